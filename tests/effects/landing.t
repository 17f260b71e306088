#!/usr/bin/env lua5.4
-- landing.t - a body that flies and lands: its lowest point, the impact, and the motion in the air and on the plane.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Impact: what emitted code and library make of random states is held to Newton's and Euler's laws of impulses, to the
-- law of Chatterjee and Ruina in words (restitution, cone of friction, no energy made), and to each other.
-- Motion: against closed forms of bouncing balls, and of a body that has left the plane.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local whole = require "tests.cli.whole"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

-- ---- the impact, by two roads and by its laws ----

local BODY = "tensor { mass = 2, xx = 0.02, yy = 0.03, zz = 0.04, xy = 0.001, xz = -0.002, yz = 0.003 }"
local I = { { 0.02, 0.001, -0.002 }, { 0.001, 0.03, 0.003 }, { -0.002, 0.003, 0.04 } }
local MASS = 2

-- surface, law, impact: its restitution and friction (math.huge: sticks).
local cases = {
  { "contact.sphere { r = 0.1 }", 'law = "smooth"', "{ restitution = 0.7 }", 0.7, 0 },
  { "contact.sphere { r = 0.1, at = {0.01, 0.02, 0.03} }", 'law = "sliding", friction = { viscous = 1 }',
    "{ restitution = 0.5, friction = 0.2, tangential = 0.4 }", 0.5, 0.2 },
  { "contact.ellipsoid { a = 0.1, b = 0.2, c = 0.05, turned = { axis = 'x', angle = 0.3 } }",
    'law = "sliding", friction = { coulomb = 0.3, smoothing = 1e-3 }, normal = {1, 2, 5}', "{ restitution = 0.9 }", 0.9,
    0.3 },
  { "contact.disc { r = 0.1, edge = 0.01 }", 'law = "rolling"', "{ restitution = 0.4 }", 0.4, math.huge },
  { "contact.sphere { r = 0.1, at = {0.01, 0, 0} }",
    'law = "sliding", friction = { coulomb = 5, smoothing = 1e-3 }, turntable = 3',
    "{ restitution = 1, tangential = -0.5 }", 1, 5 },
  { "contact.ellipsoid { a = 0.1, b = 0.2, c = 0.05 }", 'law = "sliding", friction = { coulomb = 0, smoothing = 1 }',
    "{ restitution = 0 }", 0, 0 },
}

local function scene_of(case, name)
  return string.format([[
return scene { name = %q, body = %s,
  effects = { effect.plane { surface = %s, %s, impact = %s }, effect.translation { gravity = 9 } },
  initial = { position = {0, 0, 1}, attitude = {0.9, 0.3, 0.2, 0.1} } }]], name, BODY, case[1], case[2], case[3])
end

local STATES = 200

-- The library's gaps and impacts of random states, as lines of numbers: x (13), gap (8), x after (13), impulse.
local function by_library(name)
  return whole(string.format([[
local numeric = require "generator.dynamics.numeric"
local job = assert(driver.read(host, args[1] .. "/%s.lua", { phase = "contact" }))
local library = assert(host.rates(numeric.scene(job)))
local plane
for _, e in ipairs(job.record.effects) do plane = e.kind == "effect.plane" and e or plane end
local a, law = plane.a.impact, { 0.0, math.huge, 0.0 }
law[1] = job.model:double(a.restitution)
if a.friction then law[2] = job.model:double(a.friction) end
if a.tangential then law[3] = job.model:double(a.tangential) end
local seed = 12345
local function random()
  seed = (seed * 1103515245 + 12345) %% 2147483648
  return seed / 1073741824 - 1
end
for n = 1, %d do
  local x, norm = {}, 0.0
  for i = 1, 13 do x[i] = random() * (i > 4 and 3 or 1) end
  for i = 1, 4 do norm = norm + x[i] * x[i] end
  for i = 1, 4 do x[i] = x[i] / math.sqrt(norm) end
  local gap = assert(library:gap(x))
  local after, impulse = library:impact(law, x)
  assert(after, impulse)
  local line = {}
  for _, list in ipairs { x, gap, after, { impulse } } do
    for _, v in ipairs(list) do line[#line + 1] = string.format("%%a", v) end
  end
  host.out(table.concat(line, " ") .. "\n")
end
]], name, STATES))
end

local MAIN = [[
#include "NAME.h"
#include <stdio.h>
int main(void) {
  NAME_model m;
  NAME_init(&m, NULL);
  double x[NAME_NX], v;
  int n = 0;
  while (scanf("%la", &v) == 1) {
    if (n < 13)
      x[n] = v;
    if (++n < 35)
      continue;
    n = 0;
    const double gap = NAME_gap(&m, x), impulse = NAME_impact(&m, x);
    printf("%a %a", gap, impulse);
    for (int i = 0; i < 13; i++)
      printf(" %a", x[i]);
    printf("\n");
  }
  return 0;
}
]]

local function numbers(line)
  local list = {}
  for word in line:gmatch "%S+" do list[#list + 1] = tonumber(word) end
  return list
end

local function by_code(name, lines)
  program.write(dir .. "/" .. name .. ".txt", lines)
  local upper = name:upper()
  local main = MAIN:gsub("NAME_NX", upper .. "_NX"):gsub("NAME_init%(&m, NULL%)", name .. "_init(&m, NULL)")
  program.write(dir .. "/main.c", (main:gsub("NAME", name)))
  local compile = (os.getenv "CC" or "cc") .. " -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror"
  local code = program.shell(string.format("%s gen %s/%s.lua --phase flight -o %s/%s 2>%s/err && cd %s && " ..
    "%s -I%s -o run main.c %s/%s.c -lm && ./run <%s.txt >%s.out", binary, dir, name, dir, name, dir, dir, compile,
    name, name, name, name, name))
  return code == 0 and program.read(dir .. "/" .. name .. ".out") or nil
end

local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end
local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end
local function norm(a) return math.sqrt(dot(a, a)) end
local function minus(a, b) return { a[1] - b[1], a[2] - b[2], a[3] - b[3] } end
local function part(list, from) return { list[from], list[from + 1], list[from + 2] } end
local function times(M, v) return { dot(M[1], v), dot(M[2], v), dot(M[3], v) } end

-- From body to inertial axes.
local function turned(q, v)
  local u = { q[2], q[3], q[4] }
  local a = cross(u, v)
  local b = cross(u, a)
  return { v[1] + 2 * (q[1] * a[1] + b[1]), v[2] + 2 * (q[1] * a[2] + b[2]), v[3] + 2 * (q[1] * a[3] + b[3]) }
end

-- The worst relative deviations from the laws of one state.
local function laws(worst, case, n, before, gap, after, impulse)
  local e, mu = case[4], case[5]
  local function note(name, x) worst[name] = math.max(worst[name] or 0, x == x and x or math.huge) end
  local q, d = { table.unpack(before, 1, 4) }, minus(part(gap, 3), part(before, 8))
  local slip, w0, w1 = part(gap, 6), part(before, 5), part(after, 5)
  local v0, v1 = part(before, 11), part(after, 11)
  local approach = dot(n, slip)
  if approach >= 0 then
    note("leaving", norm(minus(v1, v0)) + norm(minus(w1, w0)) + math.abs(impulse))
    return
  end
  local P = minus(v1, v0)
  for i = 1, 3 do P[i] = MASS * P[i] end
  local size, along = norm(P), dot(n, P)
  note("normal impulse", math.abs(along - impulse) / size)
  local turn = turned(q, times(I, minus(w1, w0)))
  note("angular impulse", norm(minus(turn, cross(d, P))) / (size * norm(d)))
  local across = math.sqrt(math.max(0, size * size - along * along))
  if mu < math.huge then note("cone", math.max(0, across - mu * along) / size) end
  local change = { 0, 0, 0 } -- of the slip
  local spin = turned(q, minus(w1, w0))
  for i = 1, 3 do change[i] = v1[i] - v0[i] + cross(spin, d)[i] end
  local left = { slip[1] + change[1], slip[2] + change[2], slip[3] + change[3] }
  if mu == 0 then note("restitution", math.abs(dot(n, left) + e * approach) / norm(slip)) end
  -- inside the cone P = (1 + e) P1 + (1 + e_t)(P2 - P1), with which the slip becomes e K P1 - e_t (v + K P1); of e = 0
  -- and e_t = 0 it is none
  if mu == math.huge and e == 0 then note("stick", norm(left) / norm(slip)) end
  local function energy(v, w) return MASS * dot(v, v) / 2 + dot(w, times(I, w)) / 2 end
  -- beside the plane's motion: of what the impulse does against the slip before and after
  local work = (dot(P, slip) + dot(P, left)) / 2
  note("energy made", math.max(0, work) / (size * norm(slip)))
  if case[2]:find "turntable" == nil then
    note("energy", math.abs(energy(v1, w1) - energy(v0, w0) - work) / energy(v0, w0))
  end
  if e == 1 and mu == 0 then note("elastic", math.abs(work) / (size * norm(slip))) end
end

-- Numbers of a few hundred operations on terms of one size, and a 3x3 system whose condition is below 100 here.
local MOST = 1e-12

local more = { -- the ends of the law
  { "contact.ellipsoid { a = 0.1, b = 0.2, c = 0.05 }", 'law = "smooth"', "{ restitution = 1 }", 1, 0 },
  { "contact.ellipsoid { a = 0.1, b = 0.2, c = 0.05 }", 'law = "rolling"', "{ restitution = 0 }", 0, math.huge },
}
for _, case in ipairs(more) do cases[#cases + 1] = case end

for k, case in ipairs(cases) do
  local name = "case" .. k
  program.write(dir .. "/" .. name .. ".lua", scene_of(case, name))
  local lines = by_library(name)
  local emitted = lines and by_code(name, lines)
  tap.ok(emitted, name .. ": emitted and compiled without a warning")
  local normal = case[2]:find "normal" and { 1, 2, 5 } or { 0, 0, 1 }
  local length = norm(normal)
  for i = 1, 3 do normal[i] = normal[i] / length end
  local next_line = (emitted or ""):gmatch "[^\n]+"
  local by_laws, of_code, roads, count, hits = {}, {}, 0, 0, 0
  for line in (lines or ""):gmatch "[^\n]+" do
    local list, code = numbers(line), numbers(next_line() or "")
    local before, gap = { table.unpack(list, 1, 13) }, { table.unpack(list, 14, 21) }
    local after, impulse = { table.unpack(list, 22, 34) }, list[35]
    laws(by_laws, case, normal, before, gap, after, impulse)
    laws(of_code, case, normal, before, gap, { table.unpack(code, 3, 15) }, code[2])
    local size = math.max(1, math.abs(impulse)) -- speeds of 1 m/s and lengths of 0.1 m: change 1 m/s and 10 rad/s
    for i = 1, 13 do
      roads = math.max(roads, math.abs(after[i] - (code[2 + i] or 0 / 0)) / size / (i > 4 and i < 8 and 10 or 1))
    end
    roads = math.max(roads, math.abs(gap[1] - (code[1] or 0 / 0)), math.abs(impulse - (code[2] or 0 / 0)) / size)
    count, hits = count + 1, hits + (impulse > 0 and 1 or 0)
  end
  tap.is(count, STATES, name .. ": the library takes every state")
  tap.ok(hits > STATES / 4, name .. ": " .. hits .. " of them are impacts")
  tap.ok(roads <= MOST, string.format("%s: emitted code and library agree, to %.1g", name, roads))
  for key, x in pairs(by_laws) do
    tap.ok(x <= MOST and of_code[key] <= MOST, string.format("%s: %s, to %.1g and %.1g", name, key, x, of_code[key]))
  end
end

-- ---- motions ----

-- The rows and events of a run: lists of {column = number}, events with their names.
local function run(name, text, options)
  program.write(dir .. "/" .. name .. ".lua", text)
  local code = program.shell(string.format("timeout 100 %s run %s/%s.lua %s --events %s/events >%s/out 2>%s/err",
    binary, dir, name, options, dir, dir, dir))
  if code ~= 0 then
    tap.diag(program.read(dir .. "/err"))
    return { {} }, { {} }
  end
  local tables, names = { {} }, nil
  for line in (program.read(dir .. "/out") .. "\n" .. program.read(dir .. "/events")):gmatch "([^\n]*)\n" do
    if line == "" then
      tables[#tables + 1], names = {}, nil
    elseif not names then
      names = {}
      for word in line:gmatch "[^,]+" do names[#names + 1] = word end
    else
      local row, i = {}, 0
      for word in line:gmatch "[^,]+" do
        i = i + 1
        row[names[i]] = tonumber(word) or word
      end
      table.insert(tables[#tables], row)
    end
  end
  return tables[1], tables[2]
end

local function close(got, want, most, name) tap.near(got or 0 / 0, want, 0, most, name, "argued beside its bound") end

-- A ball dropped from h: impact k at t0 (1 + 2 (e + .. + e^(k-1))), t0 = sqrt(2 h/g), the speed after it e^k v0; it
-- rests after t0 (1 + e)/(1 - e).  Bounds: a time is known to a few roundings of itself and of the height 0.02 m over
-- the speed; the end to the rise that is lost in 64 roundings of that height, 2 v/g/(1 - e) with v = 7.5e-8 m/s.
local e, h, g = 0.5, 0.5, 9.81
local t0, v0 = math.sqrt(2 * h / g), math.sqrt(2 * h * g)
for _, engine in ipairs { "general", "generated" } do
  local rows, found = run("drop", [[
return scene { name = "drop", body = solid.sphere { r = 0.02, mass = 0.1 },
  effects = { effect.plane { surface = contact.sphere { r = 0.02 }, law = "smooth", impact = { restitution = 0.5 } },
    effect.translation { gravity = 9.81 } },
  initial = { position = { 0, 0, 0.52 } }, time = { step = 0.01, horizon = 1.5 } }]],
    "--columns t,rz,vz,N,energy --every 0.5 --engine " .. engine)
  local t = t0
  for k = 1, 20 do
    local known = 1e-14 + 16 * 2.0 ^ -53 * 0.02 / (e ^ (k - 1) * v0)
    close(found[k].t, t, known, engine .. ": time of impact " .. k)
    close(found[k].vz, e ^ k * v0, g * known + 1e-15 * v0, engine .. ": speed after it")
    t = t + 2 * e ^ k * t0
  end
  tap.is(found[#found].event, "landing", engine .. ": it comes to rest")
  close(found[#found].t, t0 * (1 + e) / (1 - e), 2 * 7.5e-8 / g / (1 - e), engine .. ": when")
  close(rows[#rows].N, 0.1 * g, 1e-15, engine .. ": then the plane carries its weight")
  close(rows[#rows].energy, 0.1 * g * 0.02, 1e-15, engine .. ": and its energy is that of its height")
  tap.is(rows[1].N, 0.0, engine .. ": in the air there is no reaction")
end

-- A solid ball that meets the plane at v_z with the slip s = v_x - R w: stuck the slip is gone (2/7 of it comes from
-- v_x); sliding, the impulse across is mu (1 + e) v_z; a superball (Garwin 1969) reverses the slip.
local function oblique(name, impact, mu, want)
  local _, found = run(name, string.format([[
return scene { name = %q, body = solid.sphere { r = 0.1, mass = 1 },
  effects = { effect.plane { surface = contact.sphere { r = 0.1 }, law = "sliding",
      friction = { coulomb = %g, smoothing = 0.01 }, impact = %s }, effect.translation { gravity = 10 } },
  initial = { position = { 0, 0, 0.3 }, velocity = { 3, 0, 0 }, omega = { 0, 10, 0 } },
  time = { step = 0.01, horizon = 0.3 } }]], name, mu, impact), "--columns t,vx,vz,wy,energy --every 0.3")
  close(found[1].vx, want, 1e-14, name .. ": speed along the plane")
  close(found[1].wy, 10 + (3 - want) / 0.1 / 0.4, 2e-13, name .. ": and the spin that the impulse gives")
  return found
end
oblique("stuck", "{ restitution = 0.5 }", 10, 3 - 2 / 7 * 2)
oblique("slides", "{ restitution = 0.5 }", 0.1, 3 - 0.1 * 1.5 * 2)
local super = oblique("superball", "{ restitution = 1, tangential = 1 }", 10, 3 - 2 * 2 / 7 * 2)
close(super[1].energy, 3 + 4.5 + 0.4 * 0.01 * 100 / 2, 1e-14, "superball: no energy is lost")

-- A spinning egg that rises and leaves the plane: until then, and then, the motions of other laws.
local EGG = [[
return scene { name = "egg", body = tensor { mass = 1, xx = 0.01, yy = 0.01, zz = 0.004 },
  effects = { effect.plane { surface = contact.ellipsoid { a = 0.1, b = 0.1, c = 0.2 }, law = "smooth"%s },
    %s }, initial = { omega = { 30, 0, 0 }, attitude = { axis = "x", angle = 1.5 } },
  time = { step = 0.001, horizon = 0.2 } }]]
local _, lost = run("kept", EGG:format(", gravity = 9.81", ""), "--columns t,com_z,com_velocity_z --every 0.1")
local rows, found = run("lifts", EGG:format(", impact = { restitution = 0.2 }",
  "effect.translation { gravity = 9.81 }"), "--columns t,rz,vz,N --at 0,0.02,0.04")
tap.is(found[1] and found[1].event, "lift_off", "an egg that turns over leaves the plane")
local lift = found[1] or {}
close(lift.t, lost[1] and lost[1].t, 1e-14, "when a scene without impact ends")
tap.is(lost[1] and lost[1].event, "contact_lost", "which says so")
local falls = 0
for _, row in ipairs(rows) do
  if row.t > (lift.t or math.huge) and (not found[2] or row.t < found[2].t) then
    local t = row.t - lift.t
    close(row.rz, lift.rz + lift.vz * t - 9.81 * t * t / 2, 1e-14, "then it falls freely")
    tap.is(row.N, 0.0, "without a reaction")
    falls = falls + 1
  end
end

tap.ok(falls > 0, "rows in the air are seen")

-- The scene that docs/plane.md shows.
local shown
for block in program.read "docs/plane.md":gmatch "```lua\n(.-)```" do shown = block:find "impact" and block or shown end
local _, told = run("bouncing_ball", shown, "--every 0.5 --columns t,rx,rz,wy,N,energy")
tap.is(told[#told].event, "landing", "docs/plane.md: the ball comes to rest on the plane")
for i = 2, #told do
  if told[i].energy > told[i - 1].energy * (1 + 1e-14) then tap.ok(false, "docs/plane.md: energy at " .. told[i].t) end
end

-- ---- what cannot be ----

local function refused(effects, initial, message, command)
  program.write(dir .. "/wrong.lua", string.format("return scene { name = 'wrong', body = solid.sphere { r = 0.1, " ..
    "mass = 1 },\n  effects = { %s },\n  initial = { %s } }\n", effects, initial))
  local code = program.shell(string.format("%s %s %s/wrong.lua >%s/out 2>%s/err", binary, command or "run", dir, dir,
    dir))
  local said = program.read(dir .. "/err")
  tap.ok(code ~= 0 and said:find(message, 1, true), message)
  if not said:find(message, 1, true) then tap.diag(said) end
end

local function plane(rest, law)
  return "effect.plane { surface = contact.sphere { r = 0.1 }, law = '" .. (law or "smooth") .. "'" .. rest .. " }"
end
local FLIES = ", effect.translation { gravity = 9.81 }"
for _, case in ipairs {
  { plane ", impact = { restitution = 0.5 }", "", "2: effect.plane: impact needs effect.translation, which says how " ..
    "the body flies" },
  { plane ", impact = { restitution = 1.5 }" .. FLIES, "", "2: effect.plane: impact: restitution must not be above 1" ..
    ", got 1.5" },
  { plane ", impact = { restitution = -1 }" .. FLIES, "", "restitution must not be negative" },
  { plane ", impact = { restitution = 0, friction = 1 }" .. FLIES, "",
    "unknown argument \"friction\" (it has restitution)" },
  { plane(", friction = { viscous = 1 }, impact = { restitution = 0 }", "sliding") .. FLIES, "",
    "friction is missing" },
  { plane(", friction = { coulomb = 1, smoothing = 1 }, impact = { restitution = 0, tangential = 2 }", "sliding") ..
    FLIES, "", "tangential must be from -1 to 1, got 2" },
  { plane ", impact = 0.5" .. FLIES, "", "impact" },
  { plane ", gravity = 9.81, impact = { restitution = 0.5 }" .. FLIES, "", "gravity is that of effect.translation " ..
    "(line 2) in a scene with impact" },
  { plane ", impact = { restitution = 0.5 }" .. ", effect.translation { drag = 1 }", "",
    "effect.translation: must have gravity alone beside effect.plane with impact" },
  { plane "" .. FLIES, "", "cannot be together with effect.plane (line 2)" },
  { plane ", impact = { restitution = 0.5 }" .. FLIES, "position = {0, 0, 0.05}",
    "3: initial: position must not put the body below the plane (line 2), got its lowest point 0.05 m below" },
  { plane(", impact = { restitution = 0.5 }", "rolling") .. FLIES, "position = {0, 0, 0.1}, velocity = {1, 0, 0}",
    "the body starts on the plane with a slip of 1 m/s, and it rolls" },
  -- w^2 of the centre of mass, 0.02 m above the middle, lifts more than the weight: N = m (g - 0.02 w^2) < 0
  { "effect.plane { surface = contact.sphere { r = 0.1, at = {0, 0, -0.02} }, law = 'smooth' }", "omega = {30, 0, 0}",
    "at t = 0 s: the plane would have to pull the body: N = -8.193 N" },
  { plane "", "", "--phase flight: the scene has no effect.plane with impact", "gen --phase flight" },
} do
  refused(table.unpack(case))
end

program.finish()
tap.done()
