-- split.lua -- the splitting steppers as C: the kick's rates printed, the rest in templates/steppers/split.c.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"
local source = require "generator.emit.source"

local split = {}

local function text(n) return string.format("%d", n) end

-- A palindrome as rows of C: drifts a, kicks b with the time c of each.
local function rows(p, real)
  local out = { n = text(#p.b) }
  for _, name in ipairs { "a", "b", "c" } do
    local list = {}
    for i, x in ipairs(p[name]) do
      list[i] = number.text(R.fromdouble(real == "float" and R.tofloat(x) or R.todouble(x)), real)
    end
    out[name] = list
  end
  return out
end

-- 1 - z/2 + z^2 (1/24 - z/720 + z^2 ( ...)) or with odd factorials, an odd number of terms; pairs, so that processors
-- work on several at a time.
local function series(first, terms, real)
  local coefficient, list = R.one, {}
  for n = 0, terms - 1 do
    list[n + 1] = number.text(coefficient, real)
    coefficient = coefficient / R.lift((2 * n + 1 + first) * (2 * n + 2 + first))
  end
  local s = list[terms]
  for n = terms - 2, 1, -2 do s = "(" .. list[n] .. " - " .. list[n + 1] .. "*z) + zz*(" .. s .. ")" end
  return s
end

local function constant(e, real)
  if e.kind == "num" then return number.text(e.value, real) end
  return "m->" .. e.name
end

-- Does a method of the job need the axes that NAME_init finds?  Its check then has a number.
function split.setup(job, v)
  v.split_setup = false
  for _, s in ipairs(job.steppers) do
    v.split_setup = v.split_setup or s.method.template == "split" and s.program.drift.kind == "full"
  end
  if not v.split_setup then return end
  local list, text_of_it = v.checks, "every derived constant must be finite"
  if list[#list].text ~= text_of_it then
    list[list[#list].number == "-" and #list or #list + 1] = { text = text_of_it }
    list[#list].number = text(#list)
  end
  v.split_code = list[#list].number
end

-- Fills the template's values for the program of methods/split.lua; what the methods share is printed with the first.
function split.fill(ctx, program, v)
  local upper = ctx.upper
  v.split_shared = not v.split_done
  v.split_done = true
  v.split_method = "split" .. text(program.order)
  v.split_order, v.split_about = text(program.order), program.source
  v.split_outer, v.split_inner = rows(program.outer, ctx.real), rows(program.inner, ctx.real)
  v.split_kicks, v.split_slowed = #program.kicked > 0, program.slowed
  local d, float = program.drift, ctx.real == "float"
  v.split_sphere, v.split_axis = d.kind == "sphere", d.kind == "axis"
  v.split_oblique, v.split_diagonal, v.split_full = d.kind == "oblique", d.kind == "diagonal", d.kind == "full"
  v.split_turns, v.split_attitude, v.split_moves = program.has.rates, program.has.attitude, program.has.position
  for name, e in pairs(d.constants) do v[name] = constant(e, ctx.real) end -- into a table: order is lost anyway
  local function numbers(i) return i and text(i - 1) or "", i and text(i % 3) or "", i and text((i + 1) % 3) or "" end
  v.split_i, v.split_j, v.split_k = numbers(d.axis)
  if v.split_diagonal then -- what the map needs beside them; the tiny: its inverse is no infinity
    v.third = number.text(R.new(1, 3), ctx.real)
    for _, n in ipairs { 5, 7, 9, 20 } do v["split_" .. text(n) .. "th"] = number.text(R.new(1, n), ctx.real) end
    v.split_tiny = number.text(R.new(2) ^ (float and -100 or -1000), ctx.real)
  end
  local terms = float and 5 or 9 -- z^8/16! of z = 1/4 is 7e-19, z^4/8! below 1e-7
  v.split_cos, v.split_sin = series(0, terms, ctx.real), series(1, terms, ctx.real)
  if not v.split_shared then return end
  local groups = {}
  for i, g in ipairs(program.groups) do
    local outs = {}
    for k, o in ipairs(g.outs) do outs[k] = { array = "dx", state = o.state, expr = o.expr } end
    groups[i] = { why = g.why, where = g.where, defs = g.defs, outs = outs }
  end
  v.split_head, v.split_lines, v.split_states = "", {}, {}
  if #program.kicked == 0 then return end
  local f = source.make(ctx, { name = "split_rates", groups = groups, doc = {}, args = { "m", "t", "x", "u", "dx" } })
  v.split_head, v.split_lines = f.head, f.lines
  for i, name in ipairs(program.kicked) do v.split_states[i] = upper .. "_" .. string.upper(name) end
end

return split
