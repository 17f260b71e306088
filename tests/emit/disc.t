#!/usr/bin/env lua5.4
-- disc.t -- what the emitted code is asked of rolling discs: tilt, linear integrals, rates of a tilt, swing.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracles: tests/reference/disc.lua (Legendre functions with 50 digits, sharp edges); generator/dynamics/disc.lua,
-- which tests/dynamics/disc.t holds to that table and, with rounded edges, to the library's motion; and motions of the
-- library and of the emitted Taylor series, along which the integrals must stay.
-- Bars: those of the contract in the header, 2e-14 and in float 1e-5: 90 units of the last place for the roundings of
-- up to 700 pieces, walking, and for what they move near a double root.  Rows that start upright to 1e-16 have no such
-- attitude in doubles, and are left to generator/dynamics/disc.lua at the tilt that the code found.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local disc = require "generator.dynamics.disc"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local BARS = { double = 2e-14, float = 1e-5 }

local function shell(format, ...) return program.shell(string.format(format, ...)) end

local function scene(name, edge)
  return string.format([[
local I1, I3, G = param("I1", 0.25, "kg m^2"), param("I3", 0.5, "kg m^2"), param("G", 10, "m/s^2")
local edge = param("edge", 0.05, "m")
return scene { name = %q, body = tensor { mass = 1, xx = I1, yy = I1, zz = I3 },
  effects = { effect.plane { surface = contact.disc { r = %s, edge = %s }, gravity = G } },
  initial = { omega = { 0.2, 2, 1 }, attitude = { axis = "x", angle = 0.5 } }, time = { step = 0.0005 } }
]], name, edge == "0" and "1 + 0*edge" or "1", edge)
end

local MAIN = [[
#include "NAME.h"
#include "NAME_analysis.h"
#include <stdio.h>
int main(void)
{
  NAME_model m;
  NAME_real p[NAME_COUNT], x[NAME_STATES], tilt[5], swing[4], C[2], rates[2];
  double in[4 + 7];
  int i, status, all;
  for (;;) {
    for (i = 0; i < 11; i++) {
      if (scanf("%lf", in + i) != 1) return 0;
    }
    for (i = 0; i < NAME_COUNT; i++) p[i] = (NAME_real)in[i];
    for (i = 0; i < NAME_STATES; i++) x[i] = i < 7 ? (NAME_real)in[4 + i] : 0;
    if (NAME_init(&m, p)) return 1;
    swing[0] = swing[1] = swing[2] = swing[3] = C[0] = C[1] = rates[0] = rates[1] = 0;
    NAME_disc_tilt(&m, x, tilt);
    status = NAME_disc_swing(&m, x, swing);
    all = NAME_disc_integrals(&m, x, C);
    if (!all) all = NAME_disc_rates(&m, C, (NAME_real)swing[0], rates);
    printf("%d %d", status, all);
    for (i = 0; i < 5; i++) printf(" %.17g", (double)tilt[i]);
    for (i = 0; i < 4; i++) printf(" %.17g", (double)swing[i]);
    printf(" %.17g %.17g %.17g %.17g\n", (double)C[0], (double)C[1], (double)rates[0], (double)rates[1]);
  }
}
]]

-- The program of a scene as run(lines) -> rows of numbers.
local function compiled(name, edge, real)
  program.write(dir .. "/" .. name .. ".lua", scene(name, edge))
  local out, upper = dir .. "/" .. name .. real, name:upper()
  program.write(dir .. "/main.c", (MAIN:gsub("NAME_COUNT", upper .. "_NP"):gsub("NAME_STATES", upper .. "_NX")
    :gsub("NAME", name)))
  local status = shell("%s gen %s/%s.lua --with analysis --method rk4 --real %s -o %s >%s/said 2>&1 && cd %s && " ..
    "%s -std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror -I%s -c %s/%s.c " ..
    "%s/%s_analysis.c >>said 2>&1 && %s -std=c99 -I%s -o %s_run main.c %s.o %s_analysis.o -lm >>said 2>&1", binary, dir,
    name, real, out, dir, dir, os.getenv "CC" or "cc", out, out, name, out, name, os.getenv "CC" or "cc", out, out,
    name, name)
  tap.is(status, 0, name .. ", " .. real .. ": emitted and compiled without a warning")
  if status ~= 0 then tap.diag(program.read(dir .. "/said")) end
  return function(lines)
    program.write(dir .. "/in", table.concat(lines, "\n") .. "\n")
    shell("%s_run <%s/in >%s/out", out, dir, dir)
    local rows = {}
    for line in program.read(dir .. "/out"):gmatch "[^\n]+" do
      local row = {}
      for word in line:gmatch "%S+" do row[#row + 1] = tonumber(word) or 0 / 0 end
      rows[#rows + 1] = row
    end
    return rows
  end
end

local function numbers(...)
  local out = {}
  for i, x in ipairs { ... } do out[i] = string.format("%.17g", x) end
  return table.concat(out, " ")
end

-- The largest difference of {least, greatest, period, turn, C1, C2}, over what the contract says.
local function off(got, want)
  local worst, both = 0.0, math.abs(want[5]) + math.abs(want[6])
  local size = { want[1], want[2], want[3], math.max(1.0, math.abs(want[4])), both, both }
  for k = 1, 6 do
    local e = math.abs(got[k] - want[k]) / size[k]
    worst = e <= worst and worst or e == e and e or math.huge
  end
  return worst
end

local function tilts(z) return math.atan(z.s, z.c) end

-- By generator/dynamics/disc.lua, from NAME_disc_tilt's numbers.
local function expected(I1, I3, edge, G, t)
  local d = disc.of(I1, I3, 1.0, 1.0, edge, G)
  local z = { s = t[1], c = t[2], a = t[4], w = t[5] }
  local f = disc.swing(d, z, t[3])
  local want = { f.least and tilts(f.least), f.greatest and tilts(f.greatest), f.period, f.turn, disc.integrals(d, z) }
  return want, f.least
end

local function compare(name, run, edge, real, list)
  local lines = {}
  for i, r in ipairs(list) do
    local half = r[4] / 2
    -- e1 is the body's x: theta' and a are the rates along x and y, as g = (0, s, c) has g x z along x
    lines[i] = numbers(r[1], r[2], r[3], edge, math.cos(half), math.sin(half), 0.0, 0.0, r[5], r[6], r[7])
  end
  local rows = run(lines)
  tap.is(#rows, #list, name .. ": all rows")
  for i, row in ipairs(rows) do
    local r = list[i]
    local want, least = expected(r[1], r[2], edge, r[3], table.move(row, 3, 7, 1, {}))
    local got = table.move(row, 8, 13, 1, {})
    local e = off(got, want)
    -- a is all but 1/theta there, so that it has the relative error of the tilt, too
    for k, x in ipairs { least.w, least.a } do
      e = math.max(e, math.abs(row[13 + k] - x) / (math.abs(least.w) + math.abs(least.a)) / 2)
    end
    tap.ok(row[1] == 0 and row[2] == 0 and e < BARS[real], string.format("%s, %s, row %d: by the tilt", name, real, i),
      e)
    if edge == 0 and r[4] ~= 1.5707963267948966 and r[8] then
      e = off(got, table.move(r, 8, 13, 1, {}))
      tap.ok(e < BARS[real], string.format("%s, %s, row %d: Legendre functions", name, real, i), e)
    end
  end
end

local table_of = dofile "tests/reference/disc.lua"
local sharp, sharp_float = compiled("sharp", "0", "double"), compiled("sharpf", "0", "float")
local round, round_float = compiled("round", "edge", "double"), compiled("roundf", "edge", "float")
compare("sharp", sharp, 0.0, "double", table_of)
compare("round", round, 0.0, "double", table_of)
compare("round", round, 0.05, "double", table_of)
compare("round", round, 2.0, "double", table_of)
compare("sharp", sharp_float, 0.0, "float", table_of)
compare("round", round_float, 0.05, "float", table_of)

-- ---- the unit of time ----

local fast = {}
for i, r in ipairs(table_of) do
  fast[i] = { r[1], r[2], r[3] * 1e24, r[4], r[5] * 1e12, r[6] * 1e12, r[7] * 1e12 }
end
compare("a unit of time of 1e-12 s", sharp, 0.0, "double", fast)

-- ---- motions ----

-- Each step rounds the state by half a unit, walking; the library's columns are doubles.  The runs have some 3000
-- steps; 20 s are 60 falls and rises.
for _, case in ipairs { { "sharp", sharp, 0.0, "general", 2e-14 }, { "round", round, 0.05, "general", 2e-14 },
  { "sharp", sharp, 0.0, "generated --method taylor --tolerance 1e-15", 2e-13 },
  { "round", round, 0.05, "generated --method taylor --tolerance 1e-15", 2e-13 },
  { "sharpf", sharp_float, 0.0, "generated --real float --method taylor --tolerance 2e-7", 1e-4 },
  { "roundf", round_float, 0.05, "generated --real float --method taylor --tolerance 2e-7", 1e-4 } } do
  local name, run, edge, engine, bar = table.unpack(case)
  shell("%s run %s/%s.lua --engine %s --until 20 --every 0.5 --columns q,w >%s/out 2>%s/err", binary, dir, name, engine,
    dir, dir)
  local lines = {}
  for line in program.read(dir .. "/out"):gmatch "\n([%d.,e+-]+)" do
    lines[#lines + 1] = numbers(0.25, 0.5, 10, edge) .. " " .. line:gsub(",", " ")
  end
  local rows, worst = run(lines), 0.0
  for _, row in ipairs(rows) do
    for k = 12, 13 do
      local e = math.abs(row[k] - rows[1][k]) / (math.abs(rows[1][12]) + math.abs(rows[1][13]))
      worst = e <= worst and worst or e == e and e or math.huge
    end
  end
  tap.ok(#rows == 41 and worst < bar, name .. ", " .. engine .. ": both integrals stay", string.format("%d rows, %.3g",
    #rows, worst))
end

-- ---- what has no swing ----

local R = math.sqrt(0.5)
for _, case in ipairs { { "flat", { 1, 0, 0, 0, 1, 2, 3 }, 1, 1 }, { "upside down", { 0, 1, 0, 0, 1, 2, 3 }, 1, 1 },
  { "no number", { R, 0 / 0, 0, 0, 1, 2, 3 }, 1, 1 }, { "an infinite rate", { R, R, 0, 0, 1, math.huge, 3 }, 1, 1 },
  { "it falls flat", { 0.8, 0.6, 0, 0, 1, 0, 0 }, 1, 1 }, -- 0 is no tilt to ask the rates of
  { "rolling straight too slowly", { R, R, 0, 0, 0, 0, 1.8 }, 2, 0 },
  { "rolling straight", { R, R, 0, 0, 0, 0, 1.9 }, 0, 0 } } do
  for _, run in ipairs { sharp, round } do
    local row = run { (numbers(0.25, 0.5, 10, 0.0, table.unpack(case[2])):gsub("%-nan", "nan")) }[1] or {}
    tap.ok(row[1] == case[3] and row[2] == case[4], case[1] .. ": the status", table.concat(row, " "))
  end
end
-- (I1 + 1) Omega^2 = (I3 + 1) I3/I1 w^2 - G of a disc that rolls straight (Routh)
local row = sharp { numbers(0.25, 0.5, 10, 0.0, R, R, 0, 0, 0, 0, 1.9) }[1]
tap.near(row[10], 2 * math.pi / math.sqrt((3 * 1.9 ^ 2 - 10) / 1.25), 1e-14, 0, "the period of small swings",
  "a dozen roundings")

program.finish()
tap.done()
