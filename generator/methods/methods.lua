-- methods.lua -- the steppers that can be emitted, in the order they are listed.
--
-- One file a method.  Each gives: name; about (one line); order (of convergence; nil where it is an option); and either
--     groups(eq, constant)      the step as equation groups, printed as one function (rk4.lua)
--     plain(eq, constant)       the step as equation groups for what is derived from it (optional; without a division
--                               by h, and also of a method that is printed by parts: adaptive.lua)
--     increments(eq, constant)  what the step adds, as equation groups (optional: compensated.lua)
--     program(eq, options)      what emit/NAME.lua makes C of with templates/NAME.h and .c; nil and why it cannot
--     refused(eq)               why it cannot step the equations (optional: of one without program)
--     needs                     its special paths, {path =, needs = what it must find in a scene, in words}: claim.lua
--     methods.refused(eq, method)  why the method cannot step the equations at all, or nil
-- adaptive = true: NAME_METHOD_run chooses its steps from a tolerance.  stiff = true: the planner takes it where
-- something decays much faster than the motion.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local contact = require "generator.dynamics.contact"

local list = {
  require "generator.methods.rk4",
  require "generator.methods.adaptive",
  require "generator.methods.taylor",
  require "generator.methods.rosenbrock",
  require "generator.methods.midpoint",
  (require "generator.methods.semi"), -- one value: require also returns where it found it
}

for _, m in ipairs(require("generator.methods.split").methods) do list[#list + 1] = m end

list.by_name = {}
for _, m in ipairs(list) do list.by_name[m.name] = m end

-- What takes the equations of motion as they are, and asks nothing of where they come from.
local of_any = { rk4 = true, adaptive = true, taylor = true, rosenbrock = true }

function list.refused(eq, method)
  if of_any[method.name] then return nil end
  if not contact.of(eq.model) then return method.refused and method.refused(eq) or nil end
  return "the body touches a plane, and this method makes its step of torques and free turning (rk4, adaptive, " ..
    "taylor and rosenbrock step any equations)"
end

return list
