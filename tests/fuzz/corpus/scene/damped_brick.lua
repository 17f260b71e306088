-- A brick tumbling in a fluid whose torque is -rate L: the free motion, slower and slower, until it stands still.
local a, b, c = param("a", 0.20, "m"), param("b", 0.10, "m"), param("c", 0.05, "m")
local M, rate = param("M", 2.4, "kg"), param("rate", 0.25, "1/s")
return scene {
  name    = "damped_brick",
  body    = solid.box { x = a, y = b, z = c, mass = M },
  effects = { effect.damping { rate = rate } },
  initial = { omega = {0.1, 6.0, 0.2}, attitude = {1, 0, 0, 0} },
  time    = { horizon = 20 },
}
