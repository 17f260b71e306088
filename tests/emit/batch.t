#!/usr/bin/env lua5.4
-- batch.t - gen --with batch: many bodies at once have the bits that the functions of one body give them.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The oracle is the scalar step of the same scene, body by body, compared as bytes: for numbers of bodies below, at and
-- beyond a block, for one model and for a model a body, with gcc and clang, with and without vector instructions.  That
-- the scalar step is right, other tests say.  Parameters that are no body are refused body by body.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local STRICT = "-std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror -ffp-contract=off"

local MAIN = [[
#include "NAME_batch.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef NAME_real num;

/* a few per cent apart, the same on every machine */
static num bent(num x, int i, int k) { return x + (num)0.01*(num)((7*k + 3*i)%11 - 5)*(x == 0 ? (num)1 : x); }

static int differ(const num a[], const num x[], int n, int k)
{
  int i, bad = 0;

  for (i = 0; i < UPPER_NX; i++) bad += memcmp(&a[i], &x[i*n + k], sizeof(num)) != 0;
  return bad;
}

int main(void)
{
  static const int counts[] = {1, 3, UPPER_LANES, UPPER_LANES + 1, 2*UPPER_LANES + 5};
  const num h = (num)STEP;
  NAME_model m;
  num x0[UPPER_NX], none[1] = {0};
  int c, bad = 0, moved = 0, parameters = 0, rates = 0;

  if (NAME_init(&m, 0)) return 1;
  NAME_initial(&m, x0);
  for (c = 0; c < 5; c++) {
    const int n = counts[c];
    num *x = malloc(sizeof(num)*UPPER_NX*(size_t)n), *y = malloc(sizeof(num)*UPPER_NX*(size_t)n);
    num *d = malloc(sizeof(num)*UPPER_NX*(size_t)n), *u = malloc(sizeof(num)*(NU + 1)*(size_t)n);
    int i, k, j;

    for (k = 0; k < n; k++) {
      for (i = 0; i < UPPER_NX; i++) x[i*n + k] = y[i*n + k] = i < 4 && KEEP ? x0[i] : bent(x0[i], i, k);
      for (i = 0; i < NU; i++) u[i*n + k] = bent((num)0.01, i, k);
    }
    NAME_rhs_many(&m, (num)0.5, x, u, d, n);
    for (k = 0; k < n; k++) {
      num s[UPPER_NX], v[NU + 1], ds[UPPER_NX];

      for (i = 0; i < UPPER_NX; i++) s[i] = x[i*n + k];
      for (i = 0; i < NU; i++) v[i] = u[i*n + k];
      v[NU] = none[0];
      NAME_rhs(&m, (num)0.5, s, v, ds);
      rates += differ(ds, d, n, k);
    }
    NAME_step_many(&m, (num)0.5, x, u, h, n);
    NAME_advance_many(&m, (num)0.5, x, u, h, 6, n);
    for (k = 0; k < n; k++) {
      num s[UPPER_NX], v[NU + 1];

      for (i = 0; i < UPPER_NX; i++) s[i] = y[i*n + k];
      for (i = 0; i < NU; i++) v[i] = u[i*n + k];
      v[NU] = none[0];
      NAME_step(&m, (num)0.5, s, v, h);
      for (j = 0; j < 6; j++) NAME_step(&m, (num)0.5 + (num)j*h, s, v, h);
      bad += differ(s, x, n, k);
      for (i = 0; i < UPPER_NX; i++) moved += memcmp(&s[i], &y[i*n + k], sizeof(num)) != 0;
    }
    EACH
    RUN
    free(x);
    free(y);
    free(d);
    free(u);
  }
  printf("bad %d rates %d parameters %d moved %d\n", bad, rates, parameters, moved > 0);
  return 0;
}
]]

-- To an end at a tolerance, each body in as many steps as alone; one that needs too many stops where it stops alone.
local RUN = [[
    {
      int *steps = malloc(sizeof(int)*(size_t)n);
      const num tolerance = sizeof(num) == 8 ? (num)1e-10 : (num)1e-4;

      for (i = 0; i < UPPER_NX*n; i++) x[i] = y[i];
      NAME_taylor_run_many(&m, (num)0.5, x, u, (num)2, tolerance, 12, steps, n);
      for (k = 0; k < n; k++) {
        num s[UPPER_NX], v[NU + 1];

        for (i = 0; i < UPPER_NX; i++) s[i] = y[i*n + k];
        for (i = 0; i < NU; i++) v[i] = u[i*n + k];
        v[NU] = none[0];
        bad += steps[k] != NAME_taylor_run(&m, (num)0.5, s, v, (num)2, tolerance, 12);
        bad += differ(s, x, n, k);
      }
      free(steps);
    }
]]

-- A model a body: body 2 has a parameter that is refused, if the scene refuses any.
local EACH = [[
    {
      num p[UPPER_NP], *all = malloc(sizeof(num)*UPPER_NP*(size_t)n), *own = malloc(sizeof(num)*UPPER_NC*(size_t)n);
      int *status = malloc(sizeof(int)*(size_t)n), refused, want = 0;

      NAME_defaults(p);
      for (k = 0; k < n; k++) {
        for (i = 0; i < UPPER_NP; i++) all[i*n + k] = k == 2 ? -p[i] : p[i]*((num)1 + (num)k/(num)64);
      }
      for (i = 0; i < UPPER_NX*n; i++) x[i] = y[i];
      refused = NAME_init_many(own, all, status, n);
      NAME_rhs_each(own, (num)0.5, x, u, d, n);
      NAME_step_each(own, (num)0.5, x, u, h, n);
      NAME_advance_each(own, (num)0.5, x, u, h, 3, n);
      for (k = 0; k < n; k++) {
        num s[UPPER_NX], v[NU + 1], ds[UPPER_NX];
        NAME_model b;
        int code;

        for (i = 0; i < UPPER_NP; i++) p[i] = all[i*n + k];
        code = NAME_init(&b, p);
        want += code != 0;
        parameters += code != status[k];
        if (code != 0) NAME_init(&b, 0);
        for (i = 0; i < UPPER_NX; i++) s[i] = y[i*n + k];
        for (i = 0; i < NU; i++) v[i] = u[i*n + k];
        v[NU] = none[0];
        NAME_rhs(&b, (num)0.5, s, v, ds);
        parameters += differ(ds, d, n, k);
        NAME_step(&b, (num)0.5, s, v, h);
        for (j = 0; j < 3; j++) NAME_step(&b, (num)0.5 + (num)j*h, s, v, h);
        parameters += differ(s, x, n, k);
      }
      parameters += refused != want;
      free(all);
      free(own);
      free(status);
    }
]]

-- gcc up to 12 fuses alternating sums where it packs a scalar function's statements, in spite of -ffp-contract=off.
local COMPILERS = { "gcc -O2", "clang -O2", "gcc -O3 -march=native -fno-math-errno -fno-tree-slp-vectorize",
  "clang -O2 -march=native -fno-math-errno" }

local function shell(...)
  local status = program.shell(string.format("{ %s; } >%s/stdout 2>&1", string.format(...), dir))
  return status, program.read(dir .. "/stdout")
end

local function check(body, options, compilers)
  local at = dir .. "/" .. body
  local what = body .. " " .. options
  local status, text = shell("rm -rf %s; %s gen bodies/%s.lua --with batch %s -o %s", at, binary, body, options, at)
  if not tap.is(status, 0, what .. " is emitted", text) then return end
  local header = program.read(at .. "/" .. body .. "_batch.h")
  local upper = body:upper()
  local main = MAIN:gsub("EACH", (header:find("_step_each", 1, true) and EACH:gsub("%%", "%%%%") or ""))
  main = main:gsub("RUN", (header:find("_taylor_run_many", 1, true) and RUN:gsub("%%", "%%%%") or ""))
  local nu = program.read(at .. "/" .. body .. ".h"):find("_NU\n", 1, true) and upper .. "_NU" or "0"
  local quaternion = program.read(at .. "/" .. body .. ".h"):find("_QW", 1, true) and "1" or "0"
  main = main:gsub("%f[%w]NU%f[^%w_]", nu):gsub("NAME", body):gsub("UPPER", upper):gsub("STEP", "0.004")
    :gsub("KEEP", quaternion)
  program.write(at .. "/many.c", main)
  local sources = "many.c"
  for _, tail in ipairs { "", "_orbit", "_batch" } do
    if program.read(at .. "/" .. body .. tail .. ".c") then sources = sources .. " " .. body .. tail .. ".c" end
  end
  for _, compiler in ipairs(compilers) do
    status, text = shell("cd %s && %s %s %s -o many -lm && ./many", at, compiler, STRICT, sources)
    tap.is(text, "bad 0 rates 0 parameters 0 moved 1\n", what .. ", " .. compiler .. ": the bits of one body", status)
  end
end

-- Scenes: free, forced, with inputs, in a turning frame, with own states, with a table, with sines of a state.
local SCENES = { "tumbling_box", "brick", "wheels", "foucault", "energy_sink", "thruster", "gravity_gradient",
  "magnet_pendulum", "skater", "compass", "dual_spin", "heavy_top" }
for i, body in ipairs(tier.every(4, SCENES)) do
  check(body, "--method rk4", COMPILERS)
  check(body, i % 2 == 0 and "--method semi" or "--method semi --real float", COMPILERS)
end
for _, body in ipairs(tier.every(3, { "heavy_top", "gyrostat" })) do
  check(body, "--method split4", { COMPILERS[1] })
end
for _, body in ipairs(tier.every(3, { "tumbling_box", "damped_brick", "skater", "foucault", "paddle" })) do
  check(body, "--method taylor", { COMPILERS[1], COMPILERS[4] })
  check(body, "--method taylor --real float", { COMPILERS[3] })
end

-- ---- what is called for ----

-- A rate or a step that reads none of the parameters has no function for bodies that differ, and none is declared.
for _, case in ipairs { { "cube_corner", "semi" }, { "dumbbell", "semi" }, { "heavy_top", "split2,rk4" } } do
  local at, body = dir .. "/declared", case[1]
  shell("rm -rf %s; %s gen bodies/%s.lua --with batch --method %s -o %s", at, binary, body, case[2], at)
  local status, text = shell("cd %s && gcc -std=c99 -c -o all.o %s_batch.c && nm -g --defined-only all.o", at, body)
  local defined, declared = {}, {}
  for name in text:gmatch "%sT ([%w_]+)" do defined[#defined + 1] = name end
  local header = (program.read(at .. "/" .. body .. "_batch.h") or ""):gsub("/%*.-%*/", "")
  for name in header:gmatch "%f[^\n]%a+ ([%w_]+)%(" do declared[#declared + 1] = name end
  table.sort(defined)
  table.sort(declared)
  tap.ok(status == 0 and #declared > 2 and table.concat(defined, " ") == table.concat(declared, " "),
    body .. " by " .. case[2] .. ": each function that is declared is there",
    table.concat(declared, " ") .. "\n" .. table.concat(defined, " "))
end

local status, text = shell("%s gen bodies/brick.lua --with batch --only step_many -o %s/few", binary, dir)
tap.is(status, 0, "--only step_many", text)
local header = program.read(dir .. "/few/brick_batch.h") or ""
tap.ok(header:find("brick_step_many(", 1, true) and not header:find("_each(", 1, true) and
  not header:find("rhs_many(", 1, true), "has that one", header)
status, text = shell("%s gen bodies/brick.lua --only step_many -o %s/none", binary, dir)
tap.ok(status ~= 0 and text:find("--only: the scene has no function step_many", 1, true),
  "without --with batch there is none", text)

tap.done(program.finish())
