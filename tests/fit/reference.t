#!/usr/bin/env lua5.4
-- reference.t - polhode fit against estimates and covariances that others computed (tests/reference/fit/README.md).
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Tolerances: 1e-6 of a standard error in the estimates, below anything a user can see; 1e-4 of the covariance, as the
-- root of the product of the variances; 1e-8 of chi-square, whose terms near the minimum vary with the square.  The
-- reference is good to 9 to 13 digits of the estimates.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local json = require "tests.json"
local program = require "tests.cli.program"
local cases = require "tests.fit.cases"

local dir, root = program.directory(), "tests/reference/fit/"
local binary = os.getenv "POLHODE" or "build/polhode"

-- The scene of a case, with guesses and fixed values in it.
local function scene_of(case, data, fit)
  local text = case.scene
  if case.table_file then
    text = text:gsub("EFFECTS", cases.pulses(program.read(root .. case.folder .. "/" .. case.table_file)))
  end
  text = text:gsub("SIGMA", case.sigma_text)
  return (text:gsub('param%("(%w+)", GUESS', function(name)
    local word = name == "Izz" and "I" or name -- I is a macro of C
    local p, held = data.parameters[word], fit.fixed[word]
    local guess = held or p and (p.guess ~= json.null and p.guess or p["true"]) or 0
    return string.format('param("%s", "%.17g"', name, guess)
  end))
end

local function log_of(case, i)
  local path = root .. case.folder .. "/" .. case.data[i]
  local comment = case.sigma and case.sigma[i]
  if not comment then return path end
  local copy = dir .. "/" .. case.data[i]
  program.write(copy, comment .. program.read(path))
  return copy
end

local function run(case, text)
  program.write(dir .. "/scene.lua", text)
  local words = { binary, "fit", dir .. "/scene.lua", "--format json --free", case.free }
  for i = 1, #case.data do words[#words + 1] = "--data " .. log_of(case, i) end
  if case.loss then words[#words + 1] = "--loss " .. case.loss end
  if case.input then words[#words + 1] = "--between linear --input " .. root .. case.folder .. "/" .. case.input end
  return program.output(table.concat(words, " "))
end

-- The largest difference of the estimates in standard errors; initial attitudes are compared as turns.
local function apart(got, fit)
  local worst = 0
  for i, name in ipairs(fit.free) do
    local sigma, e = fit.sigma[name], got.estimates[i]
    if name:find "^a%d$" then
      local q, r = got.initial_attitudes[1], fit.estimate_q0
      local k = tonumber(name:sub(2))
      local v = { r[1]*q[2] - r[2]*q[1] - r[3]*q[4] + r[4]*q[3], r[1]*q[3] + r[2]*q[4] - r[3]*q[1] - r[4]*q[2],
        r[1]*q[4] - r[2]*q[3] + r[3]*q[2] - r[4]*q[1] } -- conj(r) q, of which v is half the turn
      worst = math.max(worst, math.abs(2 * v[k]) / sigma)
    else
      worst = math.max(worst, math.abs(e.estimate - fit.estimate[name]) / sigma)
    end
  end
  return worst
end

local function covariance_apart(got, fit)
  local worst = 0
  for i = 1, #fit.free do
    for k = 1, #fit.free do
      local size = fit.sigma[fit.free[i]] * fit.sigma[fit.free[k]]
      worst = math.max(worst, math.abs(got.covariance[i][k] - fit.covariance[i][k]) / size)
    end
  end
  return worst
end

-- Every pair has its ellipse: area and sum of squares of the semi-axes are those of 5.991 [1 rho; rho 1].
local function regions_right(got, fit)
  local count, n = 0, #fit.free
  for k = 1, n do
    for i = 1, k - 1 do
      count = count + 1
      local a, s = got.regions_95[count], { fit.sigma[fit.free[i]], fit.sigma[fit.free[k]] }
      local rho, R = fit.covariance[i][k] / s[1] / s[2], 5.991464547107979
      if not a or math.abs(a.semi_axes[1] * a.semi_axes[2] - R * math.sqrt(1 - rho * rho)) > 1e-3 or
        math.abs(a.semi_axes[1] ^ 2 + a.semi_axes[2] ^ 2 - 2 * R) > 1e-9 or
        (a.semi_axes[1] - a.semi_axes[2]) * rho < 0 then return false end
    end
  end
  return count == #got.regions_95
end

for _, case in ipairs(cases) do
  local data = json.read(program.read(root .. case.folder .. "/case.json"))
  local fit = data.fits[case.fit]
  local name = case.folder .. ", " .. fit.name
  local code, out, err = run(case, scene_of(case, data, fit))
  local fits = case.fit == 1 or case.folder ~= "08_outliers"
  if tap.is(code, fits and 0 or 3, name .. ": exit status") then
    local got = json.read(out)
    tap.ok(got.converged, name .. ": converged")
    local far, other = apart(got, fit), covariance_apart(got, fit)
    tap.ok(far <= 1e-6, name .. ": the estimates are the reference's", far .. " standard errors apart")
    tap.ok(other <= 1e-4, name .. ": so is the covariance", other .. " apart")
    tap.ok(regions_right(got, fit), name .. ": regions of pairs are those of the reference's covariance")
    tap.ok(math.abs(got.chi2 / fit.chi2 - 1) < 1e-8, name .. ": and chi-square", got.chi2 .. " for " .. fit.chi2)
    tap.ok(got.n == fit.n_residuals, name .. ": all values are used, and no missing one")
    if os.getenv "VERBOSE" then tap.diag(string.format("%.2g sigma, covariance %.2g, %d passes, %.4f s, step %.4g",
      far, other, got.passes, got.fit_seconds, got.step)) end
  else
    tap.diag(err .. out)
  end
end

program.finish()
tap.done()
