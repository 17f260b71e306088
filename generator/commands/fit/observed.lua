-- observed.lua -- are the states there that a scene's `measure` speaks of?
--
--     observed.check(job) -> true | nil after errors in job.diag
-- The key is read before it is known which states the scene has.  The dimension of a state that is given by its name is
-- filled in here.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local units = require "generator.dsl.units"
local nearest = require "generator.nearest"

local observed = {}

local function names_of(states)
  local list = {}
  for i, s in ipairs(states) do list[i] = s.name end
  return list
end

-- Every state of an output's expressions, by name.
local function states_of(o)
  local list = {}
  for _, e in ipairs(o.e or {}) do
    for _, s in ipairs(expr.symbols(e)) do
      if s.rank == motion.rank and s.name ~= "t" then list[#list + 1] = s.name end
    end
  end
  return o.e and list or { "qw", "qx", "qy", "qz" }
end

function observed.check(job)
  local states, ok = job.states, true
  for _, o in ipairs(job.record.measure) do
    for _, name in ipairs(states_of(o)) do
      if not states.by_name[name] then
        local names = names_of(states)
        local best = nearest.one(name, names)
        job.diag:error(o.line, "measure", o.name .. ": the scene has no state " .. name .. " (it has " ..
          table.concat(names, ", ") .. ")" .. (best and "; did you mean " .. best .. "?" or ""))
        ok = false
        break
      end
    end
    for i, dim in ipairs(ok and o.dims or {}) do
      if not dim then o.dims[i] = select(2, units.parse(states.by_name[o.e[i].name].unit)) end
    end
  end
  return ok or nil
end

return observed
