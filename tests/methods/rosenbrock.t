#!/usr/bin/env lua5.4
-- rosenbrock.t - the linearly implicit method: its order conditions, and the emitted stepper on stiff and mild scenes.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- With Gamma = (1/g - C)^-1, alpha = a Gamma, beta = alpha + Gamma, b = (a_8, 1) Gamma the method has order p iff for
-- every rooted tree of at most p vertices sum b_i Phi_i is one over the tree's density, where Phi_i takes beta_ij to
-- the only child of a vertex and alpha_ij to each of several (Hairer, Wanner, Solving ODEs II, IV.7).  The coefficients
-- have 16 digits and are up to 320: a weight, a sum of products of four of them that is at most 1, may be wrong by
-- 1e-12.
--
-- A ball with I = J 1 that slides with viscous friction c on a level plane: slip s = s0 exp(-c g t/k), k = J/(J + m
-- R^2) = 2/7, and its centre's velocity V = V0 - k (s0 - s) (Newton, Euler and N = m g).  The tolerance is 1e-9 a step,
-- relative to the speed of turning R |w|, for some 500 steps: 1e-6 of that is far above, and a wrong term far beyond
-- it.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local R = require "generator.algebra.rational"
local rosenbrock = require "generator.methods.rosenbrock"
local trees = require "tests.methods.trees"

-- ---- the coefficients ----

local T, n = rosenbrock.tableau, 8

local function zeros()
  local m = {}
  for i = 1, n do
    m[i] = {}
    for k = 1, n do m[i][k] = R.zero end
  end
  return m
end

local Gamma = zeros() -- column by column: (1/g) x_i - sum C_ij x_j = e_i
for k = 1, n do
  for i = k, n do
    local sum = i == k and R.one or R.zero
    for j = k, i - 1 do sum = sum + T.C[i][j] * Gamma[j][k] end
    Gamma[i][k] = sum * T.gamma
  end
end
local alpha, beta, b = zeros(), zeros(), {}
for k = 1, n do
  for i = 1, n do
    for j = 1, i - 1 do alpha[i][k] = alpha[i][k] + T.a[i][j] * Gamma[j][k] end
    beta[i][k] = alpha[i][k] + Gamma[i][k]
  end
  b[k] = Gamma[n][k]
  for j = 1, n - 1 do b[k] = b[k] + T.a[n][j] * Gamma[j][k] end
end

local function phi(t)
  local out = {}
  for i = 1, n do out[i] = R.one end
  local by = #t.forest == 1 and beta or alpha
  for _, s in ipairs(t.forest) do
    local inner = phi(s)
    for i = 1, n do
      local sum = R.zero
      for j = 1, n do sum = sum + by[i][j] * inner[j] end
      out[i] = out[i] * sum
    end
  end
  return out
end

local function defect(weights, t)
  local sum = -(R.one / trees.density(t))
  for i, x in ipairs(phi(t)) do sum = sum + weights[i] * x end
  return math.abs(R.todouble(sum))
end

do
  local digits = 1e-12
  local all, worst, low, beyond, above = trees.build(6), 0.0, 0.0, 0.0, 0.0
  local embedded = {} -- without k_8: the row before the last of what is added
  for k = 1, n do embedded[k] = b[k] - Gamma[n][k] end
  for _, t in ipairs(all) do
    local d, e = defect(b, t), defect(embedded, t)
    if t.size <= 5 then worst = math.max(worst, d) else beyond = math.max(beyond, d) end
    if t.size <= 4 then low = math.max(low, e) elseif t.size == 5 then above = math.max(above, e) end
  end
  tap.ok(worst <= digits, "all 17 conditions of order 5", string.format("%.2g", worst))
  tap.ok(low <= digits, "without the last stage the 8 of order 4", string.format("%.2g", low))
  tap.ok(beyond > 1e-4 and above > 1e-4, "and neither one order more", string.format("%.2g, %.2g", beyond, above))
  local stiffly = 0.0
  for k = 1, n do stiffly = math.max(stiffly, math.abs(R.todouble(b[k] - beta[n][k]))) end
  tap.ok(stiffly <= digits, "stiffly accurate, so what decays at an infinite rate is gone after a step",
    string.format("%.2g", stiffly))
  local times = 0.0
  for i = 1, n do
    local sum, all_of = R.zero, R.zero
    for k = 1, n do sum, all_of = sum + alpha[i][k], all_of + Gamma[i][k] end
    times = math.max(times, math.abs(R.todouble(sum - T.c[i])), math.abs(R.todouble(all_of - T.d[i])))
  end
  tap.ok(times <= digits, "stages stand at the times of their sums", string.format("%.2g", times))
end

-- ---- the emitted stepper ----

local binary, dir = program.quick(), program.directory()

-- The rows of a run as lists of numbers by column; nil and what it said.
local function run(path, more)
  local status = program.shell(string.format("POLHODE_SOURCE=. %s run %s %s > %s/csv 2> %s/said", binary, path, more,
    dir, dir))
  if status ~= 0 then return nil, program.read(dir .. "/said") end
  local rows = {}
  for line in string.gmatch(string.match(program.read(dir .. "/csv"), "^(.-)\n\n") or program.read(dir .. "/csv"),
    "[^\n]+") do
    local row = {}
    for word in string.gmatch(line, "[^,]+") do row[#row + 1] = tonumber(word) end
    if #row > 0 then rows[#rows + 1] = row end
  end
  return rows
end

local function written(name, text)
  program.write(dir .. "/" .. name .. ".lua", text)
  return dir .. "/" .. name .. ".lua"
end

local radius, g = 0.03, 9.80665
local function ball(c, name)
  return written(name or "ball", string.format([[
return scene { name = "ball", body = solid.sphere { r = %g, mass = quantity(170, "g") },
  effects = { effect.plane { surface = contact.sphere { r = %g }, law = "sliding", friction = { viscous = %g } } },
  initial = { omega = { 10, 0, 5 }, velocity = { 1, 0.5, 0 } }, time = { horizon = 2 } }
]], radius, radius, c))
end

local emitted = "--engine generated --method rosenbrock --tolerance "
local columns = "t,slip_x,slip_y,com_velocity_x,com_velocity_y"
for _, c in ipairs { 0.01, 2, 200, 20000, 2e6 } do
  local rate = c * g * 7 / 2
  local t1 = 1 / rate
  local path = ball(c)
  -- slip at the start: v + w x (-R n) = (1, 0.5 + 10 R)
  local s0 = { 1, 0.5 + 10 * radius }
  for _, t in ipairs(t1 < 2 and { t1, 2 } or { 2 }) do
    local rows, said = run(path, string.format("--at %.17g --columns %s %s1e-9", t, columns, emitted))
    local worst = rows and 0.0 or math.huge
    for k = 1, rows and 2 or 0 do
      local s = s0[k] * math.exp(-rate * t)
      local V = (k == 1 and 1 or 0.5) - 2 / 7 * (s0[k] - s)
      worst = math.max(worst, math.abs(rows[1][1 + k] - s), math.abs(rows[1][3 + k] - V))
    end
    tap.ok(worst <= 1e-6, string.format("ball, c = %g s/m: slip and velocity of the closed form at %.2g s", c, t),
      rows and string.format("%.2g", worst) or said)
  end
end

-- From rest on a slope nothing tells how short the first step must be.  With r = c G_n/k the slip tends to G_t/r, and
-- V = G_t (t - k (t - (1 - exp(-r t))/r)): G_t = 3/5 g, G_n = 4/5 g.
do
  local path = written("slope", [[
return scene { name = "slope", body = solid.sphere { r = 0.1, mass = 1 },
  effects = { effect.plane { surface = contact.sphere { r = 0.1 }, law = "sliding", friction = { viscous = 200 },
    normal = { 0, -3, 4 } } }, initial = { omega = { 0, 0, 0 } }, time = { horizon = 0.1 } }
]])
  local t, r = 0.1, 200 * 0.8 * g * 7 / 2
  local V = 0.6 * g * (t - 2 / 7 * (t - (1 - math.exp(-r * t)) / r))
  for _, way in ipairs { { "the library", "", 1e-12 }, { "rosenbrock", emitted .. "1e-9", 1e-6 } } do
    local rows, said = run(path, "--at 0.1 --columns t,v2 " .. way[2])
    tap.ok(rows and math.abs(rows[1][2] / V + 1) <= way[3], "a ball at rest on a slope, c = 200 s/m, by " .. way[1],
      rows and string.format("%.17g, %.17g", rows[1][2], V) or said)
  end
end

-- The energy falls to the rounding of some hundred steps: 1e-9 of it a step is the tolerance.
do
  local rows = run(ball(20000), "--every 0.02 --columns t,energy " .. emitted .. "1e-9")
  local rise = 0.0
  for i = 2, #(rows or {}) do rise = math.max(rise, rows[i][2] - rows[i - 1][2]) end
  tap.ok(rows and #rows > 50 and rise <= 1e-8 * rows[1][2] and rows[#rows][2] < 0.9 * rows[1][2],
    "ball, c = 20000 s/m: the energy only falls", string.format("%.2g of %.2g", rise, rows and rows[1][2] or 0))
end

-- Largest difference from the library's motion, in units of the largest number of the row.
local function difference(path, at, tolerance, real)
  local a, said = run(path, "--at " .. at)
  local other = "--at " .. at .. " " .. emitted .. tolerance .. (real and " --real " .. real or "")
  local c, failed = run(path, other)
  if not a or not c then return math.huge, said or failed end
  local d, size = 0.0, 1.0
  for k = 2, #a[1] do
    d = math.max(d, math.abs(a[1][k] - c[1][k]))
    size = math.max(size, math.abs(a[1][k]))
  end
  return d / size
end

local damped = written("damped", [[
return scene { name = "damped", body = solid.box { x = 1, y = 2, z = 3, mass = 6 },
  effects = { effect.damping { c = { 0, 0, 1e4 } }, effect.torque { body = { 3, 0, 2 } } },
  initial = { omega = { 1, 2, 3 } }, time = { horizon = 2 } }
]])
local pivot = written("pivot", [[
return scene { name = "pivot", body = solid.box { x = 1, y = 2, z = 3, mass = 6 },
  effects = { effect.friction { torque = 3, smoothing = 1e-3 } }, initial = { omega = { 0.02, 0.01, 0.05 } },
  time = { horizon = 1 } }
]])
-- A step is wrong by the tolerance, and a motion has some tens of steps that matter: 100 tolerances.  Of order 5 the
-- number of steps grows as tolerance^(-1/5), 6.3 times from 1e-5 to 1e-9, so the error falls by 1e4/6.3 at least.
for _, s in ipairs { { "bodies/egg.lua", "0.2" }, { "bodies/tippe_top.lua", "0.2" }, { "bodies/rattleback.lua", "0.5" },
  { "bodies/kapitza.lua", "1" }, { "bodies/thrown_book.lua", "1" }, { damped, "0.5" }, { pivot, "0.3" } } do
  local coarse, said = difference(s[1], s[2], "1e-5")
  local fine = difference(s[1], s[2], "1e-9")
  tap.ok(coarse <= 1e-3 and fine <= 1e-7 and fine < coarse / 1000, s[1]:match "[^/]*$" ..
    ": the error follows the tolerance",
    said or string.format("%.2g at 1e-5, %.2g at 1e-9", coarse, fine))
end
-- After a second the slip is over, and what is left has the error of the steps in which it was large: 10 tolerances.
local single, said = difference(ball(200), "1", "1e-5", "float")
tap.ok(single <= 1e-4, "ball, c = 200 s/m, float", said or string.format("%.2g", single))

-- ---- what compilers say ----

local strict = "-std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror -fsyntax-only"
for _, real in ipairs { "double", "float" } do
  local out = dir .. "/code_" .. real
  program.shell(string.format("POLHODE_SOURCE=. %s gen %s --method rosenbrock --real %s -o %s > /dev/null", binary,
    ball(200), real, out))
  local plus = "g++ -std=c++11 -Wall -Wextra -Werror -fsyntax-only -x c++"
  for _, cc in ipairs { "gcc " .. strict, "clang " .. strict, plus } do
    local status = program.shell(string.format("%s %s/ball.c > %s/said 2>&1", cc, out, dir))
    tap.is(status, 0, real .. ": " .. cc:match "%S+" .. " has nothing to say", program.read(dir .. "/said"))
  end
end

tap.done(program.finish())
