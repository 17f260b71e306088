-- The same brick about its centroid: the tensor is diagonal, the middle axis unstable.
local a, b, c = param("a", 0.20, "m"), param("b", 0.10, "m"), param("c", 0.05, "m")
local M = param("M", 2.4, "kg")
return scene {
  name    = "brick_centroid",
  body    = solid.box { x = a, y = b, z = c, mass = M },
  initial = { omega = {0.1, 6.0, 0.2} },
  time    = { horizon = 10 },
}
