-- split.lua -- the splitting steppers as C: the rates of the kick are printed, the rest is in templates/steppers/,
-- where each kind of drift has a file of its own.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"
local source = require "generator.emit.source"
local template = require "generator.emit.template"

local SHARED = template.group("steppers/split_title.c", "steppers/split_half.c", "steppers/split_turn.c",
  "steppers/split_about.c", "steppers/split_about_axis.c", "steppers/split_setup.c", "steppers/split_point.c",
  "steppers/split_sphere.c", "steppers/split_axis.c", "steppers/split_oblique.c", "steppers/split_diagonal.c",
  "steppers/split_full.c", "steppers/split_kick.c")
local STEP = template.group("steppers/split.h", "steppers/split_step.c", "steppers/split_step_full.c")

local split = {}

local function text(n) return string.format("%d", n) end

-- A palindrome as rows of C: drifts a, kicks b with the time c of each.
-- c[i] is the sum of the drifts before kick i.
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

-- Does a method of the job need the axes that NAME_init finds?
function split.needs_setup(job)
  for _, s in ipairs(job.steppers) do
    if s.method.template == "split" and s.program.drift.kind == "full" then return true end
  end
  return false
end

-- What the kind of drift is made of, in the order of the C.
local TURNS = {
  sphere = {}, diagonal = {}, axis = { "split_about_axis.c" }, oblique = { "split_about.c" },
  full = { "split_about.c", "split_setup.c" },
}

-- The templates that all splittings of the job share: turns, drift and kick.
local function shared_parts(program)
  local d, list = program.drift, {}
  if program.has.rates then
    list[1] = "split_half.c"
    if program.has.attitude then list[2] = "split_turn.c" end
    for _, name in ipairs(TURNS[d.kind]) do list[#list + 1] = name end
  end
  list[#list + 1] = "split_" .. d.kind .. ".c"
  if #program.kicked > 0 then list[#list + 1] = "split_kick.c" end
  return list
end

-- Values and texts of what all splittings of the job have in common.
local function shared(program, kit)
  local ctx, d = kit.ctx, program.drift
  local real, upper = ctx.real, ctx.upper
  local v = { slowed = program.slowed, place = {}, states = {} }
  if program.has.position then
    for _, axis in ipairs { "X", "Y", "Z" } do
      v.place[#v.place + 1] = string.format("x[%s_R%s] += tau*x[%s_V%s];", upper, axis, upper, axis)
    end
  end
  for name, e in pairs(d.constants) do v[name] = constant(e, real) end -- into a table: order is lost anyway
  if d.axis then v.i, v.j, v.k = text(d.axis - 1), text(d.axis % 3), text((d.axis + 1) % 3) end
  if d.kind == "diagonal" then -- what the map needs beside them; the tiny: its inverse is no infinity
    for name, n in pairs { third = 3, fifth = 5, seventh = 7, ninth = 9, twentieth = 20 } do -- order is lost
      v[name] = number.text(R.new(1, n), real)
    end
    v.tiny = number.text(R.new(2) ^ (real == "float" and -100 or -1000), real)
  end
  if program.has.rates then
    local terms = real == "float" and 5 or 9 -- z^8/16! of z = 1/4 is 7e-19, z^4/8! below 1e-7
    v.cos_series, v.sin_series = series(0, terms, real), series(1, terms, real)
  end
  if #program.kicked > 0 then
    local groups = {}
    for i, g in ipairs(program.groups) do
      local outs = {}
      for k, o in ipairs(g.outs) do outs[k] = { array = "dx", state = o.state, expr = o.expr } end
      groups[i] = { why = g.why, where = g.where, defs = g.defs, outs = outs }
    end
    local f = source.make(ctx, { name = "split_rates", groups = groups, doc = {}, args = { "m", "t", "x", "u", "dx" } })
    v.head, v.lines = f.head, f.lines
    for i, name in ipairs(program.kicked) do v.states[i] = upper .. "_" .. string.upper(name) end
  end
  local render, out = SHARED(kit.templates, kit.base, v), {}
  out[1] = render "steppers/split_title.c"
  for _, name in ipairs(shared_parts(program)) do out[#out + 1] = render("steppers/" .. name) end
  return out
end

-- Header and sources of the program of methods/split.lua; what the methods share stands before the first.  s, kit: see
-- emit/steppers.lua.
function split.render(s, kit)
  local program, real, sources = s.program, kit.ctx.real, {}
  if not kit.split then
    kit.split = true
    sources = shared(program, kit)
  end
  local full = program.drift.kind == "full"
  local render = STEP(kit.templates, kit.base, { first = s.first, method = "split" .. text(program.order),
    order = text(program.order), about = program.source, kicks = #program.kicked > 0,
    outer = rows(program.outer, real), inner = full and rows(program.inner, real) or nil })
  sources[#sources + 1] = render(full and "steppers/split_step_full.c" or "steppers/split_step.c")
  return render "steppers/split.h", sources
end

return split
