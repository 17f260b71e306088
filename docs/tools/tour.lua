-- tour.lua -- the tour of docs/design.md: one scene through every stage, each stage's data as it really is.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 docs/tools/tour.lua PROGRAM PAGE        in the project's root, after make: `make docs`
--
-- The scene is the page's own block `scene`; the other blocks are made from it and written between their marks,
-- <!-- tour: NAME --> and <!-- end of NAME -->.  What a stage hands on is printed by the few lines below; instructions
-- and C are the program's own (`polhode gen --show`, and the files that it writes).

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local expr = require "generator.algebra.expr"
local text = require "generator.formula.text"
local lower = require "generator.ir.lower.lower"
local scene = require "tests.scene"
local program = require "tests.cli.program"

local tour = {}

local function show(e) return text.of(expr.lift(e)) end

-- Lines of aligned columns; the last one is ragged.
local function columns(rows)
  local width = {}
  for _, r in ipairs(rows) do
    for k = 1, #r - 1 do width[k] = math.max(width[k] or 0, utf8.len(r[k])) end
  end
  local out = {}
  for i, r in ipairs(rows) do
    local cells = {}
    for k, cell in ipairs(r) do cells[k] = cell .. string.rep(" ", k < #r and width[k] - utf8.len(cell) + 2 or 0) end
    out[i] = (string.gsub(table.concat(cells), "%s+$", ""))
  end
  return table.concat(out, "\n") .. "\n"
end

-- ---- above the line ----

local function record(r)
  local rows = {}
  for _, p in ipairs(r.params) do
    rows[#rows + 1] = { "param", p.name, tostring(p.default) .. " " .. p.unit, "line " .. p.line }
  end
  local sizes = {}
  for name, e in pairs(r.body.a) do sizes[#sizes + 1] = name .. " = " .. show(e) end -- sorted below
  table.sort(sizes)
  rows[#rows + 1] = { "body", r.body.shape, table.concat(sizes, ", ") .. ", mass = " .. show(r.body.mass),
    "line " .. r.body.line }
  for _, e in ipairs(r.effects) do
    rows[#rows + 1] = { "effect", e.kind, "rate = " .. show(e.a.rate), "line " .. e.line }
  end
  local w = {}
  for i, e in ipairs(r.omega) do w[i] = show(e) end
  rows[#rows + 1] = { "omega", "", "{" .. table.concat(w, ", ") .. "}" }
  rows[#rows + 1] = { "outputs", "", table.concat(r.outputs.list, ", ") }
  for _, c in ipairs(r.checks) do
    rows[#rows + 1] = { "check", c.what, c.rule, "line " .. c.line }
  end
  return columns(rows)
end

local function model(m)
  local rows = { { "structure", m.structure.kind } }
  for _, s in ipairs(m.states) do
    rows[#rows + 1] = { "state", s.name .. "(0) = " .. show(s.initial) .. " " .. s.unit }
  end
  for _, why in ipairs(m.reasons) do rows[#rows + 1] = { "reason", why } end
  for _, c in ipairs(m.members) do
    rows[#rows + 1] = { "constant", c.name .. " = " .. show(c.e), c.about }
  end
  return columns(rows)
end

-- Equation groups, as dynamics/equations.lua and dynamics/quantities.lua give them.
local function groups(list)
  local out = {}
  for _, g in ipairs(list) do
    out[#out + 1] = "-- " .. g.why .. "    [" .. (g.where or "") .. "]\n"
    for _, d in ipairs(g.defs) do out[#out + 1] = "   " .. d.name .. " = " .. show(d.expr) .. "\n" end
    for _, o in ipairs(g.outs) do
      local left = o.array and o.array .. "[" .. o.state .. "]" or o.state .. "'"
      out[#out + 1] = "   " .. left .. " = " .. show(o.expr) .. "\n"
    end
  end
  return table.concat(out)
end

local function refusals(closed)
  local rows = {}
  for _, o in ipairs(closed.others) do rows[#rows + 1] = { o.name, o.reason } end
  return columns(rows)
end

-- ---- the forms of lower ----

local of

local function term(t)
  if t.f.kind == "one" then return tostring(t.c) end
  local c = tostring(t.c)
  return (c == "1" and "" or c == "-1" and "-" or c .. " ") .. of(t.f)
end

local function joined(list, f)
  local out = {}
  for i, x in ipairs(list) do out[i] = f(x) end
  return table.concat(out, ", ")
end

function of(f)
  if f.kind == "leaf" then return f.name end
  if f.kind == "sum" then return "sum(" .. joined(f.terms, term) .. ")" end
  if f.kind == "powi" then return "powi(" .. of(f.base) .. ", " .. f.n .. ")" end
  if f.kind == "prod" then
    return "prod(" .. joined(f.num, of) .. (#f.den > 0 and " / " .. joined(f.den, of) or "") .. ")"
  end
  error("tour: a form that the page does not explain: " .. f.kind)
end

-- Forms of a program {defs, outs}; every symbol that is not defined is an input.
local function forms(name, list)
  local defined, inputs, seen = {}, {}, {}
  for _, g in ipairs(list) do
    for _, d in ipairs(g.defs) do defined[d.name] = true end
    for _, x in ipairs { g.defs, g.outs } do
      for _, d in ipairs(x) do
        for _, s in ipairs(expr.symbols(d.expr)) do
          if not seen[s.name] then inputs[#inputs + 1] = s.name end
          seen[s.name] = true
        end
      end
    end
  end
  local p = { name = name, inputs = {}, groups = {} }
  for _, s in ipairs(inputs) do
    if not defined[s] then p.inputs[#p.inputs + 1] = { sym = s, c = s } end
  end
  for i, g in ipairs(list) do
    p.groups[i] = { defs = g.defs, outs = {} }
    for k, o in ipairs(g.outs) do
      p.groups[i].outs[k] = { c = o.array and o.array .. "[" .. o.state .. "]" or o.state, expr = o.expr }
    end
  end
  local rows = {}
  for _, root in ipairs(lower.terms(p)) do rows[#rows + 1] = { root.name or root.c, "= " .. term(root.term) } end
  return columns(rows)
end

-- ---- what the program prints and writes ----

local function printed(binary, dir, options)
  local pipe = assert(io.popen(string.format("cd '%s' && '%s' gen brick.lua %s", dir, binary, options)))
  local out = pipe:read "a"
  assert(pipe:close(), "tour: the program refused its scene")
  return out
end

local function body_of(source, head)
  local from = assert(string.find(source, head, 1, true), head)
  return string.sub(source, from, (select(2, string.find(source, "\n}\n", from, true))))
end

-- ---- the blocks ----

-- The blocks made from the scene's text: name -> text.
function tour.blocks(binary, source)
  local dir = program.directory()
  program.write(dir .. "/brick.lua", source)
  local read = assert(scene.read(source, { file = "brick.lua" }))
  local made = { record = record(read.record), equations = groups(read.equations.groups),
    closed = refusals(read.closed) }
  local plan = assert(scene.plan(read, { only = { "rhs" } }))
  made.model = model(plan.model)
  local rhs = scene.description(plan, "rhs")
  made.description = rhs.name .. "(" .. table.concat(rhs.args, ", ") .. ")\n" .. groups(rhs.groups)
  local constants = {}
  for i, c in ipairs(plan.model.members) do constants[i] = { name = c.name, expr = c.e } end
  local outs = {}
  for i, c in ipairs(constants) do outs[i] = { state = c.name, expr = c.expr } end
  made.forms = forms("init", { { defs = {}, outs = outs } }) .. "\n" .. forms("rhs", rhs.groups)
  made.lower = printed(binary, dir, "--only rhs --show lower")
  made.order = printed(binary, dir, "--only rhs --show order")
  printed(binary, dir, "--only rhs -o out >/dev/null")
  made.statements = body_of(program.read(dir .. "/out/brick.c"), "void brick_rhs")
  local list = io.popen("cd '" .. dir .. "/out' && LC_ALL=C ls")
  made.files = list:read "a"
  list:close()
  program.finish()
  return made
end

-- The text between a block's marks, fences taken off; nil if the page has no such block.
local function marks(page, name)
  local a, b = "<!-- tour: " .. name .. " -->\n", "<!-- end of " .. name .. " -->"
  local _, from = string.find(page, a, 1, true)
  local to = from and string.find(page, b, from, true)
  return from, to
end

function tour.block(page, name)
  local from, to = marks(page, name)
  return to and string.match(string.sub(page, from + 1, to - 1), "^```%a*\n(.*)```\n$")
end

function tour.fill(page, made)
  for name, block in pairs(made) do -- each into its own place
    local from, to = marks(page, name)
    assert(to, "the page has no block " .. name)
    page = string.sub(page, 1, from) .. "```text\n" .. block .. "```\n" .. string.sub(page, to)
  end
  return page
end

if arg and string.find(arg[0] or "", "docs/tools/tour%.lua$") then
  local root = io.popen("pwd"):read "l"
  local binary, path = arg[1], assert(arg[2], "usage: tour.lua PROGRAM PAGE")
  if string.sub(binary, 1, 1) ~= "/" then binary = root .. "/" .. binary end
  local page = assert(program.read(path))
  program.write(path, tour.fill(page, tour.blocks(binary, tour.block(page, "scene"))))
end

return tour
