#!/usr/bin/env lua5.4
-- identities.t - docs/mechanics.md holds for every effect and for pairs of them: torque, power, dL/dt, laws.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Everything is evaluated in 200 bits at states, inputs and parameters without a pattern, so that what is equal is
-- equal to 1e-40.  The torque from outside is the sum of what the effects that act from outside say; the equations of
-- motion and the functions that are emitted must give the same back:
--     NAME_torque(x, w')          = N
--     dL/dt, from NAME_momentum   = R N          (in a frame that turns: less Omega x L)
--     dT/dt                       = w.N + v.F + u W - w.D' w/2 - k |L x w|^2
-- and a law that is not claimed of an effect alone does vary.  What a plane adds: newton.t.
-- The quick tier takes every fourth scene.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local vec = require "generator.algebra.vec"
local context = require "generator.dynamics.context"
local derivative = require "generator.dynamics.derivative"
local equations = require "generator.dynamics.equations"
local quantities = require "generator.dynamics.quantities"
local state = require "generator.dynamics.state"
local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"
local exact = require "tests.effects.exact"
local scenes = require "tests.effects.scenes"

local BITS, CLOSE = exact.BITS, R.new(1, 10) ^ 40

exact.seed(271828)

-- What description f gives, entry by entry, at the values; more: further names.
local function asked(f, env, more)
  local here, out = setmetatable(more or {}, { __index = env }), {}
  for _, g in ipairs(f.groups) do
    for _, o in ipairs(g.outs) do
      out[(o.index or 0) + 1] = evaluate.precise(equations.inline(f.groups, o.expr), here, BITS)
    end
  end
  return out
end

local function close(a, b, size) return R.abs(a - b) <= CLOSE * (R.one + R.abs(a) + R.abs(b) + (size or R.zero)) end
local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end
local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end

local zero = { expr.zero, expr.zero, expr.zero }

-- Sums over the effects as expressions: the torque from outside, the force, the power of what is inside.
local function acting(m)
  local N, F, power, c = zero, zero, expr.zero, context.of(m)
  for _, e in ipairs(m.record.effects) do
    local own = context.with(c, e)
    if not (e.spec.momentum or e.spec.varies or e.spec.turn) then
      if e.spec.torque then N = vec.add(N, e.spec.torque(e.a, own)) end
    elseif e.kind == "effect.wheel" then -- u W: the torque is -u a, W a the speed
      local axis = vec.map(e.a.axis, function(x) return x / expr.sqrt(vec.dot(e.a.axis, e.a.axis)) end)
      power = power - vec.dot(e.spec.torque(e.a, own), axis) * e.own.wheel
    elseif e.spec.varies then -- torque: -D' w
      power = power + vec.dot(e.spec.torque(e.a, own), state.w) / 2
    elseif e.spec.turn then -- torque: L x slip, slip = k L x w
      power = power + vec.dot(e.spec.torque(e.a, own), state.w)
    end
    if m.has.position and e.spec.force then F = vec.add(F, e.spec.force(e.a, own)) end
  end
  return N, F, power
end

local function check(name, job)
  local eq = equations.fork(job.equations)
  local m = eq.model
  local torque, momentum, energy = quantities.torque(m), quantities.momentum(m), quantities.energy(m)
  local N, F, inner = acting(m)
  local turn = m.frame and m.frame.spec.frame(m.frame.a, context.of(m))
  local env, params = exact.values(m)
  local function value(e) return exact.value(e, env, params) end
  local rates = exact.rates(eq, value)
  local outside = vec.map(N, value)
  local w, dw = vec.map(state.w, value), { rates.wx, rates.wy, rates.wz }
  local more = {}
  for i, k in ipairs { "x", "y", "z" } do more["dw" .. k], more["w" .. k] = dw[i], w[i] end
  local got, size = asked(torque, env, more), R.zero
  for i = 1, 3 do size = size + R.abs(got[i]) end
  local same = true
  for i = 1, 3 do same = same and close(got[i], outside[i], size) end
  tap.ok(same, name .. ": NAME_torque of the accelerations is the torque from outside")

  -- derivatives along the equations
  local function slope(f, index)
    local sum = R.zero
    for _, g in ipairs(f.groups) do
      for _, o in ipairs(g.outs) do
        if (o.index or 0) == index then
          local e = equations.inline(f.groups, o.expr)
          for _, s in ipairs(m.states) do
            sum = R.round(sum + value(calculus.diff(e, s.sym)) * (rates[s.name] or R.zero), BITS)
          end
          sum = sum + value(calculus.diff(e, state.t))
        end
      end
    end
    return sum
  end
  local L, spin = asked(momentum, env), vec.map(vec.matvec(vec.rotation(state.q), N), value)
  if turn then spin = vec.sub(spin, cross(vec.map(vec.add(turn.rate, vec.scale(state.t, turn.rate_dot)), value), L)) end
  same = true
  for i = 1, 3 do same = same and close(slope(momentum, i - 1), spin[i], size) end
  tap.ok(same, name .. ": dL/dt is the torque from outside, in the base's axes")
  if not (turn and m.has.position) then
    local power = dot(w, outside) + value(inner)
    if m.has.position then power = power + dot(vec.map(state.v, value), vec.map(F, value)) end
    local change = slope(energy, 0)
    local V = { groups = { { defs = {}, outs = { { expr = context.potential(m) } } } } }
    tap.ok(close(change - slope(V, 0), power, size), name .. ": dT/dt is the power of all that acts")
  end
end

local function alone(name, job)
  local holds, wrong = derivative.of(job.equations), {}
  for _, law in ipairs { "T+V", "|L|", "L", "L_z" } do
    if holds(law) ~= job.conserved.is[law] then wrong[#wrong + 1] = law end
  end
  tap.is(table.concat(wrong, " "), "", name .. ": what is claimed holds, what is not varies")
end

local n = 0
for i, a in ipairs(scenes.variants) do
  for j = i, #scenes.variants do
    local list = i == j and { a } or { a, scenes.variants[j] }
    local pair = (i * 7 + j) % 9 == 0 and not (a.where == "plane" or scenes.variants[j].where == "plane")
    if (i == j or pair) and select(2, scenes.fits(list)) then
      n = n + 1
      if not tier.quick or n % 4 == 0 then
        local name = "e" .. n
        local body = ({ "diagonal", "symmetric", "full" })[n % 3 + 1]
        local text = scenes.text(scenes.new(n, 0.3), name, body, list)
        local job, why = scene.read(text)
        local what = table.concat(vec.map(list, function(v) return v.name end), " and ")
        if job and job.model.has.attitude then
          if not job.equations.touch then check(what, job) end
          if i == j then alone(what, job) end
        else
          tap.ok(false, what .. " is a scene", why)
        end
      end
    end
  end
end

tap.done()
