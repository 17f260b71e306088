#!/usr/bin/env lua5.4
-- reference.t - drag, constant torques and wheels against tables of 32 digits, by the emitted code and by the library.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Emitted: rk4 with steps of 2e-3 rad of the fastest rate; its error is about (h w/2)^4 w t/240, below 1e-12, and what
-- rounding adds stays below 1e-11 of the state's size: a constant torque adds the same increment, rounded the same way,
-- in each of up to 1e5 steps, so that shorter steps would be worse.
-- Library: 1e-12, as its numbers are doubles at the end and all steps are in long double.
-- Published: Basilisk's test of balanced wheels, sigma = q_v/(1 + q_w) after a phase without torque, 9 digits.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local rows = require "tests.reference.effects"

local dir = program.directory()
local binary = program.quick()

local function numbers(list)
  local out = {}
  for i, s in ipairs(list) do out[i] = tonumber(s) end
  return out
end

local function braces(list) return "{" .. table.concat(list, ", ") .. "}" end

local axes = { "{1, 0, 0}", "{0, 1, 0}", "{0, 0, 1}" }

-- The rows of constant torques stand in the table of the C tests.
local function torques()
  local last
  for id, model, I, load, x0, t, x in
    program.read("tests/reference/forced_top.h"):gmatch(
      '{"([%w_]+)", FORCED_(%u+), {(.-)}, {(.-)},%s*{(.-)}, (%S+),%s*{(.-)}}') do
    local function words(text)
      local list = {}
      for word in text:gmatch "[^,%sL]+" do list[#list + 1] = word end
      return list
    end
    if model == "BODY" or model == "INERTIAL" then
      if not last or last.id ~= id then
        last = { id = id, I = words(I), x0 = words(x0), ["tau_" .. model:lower()] = words(load) }
        rows[#rows + 1] = last
      end
      last[#last + 1] = { t = t, table.unpack(words(x)) }
    end
  end
end
torques()
tap.is(#rows, 9, "nine cases of drag, wheels and constant torques")

-- The scene of a row; x: the state to start with, w, q, then speeds; u: torques of the wheels, or nil.
local function scene(row, x, u)
  local effects, wheels = {}, {}
  if row.c then effects[1] = "effect.drag { c = " .. row.c .. " }" end
  if row.tau_body then effects[1] = "effect.torque { body = " .. braces(row.tau_body) .. " }" end
  if row.tau_inertial then effects[1] = "effect.torque { inertial = " .. braces(row.tau_inertial) .. " }" end
  if row.J then wheels[1] = { 3, row.J } end
  for i = 1, row.Js and 3 or 0 do wheels[i] = { i, row.Js } end
  for i, w in ipairs(wheels) do
    effects[#effects + 1] = string.format("effect.wheel { axis = %s, inertia = %s, speed = %s, torque = %s, " ..
      "included = true }", axes[w[1]], w[2], x[7 + i], u and u[i] or "0")
  end
  return string.format("return scene { name = \"row\", body = tensor { mass = 1, com = {0, 0, 0}, xx = %s, yy = %s, " ..
    "zz = %s },\n  effects = { %s },\n  initial = { omega = %s, attitude = %s } }\n", row.I[1], row.I[2], row.I[3],
    table.concat(effects, ", "), braces { table.unpack(x, 1, 3) }, braces { table.unpack(x, 4, 7) })
end

-- The states at the times, as the table has them: w, q, speeds; raises what the program says when it fails.
local function run(text, times, options)
  program.write(dir .. "/row.lua", text)
  local command = string.format("timeout 120 %s run %s/row.lua --at %s %s >%s/stdout 2>%s/stderr", binary, dir,
    table.concat(times, ","), options, dir, dir)
  assert(program.shell(command) == 0, program.read(dir .. "/stderr"))
  local out = {}
  for line in program.read(dir .. "/stdout"):gmatch "([^\n]*)\n" do
    local cells = {}
    for cell in line:gmatch "[^,]+" do cells[#cells + 1] = cell end
    out[#out + 1] = { cells[6], cells[7], cells[8], cells[2], cells[3], cells[4], cells[5],
      table.unpack(cells, 13) }
  end
  return { table.unpack(out, 2) } -- without the names of the columns
end

-- Largest error: of q, of w over the largest rate, of a speed over the largest speed.
local function distance(got, want)
  local worst = 0.0
  for _, part in ipairs { { 1, 3 }, { 4, 7 }, { 8, #want } } do
    local size, error = 0.0, 0.0
    for i = part[1], part[2] do
      size, error = math.max(size, math.abs(want[i])), math.max(error, math.abs(got[i] - want[i]))
      if got[i] ~= got[i] then error = math.huge end
    end
    if error > 0 then worst = math.max(worst, error / size) end
  end
  return worst
end

for _, row in ipairs(rows) do
  local times, fastest = {}, 1.0
  for i, s in ipairs(row) do
    times[i] = s.t
    for k = 1, #s do fastest = math.max(fastest, math.abs(tonumber(s[k]))) end
  end
  local text = scene(row, row.x0, row.u)
  local step = string.format("--engine generated --method rk4 --step %.17g", 2e-3 / fastest)
  for _, road in ipairs { { "emitted rk4", step, 1e-11 }, { "library", "", 1e-12 } } do
    local got, worst = run(text, times, road[2]), 0.0
    tap.is(#got, #row, row.id .. ", " .. road[1] .. ": a state for every time")
    for i, s in ipairs(row) do worst = math.max(worst, distance(numbers(got[i]), numbers(s))) end
    tap.ok(worst <= road[3], string.format("%s, %s: %g", row.id, road[1], road[3]), string.format("%.3g", worst))
  end
end

-- Half a second with torque, half without: what Basilisk's own test wants of the attitude.
local published = { 1.99853994e-02, 2.45647716e-03, 8.45356279e-06 }
for _, row in ipairs(rows) do
  for _, options in ipairs(row.Js and { "", "--engine generated --method rk4 --step 0.001" } or {}) do
    local middle = run(scene(row, row.x0, row.u), { "0.5" }, options)[1]
    local x = numbers(run(scene(row, middle, nil), { "0.5" }, options)[1])
    for k = 1, 3 do
      tap.near(x[4 + k] / (1 + x[4]), published[k], 5e-9, 0, row.id .. ", published sigma " .. k .. " " .. options,
      "nine digits are published")
    end
  end
end

program.finish()
tap.done()
