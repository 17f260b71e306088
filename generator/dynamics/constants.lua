-- constants.lua -- the pool of derived constants: what NAME_init computes once and keeps.
--
-- A derived constant is an expression of parameters; asking twice for the same expression gives the same constant, a
-- number stays a number, and with `bake` every parameter is a number and no constant is left.  A pool belongs to those
-- who ask: the equations of a scene have one, and each plan goes on with a copy of it, so that nothing is left in the
-- scene of what a plan has asked for.  The model itself never changes; a pool reads it, and so stands for the model
-- wherever constants may be asked for.  ABOVE the line.
--     members     the constants in the order they were asked for: {name, e, form, about, sym, positive, multiple}
--     by_name     these, and everything else whose name is taken
--     rounded     has a number been rounded to `bits`?
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local calculus = require "generator.algebra.calculus"
local cost = require "generator.algebra.cost"
local ratio = require "generator.algebra.ratio"

local constants = {}

-- Bits kept of a constant that is no rational number (sqrt(2), pi/3) when it becomes one.
local bits = 240

local function copied(t)
  local copy = {}
  for k, x in pairs(t) do copy[k] = x end -- into a table: order is lost anyway
  return copy
end

-- A pool with nothing in it.
function constants.open(model)
  local own = { of = model, members = {}, by_expr = {}, by_name = copied(model.by_name), rounded = false,
    finer = false, closed = false }
  return setmetatable(own, { __index = function(_, name)
    local method = constants[name]
    if method then return method end
    return model[name]
  end })
end

-- A pool that goes on where this one is, for somebody else.  finer: with twice the bits in numbers.
function constants:fork(finer)
  local own = constants.open(self.of)
  own.by_name, own.rounded, own.finer = copied(self.by_name), self.rounded, finer or self.finer
  for i, member in ipairs(self.members) do
    local copy = copied(member)
    own.members[i], own.by_expr[member.e], own.by_name[member.name] = copy, copy, copy
  end
  return own
end

-- All are made: a new one is an error from here on.
function constants:close()
  self.closed = true
  return self
end

-- A pool of the same body with these of its effects alone.
function constants:variant(effects) return constants.open(self.of:variant(effects)) end

-- A derived constant; see the head.  Returns the expression to use in equations.  raw: keep e's form; form: the same
-- in the names of the body's parts and of constants made before, to be computed so when that costs less.
function constants:constant(name, e, about, raw, form)
  if not raw then e = ratio.tidy(e) end
  -- of opaque parts, what they have to do with each other may make it 0
  if self.parts and next(self.parts.named) and ratio.iszero(e) then e = expr.zero end
  if e.kind == "num" then return e end
  local limit = self.limits and self.limits[e]
  if limit then name, about = limit.name, limit.about end
  if expr.constant(e) then
    self.rounded = true
    return expr.num(evaluate.precise(e, {}, self.finer and 2 * bits or bits))
  end
  local member = self.by_expr[e]
  if not member then
    if self.closed then error("the pool is closed: no constant " .. name .. " is made", 2) end
    if form == e then form = nil end
    local step = form and form.kind == "sym" -- it has its name already
    local unique = step and form.name or self:unique(name)
    local careful = self.parts and self.parts.hole -- its forms do not cancel
    if form and not step and not careful and cost { e } <= cost { form } then form = nil end
    form = form or self.parts and self.parts:shown(e) or e
    member = { name = unique, e = e, form = form, about = about, sym = expr.sym(unique, 3) }
    self.by_expr[e], self.by_name[unique] = member, member
    self.members[#self.members + 1] = member
  end
  return member.sym
end

-- Is e a derived constant, NAME_init refuses parameters for which it is not above 0.
function constants:positive(e)
  local member = e.kind == "sym" and self.by_name[e.name]
  if member then member.positive = true end
end

-- Is e a derived constant, it is known as entry n of J, the inverse of the tensor that the body turns with: its
-- derivatives have a form in J then (dynamics/sensitivity.lua).
function constants:inverse(e, J, n)
  local member = e.kind == "sym" and self.by_name[e.name]
  if member then member.inverse = { J = J, entry = n } end
end

-- A constant made of other derived constants (a multiple, say); nil if e depends on anything else.
function constants:derived(e, about)
  local map, source = {}, nil
  for _, member in ipairs(self.members) do
    map[member.sym] = member.e
    if not source and not expr.constant(e, { [member.name] = true }) then source = member end
  end
  local inlined = calculus.substitute(e, map)
  local params = {}
  for _, p in ipairs(self.params) do params[p.sym] = true end
  for _, s in ipairs(expr.symbols(inlined)) do
    if not params[s] then return nil end
  end
  local stem = source and source.name or "constant"
  local multiple = source and select(2, expr.split(e)) == source.sym
  local raw = multiple or self.parts ~= nil
  local sym = self:constant(stem .. "_" .. string.gsub(about, "%W", ""), inlined,
    about .. (source and source.about or ""), raw, raw and e or nil)
  if self.by_name[sym.name] then self.by_name[sym.name].multiple = true end
  return sym
end

return constants
