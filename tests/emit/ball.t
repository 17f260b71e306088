#!/usr/bin/env lua5.4
-- ball.t - the closed forms of a homogeneous ball on a plane: against 32 digits, and to the last digit at long times.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The rows of tests/reference/plane.h come from Newton's and Euler's equations by a series of Taylor in 192 bits, and
-- know of no closed form.  For what they do not have (a million turns, a plane all but at rest, tiny and huge balls,
-- float) the expected numbers are the solution z'' = i k Omega z' + (1 - k) G_t in 600 bits; the rows say that it is
-- true.  That the whole motion on a level plane is the library's is asked by `polhode check`.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local plane_rows = require "tests.effects.plane_rows"
local R = require "generator.algebra.rational"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()
local BITS = 600

-- A ball's numbers at the times, or nil: lists p1 p2 v1 v2 W1 W2 W3.
local function measured(text, times, options)
  program.write(dir .. "/body.lua", text)
  local words = {}
  for i, t in ipairs(times) do words[i] = string.format("%a", t) end
  local code = program.shell(string.format("(%s gen %s/body.lua %s -o %s/out && gcc -std=c99 -O2 -ffp-contract=off " ..
    "-I%s/out -o %s/ball tests/emit/ball.c %s/out/body.c %s/out/body_orbit.c -lm && %s/ball %s) >%s/log 2>&1", binary,
    dir, options or "", dir, dir, dir, dir, dir, dir, table.concat(words, " "), dir))
  local said, rows = program.read(dir .. "/log"), {}
  for line in said:gmatch "[^\n]+" do
    local row = {}
    for word in line:gmatch "%S+" do row[#row + 1] = tonumber(word) end
    if #row == 7 then rows[#rows + 1] = row end
  end
  if code ~= 0 or #rows ~= #times then return nil, said end
  return rows
end

local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end

local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end

local function unit(v)
  local size = math.sqrt(dot(v, v))
  return { v[1] / size, v[2] / size, v[3] / size }
end

-- q (0, w) q* of a unit quaternion
local function turned(q, w)
  local u = { q[2], q[3], q[4] }
  local c = cross(u, w)
  local out = {}
  for i, x in ipairs(cross(u, c)) do out[i] = w[i] + 2 * (q[1] * c[i] + x) end
  return out
end

-- ---- the reference ----

local seen = 0
for _, case in ipairs(plane_rows.cases) do
  local I, surface, name = case[1][3], case[1][4], case[1][1]
  local law = surface.law == "PH_ROLLING" or surface.law == "PH_VISCOUS"
  local alone = case[1][9] == 0
  if I[1] == I[2] and I[2] == I[3] and surface.half_axes[1] == 0 and law and alone and dot(surface.centre,
    surface.centre) == 0 then
    seen = seen + 1
    local times = {}
    for i, row in ipairs(case) do times[i] = row[10] end
    local rows, why = measured(plane_rows.scene(case[1]), times)
    if tap.ok(rows, name .. ": has the closed form of its centre", why) then
      local worst = 0.0
      local n = unit(surface.normal)
      local along = dot(n, { 1, 0, 0 })
      local e1 = unit { 1 - along * n[1], -along * n[2], -along * n[3] } -- the direction in the plane nearest to x
      local e2 = cross(n, e1)
      for i, row in ipairs(case) do
        local x, moved = rows[i], plane_rows.moved(row)
        local W = turned(row[11], row[12])
        local speed, rate = math.sqrt(dot(row[14], row[14])), math.sqrt(dot(W, W))
        -- 16 roundings of the largest number of each kind, or 20 times what the inputs' rounding moves
        local function against(got, want, scale, by)
          local bar = math.max(16 * 2.0 ^ -53 * scale, 20 * by)
          local ratio = math.abs(got - want) / bar
          worst = ratio <= worst and worst or ratio == ratio and ratio or math.huge
        end
        local far = math.max(speed * row[10], math.sqrt(dot(row[13], row[13])))
        against(x[1], dot(row[13], e1), far, moved.com)
        against(x[2], dot(row[13], e2), far, moved.com)
        against(x[3], dot(row[14], e1), speed, moved.v)
        against(x[4], dot(row[14], e2), speed, moved.v)
        for k = 1, 3 do against(x[4 + k], W[k], rate, moved.w * rate + moved.q * rate) end
      end
      tap.ok(worst <= 1, string.format("%s: place, velocity and spin at %d times (%.2g of the bound)", name, #case,
        worst))
    end
  end
end
tap.ok(seen == 4, "the reference has four such balls, " .. seen .. " were found")

-- ---- 600 bits ----

local one, two = R.one, R.lift(2)
local function apply(f, x) return R.apply(f, BITS, x) end

-- Of a body of mass 1 with J = 2/5 R^2, k = 2/7; z0, gamma = (1 - k) G_t along e1, e2; W along e1, e2 at the start.
local function exact(c, t)
  local k = R.new(2, 7)
  local V = { -c.Omega * c.z[2] + c.R * c.W[2], c.Omega * c.z[1] - c.R * c.W[1] }
  local w = k * c.Omega
  local a, b, p, r -- t E and t^2 (..) of templates/orbit/centre.c
  local cosine, sine = one, R.zero
  if R.sign(w) == 0 then
    a, b, p, r = t, R.zero, t * t / two, R.zero
  else
    sine, cosine = apply("sin", w * t), apply("cos", w * t)
    a, b = sine / w, (one - cosine) / w
    p, r = b / w, (t - a) / w
  end
  local g = c.pull
  local moved = { a * V[1] - b * V[2] + p * g[1] - r * g[2], a * V[2] + b * V[1] + p * g[2] + r * g[1] }
  local speed = { cosine * V[1] - sine * V[2] + a * g[1] - b * g[2], cosine * V[2] + sine * V[1] + a * g[2] + b * g[1] }
  local share = R.new(5, 7) * c.Omega / c.R
  return { c.z[1] + moved[1], c.z[2] + moved[2], speed[1], speed[2],
    c.W[1] + share * moved[1] - g[2] * t / c.R, c.W[2] + share * moved[2] + g[1] * t / c.R }
end

-- t - sin(y)/rate is a sixth of t at y = rate t = 1, where it takes over from its series; its terms have six roundings.
local ROUNDINGS = 36

-- The normal is (-3/5, 0, 4/5) or z, gravity 35/4: e1 = (4/5, 0, 3/5), G.e1 = -21/4 (not a rounded number).
local function text(c, tilted)
  return string.format([[
return scene { name = "body", body = tensor { mass = 1, xx = %s, yy = %s, zz = %s },
  effects = { effect.plane { surface = contact.sphere { r = %s }, %s turntable = %s, gravity = %s } },
  initial = { omega = { %s }, position = { %s } }, time = { step = 0.001 } }
]], c.J, c.J, c.J, c.r, tilted and "normal = {-3, 0, 4}," or "", c.turntable, c.gravity or "8.75", c.omega, c.position)
end

local turns = 2 * math.pi
for _, case in ipairs {
  { what = "circles, a million times round", r = "0.5", J = "0.1", turntable = "3.5", omega = "1, 2, 3",
    position = "0.25, 1, 0", W = { "1", "2" }, z = { "1/4", "1" }, R = "1/2", Omega = "7/2",
    times = { 0.0, 0.001, 0.9, 1.1, 100.5, 1e6 * turns, -1e6 * turns } },
  { what = "a trochoid for a thousand times", r = "0.5", J = "0.1", turntable = "3.5", omega = "0, 2, 0",
    position = "0, 0, 0", tilted = true, W = { "0", "2" }, z = { "0", "0" }, R = "1/2", Omega = "7/2", pull = "-15/4",
    times = { 0.001, 0.9, 1.1, 100.5, 1000 * turns } },
  { what = "a plane all but at rest", r = "0.5", J = "0.1", turntable = "3.5e-15", omega = "0, 2, 0",
    position = "0, 0, 0", tilted = true, W = { "0", "2" }, z = { "0", "0" }, R = "1/2", Omega = "35e-16",
    pull = "-15/4", times = { 0.001, 1.0, 1000.0 } },
  { what = "at the rate of a turn a minute, from 1/1000 s on", r = "0.5", J = "0.1", turntable = "0.109375",
    omega = "0, 2, 0", position = "0, 0, 0", tilted = true, W = { "0", "2" }, z = { "0", "0" }, R = "1/2",
    Omega = "7/64", pull = "-15/4", times = { 0.001, 1.0, 31.9, 32.1, 1000.0 } },
  { what = "a slope at rest", r = "0.5", J = "0.1", turntable = "0", omega = "0, 2, 0", position = "0.64, 2, 0.48",
    tilted = true, W = { "0", "2" }, R = "1/2", Omega = "0", pull = "-15/4", z = { "4/5", "2" },
    times = { 0.001, 1.0, -1000.0, 1e9 } },
  { what = "a ball of a micrometre", r = "9.5367431640625e-7", J = "3.637978807091713e-13", turntable = "3.5",
    omega = "1, 2, 3", position = "0, 0, 0", W = { "1", "2" }, z = { "0", "0" }, R = "1/1048576", Omega = "7/2",
    small = 2.0 ^ -20, times = { 0.001, 0.9, 1.1, 100.5 } },
  { what = "a ball of a thousand kilometres", r = "1048576", J = "439804651110.4", turntable = "3.5",
    omega = "1, 2, 3", position = "0, 0, 0", W = { "1", "2" }, z = { "0", "0" }, R = "1048576", Omega = "7/2",
    small = 1.0, times = { 0.001, 0.9, 1.1, 100.5 } },
} do
  local c = { R = R.lift(case.R), Omega = R.parse(case.Omega) or R.lift(case.Omega), W = { R.lift(case.W[1]),
    R.lift(case.W[2]) }, z = { R.lift(case.z[1]), R.lift(case.z[2]) },
    pull = { R.lift(case.pull or "0"), R.zero } }
  for _, real in ipairs { "double", "float" } do
    local epsilon, times = real == "float" and 2.0 ^ -24 or 2.0 ^ -53, {}
    for i, t in ipairs(case.times) do
      times[i] = real == "float" and string.unpack("f", string.pack("f", t)) or t
    end
    local rows, why = measured(text(case, case.tilted), times, "--real " .. real)
    local worst = 0.0
    for i, t in ipairs(times) do
      local want = exact(c, R.fromdouble(t))
      for _, kind in ipairs { { 1, 2 }, { 3, 4 }, { 5, 6 } } do
        local size = kind[1] == 5 and 2.0 or case.small or 1.0 -- of the start
        for _, k in ipairs(kind) do size = math.max(size, math.abs(R.todouble(want[k]))) end
        for _, k in ipairs(kind) do
          local got = rows and rows[i][k] or 0 / 0
          if k == 5 and case.tilted then got = rows and 0.8 * rows[i][5] + 0.6 * rows[i][7] or 0 / 0 end -- W.e1
          local ratio = math.abs(got - R.todouble(want[k])) / (ROUNDINGS * epsilon * size)
          worst = ratio <= worst and worst or ratio == ratio and ratio or math.huge
        end
      end
    end
    tap.ok(rows and worst <= 1, string.format("%s, %s: to %d roundings (%.2g of that)", case.what, real, ROUNDINGS,
      worst), why)
  end
end

-- ---- what has none ----

local function said(effect)
  program.write(dir .. "/none.lua", 'return scene { name = "none", body = solid.sphere { r = 0.1, mass = 1 }, ' ..
    "effects = { " .. effect .. " } }\n")
  program.shell(string.format("%s explain %s/none.lua >%s/said 2>&1", binary, dir, dir))
  return program.read(dir .. "/said")
end

tap.like(said "effect.plane { surface = contact.sphere { r = 0.1 }, rolling_resistance = { viscous = 0.1 } }",
  "not the homogeneous ball that rolls: a resistance acts on the ball", "a resistance")
tap.like(said('effect.plane { surface = contact.sphere { r = 0.1 }, law = "sliding", friction = { coulomb = 0.1, ' ..
  "smoothing = 0.01 } }"), "only viscous friction on a level plane at rest has a closed form", "Coulomb's friction")
tap.like(said "effect.plane { surface = contact.sphere { r = 0.1 } }, effect.damping { c = 0.1 }",
  "damping acts on the ball", "a damping")

tap.done(program.finish())
