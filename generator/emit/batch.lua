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

local GROUP = template.group("batch/batch.h", "batch/batch.c", "batch/alone.c")

local batch = {}

-- Bodies in a block: four vectors of 512 bits.  From 32 to 512 bodies the time is the same; a block of 7 states is
-- within the nearest cache with room for its constants.
local LANES = { double = 32, float = 64 }

-- What the tables "as one model" and "a model a body" differ in.
-- One scene without parameters has one model; then there is nothing that bodies could differ in.
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

-- Steps and rates in lanes: the functions of a block, and those of n bodies around them.  Returns by name whether
-- bodies may differ in it, and which constants it reads.
local function in_lanes(job, ctx, base, list, advances, v)
  local own, reads = {}, {}
  local u_rows = base.has_inputs and base.name .. "_real u[][" .. base.upper .. "_LANES], " or ""
  for _, f in ipairs(job.functions) do
    local advance, rhs = advances[f.name], f.name == "rhs"
    for _, way in ipairs((advance or rhs) and list or {}) do
      local made = lanes.make(ctx, f, way.each)
      if way.each and not next(made.reads) then goto next end
      own[f.name] = way.each or nil
      for name in pairs(made.reads) do reads[name] = true end -- a set: any order
      v.blocks[#v.blocks + 1] = { name = f.name, tail = way.tail, whose = way.words, common = made.common,
        lines = made.lines, owner = way.rows or way.owner, u = u_rows,
        last = rhs and base.name .. "_real dx[][" .. base.upper .. "_LANES]" or base.name .. "_real h" }
      table.insert(rhs and v.rates or v.steps, { step = f.name, advance = advance, way = way.way, tail = way.tail,
        each = way.each, owner = way.owner, whose = way.whose, call = way.call, guard = f.guard ~= nil,
        v = base.has_inputs and "v, " or "" })
      ::next::
    end
  end
  return own, reads
end

-- The functions of n bodies that take theirs one by one, for templates/batch/alone.c.
local function one_by_one(base, s, list)
  local rows, real = {}, base.name .. "_real"
  local function add(way, name, single, before, after, counter, call)
    rows[#rows + 1] = { name = name .. "_" .. way.way, single = single and single .. "_" .. way.way or false,
      owner = way.owner, model = way.call, each = way.each, before = before, after = after, counter = counter,
      call = string.format(call, way.each and "&m" or "m", base.has_inputs and "v" or "0") }
  end
  for _, way in ipairs(list) do
    add(way, s.advance, s.step, real .. " t", real .. " h, int steps", ", j", "for (j = 0; j < steps; j++) "
      .. base.name .. "_" .. s.step .. "(%s, t + (" .. real .. ")j*h, y, %s, h)")
    if s.run then
      add(way, "taylor_run", nil, real .. " t0", real .. " t1, " .. real .. " tolerance, int most, int steps[]", "",
        "steps[k] = " .. base.name .. "_taylor_run(%s, t0, y, %s, t1, tolerance, most)")
    end
  end
  return rows
end

function batch.texts(job, ctx, base, about)
  local least = number.text(R.new(2) ^ (ctx.real == "float" and -126 or -1022), ctx.real)
  local v = { lanes = string.format("%d", LANES[ctx.real]), tiny = least, blocks = {}, steps = {}, rates = {},
    steppers = {}, wide = {}, refilled = "", inputs_text = base.has_inputs and ", u[" .. base.upper .. "_NU*n]" or "" }
  ctx.rows = rows_of(base, about.real_members)
  local list, advances, alone, all_rows = ways(base), {}, {}, false
  if #about.real_members == 0 then list = { list[1] } end -- nothing that bodies could differ in
  for i, s in ipairs(job.steppers) do
    advances[i == 1 and "step" or s.method.name .. "_step"] = i == 1 and "advance" or s.method.name .. "_advance"
  end
  local own, reads = in_lanes(job, ctx, base, list, advances, v)
  for _, f in ipairs(job.functions) do
    local row = { step = f.name, advance = advances[f.name], run = false, each = own[f.name] or false }
    if row.advance then table.insert(v.steppers, row) end
    v.rhs = v.rhs or f.name == "rhs"
  end
  for i, s in ipairs(job.steppers) do
    if s.program then
      local step = i == 1 and "step" or s.method.name .. "_step"
      local row = { step = step, advance = advances[step], run = s.method.name == "taylor", each = list[2] ~= nil }
      v.steppers[#v.steppers + 1] = row
      local made = row.run and wide.render({ program = s.program, step = step, advance = row.advance },
        { templates = job.templates, base = base, ctx = ctx }, list)
      if made then
        v.wide[#v.wide + 1] = made
        v.refilled = "  A body that has arrived makes room for the next one."
      else
        for _, f in ipairs(one_by_one(base, row, list)) do alone[#alone + 1] = f end
      end
      all_rows = all_rows or row.each
    end
  end
  if #v.steppers == 0 and not v.rhs then return nil end
  v.rhs, v.rhs_each = v.rhs or false, own.rhs or false
  v.each = all_rows or next(own) ~= nil
  v.constants, v.constant_enum = constants(base, about.real_members, ctx.rows, all_rows or reads)
  v.functions, v.own_model = alone, false
  for _, f in ipairs(alone) do v.own_model = v.own_model or f.each end
  v.order = about.order
  local render = GROUP(job.templates, base, v)
  v.alone = #alone > 0 and render "batch/alone.c"
  return render "batch/batch.h", render "batch/batch.c", v.each
end

return batch
