-- drawn.lua -- states, inputs and parameters drawn at random for the checks of `polhode check`.
--
-- Random numbers come from a fixed seed, so a failure repeats.  Parameters are drawn within a factor 2 of their
-- defaults, closer each time that the emitted NAME_init refuses them; the library then gets the same doubles.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"
local contact = require "generator.dynamics.contact"
local inputs = require "generator.dynamics.inputs"
local numeric = require "generator.dynamics.numeric"

local drawn = {}

-- xorshift64*: the same sequence on every machine (Marsaglia 2003, Vigna 2016)
function drawn.numbers(seed)
  local s = seed
  return function() -- uniform in (-1, 1)
    s = s ~ (s >> 12)
    s = s ~ (s << 25)
    s = s ~ (s >> 27)
    return ((s * 2685821657736338717) >> 11) * 2.0 ^ -52 - 1
  end
end

-- An attitude drawn at random, of any length; within 38 degrees of the scene's own where the body's surface need not
-- touch the plane in every attitude.
local function attitude(job, random)
  local q, plane = { random(), random(), random(), random() }, contact.of(job.model)
  if not (plane and plane.a.surface.open) then return q end
  local own = {}
  for i, x in ipairs(numeric.initial(job)) do
    local s = job.states[i]
    if s.kind == "attitude" then own[s.place] = x end
  end
  return vec.qmul(own, { 1.0, q[2] / 5, q[3] / 5, q[4] / 5 })
end

-- scale: by the kind of state, see scales
function drawn.state(job, random, scale, real)
  local x, q, n = {}, nil, 0
  if job.model.has.attitude then
    q = attitude(job, random)
    for i = 1, 4 do n = n + q[i] * q[i] end
    n = math.sqrt(n)
    if n < 0.1 then return drawn.state(job, random, scale, real) end
  end
  for i, s in ipairs(job.states) do
    x[i] = numeric.narrow(s.kind == "attitude" and q[s.place] / n or random() * scale[s.kind], real)
  end
  return x
end

-- Inputs with limits are also drawn beyond them, by a quarter of their range.
function drawn.input(job, random, scale, real)
  local u = {}
  for i, s in ipairs(job.model.inputs) do
    local low, high = inputs.range(job.model, s)
    local middle, half = 0.0, scale
    if low then middle, half = R.todouble(low + high) / 2, R.todouble(high - low) * 0.75 end
    u[i] = numeric.narrow(middle + random() * half, real)
  end
  return u
end

-- Random parameters, of which the plugin is made.  At the latest they are the scene's own, which it has accepted.
function drawn.parameters(job, random, plugin, real)
  for k = 100, 0, -1 do
    local list, values = {}, {}
    for i, p in ipairs(job.model.params) do
      local x = numeric.narrow(R.todouble(p.default) * 2.0 ^ (random() * k / 100), real)
      list[i], values[p.name] = x, R.fromdouble(x)
    end
    if plugin:init(list) == 0 then return values end
  end
  error "parameters of a body that the emitted code refuses"
end

return drawn
