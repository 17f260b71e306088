-- forced.lua -- the closed form of a motion with effects against the library's Taylor series: one of `polhode check`.
-- SPDX-License-Identifier: GPL-3.0-or-later

local forced = {}

local function length(v, from)
  local s = 0.0
  for i = from, from + 2 do s = s + v[i] * v[i] end
  return math.sqrt(s)
end

-- plugin: the emitted code; scale: the largest |w| that counts; starts: states; given(x): the scene for the library
-- from that state.  The closed form may refuse all but the first of them (a motion that it has not).
-- The library gets the tensor that the emitted code returns, but for a rod, which a rounded one is no more, and for a
-- heavy top, whose centre of mass counts.
-- Up to a hundred turns at the pace of the motion, w and w'/w together; where the rates grow, until they are e^4 times
-- what they were.  Bound: 18 units of the last place are promised of the emitted code, 1e-12 is what the series' steps
-- of 1e-15 have grown to; to each phase the roundings of the constants and of the time are added, 4 units.
local function worst_of(host, job, plugin, epsilon, scale, s, x0)
  if not job.model.structure.rod and job.closed.kind ~= "lagrange" then
    local I, mass = plugin:inertia(), host.mass(s)
    s.body = { shape = "tensor", mass = mass.mass, com = { 0.0, 0.0, 0.0 }, about = "com", xx = I[1], yy = I[2],
      zz = I[3], xy = I[4], xz = I[5], yz = I[6], formal = job.model.unlawful }
    s.origin = { 0.0, 0.0, 0.0 }
  end
  local w = #x0 - 2 -- where the rates begin
  local pace = scale + length(plugin:rhs(0, x0), w) / scale
  local finish = 200 * math.pi / pace
  local growth = job.closed.decay and -job.model:double(job.closed.decay) or 0
  if growth > 0 then finish = math.min(finish, 4 / growth) end
  local times = { finish / 300, finish / 15, finish }
  if job.real == "float" then
    for i, t in ipairs(times) do times[i] = string.unpack("f", string.pack("f", t)) end
  end
  local rows, why = host.run(s, { method = "adaptive", times = times })
  if not rows then return nil, why end
  local worst = 0.0
  for i, t in ipairs(times) do
    local got, want = plugin:at(t), rows[i] -- a row: t, q, w, ..
    local most = math.max(scale, length(want, 6))
    local bound = 18 * epsilon + 1e-12 + 4 * epsilon * (pace + most) * t
    for k = job.closed.full and 1 or w, #got do
      local d = k >= w and math.abs(got[k] - want[6 + k - w]) / most or math.abs(got[k] - want[1 + k])
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
      local one, why = worst_of(host, job, plugin, epsilon, scale, s, x)
      if not one then
        tap.ok(false, name .. ": the library follows the motion", why)
        return
      end
      worst, count = math.max(worst, one), count + 1
    end
  end
  tap.ok(worst <= 1, name .. ": the closed form is the library's motion over a hundred turns",
    string.format("%.2g of the bound, from %d states", worst, count))
end

return forced
