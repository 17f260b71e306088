-- effects.lua -- the effects a scene can name, in the order they are listed.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- One file an effect.  A table with: name; about (one line); args (checked by the scene language) or read (its own
-- reading) or reader (its reading in dsl/moving.lua), check(a), refuse(a, given); numeric(a, num, given, code, c), what
-- the library is told (one act, or two), code(e) being an expression of the motion as dynamics/postfix.lua writes it;
-- formula, signs, source, example (a scene of bodies/), and where there is no args takes (rows {argument, unit,
-- default, about}) for docs/effects.md (docs/tools/effects.lua); and what it does, each optional:
--     torque(a, c)      about the origin of rotation, body axes, N m
--     force(a, c)       on the centre of mass, inertial axes (those of the base frame, if one turns), N
--     said(a)           the formula as these arguments have it; absent: formula
--     pushes(a)         false where that force is none whatever the motion; absent: it may be any
--     touches           it constrains the body, whose equations dynamics/contact.lua then has
--     states(a, given)  states of its own (given: what `initial` gives): a list of {name =, initial = expr, unit =,
--                       about =}
--     derivative(a, c)  their rates by name
--     momentum(a, c)    angular momentum that it holds beside the body's (a rotor), body axes: it adds -(h' + w x h)
--     momentum_rate(a, c)  the part of h' that is not in torque, where momentum depends on more than its own states
--     kinetic(a, c)     kinetic energy that it holds beside the body's, J
--     varies(a, c)      tensor that is added to the body's as a function of its own states (moving parts), or nil
--     turn(a, c)        rate at which the body's axes turn beside w: q' = q (0, w + turn)/2, body axes; its torque is
--                       momentum() x turn, so that L stays in space
--     carries(a)        tensor (six entries) that is added to the body's for the rates (a wheel that is not locked)
--     locks(a)          tensor that is added to the body's with everything in it held still (docs/mechanics.md)
--     products(a, c)    its torque on a body of three principal moments as what it adds to the products w2 w3, w3 w1,
--                       w1 w2 of Euler's equations; used in the place of torque where the tensor is such
--     potential(a, c)   energy, J
--     turning(a, c)     its potential, J, depends on time by turning about inertial z: {rate =, potential =}; not in
--                       potential then, see dynamics/conserved.lua
--     frame(a, c)       the base frame turns: {rate =, rate_dot =, centrifugal =}
--     moves(given)      true if the centre of mass moves freely (given: what `initial` gives)
--     conserves(a, c)   a list out of "T+V", "|L|", "L", "L_z", "w3", see dynamics/conserved.lua; absent: nothing
--                       keeps: the same in words, where it is a function;   decided = true: dynamics/laws.lua finds it
--     idle              { arguments by which it is multiplied, what else makes it vanish, in words }; where one is kept
--                       under another name: { "c", c = "C" }
--     input = true      it uses the input u;   single = true: once in a scene
--     central = true    it acts about the centre of mass, which must be the origin
--     fixed = advice    it acts about a fixed point, so a body that moves cannot have it
-- `c` is the context (dynamics/context.lua): mass, com, and inertia, the tensor about the origin with all wheels held
-- still; the symbols q, w, r, v, u, t and own.NAME of its own states; M, the mass as a symbol that cancels in
-- m r'' = F; and what docs/mechanics.md defines: tensor(), I, which has the moving parts too; L(), I w; momentum(), the
-- L of all that turns, body axes; diagonal, whether I has no products;
-- constant(name, expr, text), which keeps an expression of parameters as a derived constant, and
-- per_mass(name, expr, text), which is M times the constant expr/mass; lift(e, name, text): e of the motion with its
-- constant parts kept so; in derivative also dw, the three w'.  What an effect depends on is read from its
-- expressions.  ABOVE the line.

local lifted = require "generator.effects.lifted"

local list = {
  require "generator.effects.gravity",
  require "generator.effects.damping",
  require "generator.effects.torque",
  require "generator.effects.control",
  require "generator.effects.rotor",
  require "generator.effects.translation",
  require "generator.effects.drag",
  require "generator.effects.friction",
  require "generator.effects.spring",
  require "generator.effects.magnetic",
  require "generator.effects.eddy_current",
  require "generator.effects.wheel",
  require "generator.effects.gravity_gradient",
  require "generator.effects.solar_pressure",
  require "generator.effects.pivot",
  require "generator.effects.plane",
  require "generator.effects.inertia_rate",
  require "generator.effects.dissipation",
  require "generator.effects.custom",
  (require "generator.effects.rotating_frame"), -- one value: require also returns where it found it
}
for i, spec in ipairs(list) do list[i] = lifted.spec(spec) end

return list
