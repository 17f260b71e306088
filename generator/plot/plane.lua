-- plane.lua -- curves in a plane, both axes to one scale: the herpolhode, the path of the centre of mass from above.
--
-- The herpolhode is the curve that w draws in the plane across L (w's part along L is 2T/|L|, constant).  It runs
-- between two circles: on the polhode |w| is least and greatest where it meets the planes of the principal axes.
-- SPDX-License-Identifier: GPL-3.0-or-later

local curve = require "generator.plot.curve"
local frame = require "generator.plot.frame"
local space = require "generator.plot.space"

local plane = {}

-- The radii between which the herpolhode of a free body runs: moments I ascend, w along the principal axes.  Where w_i
-- = 0 the radius is |L x w|/|L| = |I_j - I_k| w_j w_k/|L|; the squares of w_j and w_k follow from T and L as sums of
-- products of differences of moments, which do not cancel as L^2 - 2T I does.
function plane.radii(I, w)
  local L2, list = 0.0, {}
  for i = 1, 3 do L2 = L2 + (I[i] * w[i]) ^ 2 end
  for i = 1, 3 do
    local j, k = i % 3 + 1, (i + 1) % 3 + 1
    local a, b = 0.0, 0.0 -- I_j (I_k - I_j) w_j^2 and I_k (I_k - I_j) w_k^2 there
    for n = 1, 3 do
      local share = I[n] * w[n] ^ 2
      a, b = a + share * (I[k] - I[n]), b + share * (I[n] - I[j])
    end
    local d = I[k] - I[j]
    if d ~= 0 and a / d >= 0 and b / d >= 0 then
      list[#list + 1] = math.abs(d) * math.sqrt(a / d / I[j]) * math.sqrt(b / d / I[k]) / math.sqrt(L2)
    end
  end
  table.sort(list)
  return list[1], list[#list]
end

-- The points of the herpolhode: w in space across L.  samples have `space`, w in inertial axes, and L.
function plane.herpolhode(samples)
  local L = samples[1].L
  local k = space.unit(L)
  local w = samples[1].space
  local along = space.dot(w, k)
  local across = { w[1] - along * k[1], w[2] - along * k[2], w[3] - along * k[3] }
  local a, b = space.across(k)
  if space.length(across) > 1e-9 * space.length(w) then -- it begins on the first axis
    a = space.unit(across)
    b = space.cross(k, a)
  end
  local points = {}
  for i, s in ipairs(samples) do -- without w's part along L, of which a and b hold a rounding
    local c, v = space.dot(s.space, k), {}
    for n = 1, 3 do v[n] = s.space[n] - c * k[n] end
    points[i] = { space.dot(v, a), space.dot(v, b) }
  end
  return points
end

-- The range of a coordinate; one that is constant beside the other has a narrow one around its value.
local function range(values, others)
  local low, high, least, most = math.huge, -math.huge, math.huge, -math.huge
  for i, x in ipairs(values) do
    low, high = math.min(low, x), math.max(high, x)
    least, most = math.min(least, others[i]), math.max(most, others[i])
  end
  local other = most - least
  if other > 0 and high - low < 1e-9 * other then return { low - 0.05 * other, high + 0.05 * other } end
  return frame.range { values }
end

-- Draws points with a mark at their start, circles of the radii given, and a cross at their end if p.stop says in words
-- what ends there.
function plane.draw(d, p)
  local reach, xs, ys = nil, {}, {}
  for i, v in ipairs(p.points) do xs[i], ys[i] = v[1], v[2] end
  local xr, yr = range(xs, ys), range(ys, xs)
  for _, r in ipairs(p.circles or {}) do reach = math.max(reach or 0.0, 1.08 * r) end
  if reach and reach > 0 then xr, yr = { -reach, reach }, { -reach, reach } end
  local scale, s, unit = frame.plane(d, { box = p.box, x = p.x, y = p.y, xrange = xr, yrange = yr })
  for _, r in ipairs(p.circles or {}) do
    d:circle(scale.x(0), scale.y(0), r / s * unit, "ring")
  end
  local flat = {}
  for i, v in ipairs(p.points) do flat[i] = { scale.x(v[1] / s), scale.y(v[2] / s) } end
  d:path(curve.path(flat), "trace")
  d:circle(flat[1][1], flat[1][2], 3.2, "start")
  local last = flat[#flat]
  if p.stop then
    d:line(last[1] - 4, last[2] - 4, last[1] + 4, last[2] + 4, "ring")
    d:line(last[1] - 4, last[2] + 4, last[1] + 4, last[2] - 4, "ring")
    d:text(last[1], last[2] - 8, p.stop, "small", "middle")
  end
end

return plane
