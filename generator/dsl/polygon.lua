-- polygon.lua -- a profile and its holes as the scene language takes them: simple polygons (mass/simple.lua), opened.
--
-- Loops are turned anticlockwise; that they stay so, with other parameters, is asked again by the emitted code.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local args = require "generator.dsl.args"
local simple = require "generator.mass.simple"
local value = require "generator.dsl.value"

local polygon = {}

-- Twice the signed area, as an expression.
local function twice_area(loop)
  local sum = expr.zero
  for i = 2, #loop - 1 do
    local o, a, b = loop[1], loop[i], loop[i + 1]
    sum = sum + (a[1] - o[1]) * (b[2] - o[2]) - (b[1] - o[1]) * (a[2] - o[2])
  end
  return sum
end

local function reverse(loop)
  for i = 1, #loop // 2 do loop[i], loop[#loop + 1 - i] = loop[#loop + 1 - i], loop[i] end
end

-- A last corner that repeats the first, as closed outlines of other programs have it, is left out.
local function open(loop)
  local a, b = loop[1], loop[#loop]
  if #loop > 3 and a[1] == b[1] and a[2] == b[2] then loop[#loop] = nil end
end

-- Reports what is wrong with a profile and its holes; true when nothing is.  The loops themselves are opened and made
-- anticlockwise.  radius: the first coordinate is a distance from an axis.
function polygon.check(ctx, line, what, profile, holes, radius)
  local loops, ok, crossed = { profile, table.unpack(holes) }, true, {}
  for _, loop in ipairs(loops) do open(loop) end
  simple.faults(profile, holes, value.number, function(n, rule, got)
    ctx.diag:error(ctx.diag:locate(line, n == 1 and "profile" or "holes"), what, simple.name(n) .. " " .. rule, got)
    ok, crossed[n] = false, true
  end)
  for n, loop in ipairs(loops) do
    if not crossed[n] then
      local area = twice_area(loop)
      if R.sign(value.number(area)) < 0 then
        reverse(loop)
        area = -area
      end
      ok = args.condition(ctx, line, what, simple.name(n) .. " must enclose an area", area, "0") and ok
    end
    for k, row in ipairs(radius and loop or {}) do
      ok = args.condition(ctx, line, what, simple.name(n) .. "[" .. k .. "] must not be left of the axis", row[1],
        simple.place(row, value.number), true) and ok
    end
  end
  return ok
end

return polygon
