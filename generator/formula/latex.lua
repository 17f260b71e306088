-- latex.lua -- formulas in LaTeX with amsmath; \vct is a macro of the document (report/handout/latex.lua).
-- SPDX-License-Identifier: GPL-3.0-or-later

local tree = require "generator.formula.tree"

local latex = { slash = "/" }

local special = { ["\\"] = "\\textbackslash{}", ["^"] = "\\textasciicircum{}", ["~"] = "\\textasciitilde{}",
  ["<"] = "\\textless{}", [">"] = "\\textgreater{}", ["|"] = "\\textbar{}" }
function latex.escape(s)
  return (string.gsub(s, "[\\^~<>|_#%%&${}]", function(c) return special[c] or "\\" .. c end))
end

local operators = { approx = "\\approx", ne = "\\neq", quad = "\\quad", times = "\\times", to = "\\to" }
local functions = { asin = "\\arcsin", acos = "\\arccos", atan = "\\arctan", K = "K" }
for word in string.gmatch("sin cos tan exp log sinh cosh tanh min max", "%a+") do functions[word] = "\\" .. word end

function latex.num(s) return s end
function latex.sym(base, sub, vector, dot)
  local s = tree.greek[base] and "\\" .. base or #base > 1 and "\\mathit{" .. latex.escape(base) .. "}" or base
  if vector then s = "\\vct{" .. s .. "}" end
  local long = #base > 1 and not tree.greek[base]
  if dot > 0 and not long then s = (dot > 1 and "\\ddot{" or "\\dot{") .. s .. "}" end
  if dot > 0 and long then s = "\\frac{\\mathrm{d}}{\\mathrm{d}t} \\, " .. s end
  if not sub then return s end
  sub = string.gsub(sub, "[%a_]+", function(word)
    if tree.greek[word] then return "\\" .. word .. " " end
    if string.find(word, "^[xyzijk]+$") or #word == 1 then return word end
    return "\\mathrm{" .. latex.escape(word) .. "}"
  end)
  return s .. "_{" .. string.gsub(sub, " $", "") .. "}"
end
function latex.op(name) return operators[name] or name end
function latex.word(s) return "\\text{" .. latex.escape(s) .. "}" end
function latex.unit(s) return "\\mathrm{" .. string.gsub(string.gsub(s, "%^(%-?%d+)", "^{%1}"), " ", "\\,") .. "}" end
function latex.quantity(s, unit) return s .. " \\, " .. unit end
function latex.row(list) return table.concat(list, " ") end
-- A word beside another factor keeps off it: grip grip_x.
function latex.product(list)
  local out = list[1]
  for i = 2, #list do
    local words = string.find(list[i], "^\\mathit{") or string.find(list[i - 1], "\\mathit{[^{}]*}[_{},%w]*$")
    out = out .. (words and " \\: " or " ") .. list[i]
  end
  return out
end
function latex.minus(s) return "- " .. s end
function latex.sum(list)
  local out = {}
  for i, t in ipairs(list) do out[i] = (t.sign and t.sign .. " " or "") .. t.text end
  return table.concat(out, " ")
end
function latex.cross(a, b) return a .. " \\times " .. b end
function latex.dot(a, b) return a .. " \\cdot " .. b end
function latex.frac(a, b) return "\\frac{" .. a .. "}{" .. b .. "}" end
function latex.sqrt(a) return "\\sqrt{" .. a .. "}" end
function latex.pow(a, b) return a .. "^{" .. b .. "}" end
function latex.par(a) return "\\left( " .. a .. " \\right)" end
function latex.abs(a) return "\\left| " .. a .. " \\right|" end
function latex.mean(s) return "\\left\\langle " .. s .. " \\right\\rangle" end
function latex.at(a, b) return a .. "(" .. b .. ")" end
function latex.call(name, args, power)
  local head = functions[name] or "\\operatorname{" .. latex.escape(name) .. "}"
  return head .. (power and "^{" .. power .. "}" or "") .. latex.par(table.concat(args, ", "))
end
function latex.matrix(rows)
  local lines = {}
  for i, r in ipairs(rows) do lines[i] = table.concat(r, " & ") end
  return "\\begin{pmatrix} " .. table.concat(lines, " \\\\[1ex] ") .. " \\end{pmatrix}"
end
function latex.tuple(list) return latex.par(table.concat(list, ", ")) end
function latex.integral(low, high)
  return "\\int" .. (low and "_{" .. low .. "}" or "") .. (high and "^{" .. high .. "}" or "")
end
function latex.diff(s) return "\\, \\mathrm{d}" .. s end

return latex
