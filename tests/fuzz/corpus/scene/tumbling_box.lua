-- A flat box thrown to tumble about its middle axis: the scene against which other programs were timed.
local a, b, c = param("a", 0.2, "m"), param("b", 0.1, "m"), param("c", 0.0333, "m")
local M = param("M", 1, "kg")
return scene {
  name    = "tumbling_box",
  body    = solid.box { x = a, y = b, z = c, mass = M },
  initial = { omega = {1, 6.5, 1} },
  time    = { horizon = 100 },
}
