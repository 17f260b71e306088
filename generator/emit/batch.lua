-- batch.lua -- --with batch: steps and rates of many bodies at once, as values for templates/batch/batch.h and .c.
--
--     batch.texts(job, ctx, common) -> header, source      common: the values that all templates share
-- Each function is printed twice, for one model of all bodies and (where the scene has parameters) for a model a body.
-- SPDX-License-Identifier: GPL-3.0-or-later

local number = require "generator.emit.number"
local lanes = require "generator.emit.lanes"
local template = require "generator.emit.template"
local R = require "generator.algebra.rational"

local batch = {}

-- Bodies in a block: four vectors of 512 bits.  From 32 to 512 bodies the time is the same; a block of 7 states is
-- within the nearest cache with room for its constants.
local LANES = { double = 32, float = 64 }

-- What the tables "as one model" and "a model a body" differ in.
local function ways(v)
  local one = { way = "many", tail = "lanes", each = false, owner = "const " .. v.name .. "_model *m", whose = "m",
    call = "m", words = "" }
  local own = { way = "each", tail = "own_lanes", each = true, whose = "k", call = "c",
    words = ", with its own constants", owner = "const " .. v.name .. "_real c[]",
    rows = v.name .. "_real c[][" .. v.upper .. "_LANES]" }
  return v.has_params and { one, own } or { one }
end

-- Enumerators of the model's members, no two alike: two members may differ in case alone.
local function rows_of(v)
  local rows, taken = {}, {}
  for _, member in ipairs(v.real_members) do
    local name = v.upper .. "_C_" .. string.gsub(string.upper(member), "[^%w_]", "")
    while taken[name] do name = name .. "_" end
    rows[member], taken[name] = name, true
  end
  return rows
end

-- The constants that the functions read (all: true), and the lines of their enumeration.
local function constants(v, rows, reads)
  local list, lines, line = {}, {}, ""
  for _, member in ipairs(v.real_members) do
    local name = rows[member]
    if not (reads == true or reads[name]) then goto next end
    list[#list + 1] = { name = member, index = name }
    if #line + #name > 92 then lines[#lines + 1], line = line, "" end
    line = line .. (line == "" and "" or " ") .. name .. ","
    ::next::
  end
  lines[#lines + 1] = line ~= "" and line or nil
  lines[#lines + 1] = v.upper .. "_NC"
  return list, lines
end

function batch.texts(job, ctx, common)
  local least = number.text(R.new(2) ^ (ctx.real == "float" and -126 or -1022), ctx.real)
  local v = setmetatable({ lanes = string.format("%d", LANES[ctx.real]), tiny = least, blocks = {}, steps = {},
    rates = {}, loops = {}, steppers = {}, rhs = false }, { __index = common })
  ctx.rows = rows_of(common)
  local u_rows = common.has_inputs and common.name .. "_real u[][" .. common.upper .. "_LANES], " or ""
  local list = ways(common)
  v.each = false
  v.has_inputs_text = common.has_inputs and ", u[" .. common.upper .. "_NU*n]" or ""
  v.but_calls = ""
  local step_of, reads = {}, {}
  for i, s in ipairs(job.steppers) do
    local name = i == 1 and "step" or s.method.name .. "_step"
    step_of[name] = i == 1 and "advance" or s.method.name .. "_advance"
  end
  for _, f in ipairs(job.functions) do
    local advance, rhs = step_of[f.name], f.name == "rhs"
    if advance then v.steppers[#v.steppers + 1] = { step = f.name, advance = advance } end
    v.rhs = v.rhs or rhs
    for _, way in ipairs((advance or rhs) and list or {}) do
      local made = lanes.make(ctx, f, way.each)
      if not way.each or next(made.reads) then
        v.each = v.each or way.each
        for name in pairs(made.reads) do reads[name] = true end -- a set: any order
        v.blocks[#v.blocks + 1] = { name = f.name, tail = way.tail, whose = way.words, common = made.common,
          lines = made.lines, owner = way.rows or way.owner, u = u_rows,
          last = rhs and common.name .. "_real dx[][" .. common.upper .. "_LANES]" or common.name .. "_real h" }
        local row = { step = f.name, advance = advance, way = way.way, tail = way.tail, each = way.each,
          owner = way.owner, whose = way.whose, call = way.call, v = common.has_inputs and "v, " or "",
          guard = f.guard ~= nil }
        table.insert(rhs and v.rates or v.steps, row)
      end
    end
  end
  for i, s in ipairs(job.steppers) do
    if s.program then
      local step = i == 1 and "step" or s.method.name .. "_step"
      v.steppers[#v.steppers + 1] = { step = step, advance = step_of[step] }
      for _, way in ipairs(list) do
        v.each = v.each or way.each
        table.insert(v.loops, { step = step, advance = step_of[step], way = way.way, each = way.each,
          owner = way.owner, call = way.call, model = way.each and "&m" or "m",
          v = common.has_inputs and "v" or "0" })
      end
    end
  end
  if #v.steppers == 0 and not v.rhs then return nil end
  v.own_model = v.each and #v.loops > 0
  v.constants, v.constant_enum = constants(common, ctx.rows, v.own_model or reads)
  local function render(name) return template.render(name, job.templates[name], v) end
  return render "templates/batch/batch.h", render "templates/batch/batch.c"
end

return batch
