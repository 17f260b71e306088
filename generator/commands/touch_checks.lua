-- touch_checks.lua -- the integrals of a body on a plane, by the library's rates of change: `polhode check`.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local drawn = require "generator.commands.drawn"
local numeric = require "generator.dynamics.numeric"
local state = require "generator.dynamics.state"
local touch_laws = require "generator.dynamics.touch_laws"

local touch_checks = {}

local states = 50

-- The gradient is summed from terms that cancel by some hundred times at a random state.
local bound = 4096 * 2.0 ^ -52

-- The rate of a law as a part of its terms and of its value times the size of w: the worst of random states.
local function rate(job, library, law, random, scale)
  local env, worst = {}, 0.0
  for _, p in ipairs(job.model.params) do env[p.name] = R.todouble(p.default) end
  local slope = { t = calculus.diff(law.e, state.t) }
  for i, s in ipairs(job.states) do slope[i] = calculus.diff(law.e, s.sym) end
  for _ = 1, states do
    local x, t = drawn.state(job, random, scale, "double"), math.abs(random())
    local rates = numeric.part(job, (library:rates(t, numeric.whole(job, x))))
    env.t = t
    for i, s in ipairs(job.states) do env[s.name] = x[i] end
    local sum = evaluate.double(slope.t, env)
    local size = math.abs(sum) + math.abs(evaluate.double(law.e, env)) * scale.rates
    for i in ipairs(job.states) do
      local term = evaluate.double(slope[i], env) * rates[i]
      sum, size = sum + term, size + math.abs(term)
    end
    local part = size > 0 and math.abs(sum) / size or 0.0
    if part ~= part then part = math.huge end
    worst = math.max(worst, part)
  end
  return worst
end

function touch_checks.run(host, job, tap, name, random, scale)
  local laws = touch_laws.of(job.model)
  if #laws == 0 then return end
  local library = assert(host.rates(numeric.scene(job)))
  for _, law in ipairs(laws) do
    local worst = rate(job, library, law, random, scale)
    tap.ok(worst <= bound, name .. ": " .. string.gsub(law.key, "_", " ") .. " has the rate 0 at states drawn",
      string.format("%.2g of its terms", worst))
  end
end

return touch_checks
