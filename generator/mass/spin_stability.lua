-- spin_stability.lua -- about which principal axes a free body spins stably, as conditions on its parameters.
--
-- A spin about principal axis k of a free body (Landau, Lifshitz, Mechanics, section 37; Goldstein, 5.6):
--     no dissipation     stable iff I_k is the largest or the smallest moment, unstable iff it lies between the others
--     with dissipation   the energy falls while L is kept, T = L^2/(2 I): stable iff I_k is the largest (the major-axis
--                        rule: Likins, Spacecraft attitude dynamics, J. Spacecraft 4 (1967) 1638; Hughes, Spacecraft
--                        Attitude Dynamics, 1986, chapter 7), unstable iff any other moment is larger
-- Equal moments are neutral.  So all that matters is three signs, of I_y - I_z, I_z - I_x, I_x - I_y; mass/critical
-- reduces each difference to the atoms that decide it.  ABOVE the line, exact.
--
-- Axes by the structure of the tensor (mass/principal.lua):
--     sphere, symmetric or diagonal on the coordinate axes    x, y, z
--     symmetric about an oblique line                         across it, across it, the line
--     one off-diagonal entry I_ij, a block                    the third coordinate axis keeps its place; of i < j the
--                                                             lesser moment of their plane takes i, the greater j
--     full                                                    no closed form: `axes` is nil
-- A lamina's moment about its normal is the sum of the two others, so the normal is the axis of the largest moment,
-- whatever the parameters.
-- In a block, with c the third axis,  I_c - I_greater  and  I_c - I_lesser  are the roots' own differences; their signs
-- follow from  D = (I_c - I_i)(I_c - I_j) - I_ij^2  (their product) and  S = 2 I_c - I_i - I_j  (their sum): no root.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local critical = require "generator.mass.critical"
local text = require "generator.formula.text"
local vec = require "generator.algebra.vec"

local stability = {}
stability.__index = stability

local names = { "x", "y", "z" }

---- the three signs -----------------------------------------------------------------------------------

-- A sign as the product of a constant and of atoms' signs.
local function product(c, e)
  local sign, atoms = c:signs(e)
  return { sign = sign, atoms = atoms }
end

-- Has the body some area or volume?  Then no moment of inertia of it is 0, while particles and wires may lie on a line.
local function extended(m)
  for _, p in ipairs(m.body.pieces) do
    if p.measure == "area" or p.measure == "volume" then return true end
  end
  return false
end

-- The sign of I_a - I_b.  Of a lamina in the plane of two axes it is that of a moment: I_a - I_b = I_c.
local function difference(m, c, a, b)
  local I, third = m.inertia, 6 - a - b
  for _, sign in ipairs { 1, -1 } do
    if ratio.iszero(I[a] - I[b] - sign * I[third]) then
      if extended(m) then return { sign = sign, atoms = {} } end
      local of = product(c, I[third])
      return { sign = sign * of.sign, atoms = of.atoms }
    end
  end
  return product(c, I[a] - I[b])
end

-- The number of the coordinate axis along k, or nil.
local function coordinate(k)
  local found
  for i = 1, 3 do
    if k[i] ~= expr.zero then
      if found then return nil end
      found = i
    end
  end
  return found
end

-- The same signs' expressions in the names of a composite body's parts, for code: multiplied out they are unreadable
-- and cancel.  nil for other bodies.
local function named(m, s, across)
  local p = m.parts
  if not p or across then return nil end
  if s.kind == "full" then
    local i, j, k = table.unpack(s.block)
    local ki, kj, ij = p:difference(k, i), p:difference(k, j), p:entry(vec.index[i][j])
    return { D = ki * kj - ij ^ 2, S = ki + kj, gap = p:difference(i, j) ^ 2 + 4 * ij ^ 2 }
  end
  return { p:difference(2, 3), p:difference(3, 1), p:difference(1, 2) }
end

-- The stability of the model's body: {critical, axes = three names, order = three signs (I_j - I_k for axis i, cyclic)
-- or block = {c =, i =, j =, D =, S =, gap =}, named = their expressions in the parts or nil, parts}.
function stability.of(m)
  local self = setmetatable({ critical = critical.of(m.conditions), inertia = m.inertia, parts = m.parts }, stability)
  local c, I, s = self.critical, m.inertia, m.structure
  local line = s.kind == "symmetric" and coordinate(s.k)
  if s.kind == "symmetric" and not line then
    self.axes = { "any axis across the symmetry axis", "any axis across the symmetry axis", "the symmetry axis" }
    self.line = { s.k[1], s.k[2], s.k[3] }
    local up = product(c, s.axial - s.alpha)
    self.order = { { sign = -up.sign, atoms = up.atoms }, up, { sign = 0, atoms = {} } }
  elseif s.kind == "full" and s.block then
    local i, j, k = table.unpack(s.block)
    local p = I[vec.index[i][j]]
    self.axes = {}
    self.axes[k] = "axis " .. names[k]
    self.axes[i] = "the axis of lesser moment in " .. names[i] .. "-" .. names[j]
    self.axes[j] = "the axis of greater moment in " .. names[i] .. "-" .. names[j]
    self.block = { c = k, i = i, j = j, gap = product(c, (I[i] - I[j]) ^ 2 + 4 * p ^ 2) }
    if extended(m) and ratio.iszero(I[k] - I[i] - I[j]) then -- a lamina: D = I_i I_j - I_ij^2, S = I_i + I_j
      self.block.D, self.block.S = { sign = 1, atoms = {} }, { sign = 1, atoms = {} }
    else
      self.block.D = product(c, (I[k] - I[i]) * (I[k] - I[j]) - p ^ 2)
      self.block.S = product(c, 2 * I[k] - I[i] - I[j])
    end
  elseif s.kind ~= "full" then
    self.axes = { "axis x", "axis y", "axis z" }
    self.order = {}
    for i = 1, 3 do self.order[i] = difference(m, c, i % 3 + 1, (i + 1) % 3 + 1) end
  end
  self.named = self.axes and named(m, s, self.line) or nil
  return self
end

-- Every atom that decides, once.
function stability:atoms()
  local list, seen = {}, {}
  local function put(s)
    for _, a in ipairs(s.atoms) do
      if not seen[a] then
        seen[a] = true
        list[#list + 1] = a
      end
    end
  end
  for _, s in ipairs(self.order or {}) do put(s) end
  if self.block then
    put(self.block.D)
    put(self.block.S)
    put(self.block.gap)
  end
  return list
end

-- The sign of one of them, when those of its atoms are known.
local function sign_of(s, sign)
  local v = s.sign
  for _, a in ipairs(s.atoms) do v = v * sign(a) end
  return v
end

-- The signs of I_j - I_k for i = 1, 2, 3 (cyclic); sign(atom) gives an atom's.
function stability:signs(sign)
  if self.order then
    return { sign_of(self.order[1], sign), sign_of(self.order[2], sign), sign_of(self.order[3], sign) }
  end
  local b = self.block
  local D, S, gap = sign_of(b.D, sign), sign_of(b.S, sign), sign_of(b.gap, sign)
  -- D < 0: I_c between the two; D > 0: beyond both, on the side of S; D = 0: equal to one, to the lesser where S < 0
  local above_greater = D < 0 and -1 or D > 0 and S or S < 0 and -1 or 0
  local above_lesser = D < 0 and 1 or D > 0 and S or S > 0 and 1 or 0
  local out = {}
  local function put(p, q, s) -- the sign of I_p - I_q
    local forward = p % 3 + 1 == q
    out[6 - p - q] = forward and s or -s
  end
  put(b.c, b.j, above_greater)
  put(b.c, b.i, above_lesser)
  put(b.i, b.j, -gap)
  return out
end

-- 1 stable, 0 neutral, -1 unstable: the spin about axis k, from the three signs.
-- The largest moment has up > 0 and down > 0, the least both < 0, the middle one of each.
function stability.verdict(signs, k, dissipation)
  local up, down = signs[(k + 1) % 3 + 1], -signs[k % 3 + 1] -- of I_k - I_i and I_k - I_j, k, i, j cyclic
  if not dissipation then return up * down end
  if up < 0 or down < 0 then return -1 end
  return up * down
end

---- conditions as trees -------------------------------------------------------------------------------
-- true, false, {op = "and"/"or", a, b} or a leaf {atoms =, relation = ">" or "<" or "≠"}: the atoms' product against 0.

-- The condition that s has the relation to 0; an atom of even power leaves only that it is not zero.
local function leaf(s, relation)
  if s.sign == 0 then return false end
  if s.sign < 0 then relation = relation == ">" and "<" or ">" end
  if #s.atoms == 0 then return relation == ">" end
  local atoms, count = {}, {}
  for _, a in ipairs(s.atoms) do count[a] = (count[a] or 0) + 1 end
  local square = true
  for _, a in ipairs(s.atoms) do
    if count[a] then
      atoms[#atoms + 1] = a
      square = square and count[a] % 2 == 0
      count[a] = nil
    end
  end
  if square then
    if relation == "<" then return false end
    relation = "≠"
  end
  return { atoms = atoms, relation = relation }
end

-- Are both leaves of the same atoms?
local function same(a, b)
  if a == b then return true end
  if type(a) ~= "table" or type(b) ~= "table" or a.op or b.op or #a.atoms ~= #b.atoms then return false end
  for i = 1, #a.atoms do
    if a.atoms[i] ~= b.atoms[i] then return false end
  end
  return true
end

local function both(a, b)
  if a == false or b == false then return false end
  if a == true then return b end
  if b == true then return a end
  if same(a, b) then return a.relation == b.relation and a or false end
  return { op = "and", a, b }
end

-- > or < of the same is ≠.
local function either(a, b)
  if a == true or b == true then return true end
  if a == false then return b end
  if b == false then return a end
  if same(a, b) and a.relation ~= b.relation then return { atoms = a.atoms, relation = "≠" } end
  return { op = "or", a, b }
end

local function negative(s) return { sign = -s.sign, atoms = s.atoms } end

-- The tree of "the spin about axis k is stable".
function stability:tree(k, dissipation)
  local i, j = k % 3 + 1, (k + 1) % 3 + 1
  if self.order then
    local up, down = self.order[j], negative(self.order[i])
    local largest = both(leaf(up, ">"), leaf(down, ">"))
    if dissipation then return largest end
    return either(largest, both(leaf(up, "<"), leaf(down, "<")))
  end
  local b = self.block
  local outside, above, below = leaf(b.D, ">"), leaf(b.S, ">"), leaf(b.S, "<")
  local gap = leaf(b.gap, ">")
  if k == b.c then return dissipation and both(outside, above) or outside end
  if k == b.j then return both(gap, either(leaf(b.D, "<"), below)) end -- the greater: stable iff c is not above it
  if dissipation then return false end
  return both(gap, either(leaf(b.D, "<"), above))
end

-- The one parameter that stands in every atom of the tree, if there is just one.
local function common(tree)
  local count, atoms, symbols = {}, 0, {}
  local function walk(t)
    if type(t) ~= "table" then return end
    if t.op then
      walk(t[1])
      walk(t[2])
      return
    end
    for _, a in ipairs(t.atoms) do
      atoms = atoms + 1
      for _, s in ipairs(expr.symbols(a)) do
        if not count[s] then symbols[#symbols + 1] = s end
        count[s] = (count[s] or 0) + 1
      end
    end
  end
  walk(tree)
  local found
  for _, s in ipairs(symbols) do
    if count[s] == atoms and atoms > 1 then
      if found then return nil end
      found = s
    end
  end
  return found
end

-- The tree as text; true and false as words.
function stability:text(tree, style)
  style = style or "unicode"
  local prefer = common(tree)
  local function render(t, inside)
    if t == true then return "always" end
    if t == false then return "never" end
    if t.op then
      local s = render(t[1], t.op) .. " " .. t.op .. " " .. render(t[2], t.op)
      return inside and inside ~= t.op and "(" .. s .. ")" or s
    end
    if #t.atoms == 1 then return self.critical:condition(t.atoms[1], t.relation, style, prefer) end
    local list = {}
    for i, a in ipairs(t.atoms) do list[i] = "(" .. text.of(a, style) .. ")" end
    local relation = t.relation
    if relation == "≠" and style ~= "unicode" then relation = "!=" end
    return table.concat(list, style == "plain" and "*" or " ") .. " " .. relation .. " 0"
  end
  return render(tree)
end

-- "I_y = I_z" for an atom that decides between the moments of two coordinate axes; nil for others.
function stability:equality(atom)
  for i = 1, self.order and not self.line and 3 or 0 do
    for _, a in ipairs(self.order[i].atoms) do
      if a == atom then return "I_" .. names[i % 3 + 1] .. " = I_" .. names[(i + 1) % 3 + 1] end
    end
  end
  return nil
end

-- Is axis k one of two whose moments are equal whatever the parameters?
function stability:paired(k)
  if not self.order then return false end
  return self.order[k % 3 + 1].sign == 0 or self.order[(k + 1) % 3 + 1].sign == 0
end

-- For such an axis, with dissipation: the tree of "neutral" (elsewhere the spin is unstable).
function stability:neutral(k)
  local up, down = self.order[(k + 1) % 3 + 1], negative(self.order[k % 3 + 1])
  if up.sign == 0 and down.sign == 0 then return true end
  return leaf(up.sign == 0 and down or up, ">")
end

-- What is said of axis k: the condition as text, words where two moments are equal.
function stability:condition(k, dissipation, style)
  if not self:paired(k) then return self:text(self:tree(k, dissipation), style) end
  local neutral = self:neutral(k)
  if not dissipation or neutral == true then return "never (neutral: equal moments)" end
  if neutral == false then return "never" end
  return "never (neutral if " .. self:text(neutral, style) .. ")"
end

return stability
