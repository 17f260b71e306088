#!/usr/bin/env lua5.4
-- limits.t - inputs with limits: what a NaN, an infinity and a number beyond them do, and what the header says of it.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A limit is asked by comparing, and none holds for NaN: it must not go through to the states.  Each value that is not
-- within the limits must give the bits of a limit: infinities and large numbers the nearer one, NaN the lower one.

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

  printf("%d %d %d %d %d\n", same(none, none, low, -1), same(-none, 0, low, 0), same(most, most, high, 2),
         same(-most, -most, low, -1), same(1, (held_real)1e17, high, 2));
  printf("%d %d %d\n", same(low, -1, low, -1), same(high, 2, high, 2), same(low/2, 1, high, 2));
  return 0;
}
]]

for _, real in ipairs { "double", "float" } do
  for _, method in ipairs { "rk4", "taylor", "adaptive" } do
    local files = scene.files(scene.plan(scene.read(limited), { methods = { method }, real = real }))
    program.write(dir .. "/held.h", files["held.h"])
    program.write(dir .. "/held.c", files["held.c"])
    program.write(dir .. "/main.c", main)
    local code = program.shell(string.format("cd %s && gcc %s -o held main.c held.c -lm >log 2>&1 && ./held >out", dir,
      WARN))
    tap.is(code, 0, method .. ", " .. real .. ": compiles", program.read(dir .. "/log"))
    tap.is(program.read(dir .. "/out"), "1 1 1 1 1\n1 1 0\n", "NaN acts like the lower limit, infinities and large " ..
      "numbers like the nearer one")
  end
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
