-- touch.lua -- of a body on a plane: integrals at the start, closed forms of balls, critical speeds; discs: disc.lua.
--
-- G is the gravity; the critical speeds are those of dynamics/upright.lua.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local vec = require "generator.algebra.vec"
local contact = require "generator.dynamics.contact"
local state = require "generator.dynamics.state"
local steady = require "generator.dynamics.steady"
local touch_laws = require "generator.dynamics.touch_laws"
local upright = require "generator.dynamics.upright"
local disc = require "generator.report.disc"

local touch = {}

local bits = 128

local function integrals(m, put)
  local start = { [state.t] = expr.zero }
  for _, s in ipairs(m.states) do start[s.sym] = s.initial end
  for _, law in ipairs(touch_laws.of(m)) do
    put(law.key, law.symbol, law.formula, law.what, m:double(calculus.substitute(law.e, start)), law.unit)
  end
end

-- The critical rates by the law of the contact.
local formulas = {
  smooth = "{2 sqrt(I_1 M g ( h - rho ))|I_3}",
  rolling = "{2 sqrt(( I_1 + M h^2 ) M g ( h - rho ))|I_3 + M h rho}",
  sliding = "sqrt({M g ( h - rho ) h|rho ( I_3 - {I_1 rho|h} )})",
  straight = "sqrt({M g R I_1|I_3 ( I_3 + M ( R + rho )^2 )})",
  edge = "sqrt({M g R|I_1 + M ( R + rho )^2})",
}

-- What the rate of an upright spin must be, a rate^2 > c: its least or greatest one, 0 where any will do, or none.
local function critical(m, law, put)
  for _, u in ipairs(upright.of(m)) do
    local a, c = m:double(u.a), m:double(u.c)
    local rate, slides = a ~= 0 and c / a > 0 and math.sqrt(c / a) or 0.0, law == "sliding"
    local key, name = u.key, "above"
    local what = slides and "friction damps it " or "stable "
    if a > 0 or a == 0 and c < 0 then
      what = what .. (c > 0 and "above this rate" or "at every rate")
    elseif c < 0 then
      name, what = "below", "friction damps it below this rate, and turns it over above"
    else
      name, what = "below", "friction turns it over at every rate"
    end
    if key == "straight" then
      put("rolling_straight_above", "omega_straight", formulas.straight,
        "upright and rolling straight: stable above this spin", rate, "rad/s")
    elseif key == "edge" then
      put("spinning_on_edge_above", "omega_edge", formulas.edge,
        "upright and spinning about the normal: stable above this rate", rate, "rad/s")
    else
      put("upright_z_" .. key .. "_" .. name, "omega_" .. key .. "ward", formulas[law],
        "spinning upright with z " .. key .. ": " .. what, rate, "rad/s")
    end
  end
end

local function ball(m, f, put, a, mass, G)
  local J, rate = m:double(f.I1), m:double(a.rate)
  local carried = mass * m:double(f.surface.rim) ^ 2
  local k, rest = J / (J + carried), carried / (J + carried) -- rest = 1 - k
  local along = vec.cross(G, vec.map(a.normal, function(e) return m:double(e) end)) -- as long as G along the plane
  local slope = math.sqrt(vec.dot(along, along))
  if rate ~= 0 then
    put("circle_rate", "Omega_circle", "{I Omega|I + M R^2}", "rate of the circles of the centre", k * rate, "rad/s")
    if slope ~= 0 then
      put("drift", "v_drift", "{M R^2 g_along|I Omega}", "of the centre, across the slope", rest * slope / (k * rate),
        "m/s")
    end
  else
    put("acceleration", "a", "{M R^2 g_along|I + M R^2}", "of the centre down the slope", rest * slope, "m/s^2")
  end
end

-- The steady rolling of a top at its tilt and spin, and its small nutations.
local function rolling(m, put)
  local g = vec.map(vec.matvec(vec.transpose(vec.rotation(m.attitude)), contact.of(m).a.normal),
    function(e) return m:number(e) end)
  local square = g[1] * g[1] + g[2] * g[2]
  if R.sign(square) == 0 then return end -- upright
  local whole = R.apply("sqrt", bits, square + g[3] * g[3])
  local sine = R.apply("sqrt", bits, square) / whole
  for i, s in ipairs(steady.of(m, sine, g[3] / whole, m:number(m.omega[3])) or {}) do
    local number, stable = string.format("%d", i), R.sign(s.nod) >= 0
    local p = "p_" .. number
    put("steady_precession_" .. number, p, string.gsub("{M g b + ( I_3 s - M h x ) omega_3 P|s ( I_1 c - M h y ) P}",
      "P", p), "steady precession about the normal for this spin and tilt (cosine c, sine s); the contact is x " ..
      "across, y along the axis, b = y s - x c, its height h", s.n, "rad/s")
    local symbol = (stable and "Omega_p" or "sigma_") .. number
    put((stable and "steady_nutation_" or "steady_growth_") .. number, symbol, nil,
      stable and "rate of a small nutation about it: it is stable" or "rate of growth of a small one: it is unstable",
      R.sign(s.nod) ~= 0 and R.apply("sqrt", bits, R.abs(s.nod)) or 0.0, "rad/s")
  end
end

-- The rows of values.lua for a scene with effect.plane.
function touch.rows(job, put)
  local m, e = job.model, contact.of(job.model)
  integrals(m, put)
  local a, f = e.a, touch_laws.facts(m, e)
  local G, mass = vec.map(a.gravity, function(x) return m:double(x) end), m:double(m.mass)
  local alone = #m.record.effects == 1 and not a.spinning and not a.rolling_resistance
  if not alone then return end
  if f.ball and a.law == "rolling" then ball(m, f, put, a, mass, G) end
  critical(m, a.law, put)
  local size = -vec.dot(G, vec.map(a.normal, function(x) return m:double(x) end))
  if m:double(a.rate) ~= 0 or not f.level or not f.revolved or size == 0 or a.law ~= "rolling" then return end
  rolling(m, put)
  if f.surface.disc and m:double(f.centre[3]) == 0 then
    disc.rows(m, f.surface, put, m:double(f.I1), m:double(f.I3), mass, size)
  end
end

return touch
