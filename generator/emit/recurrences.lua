-- recurrences.lua -- the recurrences of a Taylor series as C: the statements of templates/steppers/taylor_terms.c,
-- taylor_rows.c and taylor_transition.c.
--
-- Straight code goes through the IR as everywhere: one block for term 0, one for term n, whose groups are the levels;
-- between them the template sums the lanes.  BELOW the line where it makes C.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local source = require "generator.emit.source"
local number = require "generator.emit.number"
local R = require "generator.algebra.rational"

local function text(n) return string.format("%d", n) end

local recurrences = {}

-- What the numbers of the recurrences are in C; ctx.kind: of several bodies at once.
local function kind(ctx) return ctx.kind or ctx.name .. "_real" end

local function symbol(name) return expr.sym(name, 8) end
local function zeroth(x) return symbol(x.name .. "0") end

-- Where a state's value is read: those of the variational equations are components of v.
local function origin(ctx, s)
  return (s.along and "v[" or "x[") .. ctx.upper .. "_" .. string.upper(s.along or s.name) .. "]"
end

-- Lines of the groups by the number that stands in `where`, loads first; letter: of their temporaries.
local function rendered(ctx, inputs, groups, letter)
  local c = source.statements(ctx, { name = "taylor", args = {}, inputs = inputs, groups = groups, letter = letter })
  local out = { loads = c.loads }
  for i in ipairs(groups) do out[i] = {} end
  for _, g in ipairs(c.groups) do out[g.where] = g.lines end
  return out
end

local function put(x, value, outs)
  if x.place then outs[#outs + 1] = { c = "y[" .. x.place .. "]", expr = value } end
end

-- Names as inputs: {sym, c}, read as they stand.
local function plain(list, names)
  for _, name in ipairs(names) do list[#list + 1] = { sym = name, c = name } end
end

-- The names that are read once before everything: members of the model, inputs, states that keep their value.
-- A corner's sign is -1 where the side that a step is on lies before it.
local function outside(ctx, program)
  local list = {}
  local moving = {}
  for _, s in ipairs(program.states) do moving[s.name] = true end
  for _, m in ipairs(ctx.members) do list[#list + 1] = { name = m.name, from = "m->" .. m.name } end
  for _, s in ipairs(ctx.states) do
    if not moving[s.name] then list[#list + 1] = { name = s.name, from = origin(ctx, s) } end
  end
  for _, s in ipairs(program.more or {}) do
    local from = s.input and "v[" .. ctx.upper .. "_NX + " .. text(s.input - 1) .. "]" or origin(ctx, s)
    list[#list + 1] = { name = s.name, from = from }
  end
  for _, k in ipairs(program.knots) do
    local at = k.time.kind == "num" and number.text(k.time.value, ctx.real) or "m->" .. k.time.name
    list[#list + 1] = { name = k.sign.name, from = string.format("side < %s ? %s : %s", at, number.text(R.lift(-1),
      ctx.real), number.text(R.one, ctx.real)) }
  end
  for _, s in ipairs(ctx.inputs) do
    list[#list + 1] = { name = s.name, from = "u[" .. ctx.upper .. "_" .. s.index .. "]" }
  end
  for i, s in ipairs(program.switches and program.switches.list or {}) do
    if s.branch then
      list[#list + 1] = { name = s.branch.name, from = program.switches.name .. "[" .. text(i - 1) .. "]" }
    end
  end
  return list
end

-- The next terms of the states, and of the sums of states: the group's results in y.  prefix: of their names, not the
-- same before the loop and in it, since a name before it may stand above both.
local function advance(program, key, prefix, by, map, group)
  local following = {}
  for _, x in ipairs(program.variables) do
    if x.state and x.place then
      local e = calculus.substitute(program.slopes[x.name][key], map) * by
      following[x.sym] = symbol(prefix .. x.name)
      group.defs[#group.defs + 1] = { name = prefix .. x.name, expr = e }
      put(x, following[x.sym], group.outs)
    elseif x.level == 0 and x.place then
      following[x.sym] = symbol(prefix .. x.name)
      group.defs[#group.defs + 1] = { name = prefix .. x.name, expr = calculus.substitute(x.term, following) }
      put(x, following[x.sym], group.outs)
    end
  end
end

-- Term 0 of everything that is needed in y, then term 1 of the states: two groups, between them the lanes are gathered.
-- Second result: term 0 alone, for taylor_rows.c, which makes term 1 itself.
local function start(ctx, program, names, needed)
  local inputs, map = {}, {}
  plain(inputs, names)
  local g, h = { where = 1, defs = {}, outs = {} }, { where = 2, defs = {}, outs = {} }
  for _, s in ipairs(program.states) do
    inputs[#inputs + 1] = { sym = s.name .. "0", c = origin(ctx, s) }
  end
  inputs[#inputs + 1] = { sym = "t0", c = "t" }
  for _, x in ipairs(program.variables) do map[x.sym] = zeroth(x) end
  for _, x in ipairs(program.variables) do
    if x.start and needed[x.name] then
      local value = calculus.substitute(x.start, map)
      g.defs[#g.defs + 1] = { name = x.name .. "0", expr = value }
      if x.first then
        g.outs[#g.outs + 1] = { c = "const " .. kind(ctx) .. " " .. program.term0 .. x.name, expr = zeroth(x) }
      end
    end
    put(x, zeroth(x), g.outs)
  end
  advance(program, "start", "first_", expr.one, map, h)
  local alone = rendered(ctx, inputs, { g }, "s") -- temporaries apart from those of the loop
  return rendered(ctx, inputs, { g, h }, "s"), alone
end

-- Term n: a group for each level, and last the states' term n + 1.
local function general(ctx, program, names, needed)
  local inputs, groups = {}, {}
  plain(inputs, names)
  plain(inputs, { "order", "after" })
  for _, x in ipairs(program.read) do
    if x.level == 0 then inputs[#inputs + 1] = { sym = x.sym.name, c = "y[" .. x.place .. "]" } end
  end
  for _, l in ipairs(program.lanes) do plain(inputs, { "p[" .. l.index .. "]" }) end -- read where it is used
  for _, x in ipairs(program.variables) do
    if x.first then
      local name = program.term0 .. x.name
      inputs[#inputs + 1] = { sym = name, c = x.state and "c[0][" .. x.place .. "]" or name }
    end
  end
  for level = 1, #program.levels do
    local g = { where = level, defs = {}, outs = {} }
    for _, x in ipairs(program.levels[level].variables) do
      if needed[x.name] then g.defs[#g.defs + 1] = { name = x.name, expr = x.term } end
      put(x, x.sym, g.outs)
    end
    groups[level] = g
  end
  local last = { where = #groups + 1, defs = {}, outs = {} }
  groups[#groups + 1] = last
  -- sums of states that no lane reads, in their order: one may have another in it
  local sums = 0
  for _, x in ipairs(program.levels[0].variables) do
    if not x.place and needed[x.name] then
      sums = sums + 1
      table.insert(groups[1].defs, sums, { name = x.name, expr = x.term })
    end
  end
  advance(program, "term", "next_", symbol "after", {}, last)
  return rendered(ctx, inputs, groups)
end

-- Which of the names do the forms of the program use?  A sum that nothing needs is not printed, so it does not count.
local function used_names(program, list)
  local seen, forms = {}, {}
  for _, d in ipairs(program.constants) do forms[d.name] = { d.expr } end
  for _, x in ipairs(program.variables) do forms[x.name] = { x.start or expr.zero, x.term } end
  local function need(name)
    if seen[name] then return end
    seen[name] = true
    for _, e in ipairs(forms[name] or {}) do
      for _, s in ipairs(expr.symbols(e)) do need((string.gsub(s.name, "^" .. program.term0, ""))) end
    end
  end
  local function note(e)
    for _, s in ipairs(expr.symbols(e)) do need((string.gsub(s.name, "^" .. program.term0, ""))) end
  end
  for _, x in ipairs(program.variables) do
    if x.place or x.first or x.root then need(x.name) end
    if x.state and x.place then
      note(program.slopes[x.name].start)
      note(program.slopes[x.name].term)
    end
  end
  local kept = {}
  for _, n in ipairs(list) do
    if seen[n.name] then kept[#kept + 1] = n end
  end
  return kept, seen
end

-- Names of the code around the statements, which those of the model must not take.
local own = { a = true, b = true, c = true, j = true, l = true, m = true, n = true, order = true, after = true,
  p = true, t = true, u = true, x = true, y = true, none = true, own = true,
  time = true }

-- The program with the names of members and inputs that the code around or a sequence takes made free: a member c
-- becomes c_, and the time as a sequence gets a name that is not t.  Of a program that was freed before nothing
-- changes: a plan may be emitted more than once.
local function freed(ctx, program)
  local map, renamed, taken, clock, sequences = {}, {}, {}, "clock", {}
  for _, x in ipairs(program.variables) do -- and its term 0
    if not x.state then sequences[x.name], sequences[x.name .. "0"] = true, true end
  end
  for _, list in ipairs { ctx.members, ctx.states, ctx.inputs, program.variables, program.constants } do
    for _, x in ipairs(list) do taken[x.name] = true end
  end
  while taken[clock] do clock = clock .. "_" end
  map[symbol "t"] = symbol(clock)
  local function free(sym, name)
    if own[name] or sequences[name] or name == "side" and #program.knots > 0 or name == "v" and program.more then
      map[sym], renamed[name] = expr.sym(name .. "_", sym.rank), name .. "_"
    end
  end
  for _, m in ipairs(ctx.members) do free(m.sym, m.name) end
  local function put_in(e) return e and calculus.substitute(e, map) end
  for _, d in ipairs(program.constants) do d.expr = put_in(d.expr) end
  for _, x in ipairs(program.variables) do
    if x.name == "t" then x.sym = map[x.sym] or x.sym end
    x.start, x.term = put_in(x.start), put_in(x.term)
  end
  for _, s in pairs(program.slopes) do -- each alone: order is lost
    s.start, s.term = put_in(s.start), put_in(s.term)
  end
  return renamed
end

-- The levels for the template: what their lanes read and the statements after them.
local function levels_of(program, rest, zero)
  local out = {}
  for level, l in ipairs(program.levels) do
    local entry = { number = text(level), lanes = {}, unknown = {}, known = {}, weighted = false, lines = rest[level],
      has_lanes = l.last >= l.first }
    local unknown = {}
    for i = l.first, l.last do
      local lane = program.lanes[i]
      local a, b = "y[" .. lane.a.place .. "]", "y[" .. lane.b.place .. "]"
      entry.lanes[#entry.lanes + 1] = { index = text(lane.index), a = text(lane.a.place), b = text(lane.b.place),
        weighted = lane.weighted or false, right = b, first = lane.weighted and zero or a,
        left = (lane.weighted and "order*" or "") .. a,
        about = (lane.weighted and "j " or "") .. lane.a.name .. "[j] " .. lane.b.name .. "[n-j]" }
      entry.weighted = entry.weighted or lane.weighted
      for side, x in ipairs { lane.a, lane.b } do
        if x.level == level then -- its newest term is made here: zero until then
          local left = side == 1
          if not unknown[x.place] then entry.unknown[#entry.unknown + 1] = text(x.place) end
          unknown[x.place] = true
          entry.known[#entry.known + 1] = string.format("%s[n][%d] = %sy[%d];", left and "a" or "b", lane.index,
            left and lane.weighted and "order*" or "", x.place)
        end
      end
    end
    out[level] = entry
  end
  return out
end

local function mentions(lines, name) return string.find(lines, "%f[%w_]" .. name .. "%f[^%w_]") ~= nil end

-- What stands in the recurrences, as values of the templates; a function from groups to their lines within them; and
-- the lines of term 0 alone.  has_knots: the time next to t is an argument.  zero: its literal.
function recurrences.of(ctx, program, has_knots, zero)
  local renamed = freed(ctx, program)
  local all = outside(ctx, program)
  for _, n in ipairs(all) do n.name = renamed[n.name] or n.name end
  local outer, seen = used_names(program, all)
  local v, names, type_name = { outer = {} }, {}, "const " .. kind(ctx) .. " "
  for i, n in ipairs(outer) do
    names[i] = n.name
    v.outer[i] = type_name .. n.name .. " = " .. n.from .. ";"
  end
  for _, d in ipairs(program.constants) do
    if seen[d.name] then
      local inputs, letter = {}, d.name .. "_t" -- all are in one scope, around that of the recurrences
      plain(inputs, names)
      local g = { where = 1, defs = {}, outs = { { c = type_name .. d.name, expr = d.expr } } }
      for _, l in ipairs(rendered(ctx, inputs, { g }, letter)[1]) do v.outer[#v.outer + 1] = l end
      names[#names + 1] = d.name
    end
  end
  local first, alone = start(ctx, program, names, seen)
  local rest = general(ctx, program, names, seen)
  local apart = alone.loads -- term 0 without term 1
  for _, l in ipairs(alone[1]) do apart[#apart + 1] = l end
  v.start, v.next = first.loads, first[2]
  for _, l in ipairs(first[1]) do v.start[#v.start + 1] = l end
  v.loads, v.after = rest.loads, rest[#rest]
  v.levels = levels_of(program, rest, zero)
  local function joined(list) return table.concat(list, "\n") .. "\n" end
  local loop = joined(v.loads) .. joined(v.after)
  for _, e in ipairs(v.levels) do
    loop = loop .. joined(e.lines) .. joined(e.known) .. (e.weighted and "order\n" or "")
  end
  local whole = loop .. joined(v.start) .. joined(v.next) .. joined(v.outer)
  v.uses_order, v.voids = mentions(loop, "order"), {}
  local sides = program.switches and program.switches.count > 0 and program.switches.name or nil
  for _, name in ipairs { "m", "t", "u", sides } do
    if not mentions(whole, name) then v.voids[#v.voids + 1] = "(void)" .. name .. ";" end
  end
  v.side = has_knots and ", " .. ctx.name .. "_real side" or ""
  v.has_lanes, v.lanes = #program.lanes > 0, text(#program.lanes)
  v.places, v.count = text(#program.read), text(#program.states)
  local function within(groups)
    local inputs = {}
    plain(inputs, names)
    return rendered(ctx, inputs, groups)[1]
  end
  return v, within, apart
end

return recurrences
