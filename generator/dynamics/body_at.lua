-- body_at.lua -- what is wrong with the body of a scene for other values of its parameters, or nil.
--
--     body_at(job, values) -> the words of NAME_init's checks; values: name -> rational, the others as in the scene
-- For what NAME_init cannot ask (mass/within.lua): polygons are looked at, and points of holes, in some 10 ms.
-- SPDX-License-Identifier: GPL-3.0-or-later

local evaluate = require "generator.algebra.evaluate"
local holes = require "generator.mass.holes"
local numeric = require "generator.dynamics.numeric"
local simple = require "generator.mass.simple"

-- The polygons of a tree, each by f(node).
local function each_polygon(node, f)
  if node.shape then return node.a and node.a.profile and f(node) end
  each_polygon(node.of or node[1], f)
  if not node.of then each_polygon(node[2], f) end
end

return function(job, values)
  local all, said = {}, nil
  for _, p in ipairs(job.record.params) do all[p.name] = values[p.name] or p.default end
  local listener = { warn = function() end, error = function(_, line, what, rule)
    said = said or job.model:sentence { what = what, rule = rule, line = line }
  end }
  local function number(e) return evaluate.precise(e, all, 240) end
  each_polygon(job.model.record.body, function(node)
    simple.faults(node.a.profile, node.a.holes or {}, number, function(n, rule)
      listener.error(nil, node.line, string.gsub(node.shape, "^solid%.", ""), simple.name(n) .. " " .. rule)
    end)
  end)
  if said then return said end
  local model = { record = job.model.record, number = function(_, e) return number(e) end }
  local done = pcall(holes.check, listener, model, numeric.scene(job, all).body)
  return done and said or nil -- what is no shape at all for these values, NAME_init refuses by itself
end
