#!/usr/bin/env lua5.4
-- split.t - the splitting steppers: order conditions to 38 digits, and what the emitted ones do.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A product of exp(a1 A) exp(b1 B) .. has order p iff the coefficient of every word of at most p letters A, B is that
-- of exp(A + B), one over the factorial of its length (the exponentials as series in letters that do not commute): 126
-- words for order 6, computed here with rationals.  Order (8, 4): also, in words with one B, sum b c^k = 1/(k + 1) for
-- k < 8, c the sum of the drifts before (McLachlan 1995, BIT 35, 258).
-- The quick tier takes a part of its cases.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local R = require "generator.algebra.rational"
local split = require "generator.methods.split"

-- All words of length n.
local function words(n)
  if n == 0 then return { "" } end
  local list = {}
  for _, w in ipairs(words(n - 1)) do
    list[#list + 1], list[#list + 2] = w .. "A", w .. "B"
  end
  return list
end

-- The largest defect of the words of each length up to p.
local function defects(k, p)
  local series, all = {}, {}
  for n = 0, p do
    for _, w in ipairs(words(n)) do
      all[#all + 1], series[w] = w, n == 0 and R.one or R.zero
    end
  end
  local function multiply(letter, x) -- by exp(x letter), from the right
    local new = {}
    for _, w in ipairs(all) do
      local sum, factor, j = series[w], R.one, 0
      while string.sub(w, -1) == letter do
        w = string.sub(w, 1, -2)
        j = j + 1
        factor = factor * x / R.new(j)
        sum = sum + factor * series[w]
      end
      new[#new + 1] = R.round(sum, 300)
    end
    for i, w in ipairs(all) do series[w] = new[i] end
  end
  for i, a in ipairs(k.a) do
    multiply("A", a)
    if k.b[i] then multiply("B", k.b[i]) end
  end
  local out, factorial = {}, R.one
  for n = 1, p do
    factorial, out[n] = factorial * R.new(n), 0.0
    for _, w in ipairs(words(n)) do
      out[n] = math.max(out[n], math.abs(R.todouble(series[w] - R.one / factorial)))
    end
  end
  return out
end

for _, row in ipairs { { "strang", 2 }, { "M84", 4 }, { "S10", 6 } } do
  local name, order = row[1], row[2]
  local k = split.coefficients[name]
  local d, worst = defects(k, order + 1), 0.0
  for n = 1, order do worst = math.max(worst, d[n]) end
  -- 40 digits are written; 20 factors of size 1
  tap.ok(worst < 1e-38, name .. ": all words of up to " .. order .. " letters", string.format("%.2g", worst))
  tap.ok(d[order + 1] > 1e-6, name .. ": and not those of one letter more", string.format("%.2g", d[order + 1]))
  local palindrome = true
  for i, a in ipairs(k.a) do palindrome = palindrome and a == k.a[#k.a + 1 - i] end
  for i, b in ipairs(k.b) do palindrome = palindrome and b == k.b[#k.b + 1 - i] end
  tap.ok(palindrome and #k.a == #k.b + 1, name .. " reads the same backwards")
end

do
  local k, worst, beyond = split.coefficients.M84, 0.0, nil
  for n = 0, 8 do
    local sum = R.zero
    for i, b in ipairs(k.b) do
      local power = R.one
      for _ = 1, n do power = power * k.c[i] end
      sum = sum + b * power
    end
    local d = math.abs(R.todouble(sum - R.one / R.new(n + 1)))
    if n < 8 then worst = math.max(worst, d) else beyond = d end
  end
  tap.ok(worst < 1e-38 and beyond > 1e-6, "M84 has order 8 in words with one kick",
    string.format("%.2g, %.2g beyond", worst, beyond))
end

-- ---- the emitted steppers ----

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()

-- Measures by method and key.
local function measured(text, real, only, flags, arguments)
  program.write(dir .. "/top.lua", text)
  local methods = only and "split2,taylor" or "split2,split4,split6,taylor"
  local status = program.shell(string.format("cd %s && rm -rf top && POLHODE_SOURCE=$OLDPWD $OLDPWD/%s gen top.lua " ..
    "--real %s --order 20 --method %s -o top > log 2>&1", dir, binary, real, methods))
  if status ~= 0 then return nil, program.read(dir .. "/log") end
  status = program.shell(string.format("cc -std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion " ..
    "-Wshadow -Werror -c %s/top/top.c -o %s/split > %s/log 2>&1", dir, dir, dir))
  if status ~= 0 then return nil, program.read(dir .. "/log") end
  status = program.shell(string.format("cc -std=c11 -O2 -ffp-contract=off -I%s/top %s %s tests/methods/split.c " ..
    "%s/top/top.c -o %s/split -lm > %s/log 2>&1 && %s/split %s > %s/out", dir, only and "-DONLY_2" or "", flags, dir,
    dir, dir, dir, arguments, dir))
  if status ~= 0 then return nil, program.read(dir .. "/log") end
  local out = {}
  for line in string.gmatch(program.read(dir .. "/out"), "[^\n]+") do
    local what, name, numbers = string.match(line, "^(%S+) (%S+) (.*)$")
    local list = {}
    for x in string.gmatch(numbers, "%S+") do list[#list + 1] = tonumber(x) end
    out[name] = out[name] or {}
    out[name][what] = list
  end
  return out
end

local function scene(body, effects, initial, more)
  return string.format('return scene { name = "top", body = %s, effects = { %s }, initial = { %s }, %s }', body,
    effects, initial, more or "")
end

local attitude = 'attitude = { axis = "x", angle = 0.9 }'
local cylinder = "solid.cylinder { r = 0.03, h = 0.12, mass = 1 }"
local brick = "solid.box { x = 0.2, y = 0.1, z = 0.05, mass = 2.4 }"
local below = "origin = {0, 0, -0.1}"

-- name, scene, T, steps; driven: no energy to keep; point: nothing turns; only: the orders 4 and 6 are refused
local rows = {
  { "heavy symmetric top", scene(cylinder, "effect.gravity { g = 1 }", "omega = {0.2, 0.3, 5}, " .. attitude, below),
    1, 12 },
  { "heavy asymmetric top", scene(brick, "effect.gravity { g = 0.5 }", "omega = {0.3, 5, 0.2}, " .. attitude, below),
    1, 12 },
  { "symmetric about an oblique axis", scene("solid.box { x = 0.1, y = 0.1, z = 0.1, mass = 1 }",
    "effect.gravity { g = 2 }", "omega = {2, -1, 3}, " .. attitude, 'origin = "corner"'), 1, 12 },
  { "heavy top on no principal axis", scene(brick .. ":turned { axis = {1, 2, 3}, angle = 0.8 }",
    "effect.gravity { g = 0.5 }", "omega = {0.3, 5, 0.2}, " .. attitude, below), 1, 12 },
  { "full tensor, nearly symmetric, turned", scene("tensor { mass = 1, com = {0, 0, 0}, xx = 2, yy = 2.000001, " ..
    "zz = 3, xy = 0.0000001, xz = 0.5, yz = -0.25 }", "effect.magnetic { moment = {1, 2, 3}, field = {1, 0, 1} }",
    "omega = {1, 2, 3}, " .. attitude), 1, 12 },
  { "damped brick, turned", scene(brick .. ":turned { axis = {1, 2, 3}, angle = 0.8 }",
    "effect.damping { c = {0.001, 0.002, 0.003} }", "omega = {1, 2, 3}"), 1, 12, only = true },
  { "sphere under an inertial torque", scene("solid.sphere { r = 0.1, mass = 1 }",
    "effect.torque { inertial = {0.01, 0.02, -0.01} }", "omega = {1, 2, -3}, " .. attitude), 1, 8, driven = true },
  { "heavy gyrostat", scene(cylinder, "effect.gravity { g = 1 }, effect.rotor { axis = {0, 0, 2}, momentum = 0.02 }",
    "omega = {0.2, 0.3, 2}, " .. attitude, below), 1, 12 },
  { "sphere with a rotor under an inertial torque", scene("solid.sphere { r = 0.1, mass = 1 }",
    "effect.torque { inertial = {0.01, 0.02, -0.01} }, effect.rotor { axis = {1, 2, 2}, momentum = 0.02 }",
    "omega = {1, 2, -3}, " .. attitude), 1, 8, driven = true },
  { "heavy rod", scene("rod.straight { length = 0.3, mass = 1 }", "effect.gravity { g = 2 }",
    "omega = {1, 2, 3}, " .. attitude, below), 1, 10 },
  { "brick under control and an inertial torque", scene(brick, "effect.control {}, " ..
    "effect.torque { inertial = {0.01, 0.02, -0.01} }", "omega = {1, 2, 3}"), 1, 12, driven = true },
  { "dipole in a turning field, torque of time", scene(brick, "effect.magnetic { moment = {0.1, 0.2, 0.3}, " ..
    "rotating = {0.1, 0, 0.05}, rate = 3 }, effect.torque { body = {0.01*sin(2*t), 0.02, 0.01*t} }",
    "omega = {1, 2, 3}, " .. attitude), 1, 12, driven = true },
  { "book on a spring", scene(brick, "effect.translation { stiffness = {2, 3, 5} }", "omega = {1, 2, 3}, " ..
    "position = {0.1, 0, 0}, velocity = {0, 1, 2}"), 1, 12 },
  { "point on a spring", scene(brick, "effect.translation { stiffness = {2, 3, 5} }", "position = {0.1, 0, 0}, " ..
    "velocity = {0, 1, 2}"), 1, 12, point = true },
  { "damped brick", scene(brick, "effect.damping { c = {0.001, 0.002, 0.003} }", "omega = {1, 2, 3}"), 1, 12,
    only = true },
  { "friction and drag", scene(brick, "effect.friction { torque = 0.002, smoothing = 1 }, effect.drag { c = 0.001 }",
    "omega = {1, 2, 3}"), 1, 12, only = true },
  { "thrown book with drag", scene(brick, "effect.translation { drag = 0.1 }", "omega = {1, 2, 3}, " ..
    "velocity = {0, 1, 20}"), 1, 12, only = true },
}

local HALVINGS = 2
local ROUNDING = 1e-12 -- below this, errors of some hundred steps are roundings

for _, row in ipairs(tier.every(9, rows)) do
  local name, text, T, steps = table.unpack(row)
  local got, why = measured(text, "double", row.only, row.point and "" or "-DTURNS",
    string.format("%g %d %d", T, steps, HALVINGS))
  if tap.ok(got ~= nil, name .. ": is emitted and runs", why) then
    for _, order in ipairs(row.only and { 2 } or { 2, 4, 6 }) do
      local m = got["split" .. order]
      local e = m.order
      local last = e[#e - 1] / e[#e]
      -- the next term of the error is h^2 (a few times) smaller: within a third of 2^order
      local fits = last > 2 ^ order / 1.5 and last < 2 ^ order * 1.5
      tap.ok(fits or e[#e] < ROUNDING, name .. ": halving h divides split" .. order .. "'s error by 2^" .. order,
        string.format("%.3g %.3g %.3g: %.3g", e[1], e[2], e[3], last))
      if not row.only then
        -- some hundred rotations forth and back, each with a few roundings, in a state of size 1
        tap.ok(m.back[1] <= 1e-13, name .. ": a step of -h undoes one of h, split" .. order, tostring(m.back[1]))
      end
      tap.ok(m.drift[3] <= 4e-15, name .. ": |q| stays 1, split" .. order, tostring(m.drift[3]))
      if not row.only and not row.driven then
        -- bounded: the last tenth is no worse than the first, but for roundings that walk, sqrt(1e6 operations)
        tap.ok(m.drift[2] <= 1.5 * m.drift[1] + 1e-12, name .. ": the energy does not drift, split" .. order,
          string.format("%.3g at first, %.3g at last", m.drift[1], m.drift[2]))
      end
    end
  end
end

-- free motion: |L| to rounding, whatever the step; exact for a symmetric body
for _, row in ipairs(tier.every(5, {
  { "free brick", scene(brick, "", "omega = {0.3, 5, 0.2}") },
  { "free brick about a corner", scene(brick, "", "omega = {0.3, 5, 0.2}", 'origin = "corner"') },
  { "free cylinder", scene(cylinder, "", "omega = {0.3, 5, 0.2}"), exact = true },
  { "free cube about its corner", scene("solid.box { x = 0.1, y = 0.1, z = 0.1, mass = 1 }", "",
    "omega = {0.3, 5, 0.2}", 'origin = "corner"'), exact = true },
  { "free sphere", scene("solid.sphere { r = 0.1, mass = 1 }", "", "omega = {0.3, 5, 0.2}"), exact = true },
})) do
  local got, why = measured(row[2], "double", false, "-DTURNS", "1 12 2")
  if tap.ok(got ~= nil, row[1] .. ": is emitted and runs", why) then
    for _, order in ipairs { 2, 4, 6 } do
      local m = got["split" .. order]
      -- 1e5 steps of about 100 roundings of 1e-16 that walk: 3e-13
      tap.ok(m.drift[4] <= 1e-12, row[1] .. ": |L| stays, split" .. order, tostring(m.drift[4]))
      local e = m.order
      tap.ok(row.exact and e[1] <= 2e-14 or not row.exact and (e[3] < ROUNDING or e[2] / e[3] > 2 ^ order / 1.5),
        row[1] .. (row.exact and ": exact" or ": converges") .. ", split" .. order,
        string.format("%.3g %.3g %.3g", e[1], e[2], e[3]))
    end
  end
end

-- free motion with three moments: order 10, energy and |L| to rounding at any step, whatever the scale
for _, row in ipairs(tier.every(5, {
  { "brick", brick, "{0.3, 5, 0.2}", "4", "12" },
  { "brick, 1e-30 rad/s", brick, "{0.3e-30, 5e-30, 0.2e-30}", "4e30", "12" },
  { "brick, 1e30 rad/s", brick, "{0.3e30, 5e30, 0.2e30}", "4e-30", "12" },
  { "brick near the separatrix", brick, "{1e-7, 5, 0}", "4", "12" },
  { "brick about its middle axis", brick, "{0, 5, 0}", "4", "12" },
  { "brick at rest", brick, "{0, 0, 0}", "4", "12" },
  { "almost a square plate", "solid.box { x = 0.2, y = 0.2000001, z = 0.05, mass = 2.4 }", "{3, 2, 5}", "2", "12" },
  { "needle", "solid.box { x = 2, y = 1e-4, z = 2e-4, mass = 2.4 }", "{3, 2, 5}", "2", "12" },
})) do
  local name, body, omega, T, n = table.unpack(row)
  local got, why = measured(scene(body, "", "omega = " .. omega .. ", " .. attitude), "double", false, "-DTURNS",
    T .. " " .. n .. " 1")
  if tap.ok(got ~= nil, name .. ": is emitted and runs", why) then
    local m, rest = got.split2, name == "brick at rest"
    local ratio = m.order[1] / m.order[2]
    -- the next term of the error is 1/10 of it; or roundings alone
    tap.ok(m.order[1] < ROUNDING or ratio > 2 ^ 10 / 1.5 and ratio < 2 ^ 10 * 1.5, name .. ": order 10",
      string.format("%.3g %.3g: %.4g", m.order[1], m.order[2], ratio))
    tap.ok(m.back[1] <= 1e-13, name .. ": a step back undoes it", tostring(m.back[1]))
    -- 1e5 steps of some 30 roundings of 1e-16 that walk: 2e-13
    if not rest then -- nothing to divide by
      tap.ok(m.drift[1] <= 1e-12 and m.drift[2] <= 1e-12 and m.drift[4] <= 1e-12, name .. ": energy and |L| stay",
        string.format("%.3g %.3g %.3g", m.drift[1], m.drift[2], m.drift[4]))
    end
  end
end

-- float: everything in 24 bits
do
  local got, why = measured(rows[2][2], "float", false, "-DTURNS", "1 12 0")
  if tap.ok(got ~= nil, "float: is emitted and runs", why) then
    for _, order in ipairs { 2, 4, 6 } do
      local m = got["split" .. order]
      -- some hundred rotations of a few 6e-8 each, walking
      tap.ok(m.back[1] <= 2e-5, "float: a step of -h undoes one of h, split" .. order, tostring(m.back[1]))
      tap.ok(m.drift[3] <= 2e-6, "float: |q| stays 1, split" .. order, tostring(m.drift[3]))
      if order > 2 then tap.ok(m.order[1] <= 1e-4, "float: the motion, split" .. order, tostring(m.order[1])) end
    end
  end
end

-- ---- what cannot be split is refused by name ----

for _, row in ipairs(tier.every(5, {
  { "damping", scene(brick, "effect.damping { c = 0.001 }", "omega = {1, 2, 3}"),
    "split4: damping depends on the rates" },
  { "a driven wheel", scene(brick, "effect.wheel { axis = {0, 0, 1}, inertia = 0.001, speed = 1, torque = 0.01, " ..
    "included = true }", "omega = {1, 2, 3}"), "wheel has a state of its own" },
  { "a turning frame", scene(brick, "effect.rotating_frame { rate = {0, 0, 1} }", "omega = {1, 2, 3}, " ..
    "position = {0, 0, 1}"), "the base frame turns" },
  { "an oblique rotor", scene(cylinder, "effect.rotor { axis = {1, 0, 0}, momentum = 1 }", "omega = {1, 2, 3}"),
    "the rotor is not along the symmetry axis" },
  { "a rotor in an asymmetric body", scene(brick, "effect.rotor { axis = {1, 0, 0}, momentum = 1 }",
    "omega = {1, 2, 3}"), "an asymmetric body with a rotor" },
})) do
  local got, why = measured(row[2], "double", false, "", "1 12 0")
  tap.ok(got == nil and string.find(why, row[3], 1, true), row[1] .. " is refused by name", why)
end

tap.done()
