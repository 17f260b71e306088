-- special.lua -- the helpers in an emitted file: functions that libm lacks, each only where it is called.
--
-- Printing the code has gathered their names in ctx.helpers; here are the values that templates/numeric/special.c
-- needs.  The arithmetic of pairs (templates/numeric/pair.c) stands once, before its first use.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"
local algorithm = require "generator.ir.special.special"
local series = require "generator.ir.special.series"
local template = require "generator.emit.template"

local special = {}

function special.fill(v, ctx)
  local function literal(x) return number.text(R.lift(x), ctx.real) end
  local constants = algorithm.constants[ctx.real]
  v.has_special = false
  for _, row in ipairs(algorithm.list) do
    local used = ctx.helpers[row[1]] or false
    v["has_" .. row[1]] = used
    v.has_special = v.has_special or used
  end
  v.has_ellipsoid = v.has_ellipsoid_area or v.has_ellipsoid_normal
  v.has_weights = v.has_arc_along or v.has_arc_lever or v.has_catenary_rise or v.has_catenary_height
  v.has_sums = v.has_weights or v.has_arc_across
  v.has_series = v.has_sums or v.has_catenary_width
  v.quarter, v.threequarters = literal "1/4", literal "3/4"
  v.three, v.four, v.five, v.nine = literal(3), literal(4), literal(5), literal(9)
  v.n24, v.n64, v.n720, v.n4320 = literal(24), literal(64), literal(720), literal(4320)
  v.series_terms = string.format("%d", series.terms[ctx.real])
  v.ellipsoid_steps = string.format("%d", constants.steps)
  v.ellipsoid_least = number.text(R.fromdouble(constants.least), ctx.real)
end

-- Renders the pairs and the helpers that are used.
function special.render(job, v)
  local function render(name) return template.render(name, job.templates[name], v) end
  v.pair_source = render "templates/numeric/pair.c"
  v.series_source = v.has_series and render "templates/numeric/series.c" or ""
  v.special_source = v.has_special and render "templates/numeric/special.c" or ""
end

return special
