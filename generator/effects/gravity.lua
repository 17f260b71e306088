-- gravity.lua -- uniform gravity on the centre of mass, about a fixed origin of rotation.
--
--     N = r x M g d_body,   d_body = R(q)^T d,   V = -M g d . (R(q) r)      r the centre of mass, d the direction
-- Goldstein, Poole, Safko (3rd ed.), section 5.7 (the heavy top).  Conserves T + V and, for a vertical d, the
-- component of L along d.  About the centroid it exerts no torque, and nothing is emitted.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"

local gravity = {
  name = "effect.gravity",
  about = "uniform gravity g along direction (inertial), acting at the centre of mass",
  idle = { { "g" }, "the origin is the centre of mass, about which the weight exerts no torque (origin = ... is the " ..
    "fixed point about which the body turns; effect.translation lets it fall)" },
  formula = "N = r x M g R(q)^T d, V = -M g d.R(q) r; r the centre of mass from the origin, d = direction/|direction|",
  signs = "direction is where things fall to; V = 0 with the centre of mass at the height of the origin",
  source = "Goldstein, Poole, Safko, Classical Mechanics, 3rd ed., 5.7",
  example = "heavy_top",
  args = { { name = "g", dim = "acceleration", sign = "nonnegative", default = 9.80665 },
    { name = "direction", size = 3, default = { 0, 0, -1 } } },
  keeps = "T+V, L_z if direction is along z, w3 if the centre of mass is on the body's z",
  fixed = "give gravity = to effect.translation or effect.plane",
}

-- d . (components of the weight per unit moment): the constants M g r and the unit direction.
local function weight(a, c)
  local n = vec.dot(a.direction, a.direction)
  local d = vec.map(a.direction, function(x) return ratio.tidy(x / expr.sqrt(n)) end)
  local m = vec.map(c.com, function(x, i)
    return c.constant("Mgr" .. string.sub("xyz", i, i), ratio.tidy(c.mass * a.g * x),
      "M g r along " .. string.sub("xyz", i, i) .. ", N m")
  end)
  return m, d
end

function gravity.check(a)
  return { { vec.dot(a.direction, a.direction), "direction must not be zero" } }
end

function gravity.torque(a, c)
  local m, d = weight(a, c)
  return vec.cross(m, vec.matvec(vec.transpose(vec.rotation(c.q)), d))
end

function gravity.potential(a, c)
  local m, d = weight(a, c)
  return -vec.dot(d, vec.matvec(vec.rotation(c.q), m))
end

-- N_z = (r x ..)_z = 0 for r along body z; for d along inertial z the torque is across it.
function gravity.conserves(a, c)
  local list = { "T+V" }
  if a.direction[1] == expr.zero and a.direction[2] == expr.zero then list[2] = "L_z" end
  if c.com[1] == expr.zero and c.com[2] == expr.zero then list[#list + 1] = "w3" end
  return list
end

-- What the general library is told.  num: expression -> double.
function gravity.numeric(a, num)
  return { kind = "gravity", g = num(a.g), direction = vec.map(a.direction, num) }
end

return gravity
