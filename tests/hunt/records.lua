-- records.lua - the hunt's results as files: tests/hunt/worst.lua and history.lua, read and written.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- worst: a list of {target, real, error, bound, states = {{value, genes}, ...}}, the worst first, at most three;
-- history: a list of {target, real, seed, tried, refused, judged, doubted, errors = {name, ...}, marks = {{tried, value,
-- ...}, ...}}.  Genes are hexadecimal numbers as text, so nothing is rounded; values have four digits.

local records = {}

records.KEPT = 3

function records.load(path)
  local chunk = loadfile(path, "t", {})
  return chunk and chunk() or {}
end

local function quoted(list)
  local out = {}
  for i, word in ipairs(list) do out[i] = string.format("%q", word) end
  return table.concat(out, ", ")
end

local function save(path, what, lines)
  local file = assert(io.open(path, "w"))
  file:write("-- ", string.match(path, "[^/]*$"), " - ", what, ", written by `make hunt`; see tests/hunt/records.lua.\n",
    "-- SPDX-License-Identifier: GPL-3.0-or-later\nreturn {\n", table.concat(lines), "}\n")
  assert(file:close())
end

function records.save_worst(path, worst)
  local lines = {}
  for _, w in ipairs(worst) do
    lines[#lines + 1] = string.format("  { target = %q, real = %q, error = %q, bound = %s, states = {\n", w.target,
      w.real, w.error, w.bound)
    for _, s in ipairs(w.states) do
      local genes, row = {}, "     "
      for i, g in ipairs(s.genes) do
        local word = string.format(" %q%s", g, i < #s.genes and "," or "")
        if #row + #word > 112 then genes[#genes + 1], row = row, "     " end
        row = row .. word
      end
      genes[#genes + 1] = row
      lines[#lines + 1] = string.format("    { value = %s, genes = {\n%s } },\n", s.value, table.concat(genes, "\n"))
    end
    lines[#lines + 1] = "  } },\n"
  end
  save(path, "the worst states found", lines)
end

function records.save_history(path, history)
  local lines = {}
  for _, h in ipairs(history) do
    lines[#lines + 1] = string.format("  { target = %q, real = %q, seed = %d, tried = %d, refused = %d, judged = %d, " ..
      "doubted = %d,\n    errors = { %s }, marks = {\n", h.target, h.real, h.seed, h.tried, h.refused, h.judged,
      h.doubted, quoted(h.errors))
    for _, m in ipairs(h.marks) do lines[#lines + 1] = "      { " .. table.concat(m, ", ") .. " },\n" end
    lines[#lines + 1] = "    } },\n"
  end
  save(path, "worst errors against states tried", lines)
end

-- The lines that a search printed: its history, and {error, value, bound, genes} of each state kept.
function records.parse(text, t)
  local h, found, marks = { target = t.name, real = t.real, errors = {}, marks = {} }, {}, {}
  for line in string.gmatch(text, "[^\n]+") do
    local w = {}
    for word in string.gmatch(line, "%S+") do w[#w + 1] = word end
    if w[1] == "history" then
      local mark = marks[w[3]]
      if not mark then
        mark = { w[3] }
        marks[w[3]], h.marks[#h.marks + 1] = mark, mark
      end
      local at = 0
      for i, name in ipairs(h.errors) do if name == w[2] then at = i end end
      if at == 0 then
        at = #h.errors + 1
        h.errors[at] = w[2]
      end
      mark[at + 1] = w[4] == "inf" and "1e999" or w[4]
    elseif w[1] == "search" then
      h.seed, h.tried, h.refused, h.judged, h.doubted = math.tointeger(tonumber(w[4])), math.tointeger(tonumber(w[5])),
        math.tointeger(tonumber(w[6])), math.tointeger(tonumber(w[7])), math.tointeger(tonumber(w[8]))
    elseif w[1] == "worst" then
      found[#found + 1] = { error = w[2], value = w[4] == "inf" and "1e999" or w[4], bound = w[5],
        genes = table.move(w, 6, #w, 1, {}) }
    end
  end
  return h, found
end

-- Keeps what is worse: the states of each error, at most KEPT.
function records.merge(worst, t, found)
  for _, f in ipairs(found) do
    local own
    for _, w in ipairs(worst) do
      if w.target == t.name and w.real == t.real and w.error == f.error then own = w end
    end
    if not own then
      own = { target = t.name, real = t.real, error = f.error, states = {} }
      worst[#worst + 1] = own
    end
    own.bound = f.bound
    local known = false
    for _, s in ipairs(own.states) do
      known = known or table.concat(s.genes, " ") == table.concat(f.genes, " ")
    end
    if not known then
      local at = 1
      while own.states[at] and tonumber(own.states[at].value) >= tonumber(f.value) do at = at + 1 end
      table.insert(own.states, at, { value = f.value, genes = f.genes })
      own.states[records.KEPT + 1] = nil
    end
  end
end

-- One run of a target with a seed and a count is one entry.
function records.remember(history, h)
  for i, old in ipairs(history) do
    if old.target == h.target and old.real == h.real and old.seed == h.seed and old.tried == h.tried then
      history[i] = h
      return
    end
  end
  history[#history + 1] = h
end

return records
