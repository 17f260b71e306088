-- page.lua -- the pieces of a hand-out, collected in one format: headings, sentences with formulas, displayed lines.
-- SPDX-License-Identifier: GPL-3.0-or-later

local read = require "generator.formula.read"
local setting = require "generator.formula.setting"
local tree = require "generator.formula.tree"
local symbols = require "generator.report.symbols"
local formula = require "generator.report.handout.formula"

local page = {}
page.__index = page

-- A page of facts (report/facts.lua) in a format: handout/latex.lua or one of its neighbours.
function page.of(format, f)
  local table_of = symbols.of(f)
  return setmetatable({ format = format, symbols = table_of, writer = formula.new(table_of), out = {},
    names = table_of.reader }, page)
end

function page:put(text) self.out[#self.out + 1] = text end

-- A place for what is known at the end only: late(page) -> text.
function page:reserve(late)
  self:put ""
  self.late = { at = #self.out, of = late }
end
function page:heading(text) self:put(self.format.heading(text)) end

-- "words with $~L = I ~omega$ in between" as the format writes it.
function page:inline(text)
  local parts = {}
  for i, part in ipairs(read.prose(text, self.names)) do
    parts[i] = part.node and self.format.inline(part.node) or self.format.words(part.words)
  end
  return table.concat(parts)
end

function page:text(text) self:put(self.format.paragraph { self:inline(text) }) end
function page:words(text) self:put(self.format.paragraph { self.format.words(text) }) end

-- A node as the format writes it within a line.
function page:node(n) return self.format.inline(n) end

function page:list(items)
  local out = {}
  for i, item in ipairs(items) do out[i] = self:inline(item) end
  if #out > 0 then self:put(self.format.list(out)) end
end

-- lines: {left = node | nil, nodes...}, or {left, equals, sum, from, to, nodes...} (formula.lua).
function page:display(lines)
  if #lines == 0 then return end
  local style, out = self.format.style, {}
  for i, l in ipairs(lines) do
    local left = l.left and setting.of(style, l.left) or ""
    local list = {}
    if l.sum then
      if l.equals then list[1] = style.op "=" end
      list[#list + 1] = setting.terms(style, l.sum, l.from, l.to)
    end
    for _, n in ipairs(l) do list[#list + 1] = setting.of(style, n) end
    out[i] = { left, style.row(list) }
  end
  self:put(self.format.display(out))
end

-- "left = right" in the short notation, one line each; beside: as many in a line as fit.
function page:lines(list, beside)
  local lines = {}
  for i, text in ipairs(list) do
    local left, right = read.equation(text, self.names)
    lines[i] = { left = left, right }
  end
  return beside and formula.beside(lines) or lines
end
function page:equations(list, beside) self:display(self:lines(list, beside)) end

-- Adds "left = expression (= number unit)" to lines; what is too long for people is given by its number.
-- words: a node after it, or nil.
function page:line(lines, left, e, number, unit, words)
  local value = number and tree.number(number, 5, unit)
  local exact = number and tree.rounded(number, 5) == number
  local tail = words or value and tree.row(tree.op(exact and "=" or "approx"), value)
  if e and e.kind == "num" and number then tail = nil end
  local rows = e and (e.kind ~= "num" or not number) and self.writer:rows(left, e, tail)
  rows = rows or { { left = left, tree.op((exact or not value) and "=" or "approx"),
    value or tree.word "(too long to print)" } }
  for _, r in ipairs(rows) do lines[#lines + 1] = r end
end

-- The named parts of what was written, which then may have parts of their own, and the constants with all digits.
function page:where()
  local w = self.writer
  self.told, self.told_constants = self.told or 0, self.told_constants or 0
  local lines = {}
  while self.told < #w.parts do
    self.told = self.told + 1
    local e = w.parts[self.told]
    local node = w.named[e]
    w.named[e] = nil
    for _, r in ipairs(w:rows(node, e) or {}) do lines[#lines + 1] = r end
    w.named[e] = node
  end
  for i = self.told_constants + 1, #w.constants do
    local c = w.constants[i]
    lines[#lines + 1] = { left = c.node, tree.op "approx", tree.number(c.number, 17) }
  end
  self.told_constants = #w.constants
  if #lines == 0 then return end
  self:words "where"
  self:display(lines)
end

function page:done()
  if self.late then
    local text = self.late.of(self)
    if text ~= "" then self.out[self.late.at] = text else table.remove(self.out, self.late.at) end
  end
  return table.concat(self.out, "\n") .. "\n"
end

return page
