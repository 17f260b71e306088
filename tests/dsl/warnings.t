#!/usr/bin/env lua5.4
-- warnings.t: what is possible and probably a slip is warned of, on its line, and what is not a slip is not.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Rows are {statements or body, what the warnings must be}: all of them, in the order of the program.  That no scene of
-- bodies/ has a warning is the test against false alarms; the rest of it is the quiet rows.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local program = require "tests.cli.program"

local BOX = 'solid.box { x = quantity(1, "m"), y = 2, z = 3, mass = 1 }'

-- LINE: MESSAGE of every warning.
local function said(text, options)
  local job, why = scene.read(text, options)
  if not job then return "refused: " .. why end
  local list = {}
  for i, w in ipairs(job.diag.warnings) do list[i] = w.line .. ": " .. w.message end
  return table.concat(list, "\n")
end

local function is(text, want, about, options)
  local list = {}
  for i, w in ipairs(want) do list[i] = w[1] .. ": " .. w[2] end
  tap.is(said(text, options), table.concat(list, "\n"), about or (want[1] and want[1][2] or "quiet: " .. text))
end

local function of(body, keys, before)
  return (before or "") .. "\nreturn scene { name = \"s\",\n  body = " .. body .. ",\n  " .. (keys or "") .. " }\n"
end

local function effects(list, keys) return of(BOX, "effects = { " .. list .. " }, " .. (keys or "")) end

-- ---- parameters ----

do
  is(of(BOX, nil, 'local u = input("u", "N m")'), { { 1, "input: u is used by no effect: it does nothing" } })
  is(of(BOX, "effects = { effect.torque { body = {u, 0, 0} } }", 'local u = input("u", "N m")'), {},
    "an input that acts")
  local unused = { 1, "param: TW is used nowhere: nothing in the scene depends on it" }
  is(of(BOX, nil, 'local TW = param("TW", 1, "N m")'), { unused }, "a parameter that is made")
  is(of(BOX, "ranges = { TW = {0, 1} }", 'local TW = param("TW", 1)'), { unused }, "a parameter that has only a range")
  is(of(BOX, "time = { horizon = 1 + TW - TW }", 'local TW = param("TW", 1, "s")'), { unused },
    "a parameter that cancels")
  is(of(BOX, nil, 'local TW = param("TW", 1, "N m") local e = effect.torque { body = {TW, 0, 0} }'), { unused },
    "a parameter of an effect that is not in the scene")
  is(of(BOX, nil, 'local TW = param("TW", 1, "N m")'), { unused }, "also when parameters become numbers",
    { bake = true })
  for _, case in ipairs { { "origin = {a, 0, 0}" }, { "time = { step = a }", "s" },
    { "initial = { omega = {0, a, 1} }", "rad/s" }, { "initial = { attitude = { axis = \"x\", angle = a } }", "rad" },
    { "events = { { name = \"e\", when = qx - a } }", "1" },
    { "effects = { effect.torque { body = {{{0, 0}, {1, a}}, 0, 0} } }", "N m" },
    { "effects = { effect.solar_pressure { sun = {1, 0, 0}, plates = { { area = a, normal = {1, 0, 0}, " ..
      "centre = {0, 1, 0} } } } }", "m^2" },
    { "effects = { effect.custom { params = { gain = a }, torque = function(s) return {s.gain, 0, 0} end } }",
      "N m" } } do
    is(of(BOX, case[1], 'local a = param("a", 0.5, "' .. (case[2] or "m") .. '")'), {}, "used: " .. case[1])
  end
end

-- ---- effects ----

local central = "does nothing: the origin is the centre of mass, about which %s exerts no torque (origin = ... is " ..
  "the fixed point about which the body turns%s)"
local weight = { 4, "effect.gravity: " .. central:format("the weight", "; effect.translation lets it fall") }
is(effects "effect.gravity {}", { weight })
is(effects("effect.gravity {}", "origin = {0, 0, 0}"), { weight }, "an origin that happens to be the centroid")
is(effects("effect.gravity {}", "origin = \"corner\""), {})
is(effects("effect.gravity { g = 0 }", "origin = \"corner\""), { { 4, "effect.gravity: does nothing: g is 0" } })
is(effects "effect.pivot { amplitude = 1, rate = 2 }",
  { { 4, "effect.pivot: " .. central:format("the support", "") } })
for _, case in ipairs { { "damping { c = 0 }", "c is 0" }, { "damping { c = {0, 0, 0} }", "c is 0" },
  { "damping { c = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}} }", "c is 0" }, { "damping { rate = 0 }", "rate is 0" },
  { "drag { c = 0 }", "c is 0" }, { "friction { torque = 0, smoothing = 1 }", "torque is 0" },
  { "torque { body = {0, 0, 0} }", "body is 0" }, { "torque { inertial = {0, 0, 0} }", "inertial is 0" },
  { "spring { stiffness = 0 }", "stiffness is 0" }, { "spring { stiffness = 0, axis = {1, 0, 0} }", "stiffness is 0" },
  { "magnetic { moment = {0, 0, 0}, field = {1, 0, 0} }", "moment is 0" },
  { "magnetic { moment = {1, 0, 0}, field = {0, 0, 0} }", "field is 0" },
  { "rotor { axis = {0, 0, 1}, momentum = 0 }", "momentum is 0" }, { "dissipation { k = 0 }", "k is 0" },
  { "rotating_frame { rate = {0, 0, 0} }", "rate is 0" }, { "inertia_rate {}", "no entry is given, or all are 0" },
  { "gravity_gradient { mu = 0, orbit = { radius = 7e6 } }", "mu is 0" },
  { "solar_pressure { flux = 0, sun = {1, 0, 0}, plates = { { area = 1, normal = {1, 0, 0}, centre = {0, 1, 0} } } }",
    "flux is 0" },
  { "custom { torque = function(s) return {0, s.w[1] - s.w[1], 0} end }", "all that it adds is 0" } } do
  is(effects("effect." .. case[1]), { { 4, "effect." .. case[1]:match "%a[%a_]*" .. ": does nothing: " .. case[2] } })
end
for _, case in ipairs { "dissipation { k = 1 }", "gravity_gradient { mu = 4e14, orbit = { radius = 7e6 } }" } do
  is(of('solid.sphere { r = quantity(1, "m"), mass = 1 }', "effects = { effect." .. case .. " }"),
    { { 4, "effect." .. case:match "%a[%a_]*" .. ": does nothing: the three moments of inertia are equal" } })
end
for _, quiet in ipairs { "effect.damping { c = 1 }", "effect.control {}", "effect.drag { c = 1 }",
  "effect.wheel { axis = {0, 0, 1}, inertia = 0.1, included = true }",
  "effect.translation { gravity = 0 }", "effect.torque { body = {0, 0, t} }" } do
  is(effects(quiet), {})
end
-- zero for a value of the parameter is not nothing: another value acts
for _, options in ipairs { {}, { bake = true }, { set = { c = "0" } }, { set = { c = "0" }, bake = true } } do
  is(of(BOX, "effects = { effect.damping { c = c } }", 'local c = param("c", ' .. (options.set and "1" or "0") ..
    ', "N m s")'), {}, "a parameter that is 0" .. (options.bake and ", baked" or "") .. (options.set and ", set" or ""),
    options)
end
is(effects "effect.control {},\n\n  effect.control { max = 1 }, effect.control {}",
  { { 6, "effect.control: takes the same input u as the one of line 4: u acts once for each" } })

-- ---- density and lengths ----

local function lighter(x)
  return "a density without a unit is in kg/m^3, and " .. x .. " is lighter than any common solid; in g/cm^3 it " ..
    "would be one: write quantity(" .. x .. ", \"g/cm^3\"), or quantity(" .. x .. ", \"kg/m^3\")"
end
is(of "solid.box {\n    x = 0.2, y = 0.1, z = 0.05,\n    density = 2.7 }", { { 5, "box: " .. lighter "2.7" } })
is(of "solid.sphere { r = 2, density = 7.85 }", { { 3, "sphere: " .. lighter "7.85" } })
is(of "solid.sphere { r = 0.02, density = 8 }", { { 3, "sphere: " .. lighter "8" } })
for _, quiet in ipairs { "density = 8", "density = 2700", "density = quantity(2.7, \"g/cm^3\")", "density = 22.6",
  "density = quantity(2.7, \"kg/m^3\")", "density = 0.05" } do
  is(of("solid.sphere { r = 1, " .. quiet .. " }"), {}) -- a whole number: a formula is tried
end
is(of("solid.sphere { r = 0.1, density = rho }", nil, 'local rho = param("rho", 2.7, "kg/m^3")'), {}, "a parameter")
is(of "plate.disc { r = 0.1, density = 2.7 }", {})

local function thin(x, guess, unit)
  return "numbers without a unit are in m and kg; its density is then " .. x .. " kg/m^3, which no solid has; " ..
    guess .. " (write quantity(number, \"" .. unit .. "\"))"
end
is(of "solid.box { x = 200, y = 100, z = 50, mass = 2.4 }",
  { { 3, "box: " .. thin("2.4e-06", "with its lengths in mm it would be 2400", "mm") } })
is(of "solid.box { x = 20, y = 10, z = 5, mass = 2.4 }",
  { { 3, "box: " .. thin("0.0024", "with its lengths in cm it would be 2400, or with its lengths in mm and its mass " ..
    "in g it would be 2400", "cm") } })
is(of 'solid.box { x = 20, y = 10, z = 5, mass = quantity(2.4, "kg") }',
  { { 3, "box: " .. thin("0.0024", "with its lengths in cm it would be 2400", "cm") } })
is(of "solid.box { x = 0.2, y = 0.1, z = 0.05, mass = 2400 }",
  { { 3, "box: " .. thin("2400000", "with its mass in g it would be 2400", "g") } })
is(of "solid.box { x = 200, y = 100, z = 50, mass = 2.4 }:at{1, 0, 0} + points{{1, 1, 2, 3}}",
  { { 3, "box: " .. thin("2.4e-06", "with its lengths in mm it would be 2400", "mm") } })
for _, quiet in ipairs {
  "solid.sphere { r = 6.371e6, mass = 5.97e24 }", "solid.sphere { r = 265, mass = 7.3e10 }", -- the Earth; Bennu
  "solid.sphere { r = 8.4e-16, mass = 1.67e-27 }", "solid.sphere { r = 1.2e4, mass = 2.8e30 }", -- proton; neutron star
  "solid.box { x = 200, y = 100, z = 50, mass = 2.4 }:scaled(0.001)", "solid.box { x = 3, y = 4, z = 5, mass = 1 }",
  'solid.box { x = quantity(200, "m"), y = 100, z = 50, mass = 2.4 }', "plate.rectangle { x = 200, y = 100, mass = 1 }",
  "solid.box { x = 1, y = 2, z = 3, density = 2000 } - solid.box { x = 0.1, y = 0.1, z = 0.1, density = 2000 }" } do
  is(of(quiet), {})
end

-- ---- where warnings are shown ----

do
  local dir = program.directory()
  local s = of(BOX, "effects = { effect.gravity {} }, time = { horizon = 0.01 }")
  program.write(dir .. "/s.lua", s)
  local want = "warning: " .. dir .. "/s.lua:4: " .. weight[2] ..
    "\n    effects = { effect.gravity {} }, time = { horizon = 0.01 } }\n"
  for _, command in ipairs { "explain", "explain --format json", "explain --format urdf", "run",
    "gen -o " .. dir .. "/out", "check --states 1 --real double", "chart --linearised" } do
    program.shell("build/polhode " .. command .. " " .. dir .. "/s.lua >" .. dir .. "/out.txt 2>" .. dir .. "/err.txt")
    tap.is(program.read(dir .. "/err.txt"):sub(1, #want), want, "polhode " .. command .. " shows it, once")
    if command:find "json" then
      local json = program.read(dir .. "/out.txt")
      tap.ok(json:find("\"warnings\": [\n    \"" .. dir .. "/s.lua:4: " .. weight[2], 1, true), "and it is in the JSON")
    end
  end
end

-- ---- no false alarm; and no table takes a key that nothing reads ----

-- An unknown key in every table of the scenes, one at a time: refused, but where the scene names the keys.
local own = { params = true, outputs = true }
local tables, taken = 0, {}
for path in assert(io.popen "ls bodies/*.lua"):lines() do
  local text = scene.slurp(path)
  is(text, {}, path .. ": nothing to warn of", { file = path })
  for at in text:gmatch "(){" do
    local line = text:sub(1, at):match "[^\n]*$"
    if not line:find("--", 1, true) then
      tables = tables + 1
      local job = scene.read(text:sub(1, at) .. " zzz = 1, " .. text:sub(at + 1), { file = path })
      if job and not own[line:match "(%a+) = {$" or ""] then taken[#taken + 1] = path .. ": " .. line end
    end
  end
end
tap.ok(tables > 300 and #taken == 0, tables .. " tables of the scenes of bodies/ take no unknown key",
  table.concat(taken, "\n"))
for _, case in ipairs { "budget = { ops = 1, zzz = 1 }", "time = { zzz = 1 }", "outputs = { \"rates\", zzz = 1 }",
  "events = { { name = \"e\", when = t - 1, zzz = 1 } }", "events = { zzz = 1 }", "ranges = { zzz = {1, 2} }",
  "ranges = { omega = {1, 2, zzz = 1} }", "effects = { zzz = effect.control {} }",
  "effects = { effect.custom { states = { heat = { rate = function() return 0 end, zzz = 1 } } } }",
  "effects = { effect.damping { c = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, zzz = 1} } }",
  "effects = { effect.torque { body = {{{0, 0}, {1, 1, zzz = 1}}, 0, 0} } }",
  "effects = { effect.inertia_rate { xx = t, zzz = 1 } }" } do
  local job = scene.read(of(BOX, case))
  tap.ok(job == nil, "refused: " .. case)
end

tap.done(program.finish())
