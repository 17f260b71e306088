#!/usr/bin/env lua5.4
-- rest.t - `polhode run` where a body comes to rest, where its motion is stiff, and where it ends: it ends in time.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A ball of radius R on Coulomb friction slips with -mu g until v = R w; the stop shot (v0 = 2/5 R w0, backspin) is at
-- rest then, after v0/(mu g) and v0^2/(2 mu g).  The smoothed law, mu g s/sqrt(s^2 + e^2) of the slip s, ends with
-- s' = -(7/2) mu g s/e: the times below are that law's, integrated in closed form: (7/2) mu g t = F(s0) - F(s) with
-- F(s) = sqrt(s^2 + e^2) - e asinh(e/s), for the slip keeps its direction and is 7/2 of the speed.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local binary = program.quick()
local dir = program.directory()

-- The processor's seconds are limited, so that a run without end fails here.
local function run(text, more)
  program.write(dir .. "/s.lua", text)
  os.remove(dir .. "/events")
  local code = program.shell(string.format("ulimit -t 40; POLHODE_SOURCE=. %s run %s/s.lua %s %s > %s/csv 2> %s/log",
    binary, dir, more or "", text:find "effect.plane" and "--events " .. dir .. "/events" or "", dir, dir))
  local csv, happened = program.read(dir .. "/csv"), program.read(dir .. "/events")
  return code, csv .. (happened and csv ~= "" and "\n" .. happened or ""), program.read(dir .. "/log")
end

local function event(csv, name)
  return tonumber(string.match(csv, "\n" .. name .. ",([^,]+),"))
end

-- The last row before the events, as numbers.
local function last(csv)
  local row = {}
  for cell in string.gmatch(string.match(csv, "([^\n]+)\n\n"), "[^,]+") do row[#row + 1] = tonumber(cell) end
  return row
end

local function ball(friction, velocity, omega, more)
  return string.format('local e = param("e", 0.1, "m/s")\nreturn scene { name = "ball", body = ' ..
    "solid.sphere { r = 0.03, mass = 0.2 }, effects = { effect.plane { surface = contact.sphere { r = 0.03 }, " ..
    "law = \"sliding\", friction = { %s }%s } }, initial = { velocity = {%s}, omega = {%s} }, " ..
    "time = { horizon = 2, step = 0.01 } }\n",
    friction, more or "", velocity, omega)
end

-- ---- rest ----

local mu, g = 0.2, 9.80665
local function F(s, e) return math.sqrt(s * s + e * e) - e * math.log(e / s + math.sqrt(1 + e * e / (s * s))) end
local function reaches(v, e, v0) return (F(3.5 * v0, e) - F(3.5 * v, e)) / (3.5 * mu * g) end

local stop = ball("coulomb = 0.2, smoothing = e", "1.2, 0, 0", "0, -100, 0")
for _, e in ipairs { 0.1, 0.01, 1e-3 } do
  local code, csv, log = run(stop, "--set e=" .. e)
  tap.is(code, 0, "the stop shot with a smoothing of " .. e .. " runs: " .. log)
  -- the larger of v and R w = 5/2 v is a thousandth of e; the time is one of a grid's chords, 1e-9 of it
  local want, got = reaches(1e-3 * e / 2.5, e, 1.2), event(csv, "at_rest")
  tap.ok(got and math.abs(got - want) < 1e-7, "and is at rest at " .. want .. " s, got " .. tostring(got))
  tap.ok(math.abs(last(csv)[15]) < 1e-9, "where it stays")
end
local code, csv, log = run(stop, "--engine generated --method rk4 --step 0.001")
tap.is(code, 0, "by rk4: " .. log)
-- rk4's own error at a thousandth of a second is 1e-6
tap.ok(math.abs(event(csv, "at_rest") - reaches(1e-4 / 2.5, 0.1, 1.2)) < 1e-4, "rest is an event of the emitted " ..
  "code, too")
code, csv = run(ball("coulomb = 0.2, smoothing = e", "0.5, 0.1, 0", "0, -3, 8",
  ", rolling_resistance = { coulomb = 3e-4, smoothing = 0.1 }, spinning = { coulomb = 2e-3, smoothing = 0.1 }"),
  "--set e=0.05 --until 20 --every 1")
tap.is(code, 0, "a ball that rolls out and spins out runs to 20 s")
tap.ok(event(csv, "at_rest"), "and comes to rest")
-- by the emitted methods with a tolerance, whose errors are measured by what the terms of the rates make in a step;
-- a run without end fails by the processor's seconds.  1e-7: their tolerance and the grid's chord
local spun = ball("coulomb = 0.2, smoothing = e", "0.5, 0.1, 0", "0, -3, 8",
  ", rolling_resistance = { coulomb = 3e-4, smoothing = 0.1 }, spinning = { coulomb = 2e-3, smoothing = 0.1 }")
local _, known = run(spun, "--set e=0.05 --at 20")
for _, method in ipairs { "adaptive", "rosenbrock", "taylor" } do
  local by = "--engine generated --method " .. method
  code, csv, log = run(stop, "--set e=0.01 " .. by)
  tap.is(code, 0, "the stop shot by " .. method .. " ends: " .. log)
  local want, got = reaches(1e-3 * 0.01 / 2.5, 0.01, 1.2), event(csv, "at_rest")
  tap.ok(got and math.abs(got - want) < 1e-7, "and is at rest at " .. want .. " s, got " .. tostring(got))
  code, csv, log = run(spun, "--set e=0.05 --at 20 " .. by)
  tap.is(code, 0, "the ball that spins out by " .. method .. ": " .. log)
  local a, b, far = last(known), code == 0 and last(csv) or {}, 0
  for i, x in ipairs(a) do far = math.max(far, math.abs(x - (b[i] or 1e9))) end
  tap.ok(far < 1e-7, "and lies where the library has it: " .. far)
end
code, csv = run(ball("coulomb = 0.2, smoothing = e", "2, 0, 0", "0, 0, 0"))
tap.is(code, 0, "a ball that rolls on for ever")
tap.ok(not event(csv, "at_rest"), "is not at rest")
code, csv = run(ball("coulomb = 0.2, smoothing = e", "0, 0, 0", "0, 0, 0"))
tap.is(code, 0, "a ball that lies there")
tap.ok(not event(csv, "at_rest"), "has not come to rest")

-- ---- stiff ----

code, csv, log = run(ball("coulomb = 0.2, smoothing = e", "2, 0, 0", "25, -30, 40"), "--set e=1e-5")
tap.is(code, 0, "a smoothing of 1e-5 m/s runs by default")
tap.like(log, "went on by implicit", "and says by what")
local v = last(csv)
-- from slipping to rolling: v = 5/7 v0 + 2/7 R w, and the spin about the normal stays
tap.ok(math.abs(v[15] - (5 / 7 * 2 + 2 / 7 * 0.03 * -30)) < 1e-9, "v1 is that of pure rolling")
tap.ok(math.abs(v[16] - 2 / 7 * 0.03 * -25) < 1e-9, "v2, too")
local lands
code, lands, log = run(ball("coulomb = 0.2, smoothing = e", "2, 0, 0", "25, -30, 40", ", impact = { restitution = 0 }")
  :gsub("effects = {", "%0 effect.translation { gravity = 9.81 },"):gsub("velocity", "position = { 0, 0, 0.031 }, %0"),
  "--set e=1e-5")
tap.ok(code == 0 and event(lands, "landing"), "a ball that lands with it, too")
tap.like(log, "went on by implicit", "says the same")
code, csv = run(ball("coulomb = 0.2, smoothing = e", "2, 0, 0", "25, -30, 40"), "--set e=1e-5 --method implicit")
tap.is(code, 0, "the implicit method by its name")
local again = last(csv)
local far = 0
for i, x in ipairs(again) do far = math.max(far, math.abs(x - v[i]) / math.max(1, math.abs(x))) end
tap.ok(far < 1e-12, "comes to the same: " .. far)

-- ---- where a motion ends ----

code, csv = run([[
return scene { name = "leaves", body = tensor { mass = 0.9644, com = { 0.0368, -0.0002, -0.0201 }, xx = 0.029385,
  yy = 0.022796, zz = 0.023167, xy = -0.0046273 }, effects = { effect.plane { surface = contact.disc { r = 0.2647,
  edge = 0.0727 }, law = "rolling", rolling_resistance = { coulomb = 0.0267, smoothing = 0.151 },
  turntable = -0.6794 } }, initial = { omega = { 1.1783, -0.7356, -1.3783 },
  attitude = { axis = { 0.838, -0.0632, -0.1798 }, angle = -0.0773 },
  position = { 0.3701, 0.5824, 0 } }, time = { horizon = 1, step = 0.001 } }
]])
tap.is(code, 0, "a disc that leaves its plane ends there, whatever comes after")
tap.ok(math.abs((event(csv, "contact_lost") or 0) - 0.62966) < 1e-5, "at 0.62966 s")

-- ---- tensors that are no body's ----

local function burning(xx, yy, zz, more)
  return string.format('return scene { name = "b", body = tensor { mass = 50, xx = 10, yy = 10, zz = 5 },\n' ..
    "  effects = { effect.inertia_rate { xx = %s, yy = %s, zz = %s%s } }, initial = { omega = { 0.3, 0, 5 } }, " ..
    "time = { horizon = 10, step = 0.01 } }\n", xx, yy, zz, more or "")
end
for _, c in ipairs {
  { burning("-1.2*t", "-1.2*t", "0"), 6.25 },                           -- 20 - 2.4 t = 5
  { burning("1 - exp(t/2)", "1 - exp(t/2)", "0"), 2 * math.log(8.5) },  -- 22 - 2 exp(t/2) = 5
  { burning("0", "0", "0", ", xy = t"), 2.5 },                          -- t^2 = 2.5^2
  { burning("0", "0", "0", ", xz = 0.5*t"), math.sqrt(18.75) * 2 },     -- 2.5 * 7.5 = t^2/4
} do
  local want = c[2]
  code, csv, log = run(c[1])
  tap.ok(code ~= 0 and csv == "", "a tensor that becomes no body's is refused")
  local got = tonumber(string.match(log, "from t = (%S+) s on"))
  tap.ok(got and math.abs(got - want) < 1e-5 * want, "from " .. want .. " s on, got " .. tostring(got))
  tap.like(log, "s.lua:2:", "at its line")
  tap.is(run(c[1], "--until " .. want * 0.999), 0, "and runs up to there")
end

tap.done()
