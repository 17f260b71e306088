#!/usr/bin/env lua5.4
-- guard.t - NAME_within and the files of --with proof: they compile, the emitted self-test of the guard passes.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The self-test asks the guard at both ends of each range, a few units of the last place beyond, and at infinities
-- and NaN; here it is compiled for scenes whose ranges take each form.  What Frama-C says of the proof:
-- tests/target/proof.t.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local scene = require "tests.scene"
local proof = require "generator.emit.proof"

local dir = program.directory()
local flags = "-O0 -ffp-contract=off -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"

local function emitted(text, real, methods)
  local s = assert(scene.read(text))
  local options = { real = real, methods = methods, proof = true }
  local job = assert(scene.plan(s, options))
  options.proof = proof.check(job)
  return scene.files(assert(scene.plan(s, options))), job
end

local rows = {
  { "a scalar, a vector of pairs and a parameter, in their units", [[
    local M = param("M", 2.5, "lb")
    return scene { name = "b", body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = M },
      initial = { omega = {0.1, 2, 0.3} },
      ranges = { omega = {{-1/3, 1}, {0, quantity(60, "rpm")}, {-7, -1e-20}}, attitude = "any", M = {2, 3} } }]],
    { "rk4", "midpoint", "semi" }, { "attitude .-: |q|%^2 from 1/4 to 4\n", "wx from %-0.333333[3]+ to 1.0 rad/s\n",
      "wy from 0.0 to 6.28318530717958[0-9]* rad/s\n", "wz from %-7.0 to %-1e%-20 rad/s\n" } },
  { "a body that flies, with an angle", [[
    return scene { name = "b", body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = 2 },
      effects = { effect.translation { gravity = {0, 0, -9.81}, drag = 0.1 } }, initial = { omega = {0.1, 2, 0.3} },
      ranges = { omega = 5, attitude = 0.5, position = {-100, 100}, velocity = {{-9, 9}, {-9, 9}, {-90, 0}} } }]],
    { "rk4" }, { "rx from %-100.0 to 100.0 m\n", "vz from %-90.0 to 0.0 m/s\n" } },
  { "a point, which has no attitude", [[
    return scene { name = "b", body = points {{1, 0, 0, 0}}, effects = { effect.translation { gravity = 9.81 } },
      initial = { position = {0, 0, 5} }, ranges = { position = 100, velocity = 30 } }]], { "rk4" }, { "rz from" } },
  { "a clamped input on a body with an axis", [[
    return scene { name = "b", body = solid.cylinder { r = 0.3, h = 0.2, mass = 2 },
      effects = { effect.control{ max = 0.5 } }, initial = { omega = {0.1, 0.2, 3} }, ranges = { omega = 5 } }]],
    { "rk4", "semi", "taylor" }, { "wz from %-5.0 to 5.0 rad/s\n" } },
}

for _, real in ipairs { "float", "double" } do
  for _, row in ipairs(rows) do
    local what = row[1] .. ", " .. real
    local files = emitted(row[2], real, row[3])
    for _, f in ipairs { "b.h", "b.c", "b_test.c", "b_proof.c" } do program.write(dir .. "/" .. f, files[f] or "") end
    for _, part in ipairs(row[4]) do tap.like(files["b.h"], part, what .. ": the header says " .. part, true) end
    tap.is(program.shell("cd " .. dir .. " && gcc -std=c99 " .. flags .. " b.c b_test.c -lm -o t && g++ -x c++ " ..
      flags .. " -c b.c -o x.o && gcc -std=c99 " .. flags .. " -c b_proof.c -o p.o"), 0,
      what .. ": compiles, the proof too")
    tap.is(program.shell("timeout 20 " .. dir .. "/t >" .. dir .. "/tap"), 0, what .. ": the self-test passes")
    tap.like(program.read(dir .. "/tap"), "the guard lets the declared ranges pass and nothing else",
      what .. ": and tests the guard")
    local cycles = select(2, files["b_proof.c"]:gsub("while %(unknown%)", ""))
    tap.is(cycles, #row[3], what .. ": the proof drives every stepper")
  end
end

-- ---- without ranges, and with ranges of some states ----

local plain = [[return scene { name = "b", body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = 2 },
  initial = { omega = {0.1, 2, 0.3} } %s}]]
local files = emitted(plain:format "", "double")
local text = files["b.h"] .. files["b.c"] .. files["b_test.c"] .. files["Makefile"]
tap.ok(not text:find "b_within" and not text:find "guard" and not text:find "frama",
  "without ranges no trace of either")
tap.is(files["b_proof.c"], nil, "and no proof")

local some, job = emitted(plain:format ", ranges = { attitude = \"any\" } ", "double")
tap.like(some["b.h"], " %*   wx any finite number\n", "a state without a range: any finite number", true)
tap.like(some["b.c"], "if (!(x[B_WX] - x[B_WX] == 0.0)) return 1 + B_WX;", "and the guard refuses what is not finite")
tap.like(job.diag:report(), "with proof: ranges must have every state but the attitude, got none of wx, wy, wz",
  "but nothing is proven of it")

-- ---- ranges that leave out each kind of state, in every kind of project ----

-- The self-test is another file than the source: it may call none of the functions that stand in that (--libm own), and
-- what is asked at infinity is the test's own.
local packages = require "generator.emit.packages.packages"
local wheel = "effect.wheel { axis = {1, 0, 0}, inertia = 0.001, torque = 0.01, included = true }"
local own = "effect.custom { states = { lag = { initial = 0.5, " ..
  "rate = function(s) return -s.lag/quantity(2, \"s\") end } } }"
local flight = "effect.translation { gravity = {0, 0, -9.81}, drag = 0.1 }"
local left = {
  { "a wheel's rate", wheel, "omega = 5" }, { "a custom state", own, "omega = 5" },
  { "position and velocity", flight, "omega = 5" }, { "velocity", flight, "omega = 5, position = 100" },
  { "the rates", flight .. ", " .. wheel, "position = 100, velocity = 30" },
  { "all but the attitude", flight .. ", " .. own .. ", " .. wheel, "attitude = \"any\"" },
}
local OWN = "libm.own"
for i, c in ipairs(left) do
  local source = "return scene { name = \"b\", body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = 2 }, " ..
    "effects = { " .. c[2] .. " }, initial = { omega = {0.1, 2, 0.3} }, ranges = { " .. c[3] .. " } }"
  local s = assert(scene.read(source))
  for k, kind in ipairs(tier.every(i, { "make", "cmake", "firmware", "arduino", OWN })) do
    local package = packages.by_name(kind == OWN and "make" or kind)
    local real = package.real or (i + k) % 2 == 0 and "float" or "double"
    local plan, d = scene.plan(s, { real = real, package = package, methods = package.methods,
      jacobians = package.jacobians, libm = kind == OWN and "own" or nil, layout = package.layout })
    if plan then
      program.shell("rm -rf " .. dir .. "/p && mkdir " .. dir .. "/p")
      local list = scene.files(plan)
      for _, name in ipairs(list) do
        local base = name:match "[^/]+$"
        if base:find "^b[%w_]*%.[ch]$" then program.write(dir .. "/p/" .. base, list[name]) end
      end
      local built = program.shell("cd " .. dir .. "/p && gcc -std=c99 " .. flags .. " b*.c -lm -o t && ./t >../tap")
      tap.is(built, 0, kind .. ", " .. real .. ": without a range of " .. c[1] .. " the self-test compiles and passes")
      tap.like(program.read(dir .. "/tap"), "the guard lets the declared ranges pass and nothing else",
        "and tests the guard")
    else
      tap.ok(kind == "firmware", kind .. ": refused without a range of " .. c[1], d and d:report())
    end
  end
end

program.finish()
tap.done()
