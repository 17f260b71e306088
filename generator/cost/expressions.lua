-- expressions.lua -- the expressions of emitted C, for generator/cost/reading.lua, whose head says what they become.
-- SPDX-License-Identifier: GPL-3.0-or-later

local tokens = require "generator.cost.tokens"

local combine, number_of = tokens.combine, tokens.number_of

local INT = { int = true, unsigned = true, signed = true, long = true, short = true, char = true, size_t = true,
  int32_t = true, uint32_t = true, int64_t = true, uint64_t = true }
local QUALIFIER = { const = true, static = true, inline = true, struct = true, union = true, volatile = true,
  register = true }
local BINARY = { ["*"] = 10, ["/"] = 10, ["%"] = 10, ["+"] = 9, ["-"] = 9, ["<<"] = 8, [">>"] = 8, ["<"] = 7,
  [">"] = 7, ["<="] = 7, [">="] = 7, ["=="] = 6, ["!="] = 6, ["&"] = 5, ["^"] = 4, ["|"] = 3, ["&&"] = 2, ["||"] = 1 }
local ASSIGN = { ["="] = true, ["+="] = "+", ["-="] = "-", ["*="] = "*", ["/="] = "/", ["%="] = "%", ["|="] = "|",
  ["&="] = "&", ["^="] = "^", ["<<="] = "<<", [">>="] = ">>" }
local CLASS = { ["+"] = "add", ["-"] = "add", ["*"] = "mul", ["/"] = "div" }

-- ---- one function ----

local parser = {}
parser.__index = parser

function parser:fail(what) error("reading " .. self.name .. ": " .. what .. " at " ..
  table.concat(self.tokens, " ", math.max(1, self.at - 8), math.min(#self.tokens, self.at + 8)), 0) end

function parser:take(what)
  if self.tokens[self.at] ~= what then self:fail("expected " .. what) end
  self.at = self.at + 1
end

function parser:accept(what)
  if self.tokens[self.at] ~= what then return false end
  self.at = self.at + 1
  return true
end

-- Counts an operation of a class into the stretch that is being read.
function parser:count(class)
  local item = self.stretch
  if not item then
    item = {}
    self.stretch, self.code[#self.code + 1] = item, item
  end
  item[class] = (item[class] or 0) + 1
end

function parser:put(item)
  self.stretch, self.code[#self.code + 1] = nil, item
end

-- The items that `read` makes, as a list of their own, and what it returns.
function parser:apart(read)
  local code, stretch = self.code, self.stretch
  self.code, self.stretch = {}, nil
  local a, b = read()
  local own = self.code
  self.code, self.stretch = code, stretch
  return own, a, b
end

-- A type's name at the current token; nil if there is none.
function parser:type_name()
  local at, t = self.at, self.tokens
  while QUALIFIER[t[at]] do at = at + 1 end
  local name = t[at]
  self.long = name == "int64_t" or name == "uint64_t"
  if INT[name] then
    while INT[t[at]] or QUALIFIER[t[at]] do at = at + 1 end
    self.at = at
    return "int"
  end
  local found = self.unit.types[name]
  if not found then return nil end
  self.at = at + 1
  while QUALIFIER[t[self.at]] do self.at = self.at + 1 end
  return found
end

-- Kinds of values: "real", "lit" (a constant), "int", a structure's name; with a star for each pointer or array.  What
-- reads an expression returns its kind, its value if it is an integer (reading.lua), and the name if it is no more than
-- an integer variable, which may be assigned to.
local function join(a, b)
  if a == "real" or b == "real" then return "real" end
  return (a == "lit" or b == "lit") and "lit" or "int"
end

local function pointer(kind) return string.sub(kind, -1) == "*" end
local function element(kind) return pointer(kind) and string.sub(kind, 1, -2) or kind end

-- Counts one operation.  A constant becomes a real number at no cost; steps of a pointer are free.
function parser:binary(op, ta, a, tb, b)
  if op == "&&" or op == "||" then return "int", combine(op, a, b) end
  if pointer(ta) or pointer(tb) then return CLASS[op] and (pointer(ta) and ta or tb) or "int" end
  local both = join(ta, tb)
  if both == "int" then
    if self.wide then self:count "long" end
    return "int", combine(op, a, b)
  end
  if CLASS[op] then
    if both == "real" then self:count(CLASS[op]) end
    return both
  end
  if both == "real" then self:count "cmp" end
  return "int"
end

-- What follows a primary expression: [..], .field, ->field, ++, --.
function parser:postfix(kind, value, name)
  local t = self.tokens
  local far = false
  while true do
    local s = t[self.at]
    if s == "[" then
      self.at = self.at + 1
      self:expression()
      self:take "]"
      kind, value, name, far = element(kind), nil, nil, true
    elseif s == "." or s == "->" then
      local fields = self.unit.fields[string.match(kind, "^[^*]*")]
      kind = fields and fields[t[self.at + 1]] or self:fail("no field " .. tostring(t[self.at + 1]) .. " in " .. kind)
      value, name, far = nil, nil, far or s == "->"
      self.at = self.at + 2
    elseif s == "++" or s == "--" then
      self.at = self.at + 1
      if name then self:put { kind = "set", name = name, value = combine(s == "++" and "+" or "-", value, 1) } end
    else
      if far and kind == "real" then self:count "mem" end
      return kind, value, name
    end
  end
end

-- fabs and copysign are free, and so is a function of constants.
function parser:call(name)
  local args, kinds = {}, {}
  self:take "("
  while not self:accept ")" do
    local n = #kinds + 1
    kinds[n], args[n] = self:expression(2)
    self:accept ","
  end
  local known = self.unit.functions[name]
  if known then
    self.results = self.results + 1
    local slot = -self.results -- its value, should it be an integer that is known
    self:put { kind = "call", name = name, args = args, slot = slot }
    return known.result, known.result == "int" and function(env) return env[slot] end or nil
  end
  local plain = self.unit.library[name] or self:fail("unknown function " .. name)
  if plain ~= "fabs" and plain ~= "copysign" then
    local real = false
    for _, k in ipairs(kinds) do real = real or k == "real" end
    if real then self:count(plain) end
  end
  return "real"
end

-- Of a cast only the step between integer and real counts, and not that of a constant to real.
function parser:primary()
  local t = self.tokens
  local s = t[self.at]
  if s == "(" then
    self.at = self.at + 1
    local to = self:type_name()
    if not to then
      local kind, value, name = self:expression()
      self:take ")"
      return self:postfix(kind, value, name)
    end
    local depth, star = 1, t[self.at] ~= ")" -- a cast, with its stars and brackets
    while depth > 0 do
      depth = depth + (t[self.at] == "(" and 1 or t[self.at] == ")" and -1 or 0)
      self.at = self.at + 1
    end
    local first = self.at
    local kind, value = self:unary()
    if star or to == "void" then return kind end
    if (to == "real") ~= (kind == "real") and not (to == "real" and (kind == "lit" or type(value) == "number")) then
      local class = "conv"
      for i = first, self.at - 1 do class = self.longs[t[i]] and "conv64" or class end
      self:count(class)
    end
    return to, to == "int" and kind == "int" and value or nil
  end
  self.at = self.at + 1
  if s == "sizeof" then
    self:take "("
    self:expression()
    self:take ")"
    return "int"
  end
  local c = string.byte(s)
  if c >= 48 and c <= 57 or c == 46 then
    if string.find(s, "^0[xX]") or not string.find(s, "[%.eEfF]") then
      return "int", math.tointeger(tonumber((string.match(s, "^[%xxX]+"))))
    end
    return "lit"
  end
  if c == 34 then return "int" end
  if t[self.at] == "(" then return self:postfix(self:call(s)) end
  local kind = self.locals[s]
  if kind then
    local value
    if kind == "int" then value = function(env) return env[s] end end
    return self:postfix(kind, value, kind == "int" and s or nil)
  end
  local fixed = self.unit.constants[s]
  if fixed then return "int", fixed end
  kind = self.unit.globals[s] or self:fail("unknown name " .. s)
  return self:postfix(kind)
end

function parser:unary()
  local s = self.tokens[self.at]
  if s == "-" or s == "+" then
    self.at = self.at + 1
    local kind, value = self:unary()
    return kind, kind == "int" and s == "-" and combine("-", 0, value) or value
  elseif s == "!" then
    self.at = self.at + 1
    local kind, value = self:unary()
    if kind == "real" then self:count "cmp" end
    return "int", combine("==", value, 0)
  elseif s == "&" or s == "*" or s == "~" then
    self.at = self.at + 1
    local kind, _, name = self:unary()
    if s == "&" and name then self:put { kind = "set", name = name } end -- someone may write to it
    if s == "*" and kind == "real*" then self:count "mem" end
    return s == "&" and kind .. "*" or s == "*" and element(kind) or kind
  elseif s == "++" or s == "--" then
    self.at = self.at + 1
    local kind, value, name = self:unary()
    value = combine(s == "++" and "+" or "-", value, 1)
    if name then self:put { kind = "set", name = name, value = value } end
    return kind, value
  end
  return self:primary()
end

-- Binary operators that bind no weaker than `least`, by precedence climbing: what is to the right binds stronger, so
-- equal ones group from the left.
function parser:operators(least)
  local kind, value, name = self:unary()
  while true do
    local op = self.tokens[self.at]
    local power = BINARY[op]
    if not power or power < least then return kind, value, name end
    self.at, name = self.at + 1, nil
    if op == "&&" or op == "||" then
      -- the right side may be skipped
      local side, k, v = self:apart(function() return self:operators(power + 1) end)
      if #side > 0 then
        local yes, no = side, {}
        if op == "||" then yes, no = no, yes end
        self:put { kind = "if", cond = value, yes = yes, no = no }
      end
      kind, value = self:binary(op, kind, value, k, v)
    else
      local k, v = self:operators(power + 1)
      kind, value = self:binary(op, kind, value, k, v)
    end
  end
end

-- With ?:, assignment and, unless a level is given (an argument, an initializer, a side of ?:), commas.
function parser:expression(level)
  local kind, value, name = self:operators(1)
  local s = self.tokens[self.at]
  if s == "?" then
    self.at = self.at + 1
    local yes, ka, a = self:apart(function() return self:expression(2) end)
    self:take ":"
    local no, kb, b = self:apart(function() return self:expression(2) end)
    if #yes > 0 or #no > 0 then self:put { kind = "if", cond = value, yes = yes, no = no } end
    local cond = value
    if self.unit.fields[ka] or pointer(ka) then return ka end
    kind, value = join(ka, kb), nil
    if kind == "int" and cond ~= nil then
      value = function(env)
        local c = number_of(cond, env)
        if c == nil then return nil end
        return number_of(c ~= 0 and a or b, env)
      end
    end
  elseif ASSIGN[s] then
    self.at = self.at + 1
    local k, v = self:expression(2)
    if s ~= "=" then
      kind, v = self:binary(ASSIGN[s], kind, value, k, v)
    elseif kind == "int" and k == "real" then
      self:count "conv"
    end
    value = kind == "int" and v or nil
    if name then self:put { kind = "set", name = name, value = value } end
  end
  if not level and self.tokens[self.at] == "," then
    self.at = self.at + 1
    return self:expression()
  end
  return kind, value, s ~= "?" and name or nil
end

parser.INT, parser.QUALIFIER = INT, QUALIFIER

return parser
