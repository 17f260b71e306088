#!/usr/bin/env lua5.4
-- query.t - the emitted inverse questions about the free top: periods, rotation number, flips.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- query.c measures a compiled tensor of parameters, in double and float, against the library's exact solver; the oracle
-- of many digits (tests/oracle) says where the middle rate changes its sign; two periods are published.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local scene = require "tests.scene"

local dir = program.directory()
local oracle = os.getenv "POLHODE_ORACLE" or "build/oracle/free_top"

local text = [[
local function entry(name, value) return param(name, value, "kg m^2") end
return scene {
  name = "%s",
  body = tensor { mass = 1, xx = entry("xx", 1), yy = entry("yy", 2), zz = entry("zz", 2.5), xy = entry("xy", 0.1),
    xz = entry("xz", 0), yz = entry("yz", 0) },
}
]]

for _, s in ipairs { { "top", "double" }, { "small", "float" } } do
  local job = assert(scene.read(string.format(text, s[1])))
  job = scene.plan(job, { real = s[2] })
  local files = scene.files(job)
  program.write(dir .. "/" .. s[1] .. ".h", files[s[1] .. ".h"])
  program.write(dir .. "/" .. s[1] .. ".c", files[s[1] .. ".c"])
end

-- Units of the last place: of a value that is formed in pairs and rounded once, 1/2; the period is a quotient of two
-- rounded numbers, 3/2; what it is compared with is rounded to double, another 1/2 there.  A flip: one unit of t.
-- |q|^2: four squares of rounded numbers; T: the rates' 18 units (top.t) twice.
local BAR = { period = 2, rate = 1, number = 1.5, inverse = 2, next = 1, norm = 4, energy = 36 }
local EXACT = { chain = true, constant = true, separatrix = true, scaled = true, symmetric = true }
local LEAST = { period = 2000, rate = 2000, number = 2000, inverse = 2000, next = 10000, norm = 250, energy = 250 }

local function measured(command)
  local code = program.shell(string.format("(%s -std=c99 -ffp-contract=off -c %s/top.c -o %s/top.o && " ..
    "%s -std=c99 -ffp-contract=off -c %s/small.c -o %s/small.o && " ..
    "gcc -std=c11 -O1 -D_DEFAULT_SOURCE -Isrc/runtime -I%s -o %s/measure tests/emit/query.c %s/top.o %s/small.o " ..
    "build/libpolhode.a -lgsl -lgslcblas -lm) >%s/log 2>&1",
    command, dir, dir, command, dir, dir, dir, dir, dir, dir, dir))
  if not tap.ok(code == 0, command .. ": compiles", program.read(dir .. "/log")) then return {} end
  code = program.shell(string.format("timeout 300 %s/measure >%s/out", dir, dir))
  tap.is(code, 0, command .. ": runs")
  local lines = {}
  for line in string.gmatch(program.read(dir .. "/out"), "[^\n]+") do lines[#lines + 1] = line end
  return lines
end

local function judge(command)
  local states, lines = {}, measured(command)
  for _, line in ipairs(lines) do
    local real, what, worst, count = string.match(line, "^(%a+) (%a+) (%S+) (%-?%d+)$")
    worst, count = tonumber(worst) or math.huge, tonumber(count) -- "nan" is no number
    if EXACT[what] then
      tap.ok(worst == 0 and count > 0, string.format("%s, %s: %s holds, %d times", command, real, what, count))
    elseif BAR[what] then
      tap.ok(worst <= BAR[what] and count >= LEAST[what], string.format(
        "%s, %s: %s as it should be, %d times", command, real, what, count), worst)
    elseif string.find(line, "^flip") or string.find(line, "^period") then
      states[#states + 1] = line
    elseif not string.find(line, "^known") then
      tap.ok(false, command .. ": " .. line)
    end
  end
  return states, lines
end

local function near(got, want, tolerance, what)
  tap.ok(got and math.abs(got - want) <= tolerance, what, got)
end

-- Published: Toutatis 5.38 +- 0.03 d and 7.40 +- 0.03 d (Zhao, Ji 2015); the rigid Earth 303.741 d.
local function published(lines)
  local values = {}
  for _, line in ipairs(lines) do
    local name, period, precession, number = string.match(line, "^known (%a+) (%S+) (%S+) (%S+)")
    if name then values[name] = { tonumber(period), tonumber(precession), tonumber(number) } end
  end
  local t, e = values.toutatis or {}, values.earth or {}
  near(t[1], 5.38, 0.03, "Toutatis turns about its long axis in 5.38 days")
  near(t[2], 7.40, 0.03, "which goes round L in 7.40")
  near(t[3], (t[1] or 0) / (t[2] or 1), 1e-8, "its rotation number is the quotient")
  near(e[1], 303.741, 5e-4, "the rigid Earth wobbles in 303.741 days")
  -- small oscillations, sqrt(A B/((C - A) (C - B))) turns of the body and one of the axis in it; the amplitude is 1e-6
  near(e[3], math.sqrt(8.0101 * 8.0103 / ((8.0365 - 8.0101) * (8.0365 - 8.0103))) + 1, 1e-6,
    "while its axis goes 305.57 times round L")
end

local function by_oracle(states)
  local input = {}
  for i, line in ipairs(states) do input[i] = string.match(line, "^%a+ %S+ (.*)$") end
  program.write(dir .. "/lines", table.concat(input, "\n") .. "\n")
  tap.is(program.shell(string.format("%s <%s/lines >%s/answers", oracle, dir, dir)), 0, "the oracle answers")
  local i, flips, periods, before, worst, turned = 0, 0, 0, nil, 0, 0
  for line in io.lines(dir .. "/answers") do
    i = i + 1
    local x, given = {}, {}
    for word in string.gmatch(line, "%S+") do x[#x + 1] = tonumber(word) end
    for word in string.gmatch(input[i], "%S+") do given[#given + 1] = tonumber(word) end
    local what, value = string.match(states[i], "^(%a+) (%S+)")
    if what == "flip" then
      local rate = x[tonumber(value) + 1]
      if before then
        if rate * before < 0 then flips = flips + 1 end
        before = nil
      else
        before = rate
      end
    else
      -- w after a period, off by the rounding of that, 2 units, times |dw/dt|; and the angle about L: the scalar part
      -- of q(t) q(0)* is its half's cosine
      local most, size = 0, 0
      for k = 1, 3 do
        size = math.max(size, math.abs(given[6 + k]))
        most = math.max(most, math.abs(x[k] - given[6 + k]))
      end
      worst = math.max(worst, most / (size * size * given[14]))
      local c, n = 0, 0
      for k = 1, 4 do
        c = c + x[3 + k] * given[9 + k]
        n = n + given[9 + k] ^ 2
      end
      local d = math.abs(math.abs(c / math.sqrt(n)) - math.abs(math.cos(math.pi * tonumber(value))))
      turned = math.max(turned, d / (1 + size * given[14]))
      periods = periods + 1
    end
  end
  tap.ok(flips >= 60 and flips == (#states - periods) / 2, "the middle rate changes its sign at a flip", flips)
  -- the moments' quotients are at most 1/0.05 of the smallest rates' product
  tap.ok(periods >= 10 and worst <= 40 * 2.0 ^ -52, "the rates come back after a period", worst)
  tap.ok(turned <= 4 * 2.0 ^ -52, "and the body has turned about L by the rotation number", turned)
end

local states, lines = judge "gcc -O2"
published(lines)
by_oracle(states)
judge "clang -O1"

program.finish()
tap.done()
