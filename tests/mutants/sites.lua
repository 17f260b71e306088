-- sites.lua - where a defect can be planted in a text of Lua, C or a template, and what it is.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     sites.find(text, "lua" | "c" | "template")   -> { { kind, line, from, to, new }, ... } in the order of the text
--     sites.kinds                                   the names of the kinds
--
-- A site is the bytes from..to of the text and what replaces them.  Comments, strings, directives of the preprocessor
-- and the names that a template fills in are no sites.  Lines of a template that begin with %% are Lua, others are C.
-- The kinds are slips that people make; each leaves a text that mostly still compiles.

local sites = {}

sites.kinds = { "operator", "constant", "sign", "index", "condition", "line" }

---- what is code: all else is blanked, in place --------------------------------------------------------

local function blank(s) return (s:gsub("[^\n]", " ")) end

-- The text with everything blanked that starts at a `mark` and is no code; `finish(text, at)` is the last byte of it.
local function masked(text, marks)
  local out, at, next_at = {}, 1, {}
  while at <= #text do
    local first, mark
    for _, m in ipairs(marks) do
      if not next_at[m] or next_at[m] < at then next_at[m] = text:find(m.start, at) or math.huge end
      if not first or next_at[m] < first then first, mark = next_at[m], m end
    end
    if first == math.huge then break end
    local last = mark.finish(text, first) or #text
    out[#out + 1] = text:sub(at, first - 1) .. blank(text:sub(first, last))
    at = last + 1
  end
  out[#out + 1] = text:sub(at)
  return table.concat(out)
end

local function line_end(text, from) return (text:find("\n", from, true) or #text + 1) - 1 end

local function quoted(text, from)
  local quote, at = text:sub(from, from), from + 1
  while at <= #text do
    local c = text:sub(at, at)
    if c == "\\" then
      at = at + 1
    elseif c == quote or c == "\n" then
      return at
    end
    at = at + 1
  end
end

local function long(text, from)
  local level = text:match("%[(=*)%[", from)
  return select(2, text:find("]" .. level .. "]", from, true))
end

local LUA = {
  { start = "%-%-", finish = function(text, from)
    return text:find("^%-%-%[=*%[", from) and long(text, from) or line_end(text, from)
  end },
  { start = "[\"']", finish = quoted },
  { start = "%[=*%[", finish = long },
}

-- A directive ends with the line, or with the first that has no \ at its end.
local function directive(text, from)
  local last = line_end(text, from)
  while text:sub(last, last) == "\\" and last < #text do last = line_end(text, last + 2) end
  return last
end

local C = {
  { start = "/%*", finish = function(text, from) return select(2, text:find("*/", from + 2, true)) end },
  { start = "//", finish = line_end },
  { start = "[\"']", finish = quoted },
  { start = "%f[^\n%z]%s*#", finish = directive },
}

-- The lines of one language, the others blanked.
local function only(text, wanted)
  return (text:gsub("[^\n]+", function(line)
    local lua = line:match "^(%%%%).*"
    if wanted == "lua" then return lua and "  " .. line:sub(3) or blank(line) end
    return lua and blank(line) or line
  end))
end

-- What stands before a byte in its line, at most 99 bytes of it.
local function left_of(code, from) return code:sub(math.max(1, from - 99), from - 1):match "[^\n]*$" end

---- the sites of code ------------------------------------------------------------------------------------

local SWAP = { ["+"] = "-", ["-"] = "+", ["*"] = "/", ["/"] = "*", ["<"] = "<=", ["<="] = "<", [">"] = ">=",
  [">="] = ">", ["=="] = "~=", ["~="] = "==", ["!="] = "==", ["and"] = "or", ["or"] = "and", ["&&"] = "||",
  ["||"] = "&&", ["+="] = "-=", ["-="] = "+=" }

-- An operand ends before, and begins after; the same space on both sides tells a product from a pointer's declaration.
local function operators(code, language, add)
  for from, op, to in code:gmatch "()([-+*/<>=~!&|]+)()" do
    local before, after = left_of(code, from), code:sub(to, to + 1)
    local space = before:find " $" ~= nil
    local operand = before:find "[%w_)%]] ?$" and after:find(space and "^ [%w_({-]" or "^[%w_(]")
    local exponent = before:find "%f[%w][%d.]+[eE]$"
    local keyword = before:find "%f[%w_]return $" or before:find "%f[%w_]and $" or before:find "%f[%w_]or $"
      or before:find "%f[%w_]not $"
    local new = SWAP[op]
    if new == "~=" and language == "c" then new = "!=" end
    if new and operand and not exponent and not keyword then
      add(op:find "^[-+]=$" and "sign" or "operator", from, to - 1, new)
    elseif op == "-" and not exponent and code:find("^[%w_(]", to)
      and (keyword or before:find "[=(,{[*/] ?$") then
      add("sign", from, to - 1, "")
    end
  end
  if language == "lua" then
    for from, word, to in code:gmatch "()%f[%w_](%l+)%f[^%w_]()" do
      if word == "and" or word == "or" then add("operator", from, to - 1, SWAP[word]) end
    end
  end
end

local function another(number)
  local digits, suffix = number:match "^(%d+)([uUlLfF]*)$"
  if digits then return math.tointeger(digits) and string.format("%d%s", math.tointeger(digits) + 1, suffix) end
  local mantissa, rest = number:match "^(%d*%.?%d+)(.*)$"
  return tonumber(mantissa) and not number:find "^0[xX]" and string.format("%.17g%s", tonumber(mantissa)*1.125, rest)
end

local function constants(code, _, add)
  for from, number, to in code:gmatch "()%f[%w_.](%d[%w.]*)()" do
    if number:find "[eE]$" and code:find("^[-+]%d", to) then
      local more = code:match("^[-+]%d+", to)
      number, to = number .. more, to + #more
    end
    local new = another(number)
    local index = code:sub(from - 1, from - 1) == "[" and code:sub(to, to) == "]"
    if new and not index then add("constant", from, to - 1, new) end
  end
end

-- real a = 1, b[3]: is what stands left of a bracket the further name of a declaration?
local function declares_more(before)
  if not before:find "^%s*[%a_][%w_]* %*?[%a_][%w_]*.*, %*?[%a_][%w_]*$" then return false end
  local open = 0
  for c in before:gmatch "[%(%){}]" do open = open + ((c == "(" or c == "{") and 1 or -1) end
  return open == 0 and not before:find "^%s*return "
end

-- Not the size of an array that is declared; in Lua, not a key that is no number.
local function indices(code, language, add)
  for from, index, to in code:gmatch "()%[([%w_]+)%]()" do
    local before = left_of(code, from)
    local declared = language == "c" and before:find "[%a_][%w_]* %*?[%w_]+$" and not before:find "return [%w_]+$" or
      declares_more(before)
    local counted = math.tointeger(index) or language == "c" or #index == 1
    if counted and not declared and before:find "[%w_)%]]$" then
      add("index", from, to - 1, function(s)
        return math.tointeger(index) and "[" .. math.tointeger(index) + 1 .. "]" or s:sub(1, -2) .. " + 1]"
      end)
    end
  end
end

local function conditions(code, language, add)
  for start, line in code:gmatch "()([^\n]+)" do
    if language == "lua" then
      for _, pattern in ipairs { "%f[%w_]if (().-()) then%f[^%w_]", "%f[%w_]while (().-()) do%f[^%w_]" } do
        local _, from, to = line:match(pattern)
        if from then add("condition", start + from - 1, start + to - 2, function(s) return "not (" .. s .. ")" end) end
      end
    else
      local from, to = line:match "%f[%w_]if ()%b()()"
      if not from then from, to = line:match "%f[%w_]while ()%b()()" end
      if from then add("condition", start + from - 1, start + to - 2, function(s) return "(!" .. s .. ")" end) end
    end
  end
end

-- Assignments and calls that are a line of their own.
local function lines(code, language, add)
  for start, line in code:gmatch "()([^\n]+)" do
    local first = line:match "^%s+()%S"
    if first and language == "lua" then
      local assigned = line:find "^%s+[%a_][%w_.%[%]]* = " or line:find "^%s+[%a_][%w_.:]*%("
      local whole = not line:find "[-+*/,({=.]%s*$" and not line:find "%f[%w_]function%f[^%w_]"
        and not line:find "%f[%w_]and%s*$" and not line:find "%f[%w_]or%s*$"
      local guard = line:find "^%s+if .* then .* end$"
      if assigned and whole or guard then add("line", start + first - 1, start + #line - 1, "") end
    elseif first and line:find ";%s*$" then
      if line:find "^%s+[%w_.%[%]>*-]+ [-+*/|&]?= " or line:find "^%s+[%a_][%w_]*%(.*%);%s*$" then
        add("line", start + first - 1, start + #line - 1, ";")
      end
    end
  end
end

local FINDERS = { operators, constants, indices, conditions, lines }

local function find(text, code, language, list)
  for _, finder in ipairs(FINDERS) do
    finder(code, language, function(kind, from, to, new)
      if type(new) == "function" then new = new(text:sub(from, to)) end
      list[#list + 1] = { kind = kind, from = from, to = to, new = new }
    end)
  end
end

function sites.find(text, language)
  local list = {}
  if language == "template" then
    find(text, masked(only(text, "lua"), LUA), "lua", list)
    -- what is filled in counts as a name
    local c = only(text, "c"):gsub("%${[^}\n]*}", function(s) return ("x"):rep(#s) end)
    find(text, masked(c, C), "c", list)
  else
    find(text, masked(text, language == "lua" and LUA or C), language, list)
  end
  table.sort(list, function(a, b) return a.from < b.from or a.from == b.from and a.kind < b.kind end)
  local line, at = 1, 1
  for _, s in ipairs(list) do
    line = line + select(2, text:sub(at, s.from - 1):gsub("\n", ""))
    at, s.line = s.from, line
  end
  return list
end

function sites.plant(text, s) return text:sub(1, s.from - 1) .. s.new .. text:sub(s.to + 1) end

return sites
