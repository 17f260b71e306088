-- advice.lua -- what accuracy.lua found, in words: how wrong a motion is, and what helps.
--
-- s: {job, motion, sure = the motion in double, times = of the rows, limit, compare(rows, better, factor) -> a
-- verdict}; v: a verdict {error, t, since, group, steps, rounding, lost}.
-- SPDX-License-Identifier: GPL-3.0-or-later

local limits = require "generator.commands.run.limits"

local advice = {}

local patience = 10 -- times motion.quick: steps of the longest run that looks for a better step

local function short(x) return string.format("%.2g", x) end

-- Two digits, not above x.
local function floor(x)
  local unit = 10.0 ^ (math.floor(math.log(x, 10)) - 1)
  local s = short(math.floor(x / unit) * unit)
  return tonumber(s) <= x and s or short(tonumber(s) - unit)
end

-- ---- what helps ----

local function richardson(motion) return 2.0 ^ motion.order / (2.0 ^ motion.order - 1) end

-- The step that has half the error that is allowed, by the order, where an error is small enough to tell.
local function by_order(s, step, e)
  if not e or e > 0.5 then return nil end
  return "--step " .. floor(step * (s.limit / 2 / e) ^ (1 / s.motion.order)) .. " (by the method's order)"
end

-- The first of the halved steps of a motion whose own error is below the limit, in words; nil if none is found with
-- patience.
local function shorter(s, motion)
  local times, step, last, slow = s.times, motion.step / 2, nil, 0
  local rows = motion.solve(times, { step = step })
  while limits.steps(times, step / 2) <= patience * motion.quick do
    local better = s.sure.solve(times, { step = step / 2 })
    local e = rows and better and s.compare(rows, better, richardson(motion)).error
    if e and e <= s.limit then return "--step " .. floor(step) .. " (estimated error " .. short(e) .. ")" end
    slow = e and last and e > 0.7 * last and slow + 1 or 0
    if slow > 3 then return nil end -- rounding, or a motion that forgets where it came from
    rows = s.sure == motion and better or motion.solve(times, { step = step / 2 })
    last, step = e, step / 2
  end
  return by_order(s, 2 * step, last)
end

-- What makes the error of the steps less; nil where it is not known.  motion: in the type that it then needs.
local function by_steps(s, v, motion)
  if motion.tolerance then
    local tolerance = v.steps and s.motion.tolerance * math.min(0.5, s.limit / 2 / v.steps)
    return tolerance and tolerance >= motion.least and "--tolerance " .. floor(tolerance) or nil
  end
  if limits.steps(s.times, motion.step) <= motion.quick then return shorter(s, motion) end
  return by_order(s, motion.step, v.steps)
end

-- What makes roundings less, or nil.
local function by_digits(s)
  if s.sure ~= s.motion then return "--real double" end
  return s.motion.emitted and "--engine general, which computes in long double" or nil
end

-- A sentence of what helps with a verdict.
function advice.advice(s, v)
  local motion, list = s.motion, {}
  local rough = v.lost or v.rounding and v.rounding > s.limit / 2
  local wider = rough and s.sure ~= motion
  -- roundings alone are too much
  local exact = v.steps and v.steps <= s.limit / 2 or rough and not (v.lost or wider)
  local steps = not exact and not motion.closed and by_steps(s, v, wider and s.sure or motion)
  if steps then
    list[1] = (wider and "--real double with " or "") .. steps
  elseif exact or motion.emitted and not motion.step then
    list[1] = by_digits(s)
  elseif motion.step then
    list[1] = (wider and "--real double with " or "") .. "a much smaller --step than " .. short(motion.step)
  end
  if motion.step and not exact then
    list[#list + 1] = motion.adaptive and "no --step: " .. motion.method .. " then chooses its own" or
      "--method adaptive, which chooses its own steps"
  end
  if motion.exact and not motion.closed then list[#list + 1] = "--engine generated --method exact" end
  if v.lost and not steps or #list == 0 then
    list[#list + 1] = "times nearer to 0: the motion magnifies every error until nothing is left"
  end
  return table.concat(list, "; or ")
end

-- ---- how wrong it is ----

local function amount(v)
  if v.error == math.huge then return "not finite" end
  if v.error > 10 then return "more than 10 (" .. v.group .. ")" end
  if v.group == "attitude" then
    return short(v.error) .. " (attitude: " .. short(4 * math.asin(math.min(2 ^ -0.5, v.error / 2))) .. " rad)"
  end
  return short(v.error) .. " (" .. v.group .. ", in parts of the largest)"
end

local function sentence(s, v)
  return string.format("%s at t = %.4g s, above %s from t = %.4g s on", amount(v), v.t,
    (string.gsub(string.format("%.0e", s.limit), "e%-0", "e-")), v.since)
end

local function help(text) return text ~= "" and "\n  what helps: " .. text or "" end

local function how(motion)
  if motion.step then return " with steps of " .. short(motion.step) .. " s" end
  return motion.tolerance and " with tolerance " .. short(motion.tolerance) or ""
end

function advice.warning(s, v)
  local motion = s.motion
  local said = v.lost and string.format("no digit is known from t = %.4g s on: there even better runs differ by %s",
    v.t, short(v.error)) or "its error is estimated at " .. sentence(s, v)
  if v.rounding and v.error < math.huge then
    said = said .. string.format(" (of the steps %s, of rounding %s)", short(v.steps), short(v.rounding))
  end
  return motion.method .. how(motion) .. ": " .. said .. help(advice.advice(s, v)) .. "\n"
end

function advice.conditioned(s, v)
  return string.format("%s: the last digit of t, or of any number of the scene, changes the state by %s%s\n",
    s.motion.method, sentence(s, v), help "times nearer to 0")
end

function advice.linearised(s, v, share)
  return string.format("linearised: the exact motion differs by %s; the transverse rates are %s of the spin, and " ..
    "terms of the order of their square are left out%s\n", sentence(s, v), short(share), help "--method exact")
end

return advice
