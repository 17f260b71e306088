-- formula.lua -- expressions as formulas: what is too wide gets named parts, what has too many digits named constants.
--
--     local w = formula.new(symbols)
--     w:of(e) -> node                            w:rows(left, e) -> lines that fit, named parts after them
-- A coefficient of at most 12 digits is exact, a longer one a constant c_n with 17 digits: `w.constants`.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local signed = require "generator.algebra.signed"
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

-- (sign base)^n, n > 0, as a factor
function formula:power(base, n, sign)
  if n == R.half then return { kind = "sqrt", self:of(base) } end
  local b = self:of(base, sign)
  if n == R.one then return base.kind == "add" and not self.named[base] and math_.par(b) or b end
  if b.kind ~= "sym" and base.fn ~= "pi" then b = math_.par(b) end
  return math_.pow(b, R.isint(n) and math_.num(tostring(n)) or math_.row(math_.num(tostring(R.num(n))), math_.op "/",
    math_.num(tostring(R.den(n)))))
end

-- A product of algebra/signed.lua without the minus before it; a sum that stands alone needs no parentheses.
function formula:product(p)
  local c, top, bottom = p.c, {}, {}
  local long = digits(c) > longest or R.den(c) ~= R.one and #tostring(R.num(c)) + #tostring(R.den(c)) > 5
  if long then
    top[1] = self:rational(c)
  else
    if R.num(c) ~= R.one then top[1] = math_.num(tostring(R.num(c))) end
    if R.den(c) ~= R.one then bottom[1] = math_.num(tostring(R.den(c))) end
  end
  for _, f in ipairs(p.above) do top[#top + 1] = self:power(f.base, f.exp, f.sign) end
  for _, f in ipairs(p.below) do bottom[#bottom + 1] = self:power(f.base, f.exp, f.sign) end
  if #top == 0 then top[1] = math_.num "1" end
  local function joined(list)
    if #list > 1 then return { kind = "row", table.unpack(list) } end
    local alone = list[1].kind == "par" and (#bottom > 0 or not p.minus)
    return alone and list[1][1] or list[1]
  end
  if #bottom == 0 then return joined(top) end
  return math_.frac(joined(top), joined(bottom))
end

-- The node of sign e; sign: 1 if left out.
function formula:of(e, sign)
  sign = sign or 1
  if self.named[e] then return self.named[e] end
  if e.kind == "sym" then return self.symbols:of(e.name) end
  if e.kind == "call" then
    if e.fn == "pi" then return math_.sym "pi" end
    if e.fn == "opaque" then return math_.par(self:of(e[1])) end
    local n = { kind = e.fn == "abs" and "abs" or "call", name = text.called(e.fn) }
    for i = 1, #e do n[i] = self:of(e[i]) end
    return n
  end
  local function named(u) return self.named[u] end
  if e.kind == "add" then
    local sum = { kind = "sum" }
    for i, p in ipairs(signed.terms(e, sign, named)) do sum[i] = { minus = p.minus, node = self:product(p) } end
    return sum
  end
  local p = signed.product(e, sign, named)
  local node = self:product(p)
  return p.minus and { kind = "sum", { minus = true, node = node } } or node
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
