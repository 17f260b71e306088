-- A satellite that a controller turns: three reaction wheels and a magnetorquer, each driven by an input of its own.
-- Motors and coil have limits, which belong to the input: what is beyond them does nothing. The field is that of a low
-- orbit, fixed in inertial axes here, and unloads the wheels slowly.
-- SPDX-License-Identifier: GPL-3.0-or-later

local J = param("J", 8e-5, "kg m^2")
local most = param("most", 2.3, "mN m")
local limits = { min = -most, max = most }

local roll = input("roll", "mN m", limits)
local pitch = input("pitch", "mN m", limits)
local yaw = input("yaw", "mN m", limits)
local coil = input("coil", "A m^2", { min = -0.2, max = 0.2 })

local function wheel(axis, torque)
  return effect.wheel { axis = axis, inertia = J, speed = quantity(1500, "rpm"), torque = torque, included = true }
end

return scene {
  name = "attitude_control",
  body = solid.box { x = 0.1, y = 0.1, z = 0.34, mass = 4 },
  effects = {
    wheel({ 1, 0, 0 }, roll), wheel({ 0, 1, 0 }, pitch), wheel({ 0, 0, 1 }, yaw),
    effect.magnetic { moment = { 0, 0, coil }, field = { 2e-5, 0, -3e-5 } },
  },
  initial = { omega = { 0.01, -0.02, 0.005 } },
  time = { horizon = 60, step = 0.05 },
}
