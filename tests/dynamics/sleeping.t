#!/usr/bin/env lua5.4
-- sleeping.t - the least spin of an upright heavy top: against the textbook's number, and against the motion itself.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A cone on its tip has I1 = 3 M (4 h^2 + r^2)/20, I3 = 3 M r^2/10, l = 3 h/4.  The motion is that of the general
-- library, which knows no such condition: from a tilt of 1e-4 rad the top falls below the least spin, and stays above.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local facts = require "generator.report.facts"
local design = require "generator.report.stability_conditions"

local text = [[
local s = param("s", %s, "rad/s")
return scene { name = "top",
  body = solid.cone { r = 0.03, h = 0.06, mass = 0.1 }:turned { axis = "x", angle = pi }:at { 0, 0, 0.06 },
  origin = { 0, 0, 0 }, effects = { effect.gravity { g = 9.81 } }, time = { horizon = 4 },
  initial = { omega = { 0, 0, s }, attitude = { axis = "x", angle = quantity("1e-4", "rad") } } }]]

local I1, I3, Mgl = 3 * 0.1 * (4 * 0.06 ^ 2 + 0.03 ^ 2) / 20, 3 * 0.1 * 0.03 ^ 2 / 10, 0.1 * 9.81 * 0.045
local least = 2 * math.sqrt(I1 * Mgl) / I3

-- The largest tilt over the horizon, rad.
local function tilt(spin)
  local path, out = os.tmpname(), {}
  local f = assert(io.open(path, "w"))
  f:write((text:format(string.format("%.17g", spin))))
  assert(f:close())
  local times = {}
  for i = 0, 200 do times[i + 1] = string.format("%.2f", i * 0.02) end
  local p = assert(io.popen("build/polhode run " .. path .. " --columns t,qx,qy --at " .. table.concat(times, ",")))
  local most = 0
  for line in p:lines() do
    local _, x, y = line:match "^([%d.e+-]+),([^,]+),([^,]+)$"
    if x and tonumber(x) then out[#out + 1], most = x, math.max(most, 2 * math.asin(math.sqrt(x * x + y * y))) end
  end
  assert(p:close() and os.remove(path))
  return #out == 201 and most
end

local function entry(spin)
  for _, e in ipairs(facts.of(scene.read((text:format(spin)))).stability) do
    if e.stable then return e end
  end
end

for _, c in ipairs { { 0.97, -1, "below" }, { 1.03, 1, "above" } } do
  local e, most = entry(string.format("%.17g", c[1] * least)), tilt(c[1] * least)
  tap.is(e.stable, c[2], "the verdict " .. c[3] .. " the least spin; the free cone's would not change")
  tap.ok(most and (most > 0.02) == (c[2] < 0), "and so moves the top", most)
  local m = e.margins[1]
  tap.near(c[2] < 0 and m.above or m.below, least, 1e-14, 0.0, "its margin is 2 sqrt(I1 M g l)/I3",
    "a root by bisection and some products")
end

local said = {}
for i, l in ipairs(design.lines(facts.of(scene.read((text:format "150"))))) do said[i] = l.text or l end
said = table.concat(said, "\n")
tap.ok(said:find("stable iff (I3 n)^2 > 4 I1 M g l; here unstable", 1, true), "150 rad/s are too few", said)
tap.is(facts.of(scene.read((text:format "150"))).upright, "unstable", "and so it stands beside a free body's verdicts")
tap.ok(not said:find("free spin", 1, true), "a free body's conditions are not said of it", said)

tap.done()
