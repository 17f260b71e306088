-- formula.lua -- expressions as formulas: what is too wide gets named parts, what has too many digits named constants.
--
--     local w = formula.new(symbols)
--     w:of(e) -> node                            w:rows(left, e) -> lines that fit, named parts after them
-- A coefficient of at most 12 digits is exact, a longer one a constant c_n with 17 digits: `w.constants`.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local text = require "generator.algebra.text"
local math_ = require "generator.report.handout.math"

local formula = {}
formula.__index = formula

formula.widest = 66 -- letters of a line
local longest = 12 -- digits of an exact fraction

function formula.new(symbols)
  return setmetatable({ symbols = symbols, constants = {}, parts = {}, named = {} }, formula)
end

local function digits(q) return #string.gsub(tostring(R.num(q)), "%D", "") + (R.den(q) == R.one and 0 or
  #tostring(R.den(q))) end

-- A positive rational: exact, a finite decimal, or a named constant.
function formula:rational(q)
  local top, bottom = tostring(R.num(q)), tostring(R.den(q))
  if digits(q) <= longest then
    if bottom == "1" then return math_.num(top) end
    if #top + #bottom <= 5 then return math_.frac(math_.num(top), math_.num(bottom)) end
  end
  local x = R.todouble(q)
  if R.lift(math_.rounded(x, 12)) == q then return math_.number(x, 12) end
  if digits(q) <= longest then return math_.frac(math_.num(top), math_.num(bottom)) end
  local name = "c_" .. #self.constants + 1
  for _, c in ipairs(self.constants) do
    if c.value == q then return c.node end
  end
  local node = self.symbols:of(name)
  self.constants[#self.constants + 1] = { node = node, value = q, number = x }
  return node
end

function formula:wrapped(node, e) return e.kind == "add" and not self.named[e] and math_.par(node) or node end

function formula:power(base, n)
  if n == R.half then return { kind = "sqrt", self:of(base) } end
  local b = self:of(base)
  if n == R.one then return self:wrapped(b, base) end
  if b.kind ~= "sym" and base.fn ~= "pi" then b = math_.par(b) end
  return math_.pow(b, R.isint(n) and math_.num(tostring(n)) or math_.row(math_.num(tostring(R.num(n))), math_.op "/",
    math_.num(tostring(R.den(n)))))
end

-- c times factors: a node, and whether a minus stands before it.
function formula:product(e)
  local c, rest = expr.split(e)
  local minus = R.sign(c) < 0
  c = R.abs(c)
  local factors = rest == expr.one and {} or self.named[rest] and { rest } or rest.kind == "mul" and rest or { rest }
  local flip = minus and self:flipped(factors)
  if flip then minus = false end
  local top, bottom = {}, {}
  local long = digits(c) > longest or R.den(c) ~= R.one and #tostring(R.num(c)) + #tostring(R.den(c)) > 5
  if long then
    top[1] = self:rational(c)
  else
    if R.num(c) ~= R.one then top[1] = math_.num(tostring(R.num(c))) end
    if R.den(c) ~= R.one then bottom[1] = math_.num(tostring(R.den(c))) end
  end
  for i = 1, #factors do
    local f = factors[i]
    if not self.named[f] and f.kind == "pow" and R.sign(f.exp) < 0 then
      bottom[#bottom + 1] = self:power(f.base, -f.exp)
    elseif not self.named[f] and f.kind == "pow" then
      top[#top + 1] = self:power(f.base, f.exp)
    else
      local node = flip == i and self:sum(f, true) or self:of(f)
      top[#top + 1] = (f.kind == "add" and not self.named[f]) and math_.par(node) or node
    end
  end
  if #top == 0 then top[1] = math_.num "1" end
  local function joined(list)
    if #list == 1 then return list[1].kind == "par" and #bottom > 0 and list[1][1] or list[1] end
    return { kind = "row", table.unpack(list) }
  end
  if #bottom == 0 then
    if #top == 1 then return flip and top[1].kind == "par" and top[1][1] or top[1], minus end
    return { kind = "row", table.unpack(top) }, minus
  end
  return math_.frac(joined(top), joined(bottom)), minus
end

-- The first sum among the factors whose terms have both signs: it takes a minus sign in.
function formula:flipped(factors)
  for i = 1, #factors do
    local f = factors[i]
    if f.kind == "add" and not self.named[f] then
      for j = 1, #f do
        if R.sign((expr.split(f[j]))) < 0 then return i end
      end
    end
  end
  return nil
end

-- A sum, with all signs changed or not; a positive term comes first.
function formula:sum(e, flip)
  local terms = {}
  for i = 1, #e do
    local node, minus = self:product(e[i])
    terms[i] = { node = node, minus = minus ~= (flip or false) }
  end
  for i, t in ipairs(terms) do
    if not t.minus then
      table.insert(terms, 1, table.remove(terms, i))
      break
    end
  end
  return { kind = "sum", table.unpack(terms) }
end

-- The node of an expression.
function formula:of(e)
  if self.named[e] then return self.named[e] end
  if e.kind == "sym" then return self.symbols:of(e.name) end
  if e.kind == "call" then
    if e.fn == "pi" then return math_.sym "pi" end
    local n = { kind = e.fn == "abs" and "abs" or "call", name = text.called(e.fn) }
    for i = 1, #e do n[i] = self:of(e[i]) end
    return n
  end
  if e.kind == "add" then return self:sum(e) end
  local node, minus = self:product(e)
  return minus and { kind = "sum", { minus = true, node = node } } or node
end

-- The widest sum inside e that may have a name of its own: not e itself, and not wider than a line.
local function part(self, e, seen, best)
  if seen[e] or self.named[e] then return best end
  seen[e] = true
  for _, c in ipairs(expr.children(e)) do
    if not self.named[c] and c.kind ~= "num" and c.kind ~= "sym" then
      best = part(self, c, seen, best)
      local w = c.kind == "add" and math_.width(self:of(c)) or 0
      if w > 14 and w > best.width then best = { e = c, width = w } end
    end
  end
  return best
end

local most = 4000 -- nodes that are written out

function formula.fits(e)
  local count = 0
  local function size(u)
    count = count + 1
    if count > most then return end
    for _, c in ipairs(expr.children(u)) do size(c) end
  end
  size(e)
  return count <= most
end

-- Lines {left, nodes...}: left = e, broken at its signs where it is too wide; parts that get names of their own are in
-- `parts`, to be printed after it.  nil where e is too long for people.
function formula:rows(left, e, tail)
  if not formula.fits(e) then return nil end
  local room = formula.widest - math_.width(left) - (tail and math_.width(tail) or 0)
  local node = self:of(e)
  local function widest()
    if node.kind ~= "sum" then return math_.width(node) end
    local w = 0
    for _, t in ipairs(node) do w = math.max(w, math_.width(t.node)) end
    return w
  end
  while widest() > room do
    local best = part(self, e, {}, { width = 0 })
    if best.width == 0 then break end
    self.parts[#self.parts + 1] = best.e
    local name = self.symbols:of("s_" .. #self.parts)
    node = nil
    self.named[best.e] = name
    node = self:of(e)
  end
  return formula.broken(left, node, tail, room)
end

-- The lines of a node that is a sum, filled up to the width.
function formula.broken(left, node, tail, room)
  local lines = {}
  if node.kind ~= "sum" or math_.width(node) <= room then
    return { { left = left, math_.op "=", node, tail } }
  end
  local from, w = 1, 0
  for i, t in ipairs(node) do
    local own = math_.width(t.node) + 2
    if i > from and w + own > room then
      lines[#lines + 1] = { sum = node, from = from, to = i - 1 }
      from, w = i, 0
    end
    w = w + own
  end
  lines[#lines + 1] = { sum = node, from = from, to = #node, tail }
  lines[1].left, lines[1].equals = left, true
  return lines
end

return formula
