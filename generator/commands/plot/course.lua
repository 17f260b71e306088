-- course.lua -- the motion that is drawn: by the engines of `polhode run`, or from rows that it wrote.
-- SPDX-License-Identifier: GPL-3.0-or-later

local accuracy = require "generator.commands.run.accuracy"
local bounce = require "generator.commands.run.bounce"
local columns = require "generator.commands.run.columns"
local engines = require "generator.commands.run.engines"
local limits = require "generator.commands.run.limits"
local touch = require "generator.commands.run.touch"
local events = require "generator.commands.events"
local options = require "generator.commands.options"
local facts = require "generator.report.facts"
local rotation = require "generator.attitude.rotation"
local units = require "generator.dsl.units"
local contact = require "generator.dynamics.contact"
local happenings = require "generator.dynamics.happenings"
local err = require "generator.plan.error"
local panels = require "generator.plot.panels"
local sampling = require "generator.plot.sampling"
local times = require "generator.plot.times"

local course = {}

local rows_of_difference, judged_at = 400, 40

-- Where q, w, r, v and further states are in a scene's state.  Those of a plane are not among them: they are the centre
-- of mass, which a sample has in space.
local function places(job)
  local at, plane = { own = {} }, contact.of(job.model)
  for i, s in ipairs(job.states) do
    local part = ({ attitude = "q", rates = "w", position = "r", velocity = "v" })[s.kind]
    if part then
      at[part] = at[part] or {}
      table.insert(at[part], i)
    elseif not (plane and s.effect == plane) then
      table.insert(at.own, i)
    end
  end
  return at
end

local function part(x, places_of)
  local list = {}
  for n, i in ipairs(places_of) do list[n] = x[i] end
  return list
end

-- The inertia times a vector along the body's axes.
local function times_inertia(I)
  return function(v)
    return { I[1] * v[1] + I[4] * v[2] + I[5] * v[3], I[4] * v[1] + I[2] * v[2] + I[6] * v[3],
      I[5] * v[1] + I[6] * v[2] + I[3] * v[3] }
  end
end

-- What the pictures know of the body: of its states, effects and laws.
local function of_scene(job, given)
  local m = job.model
  local c = { conserved = given.ground and {} or job.conserved.is, -- an impact keeps nothing
    sequence = given.sequence or "zxz", plane = touch.plane(job), framed = m.frame and true }
  if not m.has.rates then return c end
  local f = facts.of(job)
  c.body = { moments = f.moments, axes = f.axes, kind = m.structure.kind, rod = m.structure.rod }
  if m.structure.kind == "symmetric" then
    c.body.k = {}
    for i = 1, 3 do c.body.k[i] = m:double(m.structure.k[i]) end
  end
  c.along = times_inertia(f.inertia_number)
  function c.momentum(s) return s.q and s.L and rotation.back(s.q, s.L) or c.along(s.w) end
  local simple, carriers = not m.frame, { ["effect.rotor"] = true, ["effect.wheel"] = true }
  for _, e in ipairs(m.record.effects) do -- these have kinetic energy of their own, or change the body's
    c.carries = c.carries or carriers[e.kind]
    simple = simple and not (carriers[e.kind] or e.kind == "effect.inertia_rate" or e.kind == "effect.custom")
  end
  local mass = f.mass_number
  if simple then
    function c.kinetic(s)
      local L, sum = c.along(s.w), 0.0
      for i = 1, 3 do sum = sum + L[i] * s.w[i] / 2 + (s.v and mass * s.v[i] ^ 2 / 2 or 0.0) end
      return sum
    end
  end
  return c
end

-- A function of times: samples of the motion, with the values of the columns that --what asks for; nil and a failure.
local function looker(host, job, given, motion, inputs)
  local at, seen = places(job), touch.seen(host, job, motion, inputs, given.ground)
  local wanted = given.wanted or {}
  local sample = columns.sampler(host, job, { course = inputs, ground = given.ground })
  return function(ts)
    local out, failure = seen(ts)
    for i, state in ipairs(out or {}) do
      local k = state.contact
      local s = { t = state.t, x = state.x, energy = state.energy, L = job.model.has.attitude and state.L or nil,
        own = part(state.x, at.own), asked = {} }
      for _, name in ipairs { "q", "w", "r", "v" } do s[name] = at[name] and part(state.x, at[name]) end
      if k then s.N, s.r, s.v, s.point = k[1], part(k, { 2, 3, 4 }), part(k, { 5, 6, 7 }), part(k, { 11, 12, 13 }) end
      local from = #wanted > 0 and sample(state.t, state.x, state.energy, state.L, state.on)
      for n, c in ipairs(wanted) do
        s.asked[n] = c.f(from)
        if s.asked[n] - s.asked[n] ~= 0 then
          return nil, { status = 3, t = s.t, text = c.name .. " is not finite" }
        end
      end
      out[i] = panels.complete(s)
    end
    return out, failure
  end
end

-- Samples of the motion up to `finish`, of one by fixed steps after whole steps; or nil and a failure.
local function looked(look, finish, step)
  if step then return look(sampling.steps(finish, step)) end
  return sampling.adaptive(look, finish)
end

-- Differences of two runs of courses at common times: {ts, curves}; or nil and a failure.
function course.difference(first, second)
  local a, b = first.motion, second.motion
  local ts, finish, step = {}, math.min(first.finish, second.finish), math.max(a.step or 0, b.step or 0)
  if step > 0 then
    ts = sampling.steps(finish, step)
  else
    for i = 0, rows_of_difference do ts[i + 1] = finish * (i / rows_of_difference) end
  end
  local states = {}
  for n, motion in ipairs { a, b } do
    local rows, failure = motion.solve(ts, {})
    if not rows then return nil, failure end
    states[n] = err.states(rows)
  end
  local groups, curves = err.groups(first.job), {}
  local scales = err.scales(groups, states[2])
  for n, g in ipairs(groups) do
    local values = {}
    for i = 1, #ts do values[i] = err.distance(g, scales[n], states[1][i], states[2][i]) end
    curves[n] = { name = g.name, values = values }
  end
  return { ts = ts, curves = curves }
end

-- Appends what run would say of the motion's accuracy, at its end and of the linearised one at some times.
local function judged(host, job, motion, samples, warnings)
  local ts = {}
  for i = #samples, 1, -math.max(1, #samples // judged_at) do table.insert(ts, 1, samples[i].t) end
  if motion.step then ts = { ts[#ts] } end -- at every row a step would end
  local states = motion.solve(ts, {})
  warnings[#warnings + 1] = states and accuracy.warning(job, motion, ts, states, function()
    return engines.general(host, job, { method = "exact" })
  end) or nil
end

-- A course of the scene: nil, a failure of run/engines.lua.  Second result: warnings.  given: of one run; finish: the
-- end of what is drawn; inputs: over time, or nil; alone: is it all that is drawn, so that its accuracy is told?
function course.compute(host, job, given, finish, inputs, alone)
  local warnings = {}
  local motion, failure = bounce.motion(host, job, given, inputs)
  if not motion then return nil, failure end
  local wrong = limits.exceeded(motion, { finish }, given)
  if wrong then return nil, { command = true, text = wrong } end
  local c = of_scene(job, given)
  local when
  when, failure = events.ending(host, job, motion, finish, inputs)
  if when == false then return nil, failure end
  if when then
    finish = when.row.t
    c.lost = when.event.reaction and finish or nil
    warnings[1] = happenings.at(when.said, times.number(finish)) .. "; what is drawn ends there\n"
  end
  local samples
  samples, failure = looked(looker(host, job, given, motion, inputs), finish, motion.step)
  if not samples then return nil, failure end
  local last = samples[#samples].t
  if last < finish * (1 - 1e-9) then
    warnings[#warnings + 1] = "the motion bends too often to be drawn to the end: it is to t = " ..
      times.number(last) .. " s\n"
  end
  if alone then judged(host, job, motion, samples, warnings) end
  c.samples, c.motion, c.finish, c.job = samples, motion, finish, job
  return c, warnings
end

-- ---- rows of a file ----

local parts = { energy = { "energy", unit = "J" }, N = { "N", unit = "N" },
  q = { "qw", "qx", "qy", "qz", unit = "1" }, w = { "wx", "wy", "wz", unit = "rad/s" },
  r = { "rx", "ry", "rz", unit = "m" }, v = { "vx", "vy", "vz", unit = "m/s" },
  L = { "Lx", "Ly", "Lz", unit = "N m s" },
  point = { "contact_point_x", "contact_point_y", "contact_point_z", unit = "m" } }
local vectors = { "energy", "N", "q", "w", "r", "v", "L", "point" }
local still_touches = 1e-6 -- of the largest reaction: where contact is lost, run's last row has 0 but for rounding

-- The columns of a file that --what names beside the pictures: {{name =, unit =}, ...}, or nil and what is wrong.
function course.column(f, name)
  local place = f.at[name]
  if place then return { { name = name, unit = f.units[place] } } end
  return nil, "--what: the file has no column " .. name .. options.meant(name, { "t", table.unpack(f.names) })
end

-- A course of the rows that run wrote, f (of csv.open), with the body of the scene if there is one: nil and what is
-- wrong.
function course.read(f, job, given)
  local wrong
  local columns_of, there = {}, {}
  for _, p in ipairs(vectors) do
    local list, dim = {}, select(2, units.parse(parts[p].unit))
    for _, name in ipairs(parts[p]) do
      list[#list + 1] = f.at[name] and { name = name, dim = dim, needed = true } or nil
    end
    if #list == #parts[p] then
      there[#there + 1] = { part = p, before = #columns_of, size = #list }
      table.move(list, 1, #list, #columns_of + 1, columns_of)
    end
  end
  local states = #columns_of
  for _, c in ipairs(given.wanted or {}) do columns_of[#columns_of + 1] = { name = c.name, needed = true } end
  local n
  n, wrong = f:read(columns_of, true, 2)
  if not n then return nil, wrong end
  local ts, numbers, samples = f.object:values(0), {}, {}
  for i in ipairs(columns_of) do numbers[i] = f.object:values(i) end
  for i = 1, n do
    local s = { t = ts[i], asked = {} }
    for k = states + 1, #columns_of do s.asked[k - states] = numbers[k][i] end
    for _, p in ipairs(there) do
      local v = {}
      for k = 1, p.size do v[k] = numbers[p.before + k][i] end
      s[p.part] = p.size > 1 and v or v[1]
    end
    samples[i] = panels.complete(s)
  end
  local c = job and of_scene(job, given) or { conserved = {}, sequence = given.sequence or "zxz" }
  c.samples, c.column = samples, true
  local largest = 0.0
  for _, s in ipairs(samples) do largest = math.max(largest, math.abs(s.N or 0.0)) end
  if largest > 0 and math.abs(samples[n].N) < still_touches * largest then c.lost = samples[n].t end
  return c
end

return course
