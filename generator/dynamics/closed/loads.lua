-- loads.lua -- damping, constant torque in body axes and rotors of a scene, each summed: what the elementary closed
-- forms ask of its effects.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"

local loads = {}

local entry = { { 1, 4, 5 }, { 4, 2, 6 }, { 5, 6, 3 } } -- xx yy zz xy xz yz as a matrix

local function matrix(v) return vec.map(entry, function(row) return vec.map(row, function(n) return v[n] end) end) end

local function zeros() return { expr.zero, expr.zero, expr.zero } end

-- {damping = C, torque = N, rotor = h or nil each; axis, of the first rotor}, or nil and which effect is none of these.
-- The torque of the effects is N - C w - w x h.  attitude: it is needed.
function loads.of(m, attitude)
  if attitude and not m.has.attitude then return nil, "it carries the attitude, which this scene has not" end
  if not m.has.rates then return nil, "the body does not turn" end
  local l = {}
  for _, e in ipairs(m.record.effects) do
    if e.kind == "effect.damping" and e.spec.varies_with(e.a) then
      return nil, "the damping varies"
    elseif e.kind == "effect.damping" then
      local C = e.a.C or vec.map(matrix(m.inertia), function(row) return vec.scale(e.a.rate, row) end)
      l.damping = l.damping or { zeros(), zeros(), zeros() }
      for i = 1, 3 do l.damping[i] = vec.add(l.damping[i], C[i]) end
    elseif e.kind == "effect.torque" and motion.any(e.a.body or e.a.inertial) then
      return nil, "the torque varies with the motion"
    elseif e.kind == "effect.torque" and e.a.body then
      l.torque = vec.add(l.torque or zeros(), e.a.body)
    elseif e.kind == "effect.rotor" then
      l.rotor, l.axis = vec.add(l.rotor or zeros(), e.spec.held(e.a)), l.axis or e.a.axis
    elseif e.kind == "effect.torque" then
      return nil, "a torque that is constant in inertial axes needs the attitude, which has no elementary form"
    else
      return nil, string.gsub(e.kind, "effect%.", "") .. " acts on the body"
    end
  end
  return l
end

-- Is the vector along k?
function loads.along(v, k)
  for _, x in ipairs(vec.cross(v, k)) do
    if not ratio.iszero(x) then return false end
  end
  return true
end

-- The coefficient of a vector along k: v = c k.
function loads.component(v, k) return ratio.tidy(vec.dot(v, k) / vec.dot(k, k)) end

-- The rate for which C = rate I, or nil.
function loads.proportional(m, C)
  local I, rate = matrix(m.inertia), nil
  for i = 1, 3 do
    if not rate and not ratio.iszero(I[i][i]) then rate = ratio.tidy(C[i][i] / I[i][i]) end
  end
  for i = 1, 3 do
    for j = 1, 3 do
      if not ratio.iszero(C[i][j] - rate * I[i][j]) then return nil end
    end
  end
  return rate
end

-- C = c1 (1 - k k^T/k^2) + c3 k k^T/k^2: c1 and c3, or nil.
-- c3 = k.C k/k^2, c1 by the trace, and then every entry must agree.
function loads.coaxial(C, k)
  local k2 = vec.dot(k, k)
  local c3 = ratio.tidy(vec.dot(k, vec.matvec(C, k)) / k2)
  local c1 = ratio.tidy((C[1][1] + C[2][2] + C[3][3] - c3) / 2)
  for i = 1, 3 do
    for j = 1, 3 do
      local e = (c3 - c1) * k[i] * k[j] / k2 + (i == j and c1 or expr.zero)
      if not ratio.iszero(C[i][j] - e) then return nil end
    end
  end
  return c1, c3
end

return loads
