#!/usr/bin/env lua5.4
-- means.t - the emitted means over arcs and catenaries: against 200 bits, against the ir's, and only where they are
-- used.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The emitted file is compiled into a program that reads arguments and prints the six functions as hexadecimal numbers.
-- Bound, 3 ulp. Up to 3 a sum of pairs is right to one rounding, then comes one division, and for the rise one
-- product:
-- 2 ulp; the width has 4 roundings of which the fraction's are damped.  Beyond, each closed form has a constant that
-- outweighs the rest and some 4 roundings of what is at most a third of the result. arc_lever has zeros beyond pi: it
-- is
-- there a product of inertia beside a variance above 1, and is measured in units of the last place of 1.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local R = require "generator.algebra.rational"
local eval = require "tests.ir.eval"
local series = require "generator.ir.special.series"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()
local WARN = "-std=c99 -O2 -ffp-contract=off -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"

local function scene(name, of, more)
  local path = dir .. "/" .. name .. ".lua"
  program.write(path, "return scene { name = '" .. name .. "', body = " .. of .. ", origin = {0, 0, 0} }")
  return program.shell(string.format("POLHODE_SOURCE=. %s gen --layout single %s %s -o %s >%s/log 2>&1", binary,
    more or "", path, dir,
    dir)), program.read(dir .. "/" .. name .. ".c") or program.read(dir .. "/log")
end

-- All six at once; and what was computed before, closed forms alone, which must not pass.
local names, calls, prints = {}, {}, {}
for i, row in ipairs(series.list) do
  names[i], calls[i], prints[i] = row[1], "(double)" .. row[1] .. "(x)", "%a"
end
local body = [[
#include "all.c"
#include <math.h>
#include <stdio.h>

int main(void)
{
  double a;

  while (scanf("%la", &a) == 1) {
    const all_real x = (all_real)a;
    const double m = sin(a)/a, naive = (1.0 + sin(2.0*a)/(2.0*a))/2.0 - m*m;
    printf("]] .. table.concat(prints, " ") .. [[ %a\n", ]] .. table.concat(calls, ", ") .. [[, naive);
  }
  return 0;
}
]]

local all = [[wire.helix { r = param("a", 1, "m"), pitch = 1, turns = param("n", 1), mass = 1 } +
  wire.catenary { a = param("b", 1, "m"), span = param("s", 1, "m"), mass = 1 }]]

-- Arguments up to `most`: halvings to nothing, a fine grid about 3 where the formulas meet, quarter turns and their
-- neighbours, and at random in the logarithm.
local function grid(round, least, most)
  local state, list = 4711, {}
  local function put(x) list[#list + 1] = round(x) end
  for _, x in ipairs { least, 1e-20, 1e-8, 1e-3, 0.1, 1, 3, 50, 700 } do put(x) end
  for k = 1, 200 do put(k / 50) end
  for k = -20, 20 do put(3 + k * 2e-7) end
  for k = 1, 16 do
    for d = -3, 3 do put(math.pi / 4 * k * (1 + d * 1e-7)) end
  end
  for _ = 1, 400 do
    state = state * 48271 % 2147483647 -- Lehmer's generator
    local u = state / 2147483647
    put(math.exp(math.log(least) + u ^ 0.2 * (math.log(most) - math.log(least))))
  end
  return list
end

local reals = {
  { name = "double", digits = 53, exponent = -1022, least = 1e-300, round = function(x) return x * 1.0 end },
  { name = "float", digits = 24, exponent = -126, least = 1e-37, round = eval.float },
}

-- |got - want| in units of the last place of `of`, at least of the smallest normal number.
local function ulps(got, want, of, real)
  local e = R.sign(of) ~= 0 and R.log2(of) or real.exponent
  if e < real.exponent then e = real.exponent end
  return R.todouble(R.abs(R.fromdouble(got) - want) / R.new(2) ^ (e - real.digits + 1))
end

for _, real in ipairs(reals) do
  local status, code = scene("all", all, "--real " .. real.name)
  if not tap.is(status, 0, real.name .. ": the scene is emitted") then tap.diag(code) end
  local points, want, lines = grid(real.round, real.least, 2e6 * math.pi), {}, {}
  for i, p in ipairs(points) do
    want[i] = {}
    for n, name in ipairs(names) do want[i][n] = R.apply(name, 200, R.fromdouble(p)) end
    lines[i] = string.format("%a", p)
  end
  program.write(dir .. "/points", table.concat(lines, "\n") .. "\n")
  program.write(dir .. "/main.c", body)
  for _, compiler in ipairs { "gcc", "clang" } do
    local build = string.format("cd %s && %s %s -o try main.c -lm >log 2>&1 && ./try <points >values", dir,
      compiler, WARN)
    if not tap.is(program.shell(build), 0, real.name .. ", " .. compiler .. ": no warning, and it runs") then
      tap.diag(program.read(dir .. "/log"))
    end
    local worst, at, differ, k, naive = {}, {}, 0, 0, 0
    for line in string.gmatch(program.read(dir .. "/values"), "[^\n]+") do
      k = k + 1
      local x, n = points[k], 0
      for word in string.gmatch(line, "%S+") do
        n = n + 1
        local got = tonumber(word) or 0 / 0
        if n > #names then
          if x > 1e-3 and x < 1 then naive = math.max(naive, ulps(got, want[k][2], want[k][2], real)) end
        else
          local of = want[k][n]
          if names[n] == "arc_lever" and x > math.pi then of = R.one end
          local u = got == got and math.abs(got) < math.huge and ulps(got, want[k][n], of, real) or math.huge
          if u > (worst[n] or -1) then worst[n], at[n] = u, lines[k] end
          if x <= 3 and k % 4 == 0 and compiler == "gcc" and real.round(series.list[n][3](real.round,
            x)) ~= got then differ = differ + 1 end
        end
      end
    end
    tap.is(k, #points, "every point has an answer")
    for n, name in ipairs(names) do
      tap.diag(string.format("%s, %s: %s is at worst %.2f ulp off, at %s", real.name, compiler, name, worst[n], at[n]))
      tap.ok(worst[n] <= 3, real.name .. ", " .. compiler .. ": " .. name .. " is within 3 ulp at every point")
    end
    tap.is(differ, 0, real.name .. ", " .. compiler .. ": the ir computes the same to the bit up to 3, at every fourth")
    if real.name == "double" then tap.ok(naive > 1e4, "the closed form of arc_along alone would not pass") end
  end
  local plus = "cd " .. dir .. " && g++ -std=c++11 -pedantic -Wall -Wextra -Wshadow -Werror -x c++ -c all.c -o all.o"
  tap.is(program.shell(plus), 0, real.name .. ": C++ takes it")
  if real.name == "float" then
    local plain = string.gsub(code, "/%*.-%*/", "")
    tap.ok(not string.find(plain, "[^%w_]sin%(") and not string.find(plain, "[^%w_]exp%("), "float: sinf and expf")
  end
end

-- ---- only where they are used ----

do
  local function has(code, name) return string.find(code, name .. "(", 1, true) ~= nil end
  local shapes = {
    { "arc", 'wire.arc { r = 1, angle = param("w", 1, "rad"), mass = 1 }', "110000" },
    { "sector", 'plate.sector { r = 1, angle = param("w", 1, "rad"), mass = 1 }', "110000" },
    { "helix", 'wire.helix { r = 1, pitch = 1, turns = param("n", 1), mass = 1 }', "111000" },
    { "catenary", 'wire.catenary { a = param("a", 1, "m"), span = 1, mass = 1 }', "000111" },
    { "half", 'wire.arc { r = param("r", 1, "m"), angle = math.pi, mass = 1 }', "000000" },
    { "fixed", 'wire.catenary { a = 1, span = 1, density = param("rho", 1, "kg/m") }', "000000" },
  }
  for _, row in ipairs(shapes) do
    local name, of, want = table.unpack(row)
    local _, code = scene(name, of)
    local got = {}
    for i, fn in ipairs(names) do got[i] = has(code, " " .. fn) and "1" or "0" end
    if not tap.is(table.concat(got), want, name .. ": the functions that it needs") then tap.diag(code) end
    for _, compiler in ipairs { "gcc", "clang" } do
      tap.is(program.shell(string.format("cd %s && %s %s -c %s.c -o %s.o 2>log", dir, compiler, WARN, name, name)), 0,
        name .. ": no warning from " .. compiler)
    end
  end
end

-- ---- a thin arc about its bisector: all three moments to a few units of their own last place ----

do
  local path = dir .. "/thin.lua"
  program.write(path, [[
local w = param("w", 1, "rad")
return scene { name = "thin", body = wire.arc { r = 3, angle = w, mass = 7 }:turned { axis = {0, 0, 1},
  angle = -w/2 } }]])
  local status = program.shell(string.format("POLHODE_SOURCE=. %s gen --layout single %s -o %s >%s/log 2>&1", binary,
    path, dir, dir))
  tap.is(status, 0, "the thin arc is emitted")
  program.write(dir .. "/main.c", [[
#include "thin.c"
#include <stdio.h>

int main(void)
{
  double w, I[6];
  thin_model m;

  while (scanf("%la", &w) == 1) {
    if (thin_init(&m, &w)) return 1;
    thin_inertia(&m, I);
    printf("%a %a %a %a\n", I[0], I[1], I[2], I[3]);
  }
  return 0;
}
]])
  local angles, lines = { 1e-30, 1e-8, 1e-3, 0.5, 3, 3.14, 5, 6.28 }, {}
  for i, w in ipairs(angles) do lines[i] = string.format("%a", w) end
  program.write(dir .. "/points", table.concat(lines, "\n") .. "\n")
  tap.is(program.shell(string.format("cd %s && gcc %s -o try main.c -lm 2>log && ./try <points >values", dir, WARN)), 0,
    "and runs")
  local i, worst = 0, 0
  for line in string.gmatch(program.read(dir .. "/values"), "[^\n]+") do
    i = i + 1
    local h = R.fromdouble(angles[i]) / R.new(2)
    local across, along = R.apply("arc_across", 200, h), R.apply("arc_along", 200, h)
    local want, n = { across, along, across + along, R.zero }, 0
    for word in string.gmatch(line, "%S+") do
      n = n + 1
      worst = math.max(worst, ulps(tonumber(word), R.new(63) * want[n], R.new(63) * want[n], reals[1]))
    end
  end
  tap.is(i, #angles, "every angle has an answer")
  -- 2 ulp of the function, a sum and a product
  tap.ok(worst <= 4, string.format("thin and wide arcs: each principal moment within 4 ulp of itself (%.2f)", worst))
end

program.finish()
tap.done()
