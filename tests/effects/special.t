#!/usr/bin/env lua5.4
-- special.t - special paths of the methods: each effect on each kind of body in frames at rest and turning.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A special path is a formula made for one kind of motion, and wrong where the scene has anything more.  Each cell of
-- the table is refused at a line of the scene, or goes to the library's motion by every method that takes it
-- (cells.lua).  Effects are along the axis z here, for there special paths are taken: heavy tops, magnets, tilts.
-- A symmetric body has all effects in all frames, other bodies a sixth of them; pairs follow.  POLHODE_CELLS=all: the
-- whole table, in some minutes.  The quick tier takes the symmetric body by taylor where the frame turns.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local cells = require "tests.effects.cells"
local known = require "generator.effects.effects"

-- { name, body, origin }
local bodies = {
  { "symmetric", "tensor { mass = 2, com = {0, 0, 0.1}, xx = 0.5, yy = 0.5, zz = 0.2, about = \"origin\" }" },
  { "sphere", "tensor { mass = 2, com = {0, 0, 0.1}, xx = 0.5, yy = 0.5, zz = 0.5, about = \"origin\" }" },
  { "oblique", "solid.cylinder { r = 0.5, h = 1, mass = 2 }:turned { axis = {1, 2, 0}, angle = 0.7 }" },
  { "diagonal", "tensor { mass = 2, com = {0, 0, 0.1}, xx = 0.5, yy = 0.6, zz = 0.3, about = \"origin\" }" },
  { "full", "solid.box { x = 0.4, y = 0.6, z = 1, mass = 2 } + points { {0.3, {0.2, 0.3, 0.1}} }" },
  { "rod", "wire.rod { length = 1, mass = 2 }", rates = "{0.7, -0.4, 0}" },
  { "points", "points { {1, {0.4, 0, 0.2}}, {1, {-0.4, 0, 0.2}}, {1, {0, 0.4, 0.2}}, {1, {0, -0.4, 0.2}} }" },
  { "offset", "solid.box { x = 0.4, y = 0.6, z = 1, mass = 2 }", "{0.1, 0.2, -0.3}" },
}

-- { effect, arguments, free = it wants the centroid for its origin }
local effects = {
  { "gravity", "g = 3" },
  { "gravity", "g = 3, direction = {1, 0, 0}" },
  { "damping", "c = {0.1, 0.1, 0.05}" },
  { "torque", "body = {0, 0, 0.1}" },
  { "torque", "body = {-0.1*t*wy, 0.1*t*wx, 0}" },
  { "torque", "inertial = {0, {{0, 0}, {3, 0.2}, {6, 0}}, 0.1}" },
  { "control", "" },
  { "rotor", "axis = {0, 0, 1}, momentum = 0.3" },
  { "translation", "gravity = {0, 0, -1}, stiffness = 0.5", free = true },
  { "translation", "gravity = 0, thrust = {0.2, 0, 0.3}", free = true },
  { "drag", "c = 0.1" },
  { "friction", "torque = 0.1, smoothing = 0.2" },
  { "spring", "stiffness = 0.4, axis = {0, 0, 1}, rest = 0.2" },
  { "magnetic", "moment = {0, 0, 1}, field = {0, 0, 0.3}" },
  { "magnetic", "moment = {0, 0, 1}, rotating = {0.1, 0, 0.2}, rate = 2" },
  { "eddy_current", "k = 1, field = {0, 0, 0.3}" },
  { "wheel", "axis = {0, 0, 1}, inertia = 0.02, speed = 5, torque = 0.1*sin(t)" },
  { "gravity_gradient", "mu = 0.3, orbit = { radius = 0.9 }", free = true },
  { "solar_pressure", "flux = 2e8, sun = {1, 2, 0}, plates = { { area = 1, normal = {1, 0.5, 0}, " ..
    "centre = {0, 1, 0.5}, reflectivity = 0.4 } }" },
  { "pivot", "acceleration = {0, 0, 0.5*sin(3*t)}" },
  { "inertia_rate", "xz = 0.05, zz = 0.1*t" },
  { "inertia_rate", "xx = 0.1*t, yy = 0.1*t" },
  { "inertia_rate", "xx = 0.1*sin(t)^2, xy = 0.05*cos(2*t)" },
  { "dissipation", "k = 0.05" },
  { "custom", "params = { stiff = quantity(0.4, \"N m\") }, potential = function(s) return " ..
    "s.stiff*(s.q[2]^2 + s.q[3]^2) end" },
  { "custom", "params = { slope = quantity(0.2, \"N m s\") }, torque = function(s) return { -s.slope*s.w[2], " ..
    "s.slope*s.w[1], 0*s.slope*s.w[1] } end" },
}

local frames = { { "rest" }, { "turning", "rate = {0, 0, 0.7}" },
  { "faster", "rate = {0, 0, 0.7}, rate_dot = {0, 0, 0.5}" } }
local tilted = { "tilted", "rate = {0.3, 0.2, 0.5}, rate_dot = {0, 0.3, 0}" }

local methods = { taylor = true, midpoint = true, split2 = true, semi = true, exact = true }
local list, used = {}, { ["effect.rotating_frame"] = true, ["effect.plane"] = true } -- a plane's are plane_methods.t's

local function text(body, chosen, frame)
  local lines, free = {}, body[1] == "oblique" or body[1] == "full" or body[1] == "rod"
  for _, e in ipairs(chosen) do
    free = free or e.free
    used["effect." .. e[1]] = true
    lines[#lines + 1] = "effect." .. e[1] .. " { " .. e[2] .. " }"
  end
  if frame[2] then lines[#lines + 1] = "effect.rotating_frame { " .. frame[2] .. " }" end
  return "return scene { name = \"s\",\n  body = " .. body[2] .. ",\n  origin = " ..
    (free and "\"centroid\"" or body[3] or "{0, 0, 0}") .. ",\n  effects = {\n    " .. table.concat(lines, ",\n    ") ..
    " },\n  initial = { attitude = { axis = {1, 2, -1}, angle = 0.9 }, omega = " ..
    (body.rates or "{0.7, -0.4, 1.5}") .. " } }\n"
end

local function put(body, chosen, frame, number)
  list[#list + 1] = { name = body[1] .. "/" .. (chosen[1] and chosen[1][1] or "free") .. number .. "/" .. frame[1],
    text = text(body, chosen, frame), methods = methods, vector = #list % 2 == 0 }
end

local whole = os.getenv "POLHODE_CELLS" == "all"
for b, body in ipairs(bodies) do
  for f, frame in ipairs(frames) do
    put(body, {}, frame, "")
    for i, e in ipairs(effects) do
      if whole or b == 1 or (i + b + 2 * f) % 6 == 0 then put(body, { e }, frame, i) end
    end
  end
end
for i = 1, #effects do -- gravity along the axis and another effect; any two
  local e, other = effects[i], effects[i * 7 % #effects + 1]
  if not e.free and i > 1 and (whole or i % 2 == 1) then
    put(bodies[1], { e, effects[1] }, frames[2], i .. "_gravity")
  end
  if e ~= other and (whole or i % 3 == 0) then
    put(bodies[i // 2 % 2 + 1], { e, other }, i % 2 == 0 and tilted or frames[i % 3 + 1], i .. "_pair")
  end
end
for _, spec in ipairs(known) do
  if not used[spec.name] then tap.ok(false, spec.name .. " is in the table") end
end

if tier.quick then
  local some = {}
  for _, c in ipairs(list) do
    c.methods = { taylor = true }
    local name = c.name
    if name:find "^symmetric/gravity1/" or name:find "^symmetric/free/" or name == "symmetric/magnetic14/turning" or
      name == "symmetric/inertia_rate21/rest" then
      some[#some + 1] = c
    end
  end
  list = some
end

local taken, compared, refused = {}, 0, 0
for first = 1, #list, 48 do
  local some = { table.unpack(list, first, math.min(first + 47, #list)) }
  local results = cells.run(some)
  tap.is(results.status, 0, "cells " .. first .. " .. " .. first + #some - 1 .. " are run", results.err)
  for _, c in ipairs(some) do
    local bad = {}
    for method, r in pairs(results[c.name] or { none = { kind = "nothing came", why = "" } }) do
      if r.kind == "off" then
        compared = compared + 1
        local good = r.off <= 1 -- false of NaN
        if not good then bad[#bad + 1] = string.format("%s: %.3g of its bound", method, r.off) end
      elseif r.kind == "path" then
        taken[r.why] = (taken[r.why] or 0) + 1
      elseif r.kind == "why" and #r.why > 10 or r.kind == "refused" and r.why:find "^[%w_/]+%.lua:%d+: " then
        refused = refused + 1
      else
        bad[#bad + 1] = method .. ": " .. r.kind .. " " .. r.why
      end
    end
    tap.ok(#bad == 0, c.name, table.concat(bad, "\n") .. "\n" .. c.text)
  end
end
-- a table in which nothing special is taken, or everything refused, would pass
for _, row in ipairs { { "heavy top", 2, 1 }, { "frame about an axis", 3, 1 }, { "frame of L", 1 }, { "sphere", 3 },
  { "axis", 5 }, { "oblique", 2 }, { "diagonal", 2 }, { "full", 2 } } do
  local path, least = row[1], tier.quick and (row[3] or 0) or row[2]
  tap.ok((taken[path] or 0) >= least, path .. " is taken at least " .. least .. " times", taken[path])
end
tap.ok(compared >= #list, compared .. " motions of " .. #list .. " cells are the library's, " .. refused .. " refused")

-- ---- what else has the special paths in it: bodies at once, compensated steps, dense output, vectors ----
--
-- Against rk4, which takes the equations as they are: 200 steps of 0.0025 s leave (h |w|)^4 of half a radian, below
-- 1e-10, |w| = 3.  A compensated step is its plain step but for rounding: 200 steps, some units each.  Bodies at once
-- have the bits of one.  All scenes are one program.

local roads = {}
for _, row in ipairs { { 1, {}, 3 }, { 1, { 1 }, 1 }, { 1, { 1 }, 2 }, { 1, { 14 }, 3 }, { 1, { 21 }, 1 },
  { 1, { 24 }, 2 }, { 1, { 10 }, 1 }, { 2, { 8 }, 2 }, { 4, {}, 1 }, { 4, {}, 2 } } do
  local chosen = {}
  for i, n in ipairs(row[2]) do chosen[i] = effects[n] end
  roads[#roads + 1] = { name = "r" .. #roads + 1, text = text(bodies[row[1]], chosen, frames[row[3]]) }
end

local CHECK = [[
static double NAME_far(const double x[], const double y[])
{
  double d = 0;
  for (int i = 0; i < UPPER_NX; i++) d = fmax(d, fabs(x[i] - y[i]));
  return d;
}
static void NAME_check(void)
{
  enum { N = 3, STEPS = 200 };
  const double h = 0.0025;
  NAME_model m;
  double p[1], c[UPPER_ORDER + 1][UPPER_ROW], rk[UPPER_NX], ta[UPPER_NX], tc[UPPER_NX], se[UPPER_NX], sc[UPPER_NX];
  double at[UPPER_NX], run[UPPER_NX], lt[UPPER_NX] = { 0 }, ls[UPPER_NX] = { 0 }, many[UPPER_NX*N], runs[UPPER_NX*N];
  int steps[N], same = 1;

  if (NAME_init(&m, p)) { printf("NAME init\n"); return; }
  NAME_initial(&m, rk);
  memcpy(ta, rk, sizeof rk), memcpy(tc, rk, sizeof rk), memcpy(se, rk, sizeof rk), memcpy(sc, rk, sizeof rk);
  memcpy(at, rk, sizeof rk), memcpy(run, rk, sizeof rk);
  for (int i = 0; i < UPPER_NX; i++) for (int k = 0; k < N; k++) many[i*N + k] = runs[i*N + k] = rk[i];
  NAME_taylor_series(&m, 0, rk, 0, c);
  NAME_taylor_at(&m, c, STEPS*h, at);
  for (int n = 0; n < STEPS; n++) {
    NAME_step(&m, n*h, rk, 0, h);
    NAME_taylor_step(&m, n*h, ta, 0, h);
    NAME_taylor_step_compensated(&m, n*h, tc, 0, h, lt);
    NAME_taylor_step_many(&m, n*h, many, 0, h, N);
    NAME_semi_step(&m, n*h, se, 0, h);
    NAME_semi_step_compensated(&m, n*h, sc, 0, h, ls);
  }
  NAME_taylor_run(&m, 0, run, 0, STEPS*h, 1e-12, 1000);
  NAME_taylor_run_many(&m, 0, runs, 0, STEPS*h, 1e-12, 1000, steps, N);
  for (int i = 0; i < UPPER_NX; i++) for (int k = 0; k < N; k++)
    same = same && many[i*N + k] == ta[i] && runs[i*N + k] == run[i];
  printf("NAME %.17g %.17g %.17g %.17g %.17g %d\n", NAME_far(rk, ta), NAME_far(rk, at), NAME_far(rk, run),
    NAME_far(ta, tc), NAME_far(se, sc), same);
}
]]

local function compiled(dir, flags)
  local pipe = io.popen("cd " .. dir .. " && clang -std=c99 -O0 -ffp-contract=off " .. flags ..
    " -o roads roads.c r*/r?.c r*/r1?.c -lm 2>&1 && ./roads")
  local out = pipe:read "a"
  pipe:close()
  local seen = {}
  for name, rest in out:gmatch "(r%d+) ([^\n]+)" do
    seen[name] = {}
    for word in rest:gmatch "%S+" do table.insert(seen[name], tonumber(word)) end
  end
  return seen, out
end

if not tier.quick then
  local dir = program.directory() .. "/roads"
  local binary, calls = os.getenv "POLHODE" or "build/polhode", {}
  local main = { "#include <math.h>\n#include <stdio.h>\n#include <string.h>\n" }
  program.shell("mkdir -p " .. dir)
  for _, r in ipairs(roads) do
    program.write(dir .. "/" .. r.name .. ".lua", r.text)
    local status = program.shell(string.format("%s gen %s/%s.lua --name %s --layout single --with " ..
      "compensated,batch --method rk4,taylor,semi -o %s/%s >%s/said 2>&1", binary, dir, r.name, r.name, dir, r.name,
      dir))
    tap.is(status, 0, r.name .. " is written", program.read(dir .. "/said"))
    main[#main + 1] = string.format("#include \"%s/%s.h\"\n", r.name, r.name)
    main[#main + 1] = (CHECK:gsub("NAME", r.name):gsub("UPPER", r.name:upper()))
    calls[#calls + 1] = r.name .. "_check();"
  end
  program.write(dir .. "/roads.c", table.concat(main) .. "int main(void) { " .. table.concat(calls, " ") ..
    " return 0; }\n")
  local vectors = "-march=native"
  for _, r in ipairs(roads) do vectors = vectors .. " -D" .. r.name:upper() .. "_VECTOR" end
  for _, flags in ipairs { "", vectors } do
    local seen, out = compiled(dir, flags)
    for _, r in ipairs(roads) do
      local v = seen[r.name] or {}
      tap.ok(#v == 6 and math.max(v[1], v[2], v[3]) < 1e-9 and v[4] < 1e-12 and v[5] < 1e-12 and
        (v[6] == 1 or flags ~= ""), r.name .. ": series, dense output, bodies at once, compensated steps " ..
        flags:sub(1, 13),
        table.concat(v, " ") .. out:sub(1, 2000) .. r.text)
    end
  end
end

program.finish()
tap.done()
