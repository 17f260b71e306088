#!/usr/bin/env lua5.4
-- bench_time.t - loops inside plugins, what timing them reports, and compiling several at once.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Nothing here depends on how fast anything is: times must be positive and in order, counts exact, and a limit kept so
-- far that the test ends.

local tap = require "tests.tap"
local program = require "tests.cli.program"
local lua = require "tests.cli.whole"

local dir = program.directory()

program.write(dir .. "/free.lua", [[
local a = param("a", 0.2, "m")
return scene { name = "free", body = solid.box { x = a, y = 0.1, z = 0.0333, mass = 1 },
  initial = { omega = {1, 6.5, 1} }, time = { horizon = 5 } }
]])
-- time in its torque, and an input
program.write(dir .. "/driven.lua", [[
return scene { name = "driven", body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = 12 },
  effects = { effect.control {}, effect.torque { body = { 0, 0.01, 0.02*sin(1.5*t) } } },
  initial = { omega = {0.1, 0.2, 0.3} }, time = { horizon = 6, step = 0.001 } }
]])

-- The lines that the text says, each a test of its own: "true what" or something else.
local function holds(text)
  local out = lua(text)
  tap.ok(out ~= nil, "the program runs")
  for line in (out or ""):gmatch "[^\n]+" do
    local good, what = line:match "^(%S+) (.*)$"
    tap.ok(good == "true", what, line)
  end
end

-- Start and step are multiples of 1/128: t0 + i h is exact in float, too.
holds [[
local all = { "rk4", "adaptive", "taylor", "semi" }
local list = {
  { job = plan("driven", { methods = all, order = 6 }) },
  { job = plan("driven", { methods = all, order = 6, real = "float" }) },
  { job = plan("free", { methods = { "exact", "rk4", "midpoint", "split4" } }) },
  { job = plan("free", { methods = { "exact", "rk4", "midpoint", "split4" }, real = "float" }) },
}
local p = assert(build.plugins(host, list))
local n, orders = 100, { rk4 = 4, adaptive = 5, taylor = 6, semi = 1, midpoint = 2, split4 = 4 }
for i, plugin in ipairs(p) do
  plugin:init()
  local about = plugin:info()
  local tag = about.name .. ", " .. about.real .. ", "
  say(#about.steppers == (i <= 2 and 4 or 3), tag .. "all steppers are there")
  for _, s in ipairs(about.steppers) do
    local x0, u, h, t0 = numeric.initial(list[i].job), i <= 2 and { 0.1, -0.2, 0.3 } or nil, 1 / 128, 1 / 4
    local x = x0
    for k = 0, n - 1 do x = plugin:step(t0 + k * h, x, u, h, s.name) end
    say(same(plugin:march(t0, x0, u, h, n, s.name), x), tag .. s.name .. ": n steps in a loop are n single steps")
    say(not same(x, x0), tag .. s.name .. ": they lead somewhere")
    say(s.order == orders[s.name], tag .. s.name .. ": its order")
    say(s.adaptive == (s.name == "adaptive" or s.name == "taylor"), tag .. s.name .. ": has it steps of its own?")
  end
end
say(same(p[1]:march(0, numeric.initial(list[1].job), nil, 0.1, 0), numeric.initial(list[1].job)), "no steps, no motion")
say(not pcall(p[1].march, p[1], 0, { 1 }, nil, 0.1, 1), "march: a short state is refused")
say(not pcall(p[1].march, p[1], 0, numeric.initial(list[1].job), nil, 0.1, -1), "march: a negative number is refused")
say(not pcall(p[1].march, p[1], 0, numeric.initial(list[1].job), nil, 0.1, 1, "heun"), "march: another name is refused")
]]

local TIME = [[
local function sound(r) return r.least > 0 and r.least <= r.median and r.median <= r.most and r.most < math.huge end
local function refused(p, options, part)
  local ok, why = pcall(p.time, p, options)
  say(not ok and string.find(why, part, 1, true) ~= nil, "time refuses: " .. part .. " (" .. tostring(why) .. ")")
end
]]

holds(TIME .. [[
local job = plan("free", { methods = { "exact", "rk4", "adaptive" } })
local p = assert(build.plugin(host, job))
local x0 = numeric.initial(job)
say(not pcall(p.time, p, { x0 = x0, to = 1, step = 0.1 }), "nothing is timed before init")
p:init()
local function cpus() return string.match(host.read "/proc/self/status" or "", "Cpus_allowed:%s*(%S+)") end
local before = cpus()
local r = p:time { x0 = x0, to = 1, step = 0.01, method = "rk4", repeats = 5 }
say(sound(r) and r.steps == 100 and r.repeats == 5 and r.part == 1, "a fixed step: times in order, all steps")
say(before == cpus(), "afterwards every processor may be used as before")
r = p:time { x0 = x0, to = 1, step = 0.3, repeats = 4 }
say(sound(r) and r.steps == 4 and r.repeats == 4, "steps are cut as integrate cuts them; the scene's own stepper")
r = p:time { x0 = x0, to = 1, tolerance = 1e-9, method = "adaptive", repeats = 3 }
local _, steps = p:integrate(x0, nil, { 1e-9 }, { 1 }, 0, "adaptive")
say(sound(r) and r.steps == steps and r.part == 1, "a tolerance: as many steps as integrate takes")
r = p:time { x0 = x0, to = 1e9, step = 1e-2, limit = 0.02 }
say(sound(r) and r.steps == 1e11 and r.part < 1, "of a long way a part is timed")
r = { p:time { x0 = x0, to = 1e9, tolerance = 1e-13, method = "adaptive", limit = 0.02 } }
say(r[1] == nil and r[2] == "not done within the limit", "a run that would take for ever ends with a message")
r = { p:time { x0 = { 1, 0, 0, 0, 1e308, 1e308, 1e308 }, to = 1, tolerance = 1e-9, method = "adaptive", limit = 5 } }
say(r[1] == nil and r[2] == "no steps lead to the end", "a run that cannot go on says so")
refused(p, { x0 = x0, to = 1 }, "a step or a tolerance")
refused(p, { x0 = x0, to = 1, step = 0.1, tolerance = 1e-9 }, "a step or a tolerance")
refused(p, { x0 = x0, to = 1, step = -0.1 }, "step: a positive number")
refused(p, { x0 = x0, to = 1, step = 0 / 0 }, "step: a positive number")
refused(p, { x0 = x0, to = 1, step = "0.1" }, "field 'step': number expected")
refused(p, { x0 = x0, to = 1, step = 1e-20 }, "more than 1e15 steps")
refused(p, { x0 = x0, step = 0.1 }, "to: a positive number")
refused(p, { x0 = x0, to = 0, step = 0.1 }, "to: a positive number")
refused(p, { x0 = { 1 }, to = 1, step = 0.1 }, "a list of 7 numbers")
refused(p, { to = 1, step = 0.1 }, "field 'x0': list of numbers expected")
refused(p, { x0 = x0, to = 1, step = 0.1, method = "heun" }, "no stepper heun")
refused(p, { x0 = x0, to = 1, tolerance = 0.1, method = "rk4" }, "the stepper rk4 has a fixed step")

p:solve(x0)
local there = p:at(0.7)
r = p:time_closed { x0 = { 1, 0, 0, 0, 3, 2, 1 }, to = 5, repeats = 3 }
say(sound(r.setup) and sound(r.at) and sound(r.many) and r.setup.repeats == 3,
  "closed form: set-up, evaluation, many evaluations, each in order")
say(same(p:at(0.7), there), "the plugin's orbit is what it was")
p = assert(build.plugin(host, plan("driven", { methods = { "rk4" } })))
p:init()
r = { p:time_closed { x0 = { 1, 0, 0, 0, 3, 2, 1 }, to = 5 } }
say(r[1] == nil and r[2] == "the emitted code has no closed form", "without a closed form there is nothing to time")

local b = host.baseline()
say(sound(b) and b.ns == b.median and b.spread >= 0, "the baseline is a time and a spread")
say(math.type(host.processors()) == "integer" and host.processors() >= 1, "there is a processor")
]])

-- ---- several compilers at once ----

holds [[
local function item(flags, real) return { job = plan("free", { methods = { "rk4" }, real = real }), flags = flags } end
local good, bad = { "-O1" }, { "-include", "nothing_of_that_name.h" }
local p, failed = build.plugins(host, { item(good), item(bad), item(nil, "float"), item { "--no-such-option" } })
say(p[1] and p[3] and p[2] == false and p[4] == false, "those that compile are there")
say(failed[1] == nil and failed[3] == nil, "only those that do not have failed")
say(string.find(failed[2].message, "nothing_of_that_name.h", 1, true) ~= nil and
  string.find(failed[4].message, "no-such-option", 1, true) ~= nil, "each failure has its own message")
say(p[1]:info().real == "double" and p[3]:info().real == "float", "each plugin is that of its own job")
say(select("#", build.plugins(host, { })) == 2 and #build.plugins(host, { }) == 0, "of no jobs no plugins")
]]

local MANY = [[
local dir, list = host.tempdir(), {}
for i = 1, 9 do
  host.write_file(dir .. "/" .. i .. ".c", i == 5 and "#error five\n" or "int n" .. i .. ";\n")
  list[i] = { dir, { i .. ".c" }, i .. ".o", { flags = { "-c" } } }
end
]]
holds(MANY .. [[
for _, at_once in ipairs { 0, 1, 2, 100 } do
  local made = host.compile_many(list, at_once)
  local right = #made == 9
  for i = 1, 9 do
    local command, message = made[i].command or "", made[i].message or ""
    if i == 5 then
      right = right and string.find(message, "five", 1, true) ~= nil
    else
      right = right and string.find(command, " " .. i .. ".c", 1, true) ~= nil
        and host.read(dir .. "/" .. i .. ".o") ~= nil
    end
  end
  say(right, "nine files, " .. at_once .. " at once: every result at its place")
end
list[1][4] = { cc = "no-such-compiler-" .. 1 }
local made = host.compile_many { list[1], list[2] }
say(string.find(made[1].message, "cannot run the C compiler no-such-compiler-1", 1, true) ~= nil,
  "a compiler that is not there")
say(made[2].command ~= nil, "does not keep the next from running")
say(#host.compile_many {} == 0, "nothing to compile")
say(not pcall(host.compile_many, { { } }) and not pcall(host.compile_many, { 1 }) and not pcall(host.compile_many),
  "a list of another form is refused")
]])

tap.done(program.finish())
