-- A copper shell thrown spinning into a magnet's field: eddy currents stop every turn but that about the field.
-- The turn across the field falls as exp(-k B^2 t/I), here in a quarter of a second; that along it stays.
-- SPDX-License-Identifier: GPL-3.0-or-later

local r = param("r", 0.05, "m")
local d = param("d", 0.002, "m") -- of the wall
local conductivity = param("conductivity", 5.9e7, "A^2 s^3/kg/m^3")
local density = quantity(8960, "kg/m^3")

return scene {
  name = "eddy_damper",
  body = shell.sphere { r = r, density = density * d },
  effects = { effect.eddy_current { k = 2 * pi * conductivity * d * r ^ 4 / 3, field = { 0.03, 0, 0.04 } } },
  initial = { omega = { 20, -30, 40 } },
  time = { horizon = 1, step = 0.001 },
}
