#!/usr/bin/env lua5.4
-- asking.t - what `polhode run` answers does not depend on how one asks.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each scene is asked for its state at the time T alone, and then otherwise: with other rows before and after, by
-- --until and --every, with other columns, as JSON, with its parameters and effects written in another order, from the
-- state at T/2 on, by other methods of the library, and by the emitted code.  The answers are those of one motion, so
-- they agree to what the methods' tolerances let through.  Scenes: those that are installed, random ones of two to five
-- effects (tests/effects/scenes.lua), and some whose equations have corners and jumps.
-- POLHODE_SCENES=300 POLHODE_SEED=7: so many random ones, from that seed.

package.path = "./?.lua;" .. package.path

local json = require "tests.json"
local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local scenes = require "tests.effects.scenes"

local dir = program.directory()
local polhode = program.quick()
local count = tonumber(os.getenv "POLHODE_SCENES") or 24
local seed = tonumber(os.getenv "POLHODE_SEED") or 5

-- Over some radians errors grow as neighbouring motions part, by less than GROWTH.  The library's default is near the
-- rounding of 64 bits, its results are doubles; a tolerance is that of a step, and there are some hundred of them.
local GROWTH = 1e4
local DEFAULT, TOLERANCE = 1e-16 * GROWTH, 1e-12 * GROWTH * 100

-- The rows of a run as tables {column = number}, or nil and what was said.
local function run(path, how)
  local status, out, err = program.output(string.format("timeout 100 %s run %s %s", polhode, path, how))
  if status ~= 0 then return nil, how .. ": " .. status .. " " .. err end
  local list, names = {}, {}
  if how:find "json" then
    local read = json.read(out)
    for i, cells in ipairs(read.rows) do
      list[i] = {}
      for k, name in ipairs(read.columns) do list[i][name] = cells[k] end
    end
    return list, how
  end
  for line in (out:match "^(.-\n)\n" or out):gmatch "[^\n]+" do
    local row, k = {}, 0
    for cell in line:gmatch "[^,]+" do
      k = k + 1
      if #names < k and not tonumber(cell) then names[k] = cell else row[names[k]] = tonumber(cell) end
    end
    if next(row) then list[#list + 1] = row end
  end
  return list, how
end

local function at(rows, t)
  for _, row in ipairs(rows or {}) do
    if math.abs(row.t - t) <= 1e-12 * t then return row end
  end
end

local KINDS = { { "qw", "qx", "qy", "qz" }, { "wx", "wy", "wz" }, { "rx", "ry", "rz" }, { "vx", "vy", "vz" } }

-- The largest difference of two rows, each kind of state by its size in `size`; infinite if a number is missing.
local function distance(a, b, size)
  local worst = 0.0
  for _, kind in ipairs(KINDS) do
    local most, off = 0.0, 0.0
    for _, c in ipairs(kind) do
      if size[c] then
        most = math.max(most, math.abs(size[c]))
        local d = a[c] and b[c] and math.abs(a[c] - b[c]) or math.huge
        off = d ~= d and math.huge or math.max(off, d)
      end
    end
    if off > 0 then worst = math.max(worst, off / most) end
  end
  return worst
end

local function number(x) return string.format("%.17g", x) end

-- ways: a list of {how, bound[, path]}; one scene at the time T.
local function ask(name, path, T, ways, said)
  local rows, why = run(path, "--at " .. number(T))
  local base = at(rows, T)
  if not base then
    tap.ok(said and why:find(said), name .. ": has an answer", why)
    return
  end
  local bad, worst = {}, 0.0
  for _, way in ipairs(ways) do
    local got, how = run(way[3] or path, way[1])
    local row = at(got, T)
    local d = row and distance(row, base, base) or math.huge
    worst = math.max(worst, d / way[2])
    local fine = d <= way[2] -- false of NaN
    if not fine then
      bad[#bad + 1] = string.format("%s: off by %.3g, %.3g is allowed", how, d, way[2])
    end
  end
  tap.ok(#bad == 0, string.format("%s: %d ways, one answer", name, #ways), table.concat(bad, "\n"))
end

-- How else the same can be asked; compiled: the emitted code, too.
local function ways_of(T, compiled)
  local list = {
    { "--at " .. number(T / 7) .. "," .. number(T), DEFAULT },
    { "--at " .. number(T * 0.337) .. "," .. number(T * 0.9999) .. "," .. number(T), DEFAULT },
    { "--until " .. number(T) .. " --every " .. number(T / 32), DEFAULT },
    { "--until " .. number(T) .. " --every " .. number(T / 2) .. " --columns 'states, t'", DEFAULT },
    { "--at " .. number(T) .. "," .. number(T * 1.25), DEFAULT },
    { "--at " .. number(T) .. " --format json", DEFAULT },
    { "--at " .. number(T) .. " --tolerance 1e-14", 1e-14 * GROWTH * 10 },
    { "--at " .. number(T) .. " --method rk8pd --tolerance 1e-13", TOLERANCE },
  }
  if compiled then
    list[#list + 1] = { "--at " .. number(T) .. " --engine generated --method adaptive --tolerance 1e-12", TOLERANCE }
    list[#list + 1] = { "--at " .. number(T / 3) .. "," .. number(T) ..
      " --engine generated --method adaptive --tolerance 1e-12", TOLERANCE }
  end
  return list
end

-- ---- scenes with corners and jumps ----

local BODY = "tensor { mass = 1, xx = 1, yy = 1.2, zz = 1.5 }"
local function scene(effects, initial, first)
  return (first or "") .. "return scene { name = \"s\", body = " .. BODY .. ", effects = { " .. effects ..
    " }, initial = { " .. initial .. " } }"
end
local K = "local k = param(\"k\", 1, \"N m s\")\n"
for _, c in ipairs {
  { "|w| in a torque", scene("effect.torque { body = { -k*abs(wy), 0, k*abs(wx) } }", "omega = {-2.194, 2.085, 1.583}",
    K), 2 },
  { "|sin 3t| in a torque", scene("effect.torque { body = { 0, quantity(1, \"N m\")*abs(sin(3*t)), 0 } }",
    "omega = {1, 2, 3}"), 7 },
  { "a table in a torque", scene("effect.torque { body = { 0, {{0, 0}, {1, 1}, {1.5, -1}, {4, 0}}, 0 } }",
    "omega = {1, 2, 3}"), 5 },
  { "drag on the turning, through a rest of w", scene("effect.drag { c = 1 }, effect.torque { body = {-1, 0, 0} }",
    "omega = {2, 0, 0}"), 4 },
  { "drag on a stone thrown straight up", scene("effect.translation { gravity = 9, drag = 0.3 }",
    "omega = {1, 2, 3}, velocity = {0, 0, 0.5288}"), 2 },
  { "drag on a stone thrown all but straight up", scene("effect.translation { gravity = 9, drag = 0.3 }",
    "omega = {1, 2, 3}, velocity = {1e-7, 0, 4.5863}"), 2 },
  { "friction that is all but dry", scene("effect.friction { torque = 0.5, smoothing = 1e-6 }", "omega = {1, 2, 3}"),
    1.5 },
  { "two plates that turn their edges to the light", scene("effect.solar_pressure { flux = 1e8, sun = {1, 0, 0}, " ..
    "plates = { { area = 1, normal = {1, 0, 0}, centre = {0, 1, 0} }, { area = 1, normal = {1, 3e-4, 0}, " ..
    "centre = {0, 0, 1} } } }", "omega = {0.1, 0.2, 1}"), 6 },
} do
  local path = dir .. "/s.lua"
  program.write(path, c[2])
  ask(c[1], path, c[3], ways_of(c[3], true))
end

-- ---- installed scenes ----

local bodies = io.popen "ls bodies/*.lua"
local paths = {}
for path in bodies:lines() do paths[#paths + 1] = path end
bodies:close()
for _, path in ipairs(tier.every(8, paths)) do
  local text = program.read(path)
  local T = tonumber(text:match "horizon = ([%w.+-]+)") or 1
  -- chaos of a long motion is no matter of asking
  T = math.min(T / 4, 2)
  if not text:find "effect.plane" then ask(path:match "([%w_]+)%.lua", path, T, ways_of(T, false)) end
end

-- ---- random scenes ----

local random = scenes.new(seed, 0)
local done = 0

-- A scene's text with parameters and effects in the opposite order.
local function reversed(parts)
  local p = { effects = {}, body = parts.body, origin = parts.origin, initial = parts.initial }
  for i, e in ipairs(parts.effects) do p.effects[#parts.effects + 1 - i] = e end
  local lines = {}
  for line in parts.params:gmatch "[^\n]+\n" do table.insert(lines, 1, line) end
  p.params = table.concat(lines)
  return p
end

-- Variants without states of their own and without the time: the motion from one of its rows is the same motion.
local RESTART = { gravity = true, gravity_direction = true, damping = true, damping_principal = true,
  damping_matrix = true, damping_rate = true, torque_body = true, torque_inertial = true, rotor = true,
  rotor_fast = true, flight = true, flight_drag = true, flight_rates = true, drag = true, friction = true,
  spring = true, spring_rest = true, spring_axis = true, magnetic = true, eddy = true, eddy_upright = true,
  sunlight = true, custom_torque = true, custom_potential = true, frame = true, frame_upright = true, sink = true }

-- The scene that starts at the row; nil where it is not given by the row alone.
local function restarted(parts, list, row)
  for _, v in ipairs(list) do
    if not RESTART[v.name] then return nil end
  end
  local function vector(...)
    local cells = { ... }
    for i, c in ipairs(cells) do cells[i] = number(row[c]) end
    return "{" .. table.concat(cells, ", ") .. "}"
  end
  local initial = "attitude = " .. vector("qw", "qx", "qy", "qz") .. ", omega = " .. vector("wx", "wy", "wz")
  if row.rx then
    initial = initial .. ", position = " .. vector("rx", "ry", "rz") .. ", velocity = " .. vector("vx", "vy", "vz")
  end
  return scenes.joined("a", { params = parts.params, effects = parts.effects, body = parts.body,
    origin = parts.origin, initial = initial })
end

local restarts = 0
while done < count do
  local list, n = {}, 1 + random:random(4)
  for i = 1, n do list[i] = scenes.draw(random) end
  local origin, fits = scenes.fits(list)
  if fits then
    done = done + 1
    local body = ({ "diagonal", "symmetric", "full" })[random:random(3)]
    local parts = scenes.parts(scenes.new(seed + 7919*done, 0.75), body, list, origin)
    local path, other = dir .. "/a.lua", dir .. "/b.lua"
    program.write(path, scenes.joined("a", parts))
    program.write(other, scenes.joined("a", reversed(parts)))
    local ways = ways_of(1, done % 10 == 0)
    ways[#ways + 1] = { "--at 1", DEFAULT, other }
    ask("scene " .. done, path, 1, ways, "plane would have to pull")
    local row = at(run(path, "--at 0.5"), 0.5)
    local text = row and restarted(parts, list, row)
    if text then
      restarts = restarts + 1
      program.write(other, text)
      -- a row has doubles, and scenes read an attitude as it is: 1e-16 more than the default's own
      local whole, rest = at(run(path, "--at 1"), 1), at(run(other, "--at 0.5"), 0.5)
      local off = rest and distance(rest, whole, whole) or math.huge
      tap.ok(off <= 2 * DEFAULT, "scene " .. done .. ": from one of its rows on", "off by " .. off)
    end
  end
end

if count >= 20 then tap.ok(restarts * 20 >= count, restarts .. " scenes were started again") end

tap.done(program.finish())
