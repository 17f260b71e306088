-- explain.lua -- the explanation of a scene as text or JSON, from report/facts.lua; handout/ has the printed one.
--
-- A document is a list of sections {title, {line, ...}}; a line is plain words, or a formula {name, expression,
-- unit, number} that each format writes in its own way.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local text = require "generator.formula.text"
local vec = require "generator.algebra.vec"
local equations = require "generator.dynamics.equations"
local linear = require "generator.formula.linear"
local setting = require "generator.formula.setting"
local switching = require "generator.dynamics.switching"
local init = require "generator.emit.init"
local source = require "generator.emit.source"
local attribution = require "generator.report.attribution"
local counted = require "generator.report.counted"
local facts = require "generator.report.facts"
local handout = require "generator.report.handout.handout"
local json = require "generator.report.json"
local linearised = require "generator.report.linearised"
local order = require "generator.report.order"
local pieces = require "generator.report.pieces"
local symbols = require "generator.report.symbols"
local design = require "generator.report.stability_conditions"
local values = require "generator.report.values"

local explain = {}

local comp = { "x", "y", "z" }

local function formula(name, e, unit, number) return { name = name, e = e, unit = unit, number = number } end

-- named: the entries in the names of the body's parts, when it has such.
local function tensor_lines(I, numbers, named)
  local lines, zeros = {}, {}
  for n, e in ipairs(I) do
    local name = "I" .. vec.entry[n]
    if e == expr.zero then
      zeros[#zeros + 1] = name
    else
      lines[#lines + 1] = formula(name, named and named[n] or e, "kg m^2", numbers[n])
    end
  end
  if #zeros > 0 then lines[#lines + 1] = table.concat(zeros, " = ") .. " = 0" end
  return lines
end

local function number(x) return json.number(x) end

-- e as the text has it: with the names of the body's parts for what is opaque.
local function in_names(f, e)
  local parts = f.job.model.parts
  return parts and parts:shown(e) or e
end

local function body_section(f)
  local lines = { formula("M", f.mass, "kg", f.mass_number) }
  local function vector(name, v, numbers, meaning, vanishes)
    local count = #lines
    for i = 1, 3 do
      if v[i] ~= expr.zero then lines[#lines + 1] = formula(name .. comp[i], v[i], "m", numbers[i]) end
    end
    lines[#lines + 1] = #lines == count and vanishes or meaning
  end
  vector("com_", f.com, f.com_number, "com: the centre of mass in the coordinates of the shape",
    "the centre of mass is at (0, 0, 0) of the shape")
  vector("R", f.arm, f.arm_number, "R: the centre of mass seen from the origin of rotation",
    "the centre of mass is the origin of rotation")
  return lines
end

local function principal_section(f)
  local lines = { "structure: " .. f.symmetry }
  if not f.physical then
    lines[2] = "no body has these moments (physical = false): the largest is more than the sum of the others"
  end
  for n, p in ipairs(f.closed_moments or {}) do
    local named = f.closed_named[n]
    lines[#lines + 1] = formula("I" .. (p.multiplicity > 1 and " (" .. p.multiplicity .. " times)" or ""),
      named.moment, "kg m^2", f.job.model:double(p.moment))
    if p.axis then
      local parts = {}
      for i = 1, 3 do parts[i] = text.of(in_names(f, named.axis[i]), "plain") end
      lines[#lines + 1] = "  about the axis (" .. table.concat(parts, ", ") .. ")"
    end
  end
  for n, k in ipairs(order.of(f)) do
    local a = f.axes[k]
    lines[#lines + 1] = string.format("I%d = %s kg m^2, axis (%s, %s, %s)", n, number(f.moments[k]), number(a[1]),
      number(a[2]), number(a[3]))
  end
  return lines
end

local function equation_section(f)
  local lines = {}
  local shown = { M = f.mass } -- above, by their names; and a multiple only the code needs
  for n, e in ipairs(f.inertia) do shown["I" .. vec.entry[n]] = e end
  for k, e in ipairs(f.arm) do shown["R" .. comp[k]] = e end
  for _, member in ipairs(f.job.model.members) do
    if shown[member.name] ~= member.e and not member.multiple then
      local own = member.form == member.sym -- a step of the body, which need not stand above
      lines[#lines + 1] = formula(member.name, own and member.e or member.form, nil, f.job.model:double(member.e))
    end
  end
  for _, g in ipairs(f.job.equations.groups) do
    lines[#lines + 1] = g.why .. (g.where and "  [" .. g.where .. "]" or "")
    for _, d in ipairs(g.defs) do lines[#lines + 1] = formula("  " .. d.name, d.expr) end
    for _, o in ipairs(g.outs) do lines[#lines + 1] = formula("  d" .. o.state .. "/dt", o.expr) end
  end
  return lines
end

local function corner_section(corners)
  local lines, seen = { "adaptive, taylor and rosenbrock end their steps there; other methods lose their order" }, {}
  for _, s in ipairs(corners.list) do
    local what = switching.about(s)
    if not seen[what] then lines[#lines + 1] = "  " .. what end
    seen[what] = true
  end
  return lines
end

local function stability_section(f)
  local lines = { "small oscillations of a free spin w about each principal axis (k; i, j cyclic):" ..
    " Omega1 = (Ik - Ij)/Ii w, Omega2 = (Ik - Ii)/Ij w; the rates are A cos(sqrt(Omega1 Omega2) t + psi0)" }
  if not f.job.model.has.rates then return { "the body is a point: it does not turn" } end
  local upright = f.upright and "; the heavy top, upright with its spin, is " .. f.upright or ""
  if #f.job.record.effects > 0 then lines[#lines + 1] = "(of the body without its effects" .. upright .. ")" end
  for n, k in ipairs(order.of(f)) do
    local s = f.stability[k]
    local tail = s.period and ", period " .. number(s.period) .. "/w" or s.growth and ", growth rate " ..
      number(s.growth) .. " w" or ""
    lines[#lines + 1] = string.format("axis %d: %s; Omega1 = %s w, Omega2 = %s w%s", n, s.verdict, number(s.omega1),
      number(s.omega2), tail)
  end
  for k, e in ipairs(f.conditions or {}) do
    lines[#lines + 1] = formula("  Omega1 Omega2/w^2 about " .. comp[k], e, nil, f.job.model:double(e))
  end
  return lines
end

-- The closed forms that were refused, those with one reason together; the ones that a better form made needless are not
-- told.
local function refusals(others)
  local groups, by_reason = {}, {}
  for _, o in ipairs(others) do
    local g = by_reason[o.reason]
    if not g and not string.find(o.reason, "^not needed") then
      g = { reason = o.reason, names = {} }
      groups[#groups + 1], by_reason[o.reason] = g, g
    end
    if g then g.names[#g.names + 1] = o.name end
  end
  return groups
end

local function motion_section(f)
  local lines = {}
  if f.closed.kind then
    lines[1] = "closed form: " .. f.closed.theorem
    for _, l in ipairs(f.closed.text) do lines[#lines + 1] = "  " .. l end
  elseif f.closed.reduced then
    lines[1] = "reduced to quadratures: " .. f.closed.reduced.theorem
    for _, l in ipairs(f.closed.reduced.text) do lines[#lines + 1] = "  " .. l end
  else
    lines[1] = "no closed form"
  end
  for _, o in ipairs(refusals(f.closed.others)) do
    lines[#lines + 1] = "  not the " .. table.concat(o.names, ", the ") .. ": " .. o.reason
  end
  for _, e in ipairs(f.job.record.effects) do
    local name = string.gsub(e.kind, "effect%.", "")
    lines[#lines + 1] = "effect " .. name .. " (line " .. e.line .. "): " .. e.spec.about .. "; conserves " ..
      f.job.conserved.words(e.spec)
  end
  if #f.job.record.effects == 0 then
    lines[#lines + 1] = "no effects: T and the inertial L are conserved"
  end
  local landing = f.job.record.landing
  if landing then
    lines[#lines + 1] = "landing on the plane (line " .. landing.line .. "): " .. f.job.model.name .. "_gap is the " ..
      "height of the lowest point, " .. f.job.model.name .. "_impact the impact of Chatterjee and Ruina"
  end
  local laws = f.job.conserved
  lines[#lines + 1] = "conserved: " .. (#laws > 0 and table.concat(laws, ", ") or "nothing") ..
    (landing and " from one impact to the next" or "")
  if f.stiff then
    lines[#lines + 1] = string.format("stiff: at t = 0 something decays at %.2g 1/s, %.2g times within the horizon " ..
      "of %s s", f.stiff.rate, f.stiff.decays, number(f.job.model:double(f.job.model.horizon)))
  end
  for _, why in ipairs(f.job.model.reasons) do lines[#lines + 1] = "state: " .. why end
  return lines
end

local function cost_section(job)
  local ctx = { name = job.model.name, upper = string.upper(job.model.name), real = job.real,
    members = job.model.members, states = job.states, inputs = job.model.inputs }
  local lines = {}
  local function put(name, c)
    lines[#lines + 1] = { fn = name, add = c.add or 0, mul = c.mul or 0, div = c.div or 0, sqrt = c.sqrt or 0,
      call = c.call or 0 }
  end
  local m, tensor = job.model, {}
  for _, member in ipairs(m.members) do
    for _, e in ipairs(m.inertia) do
      if member.e == e then tensor[#tensor + 1] = member end
    end
  end
  put("init", init.cost(ctx, m, m.members))
  put("  its tensor", init.cost(ctx, m, tensor))
  for _, fn in ipairs(job.functions) do put(fn.name, source.cost(ctx, fn)) end
  return lines
end

local function operations(job)
  local lines = {}
  for i, c in ipairs(cost_section(job)) do
    lines[i] = string.format("%-16s %4d + -  %4d *  %3d /  %2d sqrt  %2d calls", c.fn, c.add, c.mul, c.div, c.sqrt,
      c.call)
  end
  return lines
end

-- The central tensor in the names of the parts of a body that turns about another point: the shift back.
-- The mass is the M that stands above, unless a parameter is called so.
local function shifted_back(f, parts)
  local mass = parts.mass.kind ~= "num" and expr.sym("M", 3) or parts.mass
  for _, p in ipairs(f.params) do
    if p.name == "M" then mass = f.mass end
  end
  local R = vec.map(f.arm, function(e, i) return e.kind == "num" and e or expr.sym("R" .. comp[i], 3) end)
  return vec.map(f.inertia, function(_, n)
    local I = expr.sym("I" .. vec.entry[n], 3)
    if n > 3 then return I + mass * R[vec.pair[n][1]] * R[vec.pair[n][2]] end
    return I - mass * (R[n % 3 + 1] ^ 2 + R[(n + 1) % 3 + 1] ^ 2)
  end)
end

local function document(f)
  local doc = {}
  local function section(title, lines) doc[#doc + 1] = { title = title, lines = lines } end
  local params = {}
  for i, p in ipairs(f.params) do params[i] = p.name .. " = " .. p.given end
  if #params == 0 then params[1] = "none: every number is an exact constant" end
  section("Parameters", params)
  local derived = pieces.lines(f.job.model, formula)
  if #derived > 0 then section("Pieces", derived) end
  section("Body", body_section(f))
  local parts = f.job.model.parts
  section("Tensor of inertia about the origin of rotation",
    tensor_lines(f.inertia, f.inertia_number, parts and parts.entries))
  section("Tensor of inertia about the centre of mass", f.is_central and { "the same" } or
    tensor_lines(f.centroidal, f.centroidal_number, parts and shifted_back(f, parts)))
  if f.job.model.has.rates then section("Principal moments and axes", principal_section(f)) end
  section("Equations of motion", equation_section(f))
  local corners = switching.of(equations.fork(f.job.equations))
  if corners then section("Corners at times that are not known before", corner_section(corners)) end
  section("Motion", motion_section(f))
  local known = symbols.of(f)
  local initially = values.lines(f, known.reader)
  for _, c in ipairs(known:said()) do
    local name = setting.of(linear.ascii, c.node)
    initially[#initially + 1] = (c.name and c.name .. " is a name of the scene, so " or "") .. c.meaning ..
      " is written " .. name
  end
  if #initially > 0 then section("Values of the motion", initially) end
  section("Stability", stability_section(f))
  if f.job.model.has.rates then
    section("Linearised motion", linearised.lines(f))
    section("Stability by design", design.lines(f))
  end
  if f.asked then section("Asked for", f.asked) end
  section("Operations of the emitted functions", operations(f.job))
  local sheet, names = f.job.sheet(true)
  local table_of = { string.format("%-12s %s", "", string.format(string.rep("%11s", #names), table.unpack(names))) }
  for _, row in ipairs(sheet) do
    table_of[#table_of + 1] = string.format("%-12s %s", row.name,
      string.format(string.rep("%11s", #row.cycles), table.unpack(row.cycles)))
  end
  section("Estimated cycles of one call, in " .. f.job.real .. " (--target counts instead)", table_of)
  for _, s in ipairs(f.job.counted and counted.text(f.job.counted) or {}) do section(s.title, s.lines) end
  section("Operations of the right-hand side, by what calls for them", attribution.lines(attribution.of(f.job)))
  local warnings = {}
  for i, w in ipairs(f.warnings) do warnings[i] = w.text end
  if #warnings > 0 then section("Warnings", warnings) end
  return doc
end

local writers = {}

function writers.text(f)
  local out = { f.name .. " (" .. f.file .. ")" }
  for _, s in ipairs(document(f)) do
    out[#out + 1] = "\n" .. s.title
    for _, l in ipairs(s.lines) do
      if type(l) == "string" then
        out[#out + 1] = "  " .. l
      else
        local sides = { l.name } -- the name, the formula, the number; what repeats is said once
        local value, plain = text.of(in_names(f, l.e), "unicode"), l.number and number(l.number)
        if value ~= l.name then sides[#sides + 1] = value end
        if plain and tonumber(value) ~= l.number then sides[#sides + 1] = plain end
        out[#out + 1] = "  " .. table.concat(sides, " = ") .. (l.unit and " " .. l.unit or "")
      end
    end
  end
  return table.concat(out, "\n") .. "\n"
end

local object = json.object

local function entries(I, numbers)
  local symbolic = {}
  for n, e in ipairs(I) do symbolic[n] = { vec.entry[n], text.of(e, "plain") } end
  return object { { "symbolic", object(symbolic) }, { "numeric", numbers } }
end

local function symbolic(v)
  local list = {}
  for i, e in ipairs(v) do list[i] = text.of(e, "plain") end
  return list
end

function writers.json(f)
  local others = {}
  for i, o in ipairs(f.closed.others) do others[i] = object { { "name", o.name }, { "reason", o.reason } } end
  local closed = f.closed.kind and object { { "kind", f.closed.kind }, { "theorem", f.closed.theorem },
      { "rates_only", not f.closed.full and not f.closed.centre }, { "part", f.closed.part or json.null },
      { "others", others } } or
    object { { "kind", json.null }, { "refused", f.closed.refused },
      { "reduced", f.closed.reduced and f.closed.reduced.theorem or json.null }, { "others", others } }
  local params, stability, effects, cost, warnings, estimated = {}, {}, {}, {}, {}, {}
  for i, p in ipairs(f.params) do
    params[i] = object { { "name", p.name }, { "default", f.job.model:double(p.sym) }, { "unit", p.unit } }
  end
  for i, s in ipairs(f.stability) do
    local entry = { { "axis", s.axis }, { "moment", s.moment }, { "verdict", s.verdict },
      { "Omega1_per_rate", s.omega1 }, { "Omega2_per_rate", s.omega2 }, { "Omega_squared_per_rate_squared", s.square } }
    for _, more in ipairs(design.json(s)) do entry[#entry + 1] = more end
    stability[i] = object(entry)
  end
  for i, e in ipairs(f.job.record.effects) do
    effects[i] = object { { "name", e.kind }, { "about", e.spec.about }, { "conserves", f.job.conserved.words(e.spec) },
      { "line", e.line } }
  end
  for i, c in ipairs(cost_section(f.job)) do
    cost[i] = object { { "function", c.fn }, { "add", c.add }, { "mul", c.mul }, { "div", c.div }, { "sqrt", c.sqrt },
      { "call", c.call } }
  end
  local sheet, names = f.job.sheet(true)
  for i, row in ipairs(sheet) do
    local c, cycles = row.counts, {}
    for k, name in ipairs(names) do cycles[k] = { name, tonumber(row.cycles[k]) } end
    estimated[i] = object { { "function", row.name }, { "add", c.add }, { "mul", c.mul }, { "div", c.div },
      { "sqrt", c.sqrt }, { "call", c.call }, { "cycles", object(cycles) } }
  end
  for i, w in ipairs(f.warnings) do warnings[i] = w.text end
  local methods = { "rk4", f.job.model.has.rates and "linearised" or nil }
  if f.closed.kind then methods[#methods + 1] = "exact" end
  local doc = object { { "name", f.name }, { "parameters", params }, { "mass", f.mass_number },
    { "mass_symbolic", text.of(f.mass, "plain") }, { "com", f.com_number }, { "com_symbolic", symbolic(f.com) },
    { "origin", f.origin_number },    { "com_from_origin", f.arm_number },
    { "inertia", entries(f.inertia, f.inertia_number) }, { "centroidal", entries(f.centroidal, f.centroidal_number) },
    { "principal", object { { "moments", f.moments }, { "axes", f.axes } } }, { "symmetry", f.symmetry },
    { "physical", f.physical },
    { "closed_form", closed }, { "stiff", f.stiff and object { { "rate", f.stiff.rate }, { "decays", f.stiff.decays },
      { "horizon", f.job.model:double(f.job.model.horizon) } } or json.null },
    { "values", values.json(f) }, { "stability", stability },
    { "linearised", linearised.json(f) }, { "effects", effects }, { "methods", methods }, { "cost", cost },
    { "cycles", object { { "real", f.job.real }, { "functions", estimated } } },
    { "rhs", attribution.json(attribution.of(f.job), object) }, { "asked", f.asked or json.null },
    { "warnings", warnings } }
  if f.job.counted then doc[#doc + 1] = { "counted", counted.json(f.job.counted, object, json.null) } end
  return json.text(doc)
end

-- What a hand-out says of processors: the sections of costs, as lines of text.
local function costs(f)
  local list = { { title = "Operations of the emitted functions", lines = operations(f.job) } }
  list[2] = { title = "Operations of the right-hand side, by what calls for them",
    lines = attribution.lines(attribution.of(f.job)) }
  for _, s in ipairs(f.job.counted and counted.text(f.job.counted) or {}) do
    list[#list + 1] = { title = s.title, lines = s.lines }
  end
  return list
end

-- The explanation of a unit in the format; told: {asked = lines on the accuracy that is asked for, or nil, stiff =
-- {rate, decays} of plan/stiffness.lua, or nil}, or nil; sections and head: of a hand-out, or nil.
function explain.text(unit, format, told, sections, head)
  local f = facts.of(unit)
  if told then f.asked, f.stiff = told.asked, told.stiff end
  if handout.formats[format] then return handout.text(f, format, sections, costs(f), head) end
  return writers[format](f)
end

return explain
