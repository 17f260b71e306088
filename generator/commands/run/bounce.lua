-- bounce.lua -- the motion of a body that flies and lands (effect.plane with impact), from those of its two phases.
--
-- A motion as engines.lua has them, of the states of the phase in the air.  It ends a flight where the lowest point
-- meets the plane, applies the library's impact, and goes on in the air; or on the plane, if that pushes and the point
-- leaves it so slowly that its next rise would be lost among the roundings of the body's height.  (A ball that keeps a
-- part e of its speed bounces without end in a finite time: what is left then is a sum of such rises.)  On the plane it
-- lifts off where the reaction becomes 0.
-- A state of the list has `on`, the state of the phase on the plane, where it is on it.
-- SPDX-License-Identifier: GPL-3.0-or-later

local vec = require "generator.algebra.vec"
local engines = require "generator.commands.run.engines"
local driver = require "generator.driver"
local happenings = require "generator.dynamics.happenings"
local motion = require "generator.dynamics.motion"
local numeric = require "generator.dynamics.numeric"

local bounce = {}
bounce.__index = bounce

local rounding = 2.0 ^ -52
local most = 100000 -- phases of one run
local lost = 64 -- roundings of the height: a rise of less is none
local slipping = 2.0 ^ -30 -- of the speeds of a body that rolls
local at_once = 100 -- of one instant
local parts, longest = 16, 256 -- of what is looked through at once: states

local function failed(t, text) return nil, { status = 3, t = t, text = text } end

local function part(list, first) return { table.unpack(list, first, first + 2) } end
local function norm(v) return math.sqrt(vec.dot(v, v)) end

-- ---- states of the two phases ----

local places = { rx = 8, ry = 9, rz = 10, vx = 11, vy = 12, vz = 13 }

-- q, w, r, v of a state in the air.
function bounce:thirteen(x)
  local full = numeric.whole(self.flight, x)
  return { table.unpack(full, 1, 13) }
end

-- The state in the air of a state on the plane; t: its time.
function bounce:lifted(t, on)
  local c, why = self.library:contact(t, numeric.whole(self.contact, on), self.course)
  if not c then return nil, why end
  local x = {}
  for i, s in ipairs(self.flight.states) do
    local k = places[s.name]
    x[i] = k and c[k < 11 and k - 6 or k - 6] or on[self.at[s.name]]
  end
  return x, c[1]
end

-- The state on the plane of one in the air that touches it.
function bounce:landed(x)
  local e1, e2, full, on = self.e1, self.e2, self:thirteen(x), {}
  local r, v = part(full, 8), part(full, 11)
  local own = { p1 = vec.dot(e1, r), p2 = vec.dot(e2, r), v1 = vec.dot(e1, v), v2 = vec.dot(e2, v) }
  for i, s in ipairs(self.contact.states) do
    local key = s.effect == self.plane and s.key
    on[i] = key and own[key] or x[self.of[s.name]]
  end
  return on
end

-- ---- one phase ----

-- Between two states of a phase, the first with a positive value, the second without: the last state that is not
-- beyond the zero, within rounding of it.
local function narrowed(phase, value, a, b, ga, gb, o)
  local side = 0
  for _ = 1, 100 do
    local t = a.t + (b.t - a.t) * (ga / (ga - gb))
    if not (t > a.t and t < b.t) then t = a.t + (b.t - a.t) / 2 end
    if t <= a.t or t >= b.t then break end
    local c, why = motion.to(phase, t, { from = a, step = o.step, tolerance = o.tolerance })
    if not c then return nil, why end
    local g = value(c)
    if g > 0 then
      a, ga = c, g
      if side == 1 then gb = gb / 2 end -- Illinois: the end that stays counts half
      side = 1
    else
      b, gb = c, g
      if side == -1 then ga = ga / 2 end
      side = -1
      if g == 0 then break end
    end
  end
  return b
end

-- The first state after a, at most dt later, at which the value is positive, and that step; a where there is none.
local function risen(phase, value, a, dt, o)
  while a.t + dt > a.t do
    local b, why = motion.to(phase, a.t + dt, { from = a, step = o.step, tolerance = o.tolerance })
    if not b then return nil, why end
    if value(b) > 0 then return b, dt end
    dt = dt / 4
  end
  return a, dt
end

-- From the start {a, dt} on to the time `to` with steps of dt that grow to `step`, until value, positive at first, is
-- not: that state, or nil; second result: the failure.  The value may be 0 at the start; where it does not rise it is
-- a.  The start is moved on, so that the next search begins where this one ended.
local function first_zero(phase, value, start, to, step, o)
  local a, dt, ga = start.a, start.dt, start.value or value(start.a)
  local n = start.n or parts
  if ga <= 4 * rounding and a.t < to then
    local b, short = risen(phase, value, a, dt, o)
    if not b or b == a then return b, short end
    a, dt, ga = b, short, value(b)
  end
  while a.t < to do
    local times, t = {}, a.t
    for i = 1, n do
      local next_time = i == n and math.min(a.t + n * dt, to) or a.t + i * dt
      if next_time > t and next_time <= to then
        times[#times + 1], t = next_time, next_time
      end
    end
    if #times == 0 then times[1] = to end
    local list, why = phase.solve(times, { from = a, step = o.step, tolerance = o.tolerance })
    if not list then return nil, why end
    for _, b in ipairs(list) do
      local gb = value(b)
      if gb ~= gb then return nil, { status = 3, t = b.t, text = happenings.no_point } end
      if gb <= 0 then return narrowed(phase, value, a, b, ga, gb, o) end
      a, ga = b, gb
    end
    dt, n = math.min(2 * dt, step), math.min(2 * n, longest)
  end
  start.a, start.dt, start.value, start.n = a, dt, ga, n
  return nil
end

-- ---- the sequence of phases ----

-- The phase that begins at t in the state x in the air, just after an impact or at the start.  down: it does not rise.
function bounce:begun(t, x, name, down)
  local low, why = self.library:gap(self:thirteen(x))
  if not low then return failed(t, why) end
  local full = self:thirteen(x)
  local height = vec.dot(self.normal, part(full, 8))
  local least = lost * rounding * math.abs(height)
  local slip, speeds = norm(part(low, 6)), norm(part(full, 11)) + norm(part(full, 5)) * math.abs(height)
  if not name and self.rolls and low[1] <= least and slip > slipping * speeds then
    return failed(t, string.format("the body starts on the plane with a slip of %.6g m/s, and it rolls: its " ..
      "velocity follows from omega where initial gives no position", slip))
  end
  if down or low[1] <= least and low[2] <= math.sqrt(2 * self.weight * least) then
    local on = self:landed(x)
    local c = self.library:contact(t, numeric.whole(self.contact, on), self.course)
    if c and c[1] > 0 then return { t = t, x = x, on = on, name = name and "landing" } end
  end
  return { t = t, x = x, rate = low[2], name = name }
end

-- The phase after `now`, if it begins before `to`; nil and a failure, or nil.
function bounce:after(now, to, o)
  if now.on then
    now.search = now.search or { a = { t = now.t, x = now.on }, dt = self.step }
    local at, why = first_zero(self.on_plane, function(s)
      local c = self.library:contact(s.t, numeric.whole(self.contact, s.x), self.course)
      return c and c[1] or 0 / 0
    end, now.search, to, self.step, o)
    if not at then return nil, why end
    local x, wrong = self:lifted(at.t, at.x)
    if not x then return failed(at.t, wrong) end
    return { t = at.t, x = x, rate = 0.0, name = "lift_off" }
  end
  local function gap(s)
    local low = self.library:gap(self:thirteen(s.x))
    return low and low[1] or 0 / 0
  end
  local rise = self.weight > 0 and now.rate > 0 and now.rate / self.weight / 8 or self.step
  now.search = now.search or { a = { t = now.t, x = now.x }, dt = math.min(rise, self.step) }
  local at, why = first_zero(self.in_air, gap, now.search, to, self.step, o)
  if not at then return nil, why end
  if at.t == now.t then return self:begun(now.t, now.x, "landing", true) end
  local x, impulse = self.library:impact(self.law, self:thirteen(at.x))
  if not x then return failed(at.t, impulse) end
  local after = { table.unpack(at.x) }
  for i, k in ipairs((numeric.positions(self.flight))) do after[i] = k <= 13 and x[k] or at.x[i] end
  return self:begun(at.t, after, "impact")
end

-- The phases up to the time `to`; those from the scene's start are kept, by the step.
function bounce:phases(to, o)
  local key, from = o.step or o.tolerance or 0, o.from or { t = 0.0, x = self.start }
  local made = not o.from and self.made[key]
  if not made then
    local first, why = from, nil
    if not from.on then first, why = self:begun(from.t, from.x) end
    if not first then return nil, why end
    made = { { t = first.t, x = first.x, on = first.on, rate = first.rate }, reached = from.t }
    self.made[key] = not o.from and made or self.made[key]
  end
  while made.reached < to do
    local next_phase, why = self:after(made[#made], to, o)
    if why then return nil, why end
    if not next_phase then
      made.reached = to
    else
      made[#made + 1] = next_phase
      if #made > most then return failed(next_phase.t, "more than " .. most .. " impacts") end
      local before = made[#made - at_once]
      if before and before.t == next_phase.t then
        return failed(next_phase.t, "more than " .. at_once .. " impacts at one time")
      end
    end
  end
  return made
end

-- The states at ascending times.
function bounce:solve(times, o)
  local made, why = self:phases(times[#times] or 0, o)
  if not made then return nil, why end
  local out, i = {}, 1
  for k, phase in ipairs(made) do
    local wanted, ends = {}, made[k + 1] and made[k + 1].t or math.huge
    while times[i] and times[i] < ends do
      wanted[#wanted + 1] = times[i]
      i = i + 1
    end
    local inner = phase.on and self.on_plane or self.in_air
    local list, wrong = {}, nil
    if #wanted > 0 then
      list, wrong = inner.solve(wanted, { from = { t = phase.t, x = phase.on or phase.x },
        step = o.step, tolerance = o.tolerance })
    end
    if not list then return nil, wrong end
    for _, s in ipairs(list) do
      local x = s.x
      if phase.on then
        x, wrong = self:lifted(s.t, s.x)
        if not x then return failed(s.t, wrong) end
      end
      out[#out + 1] = { t = s.t, x = x, on = phase.on and s.x, inner = s }
    end
  end
  return out
end

-- ---- the motion ----

local function by_name(states)
  local at = {}
  for i, s in ipairs(states) do at[s.name] = i end
  return at
end

-- contact, flight: the scenes of the two phases; engine(scene, given) -> a motion.  Returns the motion, or nil and the
-- failure.
local composed
function composed(host, contact, flight, given, course, engine)
  local on_plane, why = engine(contact, given)
  if not on_plane then return nil, why end
  local same = {}
  for k, v in pairs(given) do same[k] = v end -- a copy: order is lost anyway
  same.method = on_plane.method
  local in_air, wrong = engine(flight, same)
  if not in_air then return nil, wrong end
  local plane, m = flight.record.landing, flight.model
  local a = plane.a
  local function double(v) return vec.map(v, function(e) return m:double(e) end) end
  local self = setmetatable({ contact = contact, flight = flight, on_plane = on_plane, in_air = in_air, made = {},
    library = host.rates(numeric.scene(contact)), course = course, step = m:double(m.step), e1 = double(a.e1),
    e2 = double(a.e2), normal = double(a.normal), at = by_name(contact.states), of = by_name(flight.states),
    start = numeric.initial(flight) }, bounce)
  for _, e in ipairs(contact.model.record.effects) do self.plane = e.spec.touches and e or self.plane end
  self.weight = math.max(0.0, -vec.dot(self.normal, double(a.gravity)))
  self.rolls = a.law == "rolling"
  self.law = { m:double(a.impact.restitution), a.impact.friction and m:double(a.impact.friction) or math.huge,
    a.impact.tangential and m:double(a.impact.tangential) or 0.0 }
  local way = {}
  for k, v in pairs(on_plane) do way[k] = v end -- a copy: order is lost anyway
  way.closed, way.exact, way.judge, way.ground = false, false, nil, contact
  way.twin = on_plane.double and function()
    return (composed(host, contact, flight, on_plane.double, course, engine))
  end
  function way.solve(times, o)
    local list, failure = self:solve(times, o)
    way.stiff = on_plane.stiff or in_air.stiff
    return list, failure
  end
  function way.measured(s) return (s.on and on_plane or in_air).measured(s.inner) end
  -- What happened up to a time: a list of {name, t}; those of the longest step.
  function way.phases(to)
    local list = {}
    for _, p in ipairs(self:phases(to, {}) or {}) do
      if p.name and p.t <= to then list[#list + 1] = { name = p.name, t = p.t } end
    end
    return list
  end
  return way
end

-- The scene whose states a motion has: the phase in the air of a body that flies and lands, and then given.ground is
-- that on the plane; else the scene itself.  nil, diagnostics and what else is wrong, as driver.read has them.
function bounce.scene(scene, given)
  if not scene.record.flies then return scene end
  given.ground = scene
  return driver.flight(scene, given)
end

-- The motion of a scene, such or another, by the engine that is asked for: as engines.lua has it, or nil and a failure.
function bounce.motion(host, scene, given, course)
  local engine = given.engine == "generated" and engines.generated or engines.general
  if not given.ground then return engine(host, scene, given, course) end
  return composed(host, given.ground, scene, given, course, function(phase, own)
    return engine(host, phase, own, course)
  end)
end

return bounce
