#!/usr/bin/env lua5.4
-- init.t - the emitted NAME_init accepts every tensor that a body has, rounded or not, and refuses the others.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A scene whose tensor is seven parameters (ten about the origin) is compiled in double and float.  The C program below
-- makes bodies of n particles at random, 1e-4 to 1e2 m large and up to 1e3 sizes from the origin: n = 2 a rod, n = 3 a
-- lamina, both on the border of the lawful, n = 4 a body.  Rounded to the working type the tensors are off by a few
-- roundings, to either side of the border, and none may be refused for the triangle inequality (an oblique rod is for
-- having no inverse).  Then 1e-3 of the trace is taken from Sigma across a rod or lamina, where there is nothing to
-- take: these must all be refused for it.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()

local function params(list) -- a cube's tensor by default
  local out = {}
  for name, unit in list:gmatch "(%w+):([^,]+),?" do
    local default = #name == 2 and name:sub(1, 1) == name:sub(2, 2) and 1 or name == "mm" and 1 or 0
    out[#out + 1] = string.format("local %s = param(\"%s\", %s, \"%s\")", name, name, default, unit)
  end
  return table.concat(out, "\n") .. "\n"
end

local names = "mm:kg,xx:kg m^2,yy:kg m^2,zz:kg m^2,xy:kg m^2,xz:kg m^2,yz:kg m^2"
program.write(dir .. "/com.lua", params(names) .. [[
return scene { name = "com", body = tensor { mass = mm, xx = xx, yy = yy, zz = zz, xy = xy, xz = xz, yz = yz } }
]])
program.write(dir .. "/origin.lua", params(names .. ",cx:m,cy:m,cz:m") .. [[
return scene { name = "origin", body = tensor { mass = mm, com = {cx, cy, cz}, xx = xx, yy = yy, zz = zz, xy = xy,
  xz = xz, yz = yz, about = "origin" } }
]])

local main = [[
#include <math.h>
#include <stdio.h>
#include "NAME.h"

static unsigned long state = 1;

static double uniform(void) /* Park and Miller, in (-1, 1) */
{
  state = state * 16807ul % 2147483647ul;
  return 2.0 * (double)state / 2147483647.0 - 1.0;
}

int main(void)
{
  int lawful = 0, accepted = 0, unlawful = 0, refused = 0;
  for (int k = 0; k < 3000; k++) {
    int n = 2 + k % 3;
    double scale = pow(10.0, (double)(k % 7) - 4.0), far = FAR ? pow(10.0, (double)(k % 4)) : 0.0;
    double m[4], r[4][3], c[3] = { 0 }, M = 0, S[3][3] = { { 0 } }, u[3], v[3], w[3], steiner = 0;
    for (int i = 0; i < n; i++) {
      m[i] = 1.5 + uniform();
      M += m[i];
      for (int j = 0; j < 3; j++) r[i][j] = scale * (uniform() + far);
    }
    for (int i = 0; i < n; i++)
      for (int j = 0; j < 3; j++) c[j] += m[i] * r[i][j] / M;
    for (int i = 0; i < n; i++)
      for (int j = 0; j < 3; j++)
        for (int l = 0; l < 3; l++) S[j][l] += m[i] * (r[i][j] - c[j]) * (r[i][l] - c[l]);
    for (int j = 0; j < 3; j++) {
      u[j] = (r[1][j] - r[0][j]) / scale;
      v[j] = n > 2 ? (r[2][j] - r[0][j]) / scale : uniform();
      steiner += FAR ? M * c[j] * c[j] : 0;
    }
    for (int j = 0; j < 3; j++) w[j] = u[(j + 1) % 3] * v[(j + 2) % 3] - u[(j + 2) % 3] * v[(j + 1) % 3];
    double square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
    for (int bad = 0; bad < (n < 4 ? 2 : 1); bad++) {
      double lost = bad ? 1e-3 * (S[0][0] + S[1][1] + S[2][2] + steiner) / square : 0, T[3][3], t = 0;
      for (int j = 0; j < 3; j++) {
        for (int l = 0; l < 3; l++) T[j][l] = S[j][l] - lost * w[j] * w[l] + (FAR ? M * c[j] * c[l] : 0);
        t += T[j][j];
      }
      NAME_real p[] = { (NAME_real)M, (NAME_real)(t - T[0][0]), (NAME_real)(t - T[1][1]), (NAME_real)(t - T[2][2]),
        (NAME_real)-T[0][1], (NAME_real)-T[0][2], (NAME_real)-T[1][2], (NAME_real)c[0], (NAME_real)c[1],
        (NAME_real)c[2] };
      NAME_model model;
      int status = NAME_init(&model, p);
      if (bad) {
        unlawful++;
        refused += status != 0 && status <= LAST; /* a moment may be negative, said first */
      } else {
        lawful++;
        /* a tensor that has no inverse, or none left after the shift from 1e3 sizes away, is refused for that */
        accepted += status == 0 || (status > LAST && (n == 2 || far > 100));
      }
    }
  }
  printf("%d of %d accepted, %d of %d refused\n", accepted, lawful, refused, unlawful);
  return 0;
}
]]

for _, name in ipairs { "com", "origin" } do
  for _, real in ipairs { "double", "float" } do
    local out = dir .. "/" .. name .. "_" .. real
    program.shell(string.format("%s gen --real %s -o %s %s/%s.lua >%s.log 2>&1", binary, real, out, dir, name, out))
    local first, last
    for code in (program.read(out .. "/" .. name .. ".h") or ""):gmatch "%*   (%d+)  tensor: the triangle" do
      first, last = first or code, code
    end
    tap.ok(first and last - first == 2, name .. ", " .. real .. ": init tests three pivots", program.read(out ..
      ".log"))
    program.write(out .. "/test.c", (main:gsub("NAME", name)))
    program.shell(string.format("cc -std=c99 -O1 -DLAST=%s -DFAR=%d -o %s/test %s/test.c %s/%s.c -lm >%s.log 2>&1",
      last, name == "origin" and 1 or 0, out, out, out, name, out))
    program.shell(out .. "/test >>" .. out .. ".log")
    tap.is(program.read(out .. ".log"), "3000 of 3000 accepted, 2000 of 2000 refused\n",
      name .. ", " .. real .. ": rods, laminas and bodies pass, what is less than nothing does not")
  end
end

-- A hole whose size is a parameter has the second moments tested: sums over the pieces, but the products, which no
-- parameter changes, as numbers.  Those of a rod along (1, 2, 2)/3 are so large that any other sign of theirs is no
-- body's.
program.write(dir .. "/bored.lua", [[local a = param("a", 0.02, "m")
return scene { name = "bored", origin = "centroid", body = tensor { mass = 9, xx = 8.1, yy = 5.1, zz = 5.1,
  xy = -2, xz = -2, yz = -4 } + solid.box { x = 0.2, y = 0.2, z = 0.2, density = 1000 } -
  solid.box { x = a, y = a, z = 0.02, density = 1000 } }
]])
tap.is(program.shell(string.format("%s run --engine generated --at 0 %s/bored.lua >%s/bored.log 2>&1", binary, dir,
  dir)),
  0, "a rod with a hole, its products numbers: accepted")

tap.done(program.finish())
