-- effects.lua -- what each effect adds to the equations, as formulas (notation of formula/read.lua).
--
-- N: its torque in body axes, F: its force; S turns body axes into inertial axes.  tests/report/handout.t wants an
-- entry for every effect.
-- SPDX-License-Identifier: GPL-3.0-or-later

return {
  ["effect.control"] = { "~N = ~u" },
  ["effect.custom"] = {},
  ["effect.damping"] = { '~N = - C ~omega "or" ~N = - gamma ~L' },
  ["effect.dissipation"] = { "I ~omega' = ~L x ~omega + kappa ~L x ( ~L x ~omega ) + ~N" },
  ["effect.drag"] = { "~N = - c | ~omega | ~omega" },
  ["effect.eddy_current"] = { "~N = - kappa ~B x ( ~omega x ~B )" },
  ["effect.friction"] = { "~N = - tau_0 {~omega|s}", "s^2 = omega^2 + omega_0^2" },
  ["effect.gravity"] = { "~N = ~R x M g S^T ~d", "V = - M g ~d . S ~R" },
  ["effect.gravity_gradient"] = { "~N = {3 mu|d^3} ~o x I ~o" },
  ["effect.inertia_rate"] = { "( I + D ) ~omega' = ~L_t x ~omega - D' ~omega + ~N", "~L_t = ( I + D ) ~omega" },
  ["effect.magnetic"] = { "~N = ~mu x S^T ~B", "V = - ~mu . S^T ~B" },
  ["effect.pivot"] = { "~N = ~R x S^T ( - M ~a(t) )" },
  ["effect.plane"] = { '~v + ~omega x ~r = ~U "rolling"', '~F = N_n ~n "smooth"', '~F = N_n ( ~n - c ~s ) "sliding"',
    "~s = ~v + ~omega x ~r - ~U", "~N = ~r x ~F" },
  ["effect.rotating_frame"] = {},
  ["effect.rotor"] = { "I ~omega' = ( I ~omega + ~h ) x ~omega + ~N" },
  ["effect.solar_pressure"] = {
    "~F = - {Phi|c_0} A c ( ( 1 - rho ) ~s + 2 rho c ~n )", "~N = ~d x ~F" },
  ["effect.spring"] = { "V = 2 ~u . K ~u", "~N = - 2 ( p_0 K ~u + ( K ~u ) x ~u )" },
  ["effect.torque"] = { '~N = ~b "or" ~N = S^T ~b' },
  ["effect.translation"] = { "M ~v' = M ~g - c | ~v | ~v - gamma ~v - kappa ~r + ~F + S ~f", "~r' = ~v" },
  ["effect.wheel"] = { "J ( ~a . ~omega' + W' ) = u", "~N = J ( ~a . ~omega + W ) ~a x ~omega - u ~a" },
}
