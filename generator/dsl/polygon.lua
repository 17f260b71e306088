-- polygon.lua -- is a profile a simple polygon, with its holes inside it and apart?
--
-- Decided for the default parameters, in doubles: sides that meet only where they should are told from sides that
-- cross by strict signs, so touching is allowed.  Loops are turned anticlockwise; that they stay so, with other
-- parameters, is asked again by the emitted code.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local args = require "generator.dsl.args"
local value = require "generator.dsl.value"
local diag = require "generator.diag"

local polygon = {}

local function numbers(loop)
  local out = {}
  for i, row in ipairs(loop) do
    out[i] = { R.todouble(value.number(row[1])), R.todouble(value.number(row[2])) }
  end
  return out
end

-- Twice the signed area of the triangle a, b, c.
local function turn(a, b, c) return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]) end

local function cross(a, b, c, d)
  local s, t = turn(a, b, c), turn(a, b, d)
  local u, v = turn(c, d, a), turn(c, d, b)
  return (s > 0 and t < 0 or s < 0 and t > 0) and (u > 0 and v < 0 or u < 0 and v > 0)
end

-- Do sides of the two loops cross?  Returns their numbers.
local function crossing(p, q)
  for i = 1, #p do
    for j = p == q and i + 1 or 1, #q do
      if cross(p[i], p[i % #p + 1], q[j], q[j % #q + 1]) then return i, j end
    end
  end
end

-- Is the point strictly outside the loop?  A point on a side is not.
local function outside(p, r)
  local winding = 0
  for i = 1, #p do
    local a, b = p[i], p[i % #p + 1]
    local s = turn(a, b, r)
    if s == 0 and (r[1] - a[1]) * (r[1] - b[1]) + (r[2] - a[2]) * (r[2] - b[2]) <= 0 then return false end
    if a[2] <= r[2] and b[2] > r[2] and s > 0 then winding = winding + 1 end
    if a[2] > r[2] and b[2] <= r[2] and s < 0 then winding = winding - 1 end
  end
  return winding == 0
end

local function middle(p, i) -- of the side that begins at corner i
  local a, b = p[i], p[i % #p + 1]
  return { (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 }
end

-- A corner or middle of a side of q that is strictly outside of p.
local function stray(p, q)
  for i = 1, #q do
    for _, r in ipairs { q[i], middle(q, i) } do
      if outside(p, r) then return r end
    end
  end
end

local function show(r) return "(" .. diag.show(r[1]) .. ", " .. diag.show(r[2]) .. ")" end

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

-- Reports what is wrong with a profile and its holes; true when nothing is.  Clockwise loops are reversed in place.
-- radius: the first coordinate is a distance from an axis.
function polygon.check(ctx, line, what, profile, holes, radius)
  local loops, ok = { numbers(profile) }, true
  for i, h in ipairs(holes) do loops[i + 1] = numbers(h) end
  local function name(n) return n == 1 and "profile" or "holes[" .. n - 1 .. "]" end
  local function report(n, rule, got)
    ctx.diag:error(ctx.diag:locate(line, n == 1 and "profile" or "holes"), what, name(n) .. " " .. rule, got)
    ok = false
  end
  for n, loop in ipairs { profile, table.unpack(holes) } do
    local i, j = crossing(loops[n], loops[n])
    if i then
      report(n, "must not cross itself", "sides " .. i .. " and " .. j)
    else
      local area = twice_area(loop)
      if R.sign(value.number(area)) < 0 then
        reverse(loop)
        area = -area
      end
      ok = args.condition(ctx, line, what, name(n) .. " must enclose an area", area, "0") and ok
    end
    for k, row in ipairs(radius and loop or {}) do
      ok = args.condition(ctx, line, what, name(n) .. "[" .. k .. "] must not be left of the axis", row[1],
        show(loops[n][k]), true) and ok
    end
  end
  for n = 2, #loops do
    local i = crossing(loops[1], loops[n])
    local r = stray(loops[1], loops[n])
    if i or r then report(n, "must lie inside the profile", i and "sides that cross" or show(r)) end
    for m = 2, n - 1 do
      if crossing(loops[m], loops[n]) or not stray(loops[m], loops[n]) or
        not stray(loops[n], loops[m]) then
        report(n, "must not overlap " .. name(m))
      end
    end
  end
  return ok
end

return polygon
