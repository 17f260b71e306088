-- simple.lua -- is a profile a simple polygon, with its holes inside it and apart?
--
-- Decided exactly for plain numbers; touching is refused like crossing.  The scene language asks it of the parameters'
-- defaults (dsl/polygon.lua), and it is asked again of other values where NAME_init cannot (dynamics/body_at.lua).
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local diag = require "generator.diag"

local simple = { rule = "profile must not cross or touch itself" }

-- Corners as doubles, the exact numbers beside them.
local function numbers(loop, number)
  local out = {}
  for i, row in ipairs(loop) do
    local exact = { number(row[1]), number(row[2]) }
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

-- The name of a loop: 1 is the profile, the others are holes.
function simple.name(n) return n == 1 and "profile" or "holes[" .. n - 1 .. "]" end

-- A corner, for a message.
function simple.place(row, number) return show(numbers({ row }, number)[1]) end

-- What is wrong, by put(number of the loop, rule, what was got).  number: expression -> rational.  Loops without an
-- area are not looked at by themselves.
function simple.faults(profile, holes, number, put)
  local loops = {}
  for n, loop in ipairs { profile, table.unpack(holes) } do loops[n] = numbers(loop, number) end
  local function sides(i, j) return "sides " .. i .. " and " .. j end
  for n, loop in ipairs(loops) do
    local i, j = meeting(loop, loop)
    if i and not flat(loop) then put(n, "must not cross or touch itself", sides(i, j)) end
  end
  for n = 2, #loops do
    local i, j = meeting(loops[1], loops[n])
    if i then
      put(n, "must lie inside the profile", sides(i, j) .. " that meet")
    elseif outside(loops[1], loops[n][1]) then
      put(n, "must lie inside the profile", show(loops[n][1]))
    end
    for m = 2, n - 1 do
      if meeting(loops[m], loops[n]) or not outside(loops[m], loops[n][1]) or not outside(loops[n], loops[m][1]) then
        put(n, "must not overlap " .. simple.name(m))
      end
    end
  end
end

return simple
