-- values.lua -- what a textbook computes of the motion from the initial state: energy, rates, periods, angles.
--
-- Free bodies: Landau and Lifshitz, Mechanics, sections 33 and 37, with periods and turns of dynamics/free_top.lua.
-- The heavy symmetric top: dynamics/heavy_top.lua.  Bodies on a plane: touch.lua.
-- All from the exact initial state with 128 bits and more, rounded once: what cancels costs no digit.  Nine are
-- written.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"
local contact = require "generator.dynamics.contact"
local free_top = require "generator.dynamics.free_top"
local heavy_top = require "generator.dynamics.heavy_top"
local json = require "generator.report.json"
local touch = require "generator.report.touch"

local values = {}

local flips = 3 -- the next ones that are listed

local bits = 128
local two = R.new(2)

local function root(x) return R.sign(x) > 0 and R.apply("sqrt", bits, x) or R.zero end
local function length(v) return root(vec.dot(v, v)) end
local function pi() return R.apply("pi", bits) end
local function degrees(x) return R.new(180) * x / pi() end

local function angle(a, b) return degrees(R.apply("atan2", bits, length(vec.cross(a, b)), vec.dot(a, b))) end

-- A list of rows {key, what it is, formula, formula for LaTeX, number, unit}; number: nil where there is none, as of an
-- infinite period.
local function collector()
  local list = {}
  return list, function(key, what, formula, latex, number, unit)
    if R.is(number) then number = R.todouble(number) end
    if number and number - number == 0 then
      list[#list + 1] = { key = key, what = what, formula = formula, latex = latex, number = number, unit = unit }
    end
  end
end

-- 2 pi/|rate|, nil where nothing turns
local function period(rate) return R.sign(rate) ~= 0 and two * pi() / R.abs(rate) or nil end

-- ---- free bodies ----

-- k is taken on the side of L, so w3 is not negative.
local function symmetric(f, put, w, L)
  local s, m = f.structure, f.job.model
  local k = vec.map(s.k, function(e) return m:number(e) end)
  k = vec.scale(R.one / length(k), k)
  if R.sign(vec.dot(k, L)) < 0 then k = vec.scale(-R.one, k) end
  local I1, I3, w3 = m:number(s.alpha), m:number(s.axial), vec.dot(k, w)
  local wobble, precession = (I3 - I1) / I1 * w3, length(L) / I1
  put("precession_rate", "of the axis about L", "|L|/I1", "|L|/I_1", precession, "rad/s")
  put("precession_period", "", "2 pi I1/|L|", "2\\pi I_1/|L|", period(precession), "s")
  if s.rod then return end
  put("wobble_rate", "of w about the axis, in the body", "(I3 - I1)/I1 w3", "(I_3 - I_1)\\omega_3/I_1", wobble,
    "rad/s")
  put("wobble_period", "", "2 pi/|wobble_rate|", "2\\pi/|\\Omega|", period(wobble), "s")
  put("axis_to_L", "between the axis and L", "atan(I1 w_across/(I3 w3))", "\\arctan(I_1\\omega_\\perp/(I_3\\omega_3))",
    angle(k, L), "deg")
  put("body_cone", "half angle of the cone of w in the body", "atan(w_across/w3)", "\\arctan(\\omega_\\perp/\\omega_3)",
    angle(k, w), "deg")
  put("space_cone", "half angle of the cone of w in space", "|axis_to_L - body_cone|", "|\\theta - \\alpha|",
    angle(L, w), "deg")
end

local function asymmetric(f, put)
  local m = f.job.model
  local x0 = { R.one, R.zero, R.zero, R.zero }
  for i = 1, 3 do x0[4 + i] = m:number(m.omega[i]) end
  local top = free_top.new(vec.map(m.inertia, function(e) return m:number(e) end), x0, bits, two ^ -49)
  if not top then return end
  local function double(x) return R.todouble(R.round(x, 53)) end
  if top.constant then
    put("revolution_period", "w is constant", "2 pi/|w|", "2\\pi/|\\omega|", double(two * top.pi / top.b[3]), "s")
    return
  end
  put("modulus", "of Jacobi's functions; 1 on the separatrix", "k", "k", double(top.k), "1")
  local rate = top.separatrix and R.zero or top.hyperbolic and top.rate / (two * top.period) or top.rate / two
  if not top.separatrix then
    put("polhode_period", "w comes back", "4 K(k)/lambda", "4K(k)/\\lambda", 1 / double(rate), "s")
  end
  local mean = top.turn - (top.hyperbolic and not top.separatrix and two * top.jump * rate or R.zero)
  local turns = double(two * mean + R.new(top.s) * rate)
  put("precession_rate", "about L, on average", "mean of L (2T - I w_a^2)/(L^2 - I^2 w_a^2)",
    "\\langle\\dot\\varphi\\rangle", 2 * math.pi * turns, "rad/s")
  put("precession_period", "", "2 pi/precession_rate", "2\\pi/\\langle\\dot\\varphi\\rangle", 1 / turns, "s")
  local n = top.separatrix and R.zero or R.floor(top.u0 / (two * top.K)) + R.one
  for i = 1, top.separatrix and 1 or flips do
    local t = ((top.separatrix and R.zero or two * top.K * n) - top.u0) / top.lambda
    if R.sign(t) > 0 then
      put("flip_" .. string.format("%d", i), "w along the middle axis changes its sign", i == 1 and "next" or "then",
        "t_" .. string.format("%d", i), double(t), "s")
    end
    n = n + R.one
  end
end

-- ---- the heavy symmetric top ----

local function heavy(f, put)
  local m, s = f.job.model, f.structure
  local function numbers(v) return vec.map(v, function(e) return m:number(e) end) end
  local gravity
  for _, e in ipairs(m.record.effects) do gravity = e.kind == "effect.gravity" and e.a or gravity end
  local arm, I1 = numbers(m.com), m:number(s.alpha)
  local weight = m:number(m.mass) * m:number(gravity.g) * length(arm)
  if R.sign(weight) <= 0 then return end
  local up = vec.matvec(vec.transpose(vec.rotation(numbers(m.attitude))), numbers(gravity.direction))
  local I3 = s.kind == "sphere" and I1 or s.rod and R.zero or m:number(s.axial)
  local top = heavy_top.of { I1 = I1, I3 = I3, weight = weight, arm = arm, up = vec.scale(-R.one, up),
    w = numbers(m.omega) }
  local spin, precession = R.abs(top.s), top.precession
  put("weight_moment", "", "M g l", "Mgl", weight, "N m")
  put("L_vertical", "conserved", "L.up", "L_z", I1 * top.l, "N m s")
  put("L_axial", "conserved", "I3 w3", "I_3\\omega_3", I1 * top.s, "N m s")
  put("tilt_least", "between the axis and the vertical", "acos u2", "\\arccos u_2", degrees(top.tilt[1]), "deg")
  put("tilt_greatest", "", "acos u1", "\\arccos u_1", degrees(top.tilt[2]), "deg")
  put("nutation_period", "of the tilt", "2 K(k)/lambda", "2K(k)/\\lambda", top.period, "s")
  put("precession_rate", "about the vertical, on average", "mean of (L.up - L3 u)/(I1 (1 - u^2))",
    "\\langle\\dot\\varphi\\rangle", precession, "rad/s")
  put("precession_period", "", "2 pi/|precession_rate|", "2\\pi/|\\langle\\dot\\varphi\\rangle|",
    precession and period(precession), "s")
  if R.sign(spin) ~= 0 then
    put("fast_precession_rate", "what it tends to for a fast spin", "M g l/(I3 w3)", "Mgl/(I_3\\omega_3)",
      weight / (I1 * top.s), "rad/s")
  end
  put("fast_nutation_rate", "so, too", "I3 w3/I1", "I_3\\omega_3/I_1", spin, "rad/s")
  put("sleeping", "above 1 the upright top is stable", "(I3 w3)^2/(4 I1 M g l)", "(I_3\\omega_3)^2/(4I_1Mgl)",
    I1 * spin * spin / (R.new(4) * weight), "1")
end

-- ---- for explain.lua ----

-- The rows of a scene; empty where nothing turns.
function values.of(f)
  local m = f.job.model
  local list, put = collector()
  if not m.has.rates then return list end
  local function numbers(v) return vec.map(v, function(e) return m:number(e) end) end
  local w = numbers(m.omega)
  local L = vec.apply(numbers(m.inertia), w)
  put("rate", "", "|w|", "|\\omega|", length(w), "rad/s")
  put("T", "kinetic energy of the rotation", "w.I w/2", "\\tfrac12\\,\\omega\\cdot I\\omega", vec.dot(w, L) / two, "J")
  put("momentum", "", "|L| = |I w|", "|L| = |I\\omega|", length(L), "N m s")
  local rests = R.sign(vec.dot(L, L)) == 0
  if not rests then
    put("w_to_L", "between w and L", "atan(|w x L|/w.L)", "\\angle(\\omega, L)", angle(w, L), "deg")
  end
  if f.closed.kind == "lagrange" then heavy(f, put) end
  if #m.record.effects == 0 and not rests then
    if f.structure.kind == "symmetric" then symmetric(f, put, w, L) else asymmetric(f, put) end
  end
  if contact.of(m) then touch.rows(f.job, put) end
  return list
end

local function number(x) return json.number(tonumber(string.format("%.9g", x))) end

function values.lines(f)
  local lines = {}
  for i, v in ipairs(values.of(f)) do
    local unit = v.unit ~= "1" and " " .. v.unit or ""
    local tex = v.unit ~= "1" and "\\,\\mathrm{" .. string.gsub(v.unit, " ", "\\,") .. "}" or ""
    local what = v.what ~= "" and " (" .. v.what .. ")" or ""
    local name = string.gsub(v.key, "_", " ")
    lines[i] = { text = name .. ": " .. v.formula .. " = " .. number(v.number) .. unit .. what,
      latex = name .. ": \\( " .. v.latex .. " = " .. number(v.number) .. tex .. " \\)" .. what }
  end
  if #lines > 0 and #f.job.record.effects > 0 then
    table.insert(lines, 1, { text = "at t = 0; T and L are those of the body's own rotation",
      latex = "at \\( t = 0 \\); \\( T \\) and \\( L \\) are those of the body's own rotation" })
  end
  return lines
end

-- For --format json: an object by keys, each {value, unit, formula}.
function values.json(f)
  local entries = {}
  for i, v in ipairs(values.of(f)) do
    entries[i] = { v.key, json.object { { "value", v.number }, { "unit", v.unit }, { "formula", v.formula } } }
  end
  return json.object(entries)
end

return values
