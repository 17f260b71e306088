#!/usr/bin/env lua5.4
-- laws.t - errors grow with the number of steps as theory says: the quick part of `make drift-laws`, one scene for
-- each law.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each exponent is fitted over an ensemble of 32 states (tests/bench/laws.c) and has a standard error by the
-- jackknife over its 8 groups; it must be within 3 of them of the law, and 0.1 more, for a window of a few decades
-- begins where the law before it ends (the phase's n^(3/2) after the attitude's own sqrt(n)).  Laws are half a unit
-- apart, so a standard error above 0.1 would decide nothing: that fails, too.  The ensemble is the same every time;
-- nothing here is timed. Predicted: rk4, truncation: energy and |L| n, phase n^2, the direction of L bounded, for the
-- method commutes with rotations of space; rounding in float: energy, |L|, direction sqrt(n), phase n^(3/2); split2
-- and a heavy top: energy bounded, Lz sqrt(n), phase n; the closed form: all bounded.  Derivations: docs/drift.md.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local build = require "tests.bench.laws_build"
local fit = require "tests.bench.laws_fit"
local runs = require "tests.bench.laws_runs"

local list, dir = runs.few(), program.directory()
build.all(os.getenv "POLHODE" or "build/polhode", "build/libpolhode.a", dir, list)
local by = {}
for _, r in ipairs(list) do
  local out = dir .. "/out"
  local code = program.shell(string.format("%s/laws %d %.17g %d %d > %s", r.folder, r.row, r.h, r.steps, r.members,
    out))
  local what = string.format("%s, %s, %s", string.gsub(r.method, "few: ", ""), r.scene, r.regime)
  if tap.is(code, 0, what .. ": runs") then
    local points = build.read(out)
    fit.run(r, points)
    by[r.method .. r.real] = points
    for _, name in ipairs(fit.quantities) do
      local f = r.fits[name]
      if f then
        local got = string.format("%.3f with a standard error of %.3f", f.p, f.error)
        -- laws are half a power apart: four standard errors at the least
        tap.ok(fit.agrees(f) and f.error <= 0.125, string.format("%s: %s like n^%g", what, name, f.law), got)
      else
        tap.ok(not r.laws[name], what .. ": " .. name .. " has enough points for a fit")
      end
    end
  end
end

-- A plain step loses half an ulp whatever h is, a compensated one h |w| times some ten roundings: a hundredth here,
-- and the test asks for a tenth.
local plain, low = by["few: rk4float"], by["few: rk4, compensatedfloat"]
if plain and low then
  local n = 100000
  local function energy(points)
    for _, p in ipairs(points) do
      if p.n == n then return fit.rms(p.square[1]) end
    end
    return 0 / 0
  end
  tap.ok(energy(low) * 10 <= energy(plain), "compensated sums keep the energy ten times as well, 10^5 steps in float",
    string.format("%.2g and %.2g", energy(low), energy(plain)))
end

program.finish()
tap.done()
