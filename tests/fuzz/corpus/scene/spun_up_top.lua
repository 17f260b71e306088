-- A symmetric top spun up by a motor about its axis against friction in air: the nutation winds up faster and faster.
local I1, I3 = param("I1", 0.03, "kg m^2"), param("I3", 0.05, "kg m^2")
return scene {
  name    = "spun_up_top",
  body    = tensor { mass = 2, xx = I1, yy = I1, zz = I3 },
  effects = { effect.torque { body = {0, 0, param("N", 0.2, "N m")} },
    effect.damping { c = {0.001, 0.001, param("c", 0.004, "N m s")} } },
  initial = { omega = {0.5, 0, 3}, attitude = {1, 0, 0, 0} },
  time    = { horizon = 30 },
}
