-- step_control.lua -- what methods with an embedded estimate of their error have in common, as C: the error of a step
-- in the norm of its states, the length of the next one, the contract of a run.
-- SPDX-License-Identifier: GPL-3.0-or-later

local floors = require "generator.emit.floors"
local source = require "generator.emit.source"
local template = require "generator.emit.template"

local GROWTH, NORM = template.group "steppers/growth.c", template.group "steppers/norm.c"
local RUN = template.group "steppers/run.h"

local step_control = {}

-- The function that all of them call, before the first.
function step_control.shared(kit) return GROWTH(kit.templates, kit.base, {}) "steppers/growth.c" end

-- Texts for v, the values of the method's own templates, which have been given those of switched.lua.  A pair ends in
-- the states that move alone, the linearly implicit method in all.
function step_control.put(v, s, kit, method)
  local own = { method = method, kinds = source.kinds(s.program.states),
    place = method == "adaptive" and "k" or kit.ctx.name .. "_" .. method .. "_moving[k]" }
  floors.put(own, s.program, kit)
  v.norm = NORM(kit.templates, kit.base, own) "steppers/norm.c"
  v.norm_pass = floors.passed(s.program, "m", "u", "h")
  v.run = RUN(kit.templates, kit.base, { method = method, has_switches = v.has_switches,
    has_sides = v.has_sides }) "steppers/run.h"
end

return step_control
