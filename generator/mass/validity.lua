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
-- which a hole may have broken.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local diag = require "generator.diag"
local jacobi = require "generator.mass.jacobi"
local slips = require "generator.mass.slips"

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

local function report(d, line, what, list, hint)
  for n, f in ipairs(list) do d:error(line, what, f[1], f[2] .. (n == 1 and hint and "; " .. hint or "")) end
  return #list == 0
end

-- ---- implausible, and possible all the same: warnings ----

-- The largest principal moment of a body of volume V is smallest for a ball, where M/k^3 = (5/2)^1.5 M/r^3 = 16.6 times
-- the density (k: the radius of gyration that belongs to the largest moment).  Nothing on Earth is denser than osmium,
-- 22590 kg/m^3: above 16.6*22590 the tensor is too small for its mass.  There is no such bound below; thin structures
-- (booms, sails of 100 m and 10 kg) have some 1e-3 kg/m^3, and 1e-4 leaves them in peace.
local heaviest, lightest = 3.75e5, 1e-4

local others = { { 1e-6, "kg mm^2" }, { 1e-9, "g mm^2" }, { 1e-4, "kg cm^2" }, { 1e-7, "g cm^2" }, { 1e-3, "g m^2" } }

-- mass, centre and central tensor of one `tensor` in doubles.
local function plausible(d, line, mass, com, I)
  local moment = jacobi.run(I)[3]
  if not (moment > 0 and mass > 0) then return end
  local k = math.sqrt(moment / mass)
  local density = mass / k / k / k
  local about = "the radius of gyration sqrt(I/mass) is " .. diag.rough(k) .. " m"
  if density < lightest then
    local guess = ""
    for _, o in ipairs(others) do -- the first unit that gives a body of ordinary density
      local r = math.sqrt(moment * o[1] / mass)
      local then_density = mass / r / r / r
      if guess == "" and then_density > 1 and then_density < heaviest then
        guess = " (in " .. o[2] .. " it would be " .. diag.rough(r) .. " m)"
      end
    end
    d:warn(line, "tensor", "the moments look too large for the mass: " .. about .. guess)
  elseif density > heaviest and k > 1e-8 then -- the mass of a molecule is in its nuclei
    local grams = math.sqrt(moment / mass * 1e3)
    local fits = mass * 1e-3 / grams ^ 3 < heaviest and mass * 1e-3 / grams ^ 3 > 1
    d:warn(line, "tensor", "the moments look too small for the mass, denser than any metal: " .. about ..
      (fits and " (with the mass in g it would be " .. diag.rough(grams) .. " m)" or ""))
  end
  local far = math.sqrt(com[1] ^ 2 + com[2] ^ 2 + com[3] ^ 2)
  if far > 1e3 * k then -- 300 mm typed as 300 m beside a body of 10 cm
    d:warn(line, "tensor", "com is " .. diag.rough(far) .. " m from the origin, " .. diag.rough(far / k) ..
      " radii of gyration: is it in metres?")
  end
end

-- Parts of one body whose sizes differ by more than six orders: one of them is probably in another unit.  A part's size
-- is its largest spread about its own centre, so needles and plates have the size of their length.
local function sizes(d, m)
  local least, largest
  for _, p in ipairs(m.body.pieces) do
    local s = p.sigma and p.name ~= "tensor" and 0 or nil
    for i = 1, s and 3 or 0 do s = math.max(s, math.abs(m:double(p.sigma[i]))) end
    if s and s > 0 then
      local part = { size = math.sqrt(s), p = p }
      if not least or part.size < least.size then least = part end
      if not largest or part.size > largest.size then largest = part end
    end
  end
  if least and largest.size > 1e6 * least.size then
    d:warn(least.p.line, least.p.name, "is " .. diag.rough(largest.size / least.size) .. " times smaller than the " ..
      largest.p.name .. " of line " .. largest.p.line .. " in the same body: are both in one unit?")
  end
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
  local good = true
  each_tensor(m.record.body, function(node)
    local g = numbers(m, node)
    local list = faults(g.central, node.name == "inertial" and foreign or nil)
    good = report(d, node.line, "tensor", list, #list > 0 and slips.hint(g)) and good
    if #list == 0 then
      plausible(d, node.line, R.todouble(g.mass), vec.map(g.com, R.todouble), vec.map(g.central, R.todouble))
    end
  end)
  if not good then return false end
  sizes(d, m)
  local relative
  for _, p in ipairs(m.body.pieces) do relative = p.name == "inertial" and foreign or relative end
  return report(d, m.line, "body", faults(vec.map(J, function(e) return m:number(e) end), relative))
end

-- ---- what NAME_init must ask again ----

-- Half a unit in the last place of the emitted code's real type: a symbol that emit/ knows.
validity.roundoff = expr.sym("unit roundoff", 1, true)

-- Conditions under which S is positive semidefinite, as expressions >= 0; size: a bound of the terms it was added from.
-- Entries that were rounded, and added, are off by some 4 u size; a lamina or a rod (S singular) must pass with these.
-- So the test is made of S + 16 u size 1, which is then positive definite by 12 u size, more than the rounding of the
-- elimination itself can eat (Higham, Accuracy and Stability, 2nd ed., theorem 10.7: some 4 u of the largest entry).
-- The conditions are the pivots of elimination, not minors: each is as large as a moment, so none leaves the range of
-- float.
local function semidefinite(S, size)
  local shift = 16 * validity.roundoff * size
  local p = S[1] + shift
  if expr.iszero(S[4]) and expr.iszero(S[5]) and expr.iszero(S[6]) then
    return { p, S[2] + shift, S[3] + shift }, true -- may be zero
  end
  local second = S[2] + shift - S[4] ^ 2 / p
  return { p, second, S[3] + shift - S[5] ^ 2 / p - (S[6] - S[4] * S[5] / p) ^ 2 / second }
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
  local function lawful_at(S, size, what, line, named)
    if constant(S) then return end
    local pivots, zero = semidefinite(S, size)
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
    lawful_at(vec.second(I), size, "tensor", node.line)
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
    lawful_at(S, m.parts:size(signs), "body", m.line, true)
  elseif hole then
    lawful_at(vec.second(m.centroidal), size, "body", m.line)
  end
  return list
end

return validity
