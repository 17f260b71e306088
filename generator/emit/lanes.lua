-- lanes.lua -- a function of one body as a loop over a block of bodies, which compilers turn into vector instructions.
--
--     lanes.make(ctx, f, each) -> { common = lines before the loop, lines = lines of the loop, reads = rows of c that
--                                   are read, a set }
-- f: a description with the arguments m, t, x (or x!, dx), u, h, and p (each body's parameters) where f.inputs has it.
-- The IR is that of the scalar function, so every lane has the same operations in the same order, and the same bits.
-- What depends on t, h and (unless `each`: a model per body) on the model alone is the same for all lanes and stands
-- before the loop.
-- ctx.rows: member of the model -> the enumerator of its row.  In C x, u, dx and c are blocks, rows of NAME_LANES
-- numbers; row i of x is state i of the bodies.
-- SPDX-License-Identifier: GPL-3.0-or-later

local cprint = require "generator.emit.cprint"
local source = require "generator.emit.source"
local instr = require "generator.ir.core.instr"
local lower = require "generator.ir.lower.lower"
local passes = require "generator.ir.passes.passes"

local lanes = {}

-- What an argument of the scalar function is read from in a lane, and whether it differs from lane to lane.
local function placed(ctx, input, each)
  if input.lane ~= nil then -- the description says it itself
    return { sym = input.sym, c = input.c .. (input.lane and "[lane]" or ""), rank = input.rank }, input.lane
  end
  local array = string.match(input.c, "^([xup])%[")
  if array then return { sym = input.sym, c = input.c .. "[lane]", rank = input.rank }, true end
  local member = each and string.match(input.c, "^m%->([%w_]+)$")
  if member then
    return { sym = input.sym, c = "c[" .. ctx.rows[member] .. "][lane]", rank = input.rank }, true
  end
  return input, false
end

-- The program of f with its arguments in lanes; sym -> does it differ from lane to lane?
local function program_of(ctx, f, each)
  local own, differs = setmetatable({ inputs = {} }, { __index = f }), {}
  for i, input in ipairs(f.inputs or source.inputs(ctx, f)) do
    own.inputs[i], differs[input.sym] = placed(ctx, input, each)
  end
  own.groups = {}
  for g, group in ipairs(f.groups) do
    local outs = {}
    for k, o in ipairs(group.outs) do outs[k] = { c = source.target(ctx, o) .. "[lane]", expr = o.expr } end
    own.groups[g] = { why = group.why, where = group.where, defs = group.defs, outs = outs }
  end
  return source.program(ctx, own), differs
end

-- Value numbers that differ from lane to lane.
local function varying(ir, differs)
  local set = {}
  for _, i in ipairs(ir.inputs) do set[i.dst] = differs[i.sym] or nil end
  for _, group in ipairs(ir.groups) do
    for _, i in ipairs(group.code) do
      for _, field in ipairs(instr.srcs(i)) do
        if i.dst and set[i[field]] then set[i.dst] = true end
      end
    end
  end
  return set
end

-- Names that the IR has.
local function names_of(ir)
  local taken = {}
  instr.each(ir, function(i)
    if i.sym then taken[i.sym] = true end
    if i.name then taken[i.name] = true end
  end)
  return taken
end

-- The IR in two: what is common to all lanes, its values by name, and the rest, which reads these names.
-- A common value that only common ones read stays before the loop; one that a lane reads gets a name if it has none.
local function parted(ir, differs)
  local own, taken, n = varying(ir, differs), names_of(ir), 0
  local function fresh()
    repeat n = n + 1 until not taken["r" .. n]
    return "r" .. n
  end
  local read = {} -- common values that a lane reads
  for _, group in ipairs(ir.groups) do
    for _, i in ipairs(group.code) do
      for _, field in ipairs(instr.srcs(i)) do
        if (not i.dst or own[i.dst]) and not own[i[field]] then read[i[field]] = true end
      end
    end
  end
  local common = { name = ir.name, n = ir.n, inputs = {}, consts = ir.consts, groups = {} }
  local rest = { name = ir.name, n = ir.n, inputs = {}, consts = ir.consts, groups = {} }
  for _, i in ipairs(ir.inputs) do
    table.insert((own[i.dst] and rest or common).inputs, i)
    if not own[i.dst] and read[i.dst] then -- the name stands before the loop
      table.insert(rest.inputs, { op = "input", dst = i.dst, sym = i.sym, c = i.sym })
    end
  end
  local before = {}
  for g, group in ipairs(ir.groups) do
    local code = {}
    for _, i in ipairs(group.code) do
      if not i.dst or own[i.dst] then
        code[#code + 1] = i
      else
        if read[i.dst] and not i.name then i = instr.named(i, fresh()) end
        before[#before + 1] = i
        if read[i.dst] then rest.inputs[#rest.inputs + 1] = { op = "input", dst = i.dst, sym = i.name, c = i.name } end
      end
    end
    rest.groups[g] = { why = group.why, where = group.where, code = code }
  end
  common.groups[1] = { code = before }
  return common, rest
end

function lanes.make(ctx, f, each)
  local program, differs = program_of(ctx, f, each)
  local common, rest = parted(passes.run(lower.run(program)), differs)
  local opts = source.printed(ctx)
  opts.letter = "r"
  local before = source.body(cprint.statements(common, ctx.real, opts))
  opts = source.printed(ctx)
  opts.indent = 4
  local lines = source.body(cprint.statements(rest, ctx.real, opts))
  local text = string.gsub(table.concat(before, "\n") .. "\n" .. table.concat(lines, "\n"), "/%*.-%*/", "")
  local void = {}
  for _, a in ipairs(f.args) do
    local name = a == "x!" and "x" or a == "m" and each and "c" or type(a) == "table" and a.name or a
    local used = string.find(text, "%f[%w_]" .. name .. "%f[^%w_]")
    if not used and (name ~= "u" or #ctx.inputs > 0) then void[#void + 1] = "(void)" .. name .. ";" end
  end
  for i = #void, 1, -1 do table.insert(before, 1, void[i]) end
  local reads = {}
  for _, i in ipairs(rest.inputs) do
    local row = string.match(i.c, "^c%[([%w_]+)%]")
    if row then reads[row] = true end
  end
  return { name = f.name, common = before, lines = lines, reads = reads }
end

return lanes
