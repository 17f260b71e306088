-- numeric.lua -- a scene as plain numbers, for the general library.
--
-- The library gets the SHAPES and the effects, not our tensor: it computes mass properties and motion by its own
-- formulas, which is what makes it a second road.  Parameters take given values (their defaults, or random ones).
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local vec = require "generator.algebra.vec"
local context = require "generator.dynamics.context"
local numeric_body = require "generator.dynamics.numeric_body"
local postfix = require "generator.dynamics.postfix"
local state = require "generator.dynamics.state"

local numeric = {}

local none = { expr.zero, expr.zero, expr.zero }

-- job: a scene; values: {name -> rational} for all parameters (nil: defaults); lines: inputs run along straight lines.
-- Returns {name, body, origin, effects, q, w, r, v} as the host's engine takes it.
function numeric.scene(job, values, lines)
  local m, record = job.model, job.record
  local env = {}
  for _, p in ipairs(record.params) do env[p.name] = values and values[p.name] or p.default end
  local function exact(e) return evaluate.precise(e, env, 240) end
  local function num(e) return R.todouble(exact(e)) end
  local function nums(v) return vec.map(v, num) end
  local body_tree = numeric_body(record.body, m.origin, exact)
  if not job.states then return { body = body_tree } end -- asked for while the model is made
  local effects, dry = {}, context.dry(m)
  dry.lines = lines
  -- of states from 0, of inputs minus their number from 1
  local place = {}
  for k, s in ipairs(state.known) do place[s.name] = k - 1 end
  for i, k in ipairs((numeric.positions(job))) do place[job.states[i].name] = k - 1 end
  for i, s in ipairs(m.inputs) do place[s.name] = -i end
  for i, name in ipairs { "@nx", "@ny", "@nz" } do place[name] = i - 1 end -- a support function takes its normal for x
  local function code(e) return postfix.of(e, exact, place) end
  for _, e in ipairs(m.record.effects) do -- those that act
    local more
    effects[#effects + 1], more = e.spec.numeric(e.a, num, record.given, code, context.with(dry, e))
    effects[#effects + 1] = more
  end
  local own = {}
  for _, s in ipairs(job.states) do
    if s.effect then own[#own + 1] = s.initial end
  end
  return { name = m.name, body = body_tree, origin = { 0.0, 0.0, 0.0 }, effects = effects, inputs = #m.inputs,
    own = nums(own), q = nums(record.attitude), w = nums(record.omega), r = nums(record.given.position or none),
    v = nums(record.given.velocity or none) }
end

-- The library's state is q and w, with r and v where the body moves, and what effects add.  Where each state of the
-- scene is in it, and how long it is.
function numeric.positions(job)
  local list, n = {}, job.model.has.position and 13 or 7
  for i, s in ipairs(job.states) do
    for k, known in ipairs(state.known) do
      if known.name == s.name then list[i] = k end
    end
    if s.effect then
      n = n + 1
      list[i] = n
    end
  end
  return list, n
end

-- The library's state for the scene's state x: no turning where the scene has none.
function numeric.whole(job, x)
  local at, n = numeric.positions(job)
  local full = { 1.0, 0.0, 0.0, 0.0 }
  for i = 5, n do full[i] = 0.0 end
  for i, k in ipairs(at) do full[k] = x[i] end
  return full
end

-- The scene's part of a list in the library's order, which begins after `offset` entries.
function numeric.part(job, full, offset)
  return vec.map((numeric.positions(job)), function(k) return full[(offset or 0) + k] end)
end

-- The library's scene `s` of the job from the state x on.
function numeric.from(s, job, x)
  local own, full = {}, numeric.whole(job, x)
  for k, v in pairs(s) do own[k] = v end -- a copy: order is lost anyway
  local after = job.model.has.position and 13 or 7
  own.q, own.w = { table.unpack(full, 1, 4) }, { table.unpack(full, 5, 7) }
  if after > 7 then own.r, own.v = { table.unpack(full, 8, 10) }, { table.unpack(full, 11, 13) } end
  own.own = { table.unpack(full, after + 1) }
  return own
end

-- A double that the real type holds exactly.
function numeric.narrow(x, real)
  if real == "float" then return string.unpack("f", string.pack("f", x)) end
  return x
end

-- The scene's initial state as doubles, parameters at their defaults.
function numeric.initial(job)
  return vec.map(job.states, function(s) return job.model:double(s.initial) end)
end

return numeric
