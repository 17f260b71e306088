-- typst.lua -- formulas in Typst's mathematics.
-- SPDX-License-Identifier: GPL-3.0-or-later

local tree = require "generator.formula.tree"

local typst = { slash = "\\/" }

local operators = { approx = "approx", ne = "!=", quad = "quad", times = "times", to = "->" }
local functions = {}
for word in string.gmatch("sin cos tan exp log sinh cosh tanh min max", "%a+") do functions[word] = word end
functions.asin, functions.acos, functions.atan, functions.K = "arcsin", "arccos", "arctan", "K"

local function quoted(s) return '"' .. string.gsub(s, '["\\]', "\\%0") .. '"' end

-- Typst takes letters and digits that stand together for the name of a variable.
local function index(sub)
  local words = string.gsub(sub, "(%a+)(%d*)", function(word, digits)
    local w = quoted(word)
    if tree.greek[word] or #word == 1 then w = word end
    if string.find(word, "^[xyzijk]+$") then w = (string.gsub(word, ".", "%0 ", #word - 1)) end
    return w .. (digits ~= "" and " " .. digits or "")
  end)
  return words
end

function typst.num(s) return s end
function typst.sym(base, sub, vector, dot)
  local s = (tree.greek[base] or #base == 1) and base or "italic(" .. quoted(base) .. ")"
  if vector then s = "bold(" .. s .. ")" end
  if dot > 0 then s = (dot > 1 and "dot.double(" or "dot(") .. s .. ")" end
  return sub and s .. "_(" .. index(sub) .. ")" or s
end
function typst.op(name) return operators[name] or name end
typst.word = quoted
function typst.unit(s)
  local out = {}
  for stem, power in string.gmatch(s, "([^%s%^]+)%^?(%-?%d*)") do
    out[#out + 1] = quoted(stem) .. (power ~= "" and "^(" .. power .. ")" or "")
  end
  return table.concat(out, " thin ")
end
function typst.quantity(s, unit) return s .. " thin " .. unit end
function typst.row(list) return table.concat(list, " ") end
function typst.product(list)
  local out = list[1]
  for i = 2, #list do
    local words = string.find(list[i], "^italic%(") or string.find(list[i - 1], "^italic%(")
    out = out .. (words and " thin " or " ") .. list[i]
  end
  return out
end
function typst.minus(s) return "- " .. s end
function typst.sum(list)
  local out = {}
  for i, t in ipairs(list) do out[i] = (t.sign and t.sign .. " " or "") .. t.text end
  return table.concat(out, " ")
end
function typst.cross(a, b) return a .. " times " .. b end
function typst.dot(a, b) return a .. " dot.op " .. b end
function typst.frac(a, b) return "frac(" .. a .. ", " .. b .. ")" end
function typst.sqrt(a) return "sqrt(" .. a .. ")" end
function typst.pow(a, b) return a .. "^(" .. b .. ")" end
function typst.par(a) return "lr(( " .. a .. " ))" end
function typst.abs(a) return "abs(" .. a .. ")" end
function typst.mean(s) return "lr(⟨ " .. s .. " ⟩)" end -- by themselves: their names differ between versions
function typst.at(a, b) return a .. " lr(( " .. b .. " ))" end
function typst.call(name, args, power)
  return (functions[name] or "op(" .. quoted(name) .. ")") .. (power and "^(" .. power .. ")" or "") .. " lr(( " ..
    table.concat(args, " , ") .. " ))"
end
function typst.matrix(rows)
  local out = {}
  for i, r in ipairs(rows) do out[i] = table.concat(r, ", ") end
  return "mat(" .. table.concat(out, "; ") .. ")"
end
function typst.tuple(list) return typst.par(table.concat(list, " , ")) end
function typst.integral(low, high)
  return "integral" .. (low and "_(" .. low .. ")" or "") .. (high and "^(" .. high .. ")" or "")
end
function typst.diff(s) return "thin dif " .. s end

return typst
