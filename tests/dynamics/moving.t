#!/usr/bin/env lua5.4
-- moving.t - translation and turning frames: equations, energy and the RK4 step, in exact arithmetic.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The generator writes - Omega x (2 v + Omega x r) and takes constants together; the book has each term on its own
-- (Landau, Lifshitz, Mechanics, 39.7).  At rational states and parameters both must be EQUAL.  So must the derivative
-- of the energy along the motion be zero, or the power of the drag, and the unrolled step be Kutta's four lines.
-- Drag has a root; there the numbers have 240 bits and agree to 200.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local equations = require "generator.dynamics.equations"

local BITS = 240

local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end
local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end
local function hamilton(p, s)
  return { p[1] * s[1] - p[2] * s[2] - p[3] * s[3] - p[4] * s[4], p[1] * s[2] + p[2] * s[1] + p[3] * s[4] - p[4] * s[3],
    p[1] * s[3] - p[2] * s[4] + p[3] * s[1] + p[4] * s[2], p[1] * s[4] + p[2] * s[3] - p[3] * s[2] + p[4] * s[1] }
end

-- Parameters as they are named in the scenes below, and the same numbers for the book.
local p = { M = R.new(3), g = R.new(7), h = R.lift "1/3", c = R.lift "1/5", l = R.lift "2/7", k = R.new(5),
  O = R.lift "1/2", P = R.lift "-3/4", A = R.lift "1/8" }
local head = "local M = param(\"M\", 3, \"kg\")\n"
for _, line in ipairs { 'g = param("g", 7, "m/s^2")', 'h = param("h", 1, "m/s^2")/3', 'c = param("c", 1, "kg/m")/5',
  'l = param("l", 2, "kg/s")/7', 'k = param("k", 5, "N/m")', 'O = param("O", 1, "1/s")/2',
  'P = -3*param("P", 1, "1/s")/4', 'A = param("A", 1, "1/s^2")/8' } do
  head = head .. "local " .. line .. "\n"
end

local BODY = "solid.box { x = 2, y = 3, z = 5, mass = M }"
local zero = { R.zero, R.zero, R.zero }

-- {name, effects, initial, what the book takes: gravity, drag, linear, stiffness, rate, rate_dot, centrifugal}
local scenes = {
  { "gravity", "effect.translation { gravity = g }", g = { R.zero, R.zero, -p.g } },
  { "gravity aslant", "effect.translation { gravity = {h, 0, g} }", g = { p.h, R.zero, p.g } },
  { "drag", "effect.translation { gravity = g, drag = c, linear = l }", g = { R.zero, R.zero, -p.g },
    c = p.c, l = p.l },
  { "springs", "effect.translation { gravity = 0, stiffness = {k, 2*k, 0} }", k = { p.k, p.k + p.k, R.zero } },
  { "a frame about z", "effect.translation { gravity = g, stiffness = k }, effect.rotating_frame { rate = {0, 0, O} }",
    g = { R.zero, R.zero, -p.g }, k = { p.k, p.k, p.k }, O = { R.zero, R.zero, p.O }, centrifugal = true },
  { "a frame aslant", "effect.translation { gravity = {h, 0, g} }, effect.rotating_frame { rate = {O, P, 2} }",
    g = { p.h, R.zero, p.g }, O = { p.O, p.P, R.new(2) }, centrifugal = true },
  { "without the centrifugal term", "effect.translation { gravity = g }, " ..
    "effect.rotating_frame { rate = {O, P, 2}, centrifugal = false }", g = { R.zero, R.zero, -p.g },
    O = { p.O, p.P, R.new(2) } },
  { "a frame that gains speed", "effect.rotating_frame { rate = {O, 0, P}, rate_dot = {0, A, 1} }",
    O = { p.O, R.zero, p.P }, A = { R.zero, p.A, R.one }, centrifugal = true },
  { "all at once", "effect.translation { gravity = {h, g, 0}, drag = c, linear = l, stiffness = {k, 0, k} }, " ..
    "effect.rotating_frame { rate = {O, P, 2}, rate_dot = {A, 0, -A} }", g = { p.h, p.g, R.zero }, c = p.c, l = p.l,
    k = { p.k, R.zero, p.k }, O = { p.O, p.P, R.new(2) }, A = { p.A, R.zero, -p.A }, centrifugal = true },
}

-- The book's rates of r, v and q at time t; w is the body's own.
local function book(s, x, t)
  local r, v, O, A = { x.rx, x.ry, x.rz }, { x.vx, x.vy, x.vz }, {}, s.A or zero
  for i = 1, 3 do O[i] = (s.O or zero)[i] + A[i] * t end
  local speed = s.c and R.apply("sqrt", BITS, dot(v, v) + R.new(2) ^ -126) or R.zero
  local coriolis, euler, centrifugal = cross(O, v), cross(A, r), cross(O, cross(O, r))
  local out = { rx = v[1], ry = v[2], rz = v[3] }
  for i, name in ipairs { "vx", "vy", "vz" } do
    local F = (s.g or zero)[i] * p.M - (s.k or zero)[i] * r[i] - ((s.c or R.zero) * speed + (s.l or R.zero)) * v[i]
    out[name] = F / p.M - R.new(2) * coriolis[i] - euler[i] - (s.centrifugal and centrifugal[i] or R.zero)
  end
  if x.qw then
    local q = { x.qw, x.qx, x.qy, x.qz }
    local a, b = hamilton(q, { R.zero, x.wx, x.wy, x.wz }), hamilton({ R.zero, O[1], O[2], O[3] }, q)
    for i, name in ipairs { "qw", "qx", "qy", "qz" } do out[name] = (a[i] - b[i]) / R.new(2) end
    local w, I = { x.wx, x.wy, x.wz }, { R.lift "17/2", R.lift "29/4", R.lift "13/4" } -- M/12 (34, 29, 13)
    for i, name in ipairs { "wx", "wy", "wz" } do
      local j, k = i % 3 + 1, (i + 1) % 3 + 1
      out[name] = (I[j] - I[k]) / I[i] * w[j] * w[k]
    end
  end
  return out
end

local point = { rx = "1/2", ry = "-2/3", rz = "3/7", vx = "2", vy = "-1/4", vz = "5/6" }
local turn = { qw = "1/2", qx = "-1/2", qy = "1/2", qz = "1/2", wx = "3/4", wy = "-5/8", wz = "9/16" }
local time = R.lift "3/5"

-- equal, or to 200 bits where there is a root
local function same(a, b, s)
  if not s.c then return a == b end
  local d = R.abs(a - b)
  return R.sign(d) == 0 or R.log2(d) < R.log2(R.abs(b) + R.one) - 200
end

for _, s in ipairs(scenes) do
  for _, turns in ipairs { false, true } do
    local initial = "initial = { position = {1, 0, 0}" .. (turns and ", omega = {1, 2, 3}" or "") .. " }"
    local job, why = scene.read(head .. "return scene { name = \"b\", body = " .. BODY .. ", effects = {" .. s[2] ..
      "}, " .. initial .. " }")
    local name = s[1] .. (turns and ", a body" or ", a point")
    if not tap.ok(job, name .. ": is a scene", why) then break end
    job = scene.plan(job)
    local m, x = job.model, {}
    local env = { t = time, h = R.lift "1/16" }
    for k, q in pairs(m.defaults) do env[k] = q end -- into a table: order is lost anyway
    for k, q in pairs(point) do x[k] = R.lift(q) end -- so here
    for k, q in pairs(turns and turn or {}) do x[k] = R.lift(q) end -- and here
    local function value(e, with)
      if s.c then return evaluate.precise(e, with or env, BITS) end
      return evaluate.exact(e, with or env)
    end
    for _, member in ipairs(m.members) do env[member.name] = value(member.e) end
    for k, q in pairs(x) do env[k] = q end -- and here
    local want, got = book(s, x, time), {}
    for _, g in ipairs(job.equations.groups) do
      for _, o in ipairs(g.outs) do got[o.state] = value(equations.inline(job.equations.groups, o.expr)) end
    end
    local bad = {}
    for _, st in ipairs(job.states) do
      if not same(got[st.name], want[st.name], s) then bad[#bad + 1] = st.name end
    end
    tap.is(table.concat(bad, " "), "", name .. ": the book's equations")

    -- dE/dt = dE/dx . x': the power of the drag; with a changing rate there is no such law
    if not s.A then
      local E, dE = scene.description(job, "energy"), R.zero
      local e = equations.inline(E.groups, E.groups[#E.groups].outs[1].expr)
      for _, st in ipairs(job.states) do dE = dE + value(calculus.diff(e, st.sym)) * want[st.name] end
      local v = { x.vx, x.vy, x.vz }
      local speed = s.c and R.apply("sqrt", BITS, dot(v, v)) or R.zero
      local power = -((s.c or R.zero) * speed + (s.l or R.zero)) * dot(v, v)
      local agrees = dE == power or s.c and R.log2(R.abs(dE - power)) < -100
      tap.ok(agrees, name .. ": the energy changes by the drag's power")
    end

    -- Kutta's four lines; |q| = 1 here, so the step's own normalisation is by n = 1
    local h, k, y = env.h, {}, {}
    for stage = 1, 4 do
      local z, part = {}, stage == 1 and R.zero or stage == 4 and h or h / R.new(2)
      for _, st in ipairs(job.states) do
        z[st.name] = x[st.name] + (stage == 1 and R.zero or part * k[stage - 1][st.name])
      end
      k[stage] = book(s, z, time + part)
    end
    local stepped = {}
    for n, q in pairs(env) do stepped[n] = q end -- and here
    for _, g in ipairs(scene.description(job, "step").groups) do
      for _, d in ipairs(g.defs) do stepped[d.name] = value(d.expr, stepped) end
      for _, o in ipairs(g.outs) do y[o.state] = value(o.expr, stepped) end
    end
    bad = {}
    for _, st in ipairs(job.states) do
      local n = st.name
      local whole = x[n] + h * (k[1][n] + R.new(2) * (k[2][n] + k[3][n]) + k[4][n]) / R.new(6)
      if not same(y[n] or x[n], whole, s) then bad[#bad + 1] = n end
    end
    tap.is(table.concat(bad, " "), "", name .. ": the step is the classical Runge-Kutta method")
  end
end

tap.done()
