-- disc.lua -- the rolling disc: reduced to quadratures (Appell, Korteweg 1899), dynamics/disc.lua and its C.
--
-- No form of closed.lua's: the state at a time would need the inverse of a quadrature, so NAME_at is not made.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local contact = require "generator.dynamics.contact"
local state = require "generator.dynamics.state"
local touch = require "generator.dynamics.touch"
local upright = require "generator.dynamics.upright"

local disc = { name = "rolling disc (Appell, Korteweg)" }

-- upright.revolved of the scene; nil, the reason why it is not of this kind, and whether it is a disc at least.
function disc.of(m)
  local e = contact.of(m)
  if not e then return nil, "no plane is touched" end
  if not e.a.surface.disc then return nil, "the surface is no disc" end
  if e.a.law ~= "rolling" then return nil, "the disc does not roll", true end
  local at, why = upright.revolved(m)
  if not at then return nil, why, true end
  if not ratio.iszero(at.f.centre[3]) then return nil, "the centre of mass is not in the disc's centre", true end
  return at
end

local law = { "theta: the axis from the normal; w: the spin about it; a = phi' sin theta, phi the precession.",
  "They obey linear equations in theta, so w and a where the disc is upright are two integrals of the motion:" }
local sharp = { "(I3 + m R^2) dw/dtheta = m R^2 a, I1 d(a sin theta)/dtheta = I3 w sin theta: w is a Legendre function",
  "of cos theta of the degree nu, nu (nu + 1) = -I3 m R^2/(I1 (I3 + m R^2))." }
local round = { "I3 dw/dtheta = (R + rho sin theta) f, I1 d(a sin theta)/dtheta = (I3 w - rho f cos theta) sin theta,",
  "(1/m + (R + rho sin theta)^2/I3 + rho^2 cos^2 theta/I1) f = R a + rho (I3/I1 - 1) w cos theta.  A sharp edge,",
  "rho = 0, would have Legendre functions; here w and a are series in ln tan(theta/2)." }
local rest = { "The energy gives theta' of theta, whose swing between two roots gives the time and the precession by",
  "quadratures.  The state at a time would need the inverse of the first: there is no NAME_at." }

local function reduced(f)
  local text = {}
  for _, lines in ipairs { law, f.surface.rim == expr.zero and sharp or round, rest } do
    for _, line in ipairs(lines) do text[#text + 1] = line end
  end
  return { theorem = "rolling disc (Appell, Korteweg 1899)" .. (f.surface.rim == expr.zero and
    ", Legendre functions" or " with a rounded edge, a linear system"), text = text }
end

function disc.detect(m)
  local at, why, near = disc.of(m)
  if not at then return nil, why, near end
  return nil, "it is reduced to quadratures, but the state at a time needs the inverse of one", true, reduced(at.f)
end

-- ---- what is emitted: emit/disc.lua ----

-- NAME_disc_tilt, the state in the variables of dynamics/disc.lua.
function disc.tilt(m)
  local g = { why = "g: the plane's normal in body axes; c = g.z, s e2 = g - c z, s e1 = g x z", defs = {}, outs = {} }
  local name = touch.namer(m, g, {})
  local normal = vec.map(contact.of(m).a.normal, function(x, i)
    local letter = string.sub("xyz", i, i)
    return m:constant("plane" .. letter, ratio.tidy(x), "normal of the plane, " .. letter)
  end)
  local up = name("up_", vec.matvec(vec.transpose(vec.rotation(state.q)), normal))
  local s, w = name("s", { expr.sqrt(up[1] ^ 2 + up[2] ^ 2) })[1], state.w
  local results = { s, up[3], (w[1] * up[2] - w[2] * up[1]) / s, (w[1] * up[1] + w[2] * up[2]) / s, w[3] }
  for i, e in ipairs(results) do g.outs[i] = { array = "tilt", index = i - 1, expr = e } end
  return { name = "disc_tilt", args = { "m", "x", { name = "tilt", count = 5, out = true } },
    doc = { "The tilt theta, from the normal to the disc's axis: sin theta, cos theta, theta' in rad/s, and",
      "a = phi' sin theta and w, rad/s: phi is the precession about the normal, w the rate about the axis.",
      "Not of a disc that lies flat." },
    groups = { g } }
end

-- {k1, k3, p, gamma} of dynamics/disc.lua as constants of the model.
function disc.constants(m)
  local at = disc.of(m)
  local surface = at.f.surface
  local R, size = surface.half[1], m.mass * surface.half[1] ^ 2
  return { k1 = m:constant("disc_k1", ratio.tidy(at.I1 / size), "I1/(m R^2)"),
    k3 = m:constant("disc_k3", ratio.tidy(at.I3 / size), "I3/(m R^2)"),
    p = m:constant("disc_p", ratio.tidy(surface.rim / R), "rho/R, rounding of the edge"),
    gamma = m:constant("disc_gamma", ratio.tidy(at.G / R), "gravity/R, 1/s^2") }
end

return disc
