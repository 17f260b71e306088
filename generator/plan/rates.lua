-- rates.lua -- the equations of a scene in doubles, without a compiler: x' at a state, and what a body slips there.
--
-- A walk over the expressions, some hundred times slower than the emitted code: for a few states only.
-- SPDX-License-Identifier: GPL-3.0-or-later

local evaluate = require "generator.algebra.evaluate"
local rosenbrock = require "generator.methods.rosenbrock"

local rates = {}
rates.__index = rates

-- The equations of a scene that was read, parameters at their defaults.
function rates.new(job)
  local self = setmetatable({ job = job, known = {} }, rates)
  local m = job.equations.model
  for name, q in pairs(job.model.defaults) do self.known[name] = q end -- into a table: order is lost anyway
  for _, c in ipairs(m.members) do self.known[c.name] = m:double(c.e) end
  return self
end

-- Values by name at (t, x, u), with all definitions.
local function values(self, t, x, u)
  local env = setmetatable({ t = t }, { __index = self.known })
  for i, s in ipairs(self.job.states) do env[s.name] = x[i] end
  for i, s in ipairs(self.job.model.inputs) do env[s.name] = u and u[i] or 0.0 end
  for _, g in ipairs(self.job.equations.groups) do
    for _, d in ipairs(g.defs) do env[d.name] = evaluate.double(d.expr, env) end
  end
  return env
end

-- x' at (t, x, u), a list in the order of the states.
function rates:of(t, x, u)
  local env, by_name, list = values(self, t, x, u), {}, {}
  for _, g in ipairs(self.job.equations.groups) do
    for _, o in ipairs(g.outs) do by_name[o.state] = evaluate.double(o.expr, env) end
  end
  for i, s in ipairs(self.job.states) do list[i] = by_name[s.name] or 0.0 end
  return list
end

-- The largest slip, m/s, of a body on a plane over states (rows, at t = 0: nothing that slips depends on t), and the
-- largest speed of its centre of mass along the plane; nil of what does not slide.
function rates:slip(rows, u)
  local list = rosenbrock.slips(self.job.equations)
  if #list == 0 then return nil end
  local slip, speed = 0.0, 0.0
  for _, x in ipairs(rows) do
    local env, s, v = values(self, 0.0, x, u), 0.0, 0.0
    for _, part in ipairs(list) do
      s = s + env[self.job.equations.groups[part.group].defs[part.place].name] ^ 2
      v = v + env[part.state.name] ^ 2
    end
    slip, speed = math.max(slip, math.sqrt(s)), math.max(speed, math.sqrt(v))
  end
  return slip, speed
end

return rates
