-- derivative.lua -- what a law of the motion changes by, along the equations of the whole scene.
--
-- dF/dt = dF/dx x' + dF/dt of a quantity F(x, t), at states that have nothing special about them, with parameters that
-- have moved off their defaults, in 240 bits.  What vanishes there to 140 bits against its largest term vanishes by
-- its form: numbers of a scene do not cancel to 42 digits by chance.  So a law that every effect keeps when it is alone
-- is claimed only if it is kept with all of them together.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local motion = require "generator.algebra.motion"
local vec = require "generator.algebra.vec"
local context = require "generator.dynamics.context"
local equations = require "generator.dynamics.equations"
local state = require "generator.dynamics.state"

local derivative = {}

local bits, digits, samples = 240, 140, 3

-- Fractions in [-1, 1) without a pattern, the same ones every time (Park and Miller's generator with 48271).
local function fractions(seed)
  return function()
    seed = seed * 48271 % 2147483647
    return R.new(seed - 1073741824, 1073741824)
  end
end

-- A unit quaternion of rationals.
-- (1 - s, 2 a, 2 b, 2 c)/(1 + s), s = a^2 + b^2 + c^2: the sphere by stereographic projection, all without a root.
local function attitude(random)
  local a, b, c = random(), random(), random()
  local s, two = a * a + b * b + c * c, R.new(2)
  local over = R.one / (R.one + s)
  return { (R.one - s) * over, two * a * over, two * b * over, two * c * over }
end

-- Values of all that an expression of the motion can have in it, by name: derived constants, states, inputs, t.
-- Parameters within a 16th of their defaults, states of the size of their initial values.
local function environment(m, random, precision)
  local params, env = {}, {}
  for _, p in ipairs(m.params) do
    local r = random()
    params[p.name] = R.sign(p.default) == 0 and R.abs(r) or p.default * (R.one + r / R.new(16))
  end
  local value = evaluate.within(params, precision)
  for _, member in ipairs(m.members) do env[member.name] = value(member.e) end
  local horizon, q = m:number(m.horizon), attitude(random)
  for _, s in ipairs(m.states) do
    local initial = R.abs(m:number(s.initial))
    env[s.name] = s.kind == "attitude" and q[s.place] or random() * (R.sign(initial) == 0 and R.one or initial)
  end
  for _, u in ipairs(m.inputs) do env[u.name] = random() end
  env.t = R.abs(random()) * horizon
  for k, v in pairs(params) do env[k] = env[k] or v end -- into a table: order is lost anyway
  return env
end

-- What the laws are of: T + V, the momentum in body axes and in those of the base, as expressions without constants.
local function quantities_of(m)
  local c = context.dry(m)
  local T, V = context.energy(m, c, "kinetic"), context.energy(m, c, "potential")
  local out = { turning = context.energy(m, c, "turning") }
  if m.has.rates then
    out.L = context.momentum(m, false)
    T = T + vec.dot(state.w, vec.apply((context.now(m, false)), state.w)) / 2
    if m.has.attitude then out.inertial = vec.matvec(vec.rotation(state.q), out.L) end
  end
  if m.has.position then T = T + m.mass * vec.dot(state.v, state.v) / 2 end
  out.energy = T + calculus.substitute(V, { [context.M] = m.mass })
  return out
end

-- The laws by name as lists of quantities that are constant.
local function laws(m, rate)
  local f, list = quantities_of(m), {}
  list["T+V"] = { f.energy }
  if f.L then list["|L|"] = { vec.dot(f.L, f.L) } end
  if f.inertial then
    list.L, list.L_z = f.inertial, { f.inertial[3] }
    if rate then list["T+V-n.L"] = { f.energy + f.turning - rate * f.inertial[3] } end
  end
  list.w3 = { state.w[3] }
  return list
end

-- The scene as a function: law -> does it hold?  rate: of the fields that turn, or nil.
function derivative.of(eq, rate)
  local m, rates, inlined = eq.model, {}, equations.inlined(eq.groups)
  for _, g in ipairs(eq.groups) do
    for _, o in ipairs(g.outs) do rates[o.state] = inlined(o.expr) end
  end
  local list, t = laws(m, rate), motion.sym "t"
  -- The values at sample n, made when they are first asked for.
  local here = {}
  local function sample(n, precision)
    local at = here[precision + n]
    if not at then
      at = { value = evaluate.within(environment(m, fractions(1000 + n), precision), precision), dx = {} }
      for name, e in pairs(rates) do at.dx[name] = at.value(e) end -- into a table: order is lost anyway
      here[precision + n] = at
    end
    return at
  end
  -- F' at a sample, and the sum of the moduli of its terms.
  local function slope(explicit, slopes, at, precision)
    local sum = at.value(explicit)
    local size = R.abs(sum)
    for _, s in ipairs(m.states) do
      if slopes[s.name] then
        local term = at.value(slopes[s.name]) * at.dx[s.name]
        sum, size = R.round(sum + term, precision), R.round(size + R.abs(term), precision)
      end
    end
    return R.abs(sum), size
  end
  -- |sum of terms| against the sum of |terms|, so the scale of F does not matter.
  local function still(F)
    local slopes, explicit, small = {}, calculus.diff(F, t), R.one / R.new(2) ^ digits
    for _, s in ipairs(m.states) do
      local d = calculus.diff(F, s.sym)
      if d ~= expr.zero and rates[s.name] ~= expr.zero then slopes[s.name] = d end
    end
    for n = 1, samples do
      local sum, size = slope(explicit, slopes, sample(n, bits), bits)
      if sum > size * small and slope(explicit, slopes, sample(n, 2 * bits), 2 * bits) > sum * small then
        return false
      end
    end
    return true
  end
  return function(law)
    for _, F in ipairs(list[law] or {}) do
      if not still(F) then return false end
    end
    return list[law] ~= nil
  end
end

return derivative
