-- records.lua - the hunt's results as files: tests/hunt/worst.tsv and history.tsv, read and written.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- worst: a list of {target, real, error, bound, states = {{value, genes}, ...}}, the worst first, at most KEPT;
-- history: a list of {target, real, seed, tried, refused, judged, doubted, errors = {name, ...}, marks = {{tried,
-- value, ...}, ...}}.  Genes are hexadecimal numbers as text, so nothing is rounded; values have four digits.

local records = {}

records.KEPT = 3

local function split(text, separator)
  local list = {}
  for word in string.gmatch(text .. separator, "(.-)" .. separator) do list[#list + 1] = word end
  return list
end

-- The rows of a file of tabs, without its head; none if there is no file.
local function rows(path)
  local list, file = {}, io.open(path)
  if not file then return list end
  for line in file:lines() do
    if not string.find(line, "^#") then list[#list + 1] = split(line, "\t") end
  end
  file:close()
  return list
end

local function save(path, head, lines)
  local file = assert(io.open(path, "w"))
  file:write("# Written by `make hunt` (tests/hunt/records.lua).  SPDX-License-Identifier: GPL-3.0-or-later\n# ", head,
    "\n")
  for _, line in ipairs(lines) do file:write(table.concat(line, "\t"), "\n") end
  assert(file:close())
end

function records.load_worst(path)
  local worst, own = {}, nil
  for _, r in ipairs(rows(path)) do
    if not (own and own.target == r[2] and own.real == r[3] and own.error == r[4]) then
      own = { target = r[2], real = r[3], error = r[4], bound = r[6], states = {} }
      worst[#worst + 1] = own
    end
    own.states[#own.states + 1] = { name = r[1], value = r[5], genes = split(r[7], " ") }
  end
  return worst
end

-- label(target, error): the name of a list of states, which its rank completes.
function records.save_worst(path, worst, label)
  local lines = {}
  for _, w in ipairs(worst) do
    for rank, s in ipairs(w.states) do
      lines[#lines + 1] = { label(w, w.error) .. "_" .. rank, w.target, w.real, w.error, s.value, w.bound,
        table.concat(s.genes, " ") }
    end
  end
  save(path, "name\ttarget\treal\terror\tvalue\tbound\tgenes", lines)
end

function records.load_history(path)
  local history = {}
  for _, r in ipairs(rows(path)) do
    if r[1] == "run" then
      local function whole(i) return math.tointeger(tonumber(r[i])) end
      history[#history + 1] = { target = r[2], real = r[3], seed = whole(4), tried = whole(5), refused = whole(6),
        judged = whole(7), doubted = whole(8), errors = table.move(r, 9, #r, 1, {}), marks = {} }
    else
      local marks = history[#history].marks
      marks[#marks + 1] = table.move(r, 2, #r, 1, {})
    end
  end
  return history
end

function records.save_history(path, history)
  local lines = {}
  for _, h in ipairs(history) do
    lines[#lines + 1] = { "run", h.target, h.real, h.seed, h.tried, h.refused, h.judged, h.doubted,
      table.unpack(h.errors) }
    for _, m in ipairs(h.marks) do lines[#lines + 1] = { "after", table.unpack(m) } end
  end
  save(path, "run\ttarget\treal\tseed\ttried\trefused\tjudged\tdoubted\terrors...; after\ttried\tvalues...", lines)
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
