-- values.lua -- what a textbook computes of the motion from the initial state: energy, rates, periods, angles.
--
-- Free bodies: Landau and Lifshitz, Mechanics, sections 33 and 37, with the periods and turns of the closed form
-- (dynamics/free_top.lua, 128 bits).  The heavy symmetric top: Goldstein, section 5.7: the tilt's cosine u runs between
-- two roots of a cubic, u = u1 + (u2 - u1) sn^2.  Nine digits are written: those that doubles leave at any modulus.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"
local contact = require "generator.dynamics.contact"
local free_top = require "generator.dynamics.free_top"
local json = require "generator.report.json"
local touch = require "generator.report.touch"

local values = {}

local flips = 3 -- the next ones that are listed

local function length(v) return math.sqrt(vec.dot(v, v)) end

local function angle(a, b) return math.atan(length(vec.cross(a, b)), vec.dot(a, b)) end

-- A list of rows {key, what it is, formula, formula for LaTeX, number, unit}; infinite periods are left out.
local function collector()
  local list = {}
  return list, function(key, what, formula, latex, number, unit)
    if number and number - number == 0 then
      list[#list + 1] = { key = key, what = what, formula = formula, latex = latex, number = number, unit = unit }
    end
  end
end

-- ---- free bodies ----

-- k is taken on the side of L, so w3 is not negative.
local function symmetric(f, put, w, L)
  local s, m = f.structure, f.job.model
  local k = vec.map(s.k, function(e) return m:double(e) end)
  k = vec.scale(1 / length(k), k)
  if vec.dot(k, L) < 0 then k = vec.scale(-1, k) end
  local I1, I3, w3 = m:double(s.alpha), m:double(s.axial), vec.dot(k, w)
  local wobble = (I3 - I1) / I1 * w3
  put("precession_rate", "of the axis about L", "|L|/I1", "|L|/I_1", length(L) / I1, "rad/s")
  put("precession_period", "", "2 pi I1/|L|", "2\\pi I_1/|L|", 2 * math.pi * I1 / length(L), "s")
  if s.rod then return end
  put("wobble_rate", "of w about the axis, in the body", "(I3 - I1)/I1 w3", "(I_3 - I_1)\\omega_3/I_1", wobble,
    "rad/s")
  put("wobble_period", "", "2 pi/|wobble_rate|", "2\\pi/|\\Omega|", 2 * math.pi / math.abs(wobble), "s")
  put("axis_to_L", "between the axis and L", "atan(I1 w_across/(I3 w3))", "\\arctan(I_1\\omega_\\perp/(I_3\\omega_3))",
    math.deg(angle(k, L)), "deg")
  put("body_cone", "half angle of the cone of w in the body", "atan(w_across/w3)", "\\arctan(\\omega_\\perp/\\omega_3)",
    math.deg(angle(k, w)), "deg")
  put("space_cone", "half angle of the cone of w in space", "|axis_to_L - body_cone|", "|\\theta - \\alpha|",
    math.deg(angle(L, w)), "deg")
end

local function asymmetric(f, put)
  local m, two = f.job.model, R.new(2)
  local x0 = { R.one, R.zero, R.zero, R.zero }
  for i = 1, 3 do x0[4 + i] = m:number(m.omega[i]) end
  local top = free_top.new(vec.map(m.inertia, function(e) return m:number(e) end), x0, 128, two ^ -49)
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

-- The real roots of u^3 - s u^2 + e u - p, ascending, when there are three: by cosines of thirds of an angle (Viete).
local function cubic(s, e, p)
  local third = s / 3
  local P, Q = e - s * third, -p + e * third - 2 * third ^ 3
  local size = 2 * math.sqrt(math.max(0.0, -P / 3))
  if size == 0 then return { third, third, third } end
  local phi = math.acos(math.max(-1.0, math.min(1.0, 3 * Q / (P * size)))) / 3
  local list = {}
  for n = 0, 2 do list[n + 1] = third + size * math.cos(phi - 2 * math.pi * n / 3) end
  table.sort(list)
  return list
end

local function complete(k2) -- K by the arithmetic-geometric mean
  local a, b = 1.0, math.sqrt(math.max(0.0, 1 - k2))
  if b == 0 then return math.huge end
  for _ = 1, 40 do a, b = (a + b) / 2, math.sqrt(a * b) end
  return math.pi / (2 * a)
end

-- The mean of g(u) over a nutation, or nil where sums of up to 2^15 points do not settle it.  u = u1 + (u2 - u1) s^2
-- with s = sn, the sine of the amplitude: over the amplitude the integrand is periodic and analytic, so the trapezoidal
-- rule gains digits in proportion to its points.
local function mean(g, u, k2, K)
  local before
  for bits = 5, 15 do
    local n, sum = 1 << bits, 0.0
    for i = 0, n do
      local s = math.sin(math.pi / 2 * i / n) ^ 2
      sum = sum + (i % n == 0 and 0.5 or 1) * g(u[1] + (u[2] - u[1]) * s) / math.sqrt(1 - k2 * s)
    end
    local now = sum * math.pi / 2 / n / K
    if before and math.abs(now - before) <= 1e-12 * math.abs(now) then return now end
    before = now
  end
  return nil
end

-- u'^2 = (1 - u^2)(alpha - beta u) - (b - a u)^2
-- with beta = 2 M g l/I1, a = L3/I1, b = Lz/I1, alpha = (2 E - L3^2/I3)/I1.
local function heavy(f, put, w, L)
  local m, s = f.job.model, f.structure
  local effect
  for _, e in ipairs(m.record.effects) do effect = e.kind == "effect.gravity" and e or effect end
  local arm = f.arm_number
  local I1 = m:double(s.alpha)
  local Mgl = f.mass_number * m:double(effect.a.g) * length(arm)
  if Mgl <= 0 then return end
  local k = vec.scale(1 / length(arm), arm) -- the axis, towards the centre of mass
  local direction = vec.map(effect.a.direction, function(e) return m:double(e) end)
  local q = vec.map(m.attitude, function(e) return m:double(e) end)
  local up = vec.matvec(vec.transpose(vec.rotation(q)), vec.scale(-1 / length(direction), direction))
  local u0, L3, Lz = vec.dot(k, up), vec.dot(k, L), vec.dot(up, L)
  local across = vec.sub(w, vec.scale(vec.dot(k, w), k))
  local beta, a, b = 2 * Mgl / I1, L3 / I1, Lz / I1
  local alpha = vec.dot(across, across) + beta * u0
  local u = cubic((alpha + a * a) / beta, (2 * a * b - beta) / beta, (b * b - alpha) / beta)
  u[1], u[2] = math.max(-1.0, u[1]), math.min(1.0, u[2])
  local k2 = (u[2] - u[1]) / (u[3] - u[1])
  local K, lambda = complete(k2), math.sqrt(beta * (u[3] - u[1])) / 2
  put("weight_moment", "", "M g l", "Mgl", Mgl, "N m")
  put("L_vertical", "conserved", "L.up", "L_z", Lz, "N m s")
  put("L_axial", "conserved", "I3 w3", "I_3\\omega_3", L3, "N m s")
  put("tilt_least", "between the axis and the vertical", "acos u2", "\\arccos u_2", math.deg(math.acos(u[2])), "deg")
  put("tilt_greatest", "", "acos u1", "\\arccos u_1", math.deg(math.acos(u[1])), "deg")
  put("nutation_period", "of the tilt", "2 K(k)/lambda", "2K(k)/\\lambda", 2 * K / lambda, "s")
  local rate = K < math.huge and mean(function(x) return (b - a * x) / (1 - x * x) end, u, k2, K)
  put("precession_rate", "about the vertical, on average", "mean of (L.up - L3 u)/(I1 (1 - u^2))",
    "\\langle\\dot\\varphi\\rangle", rate or nil, "rad/s")
  put("precession_period", "", "2 pi/|precession_rate|", "2\\pi/|\\langle\\dot\\varphi\\rangle|",
    rate and 2 * math.pi / math.abs(rate), "s")
  put("fast_precession_rate", "what it tends to for a fast spin", "M g l/(I3 w3)", "Mgl/(I_3\\omega_3)", Mgl / L3,
    "rad/s")
  put("fast_nutation_rate", "so, too", "I3 w3/I1", "I_3\\omega_3/I_1", math.abs(L3) / I1, "rad/s")
  put("sleeping", "above 1 the upright top is stable", "(I3 w3)^2/(4 I1 M g l)", "(I_3\\omega_3)^2/(4I_1Mgl)",
    L3 * L3 / (4 * I1 * Mgl), "1")
end

-- ---- for explain.lua ----

-- The rows of a scene; empty where nothing turns.
function values.of(f)
  local m = f.job.model
  local list, put = collector()
  if not m.has.rates then return list end
  local w, I = vec.map(m.omega, function(e) return m:double(e) end), f.inertia_number
  local L = vec.apply(I, w)
  put("rate", "", "|w|", "|\\omega|", length(w), "rad/s")
  put("T", "kinetic energy of the rotation", "w.I w/2", "\\tfrac12\\,\\omega\\cdot I\\omega", vec.dot(w, L) / 2, "J")
  put("momentum", "", "|L| = |I w|", "|L| = |I\\omega|", length(L), "N m s")
  if contact.of(m) and length(L) == 0 then touch.rows(f.job, put) end
  if length(L) == 0 then return list end
  put("w_to_L", "between w and L", "atan(|w x L|/w.L)", "\\angle(\\omega, L)", math.deg(angle(w, L)), "deg")
  if #m.record.effects == 0 then
    if f.structure.kind == "symmetric" then symmetric(f, put, w, L) else asymmetric(f, put) end
  elseif f.closed.kind == "lagrange" then
    heavy(f, put, w, L)
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
