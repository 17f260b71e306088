-- Many effects at once, each with a parameter, and an input.
-- SPDX-License-Identifier: GPL-3.0-or-later

local a, M = param("a", 0.3, "m"), param("M", 2, "kg")
local c, k, d = param("c", 0.01, "N m s"), param("k", 0.5, "N m"), param("d", 0.002, "N m s^2")
local f, e = param("f", 0.01, "N m"), param("e", 0.05, "rad/s")
local h, B, g = param("h", 0.1, "kg m^2/s"), param("B", 0.02, "T"), param("g", 9.81, "m/s^2")

return scene {
  name = "busy",
  body = solid.box { x = a, y = 2 * a, z = 3 * a, mass = M }:at { 0, 0, a },
  origin = { 0, 0, 0 },
  effects = {
    effect.gravity { g = g }, effect.damping { c = c }, effect.spring { stiffness = { k, k, k } },
    effect.drag { c = d }, effect.friction { torque = f, smoothing = e },
    effect.rotor { axis = { 1, 0, 1 }, momentum = h },
    effect.magnetic { moment = { 0, 0, 1 }, field = { B, 0, 0 } },
    effect.torque { body = { { { 0, 0 }, { 1, k }, { 2, 0 } }, 0, k * sin(5 * t) } }, effect.control {},
  },
  initial = { omega = { 1, 2, 3 } },
  time = { horizon = 1, step = 0.001 },
}
