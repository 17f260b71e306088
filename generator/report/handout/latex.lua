-- latex.lua -- formulas and documents in LaTeX: article and amsmath, nothing else.
-- SPDX-License-Identifier: GPL-3.0-or-later

local formulas = require "generator.formula.latex"
local setting = require "generator.formula.setting"

local latex = { style = formulas, escape = formulas.escape }

local head = [[
\documentclass[10pt,a4paper]{article}
\usepackage{amsmath}
\setlength{\textwidth}{155mm}\setlength{\oddsidemargin}{2mm}\setlength{\evensidemargin}{2mm}
\setlength{\textheight}{250mm}\setlength{\topmargin}{-18mm}
\setlength{\parindent}{0pt}\setlength{\parskip}{0.6ex plus 0.2ex}\setlength{\jot}{2pt}
\makeatletter
\newcommand{\heading}{\@startsection{subsection}{2}{0pt}{1.6ex plus 0.6ex}{0.6ex}{\normalfont\large\bfseries}}
\makeatother
\allowdisplaybreaks
\sloppy\raggedbottom
\newcommand{\vct}[1]{\boldsymbol{#1}} % for arrows: \renewcommand{\vct}[1]{\vec{#1}}
% functions and factors stand close to their brackets
\let\widebegin\left\let\wideend\right
\renewcommand{\left}{\mathopen{}\mathclose\bgroup\widebegin}
\renewcommand{\right}{\aftergroup\egroup\wideend}
\begin{document}
\setlength{\abovedisplayskip}{5pt plus 2pt minus 2pt}\setlength{\abovedisplayshortskip}{5pt plus 2pt minus 2pt}
\setlength{\belowdisplayskip}{5pt plus 2pt minus 2pt}\setlength{\belowdisplayshortskip}{5pt plus 2pt minus 2pt}
]]

function latex.inline(n) return "$" .. setting.of(formulas, n) .. "$" end

-- Lines {left, right}: one under the other, at their signs.
function latex.display(lines)
  local out = {}
  for i, l in ipairs(lines) do out[i] = l[1] .. " &" .. (l[2] ~= "" and " " .. l[2] or "") end
  return "\\begin{align*}\n" .. table.concat(out, " \\\\\n") .. "\n\\end{align*}"
end

function latex.title(s, under)
  return head .. "\\section*{" .. latex.escape(s) .. "}" .. (#under > 0 and "\n\\par " ..
    latex.escape(table.concat(under, ", ")) or "")
end
function latex.heading(s) return "\\heading*{" .. latex.escape(s) .. "}" end
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
