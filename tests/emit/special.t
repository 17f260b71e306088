#!/usr/bin/env lua5.4
-- special.t - the emitted helpers: their values against 200 bits, against the ir's, and only where they are used.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The emitted file is compiled into a program that reads axes and prints area and normal as hexadecimal numbers.
-- Bounds: the pairs leave the sum of shares right to one rounding; the ratios of the axes (1/2 ulp each, weighted
-- with shares
-- below 1) and two products add up to 2 roundings of area, hence 2 ulp of its own, for a rounding is at most 1/2 ulp of
-- a number up to twice as large; the third unit is for the rounding of the pair and what the series leaves.  A normal
-- depends on a ratio up to its square (2 roundings) and is a quotient of two rounded sums (1 1/2): 3 ulp too.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local R = require "generator.algebra.rational"
local eval = require "tests.ir.eval"
local algorithm = require "generator.ir.special.special"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()
local WARN = "-std=c99 -O2 -ffp-contract=off -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"

local body = [[
#include "egg.c"
#include <stdio.h>

int main(void)
{
  double a, b, c;

  while (scanf("%la %la %la", &a, &b, &c) == 3) {
    const egg_real x = (egg_real)a, y = (egg_real)b, z = (egg_real)c;
    printf("%a %a\n", (double)ellipsoid_area(x, y, z), (double)ellipsoid_normal(x, y, z));
  }
  return 0;
}
]]

local function scene(name, of, more)
  local path = dir .. "/" .. name .. ".lua"
  program.write(path, "return scene { name = '" .. name .. "', body = " .. of .. ", initial = { omega = {1, 2, 3} } }")
  return program.shell(string.format("POLHODE_SOURCE=. %s gen --layout single %s %s -o %s >%s/log 2>&1", binary,
    more or "", path, dir,
    dir)), program.read(dir .. "/" .. name .. ".c") or program.read(dir .. "/log")
end

local egg = [[shell.ellipsoid { a = param("a", 1, "m"), b = param("b", 2, "m"), c = param("c", 3, "m"),
  density = param("rho", 2, "kg/m^2") }]]

-- Axes over a grid of ratios and, reproducibly, at random: close to the sphere, to spheroids, and far from all.
local function grid(round, most)
  local state, list = 1749, {}
  local function random()
    state = state * 48271 % 2147483647 -- Lehmer's generator
    return state / 2147483647
  end
  local function put(a, b, c) list[#list + 1] = { round(a), round(b), round(c) } end
  local ratios = { 1, 1 + 1e-9, 1 + 1e-6, 1.001, 1.5, 3, 1e2, 1e5, most }
  for _, x in ipairs(ratios) do
    for _, y in ipairs(ratios) do
      put(1, x, y)
      put(1, x, 1 / y)
      put(1, 1 / x, 1 / y)
    end
  end
  for k = 1, 600 do
    local width = ({ 1e-6, 0.1, 1, 5, math.log(most) })[k % 5 + 1]
    local function axis() return math.exp((2 * random() - 1) * width) end
    local a, b = axis(), axis()
    put(a, b, k % 4 == 0 and a or k % 4 == 1 and b or axis())
  end
  return list
end

local reals = {
  { name = "double", digits = 53, least = -1022, most = 1e30, round = function(x) return x * 1.0 end },
  { name = "float", digits = 24, least = -126, most = 1e15, round = eval.float },
}

-- |got - want| in units of the last place of want, which below the normal range is that of the smallest normal number.
local function ulps(got, want, real)
  local e = R.log2(want)
  if e < real.least then e = real.least end
  return R.todouble(R.abs(R.fromdouble(got) - want) / R.new(2) ^ (e - real.digits + 1))
end

for _, real in ipairs(reals) do
  local status, code = scene("egg", egg, "--real " .. real.name)
  tap.is(status, 0, real.name .. ": the scene is emitted")
  local points, want, lines = grid(real.round, real.most), {}, {}
  for i, p in ipairs(points) do
    local a, b, c = R.fromdouble(p[1]), R.fromdouble(p[2]), R.fromdouble(p[3])
    want[i] = { R.apply("ellipsoid_area", 200, a, b, c), R.apply("ellipsoid_normal", 200, a, b, c) }
    lines[i] = string.format("%a %a %a", p[1], p[2], p[3])
  end
  program.write(dir .. "/points", table.concat(lines, "\n") .. "\n")
  program.write(dir .. "/main.c", body)
  for _, compiler in ipairs { "gcc", "clang" } do
    local build = string.format("cd %s && %s %s -o try main.c -lm >log 2>&1 && ./try <points >values", dir,
      compiler, WARN)
    if not tap.is(program.shell(build), 0, real.name .. ", " .. compiler .. ": no warning, and it runs") then
      tap.diag(program.read(dir .. "/log"))
    end
    local worst, at, differ, k = { 0, 0 }, {}, 0, 0
    for x, y in string.gmatch(program.read(dir .. "/values"), "(%S+) (%S+)") do
      k = k + 1
      local p = points[k]
      for n, word in ipairs { x, y } do
        local got = tonumber(word) or 0 / 0
        local u = got == got and math.abs(got) < math.huge and ulps(got, want[k][n], real) or math.huge
        if u > worst[n] then worst[n], at[n] = u, lines[k] end
        local mirror = real.round(algorithm.list[n][3](real.round, p[1], p[2], p[3]))
        if mirror ~= got then differ = differ + 1 end
      end
    end
    tap.is(k, #points, "every point has an answer")
    for n, name in ipairs { "area", "normal" } do
      tap.diag(string.format("%s, %s: %s is at worst %.2f ulp off, at %s", real.name, compiler, name, worst[n], at[n]))
      tap.ok(worst[n] <= 3, real.name .. ", " .. compiler .. ": " .. name .. " is within 3 ulp at every point")
    end
    tap.is(differ, 0, real.name .. ", " .. compiler .. ": the ir computes the same to the bit")
  end
  local plus = "cd " .. dir .. " && g++ -std=c++11 -pedantic -Wall -Wextra -Wshadow -Werror -x c++ -c egg.c -o egg.o"
  tap.is(program.shell(plus), 0, real.name .. ": C++ takes it")
  local function count(pattern) return select(2, string.gsub(code, pattern, "")) end
  tap.is(count "static real ellipsoid_area", 1, real.name .. ": one helper, however often it is called")
  if real.name == "float" then
    tap.ok(not string.find(string.gsub(code, "/%*.-%*/", ""), "[^%w_]sqrt%("), "float: the root is sqrtf")
  end
end

-- ---- only where it is used ----

do
  local _, box = scene("box", 'solid.box { x = param("x", 1, "m"), y = 2, z = 3, mass = 1 }')
  tap.ok(not string.find(box, "functions that libm lacks", 1, true), "a box has no helper")
  local _, given = scene("given", 'shell.ellipsoid { a = param("a", 1, "m"), b = 2, c = 3, mass = 1 }')
  tap.ok(string.find(given, "static real ellipsoid_normal", 1, true) and
    not string.find(given, "ellipsoid_area", 1, true), "with the mass given the area is not needed, and not there")
  local _, fixed = scene("fixed", "shell.ellipsoid { a = 1, b = 2, c = 3, density = 1 }")
  tap.ok(not string.find(fixed, "ellipsoid_", 1, true), "without parameters the values are numbers")
  local _, round = scene("round", 'shell.ellipsoid { a = 2, b = 2, c = 2, density = param("rho", 1, "kg/m^2") }')
  tap.ok(not string.find(round, "ellipsoid_", 1, true), "a sphere needs none")
  local _, top = scene("top", [[(function()
    local a = param("a", 1, "m")
    return shell.ellipsoid { a = a, b = a, c = 3, mass = 1 }
  end)()]])
  tap.is(select(2, string.gsub(top, "} pair;", "")), 1, "helper and closed form share one arithmetic of pairs")
  for _, name in ipairs { "given", "fixed", "round", "top" } do
    for _, compiler in ipairs { "gcc", "clang" } do
      tap.is(program.shell(string.format("cd %s && %s %s -c %s.c -o %s.o", dir, compiler, WARN, name, name)), 0,
        name .. ": no warning from " .. compiler)
    end
  end
end

program.finish()
tap.done()
