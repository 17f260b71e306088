-- holes_at.lua -- what is wrong with the holes of a scene for other values of its parameters, or nil.
--
--     holes_at(job, values) -> the words of NAME_init's checks; values: name -> rational, the others as in the scene
-- For the holes of which NAME_init cannot ask (mass/within.lua): points are asked, in some 10 ms.
-- SPDX-License-Identifier: GPL-3.0-or-later

local evaluate = require "generator.algebra.evaluate"
local holes = require "generator.mass.holes"
local numeric = require "generator.dynamics.numeric"

return function(job, values)
  local all, said = {}, nil
  for _, p in ipairs(job.record.params) do all[p.name] = values[p.name] or p.default end
  local listener = { warn = function() end, error = function(_, line, what, rule)
    said = said or job.model:sentence { what = what, rule = rule, line = line }
  end }
  local model = { record = job.model.record, number = function(_, e) return evaluate.precise(e, all, 240) end }
  local done = pcall(holes.check, listener, model, numeric.scene(job, all).body)
  return done and said or nil -- what is no shape at all for these values, NAME_init refuses by itself
end
