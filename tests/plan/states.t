#!/usr/bin/env lua5.4
-- states.t - the points at which a plan is tried lie in the ranges, reach their ends and fill them evenly.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Evenly: of 512 points each of the 16 equal parts of every quantity has 32 +- 8 (Kronecker's sequence with a badly
-- approximable number is far better than random points, whose deviation would be 5.5 and which pass 8 off in one of 7).

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local states = require "generator.plan.states"

local head = [[local a, M = param("a", 20, "cm"), param("M", 2, "kg")
return scene { name = "s", body = solid.box { x = a, y = 0.1, z = 0.05, mass = M },
  initial = { omega = {3, 0, 4}, attitude = { axis = "x", angle = 1 } }, ]]

local function read(more) return assert(scene.read(head .. more .. "}")) end

local function extent(points, get)
  local lo, hi = math.huge, -math.huge
  for _, p in ipairs(points) do lo, hi = math.min(lo, get(p)), math.max(hi, get(p)) end
  return lo, hi
end

-- the angle between the attitudes of two points
local function apart(x, y)
  local d = 0.0
  for i = 1, 4 do d = d + x[i] * y[i] end
  return 2 * math.acos(math.min(1, math.abs(d)))
end

-- ---- without ranges ----

local job = read ""
local points = states.points(job, "double", 512)
tap.is(#points, 512, "as many points as were asked for")
tap.is(table.concat(points[1].x, " ", 5, 7), "3.0 0.0 4.0", "the first is the scene's own")
for k, own in ipairs { 3, 0, 4 } do
  local lo, hi = extent(points, function(p) return p.x[4 + k] end)
  tap.ok(lo == own - 0.5 and hi == own + 0.5, "rates: 10 % of |omega| = 5 to both sides, component " .. k)
end
local _, far = extent(points, function(p) return apart(points[1].x, p.x) end)
-- acos near 1 has half the digits: 1e-7
tap.ok(far <= 0.1 + 1e-7 and far > 0.099, "attitude within 0.1 rad, and as far as that", string.format("%.9f", far))
local _, norm = extent(points, function(p)
  return math.abs(p.x[1] ^ 2 + p.x[2] ^ 2 + p.x[3] ^ 2 + p.x[4] ^ 2 - 1)
end)
tap.ok(norm <= 2 ^ -51, "attitudes are unit quaternions")
tap.is(points[2].params, nil, "parameters stay")

-- ---- with ranges ----

job = read [[ranges = { omega = {{1, 2}, {-1, 0}, {4, 4}}, attitude = "any", a = {10, 30} }]]
points = states.points(job, "double", 512)
local function bins(get, lo, hi)
  local count, worst = {}, 0
  for b = 0, 15 do count[b] = 0 end
  for i = 130, #points do -- behind the extremes
    local b = math.min(15, math.floor((get(points[i]) - lo) / (hi - lo) * 16))
    count[b] = count[b] + 1
  end
  for b = 0, 15 do worst = math.max(worst, math.abs(count[b] - (#points - 129) / 16)) end
  return worst
end
for _, c in ipairs { { "wx", function(p) return p.x[5] end, 1, 2 }, { "wy", function(p) return p.x[6] end, -1, 0 },
  { "the parameter a", function(p) return p.params and p.params[1] or 0.2 end, 0.1, 0.3 } } do
  local lo, hi = extent({ table.unpack(points, 2) }, c[2])
  tap.ok(lo == c[3] and hi == c[4], c[1] .. " reaches both ends and stays between them", lo .. " " .. hi)
  tap.ok(bins(c[2], c[3], c[4]) <= 8, c[1] .. " is filled evenly")
end
local lo, hi = extent(points, function(p) return p.x[7] end)
tap.ok(lo == 4 and hi == 4, "a range of one value is that value")
_, far = extent(points, function(p) return apart(points[1].x, p.x) end)
tap.ok(far > 3, "any attitude: almost half a turn away, too")
tap.is(points[3].params[2], 2.0, "parameters without a range have their default")
tap.is(require("generator.algebra.rational").todouble(points[3].values.a), points[3].params[1],
  "the library and NAME_init get the same number")

-- ---- extremes meet ----

job = read [[ranges = { omega = 1 }]]
points = states.points(job, "double", 17)
local seen = {}
for i = 2, 9 do seen[table.concat(points[i].x, " ", 5, 7)] = true end
local corners = 0
for _ in pairs(seen) do corners = corners + 1 end -- a count: order does not matter
tap.is(corners, 8, "three quantities: all 8 corners")

-- six quantities: every pair of ends of every two
job = read [[ranges = { omega = {{1, 2}, {1, 2}, {1, 2}}, attitude = 1, a = {10, 30}, M = {1, 2} }]]
points = states.points(job, "double", 33)
local get = {}
for k = 1, 3 do get[k] = function(p) return p.x[4 + k] end end
for k = 1, 2 do get[3 + k] = function(p) return p.params and p.params[k] or 0 end end
local meetings = true
for i = 1, #get do
  for k = i + 1, #get do
    local met, count = {}, 0
    for n = 2, 17 do
      local key = get[i](points[n]) .. " " .. get[k](points[n])
      if not met[key] then met[key], count = true, count + 1 end
    end
    meetings = meetings and count == 4
  end
end
tap.ok(meetings, "more quantities: the ends of any two meet in all four ways")
job = read [[ranges = { omega = 1 }]]
points = states.points(job, "double", 17)

-- ---- the same again, and others ----

local again = states.points(job, "double", 17)
local same = true
for i, p in ipairs(points) do
  for k, x in ipairs(p.x) do same = same and x == again[i].x[k] end
end
tap.ok(same, "the same points every time")
local unseen = states.points(job, "double", 5, 1000)
local longer, met = states.points(job, "double", 300), false
for _, p in ipairs(longer) do
  for _, u in ipairs(unseen) do met = met or p.x[5] == u.x[5] and p.x[6] == u.x[6] end
end
tap.ok(#unseen == 5 and not met, "points from a later place are others")
for _, p in ipairs(states.points(job, "float", 20)) do
  for _, x in ipairs(p.x) do same = same and x == string.unpack("f", string.pack("f", x)) end
end
tap.ok(same, "float: all numbers are floats")
job = assert(scene.read [[return scene { name = "s", body = solid.sphere { r = 1, mass = 1 }, ranges = {} }]])
tap.is(#states.points(job, "double", 10), 1, "nothing varies: one point")

tap.done()
