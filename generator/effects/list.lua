-- list.lua -- the effects a scene can name, in the order they are listed.
--
-- One file an effect.  A table with: name; about (one line); args (checked by the scene language) or read (its own
-- reading), check(a); numeric(a, num), what the library is told; and what it does, each optional:
--     torque(a, c)      about the origin of rotation, body axes, N m
--     force(a, c)       on the centre of mass, inertial axes (those of the base frame, if one turns), N
--     states(a)         states of its own: a list of {name =, initial = expr, unit =, about =}
--     derivative(a, c)  their rates by name
--     momentum(a, c)    angular momentum that it holds beside the body's (a rotor), body axes: it adds -(h' + w x h)
--     potential(a, c)   energy, J
--     frame(a, c)       the base frame turns: {rate =, rate_dot =, centrifugal =}
--     moves(given)      true if the centre of mass moves freely (given: what `initial` gives)
--     conserves(a, c)   a list out of "T+V", "|L|", "L", "L_z", "w3", see dynamics/conserved.lua; absent: nothing
--                       keeps: the same in words, where it is a function
--     input = true      it uses the input u;   single = true: once in a scene
--     fixed = advice    it acts about a fixed point, so a body that moves cannot have it
-- `c` is the context (dynamics/context.lua): mass, com, inertia, structure of the body about the origin; the symbols
-- q, w, r, v, u, t and own.NAME of its own states; M, the mass as a symbol that cancels in m r'' = F;
-- constant(name, expr, text), which keeps an expression of parameters as a derived constant, and
-- per_mass(name, expr, text), which is M times the constant expr/mass.  What an effect depends on is read from its
-- expressions.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

return {
  require "generator.effects.gravity",
  require "generator.effects.damping",
  require "generator.effects.torque",
  require "generator.effects.control",
  require "generator.effects.rotor",
  require "generator.effects.translation",
  (require "generator.effects.rotating_frame"), -- one value: require also returns where it found it
}
