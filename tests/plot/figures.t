#!/usr/bin/env lua5.4
-- figures.t - the curves of a motion's pictures against independent formulas: polhode, herpolhode, cones, levels.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The motion is this test's own: Euler's equations by its own RK4 with steps so small that its error is below 1e-12.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local cones = require "generator.plot.cones"
local curve = require "generator.plot.curve"
local levels = require "generator.plot.levels"
local panels = require "generator.plot.panels"
local plane = require "generator.plot.plane"
local quadric = require "generator.plot.quadric"
local sampling = require "generator.plot.sampling"
local space = require "generator.plot.space"

local I = { 1.0, 2.0, 2.5 }

local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end

local function rate(x) -- w' and q'
  local w, q = { x[1], x[2], x[3] }, { x[4], x[5], x[6], x[7] }
  local n = cross({ I[1] * w[1], I[2] * w[2], I[3] * w[3] }, w)
  return { n[1] / I[1], n[2] / I[2], n[3] / I[3],
    (-q[2] * w[1] - q[3] * w[2] - q[4] * w[3]) / 2, (q[1] * w[1] + q[3] * w[3] - q[4] * w[2]) / 2,
    (q[1] * w[2] + q[4] * w[1] - q[2] * w[3]) / 2, (q[1] * w[3] + q[2] * w[2] - q[3] * w[1]) / 2 }
end

local function step(x, h)
  local function moved(k, s)
    local y = {}
    for i = 1, 7 do y[i] = x[i] + s * k[i] end
    return y
  end
  local a = rate(x)
  local b = rate(moved(a, h / 2))
  local c = rate(moved(b, h / 2))
  local d, y = rate(moved(c, h)), {}
  for i = 1, 7 do y[i] = x[i] + h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]) end
  return y
end

local function motion(w0, T, n)
  local x, list, h = { w0[1], w0[2], w0[3], 1.0, 0.0, 0.0, 0.0 }, {}, T / n
  for i = 0, n do
    local w, q = { x[1], x[2], x[3] }, { x[4], x[5], x[6], x[7] }
    local L = { I[1] * w0[1], I[2] * w0[2], I[3] * w0[3] } -- constant in space
    if i % 5 == 0 then list[#list + 1] = panels.complete { t = i * h, w = w, q = q, L = L, energy = 1.0 } end
    x = step(x, h)
  end
  return list
end

local small = "RK4 with steps of 1e-3 and rates of 1: errors below 1e-12 in the run"

local function course(samples)
  return { samples = samples, conserved = { L = true, ["T+V"] = true }, sequence = "zxz",
    body = { moments = I, axes = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, kind = "diagonal" },
    along = function(w) return { I[1] * w[1], I[2] * w[2], I[3] * w[3] } end,
    momentum = function(s) return { I[1] * s.w[1], I[2] * s.w[2], I[3] * s.w[3] } end }
end

-- What quadric.draw was given by a panel.
local function given(c, name)
  local kept, real = nil, quadric.draw
  quadric.draw = function(_, _, q) kept = q end
  panels.of(c, { name })[1][1].draw(nil, nil)
  quadric.draw = real
  return kept
end

for _, w0 in ipairs { { 1.0, 0.2, 0.1 }, { 0.1, 0.3, 1.0 }, { 0.02, 1.0, 0.01 } } do
  local name = string.format("from (%g, %g, %g)", w0[1], w0[2], w0[3])
  local c = course(motion(w0, 20, 20000))
  tap.is(panels.refused(c, "polhode"), nil, name .. ": a free body has a polhode")
  local T2, L2 = 0, 0
  for i = 1, 3 do T2, L2 = T2 + I[i] * w0[i] ^ 2, L2 + (I[i] * w0[i]) ^ 2 end

  local q, one, two = given(c, "polhode"), 0.0, 0.0
  for _, p in ipairs(q.points) do
    local energy, momentum = 0, 0
    for i = 1, 3 do
      energy, momentum = energy + (p[i] / q.a[i]) ^ 2, momentum + I[i] ^ 2 * p[i] ^ 2
    end
    one, two = math.max(one, math.abs(energy - 1)), math.max(two, math.abs(momentum / L2 - 1))
  end
  tap.near(one, 0, 0, 1e-11, name .. ": the polhode lies on the ellipsoid that is drawn", small)
  tap.near(two, 0, 0, 1e-11, name .. ": and on that of the momentum", small)
  for i = 1, 3 do tap.near(q.a[i] ^ 2 * I[i], T2, 1e-15, 0, name .. ": half axis " .. i, "a root and a square") end

  q, one = given(c, "phase"), 0.0
  for _, p in ipairs(q.points) do
    local energy = 0
    for i = 1, 3 do energy = energy + q.c[i] * p[i] ^ 2 end
    one = math.max(one, math.abs(energy * L2 / T2 - 1), math.abs(space.length(p) - 1))
  end
  tap.near(one, 0, 0, 1e-11, name .. ": on the sphere of momentum it stays on its line of energy", small)

  -- radii of the herpolhode: |w|^2 - (2T/L)^2 along the motion itself, long enough to meet both ends
  local least, most, low, high = math.huge, 0.0, plane.radii(I, w0)
  for _, s in ipairs(c.samples) do
    local r = math.sqrt(math.max(0, space.dot(s.w, s.w) - T2 ^ 2 / L2))
    least, most = math.min(least, r), math.max(most, r)
  end
  tap.near(low, least, 1e-4, 1e-6, name .. ": the herpolhode's inner circle", "samples every 5e-3 s")
  tap.near(high, most, 1e-4, 0, name .. ": its outer circle", "samples every 5e-3 s")
  tap.ok(low <= least * (1 + 1e-9) + 1e-9 and high >= most * (1 - 1e-9), name .. ": no sample is beyond them")
  local worst = 0.0
  for i, p in ipairs(plane.herpolhode(c.samples)) do
    local s = c.samples[i]
    local r = math.sqrt(math.max(0, space.dot(s.w, s.w) - T2 ^ 2 / L2))
    worst = math.max(worst, math.abs(math.sqrt(p[1] ^ 2 + p[2] ^ 2) - r))
  end
  tap.near(worst, 0, 0, 1e-7, name .. ": and its points are that far from L", "a difference of squares, small at 1e-2")
end

-- ---- neighbours ----

for _, c in ipairs { { 1, 2, 3.5 }, { 2, 2, 3 }, { 1, 2, 2 }, { 1, 0.5, 0.4 } } do
  local name = string.format("(%g, %g, %g)", c[1], c[2], c[3])
  local worst, spread, count = 0.0, 0.0, 0
  for _, line in ipairs(levels.family(c, 4)) do
    local level
    count = count + 1
    for _, u in ipairs(line) do
      local v = c[1] * u[1] ^ 2 + c[2] * u[2] ^ 2 + c[3] * u[3] ^ 2
      level = level or v
      worst = math.max(worst, math.abs(space.length(u) - 1))
      spread = math.max(spread, math.abs(v - level))
    end
  end
  tap.ok(count == ((c[1] == c[2] or c[2] == c[3]) and 8 or 16), name .. ": four lines around each end of its axes")
  tap.near(worst, 0, 0, 1e-15, name .. ": they are on the sphere", "a few roundings")
  tap.near(spread, 0, 0, 1e-14, name .. ": each at one level", "a few roundings of 3")
  for _, line in ipairs(levels.separatrix(c)) do
    for _, u in ipairs(line) do
      spread = math.max(spread, math.abs(c[1] * u[1] ^ 2 + c[2] * u[2] ^ 2 + c[3] * u[3] ^ 2 - c[2]))
    end
  end
  tap.near(spread, 0, 0, 1e-14, name .. ": the separatrix at the middle one's", "a few roundings of 3")
end
tap.is(#levels.separatrix { 1, 2, 3 }, 2, "the separatrix is two circles")
tap.is(#levels.separatrix { 2, 2, 3 }, 0, "of a symmetric body there is none")

-- ---- cones: Landau and Lifshitz, section 33 ----

for _, case in ipairs { { 1.0, 2.0, 0.6 }, { 2.0, 1.0, 0.6 }, { 1.0, 1.9, -2.0 }, { 3.0, 0.1, 0.01 } } do
  local I1, I3, across = case[1], case[2], case[3]
  local w = { across * 0.6, across * 0.8, 1.0 }
  local c = cones.of(w, { I1 * w[1], I1 * w[2], I3 * w[3] }, { 0, 0, 2 })
  local size = math.abs(across)
  local body, theta = math.atan(size, 1.0), math.atan(I1 * size, I3)
  local name = string.format("cones of %g, %g: ", I1, I3)
  tap.near(c.body, body, 1e-14, 0, name .. "the body's has tan = w_across/w3", "two arctangents")
  tap.near(c.space, math.abs(theta - body), 1e-13, 0, name .. "the one in space the rest of L's angle",
    "a difference of arctangents")
end
do -- spin against the axis: the cone is about the axis that points along L
  local c = cones.of({ 0.1, 0, -1 }, { 0.1, 0, -2 }, { 0, 0, 1 })
  tap.is(c.axis[3], -1.0, "the axis is turned to the side of L")
  tap.near(c.body, math.atan(0.1), 1e-14, 0, "and the half angle is an acute one", "an arctangent")
end

for _, case in ipairs { { 3.2, 6.84, false, 3 }, { 2.9, 1.4, true, 10 }, { 1.43, 0.72, true, 20 }, { 41, 29, false, 1 },
  { 38, 17, true, 1 } } do
  local body, outer, inside, want = table.unpack(case)
  local c = { body = math.rad(body), space = math.rad(outer), inside = inside }
  tap.is(cones.opened(c), want, string.format("cones of %g and %g degrees are drawn %d times as wide", body, outer,
    want))
end

-- The colours of the page that `polhode view` makes: which cone has which, and what they are on light paper.
do
  local function text_of(path)
    local f = assert(io.open(path))
    local text = f:read "a"
    f:close()
    return text
  end
  local page, own = text_of "templates/page/space.js", text_of "generator/plot/sheet.lua"
  for _, cone in ipairs { { "space", "L, outer" }, { "body", "axis, body" } } do
    local theirs = page:match("cones%." .. cone[1] .. ", 1%.2%), %[%.%.%.c%.(%l)")
    local ours = text_of("generator/plot/cones.lua"):match("cone%(d, " .. cone[2] .. ', camera, map, "c(%l)"')
    tap.ok(theirs and theirs == ours, "the " .. cone[1] .. " cone has the colour that the page gives it", ours)
  end
  for _, axis in ipairs { "x", "y", "z" } do
    local r, g, b = page:match("LIGHT = .-%f[%w]" .. axis .. ": %[([%d.]+), ([%d.]+), ([%d.]+)%]")
    local hex = own:match('{ "c' .. axis .. '", "stroke:#(%x+)"')
    local off = 1.0
    if r and hex then
      off = 0.0
      for i, v in ipairs { r, g, b } do
        off = math.max(off, math.abs(tonumber(v) - tonumber(hex:sub(2 * i - 1, 2 * i), 16) / 255))
      end
    end
    tap.near(off, 0, 0, 0.006, "colour " .. axis .. " is the page's", "its numbers have two digits")
  end
end

-- ---- curves on paper ----

do
  local points = {}
  for i = 0, 2000 do points[i + 1] = { i / 4, 100 * math.sin(i / 60) + 3 * math.sin(i / 7) } end
  local kept = curve.simplified(points)
  local worst, at = 0.0, 1
  for _, p in ipairs(points) do
    while kept[at + 1] and kept[at + 1][1] < p[1] do at = at + 1 end
    local a, b = kept[at], kept[at + 1] or kept[at]
    local s = b[1] > a[1] and (p[1] - a[1]) / (b[1] - a[1]) or 0
    local ux, uy = b[1] - a[1], b[2] - a[2]
    local length = math.sqrt(ux * ux + uy * uy)
    worst = math.max(worst, length > 0 and math.abs(p[2] - a[2] - s * uy) * ux / length or 0)
  end
  tap.ok(worst <= 0.12 + 1e-9, "a simplified curve is nowhere farther off than 0.12 pixels", tostring(worst))
  tap.ok(#kept < 600, "and has far fewer points", #kept .. " of 2001")
  tap.is(curve.path { { 0, 0 }, { 10, 0 }, { 10, 4.44 }, { 9.96, 4.44 } }, "M0 0l10 0 0 4.4", "path data in tenths")
  tap.is(curve.path { { 1, 2 }, { 1, 2 } }, "M1 2l0 0", "a point is a dot")
end

do -- two corners outside, one in the middle: the lines through the rectangle
  local pieces = curve.clipped({ { -5, 5 }, { 5, 5 }, { 5, 20 }, { 8, 20 }, { 8, 2 } }, 0, 0, 10, 10)
  local said = {}
  for i, piece in ipairs(pieces) do
    local words = {}
    for k, p in ipairs(piece) do words[k] = string.format("%g %g", p[1], p[2]) end
    said[i] = table.concat(words, ", ")
  end
  tap.is(table.concat(said, " | "), "0 5, 5 5, 5 10 | 8 10, 8 2", "what leaves a rectangle is cut at its edges")
end

-- ---- sampling ----

do -- a spike of a hundredth of the time between long rests
  local calls = 0
  local function look(times)
    calls = calls + #times
    local list = {}
    for i, t in ipairs(times) do list[i] = { t = t, w = { 1 / (1 + ((t - 3.3) / 0.02) ^ 2), 0.0, 5.0 } } end
    return list
  end
  local list = sampling.adaptive(look, 10)
  local worst = 0.0
  for i = 2, #list do
    local a, b = list[i - 1], list[i]
    local t = (a.t + b.t) / 2
    worst = math.max(worst, math.abs(1 / (1 + ((t - 3.3) / 0.02) ^ 2) - (a.w[1] + b.w[1]) / 2))
  end
  tap.ok(worst < 1.1e-3, "straight lines between the samples are right to a thousandth", tostring(worst))
  tap.ok(#list < 700 and list[1].t == 0 and list[#list].t == 10, "with few of them, from end to end", #list)
  local ascending = true
  for i = 2, #list do ascending = ascending and list[i].t > list[i - 1].t end
  tap.ok(ascending, "in the order of time")
  local fast = sampling.adaptive(function(times)
    local out = {}
    for i, t in ipairs(times) do out[i] = { t = t, w = { math.sin(1e5 * t), 0.0, 0.0 } } end
    return out
  end, 10)
  tap.ok(fast[#fast].t < 10 and #fast <= 30000, "what turns too often is looked at for a part of the time",
    fast[#fast].t)
end

tap.done()
