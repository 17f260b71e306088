-- mathml.lua -- formulas as MathML Core, which browsers draw by themselves.
--
-- Rounded brackets do not stretch around what is one line high: Chromium leaves gaps else.
-- SPDX-License-Identifier: GPL-3.0-or-later

local mathml = { slash = "<mo>/</mo>" }

local letters = { alpha = "α", beta = "β", gamma = "γ", delta = "δ", epsilon = "ε", zeta = "ζ", eta = "η",
  theta = "θ", kappa = "κ", lambda = "λ", mu = "μ", nu = "ν", xi = "ξ", rho = "ρ", sigma = "σ", tau = "τ", pi = "π",
  phi = "φ", psi = "ψ", omega = "ω", Omega = "Ω", Delta = "Δ", Phi = "Φ", Psi = "Ψ", Theta = "Θ", Lambda = "Λ",
  Pi = "Π", Gamma = "Γ", Sigma = "Σ", Xi = "Ξ" }
mathml.letters = letters
local operators = { approx = "≈", ne = "≠", times = "×", to = "→", ["-"] = "−", ["<"] = "&lt;", [">"] = "&gt;" }
local TIMES, THIN = "<mo>\u{2062}</mo>", '<mspace width="0.17em"/>'

local entities = { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;" }
function mathml.escape(s) return (string.gsub(s, '[&<>"]', entities)) end

local function row(list) return "<mrow>" .. table.concat(list) .. "</mrow>" end
local function tall(s) return string.find(s, "<mfrac>", 1, true) or string.find(s, "<mtable>", 1, true) end
local function fence(open, s, close)
  local stretchy = tall(s) and "" or ' stretchy="false"'
  return row { "<mo", stretchy, ">", open, "</mo>", s, "<mo", stretchy, ">", close, "</mo>" }
end

function mathml.num(s) return "<mn>" .. s .. "</mn>" end
function mathml.sym(base, sub, vector, dot)
  local letter = letters[base] or mathml.escape(base)
  local s = vector and '<mi class="v">' .. letter .. "</mi>" or "<mi>" .. letter .. "</mi>"
  if dot > 0 then s = '<mover accent="true">' .. s .. "<mo>" .. (dot > 1 and "¨" or "˙") .. "</mo></mover>" end
  if not sub then return s end
  local parts = {}
  for word, rest in string.gmatch(sub, "(%w*)(%W*)") do
    if string.find(word, "^[xyzijk]+$") then word = string.gsub(word, ".", "<mi>%0</mi>") -- components are letters each
    elseif word ~= "" then word = "<mi>" .. (letters[word] or word) .. "</mi>" end
    parts[#parts + 1] = word .. (rest ~= "" and "<mo>" .. mathml.escape(rest) .. "</mo>" or "")
  end
  local index = table.concat(parts)
  if select(2, string.gsub(index, "</m", "")) > 1 then index = "<mrow>" .. index .. "</mrow>" end
  return "<msub>" .. s .. index .. "</msub>"
end
function mathml.op(name)
  if name == "quad" then return '<mspace width="1em"/>' end
  return "<mo>" .. (operators[name] or mathml.escape(name)) .. "</mo>"
end
function mathml.word(s) return "<mtext>" .. mathml.escape(s) .. "</mtext>" end
function mathml.unit(s)
  local out = {}
  for stem, power in string.gmatch(s, "([^%s%^]+)%^?(%-?%d*)") do
    local word = "<mtext>" .. mathml.escape(stem) .. "</mtext>"
    out[#out + 1] = power ~= "" and "<msup>" .. word .. "<mn>" .. power .. "</mn></msup>" or word
  end
  return row { table.concat(out, THIN) }
end
function mathml.quantity(s, unit) return row { s, THIN, unit } end
mathml.row = row

-- Names of several letters need a gap, or two look like one.
function mathml.product(list)
  return row { table.concat(list, TIMES .. '<mspace width="0.1em"/>') }
end
function mathml.minus(s) return row { '<mo form="prefix">−</mo>', s } end
function mathml.sum(list, starts)
  local out = {}
  for i, t in ipairs(list) do
    local form = i == 1 and starts and ' form="prefix"' or ""
    if t.sign then out[#out + 1] = "<mo" .. form .. ">" .. (t.sign == "-" and "−" or "+") .. "</mo>" end
    out[#out + 1] = t.text
  end
  return row(out)
end
function mathml.cross(a, b) return row { a, "<mo>×</mo>", b } end
function mathml.dot(a, b) return row { a, "<mo>·</mo>", b } end
function mathml.frac(a, b) return "<mfrac>" .. a .. b .. "</mfrac>" end
function mathml.sqrt(a) return "<msqrt>" .. a .. "</msqrt>" end
function mathml.pow(a, b) return "<msup>" .. a .. row { b } .. "</msup>" end
function mathml.par(a) return fence("(", a, ")") end
function mathml.abs(a) return fence("|", a, "|") end
function mathml.mean(s) return fence("⟨", s, "⟩") end
function mathml.at(a, b) return row { a, fence("(", b, ")") } end
function mathml.call(name, args, power)
  local head = "<mi>" .. mathml.escape(name) .. "</mi>"
  if power then head = "<msup>" .. head .. row { power } .. "</msup>" end
  return row { head, "<mo>\u{2061}</mo>", fence("(", table.concat(args, "<mo>,</mo>"), ")") }
end
function mathml.matrix(rows)
  local out = {}
  for i, r in ipairs(rows) do out[i] = "<mtr><mtd>" .. table.concat(r, "</mtd><mtd>") .. "</mtd></mtr>" end
  return fence("(", "<mtable>" .. table.concat(out) .. "</mtable>", ")")
end
function mathml.tuple(list) return fence("(", table.concat(list, "<mo>,</mo>"), ")") end
function mathml.integral(low, high)
  if not low then return "<mo>∫</mo>" end
  return high and "<msubsup><mo>∫</mo>" .. row { low } .. row { high } .. "</msubsup>" or
    "<msub><mo>∫</mo>" .. row { low } .. "</msub>"
end
-- A number that the page's script puts in.
function mathml.live(name) return '<mn data-value="' .. name .. '">0</mn>' end

function mathml.diff(s) return row { THIN, '<mi mathvariant="normal">d</mi>', s } end

return mathml
