-- theory.lua -- the symbols of the theory: each with its meaning, its indices, and what to write where it is taken.
--
-- A family is {base, subs, others, word, meaning}: its letter, the indices with which it stands in any formula ("" for
-- none, "~" for a vector without one), other letters for it, the word that becomes an index where all of these are
-- taken.  No two families share a letter with an index.
-- SPDX-License-Identifier: GPL-3.0-or-later

local theory = {}

local list, members = {}, {} -- "base_sub" -> family

local function family(base, subs, word, meaning, others)
  local f = { base = base, subs = {}, word = word, meaning = meaning, others = {} }
  for sub in string.gmatch(subs, "%S+") do f.subs[#f.subs + 1] = sub == "-" and "" or sub end
  for other in string.gmatch(others or "", "%S+") do f.others[#f.others + 1] = other end
  for _, sub in ipairs(f.subs) do
    local k = base .. "_" .. sub
    assert(not members[k], k)
    members[k] = f
  end
  list[#list + 1] = f
  return f
end

local VECTOR, ENTRIES = " ~ x y z", " xx yy zz xy xz yz"
local function of_each(word, subs) return (string.gsub(subs, "%a+", word)) end

theory.mass = family("M", "-", "tot", "the mass", "m")
family("I", "-" .. ENTRIES .. of_each("%0,c", ENTRIES) .. of_each("%0,b", ENTRIES) .. " c b jk", "body",
  "the tensor of inertia", "Theta")
family("I", "1 2 3 i j k", "p", "a principal moment", "A")
family("J", ENTRIES, "inv", "the inverse of the tensor of inertia", "U")
family("J", "-", "wheel", "the moment of a wheel")
family("D", "- ~" .. ENTRIES, "mov", "the tensor of what moves within the body")
family("C", "~ -", "damp", "the tensor of damping")
family("K", "~ -", "spring", "the tensor of a spring")
family("T", "-", "rot", "the kinetic energy")
family("E", "- 0", "tot", "the energy")
family("V", "-", "pot", "the potential")
family("L", "- 1 2 3 n v free" .. VECTOR .. " t" .. of_each("%0,t", " x y z"), "rot", "the angular momentum", "H")
family("N", "- 1 2 3" .. VECTOR, "tot", "the torque", "Q")
family("N", "n min max 0", "plane", "the reaction of the plane")
family("omega", "- 0 crit 1 2 3 i j k n straight edge upward downward free" .. VECTOR, "rot",
  "the angular velocity", "w")
family("t", "- 0", "time", "the time")
family("t", "1 2 3", "turn", "a time of a change of sign")
family("r", "- 0 s" .. VECTOR, "cm", "the position")
family("R", VECTOR, "cm", "the arm of the centre of mass")
family("R", "-", "rim", "the radius of the surface")
family("v", "- 0 drift" .. VECTOR, "cm", "the velocity")
family("q", "- w free 0" .. VECTOR, "att", "the attitude")
family("p", "- 0 1 2 ~", "prec", "a rate of precession or a part of the attitude")
family("S", "-", "att", "the rotation matrix", "Q U")
family("x", "j k ~", "mass", "a coordinate of a part of the mass", "xi")
family("x", "-", "con", "the contact across the axis")
family("y", "-", "con", "the contact along the axis")
family("e", "1 2 3 i j k ~", "axis", "a unit vector along an axis")
family("n", "- ~", "up", "the unit vector along the normal")
family("delta", "jk", "unit", "the unit tensor")
family("a", "- ~ inertial", "acc", "an acceleration or a direction")
family("F", "~ Coriolis centrifugal Euler" .. of_each("Coriolis,%0", " x y z") ..
  of_each("centrifugal,%0", " x y z") .. of_each("Euler,%0", " x y z"), "tot", "the force")
family("f", "~", "body", "the thrust")
family("Omega", "- ~" , "fr", "the rate of the frame or of the cone")
family("Omega", "1 2 p1 p2 circle fast", "osc", "a rate of small oscillations")
family("sigma", "- 1 2", "gr", "a rate of growth or the criterion of sleep")
family("lambda", "-", "ell", "the rate of the argument of Jacobi's functions")
family("k", "-", "ell", "the modulus of Jacobi's functions")
family("u", "- 1 2", "arg", "the argument of Jacobi's functions or the cosine of the tilt")
family("u", "~", "ctl", "a control")
family("B", "1 2 3", "amp", "an amplitude of the angular momentum")
family("B", "~", "field", "the magnetic field")
family("phi", "- fast", "prec", "the angle of precession")
family("theta", "- min max 0", "tilt", "the tilt")
family("gamma", "-", "wL", "an angle or a rate of damping")
family("alpha", "-", "body", "the half angle of the body cone")
family("beta", "-", "space", "the half angle of the space cone")
family("tau", "- p w n 1 0", "per", "a period or a torque")
family("A", "-", "amp", "the amplitude of the angular velocity or an area")
family("psi", "- 0", "ph", "a phase or an angle of turn")
family("C", "1 2 n e1 e2 J R", "int", "an integral of the motion")
family("G", "-", "wt", "the moment of the weight")
family("g", "- ~ along", "grav", "the gravity")
family("h", "- ~ s", "cen", "the height of the centre or the momentum of rotors")
family("rho", "-", "edge", "the radius of the edge or a reflectivity")
family("c", "- 0", "tilt", "a cosine, or a coefficient of drag")
family("s", "- ~", "tilt", "a sine, a speed, a direction or a coordinate")
family("b", "- ~", "lev", "a lever or a torque")
family("d", "- ~", "dir", "a distance or a direction")
family("m", "s", "sh", "the mass of a shape")
family("l", "x y z", "sh", "an edge of a shape")
family("xi", "-", "co", "a coordinate")
family("eta", "-", "co", "a coordinate")
family("zeta", "-", "co", "a coordinate")
family("z", "-", "co", "a coordinate")
family("o", "~", "up", "the direction of the planet")
family("U", "~", "plane", "the velocity of the plane")
family("W", "-", "wheel", "the rate of the wheel")
family("kappa", "-", "coef", "a coefficient")
family("mu", "- ~", "grav", "the gravitational parameter or the magnetic moment")
family("Phi", "-", "sun", "the flux of light")
family("i", "-", "unit", "the imaginary unit")

-- The family of a symbol, or nil.
function theory.has(base, sub, vector)
  sub = sub or ""
  return vector and sub == "" and members[base .. "_~"] or members[base .. "_" .. sub]
end

theory.families = list

-- Names of the code for symbols of the theory: {base, sub}.
theory.names = { t = { "t" }, clock = { "t" } }
for letter, base in pairs { w = "omega", r = "r", v = "v", q = "q", L = "L", R = "R" } do -- a map to a map
  for _, x in ipairs { "x", "y", "z" } do theory.names[letter .. x] = { base, x } end
end
theory.names["the mass"] = { "M" }
theory.names.qw = { "q", "w" }
for _, x in ipairs { "xx", "yy", "zz", "xy", "xz", "yz" } do
  theory.names["I" .. x], theory.names["J" .. x] = { "I", x }, { "J", x }
end

return theory
