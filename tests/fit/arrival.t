#!/usr/bin/env lua5.4
-- arrival.t - where a fit ends and what it says there do not depend on where it began: attitudes, rates, angles, robust
-- losses.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The oracle is tests/fit/oracle.lua: motions of its own, derivatives by differences of the residuals about the
-- estimate, and a search of its own.  Tolerances: the step of Newton that is left at an estimate is below 1e-6 standard
-- errors (the oracle's motion and differences are good to 1e-7 of them); covariances agree with the oracle's to 1e-6 of
-- themselves, and with each other to 1e-9.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local fitting = require "tests.fit.fitting"
local oracle = require "tests.fit.oracle"
local program = require "tests.cli.program"
local tier = require "tests.tier"
local worlds = require "tests.fit.worlds"

local LEFT, OTHER_ROAD, SAME = 1e-6, 1e-6, 1e-9

local dir = program.directory()
local binary = program.quick()

local function fit(world, start, log, loss)
  program.write(dir .. "/log.csv", world.csv(log))
  return fitting.run(binary, world.scene(start), string.format("--data %s/log.csv --free %s --loss %s", dir, world.free,
    loss))
end

-- ---- ten starts, near and far ----

math.randomseed(20261126)
for _, name in ipairs { "body", "top" } do
  local world = worlds[name]
  local truth = world.truth()
  local log = world.noisy(truth, 30, 0)
  local first
  for i, angle in ipairs { 0, 1e-3, 0.02, 0.1, 0.3, 0.6, 1, 1.5, 2, 2.5 } do
    local label = name .. ", a start " .. angle .. " rad away"
    local code, got, err = fit(world, worlds.away(truth, 0.02 * (i % 3 - 1), angle, 0.05 * (i - 1)), log, "squares")
    if tap.is(code, 0, label .. ": it fits") then
      if not first then
        first = got
        local _, left, C = oracle.judge(world.model(log), world.of(got), "squares")
        tap.ok(left < LEFT, label .. ": the minimum by another road", left)
        local apart = oracle.apart(C, got.covariance)
        tap.ok(apart < OTHER_ROAD, label .. ": and the covariance, about the estimate", apart)
      end
      local worst, regions = 0, 0
      for k, e in ipairs(got.estimates) do
        worst = math.max(worst, math.abs(e.estimate - first.estimates[k].estimate) / first.estimates[k].sigma)
      end
      local turn = oracle.between(first.initial_attitudes[1], got.initial_attitudes[1])
      for k = 1, 3 do worst = math.max(worst, math.abs(turn[k]) / first.estimates[2 + k].sigma) end
      tap.ok(worst < LEFT, label .. ": the same estimates", worst)
      local apart = oracle.apart(first.covariance, got.covariance)
      tap.ok(apart < SAME, label .. ": the same covariance", apart)
      for k, a in ipairs(got.regions_95) do
        regions = math.max(regions, math.abs(a.correlation - first.regions_95[k].correlation),
          math.abs(a.semi_axes[2] - first.regions_95[k].semi_axes[2]))
      end
      tap.ok(regions < 10 * SAME, label .. ": the same regions", regions) -- a thin one's root is less well posed
    else
      tap.diag(err .. (got and table.concat(got.wrong, "; ") or ""))
    end
  end
end

-- ---- a plate, whose minimum is beyond what is a body ----

do
  local world, ends, _ = worlds.body, {}
  local truth = { I2 = 1.5, I3 = 2.5, q = { 1, 0, 0, 0 }, w = { 0.9, 1.1, -0.4 } }
  for i = 1, 4 do -- the first log that has such a minimum
    math.randomseed(i)
    local log = world.noisy(truth, 40, 0)
    for k, start in ipairs { { 1.4, 2.3 }, { 1.2, 2.1 }, { 1.6, 2.1 }, { 1.5, 2.5 } } do
      _, ends[k] = fit(world, { I2 = start[1], I3 = start[2], q = truth.q, w = truth.w }, log, "squares")
    end
    if not ends[1].converged then break end
  end
  tap.ok(not ends[1].converged and ends[1].wrong[1]:find("border of the rule", 1, true), "a plate: it is said",
    ends[1].wrong[1])
  for k = 2, 4 do
    local worst = math.abs(ends[k].last_step - ends[1].last_step)
    for i, e in ipairs(ends[k].estimates) do
      worst = math.max(worst, math.abs(e.estimate - ends[1].estimates[i].estimate) / e.sigma)
    end
    tap.ok(worst < LEFT, "a plate, start " .. k .. ": the same body at the border, as far from the minimum", worst)
  end
end

-- ---- small logs with gross errors ----

-- Where the search of the oracle from the truth arrives it must be at the same point, or at a loss that is not lower.
local function compared(label, model, p, truth, loss, got)
  local other = oracle.minimum(model, truth, loss)
  if not other then return end
  local there, here = oracle.loss(model, other, loss), oracle.loss(model, p, loss)
  if not tap.ok(here <= there * (1 + 1e-9), label .. ": no higher than another search", here .. " " .. there) or
    here < there * (1 - 1e-9) then return end
  local worst = 0
  for i, name in ipairs(model.names) do
    if p[name] and not name:find "turn" and not name:find "w.%(0%)" then
      worst = math.max(worst, math.abs(p[name] - other[name]) / got.estimates[i].sigma)
    end
  end
  tap.ok(worst < 2 * LEFT, label .. ": where another search ends", worst)
end

local NAMES, LOSSES = { "body", "swing", "top", "swing" }, { "huber", "cauchy", "huber", "squares", "huber" }
local CASES = {}
for i = 1, 200 do CASES[i] = { i, NAMES[i % 4 + 1], LOSSES[i % 5 + 1] } end
for _, case in ipairs(tier.every(20, CASES)) do
  local i, name, loss = table.unpack(case)
  math.randomseed(i)
  local world, label = worlds[name], name .. ", " .. loss .. ", log " .. i
  local truth = world.truth()
  local log = world.noisy(truth, math.random(10, 25) + (name == "swing" and 15 or 0), 0.05 + 0.1 * math.random())
  local code, got, err = fit(world, worlds.away(truth, 0.03, 0.3 * math.random(), 0.1), log, loss)
  if tap.ok(got and got.converged, label .. ": it converges", err .. (got and table.concat(got.wrong, "; ") or "")) then
    local p, model = world.of(got), world.model(log)
    local _, left, C = oracle.judge(model, p, loss)
    tap.ok(left < LEFT, label .. ": the gradient of the loss is none", left .. " standard errors; status " .. code)
    local apart = oracle.apart(C, got.covariance)
    tap.ok(apart < OTHER_ROAD, label .. ": the covariance by another road", apart)
    if i % 10 == 1 then compared(label, model, p, truth, loss, got) end
  end
end

program.finish()
tap.done()
