-- page.lua -- the pieces of a hand-out, collected in one format: headings, sentences with formulas, displayed lines.
-- SPDX-License-Identifier: GPL-3.0-or-later

local math_ = require "generator.report.handout.math"
local setting = require "generator.report.handout.setting"
local formula = require "generator.report.handout.formula"

local page = {}
page.__index = page

-- format: handout/latex.lua or one of its neighbours; symbols: handout/symbols.lua.
function page.new(format, symbols, title)
  local self = setmetatable({ format = format, symbols = symbols, writer = formula.new(symbols), out = {} }, page)
  self.names = symbols:reader()
  self.out[1] = format.title(title)
  return self
end

function page:put(text) self.out[#self.out + 1] = text end
function page:heading(text) self:put(self.format.heading(text)) end

-- "words with $~L = I ~omega$ in between" as the format writes it.
function page:inline(text)
  local parts = {}
  for words, notation in string.gmatch(text .. "$$", "([^$]*)%$([^$]*)%$") do
    parts[#parts + 1] = self.format.words(words)
    if notation ~= "" then parts[#parts + 1] = self.format.inline(math_.read(notation, self.names)) end
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

-- "left = right" in the short notation, one line each.
function page:equations(list)
  local lines = {}
  for i, text in ipairs(list) do
    local left, right = string.match(text, "^(.-) = (.*)$")
    lines[i] = { left = math_.read(left, self.names), math_.op "=", math_.read(right, self.names) }
  end
  self:display(lines)
end

-- Adds "left = expression (= number unit)" to lines; what is too long for people is given by its number.
function page:line(lines, left, e, number, unit)
  local value = number and math_.number(number, 5, unit)
  local exact = number and math_.rounded(number, 5) == number
  local tail = value and math_.row(math_.op(exact and "=" or "approx"), value)
  if e and e.kind == "num" and number then tail = nil end
  local rows = e and (e.kind ~= "num" or not number) and self.writer:rows(left, e, tail)
  rows = rows or { { left = left, math_.op((exact or not value) and "=" or "approx"),
    value or math_.word "(too long to print)" } }
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
    lines[#lines + 1] = { left = c.node, math_.op "approx", math_.number(c.number, 17) }
  end
  self.told_constants = #w.constants
  if #lines == 0 then return end
  self:words "where"
  self:display(lines)
end

function page:done() return table.concat(self.out, "\n") .. "\n" .. self.format.tail end

return page
