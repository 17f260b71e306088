#!/usr/bin/env lua5.4
-- sensitivity.t - df/dx, df/du, df/dp, dx(0)/dp and the transition matrix of a step, against finite differences.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The emitted C is compiled and run.  What it must give is no derivative that anybody formed: central differences
-- of the right-hand side (the exact expressions at 200 bits) with a displacement of 2^-50, and of a Runge-Kutta step
-- written here from the textbook, followed by the one Newton step that brings |q| to 1.  Their error is the square
-- of the displacement times a third derivative, some 2^-100, and 2^-150 of rounding.
-- Tolerance: an entry of df/dx, df/du, df/dp is at most 32 operations deep (emit/selftest.lua), each of which loses
-- half an ulp of the terms before they cancel; the magnitudes of the terms come from the description, the value does
-- not.  An entry of the transition is at most 128 deep (four stages of products, sums, the rate, and their
-- derivatives), on numbers of the size of the largest in its row or of 1.
-- The quick tier takes every seventh scene.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"
local program = require "tests.cli.program"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local selftest = require "generator.emit.selftest"

local BITS, H = 200, R.new(1, 16)
local DELTA = R.new(2) ^ -50
local dir = program.directory()

local BOX = 'solid.box { x = param("a", 0.5, "m"), y = 0.75, z = param("c", 2, "m"), mass = param("M", 3, "kg") }'
local TOP = 'solid.cylinder { r = param("a", 0.5, "m"), h = 2, mass = param("M", 3, "kg") }'
local BALL = 'solid.sphere { r = param("a", 0.5, "m"), mass = 3 }'
local ROD = 'rod.straight { length = param("l", 2, "m"), mass = 3 }'
local OBLIQUE = BOX .. ':turned { axis = {1, 2, 3}, angle = 1 }'
local BRACKET = BOX .. ' + solid.box { x = 0.25, y = 0.5, z = param("e", 0.5, "m"), mass = 1 }:at{0.5, 0.25, 1}'

-- {what, body, effects, more}
local rows = {
  { "box", BOX, "" }, { "cylinder", TOP, "" }, { "ball", BALL, "" }, { "rod", ROD, "" }, { "oblique", OBLIQUE, "" },
  { "bracket", BRACKET, "" },
  { "box, damped", BOX, 'effect.damping { c = { param("k", 0.25, "N m s"), 0.5, 0.125 } }' },
  { "heavy top", TOP, 'effect.gravity { g = param("g", 9.5, "m/s^2") }', "origin = {0, 0, -1}" },
  { "ball, driven", BALL, 'effect.control {}, effect.torque { inertial = { param("n", 0.5, "N m"), 0, 1 } }' },
  { "rod, hanging", ROD, "effect.gravity {}", "origin = {0, 0, 1}" },
  { "oblique, damped and driven", OBLIQUE, "effect.damping { c = {{1, 0.25, 0}, {0.25, 2, 0}, {0, 0, 1}} }, " ..
    "effect.control {}" },
  { "bracket on its corner", BRACKET, "effect.gravity {}, effect.damping { rate = 0.25 }", "origin = {0, 0, 0}" },
  { "box in a turning frame, thrown", BOX, 'effect.rotating_frame { rate = {0.25, 0, param("W", 0.5, "rad/s")} }, ' ..
    "effect.translation { gravity = {0, 0, -4}, drag = 0.5 }" },
  { "box, drag, a turning field and a wheel", BOX, 'effect.drag { c = param("k", 0.25) }, effect.magnetic { moment =' ..
    ' {1, 0, 0.5}, rotating = { param("B", 0.25), 0, 1 }, rate = 0.5 }, effect.wheel { axis = {0, 3, 4}, inertia = ' ..
    'param("j", 0.125), torque = 0.5, included = false }' },
  { "point", BOX, 'effect.translation { drag = param("k", 0.5, nil) }', "initial = { position = {0, 0, 1} }" },
}

local places = { qw = "1/2", qx = "-1/2", qy = "1/2", qz = "1/2", wx = "3/4", wy = "-5/8", wz = "9/8", rx = "1/2",
  ry = "-1", rz = "1/4", vx = "1/4", vy = "3/4", vz = "-1/2", ux = "1/4", uy = "1/2", uz = "3/4", t = "0", wheel = "2" }

-- f at a point and its central differences by `names`: a list of {name = difference}.
local function differences(f, at, names)
  local out = {}
  for k, name in ipairs(names) do
    local kept = at[name]
    at[name] = kept + DELTA
    local high = f(at)
    at[name] = kept - DELTA
    local low = f(at)
    at[name] = kept
    out[k] = {}
    for s, x in pairs(high) do out[k][s] = (x - low[s]) / (DELTA + DELTA) end -- in any order: by name
  end
  return out
end

-- The textbook's Runge-Kutta step of the rates f, then q times 3/2 - |q|^2/2 of the q it started from.
local function step(f, x, states)
  local function moved(k, h)
    local y = setmetatable({}, { __index = x })
    for _, s in ipairs(states) do y[s.name] = R.round(x[s.name] + h * k[s.name], BITS) end
    y.t = x.t + h
    return y
  end
  local k1 = f(x)
  local k2 = f(moved(k1, H / R.new(2)))
  local k3 = f(moved(k2, H / R.new(2)))
  local k4 = f(moved(k3, H))
  local n, out = R.new(3, 2), {}
  for _, s in ipairs(states) do
    if s.kind == "attitude" then n = n - x[s.name] * x[s.name] / R.new(2) end
  end
  for _, s in ipairs(states) do
    local y = x[s.name] + H / R.new(6) * (k1[s.name] + R.new(2) * (k2[s.name] + k3[s.name]) + k4[s.name])
    out[s.name] = s.kind == "attitude" and n * y or y
  end
  return out
end

local function names(list)
  local out = {}
  for i, x in ipairs(list) do out[i] = x.name end
  return out
end

local main = [[
#include "NAME.h"
#include <stdio.h>
static void show(const char *what, int n, const NAME_real *v) {
  int i;
  printf("%s", what);
  for (i = 0; i < n; i++) printf(" %.17g", (double)v[i]);
  printf("\n");
}
int main(void) {
  static NAME_real J[400];
  static NAME_real x[] = {STATE};
  static const NAME_real u[] = {(NAME_real)0.25, (NAME_real)0.5, (NAME_real)0.75};
  NAME_model m;
  if (NAME_init(&m, 0) != 0) return 1;
CALLS  return 0;
}
]]

local jobs, script = {}, {}
for i, row in ipairs(tier.every(7, rows)) do
  -- every other scene in float, too: there only constants and tolerances are others
  for _, real in ipairs { "double", i % 2 == 0 and "float" or nil } do
    local name = string.format("s%d%s", i, real:sub(1, 1))
    local job = assert(scene.read("return scene { name = \"" .. name .. "\", body = " .. row[2] .. ", effects = {" ..
      row[3] .. "}, " .. (row[4] or 'initial = { omega = { param("p", 0.5, "rad/s"), 1, 2 } }') .. " }\n"))
    job = assert(scene.plan(job, { real = real, jacobians = true }))
    local files = scene.files(job)
    local calls, sizes = {}, {}
    local nx, nu, np = #job.states, #job.model.inputs, #job.model.params
    local function call(f, n, args)
      if scene.description(job, f) then
        calls[#calls + 1] = string.format("  NAME_%s(%s);\n  show(\"%s\", %d, J);\n", f, args, f, n)
        sizes[f] = n
      end
    end
    call("jacobian", nx * nx, "&m, 0, x, u, J")
    call("jacobian_u", nx * nu, "&m, 0, x, u, J")
    call("jacobian_p", nx * np, "&m, 0, x, u, J")
    call("initial_p", nx * np, "&m, J")
    call("step_transition", nx * nx, "&m, 0, x, u, (NAME_real)0.0625, J")
    local values = {}
    for k, s in ipairs(job.states) do
      values[k] = string.format("(NAME_real)%.17g", R.todouble(R.lift(places[s.name])))
    end
    local text = main:gsub("CALLS", table.concat(calls)):gsub("STATE", table.concat(values, ", ")):gsub("NAME", name)
    program.write(dir .. "/" .. name .. ".h", files[name .. ".h"])
    program.write(dir .. "/" .. name .. ".c", files[name .. ".c"])
    program.write(dir .. "/" .. name .. "_main.c", text)
    script[#script + 1] = string.gsub("gcc -std=c99 -O0 -Wall -Wextra -Werror -ffp-contract=off -o NAME NAME.c " ..
      "NAME_main.c -lm && ./NAME > NAME.out", "NAME", name)
    jobs[#jobs + 1] = { job = job, what = row[1] .. ", " .. real, body = row[1], name = name, real = real,
      sizes = sizes }
  end
end
program.write(dir .. "/build.sh", "cd " .. dir .. "\n" .. table.concat(script, "\n") .. "\n")
tap.is(program.shell("sh " .. dir .. "/build.sh 2>" .. dir .. "/log"), 0, "the emitted code compiles",
  program.read(dir .. "/log"))

local function check(j, f, want)
  local job = j.job
  local got = {}
  for line in io.lines(dir .. "/" .. j.name .. ".out") do
    if line:match "^%S+" == f then
      for word in line:gmatch " (%S+)" do got[#got + 1] = tonumber(word) end
    end
  end
  if not tap.is(#got, j.sizes[f], j.what .. ": " .. f .. " has all its numbers") then return end
  local epsilon = R.new(2) ^ (j.real == "float" and -23 or -52)
  local at = {}
  for k, v in pairs(places) do at[k] = R.lift(v) end -- in any order: by name
  at.h = H
  local most = {} -- of a row of the transition
  for i, s in ipairs(job.states) do
    most[i] = R.one
    for _, column in ipairs(want) do
      if R.abs(column[s.name]) > most[i] then most[i] = R.abs(column[s.name]) end
    end
  end
  local tolerance = {}
  if f ~= "step_transition" then
    local env = selftest.environment(job.model, job.model.defaults)
    local _, t = selftest.expect(scene.description(job, f), env, at, function(o) return o.index + 1 end, epsilon)
    tolerance = t
  end
  local wrong, worst = {}, 0
  local columns = #want
  for k, column in ipairs(want) do
    for i, s in ipairs(job.states) do
      local n = (i - 1) * columns + k
      local d = R.abs(R.fromdouble(got[n]) - column[s.name])
      local allowed = (f == "step_transition" and most[i] * R.new(64) * epsilon or tolerance[n]) + R.new(2) ^ -80
      worst = math.max(worst, R.todouble(d / allowed))
      if d > allowed then
        wrong[#wrong + 1] = string.format("[%s, %d] %.17g, not %.17g", s.name, k, got[n], R.todouble(column[s.name]))
      end
    end
  end
  tap.ok(#wrong == 0, j.what .. ": " .. f .. string.format(" (worst %.2g of what rounding may do)", worst),
    table.concat(wrong, "\n", 1, math.min(#wrong, 5)))
end

local wanted = {} -- by what was asked: the same for double and float
for _, j in ipairs(jobs) do
  local job = j.job
  local rates = scene.rates(job)
  local at = {}
  for k, v in pairs(job.model.defaults) do at[k] = v end -- in any order: by name
  for k, v in pairs(places) do at[k] = R.lift(v) end
  local function values(list)
    return function(x)
      local out = {}
      for name, e in pairs(list) do out[name] = evaluate.precise(e, x, BITS) end -- in any order: by name
      return out
    end
  end
  local f, fixed, constants = values(rates), {}, {} -- fixed: the parameters put in, for it is quicker
  for _, p in ipairs(job.model.params) do constants[p.sym] = expr.num(p.default) end
  for name, e in pairs(rates) do fixed[name] = calculus.substitute(e, constants) end -- in any order: by name
  fixed = values(fixed)
  local function start(x)
    local out = {}
    for _, s in ipairs(job.states) do out[s.name] = evaluate.precise(s.initial, x, BITS) end
    return out
  end
  local states, params = names(job.states), names(job.model.params)
  local function one(what, g, by)
    local key = j.body .. " " .. what
    wanted[key] = wanted[key] or differences(g, at, by)
    check(j, what, wanted[key])
  end
  one("jacobian", fixed, states)
  if job.equations.inputs then one("jacobian_u", fixed, names(job.model.inputs)) end
  one("jacobian_p", f, params)
  one("initial_p", start, params)
  one("step_transition", function(x) return step(fixed, x, job.states) end, states)
end

-- what is not asked for is not there; what does not exist is refused
do
  local text = "local s = scene { name = \"b\", body = " .. BOX .. ",\n  %s }\nreturn s\n"
  local job = assert(scene.read(text:format ""))
  job = scene.plan(job)
  for _, name in ipairs { "jacobian_u", "jacobian_p", "initial_p", "step_transition" } do
    tap.ok(not scene.description(job, name), name .. " is not there unless asked for")
  end
  local planned, d = scene.plan(assert(scene.read(text:format
    'initial = { omega = { sqrt(param("p", 0, "rad^2/s^2")), 1, 2 } }')), { jacobians = true })
  tap.ok(not planned, "the root of p has no derivative at p = 0: refused")
  tap.ok(d:report():find("test.lua:%d: jacobians: d wx%(0%)/d p must exist"), "and it says which", d:report())
end

-- Expected values of a step whose sums cancel in each stage: their magnitudes are products of a high degree.
do
  local job = assert(scene.read [[return scene { name = "rd", body = tensor { mass = 1, xx = 0.01, yy = 0.012,
    zz = 0.02 }, initial = { omega = {0.1, 0, 7}, attitude = {1, 1, 0.1, 0} }, effects = { effect.plane {
    surface = contact.disc { r = 0.3, edge = 0.02 }, law = "rolling", spinning = { viscous = 0.01 } } } }]])
  local began = os.clock()
  local files = scene.files(scene.plan(job, { jacobians = true }))
  tap.ok(files["rd_test.c"] and os.clock() - began < 30, "a rolling disc with resistance to spinning: a test is made")
end

program.finish()
tap.done()
