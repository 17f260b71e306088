-- hunt.lua - `make hunt`: searches every target for its worst states, keeps them, and writes docs/hunt.md.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/hunt/hunt.lua POLHODE DIRECTORY COUNT SEED "TARGETS"
--
-- COUNT states for a target of share 1.  The same seed and count find the same states.  TARGETS: names, or nothing for
-- all; "page" alone writes the page from what is kept.

package.path = "./?.lua;" .. package.path

local targets = require "tests.hunt.targets"
local records = require "tests.hunt.records"
local page = require "tests.hunt.page"

local WORST, HISTORY, PAGE = "tests/hunt/worst.tsv", "tests/hunt/history.tsv", "docs/hunt.md"
local polhode, directory, count, seed, names = table.unpack(arg)
count, seed = tonumber(count), math.tointeger(tonumber(seed))
if not (count and count >= 1 and seed) then
  io.stderr:write("usage: hunt.lua POLHODE DIRECTORY COUNT SEED [TARGETS]\n")
  os.exit(2)
end

local worst, history = records.load_worst(WORST), records.load_history(HISTORY)

-- In the order of the list of targets, then as they came.
local function sorted(list)
  local out = {}
  for _, t in ipairs(targets.list) do
    for _, entry in ipairs(list) do
      if entry.target == t.name and entry.real == t.real then out[#out + 1] = entry end
    end
  end
  return out
end
local failed = false
for _, t in ipairs(names == "page" and {} or targets.chosen(names)) do
  local program, said = targets.build(t, directory, polhode)
  if said and said:find "warning" then io.stderr:write(said) end
  if not program then
    io.stderr:write(said)
    os.exit(1)
  end
  local states = math.max(1000, math.floor(count * t.share))
  local pipe = assert(io.popen(string.format("%s --seed %d --count %d", program, seed, states)))
  local text = pipe:read "a"
  if not pipe:close() then
    io.stderr:write("hunt: ", t.name, " failed\n")
    os.exit(1)
  end
  local h, found = records.parse(text, t)
  records.merge(worst, t, found)
  records.remember(history, h)
  for _, f in ipairs(found) do
    if tonumber(f.value) > tonumber(f.bound) then
      failed = true
      print(string.format("%s: %s is beyond its bound %s", targets.label(t, f.error), f.value, f.bound))
    end
  end
  records.save_worst(WORST, sorted(worst), targets.label)
  records.save_history(HISTORY, sorted(history))
end
page.write(PAGE, worst, history)
print("the worst states are in " .. WORST .. ", their history is in " .. PAGE)
os.exit(not failed)
