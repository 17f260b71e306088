-- typst.lua -- the hand-out in Typst.
-- SPDX-License-Identifier: GPL-3.0-or-later

local setting = require "generator.formula.setting"
local formulas = require "generator.formula.typst"

local typst = { style = formulas }

local head = [[
#set page(paper: "a4", margin: (x: 27mm, y: 20mm), numbering: "1")
#set text(size: 10pt)
#set par(justify: true, spacing: 0.75em)
#set block(spacing: 0.75em)
#show heading.where(level: 2): set block(above: 1.4em, below: 0.8em)
#show math.equation.where(block: true): set block(breakable: true)
]]

function typst.inline(n) return "$" .. setting.of(formulas, n) .. "$" end
function typst.display(lines)
  local out = {}
  for i, l in ipairs(lines) do out[i] = l[1] .. " & " .. l[2] end
  return "$ " .. table.concat(out, " \\\n  ") .. " $\n"
end
function typst.title(s, under)
  return head .. "= " .. typst.words(s) .. "\n" .. (#under > 0 and typst.words(table.concat(under, ", ")) .. "\n" or "")
end
function typst.heading(s) return "== " .. typst.words(s) .. "\n" end
function typst.paragraph(parts)
  local text = table.concat(parts)
  -- what is not the end of a sentence stays on the page of the display that follows
  return (string.find(text, "%.$") and text or "#block(sticky: true)[" .. text .. "]") .. "\n"
end
function typst.words(s)
  s = string.gsub(s, "[\\#$*_`<>@~%[%]=/\"]", "\\%0")
  return (string.gsub(string.gsub(s, "^[-+]", "\\%0"), "^(%d+)%.", "%1\\.")) -- no item of a list
end
function typst.list(items) return "- " .. table.concat(items, "\n- ") .. "\n" end
function typst.listing(lines) return "```\n" .. table.concat(lines, "\n") .. "\n```\n" end
typst.tail = ""

return typst
