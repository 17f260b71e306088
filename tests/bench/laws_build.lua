-- laws_build.lua -- compiles the scenes of the drift laws: tests/bench/laws.c with the emitted code and its rows.
-- SPDX-License-Identifier: GPL-3.0-or-later

local files = require "tests.cli.program"

local build = {}

-- Moments 3, 4, 1 (a lamina): the quotients in Euler's equations are 1, -1/2, -1, exact in every type, so that rounded
-- constants are no part of what is measured.  The heavy top's are 2, 2, 1 about its point, m g r/I1 = 2.
local scenes = {
  free = { heavy = 0, text = 'body = tensor { mass = 1, xx = 3, yy = 4, zz = 1 }, ' ..
    "initial = { omega = {0.5, 0.5, 0.75} }" },
  heavy = { heavy = 4, text = 'body = tensor { mass = 1, xx = 1.75, yy = 1.75, zz = 1, com = {0, 0, 0.5} }, ' ..
    "origin = {0, 0, 0}, effects = { effect.gravity { g = 8 } }, " ..
    'initial = { omega = {0.25, 0, 3}, attitude = { axis = "x", angle = 0.5 } }' },
}

-- Groups of steppers that are generated together: options of gen, and rows by name: {kind, step, low}.
local groups = {
  plain = { options = "--method rk4,adaptive,midpoint,semi,split2,split4,split6", rows = {
    { "rk4", "STEP", "top_step" }, { "adaptive", "STEP", "top_adaptive_step" },
    { "midpoint", "STEP", "top_midpoint_step" }, { "semi", "STEP", "top_semi_step" },
    { "split2", "STEP", "top_split2_step" }, { "split4", "STEP", "top_split4_step" },
    { "split6", "STEP", "top_split6_step" }, { "library rk4", "LIBRARY_RK4" } } },
  low = { options = "--method rk4,adaptive,semi,taylor --order 8 --with compensated", rows = {
    { "rk4, compensated", "LOW", nil, "top_step_compensated" },
    { "adaptive, compensated", "LOW", nil, "top_adaptive_step_compensated" },
    { "semi, compensated", "LOW", nil, "top_semi_step_compensated" },
    { "taylor 8", "STEP", "top_taylor_step" },
    { "taylor 8, compensated", "LOW", nil, "top_taylor_step_compensated" } } },
  taylor20 = { options = "--method taylor --order 20 --with compensated", rows = {
    { "taylor 20", "STEP", "top_step" }, { "taylor 20, compensated", "LOW", nil, "top_step_compensated" } } },
  -- of tests/methods/laws.t: few functions, for the compiler's sake
  few = { options = "--method rk4,exact --with compensated,orbit", defines = "-DTICKS", rows = {
    { "few: rk4", "STEP", "top_step" }, { "few: rk4, compensated", "LOW", nil, "top_step_compensated" },
    { "few: closed form by ticks", "CLOSED" } } },
  split = { options = "--method split2", rows = { { "few: split2", "STEP", "top_step" } } },
  ticks = { options = "--method exact --with orbit", defines = "-DTICKS", rows = {
    { "closed form by ticks", "CLOSED" } } },
  q31 = { options = "--with q31", defines = "-DQ31", more = ", ranges = { omega = 1.1 }, time = { step = 0.001953125 }",
    sources = { "top_q31.c", "top_q31_real.c" }, rows = { { "q31", "WHOLE" } } },
}

local place = {} -- of a row by its name: group, number
for name, g in pairs(groups) do -- into a table: order is lost anyway
  for i, row in ipairs(g.rows) do place[row[1]] = { group = name, row = i - 1 } end
end

local function shell(...)
  local command = string.format(...)
  assert(os.execute(command), command)
end

local function scene_file(path, name, s, more)
  files.write(path, string.format("return scene { name = %q, %s%s }\n", name, s.text, more or ""))
end

-- The scene in double with its closed form, compiled once for all that is compared with it.
local function reference(program, dir, scene)
  local folder = string.format("%s/%s", dir, scene)
  if files.read(folder .. "/ref.o") then return folder end
  shell("mkdir -p %s", folder)
  scene_file(folder .. "/ref.lua", "ref", scenes[scene])
  shell("POLHODE_SOURCE=. %s gen --layout single --with orbit %s/ref.lua --method exact -o %s > %s/log", program,
    folder, folder, folder)
  shell("cc -std=c11 -O1 -ffp-contract=off -c -o %s/ref.part %s/ref.c && mv %s/ref.part %s/ref.o", folder, folder,
    folder, folder)
  return folder
end

local function make(program, library, dir, scene, real, group)
  local s, g = scenes[scene], groups[group]
  local folder = string.format("%s/%s_%s_%s", dir, scene, real, group)
  if files.read(folder .. "/laws") then return folder end -- of an interrupted measurement
  local ref = reference(program, dir, scene)
  shell("mkdir -p %s", folder)
  local rows, sources = {}, { folder .. "/top.c" }
  for i, row in ipairs(g.rows) do
    rows[i] = string.format("{%s, %s, %s},\n", row[2], row[3] or "NULL", row[4] or "NULL")
  end
  files.write(folder .. "/rows.h", table.concat(rows))
  scene_file(folder .. "/top.lua", "top", s, g.more)
  shell("POLHODE_SOURCE=. %s gen --layout single %s/top.lua --real %s %s -o %s > %s/log", program, folder, real,
    g.options, folder,
    folder)
  for _, name in ipairs(g.sources or {}) do sources[#sources + 1] = folder .. "/" .. name end
  shell("cc -std=c11 -O2 -ffp-contract=off -Wno-unused -I%s -I%s -Isrc/runtime -DHEAVY=%d %s tests/bench/laws.c %s " ..
    "%s/ref.o %s -o %s/laws -lgsl -lgslcblas -lmpfr -lgmp -lm", folder, ref, s.heavy, g.defines or "",
    table.concat(sources, " "), ref, library, folder)
  return folder
end

-- Compiles what the runs need and gives each its folder and row.
function build.all(program, library, dir, list)
  local made = {}
  for _, r in ipairs(list) do
    local at = place[r.method] or error("no row " .. r.method)
    local key = r.scene .. r.real .. at.group
    made[key] = made[key] or make(program, library, dir, r.scene, r.real, at.group)
    r.folder, r.row = made[key], at.row
  end
end

-- Operations of a row's step from the emitted README: additions + multiplications + divisions + roots.
function build.operations(program, r)
  local at = place[r.method]
  local g = groups[at.group]
  local name = string.gsub(g.rows[at.row + 1][4] or g.rows[at.row + 1][3], "^top_", "")
  local folder = r.folder .. "/sheet"
  if not files.read(folder .. "/README.md") then
    shell("POLHODE_SOURCE=. %s gen --layout single %s/top.lua --real %s %s -o %s > %s/log", program, r.folder,
      r.real, g.options,
      folder,
      r.folder)
  end
  local sheet = files.read(folder .. "/README.md")
  local sum = 0
  for n in string.gmatch(string.match(sheet, "\n| " .. name .. " | ([%d |]-) |\n"), "%d+") do sum = sum
    + tonumber(n) end
  return sum
end

-- The output of laws.c: {time = ns, {n = , mean = {5}, square = {5 of groups}}, ...}
function build.read(path)
  local out = {}
  for line in io.lines(path) do
    local words = {}
    for w in string.gmatch(line, "%S+") do words[#words + 1] = tonumber(w) or w end
    if words[1] == "time" then
      out.time = words[2]
    else
      local at, point = 2, { n = words[1], mean = {}, square = {} }
      for q = 1, 5 do
        point.mean[q], point.square[q] = words[at], table.move(words, at + 1, at + 8, 1, {})
        at = at + 9
      end
      out[#out + 1] = point
    end
  end
  return out
end

return build
