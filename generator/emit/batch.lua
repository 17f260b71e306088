-- batch.lua -- --with batch: steps and rates of many bodies at once, as values for templates/batch/batch.h and .c.
--
--     batch.texts(job, ctx, base, about) -> header, source
-- about: {real_members, order}, from parts_of in emit/code.lua.  Each function is printed twice, for one model of all
-- bodies and (where the scene has parameters) for a model a body.
-- SPDX-License-Identifier: GPL-3.0-or-later

local number = require "generator.emit.number"
local lanes = require "generator.emit.lanes"
local template = require "generator.emit.template"
local wide = require "generator.emit.wide"
local R = require "generator.algebra.rational"

local GROUP = template.group("batch/batch.h", "batch/batch.c")

local batch = {}

-- Bodies in a block: four vectors of 512 bits.  From 32 to 512 bodies the time is the same; a block of 7 states is
-- within the nearest cache with room for its constants.
local LANES = { double = 32, float = 64 }

-- What the tables "as one model" and "a model a body" differ in.
local function ways(base)
  local one = { way = "many", tail = "lanes", each = false, owner = "const " .. base.name .. "_model *m", whose = "m",
    call = "m", words = "" }
  local own = { way = "each", tail = "own_lanes", each = true, whose = "k", call = "c",
    words = ", with its own constants", owner = "const " .. base.name .. "_real c[]",
    rows = base.name .. "_real c[][" .. base.upper .. "_LANES]" }
  return base.has_params and { one, own } or { one }
end

-- Enumerators of the model's members, no two alike: two members may differ in case alone.
local function rows_of(base, members)
  local rows, taken = {}, {}
  for _, member in ipairs(members) do
    local name = base.upper .. "_C_" .. string.gsub(string.upper(member), "[^%w_]", "")
    while taken[name] do name = name .. "_" end
    rows[member], taken[name] = name, true
  end
  return rows
end

-- The constants that the functions read (all: true), and the lines of their enumeration.
local function constants(base, members, rows, reads)
  local list, lines, line = {}, {}, ""
  for _, member in ipairs(members) do
    local name = rows[member]
    if not (reads == true or reads[name]) then goto next end
    list[#list + 1] = { name = member, index = name }
    if #line + #name > 92 then lines[#lines + 1], line = line, "" end
    line = line .. (line == "" and "" or " ") .. name .. ","
    ::next::
  end
  lines[#lines + 1] = line ~= "" and line or nil
  lines[#lines + 1] = base.upper .. "_NC"
  return list, lines
end

function batch.texts(job, ctx, base, about)
  local least = number.text(R.new(2) ^ (ctx.real == "float" and -126 or -1022), ctx.real)
  local v = { lanes = string.format("%d", LANES[ctx.real]), tiny = least, blocks = {}, steps = {},
    rates = {}, loops = {}, steppers = {}, wide = {}, rhs = false, order = about.order }
  ctx.rows = rows_of(base, about.real_members)
  local u_rows = base.has_inputs and base.name .. "_real u[][" .. base.upper .. "_LANES], " or ""
  local list = ways(base)
  v.each = false
  v.inputs_text = base.has_inputs and ", u[" .. base.upper .. "_NU*n]" or ""
  v.refilled = ""
  local step_of, reads, all_rows = {}, {}, false
  for i, s in ipairs(job.steppers) do
    local name = i == 1 and "step" or s.method.name .. "_step"
    step_of[name] = i == 1 and "advance" or s.method.name .. "_advance"
  end
  for _, f in ipairs(job.functions) do
    local advance, rhs = step_of[f.name], f.name == "rhs"
    if advance then v.steppers[#v.steppers + 1] = { step = f.name, advance = advance, run = false } end
    v.rhs = v.rhs or rhs
    for _, way in ipairs((advance or rhs) and list or {}) do
      local made = lanes.make(ctx, f, way.each)
      if not way.each or next(made.reads) then
        v.each = v.each or way.each
        for name in pairs(made.reads) do reads[name] = true end -- a set: any order
        v.blocks[#v.blocks + 1] = { name = f.name, tail = way.tail, whose = way.words, common = made.common,
          lines = made.lines, owner = way.rows or way.owner, u = u_rows,
          last = rhs and base.name .. "_real dx[][" .. base.upper .. "_LANES]" or base.name .. "_real h" }
        local row = { step = f.name, advance = advance, way = way.way, tail = way.tail, each = way.each,
          owner = way.owner, whose = way.whose, call = way.call, v = base.has_inputs and "v, " or "",
          guard = f.guard ~= nil }
        table.insert(rhs and v.rates or v.steps, row)
      end
    end
  end
  for i, s in ipairs(job.steppers) do
    if s.program then
      local step = i == 1 and "step" or s.method.name .. "_step"
      local own = { step = step, advance = step_of[step], run = s.method.name == "taylor" }
      v.steppers[#v.steppers + 1] = own
      local made = s.method.name == "taylor" and wide.render({ program = s.program, step = step,
        advance = own.advance }, { templates = job.templates, base = base, ctx = ctx }, list)
      if made then
        v.wide[#v.wide + 1] = made
        v.each, all_rows = list[2] ~= nil, true
        v.refilled = "  A body that has arrived makes room for the next one."
      end
      for _, way in ipairs(made and {} or list) do
        v.each = v.each or way.each
        table.insert(v.loops, { step = step, advance = step_of[step], way = way.way, each = way.each,
          run = own.run, owner = way.owner, call = way.call, model = way.each and "&m" or "m",
          v = base.has_inputs and "v" or "0" })
      end
    end
  end
  if #v.steppers == 0 and not v.rhs then return nil end
  v.own_model = v.each and #v.loops > 0
  v.constants, v.constant_enum = constants(base, about.real_members, ctx.rows, v.own_model or all_rows or reads)
  local render = GROUP(job.templates, base, v)
  return render "batch/batch.h", render "batch/batch.c", v.each
end

return batch
