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

-- N m, kg m, lbf ft: written without the blank between them.
local first = { "kg", "lbf", "lb", "slug", "N", "J", "W", "A", "T" }

-- What should be written instead of `word`, or nil.  known: the symbols as keys.
function unitnames.meant(word, known)
  local lower = string.lower(word)
  local s = symbol(lower, known) or symbol(string.match(lower, "^(.+)s$") or "", known)
  if s and s ~= word then return s end
  for _, head in ipairs(first) do
    local tail = string.sub(word, #head + 1)
    if string.sub(word, 1, #head) == head and known[tail] then return head .. " " .. tail end
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
