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

local function swing(d, put, z, rate)
  local spin, precession = disc.integrals(d, z)
  put("upright_spin", "C_1", nil, "linear integral (Appell, Korteweg): the spin of the solution where it is upright",
    spin, "rad/s")
  put("upright_precession", "C_2", nil, "the other: its precession there", precession, "rad/s")
  local f = disc.swing(d, z, rate)
  if not f.least then
    put("tilt_least", "theta_min", nil, "it falls flat, and then touches along a line", 0.0, "deg")
    return
  end
  local function deg(n) return math.deg(math.atan(n.s, n.c)) end
  put("tilt_least", "theta_min", nil, "least tilt between the axis and the normal", deg(f.least), "deg")
  put("tilt_greatest", "theta_max", nil, "greatest tilt; equal to the least in steady rolling", deg(f.greatest), "deg")
  put("reaction_tilt_least", "N_min", "M ( g + R cos(theta) theta'' )", "reaction at the least tilt",
    disc.reaction(d, f.least), "N")
  put("reaction_tilt_greatest", "N_max", "M ( g + R cos(theta) theta'' )", "reaction at the greatest tilt",
    disc.reaction(d, f.greatest), "N")
  if f.N then
    put("reaction_least", "N_0", "M ( g + R ( cos(theta) theta'' - sin(theta) theta'^2 ) )", f.N > 0 and
      "least reaction in the swing: it stays on the plane" or "least reaction in the swing: contact is lost before, " ..
      "and what is said of the whole swing does not hold", f.N, "N")
  end
  if f.period then
    put("tilt_period", "tau", "2 int {1|theta'} dtheta", "period of the tilt", f.period, "s")
    put("contact_turn", "psi", "2 int {phi'|theta'} dtheta",
      "turn of the contact point about the normal in it, as of the precession", math.deg(f.turn), "deg")
    put("precession_rate", "phi'", "{psi|tau}", "precession about the normal, on average", f.turn / f.period, "rad/s")
  end
  put("contact_turn_flat", "psi_0", "pi sqrt(1 + {M R^2|I_1 + M rho^2})", "what |psi| tends to for ever flatter falls",
    math.deg(disc.flat_turn(d)), "deg")
end

-- The rows; I1, I3, mass, G: numbers.
function report.rows(m, surface, put, I1, I3, mass, G)
  local d = disc.of(I1, I3, mass, m:double(surface.half[1]), m:double(surface.rim), G)
  local z, rate = start(m)
  swing(d, put, z, rate)
end

return report
