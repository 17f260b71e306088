-- values.lua -- closed forms and the values of report/values.lua as formulas (notation of handout/math.lua).
-- SPDX-License-Identifier: GPL-3.0-or-later

local values = {}

-- By the closed form's kind; the others say it in words.
values.closed = {
  sphere = { "~omega = ~omega (0)" },
  asymmetric = { "~L = B_1 cn (u) ~e_1 + B_2 sn (u) ~e_2 + B_3 dn (u) ~e_3", "u = lambda ( t - t_0 )" },
  lagrange = { "cos theta = u_1 + ( u_2 - u_1 ) sn^2 ( lambda ( t - t_0 ) )" },
  symmetric = { "Omega = {I_3 - I_1|I_1} omega_3", "omega_1 + i omega_2 = ( omega_1 (0) + i omega_2 (0) ) "
    .. "( cos Omega t + i sin Omega t )", "omega_3 = omega_3 (0)", "phi' = {L|I_1}" },
}

-- key = {symbol, formula, what it is}
values.rows = {
  rate = { "omega", "| ~omega |", "size of the angular velocity" },
  T = { "T", "{1|2} ~omega . I ~omega", "kinetic energy of the rotation" },
  momentum = { "L", "| I ~omega |", "size of the angular momentum" },
  w_to_L = { "gamma", nil, "angle between the angular velocity and L" },
  precession_rate = { "phi'", nil, "mean precession rate" },
  precession_period = { "tau_p", "{2 pi|phi'}", "period of the precession" },
  wobble_rate = { "Omega", "{I_3 - I_1|I_1} omega_3", "rate of the angular velocity about the axis" },
  wobble_period = { "tau_w", "{2 pi|| Omega |}", "its period" },
  axis_to_L = { "theta", nil, "angle between the axis and L" },
  body_cone = { "alpha", nil, "half angle of the body cone" },
  space_cone = { "beta", nil, "half angle of the space cone" },
  revolution_period = { "tau", "{2 pi|omega}", "period of the turn" },
  modulus = { "k", nil, "modulus of the elliptic functions" },
  polhode_period = { "tau_1", "{4 K (k)|lambda}", "after which the angular velocity comes back" },
  weight_moment = { "M g l", nil, "moment of the weight" },
  L_vertical = { "L_z", nil, "vertical component, conserved" },
  L_axial = { "L_3", "I_3 omega_3", "along the axis, conserved" },
  tilt_least = { "theta_min", nil, "least tilt" }, tilt_greatest = { "theta_max", nil, "greatest tilt" },
  nutation_period = { "tau_n", "{2 K (k)|lambda}", "period of the nutation" },
  fast_precession_rate = { "phi'_fast", "{M g l|I_3 omega_3}", "limit of a fast spin" },
  fast_nutation_rate = { "Omega_fast", "{I_3 omega_3|I_1}", "limit of a fast spin" },
  sleeping = { "sigma", "{( I_3 omega_3 )^2|4 I_1 M g l}", "above 1 the upright top is stable" },
}

return values
