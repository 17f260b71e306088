-- flat.lua -- where a disc on a plane lies flat: it touches the plane in a line there, and no motion leads on.
--
-- In the surface's axes g is the plane's normal, s = |(g1, g2)| the sine of the tilt, w_t the rates across the axis,
-- c the surface's centre from the centre of mass, R the disc's radius.  Two laws:
--   settled   The disc cannot rise so far that its fall back would take more than one time.step.  With
--             J = I_t + m ((R + |c_t|)^2 + h^2), the most that w_t can turn about, and the pull
--             k = m G (R - |c_t|)/J,  G the gravity along the normal (rolling: less w_n^2 h, h the height of the
--             centre of mass, which the turning about the contact point takes off),
--             energy gives  top = s (R + |c_t|)/(R - |c_t|) + w_t^2/(2 k),  and the fall from there takes
--             sqrt(2 top/k).  A disc that only passes near to flat is above this one step later: two states in
--             succession must have it.
--   fallen    (g1, g2) goes on with g' = g x w.  Where it would pass 0 at less than the root of a rounding, half of
--             the digits are gone that tell where the contact point is: the disc falls flat.
-- Where the steps of a method end, the clock cannot count on: the disc is the cause if it would be flat within `ticks`
-- of the clock.
-- SPDX-License-Identifier: GPL-3.0-or-later

local vec = require "generator.algebra.vec"
local context = require "generator.dynamics.context"
local rotation = require "generator.attitude.rotation"

local flat = {}

local longest = 16 -- steps of the grid at once
local ticks = 1024 -- steps of high order are some hundredths of the time in which the motion changes

-- Numbers of the disc, or nil: {lever = R - |c_t| and reach = R + |c_t|, m; high = h at most, m; mass, J and G of
-- above; least = the least that w_t can turn about; rolls, normal, step, line; at = places of q and w in a state}.
local function disc_of(job, plane)
  local m, a = job.model, plane.a
  local s = a.surface
  if not s.disc then return nil end
  local at = {}
  local function double(e) return m:double(e) + 0.0 end
  for i, state in ipairs(job.states) do at[state.name] = i end
  local c = vec.map(vec.sub(s.at, context.dry(m).origin), double)
  local R, I, mass, normal = double(s.half[1]), vec.map(m.inertia, double), double(m.mass), vec.map(a.normal, double)
  local beside = math.sqrt(c[1] ^ 2 + c[2] ^ 2)
  -- the moments across the axis are mean + off and mean - off
  local mean, off = (I[1] + I[2]) / 2, math.sqrt(((I[1] - I[2]) / 2) ^ 2 + I[4] ^ 2)
  local high = double(s.rim) + math.abs(c[3])
  return { lever = R - beside, reach = R + beside, high = high, mass = mass, at = at, normal = normal,
    J = mean + off + mass * ((R + beside) ^ 2 + high ^ 2), least = mean - off + mass * (R - beside) ^ 2,
    G = -vec.dot(normal, vec.map(a.gravity, double)), rolls = a.law == "rolling", step = double(m.step),
    line = plane.line }
end

local function picked(d, x, names)
  return vec.map(names, function(name) return x[d.at[name]] end)
end

-- g and g' of a state, body axes, and w.
local function tilted(d, x)
  local q = picked(d, x, { "qw", "qx", "qy", "qz" })
  local w = picked(d, x, { "wx", "wy", "wz" })
  local g = rotation.back(q, d.normal)
  return g, vec.cross(g, w), w
end

-- The time that the fall from the highest tilt takes, in time.steps, less 1.
local function fall(d, x)
  local g, _, w = tilted(d, x)
  local n = vec.dot(g, w)
  local k = d.mass * (d.G - (d.rolls and n * n * d.high or 0.0)) * d.lever / d.J
  if k <= 0 then return 1.0 end
  local top = math.sqrt(g[1] ^ 2 + g[2] ^ 2) * d.reach / d.lever + (w[1] ^ 2 + w[2] ^ 2) / (2 * k)
  return math.sqrt(2 * top / k) / d.step - 1
end

-- s; the time to where it is least if g' stays as it is; and how small it is there.
local function ahead(d, x)
  local g, rate = tilted(d, x)
  local s, speed = math.sqrt(g[1] ^ 2 + g[2] ^ 2), math.sqrt(rate[1] ^ 2 + rate[2] ^ 2)
  if speed <= 0 then return s, math.huge, s end
  return s, -(g[1] * rate[1] + g[2] * rate[2]) / speed ^ 2, math.abs(g[1] * rate[2] - g[2] * rate[1]) / speed
end

-- The last state on the way from `at` to where the disc is flat that is not nearer to it than half of the digits.
local function approach(d, course, at)
  local near = math.sqrt(course.epsilon)
  for _ = 1, 60 do
    local s, left = ahead(d, at.x)
    local t = at.t + left / 2
    if s <= 2 * near or t <= at.t then break end
    local list = course.solve({ t }, { from = at })
    if not list then break end
    at = list[1]
  end
  return at
end

-- How many steps of the grid may be had before it is looked for again: half of the time before which the disc cannot be
-- flat, for all of its speed leads there at most, and what pulls it is at most twice what it is near to flat.
local function steps(d, x, step)
  local g, rate = tilted(d, x)
  local s, speed = math.sqrt(g[1] ^ 2 + g[2] ^ 2), math.sqrt(rate[1] ^ 2 + rate[2] ^ 2)
  if s == 0 then return 1 end
  local pull = 2 * d.mass * math.abs(d.G) * d.reach / d.least
  local left = 2 * s / (speed + math.sqrt(speed ^ 2 + 2 * pull * s))
  return math.floor(math.max(1, math.min(longest, left / step / 2)))
end

-- The events of a disc on the plane of an effect, as events.lua has them.
function flat.events(job, plane)
  local d = disc_of(job, plane)
  if not d or d.lever <= 0 then return {} end
  local function touches(at) return at.on or not job.record.landing end
  local settled = { name = "lies_flat", direction = -1, stop = true, line = d.line, stays = true,
    said = "the disc has settled flat: it would not rise again by what it falls in one time.step" }
  function settled.value(at) return touches(at) and fall(d, at.x) or nil end
  function settled.confirm(g) return (g + 1) / 2 * d.step end -- s, half of the fall: the contact point has not jumped
  local fallen = { name = "lies_flat", direction = 1, stop = true, line = d.line,
    said = "the disc has fallen flat, and touches the plane in a line" }
  function fallen.value() return nil end
  function fallen.size(at, step) return steps(d, at.x, step) end
  function fallen.meets(at, within, epsilon)
    local _, left, least = ahead(d, at.x)
    return touches(at) and left > 0 and left <= within and least <= math.sqrt(epsilon)
  end
  function fallen.approach(course, at) return approach(d, course, at) end
  function fallen.within(at, tick)
    local s, left = ahead(d, at.x)
    return touches(at) and math.abs(left) <= ticks * tick and s <= 2.0 ^ -8
  end
  return { settled, fallen }
end

-- The numbers of the laws for a page: {pull, off = k for w_n = 0, and what w_n^2 takes of it, ratio, rolls, step};
-- nil of what is no disc.
function flat.numbers(job, plane)
  local d = disc_of(job, plane)
  if not d or d.lever <= 0 then return nil end
  local per = d.mass * d.lever / d.J
  return { pull = d.G * per, off = d.high * per, ratio = d.reach / d.lever, rolls = d.rolls, step = d.step }
end

return flat
