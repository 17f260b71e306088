-- view.lua -- polhode view: a scene as one HTML file that runs the emitted C, compiled to WebAssembly.
--
-- The C is that of `polhode gen --libm own`, without any import; templates/page/glue.c exports it.  It is compiled by
-- clang at -O2 without contraction, so the page has the bits of a native program.  Never -msimd128: clang 14 makes
-- wrong code with it.
-- SPDX-License-Identifier: GPL-3.0-or-later

local facts = require "generator.commands.view.facts"
local panel = require "generator.report.handout.panel"
local report = require "generator.report.facts"
local driven = require "generator.commands.driven"
local options = require "generator.commands.options"
local recorded = require "generator.commands.view.recorded"
local solid = require "generator.commands.view.solid"
local run = require "generator.commands.run"
local bounce = require "generator.commands.run.bounce"
local driver = require "generator.driver"
local happenings = require "generator.dynamics.happenings"
local methods = require "generator.methods.methods"
local gltf = require "generator.page.gltf"
local page = require "generator.page.page"
local times = require "generator.plot.times"

local view = {}

view.forms = { { "SCENE", "a page that runs the emitted code (HTML)",
  "One file that needs no network: the body in space, sliders, plots, and what accuracy costs. It is made by clang " ..
    "and wasm-ld (Debian packages clang and lld). With --trajectory it plays a computed motion, and needs neither." } }
view.operands = { 1, 1, "SCENE" }
view.options = {
  { "--method", "words", "the methods that the page can choose from, beside the closed form", value = "M,...",
    default = "all that the scene takes of rk4, adaptive, midpoint, semi, split2, split4" },
  { "--trajectory", false, "a page that plays one motion; the general library computes it by one --method of run" },
  { "--format", { "html", "glb" }, "glb: binary glTF 2.0, for Blender and others, of the motion that " ..
    "--trajectory plays", default = "html" },
  { "--real", { "double", "float" }, "the type of all numbers", default = "double" },
  { "--set", "pair", "another value for a parameter of the scene, in the unit that the scene gives it" },
  options.row(run, "--input"), options.row(run, "--between"),
  { "-o", "text", "the file that is written; - is standard output", value = "FILE.html|.glb",
    default = "NAME.html, NAME.glb" },
}
view.examples = {
  { "polhode view tennis_racket", "tennis_racket.html: open it in a browser" },
  { "polhode view heavy_top --trajectory -o top.html", "without clang: a page that plays a computed motion" },
  { "polhode view attitude_control --trajectory --input torques.csv", "the motion under inputs over time" },
  { "polhode view thrown_book --format glb", "thrown_book.glb: an animation for Blender" },
  { "polhode view heavy_top --real float --method rk4,taylor -o top.html", "two methods in float" },
}

local FLAGS = { "--target=wasm32", "-O2", "-std=c99", "-ffp-contract=off", "-fno-math-errno", "-ffreestanding",
  "-nostdlib", "-fvisibility=hidden", "-Wl,--no-entry", "-Wl,--strip-all", "-Wl,--stack-first",
  "-Wl,-z,stack-size=65536" }

local WITHOUT = "--trajectory makes a page that plays a computed motion without it"

-- Methods whose steps the scene takes; each is asked alone, for one that is not possible is an error of a plan.
local usual = { "rk4", "adaptive", "midpoint", "semi", "split2", "split4" }

-- bare: without the closed form.
local function plan_with(scene, given, list, bare)
  local names = scene.closed.full and not bare and { "exact" } or {}
  for _, name in ipairs(list) do names[#names + 1] = name end
  return driver.plan(scene, { real = given.real, methods = names, libm = "own", command = "polhode view" })
end

-- The methods of a page for all of the scenes: those that are asked for, or the usual ones that each takes.
local function chosen(scenes, given)
  if given.method then return given.method end
  local list = {}
  for _, name in ipairs(usual) do
    local taken = true
    for _, scene in ipairs(name == "rk4" and {} or scenes) do taken = taken and plan_with(scene, given, { name }) end
    if taken then list[#list + 1] = name end
  end
  return list
end

-- What is wrong with the names of --method, or nil.
local function unknown(given)
  local names = {}
  for i, m in ipairs(methods) do names[i] = m.name end
  local seen = {}
  if given.trajectory and #(given.method or {}) > 1 then
    return "--trajectory plays one motion: --method must be one method, got " .. table.concat(given.method, ",")
  end
  if given.trajectory and given.real then
    return "--real: it is the type of the emitted code, which --trajectory leaves out"
  end
  for _, name in ipairs(given.trajectory and {} or { "input", "between" }) do
    if given[name] then
      return "--" .. name .. ": it belongs to --trajectory; a page that runs the code has sliders for inputs"
    end
  end
  if given.trajectory then return nil end
  for _, name in ipairs(given.method or {}) do
    if name == "exact" then return "--method exact: the closed form is always there, where the scene has one" end
    if not methods.by_name[name] then return options.unknown("--method", { name }, names) end
    if seen[name] then return "--method: " .. name .. " stands there twice" end
    seen[name] = true
  end
  return nil
end

-- The wasm of a plan, or nil and why there is none.
local function compiled(host, unit)
  local dir, why = host.tempdir()
  local ok = dir
  if dir then ok, why = host.write_files(dir, unit.files) end
  if not ok then return nil, why end
  local name = unit.model.name
  local made, said = host.compile(dir, { "page.c", name .. ".c" }, "page.wasm", { cc = "clang", flags = FLAGS })
  if made then return host.read(dir .. "/page.wasm") end
  if string.find(said, "^cannot run") then return nil, "needs the program clang (Debian package clang); " .. WITHOUT end
  if string.find(said, 'execute command: Executable "wasm-ld', 1, true) then
    return nil, "needs the program wasm-ld (Debian package lld); " .. WITHOUT
  end
  return nil, "the page's code does not compile:\n" .. said
end

-- Writes a page: its plan, its facts, and the code that it runs or nil; ground: of a body that flies and lands that on
-- the plane.
local function written(host, plan, given, known, wasm, ground)
  local html = page.html(host.templates, host.sha256, { facts = known, shape = solid.of(plan), code = wasm,
    ground = ground, formulas = panel.html(report.of(plan)) })
  return options.write(host, "view", given.o or plan.model.name .. ".html", html)
end

-- The motion as binary glTF: of the body's places those that the scene has, in space or on a plane, while it touches.
local function animation(host, scene, given, inputs)
  local rows, failure, ended = recorded.rows(host, scene, given, inputs)
  if not rows then return run.refuse(host, failure, nil, "view") end
  if ended then
    host.err("warning: " .. happenings.at(ended, times.number(rows[#rows][1])) .. "; the file ends there\n")
  end
  local o = { name = scene.model.name, version = "polhode " .. scene.build,
    shape = solid.corners(given.ground or scene), times = {},
    attitude = {} }
  local at, plane = { attitude = {}, position = {} }, #rows[1] > #scene.states + 5 and #scene.states + 6
  for i, s in ipairs(scene.states) do
    if at[s.kind] then table.insert(at[s.kind], i + 1) end
  end
  if plane then at.position = { plane + 1, plane + 2, plane + 3 } end
  if #at.position > 0 then o.place = {} end
  local function picked(row, list)
    local out = {}
    for k, i in ipairs(list) do out[k] = row[i] end
    return out
  end
  for i, row in ipairs(rows) do
    if plane and row[plane] <= 0 and not given.ground then
      host.err("warning: contact is lost before t = " .. times.number(row[1]) .. " s: the file ends there\n")
      break
    end
    o.times[i], o.attitude[i] = row[1], picked(row, at.attitude)
    if o.place then o.place[i] = picked(row, at.position) end
  end
  if #o.times < 2 then return options.failed(host, "view", "the plane does not carry the body at the start") end
  return options.write(host, "view", given.o or scene.model.name .. ".glb", gltf.binary(o))
end

-- scene: of a body that flies and lands that in the air; its shape is the same in both.
local function played(host, scene, given)
  local said, inputs = driven.one(host, scene, given)
  if not said then return options.wrong(host, "view", inputs) end
  for _, w in ipairs(said) do host.err("warning: " .. w) end
  if given.format == "glb" then return animation(host, scene, given, inputs) end
  local motion, failure = recorded.of(host, scene, given, inputs)
  if not motion then return run.refuse(host, failure, nil, "view") end
  local known = facts.of(scene)
  known.recorded, known.horizon = motion, motion.finish
  local plan, d = driver.plan(given.ground or scene, { command = "polhode view" })
  if not plan then return options.refuse(host, d) end
  return written(host, plan, given, known, nil)
end

-- Plan, unit and WebAssembly of a scene; or nil and the exit status.
local function built(host, scene, given, list, bare)
  local plan, d = plan_with(scene, given, list, bare)
  if not plan then return nil, options.refuse(host, d) end
  local unit = driver.files(plan, { plugin = { page = true } })
  if not unit then return nil, options.refuse(host, plan.diag) end
  local wasm, why = compiled(host, unit)
  if not wasm then return nil, options.failed(host, "view", why) end
  return { plan = plan, unit = unit, wasm = wasm }
end

-- flight: of a body that flies and lands the scene in the air, scene then being that on the plane.
local function live(host, scene, given, flight)
  local list = chosen({ scene, flight }, given)
  local own, status = built(host, scene, given, list)
  if not own then return status end
  if not flight then return written(host, own.plan, given, facts.compiled(scene, own.plan, own.unit), own.wasm) end
  local air, wrong = built(host, flight, given, list, true)
  if not air then return wrong end
  local known = facts.phases(facts.compiled(flight, air.plan, air.unit),
    facts.compiled(scene, own.plan, own.unit), scene)
  return written(host, own.plan, given, known, air.wasm, own.wasm)
end

-- Why a motion cannot be shown in space and what can be done, or nil.  name: the scene as the command line has it.
local function shapeless(model, name)
  if not model.has.rates then
    return "a page shows how a body turns, and this body is a point: nothing turns it, and initial gives neither " ..
      "omega nor attitude. Its path: polhode plot " .. name .. " --what path"
  elseif not model.has.attitude then
    return "a page shows how a body turns, and outputs does not ask for its attitude: add \"attitude\" there. " ..
      "The rates alone: polhode plot " .. name .. " --what rates"
  end
  return nil
end

function view.run(host, given)
  if given.format == "glb" then given.trajectory = true end
  local wrong = unknown(given)
  local ending = given.format or "html"
  if given.o and given.o ~= "-" and not string.find(given.o, "[^/]%." .. ending .. "$") then
    wrong = wrong or "-o must end in ." .. ending .. ", or be -, got " .. given.o
  end
  if wrong then return options.wrong(host, "view", wrong) end
  given.follows = true
  local scene, d, why = driver.read(host, given[1], given)
  if not scene then return options.refuse(host, d, why) end
  why = shapeless(scene.model, given[1])
  if why then return options.failed(host, "view", why) end
  options.warn(host, scene.diag)
  options.unasked(host, scene, "the page does not ask")
  local flight
  if scene.record.flies then flight, d, why = bounce.scene(scene, given) end
  if scene.record.flies and not flight then return options.refuse(host, d, why) end
  if given.trajectory then return played(host, flight or scene, given) end
  return live(host, scene, given, flight)
end

return view
