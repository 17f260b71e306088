-- state.lua -- the symbols of the state, the input and time, and how emitted code names them.
--
-- One list serves equations, steppers, Jacobian and header: name (also the C local), the enumerator's text, unit.
-- Attitude q is the unit quaternion from body to inertial axes, scalar first; w are the body rates.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"

local state = {}

local rank = 8 -- states after all constants in a product

local function list(rows)
  local out = { by_name = {} }
  for i, r in ipairs(rows) do
    local s = { name = r[1], sym = expr.sym(r[1], rank), about = r[2], unit = r[3] }
    out[i], out.by_name[r[1]] = s, s
  end
  return out
end

state.all = list {
  { "qw", "attitude, body to inertial", "1" }, { "qx", "", "1" }, { "qy", "", "1" }, { "qz", "", "1" },
  { "wx", "rates, body axes", "rad/s" }, { "wy", "", "rad/s" }, { "wz", "", "rad/s" },
}
state.inputs = list {
  { "ux", "torque, body axes", "N m" }, { "uy", "", "N m" }, { "uz", "", "N m" },
}
state.t = expr.sym("t", rank)
state.h = expr.sym("h", 6)

local function pick(l, names)
  local v = {}
  for i, n in ipairs(names) do v[i] = l.by_name[n].sym end
  return v
end

state.q = pick(state.all, { "qw", "qx", "qy", "qz" })
state.w = pick(state.all, { "wx", "wy", "wz" })
state.u = pick(state.inputs, { "ux", "uy", "uz" })

return state
