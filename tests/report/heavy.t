#!/usr/bin/env lua5.4
-- heavy.t - nutation and precession of heavy tops: what explain says and the emitted code returns, by quadratures.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Hard motions of one top (tests/reference/heavy.lua, 22 digits by another formulation): 1e-1 to 1e-9 rad from the
-- vertical, through it above and below, spins of 1e2 to 1e6 rad/s, both sides of the separatrix, nearly steady.  The
-- emitted code is compared with dynamics/heavy_top.lua, which explain asks, at the doubles that it sees.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local program = require "tests.cli.program"
local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"
local heavy_top = require "generator.dynamics.heavy_top"
local facts = require "generator.report.facts"
local values = require "generator.report.values"

local rows = dofile "tests/reference/heavy.lua"

local function read(row)
  return assert(scene.read(string.format([[return scene { name = "top", origin = {0, 0, 0},
    body = tensor { mass = 1, com = {0, 0, 0.05}, about = "origin", xx = 0.0045, yy = 0.0045, zz = 0.0007 },
    effects = { effect.gravity { g = 9.81 } }, initial = { attitude = %s, omega = %s } }]], row[1], row[2])))
end

local function name_of(row) return row[1] .. ", w = " .. row[2] end

-- ---- explain ----

-- Exact numbers to 128 bits, rounded once, and here once more from radians to degrees.
local ONCE = 2 * 2.0 ^ -52

local jobs = {}
for i, row in ipairs(rows) do
  local v = {}
  jobs[i] = read(row)
  for _, r in ipairs(values.of(facts.of(jobs[i]))) do v[r.key] = r.number end
  for k, key in ipairs { "tilt_least", "tilt_greatest", "nutation_period", "precession_rate" } do
    local want = k <= 2 and math.deg(row[2 + k]) or row[2 + k]
    tap.near(v[key], want, ONCE, 1e-300, name_of(row) .. ": explain's " .. key, "rounded once from many digits")
  end
end

-- Where the axis rests there is no nutation; on the separatrix no period.
local function rests(attitude, omega, least, greatest)
  local v = {}
  local list = values.of(facts.of(read { attitude, omega }))
  for _, r in ipairs(list) do v[r.key] = r.number end
  local where = attitude .. ", w = " .. omega
  tap.ok(v.tilt_least == least and v.tilt_greatest == greatest, where .. ": the tilt", tostring(v.tilt_least))
  tap.ok(v.nutation_period == nil and v.precession_rate == nil, where .. ": no period")
end
rests("{1, 0, 0, 0}", "{0, 0, 300}", 0, 0)
rests("{1, 0, 0, 0}", "{0, 0, 10}", 0, 0)
rests("{0, 1, 0, 0}", "{0, 0, 10}", 180, 180)
rests("{0, 1, 1, 0}", "{0, 0, 0}", 180, 180)

-- ---- the emitted code ----

local MAIN = [[
#include "top.h"
#include <stdio.h>
int main(void)
{
  top_model m;
  top_orbit o;
  double x[7], tilt[2];
  top_init(&m, NULL);
  while (scanf("%la %la %la %la %la %la %la", x, x + 1, x + 2, x + 3, x + 4, x + 5, x + 6) == 7) {
    if (top_solve(&o, &m, x) != 0) return 1;
    top_nutation_range(&o, tilt);
    printf("%a %a %a %a\n", tilt[0], tilt[1], top_nutation_period(&o), top_precession_rate(&o));
  }
  return 0;
}
]]

local dir = program.directory()
do
  local plan = scene.plan(jobs[1])
  local files, units, input = scene.files(plan), {}, {}
  for _, name in ipairs(files) do
    program.write(dir .. "/" .. name, files[name])
    if name:find "^top.*%.c$" and not name:find "_test%.c$" then units[#units + 1] = dir .. "/" .. name end
  end
  program.write(dir .. "/main.c", MAIN)
  for i, job in ipairs(jobs) do
    local x = {}
    for k, s in ipairs(job.states) do x[k] = string.format("%a", job.model:double(s.initial)) end
    input[i] = table.concat(x, " ")
  end
  program.write(dir .. "/in", table.concat(input, "\n") .. "\n")
  local status = program.shell(string.format("%s sh -c '$CC -o %s/run %s/main.c %s -lm' && %s/run <%s/in >%s/out",
    program.quick_compiler(), dir, dir, table.concat(units, " "), dir, dir, dir))
  tap.is(status, 0, "the emitted functions run")
end

-- The emitted code sees the doubles of the constants and of the state, which is another motion beside the separatrix:
-- what it is compared with has these doubles.  The set-up keeps some 100 bits, and rounds a few results of sums of
-- pairs; 18 units of 2^-52, as of the attitude.
local EMITTED = 18 * 2.0 ^ -52
-- Where nothing goes round on average what is left of turns that cancel in pairs: 2^-100 of them.
local NOTHING = 2.0 ^ -90

local function exactly(job)
  local m, w, q = job.model, {}, {}
  local function double(e) return R.fromdouble(m:double(e)) end
  for k = 1, 3 do w[k] = double(m.omega[k]) end
  for k = 1, 4 do q[k] = double(m.attitude[k]) end
  local up = vec.matvec(vec.transpose(vec.rotation(q)), { R.zero, R.zero, R.one })
  return heavy_top.of { I1 = double(m.structure.alpha), I3 = double(m.structure.axial), weight = R.fromdouble(0.4905),
    arm = { R.zero, R.zero, R.one }, up = up, w = w } -- 9.81*0.05, the nearest double
end

local i = 0
for line in (program.read(dir .. "/out") or ""):gmatch "[^\n]+" do
  i = i + 1
  local got, top = {}, exactly(jobs[i])
  for word in line:gmatch "%S+" do got[#got + 1] = tonumber(word) end
  for n, want in ipairs { top.tilt[1], top.tilt[2], top.period, top.precession } do
    tap.near(got[n], R.todouble(want), EMITTED, NOTHING, name_of(rows[i]) .. ": the emitted " ..
      ({ "least tilt", "greatest tilt", "period", "precession" })[n], "see EMITTED")
  end
end
tap.is(i, #rows, "all motions were solved")

tap.done(program.finish())
