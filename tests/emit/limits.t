#!/usr/bin/env lua5.4
-- limits.t - inputs with limits: what a NaN, an infinity and a number beyond them do, and what the header says of it.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A limit is asked by comparing, and none holds for NaN: it must not go through to the states, and full reverse is no
-- answer to a lost reading.  Each value that is not within the limits must give the bits of one that is: infinities and
-- large numbers those of the nearer limit, NaN those of the number that is nearest to 0.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local scene = require "tests.scene"

local dir = program.directory()
local WARN = "-std=c99 -O2 -ffp-contract=off -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"

local text = [[
local most = param("most", 0.6, "mN m")
return scene { name = "held", body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = param("M", 2, "kg") },
  effects = { effect.torque { body = { input("a", "N m", { min = -most, max = 2 * most }), %s, 0 } } },
  initial = { omega = { 0.1, 0.2, 0.3 } } }]]
local limited = string.format(text, 'input("b", "N m", { min = -1, max = 2 })')
local above = string.format(text, 'input("b", "N m", { min = 1, max = 2 })')
local below = string.format(text, 'input("b", "N m", { min = -2, max = -1 })')

local main = [[
#include "held.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static int same(held_real a, held_real b, held_real as_a, held_real as_b)
{
  const held_real u[HELD_NU] = {a, b}, v[HELD_NU] = {as_a, as_b};
  held_real x[HELD_NX], y[HELD_NX];
  held_model m;

  if (held_init(&m, 0) != 0) return 0;
  held_initial(&m, x);
  held_initial(&m, y);
  for (int i = 0; i < 3; i++) {
    held_step(&m, 0, x, u, (held_real)0.01);
    held_step(&m, 0, y, v, (held_real)0.01);
  }
  return memcmp(x, y, sizeof x) == 0 && x[HELD_WX] - x[HELD_WX] == 0;
}

int main(void)
{
  const held_real none = (held_real)NAN, most = (held_real)INFINITY, low = (held_real)-0.0006, high = (held_real)0.0012;

  printf("%d %d %d %d\n", same(none, none, 0, REST), same(-none, REST, 0, REST), same(most, most, high, MOST),
         same(-most, -most, low, LEAST));
  printf("%d %d %d %d\n", same(1, (held_real)1e17, high, MOST), same(low, LEAST, low, LEAST),
         same(high, MOST, high, MOST), same(low/2, MOST, high, MOST));
  return 0;
}
]]

-- Limits of b, and what NaN is there.
local function judge(source, method, real, least, most, rest)
  local files = scene.files(scene.plan(scene.read(source), { methods = { method }, real = real }))
  program.write(dir .. "/held.h", files["held.h"])
  program.write(dir .. "/held.c", files["held.c"])
  program.write(dir .. "/main.c", main)
  local code = program.shell(string.format("cd %s && gcc %s -DLEAST=%d -DMOST=%d -DREST=%d -o held main.c held.c " ..
    "-lm >log 2>&1 && ./held >out", dir, WARN, least, most, rest))
  tap.is(code, 0, method .. ", " .. real .. ": compiles", program.read(dir .. "/log"))
  tap.is(program.read(dir .. "/out"), "1 1 1 1\n1 1 1 0\n", string.format("NaN within %d .. %d is %d, infinities " ..
    "and large numbers are the nearer limit", least, most, rest))
end

for _, real in ipairs { "double", "float" } do
  for _, method in ipairs { "rk4", "taylor", "adaptive" } do judge(limited, method, real, -1, 2, 0) end
  judge(above, "rk4", real, 1, 2, 1)
  judge(below, "rk4", real, -2, -1, -1)
end

-- The same rule where expressions are evaluated, and when constants are folded.
for name, clamp in pairs { -- any order
  evaluate = require "generator.algebra.choice".values.clamp,
  folding = require "generator.ir.special.special".value.clamp,
} do
  local none = 0.0/0.0
  tap.is(table.concat({ clamp(1.0, none, -1.0, 2.0), clamp(1.0, none, 1.0, 2.0), clamp(1.0, none, -2.0, -1.0),
    clamp(1.0, 5.0, -1.0, 2.0), clamp(1.0, -5.0, -1.0, 2.0), clamp(1.0, 0.5, -1.0, 2.0) }, " "),
    "0.0 1.0 -1.0 2.0 -1.0 0.5", name .. ": NaN counts as 0")
end

-- ---- what the header says ----

local function header(source, options) return scene.files(scene.plan(scene.read(source, options)))["held.h"] end

local SAID = "/* An input beyond its limits acts like the nearer limit, and one that is not a number (NaN) like"
local h = header(limited)
tap.like(h, SAID, "the header says what NaN does")
tap.like(h, "HELD_A, /* a [N m], limited to -most .. 2*most; by default -0.0006 .. 0.0012 */",
  "limits of parameters are formulas")
tap.like(h, "HELD_B, /* b [N m], limited to -1.0 .. 2.0 */", "others are numbers")
tap.like(h, "HELD_MOST, /* default 0.0006 [kg m^2/s^2], 0.6 mN m in the scene */",
  "a default is the number that p[] takes")
tap.like(h, "HELD_M, /* default 2 [kg] */", "the unit once")
tap.like(header(limited, { bake = true }), "HELD_A, /* a [N m], limited to -0.0006 .. 0.0012 */",
  "and with --bake all limits are numbers")
h = header((string.gsub(string.format(text, "0"), ", { min.-}", "")))
tap.ok(not h:find("limit", 1, true), "without limits nothing is said of them")

program.finish()
tap.done()
