-- page.lua - docs/hunt.md: what the hunt searches, its worst errors and their history.
-- SPDX-License-Identifier: GPL-3.0-or-later

local targets = require "tests.hunt.targets"
local words = require "tests.hunt.words"

local page = {}

-- Three digits; a power of ten where there are more before the point.
local function short(value)
  local x = tonumber(value)
  if x >= 1e5 then return (string.gsub(string.format("%.1e", x), "e%+?0*", "e")) end
  return string.format(x >= 99.95 and "%.0f" or x >= 9.995 and "%.1f" or "%.2f", x)
end

local function power(n)
  return n < 1000 and string.format("%d", n) or (string.gsub(string.format("%.2g", n), "e%+0*", "e"))
end

-- The states of all runs of a target.
local function tried(history, t)
  local n = 0
  for _, h in ipairs(history) do
    if h.target == t.name and h.real == t.real then n = n + h.tried end
  end
  return n
end

local function names_of(t) return t.name .. (t.real == "float" and ", float" or "") end

local function summary(out, worst, history)
  out[#out + 1] = "| target | error | unit | bound | worst | worst/bound | states |\n|---|---|---|---|---|---|---|\n"
  for _, t in ipairs(targets.list) do
    for _, w in ipairs(worst) do
      if w.target == t.name and w.real == t.real then
        local value, bound = tonumber(w.states[1].value), tonumber(w.bound)
        out[#out + 1] = string.format("| %s | %s | %s | %s | %s | %s | %s |\n", names_of(t), w.error,
          words.unit(t, w.error), w.bound, short(value), string.format("%.2f", value/bound), power(tried(history, t)))
      end
    end
  end
end

local function histories(out, history)
  for _, t in ipairs(targets.list) do
    for _, h in ipairs(history) do
      if h.target == t.name and h.real == t.real then
        out[#out + 1] = string.format("\n**%s**, seed %d: %s states", names_of(t), h.seed, power(h.tried))
        out[#out + 1] = string.format(" (%d judged, %d doubted)\n\n| after | %s |\n|---|%s\n", h.judged, h.doubted,
          table.concat(h.errors, " | "), string.rep("---|", #h.errors))
        for i, m in ipairs(h.marks) do
          -- the last line judges also what was just below the third worst: it replaces that of the same count
          if not (h.marks[i + 1] and h.marks[i + 1][1] == m[1]) then
            local cells = { power(math.tointeger(tonumber(m[1]))) }
            for k = 2, #m do cells[k] = short(m[k]) end
            out[#out + 1] = "| " .. table.concat(cells, " | ") .. " |\n"
          end
        end
      end
    end
  end
end

-- A gene in decimals, for reading; the file has all digits.
local function decimal(gene)
  return (string.gsub(string.gsub(string.format("%.6g", tonumber(gene)), "e([+-])0*", "e%1"), "e%+", "e"))
end

local function states(out, worst)
  out[#out + 1] = "| name | value | state |\n|---|---|---|\n"
  for _, t in ipairs(targets.list) do
    for _, w in ipairs(worst) do
      if w.target == t.name and w.real == t.real then
        local genes = {}
        for i, g in ipairs(w.states[1].genes) do genes[i] = decimal(g) end
        out[#out + 1] = string.format("| `%s_1` | %s | %s |\n", targets.label(t, w.error),
          short(w.states[1].value), table.concat(genes, " "))
      end
    end
  end
end

function page.write(path, worst, history)
  local out = { words.head }
  summary(out, worst, history)
  out[#out + 1] = words.found
  for _, f in ipairs(dofile "tests/hunt/found.lua") do
    local was = f.was == "no number" and "the states were no numbers" or "off by " .. f.was .. " u"
    out[#out + 1] = string.format("- `%s` (%s): %s (%s; %s)\n", f.name, names_of { name = f.target, real = f.real },
      f.what, f.error, was)
  end
  out[#out + 1] = words.states
  states(out, worst)
  out[#out + 1] = words.history
  histories(out, history)
  local file = assert(io.open(path, "w"))
  file:write(table.concat(out))
  assert(file:close())
end

return page
