-- disc.lua -- of a rolling disc (dynamics/disc.lua): its linear integrals, swing of the tilt, turn of the contact
-- point, and reactions.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"
local contact = require "generator.dynamics.contact"
local disc = require "generator.dynamics.disc"

local report = {}

local bits = 128

-- {s, c, a, w} of the initial state, and theta': sine and cosine have all their digits at any tilt.
local function start(m)
  local q = vec.rotation(m.attitude)
  local g = vec.map(vec.matvec(vec.transpose(q), contact.of(m).a.normal), function(e) return m:number(e) end)
  local omega = vec.map(m.omega, function(e) return m:number(e) end)
  local function double(x) return R.todouble(R.round(x, bits)) end
  local function root(x) return R.sign(x) == 0 and x or R.apply("sqrt", bits, x) end
  local across = root(g[1] * g[1] + g[2] * g[2])
  local whole = root(across * across + g[3] * g[3])
  return { s = double(across / whole), c = double(g[3] / whole), w = double(omega[3]),
    a = double((omega[1] * g[1] + omega[2] * g[2]) / across) }, double((omega[1] * g[2] - omega[2] * g[1]) / across)
end

local flat = "\\pi\\sqrt{1 + mR^2/(I_1 + m\\varrho^2)}"

local function swing(d, put, z, rate)
  local spin, precession = disc.integrals(d, z)
  put("upright_spin", "linear integral (Appell, Korteweg): w3 of the solution where it is upright", "w3 at 90 deg",
    "\\omega_3(90^\\circ)", spin, "rad/s")
  put("upright_precession", "the other: its precession there", "phi' at 90 deg", "\\dot\\varphi(90^\\circ)", precession,
    "rad/s")
  local f = disc.swing(d, z, rate)
  if not f.least then
    put("tilt_least", "it falls flat, and then touches along a line", "0", "0", 0.0, "deg")
    return
  end
  local function deg(n) return math.deg(math.atan(n.s, n.c)) end
  local function roots(which) return which .. " root of W = J theta'^2/2", "W(\\theta_" .. which .. ") = 0" end
  local formula, latex = roots "least"
  put("tilt_least", "between the axis and the normal", formula, latex, deg(f.least), "deg")
  formula, latex = roots "greatest"
  put("tilt_greatest", "the same; equal to the least in steady rolling", formula, latex, deg(f.greatest), "deg")
  put("reaction_tilt_least", "", "N = m (G + R c theta'')", "N = m(G + Rc\\ddot\\theta)", disc.reaction(d, f.least),
    "N")
  put("reaction_tilt_greatest", "", "N = m (G + R c theta'')", "N = m(G + Rc\\ddot\\theta)",
    disc.reaction(d, f.greatest), "N")
  if f.N then
    put("reaction_least", f.N > 0 and "in the swing: it stays on the plane" or
      "in the swing: contact is lost before, and what is said of the whole swing does not hold",
      "N = m (G + R (c theta'' - s theta'^2))", "N = m(G + R(c\\ddot\\theta - s\\dot\\theta^2))", f.N, "N")
  end
  if f.period then
    put("tilt_period", "of the tilt", "2 int dtheta/theta'", "2\\int d\\theta/\\dot\\theta", f.period, "s")
    put("contact_turn", "of the contact point about the normal in it, as of the precession", "2 int phi'/theta' dtheta",
      "2\\int(\\dot\\varphi/\\dot\\theta)\\,d\\theta", math.deg(f.turn), "deg")
    put("precession_rate", "about the normal, on average", "contact_turn/tilt_period",
      "\\langle\\dot\\varphi\\rangle", f.turn / f.period, "rad/s")
  end
  put("contact_turn_flat", "what |contact turn| tends to for ever flatter falls", "pi sqrt(1 + m R^2/(I1 + m rho^2))",
    flat, math.deg(disc.flat_turn(d)), "deg")
end

-- The rows; I1, I3, mass, G: numbers.
function report.rows(m, surface, put, I1, I3, mass, G)
  local d = disc.of(I1, I3, mass, m:double(surface.half[1]), m:double(surface.rim), G)
  local z, rate = start(m)
  swing(d, put, z, rate)
end

return report
