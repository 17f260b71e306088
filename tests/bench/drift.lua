-- drift.lua -- the table of drifts in docs/methods.md: every emitted stepper over many revolutions.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/bench/drift.lua PROGRAM DIRECTORY REVOLUTIONS [PAGE]
-- prints the tables, and puts them between the two marks of the page.  drift.c measures.  A stepper that a scene
-- refuses is left out of its table; one that is new is in it at 32 steps a revolution.

package.path = "./?.lua;" .. package.path

local files = require "tests.cli.program"

local program, dir, turns, page = arg[1], arg[2], tonumber(arg[3]), arg[4]

local scenes = {
  { title = "Free brick, 20 x 10 x 5 cm, spun about the middle axis, which flips over and over; momentum: all of L",
    period = "2*math.pi/6", momentum = 0,
    text = [[body = solid.box { x = 0.2, y = 0.1, z = 0.05, mass = 2.4 }, initial = { omega = {0.1, 6, 0.2} }]] },
  { title = "Heavy top, V/T = 0.03, with nutation; momentum: L along the vertical", period = "2*math.pi/150",
    momentum = 1,
    text = [[body = solid.cylinder { r = 0.05, h = 0.02, mass = 0.5 }, origin = {0, 0, -0.05},
      effects = { effect.gravity {} }, initial = { omega = {1, 0, 150}, attitude = { axis = "x", angle = 0.7 } }]] },
}

local steps = { rk4 = 64, split2 = 32, split4 = 8, split6 = 8, midpoint = 64, semi = 64 }

local function shell(...) return os.execute(string.format(...)) end

-- Names of the steppers that the scene takes.
local function taken(path)
  local list = {}
  local pipe = assert(io.popen(program .. " list methods"))
  for line in pipe:lines() do
    local name = string.match(line, "^%S+")
    if name ~= "exact" and name ~= "linearised" and
      shell("%s gen %s --layout single --method %s -o %s/try > %s/log 2>&1", program, path, name, dir, dir) then
      list[#list + 1] = name
    end
  end
  pipe:close()
  return list
end

local function measured(s)
  local path = dir .. "/top.lua"
  files.write(path, 'return scene { name = "top", ' .. s.text .. " }\n")
  local names, rows = taken(path), {}
  assert(shell("%s gen %s --layout single --method %s -o %s > %s/log", program, path, table.concat(names, ","), dir,
    dir))
  local header = files.read(dir .. "/top.h")
  for i, name in ipairs(names) do
    local runs = string.find(header, "top_" .. name .. "_run(", 1, true)
    local step = string.find(header, "top_" .. name .. "_step(", 1, true) and "top_" .. name .. "_step" or "top_step"
    rows[i] = string.format('{"%s", %d, %s, %s},\n', name, runs and 0 or steps[name] or 32, step,
      runs and "top_" .. name .. "_run" or "NULL")
  end
  files.write(dir .. "/steppers.h", table.concat(rows))
  assert(shell("cc -std=c11 -O2 -DMOMENTUM=%d -I%s tests/bench/drift.c %s/top.c -o %s/drift -lm", s.momentum, dir, dir,
    dir))
  local out = {}
  local pipe = assert(io.popen(string.format("%s/drift %.17g %d", dir, load("return " .. s.period)(), turns)))
  for line in pipe:lines() do
    local cells = {}
    for w in string.gmatch(line, "%S+") do cells[#cells + 1] = w end
    if cells[2] == "0" then cells[2] = "own" end
    out[#out + 1] = "| " .. table.concat(cells, " | ") .. " |"
  end
  assert(pipe:close())
  return table.concat(out, "\n")
end

assert(shell("mkdir -p %s", dir))
local text = {}
for _, s in ipairs(scenes) do
  text[#text + 1] = s.title .. "; " .. string.format("%.0f", turns) .. " revolutions:\n\n" ..
    "| method | steps | energy, first | energy, last | momentum, first | momentum, last | norm of q |\n" ..
    "|---|---|---|---|---|---|---|\n" .. measured(s) .. "\n"
end
text = table.concat(text, "\n")
io.stdout:write(text)
if page then
  local old = files.read(page)
  local a, b = string.find(old, "<!-- drift -->\n", 1, true), string.find(old, "<!-- end of drift -->", 1, true)
  assert(a and b, page .. " must have both marks")
  files.write(page, string.sub(old, 1, a - 1) .. "<!-- drift -->\n\n" .. text .. "\n" .. string.sub(old, b))
end
