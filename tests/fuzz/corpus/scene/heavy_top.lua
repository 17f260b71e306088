-- A heavy top: a cone that spins on its tip under its weight, released with its axis tilted (cusps and loops).
local r, h = param("r", 30, "mm"), param("h", 80, "mm")
return scene {
  name    = "heavy_top",
  body    = solid.cone { r = r, h = h, density = quantity(2700, "kg/m^3") },
  origin  = {0, 0, h},
  effects = { effect.gravity{} },
  initial = { omega = {1, 0, quantity(3000, "rpm")}, attitude = {0.2, 0.96, 0.1, 0} },
  time    = { horizon = 2, step = 0.0001 },
}
