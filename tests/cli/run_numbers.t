#!/usr/bin/env lua5.4
-- run_numbers.t - `polhode run` is never silent about numbers that are wrong: what failed, what is doubtful, what has
-- no effect.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracles.  A pure spin at rate w about z turns the attitude by w t; a method that multiplies q by R(i h w/2) in a step
-- turns it by 2 arg R: with n steps |q - q'| = 2 |sin(n (arg R - h w/2)/2)|, and the arg of R is written out below for
-- each method.  When Euler's equations leave the range of doubles under the classical Runge-Kutta method is found by
-- that method, written out here.  L_z of a heavy top is what it was.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local binary = program.quick()
local dir = program.directory()

local function run(text, more)
  program.write(dir .. "/s.lua", text)
  return program.output(string.format("POLHODE_SOURCE=. timeout 60 %s run %s/s.lua %s", binary, dir, more or ""))
end

local function scene(omega)
  return "return scene { name = \"s\", body = solid.box { x = 0.2, y = 0.1, z = 0.05, mass = 1 },\n" ..
    "  initial = { omega = {" .. table.concat(omega, ", ") .. "} }, time = { horizon = 10, step = 0.01 } }\n"
end

local function last(csv)
  local row = {}
  for cell in string.gmatch(string.match(csv, "([^\n]*)\n$") or "", "[^,]+") do row[#row + 1] = tonumber(cell) end
  return row
end

-- ---- not finite ----

-- The end of the first step after which Euler's equations for this box have no finite rates: classical Runge-Kutta.
local function overflow(w, h)
  local I = { (0.1 ^ 2 + 0.05 ^ 2) / 12, (0.2 ^ 2 + 0.05 ^ 2) / 12, (0.2 ^ 2 + 0.1 ^ 2) / 12 }
  local function f(x)
    return { (I[2] - I[3]) / I[1] * x[2] * x[3], (I[3] - I[1]) / I[2] * x[3] * x[1],
      (I[1] - I[2]) / I[3] * x[1] * x[2] }
  end
  local function plus(x, k, s) return { x[1] + s * k[1], x[2] + s * k[2], x[3] + s * k[3] } end
  for n = 1, 100 do
    local a = f(w)
    local b = f(plus(w, a, h / 2))
    local c = f(plus(w, b, h / 2))
    local d = f(plus(w, c, h))
    w = plus(plus(plus(plus(w, a, h / 6), b, h / 3), c, h / 3), d, h / 6)
    for i = 1, 3 do
      if w[i] ~= w[i] or math.abs(w[i]) == math.huge then return n * h end
    end
  end
end

local FAST = { 3.0, 3.0, 4.0 } -- h |w| = 5.8 with h = 1
for _, c in ipairs { { "--method rk4", "at t = " }, { "--engine generated --method rk4", "the state is not finite" },
  { "--method rk4 --format json", "exceeds the range" } } do
  local code, out, err = run(scene(FAST), "--step 1 --at 20 " .. c[1])
  local t = overflow(FAST, 1.0)
  tap.ok(code == 3 and out == "" and string.find(err, string.format("at t = %g s: ", t), 1, true) and
    string.find(err, c[2], 1, true) and string.find(err, "what helps: --step 0.", 1, true),
    c[1] .. ": not finite at " .. t .. " s, status 3, what helps", code .. err)
end
do
  local code, out, err = run(scene(FAST), "--step 1 --every 2 --method rk4 -o " .. dir .. "/none.csv")
  tap.ok(code == 3 and out == "" and program.read(dir .. "/none.csv") == nil, "and -o writes no file", err)
  code, out, err = run(scene(FAST), "--step 1 --every 2 --engine generated --method rk4 --real float")
  tap.ok(code == 3 and out == "" and string.find(err, "not finite", 1, true), "float likewise", err)
  code, out, err = run(scene({ 0, 1.0, 1e-3 }), "--method linearised --at 1,2000") -- exp(0.7*2000)
  tap.ok(code == 3 and out == "" and string.find(err, "exceeds the range", 1, true), "the linearised motion likewise",
    err)
  local rate = tonumber(string.match(err, "at t = (%S+) s"))
  local g = math.sqrt((0.04 + 0.0025 - 0.0125) / 0.0125 * (0.05 - 0.0425) / 0.05) -- sqrt((I2-I1)(I3-I2)/(I1 I3))
  -- cosh(g t) 1e-3 = 1.8e308; the smaller of the two transverse rates is within a factor 10 of the larger: 3 e-folds
  tap.near(rate or 0.0, (math.log(1.8) + 311 * math.log(10)) / g, 5 / g, 0.0, "at the time when it leaves the range",
    "e-folds")
end

-- A force that ends at t = 2, and an event that stops the run before.
local POLE = 'return scene { name = "pole", body = solid.sphere { r = 1, mass = 1 }, effects = { effect.translation ' ..
  "{ gravity = {0, 0, 0} }, effect.custom { force = function(s) return { 1/(2 - s.t), 0, 0 } end } }, " ..
  "initial = { velocity = {0, 0, 1} }, time = { horizon = 4, step = 0.125 }%s }\n"
for _, how in ipairs { "--method rk4", "--engine generated --method rk4" } do
  local code, out, err = run(string.format(POLE, ", events = { { name = \"half\", when = rz - 0.5 } }"), how)
  tap.ok(code == 3 and out == "" and string.find(err, "at t = 2 s: ", 1, true), how .. ": a pole at 2 s, and events",
    code .. err)
  code, out, err = run(string.format(POLE, ", events = { { name = \"half\", when = rz - 0.5, stop = true } }"), how)
  tap.ok(code == 0 and string.find(out, "\n0.5,", 1, true) and err == "event half at t = 0.5 s\n",
    how .. ": a run that ends before is printed",
    code .. err)
end

-- ---- wrong but finite ----

-- arg R(i y) for y = h w/2.
local argument = {}
local function truncated(order)
  return function(y)
    local re, im, term = 0.0, 0.0, 1.0
    for n = 0, order do
      local s = ({ 1, 1, -1, -1 })[n % 4 + 1] * term
      if n % 2 == 0 then re = re + s else im = im + s end
      term = term * y / (n + 1)
    end
    return math.atan(im, re)
  end
end
argument.rk4 = truncated(4)
argument["gsl-rk4"] = function(y) return 2 * argument.rk4(y / 2) end -- it takes two half steps
argument.midpoint = function(y) return math.atan(y) end              -- Cayley

local function estimate(err)
  if string.find(err, "no digit is known", 1, true) then return 10.0 end
  local e = string.match(err, "its error is estimated at (%S+)")
  return e == "more" and 10.0 or tonumber(e)
end

for _, c in ipairs(tier.every(2, { -- engine, method, w, h, t
  { "general", "rk4", 0.75, 0.6, 300 }, { "general", "gsl-rk4", 0.75, 0.6, 5000 },
  { "generated", "rk4", 0.75, 0.6, 2000 }, { "generated", "midpoint", 0.75, 0.1, 200 },
  { "general", "rk4", 0.75, 0.6, 15000 }, { "generated", "rk4", 2, 0.1, 31000 }, -- long: 25000 and 310000 steps
})) do
  local name, w, h = string.match(c[2], "%S+"), c[3], c[4]
  local function turned(step) -- the error of the row at the end, by the printed attitude
    local code, out, err = run(scene { 0, 0, w }, string.format("--engine %s --method %s --step %.17g --at %d", c[1],
      c[2], step, c[5]))
    local row, half = last(out), w * c[5] / 2
    return math.sqrt((row[2] - math.cos(half)) ^ 2 + (row[5] - math.sin(half)) ^ 2), code, err
  end
  local got, code, err = turned(h)
  local what = string.format("%s %s, h w = %.2g, %.0f steps", c[1], name, h * w, c[5] // h)
  if argument[name] then
    local n = math.ceil(c[5] / h * (1 - 1e-12))
    local y = c[5] / n * w / 2
    tap.near(got, math.abs(2 * math.sin(n * (argument[name](y) - y) / 2)), 1e-6, 1e-9, what .. ": the error is " ..
      string.format("%.3g", got), "roundings")
  end
  -- two digits are printed; Richardson's next term is (h w)^2 of it
  local off = estimate(err) and math.abs(estimate(err) / got - 1) or math.huge
  tap.ok(code == 0 and got > 1e-3 and off < 0.05 + (h * w) ^ 2 / 4, what .. ": it is estimated",
    err .. got)
  local step = tonumber(string.match(err, "what helps: %-%-step (%S+)"))
  if step then
    got, code, err = turned(step)
    tap.ok(code == 0 and err == "" and got < 1e-3 and step < h, what .. ": --step " .. step .. " helps", err .. got)
  else
    tap.ok(false, what .. ": a step is named that helps", err)
  end
end

-- h w = 2 to 6: nothing of it is right, and it is said.
for hw = 2, 6, tier.quick and 4 or 1 do
  for _, how in ipairs { "--method rk4", "--method gsl-rk4" } do
    local code, _, err = run(scene { 0, 0, hw }, how .. " --step 1 --at 50,100")
    tap.ok(code == 0 and (estimate(err) or 0) > 0.01, how .. ", h w = " .. hw .. ": a warning", code .. err)
  end
end
do
  local TOP = "return scene { name = \"top\", body = solid.cone { r = 0.02, h = 0.05, mass = 0.1 }:turned { axis = " ..
    "\"x\", angle = pi }:at { 0, 0, 0.05 }, origin = { 0, 0, 0 }, effects = { effect.gravity { } }, initial = { " ..
    "omega = {3, 3, 200}, attitude = {0.98, 0.2, 0, 0} }, time = { horizon = 20, step = 0.01 } }\n"
  local code, out, err = run(TOP, "--method rk4 --at 0,20")
  local first = {}
  for cell in string.gmatch(string.match(out, "\n(0%.0,[^\n]*)"), "[^,]+") do first[#first + 1] = tonumber(cell) end
  tap.ok(code == 0 and first[12] * last(out)[12] < 0 and (estimate(err) or 0) > 0.1 and
    string.find(err, "--method adaptive", 1, true), "a heavy top whose L_z changes its sign is pointed out", err)
  code, out, err = run(TOP, "--at 0,20")
  tap.ok(code == 0 and err == "" and math.abs(last(out)[12] / first[12] - 1) < 1e-9, "by tolerance it does not: silent",
    err)
end

-- ---- no false alarm: the bodies by their own step, whose errors are below 1e-6 (docs/methods.md) ----

for _, body in ipairs(tier.every(2, { "nodding_top", "kapitza", "wheels", "thrown_book" })) do
  local code, _, err = program.output(string.format("POLHODE_SOURCE=. timeout 60 %s run bodies/%s.lua --method rk4",
    binary, body))
  tap.ok(code == 0 and err == "", body .. ": silent", err)
end

do -- at rest, the torque's parts cancel but for roundings: rates of 1e-17 rad/s, of which no digit is right
  local code, out, err = run('return scene { name = "s", body = solid.box { x = 0.2, y = 0.1, z = 0.05, mass = 1 }' ..
    ":at { 0.1, 0.17, 0.31 }, origin = { 0, 0, 0 }, effects = { effect.gravity { direction = {0.1, 0.17, 0.31} } }, " ..
    "time = { horizon = 20, step = 0.01 } }\n", "--method rk4 --at 20")
  local w = math.abs(last(out)[6]) + math.abs(last(out)[7])
  tap.ok(code == 0 and err == "" and w > 0 and w < 1e-12, "rates that are rounding: silent", err .. w)
end

-- ---- linearised, exact ----

do
  local symmetric = "return scene { name = \"s\", body = solid.cylinder { r = 0.1, h = 0.3, mass = 1 }, initial = { " ..
    "omega = {0.3, 0.4, 2} }, time = { horizon = 20 } }\n"
  local code, linear, err = run(symmetric, "--method linearised --at 20")
  local _, exact = run(symmetric, "--method exact --at 20")
  local a, b, off = last(linear), last(exact), 0.0
  for i = 2, 8 do off = math.max(off, math.abs(a[i] - b[i])) end
  tap.ok(code == 0 and err == "" and off <= 1e-14, "a symmetric top about its axis: linearised is exact, attitude too",
    err .. off)
  code, linear, err = run(scene { 0.05, 0.1, 2 }, "--method linearised --at 20")
  _, exact = run(scene { 0.05, 0.1, 2 }, "--method exact --at 20")
  a, b, off = last(linear), last(exact), 0.0
  for i = 2, 5 do off = off + (a[i] - b[i]) ^ 2 end
  off = math.sqrt(math.min(off, 4 - off))
  local said = tonumber(string.match(err, "differs by (%S+) %(attitude"))
  tap.ok(code == 0 and off > 1e-3 and said and math.abs(said / off - 1) < 0.06 and
    string.find(err, "the transverse rates are 0.056 of the spin", 1, true), "another: a warning with the difference",
    err)
  -- t = 2^50: the last digit of t is 1/4 s, half a radian
  code, _, err = run(scene { 0, 0, 2 }, "--method exact --at 1,1125899906842624")
  said = tonumber(string.match(err, "changes the state by (%S+) %(attitude"))
  tap.ok(code == 0 and said and math.abs(said / (2 * math.sin(0.5 / 4)) - 1) < 0.06,
    "a time beyond the digits: a warning", err)
  code, _, err = run(scene { 0, 0, 2 }, "--method exact --at 1,1e9")
  tap.ok(code == 0 and err == "", "1e9 s are not", err)
end

-- ---- options that cannot be met or have no effect ----

for _, c in ipairs(tier.every(3, {
  { "--step -1", "--step must be positive, got -1.0" },
  { "--engine generated --method rk4 --step 0", "--step must be positive, got 0.0" },
  { "--step 1e-400", "--step must be positive, got 0.0" }, { "--tolerance 2", "from 1e-19 to 0.1, got 2.0" },
  { "--tolerance 0", "--tolerance must be from 1e-19 to 0.1, got 0.0" },
  { "--engine generated --method taylor --tolerance 0", "--tolerance must be from 2.2e-16 to 0.1, got 0.0" },
  { "--engine generated --method adaptive --tolerance 1e-20", "got 1e-20" },
  { "--engine generated --method adaptive --real float --tolerance 1e-9", "--tolerance must be from 1.2e-07 to 0.1" },
  { "--engine generated --method rk4 --tolerance 1e-9", "--tolerance: the method rk4 has a fixed step" },
  { "--method exact --tolerance 1e-9", "--tolerance: the method exact has no steps" },
  { "--method linearised --step 1", "--step: the method linearised has no steps" },
  { "--method taylor --step 1 --tolerance 1e-9", "--step and --tolerance exclude each other" },
  { "--method rk4 --step 1e-9", "5e+06 are the most" },
})) do
  local code, out, err = run(scene { 0, 1, 2 }, c[1])
  tap.ok(code == 2 and out == "" and string.find(err, c[2], 1, true) and not string.find(err, "\n.", 1), c[1] .. ": " ..
    c[2], code .. err)
end
do
  local code, out, err = run(scene { 0, 0, 2 }, "--method rk4 --step 1 --every 0.01")
  tap.ok(code == 0 and out ~= "" and string.find(err, "--step 1 has no effect", 1, true), "a step longer than all " ..
    "intervals between rows: a warning", err)
end

program.finish()
tap.done()
