-- text.lua -- expressions as text; and a canonical text of their nodes.
--
--     text.of(e, style) -> text     style: "plain" (b*c, the default), "unicode" (b c, raised powers), "latex",
--                                   "mathml" or "typst"; "..." where it would be too long to read
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local double = require "generator.algebra.double"
local expr = require "generator.algebra.expr"
local expression = require "generator.formula.expression"
local linear = require "generator.formula.linear"
local latex = require "generator.formula.latex"
local mathml = require "generator.formula.mathml"
local setting = require "generator.formula.setting"
local tree = require "generator.formula.tree"
local typst = require "generator.formula.typst"

local text = {}

local styles = { plain = linear.plain, unicode = linear.unicode, latex = latex, mathml = mathml, typst = typst }

-- A number that is rounded, or too long to be read as a quotient, as a decimal; within the range of a double.
local function decimal(c)
  local size = R.log2(c)
  if math.max(R.log2(R.num(c)), R.log2(R.den(c))) <= 128 or math.abs(size) >= 1000 then return nil end
  return tree.num(double.shortest(R.todouble(c), 15))
end

local function rational(c) return R.sign(c) ~= 0 and decimal(c) or nil end
local in_a_line = { rational = rational }
local set = { rational = rational, names = function(name) return tree.sym(tree.split(name)) end }

local longest = 3000 -- parts; more is no text for people

function text.of(e, style)
  if expression.size(e, longest) > longest then return "..." end
  local s = styles[style or "plain"] or error("unknown style " .. style)
  return setting.of(s, expression.tree(e, s.linear and in_a_line or set))
end

-- A function that writes expressions so that every two are told apart, whatever their length: put(e) gives the number
-- of e's node, and put() all nodes so far, each one line by the numbers of its parts.  Shared nodes are written once,
-- so the work is linear in them.
function text.nodes()
  local number, lines = {}, {}
  local function put(e)
    if not e then return table.concat(lines, "\n") end
    if number[e] then return number[e] end
    local parts = { e.kind, e.name or e.fn or tostring(e.value or e.exp or "") }
    for _, c in ipairs(expr.children(e)) do parts[#parts + 1] = put(c) end
    lines[#lines + 1] = table.concat(parts, " ")
    number[e] = string.format("%d", #lines)
    return number[e]
  end
  return put
end

return text
