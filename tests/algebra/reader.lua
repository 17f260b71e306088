-- reader.lua - reads a formula back from its text: what the program prints for people becomes a number again.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     reader.value("M (b² + c²)/12", env)             by doubles
--     reader.value("M*(b^2 + c^2)/12", env, reader.exact(300))      by rationals and MPFR to 300 bits
--     reader.value(text, env, arithmetic, "latex")     or "mathml"
-- It knows nothing of the printer.  Precedence is that of any algebra system: ^ from the right and before a sign, a
-- sign before * and /, these from the left, then + and -.  What stands side by side is multiplied, as tightly as by
-- *: "M a b/4" is (M a b)/4.  A minus stands before a product only where a sum may begin, or after ^.
-- LaTeX and MathML are rewritten as words of that language first; what is not known is an error.

local R = require "polhode_rational"

local reader = {}

local FUNCTIONS = {}
for name in string.gmatch("sin cos tan asin acos atan atan2 exp log sinh cosh tanh abs sign sqrt clamp " ..
  "ellipsoid_area ellipsoid_normal arc_across arc_along arc_lever catenary_rise catenary_width catenary_height",
  "%g+") do
  FUNCTIONS[name] = true
end

-- ---- arithmetic ----

reader.doubles = {
  number = tonumber,
  power = function(x, n) return n == 0.5 and math.sqrt(x) or x ^ n end,
  call = function(fn, x, y, z)
    if fn == "clamp" then return math.max(y, math.min(z, x)) end
    if fn == "sign" then return x < 0 and -1 or 1 end
    if math[fn] and not y then return math[fn](x) end
    return R.todouble(R.apply(fn, 80, R.fromdouble(x), y and R.fromdouble(y)))
  end,
  pi = math.pi,
}

function reader.exact(bits)
  return {
    number = R.parse,
    power = function(x, n)
      if R.isint(n) then return x ^ R.toint(n) end
      return R.apply("pow", bits, x, n)
    end,
    call = function(fn, x, y)
      if fn == "abs" then return R.abs(x) end
      if fn == "sqrt" and R.sign(x) == 0 then return x end
      if y then return R.apply(fn, bits, x, y) end
      return R.apply(fn, bits, x)
    end,
    pi = R.apply("pi", bits),
  }
end

-- ---- words: {kind, text}, kind one of "number", "name", "sign" ----

local RAISED = { ["⁰"] = "0", ["¹"] = "1", ["²"] = "2", ["³"] = "3", ["⁴"] = "4", ["⁵"] = "5", ["⁶"] = "6",
  ["⁷"] = "7", ["⁸"] = "8", ["⁹"] = "9", ["⁻"] = "-" }

local WORDS = { ["√"] = "sqrt", ["π"] = "pi" }

local tokens = {}

function tokens.text(s)
  local list, at = {}, 1
  local function put(kind, text) list[#list + 1] = { kind, text } end
  while at <= #s do
    local c = string.match(s, utf8.charpattern, at)
    local number = string.match(s, "^%d+%.?%d*e[+-]?%d+", at) or string.match(s, "^%d+%.?%d*", at)
    local name = string.match(s, "^[%a_][%w_]*", at)
    if number or name then
      put(number and "number" or "name", number or name)
      at = at + #(number or name)
    elseif RAISED[c] then
      put("sign", "^")
      local digits = ""
      while RAISED[c] do
        digits, at = digits .. RAISED[c], at + #c
        c = string.match(s, utf8.charpattern, at)
      end
      if string.sub(digits, 1, 1) == "-" then put("sign", "-") end
      put("number", (string.gsub(digits, "^%-", "")))
    else
      if WORDS[c] then put("name", WORDS[c]) elseif c ~= " " then put("sign", c) end
      at = at + #c
    end
  end
  return list
end

-- LaTeX as text of the language above: groups are rewritten from the inside out.
local function rewritten(s, rules)
  local before
  repeat
    before = s
    for _, rule in ipairs(rules) do s = string.gsub(s, rule[1], rule[2]) end
  until s == before
  return s
end

local LATEX = {
  { "\\left|", " abs( " }, { "\\right|", " ) " }, { "\\left%(", " ( " }, { "\\right%)", " ) " },
  { "\\cdot%s*10%^{(%-?%d+)}", " * 10^(%1) " }, { "\\times%s*10%^{(%-?%d+)}", " * 10^(%1) " },
  { "\\arc(%a+)", " a%1 " }, { "\\operatorname{([%w\\_]+)}", " %1 " }, { "\\math%a+{([%w\\_]+)}", "%1" },
  { "\\frac{([^{}]*)}{([^{}]*)}", " ((%1)/(%2)) " }, { "\\sqrt{([^{}]*)}", " sqrt(%1) " },
  { "%^{([^{}]*)}", "^(%1) " }, { "([%w])_{([%w,\\_]+)}", "%1_%2 " }, { "\\_", "_" }, { "(%w),(%d)", "%1_%2" },
}

function tokens.latex(s)
  s = rewritten(s, LATEX)
  s = string.gsub(string.gsub(s, "\\cdot%f[%A]", " · "), "\\times%f[%A]", " × ")
  s = string.gsub(s, "\\(%a[%w_]*)", " %1 ")
  if string.find(s, "[{}\\&]") then error("no formula in LaTeX: " .. s, 0) end
  return tokens.text(s)
end

-- Letters and signs of MathML that are written otherwise in text.
local LETTERS = { ["\u{2062}"] = "*", ["\u{2061}"] = "", ["−"] = "-", ["ω"] = "omega",
  ["α"] = "alpha", ["β"] = "beta", ["γ"] = "gamma", ["θ"] = "theta", ["φ"] = "phi",
  ["ρ"] = "rho", ["λ"] = "lambda", ["μ"] = "mu" }

-- The children of an element from `at` on as texts, and where its end is.
local function elements(s, at)
  local list = {}
  while true do
    local tag, empty, inside = string.match(s, "^<(%a+)[^<>]-(/?)>()", at)
    if not tag then return list, at end
    local inner, past
    if empty == "/" then
      inner, past = {}, inside
    else
      local ending
      inner, ending = elements(s, inside)
      past = assert(string.match(s, "^[^<]*</" .. tag .. ">()", ending), "no end of <" .. tag .. "> in " .. s)
      if #inner == 0 then inner = { string.match(s, "^[^<]*", inside) } end
    end
    local first, second = table.unpack(inner)
    if tag == "mfrac" then
      first = "((" .. first .. ")/(" .. second .. "))"
    elseif tag == "msup" then
      first = (string.find(first, "^ %l+ $") and first or "(" .. first .. ")") .. "^(" .. second .. ")"
    elseif tag == "msub" then
      first = " " .. string.gsub(first .. "_" .. second, " ", "") .. " "
    elseif tag == "msqrt" then
      first = "sqrt(" .. table.concat(inner) .. ")"
    elseif first == "|" then
      first = list.open and " ) " or " abs( "
      list.open = not list.open
    elseif tag == "mi" or tag == "mn" or tag == "mo" then
      first = " " .. (LETTERS[first] or first) .. " "
    elseif tag == "mrow" or tag == "mspace" then
      first = table.concat(inner)
    else
      error("no formula in MathML: <" .. tag .. ">", 0)
    end
    list[#list + 1], at = first, past
  end
end

function tokens.mathml(s)
  local list, at = elements(s, 1)
  if at <= #s then error("no formula in MathML: " .. s, 0) end
  return tokens.text(table.concat(list))
end

-- ---- the parser ----

local function parse(list, env, A, source)
  local at = 1
  local sum
  local function fail(why) error(why .. " at word " .. at .. " of " .. source, 0) end
  local function sign(s) return list[at] and list[at][1] == "sign" and list[at][2] == s end
  local function take(s)
    if not sign(s) then return false end
    at = at + 1
    return true
  end
  local function close() if not take ")" then fail "no )" end end
  local power
  local function atom()
    if take "(" then
      local v = sum()
      close()
      return v
    end
    local word = list[at] or fail "nothing"
    if word[1] == "sign" then fail("'" .. word[2] .. "'") end
    at = at + 1
    if word[1] == "number" then return A.number(word[2]) end
    local name = word[2]
    if env[name] ~= nil then return env[name] end
    if name == "pi" then return A.pi end
    if not FUNCTIONS[name] then fail("no value of " .. name) end
    local raised -- sin^2 (x)
    if sign "^" and list[at + 1] and list[at + 1][2] == "(" then
      at = at + 2
      raised = sum()
      close()
    end
    if name == "sqrt" and not sign "(" then return A.call("sqrt", atom()) end -- √3 r
    if not take "(" then fail("no argument of " .. name) end
    local args = { sum() }
    while take "," do args[#args + 1] = sum() end
    close()
    local v = A.call(name, table.unpack(args))
    return raised and A.power(v, raised) or v
  end
  function power()
    local base = atom()
    if not take "^" then return base end
    local minus = take "-"
    local exponent = power()
    return A.power(base, minus and -exponent or exponent)
  end
  local function product()
    local v = power()
    while list[at] do
      if take "*" then
        v = v * power()
      elseif take "/" then
        v = v / power()
      elseif list[at][1] ~= "sign" or sign "(" then
        v = v * power()
      else
        break
      end
    end
    return v
  end
  local function term() -- products of vectors bind less than those of numbers: a b × c is (a b) × c
    local v = product()
    while true do
      if take "·" then
        v = A.dot(v, product())
      elseif take "×" then
        v = A.cross(v, product())
      else
        return v
      end
    end
  end
  function sum()
    local v = take "-" and -term() or term()
    while true do
      if take "+" then
        v = v + term()
      elseif take "-" then
        v = v - term()
      else
        return v
      end
    end
  end
  local v = sum()
  if list[at] then fail "more" end
  return v
end

function reader.value(s, env, arithmetic, style)
  return parse(tokens[style or "text"](s), env, arithmetic or reader.doubles, s)
end

return reader
