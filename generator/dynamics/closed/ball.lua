-- ball.lua -- a homogeneous ball that rolls on a plane: its whole motion, or that of its centre.
--
-- k = J/(J + m R^2); along the plane, as complex numbers (i: the quarter turn about n), z the centre, Z the spin:
--     z'' = i k Omega z' + (1 - k) G_t,     z' = i Omega z - i R Z,     Z' = ((1 - k) Omega z' + i (1 - k) G_t)/R
-- (Earnshaw, Dynamics, 1844; Weltner, Am. J. Phys. 47 (1979) 984): circles at the rate k Omega, on a tilted turntable
-- trochoids that drift across the slope, on a tilted plane at rest parabolas.  W.n is constant.
-- On a level plane at rest Z is constant, and so is w in body axes: uniform rotation and a straight line.  Elsewhere
-- W changes its direction, and of the attitude there is no elementary form: q' = (0, W) q/2 is Hill's equation on a
-- turntable and Landau and Zener's on a slope (parabolic cylinder functions).  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local contact = require "generator.dynamics.contact"
local touch_laws = require "generator.dynamics.touch_laws"

local ball = { name = "homogeneous ball that rolls" }

local whole_text = { "Nothing acts along the plane: w is constant in both frames, and the centre moves on a straight",
  "line, V = R W x n, q(t) = q(0) (cos |w|t/2, w/|w| sin |w|t/2)." }

local function centre_text(turns, tilted)
  local law = "V' = " .. (turns and "k Omega n x V" or "") .. (turns and tilted and " + " or "") ..
    (tilted and "(1 - k) G_t" or "") .. ", k = J/(J + m R^2)"
  local path = turns and (tilted and "a trochoid" or
    "a circle at the rate k Omega, wherever it starts") or "a parabola"
  return { law .. ", so the centre moves on " .. path .. ".",
    "W x n = (V - Omega n x p)/R gives the spin W along the plane; W.n is constant.  Of the attitude there is no",
    "elementary form: q' = (0, W) q/2 is " .. (turns and "Hill's equation." or
      "Landau and Zener's equation (parabolic cylinder functions)."),
    "Earnshaw, Dynamics, 1844; Weltner, Am. J. Phys. 47 (1979) 984." }
end

-- What templates/orbit/ball.c and centre.c ask of the model: radius and axes; moving: what the centre's law needs.
local function constants(a, moving)
  return function(model)
    local out = {}
    local function put(name, e, about) out[name] = model:constant("ball_" .. name, ratio.tidy(e), about) end
    put("R", a.surface.rim, "radius, m")
    for _, v in ipairs { { "a", a.e1 }, { "b", a.e2 }, { "n", a.normal } } do
      for i, x in ipairs(v[2]) do put(v[1] .. i, x, "component of e1, e2 or n of the plane") end
    end
    if moving then moving(put) end
    return out
  end
end

-- Of z'' and Z' in the head.
local function centre_law(a, J, mass)
  local R, mR2 = a.surface.rim, mass * a.surface.rim ^ 2
  local k, rest = J / (J + mR2), mR2 / (J + mR2)
  return function(put)
    put("Omega", a.rate, "rate of the plane, rad/s")
    put("turn", k * a.rate, "k Omega, rate of the centre's circles, rad/s")
    put("share", rest * a.rate / R, "(1 - k) Omega/R, 1/(m s)")
    for i, e in ipairs { a.e1, a.e2 } do
      local pull = rest * vec.dot(a.gravity, e)
      put("pull" .. i, pull, "(1 - k) gravity along e" .. i .. ", m/s^2")
      put("spin" .. i, pull / R, "the same over R, rad/s^2")
    end
  end
end

local slide_text = { "The slip v = V - R W x n keeps its direction: v = v0 exp(-c G t/k), k = J/(J + m R^2);",
  "V - V0 = k (v - v0), R (W - W0) x n = -(1 - k) (v - v0), and W.n is constant.  Of the attitude there is no",
  "elementary form." }

-- weight: gravity towards the plane
local function slide_law(a, weight, J, mass)
  local R, mR2 = a.surface.rim, mass * a.surface.rim ^ 2
  local k = J / (J + mR2)
  return function(put)
    put("decay", a.friction.viscous * weight / k, "rate at which the slip decays, 1/s")
    put("share", k, "J/(J + m R^2)")
    put("rest", mR2 / (J + mR2) / R, "(1 - k)/R, 1/m")
  end
end

function ball.detect(m)
  local e = contact.of(m)
  if not e then return nil, "the body touches no plane" end
  local a, f = e.a, touch_laws.facts(m, e)
  if not f.ball then return nil, "it is no sphere about its centre of mass with three equal moments" end
  local turns = not ratio.iszero(a.rate)
  local viscous = a.law == "sliding" and a.friction.viscous
  if a.law == "smooth" then return nil, "nothing turns the ball", true end
  if a.law == "sliding" and not (viscous and f.level and not turns) then
    return nil, "the ball slides, and only viscous friction on a level plane at rest has a closed form", true
  end
  if a.spinning or a.rolling_resistance then return nil, "a resistance acts on the ball", true end
  for _, other in ipairs(m.record.effects) do
    if other ~= e then return nil, string.gsub(other.kind, "effect%.", "") .. " acts on the ball", true end
  end
  if viscous then
    return { kind = "centre of a sliding ball", theorem = "ball that slides with viscous friction: the centre's path",
      text = slide_text, full = false, centre = true, slides = true, flags = { rolls = true },
      constants = constants(a, slide_law(a, -e.spec.weight(a), f.I3, m.mass)) }
  elseif not turns and f.level then
    return { kind = "rolling ball", theorem = "rolling ball, uniform rotation and a straight line", text = whole_text,
      flags = { rolls = true }, full = true, constants = constants(a) }
  end
  return { kind = "centre of a rolling ball", theorem = "rolling ball on a " .. (f.level and "" or "tilted ") ..
      (turns and "turntable: the centre's " .. (f.level and "circle" or "trochoid") or "plane: the centre's parabola"),
    text = centre_text(turns, not f.level), full = false, centre = true,
    flags = { rolls = true, turning = turns, tilted = not f.level },
    constants = constants(a, centre_law(a, f.I3, m.mass)) }
end

return ball
