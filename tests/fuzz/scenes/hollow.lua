-- A box with a bore and an eccentric ball of air: a body with holes whose sizes are parameters.
-- SPDX-License-Identifier: GPL-3.0-or-later

local a, r, s = param("a", 0.2, "m"), param("r", 0.02, "m"), param("s", 0.03, "m")
local rho = param("rho", 2700, "kg/m^3")

return scene {
  name = "hollow",
  body = solid.box { x = a, y = a, z = a, density = rho } - solid.cylinder { r = r, h = a, density = rho }
    - solid.sphere { r = s, density = rho }:at { 0.06, 0, 0 },
  initial = { omega = { 1, 2, 3 } },
  time = { horizon = 1, step = 0.001 },
}
