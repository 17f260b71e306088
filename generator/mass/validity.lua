-- validity.lua -- can this body exist?  Positive mass, moments that are not negative, the triangle inequality.
--
-- The conditions are necessary and sufficient for a distribution of positive mass with that tensor: the second
-- moments Sigma = tr(I)/2 1 - I about the centre of mass must be positive semidefinite (Wensing, Kim, Slotine 2018,
-- IEEE RA-L 3, 60).  They are decided exactly, for the parameters' defaults, by the principal minors of rationals; all
-- broken ones are named with their numbers, and mass/slips.lua says which slip would explain them.
--     diagonal of Sigma >= 0       2 Sigma_xx = yy + zz - xx: the triangle inequality of the entries
--     minors of two >= 0           xy^2 <= Sigma_xx Sigma_yy: what the moments leave for a product
--     determinant >= 0             the triangle inequality of the principal moments
-- Every `tensor` is tested by itself, in the axes and with the entries its author wrote; then the body as a whole,
-- which a hole may have broken.  Two kinds of tensors need not pass.  One is asked to be no body's (physical = false);
-- the other would pass if it were not rounded to the digits that are written.  Both must be positive definite instead,
-- since the equations of motion divide by the moments.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local diag = require "generator.diag"
local jacobi = require "generator.mass.jacobi"
local plausible = require "generator.mass.plausible"
local slips = later "generator.mass.slips"

local validity = {}

local function show(q) return diag.show(R.todouble(q)) end

-- What rounding may do to a condition, in parts of the trace: irrational entries are evaluated to 240 bits; those of
-- inertial{} were rounded by another program (the zz = xx + yy of a plate is off by a unit of the last place of each).
local rounding, foreign = R.new(2) ^ -200, R.new(2) ^ -49

-- Which principal minors of a symmetric matrix of rationals are negative: {[1..3] = diagonal entry i, [4..6] = minor of
-- the pair xy, xz, yz, [7] = determinant}; empty if it is positive semidefinite to `relative`.
local function negative(S, relative)
  local trace = R.abs(S[1]) + R.abs(S[2]) + R.abs(S[3]) + R.abs(S[4]) + R.abs(S[5]) + R.abs(S[6])
  local slack, broken = -trace * (relative or rounding), {}
  local adj, det = vec.adjugate(S)
  for i = 1, 3 do
    if S[i] < slack then broken[i] = true end
    if adj[4 - i] < slack * trace then broken[3 + i] = true end -- xy is the cofactor of zz
  end
  if det < slack * trace * trace then broken[7] = true end
  return broken
end

local function lawful(I) return next(negative(vec.second(I))) == nil end
validity.lawful = lawful

-- Sylvester's criterion, exactly.
local function definite(I)
  local _, det = vec.adjugate(I)
  return R.sign(I[1]) > 0 and R.sign(I[1] * I[2] - I[4] ^ 2) > 0 and R.sign(det) > 0
end

-- Sigma plus k 1, as the tensor that has it: tr(k 1) 1 - k 1 more.
local function widened(I, k) return { I[1] + 2 * k, I[2] + 2 * k, I[3] + 2 * k, I[4], I[5], I[6] } end

local names = { "xx", "yy", "zz", "xy", "xz", "yz" }
local pairs_of = { { 1, 2 }, { 1, 3 }, { 2, 3 } }

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

-- a > b as text, and by how much where their doubles agree.
local function excess(a, b, text)
  local close = R.todouble(a) == R.todouble(b)
  return show(a) .. " > " .. text .. (close and " by " .. R.magnitude(a - b) or "")
end

-- The broken conditions of a central tensor as {rule, got}, simplest first: what follows from a broken diagonal, or
-- from a broken pair, is not said again.
local function faults(I, relative)
  local S, list = vec.second(I), {}
  local broken = negative(S, relative)
  local function put(rule, got) list[#list + 1] = { rule, got } end
  for i = 1, 3 do
    if R.sign(I[i]) < 0 and next(broken) then
      put(names[i] .. " about the centre of mass must not be negative", show(I[i]))
    end
  end
  for i = 1, 3 do
    local j, k = i % 3 + 1, (i + 1) % 3 + 1
    if broken[i] then
      put(string.format("triangle inequality about the centre of mass: %s <= %s + %s must hold", names[i], names[j],
        names[k]), excess(I[i], I[j] + I[k], show(I[j]) .. " + " .. show(I[k])))
    end
  end
  if #list > 0 then return list end
  for n, p in ipairs(pairs_of) do
    if broken[3 + n] then
      local i, j = p[1], p[2]
      local k = 6 - i - j
      local limit = R.apply("sqrt", 240, S[i] * S[j])
      local rule = string.format("|%s| <= sqrt((%s + %s - %s)(%s + %s - %s))/2 must hold about the centre of mass",
        names[3 + n], names[j], names[k], names[i], names[k], names[i], names[j])
      put(rule, excess(R.abs(I[3 + n]), limit, show(limit)))
    end
  end
  if #list > 0 or not broken[7] then return list end
  local double = vec.map(I, R.todouble)
  local m = jacobi.run(double)
  put("triangle inequality of the principal moments about the centre of mass must hold",
    string.format("%s > %s + %s from %s", diag.rough(m[3]), diag.rough(m[1]), diag.rough(m[2]), entries(I)))
  return list
end

-- How far rounding can move an eigenvalue of Sigma: half the trace of the moments' half units, and no more than all of
-- the products' (Gershgorin).  So whatever lawful tensor was rounded, Sigma plus this is not negative.
local function rounding_of(node)
  local h = node.halves
  if not h then return R.zero end
  return (h[1] + h[2] + h[3]) / 2 + h[4] + h[5] + h[6]
end

-- A tensor that breaks a law: is it taken all the same?  Says so, or what is wrong with it, and returns whether.
local function taken(d, node, g, list)
  local positive, slack = definite(g.central), rounding_of(node)
  if node.formal then
    if not positive then
      d:error(node.line, "tensor", "the principal moments about the centre of mass must be positive, also with " ..
        "physical = false", entries(g.central))
    end
    return positive
  elseif not positive or R.sign(slack) == 0 or not lawful(widened(g.central, slack)) then
    local advice = positive and "; physical = false takes any positive moments" or ""
    local hint = slips.hint(g)
    for n, f in ipairs(list) do
      d:error(node.line, "tensor", f[1], f[2] .. (n == 1 and (hint and "; " .. hint or "") .. advice or ""))
    end
    return false
  end
  local moment = jacobi.run(vec.map(g.central, R.todouble))
  d:warn(node.line, "tensor", list[1][1] .. ", got " .. list[1][2] .. ": too large by " ..
    diag.rough(moment[3] - moment[1] - moment[2]) .. ", which rounding to the digits that are written explains " ..
    "(up to " .. diag.rough(2 * R.todouble(slack)) .. "); the numbers are taken as they are")
  node.rounded = slack / vec.trace(g.central)
  return true
end

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

-- One `tensor` as numbers: {I = as given, mass, com, about, central}.
local function numbers(m, node)
  local a = node.a
  local function n(e) return m:number(e) end
  local g = { I = vec.map({ a.xx, a.yy, a.zz, a.xy, a.xz, a.yz }, n), mass = n(a.mass), com = vec.map(a.com, n),
    about = a.about, lawful = lawful }
  g.central = g.I
  if a.about == "origin" then g.central = vec.sub(g.I, slips.steiner(g.mass, g.com)) end
  return g
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
  each_tensor(m.record.body, function(node)
    local g = numbers(m, node)
    local list = faults(g.central, node.name == "inertial" and foreign or nil)
    local fine = #list == 0 and not node.formal or taken(d, node, g, list)
    good = fine and good
    if node.rounded and node.rounded > slack then slack = node.rounded end
    if fine and not node.formal then
      plausible.tensor(d, node.line, R.todouble(g.mass), vec.map(g.com, R.todouble), vec.map(g.central, R.todouble))
    end
  end)
  if not good then return false end
  plausible.sizes(d, m)
  plausible.densities(d, m)
  -- m.unlawful: the library must be told of a tensor that is no body's
  m.formal, m.slack, m.unlawful = m.record.body.formal, slack, m.record.body.formal or R.sign(slack) > 0 or nil
  if m.formal then return true end
  local relative
  for _, p in ipairs(m.body.pieces) do relative = p.name == "inertial" and foreign or relative end
  local whole = vec.map(J, function(e) return m:number(e) end)
  return report(d, m.line, "body", faults(widened(whole, slack * vec.trace(whole)), relative))
end

-- ---- what NAME_init must ask again ----

-- Half a unit in the last place of the emitted code's real type: a symbol that emit/ knows.
validity.roundoff = expr.sym("unit roundoff", 1, true)

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
  local shift = (16 * validity.roundoff + expr.num(slack)) * size
  return pivots_of { S[1] + shift, S[2] + shift, S[3] + shift, S[4], S[5], S[6] } -- may be zero if diagonal
end

local function constant(list)
  for _, e in ipairs(list) do
    if not expr.constant(e) then return false end
  end
  return true
end

-- Conditions on parameters that NAME_init must test: a positive total mass, lawful tensors (expressions > 0 or >= 0).
function validity.conditions(m)
  local list = {}
  if not expr.constant(m.mass) then
    list[1] = { e = m.mass, form = m.parts and m.parts.mass or nil, line = m.line, what = "body",
      rule = "total mass must be positive" }
  end
  -- S: second moments about the centre of mass; named: S and size are in the names of the body's parts
  local function lawful_at(S, size, what, line, named, slack)
    if constant(S) then return end
    local pivots, zero = semidefinite(S, size, slack or R.zero)
    for _, e in ipairs(pivots) do -- the next pivot divides by this one
      list[#list + 1] = { e = named and m.parts:resolve(e) or e, form = named and e or nil, pivot = true, line = line,
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
    if not node.formal then lawful_at(vec.second(I), size, "tensor", node.line, nil, node.rounded) end
    for _, e in ipairs((node.formal or node.rounded) and not constant(I) and (pivots_of(I)) or {}) do
      list[#list + 1] = { e = e, pivot = true, line = node.line, what = "tensor",
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
  return list
end

return validity
