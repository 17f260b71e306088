-- A free symmetric top, prolate: regular precession, solved in closed form.
local r, h = param("r", 0.03, "m"), param("h", 0.12, "m")
return scene {
  name    = "symmetric_top",
  body    = solid.cylinder { r = r, h = h, density = quantity(2700, "kg/m^3") },
  initial = { omega = {1.0, 0.5, 20}, attitude = { axis = "x", angle = quantity(20, "deg") } },
  time    = { horizon = 20 },
}
