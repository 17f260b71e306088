-- special.lua -- the helpers in an emitted file: functions that libm lacks, each only where it is called.
--
-- Printing the code has gathered their names in ctx.helpers.  The arithmetic of pairs (templates/numeric/pair.c) stands
-- once, before its first use.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"
local algorithm = require "generator.ir.special.special"
local series = require "generator.ir.special.series"
local template = require "generator.emit.template"

local PAIR = template.group "numeric/pair.c"
local GROUP = template.group("numeric/series.c", "numeric/special.c")

local special = {}

-- Do the functions that have been printed call any?
function special.used(ctx)
  for _, row in ipairs(algorithm.list) do
    if ctx.helpers[row[1]] then return true end
  end
  return false
end

-- The arithmetic of pairs: only the parts that are called for.
function special.pair(templates, base, add, multiply)
  return PAIR(templates, base, { add = add, multiply = multiply }) "numeric/pair.c"
end

-- The helpers; used: a copy of ctx.helpers, which grows.
function special.text(templates, base, ctx, used)
  local function literal(x) return number.text(R.lift(x), ctx.real) end
  local constants, v = algorithm.constants[ctx.real], {}
  for _, row in ipairs(algorithm.list) do v["has_" .. row[1]] = used[row[1]] or false end
  v.has_ellipsoid = v.has_ellipsoid_area or v.has_ellipsoid_normal
  v.has_weights = v.has_arc_along or v.has_arc_lever or v.has_catenary_rise or v.has_catenary_height
  v.has_sums = v.has_weights or v.has_arc_across
  v.threequarters, v.five, v.nine = literal "3/4", literal(5), literal(9)
  v.n24, v.n64, v.n720, v.n4320 = literal(24), literal(64), literal(720), literal(4320)
  v.series_terms = string.format("%d", series.terms[ctx.real])
  v.ellipsoid_steps = string.format("%d", constants.steps)
  v.ellipsoid_least = number.text(R.fromdouble(constants.least), ctx.real)
  local render = GROUP(templates, base, v)
  v.series = (v.has_sums or v.has_catenary_width) and render "numeric/series.c" or ""
  return render "numeric/special.c"
end

return special
