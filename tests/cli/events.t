#!/usr/bin/env lua5.4
-- events.t - zero crossings along `polhode run`: when, which, in what form, and what is refused.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- True times: a body that spins about its axis at rate w has qw = cos(w t/2), qz = sin(w t/2); a stone thrown up at v
-- has rz = v t - g t^2/2.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local binary = program.quick()
local dir = program.directory()

local function run(text, more)
  program.write(dir .. "/s.lua", text)
  os.remove(dir .. "/events.csv")
  local happens = text:find("when =", 1, true) and not (more or ""):find "json"
  local code, csv, log = program.output(string.format("POLHODE_SOURCE=. %s run %s/s.lua %s %s", binary, dir, more or "",
    happens and "--events " .. dir .. "/events.csv" or ""))
  local found = happens and program.read(dir .. "/events.csv")
  return code, csv .. (found and "\n" .. found or ""), log
end

-- Of rows and, behind an empty line, events: {name, t, row (numbers by column)} ..., and the rows.
local function events(csv)
  local first, second = string.match(csv, "^(.-\n)\n(.*)$")
  local list, rows, names = {}, {}, {}
  for line in string.gmatch(second or "", "[^\n]+") do
    local cells = {}
    for cell in string.gmatch(line, "[^,]+") do cells[#cells + 1] = cell end
    if #names == 0 then
      names = cells
    else
      local row = {}
      for i = 2, #cells do row[names[i]] = tonumber(cells[i]) end
      list[#list + 1] = { name = cells[1], t = tonumber(cells[2]), row = row }
    end
  end
  for line in string.gmatch(first or "", "[^\n]+") do rows[#rows + 1] = line end
  return list, rows, names
end

local function spin(list, more)
  return 'local limit = param("limit", 0.5, nil)\nreturn scene { name = "spin", body = solid.box { x = 1, ' ..
    "y = 2, z = 3, mass = 1 }, initial = { omega = {0, 0, 2} }, time = { horizon = 10, step = 0.01 },\n" ..
    "  events = { " .. list .. " }" .. (more or "") .. " }\n"
end

local U = 2.0 ^ -52
local function near(got, want) return got and math.abs(got - want) <= 4 * U * want end

-- ---- when ----

-- q of an engine is good to its tolerance, 1e-12 over 10 s, or to rounding
for _, c in ipairs { { "", 1e-12 }, { "--engine generated", 8 * U }, { "--engine generated --method taylor", 1e-12 },
  { "--engine general --method exact", 8 * U }, { "--tolerance 1e-15", 1e-13 } } do
  local code, csv, log = run(spin('{ name = "half", when = qw }, { name = "tilt", when = qz - limit, direction = 1 }'),
    c[1])
  local list = events(csv)
  local want = {}
  for k = 0, 2 do want[#want + 1] = { "half", math.pi / 2 + k * math.pi } end
  for k = 0, 1 do want[#want + 1] = { "tilt", math.pi / 6 + 2 * k * math.pi } end
  table.sort(want, function(a, b) return a[2] < b[2] end)
  local ok, worst = code == 0 and #list == #want, 0.0
  for i, w in ipairs(want) do
    ok = ok and list[i] and list[i].name == w[1]
    worst = math.max(worst, ok and math.abs(list[i].t - w[2]) / w[2] or math.huge)
  end
  tap.ok(ok and worst <= c[2], string.format("run %s: five crossings, the worst off by %.2g of t", c[1], worst),
    csv .. log)
end

do
  local stone = 'return scene { name = "stone", body = solid.sphere { r = 1, mass = 2 }, effects = { ' ..
    "effect.translation { gravity = {0, 0, -8} } }, initial = { velocity = {1, 0, 12} }, time = { horizon = 9, " ..
    "step = 0.01 },\n events = { { name = \"top\", when = vz }, { name = \"ground\", when = rz, direction = -1, " ..
    "stop = true } } }\n"
  local code, csv, log = run(stone, "--every 1")
  local list, rows = events(csv)
  tap.ok(code == 0 and #list == 2 and list[1].name == "top" and near(list[1].t, 1.5) and list[2].name == "ground" and
    near(list[2].t, 3), "a stone's top and its return, which ends the run", csv .. log)
  tap.ok(list[1] and math.abs(list[1].row.rz - 9) <= 36 * U, "the row of an event is the state there", csv)
  tap.ok(#rows == 5 and string.match(rows[5], "^3%.0,") or string.match(rows[5] or "", "^2%.99999999999999"),
    "the table ends with the event that stops", csv)
end

-- ---- which ----

local function names(list)
  local _, csv, log = run(spin(list))
  local out = {}
  for i, e in ipairs((events(csv))) do out[i] = string.format("%s@%.3f", e.name, e.t) end
  return table.concat(out, " "), csv .. log
end
local function same(list, want, what)
  local got, all = names(list)
  tap.ok(got == want, what .. ": " .. got, all)
end
same('{ name = "a", when = qw, direction = -1 }', "a@1.571 a@7.854", "falling")
same('{ name = "a", when = qw, direction = 1 }', "a@4.712", "rising")
same('{ name = "a", when = qw, direction = 0 }', "a@1.571 a@4.712 a@7.854", "both")
same('{ name = "a", when = qz }', "a@3.142 a@6.283 a@9.425", "a zero at the start is no crossing")
same('{ name = "a", when = qw }, { name = "b", when = 2*qw }', "a@1.571 b@1.571 a@4.712 b@4.712 a@7.854 b@7.854",
  "two at once, in the order of the scene")
same('{ name = "a", when = t - 3 }', "a@3.000", "time alone, a zero on the grid")
same('{ name = "a", when = qw*qw }', "", "touching zero is no crossing")
same('{ name = "a", when = qx }', "", "what stays zero has none")
same('{ name = "a", when = (t - 3.001)*(t - 3.009) }', "", "two crossings within one step are not seen")
same('{ name = "a", when = (t - 3.001)*(t - 3.011) }', "a@3.001 a@3.011", "in two steps they are")
same('{ name = "a", when = sqrt(t - 5) - 1 }', "a@6.000", "before 5 it is not a number")
same('{ name = "a", when = 1/(t - 3.003) }', "", "a pole is no crossing")
same('{ name = "a", when = (t - 5)*sqrt((t - 4)*(t - 6)) }', "", "across where it is not a number there is none")
same('{ name = "a", when = (t - 3)^3 }', "a@3.000", "a triple zero is found, to the last interval")

-- ---- form ----

do
  local _, csv = run(spin '{ name = "a", when = qx }')
  local list, _, head = events(csv)
  tap.ok(#list == 0 and head[1] == "event" and head[2] == "t",
    "without a crossing the table of events has its head alone")
  local _, json = run(spin '{ name = "a", when = qw }', "--format json --every 5")
  tap.ok(string.find(json, '"events": [\n    {\n      "name": "a",\n      "row": [1.570796326794', 1, true),
    "JSON has them under events", json)
  local code, plain, log = run(spin "", "--events " .. dir .. "/events.csv")
  tap.ok(code == 2 and plain == "" and log:find("--events: nothing happens on the way", 1, true),
    "a scene without events has no table of them", log)
  code, _, log = run(spin '{ name = "a", when = qw }', "--format json --events " .. dir .. "/events.csv")
  tap.ok(code == 2 and log:find("JSON has the events", 1, true), "nor has JSON beside its own", log)
  code = program.shell(string.format("POLHODE_SOURCE=. %s run %s/s.lua --every 5 >%s/csv 2>%s/log", binary, dir, dir,
    dir))
  csv, log = program.read(dir .. "/csv"), program.read(dir .. "/log")
  tap.ok(code == 0 and select(2, csv:gsub("\n", "")) == 4 and not csv:find "event" and
    log:find("event a at t = 1.57079633 s\nevent a at t = 4.71238898 s\nevent a at t = 7.85398163 s\n", 1, true),
    "without a file for them events are named on standard error, and the rows are a table that all readers take",
    csv .. log)
end

-- ---- refused ----

for _, c in ipairs {
  { '{ name = "a", when = 3 }', 's.lua:3: events[1]: when must depend on t or on states, got 3' },
  { '{ name = "a", when = function() end }', "s.lua:3: events[1]: when must be a number, got a function" },
  { '{ name = "2a", when = qw }', "s.lua:3: events[1]: name must be a C identifier" },
  { '{ name = "a", when = qw }, { name = "a", when = qx }', "s.lua:3: events[2]: name is given twice" },
  { '{ name = "a", when = qw, direction = 2 }', "s.lua:3: events[1]: direction must be 1, -1 or 0, got 2" },
  { '{ name = "a", when = qw, stop = 1 }', "s.lua:3: events[1]: stop must be true or false, got 1" },
  { '{ name = "a", when = qw, until_then = 1 }', 's.lua:3: events[1]: unknown argument "until_then"' },
  { "qw", "s.lua:3: events[1]: must be a table {name =, when =, direction =, stop =}" },
} do
  local code, csv, log = run(spin(c[1]))
  tap.ok(code ~= 0 and csv == "" and string.find(log, c[2], 1, true), c[2], log)
end
do
  local code, csv, log = run(spin('{ name = "a", when = qw }', ', outputs = { "rates" }'))
  tap.ok(code == 1 and csv == "" and string.find(log, "s.lua:3: event a: when must be made of parameters and what " ..
    "this scene has: t, wx, wy, wz, energy, speed, got qw\n", 1, true),
    "an event does not bring states into a scene", log)
end

-- ---- what else events know ----

-- A ball slides with Coulomb's friction mu: v = v0 - mu g t, r w = 5/2 mu g t, so the slip is v0 - 7/2 mu g t (Coulomb,
-- Coriolis).  The smoothing e makes mu e^2/(2 slip^2) of it less: at a slip of v0/4 of 2 m/s and 1e-5 m/s below 1e-9.
local cue = [[
local r = param("r", 0.03, "m")
return scene { name = "cue", body = solid.sphere { r = r, mass = 0.17 }, effects = { effect.plane {
  surface = contact.sphere { r = r }, law = "sliding", friction = { coulomb = 0.2, smoothing = 1e-5 } } },
  initial = { velocity = { 2, 0, 0 } }, time = { horizon = 0.25 }, events = { EVENTS } }
]]
local function cued(list, more) return run((cue:gsub("EVENTS", list)), more) end
do
  local code, csv, log = cued('{ name = "slip", when = slip - quantity(0.5, "m/s") }, ' ..
    '{ name = "both", when = v1 - r*wy - 0.5 }, { name = "x", when = slip_x - 0.5 }, ' ..
    '{ name = "far", when = p1 - 0.2 }, ' ..
    '{ name = "N", when = N*t - 0.17*9.80665*0.1 }, { name = "up", when = height*t - 0.0045 }')
  local at = {}
  for _, e in ipairs(events(csv)) do at[e.name] = e.t end
  local g = 9.80665
  local slid = 1.5 / (3.5 * 0.2 * g)
  local far = (2 - math.sqrt(4 - 2 * 0.2 * g * 0.2)) / (0.2 * g)
  for _, c in ipairs { { "slip", slid }, { "both", slid }, { "x", slid }, { "far", far }, { "N", 0.1 },
    { "up", 0.15 } } do
    tap.ok(code == 0 and at[c[1]] and math.abs(at[c[1]] - c[2]) < 1e-8,
      "an event of " .. c[1] .. " at " .. c[2] .. " s: states and quantities of a body on a plane", at[c[1]] or log)
  end
  code, csv, log = cued '{ name = "a", when = wheel - 1 },\n{ name = "b", when = omega_frame_x*rz }'
  local has = "when must be made of parameters and what this scene has: t, qw, qx, qy, qz, wx, wy, wz, p1, p2, " ..
    "v1, v2, energy, speed, omega_inertial_x .. z, Lx .. z"
  tap.ok(code == 1 and csv == "" and log:find("s.lua:4: event a: " .. has, 1, true) and
    log:find("got wheel\n", 1, true) and log:find("got omega_frame_x\n", 1, true) and log:find("got rz\n", 1, true),
    "what the scene has not is named, all of it, beside what it has", log)
  code, csv, log = cued('{ name = "low", when = height - 2*r }, { name = "a", when = "N" }', "")
  tap.ok(code == 1 and csv == "" and log:find("s.lua:4: events[2]: when", 1, true), "a name as text is none", log)
end
-- In the air, too: a ball falls from 0.5 m to 0.1 m in sqrt(2*0.4/g), and is on the plane after its bounces.
do
  local code, csv, log = run [[
return scene { name = "ball", body = solid.sphere { r = 0.02, mass = 0.1 }, effects = { effect.plane {
  surface = contact.sphere { r = 0.02 }, law = "smooth", impact = { restitution = 0.2 } },
  effect.translation { gravity = 9.81 } }, initial = { position = { 0, 0, 0.5 } }, time = { horizon = 0.6 },
  events = { { name = "low", when = height - 0.1, direction = -1 }, { name = "lies", when = N - 0.5 } } }
]]
  local at = {}
  for _, e in ipairs(events(csv)) do at[e.name] = at[e.name] or e.t end
  tap.ok(code == 0 and at.low and math.abs(at.low - math.sqrt(0.8 / 9.81)) < 1e-12 and
    math.abs(at.lies - at.landing) < 1e-9,
    "height and N of a body that flies and lands", log .. tostring(at.low) .. " " .. tostring(at.lies) .. " " ..
    tostring(at.landing))
end

program.finish()
tap.done()
