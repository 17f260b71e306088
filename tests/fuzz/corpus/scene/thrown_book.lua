-- A book thrown up with a spin about its middle axis: it turns over while its centre of mass flies a parabola.
local a, b, c = param("a", 0.24, "m"), param("b", 0.16, "m"), param("c", 0.03, "m")
local M = param("M", 0.8, "kg")
return scene {
  name    = "thrown_book",
  body    = solid.box { x = a, y = b, z = c, mass = M },
  effects = { effect.translation { drag = 0.01 } },
  initial = { omega = {0.05, 9, 0.05}, position = {0, 0, 1.5}, velocity = {0.4, 0, 4} },
  time    = { horizon = 1.1 },
}
