-- A cube about its corner: moments 1/6, 11/12, 11/12 of M a^2, a symmetric top about the space diagonal.
local a, M = param("a", 0.1, "m"), param("M", 1, "kg")
return scene {
  name    = "cube_corner",
  body    = solid.box { x = a, y = a, z = a, mass = M },
  origin  = "corner",
  initial = { omega = {2, -1, 5} },
  time    = { horizon = 10 },
}
