-- reading.lua -- emitted C as programs of a small machine that counts operations and knows integers.
--
-- The templates' C is a small language: functions at column 0, `for` and `while`, `if`, no goto, no macros with
-- arguments.  Each function becomes a list of items:
--     {add =, mul =, ...}                      operations on the real type, of a stretch without branches
--     {kind = "call", name, args}              another emitted function, args values (below)
--     {kind = "if", cond, yes, no}             cond a value, yes and no lists
--     {kind = "loop", cond, before, body, step, after}  before: what the condition costs; after: it comes last
--     {kind = "set", name, value}              an integer variable;  {kind = "return" | "break" | "continue"}
-- A value is an integer that is known (a number), one that is computed (function of the integer variables), or nil:
-- it depends on the numbers.  Operations on two constants are free, as compilers fold them; negation and fabs are a
-- sign bit.  Besides add, mul, div, sqrt and names of the C library there are cmp: comparisons; conv: conversions to or
-- from an integer, conv64 one of 64 bits; long: operations on integers in a function that has some of 64 bits;
-- mem: numbers read from or written to arrays and structures behind a pointer.
-- SPDX-License-Identifier: GPL-3.0-or-later

local parser = require "generator.cost.expressions"
local tokens = require "generator.cost.tokens"

local reading = { integer = parser.INT }

local QUALIFIER = parser.QUALIFIER

-- { a, b, { c } }: counted unless the variable is static
function parser:braces()
  self:take "{"
  while not self:accept "}" do
    if self.tokens[self.at] == "{" then self:braces() else self:expression(2) end
    self:accept ","
  end
end

-- Declarators after a type: name, *name, name[n] = ...; the values of integers
function parser:declarators(kind, fixed)
  local t, long = self.tokens, self.long
  repeat
    local stars = ""
    while t[self.at] == "*" or QUALIFIER[t[self.at]] do
      stars = stars .. (t[self.at] == "*" and "*" or "")
      self.at = self.at + 1
    end
    local name = t[self.at]
    self.at = self.at + 1
    while self:accept "[" do
      stars = stars .. "*"
      if t[self.at] ~= "]" then self:apart(function() self:expression() end) end
      self:take "]"
    end
    local value
    self.locals[name], self.longs[name] = kind .. stars, long
    if self:accept "=" then
      local function read()
        if t[self.at] == "{" then return self:braces() end
        local k, v = self:expression(2)
        if kind == "int" and k == "real" then self:count "conv" end
        value = v
      end
      if fixed then self:apart(read) else read() end
    end
    if kind == "int" and stars == "" then self:put { kind = "set", name = name, value = value } end
  until not self:accept ","
  self:take ";"
end

-- `struct {..}` or `union {..}` without a name: its type; nil if there is none here.
function parser:anonymous()
  local t, at = self.tokens, self.at
  while QUALIFIER[t[at]] do at = at + 1 end
  if t[at] ~= "{" or at == self.at then return nil end
  local fields, kind = {}, self.name .. at
  self.at = at + 1
  while not self:accept "}" do
    local own = self:type_name() or self:fail "a field without a type"
    while not self:accept ";" do
      local s = t[self.at]
      if string.find(s, "^[%a_]") then fields[s] = own .. (t[self.at + 1] == "[" and "*" or "") end
      self.at = self.at + 1
    end
  end
  self.unit.fields[kind] = fields
  return kind
end

-- Is there a declaration?  If not, no token is taken: a type's name may also begin a cast.
function parser:declaration()
  local at = self.at
  local fixed = self.tokens[at] == "static"
  local kind = self:anonymous() or self:type_name()
  if kind and self.tokens[self.at] ~= "(" then
    self:declarators(kind, fixed)
    return true
  end
  self.at = at
  return false
end

function parser:statement()
  local s = self.tokens[self.at]
  if self:accept ";" then return end
  if s == "{" then return self:block() end
  if s == "if" then
    self.at = self.at + 1
    self:take "("
    local _, cond = self:expression()
    self:take ")"
    local yes, no = self:apart(function() self:statement() end), {}
    if self:accept "else" then no = self:apart(function() self:statement() end) end
    return self:put { kind = "if", cond = cond, yes = yes, no = no, rare = yes.hint == "rare" }
  elseif s == "for" or s == "while" then
    self.at = self.at + 1
    self:take "("
    if s == "for" and not self:accept ";" and not self:declaration() then
      self:expression()
      self:take ";"
    end
    local cond, _ = 1, nil
    local before = self:apart(function()
      if self.tokens[self.at] ~= ";" then _, cond = self:expression() end
    end)
    local step = {}
    if s == "for" then
      self:take ";"
      if self.tokens[self.at] ~= ")" then step = self:apart(function() self:expression() end) end
    end
    self:take ")"
    local body = self:apart(function() self:statement() end)
    return self:put { kind = "loop", cond = cond, before = before, body = body, step = step,
      turns = body.hint }
  elseif s == "do" then
    self.at = self.at + 1
    local body, cond, _ = self:apart(function() self:statement() end), nil, nil
    self:take "while"
    local before = self:apart(function() _, cond = self:expression() end)
    self:take ";"
    return self:put { kind = "loop", cond = cond, before = before, body = body, step = {}, turns = body.hint,
      after = true }
  elseif s == "return" then
    self.at = self.at + 1
    local value, _
    if self.tokens[self.at] ~= ";" then _, value = self:expression() end
    self:take ";"
    return self:put { kind = "return", value = value }
  elseif s == "break" or s == "continue" then
    self.at = self.at + 2
    return self:put { kind = s }
  end
  if self:declaration() then return end
  self:expression()
  self:take ";"
end

-- After the brace there may be `@ 8` or `@ rare`, which tally.lua makes of comments: the block's hint.
function parser:block()
  self:take "{"
  if self:accept "@" then
    local hint = self.tokens[self.at]
    self.at = self.at + 1
    self.code.hint = math.tointeger(tonumber(hint)) or hint
  end
  while not self:accept "}" do self:statement() end
end

-- The items of a function; unit: {types, fields, functions, library, constants, globals}, parameters: their text.
function reading.body(unit, name, parameters, text)
  local p = setmetatable({ unit = unit, name = name, locals = {}, longs = {}, at = 1, code = {}, results = 0,
    wide = string.find(text, "int64_t", 1, true) }, parser)
  local order = {}
  p.tokens = tokens.of(parameters)
  for piece in string.gmatch(string.gsub(string.sub(parameters, 2, -2), "%b[]", "*"), "[^,]+") do
    p.tokens, p.at = tokens.of(string.gsub(piece, "[*()]", " ")), 1
    local kind = p:type_name()
    local own = p.tokens[p.at]
    if own then
      p.longs[own] = p.long
      p.locals[own] = kind .. string.gsub(piece, "[^*]", "")
      order[#order + 1] = own
    end
  end
  p.tokens, p.at, p.code, p.stretch = tokens.of(text), 1, {}, nil
  p:block()
  return { code = p.code, parameters = order, kinds = p.locals }
end

return reading
