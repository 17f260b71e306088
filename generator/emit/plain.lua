-- plain.lua -- long texts by plain search.  A pattern is tried at every letter; what is rare is found ten times as fast
-- by string.find without one, and then looked at.
-- BELOW the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local byte, find, match, sub = string.byte, string.find, string.match, string.sub

local plain = {}

local IN_WORD = {}
for c = 0, 255 do IN_WORD[c] = find(string.char(c), "[%w_]") ~= nil end

function plain.has(text, word) return find(text, word, 1, true) ~= nil end

-- Does the text have the word, not as a part of another one?  Of a call, `name(`, what follows does not matter.
function plain.word(text, word)
  local at, last = find(text, word, 1, true)
  while at do
    local before, behind = byte(text, at - 1), byte(text, last + 1)
    if (at == 1 or not IN_WORD[before]) and (not IN_WORD[behind] or not IN_WORD[byte(text, last)]) then return true end
    at, last = find(text, word, at + 1, true)
  end
  return false
end

-- The lines of a text; what follows the last newline is one too, unless it is empty.
function plain.lines(text)
  local out, n, from = {}, 0, 1
  local at = find(text, "\n", 1, true)
  while at do
    n = n + 1
    out[n] = sub(text, from, at - 1)
    from = at + 1
    at = find(text, "\n", from, true)
  end
  if from <= #text then out[n + 1] = sub(text, from) end
  return out
end

-- C with `instead` in the place of each comment; one that does not end stays.
function plain.uncommented(text, instead)
  local open = find(text, "/*", 1, true)
  if not open then return text end
  local out, n, from = {}, 0, 1
  while open do
    local _, close = find(text, "*/", open + 2, true)
    if not close then break end
    n = n + 1
    out[n] = sub(text, from, open - 1)
    from = close + 1
    open = find(text, "/*", from, true)
  end
  out[n + 1] = sub(text, from)
  return table.concat(out, instead)
end

-- The text with the names of the map, all of which begin with the prefix, replaced.
function plain.renamed(text, prefix, map)
  local out, n, from = {}, 0, 1
  local at = find(text, prefix, 1, true)
  while at do
    local last = at + #prefix - 1
    if at == 1 or not find(text, "^[%w_]", at - 1) then
      last = at + #match(text, "^[%w_]+", at) - 1
      local own = map[sub(text, at, last)]
      if own then
        out[n + 1], out[n + 2] = sub(text, from, at - 1), own
        n, from = n + 2, last + 1
      end
    end
    at = find(text, prefix, last + 1, true)
  end
  out[n + 1] = sub(text, from)
  return table.concat(out)
end

-- The name that ends before position `at`, blanks between; nil if there is none.  Read backwards, from its end.
function plain.name_before(text, at)
  local back = match(string.reverse(sub(text, 1, at - 1)), "^%s*([%w_]+)")
  return back and string.reverse(back)
end

return plain
