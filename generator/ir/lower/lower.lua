-- lower.lua: from a program over exact expressions to the IR.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- This is the line.  Above it the expressions are real algebra, so here, and for the last time, the
-- form of evaluation is free: expressions become forms (form.lua: common factors, quotients, roots,
-- differences of squares), forms share their parts (share.lua), scales, signs and factors are placed (size.lua,
-- orient.lua), and the chosen order is written down as instructions (select.lua).  From then on
-- values are IEEE numbers and nothing is reordered.
--
-- A program is { name, inputs = { { sym, c } }, groups = { { why, where, defs, outs } } }; a def is
-- { name, expr }, an out { c, expr, op }.  A def that is merely an input, another def or a constant
-- is replaced by it; one that no result needs is left out, and so are expressions never used.
-- Constants that are no rationals (pi, sqrt 2, sin 1) become dyadic rationals of form.BITS bits.
--
-- What is promised: for real arithmetic the instructions compute what the expressions mean, wherever denominators are
-- not zero.  For IEEE arithmetic nothing can be promised of expressions, which have no order; tests/ir/oracle.t holds
-- the rounding errors of the chosen order to a running error bound.  The same program gives the same ir: no table is
-- walked in hash order.  Named definitions are borders: a sum is not opened through a name, as people who read
-- the C want to find the name; and so no definition is computed twice.

local R = require "generator.algebra.rational"
local choice = require "generator.algebra.choice"
local form = require "generator.ir.lower.form"
local share = require "generator.ir.lower.share"
local orient = require "generator.ir.lower.orient"
local size = require "generator.ir.lower.size"
local select = require "generator.ir.lower.select"

local lower = {}

-- ---- expressions to terms -----------------------------------------------------------------------------

-- The term of a function of numbers: exact where the value is rational, else the nearest dyadic of form.BITS bits.
local function constant_call(B, fn, args)
  local values = {}
  for k, t in ipairs(args) do values[k] = t.c end
  local result = choice.of(fn, R.one, table.unpack(values)) or R.apply(fn, form.BITS, table.unpack(values))
  return B.number(result or error("lower: " .. fn .. " of " .. tostring(values[1]) .. " is no number"))
end

-- Returns shape(node) -> term, which keeps what it has made: one visit of each node.  bound: symbol -> term.
-- by_kind: how each kind of expr node becomes a term
local function shaper(B, bound)
  local memo = {}
  local shape

  local by_kind = {
    num = function(e) return B.number(e.value) end,
    sym = function(e)
      return bound[e.name] or error("lower: symbol '" .. e.name .. "' is neither an input nor defined above")
    end,
    add = function(e)
      local terms = {}
      for k = 1, #e do terms[k] = shape(e[k]) end
      return B:sum(terms)
    end,
    mul = function(e)
      local factors = {}
      for k = 1, #e do
        local f = e[k]
        if f.kind == "pow" then
          factors[k] = { shape(f.base), f.exp }
        else
          factors[k] = { shape(f), 1 }
        end
      end
      return B:product(factors)
    end,
    pow = function(e) return B:product { { shape(e.base), e.exp } } end,
    call = function(e)
      if e.fn == "opaque" then return shape(e[1]) end
      local args, constant = {}, true
      for k = 1, #e do
        args[k] = shape(e[k])
        constant = constant and args[k].f == B.one
      end
      if constant then return constant_call(B, e.fn, args) end
      if e.fn == "side" then return { c = R.one, f = B:call("copysign", { B.number(R.one), args[1] }) } end
      return { c = R.one, f = B:call(e.fn == "abs" and "fabs" or e.fn, args) }
    end,
  }

  function shape(e)
    local t = memo[e]
    if not t then
      local rule = by_kind[e.kind] or error("lower: unknown node kind '" .. tostring(e.kind) .. "'")
      t = rule(e)
      memo[e] = t
    end
    return t
  end

  return shape
end

-- ---- programs -------------------------------------------------------------------------------------------

-- Every def and out of the program with its term, in order: { term, group, name or c, leaf }.
local function roots_of(program, B)
  local bound, roots = {}, {}
  local function bind(name, t)
    if bound[name] then error("lower: '" .. name .. "' is defined twice") end
    bound[name] = t
  end
  for _, input in ipairs(program.inputs) do bind(input.sym, { c = R.one, f = B:leaf(input.sym) }) end

  local shape = shaper(B, bound)
  for g, group in ipairs(program.groups) do
    for _, def in ipairs(group.defs or {}) do
      local t = shape(def.expr)
      if t.f == B.one or t.f.kind == "leaf" and t.c == R.one then
        bind(def.name, t)
      else
        local leaf = B:leaf(def.name)
        local term = { c = t.c, f = t.f, named = true }
        roots[#roots + 1] = { term = term, group = g, name = def.name, leaf = leaf }
        bind(def.name, { c = R.one, f = leaf })
      end
    end
    for _, out in ipairs(group.outs or {}) do
      local t = shape(out.expr)
      roots[#roots + 1] = { term = { c = t.c, f = t.f }, group = g, c = out.c, assign = out.op or "=" }
    end
  end
  return roots
end

-- The roots that some result needs, all outs and the defs they reach, and the forms below them.
-- A leaf of a definition leads on to what it stands for.
local function needed(roots)
  local outs, inside = {}, {}
  for _, root in ipairs(roots) do
    if root.leaf then inside[root.leaf] = root.term.f else outs[#outs + 1] = root.term end
  end
  local forms = orient.survey(outs, inside).list
  local live = {}
  for _, f in ipairs(forms) do live[f] = true end
  local kept = {}
  for _, root in ipairs(roots) do
    if not root.leaf or live[root.leaf] then kept[#kept + 1] = root end
  end
  return kept, forms
end

-- What the definitions and results of a program became, before parts are shared: a list of { name or c, term }.
function lower.terms(program)
  return (needed(roots_of(program, form.builder())))
end

-- The ir of a program.
function lower.run(program)
  local B = form.builder()
  local roots, forms = needed(roots_of(program, B))
  share.quotients(forms, B)
  share.products(forms, B)
  share.sums(forms, B)
  local terms = {}
  for k, root in ipairs(roots) do terms[k] = root.term end
  size.run(terms)
  local survey = orient.run(terms)

  local ir = { name = program.name, n = 0, inputs = {}, consts = {}, groups = {} }
  local S = select.new(ir, survey)
  for k, input in ipairs(program.inputs) do
    ir.n = ir.n + 1
    ir.inputs[k] = { op = "input", dst = ir.n, sym = input.sym, c = input.c }
    S.values[B:leaf(input.sym)] = ir.n
  end
  for g, group in ipairs(program.groups) do
    ir.groups[g] = { why = group.why, where = group.where, code = {} }
  end

  for _, root in ipairs(roots) do
    local code = ir.groups[root.group].code
    select.into(S, code)
    local v = select.signed(S, root.term)
    if root.leaf then
      S.values[root.leaf] = v
      local i = S.made[v]
      i.name = i.name or root.name -- an equal def before it has named it
    else
      code[#code + 1] = { op = "store", src1 = v, c = root.c, assign = root.assign }
    end
  end
  return ir
end

return lower
