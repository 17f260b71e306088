-- accuracy.lua -- docs/accuracy.md: what accuracy costs, on six scenes, measured by `polhode bench`.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/bench/accuracy.lua PROGRAM DIRECTORY PAGE [SCENE...]
-- runs the scenes (all, or those named), leaves what they print in DIRECTORY, puts the diagrams beside the page into
-- accuracy/, and writes the tables between the page's marks.  A mark is <!-- NAME --> .. <!-- end of NAME -->:
-- `machine`, `bars`, and the name of each scene.

package.path = "./?.lua;" .. package.path

local report = require "generator.report.bench"
local files = require "tests.cli.program"

local program, dir, page = arg[1], arg[2], arg[3]

local scenes = {
  { name = "tumbling_box" },
  { name = "tennis_racket", horizon = 60 },
  { name = "nodding_top" },
  { name = "damped_brick" },
  { name = "gravity_gradient", horizon = 86400 },
  { name = "gyrostat" },
}

-- What the emitted code is to be ahead of the best peer by, at the levels.
local levels = { 1e-3, 1e-6, 1e-9, 1e-11 }
local bars = {
  { scene = "tumbling_box", title = "A, closed form", want = { 100, 200, 400, 800 },
    groups = { "closed", "closed host" } },
  { scene = "tumbling_box", title = "A, closed form forbidden", want = { 2, 2.5, 3.5, 5 },
    groups = { "portable", "host" } },
  { scene = "nodding_top", title = "B, closed form forbidden", want = { 3.5, 5, 9, 12 },
    groups = { "portable", "host" } },
}

local function shell(...) return os.execute(string.format(...)) end

-- ---- one scene ----

local function split(line)
  local cells = {}
  for cell in string.gmatch(line .. ",", "([^,]*),") do cells[#cells + 1] = cell end
  return cells
end

-- The rows of a CSV file as the report has them.
local function rows_of(path)
  local rows, head = {}, nil
  for line in io.lines(path) do
    local cells = split(line)
    if not head then
      head = cells
    else
      local c = {}
      for i, name in ipairs(head) do c[name] = cells[i] end
      rows[#rows + 1] = { name = c.method, group = c.group, real = c.real, kind = c.kind,
        error = tonumber(c.error) or math.huge,
        time = tonumber(c.seconds), family = string.match(c.method, "^%l+%d*") or c.method }
    end
  end
  return rows
end

local function filter(rows, take)
  local list = {}
  for _, r in ipairs(rows) do
    if take(r) then list[#list + 1] = r end
  end
  return list
end

-- Lines {title, rows, named = which of them it was is worth saying}.
local function lines_of(rows)
  local lines = {}
  local function put(title, named, take)
    local list = filter(rows, take)
    if #list > 0 then lines[#lines + 1] = { title, list, named = named } end
  end
  put("closed form", false, function(r) return r.group == "closed" and r.real == "double" end)
  local seen = {}
  for _, r in ipairs(rows) do
    if r.group == "portable" and r.real == "double" and not seen[r.family] then
      seen[r.family] = true
      put(r.family, r.family == "taylor", function(o)
        return o.group == "portable" and o.real == "double" and o.family == r.family
      end)
    end
  end
  put("best in float", true, function(r) return r.group == "portable" and r.real == "float" end)
  put("best for this machine", true, function(r) return r.group == "host" end)
  put("hand-written RK4", false, function(r) return r.name == "hand RK4" end)
  put("best of GSL", true, function(r) return string.find(r.name, "^GSL") end)
  put("best of SUNDIALS", true, function(r) return string.find(r.name, "^CVODE") or string.find(r.name, "^ARKODE") end)
  return lines
end

local function table_of(rows)
  local head = { "error at most" }
  for i, level in ipairs(levels) do head[i + 1] = report.level_text(level) end
  local out = { "| " .. table.concat(head, " | ") .. " | best error |", "|---|" .. string.rep("---:|", #levels + 1) }
  for _, l in ipairs(lines_of(rows)) do
    local cells, least = { l[1] }, math.huge
    for i, level in ipairs(levels) do
      local best = report.best(l[2], level)
      local short = best and l.named and string.gsub(string.gsub(best.name, "^GSL ", ""), " float$", "")
      cells[i + 1] = best and report.time_text(best.time) .. (short and " (" .. short .. ")" or "") or "-"
    end
    for _, r in ipairs(l[2]) do least = math.min(least, r.error) end
    cells[#cells + 1] = report.error_text(least)
    out[#out + 1] = "| " .. table.concat(cells, " | ") .. " |"
  end
  return table.concat(out, "\n") .. "\n"
end

local function measured(s)
  local file = dir .. "/" .. s.name
  local words = s.horizon and string.format(" --until %d", s.horizon) or ""
  io.stderr:write(s.name, "\n")
  assert(shell("%s bench bodies/%s.lua%s --format markdown -o %s > %s.md 2> %s.err", program, s.name, words, dir, file,
    file), "polhode bench failed: see " .. file .. ".err")
  local preface = {}
  for line in io.lines(file .. ".md") do
    if string.sub(line, 1, 2) ~= "- " then break end
    preface[#preface + 1] = line
  end
  s.noise = string.match(files.read(file .. ".err"), "warning: (the machine[^\n]*)")
  s.rows = rows_of(file .. ".csv")
  local folder = string.gsub(page, "%.md$", "")
  assert(shell("mkdir -p %s", folder))
  files.write(folder .. "/" .. s.name .. ".svg", files.read(file .. ".svg"))
  return table.concat(preface, "\n") .. (s.noise and "\n- " .. s.noise or "") .. "\n\n" .. table_of(s.rows)
end

-- ---- the page ----

-- The page is read and written anew each time: what was measured stays, whatever happens to the next scene.
local function fill(mark, what)
  local text = files.read(page)
  local a, b = string.format("<!-- %s -->\n", mark), string.format("<!-- end of %s -->", mark)
  local from, to = string.find(text, a, 1, true), string.find(text, b, 1, true)
  assert(from and to, page .. " must have the marks of " .. mark)
  files.write(page, string.sub(text, 1, from + #a - 1) .. "\n" .. what .. "\n" .. string.sub(text, to))
end

local function bars_table(by_name)
  local head = { "error at most" }
  for i, level in ipairs(levels) do head[i + 1] = report.level_text(level) end
  local out = { "| " .. table.concat(head, " | ") .. " |", "|---|" .. string.rep("---:|", #levels) }
  for _, bar in ipairs(bars) do
    local study = { rows = by_name[bar.scene].rows, levels = levels }
    local summary = report.summary(study)
    local function line(title, cell)
      local cells = { title }
      for i, s in ipairs(summary) do cells[i + 1] = cell(s, i) end
      out[#out + 1] = "| " .. table.concat(cells, " | ") .. " |"
    end
    line("**" .. bar.title .. "**: asked for", function(_, i) return string.format("%g", bar.want[i]) end)
    for _, group in ipairs(bar.groups) do
      local title = string.find(group, "host") and "for this machine" or "portable C"
      line(title, function(s, i)
        if not s[group] then return "-" end
        local what = report.time_text(s[group].time) .. " (" .. s[group].name .. ")"
        if not s.ratio[group] then return "no peer gets there; " .. what end
        local ratio = report.ratio_text(s.ratio[group])
        return (s.ratio[group] >= bar.want[i] and "**" .. ratio .. "**" or ratio) .. ": " .. what
      end)
    end
    local function named(r) return r and report.time_text(r.time) .. " (" .. r.name .. ")" or "-" end
    line("best peer", function(s) return named(s.peer) end)
    local choosing = filter(study.rows, function(r) return r.group == "peer" and r.kind == "tolerance" end)
    line("best peer that chooses its steps", function(s) return named(report.best(choosing, s.level)) end)
  end
  return table.concat(out, "\n") .. "\n"
end

local function line_of(command)
  local pipe = assert(io.popen(command))
  local line = pipe:read("l")
  pipe:close()
  return line
end

local function machine()
  local cpu = line_of "sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo 2>/dev/null"
  cpu = cpu or "a processor that does not say its name"
  return "Measured on " .. cpu .. ", one core, with " .. (line_of "${CC:-cc} --version" or "cc") .. ".\n"
end

assert(shell("mkdir -p %s", dir))
local wanted = {}
for i = 4, #arg do wanted[arg[i]] = true end
local by_name = {}
for _, s in ipairs(scenes) do
  by_name[s.name] = s
  if #arg < 4 or wanted[s.name] then fill(s.name, measured(s)) end
end
fill("machine", machine())
if by_name.tumbling_box.rows and by_name.nodding_top.rows then fill("bars", bars_table(by_name)) end
