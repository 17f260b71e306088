-- forced.lua -- the closed form of a motion with effects against the library's Taylor series: one of `polhode check`.
-- SPDX-License-Identifier: GPL-3.0-or-later

local motion_checks = require "generator.commands.motion_checks"
local numeric = require "generator.dynamics.numeric"

local forced = {}

-- How many turns are followed: a ball that is driven along goes faster and faster.
function forced.turns(job) return job.closed.centre and 4 or 100 end

local function length(v, from)
  local s = 0.0
  for i = from, from + 2 do s = s + v[i] * v[i] end
  return math.sqrt(s)
end

-- plugin: the emitted code; scale: the largest |w| that counts; starts: states; given(x): the scene for the library
-- from that state.  The closed form may refuse all but the first of them (a motion that it has not).
-- The library gets the tensor that the emitted code returns, but for a heavy top, whose centre of mass counts.
-- Of a ball on a plane the place counts, too, by how far it went.
-- Up to a hundred turns (a ball that a slope or a turntable drives: four) at the pace of the motion, w and w'/w
-- together; where the rates grow, until they are e^4 times what they were.  Bound: 18 units of the last place are
-- promised of the emitted code, 1e-12 is what the series' steps of 1e-15 have grown to; to each phase the roundings of
-- the constants and of the time are added, 4 units.
local function worst_of(host, job, plugin, epsilon, scale, s, x0)
  if job.closed.kind ~= "lagrange" then motion_checks.at_tensor(host, job, plugin, s) end
  local w, place = 0, nil -- where the rates begin, and the coordinates along a plane
  for i, state in ipairs(job.states) do
    if state.name == "wx" then w = i end
    if state.name == "p1" then place = i end
  end
  local dx = plugin:rhs(0, x0)
  local speed = place and math.abs(dx[place]) + math.abs(dx[place + 1])
  local pace = scale + length(dx, w) / scale
  local finish = 2 * math.pi * forced.turns(job) / pace
  local growth = job.closed.decay and -job.model:double(job.closed.decay) or 0
  if growth > 0 then finish = math.min(finish, 4 / growth) end
  local times = { finish / 300, finish / 15, finish }
  for i, t in ipairs(times) do times[i] = numeric.narrow(t, job.real) end
  local list, wanted, why = motion_checks.both(host, job, plugin, x0, s, "adaptive", times)
  if not list then return nil, wanted, why end
  local worst = 0.0
  for _, p in ipairs(list) do
    local t, got, want = p.t, p.got, p.want
    local most = math.max(scale, length(want, w))
    local bound = 18 * epsilon + 1e-12 + 4 * epsilon * (pace + most) * t
    local function largest(from, more)
      return math.max(math.abs(x0[from]), math.abs(x0[from + 1]), math.abs(want[from]), math.abs(want[from + 1]), more)
    end
    local far = place and largest(place, speed * t)
    local fast = place and x0[place + 2] and largest(place + 2, 0.0)
    for k = job.closed.full and 1 or job.closed.centre and place or w, #got do
      local size = k >= w and most or 1
      if place and k >= place then size = k < place + 2 and far or fast end
      local d = math.abs(got[k] - want[k]) / size
      worst = d == d and math.max(worst, d / bound) or math.huge
    end
  end
  return worst
end

function forced.run(host, job, plugin, tap, name, epsilon, scale, starts, given)
  local worst, count = 0.0, 0
  for n, x in ipairs(starts) do
    local s = given(x)
    local status = plugin:solve(x)
    if status ~= 0 and n == 1 then
      tap.ok(false, name .. ": the closed form accepts the initial state")
      return
    elseif status == 0 then
      local one, wanted, why = worst_of(host, job, plugin, epsilon, scale, s, x)
      if not one then
        tap.ok(false, name .. ": " .. wanted, why)
        return
      end
      worst, count = math.max(worst, one), count + 1
    end
  end
  tap.ok(worst <= 1, name .. ": the closed form is the library's motion over " .. forced.turns(job) .. " turns",
    string.format("%.2g of the bound, from %d states", worst, count))
end

return forced
