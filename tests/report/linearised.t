#!/usr/bin/env lua5.4
-- linearised.t - the linearised top: what explain says of it against the exact motion, run and chart.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The exact motion is the general library's closed form (`run --method exact`), the linearised one is written out here,
-- so that the law is judged by neither of its own formulas.  The quick tier takes fewer bodies.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local json = require "tests.json"
local program = require "tests.cli.program"
local law = require "generator.mass.linearised"

local EPSILON = 2.0 ^ -52
local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function run(arguments)
  return program.output(string.format("timeout 120 %s %s", binary, arguments))
end

-- A body with the principal moments I on its axes and the rates w, as a file.
local function scene(I, w, more)
  local path = dir .. "/s.lua"
  program.write(path, string.format('return scene { name = "s", body = tensor { mass = 1, com = {0, 0, 0}, '
    .. 'xx = "%.17g", yy = "%.17g", zz = "%.17g", xy = 0, xz = 0, yz = 0 }, origin = {0, 0, 0}, initial = { omega = '
    .. "{%.17g, %.17g, %.17g} }%s }\n", I[1], I[2], I[3], w[1], w[2], w[3], more or ""))
  return path
end

-- Rows {t, q, w} of the motion at the times, or up to and every so often.
local function motion(path, times, method)
  local words, list = {}, {}
  for i, t in ipairs(times) do words[i] = string.format("%.17g", t) end
  local when = times.finish and string.format("--until %.17g --every %.17g", times.finish, times.every)
    or "--at " .. table.concat(words, ",")
  local status, out, err = run("run " .. path .. " --method " .. method .. " " .. when)
  if status ~= 0 then return nil, err end
  for line in out:gmatch "\n([^\n]+)" do
    local row = {}
    for cell in line:gmatch "[^,]+" do row[#row + 1] = tonumber(cell) end
    list[#list + 1] = row
  end
  return list
end

local function explained(path) return json.read((select(2, run("explain " .. path .. " --format json")))).linearised end

---- the law against the exact motion, at three amplitudes -------------------------------------------------------------

-- The rates of the linearised top about axis k, spin 1, from the book (Landau and Lifshitz, Mechanics, section 37).
local function textbook(I, k, x, y, t)
  local i, j = k % 3 + 1, (k + 1) % 3 + 1
  local a, b = (I[k] - I[j]) / I[i], (I[k] - I[i]) / I[j]
  local n = math.sqrt(a * b)
  return math.cos(n * t) * x - a / n * math.sin(n * t) * y, math.cos(n * t) * y + b / n * math.sin(n * t) * x, n
end

local bodies = { { 1.0, 4.0, 4.5 }, { 3.0, 4.0, 7.0 } }

for n, I in ipairs(tier.every(2, bodies)) do
  for _, k in ipairs(tier.every(2, { 1, 3 })) do
    local i, j = k % 3 + 1, (k + 1) % 3 + 1
    for _, e in ipairs { 0.1, 0.03, 0.01 } do
      for _, direction in ipairs(tier.every(3, { { 0.6, -0.8 }, { 1.0, 0.0 }, { 0.0, 1.0 } })) do
        local x, y = e * direction[1], e * direction[2]
        local w = {}
        w[i], w[j], w[k] = x, y, 1.0
        local path = scene(I, w)
        local said = explained(path)
        local what = string.format("body %d, axis %d, e = %g, direction (%g, %g): ", n, k, e, table.unpack(direction))
        tap.ok(said.axis == k and math.abs(said.amplitude - e) <= 4 * EPSILON, what .. "axis and amplitude")
        local _, _, frequency = textbook(I, k, x, y, 0.0)
        local period, times = 2 * math.pi / frequency, {}
        for s = 1, 100 do times[s] = s * period / 100 end
        local function largest(when)
          local all, axial = 0.0, 0.0
          for _, row in ipairs(motion(path, when, "exact")) do
            local lx, ly = textbook(I, k, x, y, row[1])
            axial = math.max(axial, math.abs(row[5 + k] - 1))
            all = math.max(all, math.abs(row[5 + i] - lx), math.abs(row[5 + j] - ly), axial)
          end
          return all, axial
        end
        local one, axial = largest(times)
        local hundred = math.max(one, (largest { finish = 100 * period, every = period / 24 }))
        local A = law.axis(I, k)
        local m = 2 * A.C * e * e
        -- 100 samples of an extremum of twice the polhode's frequency: (2 pi/200)^2/2 of it, twice that where the start
        -- is no extremum itself
        tap.near(said.axial_change, axial, 2e-3, 16 * EPSILON, what .. "the axial rate", "the samples")
        -- over one period the axial rate decides as long as pi e ratio < 1, else it is third order, m of it
        tap.near(said.error_1, one, 2e-3 + (math.pi * e * A.ratio > 0.7 and 0.3 or 0), 16 * EPSILON,
          what .. "the error in a period", "the samples; the phase's ripple where it decides")
        -- over 100: 24 samples in a period, (pi/24)^2/2; the last extremum lies up to half a period before the end,
        -- 1/200 of the drift; further m of it all.  The ripple of the phase is C e^2/4 each way against a drift of
        -- 100 pi C e^2 in the worst direction; in the third direction the parts of the drift may cancel, the
        -- ripple's do not, so it stands as it is.
        local ripple = A.C * e * e / 2 * e * A.ratio * 2
        tap.near(said.error_100, hundred, 1 / 200 + 9e-3 + 2 * m, ripple, what .. "the error in 100 periods",
          "samples, half a period, the ripple, the next order")
      end
    end
  end
end

---- the third harmonic of the exact motion, over its own period ---------------------------------------------------

for n, I in ipairs(tier.every(2, bodies)) do
  for _, k in ipairs(tier.every(2, { 1, 3 })) do
    local A, e = law.axis(I, k), 0.05
    local w, x, y = {}, law.direction(A)
    w[A.i], w[A.j], w[A.k] = e * x, e * y, 1.0
    local path = scene(I, w)
    local said = explained(path)
    local period, times, count = 2 * math.pi / (A.frequency * (1 + said.frequency_shift)), {}, 64
    for s = 1, count do times[s] = (s - 1) * period / count end
    local weak, first, third = A.weak, { 0.0, 0.0 }, { 0.0, 0.0 }
    for s, row in ipairs(motion(path, times, "exact")) do
      local phase, v = 2 * math.pi * (s - 1) / count, row[5 + weak]
      first = { first[1] + v * math.cos(phase), first[2] + v * math.sin(phase) }
      third = { third[1] + v * math.cos(3 * phase), third[2] + v * math.sin(3 * phase) }
    end
    local got = math.sqrt(third[1] ^ 2 + third[2] ^ 2) / math.sqrt(first[1] ^ 2 + first[2] ^ 2)
    -- the ratio of cn is q/(1 - q + q^2) .. = m/16 (1 + m/2 + ...)
    local m = 2 * A.C * e * e
    tap.near(said.third_harmonic, got, m, 1e-13, string.format("body %d, axis %d: the third harmonic", n, k),
      "the next order, m/2; 64 doubles")
    -- and the frequency: the exact motion is back after its period
    local back = motion(path, { 1000 * period }, "exact")[1]
    local off = math.max(math.abs(back[6] - w[1]), math.abs(back[7] - w[2]), math.abs(back[8] - w[3]))
    -- the period is a product of four roundings of numbers with a dozen each; a phase of 2000 pi, amplitude e ratio
    tap.ok(off <= 2000 * math.pi * 16 * EPSILON * e * A.ratio, string.format(
      "body %d, axis %d: the exact motion is back after 1000 of its periods", n, k), string.format("%.3g", off))
  end
end

---- the unstable axis and the neutral one ---------------------------------------------------------------------------

for n, case in ipairs(tier.every(3, { { { 1.0, 4.0, 4.5 }, 2 }, { { 2.0, 2.1, 2.2 }, 2 }, { { 1.0, 100.0, 100.5 }, 2 },
  { { 1.0, 2.0, 2.0 }, 2 } })) do
  local I, k = case[1], case[2]
  local i, j = k % 3 + 1, (k + 1) % 3 + 1
  for _, e in ipairs { 0.1, 0.01, 0.001 } do
    local w = {}
    w[i], w[j], w[k] = 0.0, e, 1.0 -- j is axis 1
    local path = scene(I, w)
    local said = explained(path)
    local a, b = (I[k] - I[j]) / I[i], (I[k] - I[i]) / I[j]
    local g = math.sqrt(-a * b)
    local T = said.wrong_by_a_tenth
    local times, failed, before = {}, nil, 0.0
    for s = 1, 400 do times[s] = T * (0.9 + s / 2000) end
    for s, row in ipairs(motion(path, times, "exact")) do
      local t = times[s]
      local c, sn = 1.0, t
      if g > 0 then c, sn = (math.exp(g * t) + math.exp(-g * t)) / 2, (math.exp(g * t) - math.exp(-g * t)) / 2 / g end
      local error = math.max(math.abs(row[5 + i] + a * sn * e), math.abs(row[5 + j] - c * e), math.abs(row[5 + k] - 1))
      if not failed and error >= 0.1 and s > 1 and before < 0.1 then
        failed = t - T / 2000 * (error - 0.1) / (error - before)
      end
      before = error
    end
    -- the lag leaves out e^2 of it; a line between samples 1/2000 apart errs by its square
    local slack = 2 * e * e / math.min(1, math.max(g, 0.05)) + 1e-6
    tap.near(T, failed or 0.0, slack, 0.0, string.format("not stable, body %d, e = %g: wrong by a tenth after %.6g", n,
      e, T), "e^2, and the samples")
  end
end

-- What the table says of the axis is the least of what motions about it take, whose times are those above.  Eight
-- directions over half a turn: the worst is at most pi/16 from one, where the growing part is cos(pi/16) = 0.98 of its
-- largest, which takes ln(1/0.98) = 0.02 growth times longer; and the size e = 0.1 is in the table.
do
  local I, e, least, axes = { 1.0, 4.0, 4.5 }, 0.1, math.huge, nil
  for s = 1, 8 do
    local direction = math.pi * s / 8
    local said = explained(scene(I, { e * math.cos(direction), 1.0, e * math.sin(direction) }))
    least, axes = math.min(least, said.wrong_by_a_tenth), said.axes
  end
  local times = axes[2].wrong_by_a_tenth or {}
  local growth = math.sqrt((I[2] - I[1]) * (I[3] - I[2]) / (I[3] * I[1]))
  local row = { amplitude = 0.0, time_times_rate = 0.0 }
  for _, r in ipairs(times) do row = r.amplitude == e and r or row end
  tap.ok(row.time_times_rate <= least and least - row.time_times_rate <= 0.02 / growth,
    "the table of an unstable axis has the time of the worst direction",
    string.format("%.6g, the least of eight directions %.6g", row.time_times_rate, least))
  local last = #times > 0 and times[#times].time_times_rate or 0.0
  tap.is(#times, 4, "it has four amplitudes")
  tap.ok(last > row.time_times_rate and last < math.huge, "the smallest of them lasts longest")
end

-- Axes of a symmetric body in the order 1, 2, 3, each with its line.
do
  local _, out = run("explain " .. scene({ 1.0, 2.0, 2.0 }, { 1.0, 0.1, 0.2 }))
  local section = out:match "\nLinearised motion\n(.-)\n\n" or ""
  local lines = {}
  for axis, text in section:gmatch "\n  axis (%d): ([^\n,]*)" do lines[#lines + 1] = axis .. " " .. text end
  tap.is(table.concat(lines, "; "), "1 exact at any amplitude; 2 neutral; 3 neutral",
    "a symmetric body: a line for each axis, the axis of symmetry exact")
  tap.ok(section:find "the moments across it are equal\n", "and why it is exact")
end

---- what is exact -------------------------------------------------------------------------------------------------

for _, case in ipairs {
  { { 2.0, 2.0, 3.0 }, { 0.3, 0.4, 2.0 }, "the moments across the axis are equal" },
  { { 2.0, 2.0, 2.0 }, { 0.3, 0.4, 2.0 }, "the rates stay what they are" },
  { { 1.0, 2.0, 2.5 }, { 0.0, 0.0, 0.0 }, "it stays there" },
  { { 1.0, 2.0, 2.5 }, { 0.0, 7.0, 0.0 }, "a pure spin stays what it is" },
  { { 0.0, 2.0, 2.0 }, { 3.0, 0.4, 0.5 }, "the moments across the axis are equal" },
} do
  local path = scene(case[1], case[2])
  local said = explained(path)
  tap.ok(said.exact and said.error_100 == 0 and said.verdict:find(case[3], 1, true), "exact: " .. said.verdict)
  local exact, mine = motion(path, { 0.0, 0.7, 100.0 }, "exact"), motion(path, { 0.0, 0.7, 100.0 }, "linearised")
  tap.is(#mine, #exact, "as many rows")
  for s, row in ipairs(exact) do
    -- phases of 100 rad and more in double, amplitudes of 3
    for c = 2, 8 do
      tap.near(mine[s][c], row[c], 8 * EPSILON, 8 * EPSILON, "run: exact " .. (c < 6 and "attitude" or "rates"),
        "4 ulp each")
    end
  end
end

---- run --method linearised -----------------------------------------------------------------------------------------

do
  local I, w = { 1.0, 4.0, 4.5 }, { 0.02, -0.01, 1.5 }
  local path = scene(I, w)
  for _, row in ipairs(motion(path, { -3.0, 0.0, 0.4, 20.0 }, "linearised")) do
    local x, y = textbook(I, 3, w[1] / w[3], w[2] / w[3], row[1] * w[3])
    tap.near(row[6], x * w[3], 8 * EPSILON, 32 * EPSILON * w[1], "run: wx at " .. row[1], "a phase of 30 rad")
    tap.near(row[7], y * w[3], 8 * EPSILON, 32 * EPSILON * w[1], "run: wy at " .. row[1], "a phase of 30 rad")
    tap.is(row[8], w[3], "run: wz is kept")
  end
  for _, case in ipairs {
    { "run bodies/gyroscope.lua --method linearised", "solves free tops, and this scene has effects" },
    { "run " .. path .. " --method linearised --engine generated", "in C it is the function NAME_linearised" },
    { "chart " .. path .. " --linearised --axis x", "--linearised excludes" },
    { "chart " .. scene({ 2.0, 2.0, 2.0 }, w) .. " --linearised", "all moments of this body are equal" },
  } do
    local status, out, err = run(case[1])
    tap.ok(status == 2 and out == "" and err:find(case[2], 1, true), case[1]:gsub(dir, ""), err)
  end
  tap.is(run("gen bodies/brick.lua --method rk4,linearised -o " .. dir .. "/brick"), 0, "gen --method linearised")
  tap.like(program.read(dir .. "/brick/brick_analysis.c"), "brick_linearised(", "gen --method linearised emits it")
end

---- text: no NaN from hard bodies ------------------------------------------------------------------------------------

for n, case in ipairs(tier.every(8, {
  { { 1.0, 1.0 + EPSILON, 2.0 }, { 0.1, 1.0, 0.2 } }, { { 1.0, 2.0, 2.0 + 2 * EPSILON }, { 0.1, 1.0, 0.2 } },
  { { 1e-30, 2e-30, 2.5e-30 }, { 1e-31, 1e-30, 0.0 } }, { { 1e30, 2e30, 2.5e30 }, { 1e29, 0.0, 1e30 } },
  { { 0.0, 1.0, 1.0 }, { 0.1, 1.0, 0.2 } }, { { 1.0, 1.0, 2.0 }, { 1.0, 1.0, 0.2 } },
  { { 1.0, 2.0, 2.5 }, { 1.0, 1.0, 1.0 } }, { { 1e-12, 1.0, 1.0 }, { 1.0, 1e-6, 0.0 } },
})) do
  local path = scene(case[1], case[2])
  for _, format in ipairs({ "text", "json" }) do
    local status, out = run("explain " .. path .. " --format " .. format)
    tap.ok(status == 0 and not out:find "%f[%w]nan%f[%W]" and not out:find "%f[%w]inf%f[%W]"
      and out:find("inearised", 1, true), "hard body " .. n .. ", " .. format .. ": numbers, and the section")
  end
  local rows, why = motion(path, { 0.0, 1e-3 / case[2][1], 1 / case[2][1] }, "linearised")
  local fine = rows and #rows == 3
  for _, row in ipairs(rows or {}) do
    for c = 1, 12 do fine = fine and row[c] == row[c] end
    fine = fine and math.abs(row[2] ^ 2 + row[3] ^ 2 + row[4] ^ 2 + row[5] ^ 2 - 1) <= 4 * EPSILON
  end
  tap.ok(fine, "hard body " .. n .. ": run --method linearised", why)
end

---- the chart: points of the exact motion on the lines of the law -------------------------------------------------

do
  local I = { 1.0, 4.0, 4.5 }
  local path = scene(I, { 0.0, 0.1, 1.0 })
  local status, svg = run("chart " .. path .. " --linearised")
  tap.ok(status == 0 and svg:find "^<svg " and svg:find("prefers-color-scheme:dark", 1, true)
    and not svg:find "%f[%w]nan%f[%W]", "chart: an SVG for light and dark")
  tap.is(select(2, run("chart " .. path .. " --linearised")), svg, "chart: the same bytes twice")
  local boxes = {}
  for x, y, w, h in svg:gmatch '<rect class="frame" x="([%d.]+)" y="([%d.]+)" width="([%d.]+)" height="([%d.]+)"/>' do
    boxes[#boxes + 1] = { tonumber(x), tonumber(y), tonumber(w), tonumber(h) }
  end
  tap.is(#boxes, 2, "chart: a panel for the stable axes, one for the unstable")
  local box = boxes[1]
  for n, k in ipairs { 1, 3 } do
    -- C in moments: the smaller of the two couplings divides
    local i, j = k % 3 + 1, (k + 1) % 3 + 1
    local C = math.abs(I[i] - I[j]) / (2 * I[k]
      * math.min(math.abs(I[k] - I[j]) / I[i], math.abs(I[k] - I[i]) / I[j]))
    local points, worst = 0, 0.0
    for x, y in svg:gmatch('class="dot%-' .. ("ab"):sub(n, n) .. '" cx="([%d.]+)" cy="([%d.]+)"') do
      local e = 10.0 ^ (-4 + 4 * (x - box[1]) / box[3])
      if tonumber(y) < box[2] + box[4] + 1 and e < 0.05 then
        points = points + 1
        -- 3/8 and 2/3 of 1e-8: the axis goes down to 1e-9 and up to 10
        local error = 10.0 ^ (1 - 10 * (y - box[2]) / box[4])
        worst = math.max(worst, math.abs(math.log(error / (C * e * e), 10)) * box[4] / 10)
      end
    end
    -- in pixels: two decimals of a coordinate, twice the other's; the next order of C e^2, 0.002, is less
    tap.ok(points >= 8 and worst <= 0.02 + 0.03, "chart: the points of axis " .. k .. " are at C e^2",
      points .. " points, " .. worst)
  end
  -- the unstable axis: dots on the line, whose ends are equally far down per decade: a logarithm
  local dots = {}
  for x, y in svg:gmatch 'class="dot%-c" cx="([%d.]+)" cy="([%d.]+)"' do
    if tonumber(y) < boxes[2][2] + boxes[2][4] then dots[#dots + 1] = { tonumber(x), tonumber(y) } end
  end
  local first, last = dots[2][2] - dots[1][2], dots[6][2] - dots[5][2]
  tap.ok(#dots == 13 and math.abs(first - last) <= 0.1, "chart: the time of the unstable axis is a logarithm of e",
    #dots .. " points, " .. first .. " " .. last)
  status, svg = run "chart bodies/symmetric_top.lua --linearised"
  tap.ok(status == 0 and svg:find("neutral", 1, true) and not svg:find("where the spin is stable", 1, true),
    "chart: a symmetric top has the neutral panel only")
  for n, hard in ipairs { { 1.0, 1.0 + EPSILON, 2.0 }, { 1e-30, 2e-30, 2.5e-30 }, { 0.0, 1.0, 1.0 }, { 1.0, 2.0, 3.0 },
    { 1.0, 1e6, 1e6 + 0.5 } } do
    status, svg = run("chart " .. scene(hard, { 0.0, 0.1, 1.0 }) .. " --linearised")
    tap.ok(status == 0 and not svg:find "%f[%w]nan%f[%W]" and not svg:find "%f[%w]inf%f[%W]", "chart: hard body " .. n)
  end
end

program.finish()
tap.done()
