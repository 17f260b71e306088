#!/usr/bin/env lua5.4
-- units.t: factors to SI, exact, and the algebra of dimensions.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Source of the factors: NIST Special Publication 811 (2008), appendix B.8, which gives those in bold as exact, and
-- the SI brochure (9th edition) tables 7 and 8.  Long decimals of B.8 are rounded to 7 digits there: those are compared
-- to 7.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local units = require "generator.dsl.units"

-- ---- factors ----

for _, case in ipairs {
  { "m", "1" }, { "km", "1000" }, { "cm", "0.01" }, { "mm", "0.001" }, { "um", "1e-6" }, { "nm", "1e-9" },
  { "pm", "1e-12" }, { "angstrom", "1e-10" }, { "in", "0.0254" }, { "ft", "0.3048" }, { "au", "149597870700" },
  { "kg", "1" }, { "g", "0.001" },
  { "mg", "1e-6" }, { "t", "1000" }, { "lb", "0.45359237" }, { "oz", "0.028349523125" }, { "s", "1" },
  { "ms", "0.001" },
  { "min", "60" }, { "h", "3600" }, { "day", "86400" }, { "N", "1" }, { "lbf", "4.4482216152605" }, { "J", "1" },
  { "W", "1" }, { "Pa", "1" }, { "T", "1" }, { "A", "1" }, { "K", "1" }, { "Hz", "1" }, { "rad", "1" }, { "1", "1" },
  { "u", "1.66053906660e-27" }, -- CODATA 2018
  { "kg m^2", "1" }, { "g cm^2", "1e-7" }, { "g/cm^3", "1000" }, { "lb ft^2", "0.0421401100938048" },
  { "lb/ft^3", tostring(R.parse "0.45359237" / R.parse "0.3048" ^ 3) }, { "km/h", "5/18" }, { "N m", "1" },
  { "ft lbf", "1.3558179483314004" }, { "kg*m/s/s", "1" }, { "m^-2", "1" }, { "cm^-2", "10000" }, { "1/min", "1/60" },
  { "mA", "0.001" }, { "mT", "0.001" }, { "uT", "1e-6" }, { "nT", "1e-9" }, { "uN", "1e-6" }, { "mN", "0.001" },
  { "m2", "1" }, { "g/cm3", "1000" }, { "kg m2", "1" }, { "g cm2/s2", "1e-7" }, { "12", nil }, { "m2.5", nil },
  { "kg m²", "1" }, { "kg·m²", "1" }, { "g⋅cm²", "1e-7" }, { "g/cm³", "1000" }, { "mm s⁻²", "0.001" }, { "µT", "1e-6" },
  { "μm", "1e-6" }, { "cm⁻²", "10000" }, { "m¹⁰", "1" }, { "N×m", "1" }, { "m³²", nil },
  { "  kg   m ^2 ", nil }, { " kg  m^2 ", "1" }, { "", "1" },
} do
  local factor = units.parse(case[1])
  if case[2] then
    tap.ok(factor and factor == expr.lift(case[2]), "'" .. case[1] .. "' is exactly " .. case[2],
      factor and require("generator.formula.text").of(factor))
  else
    tap.ok(factor == nil, "'" .. case[1] .. "' is no unit")
  end
end

-- The slug is the mass that 1 lbf accelerates by 1 ft/s^2.
tap.ok(units.parse "slug" == units.parse "lbf s^2/ft", "1 slug = 1 lbf s^2/ft, exactly")
do
  local kg = R.todouble(units.parse("slug").value)
  tap.near(kg, 14.59390, 0, 0.5e-5, "1 slug = 14.59390 kg", "NIST SP 811 gives 7 digits")
  local inertia = R.todouble(units.parse("slug ft^2").value)
  tap.near(inertia, 1.355818, 0, 0.5e-6, "1 slug ft^2 = 1.355818 kg m^2", "NIST SP 811 gives 7 digits")
end

-- Angles carry pi.
local pi = expr.pi
tap.ok(units.parse "deg" == pi / 180, "1 deg = pi/180")
tap.ok(units.parse "rev" == 2 * pi, "1 rev = 2 pi")
tap.ok(units.parse "rpm" == pi / 30, "1 rpm = pi/30 per second")
tap.ok(units.parse "rpm" == units.parse "rev/min", "1 rpm = 1 rev/min")
tap.ok(units.parse "deg/s" * 180 == pi, "180 deg/s = pi rad/s")
tap.near(evaluate.double(units.parse "rpm", {}), 0.1047198, 0, 0.5e-7, "1 rpm = 0.1047198 rad/s",
  "NIST SP 811 gives 7 digits")

-- ---- dimensions ----

local function dimension(s) return select(2, units.parse(s)) end
for _, case in ipairs {
  { "m", "m" }, { "kg m^2", "kg m^2" }, { "N", "kg m/s^2" }, { "N m", "kg m^2/s^2" }, { "J", "kg m^2/s^2" },
  { "W", "kg m^2/s^3" }, { "Pa", "kg/m/s^2" }, { "T", "kg/s^2/A" }, { "rad/s", "1/s" }, { "Hz", "1/s" },
  { "deg", "a pure number" }, { "1", "a pure number" }, { "m/m", "a pure number" }, { "lb/ft^3", "kg/m^3" },
  { "slug ft^2", "kg m^2" }, { "K", "K" }, { "m^2/m^2 kg", "kg" },
} do
  tap.is(units.name(dimension(case[1])), case[2], "the dimension of '" .. case[1] .. "' is " .. case[2])
end
tap.ok(units.equal(dimension "N m", units.torque), "N m is a torque")
tap.ok(units.equal(dimension "J", units.torque), "so is J: work and torque have one dimension")
tap.ok(units.equal(dimension "N m s", units.angular_momentum), "N m s is an angular momentum")
tap.ok(units.equal(dimension "lb/in^3", units.density_volume), "lb/in^3 is a density")
tap.ok(units.equal(dimension "kg/m^2", units.density_area), "kg/m^2 is an area density")
tap.ok(units.equal(dimension "kg/m", units.density_length), "kg/m is a line density")
tap.ok(not units.equal(units.length, units.time), "metres are no seconds")
tap.ok(units.equal(units.times(units.length, units.power(units.time, R.new(-1))), dimension "m/s"),
  "length times time^-1 is a speed")
tap.ok(units.equal(units.power(units.power(units.inertia, R.half), R.new(2)), units.inertia),
  "the root of a dimension, squared, is the dimension")
tap.is(units.name(units.power(units.length, R.half)), "m^1/2", "a root has a fractional exponent")
tap.is(units.si(units.none), "1", "the SI unit of a pure number is 1")
tap.is(units.si(units.torque), "kg m^2/s^2", "the SI unit of a torque")

-- ---- what is no unit ----

for _, case in ipairs {
  { "furlong", "unknown unit \"furlong\"" }, { "kg parsec", "unknown unit \"parsec\"" },
  { "M", "unknown unit \"M\" (write \"m\")" }, { "KG", "unknown unit \"KG\" (write \"kg\")" },
  { "m^", "unknown unit \"^\"" }, { "m^2.5", "unknown unit \".5\"" },
  { "m/", "unknown unit \"\"" }, { "/", "unknown unit \"\"" }, { "m//s", "unknown unit \"/s\"" },
  { "2 m", "unknown unit \"2 m\"" }, { "m-1", "unknown unit \"-1\" (write \"^-1\")" },
  { "m^21", "an exponent in \"m^21\" is too large" },
  { "m^-21", "an exponent in \"m^-21\" is too large" },
  { "m^123456789012345678901234567890", "an exponent in \"m^123456789012345678901234567890\" is too large" },
} do
  local factor, why = units.parse(case[1])
  tap.ok(factor == nil and why == case[2], "'" .. case[1] .. "': " .. case[2], tostring(why))
end

-- What was meant.  The right column is itself a unit.
for _, case in ipairs { { "meter", "m" }, { "metres", "m" }, { "Kilogram", "kg" }, { "kilogrammes", "kg" },
  { "second", "s" }, { "secs", "s" }, { "Newton", "N" }, { "degrees", "deg" }, { "millimeters", "mm" },
  { "micrometre", "um" },
  { "hz", "Hz" },
  { "RPM", "rpm" }, { "Nm", "N m" }, { "kgm", "kg m" }, { "lbs", "lb" }, { "Ns", "N s" }, { "inches", "in" },
  { "feet", "ft" },
  { "Tesla", "T" }, { "hours", "h" }, { "amu", "u" }, { "Angstrom", "angstrom" }, { "rads", "rad" }, { "MM", "mm" },
  { "kilonewton", "kN" }, { "sm" },
  { "mNm", "mN m" }, { "Nmm", "N mm" }, { "kgm", "kg m" } } do
  local factor, why = units.parse(case[1])
  local want = "unknown unit \"" .. case[1] .. "\"" .. (case[2] and " (write \"" .. case[2] .. "\")" or "")
  tap.ok(factor == nil and why == want and (not case[2] or units.parse(case[2])), want, tostring(why))
end

tap.is(select(2, units.parse "Nms"), "unknown unit \"Nms\" (write \"N m s\" or \"N ms\")",
  "two readings: both are named")
tap.ok(units.parse "°/s" * 180 == pi, "180 °/s = pi rad/s")

-- Every listed unit reads back to itself.
do
  local wrong = {}
  for _, u in ipairs(units.list) do
    local factor, dim = units.parse(u[1])
    if not factor or not units.equal(dim, u[3]) then wrong[#wrong + 1] = u[1] end
  end
  tap.is(table.concat(wrong, " "), "", #units.list .. " listed units are understood")
end

tap.done()
