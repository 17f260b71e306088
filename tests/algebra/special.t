#!/usr/bin/env lua5.4
-- special.t - the functions of the uniform ellipsoid shell: values, limits, laws, text, derivative.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracles: mpmath 1.3 at 60 digits, its elliprg and elliprd (DLMF 19.33.1; 19.21.8 for the normal), agreeing to 25
-- digits with mpmath's two-dimensional quadrature of sqrt(Q), p n^2/sqrt(Q) and n^2 sqrt(Q) over the sphere; the
-- elementary
-- formulas of spheroids; numeric derivatives at 400 bits.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local text = require "generator.formula.text"

local function q(s) return R.lift(s) end

-- |x/y - 1| < 2^-bits?
local function agree(x, y, bits)
  local d = R.abs(x - y)
  return R.sign(d) == 0 or R.log2(d) - R.log2(y) < -bits
end

-- ---- values ----

local published = { -- a, b, c, area/(4 pi), mean of N_a^2
  { "1", "2", "3", "3.88991760649857485563715999801939958334118055",
    "0.660917653119880252516915138870960262258951014" },
  { "3", "1", "2", "3.88991760649857485563715999801939958334118055",
    "0.113571557093658921653388806641455107400872942" },
  { "2", "3", "1", "3.88991760649857485563715999801939958334118055",
    "0.225510789786460825829696054487584630340176044" },
  { "1", "1.5", "0.25", "0.826707768010936356227829901088172405483903465",
    "0.0987674386067718572981865097672582673726961045" },
  { "7", "7.5", "0.125", "26.2872122054239350057815160247290563509341887",
    "0.00134897706969771517246183734597353933457873903" },
  { "1", "1.000000001", "0.999999999", "0.999999999999999999866666666666666666752380952",
    "0.333333333333333332901587301587301587285579606" },
  { "1e15", "1", "1e-15", "500000000000000.000000000000008856267689007644",
    "3.59250707560305738791043360625557234311326363e-59" },
  { "1", "1e-15", "1e15", "500000000000000.000000000000008856267689007644",
    "3.49250707560305758791043360625886485018886668e-29" },
  { "1e-15", "1e15", "1", "500000000000000.000000000000008856267689007644",
    "0.999999999999999999999999999965074929243969424" },
}
for _, row in ipairs(published) do
  local a, b, c = q(row[1]), q(row[2]), q(row[3])
  local name = string.format("(%s, %s, %s)", row[1], row[2], row[3])
  -- 45 digits were printed: 10^-44.5 is 2^-147.8
  tap.ok(agree(R.apply("ellipsoid_area", 240, a, b, c), q(row[4]), 147), "area of " .. name .. " to 45 digits")
  tap.ok(agree(R.apply("ellipsoid_normal", 240, a, b, c), q(row[5]), 147), "normal of " .. name .. " to 45 digits")
end

-- ---- spheroids: a along the axis, b = c = 1, by elementary integrals over u = cos of the polar angle ----
-- With k = (a^2 - b^2)/a^2 = 1 - 1/a^2,  G = integral_0^1 sqrt(1 - k u^2) du,  H_a = integral u^2/a^2/sqrt(1 - k u^2),
-- and  integral u^2/sqrt(1 - k u^2) = (F - G)/k  with F = integral 1/sqrt(1 - k u^2).

local bits = 400
local function apply(fn, ...) return R.apply(fn, bits, ...) end
for _, s in ipairs { "1e-15", "0.01", "0.999999999", "1.000000001", "3", "1e15" } do
  local a, one = q(s), R.one
  local k = one - one / a ^ 2
  local root = apply("sqrt", R.abs(k))
  local F = R.sign(k) > 0 and apply("asin", root) / root
    or apply("log", root + apply("sqrt", one + root ^ 2)) / root
  local G = (F + one / a) / R.new(2)
  local H = (F - G) / k / a ^ 2
  -- the oracle cancels twice where k is small: 400 - 2*60 bits are left
  tap.ok(agree(apply("ellipsoid_area", a, one, one), a * G, 270), "the spheroid of ratio " .. s .. ": area")
  tap.ok(agree(apply("ellipsoid_normal", a, one, one), H / G, 270), "the spheroid of ratio " .. s .. ": normal")
end

do
  local a, b, c = q "0.3", q "5", q "11"
  for _, n in ipairs { 53, 240, 800 } do
    local sum = R.apply("ellipsoid_normal", n, a, b, c) + R.apply("ellipsoid_normal", n, b, c, a)
      + R.apply("ellipsoid_normal", n, c, a, b)
    tap.ok(agree(sum, R.one, n - 2), "the three normals add up to 1 at " .. n .. " bits")
    tap.ok(agree(R.apply("ellipsoid_area", n, a, b, c), R.apply("ellipsoid_area", 900, a, b, c), n - 1),
      "area is good to the last of " .. n .. " bits")
  end
  tap.ok(R.apply("ellipsoid_area", 60, a, b, R.zero) == nil, "a semi-axis of zero is outside the domain")
  tap.ok(R.apply("ellipsoid_normal", 60, -a, b, c) == nil, "so is a negative one")
end

-- ---- expressions ----

local a, b, c = expr.sym("a", 3, true), expr.sym("b", 3, true), expr.sym("c", 3, true)
local area, normal = expr.call("ellipsoid_area", a, b, c), expr.call("ellipsoid_normal", a, b, c)
tap.ok(expr.call("ellipsoid_area", c, a, b) == area, "area is one node whatever the order of the axes")
tap.ok(expr.call("ellipsoid_normal", a, c, b) == normal, "normal is symmetric in the last two")
tap.ok(expr.call("ellipsoid_normal", b, a, c) ~= normal, "and not in the first")
tap.ok(expr.call("ellipsoid_area", a, a, a) == a ^ 2, "the area of a sphere is exact")
tap.ok(expr.call("ellipsoid_second", a, a, a) == a ^ 4 / 3, "so is its second moment")
tap.ok(expr.nonnegative(area) and expr.nonnegative(normal), "both are known to be positive")
tap.is(text.of(area), "ellipsoid_area(a, b, c)", "plain text")
tap.is(text.of(normal, "latex"), "\\operatorname{ellipsoid\\_normal}\\left( a, b, c \\right)", "LaTeX")

-- second moment: mpmath's quadrature of a^3 b c n_a^2 sqrt(Q) over the sphere, 25 digits
local env = { a = q "3", b = q "1", c = q "2" }
local second = expr.call("ellipsoid_second", a, b, c)
tap.ok(agree(evaluate.precise(second, env, 200), q "9.746328613577977819390748", 81), "second moment of (3, 1, 2)")
tap.ok(agree(evaluate.precise(second, { a = q "1", b = q "2", c = q "3" }, 200), q "1.615208205453828700501682", 81),
  "second moment of (1, 2, 3)")
-- MPFR's value rounded once
tap.near(evaluate.double(area, { a = 1, b = 2, c = 3 }), 3.8899176064985748556, 0x1p-52, 0, "in doubles",
  "one rounding")

for _, x in ipairs { a, b, c } do -- central difference of step 2^-100: its error is 2^-200 and 2^-300 from 400 bits
  local function at(d)
    local e = { a = env.a, b = env.b, c = env.c }
    e[x.name] = e[x.name] + d
    return evaluate.precise(area, e, 400)
  end
  local d = R.new(2) ^ -100
  local want = (at(d) - at(-d)) / (R.new(2) * d)
  tap.ok(agree(evaluate.precise(calculus.diff(area, x), env, 400), want, 190), "d area/d" .. x.name)
end
tap.throws(function() calculus.diff(normal, a) end, "no derivative rule for ellipsoid_normal",
  "the normal has no derivative here")
tap.ok(calculus.diff(normal, expr.sym "t") == expr.zero, "but it is constant where its arguments are")

tap.done()
