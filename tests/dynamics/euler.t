#!/usr/bin/env lua5.4
-- euler.t - the torque equation, Euler's equations for every structure of the tensor, effects and what they conserve.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The generator writes the equations in the least form that each structure allows; all of them must satisfy
--     I w' + w x I w = N,   q' = q (0, w)/2
-- identically in the state, the input and the parameters, with the torque N of each effect written out here from its
-- definition.  Proofs are by the normal form of rational functions (ratio.iszero), with no numbers and no tolerance.
-- The quick tier takes every fourth body.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"
local equations = require "generator.dynamics.equations"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local calculus = require "generator.algebra.calculus"
local text = require "generator.formula.text"
local context = require "generator.dynamics.context"

local function symbols(list)
  local v = {}
  for name in list:gmatch "%S+" do v[#v + 1] = expr.sym(name, 8) end
  return v
end

local q, w, u = symbols "qw qx qy qz", symbols "wx wy wz", symbols "ux uy uz"

local function lift(v)
  local out = {}
  for i, x in ipairs(v) do out[i] = expr.lift(x) end
  return out
end

local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end
local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end
local function plus(a, b) return { a[1] + b[1], a[2] + b[2], a[3] + b[3] } end
local function times(k, a) return { k * a[1], k * a[2], k * a[3] } end

local function apply(I, b)
  return { I[1] * b[1] + I[4] * b[2] + I[5] * b[3], I[4] * b[1] + I[2] * b[2] + I[6] * b[3],
    I[5] * b[1] + I[6] * b[2] + I[3] * b[3] }
end

local function hamilton(p, s)
  return { p[1] * s[1] - p[2] * s[2] - p[3] * s[3] - p[4] * s[4], p[1] * s[2] + p[2] * s[1] + p[3] * s[4] - p[4] * s[3],
    p[1] * s[3] - p[2] * s[4] + p[3] * s[1] + p[4] * s[2], p[1] * s[4] + p[2] * s[3] - p[3] * s[2] + p[4] * s[1] }
end

-- q* (0, b) q: an inertial vector in body axes; and q (0, b) q*: the way back
local function to_body(b)
  local p = hamilton(hamilton({ q[1], -q[2], -q[3], -q[4] }, { expr.zero, b[1], b[2], b[3] }), q)
  return { p[2], p[3], p[4] }
end
local function to_inertial(b)
  local p = hamilton(hamilton(q, { expr.zero, b[1], b[2], b[3] }), { q[1], -q[2], -q[3], -q[4] })
  return { p[2], p[3], p[4] }
end

local function vanishes(list, name)
  for i, e in ipairs(list) do
    if not ratio.iszero(e) then return tap.ok(false, name, "entry " .. i .. ": " .. text.of((ratio.tidy(e)))) end
  end
  return tap.ok(#list > 0, name)
end

-- ---- effects: scene text and torque ----

local effects = {
  { "free", "", function() return lift { 0, 0, 0 } end },
  { "control", "effect.control{}", function() return u end },
  { "constant torque in body axes", "effect.torque{body = {2, -3, 5}}", function() return lift { 2, -3, 5 } end },
  { "constant torque in inertial axes", "effect.torque{inertial = {2, -3, 5}}",
    function() return to_body(lift { 2, -3, 5 }) end },
  { "isotropic damping", "effect.damping{c = 0.7}", function() return times(expr.lift(-0.7), w) end },
  { "damping by axes", "effect.damping{c = {1, 2, 3}}", function() return { -w[1], -2 * w[2], -3 * w[3] } end },
  { "damping by a matrix", "effect.damping{c = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}", function()
    return { -(w[1] + 2 * w[2] + 3 * w[3]), -(4 * w[1] + 5 * w[2] + 6 * w[3]), -(7 * w[1] + 8 * w[2] + 9 * w[3]) }
  end },
  { "decay of L", "effect.damping{rate = 0.3}", function(m) return times(expr.lift(-0.3), apply(m.inertia, w)) end },
  { "gravity along (1, 2, -2)", "effect.gravity{g = 9.8, direction = {1, 2, -2}}", function(m)
    return cross(m.com, to_body(times(m.mass * expr.lift(9.8), lift { "1/3", "2/3", "-2/3" })))
  end },
  { "gravity and control and decay of L", "effect.gravity{g = 2}, effect.control{}, effect.damping{rate = 0.3}",
    function(m)
      local weight = cross(m.com, to_body(times(2 * m.mass, lift { 0, 0, -1 })))
      return plus(plus(weight, u), times(expr.lift(-0.3), apply(m.inertia, w)))
    end },
}

-- ---- bodies of each structure ----

-- Energy and momentum follow from the equations of motion, so one body a structure is enough for them: `whole`.
local abc = { "M", "a", "b", "c" }
local bodies = {
  { "sphere", "sphere", "solid.sphere { r = a, mass = M }", { "M", "a" }, whole = true },
  { "cylinder along z", "symmetric", "solid.cylinder { r = a, h = b, mass = M }", { "M", "a", "b" } },
  { "cylinder along x", "symmetric", "solid.cylinder { r = a, h = b, mass = M }:turned{axis = \"y\", angle = pi/2}",
    { "M", "a", "b" } },
  { "cylinder along y", "symmetric", "solid.cylinder { r = a, h = b, mass = M }:turned{axis = \"x\", angle = pi/2}",
    { "M", "a", "b" } },
  { "cylinder along (3, 0, 4)", "symmetric",
    "solid.cylinder { r = a, h = b, mass = M }:turned{quaternion = {2, 0, 1, 0}}", { "M", "a", "b" }, whole = true },
  { "cone about its apex", "symmetric", "solid.cone { r = a, h = b, mass = M }", { "M", "a", "b" }, 'origin = "apex"' },
  { "cube about its corner", "symmetric", "solid.box { x = a, y = a, z = a, mass = M }", { "M", "a" },
    'origin = "corner"' },
  { "rod along z", "rod", "rod.straight { length = a, mass = M }", { "M", "a" }, 'origin = "end"' },
  { "rod along (1, 2, 3)", "rod", "rod.between { from = {0, 0, 0}, to = {a, 2*a, 3*a}, mass = M }", { "M", "a" },
    'origin = "from"', whole = true },
  { "brick about its centroid", "diagonal", "solid.box { x = a, y = b, z = c, mass = M }", abc },
  { "brick about the middle of an edge", "full", "solid.box { x = a, y = b, z = c, mass = M }", abc,
    "origin = {0, -b/2, -c/2}", whole = true },
  { "brick about its corner", "full", "solid.box { x = a, y = b, z = c, mass = M }", abc, 'origin = "corner"' },
  { "brick about a point above", "diagonal", "solid.box { x = a, y = b, z = c, mass = M }", abc, "origin = {0, 0, c}",
    whole = true },
}

-- The torque equation read backwards, and what becomes of energy and momentum.
local function conserved(job, dw, N, rates, effect, name)
  local m = equations.fork(job.equations).model
  -- the torque equation read backwards: N = I w' + w x L, with these w' it gives N again
  local emitted = scene.results(job, scene.description(job, "torque")).N
  local map = {}
  for i, comp in ipairs { "x", "y", "z" } do map[expr.sym("dw" .. comp, 8)] = dw[i] end
  local back = {}
  for i = 1, 3 do back[i] = calculus.substitute(emitted[i], map) - N[i] end
  vanishes(back, name .. ": the emitted torque equation at these rates gives the effects' torque")

  -- energy and momentum
  local T = dot(w, apply(m.inertia, w)) / 2
  vanishes({ calculus.diff(T, w[1]) * dw[1] + calculus.diff(T, w[2]) * dw[2] + calculus.diff(T, w[3]) * dw[3]
    - dot(w, N) }, name .. ": dT/dt = w.N")
  local dL = { expr.zero, expr.zero, expr.zero }
  local L = to_inertial(apply(m.inertia, w))
  local along = { { q[1], rates.qw }, { q[2], rates.qx }, { q[3], rates.qy }, { q[4], rates.qz }, { w[1], dw[1] },
    { w[2], dw[2] }, { w[3], dw[3] } }
  for i = 1, 3 do
    for _, p in ipairs(along) do dL[i] = dL[i] + calculus.diff(L[i], p[1]) * p[2] end
  end
  vanishes(plus(dL, times(expr.lift(-1), to_inertial(N))), name .. ": dL/dt in inertial axes is the torque there")
  local V = context.potential(m)
  if effect:find "^gravity along" then
    local dV = expr.zero
    local map_back = {}
    for _, member in ipairs(m.members) do map_back[member.sym] = member.e end
    local plain = calculus.substitute(V, map_back)
    for _, p in ipairs(along) do dV = dV + calculus.diff(plain, p[1]) * p[2] end
    vanishes({ dV + dot(w, N) }, name .. ": dV/dt = -w.N along the motion")
    vanishes({ dot(dL, lift { 1, 2, -2 }) }, name .. ": L along the direction of gravity is conserved")
  else
    tap.ok(effect:find "gravity" or V == expr.zero, name .. ": there is no potential")
  end
end

for _, body in ipairs(tier.every(4, bodies)) do
  for _, effect in ipairs(effects) do
    local more = (body[5] and body[5] .. ", " or "") .. "effects = {" .. effect[2] .. "}"
    local name = body[1] .. ", " .. effect[1]
    local job, why = scene.body(body[3], body[4], more)
    local m = job and job.model
    local free = body[2] == "rod" and assert(scene.body(body[3], body[4], body[5])).model
    if free and not ratio.iszero(dot(free.structure.k, effect[3](free))) then
      -- about a rod's line a torque has no effect that could be computed: the scene must be refused
      tap.ok(not job and why:find("no torque may act along its line", 1, true), name .. ": is refused", why)
    elseif tap.ok(job, name .. ": is read", why) then
      local s = m.structure
      tap.is(s.rod and "rod" or s.kind, body[2], name .. ": structure " .. body[2])
      local plan = scene.plan(job)
      local rates = scene.rates(plan)
      local dw, N = { rates.wx, rates.wy, rates.wz }, effect[3](m)
      local residue = plus(plus(apply(m.inertia, dw), cross(w, apply(m.inertia, w))), times(expr.lift(-1), N))
      vanishes(residue, name .. ": I w' + w x I w = N identically")
      if s.rod then vanishes({ dot(s.k, dw) }, name .. ": the rate along the rod is kept") end
      vanishes({ rates.qw + dot(w, { q[2], q[3], q[4] }) / 2, rates.qx - (q[1] * w[1] + q[3] * w[3] - q[4] * w[2]) / 2,
        rates.qy - (q[1] * w[2] + q[4] * w[1] - q[2] * w[3]) / 2,
        rates.qz - (q[1] * w[3] + q[2] * w[2] - q[3] * w[1]) / 2 }, name .. ": q' = q (0, w)/2")

      if body.whole then conserved(plan, dw, N, rates, effect[1], name) end
    end
  end
end

-- ---- gravity about the centroid vanishes ----

do
  local job = scene.plan(assert(scene.body("solid.box { x = a, y = b, z = c, mass = M }", abc,
    "effects = {effect.gravity{}}")))
  local free = scene.plan(assert(scene.body("solid.box { x = a, y = b, z = c, mass = M }", abc)))
  local with, without = scene.rates(job), scene.rates(free)
  tap.ok(with.wx == without.wx and with.wy == without.wy and with.wz == without.wz,
    "gravity about the centroid: the equations are those of the free body")
  tap.ok(not job.equations.coupled, "gravity about the centroid: the rates do not depend on the attitude")
  tap.ok(context.potential(job.model) == expr.zero, "gravity about the centroid: the potential is constant")
  local code = scene.files(job)["b.c"]
  tap.ok(not code:find("Mgr", 1, true), "gravity about the centroid: nothing of it is emitted")
end

-- ---- limits of the control ----

do
  local job = scene.plan(assert(scene.body("solid.sphere { r = 1, mass = 2.5 }", {},
    "effects = {effect.control{max = 3}}")))
  local rates = scene.rates(job)
  local I = scene.exact(job.model.inertia[1], {})
  local right = true
  for _, value in ipairs { "-100", "-3.0001", "-3", "-2.9", "0", "1e-30", "2.5", "3", "3.5", "1e30" } do
    local x = R.parse(value)
    local clamped = x > R.new(3) and R.new(3) or x < R.new(-3) and R.new(-3) or x
    local env = { ux = x, uy = -x, uz = R.zero, wx = R.one, wy = R.one, wz = R.one }
    right = right and scene.exact(rates.wx, env) == clamped / I and scene.exact(rates.wy, env) == -clamped / I
  end
  tap.ok(right, "control with max = 3: each component is clamped, exactly, at ten values on both sides")
end

tap.done()
