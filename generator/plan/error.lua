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

-- Rows {t, x...} as plugin:integrate gives them, without the time.
function err.states(rows)
  local out = {}
  for i, row in ipairs(rows) do out[i] = { table.unpack(row, 2) } end
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

-- The error of rows against as many reference rows, each a state as the scene has it: a number (math.huge where
-- something is not finite), and {[group's name] = number, [1..n] = names}.
function err.of(job, rows, reference)
  assert(#rows == #reference and #rows > 0)
  local worst, parts = 0.0, {}
  for n, g in ipairs(err.groups(job)) do
    local most, scale = 0.0, 0.0
    for k, want in ipairs(reference) do
      local d = norm(g, rows[k], want, 1)
      if g.name == "attitude" then d = math.min(d, norm(g, rows[k], want, -1)) end
      most = math.max(most, d)
      scale = math.max(scale, norm(g, want))
    end
    if g.name ~= "attitude" and scale > 0 then most = most / scale end
    if most ~= most then most = math.huge end
    parts[n], parts[g.name] = g.name, most
    worst = math.max(worst, most)
  end
  return worst, parts
end

return err
