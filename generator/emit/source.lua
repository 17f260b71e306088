-- source.lua -- function descriptions as C: prototype, contract, body.
--
-- A description (dynamics/quantities.lua, methods/) knows symbols and results; here it gets its C arguments, each
-- symbol the place it is read from, each result the place it is written to.  The body goes through lower, the
-- passes and cprint; nothing else makes C expressions.  All inputs are read before the first result is written, so
-- results may overlap arguments.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local number = require "generator.emit.number"
local plain = require "generator.emit.plain"
local distinct = require "generator.dynamics.distinct"
local lower = require "generator.ir.lower.lower"
local passes = require "generator.ir.passes.passes"
local count = require "generator.ir.core.count"
local show = require "generator.ir.core.show"
local cprint = require "generator.emit.cprint"

local source = {}

-- How many numbers an array has: NAME_NX*NAME_NX, or the number alone.
local function size(ctx, a)
  local parts = {}
  for i = 1, 2 do
    local n = a.size and a.size[i]
    if n then parts[#parts + 1] = string.find(n, "^N") and ctx.upper .. "_" .. n or n end
  end
  return parts[1] and table.concat(parts, "*") or a.count
end

-- ctx: {name, upper, real ("double"|"float"), type (what the code calls it: real, or NAME_real where the scene has a
-- quantity of that name), members, states, inputs (lists of {name}), helpers (set of the functions that libm lacks and
-- the code calls; filled here), own (bool: --libm own)}
local function declarations(ctx, f)
  local real = ctx.name .. "_real "
  local word = {
    m = "const " .. ctx.name .. "_model *m", x = "const " .. real .. "x[]", ["x!"] = real .. "x[]", xo = real .. "x[]",
    t = real .. "t", h = real .. "h", n = real .. "n", tilt = real .. "tilt",
    u = "const " .. real .. "u[]", dx = real .. "dx[]",
  }
  local list = {}
  for i, a in ipairs(f.args) do
    if type(a) == "table" then
      list[i] = (a.out and "" or "const ") .. real .. a.name .. "[" .. size(ctx, a) .. "]"
    else
      list[i] = word[a] or error("unknown argument word " .. a)
    end
  end
  return list
end

-- The C name of a baked constant.
function source.held(ctx, name) return ctx.name .. "_k_" .. name end

local six, three = { "xx", "yy", "zz", "xy", "xz", "yz" }, { "x", "y", "z" }

-- Where each symbol is read from, as a list in the order of loading: {sym, c, rank of its symbol}.
function source.inputs(ctx, f)
  local list = {}
  local function put(sym, c, rank) list[#list + 1] = { sym = sym, c = c, rank = rank or 8 } end
  for _, a in ipairs(f.args) do
    if a == "m" then
      for _, m in ipairs(ctx.members) do put(m.name, "m->" .. m.name, 3) end
      for _, k in ipairs(f.constants or {}) do put(k.name, source.held(ctx, k.name), 3) end
    elseif a == "x" or a == "x!" then
      for _, s in ipairs(ctx.states) do put(s.name, "x[" .. ctx.upper .. "_" .. string.upper(s.name) .. "]") end
    elseif a == "u" then
      for _, s in ipairs(ctx.inputs) do put(s.name, "u[" .. ctx.upper .. "_" .. s.index .. "]") end
    elseif a == "t" or a == "h" or a == "n" or a == "tilt" then
      put(a, a, a ~= "t" and 6 or nil)
    elseif type(a) == "table" and a.held then -- read and written, one number a state
      for i, s in ipairs(ctx.states) do put(a.names[i], a.name .. "[" .. ctx.upper .. "_" .. string.upper(s.name) ..
        "]") end
    elseif type(a) == "table" and not a.out then
      local names = a.names or a.count == 6 and six or three
      for i = 1, a.count do put(a.name .. names[i], a.name .. "[" .. (i - 1) .. "]") end
    end
  end
  return list
end

-- The place that result o is written to.
function source.target(ctx, o)
  if o.result then return "const " .. ctx.name .. "_real result" end
  if o.c then return o.c end
  if o.state then return o.array .. "[" .. ctx.upper .. "_" .. string.upper(o.state) .. "]" end
  return o.array .. "[" .. o.index .. "]"
end

-- Parameters {name, sym} as inputs, and the new symbol of each whose name `taken` claims: node -> symbol.
function source.parameters(ctx, params, taken)
  local list, map, used = {}, {}, {}
  for _, p in ipairs(params) do used[p.name] = true end
  for i, p in ipairs(params) do
    local name, n = p.name, 1
    if taken(name) then
      name = name .. "_"
      while used[name] do
        n = n + 1
        name = p.name .. "_" .. n
      end
      map[p.sym] = expr.sym(name, 2)
    end
    list[i] = { sym = name, c = "p[" .. ctx.upper .. "_" .. string.upper(p.name) .. "]" }
  end
  return list, map
end

-- pi as a name, so that it is read as pi and rounded once.
local pi = expr.sym("pi", 1)

-- The program of a description (see ir/lower/lower.lua).
function source.program(ctx, f)
  local groups, uses_pi, in_words = {}, false, calculus.substitution { [expr.pi] = pi }
  local function named(e)
    local x = in_words(e)
    uses_pi = uses_pi or x ~= e
    return x
  end
  for i, g in ipairs(f.groups) do
    local outs = {}
    for k, o in ipairs(g.outs) do outs[k] = { c = source.target(ctx, o), expr = named(o.expr) } end
    local defs = {}
    for k, d in ipairs(g.defs) do defs[k] = { name = d.name, expr = named(d.expr) } end
    groups[i] = { why = g.why, where = g.where, defs = defs, outs = outs }
  end
  local inputs = f.inputs or source.inputs(ctx, f)
  local ranks = {}
  for _, input in ipairs(inputs) do ranks[input.sym] = input.rank end
  groups = distinct.run(groups, ranks)
  if uses_pi then
    local value = number.text(R.apply("pi", 200), ctx.real)
    inputs = { { sym = "pi", c = value }, table.unpack(inputs) }
  end
  return { name = ctx.name .. "_" .. f.name, inputs = inputs, groups = groups }
end

-- Lines of comment text `s` within the width, continued with `pad`.
local function comment(s)
  local lines, line = {}, "/*"
  for word in string.gmatch(s, "%S+") do
    if #line + #word > 92 then
      lines[#lines + 1] = line
      line = "  "
    end
    line = line .. " " .. word
  end
  lines[#lines + 1] = line .. " */"
  return lines
end
source.comment = comment

-- The statements of groups, each with its equation as a comment, blank lines between.
function source.body(c)
  local lines = {}
  for _, l in ipairs(c.loads) do lines[#lines + 1] = l end
  for i, g in ipairs(c.groups) do
    if i > 1 or #lines > 0 then lines[#lines + 1] = "" end
    if g.why then
      for _, l in ipairs(comment(g.why .. (g.where and "  [" .. g.where .. "]" or ""))) do lines[#lines + 1] = l end
    end
    for _, l in ipairs(g.lines) do lines[#lines + 1] = l end
  end
  return lines
end

-- Arguments that the body never mentions are voided, so that no compiler warns.
local function unused(f, lines)
  local text, list = plain.uncommented(table.concat(lines, "\n"), ""), {}
  for _, a in ipairs(f.args) do
    local name = type(a) == "table" and a.name or a == "x!" and "x" or a == "xo" and "x" or a
    if not plain.word(text, name) then list[#list + 1] = "(void)" .. name .. ";" end
  end
  return list
end

-- prefix(arg, arg, ...) broken at 100 columns.
local function prototype(head, args, tail)
  local line = head .. "(" .. table.concat(args, ", ") .. ")" .. tail
  if #line <= 98 then return line end
  local lines, current = {}, head .. "("
  local pad = string.rep(" ", #current)
  for i, a in ipairs(args) do
    local piece = a .. (i < #args and "," or ")" .. tail)
    if #current + #piece > 98 then
      lines[#lines + 1] = string.gsub(current, "%s+$", "")
      current = pad
    end
    current = current .. piece .. (i < #args and " " or "")
  end
  lines[#lines + 1] = current
  return table.concat(lines, "\n")
end

-- How cprint writes the scene's functions.
function source.printed(ctx)
  return { type = ctx.type or ctx.name .. "_real", indent = 2, scene = ctx.name, helpers = ctx.helpers, own = ctx.own }
end

-- Runs of states of one kind, attitude, rates and so on: {first, last (one beyond), about} as text.
function source.kinds(states)
  local list = {}
  for i, s in ipairs(states) do
    local kind = list[#list]
    if not kind or s.about ~= "" then
      kind = { first = string.format("%d", i - 1), about = s.about ~= "" and s.about or s.name }
      list[#list + 1] = kind
    end
    kind.last = string.format("%d", i)
  end
  return list
end

-- What the code calls its real type.
function source.type(m)
  for _, list in ipairs { m.params, m.members, m.states, m.inputs } do
    for _, s in ipairs(list) do
      if s.name == "real" then return m.name .. "_real" end
    end
  end
  return "real"
end

-- Everything a template needs of one function: doc lines, prototype, body lines, operation counts; and its IR.
function source.make(ctx, f)
  local ir = passes.run(lower.run(source.program(ctx, f)))
  local c = cprint.statements(ir, ctx.real, source.printed(ctx))
  local lines = source.body(c)
  local void = unused(f, lines)
  for i = #void, 1, -1 do table.insert(lines, 1, void[i]) end
  if f.guard then
    local least = number.text(R.new(2) ^ (ctx.real == "float" and -126 or -1022), ctx.real)
    local test = string.format("if (%s > -%s && %s < %s)", f.guard, least, f.guard, least)
    table.insert(lines, #void + 1, test .. " return; /* no time passes */")
  end
  if f.result then
    local value = string.match(lines[#lines], "^const [%w_]+ result = (.*)$")
    lines[#lines] = value and "return " .. value or lines[#lines]
    if not value then lines[#lines + 1] = "return result;" end
  end
  local head = (f.result and ctx.name .. "_real " or "void ") .. ctx.name .. "_" .. f.name
  local args = declarations(ctx, f)
  return { name = f.name, doc = f.doc, declaration = prototype(head, args, ";"), head = prototype(head, args, ""),
    lines = lines, cost = count.run(ir), ir = ir }
end

-- What making C of a job's functions needs (see declarations, above).
function source.context(job)
  local m = job.model
  return { name = m.name, upper = string.upper(m.name), real = job.real, type = source.type(m), members = m.members,
    states = job.states, inputs = m.inputs or {}, helpers = {}, own = job.libm == "own" }
end

-- Named constants as C text; and do any stand in the model?
function source.constants(list, real)
  local out, uses = {}, false
  for name, e in pairs(list) do -- into a table: order is lost anyway
    if e.kind == "num" then
      out[name] = number.text(e.value, real)
    else
      out[name], uses = "m->" .. e.name, true
    end
  end
  return out, uses
end

-- Operation counts of a program and of a description, without making C of it.
function source.count(program) return count.run(passes.run(lower.run(program))) end
function source.cost(ctx, f) return source.count(source.program(ctx, f)) end

-- The IR of a description after the pass `stop`, as text: --show.
function source.show(ctx, f, stop)
  return show.run(passes.run(lower.run(source.program(ctx, f)), stop), ctx.real)
end

-- C statements for groups without a function around them (NAME_init): loads and groups of lines.
function source.statements(ctx, f)
  local opts = source.printed(ctx)
  opts.letter = f.letter
  return cprint.statements(passes.run(lower.run(source.program(ctx, f))), ctx.real, opts)
end

return source
