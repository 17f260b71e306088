-- condition.lua -- how far the end of a motion moves when what it starts from moves: the scene's condition number.
--
-- Each input that is not zero, a state at t = 0 or a parameter, is changed by a relative 2^-30 in the general library;
-- the end states' difference in the measure of error.lua, over 2^-30, is that input's number, and the scene's is the
-- largest.  So one unit in the last place of the input, 2^-52, moves the end by 2^-52 times it.  (2^-30: the end states
-- are doubles, so the quotient is good to 2^-22 of itself or better, and for numbers up to 10^6 the second-order part
-- of the difference is below a thousandth.)
-- `growth` is the number at T over that at T/2, of the worst input: 2 where errors grow with time, 4 with its square,
-- as in regular motions they do; more is instability, or chaos.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local err = require "generator.plan.error"
local reference = require "generator.plan.reference"

local condition = {}

local change = 2.0 ^ -30

local function unit(x, at)
  local sum = 0.0
  for _, i in ipairs(at) do sum = sum + x[i] ^ 2 end
  for _, i in ipairs(at) do x[i] = x[i] / math.sqrt(sum) end
end

-- {number =, input = name of the worst, growth =, [1..n] = {name =, number =}}, or nil and why; tick: called after
-- each of the runs (may be nil).
function condition.of(host, job, x0, T, tick)
  local times, half = err.times(T / 2), #err.times(T)
  for _, t in ipairs(err.times(T)) do times[#times + 1] = t end
  local function ends(x, values)
    local rows, why = reference.of(host, job, x, times, values, true)
    if not rows then return nil, why end
    if tick then tick() end
    return { table.unpack(rows, 1, half) }, { table.unpack(rows, half + 1) }
  end
  local early, late = ends(x0)
  if not early then return nil, late end
  local out = { number = 0.0 }
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
  local attitude = {}
  for i, s in ipairs(job.states) do
    if s.kind == "attitude" then attitude[#attitude + 1] = i end
  end
  for i, s in ipairs(job.states) do
    if x0[i] ~= 0 then
      local x = { table.unpack(x0) }
      x[i] = x[i] * (1 + change)
      if s.kind == "attitude" then unit(x, attitude) end
      add(s.name, x)
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
