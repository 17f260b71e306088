#!/usr/bin/env lua5.4
-- linearised.t - the error law of the linearised top: against K of the reference table, its own series, hard cases.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- From the worst direction a stable spin is dn(u; m) with m = 2 C e^2 (Landau and Lifshitz, Mechanics, section 37), so
-- the exact period is 2K(m)/pi of the linearised one; K is tests/reference/elliptic.h's, 32 digits, by mpmath.  What
-- the whole law says of a motion is compared with the exact solver in tests/report/linearised.t.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local law = require "generator.mass.linearised"

local EPSILON = 2.0 ^ -52

local bodies = { { 1.0, 4.0, 4.5 }, { 2.0, 2.1, 2.2 }, { 1.0, 20.0, 20.5 }, { 3.0, 4.0, 7.0 },
  { 1e-30, 3e-30, 3.5e-30 }, { 1e30, 1.5e30, 2e30 } }

---- K ----------------------------------------------------------------------------------------------------------

local rows = 0
for line in io.lines "tests/reference/elliptic.h" do
  local complement, value, K =
    line:match "^  {ELLIPTIC_COMPLETE, (%d), ([^,]+), 0, 0, HUGE_VAL, 0, 0, 0, 0, ([%d.e+-]+)L,"
  local m = value and (complement == "1" and 1 - tonumber(value) or tonumber(value))
  -- in between, so that m comes back from e with some ulp
  if m and m > 0 and m < 0.9999 and complement == "0" then
    rows = rows + 1
    for n, I in ipairs(bodies) do
      for _, k in ipairs { 1, 3 } do
        local A = law.axis(I, k)
        local motion = law.worst(A, math.sqrt(m / (2 * A.C)))
        local what = string.format("m = %.4g, body %d, axis %d: ", m, n, k)
        -- m comes back through C and e: 8 ulp, times d ln K/d ln m < m/(1 - m); the means: 8 ulp of the period
        local slack = 8 * EPSILON * (1 + m / (1 - m))
        tap.near(1 / (1 + motion.shift), 2 * tonumber(K) / math.pi, slack, 0.0, what .. "the period is 4K/lambda",
          "8 ulp of m, 8 operations")
        tap.near(motion.axial, m / (1 + math.sqrt(1 - m)), 2 * slack, 0.0, what .. "the axial rate is sqrt(1 - m)",
          "8 ulp of m")
      end
    end
  end
end
tap.ok(rows >= 5, "the table has rows of K", rows .. " rows")

-- pi/(2K) = 1 - m/4 - 5 m^2/64 - 11 m^3/256 - ..: from K = pi/2 (1 + m/4 + 9 m^2/64 + 25 m^3/256 + ..), DLMF 19.5.1.
-- All coefficients are negative and at m = 1 the sum is 0, so what follows the second is at most m^3.
for _, m in ipairs { 1e-2, 1e-4, 1e-8, 1e-16, 1e-200 } do
  local A = law.axis({ 1.0, 4.0, 4.5 }, 1)
  local motion = law.worst(A, math.sqrt(m / (2 * A.C)))
  tap.near(motion.shift, -m / 4 - 5 * m * m / 64, 16 * EPSILON, m ^ 3, "the frequency falls by C e^2/2, m = " .. m,
    "16 ulp, the third term of the series")
  -- 1 - sqrt(1 - m) = m/2 + m^2/8 + ..., the rest at most m^3/2
  tap.near(motion.axial, m / 2 + m * m / 8, 16 * EPSILON, m ^ 3, "the axial rate falls by C e^2, m = " .. m,
    "16 ulp, the third term of the series")
  tap.near(motion.third, m / 16, 16 * EPSILON, 0.0, "the third harmonic is C e^2/8, m = " .. m, "a dozen operations")
end

---- any direction: what a motion says is the same from all its points -------------------------------------------

for n, I in ipairs(bodies) do
  for _, k in ipairs { 1, 3 } do
    local A = law.axis(I, k)
    local a, b = math.sqrt(math.abs(A.a)), math.sqrt(math.abs(A.b))
    local r, most, least = 0.3 / math.max(a, b) * math.min(1, A.limit), 0.0, math.huge
    for step = 0, 40 do
      local phase = step * math.pi / 20
      local X, Y = r * math.cos(phase), r * math.sin(phase)
      -- z^2 - c/b y^2 is constant
      local z = math.sqrt(1 + (A.a > 0 and A.c or -A.c) * Y * Y)
      local motion = law.motion(A, X * a / z, Y * b / z)
      if not tap.ok(motion, "body " .. n .. ", axis " .. k .. ": circulates") then break end
      local frequency = (1 + motion.shift) * z
      most, least = math.max(most, frequency), math.min(least, frequency)
    end
    -- a dozen operations on each of two dozen numbers near 1; divided by the differences of the moments of 4 %
    tap.ok(most - least <= 40 * EPSILON, "body " .. n .. ", axis " .. k .. ": one frequency from every phase",
      string.format("%.3g", most - least))
    -- and the worst direction is the worst
    local e = 0.2 * A.limit
    local worst = law.worst(A, e)
    for step = 0, 20 do
      local motion = law.motion(A, e * math.cos(step * math.pi / 20), e * math.sin(step * math.pi / 20))
      for _, periods in ipairs { 1, 100 } do
        if law.error(motion, periods) > law.error(worst, periods) * (1 + 1e-12) then
          tap.ok(false, "body " .. n .. ", axis " .. k .. ": the worst direction is the worst")
        end
      end
    end
  end
end

---- amplitudes that are good --------------------------------------------------------------------------------------

for n, I in ipairs(bodies) do
  for _, k in ipairs { 1, 3 } do
    local A = law.axis(I, k)
    for _, eps in ipairs { 1e-2, 1e-3, 1e-6, 1e-300 } do
      for _, periods in ipairs { 1, 100 } do
        local e = law.amplitude(A, eps, periods)
        -- bisection of log e in 750 ends at 750 2^-53; the error has a slope of at most 3 and a bit in it
        tap.near(law.error(law.worst(A, e), periods), eps, 1e-12, 0.0, string.format(
          "body %d, axis %d: an error of %g after %d is reached at e = %.3g", n, k, eps, periods, e), "the bisection")
      end
    end
  end
end

---- hard cases: no NaN, and what is exact is exact ------------------------------------------------------------------

local hard = { { 0.0, 1.0, 1.0 }, { 1.0, 1.0, 2.0 }, { 1.0, 2.0, 2.0 }, { 1.0, 1.0, 1.0 }, { 1.0, 1.0 + EPSILON, 2.0 },
  { 1.0, 1.0 + EPSILON, 1.0 + 2 * EPSILON }, { 1.0, 2.0 - EPSILON, 2.0 }, { 1e-12, 1.0, 1.0 },
  { 1e-12, 1.0, 1.0 + EPSILON }, { 1e-30, 2e-30, 2.5e-30 }, { 1e30, 2e30, 2.5e30 }, { 1e-300, 1.5e-300, 2e-300 },
  { 1e300, 1.5e300, 2e300 }, { 1e-30, 1.0, 1.0 } }
local function number(x) return x == x end
for n, I in ipairs(hard) do
  local fine = true
  for k = 1, 3 do
    local A = law.axis(I, k)
    local x, y = law.direction(A)
    fine = fine and math.abs(x * x + y * y - 1) <= 4 * EPSILON
    for _, e in ipairs { 0.0, 1e-300, 1e-30, 1e-8, 1e-3, 0.1, 1.0 } do
      if A.kind == "stable" then
        local motion = law.worst(A, e)
        fine = fine and (e > 0 or motion) and (not motion or number(motion.axial + motion.shift + motion.swing
          + motion.third) and number(law.error(motion, 1)) and law.error(motion, 100) >= law.error(motion, 1)
          and law.error(motion, 1) >= 0)
        fine = fine and (e > 0 or law.error(motion, 100) == 0)
      elseif A.kind ~= "exact" then
        local time = law.failure(A, e * x, e * y, 0.1)
        fine = fine and number(time) and time >= 0 and (e > 0 or time == math.huge)
      end
      local rx, ry = law.rates(A, e * x, e * y, 0.7)
      fine = fine and number(rx + ry)
    end
    if A.kind == "stable" then
      for _, eps in ipairs { 1e-2, 1e-6 } do fine = fine and number(law.amplitude(A, eps, 100)) end
    end
  end
  tap.ok(fine, "hard body " .. n .. ": every number is one", table.concat(I, " "))
end
for _, size in ipairs { 1e-30, 1.0, 1e30, 1e300 } do
  local s = law.spin({ 1.0, 2.0, 3.0 }, { 0.0, 0.3 * size, -size })
  tap.ok(s.k == 3 and s.x == 0 and math.abs(s.y + 0.3) <= EPSILON and math.abs(s.rate / size - 1) <= EPSILON,
    "a spin of size " .. size .. " about -3, seen from there")
  s = law.spin({ 2.0, 2.0, 3.0 }, { 0.3 * size, 0.4 * size, 0.25 * size })
  tap.ok(s.k == 1 and s.x == 0 and math.abs(s.y - 0.5) <= 2 * EPSILON and math.abs(s.rate / size - 0.5) <= EPSILON,
    "two equal moments: the axis in their plane is the spin's own, size " .. size)
  s = law.spin({ 1.0, 1.0, 1.0 }, { size, size, size })
  tap.ok(s.e == 0 and math.abs(s.rate / size - math.sqrt(3)) <= 4 * EPSILON, "a sphere: no transverse rate")
end
local rest = law.spin({ 1.0, 2.0, 3.0 }, { 0.0, 0.0, 0.0 })
tap.ok(rest.e == 0 and rest.rate == 0, "rest")
tap.is(law.axis({ 0.0, 1.0, 1.0 }, 1).kind, "exact", "a rod about its line")
tap.is(law.axis({ 0.0, 1.0, 1.0 }, 2).kind, "neutral", "a rod across it")
tap.is(law.motion(law.axis({ 1.0, 4.0, 4.5 }, 3), 1.0, 0.0), nil, "beyond the separatrix there is no law")
-- an unstable spin on the arm of the separatrix that ends in it: X = Y where a > 0
do
  local A = law.axis({ 1.0, 2.0, 2.5 }, 2)
  local a, b = math.sqrt(math.abs(A.a)), math.sqrt(math.abs(A.b))
  local sign = A.a > 0 and 1 or -1
  local time = law.failure(A, 2.0 ^ -5 * a, sign * 2.0 ^ -5 * b, 0.1)
  tap.ok(time == math.huge or time > 15 / A.growth, "what ends in the spin does not fail, but for a rounding")
end

tap.done()
