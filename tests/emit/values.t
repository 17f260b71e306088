#!/usr/bin/env lua5.4
-- values.t - the tables that templates are filled with: nothing is given that no template reads.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- An unknown name stops the rendering of a template; here is the other direction.  Names are read off the text of the
-- templates, in ${} and in lines of logic.  The values that each group is given are seen while scenes are emitted that
-- together use every group.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local base = require "generator.emit.base"
local libm = require "generator.emit.libm"
local packages = require "generator.emit.packages.packages"
local proof = require "generator.emit.proof"
local template = require "generator.emit.template"

require "generator.emit.calls"

local KEYWORDS = {}
for word in string.gmatch("and do else elseif end false for if in ipairs not or then true", "%a+") do
  KEYWORDS[word] = true
end

-- Adds the names of an expression or of a line of logic, but for fields of tables and what stands in strings.
local function put_names(text, set)
  text = string.gsub(text, '"[^"]*"', '""')
  for before, name in string.gmatch(" " .. text, "([^%w_])([%a_][%w_]*)") do
    if before ~= "." and not KEYWORDS[name] then set[name] = true end
  end
end

-- What a template reads, and the variables of its loops: two sets.
local function names_of(text)
  local read, own = {}, {}
  for line in string.gmatch(text, "([^\n]*)\n") do
    local logic = string.match(line, "^%s*%%%%(.*)$")
    if logic and not string.find(logic, "^%s*%-%-") then
      local variables, list = string.match(logic, "^%s*for (.-) in (.*)$")
      if variables then put_names(variables, own) end
      put_names(list or logic, read)
    elseif not logic then
      for expression in string.gmatch(line, "%${([^}]*)}") do put_names(expression, read) end
    end
  end
  for name in pairs(own) do read[name] = nil end
  return read, own
end

local reads, loops = {}, {}
for name in io.popen("find templates -type f | LC_ALL=C sort"):lines() do
  local short = string.match(name, "^templates/(.*)$")
  reads[short], loops[short] = names_of(scene.slurp(name))
end

-- ---- what is given while scenes are emitted ----

local given = {} -- group -> set of names
template.watch = function(group, values)
  given[group] = given[group] or {}
  for name in pairs(values) do given[group][name] = true end
end

local plain_base
local function emit(body, options, project)
  options.package = packages.by_name(project or packages.default)
  local plan = scene.plan(scene.file("bodies/" .. body .. ".lua"), options)
  if not tap.ok(plan ~= nil, body .. " is planned") then return end
  scene.files(plan, options.plugin)
  plain_base = plain_base or base.of(plan, false)
end

emit("brick_centroid", { analysis = true, jacobians = true, plugin = { peers = true },
  methods = { "exact", "rk4", "taylor", "adaptive", "midpoint" } })
emit("heavy_top", { analysis = true, attitude = true, estimator = true, methods = { "taylor", "exact" } })
emit("rolling_coin", { analysis = true, methods = { "rk4" } })
emit("gyrostat", { methods = { "exact", "split2" }, real = "float", batch = true })
emit("brick_centroid", { methods = { "taylor" }, batch = true })
emit("attitude_control", { methods = { "taylor" }, real = "float", batch = true })
emit("attitude_control", { methods = { "rk4" }, jacobians = true, real = "float" }, "firmware")
emit("thruster", { methods = { "taylor", "adaptive" }, jacobians = true, compensated = true }, "fmu")
emit("egg", { methods = { "rosenbrock" } })
emit("thruster", { methods = { "rosenbrock" }, real = "float" })
emit("attitude_control", { methods = { "rk4" } }, "python")
for _, project in ipairs { "cmake", "arduino", "platformio", "zephyr" } do
  emit("dropped_stone", { methods = { "rk4" } }, project)
end

local wx, factor = motion.sym "wx", expr.one
emit("magnet_pendulum", { methods = { "rk4" }, batch = true, command = "", sweep = { members = 2, samples = 1, seed = 1,
  values = { { kind = "param", name = "pull", unit = "N m", about = "pull", factor = factor,
    over = { low = 0.1, high = 0.2, count = 2 } }, { kind = "state", name = "wx", unit = "rad/s", about = "wx",
    factor = factor, draw = { kind = "normal", a = 0.0, b = 1.0, dimension = 0 } } },
  keeps = { { kind = "state" }, { kind = "states" }, { kind = "drift", name = "drift", unit = "J", about = "drift" },
    { kind = "first", name = "f", e = wx, unit = "s", about = "f" },
    { kind = "max", name = "m", e = wx, unit = "rad/s", about = "m" },
    { kind = "final", name = "e", e = wx, unit = "rad/s", about = "e" } },
  times = { 0.0, 1.0 }, stretches = { { t0 = 0.0, t1 = 0.0, h = 0.0, steps = 0, time = 1 },
    { t0 = 0.0, t1 = 1.0, h = 0.01, steps = 100, time = 2 } }, accuracy = 1e-6, order = 4, step = "step" } }, "sweep")

emit("heavy_top", { methods = { "rk4" }, command = "", only = { "init", "defaults", "initial" },
  fit = { free = {}, outputs = { { name = "gyro", columns = { "gyro" }, e = { wx } } } } }, "fit")

-- Scenes that bodies/ does not have: splittings of every kind, ranges, a free motion in another time, helpers.
local function own(what, text, options)
  local read, why = scene.read(text)
  if not tap.ok(read ~= nil, what .. " is a scene", why) then return end
  local plan = scene.plan(read, options)
  if not tap.ok(plan ~= nil, what .. " is planned") then return end
  if options.proof then tap.ok(proof.check(plan), what .. " can be proved") end
  scene.files(plan)
end
local WHOLE = 'return scene { name = "b", body = %s, effects = { %s }, initial = { omega = {0.5, 1, 2} }, %s ' ..
  'time = { horizon = 2, step = 0.01 } }'
own("a diagonal body", string.format(WHOLE, "tensor { mass = 2, xx = 2, yy = 3, zz = 4 }", "effect.control { max = 2 }",
  "ranges = { wx = {-5, 5}, wy = {-5, 5}, wz = {-9, 9} },"), { methods = { "rk4" }, proof = true, q31 = true,
  analysis = true })
own("the same, split", string.format(WHOLE, "tensor { mass = 2, xx = 2, yy = 3, zz = 4 }",
  "effect.torque { body = {1, 0, 0} }", ""), { methods = { "split4" } })
own("an oblique body", string.format(WHOLE, 'tensor { mass = 2, xx = exact("19/9"), yy = exact("22/9"), ' ..
  'zz = exact("22/9"), xy = exact("2/9"), xz = exact("2/9"), yz = exact("4/9") }', "", ""), { methods = { "split2",
  "exact" }, analysis = true })
own("a body with corners", string.format(WHOLE, "tensor { mass = 2, xx = 2, yy = 3, zz = 4 }",
  "effect.torque { body = { -1*sign(wx), 0.1*abs(wy), 0.2*min(wz, 1) } }", ""), { methods = { "adaptive", "taylor",
  "rosenbrock" } })
own("any body", string.format(WHOLE, "tensor { mass = 2, xx = 2, yy = 3, zz = 4, xy = 0.1, xz = 0.2, yz = 0.3 }", "",
  ""), { methods = { "split2", "taylor" }, analysis = true, libm = "own" })
local seven = { "1", "0", "0", "0", "1", "2", "3" }
own("a planned scene", string.format(WHOLE, "solid.sphere { r = 1, mass = 2 }", "", ""), { methods = { "rk4" },
  planned = { setting = "step", method = "rk4", title = "rk4", accuracy_text = "1e-6", value_text = "0.01",
    expected = seven, bounds = seven, report = {} } })

-- ---- each way ----

local function sorted(set)
  local list = {}
  for name in pairs(set) do list[#list + 1] = name end
  table.sort(list)
  return list
end

local grouped = {} -- template -> group
for _, group in ipairs(template.groups) do
  local read, idle, hidden = {}, {}, {}
  for _, name in ipairs(group.names) do
    if not tap.ok(reads[name] ~= nil, name .. " is a template") then return end
    tap.is(grouped[name], nil, name .. " belongs to one group")
    grouped[name] = group
    for word in pairs(reads[name]) do read[word] = true end
  end
  for _, name in ipairs(sorted(given[group] or {})) do
    if not read[name] then idle[#idle + 1] = name end
  end
  tap.is(table.concat(idle, " "), "", group.names[1] .. ": every value is read by a template of the group")
  for _, name in ipairs(group.names) do
    for _, word in ipairs(sorted(loops[name])) do
      if (given[group] or {})[word] or plain_base[word] ~= nil then hidden[#hidden + 1] = name .. ":" .. word end
    end
  end
  tap.is(table.concat(hidden, " "), "", group.names[1] .. ": no variable of a loop hides a value")
  if group.names[1] ~= "target/calls.c" then -- filled by tests/emit/calls.t
    tap.ok(given[group] ~= nil, group.names[1] .. ": a scene of this test fills the group")
  end
end

for _, name in ipairs(sorted(reads)) do
  if next(reads[name]) then tap.ok(grouped[name] ~= nil, name .. " belongs to a group") end
end

-- base.lua is for what several groups read; of libm it has all names.
local mathematics = libm.names({ name = "b", real = "double" }, false)
for _, name in ipairs(sorted(base.names(plain_base))) do
  local readers, count = {}, 0
  for file, words in pairs(reads) do
    local group = grouped[file]
    if words[name] and group and not readers[group] then
      readers[group], count = true, count + 1
    end
  end
  tap.ok(mathematics[name] or count > 1, name .. " of emit/base.lua is read by several groups", "by " .. count)
end

tap.done()
