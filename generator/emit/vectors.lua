-- vectors.lua -- the states, cases and bounds of the emitted self-test, as values of templates/test/test*.c.
--
-- Three states: the scene's own and two fixed ones scaled to its rates.  They are rounded to the emitted real type
-- before anything is computed from them (see selftest.lua), so the expected numbers belong to exactly the inputs that
-- the C code sees.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local switching = require "generator.dynamics.switching"
local inputs = require "generator.dynamics.inputs"
local motion = require "generator.emit.motion"
local number = require "generator.emit.number"
local quantities = require "generator.dynamics.quantities"
local sensitivity = require "generator.dynamics.sensitivity"
local selftest = require "generator.emit.selftest"
local source = require "generator.emit.source"
local test_state = require "generator.emit.test_state"

local vectors = {}

local function rounder(real)
  return function(q) return R.fromdouble(real == "float" and R.tofloat(q) or R.todouble(q)) end
end

-- Numbers three to a line, with commas.
local function lines(list, real)
  local out = {}
  for i = 1, #list, 3 do
    local row = {}
    for k = i, math.min(i + 2, #list) do row[#row + 1] = number.text(list[k], real) .. (k < #list and "," or "") end
    out[#out + 1] = table.concat(row, " ")
  end
  return out
end

-- The function's equations, whether it is emitted or another one only needs it.
local function equations_of(job, name)
  for _, f in ipairs(job.functions) do
    if f.name == name then return f end
  end
  return nil
end

-- The same if it is emitted.
local function description(job, name)
  return job.selection.asked(name) and equations_of(job, name) or nil
end

-- 2^n next below the largest of the list; nil if all are 0
local function power_of(list)
  local most = R.zero
  for _, x in ipairs(list) do
    if R.abs(x) > most then most = R.abs(x) end
  end
  return R.sign(most) > 0 and R.new(2) ^ R.log2(most) or nil
end

-- sqrt |J_ij J_ji| and |J_ii| of the Jacobian have the dimension of a rate whatever the states' units: a power of two
-- near the largest at the initial state, or nil.
local function rate_of(job, env, own)
  local n, state = #job.states, { t = R.zero }
  for i, s in ipairs(job.states) do state[s.name] = own[i] end
  for i, s in ipairs(job.model.inputs) do state[s.name] = inputs.sample(job.model, s, i) end
  local f = equations_of(job, "jacobian") or { groups = sensitivity.tangent(job.model, job.equations.groups,
    sensitivity.nothing(job.states), {}, job.states, "J") }
  local J = selftest.expect(f, env, state, function(o) return o.index + 1 end, R.one)
  local list = {}
  for i = 1, n do
    for k = 1, n do list[#list + 1] = J[(i - 1) * n + k] * J[(k - 1) * n + i] end
  end
  local square = power_of(list)
  return square and R.new(2) ^ (R.log2(square) // 2)
end

-- The three states {name, values}; the time of half a radian of the fastest rate, and a scale of all states.
local function states(job, round, env)
  local m, own = job.model, {}
  for i, s in ipairs(job.states) do own[i] = round(m:number(s.initial)) end
  local function of(k) -- the initial values of one kind
    local list = {}
    for i, s in ipairs(job.states) do
      if s.kind == k then list[#list + 1] = own[i] end
    end
    return list
  end
  local power = power_of(of "rates")
  if not job.equations.free or not power then
    local rate = not job.equations.free and rate_of(job, env, own)
    if rate and (not power or rate > power) then power = rate end
  end
  local scale, time = { rates = power or R.one }, power and R.new(1, 2) / power
  if m.has.position then
    local longest = m:number(m.horizon) / R.new(16)
    if not time or time > longest then time = longest end
    local x = { t = R.zero }
    for i, s in ipairs(job.states) do x[s.name] = own[i] end
    for i, s in ipairs(m.inputs) do x[s.name] = inputs.sample(m, s, i) end
    local a, tail = {}, {}
    for i, s in ipairs(job.states) do tail[s.name] = i end
    local f = equations_of(job, "rhs") or quantities.rhs(job.equations)
    local dx = selftest.expect(f, env, x, function(o) return tail[o.state] end, R.one)
    for i, s in ipairs(job.states) do
      if s.kind == "velocity" then a[#a + 1] = dx[i] * time end
    end
    for _, v in ipairs(of "velocity") do a[#a + 1] = v end
    scale.velocity = power_of(a) or R.one
    local r = of "position"
    r[#r + 1] = scale.velocity * time
    scale.position = power_of(r) or R.one
  end
  local function made(name)
    local x, q = {}, m.has.attitude and test_state.attitude(job, name, own, round)
    for i, s in ipairs(job.states) do
      local turns = s.kind == "attitude"
      x[i] = turns and q[s.place] or R.lift(test_state.vector[name][(s.place - 1) % 3 + 1])
      if not turns then x[i] = x[i] * (scale[s.kind] or power_of { own[i] } or R.one) end
    end
    return { name = name, values = x }
  end
  local size = R.one
  for _, k in ipairs { "rates", "position", "velocity" } do
    if m.has[k] and scale[k] > size then size = scale[k] end
  end
  for i, s in ipairs(job.states) do -- an effect's own
    if s.effect and R.abs(own[i]) > size then size = R.abs(own[i]) end
  end
  local x2 = made "x2"
  if m.has.position then -- drag may be faster than at rest
    local rate = rate_of(job, env, x2.values)
    if rate and rate * time > R.new(1, 2) then time = R.new(1, 2) / rate end
  end
  if job.smooth_until and (not time or time > job.smooth_until) then time = job.smooth_until end
  return { { name = "x1", values = own }, x2, made "x3" }, R.round(time or R.new(1, 2), 24), size
end

local rest = { -- inputs of functions that take vectors: w, dw, a, r, v, N
  w = { "3/4", "-5/8", "9/16" }, dw = { "-1/2", "7/8", "1/4" }, a = { "1/4", "-3/8", "5/8" },
  r = { "5/8", "3/4", "-1/2" }, v = { "-7/8", "1/8", "3/8" }, da = { "1/2", "3/8", "-1/8" },
}

local function by_index(o) return o.index and o.index + 1 end
local function result(o) return o.result and 1 end

-- The function of what the motion conserves, where a free body's energy and momentum are not all; nil if nothing is.
function vectors.conserved(job)
  if job.equations.free and job.model.has.attitude then return nil end
  return job.conserved.rate and "jacobi_integral" or job.conserved.is["T+V"] and "energy" or nil
end

-- What the checks of the transition matrix and of the steps' order need beside the cases.
local function of_steps(job, made, v, epsilon, time, real)
  local offers, eq = made.offers, job.equations
  local conserved = vectors.conserved(job)
  local order = job.steppers[1].method.order or 4 -- a series has at least 4
  local spins = made.parts.stability.say
  v.fine_steps, v.low_order, v.low_order_error = order >= 4, string.format("%d", order), order >= 4 and "" or " + d2"
  v.low_order_falls = string.format("%d", 1 << order)
  v.low_order_bound = number.text(R.new(3, 4) * R.new(2) ^ order, real)
  v.has_corners = #switching.corners(eq) > 0
  v.test_steps, v.test_follows = offers.step, offers.step and offers.rhs
  v.check_free = v.test_steps and eq.free and job.model.has.attitude and v.fine_steps and offers.energy and
    offers.momentum
  v.check_conservative = v.test_steps and conserved ~= nil and v.fine_steps and offers[conserved]
  local at = job.closed.full and "at" or job.closed.centre and "at_centre" or "at_rates"
  v.test_closed = v.test_steps and offers.solve and offers[at]
  v.test_principal = offers.principal and offers.linearised and offers.inertia
  v.test_spins = spins ~= nil and spins.numeric and offers.spin_stable and offers.stability and offers.principal
  v.test_compensated = v.test_steps and offers.step_compensated
  v.has_transition = v.test_steps and offers.step_transition and job.transition or false
  v.has_transition_case = description(job, "step_transition") ~= nil
  if not (v.has_transition or v.test_compensated) then return end
  v.has_differences = not v.has_corners -- next to a corner there is no derivative
  v.state_kinds = source.kinds(job.states)
  v.displacement = number.text(R.new(2) ^ (real == "float" and -5 or -14), real)
  v.roundings = number.text(epsilon * R.new(selftest.roundings), real)
  v.transition_step = number.text(time, real)
end

-- What the cases are made of: numbers of the emitted type, the environment of the formulas, three states.
local function kit_of(job, made)
  local real = made.ctx.real
  local kit = { job = job, made = made, real = real, round = rounder(real), held = { t = R.zero }, arguments = {},
    epsilon = R.lift(R.new(2) ^ (real == "float" and -23 or -52)), params = {},
    least = R.new(2) ^ (real == "float" and -126 or -1022) }
  local m, names = job.model, { "x", "y", "z" }
  for _, p in ipairs(m.params) do kit.params[p.name] = kit.round(p.default) end
  for i, s in ipairs(m.inputs) do kit.held[s.name] = kit.round(inputs.sample(m, s, i)) end
  for name, list in pairs(rest) do -- into a table: order is lost anyway
    kit.arguments[name] = {}
    for i = 1, 3 do kit.arguments[name][name .. names[i]] = R.lift(list[i]) end
  end
  kit.env = selftest.environment(m, kit.params, job.held)
  kit.states, kit.time, kit.size = states(job, kit.round, kit.env)
  return kit
end

-- What f is given: the state x, and those of the vectors that it takes, and no others, for a constant of the model may
-- be called like one.
local function given(kit, f, x)
  local list = {}
  for k, q in pairs(kit.held) do list[k] = q end -- into a table: order is lost anyway
  for _, a in ipairs(f.args) do
    for k, q in pairs(type(a) == "table" and kit.arguments[a.name] or {}) do list[k] = q end -- order is lost
  end
  for i, s in ipairs(x and kit.job.states or {}) do list[s.name] = x[i] end
  return list
end

-- A case as text.
local function printed(kit, n, want, tolerance, call, what)
  local least = kit.least
  for i = 1, n do
    want[i], tolerance[i] = want[i] or R.zero, tolerance[i] or R.zero
    -- below the smallest normal number relative rounding ends
    if R.sign(tolerance[i]) > 0 and tolerance[i] < least then tolerance[i] = least end
    -- nothing is known of a derivative next to a corner, but the bound must be a number of the type
    if tolerance[i] > R.one / least then tolerance[i] = R.one / least end
    if R.abs(want[i]) < least then want[i] = kit.round(want[i]) end
  end
  return { n = string.format("%d", n), want = lines(want, kit.real), tolerance = lines(tolerance, kit.real),
    call = call, what = what }
end

-- How many numbers the widest matrix has, as text of C.
local function widest(job, ctx)
  local nx, np, columns = #job.states, #job.model.params, "_NX"
  if description(job, "jacobian_p") and np > nx then columns = "_NP" end
  if description(job, "jacobian_u") and #job.model.inputs > math.max(nx, columns == "_NP" and np or 0) then
    columns = "_NU"
  end
  local size = nx < 4 and columns == "_NX" and "16" or ctx.upper .. "_NX*" .. ctx.upper .. columns
  return nx < 4 and columns ~= "_NX" and "16 + " .. size or size
end

-- Cases of functions: which function, with which state, how many numbers, how it is called.
local function cases_of(kit, short)
  local job, xs, zero, list = kit.job, kit.states, kit.made.base.zero, {}
  local m, position = job.model, {}
  for i, s in ipairs(job.states) do position[s.name] = i end
  local function case(name, n, state, call, what, index, depth)
    local f = description(job, name)
    if not f then return end
    local want, tolerance = selftest.expect(f, kit.env, given(kit, f, state), index, (depth or R.one) * kit.epsilon)
    list[#list + 1] = printed(kit, n, want, tolerance, call, what)
  end
  local p, nx, np, nu = m.name .. "_", #job.states, #m.params, #m.inputs
  local function of_state(o) return o.state and position[o.state] or by_index(o) end
  case("inertia", 6, nil, p .. "inertia(&m, got)", "tensor of inertia about the origin", by_index)
  case("initial", nx, nil, p .. "initial(&m, got)", "initial state", of_state)
  case("mass", 4, nil, "got[0] = " .. p .. "mass(&m, got + 1)", "mass and centre of mass",
    function(o) return o.result and 1 or by_index(o) + 1 end)
  for i, x in ipairs(xs) do
    case("rhs", nx, x.values, p .. "rhs(&m, " .. zero .. ", " .. x.name .. ", u, got)",
      "rates of change at state " .. i, of_state)
    case("energy", 1, x.values, "got[0] = " .. p .. "energy(&m, " .. x.name .. ")", "energy at state " .. i, result)
    case("jacobi_integral", 1, x.values, "got[0] = " .. p .. "jacobi_integral(&m, " .. zero .. ", " .. x.name .. ")",
      "Jacobi's integral at state " .. i, result)
    case("momentum", 3, x.values, p .. "momentum(&m, " .. x.name .. ", got)", "angular momentum at state " .. i,
      by_index)
  end
  local x2 = xs[2].values
  case("momentum_body", 3, x2, p .. "momentum_body(&m, x2, got)", "angular momentum in body axes", by_index)
  case("particle_energy", 1, x2, "got[0] = " .. p .. "particle_energy(&m, x2)", "kinetic energy of the particles",
    result)
  case("inertia_at", 6, nil, p .. "inertia_at(&m, a, got)", "tensor about another point", by_index)
  case("inertia_now", 6, x2, p .. "inertia_now(&m, x2, got)", "tensor with moving parts", by_index)
  local torque = description(job, "torque")
  case("torque", 3, torque and torque.stateful and x2 or nil, p .. "torque(&m, " ..
    (torque and torque.stateful and zero .. ", x2, u" or "w") .. ", dw, got)", "torque of a given motion", by_index)
  case("rate", 3, nil, p .. "rate(w, a, da, got)", "rate of change of a vector", by_index)
  local term = { coriolis = 0, euler = 3, centripetal = 6, total = 9 }
  case("acceleration", 12, nil, p .. "acceleration(w, dw, r, v, a, got, got + 3, got + 6, got + 9)",
    "acceleration: Coriolis, Euler, centripetal, total", function(o) return term[o.array] + o.index + 1 end)
  case("jacobian", nx * nx, x2, p .. "jacobian(&m, " .. zero .. ", x2, u, got)",
    "Jacobian of the equations at state 2", by_index)
  case("jacobian_u", nx * nu, x2, p .. "jacobian_u(&m, " .. zero .. ", x2, u, got)",
    "derivative of the equations by the input at state 2", by_index)
  case("jacobian_p", nx * np, x2, p .. "jacobian_p(&m, " .. zero .. ", x2, u, got)",
    "derivative of the equations by the parameters at state 2", by_index)
  case("initial_p", nx * np, nil, p .. "initial_p(&m, got)", "derivative of the initial state by the parameters",
    by_index)
  kit.held.h = short
  case("step_transition", nx * nx, x2, "transition(&m, x2, u, " .. number.text(short, kit.real) .. ", got)",
    "transition matrix of a step from state 2", by_index, selftest.stages)
  case("step_transition_u", nx * nu, x2, p .. "step_transition_u(&m, " .. zero .. ", x2, u, " ..
    number.text(short, kit.real) .. ", got)", "derivative of a step from state 2 by the input", by_index,
    selftest.stages)
  kit.held.h = nil
  return list
end

-- Cases of the closed form, of those functions that are emitted.
local function motion_cases(kit)
  local job, made, list = kit.job, kit.made, {}
  local p = job.model.name .. "_"
  for _, c in ipairs(made.offers.solve and motion.cases { job = job, x0 = kit.states[1].values,
    power = R.new(1, 2) / (kit.time or R.half), env = kit.env, params = kit.params, epsilon = kit.epsilon,
    real = kit.real, name = job.model.name, has_own = made.parts.closed.own, has_ticks = job.closed.ticks or false,
    number = function(q) return number.text(q, kit.real) end } or {}) do
    local whole = true
    for f in string.gmatch(c.call, "%f[%w_]" .. p .. "([%w_]+)") do whole = whole and made.offers[f] end
    if whole then list[#list + 1] = printed(kit, 7, c.want, c.tolerance, c.call, c.what) end
  end
  return list
end

-- The vectors, states and inputs that the cases name.
local function named_by(kit, v)
  local calls, m = {}, kit.job.model
  for i, c in ipairs(v.cases) do calls[i] = c.call end
  local called = table.concat(calls, "\n")
  local function named(name) return string.find(called, "%f[%w_]" .. name .. "%f[^%w_]") ~= nil end
  v.vectors, v.states = {}, {}
  for _, name in ipairs { "w", "dw", "r", "v", "a", "da" } do
    if named(name) then
      local list = {}
      for k = 1, 3 do list[k] = R.lift(rest[name][k]) end
      v.vectors[#v.vectors + 1] = { name = name, values = table.concat(lines(list, kit.real), " ") }
    end
  end
  local start, moved = v.test_start and not v.offers.initial, v.has_transition or v.test_compensated
  for _, x in ipairs(kit.states) do
    if named(x.name) or x.name == "x1" and start or x.name == "x2" and moved then
      v.states[#v.states + 1] = { name = x.name, lines = lines(x.values, kit.real) }
    end
  end
  v.uses_inputs = named "u" or moved
  local list, spans = {}, {}
  for i, s in ipairs(m.inputs) do
    local low, high = inputs.range(m, s)
    local held = kit.held[s.name]
    list[i], spans[i] = number.text(held, kit.real), number.text(low and high - low or held, kit.real)
  end
  v.input_values, v.input_spans = table.concat(list, ", "), table.concat(spans, ", ")
end

-- The bounds of the tests of order, length and drift.
local function bounds_of(kit, v)
  local job, epsilon, real = kit.job, kit.epsilon, kit.real
  -- The test of order runs over about half a radian: h w = 1/64 and less, where the fourth-order term leads and still
  -- stands above rounding (float: the floor of 64 roundings of the state).
  v.order_time = number.text(kit.time, real)
  for name, n in pairs { order_two = 2, order_four = 4, order_six = 6 } do -- into a table: order is lost anyway
    v[name] = number.text(R.new(n), real)
  end
  local roundings, program = 256, job.steppers[1].program
  if program and program.drift and program.drift.kind == "full" then -- of that many rotations a step, walking
    local rotations = (#program.outer.b + 1) * (2 * #program.inner.b + 1)
    roundings = roundings * math.ceil(math.sqrt(rotations))
  end
  v.order_floor = number.text(R.round(kit.size * epsilon * R.new(roundings), 24), real)
  v.norm_bound, v.jacobi_bound = number.text(epsilon * R.new(16), real), number.text(epsilon * R.new(64), real)
  -- float: e^2 must stay above 256 roundings of 1
  v.disturbance = number.text(R.new(2) ^ (real == "float" and -6 or -10), real)
  v.disturbance_step, v.drift = number.text(R.new(1, 256), real), number.text(epsilon * R.new(4096), real)
  if not v.check_conservative then return end
  local most = kit.least -- relative to the terms of the energy at the largest of the three states
  for _, x in ipairs(kit.states) do
    local f = equations_of(job, vectors.conserved(job))
    local _, tolerance = selftest.expect(f, kit.env, given(kit, f, x.values), result, epsilon)
    if tolerance[1] > most then most = tolerance[1] end
  end
  v.energy_drift = number.text(R.round(most * R.new(4096 // selftest.roundings), 24), real)
end

-- made: from code.of.
function vectors.of(job, made)
  local base, offers, kit = made.base, made.offers, kit_of(job, made)
  local v, short = { offers = offers, got_size = widest(job, made.ctx) }, R.round(kit.time / R.new(32), 24)
  v.cases = cases_of(kit, short)
  of_steps(job, made, v, kit.epsilon, short, kit.real)
  v.motion_cases = motion_cases(kit)
  v.has_cases = #v.cases > 0 or #v.motion_cases > 0 or v.test_closed or job.planned ~= nil
  v.test_orbit = v.test_closed or #v.motion_cases > 0
  v.test_start = v.test_steps or v.test_closed or #v.motion_cases > 0
  v.test_index = v.test_steps and base.has_attitude or v.test_closed or v.test_start and not offers.initial
  v.test_distance = v.test_steps or v.test_principal
  v.spin_cases = {}
  for i, c in ipairs(offers.spin_stable and selftest.spins(job, kit.params) or {}) do
    v.spin_cases[i] = { axis = string.format("%d", c.axis), dissipation = string.format("%d", c.dissipation),
      want = string.format("%d", c.want), tail = c.last and "," or " &&" }
  end
  v.has_spin_cases = #v.spin_cases > 0
  named_by(kit, v)
  bounds_of(kit, v)
  return v
end

return vectors
