-- validity.lua -- can the body of a scene exist?  Positive mass, and lawful tensors (mass/law.lua).
--
-- Every `tensor` is tested by itself, for the parameters' defaults, in the axes and with the entries its author wrote;
-- then the body as a whole, which a hole may have broken.  A tensor out of a file of another program has been judged
-- where its line is known (interchange/read.lua).  What depends on parameters, NAME_init must ask again.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local diag = require "generator.diag"
local law = require "generator.mass.law"
local plausible = require "generator.mass.plausible"
local slips = require "generator.mass.slips"
local within = require "generator.mass.within"

local validity = {}

local function show(q) return diag.show(R.todouble(q)) end

-- Moments are divided by, so their reciprocals must be doubles too; a tensor that is not diagonal is inverted, and its
-- determinant is the cube of a moment.
local ranges = {
  plain = { most = R.parse "1e300", about = " (1e-300 to 1e300)" },
  coupled = { most = R.parse "1e100", about = ", and so must their cubes (1e-100 to 1e100)" },
}

local function report(d, line, what, list)
  for _, f in ipairs(list) do d:error(line, what, f[1], f[2]) end
  return #list == 0
end

-- ---- the checks ----

-- Every `tensor` below node by f(its node).
local function each_tensor(node, f)
  if node.shape == "tensor" then return f(node) end
  for _, child in ipairs { node.of or node[1], not node.of and node[2] or nil } do each_tensor(child, f) end
end

-- One `tensor` as numbers, for law.judge.
local function numbers(m, node)
  local a = node.a
  local function n(e) return m:number(e) end
  return { I = vec.map({ a.xx, a.yy, a.zz, a.xy, a.xz, a.yz }, n), mass = n(a.mass), com = vec.map(a.com, n),
    about = a.about, written = node.written, formal = node.formal, scene = true }
end

-- Reports what is wrong with the model's mass and tensors; true when nothing is.
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
  local good, slack = true, R.zero
  local formal = m.record.body.formal
  each_tensor(m.record.body, function(node)
    local function fail(rule, got) d:error(node.line, "tensor", rule, got) end
    local v = node.judged or law.judge(numbers(m, node), fail, function(text) d:warn(node.line, "tensor", text) end)
    good = v.good and good
    node.slack, node.positive = v.slack, v.positive -- for the conditions below
    if v.slack and v.slack > slack then slack = v.slack end
    m.unlawful = m.unlawful or v.positive
  end)
  if not good then return false end
  plausible.sizes(d, m)
  plausible.densities(d, m)
  -- m.unlawful: the library must be told of a tensor that is no body's; of one that was computed it need not
  m.formal, m.slack, m.unlawful = formal, slack, formal or m.unlawful or nil
  if m.formal then return true end
  local whole = vec.map(J, function(e) return m:number(e) end)
  return report(d, m.line, "body", law.faults(law.widened(whole, slack * vec.trace(whole))))
end

-- ---- what NAME_init must ask again ----

local roundoff = expr.sym("unit roundoff", 1, true)

-- The symbols in conditions that allow for rounding, with their values where half a unit in the last place of 1 is
-- `unit`: a list of {sym =, name = what a person calls it, value = rational}.
function validity.rounding(unit)
  return { { sym = roundoff, name = "roundoff", value = unit },
    { sym = within.slack, name = "slack", value = within.slack_of(unit) } }
end

-- The same for exact numbers: {symbol -> number}.
validity.exactly = {}
for _, c in ipairs(validity.rounding(R.zero)) do validity.exactly[c.sym] = expr.num(c.value) end

-- The pivots of elimination of A, which must be positive, and whether A is diagonal.
-- A_11; A_22 - A_12^2/A_11; what is left of A_33.
local function pivots_of(A)
  local p = A[1]
  if expr.iszero(A[4]) and expr.iszero(A[5]) and expr.iszero(A[6]) then return { p, A[2], A[3] }, true end
  local second = A[2] - A[4] ^ 2 / p
  return { p, second, A[3] - A[5] ^ 2 / p - (A[6] - A[4] * A[5] / p) ^ 2 / second }, false
end

-- Conditions under which S is positive semidefinite, as expressions >= 0; size: a bound of the terms it was added from.
-- Entries that were rounded, and added, are off by some 4 u size; a lamina or a rod (S singular) must pass with these.
-- So the test is made of S + 16 u size 1, which is then positive definite by 12 u size, more than the rounding of the
-- elimination itself can eat (Higham, Accuracy and Stability, 2nd ed., theorem 10.7: some 4 u of the largest entry).
-- The conditions are the pivots of elimination, not minors: each is as large as a moment, so none leaves the range of
-- float.
-- slack: what the rounding of written digits is allowed beside that, in parts of size.
local function semidefinite(S, size, slack)
  local shift = (16 * roundoff + expr.num(slack)) * size
  return pivots_of { S[1] + shift, S[2] + shift, S[3] + shift, S[4], S[5], S[6] } -- may be zero if diagonal
end

local function constant(list)
  for _, e in ipairs(list) do
    if not expr.constant(e) then return false end
  end
  return true
end

-- Conditions on parameters that NAME_init must test: a positive total mass, lawful tensors, holes inside their bodies
-- (expressions > 0 or >= 0); and the rules of which there is no condition: {what, rule, line}.
function validity.conditions(m)
  local list, unasked = within.conditions(m) -- first: a hole that reaches out is the cause of what else is wrong
  if not expr.constant(m.mass) then
    list[#list + 1] = { e = m.mass, form = m.parts and m.parts.mass or nil, line = m.line, what = "body",
      rule = "total mass must be positive" }
  end
  -- S: second moments about the centre of mass; named: S and size are in the names of the body's parts
  local function lawful_at(S, size, what, line, named, slack)
    if constant(S) then return end
    local pivots, zero = semidefinite(S, size, slack or R.zero)
    for _, e in ipairs(pivots) do -- the next pivot divides by this one
      list[#list + 1] = { e = named and m.parts:resolve(e) or e, form = named and e or nil, opaque = true, line = line,
        what = what, allow_zero = zero,
        rule = "the triangle inequality of the principal moments about the centre of mass must hold" }
    end
  end
  each_tensor(m.record.body, function(node)
    local a = node.a
    local I = { a.xx, a.yy, a.zz, a.xy, a.xz, a.yz }
    local size = vec.trace(I)
    if a.about == "origin" then
      local shift = slips.steiner(a.mass, a.com)
      I, size = vec.sub(I, shift), size + vec.trace(shift)
    end
    if not node.formal then lawful_at(vec.second(I), size, "tensor", node.line, nil, node.slack) end
    for _, e in ipairs((node.formal or node.positive) and not constant(I) and (pivots_of(I)) or {}) do
      list[#list + 1] = { e = e, opaque = true, line = node.line, what = "tensor",
        rule = "the principal moments about the centre of mass must be positive" }
    end
  end)
  -- a hole may outgrow its body when parameters change: then the central tensor must be tested again
  local hole, size, signs = false, expr.zero, {}
  for i, p in ipairs(m.body.pieces) do
    signs[i] = R.sign(m:number(p.mass))
    hole = hole or signs[i] < 0
    if p.sigma then
      local d = vec.sub(p.com, m.body.com)
      size = size + 2 * signs[i] * p.mass * (p.sigma[1] + p.sigma[2] + p.sigma[3] + vec.dot(d, d))
    end
  end
  if hole and m.parts and m.parts.central then
    local S = {}
    for n = 1, 6 do S[n] = m.centroidal[n].kind == "num" and n > 3 and -m.centroidal[n] or m.parts:second(n) end
    lawful_at(S, m.parts:size(signs), "body", m.line, true, m.slack)
  elseif hole then
    lawful_at(vec.second(m.centroidal), size, "body", m.line, nil, m.slack)
  end
  return list, unasked
end

return validity
