-- bench.lua -- what was measured of a scene's methods: Pareto fronts, the best at each level, tables, CSV, the diagram.
--
-- A study is plain data:
--     { name =, horizon = (s), reference = "how", own_error =, condition = { number =, input =, state =, growth = },
--       epsilon = { double =, float = }, conserved = { "T+V", ... }, levels = { 1e-3, ... },
--       noise = { least =, most = (of the baseline, s), noisy = bool }, rows = { ... } }
-- and a row one method at one setting:
--     { name = "taylor 16", family = "taylor", group = one of `groups`, real = "double"|"float",
--       kind = "step"|"tolerance"|"none", setting = number or nil, error =, note = "rounding"|"reference"|nil,
--       drift = { ["T+V"] = number, ... }, steps = integer or nil, time = s for the horizon, spread = of its medians,
--       evaluation = s (closed forms: of one evaluation, without the set-up), operations = { add =, mul =, div =,
--       sqrt =, call = } of one step or nil }
-- `mark` sets row.front: no row of its group is both faster and more accurate.
-- SPDX-License-Identifier: GPL-3.0-or-later

local rows_of = require "generator.report.rows"
local workprecision = require "generator.draw.workprecision"

local bench = {}

bench.groups = {
  { key = "closed", title = "closed form, portable C", closed = true },
  { key = "closed host", title = "closed form, compiled for this machine", closed = true },
  { key = "portable", title = "emitted steppers, portable C" },
  { key = "host", title = "emitted steppers, compiled for this machine" },
  { key = "peer", title = "peers, same right-hand side and flags" },
}
local useless = 1.0 -- an error of this size
local operations = { "add", "mul", "div", "sqrt", "call" }

-- ---- which rows are best ----

-- Rows of a group with a finite error, in the order they came.
local function of_group(study, key)
  local list = {}
  for _, r in ipairs(study.rows) do
    if r.group == key and r.error < math.huge then list[#list + 1] = r end
  end
  return list
end
bench.of_group = of_group

-- Those on the front of the list: fastest first, errors falling.  An error above 1 is no result.
function bench.front(list)
  local sorted = { table.unpack(list) }
  local place = {}
  for i, r in ipairs(list) do place[r] = i end
  table.sort(sorted, function(a, b)
    if a.time ~= b.time then return a.time < b.time end
    if a.error ~= b.error then return a.error < b.error end
    return place[a] < place[b]
  end)
  local out, least = {}, useless
  for _, r in ipairs(sorted) do
    if r.error < least then out[#out + 1], least = r, r.error end
  end
  return out
end

function bench.mark(study)
  for _, r in ipairs(study.rows) do r.front = false end
  for _, g in ipairs(bench.groups) do
    for _, r in ipairs(bench.front(of_group(study, g.key))) do r.front = true end
  end
end

-- The fastest row with at most that error, or nil.
function bench.best(list, level)
  local found
  for _, r in ipairs(list) do
    if r.error <= level and (not found or r.time < found.time) then found = r end
  end
  return found
end

-- For each level: {level =, peer = row, [group] = row, ratio = {[group] = peer's time over ours}}
function bench.summary(study)
  local out = {}
  for i, level in ipairs(study.levels) do
    local s = { level = level, ratio = {} }
    for _, g in ipairs(bench.groups) do s[g.key] = bench.best(of_group(study, g.key), level) end
    for _, g in ipairs(bench.groups) do
      if g.key ~= "peer" and s.peer and s[g.key] then s.ratio[g.key] = s.peer.time / s[g.key].time end
    end
    out[i] = s
  end
  return out
end

-- ---- words ----

local function level_text(x) return (string.gsub(string.format("%.2g", x), "e([+-])0*", "e%1")) end
bench.level_text = level_text

local function error_text(x)
  if x == math.huge then return "none" end
  return (string.gsub(string.format("%.1e", x), "e([+-])0", "e%1"))
end
bench.error_text = error_text

-- Three digits with a unit.
function bench.time_text(s)
  for _, u in ipairs { { 1e-6, 1e9, "ns" }, { 1e-3, 1e6, "µs" }, { 1, 1e3, "ms" }, { math.huge, 1, "s" } } do
    local v = s * u[2]
    if s < u[1] * 0.9995 then
      return string.format(v < 9.995 and "%.2f" or v < 99.95 and "%.1f" or "%.0f", v) .. " " .. u[3]
    end
  end
end
local time_text = bench.time_text

local function count_text(x) return string.format(x < 9.95 and "%.1f" or x < 1e5 and "%.0f" or "%.1e", x) end

local function ratio_text(x) return string.format(x < 9.95 and "%.2f" or x < 99.5 and "%.1f" or "%.0f", x) end
bench.ratio_text = ratio_text

local function setting_text(r)
  if r.kind == "none" then return "-" end
  return (r.kind == "step" and "h " or "tol ") .. (r.kind == "step" and string.format("%.4g", r.setting) or
    level_text(r.setting))
end

local function count(r)
  if not r.operations then return nil end
  local n = 0
  for _, k in ipairs(operations) do n = n + (r.operations[k] or 0) end
  return n
end

-- Seconds of one step, or of one evaluation of a closed form.
local function each(r) return r.evaluation or r.steps and r.steps > 0 and r.time / r.steps or nil end

-- ---- tables: {head, sections}, a section {title, {{cell, ...}, ...}}; the first column is to the left ----

-- One line a method: the least time at each level; `*` the best of its group.
local function levels_section(study, g)
  local list, names, rows = of_group(study, g.key), {}, {}
  for _, r in ipairs(list) do
    if not names[r.name] then
      names[r.name] = {}
      names[#names + 1] = r.name
    end
    table.insert(names[r.name], r)
  end
  for i, name in ipairs(names) do
    local cells, least = { name }, nil
    for _, level in ipairs(study.levels) do
      local own = bench.best(names[name], level)
      cells[#cells + 1] = own and time_text(own.time) .. (own == bench.best(list, level) and "*" or " ") or ". "
    end
    for _, r in ipairs(names[name]) do
      if not least or r.error < least.error then least = r end
    end
    cells[#cells + 1], cells[#cells + 2] = error_text(least.error), least.note or ""
    rows[i] = cells
  end
  return { g.title, rows }
end

local function levels_table(study)
  local head, sections = { "error at most" }, {}
  for _, level in ipairs(study.levels) do head[#head + 1] = level_text(level) .. " " end
  head[#head + 1], head[#head + 2] = "best error", ""
  for i, g in ipairs(bench.groups) do sections[i] = levels_section(study, g) end
  return { head, sections }
end

-- One line a row: the front of the group, fastest first, or all of it.
local function rows_section(study, g, all)
  local rows = {}
  for _, r in ipairs(all and of_group(study, g.key) or bench.front(of_group(study, g.key))) do
    local cells = { (not all and "" or r.front and "* " or "  ") .. r.name, setting_text(r), error_text(r.error),
      r.note or "" }
    for _, law in ipairs(study.conserved) do
      cells[#cells + 1] = r.drift and r.drift[law] and error_text(r.drift[law]) or "."
    end
    cells[#cells + 1] = r.steps and string.format("%d", r.steps) or "."
    cells[#cells + 1] = each(r) and time_text(each(r)) or "."
    cells[#cells + 1] = count(r) and string.format("%d", count(r)) or "."
    cells[#cells + 1] = time_text(r.time)
    cells[#cells + 1] = string.format("%.0f%%", 100 * (r.spread or 0))
    rows[#rows + 1] = cells
  end
  return { g.title, rows }
end

local function rows_table(study, all)
  local head, sections = { "method", "setting", "error", "" }, {}
  for _, law in ipairs(study.conserved) do head[#head + 1] = "drift " .. law end
  for _, s in ipairs { "steps", "a step", "operations", "time", "±" } do head[#head + 1] = s end
  for i, g in ipairs(bench.groups) do sections[i] = rows_section(study, g, all) end
  return { head, sections }
end

-- The best of each group at each level, and how many times faster than the best peer.
local function summary_table(study)
  local rows, head = {}, { "error at most" }
  local list = bench.summary(study)
  for i, s in ipairs(list) do head[i + 1] = level_text(s.level) end
  for _, g in ipairs(bench.groups) do
    local cells = { g.title }
    for i, s in ipairs(list) do
      local r, ratio = s[g.key], s.ratio[g.key]
      cells[i + 1] = not r and "." or r.name .. ", " .. time_text(r.time) ..
        (ratio and " (" .. ratio_text(ratio) .. " x)" or "")
    end
    if #of_group(study, g.key) > 0 then rows[#rows + 1] = cells end
  end
  return { head, { { nil, rows } } }
end

local function plain(t, out)
  local head, sections = t[1], t[2]
  local wide = {}
  local function measure(cells)
    for k, c in ipairs(cells) do wide[k] = math.max(wide[k] or 0, utf8.len(c)) end
  end
  local function put(cells)
    local parts = {}
    for k, c in ipairs(cells) do
      local pad = string.rep(" ", wide[k] - utf8.len(c))
      parts[k] = k == 1 and c .. pad or pad .. c
    end
    out[#out + 1] = (string.gsub(table.concat(parts, "  "), " +$", ""))
  end
  measure(head)
  for _, s in ipairs(sections) do
    for _, cells in ipairs(s[2]) do measure(cells) end
  end
  put(head)
  for _, s in ipairs(sections) do
    if s[1] and #s[2] > 0 then out[#out + 1] = "-- " .. s[1] end
    for _, cells in ipairs(s[2]) do put(cells) end
  end
  out[#out + 1] = ""
end

local function markdown(t, out)
  local function put(cells)
    local line = {}
    for k, c in ipairs(cells) do line[k] = (string.gsub(string.gsub(c, " +$", ""), "|", "\\|")) end
    out[#out + 1] = "| " .. table.concat(line, " | ") .. " |"
  end
  local marks = {}
  for k in ipairs(t[1]) do marks[k] = k == 1 and "---" or "---:" end
  put(t[1])
  out[#out + 1] = "|" .. table.concat(marks, "|") .. "|"
  for _, s in ipairs(t[2]) do
    if s[1] and #s[2] > 0 then
      local cells = { "*" .. s[1] .. "*" }
      for k = 2, #t[1] do cells[k] = "" end
      put(cells)
    end
    for _, cells in ipairs(s[2]) do put(cells) end
  end
  out[#out + 1] = ""
end

-- What is to be known before the numbers are read: sentences.
function bench.preface(study)
  local c, list = study.condition, {}
  list[1] = study.name .. " over " .. string.format("%.6g", study.horizon) .. " s; error: the largest at 40 end " ..
    "times in the last tenth of it, each kind of state relative to its largest value"
  list[2] = "reference: " .. study.reference .. ", good to " .. error_text(study.own_error)
  if c then
    local function ulp(n)
      local e = study.epsilon
      local function by(x) return x < 1 and error_text(x) or "all of it" end
      return by(n * e.double) .. " in double, " .. by(n * e.float) .. " in float"
    end
    list[3] = "condition number " .. count_text(c.number) .. " (worst input: " .. c.input ..
      "): one ulp of it moves the end by " .. ulp(c.number)
    list[4] = "one ulp of the size of the state, as each step adds, moves the end by up to " ..
      ulp(c.state) .. ". Errors near these are named rounding"
    if c.growth then list[#list + 1] = c.growth end
  end
  for _, s in ipairs(study.remarks or {}) do list[#list + 1] = s end
  return list
end

-- A warning, or nil.
function bench.noise(study)
  local n = study.noise
  if not n or not n.noisy then return nil end
  return "the machine was noisy: the same loop took " .. time_text(n.least) .. " to " .. time_text(n.most) ..
    "; times may be too long by as much"
end

-- options: {format = "text"|"markdown", all = every row}
function bench.text(study, options)
  local in_markdown, out = options.format == "markdown", {}
  local put = in_markdown and markdown or plain
  for _, s in ipairs(bench.preface(study)) do out[#out + 1] = (in_markdown and "- " or "") .. s end
  local function section(words, t)
    out[#out + 1] = ""
    out[#out + 1] = words
    out[#out + 1] = in_markdown and "" or nil
    put(t, out)
    out[#out] = nil
  end
  section("Least time to cover the horizon with at most that error; * the best of its kind:", levels_table(study))
  section(options.all and "Every row; * on the Pareto front of its kind:" or
    "The Pareto fronts: nothing of its kind is both faster and more accurate:", rows_table(study, options.all))
  section("The best, and how many times faster than the best peer:", summary_table(study))
  return table.concat(out, "\n") .. "\n"
end

-- ---- all rows, for programs ----

local function number(x) return x and string.format("%.17g", x) or "" end

function bench.csv(study)
  local head = { "scene", "group", "method", "real", "kind", "setting", "error", "note" }
  for _, law in ipairs(study.conserved) do head[#head + 1] = "drift " .. law end
  for _, s in ipairs { "steps", "seconds_step", "seconds", "spread" } do head[#head + 1] = s end
  for _, s in ipairs(operations) do head[#head + 1] = s end
  head[#head + 1] = "front"
  local list = {}
  for i, r in ipairs(study.rows) do
    local cells = { study.name, r.group, r.name, r.real, r.kind, number(r.setting),
      r.error == math.huge and "inf" or number(r.error), r.note or "" }
    for _, law in ipairs(study.conserved) do cells[#cells + 1] = number(r.drift and r.drift[law]) end
    cells[#cells + 1] = r.steps and string.format("%d", r.steps) or ""
    cells[#cells + 1], cells[#cells + 2] = number(each(r)), number(r.time)
    cells[#cells + 1] = number(r.spread)
    for _, s in ipairs(operations) do
      cells[#cells + 1] = r.operations and string.format("%d", r.operations[s] or 0) or ""
    end
    cells[#cells + 1] = r.front and "1" or "0"
    list[i] = cells
  end
  return rows_of.csv(head, list)
end

-- ---- the diagram ----

-- What is drawn: the front of each family in portable double, the front of what is compiled for this machine, the
-- front of float, each peer, the closed form.
function bench.curves(study)
  local curves = {}
  local function curve(label, kind, take)
    local list = {}
    for _, r in ipairs(study.rows) do
      if r.error < math.huge and take(r) then list[#list + 1] = r end
    end
    local points = {}
    for i, r in ipairs(bench.front(list)) do points[i] = { r.time, r.error } end
    if #points > 0 then curves[#curves + 1] = { label = label, kind = kind, points = points } end
  end
  local function names(key, field)
    local list, seen = {}, {}
    for _, r in ipairs(of_group(study, key)) do
      if not seen[r[field]] and r.real == "double" then
        seen[r[field]], list[#list + 1] = true, r[field]
      end
    end
    return list
  end
  curve("closed form", "spot", function(r) return r.group == "closed" and r.real == "double" end)
  for _, family in ipairs(names("portable", "family")) do
    curve(family, "own", function(r) return r.group == "portable" and r.real == "double" and r.family == family end)
  end
  curve("this machine, best", "group", function(r) return r.group == "host" and r.real == "double" end)
  curve("float, best", "group", function(r)
    return r.real == "float" and (r.group == "portable" or r.group == "host")
  end)
  for _, name in ipairs(names("peer", "name")) do
    curve(name, "peer", function(r) return r.group == "peer" and r.name == name end)
  end
  return curves
end

function bench.picture(study)
  local floors, c = {}, study.condition
  for i, real in ipairs(c and { "double", "float" } or {}) do
    floors[i] = { c.number * study.epsilon[real], "one ulp of the input, " .. real }
  end
  local title = study.name .. ": error against time for " .. string.format("%.6g", study.horizon) .. " s of motion"
  return workprecision.text { title = title, floors = floors, curves = bench.curves(study),
    about = "For each method the time to cover the horizon and the largest error near its end, both logarithmic.",
    note = "filled markers: emitted C, portable, double; hollow: peers; heavy: the best of its kind; lower left is " ..
      "better",
    xlabel = "time to cover the horizon [s]", ylabel = "largest error at the end" }
end

return bench
