-- polygon.lua -- is a profile a simple polygon, with its holes inside it and apart?
--
-- Decided exactly for the default parameters; touching is refused like crossing.  Loops are turned anticlockwise; that
-- they stay so, with other parameters, is asked again by the emitted code.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local args = require "generator.dsl.args"
local value = require "generator.dsl.value"
local diag = require "generator.diag"

local polygon = {}

-- Corners as doubles, the exact numbers beside them.
local function numbers(loop)
  local out = {}
  for i, row in ipairs(loop) do
    local exact = { value.number(row[1]), value.number(row[2]) }
    out[i] = { R.todouble(exact[1]), R.todouble(exact[2]), exact = exact }
  end
  return out
end

-- The sign of the area of the triangle a, b, c: in doubles where their roundings cannot decide it, else exactly.
local function turn(a, b, c)
  local s, t = (b[1] - a[1]) * (c[2] - a[2]), (b[2] - a[2]) * (c[1] - a[1])
  local size = math.max(math.abs(a[1]), math.abs(a[2]), math.abs(b[1]), math.abs(b[2]), math.abs(c[1]), math.abs(c[2]))
  -- coordinates and differences are wrong by 2^-52 of the size, at most two sizes long; 2^-45 is ample
  if math.abs(s - t) > 2.0 ^ -45 * size * size and size < 1e150 and size > 1e-140 then return s > t and 1 or -1 end
  local p, q, r = a.exact, b.exact, c.exact
  return R.sign((q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1]))
end

-- Is r, on the line through a and b, between them or at one of them?
local function between(a, b, r)
  local p, q, v = a.exact, b.exact, r.exact
  return R.sign((v[1] - p[1]) * (v[1] - q[1]) + (v[2] - p[2]) * (v[2] - q[2])) <= 0
end

-- Have the sides a b and c d a point in common?
-- Each side's ends lie on either side of the other's line, or an end lies on the other side.
local function meet(a, b, c, d)
  local s, t = turn(a, b, c), turn(a, b, d)
  if s * t > 0 then return false end
  local u, v = turn(c, d, a), turn(c, d, b)
  if u * v > 0 then return false end
  return s * t < 0 and u * v < 0 or s == 0 and between(a, b, c) or t == 0 and between(a, b, d) or
    u == 0 and between(c, d, a) or v == 0 and between(c, d, b)
end

-- Do sides of the two loops meet, but for neighbours in their corner?  Returns their numbers.
local function meeting(p, q)
  for i = 1, #p do
    local a, b = p[i], p[i % #p + 1]
    for j = p == q and i + 1 or 1, #q do
      local c, d = q[j], q[j % #q + 1]
      if p ~= q or b ~= c and a ~= d then
        if meet(a, b, c, d) then return i, j end
      elseif b == c and turn(a, b, d) == 0 and (between(a, b, d) or between(b, d, a)) or
        a == d and turn(c, a, b) == 0 and (between(c, a, b) or between(a, b, c)) then
        return i, j -- neighbours that lie on each other
      end
    end
  end
end

-- Are all corners on one line?
local function flat(p)
  for i = 1, #p do
    if turn(p[i], p[i % #p + 1], p[(i + 1) % #p + 1]) ~= 0 then return false end
  end
  return true
end

-- Is r, which is on no side, outside the loop?
-- By its winding number: sides that cross the height of r upwards with r on their left, less those downwards.
local function outside(p, r)
  local winding = 0
  for i = 1, #p do
    local a, b = p[i], p[i % #p + 1]
    local s = turn(a, b, r)
    if a[2] <= r[2] and b[2] > r[2] and s > 0 then winding = winding + 1 end
    if a[2] > r[2] and b[2] <= r[2] and s < 0 then winding = winding - 1 end
  end
  return winding == 0
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

-- A last corner that repeats the first, as closed outlines of other programs have it, is left out.
local function open(loop)
  local a, b = loop[1], loop[#loop]
  if #loop > 3 and a[1] == b[1] and a[2] == b[2] then loop[#loop] = nil end
end

-- Reports what is wrong with a profile and its holes; true when nothing is.  The loops themselves are opened and made
-- anticlockwise.  radius: the first coordinate is a distance from an axis.
function polygon.check(ctx, line, what, profile, holes, radius)
  for _, loop in ipairs { profile, table.unpack(holes) } do open(loop) end
  local loops, ok = { numbers(profile) }, true
  for i, h in ipairs(holes) do loops[i + 1] = numbers(h) end
  local function name(n) return n == 1 and "profile" or "holes[" .. n - 1 .. "]" end
  local function report(n, rule, got)
    ctx.diag:error(ctx.diag:locate(line, n == 1 and "profile" or "holes"), what, name(n) .. " " .. rule, got)
    ok = false
  end
  local function sides(i, j) return "sides " .. i .. " and " .. j end
  for n, loop in ipairs { profile, table.unpack(holes) } do
    local level = flat(loops[n])
    local i, j = meeting(loops[n], loops[n])
    if i and not level then
      report(n, "must not cross or touch itself", sides(i, j))
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
    local i, j = meeting(loops[1], loops[n])
    if i then
      report(n, "must lie inside the profile", sides(i, j) .. " that meet")
    elseif outside(loops[1], loops[n][1]) then
      report(n, "must lie inside the profile", show(loops[n][1]))
    end
    for m = 2, n - 1 do
      if meeting(loops[m], loops[n]) or not outside(loops[m], loops[n][1]) or not outside(loops[n], loops[m][1]) then
        report(n, "must not overlap " .. name(m))
      end
    end
  end
  return ok
end

return polygon
