#!/usr/bin/env lua5.4
-- stability.t - small oscillations about the principal axes: Omega1, Omega2, period, verdict; emitted functions.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- About a spin s along axis k (i, j, k cyclic) Euler's equations are, to first order,
--     w_i' = -Omega1 w_j,  w_j' = Omega2 w_i,  Omega1 = (I_k - I_j)/I_i s,  Omega2 = (I_k - I_i)/I_j s
-- which is proved here by differentiating the generator's own equations.  The emitted functions are compiled once and
-- their numbers compared with formulas written out here in double.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local compiled = require "tests.ir.compiled"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local calculus = require "generator.algebra.calculus"
local facts = require "generator.report.facts"

local EPSILON = 2.0 ^ -52

-- ---- the linearised equations, symbolic ----

local job = scene.plan(scene.file "bodies/brick_centroid.lua")
local I = job.model.inertia
local w = { expr.sym("wx", 8), expr.sym("wy", 8), expr.sym("wz", 8) }
do
  local rates = scene.rates(job)
  local dw = { rates.wx, rates.wy, rates.wz }
  local f = facts.of(job)
  for k = 1, 3 do
    local i, j = k % 3 + 1, (k + 1) % 3 + 1
    local spin = { [w[i]] = expr.zero, [w[j]] = expr.zero }
    local function slope(a, b) return calculus.substitute(calculus.diff(dw[a], w[b]), spin) end
    local omega1, omega2 = (I[k] - I[j]) / I[i] * w[k], (I[k] - I[i]) / I[j] * w[k]
    tap.ok(ratio.iszero(slope(i, j) + omega1) and ratio.iszero(slope(j, i) - omega2) and ratio.iszero(slope(i, i))
      and ratio.iszero(slope(j, j)) and ratio.iszero(slope(k, i)) and ratio.iszero(slope(k, j)),
      "axis " .. k .. ": the slopes of Euler's equations at a pure spin are -Omega1 and Omega2, and nothing else")
    tap.ok(ratio.iszero(f.conditions[k] * w[k] ^ 2 - omega1 * omega2),
      "axis " .. k .. ": the reported Omega^2/w^2 is Omega1 Omega2")
  end
end

-- ---- verdicts and periods of the report ----

local function verdicts(path)
  local list, f = {}, facts.of(scene.file("bodies/" .. path .. ".lua"))
  for k = 1, 3 do list[k] = f.stability[k].verdict end
  return table.concat(list, " "), f
end

do
  local list, f = verdicts "brick_centroid"
  tap.is(list, "stable unstable stable",
    "brick: stable about the smallest and the largest moment, unstable about the middle")
  local m = f.moments
  for _, k in ipairs { 1, 3 } do
    local i, j = k % 3 + 1, (k + 1) % 3 + 1
    local omega = math.sqrt((m[k] - m[i]) * (m[k] - m[j]) / (m[i] * m[j]))
    -- four differences and products, one root
    tap.near(f.stability[k].period, 2 * math.pi / omega, 8 * EPSILON, 0.0, "brick: period about axis " .. k ..
      " is 2 pi sqrt(I_i I_j/((I_k - I_i)(I_k - I_j))) over the spin", "8 roundings")
  end
  tap.near(f.stability[2].growth, math.sqrt((m[2] - m[1]) * (m[3] - m[2]) / (m[1] * m[3])), 8 * EPSILON, 0.0,
    "brick: growth rate about the middle axis", "8 roundings")
  list = verdicts "tennis_racket"
  tap.is(list, "stable unstable stable", "tennis racket: unstable about its middle axis only")
  list = verdicts "symmetric_top"
  tap.is(list, "stable neutral neutral", "prolate top: stable about its axis, neutral about the two equal moments")
  list = verdicts "coin"
  tap.is(list, "neutral neutral stable", "coin: stable about its axis, neutral about the two equal moments")
  list = verdicts "dumbbell"
  tap.is(list, "stable neutral neutral", "dumbbell of particles: neutral across its line")
  list = verdicts "cube_corner"
  tap.is(list, "stable neutral neutral", "cube about its corner: rounding does not split the two equal moments")
end

-- ---- the emitted functions ----

-- C text of a scene's header and source as one unit.
local function unit(planned)
  local files, name = scene.files(planned), planned.model.name
  return (files[name .. ".c"]:gsub('#include "[^\n]*\n', function() return files[name .. ".h"] end))
end

local function run(planned, body)
  return compiled.numbers("#include <stdio.h>\n" .. unit(planned) .. [[
static void print(int n, const double *v) { int i; for (i = 0; i < n; i++) printf("%.17e\n", v[i]); }
int main(void)
{
]] .. body .. "  return 0;\n}\n")
end

do
  local got = run(job, [[
  const double m[3] = {1.0, 2.0, 2.5};
  const double w0[3] = {0.01, -0.02, 3.0}, w1[3] = {0.01, 3.0, -0.02}, w2[3] = {-3.0, 0.01, 0.02};
  const double rod[3] = {0.0, 2.0, 2.0}, pure[3] = {0.0, 0.0, 3.0};
  double Omega[2], rate, w[3];
  rate = brick_centroid_stability(m, 2, 3.0, Omega, w); print(1, &rate); print(2, Omega); print(1, w);
  rate = brick_centroid_stability(m, 1, 3.0, Omega, w); print(1, &rate); print(2, Omega); print(1, w);
  rate = brick_centroid_stability(m, 0, -3.0, Omega, w); print(1, &rate); print(2, Omega); print(1, w);
  rate = brick_centroid_stability(m, 2, 0.0, Omega, w); print(1, &rate);
  rate = brick_centroid_stability(rod, 2, 1.0, Omega, w); print(1, &rate);
  brick_centroid_linearised(m, 2, w0, 0.7, w); print(3, w);
  brick_centroid_linearised(m, 1, w1, 0.7, w); print(3, w);
  brick_centroid_linearised(m, 0, w2, -0.4, w); print(3, w);
  brick_centroid_linearised(m, 2, pure, 1e9, w); print(3, w);
]])
  local at = 0
  local function take(n)
    at = at + n
    return table.unpack(got, at - n + 1, at)
  end
  local m = { 1.0, 2.0, 2.5 }
  for _, case in ipairs { { 3, 3.0, 1, "stable" }, { 2, 3.0, -1, "unstable" }, { 1, -3.0, 1, "stable" } } do
    local k, s = case[1], case[2]
    local i, j = k % 3 + 1, (k + 1) % 3 + 1
    local verdict, o1, o2, rate = take(4)
    local name = "emitted stability, axis " .. k .. ": "
    tap.is(verdict, case[3] + 0.0, name .. case[4])
    tap.near(o1, (m[k] - m[j]) / m[i] * s, 3 * EPSILON, 0.0, name .. "Omega1", "3 operations")
    tap.near(o2, (m[k] - m[i]) / m[j] * s, 3 * EPSILON, 0.0, name .. "Omega2", "3 operations")
    tap.near(rate, math.sqrt(math.abs((m[k] - m[j]) / m[i] * s * ((m[k] - m[i]) / m[j] * s))), 8 * EPSILON, 0.0,
      name .. "rate = sqrt |Omega1 Omega2|", "8 operations")
  end
  tap.is(take(1), 0.0, "emitted stability: no spin is neutral")
  tap.is(take(1), 0.0, "emitted stability: a rod about an axis across it is neutral, although a moment is 0")
  -- the linear system by its own Taylor series, which knows nothing of cos, sin or which case it is
  local function series(k, start, t)
    local i, j = k % 3 + 1, (k + 1) % 3 + 1
    local s = start[k]
    local o1, o2 = (m[k] - m[j]) / m[i] * s, (m[k] - m[i]) / m[j] * s
    local a, b, x, y = start[i], start[j], start[i], start[j]
    for n = 1, 40 do
      a, b = -o1 * b * t / n, o2 * a * t / n
      x, y = x + a, y + b
    end
    local out = { s, s, s }
    out[i], out[j] = x, y
    return out
  end
  for _, case in ipairs { { 3, { 0.01, -0.02, 3.0 }, 0.7 }, { 2, { 0.01, 3.0, -0.02 }, 0.7 },
    { 1, { -3.0, 0.01, 0.02 }, -0.4 } } do
    local want, out = series(case[1], case[2], case[3]), { take(3) }
    for i = 1, 3 do
      -- the series' terms reach exp(|rate t|) <= 5 times the start: 40 roundings of 0.1
      tap.near(out[i], want[i], 8 * EPSILON, 40 * 0.1 * EPSILON, "emitted linearised, axis " .. case[1] .. ": w" .. i,
        "40 terms of at most 0.1")
    end
  end
  local x, y, z = take(3)
  tap.ok(x == 0 and y == 0 and z == 3, "emitted linearised: a pure spin stays what it is for 1e9 s")
end

do -- exact for a symmetric top about its axis: against the emitted closed form's rates
  local top = scene.plan(scene.file "bodies/symmetric_top.lua")
  local got = run(top, [[
  symmetric_top_model model;
  symmetric_top_orbit o;
  const double x0[7] = {1.0, 0.0, 0.0, 0.0, 4.0, -5.0, 20.0};
  double inertia[6], x[7], w[3];
  symmetric_top_init(&model, 0);
  symmetric_top_inertia(&model, inertia);
  symmetric_top_solve(&o, &model, x0);
  symmetric_top_at(&o, 0.5, x);
  symmetric_top_linearised(inertia, 2, x0 + 4, 0.5, w);
  print(3, x + 4);
  print(3, w);
]])
  for i = 1, 3 do
    -- an angle of 9 rad: its rounding moves a rate of 6.4 by 9 6.4 eps
    tap.near(got[3 + i], got[i], 0.0, 2 * 9 * 6.5 * EPSILON,
      "symmetric top: the small-oscillation form is exact, w" .. i, "two roundings of the angle, 9 rad, times the rate")
  end
end

do -- the error is of second order in the disturbance: w3 changes by w1 w2, and that feeds back
  local got = run(scene.plan(scene.file "bodies/brick_centroid.lua"), [[
  const double m[3] = {0.0025, 0.0085, 0.01};
  brick_centroid_model model;
  double e;
  brick_centroid_init(&model, 0);
  for (e = 0.1; e > 0.02; e /= 2) {
    double x[7] = {1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 5.0}, w[3];
    int n;
    x[4] = e;
    x[5] = -2*e;
    brick_centroid_linearised(m, 2, x + 4, 0.5, w);
    for (n = 0; n < 2000; n++) brick_centroid_step(&model, 0.0, x, 0, 0.00025);
    w[0] -= x[4];
    w[1] -= x[5];
    w[2] -= x[6];
    print(3, w);
  }
]])
  local function largest(n) return math.max(math.abs(got[n]), math.abs(got[n + 1]), math.abs(got[n + 2])) end
  local first, second, third = largest(1), largest(4), largest(7)
  tap.ok(first / second > 3.8 and first / second < 4.2 and second / third > 3.8 and second / third < 4.2,
    "brick: half the disturbance has a quarter of the error", string.format("%.3g %.3g %.3g", first, second, third))
end

tap.done()
