-- NASA's six-degree-of-freedom check case 3 (TM-2015-218675): the brick falls from 30000 ft, and the air damps it.
-- Axes north, east, down over latitude 0, turning with the Earth; no wind, no drag, as the case has it.  C_lp = C_mq =
-- C_nr = -1 with p b/2V, q c/2V, r b/2V make torques -(rho V/4) S b^2 p, -(rho V/4) S c^2 q, -(rho V/4) S b^2 r; of
-- the inertial rates, as three of NASA's five simulators took them.
-- rho is a state: air at rest of temperature T = T0 - beta h, h the geopotential height, has
--     d rho/dh = -(g0 M/R - beta) rho/T,    T0, beta, g0, M, R: U.S. Standard Atmosphere 1976, sections 1.2 and 1.3
-- and by its equations 18, 23, 33a, 42 0.45904060 kg/m^3 at the start.  Normal gravity over the equator, WGS 84 (NIMA
-- TR8350.2, equation 4-3): 9.75215 m/s^2 at 30000 ft, and 3.077e-6 m/s^2 more for every metre fallen.
-- SPDX-License-Identifier: GPL-3.0-or-later

local mass, start = quantity(0.155404754, "slug"), quantity(30000, "ft")
local rise = quantity(3.077e-6, "1/s^2")                 -- of gravity with the depth
local earth = quantity(7.292115e-5, "rad/s")
local S, b, c = quantity(0.22222, "ft^2"), quantity(0.33333, "ft"), quantity(0.66667, "ft")
local T0, beta = quantity(288.15, "K"), quantity(0.0065, "K/m")
local hydro = quantity(9.80665, "m/s^2")*quantity(0.0289644, "kg")/quantity(8.31432, "J/K") -- g0 M/R*, K/m
local r0 = quantity(6356766, "m")                       -- of geopotential height, h = r0 z/(r0 + z)

return scene {
  name    = "nasa_brick_damped",
  body    = tensor { mass = mass, xx = quantity(0.001894220, "slug ft^2"),
                     yy = quantity(0.006211019, "slug ft^2"), zz = quantity(0.007194665, "slug ft^2") },
  effects = {
    effect.translation { gravity = { 0, 0, quantity(9.75215, "m/s^2") }, stiffness = { 0, 0, -mass*rise } },
    effect.rotating_frame { rate = { earth, 0, 0 }, centrifugal = false }, -- which gravity contains
    effect.custom {
      params = { roll = S*b^2/4, pitch = S*c^2/4, yaw = S*b^2/4 },
      states = { rho = { initial = quantity(0.4590406004, "kg/m^3"), unit = "kg/m^3", rate = function(s)
        local z = start - s.r[3]
        local h = r0*z/(r0 + z)
        return (hydro - beta)*s.rho/(T0 - beta*h)*(r0/(r0 + z))^2*s.v[3]
      end } },
      torque = function(s)
        local V = sqrt(s.v[1]^2 + s.v[2]^2 + s.v[3]^2 + quantity(1e-30, "m^2/s^2"))
        return { -s.roll*s.rho*V*s.w[1], -s.pitch*s.rho*V*s.w[2], -s.yaw*s.rho*V*s.w[3] }
      end,
    },
  },
  initial = { omega = {quantity(10, "deg/s"), quantity(20, "deg/s"), quantity(30, "deg/s")} },
  time    = { horizon = 30 },
}
