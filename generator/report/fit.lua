-- fit.lua -- what a fit found: estimates, how sure they are, whether the model fits, and what the data do not tell.
--
--     report.of(found) -> told: a table with everything decided; told.status: the exit status
--     report.text(told), report.json(told) -> text
-- found: {host, job, result (src/cli/fit/fit.c), unknowns, data, names (of residuals), known (sigmas), loss, step,
-- refusals, wrong (sentences), notes (of what was read)}.  Values in told are in the parameters' own units.
-- SPDX-License-Identifier: GPL-3.0-or-later

local json = require "generator.report.json"
local regions = require "generator.report.fit_regions"

local report = {}

local SURE, CREDIBLE, CLOSE = 1e-6, 1e-3, 0.95
local SMALL = 1e-6 -- part of what is large of its kind below which a value may be 0
local WIDE = 1.5 -- chi-square over its degrees of freedom beyond which a model does not fit, whatever its probability

-- Where the search began, if not at the scene's values.
local WAYS = {
  lengthened = "from the scene's values the whole log led to a local minimum; the log was lengthened step by step",
  linear = "from the scene's values the search led to a local minimum; it began again where the logged rates keep " ..
    "the momentum constant",
  starts = "from the scene's values the search led to a local minimum; one of --starts led to this one",
}

-- A number with the digits that its standard error leaves, and two more; all digits without one.
local function rounded(x, sigma)
  if not sigma or sigma ~= sigma or sigma <= 0 or sigma == math.huge then return string.format("%.6g", x) end
  local places = math.ceil(-math.log(sigma, 10)) + 1
  if math.abs(x) >= 1e7 or places > 12 or places < 0 then return string.format("%.10g", x) end
  return string.format("%." .. places .. "f", x)
end

-- ---- what the data determine ----

-- Directions of the unknowns along which nothing that is measured changes: list of {parts = {{place, part}}}, the part
-- relative to the unknown's own size.
local function null_directions(r)
  local n, list = r.unknowns, {}
  for k = math.floor(r.rank) + 1, n do
    local parts, largest = {}, 0
    local function part(i) -- of its own size; where that is rounding, of what is large of its kind
      local own, large = math.abs(r.theta[i]), r.size[i]
      return r.vectors[(i - 1) * n + k] * r.scale[i] / (own > SMALL * large and own or large > 0 and large or 1)
    end
    for i = 1, n do largest = math.max(largest, math.abs(part(i))) end
    for i = 1, n do
      local x = part(i) / largest
      if math.abs(x) > 1e-4 then parts[#parts + 1] = { i, x } end
    end
    list[#list + 1] = { parts = parts }
  end
  return list
end

local function names_of(parts, unknowns)
  local list = {}
  for i, p in ipairs(parts) do list[i] = unknowns[p[1]].name end
  return table.concat(list, ", ")
end

-- A null direction in words.
local function said(parts, unknowns)
  local names = names_of(parts, unknowns)
  if #parts == 1 then return names .. ": nothing that is measured depends on it" end
  local alike = true
  for _, p in ipairs(parts) do alike = alike and math.abs(p[2] - parts[1][2]) < 1e-4 * math.abs(parts[1][2]) end
  if alike then
    local moments = true
    for _, p in ipairs(parts) do moments = moments and unknowns[p[1]].unit == "kg m^2" end
    return names .. ": only their ratios are determined; all of them times the same number fit as well" ..
      (moments and " (no known torque or momentum sets the scale: apply one, or keep one of them fixed)" or "")
  end
  local list = {}
  for i, p in ipairs(parts) do list[i] = string.format("%+.4g of %s", p[2], unknowns[p[1]].name) end
  return names .. ": they can change together, by these parts of their own size: " .. table.concat(list, ", ")
end

-- The null directions of a result, in words; and which unknowns have a part in them, as a set of places.
function report.nulls(r, unknowns)
  local list, lost = null_directions(r), {}
  for _, d in ipairs(list) do
    for _, p in ipairs(d.parts) do lost[p[1]] = true end
    d.text = said(d.parts, unknowns)
  end
  return list, lost
end

-- ---- residuals ----

-- Ljung and Box over pairs of equal spacing; nil where too few are.
local function whiteness(c, tail)
  local q, lags = 0, 0
  for k, pairs_of in ipairs(c.pairs) do
    if pairs_of < 0.5 * c.n then return nil end
    local rho = c.sums[k] / pairs_of / (c.chi2 / c.n)
    q, lags = q + (c.n + 2) / c.n * pairs_of * rho * rho, lags + 1
  end
  return { q = q, lags = lags, tail = tail(q, lags) }
end

local function residuals_of(found)
  local list, r = {}, found.result
  for n, log in ipairs(found.data) do
    for k, name in ipairs(found.names) do
      local c = r.counts[n][k]
      if c.n > 0 then
        list[#list + 1] = { log = log.path, name = name, n = math.floor(c.n), chi2 = c.chi2, rms =
          math.sqrt(c.chi2 / c.n), white = c.n > 60 and c.chi2 > 0 and whiteness(c, found.host.tail) or nil,
          worst = c.worst, worst_t = c.worst_t }
      end
    end
  end
  return list
end

-- The values that no noise explains, the farthest first: {log, name, line, t, z}.
local function outliers_of(found)
  local list = {}
  for i, o in ipairs(found.result.outliers) do
    list[i] = { log = found.data[math.floor(o.log)].path, name = found.names[math.floor(o.residual)],
      line = math.floor(o.line), t = o.t, z = o.z }
  end
  return list
end

-- ---- together ----

-- scale: of the covariance; lost[i]: the data do not determine unknown i, which then has no sigma.
local function estimates(found, scale, lost)
  local list, r, n = {}, found.result, found.result.unknowns
  for i, u in ipairs(found.unknowns) do
    local variance = r.covariance[(i - 1) * n + i] * scale
    local x = { name = u.name, unit = u.unit, value = r.theta[i] / u.factor, kind = u.kind }
    if not lost[i] then
      x.sigma = math.sqrt(variance) / u.factor
      -- of what cannot change its sign an interval that reaches 0 says nothing
      x.hardly = u.kind == "param" and string.find(u.unit, "kg", 1, true) ~= nil and x.sigma > math.abs(x.value) / 2
    end
    list[i] = x
  end
  return list
end

-- The matrix, NaN where an unknown is lost, and the pairs {i, k, correlation} that are hard to tell apart.
local function correlations(found, lost)
  local n, C, rows, close = found.result.unknowns, found.result.covariance, {}, {}
  for i = 1, n do
    rows[i] = {}
    for k = 1, n do
      local c = C[(i - 1) * n + k] / math.sqrt(C[(i - 1) * n + i] * C[(k - 1) * n + k])
      rows[i][k] = not (lost[i] or lost[k]) and c or 0 / 0
      if k < i and not (lost[i] or lost[k]) and math.abs(c) > CLOSE then close[#close + 1] = { k, i, c } end
    end
  end
  return rows, close
end

local LOSSES = { squares = "", huber = ", Huber's loss", cauchy = ", Cauchy's loss" }

local function put(list, ...) list[#list + 1] = string.format(...) end

-- A log on which every fit fails because its motion forgets the beginning: Lyapunov's growth, e^(lambda T).  That of a
-- regular motion is a power of time, below 1e4 between the first and the last tenth of the log.
local CHAOS = 1e4

local function chaotic(found, wrong)
  if found.segments then return false end
  for i, d in ipairs(found.data) do
    local growth = found.result.growth[i]
    local _, first, last = d.log:spacing()
    if growth > CHAOS then
      local span = (last - first) * 0.9 / math.log(growth) * math.log(100) -- in which it grows a hundredfold
      put(wrong, "the motion forgets how it began: what changes at the begin of %s is %.2g times as large at its " ..
        "end, so a log of %.4g s has no smooth optimum; try --segments %d, pieces of %.3g s", d.path, growth,
        last - first, math.ceil((last - first) / span), span)
      return true
    end
  end
  return false
end

-- What is wrong: status, and the sentences that say it; then what is only worth saying.
local function judged(found, told)
  local r, wrong, notes = found.result, found.wrong, {}
  local rule = found.refusals[math.floor(r.refused)]
  if not r.converged and rule and r.refusals < r.passes then
    put(wrong, "the search ended at the border of the rule %s: the minimum is beyond it, %.3g standard errors from " ..
      "here%s", rule.text, r.decrement, found.known and (found.host.tail(r.decrement ^ 2, r.unknowns) > 1e-3 and
      "; a body at the border is within the noise, but its standard errors mean nothing" or
      ": something is missing in the model") or "")
  elseif not r.converged then
    put(wrong, "it did not converge: the last step was %.3g standard errors long after %d passes%s", r.decrement,
      r.passes, rule and ", as the parameters break the rule " .. rule.text or "")
  elseif r.step_error > SURE then
    put(wrong, "the step of %.3g s is too long: it moves the estimate by %.2g standard errors", r.step, r.step_error)
  end
  local over = found.known and not told.robust and told.dof > 0 and told.tail < SURE
  if over and told.reduced > WIDE then
    local far = told.outliers[1]
    put(wrong, "the model does not fit: chi-square is %.4g times its expectation; another model, another start, or " ..
      "a sigma that is too small%s", told.reduced, far and string.format(" (the farthest value: %s:%d, %s is off by " ..
      "%.3g sigma)", far.log, far.line, far.name, far.z) or "")
  elseif over then
    put(notes, "chi-square is %.4g times its expectation, too much for the stated sigma", told.reduced)
  end
  if #wrong > 0 then told.chaotic = chaotic(found, wrong) end
  if found.known and told.dof > 0 and 1 - told.tail < SURE then
    put(notes, "chi-square is %.4g times its expectation, too little: sigma is overstated, or the data were smoothed",
      told.reduced)
  end
  for _, c in ipairs(told.residuals) do
    if c.white and c.white.tail < CREDIBLE then
      put(notes, "residuals of %s in %s are not white (Q = %.4g over %d lags): something is missing in the model, " ..
        "or the noise is coloured, and the standard errors are too small", c.name, c.log, c.white.q, c.white.lags)
    end
  end
  if found.segments and found.whole then
    put(notes, "the search went by %d segments; the whole log from one initial state fits as well, and is what is told",
      found.segments)
  elseif found.segments then
    put(notes, "%d segments with a state of their own each: the whole log from one initial state does not fit, or " ..
      "has no smooth optimum; nothing ties the segments together", found.segments)
  end
  if WAYS[r.way] then put(notes, "%s", WAYS[r.way]) end
  if r.tried > 0 then
    put(notes, "of %d starts in the parameters' ranges %d led to this minimum, and none to a lower one", r.tried,
      r.same)
  end
  for _, s in ipairs(found.notes) do notes[#notes + 1] = s end
  for i, d in ipairs(found.data) do
    for _, s in ipairs(i > 1 and d.log == found.data[i - 1].log and {} or d.odd) do notes[#notes + 1] = s end
    if #d.unused > 0 then
      put(notes, "%s: nothing in the scene measures %s", d.path, table.concat(d.unused, ", "))
    end
  end
  return wrong, notes
end

function report.of(found)
  local r, told = found.result, {}
  local nulls, lost = report.nulls(r, found.unknowns)
  told.nulls = nulls
  told.scene, told.unknowns = found.job.model.name, found.unknowns
  told.n, told.dof, told.chi2 = math.floor(r.n), math.floor(r.n - r.rank), r.chi2
  told.reduced = told.dof > 0 and r.chi2 / told.dof or 0 / 0
  told.tail = found.host.tail(r.chi2, told.dof)
  told.known, told.loss, told.robust = found.known, found.loss, found.loss ~= "squares"
  told.outliers = outliers_of(found)
  local scale = found.known and 1 or told.reduced
  told.estimates = estimates(found, scale, lost)
  told.correlation, told.close = correlations(found, lost)
  told.regions = regions.of(told)
  told.covariance_scale, told.residuals, told.result = scale, residuals_of(found), r
  told.names = found.names
  told.logs, told.segments = found.data, not found.whole and found.segments or nil
  told.wrong, told.notes = judged(found, told)
  told.status = #told.wrong > 0 and 3 or 0
  return told
end

-- ---- as text ----

local function widest(told)
  local wide = 8
  for _, e in ipairs(told.estimates) do wide = math.max(wide, #e.name) end
  return wide
end

local function table_of(out, told)
  local wide = widest(told)
  for _, e in ipairs(told.estimates) do
    local value, unit = rounded(e.value, e.sigma), e.unit == "1" and "" or " " .. e.unit
    if e.sigma then
      put(out, "  %-" .. wide .. "s  %s%s  +- %.2g%s", e.name, e.hardly and "hardly determined: " or "", value,
        e.sigma, unit)
    else
      put(out, "  %-" .. wide .. "s  not determined (the search ended at %.4g%s)", e.name, e.value, unit)
    end
  end
end

local function correlation_of(out, told)
  if #told.estimates > 1 and #told.estimates <= 12 then
    put(out, "\nCorrelation")
    for i, e in ipairs(told.estimates) do
      local line = {}
      for k = 1, i do
        local c = told.correlation[i][k]
        line[k] = c == c and string.format("%6.3f", c) or "     -"
      end
      put(out, "  %-" .. widest(told) .. "s %s", e.name, table.concat(line, " "))
    end
  end
  for _, c in ipairs(told.close) do
    put(out, "  %s and %s are hardly told apart: correlation %.4f", told.estimates[c[1]].name,
      told.estimates[c[2]].name, c[3])
  end
end

local SHOWN = 8 -- outliers in the text

local function outliers_text(out, told)
  local count, r = math.floor(told.result.outlier_count), told.result
  if count == 0 or count > 0.1 * told.n then return end -- so many are no outliers
  put(out, "\nOutliers: %d value%s beyond %.3g%s, where one log in a hundred has one", count, count > 1 and "s" or "",
    r.outlier_limit, told.known and " sigma" or "")
  for i = 1, math.min(SHOWN, #told.outliers) do
    local o = told.outliers[i]
    put(out, "  %s:%d: %s is off by %.3g%s at t = %.6g s", o.log, o.line, o.name, o.z, told.known and " sigma" or "",
      o.t)
  end
  if count > SHOWN then put(out, "  and %d more", count - SHOWN) end
  if not told.robust and told.known then put(out, "  (--loss huber or cauchy lets them count less)") end
end

function report.text(told)
  local out, r = {}, told.result
  put(out, "Fit of %s: %d values of %d %s%s, %d unknowns%s", told.scene, told.n, #told.logs,
    told.segments and "segment" or "log", #told.logs > 1 and "s" or "", #told.estimates, LOSSES[told.loss])
  table_of(out, told)
  put(out, "  (standard errors %s)", told.known and "from the stated sigma, not scaled" or
    "scaled by the residuals, as no sigma is stated")
  correlation_of(out, told)
  regions.text(out, told)
  put(out, "\nDoes the model fit?")
  if told.known then
    put(out, "  chi-square %.6g for %d degrees of freedom: %.5g times; more has a probability of %.2g%s", told.chi2,
      told.dof, told.reduced, told.tail, told.robust and " (outliers count in full here)" or "")
  else
    put(out, "  residuals have a standard deviation of %.4g; without a sigma nothing tells whether that is noise",
      math.sqrt(told.reduced))
  end
  for _, c in ipairs(told.residuals) do
    put(out, "  %s, %s: %d values, root mean square %.4g%s, largest %.3g at t = %.6g s%s", c.log, c.name, c.n, c.rms,
      told.known and " sigma" or "", c.worst, c.worst_t, c.white and
      string.format("; white with probability %.2g", c.white.tail) or "")
  end
  outliers_text(out, told)
  local nulls = told.chaotic and {} or told.nulls -- there they are those of no minimum
  if #nulls > 0 then put(out, "\nWhat the data do not determine") end
  for _, d in ipairs(nulls) do put(out, "  %s", d.text) end
  put(out, "\n%s after %d passes; steps of %.3g s, whose error moves the estimate by %.1g standard errors at most",
    r.converged and "Converged" or "Not converged", r.passes, r.step, r.step_error)
  for _, s in ipairs(told.notes) do put(out, "note: %s", s) end
  for _, s in ipairs(told.wrong) do put(out, "WRONG: %s", s) end
  return table.concat(out, "\n") .. "\n"
end

-- ---- as JSON ----

local function maybe(x) return x ~= nil and x or json.null end

function report.json(told)
  local object, r, n = json.object, told.result, #told.estimates
  local list, covariance, residuals, nulls, outliers = {}, {}, {}, {}, {}
  for i, e in ipairs(told.estimates) do
    list[i] = object { { "name", e.name }, { "unit", e.unit }, { "determined", e.sigma ~= nil and not e.hardly },
      { "estimate", e.value }, { "sigma", maybe(e.sigma) } }
    covariance[i] = {}
    for k, other in ipairs(told.estimates) do
      local c = r.covariance[(i - 1) * n + k] * told.covariance_scale /
        (told.unknowns[i].factor * told.unknowns[k].factor)
      covariance[i][k] = e.sigma and other.sigma and c or json.null
    end
  end
  for i, c in ipairs(told.residuals) do
    residuals[i] = object { { "log", c.log }, { "name", c.name }, { "n", c.n }, { "chi2", c.chi2 },
      { "largest", c.worst }, { "largest_at", c.worst_t }, { "whiteness_q", maybe(c.white and c.white.q) },
      { "whiteness_tail", maybe(c.white and c.white.tail) } }
  end
  for i, d in ipairs(told.nulls) do nulls[i] = d.text end
  for i, o in ipairs(told.outliers) do
    outliers[i] = object { { "log", o.log }, { "line", o.line }, { "name", o.name }, { "t", o.t }, { "off_by", o.z } }
  end
  local references = {}
  for i = 1, #r.reference, 4 do
    if r.reference[i] ~= 0 or r.reference[i + 1] ~= 0 then
      references[#references + 1] = { table.unpack(r.reference, i, i + 3) }
    end
  end
  return json.text(object { { "scene", told.scene }, { "converged", r.converged }, { "fits", #told.wrong == 0 },
    { "loss", told.loss }, { "estimates", list }, { "covariance", covariance },
    { "regions_95", regions.json(told) },
    { "covariance_scaled", not told.known }, { "initial_attitudes", references }, { "chi2", told.chi2 },
    { "n", told.n }, { "dof", told.dof }, { "upper_tail", told.known and told.tail or json.null },
    { "residuals", residuals },
    { "outlier_count", math.floor(r.outlier_count) }, { "outlier_limit", r.outlier_limit }, { "outliers", outliers },
    { "way", r.way },
    { "segments", told.segments or 1 }, { "starts", math.floor(r.tried) }, { "starts_alike", math.floor(r.same) },
    { "singular_values", r.singular }, { "rank", math.floor(r.rank) }, { "not_determined", nulls },
    { "passes", math.floor(r.passes) },
    { "trials_refused", math.floor(r.refusals) }, { "last_step", r.decrement }, { "step", r.step },
    { "step_error", r.step_error }, { "fit_seconds", r.seconds }, { "notes", told.notes }, { "wrong", told.wrong } })
end

return report
