-- A flat box spun almost exactly about its middle axis, which turns over again and again at long intervals.
local a, b, c = param("a", 0.2, "m"), param("b", 0.1, "m"), param("c", 0.0333, "m")
local M = param("M", 1, "kg")
return scene {
  name    = "flipping_box",
  body    = solid.box { x = a, y = b, z = c, mass = M },
  initial = { omega = {0.1, 7, 0.1} },
  time    = { horizon = 100 },
}
