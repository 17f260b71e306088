-- ladder.lua -- the settings of one method that are worth measuring: from the first that follows the motion at all
-- to the one that rounding ends.
--
-- A step goes down by 2, or by as much less as makes the error fall by some root of 10 a rung; a tolerance by that
-- root.  Rungs whose error is a tenth or more tell nothing and are passed over, by halves of the step.
-- SPDX-License-Identifier: GPL-3.0-or-later

local ladder = {}

local useless = 0.1 -- an error like that
local coarsest, most_steps = 20, 2 ^ 24 -- steps over the horizon
local fall = math.sqrt(10) -- of the error, from rung to rung
local slowest = 0.4 -- s: no rung takes longer
local behind = 20 -- times the time of the best of its group (or m.behind): further rungs are not worth their time
local patience = 3 -- rungs that bring nothing
local plateau = { step = 32, tolerance = 1e4 } -- far above rounding the setting falls so far without gain: long steps
-- may be cut into pieces, or limited by something else
local again = 4 -- times that a rung is run once more before it is called slow

-- m: {order = of a fixed step's method, T = horizon, kind = "step"|"tolerance", least = least tolerance,
--   behind = (see above), floor = error that rounding allows at best, noise = what it may make in many steps,
--   enough = error that is good enough (or nil),
--   run = function(setting) -> error (math.huge: no result), seconds, anything,
--   best = function(error) -> seconds of the best of its group with at most that error, or nil}
-- Returns a list of {setting =, error =, seconds =, what = run's third}, in the order of falling settings.
function ladder.climb(m)
  local list = {}
  local far = m.behind or behind
  local function rung(setting)
    local e, seconds, what = m.run(setting)
    local best = m.best(e)
    for _ = 1, e < math.huge and again or 0 do -- was it the machine, or is it so?
      if seconds <= slowest / 2 and not (best and seconds > far / 2 * best) then break end
      seconds = math.min(seconds, (select(2, m.run(setting))))
    end
    local r = { setting = setting, error = e, seconds = seconds, what = what }
    if e < 10 * useless then list[#list + 1] = r end
    return r
  end
  -- Is the rung the last?  at the floor, no longer better, too slow, or good enough
  -- stuck: rungs in a row at the floor; flat: rungs in a row that did not halve the error
  local stuck, flat, top = 0, 0, nil -- top: the setting where the flat part begins
  local function last(r)
    local before = list[#list - 1]
    local best = m.best(r.error)
    stuck = r.error <= m.floor and stuck + 1 or 0
    flat = before and r.error > before.error / 2 and flat + 1 or 0
    if flat <= 1 then top = (flat == 1 and before or r).setting end
    local vain = flat > 0 and (r.error <= m.noise and flat >= patience or top / r.setting >= plateau[m.kind])
    return stuck >= patience or vain or r.seconds > slowest
      or best and r.seconds > far * best or m.enough and r.error <= m.enough
  end
  if m.kind == "tolerance" then
    local failures = 0 -- some find no way with a tolerance that is too loose
    for k = 2, 36 do
      local tolerance = 10.0 ^ (-k / 2)
      if tolerance < m.least then break end
      local r = rung(tolerance)
      if r.error == math.huge then
        failures = failures + 1
        if failures == patience or #list > 0 then break end
      elseif r.error < useless and last(r) or r.seconds > slowest then
        break
      end
    end
    return list
  end
  local n = coarsest
  while n < most_steps do
    local r = rung(m.T / n)
    if r.error < useless or r.seconds > slowest then break end
    n = n * 2
  end
  -- from the last that told nothing
  list = {}
  -- a step shorter by this makes the error of a method of order p fall by this^p, sqrt 10 if it is not more than 2
  local factor = math.min(2, fall ^ (1 / m.order))
  n = math.max(n / 2, coarsest)
  while n < most_steps * 2 do
    local r = rung(m.T / n)
    if r.error < useless and last(r) or r.seconds > slowest then break end
    n = n * factor
  end
  return list
end

return ladder
