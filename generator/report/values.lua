-- values.lua -- what a textbook computes of the motion from the initial state: energy, rates, periods, angles.
--
-- Free bodies: Landau and Lifshitz, Mechanics, sections 33 and 37, with periods and turns of dynamics/free_top.lua.
-- The heavy symmetric top: dynamics/heavy_top.lua.  Bodies on a plane: touch.lua.
-- All from the exact initial state with 128 bits and more, rounded once: what cancels costs no digit.  Nine are
-- written.  Axes 1, 2, 3 are those of report/order.lua.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"
local contact = require "generator.dynamics.contact"
local heavy_top = require "generator.dynamics.heavy_top"
local linear = require "generator.formula.linear"
local read = require "generator.formula.read"
local setting = require "generator.formula.setting"
local json = require "generator.report.json"
local order = require "generator.report.order"
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

-- A list of rows {key, symbol, formula, what, number, unit}; symbol and formula in the notation of formula/read.lua,
-- formula: nil where there is none in a line.  number: nil where there is none, as of an infinite period.
local function collector()
  local list = {}
  return list, function(key, symbol, formula, what, number, unit)
    if R.is(number) then number = R.todouble(number) end
    if number and number - number == 0 then
      list[#list + 1] = { key = key, symbol = symbol, formula = formula, what = what, number = number, unit = unit }
    end
  end
end

-- 2 pi/|rate|, nil where nothing turns
local function period(rate) return R.sign(rate) ~= 0 and two * pi() / R.abs(rate) or nil end

-- ---- free bodies ----

-- k is taken on the side of w, so w3 is not negative.
local function symmetric(f, put, w, L)
  local s, m = f.structure, f.job.model
  local k = vec.map(s.k, function(e) return m:number(e) end)
  k = vec.scale(R.one / length(k), k)
  if R.sign(vec.dot(k, w)) < 0 then k = vec.scale(-R.one, k) end
  local I1, I3, w3 = m:number(s.alpha), m:number(s.axial), vec.dot(k, w)
  local across = length(vec.cross(k, w))
  put("spin", "omega_3", "~omega . ~e_3", "spin about the axis of symmetry", w3, "rad/s")
  put("across", "A", "|~omega x ~e_3|", "angular velocity across this axis", across, "rad/s")
  if not s.rod then
    local e = vec.map(order.of(f), function(n) return f.axes[n] end)
    local v = vec.map(w, R.todouble)
    put("phase", "psi_0", "atan2(~omega . ~e_2 , ~omega . ~e_1)", "phase of its part across the axis",
      math.atan(vec.dot(v, e[2]), vec.dot(v, e[1])), "rad")
  end
  put("precession_rate", "phi'", "{L|I_1}", "precession: of the axis about L, in space", length(L) / I1, "rad/s")
  put("precession_period", "tau_p", "{2 pi|phi'}", "its period", period(length(L) / I1), "s")
  if s.rod then return end
  local wobble = (I3 - I1) / I1 * w3
  put("wobble_rate", "Omega", "{I_3 - I_1|I_1} omega_3", "of the angular velocity about the axis, in the body", wobble,
    "rad/s")
  put("wobble_period", "tau_w", "{2 pi||Omega|}", "its period", period(wobble), "s")
  put("axis_to_L", "theta", "atan({I_1 A|I_3 omega_3})", "angle between the axis and L", angle(k, L), "deg")
  put("body_cone", "alpha", "atan({A|omega_3})", "half angle of the cone of the angular velocity in the body",
    angle(k, w), "deg")
  put("space_cone", "beta", "|theta - alpha|", "half angle of its cone in space", angle(L, w), "deg")
end

-- Landau and Lifshitz, (37.8) to (37.12): `own` has cn, `middle` sn, `round` dn, about which L goes round.
local function elliptic_rows(top, put, double)
  local own, round = top.s > 0 and "1" or "3", top.s > 0 and "3" or "1"
  local function f(text)
    return (string.gsub(string.gsub(text, "_a", "_" .. own), "_c", "_" .. round))
  end
  -- 2 T I_c - L^2 and the other differences have one sign, that of s
  local function difference(a, b) return top.s > 0 and a .. " - " .. b or b .. " - " .. a end
  local far, near = f(difference("2 T I_c", "L^2")), f(difference("L^2", "2 T I_a"))
  local ca, c2, two_a = f(difference("I_c", "I_a")), f(difference("I_c", "I_2")), f(difference("I_2", "I_a"))
  put("modulus", "k", f("sqrt({( " .. two_a .. " ) ( " .. far .. " )|( " .. c2 .. " ) ( " .. near .. " )})"),
    "modulus of Jacobi's functions; 1 on the separatrix", double(top.k), "1")
  put("argument_rate", "lambda", f("sqrt({( " .. c2 .. " ) ( " .. near .. " )|I_1 I_2 I_3})"),
    "rate of their argument", double(top.lambda), "rad/s")
  local amplitudes = { [own] = { f("sqrt({I_a ( " .. far .. " )|" .. ca .. "})"), 1 },
    ["2"] = { f("sqrt({I_2 ( " .. far .. " )|" .. c2 .. "})"), 2 },
    [round] = { f("sqrt({I_c ( " .. near .. " )|" .. ca .. "})"), 3 } }
  for _, n in ipairs { "1", "2", "3" } do
    local at = amplitudes[n][2]
    put("amplitude_" .. n, "B_" .. n, amplitudes[n][1], "amplitude of L along axis " .. n,
      double(top.I[at] * top.b[at]), "N m s")
  end
  put("initial_argument", "t_0", nil, "when the middle component is 0 and the one with cn is greatest",
    double(-top.u0 / top.lambda), "s")
end

local function asymmetric(f, put)
  local top = order.motion(f)
  if not top then return end
  local function double(x) return R.todouble(R.round(x, 53)) end
  if top.constant then
    put("revolution_period", "tau", "{2 pi|omega}", "period of the turn: the angular velocity is constant",
      double(two * top.pi / top.b[3]), "s")
    return
  end
  elliptic_rows(top, put, double)
  local rate = top.separatrix and R.zero or top.hyperbolic and top.rate / (two * top.period) or top.rate / two
  if not top.separatrix then
    put("polhode_period", "tau_1", "{4 K(k)|lambda}", "after which the angular velocity comes back", 1 / double(rate),
      "s")
  end
  local mean = top.turn - (top.hyperbolic and not top.separatrix and two * top.jump * rate or R.zero)
  local turns = double(two * mean + R.new(top.s) * rate)
  local c = top.s > 0 and "3" or "1"
  put("precession_rate", "phi'", string.gsub("mean({L ( 2 T - I_c omega_c^2 )|L^2 - I_c^2 omega_c^2})", "_c", "_" .. c),
    "precession about L, on average", 2 * math.pi * turns, "rad/s")
  put("precession_period", "tau_p", "{2 pi|phi'}", "its period", 1 / turns, "s")
  local n = top.separatrix and R.zero or R.floor(top.u0 / (two * top.K)) + R.one
  for i = 1, top.separatrix and 1 or flips do
    local t = ((top.separatrix and R.zero or two * top.K * n) - top.u0) / top.lambda
    local number = string.format("%d", i)
    if R.sign(t) > 0 then
      put("flip_" .. number, "t_" .. number, nil, (i == 1 and "next" or "then") ..
        ": the rate about the middle axis changes its sign", double(t), "s")
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
  put("weight_moment", "G", "M g |~R|", "moment of the weight about the fixed point", weight, "N m")
  put("L_vertical", "L_v", nil, "vertical component of L, conserved", I1 * top.l, "N m s")
  put("L_axial", "L_3", "I_3 omega_3", "L along the axis, conserved", I1 * top.s, "N m s")
  put("tilt_least", "theta_min", nil, "least tilt between the axis and the vertical", degrees(top.tilt[1]), "deg")
  put("tilt_greatest", "theta_max", nil, "greatest tilt", degrees(top.tilt[2]), "deg")
  put("nutation_period", "tau_n", "{2 K(k)|lambda}", "period of the tilt", top.period, "s")
  put("precession_rate", "phi'", "mean({L_v - L_3 cos(theta)|I_1 sin^2(theta)})",
    "precession about the vertical, on average", precession, "rad/s")
  put("precession_period", "tau_p", "{2 pi||phi'|}", "its period", precession and period(precession), "s")
  if R.sign(spin) ~= 0 then
    put("fast_precession_rate", "phi_fast'", "{G|L_3}", "what it tends to for a fast spin", weight / (I1 * top.s),
      "rad/s")
  end
  put("fast_nutation_rate", "Omega_fast", "{|L_3||I_1}", "rate of the nutation of a fast spin", spin, "rad/s")
  if R.sign(I3) > 0 then
    put("critical_spin", "omega_crit", "{2 sqrt(I_1 G)|I_3}", "upright, the top sleeps: it is stable above this spin",
      two * root(I1 * weight) / I3, "rad/s")
  end
  put("sleeping", "sigma", "{L_3^2|4 I_1 G}", "above 1 the upright top is stable",
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
  put("rate", "omega", "|~omega|", "size of the angular velocity", length(w), "rad/s")
  put("T", "T", "{~omega . I ~omega|2}", "kinetic energy of the rotation", vec.dot(w, L) / two, "J")
  put("momentum", "L", "|I ~omega|", "size of the angular momentum", length(L), "N m s")
  local rests = R.sign(vec.dot(L, L)) == 0
  if not rests then
    put("w_to_L", "gamma", "atan({|~omega x ~L||~omega . ~L})", "angle between the angular velocity and L", angle(w, L),
      "deg")
  end
  if f.closed.kind == "lagrange" then heavy(f, put) end
  if #m.record.effects == 0 and not rests then
    if f.structure.kind == "symmetric" then symmetric(f, put, w, L) else asymmetric(f, put) end
  end
  if contact.of(m) then touch.rows(f.job, put) end
  return list
end

local function number(x) return json.number(tonumber(string.format("%.9g", x))) end

local function plain(notation, names)
  return notation and setting.of(linear.ascii, read.of(notation, names))
end

-- Lines of text; names: the reader of the document's symbols.
function values.lines(f, names)
  local lines = {}
  for i, v in ipairs(values.of(f)) do
    local unit = v.unit ~= "1" and " " .. v.unit or ""
    local sides = { plain(v.symbol, names), plain(v.formula, names) }
    sides[#sides + 1] = number(v.number) .. unit
    lines[i] = string.gsub(v.key, "_", " ") .. ": " .. table.concat(sides, " = ") .. " (" .. v.what .. ")"
  end
  if #lines > 0 and #f.job.record.effects > 0 then
    table.insert(lines, 1, "at t = 0; T and L are those of the body's own rotation")
  end
  return lines
end

-- For --format json: an object by keys, each {value, unit, symbol, formula}; formula: "" where there is none.
function values.json(f)
  local entries = {}
  for i, v in ipairs(values.of(f)) do
    entries[i] = { v.key, json.object { { "value", v.number }, { "unit", v.unit }, { "symbol", plain(v.symbol) },
      { "formula", plain(v.formula) or "" } } }
  end
  return json.object(entries)
end

return values
