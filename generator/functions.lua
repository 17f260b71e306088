-- functions.lua -- which functions a plan has, in the order in which they are emitted.
--
--     functions.of(plan) -> bool     fills functions and steppers of an open plan (generator/stages.lua), and what they
--                                    decide; false after an error in its diagnostics
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local context = require "generator.dynamics.context"
local landing = require "generator.dynamics.landing"
local quantities = require "generator.dynamics.quantities"
local sensitivity = later "generator.dynamics.sensitivity"
local tangents = later "generator.dynamics.tangents"
local compensated = later "generator.methods.compensated"
local methods = require "generator.methods.methods"
local steady = require "generator.dynamics.steady"
local upright = later "generator.dynamics.upright"
local disc = later "generator.dynamics.closed.disc"

local functions = {}

-- The steppers that are asked for, the first one as NAME_step; rk4 if none is: a list of {method, program}.  named:
-- their names are all that counts.
local function steppers(plan, options, named)
  local list = {}
  for _, name in ipairs(options.methods or {}) do
    local method, program = methods.by_name[name], nil
    local why = method and methods.refused(plan.equations, method)
    if method and method.program and named then
      program = { transition = true }
    elseif method and (method.program or why) then
      if not why then program, why = method.program(plan.equations, options) end
      if not program then
        plan.diag:error(plan.record.line, "method " .. name, why)
        return nil
      end
    end
    if method then list[#list + 1] = { method = method, program = program } end
  end
  if #list == 0 then list[1] = { method = methods.by_name.rk4 } end
  return list
end

-- The gradients of energy and momentum.
local function gradients(plan)
  local m, list = plan.model, {}
  local function put(f, name, what)
    list[#list + 1] = sensitivity.of_made(m, f, name, { "Derivative of " .. what .. " by the states, row major: G[" ..
      (name == "momentum_gradient" and "i*NX + " or "") .. "k] = d/dx[k]." })
  end
  put(quantities.energy(m), "energy_gradient", "the energy")
  if plan.conserved.rate then
    put(quantities.jacobi_integral(m, plan.conserved.rate), "integral_gradient", "Jacobi's integral")
  end
  if m.has.rates then
    put(m.has.attitude and quantities.momentum(m) or quantities.momentum_body(m), "momentum_gradient",
      "the angular momentum")
  end
  return list
end

-- Those of a body on a plane.
local function touching(m, eq, made, put)
  put("contact", quantities.contact, eq)
  for _, u in ipairs(upright.of(m)) do put("stable_" .. u.key, upright.margin, m, u) end
  for _, f in ipairs(steady.list(m, made)) do put(f.name, function() return f end) end
  if made "disc_tilt" and disc.of(m) then put("disc_tilt", disc.tilt, m) end
end

-- options: those of driver.plan; named: see steppers.
function functions.of(plan, options, named)
  local m, eq = plan.model, plan.equations
  plan.methods, plan.jacobians = options.methods, options.jacobians
  plan.steppers = steppers(plan, options, named)
  if not plan.steppers then return false end
  local list, made = {}, plan.selection.made
  local function put(name, of, ...)
    if made(name) then list[#list + 1] = of(...) end
  end
  local function put_all(more)
    for _, f in ipairs(more) do put(f.name, function() return f end) end
  end
  put("initial", quantities.initial, m)
  put("mass", function() return (quantities.mass(m)) end)
  if m.has.rates then
    put("inertia", quantities.inertia, m)
    put("inertia_at", quantities.inertia_at, m)
    if context.parts(m) then put("inertia_now", quantities.inertia_now, m) end
  end
  put("energy", quantities.energy, m)
  if plan.conserved.rate then put("jacobi_integral", quantities.jacobi_integral, m, plan.conserved.rate) end
  local particles = m.has.rates and made "particle_energy" and quantities.particle_energy(m)
  if particles then list[#list + 1] = particles end
  if m.has.rates then put("momentum_body", quantities.momentum_body, m) end
  if m.has.attitude then put("momentum", quantities.momentum, m) end
  if m.has.rates then put("torque", quantities.torque, m) end
  put("rhs", quantities.rhs, eq)
  if eq.touch then touching(m, eq, made, put) end
  if m.record.landing then
    put("gap", landing.gap, m)
    put("impact", landing.impact, m)
  end
  for i, s in ipairs(plan.steppers) do
    local name = i == 1 and "step" or s.method.name .. "_step"
    if s.method.groups then put(name, quantities.step, m, eq, s.method, name) end
  end
  put("jacobian", quantities.jacobian, eq)
  if options.jacobians then
    local more = sensitivity.list(plan, options.jacobians)
    if not more then return false end
    plan.transition = true -- of the first step, NAME_step
    put_all(more)
    if options.outputs then put_all(gradients(plan)) end
  end
  if options.compensated then
    local more = compensated.list(plan)
    if not more then return false end
    plan.compensated = true
    put_all(more)
  end
  put("rate", quantities.rate)
  put("acceleration", quantities.acceleration)
  plan.functions = list
  plan.fit = options.fit and tangents.of(plan, options.fit) or false
  return true
end

return functions
