-- html.lua -- the hand-out as one HTML page, formulas in MathML: no script, nothing to load.
-- SPDX-License-Identifier: GPL-3.0-or-later

local math_ = require "generator.report.handout.math"
local setting = require "generator.report.handout.setting"

local html = { style = {} }
local style = html.style

local letters = { alpha = "α", beta = "β", gamma = "γ", delta = "δ", epsilon = "ε", zeta = "ζ", eta = "η",
  theta = "θ", kappa = "κ",
  lambda = "λ", mu = "μ", nu = "ν", xi = "ξ", rho = "ρ", sigma = "σ", tau = "τ",
  pi = "π", Pi = "Π", Lambda = "Λ", phi = "φ", psi = "ψ", omega = "ω",
  Omega = "Ω", Delta = "Δ", Phi = "Φ", Psi = "Ψ", Theta = "Θ" }
local operators = { cross = "×", dot = "·", approx = "≈", ne = "≠", times = "×", ["-"] = "−", ["<"] = "&lt;",
  [">"] = "&gt;" }

local entities = { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;" }
function html.escape(s) return (string.gsub(s, '[&<>"]', entities)) end

local function row(list) return "<mrow>" .. table.concat(list) .. "</mrow>" end

function style.num(s) return "<mn>" .. s .. "</mn>" end
function style.sym(base, sub, vector, dot)
  local letter = math_.greek[base] and letters[base] or html.escape(base)
  local s = vector and '<mi class="v">' .. letter .. "</mi>" or "<mi>" .. letter .. "</mi>"
  if dot > 0 then s = "<mover>" .. s .. "<mo>" .. (dot > 1 and "¨" or "˙") .. "</mo></mover>" end
  return sub and "<msub>" .. s .. "<mi>" .. html.escape(sub) .. "</mi></msub>" or s
end
function style.op(name)
  local space = name == "thin" and "0.17em" or name == "quad" and "1em"
  return space and '<mspace width="' .. space .. '"/>' or "<mo>" .. (operators[name] or html.escape(name)) .. "</mo>"
end
function style.word(s) return "<mtext>" .. html.escape(s) .. "</mtext>" end
function style.unit(s)
  local out = {}
  for stem, power in string.gmatch(s, "([^%s%^]+)%^?(%-?%d*)") do
    local word = "<mtext>" .. html.escape(stem) .. "</mtext>"
    out[#out + 1] = power ~= "" and "<msup>" .. word .. "<mn>" .. power .. "</mn></msup>" or word
  end
  return row { table.concat(out, '<mspace width="0.17em"/>') }
end
style.row = row
function style.frac(a, b) return "<mfrac>" .. a .. b .. "</mfrac>" end
function style.sqrt(a) return "<msqrt>" .. a .. "</msqrt>" end
function style.pow(a, b) return "<msup>" .. a .. b .. "</msup>" end
function style.par(a) return row { "<mo>(</mo>", a, "<mo>)</mo>" } end
function style.abs(a) return row { "<mo>|</mo>", a, "<mo>|</mo>" } end
function style.call(name, args)
  return row { "<mi>", html.escape(name), "</mi><mo>(</mo>", table.concat(args, "<mo>,</mo>"), "<mo>)</mo>" }
end
function style.matrix(rows)
  local out = {}
  for i, r in ipairs(rows) do
    out[i] = "<mtr><mtd>" .. table.concat(r, "</mtd><mtd>") .. "</mtd></mtr>"
  end
  return row { "<mo>(</mo><mtable>", table.concat(out), "</mtable><mo>)</mo>" }
end
function style.integral(low, high)
  if not low then return "<mo>∫</mo>" end
  return high and "<msubsup><mo>∫</mo>" .. low .. high .. "</msubsup>" or "<msub><mo>∫</mo>" .. low .. "</msub>"
end

function html.inline(n) return "<math>" .. setting.of(style, n) .. "</math>" end
function html.display(lines)
  local out = {}
  for i, l in ipairs(lines) do
    out[i] = '<mtr><mtd class="l">' .. row { l[1] } .. '</mtd><mtd class="r">' .. row { l[2] } .. "</mtd></mtr>"
  end
  return '<math display="block"><mtable displaystyle="true">' .. table.concat(out) .. "</mtable></math>"
end
function html.title(s)
  return '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>' .. html.escape(s) .. "</title>\n" ..
    "<style>body { max-width: 48em; margin: 2em auto; padding: 0 1em; font-family: serif }\n" ..
    "math[display] { overflow-x: auto; margin: 0.7em 0 } .v { font-weight: bold } .l { text-align: right }\n" ..
    ".r { text-align: left }</style></head><body>\n<h1>" .. html.escape(s) .. "</h1>"
end
function html.heading(s) return "<h2>" .. html.escape(s) .. "</h2>" end
function html.paragraph(parts) return "<p>" .. table.concat(parts) .. "</p>" end
function html.words(s) return html.escape(s) end
function html.list(items) return "<ul>\n<li>" .. table.concat(items, "</li>\n<li>") .. "</li>\n</ul>" end
function html.listing(lines) return "<pre>" .. html.escape(table.concat(lines, "\n")) .. "</pre>" end
html.tail = "</body></html>\n"

return html
