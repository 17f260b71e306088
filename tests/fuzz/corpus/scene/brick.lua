-- The lecture's brick: edges a, b, c, turning freely about one corner.
local a, b, c = param("a", 0.20, "m"), param("b", 0.10, "m"), param("c", 0.05, "m")
local M = param("M", 2.4, "kg")
return scene {
  name    = "brick",
  body    = solid.box { x = a, y = b, z = c, mass = M },
  origin  = "corner",
  effects = {},
  initial = { omega = {0.1, 6.0, 0.2}, attitude = {1, 0, 0, 0} },
  time    = { horizon = 10 },
}
