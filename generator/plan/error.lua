-- error.lua -- how far a computed motion is from the true one: one number, the same everywhere.
--
-- The motion is looked at 40 times in the last tenth of the horizon T.  States go by groups: the attitude (Euclidean
-- norm of q - q', with the better sign of q), rates, position, velocity (norm of the difference over the largest norm
-- of the reference among the 40), and every further state by itself, likewise.  What is zero in all of the reference
-- counts absolutely.  The error is the largest over groups and times.
-- SPDX-License-Identifier: GPL-3.0-or-later

local err = {}

err.count = 40

-- The end times t_k = T (0.9 + 0.1 k/40), k = 1..40.
function err.times(T)
  local list = {}
  for k = 1, err.count do list[k] = T * (0.9 + 0.1 * k / err.count) end
  list[err.count] = T + 0.0
  return list
end

-- The states of a motion (dynamics/motion.lua) without their times.
function err.states(list)
  local out = {}
  for i, s in ipairs(list) do out[i] = s.x end
  return out
end

local together = { attitude = true, rates = true, position = true, velocity = true }

-- The groups of a scene's states in their order: {name =, indices...}.
function err.groups(job)
  local list, by_kind = {}, {}
  for i, s in ipairs(job.states) do
    local g = by_kind[s.kind]
    if not g then
      g = { name = together[s.kind] and s.kind or s.name }
      list[#list + 1] = g
      if together[s.kind] then by_kind[s.kind] = g end
    end
    g[#g + 1] = i
  end
  return list
end

-- The norm over the group's states of a - sign b, scaled so that squares neither overflow nor vanish; b nil: of a.
local function norm(group, a, b, sign)
  local most, sum = 0.0, 0.0
  local function difference(i) return math.abs(b and a[i] - sign * b[i] or a[i]) end
  for _, i in ipairs(group) do
    local d = difference(i)
    if d ~= d or d == math.huge then return math.huge end
    if d > most then most = d end
  end
  if most == 0 then return 0.0 end
  for _, i in ipairs(group) do sum = sum + (difference(i) / most) ^ 2 end
  return most * math.sqrt(sum)
end

-- The size by which differences of each group are divided: the largest norm among the reference's states; 1 for the
-- attitude, and where that is zero.
function err.scales(groups, reference)
  local scales = {}
  for n, g in ipairs(groups) do
    local scale = 0.0
    for _, want in ipairs(reference) do scale = math.max(scale, norm(g, want)) end
    scales[n] = (g.name == "attitude" or scale == 0) and 1.0 or scale
  end
  return scales
end

-- How far a state of one group is from what it should be, in units of scale.
function err.distance(group, scale, got, want)
  local d = norm(group, got, want, 1)
  if group.name == "attitude" then d = math.min(d, norm(group, got, want, -1)) end
  d = d / scale
  return d == d and d or math.huge
end

-- The error of rows against as many reference rows, each a state as the scene has it: a number (math.huge where
-- something is not finite), and {[group's name] = number, [1..n] = names}.
function err.of(job, rows, reference)
  assert(#rows == #reference and #rows > 0)
  local groups, worst, parts = err.groups(job), 0.0, {}
  local scales = err.scales(groups, reference)
  for n, g in ipairs(groups) do
    local most = 0.0
    for k, want in ipairs(reference) do most = math.max(most, err.distance(g, scales[n], rows[k], want)) end
    parts[n], parts[g.name] = g.name, most
    worst = math.max(worst, most)
  end
  return worst, parts
end

return err
