#!/usr/bin/env lua5.4
-- newton.t - Newton's and Euler's laws and the law of contact hold for the equations of a body on a plane.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Every surface with every law (rows.lua), some beside other torques, in 200 bits at states without a pattern.  Only
-- the place of the centre of mass is taken from the emitted NAME_contact; the rest follows by differences of it:
--     V   its rate along the motion, which NAME_contact must give back, and A that of V
--     r   from the centre of mass to the contact point: the height h = -g.r of a convex body changes by -a.(r x g) as
--         the body turns about a, so r = g x (r x g) - h g
--     F = m (A - G),  N = n.F,  I w' + w x I w = torques + r x F + N T
--     rolling: V + w x r = U;  smooth: F = N n;  sliding: F = N (n - share (V + w x r - U))
-- Central differences of 1e-22 leave 1e-44 of third derivatives, which are up to 1e13 where a paraboloid is steep, and
-- of 200 bits 1e-38: bar 1e-28.
-- The quick tier takes every tenth scene.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local equations = require "generator.dynamics.equations"
local evaluate = require "generator.algebra.evaluate"
local quantities = require "generator.dynamics.quantities"
local context = require "generator.dynamics.context"
local contact = require "generator.dynamics.contact"
local state = require "generator.dynamics.state"
local vec = require "generator.algebra.vec"
local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"
local exact = require "tests.effects.exact"
local scenes = require "tests.effects.scenes"

local STEP, CLOSE = R.new(1, 10) ^ 22, R.new(1, 10) ^ 28
local BITS = exact.BITS

exact.seed(314159)

local function rounded(v) return vec.map(v, function(x) return R.round(x, BITS) end) end
local function dot(a, b) return R.round(a[1] * b[1] + a[2] * b[2] + a[3] * b[3], BITS) end
local function cross(a, b)
  return rounded { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end
local function add(a, b, factor) -- a + factor b
  return rounded { a[1] + (factor or R.one) * b[1], a[2] + (factor or R.one) * b[2], a[3] + (factor or R.one) * b[3] }
end
local function scaled(a, v) return rounded { a * v[1], a * v[2], a * v[3] } end
local function times(M, v) return rounded { dot(M[1], v), dot(M[2], v), dot(M[3], v) } end
local function flipped(M)
  return { { M[1][1], M[2][1], M[3][1] }, { M[1][2], M[2][2], M[3][2] }, { M[1][3], M[2][3], M[3][3] } }
end

-- What NAME_contact gives.
local function touched(f, env, params)
  local here = setmetatable({}, { __index = function(_, k) return env[k] or params[k] end })
  local out = { com = {}, velocity = {} }
  for _, g in ipairs(f.groups) do
    for _, o in ipairs(g.outs) do
      local x = evaluate.precise(equations.inline(f.groups, o.expr), here, BITS)
      if o.result then out.N = x else out[o.array][o.index + 1] = x end
    end
  end
  return out
end

-- Half the difference of fn(+STEP) and fn(-STEP) over STEP, of vectors.
local function slope(fn)
  local a, b = fn(STEP), fn(-STEP)
  return vec.map(a, function(x, i) return R.round((x - b[i]) / (R.new(2) * STEP), BITS) end)
end

local function check(name, job)
  local eq = equations.fork(job.equations)
  local m = eq.model
  local f, plane = quantities.contact(eq), contact.of(m)
  local a, N = plane.a, { expr.zero, expr.zero, expr.zero }
  for _, e in ipairs(m.record.effects) do
    if e ~= plane then N = vec.add(N, e.spec.torque(e.a, context.with(context.of(m), e))) end
  end
  local env, params = exact.values(m)
  local function value(e) return exact.value(e, env, params) end
  local function root(x) return evaluate.precise(expr.sqrt(expr.num(x)), {}, BITS) end
  local rates = exact.rates(eq, value)
  local function moved(change) -- the state after `change`, rates by name
    local there = setmetatable({}, { __index = env })
    for _, s in ipairs(m.states) do there[s.name] = env[s.name] + (change[s.name] or R.zero) end
    there.t = env.t + (change.t or R.zero)
    return touched(f, there, params)
  end
  local function along(key)
    return slope(function(h)
      local change = { t = h }
      for _, s in ipairs(m.states) do change[s.name] = h * rates[s.name] end
      return moved(change)[key]
    end)
  end
  local now = moved {}
  local mass, n, G = value(m.mass), vec.map(a.normal, value), vec.map(a.gravity, value)
  local w, dw = vec.map(state.w, value), { rates.wx, rates.wy, rates.wz }
  local turn = vec.map(vec.rotation(state.q), function(row) return vec.map(row, value) end)
  local back = flipped(turn)
  local V, A, g = along "com", along "velocity", times(back, n)
  local wrong = {}
  local function equal(x, y, what)
    local size, off = R.one, R.zero
    for i = 1, 3 do size, off = size + R.abs(x[i]) + R.abs(y[i]), off + R.abs(x[i] - y[i]) end
    if off > CLOSE * size then wrong[#wrong + 1] = what .. ": off by " .. R.todouble(off) end
  end
  equal(V, now.velocity, "the velocity of the centre of mass")
  -- r, from the height
  local q, turned = { env.qw, env.qx, env.qy, env.qz }, {}
  for i = 1, 3 do
    local axis = { R.zero, i == 1 and R.one or R.zero, i == 2 and R.one or R.zero, i == 3 and R.one or R.zero }
    local d = vec.qmul(q, axis)
    turned[i] = -slope(function(h)
      local half = h / R.new(2)
      return { dot(n, moved({ qw = half * d[1], qx = half * d[2], qy = half * d[3], qz = half * d[4] }).com) }
    end)[1]
  end
  local r = add(cross(g, turned), g, -dot(n, now.com))
  local F = scaled(mass, add(A, G, -R.one))
  equal({ dot(n, F), R.zero, R.zero }, { now.N, R.zero, R.zero }, "the reaction")
  -- Euler, with the resistances
  local T, spin = { R.zero, R.zero, R.zero }, dot(g, w)
  local function resist(given, rate, direction)
    if not given then return end
    local share = value(given.coulomb or given.viscous)
    if given.coulomb then share = share / root(rate + value(given.smoothing) ^ 2) end
    T = add(T, direction, -share)
  end
  local rate = value(a.rate)
  local roll = add(w, g, -spin)
  resist(a.spinning, (spin - rate) ^ 2, scaled(spin - rate, g))
  resist(a.rolling_resistance, dot(roll, roll), roll)
  local I = vec.map(m.inertia, value)
  local function apply(v)
    return rounded { I[1] * v[1] + I[4] * v[2] + I[5] * v[3], I[4] * v[1] + I[2] * v[2] + I[6] * v[3],
      I[5] * v[1] + I[6] * v[2] + I[3] * v[3] }
  end
  local torque = add(add(vec.map(N, value), cross(r, times(back, F))), T, now.N)
  equal(add(apply(dw), cross(w, apply(w))), torque, "Euler's law")
  -- the law of contact
  local P = add(now.com, times(turn, r))
  local slip = add(add(V, times(turn, cross(w, r))), cross(n, P), -rate)
  local zero = { R.zero, R.zero, R.zero }
  if a.law == "rolling" then
    equal(slip, zero, "no slip")
  else
    local share = R.zero
    if a.friction then
      share = value(a.friction.coulomb or a.friction.viscous)
      if a.friction.coulomb then share = share / root(dot(slip, slip) + value(a.friction.smoothing) ^ 2) end
    end
    equal({ dot(n, slip), R.zero, R.zero }, zero, "contact is kept")
    -- on a smooth level plane nothing says where the body is, and nothing pushes it aside
    equal(add(F, n, -now.N), scaled(-share * now.N, slip), "friction")
  end
  tap.is(table.concat(wrong, "; "), "", name)
end

local beside = {}
for _, v in ipairs(scenes.variants) do
  for _, name in ipairs { "damping_matrix", "torque_inertial", "spring_rest", "custom_torque", "control" } do
    if v.name == name then beside[#beside + 1] = v end
  end
end
local list = {}
for i, v in ipairs(scenes.variants) do
  if v.where == "plane" then
    for n, body in ipairs { "diagonal", "symmetric", "full" } do
      list[#list + 1] = { body = body, effects = (i + n) % 3 == 0 and { v, beside[i % #beside + 1] } or { v } }
    end
  end
end
-- A torque that other bodies of this kind take as products of the rates, and one of L, of each law.
local function named(name)
  for _, v in ipairs(scenes.variants) do
    if v.name == name then return v end
  end
end
for _, v in ipairs(scenes.variants) do
  if v.where == "plane" and v.name:find "^on_ellipsoid" then
    list[#list + 1] = { body = "diagonal", effects = { v, named "circular" } }
    list[#list + 1] = { body = "full", effects = { v, named "custom_torque" } }
  end
end
-- A disc about the axis of a body, which has equations in the axes of its lowest point: each law, on a level plane and
-- on a tilted one, with one more torque.
local function otherwise(v)
  return { name = v.name .. "_otherwise", effect = v.effect, where = v.where, text = function(s)
    local text, tilted = v.text(s):gsub(", normal = {[^}]*}", "")
    return tilted > 0 and text or text .. ", normal = " .. s:axes("0.1", "-0.2", "1", "polar")
  end }
end
for i, v in ipairs(scenes.variants) do
  if v.name:find "^on_disc" then
    list[#list + 1] = { body = "axial", effects = { v } }
    list[#list + 1] = { body = "axial", effects = { otherwise(v), beside[i % #beside + 1] } }
    list[#list + 1] = { body = "axial", effects = { otherwise(v) } }
  end
end
-- An ellipsoid of revolution and a sphere on the axis: their equations in the vectors g and z.
for i, contact_of in ipairs { "rolling\"", "smooth\"", "sliding\", friction = { viscous = 0.2 }" } do
  for _, body in ipairs { "axial", "diagonal" } do
    for _, text in ipairs { "ellipsoid { a = 2, b = 2, c = 2.3, at = {0, 0, 0.2} }",
      "sphere { r = 2, at = {0, 0, 0.2} }" } do
      local name = "revolved_" .. text:match "%a+"
      list[#list + 1] = { body = body, effects = { { name = name, effect = "plane", where = "plane",
        text = function() return "surface = contact." .. text .. ", law = \"" .. contact_of ..
          (i == 1 and ", turntable = 0.3" or "") end } } }
    end
  end
end
for n, item in ipairs(tier.every(10, list, 2)) do
  local what = table.concat(vec.map(item.effects, function(v) return v.name end), " and ") .. ", " .. item.body
  local job, why = scene.read(scenes.text(scenes.new(n, 0.3), "e" .. n, item.body, item.effects))
  if job then check(what, job) else tap.ok(false, what .. " is a scene", why) end
end
tap.ok(#list >= 92, #list .. " scenes on a plane")

tap.done()
