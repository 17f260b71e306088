-- fmu_variables.lua -- the variables of a unit for co-simulation, as attributes of modelDescription.xml.
--
-- In the order of their value references: time, parameters, inputs, states, (with derivatives) their rates of change,
-- energy, Jacobi's integral, angular momentum.  All are real numbers in SI units.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local inputs = require "generator.dynamics.inputs"
local number = require "generator.emit.number"
local units = require "generator.emit.packages.fmu_units"

local variables = {}

local entities = { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ["\""] = "&quot;", ["'"] = "&apos;" }

-- Text as an attribute's value: marked characters as entities, control characters as blanks, bytes that are no UTF-8
-- as question marks.
function variables.escaped(s)
  if not utf8.len(s) then s = string.gsub(s, "[\x80-\xFF]", "?") end
  return (string.gsub(string.gsub(s, "%c", " "), "[&<>\"']", entities))
end

local function attribute(name, value)
  return value and " " .. name .. "=\"" .. variables.escaped(value) .. "\"" or ""
end
variables.attribute = attribute

-- Descriptions of the three components where the first one's is for all (`about` is "" for the others).
local function abouts(list)
  local out, last = {}, ""
  for i, s in ipairs(list) do
    if s.about ~= "" then last = s.about end
    out[i] = last
  end
  return out
end

-- The list of {name, about, unit, own (unit to show it in), scale (of that unit in SI), start, low, high (rationals),
-- causality, variability, initial, state (its number), of (number of the state whose rate it is)}.
local function list_of(job)
  local m, list, taken = job.model, {}, {}
  local function put(x)
    while taken[x.name] do x.name = x.name .. "_" end
    taken[x.name] = true
    x.vr = #list
    list[#list + 1] = x
    return x
  end
  for _, p in ipairs(m.params) do taken[p.name] = true end
  for _, s in ipairs(job.states) do taken[s.name] = true end
  put { name = "time", about = "time", unit = "s", causality = "independent", variability = "continuous" }
  local ranges = {}
  for _, r in ipairs(job.ranges and job.ranges.params or {}) do ranges[r.name] = r end
  for _, p in ipairs(m.params) do
    local r = ranges[p.name] or {}
    taken[p.name] = nil
    put { name = p.name, about = "parameter, default " .. p.given, unit = p.unit, own = p.own,
      scale = p.own and m:number(p.factor), start = p.default, low = r.lo, high = r.hi, causality = "parameter",
      variability = "fixed" }
  end
  for i, about in ipairs(abouts(m.inputs)) do
    local s = m.inputs[i]
    local low, high = inputs.range(m, s)
    local fixed = low and expr.constant(s.low) and expr.constant(s.high) -- else a parameter changes them
    local start = low and (R.sign(low) > 0 and low or R.sign(high) < 0 and high) or R.zero
    put { name = s.label, about = "input, " .. about, unit = s.unit, own = s.own, scale = s.own and m:number(s.factor),
      start = start, low = fixed and low or nil, high = fixed and high or nil, causality = "input",
      variability = "continuous" }
  end
  for i, about in ipairs(abouts(job.states)) do
    local s = job.states[i]
    local exact = expr.constant(s.initial) -- no parameter determines it
    taken[s.name] = nil
    put { name = s.name, about = about, unit = s.unit, start = exact and m:number(s.initial) or nil,
      causality = "output", variability = "continuous", initial = exact and "exact" or "calculated", state = i }
  end
  for i, s in ipairs(job.jacobians and job.states or {}) do
    put { name = "der(" .. s.name .. ")", about = "rate of change of " .. s.name,
      unit = s.unit == "1" and "1/s" or s.unit .. "/s", causality = "local", variability = "continuous",
      initial = "calculated", of = i }
  end
  local function output(name, about, unit)
    put { name = name, about = about, unit = unit, causality = "output", variability = "continuous",
      initial = "calculated" }
  end
  output("energy", "kinetic and potential energy", "J")
  if job.conserved.rate then output("jacobi_integral", "Jacobi's integral of the turning field", "J") end
  for _, c in ipairs(m.has.rates and { "x", "y", "z" } or {}) do
    output("L" .. c, "angular momentum about the origin of rotation, " ..
      (m.has.attitude and "inertial" or "body") .. " axes", "kg m^2/s")
  end
  return list
end

-- Units in the order in which they come up: {name, exponents (attributes) or nil, shown = {{name, factor}}}.
local function units_of(list, real)
  local out, by_name = {}, {}
  for _, x in ipairs(list) do
    local name = units.name(x.unit)
    local u = by_name[name]
    if not u then
      u = { name = name, exponents = units.exponents(x.unit), shown = {} }
      by_name[name], out[#out + 1] = u, u
    end
    local own = x.own and units.name(x.own)
    if own and own ~= name then -- shown value = factor * value
      x.shown = own
      if not u.shown[own] then
        u.shown[own] = true
        u.shown[#u.shown + 1] = { name = own, factor = number.decimal(R.one / x.scale, "double") }
      end
    end
    x.unit_name = name
    for _, k in ipairs { "start", "low", "high" } do x[k .. "_text"] = x[k] and number.decimal(x[k], real) end
  end
  return out
end

local function references(list, at)
  local out = {}
  for i, x in ipairs(list) do out[i] = string.format("%d", x.vr + at) end
  return table.concat(out, " ")
end

-- Sets in v: units, variables, table, and who depends on whom at a communication point (structure) for `version`,
-- in which variables are named by their index from 1 (2.0) or by their value reference (3.0).
function variables.fill(job, v)
  local list = list_of(job)
  v.units = {}
  for i, u in ipairs(units_of(list, job.real)) do
    local shown = {}
    for k, s in ipairs(u.shown) do
      shown[k] = { attributes = attribute("name", s.name) .. attribute("factor", s.factor) }
    end
    v.units[i] = { name = attribute("name", u.name), base = u.exponents or "", has_base = u.exponents ~= nil,
      shown = shown }
  end
  v.variables, v.table = {}, {}
  for i, x in ipairs(list) do
    local vr = string.format("%d", x.vr)
    local numbers = attribute("unit", x.unit_name) .. attribute("displayUnit", x.shown)
    local limits = attribute("min", x.low_text) .. attribute("max", x.high_text) .. attribute("start", x.start_text)
    local state = x.of and list[i - #job.states]
    v.variables[i] = {
      head = attribute("name", x.name) .. attribute("valueReference", vr) .. attribute("description", x.about) ..
        attribute("causality", x.causality) .. attribute("variability", x.variability) ..
        attribute("initial", x.initial),
      numbers2 = numbers .. limits .. attribute("derivative", state and string.format("%d", state.vr + 1)),
      numbers3 = numbers .. limits .. attribute("derivative", state and string.format("%d", state.vr)) }
    v.table[i] = { vr = vr, name = x.name, about = x.about, unit = x.unit,
      kind = x.causality .. (x.initial == "exact" and ", can be set before the start" or ""),
      start = x.start_text or "" }
  end
  v.structure2, v.structure3 = variables.structure(list, 1, job), variables.structure(list, 0, job)
  return list
end

-- {outputs, derivatives, initial}: lists of attributes.  Outputs depend on the state alone: on no input, and on states
-- if these are known from outside (with derivatives).
function variables.structure(list, at, job)
  local name = at == 1 and "index" or "valueReference"
  local out, states, known = { outputs = {}, derivatives = {}, initial = {} }, {}, {}
  for _, x in ipairs(list) do
    if x.state and job.jacobians then states[#states + 1] = x end
    if x.causality == "input" or x.state and job.jacobians then known[#known + 1] = x end
  end
  for _, x in ipairs(list) do
    local head = attribute(name, string.format("%d", x.vr + at))
    if x.causality == "output" then
      local on = x.state and job.jacobians and { x } or states
      out.outputs[#out.outputs + 1] = head .. attribute("dependencies", references(on, at))
    elseif x.of then
      out.derivatives[#out.derivatives + 1] = head .. attribute("dependencies", references(known, at))
    end
    if x.initial == "calculated" then out.initial[#out.initial + 1] = head end
  end
  return out
end

return variables
