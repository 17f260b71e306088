-- html.lua -- the hand-out as one HTML page, formulas in MathML: no script, nothing to load.
-- SPDX-License-Identifier: GPL-3.0-or-later

local mathml = require "generator.formula.mathml"
local setting = require "generator.formula.setting"

local html = { style = mathml, escape = mathml.escape }

local row = mathml.row

function html.inline(n) return "<math>" .. setting.of(mathml, n) .. "</math>" end
function html.display(lines)
  local out = {}
  for i, l in ipairs(lines) do
    out[i] = '<mtr><mtd class="l">' .. row { l[1] } .. '</mtd><mtd class="r">' .. row { l[2] } .. "</mtd></mtr>"
  end
  return '<math display="block"><mtable displaystyle="true">' .. table.concat(out) .. "</mtable></math>"
end
function html.title(s, under)
  return '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>' .. html.escape(s) .. "</title>\n" ..
    "<style>body { max-width: 48em; margin: 2em auto; padding: 0 1em; font-family: serif }\n" ..
    "math[display] { overflow-x: auto; margin: 0.7em 0 } .v { font-weight: bold } .l { text-align: right }\n" ..
    ".r { text-align: left }</style></head><body>\n<h1>" .. html.escape(s) .. "</h1>" ..
    (#under > 0 and "\n<p>" .. html.escape(table.concat(under, ", ")) .. "</p>" or "")
end
function html.heading(s) return "<h2>" .. html.escape(s) .. "</h2>" end
function html.paragraph(parts) return "<p>" .. table.concat(parts) .. "</p>" end
function html.words(s) return html.escape(s) end
function html.list(items) return "<ul>\n<li>" .. table.concat(items, "</li>\n<li>") .. "</li>\n</ul>" end
function html.listing(lines) return "<pre>" .. html.escape(table.concat(lines, "\n")) .. "</pre>" end
html.tail = "</body></html>\n"

return html
