-- nearest.lua -- the words of a list that a mistyped one was probably meant to be.
--
--     nearest.one(word, list)        the best of the list, or nil
--     nearest.of(word, list, most)   the good ones, best first, at most `most` (3 without it)
--     nearest.slips(word, entry)     how many slips apart, nil if that is too many
-- A slip is a letter too many, one missing, another one, or two neighbours exchanged (optimal string alignment;
-- Damerau, CACM 7 (1964) 171); other capitals count half a slip.  At most one slip is allowed for every three
-- letters of the longer of the two; of two letters the second may be another.  Of equals the first in the list.  A
-- leaf: words in, words out.
-- SPDX-License-Identifier: GPL-3.0-or-later

local nearest = {}

local longest = 64 -- letters: nobody mistypes more, and the work grows with the product of the lengths

-- The fewest slips between two strings, row by row of the table of prefixes.
local function apart(a, b)
  local before, last = nil, {}
  for j = 0, #b do last[j] = j end
  for i = 1, #a do
    local row = { [0] = i }
    for j = 1, #b do
      local same = string.byte(a, i) == string.byte(b, j)
      local best = math.min(last[j] + 1, row[j - 1] + 1, last[j - 1] + (same and 0 or 1))
      if i > 1 and j > 1 and string.byte(a, i) == string.byte(b, j - 1) and
        string.byte(a, i - 1) == string.byte(b, j) then
        best = math.min(best, before[j - 2] + 1)
      end
      row[j] = best
    end
    before, last = last, row
  end
  return last[#b]
end

function nearest.slips(word, entry)
  local allowed = math.max(#word, #entry) // 3
  local short = #word == 2 and #entry == 2 and string.byte(word) == string.byte(entry) -- Cd and Cw
  if #word > longest or #entry > longest or math.abs(#word - #entry) > allowed then return nil end
  local a, b = string.lower(word), string.lower(entry)
  if a == b then return word == entry and 0 or 0.5 end
  local n = apart(a, b)
  return (n <= allowed or short) and n or nil
end

function nearest.of(word, list, most)
  local found, seen = {}, {}
  for i, entry in ipairs(list) do
    local n = not seen[entry] and nearest.slips(word, entry)
    seen[entry] = true
    if n then found[#found + 1] = { entry, n, i } end
  end
  table.sort(found, function(x, y)
    if x[2] ~= y[2] then return x[2] < y[2] end
    return x[3] < y[3]
  end)
  local out = {}
  for i = 1, math.min(#found, most or 3) do -- not what takes twice as many slips as the best
    if found[i][2] < 2 * found[1][2] or found[i][2] == found[1][2] then out[i] = found[i][1] end
  end
  return out
end

function nearest.one(word, list) return nearest.of(word, list, 1)[1] end

return nearest
