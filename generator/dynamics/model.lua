-- model.lua -- the validated scene as physics: mass, tensors, structure and states.
--
-- The model answers "what is this body" once, exactly; equations, closed forms and reports read it, and nothing is
-- added to it: what is asked for on the way is kept in a pool of constants (dynamics/constants.lua).  Its fields are
-- named in generator/stages.lua.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local calculus = require "generator.algebra.calculus"
local coordinate = require "generator.algebra.coordinate"
local cost = require "generator.algebra.cost"
local ratio = require "generator.algebra.ratio"
local text = require "generator.formula.text"
local vec = require "generator.algebra.vec"
local body = require "generator.mass.body"
local holes = require "generator.mass.holes"
local overlaps = require "generator.mass.overlaps"
local jacobi = require "generator.mass.jacobi"
local parts = require "generator.mass.parts"
local principal = require "generator.mass.principal"
local law = require "generator.mass.law"
local validity = require "generator.mass.validity"
local within = require "generator.mass.within"
local inputs = require "generator.dynamics.inputs"
local numeric = later "generator.dynamics.numeric"
local states = require "generator.dynamics.states"
local stages = require "generator.stages"

local model = {}

-- Bits of a value that is no rational number (sqrt(2), pi/3).
local bits = 240

-- The value of e for the parameters' defaults, as a rational: exact for a rational function, else to `bits` bits.  They
-- are put in first, for then sin(pi n) of n = 1 is 0 and not what rounding leaves of it.
function model:number(e)
  local ok, value = pcall(evaluate.exact, e, self.defaults)
  if ok then return value end
  local map = {}
  for _, s in ipairs(expr.symbols(e)) do
    if self.defaults[s.name] then map[s] = expr.lift(self.defaults[s.name]) end
  end
  local opened, constant = pcall(calculus.substitute, e, map)
  return evaluate.precise(opened and constant or e, self.defaults, bits)
end

-- What it means that NAME_init returns the status: the words of its check, nil for 0.
function model:refusal(status)
  if status == 0 then return nil end
  local c = self.conditions[status]
  return c and c.text or "a constant or the first step is no finite number"
end

-- The symbols in conditions that allow for the rounding of the real type, see mass/validity.lua.
function model.rounding(_, unit) return validity.rounding(unit) end

function model:double(e) return R.todouble(self:number(e)) end

-- Components of the vectors that emitted functions take (dynamics/quantities.lua): no constant is called so.
local arguments = {}
for _, v in ipairs { "w", "dw", "a", "da", "r", "v" } do
  for _, c in ipairs { "x", "y", "z" } do arguments[v .. c] = true end
end

-- The name, or the name with a number after it, whichever is free; taken: a set of further names that are not.
function model:unique(name, taken)
  local unique, n = name, 1
  while self.by_name[unique] or arguments[unique] or taken and taken[unique] do
    n = n + 1
    unique = name .. n
  end
  return unique
end

-- Origin of rotation in the shape's frame; reports an unknown named point.
local function origin(d, record, b)
  local o = record.origin
  if not o then return nil end
  if o.kind == "point" then return o.r end
  local r = b.points[o.name]
  if not r then
    local names = {}
    for k in pairs(b.points) do names[#names + 1] = k end -- in hash order, so:
    table.sort(names)
    d:error(o.line, "origin", "must be one of " .. table.concat(names, ", ") .. " or {x, y, z}",
      string.format("%q", o.name))
  end
  return r
end

-- The record with symbols replaced at any depth, but for the effects' specs and the parameters themselves.
local function substituted(record, map)
  local function s(e) return calculus.substitute(e, map) end
  local function walk(x)
    if expr.is(x) then return s(x) end
    if type(x) ~= "table" then return x end
    local y = {}
    for k, v in pairs(x) do y[k] = (k == "spec") and v or walk(v) end -- into a table: order is lost anyway
    return y
  end
  local out = {}
  for k, v in pairs(record) do out[k] = k == "params" and v or walk(v) end -- order is lost anyway
  return out
end

-- A rule in the words that all doors have for it; c: {what =, rule =, line =}.
function model:sentence(c)
  local place = c.line and " (" .. string.match(self.file, "[^/]*$") .. ":" .. c.line .. ")" or ""
  return c.what .. ": " .. c.rule .. place
end

-- What NAME_init must test again: every condition on parameters once, with the scene's line; of two on one expression
-- the stricter.  Second result: the rules that it cannot test; nil if a hole is not in its body.
local function conditions(d, m, checks)
  local list, seen = {}, {}
  local function put(c)
    local before = seen[c.e]
    if expr.constant(c.e) or before and (c.allow_zero or not before.allow_zero) then return end
    local entry = before or {}
    if not before then list[#list + 1] = entry end
    seen[c.e] = entry
    local form = c.form or m.parts and m.parts:shown(c.e) or c.e
    entry.e, entry.form, entry.opaque, entry.allow_zero = c.e, form, c.opaque, c.allow_zero
    entry.text = m:sentence(c)
  end
  for _, c in ipairs(checks) do put(c) end
  local own, open = validity.conditions(m)
  for _, c in ipairs(own) do put(c) end
  return within.hold(d, m, own) and list or nil, open
end

-- w' = I^-1 (L x w) with an oblique tensor loses as many digits as I has in its condition number; say so from 1e8 on.
local function warn_of_condition(d, m)
  if m.structure.kind ~= "full" then return end
  local moments = jacobi.run(vec.map(m.inertia, function(e) return m:number(e) end))
  local digits = math.log(moments[3] / math.max(moments[1], moments[3] * 2.0 ^ -60), 10)
  if digits >= 8 then
    d:warn(m.line, "body", string.format("the tensor about the origin of rotation has a condition number of 1e%d: " ..
      "the equations of motion lose that many digits (an origin at the centroid, or principal axes, would keep them)",
      math.floor(digits)))
  end
end

-- m.carried, the tensor that the rates carry, and its structure m.carrier: the body's without the moments of wheels
-- that the body's tensor includes.  It must be positive definite: its leading minors are.  m.locked is the tensor with
-- all wheels held still, whether the body's includes them or not.
local function carry(d, m, checks)
  m.carried, m.carrier, m.locked = m.inertia, m.structure, m.inertia
  local first
  for _, e in ipairs(m.record.effects) do
    local part, more = e.spec.carries and e.spec.carries(e.a), e.spec.locks and e.spec.locks(e.a)
    if part then m.carried, first = vec.map(vec.add(m.carried, part), ratio.tidy), first or e end
    if more then m.locked = vec.map(vec.add(m.locked, more), ratio.tidy) end
  end
  if not first then return true end
  local I = m.carried
  local minors = { I[1], I[1] * I[2] - I[4] ^ 2, select(2, vec.adjugate(I)) }
  local rule = "the tensor must stay positive without the wheels that it includes (included = true)"
  for i, minor in ipairs(minors) do
    minor = ratio.tidy(minor)
    if R.sign(m:number(minor)) <= 0 then
      d:error(first.line, "wheel", rule, "leading minor " .. i .. " = " .. string.format("%.17g", m:double(minor)))
      return false
    end
    if not expr.constant(minor) then
      checks[#checks + 1] = { e = minor, what = "wheel", rule = rule, line = first.line }
    end
  end
  m.carrier = principal.classify(m.carried)
  return true
end

-- Characters of the expressions, and whether a number of nine digits or more is among them.
local function length(list)
  local n, long = 0, false
  for _, e in ipairs(list) do
    local s = text.of(e)
    n, long = n + #s, long or string.find(s, string.rep("%d", 9)) ~= nil
  end
  return n, long
end

-- The body in named steps, unless its tensor multiplied out is less work and less to read; its names are then taken.
-- A body with a hole of its own kind always: its steps are those that do not cancel; so one with opaque parts.
-- Multiplied out it is less to read if no number has nine digits and it has at most twice the characters.
local function in_parts(m, b, r)
  local taken = {} -- by inputs, which stand beside these names in what is printed
  for _, s in ipairs(inputs.of(nil, m.record)) do taken[s.name] = true end
  local p = parts.of(b, r, function(name)
    local unique = m:unique(name, taken)
    taken[unique] = true
    return unique
  end)
  local entries, steps = {}, {}
  for n = 1, 6 do entries[n] = m.inertia[n].kind == "num" and m.inertia[n] or p:entry(n) end
  if not p.hole and not next(p.named) then
    for _, s in ipairs(p:needed(entries)) do steps[#steps + 1] = s.e end
    local known = {}
    local cheaper = cost(m.inertia) <= cost(steps, known) + cost(entries, known)
    local whole, long = length(m.inertia)
    if cheaper and not long and whole <= 2 * ((length(steps)) + (length(entries))) then return nil end
  end
  for _, s in ipairs(p.list) do m.by_name[s.name] = s end
  p.entries, p.central = entries, r == nil
  return p
end

-- d: diagnostics; record: what the scene language made; options: {bake = boolean, set = {name -> rational}}.
-- Returns nil after errors.
function model.new(d, record, options)
  local m = stages.open("model", model)
  m.name, m.by_name, m.defaults, m.params = record.name, {}, {}, record.params
  local map, symbolic = {}, record
  for _, p in ipairs(record.params) do
    m.defaults[p.name] = p.default
    if options.bake then map[p.sym] = expr.num(p.default) end
  end
  if options.bake then
    record = substituted(record, map)
    m.params = {}
  end
  for _, p in ipairs(m.params) do m.by_name[p.name] = p end
  m.record, m.symbolic, m.baked = record, symbolic, options.bake or false
  m.file, m.line = d.file, record.body and record.body.line
  m.omega, m.attitude, m.given, m.horizon, m.step = record.omega, record.attitude, record.given, record.horizon,
    record.step

  local ok, b = xpcall(body.of, function(e)
    return e == coordinate.too_large and e or debug.traceback(tostring(e), 2)
  end, record.body)
  if not ok and b == coordinate.too_large then
    d:error(m.line, "region", "its integrals must have fewer terms (limits or density of lower degree)")
    return nil
  elseif not ok then
    error(b, 0)
  end
  local r = origin(d, record, b)
  if not r then return nil end
  m.body, m.mass, m.origin = b, b.mass, r
  m.com = vec.map(vec.sub(b.com, r), ratio.tidy)
  m.inertia, m.centroidal = body.tensor(b, r), body.tensor(b, b.com)
  if parts.wanted(b) then
    local central = record.origin.kind == "named" and record.origin.name == "centroid"
    m.parts = in_parts(m, b, not central and r or nil)
  end
  -- a hole that reaches out is the cause of what else is wrong, so it is said alone
  local apart, whole = not overlaps.any(m.record.body), not holes.any(m.record.body)
  local tree = not (apart and whole) and numeric.scene({ model = m, record = m.record }).body
  local sound = whole or holes.check(d, m, tree)
  if sound and not apart then overlaps.check(d, m, tree) end
  if not sound or not validity.check(d, m) then return nil end
  m.structure = principal.classify(m.inertia)
  m.inputs = inputs.of(d, m.record)
  m.limits = inputs.limits(m.inputs)
  if not states.decide(d, m) then return nil end
  if m.structure.nothing and m.has.rates then
    d:error(m.line, "body", law.nothing "the origin")
    return nil
  end
  if not carry(d, m, record.checks) then return nil end
  m.conditions, m.unasked = conditions(d, m, record.checks)
  if not m.conditions then return nil end
  warn_of_condition(d, m)
  return stages.close(m)
end

-- The same body and states with these of its effects alone: for what is compared.
function model:variant(effects)
  local v = stages.copy(self)
  v.by_name, v.record, v.frame = {}, {}, nil
  for k, x in pairs(self.record) do v.record[k] = x end -- order is lost anyway
  v.record.effects = effects
  for _, p in ipairs(v.params) do v.by_name[p.name] = p end
  for _, s in ipairs(v.parts and v.parts.list or {}) do v.by_name[s.name] = s end
  local here = {}
  for _, e in ipairs(effects) do
    here[e] = true
    if e == self.frame then v.frame = e end
  end
  v.states = { by_name = {} }
  for _, s in ipairs(self.states) do
    if not s.effect or here[s.effect] then
      v.states[#v.states + 1] = s
      v.states.by_name[s.name] = s
    end
  end
  carry({ error = function() end }, v, {}) -- of what was accepted, so it is
  return stages.close(v)
end

return model
