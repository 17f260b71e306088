-- unitnames.lua -- which unit was meant by a word that is none: "meter", "kilograms", "Nm", "KG".
--
-- The symbols are those of units.lua; here are the words of English for them, the prefixes as words, and the
-- products that are often written without a blank.
-- SPDX-License-Identifier: GPL-3.0-or-later

local unitnames = {}

-- Words of which a plural may end in s.
local words = {
  meter = "m", metre = "m", micron = "um", angstrom = "angstrom", inch = "in", inche = "in", foot = "ft", feet = "ft",
  gram = "g", gramme = "g", tonne = "t", ton = "t", amu = "u", dalton = "u", pound = "lb", lbm = "lb", lbs = "lb",
  ounce = "oz", second = "s", sec = "s", minute = "min", mins = "min", hour = "h", hr = "h", d = "day",
  ampere = "A", amp = "A", a = "A", kelvin = "K", k = "K", radian = "rad", degree = "deg", revolution = "rev",
  turn = "rev", rps = "rev/s", hertz = "Hz", newton = "N", joule = "J", watt = "W", pascal = "Pa", tesla = "T",
}
local prefixes = { kilo = "k", centi = "c", milli = "m", micro = "u", nano = "n", pico = "p" }

-- A word without capitals: its symbol, or nil.
local function symbol(word, known)
  local s = words[word]
  for long, short in pairs(s and {} or prefixes) do
    local rest = string.match(word, "^" .. long .. "(.*)$")
    if rest and words[rest] and known[short .. words[rest]] then s = short .. words[rest] end
  end
  return s
end

-- Signs that mean one thing only.
local signs = { { "·", " " }, { "⋅", " " }, { "×", " " }, { "−", "-" }, { "µ", "u" }, { "μ", "u" }, { "°", "deg" },
  { "Å", "angstrom" } }
local raised = { { "⁻", "-" }, { "⁰", "0" }, { "¹", "1" }, { "²", "2" }, { "³", "3" }, { "⁴", "4" }, { "⁵", "5" },
  { "⁶", "6" }, { "⁷", "7" }, { "⁸", "8" }, { "⁹", "9" } }

-- "kg m²" as "kg m^2", "N·m" as "N m", "s⁻²" as "s^-2", "µm" as "um".
function unitnames.plain(s)
  if not string.find(s, "[\128-\255]") then return s end
  for _, pair in ipairs(raised) do s = string.gsub(s, pair[1], "\1" .. pair[2]) end -- \1: what follows is raised
  s = string.gsub(string.gsub(s, "([-%d])\1", "%1"), "\1", "^")
  for _, pair in ipairs(signs) do s = string.gsub(s, pair[1], pair[2]) end
  return s
end

-- N m, kg m, lbf ft: written without the blank between them.
local first = { "kg", "lbf", "lb", "slug", "mN", "kN", "uN", "N", "J", "W", "A", "T" }

-- What `head` and the letters behind it may be, as one text: "Nms" is N m s, or N ms.
local function apart(head, tail, known)
  local list = {}
  for n = 1, #tail - 1 do
    local a, b = string.sub(tail, 1, n), string.sub(tail, n + 1)
    if known[a] and known[b] and a ~= b then list[#list + 1] = head .. " " .. a .. " " .. b end
  end
  if known[tail] then list[#list + 1] = head .. " " .. tail end
  return list[1] and table.concat(list, "\" or \"")
end

-- What should be written instead of `word`, or nil.  known: the symbols as keys.
function unitnames.meant(word, known)
  if string.find(word, "^%-%d+$") then return "^" .. word end -- m-1
  local lower = string.lower(word)
  local s = symbol(lower, known) or symbol(string.match(lower, "^(.+)s$") or "", known)
  if s and s ~= word then return s end
  for _, head in ipairs(first) do
    local tail = string.sub(word, #head + 1)
    local split = string.sub(word, 1, #head) == head and apart(head, tail, known)
    if split then return split end
  end
  local found = {} -- other capitals: only if there is one such unit
  for k in pairs(known) do
    if string.lower(k) == lower then found[#found + 1] = k end
  end
  if #found == 1 then return found[1] end
  local singular = string.match(word, "^(.+)s$")
  return singular and known[singular] and singular or nil
end

return unitnames
