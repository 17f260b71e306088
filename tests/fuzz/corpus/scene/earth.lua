-- The rigid Earth: Euler's free precession of the pole, A/(C - A) = 304 sidereal days (he found 305).
-- Moments of the symmetric figure: C = 8.0365e37 kg m^2, dynamical ellipticity (C - A)/C = 1/305.3.
local C = quantity(8.0365e37, "kg m^2")
local A = C*exact("3043/3053")
return scene {
  name    = "earth",
  body    = tensor { mass = quantity(5.9722e24, "kg"), xx = A, yy = A, zz = C },
  initial = { omega = {1e-10, 0, 7.292115e-5} },
  time    = { horizon = quantity(305, "day"), step = 60 },
}
