-- tokens.lua -- what generator/cost/reading.lua reads C with: its tokens, and integers that may be known.
-- SPDX-License-Identifier: GPL-3.0-or-later

local tokens = {}

-- ---- tokens ----

local LONG = {}
for _, s in ipairs { "<<=", ">>=", "->", "++", "--", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "+=", "-=", "*=",
  "/=", "%=", "&=", "|=", "^=" } do
  LONG[s] = true
end

local OPERATOR = {} -- what may be their second character
for _, c in ipairs { string.byte("=><+-&|", 1, -1) } do OPERATOR[c] = true end

-- Names, numbers with their suffixes, strings, operators by their longest match; of a text without comments.
function tokens.of(text)
  local list, n, pos, len = {}, 0, 1, #text
  local find, sub, byte, match = string.find, string.sub, string.byte, string.match
  while true do
    pos = find(text, "%S", pos)
    if not pos then break end
    local c, last, token, _ = byte(text, pos), pos, nil, nil
    if c == 95 or c >= 97 and c <= 122 or c >= 65 and c <= 90 then
      token, last = match(text, "^([%w_]+)()", pos)
      last = last - 1
    elseif c >= 48 and c <= 57 or c == 46 and find(text, "^%.%d", pos) then
      _, last = find(text, "^[%w%.]+", pos)
      if find(text, "^[eEpP][+-]", last) and not find(text, "^0[xX][^pP]*$", pos) then
        _, last = find(text, "^[+-][%w]+", last + 1)
      end
    elseif c == 34 then
      _, last = find(text, "^\"[^\"]*\"", pos)
    else
      if pos < len and OPERATOR[byte(text, pos + 1)] then
        if LONG[sub(text, pos, pos + 2)] then
          last = pos + 2
        elseif LONG[sub(text, pos, pos + 1)] then
          last = pos + 1
        end
      end
    end
    n = n + 1
    list[n] = token or sub(text, pos, last)
    pos = last + 1
  end
  return list
end

-- ---- integers that may be known ----

-- The number that a value is, itself or a function of the integer variables env; nil where the numbers decide it.
local function number_of(v, env)
  if type(v) == "function" then return v(env) end
  return v
end
tokens.number_of = number_of

local function truth(b) return b and 1 or 0 end

-- As C has it: / and % are towards zero.
local arithmetic = {
  ["+"] = function(a, b) return a + b end, ["-"] = function(a, b) return a - b end,
  ["*"] = function(a, b) return a * b end,
  ["/"] = function(a, b) return b ~= 0 and (a // b + truth(a % b ~= 0 and (a < 0) ~= (b < 0))) or nil end,
  ["%"] = function(a, b) return b ~= 0 and math.fmod(a, b) or nil end,
  ["<<"] = function(a, b) return a << b end, [">>"] = function(a, b) return a >> b end,
  ["&"] = function(a, b) return a & b end, ["|"] = function(a, b) return a | b end,
  ["^"] = function(a, b) return a ~ b end,
  ["<"] = function(a, b) return truth(a < b) end, [">"] = function(a, b) return truth(a > b) end,
  ["<="] = function(a, b) return truth(a <= b) end, [">="] = function(a, b) return truth(a >= b) end,
  ["=="] = function(a, b) return truth(a == b) end, ["!="] = function(a, b) return truth(a ~= b) end,
}

-- Of `and` and `or` one side may settle it.
local function logical(op, a, b)
  local settled = op == "&&" and 0 or 1
  local function is(x) return x ~= nil and truth(x ~= 0) or nil end
  a, b = is(a), is(b)
  if a == settled or b == settled then return settled end
  if a == nil or b == nil then return nil end
  return 1 - settled
end

-- The value of a op b: at once if both are numbers, else when the variables are known; nil if either is, but for && and
-- ||, which one side may settle.
function tokens.combine(op, a, b)
  if op == "&&" or op == "||" then
    if type(a) ~= "function" and type(b) ~= "function" then return logical(op, a, b) end
    return function(env) return logical(op, number_of(a, env), number_of(b, env)) end
  end
  if a == nil or b == nil then return nil end
  local f = arithmetic[op]
  if type(a) == "number" and type(b) == "number" then return f(a, b) end
  return function(env)
    local x, y = number_of(a, env), number_of(b, env)
    if x == nil or y == nil then return nil end
    return f(x, y)
  end
end

return tokens
