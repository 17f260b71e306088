#!/usr/bin/env lua5.4
-- coverage.t - polhode fit is honest: over synthetic logs the truth lies in the 95 % region 95 times of 100, and from
-- starts that are far off it arrives.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The motion is that of a free body with moments 1, 1.48, 1.83, integrated here by RK4 with a hundredth of the rows'
-- distance in time, another program than the emitted one; the noise is normal (Box and Muller) from a generator that is
-- seeded here.  The region is the ellipsoid of the printed covariance, d' C^-1 d < 11.0705 with d = p - truth, the 95 %
-- point of chi-square with five degrees of freedom.
-- make check-all takes 200 logs; POLHODE_LOGS=1000: that many.
-- Bounds: of n logs the number inside is binomial; a test that is right fails by chance once in 1e4 (3.9 deviations).

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local json = require "tests.json"
local program = require "tests.cli.program"

local LOGS = tonumber(os.getenv "POLHODE_LOGS") or 200
local STARTS = LOGS // 5
local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local TRUTH = { 1.48, 1.83, 0.9, 1.1, -0.4 }
local NAMES = { "I2", "I3", "w1", "w2", "w3" }
local SIGMA, ROWS, SPACING = 0.004, 301, 0.1
local REGION = 11.0705

-- ---- the motion and the noise ----

local function rates(w)
  local I2, I3 = TRUTH[1], TRUTH[2]
  return { (I2 - I3) * w[2] * w[3], (I3 - 1) / I2 * w[3] * w[1], (1 - I2) / I3 * w[1] * w[2] }
end

local function moved(w, k, h) return { w[1] + h * k[1], w[2] + h * k[2], w[3] + h * k[3] } end

local function step(w, h)
  local k1 = rates(w)
  local k2 = rates(moved(w, k1, h / 2))
  local k3 = rates(moved(w, k2, h / 2))
  local k4 = rates(moved(w, k3, h))
  local out = {}
  for i = 1, 3 do out[i] = w[i] + h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]) end
  return out
end

local motion = { { TRUTH[3], TRUTH[4], TRUTH[5] } }
for i = 2, ROWS do
  local w = motion[i - 1]
  for _ = 1, 100 do w = step(w, SPACING / 100) end
  motion[i] = w
end

math.randomseed(20261123)

local function normal()
  return math.sqrt(-2 * math.log(1 - math.random())) * math.cos(2 * math.pi * math.random())
end

local function log()
  local lines = { "t,wx,wy,wz" }
  for i, w in ipairs(motion) do
    local cells = { string.format("%.1f", (i - 1) * SPACING) }
    for k = 1, 3 do cells[k + 1] = string.format("%.17g", w[k] + SIGMA * normal()) end
    lines[#lines + 1] = table.concat(cells, ",")
  end
  program.write(dir .. "/log.csv", table.concat(lines, "\n") .. "\n")
end

-- ---- the fit ----

local function scene(start)
  local words = {}
  for i, name in ipairs(NAMES) do
    words[i] = string.format('local %s = param("%s", "%.17g", "%s")', name, name, start[i], i < 3 and "kg m^2" or
      "rad/s")
  end
  program.write(dir .. "/body.lua", table.concat(words, "\n") .. "\n" .. [[
return scene { name = "tumbling", body = tensor { mass = 1, xx = 1, yy = I2, zz = I3 },
  initial = { omega = { w1, w2, w3 } }, measure = { wx = wx, wy = wy, wz = wz, sigma = 0.004 } }
]])
end

local function fit()
  local code = program.shell(string.format("%s fit %s/body.lua --data %s/log.csv --free %s --format json > %s/out " ..
    "2> %s/err", binary, dir, dir, table.concat(NAMES, ","), dir, dir))
  return code, code ~= 2 and code ~= 1 and json.read(program.read(dir .. "/out")) or {}
end

-- d' C^-1 d by elimination with C's rows; C is positive definite.
local function distance(got)
  local n, a, d = 5, {}, {}
  for i = 1, n do
    d[i] = got.estimates[i].estimate - TRUTH[i]
    a[i] = { table.unpack(got.covariance[i]) }
    a[i][n + 1] = d[i]
  end
  for i = 1, n do
    for k = i + 1, n do
      local f = a[k][i] / a[i][i]
      for j = i, n + 1 do a[k][j] = a[k][j] - f * a[i][j] end
    end
  end
  local sum, x = 0, {}
  for i = n, 1, -1 do
    x[i] = a[i][n + 1]
    for j = i + 1, n do x[i] = x[i] - a[i][j] * x[j] end
    x[i] = x[i] / a[i][i]
    sum = sum + d[i] * x[i]
  end
  return sum
end

do
  scene(TRUTH)
  local inside, mean, failed = 0, 0, 0
  for _ = 1, LOGS do
    log()
    local code, got = fit()
    local m = code == 0 and distance(got) or math.huge
    failed = failed + (code == 0 and 0 or 1)
    inside, mean = inside + (m < REGION and 1 or 0), mean + m / LOGS
  end
  local deviation = math.sqrt(LOGS * 0.95 * 0.05)
  tap.is(failed, 0, "every log is fitted")
  tap.ok(math.abs(inside - 0.95 * LOGS) <= 3.9 * deviation, "the truth is inside the 95 % region 95 times of 100",
    inside .. " of " .. LOGS)
  -- a sum of LOGS variables of mean 5 and variance 10
  tap.ok(math.abs(mean - 5) <= 3.9 * math.sqrt(10 / LOGS), "the mean squared distance is that of five numbers", mean)
  tap.diag(inside .. " of " .. LOGS .. " inside, mean squared distance " .. mean)
end

-- ---- far starts ----

-- Within half of the truth, each number for itself; what is no body is drawn again.
do
  log()
  local right, silent = 0, 0
  for _ = 1, STARTS do
    local start
    repeat
      start = {}
      for i, x in ipairs(TRUTH) do start[i] = x * (0.5 + math.random()) end
    until start[1] < 1 + start[2] and start[2] < 1 + start[1] and 1 < start[1] + start[2]
    scene(start)
    local code, got = fit()
    local there = got.estimates and math.abs(got.estimates[1].estimate - TRUTH[1]) < 0.01 and
      math.abs(got.estimates[2].estimate - TRUTH[2]) < 0.01
    right = right + (code == 0 and there and 1 or 0)
    silent = silent + (code == 0 and not there and 1 or 0)
  end
  tap.ok(right >= 0.95 * STARTS, "from starts within half of the truth it arrives 95 times of 100", right .. " of " ..
    STARTS)
  tap.is(silent, 0, "and where it does not, it says so")
  tap.diag(right .. " of " .. STARTS .. " arrive")
end

program.finish()
tap.done()
