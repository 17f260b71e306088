-- base.lua -- what every template may use: who the scene is, plain numbers of its real type, functions of libm.
--
--     base.of(job, own) -> values        own: the code has its own sin, exp and so on (--libm own)
--
--     name, upper                        of the scene: prefix of functions, of macros
--     real                               "double" or "float"
--     title, source, command, version, build, license     for the heads of files
--     has_inputs, has_params, has_attitude                has the scene any?
--     step_literal, horizon_literal, step_text            time.step and time.horizon in C, the step for people
--     zero one two three four eight twelve sixteen half quarter eighth threehalves     literals of the real type
--     n                                  any other number in C: ${n[2.5]}
--     epsilon, split                     a unit of the last place of 1; Dekker's factor 2^s + 1
--     sqrt, fabs, sin ... huge, fma      what the code calls these by (emit/libm.lua)
-- What the templates of one group alone read is not here, it is that group's own (emit/template.lua).  Literals are
-- made when they are first read.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local libm = require "generator.emit.libm"
local number = require "generator.emit.number"

local base = {}

local LITERALS = { zero = "0", one = "1", two = "2", three = "3", four = "4", eight = "8", twelve = "12",
  sixteen = "16", half = "1/2", quarter = "1/4", eighth = "1/8", threehalves = "3/2" }

-- By the digits of the type.
local OF_DIGITS = {
  epsilon = function(digits) return R.new(2) ^ (1 - digits) end,
  split = function(digits) return R.new(2) ^ ((digits + 1) // 2) + R.one end,
}

base.digits = { float = 24, double = 53 }

local function literal(name, real)
  local q = LITERALS[name]
  if q then return number.text(R.lift(q), real) end
  return OF_DIGITS[name] and number.text(OF_DIGITS[name](base.digits[real]), real)
end

function base.of(job, own)
  local m, real = job.model, job.real
  local step, horizon = m:number(m.step), m:number(m.horizon)
  local values = libm.names({ name = m.name, real = real }, own)
  for k, x in pairs {
    name = m.name, upper = string.upper(m.name), real = real,
    title = job.title, source = job.source, command = job.command, version = job.version, build = job.build,
    license = "SPDX-License-Identifier: MIT-0",
    has_inputs = job.equations.inputs, has_params = #m.params > 0, has_attitude = m.has.attitude or false,
    step_literal = number.text(step, real), horizon_literal = number.text(horizon, real),
    step_text = number.text(step, "double"),
  } do
    values[k] = x -- into a table: order is lost anyway
  end
  values.n = setmetatable({}, { __index = function(_, x) return number.text(R.fromdouble(x), real) end })
  return setmetatable(values, { __index = function(t, k)
    local text = literal(k, real)
    if text then rawset(t, k, text) end
    return text
  end })
end

-- All names, as a set: for tests.
function base.names(values)
  local set = {}
  for _, t in ipairs { values, LITERALS, OF_DIGITS } do
    for name in pairs(t) do set[name] = true end -- a set: any order
  end
  return set
end

return base
