#!/usr/bin/env lua5.4
-- corners.t - scenes whose equations have corners or jumps: `run` by the library gives the closed form, or the digits
-- of an integration in pieces, whatever rows, end and tolerance are asked for.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Tolerances: the default is near rounding, so 1e-14 of the number after some hundred steps (friction's layer takes
-- some thousand); a run at a tolerance of 1e-10 leaves that in each of up to hundred steps; rk8pd at its own 1e-13 so
-- 1e-11.
package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = program.quick()

local function scene(moments, effects, omega, more)
  return string.format("return scene { name = \"row\", body = tensor { mass = 1, xx = %s, yy = %s, zz = %s },\n" ..
    "effects = { %s },\ninitial = { omega = {%s}%s } }\n", moments[1], moments[2], moments[3], effects, omega,
    more or "")
end

local body, ball = { 1, 1.2, 1.5 }, { 1, 1, 1 }

-- Thrown or turned against a constant a with quadratic drag k: v = V tan(b - s t) up, -V tanh(s t - b) down.
local function turning(v0, a, k, t)
  local V, s = math.sqrt(a / k), math.sqrt(a * k)
  local d = s * t - math.atan(v0 / V)
  return -V * (d < 0 and math.tan(d) or (1 - math.exp(-2 * d)) / (1 + math.exp(-2 * d)))
end

local function plate(normal, centre)
  return string.format("{ area = 1, normal = {%s}, centre = {%s} }", normal, centre)
end

local cosine = "cos(pi*t*quantity(1, \"1/s\"))"
local wave = "abs(" .. cosine .. ")/" .. cosine .. "*quantity(1, \"N m\")"

-- what, the scene, a time, a column, its value; and where rows on the way are, the corners among them
local cases = {
  { "a state collects |sin 3t|", scene(ball, "effect.custom { states = { work = { initial = 0, unit = \"s\", " ..
    "rate = function(s) return abs(sin(quantity(3, \"rad/s\")*s.t)) end } } }", "0, 0, 0"), 20, "work",
    (38 + 1 - math.cos(60 - 19 * math.pi)) / 3, { 7, 9.42477796076938 } },
  -- in pieces that end at the signs, by series of order 14 with 30 digits, from the same doubles
  { "|w| of two axes", scene(body, "effect.torque { body = { -abs(wy)*quantity(1, \"N m s\"), 0, " ..
    "abs(wx)*quantity(1, \"N m s\") } }", "-2.194, 2.085, 1.583"), 5, "wx", -14.03860528923319722, { 0.3, 1, 2 } },
  { "quadratic drag where w turns round", scene(body, "effect.drag { c = 0.3 }, effect.torque { body = {0, 0, -1} }",
    "0, 0, 0.4334"), 5, "wz", turning(0.4334, 1 / 1.5, 0.2, 5), { 0.6, 0.63 } },
  -- sqrt(w^2 + s^2) - |w| adds s/2 times the torque's part at each end and s ln at rest: below 1e-9 rad/s
  { "friction with a smoothing of 1e-9 rad/s", scene({ 1, 1.2, 1 }, "effect.friction { torque = 0.5, " ..
    "smoothing = 1e-9 }, effect.torque { body = {0, 0, -1} }", "0, 0, 1.5084"), 3, "wz", -(3 - 1.5084 / 1.5) / 2,
    { 1.0056 }, 1e-9 },
  { "thrown up with drag", scene(body, "effect.translation { gravity = 9, drag = 0.3 }", "1, 2, 3",
    ", velocity = {0, 0, 0.5288}"), 2, "vz", turning(0.5288, 9, 0.3, 2), { 0.05857, 1 } },
  { "a torque whose sign a wave has", scene(ball, "effect.torque { body = {0, 0, " .. wave .. "} }", "0, 0, 1"), 6.25,
    "wz", 1.25, { 0.5, 3 } },
  { "dry friction by abs(wz)/wz", scene(ball,
    "effect.torque { body = {0, 0, -1/2*abs(wz)/wz*quantity(1, \"N m\") - 1} }", "0, 0, 1.3"), 3, "wz",
    -(3 - 1.3 / 1.5) / 2, { 0.8, 0.9 } },
  -- the edges are 3e-4 rad apart: by the library with rows, and rk8pd, each to 1e-13
  { "two plates whose edges turn together", scene(body,
    "effect.solar_pressure { flux = 3e8, sun = {1, 0, 0}, plates = { " ..
    plate("1, 0, 0", "0, 0.5, 0") .. ", " .. plate("1, 0.0003, 0", "0, -0.3, 0.2") .. " } }", "0, 0, 1"), 5, "wx",
    0.15478855112365653, { 1, 1.6 } },
}

local function value(options, column)
  local command = string.format("timeout 60 %s run %s/row.lua %s --columns %s >%s/stdout 2>%s/stderr", binary, dir,
    options, column, dir, dir)
  if program.shell(command) ~= 0 then return nil, program.read(dir .. "/stderr") end
  return tonumber(program.read(dir .. "/stdout"):match "([^\n]+)\n$")
end

for _, case in ipairs(cases) do
  local what, text, t, column, want, rows, more = table.unpack(case)
  program.write(dir .. "/row.lua", text)
  local asked = { { "--at " .. t, 1e-14 }, { string.format("--at %s,%s", table.concat(rows, ","), t), 1e-14 },
    { string.format("--until %s --every %.17g", t, t / 16), 1e-14 }, { "--tolerance 1e-10 --at " .. t, 1e-8 },
    { "--method rk8pd --at " .. t, 1e-11 } }
  for _, a in ipairs(asked) do
    local got, fault = value(a[1], column)
    local bound = (a[2] + (more or 0)) * math.max(1, math.abs(want))
    tap.ok(got and math.abs(got - want) <= bound, string.format("%s: run %s, %.2g", what, a[1], bound),
      fault or string.format("%.17g for %.17g", got, want))
  end
end

program.write(dir .. "/row.lua", scene(ball, "effect.torque { body = {0, 0, -abs(wz)/wz*quantity(1, \"N m\")} }",
  "0, 0, 1.3"))
local _, fault = value("--at 3", "wz")
tap.ok(fault and fault:find("t = 1.3 s", 1, true) and fault:find("back to the jump from both sides", 1, true),
  "a jump that holds the motion is said, with its time", fault)

tap.done()
