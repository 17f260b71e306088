-- init.lua -- what NAME_init does: tests the parameters, then computes the derived constants.
--
-- A composite body's constants are computed in its named parts (mass/parts.lua); a constant that a later one uses is a
-- local of its own name.  BELOW the line where it makes C.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local cost = require "generator.algebra.cost"
local cosine = require "generator.algebra.cosine"
local nest = require "generator.algebra.nest"
local number = require "generator.emit.number"
local source = require "generator.emit.source"
local template = require "generator.emit.template"

local GROUP = template.group("core/init.h", "core/init.c")

local init = {}

local words = { rest = true, m = true, p = true, k = true, roundoff = true, slack = true }

-- Does NAME_init itself call something so?
local function taken(name) return words[name] or string.match(name, "^check%d+$") end

-- The members' forms, nested if that is cheaper: all or none, as sums that they share must stay shared.
local function nested(members)
  local best = {}
  for i, member in ipairs(members) do best[i] = cosine(member.form) end
  local least = cost(best)
  for _, last in ipairs { false, true } do
    local forms = {}
    for i, member in ipairs(members) do forms[i] = nest(cosine(member.form), last) end
    local now = cost(forms)
    if now < least then best, least = forms, now end
  end
  return best
end

-- Appends a group for each step of the body's parts that the forms need and that is not in `placed` yet.
local function steps(m, forms, map, placed, groups)
  for _, step in ipairs(m.parts and m.parts:needed(forms) or {}) do
    if not placed[step] then
      placed[step] = true
      groups[#groups + 1] = { why = step.about, outs = {},
        defs = { { name = step.name, expr = calculus.substitute(step.e, map) } } }
    end
  end
end

-- The members that a model holds without those of the set `unread`, which may be nil.
function init.kept(m, unread)
  local list = {}
  for _, member in ipairs(m.members) do
    if not (unread and unread[member.name]) then list[#list + 1] = member end
  end
  return list
end

-- The set of the members whose names are not in the set `read`; nil if there is none, or no other one.  What must be
-- above 0 is kept.
function init.unread(m, read)
  local set, some = {}, false
  for _, member in ipairs(m.members) do
    if not read[member.name] and not member.positive then set[member.name] = true else some = true end
  end
  return some and next(set) and set or nil
end

-- The members that are kept, and those that they are made of.
local function computed(m, unread)
  local needed, list = {}, {}
  for i = #m.members, 1, -1 do -- a form has only earlier ones in it
    local member = m.members[i]
    if needed[member.name] or not (unread and unread[member.name]) then
      table.insert(list, 1, member)
      for _, s in ipairs(expr.symbols(member.form)) do needed[s.name] = true end
    end
  end
  return list
end

-- The groups of parts and constants; members: which constants; placed: steps that are there already; unread: those of
-- the members that no model holds, or nil.
local function constants(m, members, map, groups, placed, unread)
  local forms, used = nested(members), {}
  local own = { table.unpack(forms) }
  steps(m, forms, map, placed, groups)
  for _, e in ipairs(forms) do
    for _, s in ipairs(expr.symbols(e)) do used[s] = true end
  end
  for i, member in ipairs(members) do
    local e = calculus.substitute(own[i], map)
    local named = used[member.sym] and own[i] ~= member.sym
    groups[#groups + 1] = { why = member.about, defs = named and { { name = member.name, expr = e } } or {},
      outs = unread and unread[member.name] and {} or
        { { c = "k." .. member.name, expr = named and member.sym or e } } }
  end
  return groups
end

-- Operations that computing the constants `members` from the parameters takes.
function init.cost(ctx, m, members)
  local list, map = source.parameters(ctx, m.params, taken)
  return source.count { name = "init", inputs = list, groups = constants(m, members, map, {}, {}) }
end

-- The lists a and b as one.
local function joined(a, b)
  local list = { table.unpack(a) }
  for _, x in ipairs(b) do list[#list + 1] = x end
  return list
end

local widest = 98 -- columns of a statement with its comment behind it; a longer comment stands before

-- A group's lines; and are they one statement with its comment?
local function group_lines(g, check)
  local lines, note = { table.unpack(g.lines) }, check and check.text or g.why
  if check then
    lines[#lines + 1] = string.format("if (!(%s)) return %s;", check.condition, check.number)
  end
  local last = lines[#lines]
  if (check or #lines == 1) and note and #last + #note + 7 <= widest then
    lines[#lines] = last .. " /* " .. note .. " */"
  elseif note then
    lines = joined(source.comment(note), lines)
  end
  return lines, #lines == 1
end

-- The groups as blocks of lines, between which the template leaves a line: statements of one line stand together.
-- A group's `where` is the number of its test, or between those of the tests that it stands between; a test that
-- computes nothing is no group.
local function blocks(groups, checks)
  local out, short = {}, false
  local function put(g, check)
    local lines, alone = group_lines(g, check)
    if alone and short then
      table.insert(out[#out].lines, lines[1])
    else
      out[#out + 1] = { lines = lines }
    end
    short = alone
  end
  local done = 0
  local function tests(upto)
    for i = done + 1, upto do put({ lines = {} }, checks[i]) end
    done = math.max(done, upto)
  end
  for _, g in ipairs(groups) do
    tests(math.ceil(g.where) - 1)
    put(g, checks[g.where])
    done = math.max(done, math.floor(g.where))
  end
  tests(#checks)
  return out
end

-- The members whose being finite must be asked for.  That of a small multiple of another one follows, but for an
-- overflow, in which the first step ends as well; stepped: is there such a step?  Of several multiples of one that is
-- not kept the first is asked.
local function unsure(m, stepped, unread)
  local list, asked = {}, {}
  for _, member in ipairs(init.kept(m, unread)) do
    local e = member.form
    local factor = e.kind == "mul" and #e == 2 and e[1].kind == "num" and e[2].kind == "sym" and m.by_name[e[2].name]
    local known = factor and (asked[factor] or not (unread and unread[factor.name]))
    local follows = stepped and known and R.abs(e[1].value) <= R.new(4)
    if not follows then list[#list + 1] = member end
    if factor then asked[factor] = true end
  end
  return list
end

-- {loads, groups, finite, checks}: what NAME_init computes and tests.  stepped: does it make a step?  unread: the
-- members that no function reads, a set, or nil.
function init.of(ctx, m, stepped, unread)
  local list, map = source.parameters(ctx, m.params, taken)
  local groups, checks, placed = {}, {}, {}
  -- a condition may ask for the rounding of the real type, half a unit in the last place of 1: it keeps a name, for
  -- multiplied into the other numbers of a sum it would spoil their form
  for _, c in ipairs(m:rounding(R.new(2) ^ (ctx.real == "float" and -24 or -53))) do
    map[c.sym] = expr.sym(c.name, 1, true)
    list[#list + 1] = { sym = c.name, c = number.text(c.value, ctx.real), rounding = true }
  end
  for i, c in ipairs(m.conditions) do
    steps(m, { c.form }, map, placed, groups)
    for k = #groups, 1, -1 do
      if groups[k].where then break end
      groups[k].where = i - 0.5
    end
    local e, tested = calculus.substitute(c.form, map), "check" .. i
    for _, p in ipairs(list) do -- a parameter itself
      if e.kind == "sym" and e.name == p.sym and not p.rounding then tested = p.c end
    end
    groups[#groups + 1] = { where = i, defs = {}, outs = tested == "check" .. i and
      { { c = "const " .. ctx.type .. " check" .. i, expr = e } } or {} }
    local relation = c.allow_zero and " >= " or " > "
    checks[i] = { number = string.format("%d", i), text = c.text,
      condition = tested .. relation .. number.text(R.zero, ctx.real) }
  end
  constants(m, computed(m, unread), map, groups, placed, unread)
  for _, g in ipairs(groups) do g.where = g.where or #checks + 0.5 end
  local c = source.statements(ctx, { name = "init", args = {}, inputs = list, groups = groups })
  local code, lines, zero = #checks + 1, {}, number.text(R.zero, ctx.real)
  for _, member in ipairs(unsure(m, stepped, unread)) do
    local term = string.format("(k.%s - k.%s)", member.name, member.name)
    local line = lines[#lines]
    if line and #line + #term < 92 then
      lines[#lines] = string.sub(line, 1, -2) .. " + " .. term .. ";"
    else
      lines[#lines + 1] = (line and "rest += " or "real rest = ") .. term .. ";"
    end
  end
  if lines[1] then lines[1] = string.gsub(lines[1], "^real", ctx.type) end
  if #lines > 0 then lines[#lines + 1] = string.format("if (!(rest == %s)) return %d;", zero, code) end
  for _, member in ipairs(m.members) do
    if member.positive then
      lines[#lines + 1] = string.format("if (!(k.%s > %s)) return %d;", member.name, zero, code)
    end
  end
  local listed = {}
  for i, check in ipairs(checks) do listed[i] = { number = check.number, text = check.text } end
  if #init.kept(m, unread) > 0 then
    local nonzero, names = "", {}
    for _, member in ipairs(m.members) do
      if member.positive then names[#names + 1] = member.name end
    end
    if #names > 0 then nonzero = ", and " .. table.concat(names, ", ") .. " above 0" end
    listed[#listed + 1] = { number = string.format("%d", code), text = "every derived constant must be finite" ..
      nonzero }
  end
  if #listed == 0 then listed[1] = { number = "-", text = "there is nothing to check" } end
  return { loads = c.loads, groups = blocks(c.groups, checks), finite = lines, checks = listed }
end

local function add(list, text)
  list[list[#list].number == "-" and #list or #list + 1] = { text = text }
  list[#list].number = string.format("%d", #list)
end

-- Does the set-up of a stepper fail where a constant is not finite?  Its check has a number.
function init.check_setup(checks)
  local text = "every derived constant must be finite"
  if checks[#checks].text ~= text then add(checks, text) end
  return checks[#checks].number
end

-- The last check: parameters of which every constant is finite may still overflow in a step.  Only such a step can
-- tell, so NAME_init makes one: the scene's own first.  Without parameters there is nothing that it could find: nil.
function init.check_step(checks, m, step_text)
  if #m.params == 0 or #m.members == 0 then return nil end
  add(checks, "the state after the first step of " .. step_text .. " s must be finite")
  return checks[#checks].number
end

-- The names of the model's real members, elements of arrays each by itself; setup: with those of a splitting's set-up.
function init.real_members(members, setup)
  local names = {}
  for i, member in ipairs(members) do names[i] = member.name end
  for _, name in ipairs(setup and { "split_b", "split_c", "split_u", "split_d" } or {}) do
    for k = 0, 2 do names[#names + 1] = string.format("%s[%d]", name, k) end
  end
  if setup then names[#names + 1], names[#names + 2] = "split_fb", "split_fc" end
  return names
end

-- Statements *m = k, member by member: of the whole some compilers make a call of memcpy.
local function copies(about)
  local names, lines = table.move(about.real_members, 1, #about.real_members, 1, {}), { "" }
  for k = 0, about.order and 2 or -1 do names[#names + 1] = string.format("order[%d]", k) end
  for _, name in ipairs(names) do
    local s = "m->" .. name .. " = k." .. name .. ";"
    local last = lines[#lines]
    if last == "" then lines[1] = s
    elseif #last + #s < 96 then lines[#lines] = last .. " " .. s
    else lines[#lines + 1] = s end
  end
  return lines
end

-- What NAME_init cannot ask: lines of the header.
local function unasked(m)
  local lines = {}
  for _, c in ipairs(m.unasked) do
    lines = joined(lines, source.comment("Not a check of the set-up, for there is no formula: " .. m:sentence(c)))
  end
  return lines
end

-- Header and source of NAME_init and NAME_defaults.  made: from init.of; about: {order = does it find signs of moments,
-- setup_code, step_code = numbers of those checks or nil, real_members, defaults = see emit/head.lua,
-- no_members}
function init.fragment(made, job, base, about)
  local v = { loads = made.loads, groups = made.groups, finite = made.finite, checks = made.checks,
    params = about.defaults, copies = copies(about), has_finite = #made.finite > 0,
    order = about.order, split_setup = about.setup_code ~= nil, setup_code = about.setup_code,
    unasked = unasked(job.model), first_step = about.step_code ~= nil, step_code = about.step_code,
    no_members = about.no_members }
  local render = GROUP(job.templates, base, v)
  return render "core/init.h", render "core/init.c"
end

return init
