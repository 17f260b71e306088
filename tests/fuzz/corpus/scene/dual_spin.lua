-- A dual-spin satellite: an asymmetric platform that a rotor along z keeps steady, with some nutation.
return scene {
  name    = "dual_spin",
  body    = tensor { mass = 400, xx = 150, yy = 210, zz = 260 },
  effects = { effect.rotor { axis = {0, 0, 1}, momentum = 120 } },
  initial = { omega = {0.05, -0.02, 0.01}, attitude = {1, 0, 0, 0} },
  time    = { horizon = 600 },
}
