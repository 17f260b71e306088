-- description.lua -- the parts of a function's description.
--
-- A description is {name, args, result, doc, groups, when}: args are the words m x xo t u h n (see emit/source.lua) or
-- arrays {name, count, doc, out}; groups are equation groups {why, defs, outs}, where an out is {array, index, expr},
-- {state, expr} (into dx) or {result, expr}.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"

local description = {}

local comp = { "x", "y", "z" }

-- size: the count in the header's own names
function description.array(name, count, out, size) return { name = name, count = count, out = out, size = size } end

-- Symbols of an array argument: {r} -> rx, ry, rz for 3, rxx.. for 6.
function description.symbols(name, count)
  local v = {}
  for i = 1, count do v[i] = expr.sym(name .. (count == 6 and vec.entry[i] or comp[i]), 8) end
  return v
end

-- The components of v into the array.
function description.outs(name, v)
  return vec.map(v, function(e, i) return { array = name, index = i - 1, expr = e } end)
end

function description.group(why, defs, results) return { why = why, defs = defs, outs = results } end

return description
