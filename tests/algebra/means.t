#!/usr/bin/env lua5.4
-- means.t - the means over arcs and catenaries: values, closed forms, limits, exact values, text, derivative.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracles: mpmath 1.3, adaptive quadrature of the defining integrals at 70 digits; the closed forms in the library's
-- elementary functions with bits to spare; the first terms of the series; numeric derivatives at 400 bits.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local ratio = require "generator.algebra.ratio"
local text = require "generator.formula.text"

local function q(s) return R.lift(s) end

-- |x/y - 1| < 2^-bits?
local function agree(x, y, bits)
  local d = R.abs(x - y)
  return R.sign(d) == 0 or R.log2(d) - R.log2(y) < -bits
end

local names = { "arc_across", "arc_along", "arc_lever", "catenary_rise", "catenary_width", "catenary_height" }

-- ---- values ----

local published = { -- 45 digits of the quadrature
  { "arc_across", "0.001", "0.000000333333266666673015872663139342632675637120088" },
  { "arc_along", "0.001", "0.0000000000000222222190476192592592507081398319493510604622" },
  { "arc_lever", "0.001", "0.000000333333300000001190476168430335347522845595762" },
  { "catenary_rise", "0.001", "0.000166666669444442261905186838560163482016590667" },
  { "catenary_width", "0.001", "0.33333337777777354497396825392549837427162251" },
  { "catenary_height", "0.001", "0.000000022222220105819823633323713279742410391749194" },
  { "arc_across", "1", "0.272675643293579576150995033522063789324436257" },
  { "arc_along", "1", "0.0192509384328492303502208517275551157925633573" },
  { "arc_lever", "1", "0.30116867893975678925156571418732239589025264" },
  { "catenary_rise", "1", "0.16763034499349933988823225474354392090397648" },
  { "catenary_width", "1", "0.373929429001337392727677506138304334175972118" },
  { "catenary_height", "1", "0.0199540019747333568436303961481886082599989" },
  { "arc_across", "2.5", "0.595892427466313846889315440615599397335246154" },
  { "arc_along", "2.5", "0.346800547370744254268015693105485187331507653" },
  { "arc_lever", "2.5", "1.04053247318851631245424467134181657311000672" },
  { "catenary_rise", "2.5", "0.375648349452168949329318444680698083025395399" },
  { "catenary_width", "2.5", "0.509146152149913230246368158555179545241133686" },
  { "catenary_height", "2.5", "0.0680445753422667707378981774647690162497092097" },
  { "arc_across", "7", "0.464621165868040346147308756999479085580062525" },
  { "arc_along", "7", "0.526570030236121221140945619293089671976586915" },
  { "arc_lever", "7", "-0.660047025954906196655911937205805558227331961" },
  { "catenary_rise", "7", "0.498188707503215959528572310924766252359155747" },
  { "catenary_width", "7", "0.755101565656663362524513018641968965900429946" },
  { "catenary_height", "7", "0.0833241863473284334228852109895407374978737388" },
}
for _, row in ipairs(published) do -- the quadrature kept 70 digits of a number of size 1: 48 of arc_along(0.001)
  tap.ok(agree(R.apply(row[1], 240, q(row[2])), q(row[3]), 140), row[1] .. "(" .. row[2] .. ") to 42 digits")
end

-- ---- closed forms ----

-- The closed form of each function with that many bits.
local function closed(name, x, bits)
  local function f(fn, a) return R.apply(fn, bits, a) end
  local two, four = R.new(2), R.new(4)
  if string.find(name, "arc_") then
    local mean, double = f("sin", x) / x, f("sin", two * x) / (two * x)
    if name == "arc_across" then return (R.one - double) / two end
    if name == "arc_along" then return (R.one + double) / two - mean ^ 2 end
    return mean - f("cos", x)
  end
  local s, c = f("sinh", x), f("cosh", x)
  if name == "catenary_rise" then return ((x / s + c) / two - R.one) / s end
  if name == "catenary_width" then return (x ^ 2 - two * x * c / s + two) / x ^ 2 end
  return (R.one + s ^ 2 / R.new(3) - (x / s + c) ^ 2 / four) / s ^ 2
end

local first = { -- coefficient, power
  arc_across = { "1/3", 2 }, arc_along = { "1/45", 4 }, arc_lever = { "1/3", 2 },
  catenary_rise = { "1/6", 1 }, catenary_width = { "1/3", 0 }, catenary_height = { "1/45", 2 },
}

for _, name in ipairs(names) do
  local good = true
  for _, s in ipairs { "1e-40", "1e-15", "1e-8", "0.01", "0.3", "1", "1.5707963267948966", "3", "3.1",
    "4.493409457909064",
    "6.283185307179586", "50", "700", string.find(name, "arc_") and "1000000.25" or "7000.25", "-0.3", "-5" } do
    local x = q(s)
    -- the closed form loses at most 4 log2(1/x) + 60 bits; the large argument 20 more
    local want = closed(name, x, 1000)
    if not agree(R.apply(name, 240, x), want, 238) then
      good = false
      tap.diag(name .. "(" .. s .. ")")
    end
  end
  tap.ok(good, name .. ": 240 bits of the closed form")
  local tiny, c, n = q "1e-300", q(first[name][1]), first[name][2]
  tap.ok(agree(R.apply(name, 240, tiny), c * tiny ^ n, 238), name .. "(1e-300) is the first term of its series")
  tap.is(tostring(R.apply(name, 100, R.zero)), tostring(n == 0 and R.round(c, 100) or R.zero), name ..
    ": the limit at 0")
  for _, bits in ipairs { 24, 53, 800 } do
    tap.ok(agree(R.apply(name, bits, q "0.37"), R.apply(name, 1000, q "0.37"), bits - 1),
      name .. " is good to the last of " .. bits .. " bits")
  end
end
tap.ok(agree(R.apply("arc_across", 200, q "1e300"), q "0.5", 198), "a huge angle is many turns")

-- ---- expressions ----

local h = expr.sym("h", 3, true)
for k = 1, 24 do -- sine and cosine of k pi/12 are known, so these are too
  local angle = expr.pi * R.new(k, 12)
  for n = 1, 3 do
    local e = expr.call(names[n], angle)
    local plain = not string.find(text.of(e), "arc_", 1, true)
    local x = R.apply("pi", 1000) * R.new(k, 12)
    if not (plain and agree(evaluate.precise(e, {}, 300), closed(names[n], x, 1000), 280)) then
      tap.ok(false, names[n] .. " of " .. k .. " pi/12: " .. text.of(e))
    end
  end
end
tap.is(text.of(expr.call("arc_along", expr.pi / 2)), "(1 - 8/pi^2)/2", "the half circle is exact")
tap.ok(expr.call("arc_across", expr.pi) == expr.lift "1/2", "so is the whole one")
tap.is(text.of(expr.call("arc_across", expr.pi / 7)), "arc_across(pi/7)", "other angles stay")
tap.ok(expr.call("catenary_width", expr.zero) == expr.lift "1/3", "so is a straight catenary")
for n, name in ipairs(names) do
  local e = expr.call(name, h)
  local mirrored = expr.call(name, -h)
  tap.ok(mirrored == (name == "catenary_rise" and -e or e), name .. ": even, or odd")
  if name ~= "arc_lever" and name ~= "catenary_rise" then tap.ok(expr.nonnegative(e), name .. " is a variance") end
  tap.is(text.of(e), name .. "(h)", "plain text")
  tap.is(text.of(e, "latex"), "\\operatorname{" .. string.gsub(name, "_", "\\_") .. "}\\left( h \\right)", "LaTeX")
  tap.near(evaluate.double(e, { h = 1 }), tonumber(published[6 + n][3]), 0x1p-52, 0, "in doubles", "one rounding")
  -- central difference of step 2^-100: its error is 2^-200 and 2^-300 from 400 bits
  local d, at = R.new(2) ^ -100, q "0.7"
  local slope = (R.apply(name, 400, at + d) - R.apply(name, 400, at - d)) / (R.new(2) * d)
  tap.ok(agree(evaluate.precise(calculus.diff(e, h), { h = at }, 400), slope, 190), "d " .. name)
end

-- ---- shapes: the moments about fixed axes by elementary integrals, for a thin and for a wide angle ----

local bits = 2000
local function pi() return R.apply("pi", bits) end

-- Do com and sigma of the shape (name, numbers) have these values to 180 bits?
local function holds(args, values, want, what)
  local m = assert(scene.body(args.shape .. " { " .. args.text .. ", mass = 1 }", args.names,
    "origin = {0, 0, 0}")).model
  local I = m.centroidal
  local S = { (I[2] + I[3] - I[1]) / 2, (I[1] + I[3] - I[2]) / 2, (I[1] + I[2] - I[3]) / 2, -I[4], -I[5], -I[6] }
  local got = { m.com[1], m.com[2], m.com[3], table.unpack(S) }
  for i, w in ipairs(want) do
    local v = evaluate.precise(got[i], values, 1000)
    local zero = R.sign(w) == 0 and (R.sign(v) == 0 or R.log2(v) < -900) -- 1000 bits of terms below 1
    if not zero and (R.sign(w) == 0 or not agree(v, w, 180)) then return tap.ok(false, what .. ", entry " .. i) end
  end
  tap.ok(true, what)
end

for _, s in ipairs { "1e-8", "0.3", "3", "6.2" } do
  local w, zero, two = q(s), R.zero, R.new(2)
  local sn, cs = R.apply("sin", bits, w), R.apply("cos", bits, w)
  local x, y = sn / w, (R.one - cs) / w -- means of cos, sin, cos^2, sin^2, cos sin over 0 .. w
  local xx, yy, xy = (R.one + sn * cs / w) / two, (R.one - sn * cs / w) / two, sn ^ 2 / (two * w)
  holds({ shape = "wire.arc", text = "r = 1, angle = w/o", names = { "w", "o" } }, { w = w, o = R.one },
    { x, y, zero, xx - x ^ 2, yy - y ^ 2, zero, xy - x * y, zero, zero }, "arc of angle " .. s)
  local g = R.new(2, 3)
  holds({ shape = "plate.sector", text = "r = 1, angle = w/o", names = { "w", "o" } }, { w = w, o = R.one },
    { g * x, g * y, zero, xx / two - (g * x) ^ 2, yy / two - (g * y) ^ 2, zero, xy / two - g ^ 2 * x * y, zero, zero },
    "sector of angle " .. s)
  local tx, ty, k = sn + (cs - R.one) / w, sn / w - cs, R.one / (two * pi()) -- means of t cos t, t sin t; pitch 1
  local turns = w / (two * pi())
  holds({ shape = "wire.helix", text = "r = 1, pitch = 1, turns = n/o", names = { "n", "o" } }, { n = turns,
    o = R.one },
    { x, y, k * w / two, xx - x ^ 2, yy - y ^ 2, k ^ 2 * w ^ 2 / R.new(12), xy - x * y, k * (tx - x * w / two),
      k * (ty - y * w / two) }, "helix of angle " .. s)
  local a = q "0.5" -- u = span/(2 a) = span
  local sh, ch = R.apply("sinh", bits, w), R.apply("cosh", bits, w)
  local mean = a * (w / sh + ch) / two
  holds({ shape = "wire.catenary", text = "a = 1/2, span = w", names = { "w" } }, { w = w },
    { zero, mean, zero, a ^ 2 * (w ^ 2 - two * w * ch / sh + two), a ^ 2 * (R.one + sh ^ 2 / R.new(3)) - mean ^ 2, zero,
      zero, zero, zero }, "catenary of span " .. s)
end

do -- turned to its bisector an arc is diagonal, as the expression 0
  local m = assert(scene.body([[wire.arc { r = 1, angle = w/o, mass = 1 }:turned { axis = {0, 0, 1}, angle = -w/o/2 }]],
    { "w", "o" })).model
  tap.ok(m.inertia[4] == expr.zero, "the bisector is a principal axis structurally")
  local by = {}
  for _, s in ipairs(expr.symbols(m.inertia[2])) do by[s.name] = s end
  local w = by.w / by.o
  tap.ok(ratio.equal(m.inertia[1], expr.call("arc_across", w / 2)) and
    ratio.equal(m.inertia[2], expr.call("arc_along", w / 2)), "with the two variances as its moments")
end

tap.done()
