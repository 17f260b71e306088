-- Foucault's pendulum in the Pantheon, linearised: the plane of the swing turns clockwise, once in 31.8 hours.
local M, length = param("M", 28, "kg"), param("length", 67, "m")
local g = param("g", 9.81, "m/s^2")
local latitude = param("latitude", 48.846, "deg")
local day = quantity(7.292115e-5, "rad/s") -- the Earth's rate; x points east, y north, z up
return scene {
  name    = "foucault",
  body    = points {{M, 0, 0, 0}},
  -- the local vertical already contains the centrifugal force, and the wire holds the bob at its height
  effects = {
    effect.translation { gravity = 0, stiffness = {M*g/length, M*g/length, 0} },
    effect.rotating_frame { rate = {0, 0, day*sin(latitude)}, centrifugal = false },
  },
  initial = { position = {3, 0, 0} },
  time    = { horizon = 600, step = 0.05 },
}
