-- latex.lua -- formulas and documents in LaTeX: article and amsmath, nothing else.
-- SPDX-License-Identifier: GPL-3.0-or-later

local math_ = require "generator.report.handout.math"
local setting = require "generator.report.handout.setting"

local latex = { style = {} }
local style = latex.style

local special = { ["\\"] = "\\textbackslash{}", ["^"] = "\\textasciicircum{}", ["~"] = "\\textasciitilde{}",
  ["<"] = "\\textless{}", [">"] = "\\textgreater{}", ["|"] = "\\textbar{}" }
function latex.escape(s)
  return (string.gsub(s, "[\\^~<>|_#%%&${}]", function(c) return special[c] or "\\" .. c end))
end

local operators = { cross = "\\times", dot = "\\cdot", approx = "\\approx", ne = "\\neq", thin = "\\,", quad = "\\quad",
  times = "\\times" }
local functions = { asin = "\\arcsin", acos = "\\arccos", atan = "\\arctan" }
for word in string.gmatch("sin cos tan exp log sinh cosh tanh min max", "%a+") do functions[word] = "\\" .. word end

function style.num(s) return s end
function style.sym(base, sub, vector, dot)
  local s = math_.greek[base] and "\\" .. base or #base > 1 and "\\mathit{" .. latex.escape(base) .. "}" or base
  if vector then s = "\\vct{" .. s .. "}" end
  local word = #base > 1 and not math_.greek[base]
  if dot > 0 and not word then s = (dot > 1 and "\\ddot{" or "\\dot{") .. s .. "}" end
  if dot > 0 and word then s = "\\frac{\\mathrm{d}}{\\mathrm{d}t} \\, " .. s end
  if not sub then return s end
  return s .. "_{" .. (string.find(sub, "%a%a%a") and "\\mathrm{" .. sub .. "}" or sub) .. "}"
end
function style.op(name) return operators[name] or name end
function style.word(s) return "\\text{" .. latex.escape(s) .. "}" end
function style.unit(s) return "\\mathrm{" .. string.gsub(string.gsub(s, "%^(%-?%d+)", "^{%1}"), " ", "\\,") .. "}" end
function style.row(list) return table.concat(list, " ") end
function style.frac(a, b) return "\\frac{" .. a .. "}{" .. b .. "}" end
function style.sqrt(a) return "\\sqrt{" .. a .. "}" end
function style.pow(a, b) return a .. "^{" .. b .. "}" end
function style.par(a) return "\\left( " .. a .. " \\right)" end
function style.abs(a) return "\\left| " .. a .. " \\right|" end
function style.call(name, args)
  return (functions[name] or "\\operatorname{" .. latex.escape(name) .. "}") .. "\\left( " ..
    table.concat(args, ", ") .. " \\right)"
end
function style.matrix(rows)
  local lines = {}
  for i, r in ipairs(rows) do lines[i] = table.concat(r, " & ") end
  return "\\begin{pmatrix} " .. table.concat(lines, " \\\\[1ex] ") .. " \\end{pmatrix}"
end
function style.integral(low, high)
  return "\\int" .. (low and "_{" .. low .. "}" or "") .. (high and "^{" .. high .. "}" or "")
end

local head = [[
\documentclass[11pt,a4paper]{article}
\usepackage{amsmath}
\setlength{\textwidth}{165mm}\setlength{\oddsidemargin}{-3mm}\setlength{\evensidemargin}{-3mm}
\setlength{\textheight}{235mm}\setlength{\topmargin}{-12mm}
\setlength{\parindent}{0pt}\setlength{\parskip}{1ex}
\allowdisplaybreaks
\sloppy\raggedbottom
\newcommand{\vct}[1]{\boldsymbol{#1}} % for arrows: \renewcommand{\vct}[1]{\vec{#1}}
\begin{document}
]]

function latex.inline(n) return "$" .. setting.of(style, n) .. "$" end

-- Lines {left, right}: one under the other, at their signs.
function latex.display(lines)
  local out = {}
  for i, l in ipairs(lines) do out[i] = l[1] .. " &" .. (l[2] ~= "" and " " .. l[2] or "") end
  return "\\begin{align*}\n" .. table.concat(out, " \\\\\n") .. "\n\\end{align*}"
end

function latex.title(s) return head .. "\\section*{" .. latex.escape(s) .. "}" end
function latex.heading(s) return "\\subsection*{" .. latex.escape(s) .. "}" end
function latex.paragraph(parts) return "\\par " .. table.concat(parts) end
function latex.words(s) return latex.escape(s) end
function latex.list(items)
  local out = {}
  for i, s in ipairs(items) do out[i] = "\\item " .. s end
  return "\\begin{itemize}\n" .. table.concat(out, "\n") .. "\n\\end{itemize}"
end
function latex.listing(lines)
  return "{\\footnotesize\n\\begin{verbatim}\n" .. table.concat(lines, "\n") .. "\n\\end{verbatim}}"
end
latex.tail = "\\end{document}\n"

return latex
