-- symbols.lua -- every symbol of one document, with its meaning: those of the scene, and those of the theory.
--
--     local s = symbols.new(names, {mass = the name of the parameter that is the whole mass, or nil})
--     s:of(name) -> node              a quantity of the scene or of its code: a parameter, a state, an entry
--     s:own(base, sub, more) -> node  a symbol of the theory (theory.lua), as this document writes it
--     s.reader                        the same for read.of
--     s:fresh(base) -> node           base_1, base_2, ...: parts and constants that are named here
--     s:said() -> list of {node, usual, meaning}      what could not have its usual letter
--
-- Parameters and inputs come first: they keep the names that the scene gives them.  A symbol of the theory stands for
-- a family, such as the components of a vector.  It takes its usual letter if no member of the family is something
-- else here, else the first of its other letters of which this holds, else its usual letter with a word as an index,
-- and then with a number after the word: there is always one.
-- SPDX-License-Identifier: GPL-3.0-or-later

local theory = require "generator.formula.theory"
local tree = require "generator.formula.tree"

local symbols = {}
symbols.__index = symbols

local function key(base, sub) return base .. "_" .. (sub or "") end

function symbols:take(name, base, sub)
  if self.used[key(base, sub)] then return nil end
  self.used[key(base, sub)] = name
  self.of_name[name] = tree.sym(base, sub)
  return self.of_name[name]
end

-- The symbol of a name; the same whenever it is asked.
function symbols:of(name)
  if self.of_name[name] then return self.of_name[name] end
  local known = theory.names[name]
  if known then
    self.of_name[name] = self:own(known[1], known[2])
    return self.of_name[name]
  end
  local base, sub = tree.split((string.gsub(name, "_+$", ""))) -- slide_: a state of the code that keeps off a parameter
  local node
  local n, whole = 1, sub
  repeat -- not a letter of the theory either: the code's Omega is none of its rates
    node = not theory.has(base, whole) and self:take(name, base, whole)
    n = n + 1
    whole = (sub and sub .. "," or "") .. string.format("%d", n)
  until node
  return node
end

function symbols:fresh(base)
  local n = 0
  repeat
    n = n + 1
    local sub = string.format("%d", n)
  until not self.used[key(base, sub)] and not theory.has(base, sub)
  self.used[key(base, string.format("%d", n))] = base
  return tree.sym(base, string.format("%d", n))
end

local function bare(sub) return sub ~= "" and sub ~= "~" and sub or nil end
local function joined(a, b) return a and b and a .. "," .. b or a or b end

-- Is the letter with this word before each index free for the family?  Else: what takes it.
function symbols:free(family, base, word)
  for _, sub in ipairs(family.subs) do
    local whole = joined(word, bare(sub))
    local by = self.used[key(base, whole)]
    -- families of one letter keep off each other; a vector and its size share theirs
    if by and (type(by) == "string" or by.base ~= family.base) then return false, type(by) == "string" and by or nil end
    local other = (base ~= family.base or word) and (theory.has(base, whole) or theory.has(base, whole, true))
    if other and other ~= family then return false, other.base end
  end
  return true
end

function symbols:choose(family)
  local usual, by = self:free(family, family.base)
  local letter = usual and { base = family.base }
  for _, other in ipairs(letter and {} or family.others) do
    if not letter and self:free(family, other) then letter = { base = other } end
  end
  local n = 0
  while not letter do
    n = n + 1
    local word = family.word .. (n > 1 and string.format("%d", n) or "")
    if self:free(family, family.base, word) then letter = { base = family.base, word = word } end
  end
  for _, sub in ipairs(family.subs) do
    local k = key(letter.base, joined(letter.word, bare(sub)))
    self.used[k] = self.used[k] or family
  end
  if not usual then
    self.changed[#self.changed + 1] = { node = tree.sym(letter.base, letter.word), usual = family.base,
      name = by, meaning = family.meaning }
  end
  self.letter[family] = letter
  return letter
end

function symbols:letters(base, sub, vector)
  if base == "pi" then return base, sub end
  local family = theory.has(base, sub, vector)
  if not family then error("the theory has no symbol " .. key(base, sub), 0) end
  if family == theory.mass and self.mass then return self.mass[1], self.mass.sub end
  local letter = self.letter[family] or self:choose(family)
  return letter.base, joined(letter.word, sub)
end

function symbols:own(base, sub, more)
  base, sub = self:letters(base, sub, more and more.vector)
  return tree.sym(base, sub, more)
end

function symbols:said() return self.changed end

function symbols.new(names, o)
  local self = setmetatable({ used = {}, of_name = {}, letter = {}, changed = {} }, symbols)
  for _, name in ipairs(names) do
    local base, sub = tree.split((string.gsub(name, "_+$", "")))
    local n, whole = 1, sub
    while not self:take(name, base, whole) do
      n = n + 1
      whole = (sub and sub .. "," or "") .. string.format("%d", n)
    end
  end
  self.mass = o and o.mass and self.of_name[o.mass]
  self.reader = function(base, sub, vector) return self:letters(base, sub, vector) end
  return self
end

return symbols
