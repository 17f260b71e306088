-- formula.lua -- expressions as lines of a page: what is too wide gets named parts, what has too many digits constants.
--
--     local w = formula.new(symbols)
--     w:of(e) -> node                            w:rows(left, e) -> lines that fit, named parts after them
-- A coefficient of at most 12 digits is exact, a longer one a constant c_n with 17 digits: `w.constants`.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local expression = require "generator.formula.expression"
local tree = require "generator.formula.tree"

local formula = {}
formula.__index = formula

formula.widest = 66 -- letters of a line
local longest = 12 -- digits of an exact fraction

local function digits(q) return #string.gsub(tostring(R.num(q)), "%D", "") + (R.den(q) == R.one and 0 or
  #tostring(R.den(q))) end

function formula.new(symbols)
  local self = setmetatable({ symbols = symbols, constants = {}, parts = {}, named = {} }, formula)
  self.options = { named = self.named, names = function(name) return symbols:of(name) end,
    rational = function(q) return self:rational(q) end }
  return self
end

-- A positive rational of many digits: a finite decimal, a quotient, or a named constant; nil for one of few.
function formula:rational(q)
  local short = R.den(q) == R.one or #tostring(R.num(q)) + #tostring(R.den(q)) <= 5
  if digits(q) <= longest and short then return nil end
  local x = R.todouble(q)
  if R.lift(tree.rounded(x, 12)) == q then return tree.number(x, 12) end
  if digits(q) <= longest then return tree.exact(q) end
  for _, c in ipairs(self.constants) do
    if c.value == q then return c.node end
  end
  local node = self.symbols:fresh "c"
  self.constants[#self.constants + 1] = { node = node, value = q, number = x }
  return node
end

function formula:of(e) return expression.tree(e, self.options) end

-- The widest sum inside e that may have a name of its own: not e itself, and not wider than a line.
local function part(self, e, seen, best)
  if seen[e] or self.named[e] then return best end
  seen[e] = true
  for _, c in ipairs(expr.children(e)) do
    if not self.named[c] and c.kind ~= "num" and c.kind ~= "sym" then
      best = part(self, c, seen, best)
      local w = c.kind == "add" and tree.width(self:of(c)) or 0
      if w > 14 and w > best.width then best = { e = c, width = w } end
    end
  end
  return best
end

local most = 4000 -- nodes that are written out

function formula.fits(e) return expression.size(e, most) <= most end

-- Lines {left, nodes...}: left = e, broken at its signs where it is too wide; parts that get names of their own are in
-- `parts`, to be printed after it.  nil where e is too long for people.
function formula:rows(left, e, tail)
  if not formula.fits(e) then return nil end
  local room = formula.widest - tree.width(left) - (tail and tree.width(tail) or 0)
  local node = self:of(e)
  local function widest()
    if node.kind ~= "sum" then return tree.width(node) end
    local w = 0
    for _, t in ipairs(node) do w = math.max(w, tree.width(t.node)) end
    return w
  end
  while widest() > room do
    local best = part(self, e, {}, { width = 0 })
    if best.width == 0 then break end
    self.parts[#self.parts + 1] = best.e
    local name = self.symbols:fresh "s"
    self.named[best.e] = name
    node = self:of(e)
  end
  return formula.broken(left, node, tail, room)
end

-- The lines of a node that is a sum, filled up to the width.
function formula.broken(left, node, tail, room)
  local lines = {}
  if node.kind ~= "sum" or tree.width(node) <= room then
    return { { left = left, tree.op "=", node, tail } }
  end
  local from, w = 1, 0
  for i, t in ipairs(node) do
    local own = tree.width(t.node) + 2
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

-- ---- several equations in one line ----

function formula.width(l) return (l.left and tree.width(l.left) or 0) + tree.width(tree.row(table.unpack(l))) end

local function joined(lines, from, to)
  local out = { left = lines[from].left, table.unpack(lines[from]) }
  for i = from + 1, to do
    for _, n in ipairs { tree.op ",", tree.op "quad", lines[i].left, table.unpack(lines[i]) } do out[#out + 1] = n end
  end
  return out
end

local between = 3 -- letters

-- Each line is filled as far as it goes.
local function filled(lines)
  local out, from, w = {}, 1, 0
  for i, l in ipairs(lines) do
    local own = formula.width(l) + between
    if i > from and w + own - between > formula.widest then
      out[#out + 1] = joined(lines, from, i - 1)
      from, w = i, 0
    end
    w = w + own
  end
  out[#out + 1] = joined(lines, from, #lines)
  return out
end

-- Lines of a display beside each other, if they fit as many in each line; three are one line or three, unless they may
-- be two and one: uneven.
function formula.beside(lines, uneven)
  local widest = 0
  for _, l in ipairs(lines) do
    if l.sum or not l.left then return lines end
    widest = math.max(widest, formula.width(l))
  end
  local total = -between
  for _, l in ipairs(lines) do total = total + formula.width(l) + between end
  local many = total <= formula.widest and #lines or (formula.widest + between) // (widest + between)
  if #lines == 0 or #lines == 3 and many < 3 and not uneven then return lines end
  if many < 2 then return filled(lines) end
  local rows = math.ceil(#lines / many)
  local out, each = {}, math.ceil(#lines / rows) -- all rows alike
  for from = 1, #lines, each do out[#out + 1] = joined(lines, from, math.min(from + each - 1, #lines)) end
  return out
end

-- The same for lines whose left sides follow each other with one letter: L_x, L_y, L_z.
function formula.grouped(lines)
  local out, group = {}, {}
  local function flush()
    for _, l in ipairs(formula.beside(group)) do out[#out + 1] = l end
    group = {}
  end
  local function letter(l) return l.left and l.left.kind == "sym" and l.left[1] .. l.left.dot end
  for _, l in ipairs(lines) do
    -- a line without a left side goes on with the one before
    if #group > 0 and l.left and letter(l) ~= letter(group[1]) then flush() end
    group[#group + 1] = l
  end
  flush()
  return out
end

return formula
