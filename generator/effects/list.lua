-- list.lua -- the effects a scene can name, in the order they are listed.
--
-- One file an effect.  Each gives: name, args (checked by the scene language) or read (its own reading),
-- about (one line), needs (which of attitude, input its torque uses), torque(a, c) and, where there is one,
-- potential(a, c).  `c` is the context: mass, com, inertia of the body about the origin, the symbols of the state
-- (q, w, u), and constant(name, expr, text), which keeps an expression of parameters as a derived constant.
-- Torques are about the origin of rotation, in body axes, N m.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

return {
  require "generator.effects.gravity",
  require "generator.effects.damping",
  require "generator.effects.torque",
  (require "generator.effects.control"), -- one value: require also returns where it found it
}
