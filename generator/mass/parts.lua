-- parts.lua -- the mass properties of a composite body in named steps, as a person writes them.
--
--     m1, m2, ...          masses of the pieces
--     mass = m1 + m2 ...   com = (m1 c1 + m2 c2 ...)/mass
--     d1 = c1 - com ...    I = sum over the pieces of  m (tr(sigma) 1 - sigma) + m (d^2 1 - d d^T)
-- and for two pieces about their centre of mass, with D = c2 - c1 and the reduced mass mu = m1 m2/mass,
--     I = I1 + I2 + mu (D^2 1 - D D^T).
-- Multiplied out, the entries of such a sum are polynomials that nobody can read, cost more and cancel more.  So each
-- step is an expression of the parameters and of the names before it; its `pure` is the same in the parameters alone,
-- for what must be decided exactly.
--
-- A hole of the body's own kind may nearly fill it: m1 - m2 cancels then, while multiplied out and factored the
-- thickness of the wall stands in front.  So with such holes the mass and the sums over the pieces' own moments are
-- taken in the parameters, and about any point two pieces take the reduced mass and the centre c1 + m2 D/mass.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local text = require "generator.formula.text"
local vec = require "generator.algebra.vec"
local maps = require "generator.mass.maps"

local parts = {}
parts.__index = parts

local short = 8 -- characters: a longer constant gets a name, so that formulas stay readable

local comp = { "x", "y", "z" }
local zero3 = { expr.zero, expr.zero, expr.zero }

-- Is the body composite, with parameters in it, or are there names for what several turns make?
function parts.wanted(b)
  if #b.names > 0 then return true end
  if #b.pieces < 2 then return false end
  for _, p in ipairs(b.pieces) do
    for _, e in ipairs { p.mass, p.com[1], p.com[2], p.com[3], table.unpack(p.sigma or {}) } do
      if not expr.constant(e) then return true end
    end
  end
  return false
end

-- e under the name, if it is not one already or a short number: the symbol, or e itself.
function parts:step(name, e, about, unit)
  if e.kind == "sym" or expr.constant(e) and #text.of(e) <= short then return e end
  local sym = expr.sym(self.unique(name), 3)
  local pure = calculus.substitute(e, self.pure)
  self.list[#self.list + 1] = { name = sym.name, sym = sym, e = e, pure = pure, about = about, unit = unit }
  self.pure[sym] = pure
  return sym
end

-- The part of the tensor that piece p adds in entry n, divided by its mass.
-- sigma_jj + sigma_kk on the diagonal, -sigma_jk beside it.
local function own(p, n)
  if not p.sigma then return expr.zero end
  if n > 3 then return -p.sigma[n] end
  return ratio.tidy(maps.own(p)[n])
end

-- The number that most moments of the piece have in front (1/12 for boxes), made a step with the mass.
local function scaled_mass(self, p, m, i)
  local count = {}
  for n = 1, p.given and 0 or 3 do
    local c = expr.split(own(p, n))
    local key = tostring(c)
    count[key] = (count[key] or 0) + 1
    if count[key] == 2 and c ~= R.one and R.sign(c) ~= 0 and m.kind ~= "num" then
      return c, self:step("k" .. i, c * m, "mass of piece " .. i .. " times " .. key, "kg")
    end
  end
  return nil, nil
end

-- Distances that a shift is made of: {x, y, z} as steps.
local function distances(self, name, v, about)
  return vec.map(v, function(e, k)
    if ratio.iszero(calculus.substitute(e, self.pure)) then return expr.zero end
    return self:step(name .. comp[k], e, string.gsub(about, "#", comp[k]), "m")
  end)
end

-- The sum of mass*f(piece) over the pieces, cancelled and factored; nil without such holes, or if it is too large.
function parts:gathered(f)
  if not self.hole then return nil end
  local sum = expr.zero
  for _, s in ipairs(self.pieces) do sum = sum + s.piece.mass * f(s.piece) end
  local e, small = ratio.tidy(sum)
  return small and e or nil
end

-- The steps of what is opaque; named: node -> symbol.
local function opened(self, names)
  for _, n in ipairs(names) do
    local sym = not self.named[n.node] and self:step(n.stem, self:shown(n.node[1]), n.about, n.unit)
    if sym then self.named[n.node] = sym end
    if sym and sym.kind == "sym" then self.pure[sym], self.list[#self.list].pure = n.node, n.node end
  end
end

-- An expression of the parameters with names for what is opaque.
function parts:shown(e) return next(self.named) and calculus.substitute(e, self.named) or e end

-- The body with these names in its pieces.
local function in_names(self, b)
  if not next(self.named) then return b end
  local function shown(e) return self:shown(e) end
  local out = { pieces = {}, com = vec.map(b.com, shown) }
  for i, p in ipairs(b.pieces) do
    out.pieces[i] = setmetatable({ com = vec.map(p.com, shown), sigma = p.sigma and vec.map(p.sigma, shown) },
      { __index = p })
  end
  return out
end

-- b: a body (mass/body.lua); P: the point the tensor is about, nil for its centre of mass; unique: name -> a name that
-- is not taken yet.  The result has list (the steps), mass, com, pieces {piece, m}, shifts {m, d}, and the methods
-- below.
function parts.of(b, P, unique)
  local self = setmetatable({ list = {}, pure = {}, unique = unique, pieces = {}, shifts = {}, own = {}, named = {} },
    parts)
  opened(self, b.names)
  b, P = in_names(self, b), P and vec.map(P, function(e) return self:shown(e) end)
  local mass, first = expr.zero, zero3
  local solid = {}
  for _, p in ipairs(b.pieces) do solid[p.name] = solid[p.name] or not p.hole end
  for _, p in ipairs(b.pieces) do self.hole = self.hole or p.hole and solid[p.name] end
  for i, p in ipairs(b.pieces) do
    local m = self:step("m" .. i, p.mass, "mass of piece " .. i .. ", " .. p.name, "kg")
    local s = { m = m, piece = p }
    s.content, s.k = scaled_mass(self, p, m, i)
    self.pieces[i] = s
    mass = mass + m
    first = vec.add(first, vec.map(p.com, function(c) return m * c end))
  end
  self.mass = self:step("mass", self:gathered(function() return expr.one end) or mass, "mass", "kg")
  local two, D = #b.pieces == 2 and (self.hole or not P), nil
  if two then D = vec.map(vec.sub(b.pieces[2].com, b.pieces[1].com), ratio.tidy) end
  self.com = vec.map(b.com, function(pure, k)
    if pure.kind == "num" or pure.kind == "sym" then return pure end
    local e = self.hole and two and b.pieces[1].com[k] + self.pieces[2].m * D[k] / self.mass or first[k] / self.mass
    return self:step("com_" .. comp[k], e, "centre of mass " .. comp[k] ..
      " in the coordinates of the shape", "m")
  end)
  if two then
    local mu = self:step("mu", self.pieces[1].m * self.pieces[2].m / self.mass, "reduced mass m1 m2/mass", "kg")
    self.shifts[1] = { m = mu, d = distances(self, "D", D, "centroid # of piece 2 from that of piece 1"), mu = true }
    if P then
      self.shifts[2] = { m = self.mass, d = distances(self, "d", vec.sub(self.com, P),
        "centre of mass, # from the origin of rotation"), whole = true }
    end
  else
    local about = P and "the origin of rotation" or "the centre of mass"
    for i, s in ipairs(self.pieces) do
      self.shifts[i] = { m = s.m, d = distances(self, "d" .. i, vec.sub(s.piece.com, P or self.com),
        "piece " .. i .. ", centroid # from " .. about) }
    end
  end
  for i, s in ipairs(self.shifts) do
    local name, of = "u" .. i, " of piece " .. i
    if s.mu then name, of = #self.shifts == 1 and "u" or "U", ", mu D" end
    if s.whole then name, of = "u", " of the whole" end
    s.u = vec.map(s.d, function(d, k)
      if d == expr.zero then return d end
      return self:step(name .. comp[k], s.m * d, "first moment " .. comp[k] .. of, "kg m")
    end)
  end
  return self
end

-- m e for piece s, with the number in front taken into its step.
-- M/12 (b^2 + c^2) ==> k1 (b^2 + c^2), k1 = M/12
local function times(s, e)
  local c, rest = expr.split(e)
  if s.k and R.abs(c) == R.abs(s.content) then return c / s.content * s.k * rest end
  return s.m * e
end

-- Entry n of the tensor, in names.
-- The shifts are sums of first moment times distance, u_j d_k with u = m d.
function parts:entry(n)
  local shift = expr.zero
  for _, s in ipairs(self.shifts) do
    local function moment(j, k) return s.u[j] * s.d[k] end
    if n > 3 then
      shift = shift - moment(vec.pair[n][1], vec.pair[n][2])
    else
      shift = shift + moment(n % 3 + 1, n % 3 + 1) + moment((n + 1) % 3 + 1, (n + 1) % 3 + 1)
    end
  end
  local sum = self:gathered(function(p) return own(p, n) end)
  if sum then
    if shift == expr.zero then return sum end
    self.own[n] = self.own[n] or self:step("O" .. vec.entry[n], sum, "the pieces' own " .. vec.entry[n], "kg m^2")
    return shift + self.own[n]
  end
  sum = shift
  for _, s in ipairs(self.pieces) do
    sum = sum + (s.piece.given and s.piece.given[n] or times(s, own(s.piece, n)))
  end
  return sum
end

-- Second moment n (of x x for n = 1, of x y for n = 4) in names: the part of the mass matrix that must be positive.
function parts:second(n)
  local sum, p = self:gathered(function(piece) return piece.sigma and piece.sigma[n] or expr.zero end), vec.pair[n]
  for _, s in ipairs(sum and {} or self.pieces) do
    sum = (sum or expr.zero) + (s.piece.sigma and times(s, s.piece.sigma[n]) or expr.zero)
  end
  for _, s in ipairs(self.shifts) do sum = sum + s.u[p[1]] * s.d[p[2]] end
  return sum
end

-- I_jj - I_kk, piece by piece: the common part of two moments is never formed.
function parts:difference(j, k)
  local sum = self:gathered(function(p) return p.sigma and p.sigma[k] - p.sigma[j] or expr.zero end)
  for _, s in ipairs(sum and {} or self.pieces) do
    local p = s.piece
    sum = sum or expr.zero
    if p.given then
      sum = sum + ratio.tidy(p.given[j] - p.given[k])
    elseif p.sigma then
      sum = sum + times(s, ratio.tidy(p.sigma[k] - p.sigma[j]))
    end
  end
  for _, s in ipairs(self.shifts) do sum = sum + s.m * (s.d[k] - s.d[j]) * (s.d[k] + s.d[j]) end
  return sum
end

-- An expression in names as one in the parameters.
function parts:resolve(e) return calculus.substitute(e, self.pure) end

-- A bound of the terms that the trace of the tensor is added from; signs: of the pieces' masses.
function parts:size(signs)
  local sum = expr.zero
  for i, s in ipairs(self.pieces) do
    local sigma = s.piece.sigma
    if sigma then sum = sum + 2 * signs[i] * s.m * (sigma[1] + sigma[2] + sigma[3]) end
  end
  for i, s in ipairs(self.shifts) do
    local sign = s.whole and 1 or s.mu and signs[1] * signs[2] or signs[i] -- mu = m1 m2/mass
    sum = sum + 2 * sign * s.m * vec.dot(s.d, s.d)
  end
  return sum
end

-- The steps that the expressions in the list need, in order.
function parts:needed(list)
  local needed, by_sym = {}, {}
  for _, s in ipairs(self.list) do by_sym[s.sym] = s end
  local function mark(e)
    for _, s in ipairs(expr.symbols(e)) do
      local step = by_sym[s]
      if step and not needed[step] then
        needed[step] = true
        mark(step.e)
      end
    end
  end
  for _, e in ipairs(list) do mark(e) end
  local out = {}
  for _, s in ipairs(self.list) do
    if needed[s] then out[#out + 1] = s end
  end
  return out
end

return parts
