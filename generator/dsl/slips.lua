-- slips.lua -- what a wrong text was probably meant to be: a pasted character, a lost comma, a comma for a point.
--
--     slips.syntax(d, line, message) -> line, message: of Lua's own message where it does not name the slip
--     slips.number(given, how) -> " (...)" or "": of a text that is no number; how: where a unit goes, of %s and %s
--     slips.name(given) -> " (write omega)" or "": of a name with Greek letters
--     slips.comma(d, line) -> " (...)" or "": that the line has a decimal comma
--     slips.entry(d, line) -> the line with a decimal comma from there on, and the number as it stands; or nil
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local R = require "generator.algebra.rational"
local tokens = later "generator.diag.tokens"
local units = require "generator.dsl.units"

local slips = {}

-- ---- characters that editors and word processors put into a text ----

-- What to write for characters that Lua does not know.
local instead = {
  { "“”„‟″«»", '"' }, { "‘’‚‹›′", "'" }, { "−–—‐‑", "-" }, { "×·⋅∙∗", "*" }, { "÷∕", "/" }, { "²", "^2" },
  { "³", "^3" }, { "≤", "<=" }, { "≥", ">=" }, { "≠", "~=" }, { "，", "," }, { "；", ";" }, { "π", "pi" },
  { "√", "sqrt(..)" }, { "°", 'quantity(30, "deg")' }, { "\u{A0}\u{2009}\u{202F}\u{200B}\u{FEFF}", "a blank" },
}

local greek = {}
do
  local k = 0
  for name in string.gmatch([[alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho
    sigma sigma tau upsilon phi chi psi omega]], "%a+") do
    greek[0x3B1 + k], greek[0x391 + k] = name, string.gsub(name, "^%l", string.upper)
    k = k + 1
  end
  greek[0xB5] = "mu"
end

-- What to write for a character, as the end of a sentence.
local function remedy(character)
  for _, row in ipairs(instead) do
    if string.find(row[1], character, 1, true) then return "write " .. row[2] end
  end
  local name = greek[utf8.codepoint(character)]
  return "names are of the letters a to z, digits and _" .. (name and ": write " .. name or "")
end

local function odd_character(character)
  local known, code = pcall(utf8.codepoint, character)
  if not known then return "the text must be UTF-8" end
  return string.format("Lua has no %s (U+%04X): %s", code == 0xA0 and "such blank" or character, code,
    remedy(character))
end

-- The first character outside of strings and comments that is none of Lua's, and its line; nil if there is none.
local function first_odd(list)
  for i, token in ipairs(list) do
    if #token == 1 and string.byte(token) >= 0x80 then
      local n = i
      while list[n + 1] and list.line[n + 1] == list.line[i] and string.find(list[n + 1], "^[\x80-\xBF]$") do
        n = n + 1
      end
      local text = table.concat(list, "", i, n)
      return string.match(text, "^" .. utf8.charpattern) or token, list.line[i]
    end
  end
  return nil
end

-- The name with its Greek letters spelt out, as " (write omega)"; "" if it has none.
function slips.name(given)
  if type(given) ~= "string" or not utf8.len(given) then return "" end
  local spelt = string.gsub(given, utf8.charpattern, function(c) return greek[utf8.codepoint(c)] end)
  return spelt ~= given and " (write " .. spelt .. ")" or ""
end

-- ---- commas ----

local keywords = {}
for word in string.gmatch([[and break do else elseif end for function goto if in local not or repeat return then until
  while]], "%a+") do
  keywords[word] = true
end

local function is_value(token)
  return token and not keywords[token] and string.find(token, "^[%w_\"'})%]]") ~= nil
end

-- The entry behind which a comma is missing before `word` on a line, and its line; nil if nothing of that kind is.  In
-- 30 deg no comma is.
local function lost_comma(list, line, word)
  local i = list.first[line]
  while i and list.line[i] == line do
    local unit = string.find(list[i - 1] or "", "^%d") and string.find(word, "^%a") and list[i + 1] ~= "="
    if list[i] == word and is_value(list[i - 1]) and is_value(word) and not unit and
      not string.find(word, "^[})%]]") then
      return list[i - 1], list.line[i - 1]
    end
    i = i + 1
  end
  return nil
end

local written = 2 ^ 18 -- bytes; a longer text is made by a program, and has no slips of a hand

function slips.syntax(d, line, message)
  if #d.text > written then return line, message end
  local list = tokens.of(d.text)
  local character, at = first_odd(list)
  if character and at <= line then return at, odd_character(character) end
  local quote = string.find(message, "^unfinished string") and
    string.match(d.lines[line] or "", "\xE2\x80[\x98-\x9F]")
  if quote then return line, odd_character(quote) end
  local word = string.match(message, "^'[})]' expected.* near '(.*)'$")
  local before
  if word then before, at = lost_comma(list, line, word) end
  if before then return at, "a comma is missing between " .. before .. " and " .. word end
  return line, message
end

-- Only a comma with digits at its sides and nothing else, as nobody writes two entries of a list of words.
local pair = "%f[%w.](%d+),(%d+)%f[^%w.]"

local function point(whole, part) return "decimals have a point: " .. whole .. "." .. part .. ", not " .. whole ..
  "," .. part end

function slips.comma(d, line)
  local whole, part = string.match(d.lines[line] or "", pair)
  return whole and " (" .. point(whole, part) .. ")" or ""
end

local page = 40 -- lines of a table that are looked at

function slips.entry(d, line)
  for at = line, math.min(line + page, #d.lines) do
    local whole, part = string.match(d.lines[at], "=%s*%-?" .. pair)
    if whole then return at, point(whole, part) end
  end
  return nil
end

function slips.number(given, how)
  if type(given) ~= "string" or #given > 100 then return "" end -- nobody writes a longer one
  local whole, part = string.match(given, "^%s*(%-?%d*),(%d+)%s*$")
  if whole then return " (decimals have a point: " .. whole .. "." .. part .. ")" end
  local number, unit = string.match(given, "^%s*(%-?[%d.]+[eE]?[+-]?%d*)%s*([%a\xC2\xCE].*)$")
  if number and R.parse(number) and #unit <= 60 and units.parse(unit) then
    return " (" .. string.format(how, number, unit) .. ")"
  end
  return ""
end

return slips
