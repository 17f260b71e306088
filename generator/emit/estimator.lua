-- estimator.lua -- --with estimator: the tensor of inertia from a gyro, as templates/estimator has it.
--
--     estimator.texts(job, ctx, base) -> header, source
--     estimator.check(job) -> true | nil after an error: is there a tensor?
-- Nothing in it depends on the scene but its tensor, with which it begins.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local base_values = require "generator.emit.base"
local number = require "generator.emit.number"
local template = require "generator.emit.template"

local GROUP = template.group("estimator/estimator.h", "estimator/estimator.c")

local estimator = {}

function estimator.check(job)
  if job.model.has.rates then return true end
  job.diag:error(job.record.line, "with estimator", "needs rates among the states: this scene has none")
  return nil
end

function estimator.texts(job, ctx, base)
  local pi = number.text(R.apply("pi", base_values.digits[ctx.real] + 8), ctx.real)
  local render = GROUP(job.templates, base, { pi = pi })
  return render "estimator/estimator.h", render "estimator/estimator.c"
end

return estimator
