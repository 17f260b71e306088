-- A water molecule: three particles, an asymmetric top of 1e-47 kg m^2 that turns at 1e12 rad/s.
local u = quantity(1, "u")
local bond, half = quantity(95.72, "pm"), quantity(52.26, "deg")
local x, z = bond*sin(half), bond*cos(half)
return scene {
  name    = "water",
  body    = points { {15.9949*u, 0, 0, 0}, {1.00783*u, x, 0, z}, {1.00783*u, -x, 0, z} },
  initial = { omega = {1e12, 3e12, -2e12} },
  time    = { horizon = 1e-10, step = 1e-15 },
}
