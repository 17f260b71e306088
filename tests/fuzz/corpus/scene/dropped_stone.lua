-- A stone dropped from a tower at latitude 45: it lands east of the foot, by the Coriolis force.
local g = param("g", 9.81, "m/s^2")
local O = quantity(7.292115e-5, "rad/s")*sqrt(exact("1/2"))
return scene {
  name    = "dropped_stone",
  body    = solid.sphere { r = 0.03, density = 2700 },
  effects = {
    effect.translation { gravity = g },
    effect.rotating_frame { rate = {0, O, O} }, -- x east, y north, z up
  },
  initial = { position = {0, 0, 100} },
  time    = { horizon = 4.5, step = 0.01 },
}
