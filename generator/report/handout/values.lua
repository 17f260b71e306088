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

-- The parts of Chaplygin's vector, by the report's own text: level or on a slope.
local function chaplygin(symbol, along, what)
  local name = string.gsub(along, "[~_]", "")
  return { symbol, { ["(L - m r x V)." .. name] = "( ~L - M ~r x ~v ) . " .. along,
    ["(L - m r x V - m R (n x G) t)." .. name] = "( ~L - M ~r x ~v - M R ( ~n x ~g ) t ) . " .. along }, what }
end

-- What a steady precession obeys; c and s: cosine and sine of the tilt.
local function precession(symbol, which)
  local function with(formula) return (string.gsub(formula, "%f[%w]p%f[ ]", symbol)) end
  return { symbol, {
    ["s (I1 c - m h y) p^2 - (I3 s - m h x) w3 p = m G b"] =
      with "{M g b + ( I_3 s - M h x ) omega_3 p|s ( I_1 c - M h y ) p}" },
    which .. " precession of this tilt (cosine c, sine s) and spin" }
end

-- key = {symbol, formula or formulas by the report's text, what it is or nil: the report's words}
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
  fast_precession_rate = { "phi_fast'", "{M g l|I_3 omega_3}", "limit of a fast spin" },
  fast_nutation_rate = { "Omega_fast", "{I_3 omega_3|I_1}", "limit of a fast spin" },
  turntable_energy = { "J", "E - Omega ~n . ( ~L + M ~p x ~v )", "conserved on a turntable" },
  jellett = { "lambda", "- ~L . ~r", "Jellett's integral, conserved" },
  routh = { "kappa", "omega_3 sqrt[I_1 I_3 + M ~r . I ~r]", "Routh's integral, conserved" },
  chaplygin_e1 = chaplygin("K_1", "~e_1", "Chaplygin's vector in the plane, conserved"),
  chaplygin_e2 = chaplygin("K_2", "~e_2", "Chaplygin's vector in the plane, conserved"),
  chaplygin_n = chaplygin("K_n", "~n", "Chaplygin's vector along the normal, conserved"),
  spin_about_normal = { "omega_n", "~omega . ~n", "of a homogeneous ball, conserved" },
  momentum_about_normal = { "L_n", "~L . ~n", "conserved: nothing turns it about the normal" },
  momentum_about_axis = { "L_3", "I_3 omega_3", "conserved: a body of revolution" },
  rolling_straight_above = { "omega_straight", "sqrt[{M g R I_1|I_3 ( I_3 + M ( R + rho )^2 )}]",
    "upright and rolling straight: stable above" },
  spinning_on_edge_above = { "omega_edge", "sqrt[{M g R|I_1 + M ( R + rho )^2}]",
    "upright and spinning about the normal: stable above" },
  steady_precession_1 = precession("p_1", "one steady"),
  steady_precession_2 = precession("p_2", "the other"),
  steady_nutation_1 = { "Omega_1", nil, "rate of a small nutation about the one: it is stable" },
  steady_nutation_2 = { "Omega_2", nil, "rate of a small nutation about the other: it is stable" },
  steady_growth_1 = { "sigma_1", nil, "rate of growth of a nutation about the one: it is unstable" },
  steady_growth_2 = { "sigma_2", nil, "rate of growth of a nutation about the other: it is unstable" },
  upright_spin = { "C_1", nil, "spin of the solution where it is upright, conserved" },
  upright_precession = { "C_2", nil, "its precession there, conserved" },
  reaction_tilt_least = { "N_min", nil, "reaction at the least tilt" },
  reaction_tilt_greatest = { "N_max", nil, "reaction at the greatest tilt" },
  reaction_least = { "N_0", nil, "least reaction in the swing: contact is lost where it is not positive" },
  tilt_period = { "tau", nil, "period of the tilt" },
  contact_turn = { "Delta phi", nil, "turn of the contact point in it" },
  contact_turn_flat = { "Delta phi_0", "pi sqrt[1 + {M R^2|I_1 + M rho^2}]", "its limit for ever flatter falls" },
  circle_rate = { "Omega_circle", "{I Omega|I + M R^2}", "rate of the circles of its centre" },
  drift = { "V_drift", "{M R^2 g_along|I Omega}", "across the slope" },
  acceleration = { "a", "{M R^2 g_along|I + M R^2}", "of its centre down the slope" },
  sleeping = { "sigma", "{( I_3 omega_3 )^2|4 I_1 M g l}", "above 1 the upright top is stable" },
}

-- Critical rates of a spin upright, by the law of the contact.
local upright = {
  ["2 sqrt(I1 m G (h - rho))/I3"] = "{2 sqrt[I_1 M g ( h - rho )]|I_3}",
  ["2 sqrt((I1 + m h^2) m G (h - rho))/(I3 + m h rho)"] =
    "{2 sqrt[( I_1 + M h^2 ) M g ( h - rho )]|I_3 + M h rho}",
  ["sqrt(m G (h - rho) h/(rho (I3 - I1 rho/h)))"] = "sqrt[{M g ( h - rho ) h|rho ( I_3 - I_1 rho / h )}]",
}
for _, where in ipairs { "up", "down" } do
  values.rows["upright_z_" .. where .. "_above"] = { "omega_" .. where .. "ward", upright }
  values.rows["upright_z_" .. where .. "_below"] = { "omega_" .. where .. "ward", upright }
end

-- The row {symbol, formula or nil, what it is} of a row of report/values.lua.
function values.row(v)
  local known = values.rows[v.key]
  if not known then
    local flip = string.match(v.key, "^flip_(%d+)$")
    if not flip then error("no symbol for " .. v.key, 0) end
    return { "t_" .. flip, nil, "the rate about the middle axis changes its sign" }
  end
  local formula = known[2]
  if type(formula) == "table" then
    formula = formula[v.formula] or error("no formula for " .. v.key .. ": " .. v.formula, 0)
  end
  return { known[1], formula, known[3] or v.what }
end

return values
