-- units.lua -- units of measurement: exact factors to SI and dimensions.
--
-- A dimension is five exponents {m, kg, s, A, K}, rational so that roots have one; an angle has none.  Factors
-- are exact expressions (deg carries pi).  Source of the non-SI factors: NIST SP 811 (2008), appendix B: the
-- foot, pound and standard gravity are exact by definition, so slug = lb * (9.80665 m/s^2) / (1 ft/s^2) is exact.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local text = require "generator.formula.text"
local unitnames = require "generator.dsl.unitnames"

local units = {}

local base = { "m", "kg", "s", "A", "K" }

local function dim(m, kg, s, A, K) return { R.new(m), R.new(kg or 0), R.new(s or 0), R.new(A or 0), R.new(K or 0) } end

units.none = dim(0)
units.length, units.mass, units.time = dim(1), dim(0, 1), dim(0, 0, 1)
units.inertia, units.torque = dim(2, 1), dim(2, 1, -2)
units.force = dim(1, 1, -2)
units.velocity, units.acceleration, units.slowness = dim(1, 0, -1), dim(1, 0, -2), dim(-1, 0, 1)
units.rate, units.rate_dot = dim(0, 0, -1), dim(0, 0, -2)
units.friction, units.drag, units.stiffness = dim(0, 1, -1), dim(-1, 1), dim(0, 1, -2) -- N s/m, N s^2/m^2, N/m
units.magnetic_moment, units.field = dim(2, 0, 0, 1), dim(0, 1, -2, -1) -- A m^2, T
units.energy = units.torque
units.area, units.flux, units.gravitation = dim(2), dim(0, 1, -3), dim(3, 0, -2) -- m^2, W/m^2, m^3/s^2
units.sink = dim(-2, -1, 1) -- 1/(N m s)
units.angular_momentum, units.damping = dim(2, 1, -1), dim(2, 1, -1)
units.density_volume, units.density_area, units.density_length = dim(-3, 1), dim(-2, 1), dim(-1, 1)

local one = expr.one
local function e(s) return expr.lift(s) end

local symbols = {
  m = { one, dim(1) }, km = { e(1000), dim(1) }, cm = { e "1/100", dim(1) }, mm = { e "1/1000", dim(1) },
  um = { e "1e-6", dim(1) }, nm = { e "1e-9", dim(1) }, pm = { e "1e-12", dim(1) },
  angstrom = { e "1e-10", dim(1) },
  ["in"] = { e "0.0254", dim(1) }, ft = { e "0.3048", dim(1) }, au = { e "149597870700", dim(1) },
  kg = { one, dim(0, 1) }, g = { e "1/1000", dim(0, 1) }, mg = { e "1e-6", dim(0, 1) }, t = { e(1000), dim(0, 1) },
  lb = { e "0.45359237", dim(0, 1) }, oz = { e "0.45359237" / 16, dim(0, 1) },
  slug = { e "0.45359237" * e "9.80665" / e "0.3048", dim(0, 1) }, u = { e "1.66053906660e-27", dim(0, 1) },
  s = { one, dim(0, 0, 1) }, ms = { e "1/1000", dim(0, 0, 1) }, min = { e(60), dim(0, 0, 1) },
  h = { e(3600), dim(0, 0, 1) }, day = { e(86400), dim(0, 0, 1) },
  A = { one, dim(0, 0, 0, 1) }, mA = { e "1/1000", dim(0, 0, 0, 1) }, K = { one, dim(0, 0, 0, 0, 1) },
  rad = { one, units.none }, deg = { expr.pi / 180, units.none }, rev = { expr.pi * 2, units.none },
  Hz = { one, dim(0, 0, -1) }, rpm = { expr.pi / 30, dim(0, 0, -1) },
  N = { one, dim(1, 1, -2) },
  uN = { e "1e-6", dim(1, 1, -2) }, mN = { e "1/1000", dim(1, 1, -2) }, kN = { e(1000), dim(1, 1, -2) },
  lbf = { e "0.45359237" * e "9.80665", dim(1, 1, -2) },
  J = { one, dim(2, 1, -2) }, W = { one, dim(2, 1, -3) }, Pa = { one, dim(-1, 1, -2) },
  T = { one, dim(0, 1, -2, -1) }, mT = { e "1/1000", dim(0, 1, -2, -1) }, uT = { e "1e-6", dim(0, 1, -2, -1) },
  nT = { e "1e-9", dim(0, 1, -2, -1) }, ["1"] = { one, units.none },
}

-- Names and what they stand for, sorted: for `polhode list constants`.
units.list = {}
do
  local names = {}
  for name in pairs(symbols) do names[#names + 1] = name end
  table.sort(names)
  for _, name in ipairs(names) do
    local factor = text.of(symbols[name][1], "plain")
    if name ~= "1" then units.list[#units.list + 1] = { name, factor, symbols[name][2] } end
  end
end

-- Dimension arithmetic.
function units.times(a, b)
  local c = {}
  for i = 1, 5 do c[i] = a[i] + b[i] end
  return c
end

function units.power(a, n)
  local c = {}
  for i = 1, 5 do c[i] = a[i] * n end
  return c
end

function units.equal(a, b)
  for i = 1, 5 do
    if a[i] ~= b[i] then return false end
  end
  return true
end

-- "kg m^2/s" for a dimension; "a pure number" for none.
function units.name(a)
  local top, bottom = {}, {}
  for _, i in ipairs { 2, 1, 3, 4, 5 } do
    local x = a[i]
    if R.sign(x) ~= 0 then
      local n = R.abs(x)
      local s = base[i] .. (n == R.one and "" or "^" .. tostring(n))
      local list = R.sign(x) > 0 and top or bottom
      list[#list + 1] = s
    end
  end
  if #top == 0 and #bottom == 0 then return "a pure number" end
  local n = #top > 0 and table.concat(top, " ") or "1"
  return #bottom > 0 and n .. "/" .. table.concat(bottom, "/") or n
end

-- The SI unit that belongs to a dimension, for comments: "kg m^2", "1" for none.
function units.si(a)
  local s = units.name(a)
  return s == "a pure number" and "1" or s
end

for _, u in ipairs(units.list) do u[2] = "unit: " .. u[2] .. " " .. units.si(u[3]) end

-- Reads "kg m^2/s", "rad/s", "slug ft^2": factors split by blanks or *, each / divides by the next one factor.  No unit
-- ends in a digit, so one behind it is an exponent: "kg m2", "g/cm3"; signs of Unicode are unitnames.plain's.
-- Returns the exact factor to SI and the dimension, or nil and a phrase.
function units.parse(s)
  local factor, d, sign = one, units.none, 1
  local rest = unitnames.plain(s)
  while string.find(rest, "%S") do
    local op, tail = string.match(rest, "^%s*([*/])%s*(.*)$")
    if op then
      sign = op == "/" and -1 or 1
      rest = tail
    end
    local name, after = string.match(rest, "^%s*([%a1]%a*)(.*)$")
    local unit = name and symbols[name]
    if not unit then
      local meant = unitnames.meant(name or rest, symbols)
      return nil, "unknown unit " .. string.format("%q", name or rest) ..
        (meant and " (write \"" .. meant .. "\")" or "")
    end
    local n, more = string.match(after, "^%^(%-?%d+)(.*)$")
    if not n and name ~= "1" then n, more = string.match(after, "^(%d+)(.*)$") end
    local power = R.parse(n or "1") * sign
    if R.abs(power) > R.new(20) then return nil, "an exponent in " .. string.format("%q", s) .. " is too large" end
    factor = factor * expr.pow(unit[1], power)
    d = units.times(d, units.power(unit[2], power))
    rest, sign = more or after, 1
  end
  return factor, d
end

-- The dimension of that name ("torque"), or of a unit ("m^4/ohm").
function units.of(name)
  if units[name] then return units[name] end
  local factor, d = units.parse(name)
  return factor and d or error(d)
end

return units
