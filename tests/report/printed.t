#!/usr/bin/env lua5.4
-- printed.t - every formula that is printed of a scene is read back, and has the value that the library gives it.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Of all installed bodies and of scenes made at random: `explain` as text and JSON, `explain --diff`, and the comments
-- of the emitted code.  tests/algebra/reader.lua computes from the text alone, line after line, as a person would with
-- a calculator; the rates, the mass and the tensors to compare with are the general library's, from the shapes, at the
-- parameters' defaults and at others.  Constants are compared with what NAME_init computes, of the installed bodies.
-- POLHODE_SCENES=300 POLHODE_SEED=7: so many random scenes from that seed.  The quick tier takes every eighth body and
-- a few random scenes.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local json = require "tests.json"
local scene = require "tests.scene"
local program = require "tests.cli.program"
local worker = require "tests.cli.worker"
local made = require "tests.report.printed_init"
local reader = require "tests.algebra.reader"
local scenes = require "tests.effects.scenes"
local driver = require "generator.driver"
local difference = require "generator.report.difference"
local explain = require "generator.report.explain"

local dir = program.directory()

-- A lost sign moves a rate by a term of its own size.  Doubles lose a few hundred roundings on the way, and what
-- cancels in a printed constant, or in a formula that is printed otherwise than computed, is here less than 1e4.
local NEAR = 1e-10

local faults, counts = {}, {}
local function fault(s, what, detail)
  faults[what] = faults[what] or {}
  table.insert(faults[what], s.file .. ": " .. detail)
end

-- Is got the wanted number, to NEAR of size?  Counted under `what`.
local function compare(s, what, where, got, want, size)
  counts[what] = (counts[what] or 0) + 1
  local near = math.abs(got - want) <= NEAR * math.max(size, math.abs(want)) -- false for what is no number
  if not near then
    fault(s, what, string.format("%s is %.17g, not %.17g", where, got, want))
  end
end

-- The value of a formula; nil, and a fault, where it cannot be read.  "..." stands for what is too long to print.
local function value(s, what, formula, env)
  if formula == "..." then
    counts["too long to print"] = (counts["too long to print"] or 0) + 1
    return nil
  end
  local fine, x = pcall(reader.value, formula, env)
  if not fine then fault(s, what, tostring(x)) end
  return fine and x or nil
end

-- The names of a point's numbers.
local function names(s, p)
  local env = { t = p.t }
  for k, v in pairs(p.values) do env[k] = v end -- a map to a map: order is lost anyway
  for i, name in ipairs(s.states) do env[name] = p.x[i] end
  for i, name in ipairs(s.inputs) do env[name] = p.u[i] end
  return env
end

-- ---- explain as text ----

local UNITS = { "kg m^2/s^2", "kg m^2", "kg m", "kg", "m^2", "m", "1" }

-- "name = formula = number unit": the parts that are there.  A parameter is its own formula, which is not repeated.
local function parts(line, params)
  local name, rest = string.match(line, "^%s*([%a_][%w_/ ()^]*) = (.*)$")
  if not name or line:find ", axis %(" then return nil end
  local sides = {}
  for side in string.gmatch(rest .. " = ", "(.-) = ") do sides[#sides + 1] = side end
  for _, unit in ipairs(UNITS) do
    local short = string.match(sides[#sides], "^(.*) " .. unit:gsub("%^", "%%^") .. "$")
    if short then
      sides[#sides] = short
      break
    end
  end
  local number = tonumber(sides[#sides])
  if #sides == 1 and number and params and params[name] then return name, name end -- M = 2.0 kg: the parameter itself
  return name, sides[1], #sides > 1 and number or nil
end

local function sections(text)
  local list, own = {}, nil
  for line in text:gmatch "[^\n]*" do
    if line:find "^%S" then
      own = {}
      list[line] = own
    elseif line ~= "" and own then
      own[#own + 1] = line
    end
  end
  return list
end

local entry = { Ixx = 1, Iyy = 2, Izz = 3, Ixy = 4, Ixz = 5, Iyz = 6 }

-- The sections on the body, at a point.
local function body(s, list, p, default)
  local what, env = "body: text", names(s, p)
  local size = math.max(p.moments[3], 1e-300)
  local function each(title, see)
    for _, line in ipairs(list[title] or {}) do
      for zero in (line:match "^  (I[xyz]+ = .*) = 0$" or line:match "^  (I[xyz]+) = 0$" or ""):gmatch "%w+" do
        see(zero, 0, line)
        env[zero] = env[zero] or 0
      end
      local name, formula, number = parts(line, p.values)
      if line:find " = 0$" or line:find "%(Huygens" or name == formula then name = nil end
      local x = name and value(s, what, formula, env)
      if x then
        if default and number then compare(s, "the number beside it", line, x, number, 0) end
        see(name, x, line)
        if line:find "^  %S" and not env[name] then env[name] = x end -- deeper: of one piece
      end
    end
  end
  local reach = math.sqrt(size / p.mass)
  each("Pieces", function() end)
  local known = list.Body[#list.Body]:find "is the origin" and {} or p.com
  each("Body", function(name, x, line)
    local k = string.find("xyz", name:match "^R([xyz])$" or " ")
    if name == "M" then compare(s, what, line, x, p.mass, 0) end
    if k then compare(s, what, line, x, known[k], reach) end
  end)
  each("Tensor of inertia about the origin of rotation", function(name, x, line)
    compare(s, what, line, x, p.inertia[entry[name]], size)
  end)
  local about = {} -- named entries are those of the origin here
  for k, v in pairs(env) do about[k] = v end -- a map to a map: order is lost anyway
  each("Tensor of inertia about the centre of mass", function(name, x, line)
    compare(s, what, line, x, p.centroidal[entry[name]], size)
    env[name] = about[name]
  end)
  each("Principal moments and axes", function(name, x, line)
    if not name:find "^I ?%(?" or name:find "%d$" then return end
    local best = math.huge
    for k = 1, 3 do best = math.min(best, math.abs(x - p.moments[k])) end
    compare(s, what, line, best, 0, size)
    env[name] = nil
  end)
  return env
end

-- The equations in lines "name = formula", at a point: rates as the library's.  env: parameters, states and what the
-- sections before have named.
local function equations(s, what, lines, p, env, see)
  local met = 0
  for _, line in ipairs(lines) do
    local name, formula, number = parts(line)
    local state = name and name:match "^d([%w_]+)/dt$"
    local plain = name and name:find "^[%a_][%w_]*$"
    local x = (state or plain) and not line:find "^  %S.*[:,]" and value(s, what, formula, env)
    if x and state then
      for i, n in ipairs(s.states) do
        if n == state then
          compare(s, what, line, x, p.rates[i], p.scale[i])
          met = met + 1
        end
      end
    elseif x then
      if see then see(name, x, number, line) end
      env[name] = x
    end
  end
  if met ~= #s.states then fault(s, what, met .. " of " .. #s.states .. " rates were read") end
end

local function text(s)
  local list = sections(s.text)
  for n, p in ipairs(s.points) do
    local env = body(s, list, p, n == 1)
    equations(s, "equations: text", list["Equations of motion"], p, env, function(name, x, number, line)
      if n == 1 and number then compare(s, "the number beside it", line, x, number, 0) end
      local computed = s.made and s.made[n] and s.made[n][name]
      if computed then compare(s, "constants: what NAME_init computes", line, x, computed, 0) end
    end)
  end
end

-- ---- JSON, differences ----

local function symbolic(s)
  local j = json.read(s.json)
  for n, p in ipairs(s.points) do
    local what, env = "body: JSON", names(s, p)
    compare(s, what, j.mass_symbolic, value(s, what, j.mass_symbolic, env) or 0 / 0, p.mass, 0)
    for k = 1, n == 1 and 3 or 0 do -- the library's own place is told from the origin
      local x = value(s, what, j.com_symbolic[k], env)
      if x then compare(s, what, j.com_symbolic[k], x, p.com[k] + j.origin[k], math.sqrt(p.moments[3] / p.mass)) end
    end
    for _, which in ipairs { "inertia", "centroidal" } do
      for name, formula in pairs(j[which].symbolic) do -- any order
        local x = value(s, what, formula, env)
        if x then compare(s, what, which .. ": " .. formula, x, p[which][entry["I" .. name]], p.moments[3]) end
      end
    end
  end
end

-- The difference to a scene that has no formula in common with it.
local function differences(s)
  local j = json.read(s.diff)
  for n, p in ipairs(s.points) do
    local what, env = "equations: --diff", names(s, p)
    setmetatable(env, { __index = body(s, sections(s.text), p, false) }) -- steps of the body are not repeated
    for _, c in ipairs(j.constants) do
      local formula, number = string.match(c.a == json.null and "" or c.a, "^(.*) = (.-)$")
      local x = formula and value(s, what, formula, env)
      if x then
        env[c.what] = x
        if n == 1 then compare(s, "the number beside it", c.what .. " = " .. c.a, x, tonumber(number), 0) end
      end
    end
    local lines = {}
    for _, c in ipairs(j.equations) do
      for line in (c.a == json.null and "" or c.a):gmatch "[^\n]+" do lines[#lines + 1] = "    " .. line end
    end
    local by_state, long = {}, {}
    for _, c in ipairs(j.terms) do
      local state, term = string.match(c.what, "^d([%w_]+)/dt: (.*)$")
      term = term:gsub(" %(%d+%)$", "")
      if c.a ~= json.null then
        local x = value(s, "terms: --diff", term, env)
        by_state[state], long[state] = (by_state[state] or 0) + (x or 0), long[state] or not x
      end
    end
    for i, name in ipairs(s.states) do
      if not long[name] then
        compare(s, "terms: --diff", "the sum of the terms of " .. name, by_state[name] or 0, p.rates[i], p.scale[i])
      end
    end
    equations(s, what, lines, p, env)
  end
end

-- ---- comments of the emitted code ----

local function comments(s)
  local header = s.files[s.name .. ".h"]
  local readme = s.files["README.md"]
  for n, p in ipairs(s.points) do
    for what, t in pairs { ["banner of the header"] = header, ["README.md"] = readme } do -- any order
      local env, lines, inside = names(s, p), {}, false
      for line in t:gmatch "[^\n]+" do
        local rest = line:match "^ %* (    .*)$" or t == readme and line:match "^(    .*)$"
        inside = inside and rest ~= nil or line:find "^ %* Tensor of inertia" or line:find "^Tensor of inertia"
        if inside and rest then
          if rest:find "^        %S" then
            lines[#lines] = lines[#lines] .. " " .. rest:match "^%s*(.*)$"
          else
            lines[#lines + 1] = rest
          end
        end
      end
      for _, line in ipairs(lines) do
        local name, formula = line:match "^%s*([%a_][%w_]*) = (.*)$"
        formula = formula and formula:gsub("  %(.*%)$", "")
        local x = name and not formula:find "=" and value(s, what, formula, env)
        if x then
          if entry[name] then compare(s, what, line, x, p.inertia[entry[name]], p.moments[3]) end
          env[name] = x
        end
      end
    end
    for name, about in header:gmatch "_real ([%w_]+); /%* (.-) %*/" do
      local formula = about:match ": (.*)$"
      local computed = s.made[n] and s.made[n][name]
      local x = formula and computed and value(s, "comments of constants", formula, names(s, p))
      if x then compare(s, "comments of constants", name .. ": " .. formula, x, computed, 0) end
    end
  end
end

-- ---- scenes ----

local BATCH = 20 -- scenes for which the program is started once

local function numbers(list)
  local n = 0
  for first = 1, #list, BATCH do
    local paths = {}
    for i = first, math.min(first + BATCH - 1, #list) do paths[#paths + 1] = list[i].file end
    n = first - 1
    for line in (worker("tests/report/printed_worker.lua", paths) or ""):gmatch "[^\n]+" do
      n = n + 1
      list[n].points = load("return " .. line, "numbers", "t", {})()
    end
  end
  tap.is(n, #list, "the library reads " .. #list .. " scenes")
end

local base = scene.plan(scene.read [[return scene { name = "base", body = tensor { mass = 1, xx = 2, yy = 3, zz = 4 },
  effects = { effect.damping { rate = quantity(0.1, "1/s") } }, initial = { omega = {1, 2, 3} },
  outputs = { "rates" } }]])

-- What is printed of a scene; whole: the emitted files, too.
local function printed(s, whole)
  local job = scene.file(s.file)
  local plan = scene.plan(job, whole and {} or { only = { "rhs" } })
  s.name, s.states, s.inputs, s.params = job.model.name, {}, {}, {}
  for i, x in ipairs(job.states) do s.states[i] = x.name end
  for i, x in ipairs(job.model.inputs) do s.inputs[i] = x.name end
  for i, x in ipairs(job.model.params) do s.params[i] = x.name end
  local unit = driver.code(plan)
  s.text = explain.text(unit, "text")
  s.json = (whole or s.full) and explain.text(unit, "json")
  s.diff = difference.text(plan, base, "json")
  if whole then s.files = scene.files(plan) end
end

local function judge(s, whole)
  if not tap.ok(s.points, s.file:match "[^/]*$" .. ": the library has numbers of it") then return end
  printed(s, whole)
  if whole then tap.ok(made(s), s.name .. ": its NAME_init computes the constants") end
  text(s)
  if s.json then symbolic(s) end
  differences(s)
  if whole then comments(s) end
end

local bodies, random = {}, {}
do
  local pipe = assert(io.popen "ls bodies/*.lua")
  for path in pipe:lines() do bodies[#bodies + 1] = { file = path } end
  pipe:close()
end
bodies = tier.every(8, bodies)
local count = tonumber(os.getenv "POLHODE_SCENES") or tier.quick and 6 or 60
local seed = tonumber(os.getenv "POLHODE_SEED") or 1758
local draw = scenes.new(seed, 0)
while #random < count do
  local chosen = {}
  for i = 1, draw:random(3) do chosen[i] = scenes.draw(draw) end
  if select(2, scenes.fits(chosen)) then
    local name = "printed_" .. #random + 1
    local path, kind = dir .. "/" .. name .. ".lua", ({ "diagonal", "symmetric", "axial", "full" })[draw:random(4)]
    program.write(path, scenes.text(scenes.new(seed + 7919 * #random, 0.5), name, kind, chosen))
    random[#random + 1] = { file = path, full = #random % 10 == 0 }
  end
end

numbers(bodies)
numbers(random)
for _, s in ipairs(bodies) do judge(s, true) end
for _, s in ipairs(random) do judge(s, false) end
for what, least in pairs { ["body: text"] = 10, ["body: JSON"] = 10, ["equations: text"] = 10,
  ["equations: --diff"] = 10, ["terms: --diff"] = 10, ["the number beside it"] = 10,
  ["constants: what NAME_init computes"] = 10, ["banner of the header"] = 10, ["README.md"] = 10,
  ["comments of constants"] = 1 } do -- any order
  local n = counts[what] or 0
  tap.ok(n >= least and not faults[what], string.format("%s: %d formulas have their values", what, n),
    table.concat(faults[what] or {}, "\n", 1, math.min(12, #(faults[what] or {}))))
end
local long = counts["too long to print"] or 0
tap.ok(long < counts["equations: text"], long .. " were too long to print")

tap.done(program.finish())
