-- A satellite, symmetric about z, whose rotor along z keeps the antenna platform all but still: regular precession.
local I1, I3 = param("I1", 800, "kg m^2"), param("I3", 600, "kg m^2")
local h = param("h", 200, "kg m^2/s")
return scene {
  name    = "gyrostat",
  body    = tensor { mass = 900, xx = I1, yy = I1, zz = I3 },
  effects = { effect.rotor { axis = {0, 0, 1}, momentum = h } },
  initial = { omega = {0.01, 0.004, 0.001}, attitude = {1, 0, 0, 0} },
  time    = { horizon = 600 },
}
