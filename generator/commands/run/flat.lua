-- flat.lua -- where a disc on a plane lies flat: it touches the plane in a line there, and no motion leads on.
--
-- The two laws, by which it has settled or has fallen, are in generator/dynamics/flat.lua.
-- Where the steps of a method end, the clock cannot count on: the disc is the cause if it would be flat within `ticks`
-- of the clock.
-- SPDX-License-Identifier: GPL-3.0-or-later

local vec = require "generator.algebra.vec"
local happenings = require "generator.dynamics.happenings"
local laws = require "generator.dynamics.flat"

local flat = {}

local longest = 16 -- steps of the grid at once
local ticks = 1024 -- steps of high order are some hundredths of the time in which the motion changes

-- The disc as doubles, and step, line, and at = places of q and w in a state; nil of what is no disc that can fall.
local function disc_of(job, plane)
  local m, d = job.model, laws.disc(job.model, plane)
  if not d then return nil end
  local function double(e) return m:double(e) + 0.0 end
  for _, key in ipairs { "lever", "reach", "high", "mass", "J", "G", "least" } do d[key] = double(d[key]) end
  d.normal, d.step, d.line, d.at = vec.map(d.normal, double), double(m.step), plane.line, {}
  for i, state in ipairs(job.states) do d.at[state.name] = i end
  return d.lever > 0 and d or nil
end

local function picked(d, x, names)
  return vec.map(names, function(name) return x[d.at[name]] end)
end

local function law(d, x)
  return laws.law(d, picked(d, x, { "qw", "qx", "qy", "qz" }), picked(d, x, { "wx", "wy", "wz" }), math.sqrt)
end

-- The time that the fall from the highest tilt takes, in time.steps, less 1.
local function fall(d, x)
  local v = law(d, x)
  return v.pull > 0 and math.sqrt(v.rise) / v.pull / d.step - 1 or 1.0
end

-- s; the time to where it is least if g' stays as it is; and how small it is there.
local function ahead(d, x)
  local v = law(d, x)
  local s = math.sqrt(v.square)
  if v.speed <= 0 then return s, math.huge, s end
  return s, v.toward / v.speed, math.sqrt(v.miss / v.speed)
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
  local v = law(d, x)
  local s, speed = math.sqrt(v.square), math.sqrt(v.speed)
  if s == 0 then return 1 end
  local pull = 2 * d.mass * math.abs(d.G) * d.reach / d.least
  local left = 2 * s / (speed + math.sqrt(speed ^ 2 + 2 * pull * s))
  return math.floor(math.max(1, math.min(longest, left / step / 2)))
end

-- The events of a disc on the plane of an effect, as events.lua has them.
function flat.events(job, plane)
  local d = disc_of(job, plane)
  if not d then return {} end
  local function touches(at) return at.on or not job.record.landing end
  local settled = { name = "lies_flat", direction = -1, stop = true, line = d.line, stays = true,
    said = happenings.settled }
  function settled.value(at) return touches(at) and fall(d, at.x) or nil end
  function settled.confirm(g) return (g + 1) / 2 * d.step end -- s, half of the fall: the contact point has not jumped
  local fallen = { name = "lies_flat", direction = 1, stop = true, line = d.line, said = happenings.fallen }
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
  if not d then return nil end
  local per = d.mass * d.lever / d.J
  return { pull = d.G * per, off = d.high * per, ratio = d.reach / d.lever, rolls = d.rolls, step = d.step }
end

return flat
