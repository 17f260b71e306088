-- An L-bracket, a foot and an upright plate, tumbling freely: a composite that keeps its parameters.
local x, y, z = param("x", 0.10, "m"), param("y", 0.06, "m"), param("z", 0.01, "m")
local h = param("h", 0.08, "m")
local rho = param("rho", 2700, "kg/m^3")
local foot = solid.box { x = x, y = y, z = z, density = rho }
local wall = solid.box { x = z, y = y, z = h, density = rho }
return scene {
  name    = "bracket",
  body    = foot + wall:at{(z - x)/2, 0, (z + h)/2},
  effects = {},
  initial = { omega = {0.2, 5, 0.1} },
  time    = { horizon = 10 },
}
