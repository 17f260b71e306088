#!/usr/bin/env lua5.4
-- scene.t: what a scene that is right means: defaults, exact numbers, units, parameters, placement, attitude.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Expected values are worked by hand from the definitions (Steiner's rule, rotations by quarter turns, scaling) and
-- written as exact expressions; wrong scenes are errors.t's.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local ratio = require "generator.algebra.ratio"
local text = require "generator.formula.text"
local recipe = require "tests.algebra.recipe"

local function q(x) return expr.lift(x) end

-- got: an expression or a list of them; want: the same, of anything that denotes a number.
local function same(got, want, name)
  if expr.is(got) then got, want = { got }, { want } end
  local good, shown = #got == #want, {}
  for i = 1, #got do
    good = good and ratio.equal(got[i], q(want[i]))
    shown[i] = text.of(got[i])
  end
  return tap.ok(good, name, "got  " .. table.concat(shown, ", "))
end

local function model(source, options)
  local job, why = scene.read(source, options)
  if not job then error(why, 2) end
  return job.model, job
end

-- The model of a body in one line of the scene language; more: further keys.
local function body(shape, more, options)
  return model('return scene { name = "s", body = ' .. shape .. (more and ", " .. more or "") .. " }", options)
end

-- ---- defaults ----

do
  local m, job = body "solid.box { x = 1, y = 2, z = 3, mass = 6 }"
  same(m.origin, { 0, 0, 0 }, "the origin is the centroid unless the scene says otherwise")
  same(m.com, { 0, 0, 0 }, "then the centre of mass is there")
  same(m.omega, { 0, 0, 0 }, "the initial rates are 0")
  same(m.attitude, { 1, 0, 0, 0 }, "the initial attitude is the identity")
  same(m.horizon, 10, "the horizon is 10 s")
  same(m.step, "1/1000", "the step is 1 ms")
  tap.is(#job.record.effects, 0, "there are no effects")
  tap.is(#m.params, 0, "and no parameters")
  tap.is(job.record.name, "s", "the name is the scene's")
  same(m.inertia, { "13/2", 5, "5/2", 0, 0, 0 }, "the box has M (y^2 + z^2)/12 = 13/2 and so on")
end

-- ---- numbers ----

do
  local m = body "solid.box { x = 0.1, y = 0.2, z = 0.3, mass = 1.2 }"
  same(m.mass, "6/5", "1.2 is 6/5")
  same(m.inertia, { "13/1000", "1/100", "1/200", 0, 0, 0 }, "0.1, 0.2, 0.3 are tenths: the tensor is exact")
end
for _, case in ipairs {
  { '"1/3"', "1/3", "a text is an exact quotient" }, { 'exact("1/3")', "1/3", "exact() reads a quotient" },
  { "exact(0.1)", "1/10", "exact() of a number is its decimal" }, { "2*exact(\"1/3\")", "2/3", "products stay exact" },
  { "exact(\"1/3\")/2", "1/6", "quotients stay exact" }, { "exact(\"1e-30\")", "1e-30", "as small as one likes" },
  { "exact(\"2/3\")^3", "8/27", "powers stay exact" }, { "exact(\"1/3\") + exact(\"1/6\")", "1/2", "sums stay exact" },
  { "-exact(\"-1/3\")", "1/3", "a sign is exact" }, { "sqrt(exact(\"4/9\"))", "2/3", "roots that open are rational" },
  { "sin(pi/6)", "1/2", "sin(pi/6) is 1/2" }, { "abs(-exact(\"1/7\"))", "1/7", "|x| is exact" },
  { 'quantity(2.5, "kg")', "5/2", "a quantity in SI units is its number" },
  { 'quantity(1, "lb")', "0.45359237", "a pound is exact" }, { 'quantity("1/3", "g")', "1/3000", "a third of a gram" },
  { 'quantity(2, "kg/m")*quantity(3, "m")', 6, "dimensions multiply to a mass" },
  { 'sqrt(quantity(4, "kg^2"))', 2, "the root of a square mass is a mass" },
  { 'quantity(4, "kg^2")^0.5', 2, "and so is its power 1/2" },
  { 'quantity(6, "kg m")/quantity(3, "m")', 2, "dimensions divide to a mass" },
  { 'abs(quantity(-3, "kg"))', 3, "|x| of a mass is a mass" },
  { 'max(quantity(3, "kg"), quantity(2, "g"), 1)', 3, "the largest of masses is a mass, a plain number is one too" },
  { 'min(quantity(3, "kg"), quantity(2, "kg"))', 2, "and so is the smallest" },
  { '(2 + sign(quantity(-3, "m")))*quantity(1, "kg")', 1, "a sign is a pure number" },
  { '2 + sign(0)', 2, "sign(0) is 0" },
  { 'quantity(1, "kg") + 2', 3, "a plain number takes the dimension beside it in a sum" },
  { 'quantity(1, "kg")*2', 2, "and is a pure number in a product" },
} do
  same(body("solid.sphere { r = 1, mass = " .. case[1] .. " }").mass, case[2], case[1] .. ": " .. case[3])
end
for _, case in ipairs {
  { "pi", "pi is a plain number" }, { "2*pi", "and so is a multiple" }, { "sqrt(2)/2", "and a root" },
  { "cos(1)", "and a function's value" }, { "2^exact(0.5)", "and a power" },
  { 'atan2(quantity(1, "m"), quantity(1, "km"))*quantity(1, "kg")', "atan2 of two lengths is an angle" },
} do
  tap.ok(pcall(body, "solid.sphere { r = 1, mass = " .. case[1] .. " }"), case[1] .. " can be a mass: " .. case[2])
end
do
  local m = body 'solid.cylinder { r = pi, h = 1, density = 1 }'
  same(m.mass, expr.pi ^ 3, "pi stays pi: a cylinder of radius pi has pi^3 of volume")
end

-- ---- parameters ----

local BOOK = [[
local w = param("width", 150, "mm")
local M = param("M", 2.4, "kg")
local n = param("n", 3)
return scene { name = "s", body = solid.box { x = w, y = 2*w, z = n*w, mass = M } }]]
do
  local m, job = model(BOOK)
  local p = job.record.params
  tap.is(#p, 3, "a scene's parameters are listed in their order")
  tap.is(p[1].name .. " " .. p[2].name .. " " .. p[3].name, "width M n", "by name")
  same({ q(p[1].default), q(p[2].default), q(p[3].default) }, { "3/20", "12/5", 3 }, "with defaults in SI units")
  tap.is(p[1].unit .. " " .. p[2].unit .. " " .. p[3].unit, "m kg 1", "and SI units")
  tap.is(p[1].given, "150 mm", "and what was written is kept")
  tap.is(p[2].line, 2, "with its line")
  local w, M, n = p[1].sym, p[2].sym, p[3].sym
  same(m.inertia, { M * w ^ 2 * (4 + n ^ 2) / 12, M * w ^ 2 * (1 + n ^ 2) / 12, 5 * M * w ^ 2 / 12, 0, 0, 0 },
    "a parameter stays a symbol in the tensor")
  tap.ok(M.positive and not w.positive, "a mass is known to be positive; a length may be a coordinate")
  tap.ok(recipe.close(m:number(m.inertia[3]), R.parse "9/400", 200), "its number is that of the defaults")
end
do
  local m = model(BOOK, { set = { width = "100", n = "1/3" } })
  tap.ok(recipe.close(m:number(m.inertia[3]), R.parse "1/100", 200), "--set speaks in the parameter's own unit")
  tap.ok(recipe.close(m:number(m.inertia[1]), R.parse "37/4500", 200), "and takes exact quotients: 12/5 (4 + 1/9)/1200")
  m = model(BOOK, { set = { width = "100" }, bake = true })
  same(m.inertia[3], q "1/100", "--bake makes the parameters numbers")
  tap.is(#m.params, 0, "and leaves none")
  local job, _, why = require("generator.driver").read({
    read = function() return BOOK end, visible = function(f) return f end,
    safe = {}, sandbox = function(s, name, env) return pcall(assert(load(s, name, "t", env))) end,
  }, "s.lua", { set = { widht = "1" } })
  tap.ok(job == nil and why == "--set widht: the scene has no such parameter (it has width, M, n); did you mean width?",
    "--set of no parameter is refused", why)
end
do
  local _, job = model [[
local a, b = param("a", 2, "m"), param("b", 1, "m")
return scene { name = "s", body = solid.tube { r_in = b, r_out = a, h = 3, mass = param("M", 1, "kg") } }]]
  local rules = {}
  for i, c in ipairs(job.model.conditions) do rules[i] = c.text end
  tap.is(table.concat(rules, "; "), "param: M must be positive (test.lua:2); " ..
    "tube: r_in must be positive (test.lua:2); tube: r_out must be positive (test.lua:2); " ..
    "tube: r_out must be larger than r_in (test.lua:2)",
    "conditions on parameters are kept for the emitted code, each once, with their lines")
end

-- ---- origin ----

for _, case in ipairs {
  { "solid.box { x = 2, y = 4, z = 6, mass = 1 }", "corner", { 1, 2, 3 } },
  { "solid.box { x = 2, y = 4, z = 6, mass = 1 }", "centroid", { 0, 0, 0 } },
  { "solid.cylinder { r = 1, h = 4, mass = 1 }", "base", { 0, 0, 2 } },
  { "solid.cylinder { r = 1, h = 4, mass = 1 }", "top", { 0, 0, -2 } },
  { "solid.cone { r = 1, h = 4, mass = 1 }", "apex", { 0, 0, -3 } },
  { "plate.rectangle { x = 2, y = 4, mass = 1 }", "corner", { 1, 2, 0 } },
  { "rod.straight { length = 4, mass = 1 }", "end", { 0, 0, 2 } },
  { "rod.between { from = {1, 0, 0}, to = {3, 2, 0}, mass = 1 }", "from", { 1, 1, 0 } },
  { "rod.between { from = {1, 0, 0}, to = {3, 2, 0}, mass = 1 }", "to", { -1, -1, 0 } },
  { "solid.box { x = 2, y = 4, z = 6, mass = 1 }:at{7, 7, 7}", "corner", { 1, 2, 3 } },
  { "solid.box { x = 2, y = 4, z = 6, mass = 1 }:turned{ axis = \"z\", angle = pi/2 }", "corner", { -2, 1, 3 } },
  { "solid.box { x = 2, y = 4, z = 6, mass = 1 }:scaled{3}", "corner", { 3, 6, 9 } },
  { "solid.box { x = 2, y = 4, z = 6, mass = 1 }:mirrored \"x\"", "corner", { -1, 2, 3 } },
  { "solid.box { x = 2, y = 4, z = 6, mass = 1 } + solid.sphere { r = 1, mass = 1 }:at{2, 0, 0}", "corner",
    { 2, 2, 3 } },
} do
  same(body(case[1], 'origin = "' .. case[2] .. '"').com, case[3],
    "origin \"" .. case[2] .. "\" of " .. case[1] .. ": where the centre of mass is from there")
end
do
  local m = body("solid.box { x = 2, y = 4, z = 6, mass = 3 }", 'origin = {1, quantity(50, "cm"), -2}')
  same(m.com, { -1, "-1/2", 2 }, "an origin can be a point of the shape's frame, with units")
  -- Steiner: 3 (16 + 36)/12 = 13, + 3 (1/4 + 4)
  same(m.inertia, { 13 + 3 * 4.25, 10 + 15, 5 + 3 * 1.25, -1.5, 6, 3 }, "and the tensor is about it, by Steiner's rule")
  same(m.centroidal, { 13, 10, 5, 0, 0, 0 }, "while the one about the centroid stays")
end

-- ---- placement ----

local BOX = "solid.box { x = 1, y = 2, z = 3, mass = 12 }" -- 13, 10, 5
local function inertia(shape) return body(shape).inertia end
same(inertia(BOX), { 13, 10, 5, 0, 0, 0 }, "the box of this section")
same(inertia(BOX .. ":at{1, 2, 3}"), { 13, 10, 5, 0, 0, 0 }, "moving does not change the tensor about the centroid")
same(body(BOX .. ":at{1, 2, 3}:at{1, 0, 0}", "origin = {0, 0, 0}").com, { 2, 2, 3 }, "moves add up")
same(inertia(BOX .. ":turned{ axis = \"x\", angle = pi/2 }"), { 13, 5, 10, 0, 0, 0 },
  "a quarter turn about x swaps yy and zz, exactly")
same(inertia(BOX .. ":turned{ axis = {0, 0, 3}, angle = pi/4 }"), { "23/2", "23/2", 5, "3/2", 0, 0 },
  "an eighth of a turn about z: (xx + yy)/2 and (xx - yy)/2, whatever the length of the axis")
same(inertia(BOX .. ':turned{ axis = "z", angle = quantity(45, "deg") }'), { "23/2", "23/2", 5, "3/2", 0, 0 },
  "45 degrees are an eighth of a turn")
same(inertia(BOX .. ":turned{ axis = {1, 1, 1}, angle = 2*pi/3 }"), { 5, 13, 10, 0, 0, 0 },
  "a third of a turn about the diagonal: what was z is x, what was x is y")
same(inertia(BOX .. ":turned{ quaternion = {1, 1, 1, 1} }"), { 5, 13, 10, 0, 0, 0 },
  "which is the quaternion (1, 1, 1, 1), normalised")
same(inertia(BOX .. ":turned{ quaternion = {2, 0, 0, 0} }"), { 13, 10, 5, 0, 0, 0 }, "(2, 0, 0, 0) is no turn")
same(body(BOX .. ":at{1, 0, 0}:turned{ axis = \"z\", angle = pi/2 }", "origin = {0, 0, 0}").com, { 0, 1, 0 },
  "turning after moving carries the body round the frame's origin, x to y")
same(body(BOX .. ":turned{ axis = \"z\", angle = pi/2 }:at{1, 0, 0}", "origin = {0, 0, 0}").com, { 1, 0, 0 },
  "moving after turning does not")
same(inertia(BOX .. ":scaled{2}"), { 52, 40, 20, 0, 0, 0 }, "twice as large, the mass kept: four times the moments")
same(inertia(BOX .. ":scaled(2)"), { 52, 40, 20, 0, 0, 0 }, "a number scales as well")
same(inertia(BOX .. ":scaled{2, 1, 1}"), { 13, 13, 8, 0, 0, 0 }, "stretched along x: the box of 2, 2, 3")
do
  local m = body "solid.box { x = 1, y = 2, z = 3, density = 2 }:scaled{1, 2, 3}"
  same(m.mass, 72, "scaled with a density the mass follows the volume")
  same(body("solid.box { x = 1, y = 2, z = 3, mass = 12 }:scaled{1, 2, 3}").mass, 12, "with a mass it stays")
end
do
  local L = "points { {1, 1, 0, 0}, {2, 0, 1, 0}, {3, 1, 1, 1} }"
  local plain, mirror = inertia(L), inertia(L .. ":mirrored \"x\"")
  same(mirror, { plain[1], plain[2], plain[3], -plain[4], -plain[5], plain[6] },
    "a mirror at x = 0 turns the signs of xy and xz, and no moment")
end
do
  local m = body("solid.sphere { r = 1, mass = 1 }:at{-1, 0, 0} + solid.sphere { r = 1, mass = 1 }:at{1, 0, 0}")
  same(m.mass, 2, "masses add up")
  same(m.inertia, { "4/5", "14/5", "14/5", 0, 0, 0 }, "two balls: 2 (2/5), and 2 (2/5 + 1) across")
  same(m.com, { 0, 0, 0 }, "the centroid of a sum is its centre of mass")
end
do
  local m = body("solid.box { x = 2, y = 2, z = 2, density = 1 } - solid.box { x = 1, y = 1, z = 1, density = 1 }")
  same(m.mass, 7, "a hole takes its mass away")
  same(m.inertia, { q "16/3" - q "1/6", q "16/3" - q "1/6", q "16/3" - q "1/6", 0, 0, 0 }, "and its moments")
  m = body("solid.sphere { r = 2, density = 3 } - solid.sphere { r = 1, density = 3 }:at{1, 0, 0}",
    "origin = {0, 0, 0}")
  same(m.com, { "-1/7", 0, 0 }, "a hole moves the centre of mass away from it")
end
same(body('tensor { mass = 2, com = {1, 0, 0}, xx = 1, yy = 3, zz = 3, about = "origin" }').centroidal,
  { 1, 1, 1, 0, 0, 0 }, "a tensor can be given about the origin of its frame")
same(body("points { {1, 0, 0, 0}, {1, 2, 0, 0}, {1, 0, 2, 0} }").com, { 0, 0, 0 }, "points have their own centroid")

-- ---- initial state, time ----

do
  local m = body(BOX, [[initial = { omega = {0.1, quantity(60, "rpm"), quantity(90, "deg/s")},
    attitude = {1, 2, 2, 4} }, time = { horizon = quantity(2, "min"), step = 1e-4 }]])
  same(m.omega, { "1/10", 2 * expr.pi, expr.pi / 2 }, "rates in rad/s, rpm, deg/s")
  same(m.attitude, { "1/5", "2/5", "2/5", "4/5" }, "an attitude of four numbers is normalised, exactly")
  same(m.horizon, 120, "a horizon in minutes")
  same(m.step, "1/10000", "a step")
end
for _, case in ipairs {
  { '{ axis = "x", angle = pi/2 }', { expr.sqrt(2) / 2, expr.sqrt(2) / 2, 0, 0 }, "a quarter turn about x" },
  { '{ axis = {0, 3, 4}, angle = pi }', { 0, 0, "3/5", "4/5" }, "half a turn about an oblique axis" },
  { '{ quaternion = {0, 0, 0, -3} }', { 0, 0, 0, -1 }, "a quaternion by name" },
  { '{ axis = "z", angle = quantity(-120, "deg") }', { "1/2", 0, 0, -expr.sqrt(3) / 2 },
    "a negative angle in degrees" },
} do
  same(body(BOX, "initial = { attitude = " .. case[1] .. " }").attitude, case[2], "attitude: " .. case[3])
end
do
  local m = model [[
local t = param("tilt", 20, "deg")
return scene { name = "s", body = solid.sphere { r = 1, mass = 1 },
  initial = { attitude = { axis = "x", angle = t } } }]]
  local n = expr.zero
  for i = 1, 4 do n = n + m.attitude[i] ^ 2 end
  tap.ok(ratio.equal(n, expr.one), "an attitude by a parameter is a unit quaternion for every value of it")
  -- cos 10 degrees to 200 bits, by MPFR
  local want = R.apply("cos", 300, R.apply("pi", 300) / R.new(18))
  tap.ok(recipe.close(evaluate.precise(m.attitude[1], m.defaults, 300), want, 200), "whose w is cos(tilt/2)")
end

-- ---- what a script can and cannot do ----

do
  local m = model [[
local rods = {}
for i = 1, 3 do rods[i] = rod.straight { length = i, mass = i }:at{i, 0, 0} end
local sum
for _, r in ipairs(rods) do sum = sum and sum + r or r end
return scene { name = "s", body = sum }]]
  same(m.mass, 6, "bodies can be made in loops and summed")
  m = model [[
local s = scene { name = "s", body = solid.sphere { r = 1, mass = 1 } }
s.name, s.body, s.step = "other", 7, nil
return s]]
  tap.ok(m.name == "s" and m.mass == expr.one, "a scene that was made cannot be altered")
  m = model [[
local b = solid.sphere { r = 1, mass = 1 }
local c = b:at{1, 0, 0}
return scene { name = "s", body = b + c }]]
  same(m.inertia[2], 2 * (q "2/5" + "1/4"), "placing makes a new shape and leaves the old one where it was")
end
do
  local _, job = body(BOX, "accuracy = 1e-9, budget = { ops = 500, real = \"float\", target = \"avr\" }, " ..
    "initial = { omega = {1, 1, 2} }, ranges = { omega = { 1, 2 }, attitude = 1/4 }")
  tap.is(#job.diag.warnings, 0, "accuracy, budget and ranges are keys like others")
  local b = job.record.budget
  tap.is(table.concat({ job.record.accuracy, b.ops, b.real, b.target }, " "), "1e-09 500.0 float avr", "as given")
  local r = job.ranges
  tap.ok(r.attitude == R.parse "1/4" and r.states[5].lo == R.parse "1" and r.states[7].hi == R.parse "2" and
    not r.states[1], "ranges by the place of the state")
end
do -- the forms of ranges
  local function of(ranges, more)
    local lines = 'local a = param("a", 20, "cm") local M = param("M", 1, "kg")\nreturn scene { name = "s", ' ..
      "body = solid.box { x = a, y = 1, z = 1, mass = M }, ranges = " .. ranges .. (more or "") .. " }"
    return assert(scene.read(lines)).ranges
  end
  local r = of "{ omega = 3 }"
  tap.ok(r.states[5].lo == R.parse "-3" and r.states[5].hi == R.parse "3" and r.states[7].lo == R.parse "-3",
    "r is from -r to r")
  r = of "{ omega = { {0, 1}, {quantity(60, \"deg/s\")/60, 2}, {-1, 0} } }"
  tap.ok(r.states[5].hi == R.parse "1" and r.states[7].lo == R.parse "-1" and
    math.abs(R.todouble(r.states[6].lo) - math.pi / 180) < 1e-17, "three pairs, in any unit")
  r = of "{ a = {10, 30}, M = {quantity(500, \"g\"), 2} }"
  tap.ok(r.params[1].name == "M" and r.params[1].lo == R.parse "1/2" and r.params[1].hi == R.parse "2" and
    r.params[2].name == "a" and r.params[2].lo == R.parse "1/10" and r.params[2].hi == R.parse "3/10",
    "parameters: plain numbers in their own unit")
  r = of("{ wheel = {0, 40}, attitude = \"any\" }",
    ", effects = { effect.wheel { axis = {0, 0, 1}, inertia = 1e-6, included = true } }")
  tap.ok(r.states[8].hi == R.parse "40" and r.attitude == "any", "a state of an effect by its name; any attitude")
  r = of "{ wx = {1, 2} }"
  tap.ok(r.states[5].lo == R.parse "1" and not r.states[6], "a component by its name")
end
-- an angle beyond a full turn, without a unit and without pi, was probably meant in degrees
for _, case in ipairs { { "90", true }, { "-45", true }, { "6.3", true }, { "6.2832", false }, { "2*pi", false },
  { "4*pi", false }, { "quantity(90, \"deg\")", false }, { "quantity(90, \"rad\")", false }, { "1.5", false } } do
  local _, job = body(BOX .. ":turned{ axis = \"x\", angle = " .. case[1] .. " }")
  local w = job.diag.warnings[1]
  tap.is(w and w.message or "", case[2] and "turned: angle is in radians and " .. case[1] .. " looks like degrees: " ..
    "write quantity(" .. case[1] .. ", \"deg\") or quantity(" .. case[1] .. ", \"rad\")" or "",
    "an angle of " .. case[1] .. (case[2] and " is questioned" or " is not questioned"))
end
-- zero is of any unit: it is a neutral element of sums, an argument of any dimension, and breaks no other rule
do
  local job, why = scene.read [[
local m, L = param("m", 1, "kg"), param("L", 2, "m")
local none = quantity(0, "kg m^2")
local s = none + m + 0*L + (L - L) + max(0*L, m) - m
return scene { name = "s", body = solid.box { x = L, y = L + none, z = L, mass = s }:at{0*m, none, L},
  effects = { effect.torque { body = {none, 0*t*L, 0.1*t} } },
  initial = { omega = {none, 0*L, quantity(1, "rad/s")} } }]]
  tap.ok(job and job.model:double(job.model.mass) == 1.0, "zero is of any unit", why)
  job, why = scene.read 'return scene { name = "s", body = solid.box { x = quantity(0, "kg"), y = 1, z = 1, mass = 1 }}'
  tap.ok(not job and why:find("x must be positive, got 0", 1, true), "and no length that must be positive", why)
end
-- a scene's own globals are Lua's: made anywhere, read back, also as nil
do
  local job = scene.read('a = 0.2\nlocal function f() b = a n = nil end f() if n == nil then a = a + b end\n' ..
    '_ENV.c = pi == nil and 1 or 3 t = nil local gone = t\n' ..
    'return scene { name = "s", body = solid.box { x = a, y = b, z = c, mass = 1 } }')
  local box = job and job.record.body.a
  tap.ok(box and box.x.value == R.parse "0.4" and box.y.value == R.parse "0.2" and box.z.value == R.parse "3",
    "globals of the scene's own")
end
do
  local _, job = body(BOX, "effects = { effect.gravity{}, effect.damping { rate = 0.1 }, " ..
    "effect.torque { body = {1, 2, 3} } }")
  local kinds = {}
  for i, e in ipairs(job.record.effects) do kinds[i] = e.kind end
  tap.is(table.concat(kinds, " "), "effect.gravity effect.damping effect.torque", "effects keep their order")
  same(job.record.effects[1].a.g, "9.80665", "gravity is the standard one")
  same(job.record.effects[1].a.direction, { 0, 0, -1 }, "and points down")
  local many = {}
  for i = 1, 12 do many[i] = "effect.torque { body = {" .. i .. ", 0, 0} }" end
  _, job = body(BOX, "effects = { " .. table.concat(many, ", ") .. " }")
  local order = {}
  for i, e in ipairs(job.record.effects) do order[i] = tostring(e.a.body[1].value) end
  tap.is(table.concat(order, " "), "1 2 3 4 5 6 7 8 9 10 11 12", "twelve of them too")
end
-- 0 belongs to every unit: in sums, differences, the least and the greatest, and signs; so does 0 times a state
do
  local job, d = scene.read [[
local a, u = param("a", 0.3, "m"), input("u", "N m", { min = -1, max = 1 })
local M = quantity(2, "kg")
return scene { name = "zero", body = solid.box { x = a + 0, y = 0 + a - 0.0, z = max(a, 0, a/2) + a*sign(a - 0),
    mass = (M + 0 + (0 + M) + (M - 0) + max(M, 0) + min(0, M))/4 },
  effects = { effect.torque { body = { 0*wx + u, max(u, 0) - 0, 0 - min(u, 0*wy) } } },
  initial = { omega = { 0 + quantity(1, "rad/s"), 0, 0*quantity(1, "rad/s") } },
  events = { { name = "e", when = max(wx - 1, 0) - 0 } } }]]
  tap.ok(job and job.model:number(job.model.mass) == R.parse "2", "0 has every unit", d)
  job, d = scene.read('return scene { name = "s", body = solid.box { x = quantity(1, "m") + quantity(0, "s"), ' ..
    "y = 1, z = 1, mass = 1 } }")
  tap.ok(job, "also one that was written with another", d)
end

tap.done()
