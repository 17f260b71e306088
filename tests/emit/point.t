#!/usr/bin/env lua5.4
-- point.t - emitted code of points: the reference table, and the closed form against its formulas in 800 bits.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Table: forced_top.json's points in rotating frames (tests/reference/moving.h), by the closed form where there is one
-- and by RK4 with steps so short that the method's own error, (h w)^4/120 a radian, stays below 1e-11.
-- Formulas: the integral P, of which the emitted code has three forms, here has the textbook's form alone; it cancels,
-- which 800 bits bear, and its limits (equal rates, resonance) are written out.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"

local dir = program.directory()
local cc = "gcc -std=c99 -O2 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror " ..
  "-ffp-contract=off "

local function emit(text, real)
  local job = assert(scene.read(text))
  job = scene.plan(job, { real = real or "double" })
  local name = job.model.name
  local files = scene.files(job)
  program.write(dir .. "/" .. name .. ".h", files[name .. ".h"])
  program.write(dir .. "/" .. name .. ".c", files[name .. ".c"])
  return job
end

-- ---- the reference table ----

local spec = { -- id in the table, effects, state names in the table's order, has a closed form
  { "foucault_pendulum_linear", "foucault", [[effect.translation { gravity = 0, stiffness = {%w2%, %w2%, 0} },
    effect.rotating_frame { rate = {0, 0, 5.4905505623459494e-05}, centrifugal = false }]], "RX RY VX VY", true },
  { "dropped_particle_full", "dropped", [[effect.translation { gravity = 9.81 },
    effect.rotating_frame { rate = {0, 5.156303965692141e-05, 5.1563039656921404e-05} }]], "RX RY RZ VX VY VZ", true },
  { "free_particle_constant_omega", "constant", "effect.rotating_frame { rate = {0.3, -0.5, 0.8} }",
    "RX RY RZ VX VY VZ", true },
  { "free_particle_euler_force", "euler", "effect.rotating_frame { rate = {0, 0, 0.4}, rate_dot = {0, 0, 0.1} }",
    "RX RY VX VY", false },
  { "bead_on_rotating_rod", "bead", "effect.translation { gravity = 0, stiffness = {-1.5625, 0, 0} }", "RX VX", true },
}

local function table_program()
  local body, include = {}, {}
  for _, s in ipairs(spec) do
    local effects = string.gsub(s[3], "%%w2%%", "0.1464179104477612")
    local job = emit("return scene { name = \"" .. s[2] .. "\", body = points {{1, 0, 0, 0}}, effects = {" .. effects ..
      "}, initial = { position = {0, 0, 0} } }")
    tap.is(job.closed.kind, s[5] and "point" or nil, s[2] .. (s[5] and " has a closed form" or " has no closed form"))
    tap.is(#job.states, 6, s[2] .. ": a point has six states")
    include[#include + 1] = "#include \"" .. s[2] .. ".h\"\n"
    local index, n, upper = {}, 0, string.upper(s[2])
    for w in string.gmatch(s[4], "%S+") do
      index[#index + 1] = upper .. "_" .. w
      n = n + 1
    end
    local closed = s[5] and [[
    { NAME_orbit o; if (NAME_solve(&o, &m, x)) return 1; NAME_at(&o, row->t, y);
      printf("%s closed %g %.3g %.3g\n", row->id, row->t, off(n, at, y, row->x, row->x0),
        off(n, at + n, y, row->x + n, row->x0 + n)); }
]] or ""
    body[#body + 1] = (string.gsub([[
  if (strcmp(row->id, "ID") == 0) {
    static const int at[] = {INDEX};
    const int n = row->n/2;
    NAME_model m;
    double x[NX_] = {0}, y[NX_];
    long k, steps = (long)(row->t*RATE) + 1;
    NAME_init(&m, 0);
    for (k = 0; k < row->n; k++) x[at[k] ] = row->x0[k];
CLOSED    for (k = 0; k < steps; k++) NAME_step(&m, row->t*(double)k/(double)steps, x, 0, row->t/(double)steps);
    printf("%s rk4 %g %.3g %.3g\n", row->id, row->t, off(n, at, x, row->x, row->x0),
      off(n, at + n, x, row->x + n, row->x0 + n));
  }
]], "%u+_?", { ID = s[1], INDEX = table.concat(index, ", "), NX_ = upper .. "_NX", CLOSED = closed }))
    body[#body] = string.gsub(body[#body], "NAME", s[2])
    local per_second = { foucault = "2000", dropped = "10" }
    body[#body] = string.gsub(body[#body], "RATE", per_second[s[2]] or "1000")
  end
  program.write(dir .. "/main.c", table.concat(include) .. [[
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "moving.h"
/* error over the size of the vector, now or at the start */
static double off(int n, const int at[], const double got[], const long double want[], const double x0[]) {
  long double e = 0, size = 0;
  for (int i = 0; i < n; i++) {
    e = fmaxl(e, fabsl((long double)got[at[i] ] - want[i]));
    size = fmaxl(size, fmaxl(fabsl(want[i]), fabsl((long double)x0[i])));
  }
  return (double)(e/size);
}
int main(void) {
  for (unsigned i = 0; i < sizeof moving_rows/sizeof moving_rows[0]; i++) {
    __typeof__(&moving_rows[0]) row = &moving_rows[i];
]] .. table.concat(body) .. "  }\n  return 0;\n}\n")
  local objects = {}
  for _, s in ipairs(spec) do
    objects[#objects + 1] = s[2] .. ".o"
    for _, how in ipairs { cc, (string.gsub(cc, "gcc %-std=c99", "clang -std=c99")),
      (string.gsub(cc, "gcc %-std=c99", "g++ -x c++ -std=c++11")) } do
      local code = program.shell(string.format("(cd %s && %s -c -o %s.%s %s.c) >%s/log 2>&1", dir, how, s[2],
        how == cc and "o" or "other", s[2], dir))
      tap.is(code, 0, s[2] .. " compiles with " .. string.match(how, "^%S+"), program.read(dir .. "/log"))
    end
  end
  local code = program.shell(string.format("gcc -std=gnu11 -O1 -Itests/reference -I%s -o %s/table %s/main.c %s -lm " ..
    ">%s/log 2>&1 && %s/table >%s/out", dir, dir, dir, "-L. " .. dir .. "/" .. table.concat(objects, " " .. dir .. "/"),
    dir, dir, dir))
  tap.is(code, 0, "the table's program runs", program.read(dir .. "/log"))
  return program.read(dir .. "/out")
end

local rows = 0
for id, how, t, r, v in string.gmatch(table_program(), "(%S+) (%S+) (%S+) (%S+) (%S+)\n") do
  -- closed form: some 30 roundings of half a unit, of terms no larger than three times the vector
  local bar = how == "closed" and 1e-14 or 1e-11
  tap.ok(tonumber(r) <= bar and tonumber(v) <= bar, string.format("%s at %s s by %s", id, t, how), r .. " " .. v)
  rows = rows + 1
end
tap.is(rows, 4 + 5 + 5 + 5 + 4 + 18, "every row of the table was met")

-- ---- the formulas in many bits ----

local BITS = 800
local function round(x) return R.round(x, BITS) end
local function fn(name, x) return R.apply(name, BITS, x) end
local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end
local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end
local function zero(x) return R.sign(x) == 0 end

-- C, S of s'' = -square s, and the double integral D
local function wave(square, t)
  if zero(square) then return R.one, t, t * t / R.new(2) end
  local w = fn("sqrt", R.abs(square))
  local up = R.sign(square) < 0
  local C = fn(up and "cosh" or "cos", round(w * t))
  return C, round(fn(up and "sinh" or "sin", round(w * t)) / w), round((R.one - C) / square)
end

-- P(t), real and imaginary part; see generator/dynamics/closed/point.lua
local function push(O, delta, square, t, C, S)
  local c, s = fn("cos", round(O * t)), fn("sin", round(O * t))
  if zero(O) and zero(square) then return t * t / R.new(2), R.zero end
  if not zero(delta) then return (c * C + s * O * S - R.one) / delta, (c * O * S - s * C) / delta end
  -- resonance: P = (t - E)/(2 i O), E = (1 - exp(-2 i O t))/(2 i O)
  local two = R.new(2) * O
  local Er, Ei = fn("sin", round(two * t)) / two, (fn("cos", round(two * t)) - R.one) / two
  return -Ei / two, (Er - t) / two
end

-- r, v at t, and the sizes of the terms that were added.
local function oracle(case, x0, t)
  local O, k, g = case.O, case.k, case.g
  local w2 = dot(O, O)
  local w = zero(w2) and R.zero or fn("sqrt", w2)
  local n = zero(w2) and { R.zero, R.zero, R.one } or { O[1] / w, O[2] / w, O[3] / w }
  for i = 1, 3 do n[i] = round(n[i]) end
  local square = case.centrifugal and k or k + w2
  local function parts(a)
    local along = dot(n, a)
    return round(along), { a[1] - along * n[1], a[2] - along * n[2], a[3] - along * n[3] }
  end
  local r, v = { x0[1], x0[2], x0[3] }, { x0[4], x0[5], x0[6] }
  local turned = cross(O, r)
  local rs, A = parts(r)
  local vs, B = parts(v)
  local gs, G = parts(g)
  for i = 1, 3 do B[i] = B[i] + turned[i] end
  local c, s = fn("cos", round(w * t)), fn("sin", round(w * t))
  local C, S = wave(square, t)
  local Cn, Sn, Dn = wave(k, t)
  local Pr, Pi = push(w, w2 - square, square, t, C, S)
  local z, dz = {}, {}
  for i = 1, 3 do
    z[i], dz[i] = round(A[i] * C + B[i] * S), round(B[i] * C - square * A[i] * S)
  end
  local nz, ndz, nG = cross(n, z), cross(n, dz), cross(n, G)
  local function size(a) return fn("sqrt", round(dot(a, a)) + R.new(2) ^ -3000) end
  local out = {}
  for i = 1, 3 do
    out[i] = c * z[i] - s * nz[i] + Pr * G[i] + Pi * nG[i] + n[i] * (rs * Cn + vs * Sn + gs * Dn)
    out[3 + i] = c * (dz[i] - w * nz[i]) - s * (ndz[i] + w * z[i]) + S * (c * G[i] - s * nG[i]) +
      n[i] * (vs * Cn + gs * Sn - k * rs * Sn)
  end
  local a, b, f = size(A), size(B), size(G)
  local P = fn("sqrt", round(Pr * Pr + Pi * Pi) + R.new(2) ^ -3000)
  local across = a * R.abs(C) + b * R.abs(S)
  local big_r = across + P * f + R.abs(rs * Cn) + R.abs(vs * Sn) + R.abs(gs * Dn) + size(r)
  local big_v = w * across + b * R.abs(C) + R.abs(square) * a * R.abs(S) + R.abs(S) * f + R.abs(vs * Cn) +
    R.abs(gs * Sn) + R.abs(k * rs * Sn)
  return out, big_r, big_v
end

-- {name, rate of the frame, stiffness, gravity, times, rate that velocities are multiplied with}; start: its own
-- state, of a point that falls nearly straight: each component to its own last digits.
local cases = {
  { "an oblique axis", { 0.3, -0.5, 0.8 }, 2.25, { 1, -2, 3 }, { 0, 0.01, 1, -7, 100, 1e7 } },
  { "no stiffness", { 0.3, -0.5, 0.8 }, 0, { 1, -2, 3 }, { 0.5, 1, 1.02, 60, 1e4 } },
  { "resonance", { 0, 0, 0.5 }, 0.25, { 1, 2, 3 }, { 0.5, 1, 5, 1e3 } },
  { "near resonance", { 0, 0, 0.5 }, 0.25 * (1 + 2.0 ^ -30), { 1, 2, 3 }, { 0.5, 5, 1e3 } },
  { "not far from resonance", { 0, 0, 0.5 }, 0.2490234375, { 1, 2, 3 }, { 0.5, 5, 1e3 } },
  { "half of resonance", { 0, 0.5, 0 }, 0.125, { 1, 2, 3 }, { 0.5, 5, 1e3 } },
  { "unstable", { 0.1, 0.2, 0.3 }, -1, { 1, 2, 3 }, { 0.25, 3, 30 } },
  { "unstable, with the frame's rate", { 0, 0, 1 }, -1, { 1, 2, 3 }, { 0.25, 3, 30 } },
  { "unstable, near the frame's rate", { 0, 0, 1 }, -1 - 2.0 ^ -40, { 1, 2, 3 }, { 0.25, 3, 30 } },
  { "a slow frame", { 0, 5e-5, 5e-5 }, 0, { 0, 0, -9.81 }, { 0.1, 4.5, 100, 1e5 } },
  { "a slow spring in a fast frame", { 0, 0, 8 }, 1e-12, { 0, 1, -9.81 }, { 0.01, 1, 100, 1e7 } },
  { "a fast spring in a slow frame", { 1e-9, 0, 1e-9 }, 1e6, { 0, 1, -9.81 }, { 1e-6, 1, 100 } },
  { "no frame", { 0, 0, 0 }, 4, { 1, 2, 3 }, { 0.1, 10, 1e6 } },
  { "nothing at all", { 0, 0, 0 }, 0, { 0, 0, 0 }, { 3 } },
  { "fast", { 3e29, -5e29, 8e29 }, 2e60, { 1e55, 0, 1e60 }, { 1e-30, 1e-27 }, 1e30 },
  { "a fall from rest", { 0, 5e-5, 5e-5 }, 0, { 0, 0, -9.81 }, { 1e-3, 0.1, 3, 100 },
    start = { 0, 0, 100, 0, 0, 0 } },
  { "a throw", { 0, 5e-5, 2e-5 }, 0, { 0, 0, -9.81 }, { 1e-3, 0.1, 4.5, 100 },
    start = { 0, 3, 0, 0, 7, 20 } },
  { "a fall in a fast frame", { 0, 0.5, 0.25 }, 0.5, { 0, 0, -9.81 }, { 1e-3, 0.1 },
    start = { 0, 0, 0, 0, 0, 0 } },
  { "slow", { 3e-31, -5e-31, 8e-31 }, 2e-60, { 1e-60, 0, 1e-61 }, { 1e30, 1e33 }, 1e-30 },
}

local scenes = {}
for _, real in ipairs { "double", "float" } do
  for _, c in ipairs { true, false } do
    local name = "p" .. real .. (c and "c" or "n")
    emit(string.format([[
local function p(name, value, unit) return param(name, value, unit) end
return scene { name = "%s", body = points {{1, 0, 0, 0}},
  effects = { effect.translation { gravity = {p("gx", 1, "m/s^2"), p("gy", 1, "m/s^2"), p("gz", 1, "m/s^2")},
      stiffness = p("k", 1, "N/m") },
    effect.rotating_frame { rate = {p("a", 1, "1/s"), p("b", 1, "1/s"), p("c", 1, "1/s")}, centrifugal = %s } },
  initial = { position = {1, 0, 0} } }]], name, tostring(c)), real)
    program.write(dir .. "/" .. name .. "_main.c", (string.gsub([[
#include "NAME.h"
#include <stdio.h>
int main(void) {
  double in[14];
  for (;;) {
    NAME_model m; NAME_orbit o; NAME_real p[7], x[6], y[6], two[2], pair[12]; int i;
    for (i = 0; i < 14; i++) if (scanf("%lf", in + i) != 1) return 0;
    for (i = 0; i < 7; i++) p[i] = (NAME_real)in[i];
    for (i = 0; i < 6; i++) x[i] = (NAME_real)in[7 + i];
    if (NAME_init(&m, p) || NAME_solve(&o, &m, x)) return 1;
    two[0] = 0; two[1] = (NAME_real)in[13];
    NAME_at(&o, two[1], y);
    NAME_at_many(&o, 2, two, pair);
    for (i = 0; i < 6; i++) if (pair[2*i + 1] != y[i]) return 2;
    for (i = 0; i < 6; i++) printf("%.17g ", (double)y[i]);
    printf("\n");
  }
}
]], "NAME", name)))
    local code = program.shell(string.format("(cd %s && %s -o %s %s.c %s_main.c -lm) >%s/log 2>&1", dir, cc, name, name,
      name, dir))
    tap.is(code, 0, name .. " compiles", program.read(dir .. "/log"))
    scenes[#scenes + 1] = { name = name, real = real, centrifugal = c }
  end
end

-- units in the last place, of the sum of the terms: about 30 roundings of half a unit
local ULPS = 16
for _, s in ipairs(scenes) do
  local lines, wants = {}, {}
  for _, c in ipairs(cases) do
    local scale = c[6] or 1
    if s.real == "double" or not c[6] then
      for _, t in ipairs(c[5]) do
        local x = c.start or { 1, 0.5, -0.25, 0.125 * scale, 0.25 * scale, 0.375 * scale }
        local g, O = c[4], c[2]
        local list = { g[1], g[2], g[3], c[3], O[1], O[2], O[3], x[1], x[2], x[3], x[4], x[5], x[6], t }
        for i, y in ipairs(list) do
          if s.real == "float" then y = string.unpack("f", string.pack("f", y)) end
          list[i] = string.format("%.17g", y)
        end
        lines[#lines + 1] = table.concat(list, " ")
        local q = {}
        for i, y in ipairs(list) do q[i] = R.fromdouble(tonumber(y) + 0.0) end
        local want, r, v = oracle({ O = { q[5], q[6], q[7] }, k = q[4], g = { q[1], q[2], q[3] },
          centrifugal = s.centrifugal }, { table.unpack(q, 8, 13) }, q[14])
        wants[#wants + 1] = { c[1] .. " at " .. list[14], want, r, v, alone = c.start ~= nil }
      end
    end
  end
  program.write(dir .. "/in", table.concat(lines, "\n") .. "\n")
  tap.is(program.shell(string.format("%s/%s <%s/in >%s/out", dir, s.name, dir, dir)), 0, s.name .. " runs")
  local i, epsilon = 0, s.real == "double" and 2.0 ^ -52 or 2.0 ^ -23
  for line in string.gmatch(program.read(dir .. "/out"), "[^\n]+") do
    i = i + 1
    local k, worst = 0, 0.0
    for word in string.gmatch(line, "%S+") do
      k = k + 1
      local x = tonumber(word)
      local size = R.todouble(wants[i].alone and R.abs(wants[i][2][k]) or k <= 3 and wants[i][3] or wants[i][4])
      local e = x and x == x and R.todouble(R.abs(R.fromdouble(x) - wants[i][2][k])) or math.huge
      if e > 0 then worst = math.max(worst, e / (size * epsilon)) end
    end
    tap.ok(k == 6 and worst <= ULPS, s.name .. ": " .. wants[i][1], string.format("%.2f units", worst))
  end
  tap.is(i, #wants, s.name .. ": every case was answered")
end
program.finish()
tap.done()
