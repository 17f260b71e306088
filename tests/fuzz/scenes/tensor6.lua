-- A tensor with all six entries as parameters.
-- SPDX-License-Identifier: GPL-3.0-or-later

local xx, yy, zz = param("xx", 3, "kg m^2"), param("yy", 4, "kg m^2"), param("zz", 5, "kg m^2")
local xy, xz, yz = param("xy", 0.1, "kg m^2"), param("xz", -0.2, "kg m^2"), param("yz", 0.3, "kg m^2")

return scene {
  name = "tensor6",
  body = tensor { mass = 2, com = { 0, 0, 0 }, xx = xx, yy = yy, zz = zz, xy = xy, xz = xz, yz = yz },
  initial = { omega = { 1, 2, 3 } },
  time = { horizon = 1, step = 0.001 },
}
