-- costs.lua -- the cost sheet: operations of emitted functions, and what they take on small processors and large.
--
--     costs.rows(job, set_up)   list of {name, counts (cost/ops.lua), cycles (as targets.list)}; job: a unit
-- The functions that one calls again and again: the steppers and the closed form's evaluations; set_up: NAME_solve too.
-- SPDX-License-Identifier: GPL-3.0-or-later

local ops = require "generator.cost.ops"
local targets = require "generator.cost.targets"

local costs = { targets = targets.list }

-- To three digits: more would say more than is known.
local function rounded(x)
  local unit = 1
  while x / unit >= 1000 do unit = unit * 10 end
  return math.floor(x / unit + 0.5) * unit
end

function costs.rows(job, set_up)
  local names, rows = {}, {}
  for i, s in ipairs(job.steppers) do
    names[i] = i == 1 and "step" or s.method.name .. "_step"
  end
  for i = 1, job.compensated and #names or 0 do names[#names + 1] = names[i] .. "_compensated" end
  if set_up then names[#names + 1] = "solve" end
  for _, name in ipairs { "at", "at_rates", "at_centre", "at_attitude", "at_tick" } do names[#names + 1] = name end
  for _, name in ipairs(names) do
    local counts = ops.call(job, name)
    if counts then
      local cycles = {}
      for i, target in ipairs(targets.list) do
        cycles[i] = string.format("%d", rounded(targets.cost(target, job.real, counts)))
      end
      rows[#rows + 1] = { name = name, counts = counts, cycles = cycles }
    end
  end
  return rows
end

return costs
