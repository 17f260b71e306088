-- search.lua -- the cheapest candidate, and its step or tolerance, that stays below an error at given states.
--
-- Candidates are tried one after the other.  Once one is good enough, each further one is first run at the step that
-- costs as much as the best so far: if its error is too large there, it is dearer, and done with.  So few runs are
-- made, and none is long.  Cost: operations of a step by a target's table, times the mean number of
-- steps; never a time.
-- SPDX-License-Identifier: GPL-3.0-or-later

local search = {}

local most_steps = 2 ^ 20 -- of one run: who needs more is given up
local most_cycles = 2e9 -- of one run of an explicit method through a stiff motion: seconds
local close = 1.02 -- a number of steps that is this near the least one is good enough

-- {setting, error, steps, cost} of one setting at the points; fits = is the error below the limit.
local function tried(s, c, setting, limit)
  local e, steps = s.trial:worst(c, setting, s.points, limit)
  return s.trial:measured({ candidate = c, setting = setting, error = e, steps = steps, fits = e <= limit,
    cost = (c.setup or 0.0) + steps * c.weight(setting) }, false)
end

-- The first n digits of x > 0, which are all 16 of a double but for what no run can tell apart.
function search.rounded(x, n)
  local mantissa, exponent = string.match(string.format("%.15e", x), "^([%d.]+)e([+-]%d+)$")
  return tonumber(string.sub(mantissa, 1, n + 1) .. "e" .. exponent)
end

local digits = { step = 4, tolerance = 2 }

-- The largest step h = T/n, by whole numbers n: from a bracket of one that is too large and one that is not.
local function refine(s, c, limit, bad, good)
  local p, n = c.power, s.trial.T
  local low, high = math.max(bad and bad.n or 0, (c.least_steps or 1) - 1), good.n
  for turn = 1, 16 do
    if high <= low + 1 or high <= low * close then break end
    local guess = high * (good.error / limit) ^ (1 / p) -- the law of its order
    if turn % 2 == 0 or guess ~= guess or guess <= low then guess = math.sqrt(math.max(low, 1) * high) end
    guess = math.floor(math.max(low + 1, math.min(high - 1, guess * 1.002 + 1)))
    local r = tried(s, c, n / guess, limit)
    r.n = guess
    if r.fits then
      good, high = r, guess
    else
      low = guess
    end
  end
  return good
end

-- With a best so far: first at the number of steps for which it would cost as much.  Without: from 16 steps up, by the
-- law of the order once the error is below 0.1, until two rungs in a row bring nothing.
local function by_step(s, c, limit, best)
  local T = s.trial.T
  if best then
    local n = math.tointeger(math.floor(math.min(most_steps, best.cost / c.weight() * 0.999)))
    if n < (c.least_steps or 1) then return { fits = false, dearer = true } end
    local r = tried(s, c, T / n, limit)
    r.n, r.dearer = n, true
    for part = 1, 4 do -- where roundings add up, fewer steps may be better
      if r.fits then return refine(s, c, limit, nil, r) end
      local fewer = n >> part
      if r.error > 1000 * limit or fewer < (c.least_steps or 1) then break end
      local other = tried(s, c, T / fewer, limit)
      if other.fits then
        other.n = fewer
        return refine(s, c, limit, nil, other)
      end
    end
    return r
  end
  local n, least, idle, bad = math.max(16, c.least_steps or 1), nil, 0, nil
  while true do
    local r = tried(s, c, T / n, limit)
    r.n, r.fits = n, r.error <= limit
    if r.fits then return refine(s, c, limit, bad, r) end
    bad = r
    idle = least and r.error >= least.error / 2 and r.error < 0.1 and idle + 1 or 0
    if not least or r.error < least.error then least = r end
    if idle >= 2 or n >= most_steps then return least end
    local factor = r.error < 0.1 and 1.1 * (r.error / limit) ^ (1 / c.power) or 4
    n = math.floor(math.min(most_steps, n * math.max(2, math.min(16, factor))))
  end
end

-- The largest tolerance.  The error goes with the tolerance, more or less; steps with its (1/power)th root.
local function by_tolerance(s, c, limit, best)
  local finest = 4 * s.epsilon
  local tolerance, good, least = math.max(finest, math.min(1e-2, limit)), nil, nil
  if c.power < 8 then tolerance = math.max(tolerance, 1e-4) end
  local bad -- the smallest that was too large
  for _ = 1, 10 do
    tolerance = search.rounded(tolerance, digits.tolerance)
    local r = tried(s, c, tolerance, math.huge)
    r.fits = r.error <= limit and (not c.allowed or c.allowed(tolerance))
    if not least or r.error < least.error then least = r end
    -- what it will cost at the limit: steps go with the (1/power)th root of the error
    local should = r.cost * (r.error / limit) ^ (1 / c.power)
    if best and r.error < 0.1 and should > 1.5 * best.cost then
      r.fits, r.dearer, r.should = false, true, should
      return r
    end
    if r.fits then
      if not good or r.setting > good.setting then good = r end
      if r.error > limit / c.spread then break end
    else
      bad = math.min(bad or 1, tolerance)
      if tolerance <= finest then break end
    end
    local ratio = r.error < math.huge and math.max(1e-4, math.min(1e4, 0.8 * limit / r.error)) or 1e-2
    local following = tolerance * ratio
    if good and following <= good.setting * 1.02 then following = math.sqrt(good.setting * (bad or 1e-2)) end
    if bad and following >= bad * 0.98 then following = math.sqrt(bad * (good and good.setting or bad / 100)) end
    following = math.max(finest, math.min(1e-1, following))
    if good and bad and bad < good.setting * 1.1 then break end
    if search.rounded(following, digits.tolerance) == tolerance then break end
    tolerance = following
  end
  return good or least
end

-- One candidate at the points: {setting, error, steps, cost, fits}; dearer = given up, as it costs more than best.
local function solve(s, c, limit, best)
  if c.setting == "none" then return tried(s, c, nil, math.huge) end
  if c.stable_steps then -- no run tells more than what its stability alone costs
    local should = c.stable_steps * c.weight(c.setting == "tolerance" and math.min(1e-2, limit) or nil)
    if should > 2 * math.min(most_cycles, best and best.cost or math.huge) then
      return { fits = false, dearer = true, should = should }
    end
  end
  return (c.setting == "step" and by_step or by_tolerance)(s, c, limit, best)
end

-- s: {trial, points, epsilon (of the type), progress = function(part)}; candidates: with weight(setting), setup, power
-- (the order of the method), spread (how near the limit a tolerance's error should come), allowed(tolerance): is it
-- within the budget?, least_steps that a run must have, and stable_steps that an explicit method takes at least through
-- a stiff motion.  Returns the best {candidate,
-- ...} or nil, and for every candidate what was found: {candidate, error, setting, cost, dearer}.  bound: a plan that
-- is known to hold, to be beaten.
function search.cheapest(s, candidates, limit, bound)
  local best, found = bound, {}
  for i, c in ipairs(candidates) do
    local r = solve(s, c, limit, best)
    r.fits = r.fits and r.error <= limit
    r.candidate, found[i] = c, r
    if r.fits and (not best or r.cost < best.cost) then best = r end
    if s.progress then s.progress(i / #candidates) end
  end
  return best, found
end

return search
