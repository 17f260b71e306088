-- A fast heavy top that nods: the forced scene against which other programs were timed.
local I1, I3, c = param("I1", 7.5e-4, "kg m^2"), param("I3", 5.4e-4, "kg m^2"), param("c", 0.03, "m")
return scene {
  name    = "nodding_top",
  origin  = {0, 0, 0},
  body    = tensor { mass = 0.4, com = {0, 0, c}, xx = I1, yy = I1, zz = I3, about = "origin" },
  effects = { effect.gravity { g = 9.81 } },
  initial = { omega = {0.4, -0.3, 60}, attitude = {0.9689124217106447, 0.24740395925452294, 0, 0} },
  time    = { horizon = 20 },
}
