#!/usr/bin/env lua5.4
-- derivatives.t - the emitted self-test of `gen --with jacobians`: it passes, for every stepper that has a transition
-- matrix, and it finds a derivative that is wrong.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The numbers that it compares with are the generator's; that these are right is tests/dynamics/sensitivity.t and
-- tests/methods/transition.t.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()
local WARN = "-std=c99 -O0 -ffp-contract=off -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"

local function run(command) return program.shell(command .. " >" .. dir .. "/log 2>&1") end
local function log() return program.read(dir .. "/log") end

-- inputs, more parameters than states; a point in a turning frame
program.write(dir .. "/many.lua", [[
return scene { name = "many", origin = "corner",
  body = solid.box { x = param("a", 1, "m"), y = param("b", 2, "m"), z = param("c", 3, "m"),
    mass = param("M", 4, "kg") },
  effects = { effect.control { max = param("limit", 2, "N m") }, effect.damping { rate = param("k", 0.1, "1/s") },
    effect.gravity { g = param("g", 9.8, "m/s^2") }, effect.torque { inertial = { param("n", 1, "N m"), 0, 2 } } },
  initial = { omega = { param("p", 1, "rad/s"), 2, 3 } } }]])
program.write(dir .. "/point.lua", [[
return scene { name = "point", body = solid.sphere { r = param("r", 1, "m"), mass = param("M", 4, "kg") },
  effects = { effect.rotating_frame { rate = { 0, 0, param("W", 0.5, "rad/s") } },
    effect.translation { gravity = { 0, 0, param("g", -9.8, "m/s^2") } } }, initial = { position = { 1, 0, 0 } } }]])


for _, name in ipairs { "many", "point", "bodies/heavy_top", "bodies/thruster", "bodies/wheels" } do
  local path = string.find(name, "/", 1, true) and name or dir .. "/" .. name
  local short = string.match(name, "[%w_]+$")
  for _, method in ipairs { "rk4", "adaptive", "taylor", "semi", "midpoint" } do
    local real = method == "semi" and "float" or "double"
    local out = dir .. "/" .. short .. method
    local status = run(string.format("POLHODE_SOURCE=. %s gen %s.lua --layout single --with jacobians --method %s " ..
      "--real %s -o %s",
      binary, path, method, real, out))
    if method == "midpoint" and (short == "point" or short == "wheels") then
      tap.is(status, 1, short .. ", midpoint: refused")
    else
      tap.is(status, 0, short .. ", " .. method .. ": gen --with jacobians", log())
      status = run(string.format("cd %s && gcc %s -o test %s.c %s_test.c -lm && ./test", out, WARN, short, short))
      tap.is(status, 0, short .. ", " .. method .. ": the self-test compiles and passes", log())
      for _, what in ipairs { "transition matrix agrees", "its transition is the step" } do
        tap.ok(string.find(log(), what, 1, true), short .. ", " .. method .. ": the " .. what)
      end
    end
  end
end

-- wrong by a sign or a factor: found
for _, c in ipairs { { "manyrk4", "many", "many_jacobian_u" }, { "manyrk4", "many", "many_jacobian_p" },
  { "manyrk4", "many", "many_initial_p" }, { "manyrk4", "many", "many_step_transition" },
  { "manymidpoint", "many", "midpoint_tangent" }, { "heavy_toptaylor", "heavy_top", "taylor_along" } } do
  local source = program.read(dir .. "/" .. c[1] .. "/" .. c[2] .. ".c")
  local at = string.find(source, c[3] .. "%([^;]-%)\n{")
  local stop = string.find(source, "\n}\n", at, true)
  local body, count = string.sub(source, at, stop), 0
  body = string.gsub(body, "\n(  [FJSv]%[[%w_]+%] = )([^;]*);", function(head, value)
    count = count + 1
    return count == 3 and string.format("\n%s%s + (%s_real)0.015625;", head, value, c[2]) or nil
  end)
  program.write(dir .. "/wrong.c", string.sub(source, 1, at - 1) .. body .. string.sub(source, stop + 1))
  local status = run(string.format("gcc -std=c99 -I%s/%s -o %s/wrong %s/wrong.c %s/%s/%s_test.c -lm", dir, c[1], dir,
    dir, dir, c[1], c[2]))
  tap.ok(count >= 3 and status == 0, c[3] .. ": spoilt", log())
  tap.is(run(dir .. "/wrong"), 1, c[3] .. ": the self-test finds it", log())
end

program.finish()
tap.done()
