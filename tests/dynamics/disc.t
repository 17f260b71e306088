#!/usr/bin/env lua5.4
-- disc.t -- rolling discs: swing of the tilt, turn of the contact point, linear integrals, small nutations.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracles: tests/reference/disc.lua, by Legendre functions of 50 digits (sharp edges); the tables of 32 digits behind
-- tests/reference/plane.h; the library's motion for rounded edges, which knows neither tilt nor integrals; and the
-- classical formulas of nearly flat falls and of small nutations.
-- A swing is a chain of 10 to 700 pieces, each rounded like a number or two: sqrt(700) half units are 3e-15 of it, and
-- what starts near a double root magnifies them a little.  Asked for 2e-14.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local json = require "tests.json"
local disc = require "generator.dynamics.disc"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local BAR, WHY = 2e-14, "roundings of 700 pieces"

local function tilt(z) return math.atan(z.s, z.c) end

-- ---- Legendre functions of 50 digits ----

local units = { 1, 1e-30, 1e30 } -- of mass: its scale does not matter, nor do those of length and time
for n, row in ipairs(dofile "tests/reference/disc.lua") do
  local I1, I3, G, theta, rate, a, w = table.unpack(row)
  local want = table.move(row, 8, 13, 1, {})
  local worst = 0.0
  for _, unit in ipairs(units) do
    local length, time = unit ^ 0.9, unit ^ 0.3
    local d = disc.of(I1 * unit * length ^ 2, I3 * unit * length ^ 2, unit, length, 0.0, G * length / time ^ 2)
    local z = { s = math.sin(theta), c = math.cos(theta), a = a / time, w = w / time }
    local f, spin, precession = disc.swing(d, z, rate / time), disc.integrals(d, z)
    local got = { tilt(f.least), tilt(f.greatest), f.period / time, f.turn, spin * time, precession * time }
    -- a turn in which the precession changes its sign, and one integral beside a large other one, are differences
    local both = math.abs(want[5]) + math.abs(want[6])
    local size = { want[1], want[2], want[3], math.max(1.0, math.abs(want[4])), both, both }
    for k, x in ipairs(got) do
      local e = math.abs(x - want[k]) / size[k]
      worst = e <= worst and worst or e == e and e or math.huge
    end
  end
  tap.ok(worst <= BAR, string.format("row %d: tilts, period, turn and integrals, least tilt %.3g", n, want[1]),
    string.format("%.3g", worst))
end

-- ---- the falls of the reference set, and ever flatter ones ----

local function scene(disc_of, omega, attitude)
  return string.format([[
return scene { name = "b", body = tensor { mass = 1, xx = %.17g, yy = %.17g, zz = %.17g },
  effects = { effect.plane { surface = contact.disc { %s }, gravity = 9.81 } },
  initial = { omega = { %.17g, %.17g, %.17g }, attitude = %s }, time = { step = 0.0005 } }
]], disc_of[1], disc_of[1], disc_of[2], disc_of[3], omega[1], omega[2], omega[3], attitude)
end

local function explained(text)
  program.write(dir .. "/b.lua", text)
  local status = program.shell(string.format("%s explain %s/b.lua --format json >%s/out 2>%s/err", binary, dir, dir,
    dir))
  if status ~= 0 then return {}, program.read(dir .. "/err") end
  local all = json.read(program.read(dir .. "/out"))
  return all.values, all
end

local UNIFORM = { 0.01, 0.02, "r = 0.2" }
local HALF = "{ quaternion = { 0.9689124217106447, 0.24740395925452294, 0, 0 } }"

-- of /events, /turn and /smallest_N: least tilt, its N, greatest tilt, its N, the time between two, the turn, least N
for _, row in ipairs {
  { "disc_fall_and_flip", { 0, 0.002, 0.001 }, 5.7318364304095577564e-5, 131271.60484386661002,
    0.50000000000000003968767744372797, 3.7658535875584470782, 0.33480943060110020480832763719497,
    402.64726087058673302, 1.361 },
  { "disc_fall_and_flip_mild", { 0, 0.2, 0.1 }, 5.7661412886977337362829497324657e-3, 1291.6210062874514111,
    0.50000000000000003968767744372797, 3.7642116020432731595, 0.33481637453170520370531318906692,
    410.88620123741662335, 1.408 } } do
  local v, all = explained(scene(UNIFORM, row[2], HALF))
  for k, key in ipairs { "tilt_least", "reaction_tilt_least", "tilt_greatest", "reaction_tilt_greatest", "tilt_period",
    "contact_turn" } do
    local want = (key == "tilt_least" or key == "tilt_greatest") and math.deg(row[2 + k]) or row[2 + k]
    tap.near(v[key] and v[key].value, want, BAR, 0, row[1] .. ": " .. key, WHY)
  end
  tap.near(v.reaction_least.value, row[9], 0, 5.1e-4, row[1] .. ": least N", "four digits")
  tap.near(v.contact_turn_flat.value, 402.49223594996215988, 1e-15, 0, row[1] .. ": its limit", "a rounding")
  tap.ok(all.closed_form.reduced:find("Legendre", 1, true), "the theorem is named")
end

-- what is left falls as theta_m ln(1/theta_m): of the order of that, and never an error of its own
for _, body in ipairs { { UNIFORM, 180 * math.sqrt(5) }, { { 0.02, 0.04, "r = 0.2" }, 180 * math.sqrt(3) } } do
  local before
  for k = 4, 12, 2 do
    local v = explained(scene(body[1], { 0, 3.5 * 10.0 ^ (2 - k), 0 }, HALF))
    local flat, away = math.rad(v.tilt_least.value), math.rad(v.contact_turn.value - body[2])
    local part = math.abs(away) / (flat * math.log(1 / flat))
    -- 2^-53 of 400 deg is 4e-16 rad; between two of these the bracket changes by a part of its logarithm
    tap.ok(flat < 10.0 ^ (3 - k) and part < 10 and (not before or math.abs(away) < before / 30),
      string.format("fallen to %.2g rad: %.8f deg", flat, v.contact_turn.value), part)
    before = math.max(math.abs(away), 3e-13)
  end
end

-- ---- rounded edges: the library's motion ----

local COIN, FAT = { 3.1e-5, 6e-5, "r = 0.0115, edge = 0.001" }, { 0.03, 0.02, "r = 0.1, edge = 0.08" }

-- {s, c, a, w}, theta' and the precession of a row qw qx qy qz wx wy wz
local function seen(q)
  local g = { 2 * (q[2] * q[4] - q[1] * q[3]), 2 * (q[3] * q[4] + q[1] * q[2]),
    q[1] ^ 2 - q[2] ^ 2 - q[3] ^ 2 + q[4] ^ 2 }
  local s = math.sqrt(g[1] ^ 2 + g[2] ^ 2)
  return { s = s, c = g[3], a = (q[5] * g[1] + q[6] * g[2]) / s, w = q[7] }, (q[5] * g[2] - q[6] * g[1]) / s,
    math.atan(q[2] * q[4] + q[1] * q[3], -(q[3] * q[4] - q[1] * q[2]))
end

local tilting = "(qx*qz - qw*qy)*wy - (qy*qz + qw*qx)*wx"

for _, case in ipairs { { COIN, { 3, -10, 32 }, 1.0 }, { COIN, { 1, 0.3, -0.2 }, 0.4 }, { FAT, { 0.2, 0.3, 6 }, 1.4 },
  { FAT, { -2, 1, -3 }, 2.3 } } do
  local text = scene(case[1], case[2], string.format('{ axis = "x", angle = quantity(%.17g, "rad") }', case[3]))
  local v, all = explained(text)
  local what = string.format("edge %s from %.1f rad", case[1][3]:match "edge = ([%d.]+)", case[3])
  tap.ok(all.closed_form and all.closed_form.reduced:find("rounded", 1, true), what .. ": explained", all)
  program.write(dir .. "/b.lua", (text:gsub("time =", string.format("events = {{ name = %q, when = %s }}, time =",
    "here", tilting))))
  local least, samples, period = math.huge, 0, v.tilt_period.value
  program.shell(string.format("%s run %s/b.lua --engine general --until %.17g --every %.17g --columns t,N >%s/out " ..
    "2>%s/err", binary, dir, period, period / 400, dir, dir))
  for N in program.read(dir .. "/out"):gmatch "\n[%d.e+-]+,([%d.e+-]+)" do
    least, samples = math.min(least, tonumber(N)), samples + 1
  end
  -- the nearest sample is at most 1/800 of a period from the least N: 2 pi/800 squared, halved, is 3e-5 of its swing,
  -- and more where it has overtones
  local swing = math.max(v.reaction_tilt_least.value, v.reaction_tilt_greatest.value) - v.reaction_least.value
  local above = (least - v.reaction_least.value) / swing
  tap.ok(samples >= 400 and above > -1e-11 and above < 1e-3, what .. ": least N", string.format("%d, %g", samples,
    above))
  local until_t = 2.2 * period
  program.shell(string.format("%s run %s/b.lua --engine general --until %.17g --every %.17g --columns t,q,w " ..
    "--events %s/events >%s/out 2>%s/err", binary, dir, until_t, until_t / 9, dir, dir, dir))
  local out, times, kept = program.read(dir .. "/out"), {}, 0.0
  for t in (program.read(dir .. "/events") or ""):gmatch "here,([%d.e-]+)" do times[#times + 1] = t end
  for line in out:gmatch "\n([%d.e-]+,[%d.,e+-]+)" do
    local x = {}
    for word in line:gmatch "[^,]+" do x[#x + 1] = tonumber(word) end
    if #x == 8 then
      local size = case[1] == COIN and { 3.1e-5, 6e-5, 0.0115, 0.001 } or { 0.03, 0.02, 0.1, 0.08 }
      local d = disc.of(size[1], size[2], 1.0, size[3], size[4], 9.81)
      local spin, precession = disc.integrals(d, (seen(table.move(x, 2, 8, 1, {}))))
      kept = math.max(kept, math.abs(spin - v.upright_spin.value), math.abs(precession - v.upright_precession.value))
    end
  end
  -- columns are doubles: what a unit of the attitude moves, 1e-14 of the rates
  tap.ok(kept > 0 and kept < 1e-13 * (math.abs(v.upright_spin.value) + math.abs(v.upright_precession.value)),
    what .. ": both integrals are kept", kept)
  tap.ok(#times >= 3, what .. ": three extremes")
  if #times >= 3 then
    program.shell(string.format("%s run %s/b.lua --engine general --at %s --columns q,w,N >%s/out 2>%s/err", binary,
      dir, table.concat(times, ",", 1, 3), dir, dir))
    local states = {}
    for line in program.read(dir .. "/out"):gmatch "\n([%d.,e+-]+)" do
      local x = {}
      for word in line:gmatch "[^,]+" do x[#x + 1] = tonumber(word) end
      if #x == 8 then states[#states + 1] = x end
    end
    local first, _, from = seen(states[1])
    local second = seen(states[2])
    local _, _, to = seen(states[3])
    local low, high = first, second
    local N_low, N_high = states[1][8], states[2][8]
    if tilt(low) > tilt(high) then low, high, N_low, N_high = high, low, N_high, N_low end
    local turned = math.rad(v.contact_turn.value) - (to - from)
    -- an event stands to some ten roundings of t; angles are columns of doubles
    tap.near(times[3] - times[1], v.tilt_period.value, 1e-13, 1e-14, what .. ": period", "the events' own")
    tap.near(math.deg(tilt(low)), v.tilt_least.value, 1e-13, 0, what .. ": least tilt", "roundings of q")
    tap.near(math.deg(tilt(high)), v.tilt_greatest.value, 1e-13, 0, what .. ": greatest tilt", "roundings of q")
    tap.near(N_low, v.reaction_tilt_least.value, 1e-11, 0, what .. ": N there", "differences of accelerations")
    tap.near(N_high, v.reaction_tilt_greatest.value, 1e-11, 0, what .. ": and there", "the same")
    tap.near(turned - 2 * math.pi * math.floor(turned / 2 / math.pi + 0.5), 0, 0, 1e-11, what .. ": turn",
      "the rate of the turn times the events' own error")
  end
end

-- ---- steady rolling ----

-- (I1 + m R^2) Omega^2 of a sharp disc, s and c of the tilt, p the precession: the second derivative of the energy
local function formula(I1, I3, G, s, c, p, w)
  return (((I1 + 1) * s * s + 3 * I1 * c * c) * p * p - (3 * I3 + 1) * w * p * c + (I3 + 1) * I3 / I1 * w * w - G * s) /
    (I1 + 1)
end
for _, case in ipairs { { 0.25, 0.5, 0.9, 2.0 }, { 0.5, 1.0, 2.0, -3.0 }, { 2.0, 0.75, 0.05, 5.0 } } do
  local I1, I3, theta, p = table.unpack(case)
  local s, c, G = math.sin(theta), math.cos(theta), 10.0
  local w = (I1 * p * p * s * c - G * c) / ((I3 + 1) * p * s)
  local d, z = disc.of(I1, I3, 1.0, 1.0, 0.0, G), { s = s, c = c, a = p * s, w = w }
  local square = formula(I1, I3, G, s, c, p, w)
  tap.near(disc.nutation(d, z), square, 1e-14, 0, string.format("nutation at %.2f rad", theta), "a dozen roundings")
  tap.near(disc.reaction(d, z), G, 1e-14, 0, "N = m G", "a dozen roundings")
  for _, rate in ipairs { 1e-5, 1e-9, 1e-13, 0 } do
    local f = disc.swing(d, z, rate)
    -- the period differs by the square of the amplitude, 1e-10
    local moved = math.abs(tilt(f.least) - theta) + math.abs(tilt(f.greatest) - theta)
    tap.ok(moved < 10 * (rate + 1e-15) and
      math.abs(f.period * math.sqrt(square) / (2 * math.pi) - 1) < 1e-14 + 10 * rate ^ 2 / s ^ 2,
      string.format("disturbed by %g rad/s: the period of the nutation", rate), f.period)
  end
end

-- ---- limits ----

local d = disc.of(0.25, 0.5, 1.0, 1.0, 0.0, 10.0)
tap.is(disc.swing(d, { s = 0.8, c = 0.6, a = 0.0, w = 0.0 }, 0.0).least, nil, "without any turn it falls flat")
local straight = disc.swing(d, { s = 1.0, c = 0.0, a = 0.0, w = 3.0 }, 0.0)
tap.ok(straight.least == straight.greatest and straight.period, "rolling straight its tilt does not change")
local slow = disc.swing(d, { s = 1.0, c = 0.0, a = 0.0, w = 1.8 }, 0.0)
tap.ok(slow.least == slow.greatest and not slow.period, "nor when that is unstable, but no small swing has a period")
tap.ok(disc.nutation(d, { s = 1.0, c = 0.0, a = 0.0, w = 1.8 }) < 0 and
  disc.nutation(d, { s = 1.0, c = 0.0, a = 0.0, w = 1.9 }) > 0, "stable above sqrt(G/(3 R))")
local v = explained(scene(UNIFORM, { 0, 0, 0 }, HALF))
tap.is(v.tilt_least and v.tilt_least.value, 0.0, "explained: it falls flat")
for _, case in ipairs { { "turntable = 1", "the plane turns" }, { "normal = { 1, 0, 5 }", "the plane is not level" },
  { "spinning = { viscous = 0.01 }", "the plane resists" } } do
  local _, all = explained((scene(UNIFORM, { 0, 1, 0 }, HALF):gsub("gravity =", case[1] .. ", gravity =")))
  local said
  for _, o in ipairs(all.closed_form and all.closed_form.others or {}) do
    said = said or o.reason:find(case[2], 1, true)
  end
  tap.ok(said and not all.values.tilt_least, case[2] .. ": it says why not")
end

program.finish()
tap.done()
