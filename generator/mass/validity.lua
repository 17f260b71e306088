-- validity.lua -- can this body exist?  Positive mass, moments that are not negative, the triangle inequality.
--
-- The three conditions are necessary and sufficient for a distribution of positive mass with that tensor: the
-- second moments Sigma = tr(I)/2 1 - I about the centre of mass must be positive semidefinite (Wensing, Kim,
-- Slotine 2018, IEEE RA-L 3, 60).  They are decided exactly, for the parameters' defaults, by the leading minors of
-- rationals; each broken one is named with its numbers.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local diag = require "generator.diag"

local validity = {}

local function show(q) return diag.show(R.todouble(q)) end

-- How much rounding may do to a condition, per trace: 2^-200 where irrational entries are evaluated, 2^-49 where
-- another program rounded them (inertial{}: the zz = xx + yy of a plate is off by a unit of the last place of each).
local function rounding(m)
  for _, p in ipairs(m.body.pieces) do
    if p.name == "inertial" then return R.new(2) ^ -49 end
  end
  return R.new(2) ^ -200
end

-- Is the symmetric matrix of rationals positive semidefinite?  All principal minors must be >= 0.
local function semidefinite(S, trace, relative)
  local slack = -trace * relative
  for i = 1, 3 do
    if S[i] < slack then return false end
  end
  local adj, det = vec.adjugate(S)
  for i = 1, 3 do
    if adj[i] < slack * trace then return false end
  end
  return det >= slack * trace * trace
end

local names = { "xx", "yy", "zz" }

-- Moments are divided by, so their reciprocals must be doubles too; a tensor that is not diagonal is inverted, and its
-- determinant is the cube of a moment.
local ranges = {
  plain = { most = R.parse "1e300", about = " (1e-300 to 1e300)" },
  coupled = { most = R.parse "1e100", about = ", and so must their cubes (1e-100 to 1e100)" },
}

-- The six entries, for a message.
local function entries(I)
  return string.format("xx %s, yy %s, zz %s, xy %s, xz %s, yz %s", show(I[1]), show(I[2]), show(I[3]), show(I[4]),
    show(I[5]), show(I[6]))
end

-- Reports what is wrong with the model's mass and centroidal tensor; true when nothing is.
function validity.check(d, m)
  local mass = m:number(m.mass)
  if R.sign(mass) <= 0 then
    d:error(m.line, "body", "total mass must be positive", show(mass) .. " kg")
    return false
  end
  local I, J = m.inertia, m.centroidal
  local coupled = not (expr.iszero(I[4]) and expr.iszero(I[5]) and expr.iszero(I[6]))
  local range = ranges[coupled and "coupled" or "plain"]
  for _, e in ipairs { m.mass, I[1], I[2], I[3], J[1], J[2], J[3] } do
    local x = m:number(e)
    if R.sign(x) ~= 0 and (R.abs(x) * range.most < R.one or R.abs(x) > range.most) then
      d:error(m.line, "body", "mass and moments must be within the range of double" .. range.about, R.magnitude(x))
      return false
    end
  end
  I = vec.map(J, function(e) return m:number(e) end)
  local half = vec.trace(I) / R.new(2)
  local sigma = { half - I[1], half - I[2], half - I[3], -I[4], -I[5], -I[6] }
  local trace, relative = R.abs(I[1]) + R.abs(I[2]) + R.abs(I[3]), rounding(m)
  if semidefinite(sigma, trace, relative) then return true end
  if not semidefinite(I, trace, relative) then
    d:error(m.line, "body", "the tensor about the centre of mass must be positive semidefinite", entries(I))
    return false
  end
  local said = false
  local slack = trace * relative
  for i = 1, 3 do
    local j, k = i % 3 + 1, (i + 1) % 3 + 1
    if I[i] > I[j] + I[k] + slack then
      d:error(m.line, "body", string.format("triangle inequality about the centre of mass: %s <= %s + %s must hold",
        names[i], names[j], names[k]), string.format("%s > %s + %s", show(I[i]), show(I[j]), show(I[k])))
      said = true
    end
  end
  if not said then
    d:error(m.line, "body", "triangle inequality of the principal moments about the centre of mass must hold",
      entries(I))
  end
  return false
end

-- Conditions on parameters that NAME_init must test again: a positive total mass (expressions that must be > 0).
function validity.conditions(m)
  local list = {}
  if not expr.constant(m.mass) then
    list[1] = { e = m.mass, what = "body", rule = "total mass must be positive", line = m.line }
  end
  -- a hole may outgrow its body when parameters change: then the central tensor must be tested again
  local hole = false
  for _, p in ipairs(m.body.pieces) do hole = hole or R.sign(m:number(p.mass)) < 0 end
  if hole then
    -- the pivots of elimination, not the minors: each is as large as a moment, so none leaves the range of float
    local I = m.centroidal
    local second, mixed = I[2] - I[4] ^ 2 / I[1], I[6] - I[4] * I[5] / I[1]
    for _, e in ipairs { I[1], second, I[3] - I[5] ^ 2 / I[1] - mixed ^ 2 / second } do
      list[#list + 1] = { e = e, what = "body", line = m.line,
        rule = "the tensor about the centre of mass must be positive definite" }
    end
  end
  return list
end

return validity
