#!/usr/bin/env lua5.4
-- taylor_top.t - the Taylor series of the heavy symmetric top (Lame's equation) against its closed form.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local WARN = "-std=c99 -O2 -ffp-contract=off -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"

-- In both texts, portable and of vectors: tilts from upright to hanging, no
-- spin, a rate along the axis alone, either side of what sleeps, a torque the other way (c < 0), almost none.
program.write(dir .. "/heavy.lua", [[
local height, I1, I3 = param("height", 0.1, "m"), param("I1", 0.02, "kg m^2"), param("I3", 0.01, "kg m^2")
return scene { name = "heavy", origin = {0, 0, 0},
  body = tensor { mass = 1, com = {0, 0, height}, xx = I1, yy = I1, zz = I3, about = "origin" },
  effects = { effect.gravity { g = 10 } }, initial = { omega = {0.4, 3, 20} } }]])
program.write(dir .. "/heavy.c", [[
#include "heavy.h"
#include <math.h>
#include <stdio.h>
int main(void)
{
  static const double parameters[][3] = {{0.1, 0.02, 0.01}, {-0.1, 0.02, 0.01}, {1e-7, 0.02, 0.03},
    {0.1, 0.02, 0.0199}};
  static const double rates[][3] = {{0.4, 3, 20}, {0, 0, 0}, {0, 0, 30}, {5, 0, 0}, {1, -2, -15}, {0, 0, 0.5}};
  static const double tilts[] = {0, 1e-9, 0.5, 1.5707963267948966, 3, 3.141592653589793};
  double worst = 0, miss = 0;
  unsigned int i, j, l;
  int k, e;

  for (i = 0; i < sizeof parameters/sizeof parameters[0]; i++)
    for (j = 0; j < sizeof rates/sizeof rates[0]; j++)
      for (l = 0; l < sizeof tilts/sizeof tilts[0]; l++) {
        double x0[HEAVY_NX] = {0}, x[HEAVY_NX], y[HEAVY_NX];
        heavy_model m;
        heavy_orbit o;

        if (heavy_init(&m, parameters[i])) return 1;
        x0[0] = 0.8*cos(tilts[l]/2), x0[3] = 0.6*cos(tilts[l]/2);
        x0[1] = 0.6*sin(tilts[l]/2), x0[2] = 0.8*sin(tilts[l]/2);
        for (k = 0; k < 3; k++) x0[4 + k] = rates[j][k];
        if (heavy_solve(&o, &m, x0)) return 1;
        heavy_at(&o, 0.5, y);
        for (e = -3; e >= -15; e -= 3) {
          double d = 0;

          for (k = 0; k < HEAVY_NX; k++) x[k] = x0[k];
          if (heavy_taylor_run(&m, 0, x, 0, 0.5, pow(10, e), 4000) < 0) return 2;
          for (k = 0; k < HEAVY_NX; k++) d = fmax(d, fabs(x[k] - y[k])/(k < 4 ? 1 : 30));
          if (e == -15) worst = fmax(worst, d);
          else miss = fmax(miss, d/pow(10, e));
        }
      }
  printf("%a %a\n", worst, miss);
  return 0;
}
]])
tap.is(program.shell(string.format("POLHODE_SOURCE=. %s gen --layout single --method taylor,exact --order 24 -o " ..
  "%s/heavy %s/heavy.lua",
  binary, dir, dir)), 0, "gen of a heavy top")
for _, build in ipairs { WARN, "-O2 -march=native -DHEAVY_VECTOR -Wall -Werror" } do
  local status = program.shell(string.format("gcc %s -I%s/heavy -o %s/heavy/main %s/heavy.c %s/heavy/heavy.c -lm " ..
    "2>&1 && %s/heavy/main > %s/heavy/log", build, dir, dir, dir, dir, dir, dir))
  local v = {}
  for word in string.gmatch(program.read(dir .. "/heavy/log") or "", "%S+") do v[#v + 1] = tonumber(word) end
  local text = build == WARN and "portable" or "vectors"
  tap.is(status, 0, text .. ": heavy tops of all kinds and states arrive")
  -- some 50 steps with errors of a few units; those of an upright top grow by exp(7/s 0.5 s) = 33
  tap.ok(v[1] and v[1] <= 33 * 50 * 4 * 2.0 ^ -52, text .. ": Lame's equation gives the closed form's state",
    string.format("%.3g", v[1] or 0))
  tap.ok(v[2] and v[2] <= 33, text .. ": a heavy top's error follows the tolerance", string.format("%.3g", v[2] or 0))
end

tap.done()
