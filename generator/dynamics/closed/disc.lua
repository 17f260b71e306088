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
local touch_laws = require "generator.dynamics.touch_laws"

local disc = { name = "rolling disc (Appell, Korteweg)" }

-- What touch_laws.facts says of the scene; nil and the reason why it is not of this kind.
function disc.of(m)
  local e = contact.of(m)
  if not e then return nil, "no plane is touched" end
  local a, f = e.a, touch_laws.facts(m, e)
  if not f.surface.disc then return nil, "the surface is no disc" end
  if a.law ~= "rolling" then return nil, "the disc does not roll" end
  if #m.record.effects > 1 then return nil, "not the plane alone acts on the disc" end
  if a.spinning or a.rolling_resistance then return nil, "the plane resists its spinning or rolling" end
  if a.rate ~= expr.zero then return nil, "the plane turns" end
  if not f.level then return nil, "the plane is not level" end
  if not f.revolved or not ratio.iszero(f.centre[3]) then
    return nil, "the disc and its tensor are not of revolution about z, with the centre of mass in its centre"
  end
  return f
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
  local f, why = disc.of(m)
  if not f then return nil, why, contact.of(m) ~= nil and why ~= "the surface is no disc" end
  return nil, "it is reduced to quadratures, but the state at a time needs the inverse of one", true, reduced(f)
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
  local f = disc.of(m)
  local R, size = f.surface.half[1], m.mass * f.surface.half[1] ^ 2
  local G = ratio.tidy(expr.sqrt(vec.dot(contact.of(m).a.gravity, contact.of(m).a.gravity)))
  return { k1 = m:constant("disc_k1", ratio.tidy(f.I1 / size), "I1/(m R^2)"),
    k3 = m:constant("disc_k3", ratio.tidy(f.I3 / size), "I3/(m R^2)"),
    p = m:constant("disc_p", ratio.tidy(f.surface.rim / R), "rho/R, rounding of the edge"),
    gamma = m:constant("disc_gamma", ratio.tidy(G / R), "gravity/R, 1/s^2") }
end

return disc
