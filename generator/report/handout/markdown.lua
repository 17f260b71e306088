-- markdown.lua -- the hand-out in Markdown, formulas between dollar signs as KaTeX and MathJax read them.
-- SPDX-License-Identifier: GPL-3.0-or-later

local latex = require "generator.formula.latex"
local setting = require "generator.formula.setting"

local markdown = { style = setmetatable({}, { __index = latex }) }

function markdown.style.sym(...) -- \vct is a macro of the LaTeX document
  return (string.gsub(latex.sym(...), "\\vct", "\\boldsymbol"))
end

function markdown.inline(n) return "$" .. setting.of(markdown.style, n) .. "$" end
function markdown.display(lines)
  local out = {}
  for i, l in ipairs(lines) do out[i] = l[1] .. " &" .. (l[2] ~= "" and " " .. l[2] or "") end
  return "$$\n\\begin{aligned}\n" .. table.concat(out, " \\\\\n") .. "\n\\end{aligned}\n$$\n"
end
function markdown.title(s, under)
  return "# " .. markdown.words(s) .. "\n" ..
    (#under > 0 and "\n" .. markdown.words(table.concat(under, ", ")) .. "\n" or "")
end
function markdown.heading(s) return "## " .. s .. "\n" end
function markdown.paragraph(parts) return table.concat(parts) .. "\n" end
function markdown.words(s) return (string.gsub(s, "[\\*_$<|]", "\\%0")) end
function markdown.list(items) return "- " .. table.concat(items, "\n- ") .. "\n" end
function markdown.listing(lines) return "```\n" .. table.concat(lines, "\n") .. "\n```\n" end
markdown.tail = ""

return markdown
