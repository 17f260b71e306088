-- baked.lua -- gen --bake: each function as cheap as without it, and its constants by their names.
--
-- With the parameters' numbers in the scene equal moments and zeros are seen, and some equations become shorter; others
-- longer, because a number multiplies into a sum where a name would have stayed before it.  So each function is made
-- both ways, from the numbers and from the names of the derived constants, and the cheaper one is taken; of two that
-- cost the same the one with names.  The constants with names stand at the head of NAME.c with what they are.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local expr = require "generator.algebra.expr"
local text = require "generator.formula.text"
local number = require "generator.emit.number"
local source = require "generator.emit.source"

local baked = {}

local longest = 90 -- characters of a formula that a comment has

-- Constants of the scene without --bake and their reciprocals: {name, value, about, sym}, and {1/sym -> symbol}.
local function constants(m)
  local list, map = {}, {}
  local function put(name, value, about, formula)
    if #formula > longest then formula = "" end
    list[#list + 1] = { name = name, value = value, about = about .. (formula ~= "" and ": " .. formula or "") }
  end
  for _, member in ipairs(m.members) do
    local value = m:number(member.e)
    put(member.name, value, member.about, text.of(member.e))
    if R.sign(value) ~= 0 then
      local over = m:unique("over_" .. member.name)
      map[expr.pow(member.sym, R.new(-1))] = expr.sym(over, 3)
      put(over, R.one / value, "1/" .. member.name, "")
    end
  end
  return list, map
end

-- Do all survive in the type?  A reciprocal of a small number may not.
local function fit(list, real)
  for _, k in ipairs(list) do
    local x = real == "float" and R.tofloat(k.value) or R.todouble(k.value)
    if x == math.huge or x == -math.huge or x == 0 and R.sign(k.value) ~= 0 then return false end
  end
  return true
end

local function total(c) return c.add + c.mul + c.div + c.sqrt + c.call end

-- A division and a root take what ten additions do, a function of the C library more (docs/targets.md).
local function weight(c) return c.add + c.mul + 10 * (c.div + c.sqrt) + 20 * c.call end

-- Is g, from the names, to be taken in the place of f?  Unless f has no more operations, and they are cheaper.
local function better(f, g) return total(g) < total(f) or weight(g) <= weight(f) end

-- The description with reciprocals by name.
local function named(f, map, list)
  local g = {}
  for k, x in pairs(f) do g[k] = x end -- into a table: order is lost anyway
  g.groups, g.constants = {}, list
  for i, group in ipairs(f.groups) do
    local new = { why = group.why, where = group.where, defs = {}, outs = {} }
    for k, d in ipairs(group.defs) do new.defs[k] = { name = d.name, expr = calculus.substitute(d.expr, map) } end
    for k, o in ipairs(group.outs) do
      local out = {}
      for key, x in pairs(o) do out[key] = x end -- into a table: order is lost anyway
      out.expr = calculus.substitute(o.expr, map)
      new.outs[k] = out
    end
    g.groups[i] = new
  end
  return g
end

-- job: an open plan with --bake; plain: the same without.  Returns of each function the cheaper one, and the constants
-- of C that they may need (nil: none).
function baked.choose(job, plain)
  local list, map = constants(plain.model)
  if not fit(list, job.real) or #list == 0 then return job.functions end
  local by_name = {}
  for _, f in ipairs(plain.functions) do by_name[f.name] = f end
  local ctx, chosen = source.context(job), {}
  for i, f in ipairs(job.functions) do
    local g = by_name[f.name]
    g = g and #g.args == #f.args and named(g, map, list)
    chosen[i] = g and better(source.cost(ctx, f), source.cost(ctx, g)) and g or f
  end
  return chosen, list
end

-- The constants that the text names, as C, each with what it is.
function baked.lines(job, ctx, code)
  local out = {}
  for _, k in ipairs(job.held or {}) do
    local name = source.held(ctx, k.name)
    if string.find(code, "%f[%w_]" .. name .. "%f[^%w_]") then
      local lines = source.comment(k.about)
      local line = "static const " .. ctx.name .. "_real " .. name .. " = " .. number.text(k.value, ctx.real) .. ";"
      if #lines == 1 and #line + #lines[1] < 110 then
        lines[1] = line .. " " .. lines[1]
      else
        lines[#lines + 1] = line
      end
      for _, l in ipairs(lines) do out[#out + 1] = l end
    end
  end
  return out
end

return baked
