-- body.lua -- mass, centre of mass and second moments of a shape tree.
--
-- A body is a list of pieces, each {mass, com, sigma}: sigma are the second moments about the piece's own
-- centroid per unit mass, so the pseudo-inertia of one piece about a point P is  mass*(sigma + d d^T),  d = com - P.
-- Sums, holes (negative mass), rotations and affine images act piece by piece, and the tensor about any point is
-- one sum over the pieces: nothing is ever shifted to a common origin and back, so nothing cancels there.
--     I(P) = tr(Sigma) 1 - Sigma,   Sigma = sum mass*(sigma + d d^T)
-- ABOVE the line.  Goldstein, Poole, Safko, Classical Mechanics (3rd ed.), eqs. 5.7 and 5.23.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local catalogue = require "generator.mass.catalogue"
local maps = require "generator.mass.maps"

local body = {}

local zero3 = { expr.zero, expr.zero, expr.zero }
local tidy = ratio.tidy

local function tidy_all(v) return vec.map(v, function(e) return (tidy(e)) end) end

-- What a sum over several pieces may cost to multiply out: beyond that parts.lua has the better form.
local composite = 1000

local function tidy_sum(b, e) return (tidy(e, #b.pieces > 1 and composite or nil)) end

-- How much more of it there is after the scaling by k: of volume, area or length (the last two only for one factor
-- and mirrors, see the scene language); and after the shear A, which only volumes allow.
function body.growth(k, measure)
  local v = vec.map(k, function(x) return expr.call("abs", x) end)
  if measure == "volume" then return v[1] * v[2] * v[3] end
  return measure == "area" and v[1] ^ 2 or v[1]
end

function body.determinant(A) return vec.dot(A[1], vec.cross(A[2], A[3])) end

-- The matrix of a turn, its rows.
function body.turn(node)
  local A
  for _, t in ipairs(node.turns or {}) do
    local one = vec.rodrigues(t.axis, t.angle)
    A = A and vec.matmul(A, one) or one
  end
  return vec.map(A or vec.rotation(node.q), tidy_all)
end

local build

-- A shape that is a sum of simpler ones: its mass is shared among them by their measure.
-- A given mass goes by measure m_i = M l_i/sum l, a density by m_i = density l_i.
local function divided(node, spec)
  local list, total = spec.pieces(node.a), expr.zero
  for _, s in ipairs(list) do total = total + s.measure end
  local out = { pieces = {}, points = spec.points(node.a), names = {} }
  for i, s in ipairs(list) do
    out.pieces[i] = { mass = node.density and node.density * s.measure or node.mass * s.measure / total,
      com = tidy_all(s.com), sigma = tidy_all(s.sigma), line = node.line, name = node.shape .. ", part " .. i,
      density = node.density, measure = node.measure }
  end
  return out
end

-- A shape as one piece; particles are one each, without sigma.
local function primitive(node)
  if node.shape == "points" then
    local pieces = {}
    for _, row in ipairs(node.rows) do
      pieces[#pieces + 1] = { mass = row[1], com = { row[2], row[3], row[4] }, sigma = nil, line = node.line,
        name = "particle" }
    end
    return { pieces = pieces, points = {}, names = {}, particles = true }
  end
  local a = node.a
  if node.shape == "tensor" then
    local I = { a.xx, a.yy, a.zz, a.xy, a.xz, a.yz }
    if a.about == "origin" then
      local d = vec.outer(a.com)
      I = vec.sub(I, vec.map(vec.inertia(d), function(x) return a.mass * x end))
    end
    local sigma = vec.map(vec.second(I), function(x) return tidy(x / a.mass) end)
    return { pieces = { { mass = a.mass, com = a.com, sigma = sigma, line = node.line, name = node.name or "tensor",
      given = a.about == "com" and I or nil, typed = node.typed } }, points = {}, names = {} }
  end
  local spec = catalogue.by_name[node.shape]
  if spec.pieces then return divided(node, spec) end
  local shape = spec.build(a)
  local com = tidy_all(shape.com or zero3)
  local points = { centroid = com }
  for k, v in pairs(shape.points or {}) do points[k] = v end
  return { pieces = { { mass = node.mass or node.density * shape.measure, com = com, sigma = tidy_all(shape.sigma),
    line = node.line, name = node.shape, density = node.density, measure = node.measure } }, points = points,
    names = {} }
end

-- r -> A r, or r -> r + shift, applied to every piece and named point; step: what that is called in a derivation;
-- rigid: A turns.  change: piece -> its new mass, nil: as it was.  A tensor that was given is kept as it was typed only
-- while nothing turns it.
local function affine(b, A, shift, step, change, rigid)
  local out, some = { pieces = {}, points = {}, particles = b.particles, names = b.names }, false
  for i, p in ipairs(b.pieces) do
    local piece = { mass = change and change(p) or p.mass, com = p.com, line = p.line, name = p.name,
      density = p.density, measure = p.measure, hole = p.hole, sigma = p.sigma, own = p.own, M = p.M, rigid = p.rigid,
      opaque = p.opaque, steps = { table.unpack(p.steps or {}) } }
    piece.steps[#piece.steps + 1] = step
    if A then
      maps.apply(piece, p, A, rigid, out.names)
    else
      piece.com = tidy_all(vec.add(p.com, shift))
    end
    some = some or piece.opaque
    piece.given, piece.typed = not A and p.given or nil, not A and p.typed or nil
    out.pieces[i] = piece
  end
  local words = {}
  for k in pairs(b.points) do words[#words + 1] = k end -- in hash order, so:
  table.sort(words)
  for _, k in ipairs(words) do
    local r = A and vec.matvec(A, b.points[k]) or vec.add(b.points[k], shift)
    out.points[k] = A and some and maps.shortened(r, out.names, "place", "# of the point " .. k .. ", turned", "m") or
      tidy_all(r)
  end
  return out
end

-- a + b, or a - b: what is cut out has negative mass, and a hole in it is matter again.  Named points are those of a;
-- its centroid is no longer one.
local function joined(a, b, sign)
  local out = { pieces = {}, points = {}, particles = a.particles and b.particles and sign > 0, names = {} }
  for _, list in ipairs { a.names, b.names } do table.move(list, 1, #list, #out.names + 1, out.names) end
  for _, p in ipairs(a.pieces) do out.pieces[#out.pieces + 1] = p end
  for _, p in ipairs(b.pieces) do
    local q = {}
    for k, v in pairs(p) do q[k] = v end
    q.mass = sign * p.mass
    if sign < 0 then q.hole = not p.hole end
    q.given = nil
    out.pieces[#out.pieces + 1] = q
  end
  for k, r in pairs(a.points) do
    if k ~= "centroid" then out.points[k] = r end
  end
  return out
end

-- {pieces, points = {name -> place}, names, particles} of a tree; names: of what is opaque (maps.lua).
function build(node)
  if node.shape then return primitive(node) end
  if node.op == "at" then
    return affine(build(node.of), nil, node.r, { "moved by", node.r })
  end
  if node.op == "turned" then
    local said = { "turned by the quaternion", node.q }
    if node.turns and #node.turns == 1 then
      said = { "turned about", node.turns[1].axis, "by", node.turns[1].angle }
    elseif node.turns then
      said = { "turned by the Euler angles", vec.map(node.turns, function(t) return t.angle end), node.euler }
    end
    return affine(build(node.of), body.turn(node), nil, said, nil, true)
  end
  if node.op == "scaled" then
    local k = node.k
    local A = { { k[1], expr.zero, expr.zero }, { expr.zero, k[2], expr.zero }, { expr.zero, expr.zero, k[3] } }
    -- a mass that was given stays; a density keeps being one, so the mass follows volume, area or length
    return affine(build(node.of), A, nil, { "scaled by", k }, function(p)
      return p.density and p.mass * body.growth(k, p.measure) or p.mass
    end)
  end
  if node.op == "sheared" then
    local volume = body.determinant(node.A)
    return affine(build(node.of), node.A, nil, { "sheared by the rows", table.unpack(node.A) }, function(p)
      return p.density and p.mass * volume or p.mass
    end)
  end
  if node.op == "sum" then return joined(build(node[1]), build(node[2]), 1) end
  if node.op == "minus" then return joined(build(node[1]), build(node[2]), -1) end
  error("unknown node in a shape tree: " .. tostring(node.op))
end

-- The body of a shape tree: pieces, named points, total mass and centre of mass, in the shape's frame.
function body.of(node)
  local b = build(node)
  local mass, first = expr.zero, zero3
  for _, p in ipairs(b.pieces) do
    mass = mass + p.mass
    first = vec.add(first, vec.scale(p.mass, p.com))
  end
  b.mass = tidy_sum(b, mass)
  if #b.pieces == 1 then
    b.com = b.pieces[1].com
  elseif ratio.iszero(b.mass) then
    b.com = zero3
  else
    b.com = vec.map(first, function(x) return tidy_sum(b, x / b.mass) end)
  end
  b.points.centroid = b.points.centroid or b.com
  return b
end

-- The tensor about the point P, {xx, yy, zz, xy, xz, yz}, factored.
-- A piece without sigma is a particle.
function body.tensor(b, P)
  local I = { expr.zero, expr.zero, expr.zero, expr.zero, expr.zero, expr.zero }
  for _, p in ipairs(b.pieces) do
    local d = vec.sub(p.com, P)
    local shift = vec.inertia(vec.outer(d))
    if p.given then
      I = vec.add(I, vec.add(p.given, vec.scale(p.mass, shift)))
    else
      if p.sigma then shift = vec.add(maps.own(p), shift) end
      I = vec.add(I, vec.scale(p.mass, shift))
    end
  end
  return vec.map(I, function(e)
    e = tidy_sum(b, e)
    return #b.names > 0 and ratio.iszero(e) and expr.zero or e -- by what entries of a rotation have to do with another
  end)
end

return body
