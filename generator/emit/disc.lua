-- disc.lua -- of a rolling disc: its linear integrals, the rates of a tilt, its swing (templates/analysis/disc.c).
--
--     disc.texts(job, base, ctx) -> header, source         job.disc: constants of dynamics/closed/disc.lua
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local base_values = require "generator.emit.base"
local number = require "generator.emit.number"
local source = require "generator.emit.source"
local template = require "generator.emit.template"

local GROUP = template.group("analysis/disc.h", "analysis/disc.c")

local disc = {}

-- The series are used to a quarter of the radius of convergence, so that term k is 4^-k: what is left out is below an
-- eighth of a unit of the last place.  The radius is pi/2; with a rounded edge at least pi/4, as I3 <= 2 I1.
local TERMS = { double = 29, float = 15 }

-- Nearer to flat it is flat.
local LEAST = { double = R.new(2) ^ -960, float = R.new(2) ^ -100 }

-- What tests/emit/disc.t asks for.
local BOUND = { double = "2e-14", float = "1e-5" }

function disc.texts(job, base, ctx)
  local real, terms = ctx.real, TERMS[ctx.real]
  local digits = base_values.digits[real]
  local pi, rounded = R.apply("pi", digits + 40), job.disc.p ~= expr.zero
  local v = { terms = string.format("%d", terms), last = string.format("%d", terms - 1), rounded = rounded,
    reach = number.text(rounded and R.new(3, 16) or R.new(3, 8), real), two_pi = number.text(R.new(2) * pi, real),
    pi = number.text(pi, real), least_sine = number.text(LEAST[real], real), bound = BOUND[real] }
  local stored, uses_model = source.constants(job.disc, real)
  v.k1, v.k3, v.p, v.gamma, v.uses_model = stored.k1, stored.k3, stored.p, stored.gamma, uses_model
  local render = GROUP(job.templates, base, v)
  return render "analysis/disc.h", render "analysis/disc.c"
end

return disc
