-- condition.lua -- how far the end of a motion moves when what it starts from moves: the scene's condition numbers.
--
-- Each input that is not zero, a state at t = 0 or a parameter, is changed by a relative 2^-30 in the general library;
-- the end states' difference in the measure of error.lua, over 2^-30, is that input's number, and the scene's is the
-- largest.  So one unit in the last place of the input, 2^-52, moves the end by 2^-52 times it.  (2^-30: the end states
-- are doubles, so the quotient is good to 2^-22 of itself or better, and for numbers up to 10^6 the second-order part
-- of the difference is below a thousandth.)
-- Rounding on the way changes a state by an ulp of its group's largest entry, small entries too: `state` is the same
-- number for changes of each state by 2^-30 of the norm of its group (attitude, rates, ...; error.lua).
-- `growth` is the number at T over that at T/2, of the worst input: 2 where errors grow with time, 4 with its square,
-- as in regular motions they do; more is instability, or chaos.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local err = require "generator.plan.error"

local condition = {}

local change = 2.0 ^ -30

local function size(x, at)
  local sum = 0.0
  for _, i in ipairs(at) do sum = sum + x[i] ^ 2 end
  return math.sqrt(sum)
end

local function unit(x, at)
  local norm = size(x, at)
  for _, i in ipairs(at) do x[i] = x[i] / norm end
end

-- {number =, input = name of the worst, growth =, state =, [1..n] = {name =, number =}}, or nil and why.
-- truth: what computes the scene's true motions (reference.lua).
function condition.of(truth, x0, T)
  local job = truth.job
  local times, half = err.times(T / 2), #err.times(T)
  for _, t in ipairs(err.times(T)) do times[#times + 1] = t end
  local function ends(x, values)
    local rows, why = truth:motion(x, times, values, true)
    if not rows then return nil, why end
    return { table.unpack(rows, 1, half) }, { table.unpack(rows, half + 1) }
  end
  local early, late = ends(x0)
  if not early then return nil, late end
  local out = { number = 0.0, state = 0.0 }
  local function add(name, x, values)
    local a, b = ends(x, values)
    if not a then return end -- the changed input is refused: a limit of what can be built
    local now = err.of(job, b, late) / change
    out[#out + 1] = { name = name, number = now }
    if now > out.number then
      local before = err.of(job, a, early) / change
      out.number, out.input, out.growth = now, name, before > 0 and now / before or nil
    end
  end
  -- x0 with state i changed by 2^-30 of `by`
  local function moved(group, i, by)
    local x = { table.unpack(x0) }
    x[i] = x[i] + change * by
    if group.name == "attitude" then unit(x, group) end
    return x
  end
  for _, group in ipairs(err.groups(job)) do
    local norm = size(x0, group)
    for _, i in ipairs(group) do
      if x0[i] ~= 0 then add(job.states[i].name, moved(group, i, x0[i])) end
      local _, b
      if norm > 0 then _, b = ends(moved(group, i, norm)) end
      if b then out.state = math.max(out.state, err.of(job, b, late) / change) end
    end
  end
  for _, p in ipairs(job.record.params) do
    if R.sign(p.default) ~= 0 then
      add("parameter " .. p.name, x0, { [p.name] = p.default * (R.fromdouble(1 + change)) })
    end
  end
  return out
end

return condition
