-- read.lua -- a short notation for formulas that are the same for every body, read into trees (tree.lua).
--
--     read.of("T = {1|2} ~omega . I ~omega") -> node         read.equation(text) -> left, relation, right
--     read.prose("words with $~L = I ~omega$ in them") -> list of {words =} and {node =}
--
--     a b          a product            a + b  a - b           ( )  parts as usual
--     ~a           a vector             a x b  a . b           the vector and the inner product; x alone is a letter
--     a_12         with an index        a'  a''                one dot and two
--     {a|b}  a/b   quotients, with a bar and in the line      a^2  a^{1/2}  a power
--     |a|          the size             sqrt(a) sin(a) cn(a)   functions; sin^2(a) is a power of one
--     a(0)         the value there: no blank before the parenthesis
--     int<0;2 pi>  an integral, int alone over the body; dm dxi differentials
--     = < > ~=     relations            , "words"              between formulas of one line
-- names(base, sub, vector) -> base, sub: how the document at hand writes that symbol (symbols.lua).
-- SPDX-License-Identifier: GPL-3.0-or-later

local tree = require "generator.formula.tree"

local read = {}

-- sn, cn, dn, K: of Jacobi.  mean: over a period.
read.functions = {}
for name in string.gmatch("sin cos tan asin acos atan atan2 exp log cosh sinh tanh sn cn dn K mean sign", "%g+") do
  read.functions[name] = true
end

local relations = { ["="] = "=", ["<"] = "<", [">"] = ">", ["~="] = "approx", [","] = ",", ["->"] = "to" }

local function tokens(text)
  local list, at = {}, 1
  local function take(pattern, kind)
    local from, to, a = string.find(text, "^" .. pattern, at)
    if not from then return false end
    list[#list + 1] = { kind = kind, text = a or string.sub(text, from, to), tight = from > 1 and
      not string.find(text, "^%s", from - 1) }
    at = to + 1
    return true
  end
  while at <= #text do
    if not (take('"([^"]*)"', "words") or take("int<([^>]*)>", "integral") or take("~=", "op") or take("%->", "op") or
      take("~?%a+_?[%w,]*'*", "name") or take("%d+%.?%d*", "num") or take("[-+()%[%]{}|/^,=<>.]", "op")) then
      local skip = string.match(text, "^%s+", at)
      if not skip then error("no formula: " .. text, 0) end
      at = at + #skip
    end
  end
  return list
end

local parser = {}
parser.__index = parser

function parser:peek(text)
  local t = self.list[self.at]
  return t and t.kind == "op" and t.text == text
end
function parser:next()
  self.at = self.at + 1
  return self.list[self.at - 1]
end
function parser:fail() error("no formula: " .. self.text, 0) end
function parser:expect(text)
  if not self:peek(text) then self:fail() end
  self.at = self.at + 1
end

function parser:symbol(word)
  local vector, base, sub, dots = string.match(word, "^(~?)(%a+)_?([%w,]*)('*)$")
  vector, sub = vector ~= "", sub ~= "" and sub or nil
  if self.names then base, sub = self.names(base, sub, vector) end
  return tree.sym(base, sub, { vector = vector or nil, dot = #dots })
end

-- The content of brackets up to the sign that closes them.
function parser:enclosed(close, barred)
  self.at = self.at + 1
  local n = self:inside(barred or false)
  self:expect(close)
  return n
end

-- A function of its arguments, the first name being read; sin^2(a) is a power.
function parser:call(name)
  local power = nil
  if self:peek "^" then
    self.at = self.at + 1
    power = tree.num(self:next().text)
  end
  self:expect "("
  local n = tree.call(name, self:inside(false))
  while self:peek "," do
    self.at = self.at + 1
    n[#n + 1] = self:inside(false)
  end
  self:expect ")"
  if name == "sqrt" then n = tree.sqrt(n[1]) end
  return power and tree.pow(n, power) or n
end

-- A name: a differential, a function, a symbol, or a symbol at an argument.
function parser:named(word)
  self.at = self.at + 1
  local differential = not read.functions[word] and string.match(word, "^d(%a+)$")
  if word == "int" then return { kind = "integral" } end
  if differential and (#differential == 1 or tree.greek[differential]) then
    return { kind = "diff", self:symbol(differential) }
  end
  local opens = self:peek "(" and self.list[self.at].tight
  if word == "sqrt" or read.functions[word] and (opens or self:peek "^") then return self:call(word) end
  local s = self:symbol(word)
  return opens and { kind = "at", s, self:enclosed ")" } or s
end

-- What may stand in a product without its power; nil where none begins.
function parser:atom()
  local t = self.list[self.at]
  if not t then return nil end
  if t.kind == "num" then
    self.at = self.at + 1
    return tree.num(t.text)
  elseif t.kind == "integral" then
    self.at = self.at + 1
    local low, high = string.match(t.text, "^(.*);(.*)$")
    return { kind = "integral", low = read.of(low, self.names), high = read.of(high, self.names) }
  elseif t.kind == "name" then
    return self:named(t.text)
  elseif t.text == "(" then
    return self:enclosed ")"
  elseif t.text == "{" then
    local above = self:enclosed("|", true)
    local below = self:inside(false)
    self:expect "}"
    return tree.frac(above, below)
  elseif t.text == "|" then
    return { kind = "abs", self:enclosed("|", true) }
  end
  return nil
end

-- A sum in brackets; barred: does the next bar after an operand end it?
function parser:inside(barred)
  local before = self.barred
  self.barred = barred
  local n = self:sum()
  self.barred = before
  return n
end

function parser:factor()
  local n = self:atom()
  if n and self:peek "^" then
    self.at = self.at + 1
    if self:peek "{" then
      self.at = self.at + 1
      local a = self:next().text
      self:expect "/"
      n = tree.pow(n, { kind = "ratio", tree.num(a), tree.num(self:next().text) })
      self:expect "}"
    else
      local t = self:next()
      n = tree.pow(n, t.kind == "num" and tree.num(t.text) or tree.sym(t.text)) -- T: the transposed matrix
    end
  end
  return n
end

-- Is the x that stands here a vector product: does an operand follow?
function parser:crosses()
  local t, following = self.list[self.at], self.list[self.at + 1]
  if not (t and t.kind == "name" and t.text == "x" and following) then return false end
  return following.kind ~= "op" or following.text == "(" or following.text == "{"
end

function parser:product()
  local list = {}
  while true do
    if #list > 0 and self:crosses() then break end
    if #list > 0 and self.barred and self:peek "|" then break end
    local n = self:factor()
    if not n then break end
    if self:peek "/" then
      self.at = self.at + 1
      n = { kind = "ratio", n, self:factor() or self:fail() }
    end
    list[#list + 1] = n
  end
  if #list == 0 then self:fail() end
  return tree.product(list)
end

function parser:term()
  local n = self:product()
  while true do
    if self:crosses() then
      self.at = self.at + 1
      n = { kind = "cross", n, self:product() }
    elseif self:peek "." then
      self.at = self.at + 1
      n = { kind = "dot", n, self:product() }
    else
      return n
    end
  end
end

function parser:sum()
  local list = {}
  repeat
    local minus = self:peek "-"
    if minus or self:peek "+" then self.at = self.at + 1 end
    list[#list + 1] = { minus = minus or false, node = self:term() }
  until not (self:peek "+" or self:peek "-")
  if #list == 1 and not list[1].minus then return list[1].node end
  return { kind = "sum", table.unpack(list) }
end

-- A formula, or several of one line with relations between them (a row).
function read.of(text, names)
  local self = setmetatable({ text = text, list = tokens(text), at = 1, names = names }, parser)
  local row = {}
  while self.list[self.at] do
    local t = self.list[self.at]
    if t.kind == "words" then
      self.at = self.at + 1
      for _, n in ipairs { tree.op "quad", tree.word(t.text), tree.op "quad" } do row[#row + 1] = n end
    elseif t.kind == "op" and relations[t.text] then
      self.at = self.at + 1
      row[#row + 1] = tree.op(relations[t.text])
    else
      row[#row + 1] = self:sum()
    end
  end
  if #row == 0 then self:fail() end
  return #row == 1 and row[1] or tree.row(table.unpack(row))
end

-- "left = right": the left side, and the row of all that follows it.
function read.equation(text, names)
  local n = read.of(text, names)
  if n.kind ~= "row" or n[2].kind ~= "op" then return nil, n end
  return n[1], tree.row(table.unpack(n, 2))
end

function read.prose(text, names)
  local list = {}
  for words, notation in string.gmatch(text .. "$$", "([^$]*)%$([^$]*)%$") do
    if words ~= "" then list[#list + 1] = { words = words } end
    if notation ~= "" then list[#list + 1] = { node = read.of(notation, names) } end
  end
  return list
end

return read
