#!/usr/bin/env lua5.4
-- happenings.t - what each command says of what can happen to a motion: the table of docs/happenings.md, cell by cell.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The page says what is to come, this file provokes it.  When it happens is known by other roads: a sphere whose rate
-- grows by its square, w = 1/(1 - t); a tensor diag(10 - a t, 10 - a t, 5), a body's until 20 - 2 a t = 5; of a member,
-- the time at which the library's run ends.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local root = io.popen("pwd"):read "l"
local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = root .. "/" .. binary end
local dir = program.directory()

-- ---- scenes ----

local MEASURE = "measure = { wx = wx, wy = wy, wz = wz, sigma = 0.01 }, "
local function scene(name, text)
  program.write(dir .. "/" .. name .. ".lua",
    (text:gsub("return scene {", "return scene { name = \"" .. name .. "\", " .. MEASURE)))
end

scene("lost", [[return scene { body = tensor { mass = param("m", 0.3, "kg"), xx = 3e-5, yy = 3.2e-4, zz = 3.3e-4 },
  effects = { effect.plane { surface = contact.ellipsoid { a = .03, b = .10, c = .02, at = { 0, 0, .004 },
  turned = { axis = "z", angle = .15 } } } },
  initial = { omega = { 25, 10, -25 } }, time = { horizon = 0.02, step = 1e-4 } }]])
local function disc(friction, omega, angle, step)
  return string.format([[return scene {
  body = solid.cylinder { r = 0.0375, h = 0.0128, mass = param("m", 0.4387, "kg") },
  effects = { effect.plane { surface = contact.disc { r = 0.0311, edge = 0.0064 }%s } },
  initial = { omega = {%s}, attitude = { axis = "x", angle = %s } }, time = { horizon = 0.2, step = %s } }]], friction,
    omega, angle, step)
end
scene("falls", disc("", "0, 0, 0", "0.3", "1e-3"))
scene("settles", disc(", rolling_resistance = { coulomb = 4e-3, smoothing = 0.1 }", "0.2, 0, 20", "0.1", "5e-4"))
local BOX = "body = solid.box { x = .1, y = .2, z = .3, mass = param(\"m\", 1, \"kg\") }, "
local function damped(stop, start, step, horizon)
  return "return scene { " .. BOX .. "effects = { effect.damping { rate = 0.5 } }, initial = { omega = {0, 0, " ..
    start .. "} }, " .. stop .. "time = { horizon = " .. horizon .. ", step = " .. step .. " } }"
end
scene("stops", damped("events = { { name = \"half\", when = wz - 0.5, stop = true } }, ", "1", "0.01", "2"))
scene("passes", damped("events = { { name = \"half\", when = wz - 0.5 } }, ", "1", "0.01", "2"))
scene("fast", damped("", "470", "0.01", "2"))
scene("outside", damped("ranges = { omega = 0.5 }, ", "1", "0.01", "2"))
scene("rests", [[return scene { body = solid.sphere { r = 0.03, mass = param("m", 0.2, "kg") },
  effects = { effect.plane { surface = contact.sphere { r = 0.03 }, law = "sliding",
  friction = { coulomb = 0.2, smoothing = 0.1 } } },
  initial = { velocity = {1.2, 0, 0}, omega = {0, -100, 0} }, time = { horizon = 1, step = 0.01 } }]])
scene("ceases", [[local a = param("a", 1.2, "kg m^2/s")
  return scene { body = tensor { mass = 50, xx = 10, yy = 10, zz = 5 },
  effects = { effect.inertia_rate { xx = -a*t, yy = -a*t } }, initial = { omega = { 0.3, 0, 5 } },
  time = { horizon = 7, step = 0.001 } }]])
scene("blows", [[local k = param("m", 1, "kg m^2")
  return scene { body = solid.sphere { r = 0.1, mass = 250 },
  effects = { effect.custom { params = { gain = k }, torque = function(s) return { s.gain*s.w[1]^2, 0, 0 } end } },
  initial = { omega = { 1, 0, 0 } }, time = { horizon = 2, step = 0.01 } }]])
scene("driven", "return scene { " .. BOX .. [[effects = { effect.torque { body = { input("u", "N m"), 0, 0 } } },
  initial = { omega = { 0, 0, 1 } }, time = { horizon = 2, step = .01 } }]])
program.write(dir .. "/short.csv", "t,u\n0,0.001\n1,0.002\n")
do
  local list = { "t,wx,wy,wz" }
  for i = 0, 200 do list[#list + 1] = string.format("%g,%g,%g,%g", i / 100, 0.01 * (i % 2), 0.01 * (i % 3), 1) end
  program.write(dir .. "/log.csv", table.concat(list, "\n") .. "\n")
end

-- ---- doors ----

-- Each command as it is asked.  A warning comes before the code is compiled: where the rest would take long, `false` is
-- the compiler.
local DOORS = {
  run = "run %s.lua%s -o out.csv", plot = "plot %s.lua%s -o out.svg",
  view = "view %s.lua%s --format glb -o out.glb", bench = "bench %s.lua --no-peers --method rk4 -o out%s",
  ["gen --accuracy"] = "gen %s.lua --accuracy 1e-6 -o out%s", fit = "fit %s.lua --data log.csv --free m%s",
  design = "design %s.lua --free m%s", check = "check %s.lua --real double --states 1%s" }
local LONG = { bench = true, ["gen --accuracy"] = true, fit = true, design = true, check = true }

-- Of each row of the page: the scene, what it says, and more words of some commands.
local CEASE = "must be a body's tensor up to t = [%d.]+ s: from t = 6.25 s on"
local ROWS = {
  ["contact is lost"] = { "lost", "contact is lost.*the plane would have to pull", view = "contact is lost before" },
  ["a disc falls flat"] = { "falls", "the disc has fallen flat" },
  ["a disc settles flat"] = { "settles", "the disc has settled flat", more = { run = " --engine generated" } },
  ["an event with `stop`"] = { "stops", "event half", sweep = "event half %(line %d+%) does not end the motion" },
  ["an event without `stop`"] = { "passes", "event half" },
  ["the body comes to rest"] = { "rests", "event at_rest" },
  ["moving parts make the tensor no body's"] = { "ceases", CEASE, over = "a=1:1.2" },
  ["the same of a member alone"] = { "ceases", "is no body's tensor", over = "a=1:1.2",
    more = { sweep = " --set a=1" } },
  ["the state is not finite"] = { "blows", "not finite", plot = "t = 1 s", run = "t = 1 s", view = "t = 1 s",
    bench = "no reference: at t = 1", ["gen --accuracy"] = "cannot follow the motion", check = "not ok.*t = 1",
    fit = "chi%-square [^\n]*a probability of 0" },
  ["a step is too long: |q| is not 1"] = { "fast", "the step is too long",
    more = { run = " --engine generated --method rk4", plot = " --engine generated --method rk4" } },
  ["no `--input` for the inputs"] = { "driven", "inputs are 0: u", fit = "has no column u",
    design = "the scene has inputs" },
  ["the file of `--input` ends early"] = { "driven", "short.csv ends at t = 1 s: its last row holds to t = 2 s",
    more = { run = " --input short.csv", plot = " --input short.csv", view = " --input short.csv" } },
  ["the scene itself is outside its `ranges`"] = { "outside", "ranges: wz of the scene itself" },
}

-- Status, standard output and error.
local function ask(words, without)
  local status = program.shell(string.format("cd %s && %s POLHODE_SOURCE=%s XDG_CACHE_HOME=%s/cache nice -n 5 %s %s " ..
    ">stdout 2>stderr", dir, without and "CC=false" or "", root, dir, binary, words))
  return status, program.read(dir .. "/stdout"), program.read(dir .. "/stderr")
end

local function asked(door, row, word)
  local more = row.more and row.more[door] or ""
  if door == "sweep" then
    local values = row.over and { row.over:match "^(%w+)=([%d.]+):([%d.]+)$" } or { "m", "1", "1.5" }
    return ask(string.format("sweep %s.lua --over %s=%s:%s:2 --keep 'final: wx'%s", row[1], values[1], values[2],
      values[3], more))
  end
  return ask(string.format(DOORS[door], row[1], more), LONG[door] and word ~= "refuses")
end

-- Is what came what the word of the page promises?
local MEANINGS = {
  ends = function(status, _, err, said)
    return status == 0 and err:find("warning: " .. said) and err:find "ends there"
  end,
  tells = function(status, _, err, said) return status == 0 and err:find(said .. " at t = ") end,
  status = function(status, out, _, said)
    return status == 0 and out:find("\n%d,[^\n]*nan,[^\n]*" .. said) and not out:find "internal"
  end,
  warns = function(_, _, err, said) return err:find("warning: [^\n]*" .. said) end,
  refuses = function(status, out, err, said)
    return status ~= 0 and status < 70 and (out .. err):find(said)
  end,
  ["-"] = function(_, out, err, said) return not (out .. err):find(said) end,
}

-- ---- the table ----

local doors, seen, cells = nil, {}, 0
for line in program.read("docs/happenings.md"):gmatch "[^\n]+" do
  local list = {}
  for cell in line:sub(2):gsub("\\|", "\1"):gmatch "%s*([^|]*)|" do
    list[#list + 1] = cell:gsub("%s+$", ""):gsub("\1", "|")
  end
  local row = ROWS[list[1]]
  if list[1] == "what happens" and not doors then
    doors = list
  elseif row and doors and not seen[list[1]] then
    seen[list[1]] = true
    for k = 2, #doors do
      local door, word = doors[k]:gsub("`", ""), list[k]
      if word and word ~= "" then
        local status, out, err = asked(door, row, word)
        local said = row[door] or row[2]
        tap.ok(MEANINGS[word] and MEANINGS[word](status, out, err, said), list[1] .. ", " .. door .. ": " .. word,
          string.format("status %s\n%s%s", status, out:sub(1, 400), err:sub(1, 600)))
        cells = cells + 1
      end
    end
  end
end
for name in pairs(ROWS) do tap.ok(seen[name], "the page has the row: " .. name) end
tap.ok(doors and #doors == 10 and cells >= 90, "the page has all commands", tostring(cells))

-- ---- when ----

do -- exp(-t/2) is a half at 2 ln 2; 1e-9 is more than the tolerance of the library and of the event's search
  local _, _, err = ask "run stops.lua -o out.csv"
  local last = tonumber((program.read(dir .. "/out.csv") or ""):match "\n([^,\n]+),[^\n]*\n$")
  tap.ok(last and math.abs(last - 2 * math.log(2)) < 1e-9, "rows end where an event stops the run", err)
end

-- A member is fine up to the time at which the library's run ends, and not two steps later.
for _, case in ipairs { { "lost", 1e-4, "contact is lost", 0.3 }, { "falls", 1e-3, "fallen flat", 0.4387 } } do
  local _, _, err = ask("run " .. case[1] .. ".lua -o out.csv")
  local t = tonumber(err:match "at t = ([%d.e-]+) s") or 0 / 0
  for _, side in ipairs { -2, 2 } do
    local _, out = ask(string.format("sweep %s.lua --over m=%g:%g:2 --keep 'final: wx' --until %.17g", case[1], case[4],
      case[4] + 1e-5, t + side * case[2]))
    tap.ok((out:find(case[3], 1, true) ~= nil) == (side > 0) and (out:find ",ok\n" ~= nil) == (side < 0),
      case[1] .. ": a member " .. (side < 0 and "before" or "after") .. " the time of the run's end", out)
  end
end
-- a = 1: a body's until 7.5 s; a = 1.2: until 6.25 s
for _, case in ipairs { { 6.2, "ok", "ok" }, { 6.3, "ok", "I + D" }, { 7.6, "I + D", "I + D" } } do
  local _, out = ask(string.format("sweep ceases.lua --set a=0.5 --over a=1:1.2:2 --keep 'final: wx' --until %g",
    case[1]))
  local first, second = out:match "\n0,1,[^,]+,([^\n]+)\n1,1.2,[^,]+,([^\n]+)\n"
  tap.ok(first and first:find(case[2], 1, true) == 1 and second:find(case[3], 1, true) == 1,
    "members whose parts move, until " .. case[1] .. " s", out)
end

tap.done(program.finish())
