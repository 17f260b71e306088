-- distinct.lua -- definitions by names that nothing else has: before lowering, and before names are given values.
--
-- A definition and an input are told apart by the rank of their symbols, in C by their names alone: the second stage's
-- acceleration `ay` is ay2, and so may be a constant of the scene.  Then the definition gives way.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"

local distinct = {}

local lowest, highest = 6, 9 -- ranks of definitions, methods/ and dynamics/

-- groups, of a description or a program, with no definition called like an input; inputs: name -> rank of its symbol.
-- The same groups where none is.
function distinct.run(groups, inputs)
  local used, clash = {}, false
  for _, g in ipairs(groups) do
    for _, d in ipairs(g.defs or {}) do
      used[d.name] = true
      clash = clash or inputs[d.name] ~= nil
    end
  end
  if not clash then return groups end
  local map, list = {}, {}
  for i, g in ipairs(groups) do
    local copy = { defs = {}, outs = {} }
    for k, v in pairs(g) do copy[k] = copy[k] or v end -- into a table: order is lost anyway
    for k, d in ipairs(g.defs or {}) do
      local name = d.name
      local e = calculus.substitute(d.expr, map)
      while inputs[name] or name ~= d.name and used[name] do name = name .. "_" end
      if name ~= d.name then
        used[name] = true
        for rank = lowest, highest do
          if rank ~= inputs[d.name] then map[expr.sym(d.name, rank)] = expr.sym(name, rank) end
        end
      end
      copy.defs[k] = { name = name, expr = e }
    end
    for k, o in ipairs(g.outs or {}) do
      local out = {}
      for key, v in pairs(o) do out[key] = v end -- into a table: order is lost anyway
      out.expr = calculus.substitute(o.expr, map)
      copy.outs[k] = out
    end
    list[i] = copy
  end
  return list
end

return distinct
