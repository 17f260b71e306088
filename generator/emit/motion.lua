-- motion.lua -- expected states of the closed form for the emitted self-test.
--
-- The scene's own motion at some times by dynamics/free_top.lua (any moments) or dynamics/closed/precise.lua (sphere,
-- symmetric top).  A tolerance is `roundings` units of the type's epsilon, of 1 for q and of the largest rate for w:
-- the phases are formed in pairs and rounded once.  Where the C code computes a moment from parameters, it may be off
-- by its own tolerance: each is moved by that, and what the state moves by (twice, the two sides need not be alike) is
-- added.  So for a scene without parameters nothing grows with time.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local precise = require "generator.dynamics.closed.precise"
local free_top = require "generator.dynamics.free_top"
local orbit = require "generator.emit.orbit"
local selftest = require "generator.emit.selftest"

local motion = {}

local bits, coarse = 160, 64 -- of a state, and of a difference of states

-- The motion as a function of its uncertain inputs: a list {value, uncertainty}, and at(values, bits) -> a function of
-- the time that gives the state, or nil.
local function general(job, x0, env, epsilon, round)
  local inputs, entries = {}, nil
  for _, f in ipairs(job.functions) do
    if f.name == "inertia" then entries = f end
  end
  local want, tolerance = selftest.expect(entries, env, {}, function(o) return o.index + 1 end, epsilon)
  for i, e in ipairs(job.model.inertia) do
    inputs[i] = { round(want[i]), e.kind == "num" and R.zero or R.round(tolerance[i], 8) }
    if not inputs[i][1] then return nil end
  end
  local slack = epsilon * R.new(8)
  return inputs, function(values, n)
    local top = free_top.new(values, x0, n, slack)
    return top and function(t) return top:at(t) end
  end
end

-- Sphere and symmetric top: the moments across and along the axis, and the rates by a factor.
local function regular(job, x0, params, epsilon)
  local s = job.model.structure
  local function value(e) return evaluate.precise(e, params, bits) end
  local several = epsilon * R.new(selftest.roundings)
  local inputs, k = { { R.one, several } }, nil
  if s.kind == "symmetric" then
    k = { value(s.k[1]), value(s.k[2]), value(s.k[3]) }
    local alpha, axial = value(s.alpha), s.rod and R.zero or value(s.axial)
    inputs[2], inputs[3] = { alpha, alpha * several }, { axial, axial * several }
  end
  return inputs, function(values, n)
    local factor, alpha, axial = values[1], values[2], values[3]
    return function(t) return precise(alpha, axial, k, x0, factor * t, n) end
  end
end

-- Calls of the closed form {call, what, time}: the first has been set up by NAME_solve.
local function calls(v, times)
  local p, list = v.name .. "_", {}
  for i, t in ipairs(times) do
    local text = string.format("at time %d", i)
    list[#list + 1] = { call = p .. "at(&o, " .. v.number(t) .. ", got)", what = "closed form " .. text, time = t }
    if v.has_own then
      list[#list + 1] = { call = p .. "at(&" .. p .. "own_orbit, " .. v.number(t) .. ", got)",
        what = "the constant orbit " .. text, time = t }
    end
  end
  if v.has_ticks then
    local t = times[#times]
    list[#list + 1] = { call = string.format("(void)%sset_tick(&o, %s); %sat_tick(&o, 262144, got)", p,
      v.number(t / 262144), p), what = "closed form after 262144 ticks", time = t }
  end
  if v.has_own then
    list[#list + 1] = { call = string.format("%sat_tick(&%sown_orbit, 3145728, got)", p, p),
      what = "the constant orbit after 3145728 steps", time = v.step * 3145728 }
  end
  return list
end

-- The motion and the same with one uncertain input moved each; nil if there is no such motion.
local function neighbours(inputs, at)
  local values = {}
  for i, p in ipairs(inputs) do values[i] = p[1] end
  local function moved(i, by)
    local list = { table.unpack(values) }
    list[i] = list[i] + by
    return at(list, coarse)
  end
  local main, others = at(values, bits), {}
  if not main then return nil end
  for i, p in ipairs(inputs) do
    if R.sign(p[2]) ~= 0 then
      others[#others + 1] = moved(i, p[2])
      if not others[#others] then return nil end
    end
  end
  return main, #others > 0 and moved(1, R.zero), others
end

-- State and tolerances at the time t; nil if they are too wide to test anything.
local function expected(t, size, epsilon, main, base, others)
  local want, tolerance = main(t), {}
  for i = 5, 7 do size = R.abs(want[i]) > size and R.abs(want[i]) or size end
  for i = 1, 7 do tolerance[i] = (i > 4 and size or R.one) * epsilon * R.new(selftest.roundings) end
  if base and R.sign(t) ~= 0 then
    local here = base(t)
    for _, other in ipairs(others) do
      local there = other(t)
      for i = 1, 7 do tolerance[i] = tolerance[i] + R.new(2) * R.abs(there[i] - here[i]) end
    end
  end
  for i = 1, 7 do
    if tolerance[i] > (i > 4 and size or R.one) / R.new(64) then return nil end
    tolerance[i] = R.round(tolerance[i], 24)
  end
  return { want = want, tolerance = tolerance }
end

-- The cases {want, tolerance (rationals), call, what}.  about: {job, x0, power (of two, near the largest rate), env,
-- params, epsilon, real, name, has_own, has_ticks, number (prints)}
function motion.cases(about)
  local job, x0, round = about.job, about.x0, orbit.rounder(about.real)
  local kind, inputs, at = job.closed.kind, nil, nil
  if kind == "asymmetric" then
    inputs, at = general(job, x0, about.env, about.epsilon, round)
  elseif kind == "sphere" or kind == "symmetric" then
    inputs, at = regular(job, x0, about.params, about.epsilon)
  end
  if not inputs then return {} end
  -- some radians and some thousand; a body so slow that the type cannot count its time gets none
  local times = { R.zero, R.new(5, 8) / about.power, R.new(4096) / about.power }
  for _, t in ipairs { times[3], times[3] / 262144 } do
    if round(t) ~= t then return {} end
  end
  local main, base, others = neighbours(inputs, at)
  if not main then return {} end
  local size = R.zero
  for i = 5, 7 do size = R.abs(x0[i]) > size and R.abs(x0[i]) or size end
  about.step = round(job.model:number(job.model.step)) or R.zero
  local list, known = {}, {}
  for _, c in ipairs(calls(about, times)) do
    local k = known[c.time]
    if k == nil then k = expected(c.time, size, about.epsilon, main, base, others) or false end
    known[c.time] = k
    if k then list[#list + 1] = { want = k.want, tolerance = k.tolerance, call = c.call, what = c.what } end
  end
  return list
end

return motion
