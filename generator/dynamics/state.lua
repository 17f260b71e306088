-- state.lua -- the symbols of state, input and time, and how emitted code names them.
--
-- `known` is every state that dynamics itself knows: name (also the C local), what it is, unit, what its enumerator
-- ends in.  Which of them a scene has, and what effects add, is decided in dynamics/states.lua.  Attitude q is the
-- unit quaternion from body to inertial axes, scalar first; w are the body rates; r and v belong to the centre of mass.
-- In a rotating frame (effects/rotating_frame.lua) the frame's axes take the place of the inertial ones.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"

local state = {}

state.sym = motion.sym -- the symbol of a state of that name

local function list(rows)
  local out = { by_name = {} }
  for i, r in ipairs(rows) do
    local s = { name = r[1], sym = state.sym(r[1]), about = r[2], unit = r[3], index = string.upper(r[1]) }
    out[i], out.by_name[r[1]] = s, s
  end
  return out
end

state.known = list {
  { "qw", "attitude, body to inertial", "1" }, { "qx", "", "1" }, { "qy", "", "1" }, { "qz", "", "1" },
  { "wx", "rates, body axes", "rad/s" }, { "wy", "", "rad/s" }, { "wz", "", "rad/s" },
  { "rx", "position of the centre of mass", "m" }, { "ry", "", "m" }, { "rz", "", "m" },
  { "vx", "velocity of the centre of mass", "m/s" }, { "vy", "", "m/s" }, { "vz", "", "m/s" },
}
state.inputs = list {
  { "ux", "torque, body axes", "N m" }, { "uy", "", "N m" }, { "uz", "", "N m" },
}
state.t = motion.sym "t"
state.h = expr.sym("h", 6)

-- The four kinds of known states, by the names that `outputs` of a scene and the reports use.
state.kinds = { "attitude", "rates", "position", "velocity" }
state.names = { attitude = { "qw", "qx", "qy", "qz" }, rates = { "wx", "wy", "wz" }, position = { "rx", "ry", "rz" },
  velocity = { "vx", "vy", "vz" } }

local function pick(l, names)
  local v = {}
  for i, n in ipairs(names) do v[i] = l.by_name[n].sym end
  return v
end

state.q, state.w = pick(state.known, state.names.attitude), pick(state.known, state.names.rates)
state.r, state.v = pick(state.known, state.names.position), pick(state.known, state.names.velocity)
state.u = pick(state.inputs, { "ux", "uy", "uz" })

return state
