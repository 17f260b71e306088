-- math.lua -- formulas as trees, written once and set as LaTeX, MathML or Typst (handout/latex.lua and its neighbours).
--
-- A node is {kind, ...}:
--     num  digits            upright digits, a minus sign before them as an operator
--     sym  base, sub, vector, dot     base: a letter, the name of a Greek one, or a word; dot: how many dots
--     op   name              = + - x(cross) . , < > approx and so on, by the keys of `math.operators`
--     word text              upright words or a unit
--     row  nodes...          frac  above, below       sqrt  of       pow  base, exponent       par  of       abs  of
--     call name, nodes...    matrix  rows             sum  {minus =, node}...: what may be broken before a sign
--     integral low, high     (both nil: over the body)
-- math.read reads a short notation for formulas that are the same for every body.
-- SPDX-License-Identifier: GPL-3.0-or-later

local math_ = {}

math_.operators = { "=", "+", "-", "cross", "dot", ",", "<", ">", "approx", "ne", "thin", "quad", "times" }

math_.greek = {}
local letters = "alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi rho sigma tau phi psi omega pi " ..
  "Omega Delta Phi Psi Theta Lambda Pi"
for word in string.gmatch(letters, "%a+") do math_.greek[word] = true end

local function rounded(x, digits) return string.format("%." .. string.format("%d", digits) .. "g", x) end

function math_.num(digits) return { kind = "num", digits } end
function math_.op(name) return { kind = "op", name } end
function math_.word(text) return { kind = "word", text } end
function math_.row(...) return { kind = "row", ... } end
function math_.frac(a, b) return { kind = "frac", a, b } end
function math_.pow(a, b) return { kind = "pow", a, b } end
function math_.par(a) return { kind = "par", a } end
function math_.matrix(rows) return { kind = "matrix", rows = rows } end
function math_.integral(low, high) return { kind = "integral", low = low, high = high } end

function math_.sym(base, sub, more)
  return { kind = "sym", base, sub = sub, vector = more and more.vector, dot = more and more.dot or 0 }
end

-- The number that is printed for x with so many digits.
function math_.rounded(x, digits) return tonumber(rounded(x, digits)) end

-- 12345.678 as five digits with a power of ten where it is far from 1; unit: set behind a thin space.
function math_.number(x, digits, unit)
  local s = rounded(x, digits or 5)
  local mantissa, exponent = string.match(s, "^(.-)e([+-]%d+)$")
  local node = math_.num(s)
  if mantissa then
    local power = math_.pow(math_.num "10", math_.num(string.format("%d", tonumber(exponent))))
    node = mantissa == "1" and power or math_.row(math_.num(mantissa), math_.op "times", power)
  end
  if unit and unit ~= "" and unit ~= "1" then return math_.row(node, math_.op "thin", { kind = "unit", unit }) end
  return node
end

local upright = { sin = true, cos = true, sn = true, cn = true, dn = true }
local named = { x = "cross", ["."] = "dot", ["~="] = "approx", ["*"] = "times" }

local signs = {}
for _, list in ipairs { math_.operators, { "(", ")", "|", "/", "'", "" } } do
  for _, sign in ipairs(list) do signs[sign] = true end
end

local function atom(word, names)
  if string.find(word, "^[%d.]+$") and word ~= "." then return math_.num(word) end
  if named[word] then return math_.op(named[word]) end
  local low, high = string.match(word, "^int<(.*);(.*)>$")
  if low then
    local function bound(b) return math_.read((string.gsub(string.gsub(b, "[-/]", " %0 "), "&", " "))) end
    return math_.integral(bound(low), bound(high))
  end
  if word == "int" then return math_.integral() end
  local differential = string.match(word, "^d(%a+)$")
  if differential and (#differential == 1 or math_.greek[differential]) then
    return math_.row(math_.op "thin", math_.word "d", math_.sym(differential))
  end
  local quoted = string.match(word, '^"(.*)"$')
  if quoted then return math_.row(math_.op "quad", math_.word(quoted), math_.op "quad") end
  local base, rest = string.match(word, "^(.-)%^(%w+)$")
  if base then return math_.pow(atom(base, names), atom(rest, names)) end
  if upright[word] then return math_.word(word) end
  local vector, name, sub, dots = string.match(word, "^(~?)(%a+)_?([%w,]*)('*)$")
  if not name then
    if not signs[word] then error("no formula: " .. word, 0) end
    return math_.op(word)
  end
  sub = sub ~= "" and sub or nil
  return math_.sym(names and names(name, sub) or name, sub, { vector = vector ~= "", dot = #dots })
end

-- The content of a root as one word, and back.
local hidden, shown = { [" "] = "\5", ["{"] = "\6", ["|"] = "\7", ["}"] = "\8", ["("] = "\14", [")"] = "\15" }, {}
for c, code in pairs(hidden) do shown[code] = c end -- a map to a map: order is lost anyway
local function hide(s) return (string.gsub(s, "[ {|}()]", hidden)) end
local function show(s) return (string.gsub(s, "[\5-\8\14\15]", shown)) end

-- "~L = I ~omega": ~ a vector, x the cross product, . the inner one, ' a dot above, _ an index, ( ) as they stand,
-- {a|b} a quotient, sqrt[a] a square root, int<a;b> an integral (2&pi: two pi).  names(letter, index) -> the letter
-- that stands for it, where a scene has taken the usual one.
function math_.read(text, names)
  if text == "x" then return math_.sym "x" end -- alone it is no product
  text = string.gsub(text, "sqrt%[([^%[%]]*)%]", function(of) return " \4" .. hide(of) .. "\4 " end)
  text = string.gsub(text, "[()]", " %0 ")
  text = string.gsub(text, "{([^{}|]*)|([^{}]*)}", function(a, b)
    return " \1" .. string.gsub(a, " ", "\3") .. "\2" .. string.gsub(b, " ", "\3") .. "\1 "
  end)
  local out = { kind = "row" }
  for word in string.gmatch(text, "[^ ]+") do
    local a, b = string.match(word, "^\1(.*)\2(.*)\1$")
    local root = string.match(word, "^\4(.*)\4$")
    if root then
      out[#out + 1] = { kind = "sqrt", math_.read(show(root), names) }
    elseif a then
      out[#out + 1] = math_.frac(math_.read((string.gsub(a, "\3", " ")), names),
        math_.read((string.gsub(b, "\3", " ")), names))
    else
      out[#out + 1] = atom(word, names)
    end
  end
  return out
end

-- About how many letters wide a formula is.
function math_.width(n)
  local kind, w = n.kind, 0
  if kind == "num" or kind == "word" or kind == "unit" then return #n[1] end
  if kind == "sym" then
    return (math_.greek[n[1]] and 1.2 or #n[1] * 1.1) + 0.7 * #(n.sub or "")
  end
  if kind == "op" then return (n[1] == "thin" or n[1] == "," or n[1] == "(" or n[1] == ")") and 0.7 or 2 end
  if kind == "integral" then return 3 end
  if kind == "frac" then return math.max(math_.width(n[1]), math_.width(n[2])) + 0.5 end
  if kind == "pow" then return math_.width(n[1]) + 0.7 * math_.width(n[2]) end
  if kind == "call" then w = #n.name + 2 end
  if kind == "par" or kind == "abs" or kind == "sqrt" then w = 1.6 end
  if kind == "matrix" then
    for c = 1, #n.rows[1] do
      local most = 0
      for _, r in ipairs(n.rows) do most = math.max(most, math_.width(r[c])) end
      w = w + most + 2
    end
    return w + 1
  end
  local sum = kind == "sum"
  for _, part in ipairs(n) do w = w + math_.width(sum and part.node or part) + (sum and 2 or 0.3) end
  return w
end

return math_
