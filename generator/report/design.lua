-- design.lua -- what a design found: the candidates in order, the errors of the best, what no candidate tells.
--
--     report.of(found) -> told; told.status: the exit status; told.best: the best candidate, or nil
--     report.text(told), report.json(told) -> text; told.growth: of the best, shorter logs: list of {t, result}
-- found: {job, unknowns, of (places of those that count), values, points and inputs (of candidates: {path}), results
-- (of src/cli/fit/design.c), log, by, top, refusals}.
-- SPDX-License-Identifier: GPL-3.0-or-later

local fit = require "generator.report.fit"
local json = require "generator.report.json"

local report = {}

local CLOSE = 0.95
local BY = { D = "mean", A = "root", E = "largest" }
local WORDS = { D = "geometric mean (D)", A = "root mean square (A)", E = "largest axis (E)" }

local function put(list, ...) list[#list + 1] = string.format(...) end

local function sigma(found, r, i)
  return math.sqrt(r.covariance[(i - 1) * r.unknowns + i]) / found.unknowns[i].factor
end

-- One candidate, judged: {place, result, lost (set of places), unsure = is one that counts lost?}
local function judged(found, place)
  local r, c = found.results[place], { place = place, lost = {}, nulls = {} }
  c.result, c.refused = r, r.refused ~= 0
  if c.refused then return c end
  if r.rank < r.unknowns then c.nulls, c.lost = fit.nulls(r, found.unknowns) end
  for _, i in ipairs(found.of) do c.unsure = c.unsure or c.lost[i] or false end
  return c
end

-- Sentences about what candidates do not tell, each with how many of them say so.
local function untold(list)
  local said, order = {}, {}
  for _, c in ipairs(list) do
    for _, d in ipairs(c.unsure and c.nulls or {}) do
      if not said[d.text] then order[#order + 1] = d.text end
      said[d.text] = (said[d.text] or 0) + 1
    end
  end
  for i, text in ipairs(order) do order[i] = { text = text, count = said[text] } end
  table.sort(order, function(a, b)
    if a.count ~= b.count then return a.count > b.count end
    return a.text < b.text
  end)
  return order
end

function report.of(found)
  local told, all, key = { found = found, ranked = {}, refused = 0, unsettled = 0 }, {}, BY[found.by]
  for i = 1, #found.points do
    local c = judged(found, i)
    all[i] = c
    told.refused = told.refused + (c.refused and 1 or 0)
    told.unsettled = told.unsettled + (not c.refused and not c.result.settled and 1 or 0)
    if not c.refused and not c.unsure and c.result.settled then told.ranked[#told.ranked + 1] = c end
  end
  table.sort(told.ranked, function(a, b)
    local x, y = a.result[key], b.result[key]
    if x ~= y then return x < y end
    return a.place < b.place
  end)
  told.all, told.best, told.untold = all, told.ranked[1], untold(all)
  told.status = told.best and 0 or 3
  return told
end

-- ---- as text ----

local function unit_of(u) return u.unit == "1" and "" or " " .. u.unit end

local function named(found, place)
  local list = {}
  for k, v in ipairs(found.values) do
    list[k] = string.format("%s = %.6g%s", v.name, found.points[place][k], v.unit == "1" and "" or " " .. v.unit)
  end
  list[#list + 1] = found.inputs[place].path
  return #list > 0 and table.concat(list, ", ") or "the scene as it stands"
end

local function ranking(out, told)
  local found, head = told.found, { "  " }
  if #found.points == 1 then return end
  for _, v in ipairs(found.values) do head[#head + 1] = string.format("%12s", v.name) end
  put(out, "\nThe best, by %s of the relative standard errors", WORDS[found.by])
  put(out, "%s  %9s %9s %9s", table.concat(head), "D", "A", "E")
  for n = 1, math.min(found.top, #told.ranked) do
    local c, line = told.ranked[n], { "  " }
    for k in ipairs(found.values) do line[#line + 1] = string.format("%12.6g", found.points[c.place][k]) end
    put(out, "%s  %9.2e %9.2e %9.2e%s", table.concat(line), c.result.mean, c.result.root, c.result.largest,
      found.inputs[c.place].path and "  " .. found.inputs[c.place].path or "")
  end
  local worst = told.ranked[#told.ranked]
  if #told.ranked > 1 then
    put(out, "  the worst of %d is %.3g times less sure: %s", #told.ranked,
      worst.result[BY[found.by]] / told.best.result[BY[found.by]], named(found, worst.place))
  end
end

local function errors(out, told)
  local found, r, wide = told.found, told.best.result, 8
  for _, u in ipairs(found.unknowns) do wide = math.max(wide, #u.name) end
  put(out, "\nStandard errors of a log of %s", named(found, told.best.place))
  for i, u in ipairs(found.unknowns) do
    if told.best.lost[i] then
      put(out, "  %-" .. wide .. "s  not determined", u.name)
    else
      put(out, "  %-" .. wide .. "s  %.6g  +- %.2g%s", u.name, r.theta[i] / u.factor, sigma(found, r, i), unit_of(u))
    end
  end
  for i = 1, #found.unknowns do
    for k = i + 1, #found.unknowns do
      local n, C = r.unknowns, r.covariance
      local c = C[(i - 1) * n + k] / math.sqrt(C[(i - 1) * n + i] * C[(k - 1) * n + k])
      if not (told.best.lost[i] or told.best.lost[k]) and math.abs(c) > CLOSE then
        put(out, "  %s and %s are hardly told apart: correlation %.4f", found.unknowns[i].name,
          found.unknowns[k].name, c)
      end
    end
  end
end

local function growth(out, told)
  local found, names = told.found, {}
  if not told.growth or #told.growth == 0 then return end
  for k, i in ipairs(found.of) do names[k] = found.unknowns[i].name end
  put(out, "\nHow long: standard errors of %s", table.concat(names, ", "))
  local function line(t, r)
    local list = {}
    for k, i in ipairs(found.of) do
      list[k] = r and r.refused == 0 and r.rank == r.unknowns and string.format("%.2g", sigma(found, r, i)) or "-"
    end
    put(out, "  after %8.5g s: %s", t, table.concat(list, ", "))
  end
  for _, g in ipairs(told.growth) do line(g.t, g.result) end
  line((found.log.rows - 1) * found.log.spacing, told.best.result)
end

function report.text(told)
  local out, found = {}, told.found
  put(out, "Design for %s: logs of %d rows at %g Hz, %d candidate%s", found.job.model.name, found.log.rows,
    found.log.rate, #found.points, #found.points == 1 and "" or "s")
  if told.best then
    ranking(out, told)
    errors(out, told)
    growth(out, told)
  end
  if #told.untold > 0 then put(out, "\nWhat is not determined") end
  for _, u in ipairs(told.untold) do
    put(out, "  by %d of %d: %s", u.count, #found.points, u.text)
  end
  if told.refused > 0 then
    local first
    for _, c in ipairs(told.all) do first = first or c.refused and c or nil end
    local rule = found.refusals[first.result.refused // 1 | 0]
    put(out, "note: %d of the candidates are refused, the first (%s) as %s", told.refused, named(found, first.place),
      first.result.said or rule and rule.text or "its motion is not finite")
  end
  if told.unsettled > 0 then
    put(out, "note: of %d candidates the motion cannot be followed exactly enough by rk4; they are left out",
      told.unsettled)
  end
  if not told.best then put(out, "WRONG: no candidate determines what is asked for") end
  return table.concat(out, "\n") .. "\n"
end

-- ---- as JSON ----

local function candidate(found, c)
  local values, sigmas, nulls, covariance = {}, {}, {}, {}
  local r, n = c.result, #found.unknowns
  for k, v in ipairs(found.values) do values[k] = { v.name, found.points[c.place][k] } end
  if found.inputs[c.place].path then values[#values + 1] = { "input", found.inputs[c.place].path } end
  if c.refused then
    return json.object { { "values", json.object(values) }, { "refused", true } }
  end
  for i, u in ipairs(found.unknowns) do
    sigmas[i] = { u.name, c.lost[i] and json.null or sigma(found, r, i) }
    covariance[i] = {}
    for k = 1, n do
      local x = r.covariance[(i - 1) * n + k] / (u.factor * found.unknowns[k].factor)
      covariance[i][k] = not (c.lost[i] or c.lost[k]) and x or json.null
    end
  end
  for i, d in ipairs(c.nulls) do nulls[i] = d.text end
  local sure = not c.unsure
  return json.object { { "values", json.object(values) }, { "refused", false }, { "settled", r.settled },
    { "D", sure and r.mean or json.null }, { "A", sure and r.root or json.null },
    { "E", sure and r.largest or json.null }, { "sigma", json.object(sigmas) }, { "covariance", covariance },
    { "not_determined", nulls }, { "step", r.step } }
end

function report.json(told)
  local found, list = told.found, {}
  for i, c in ipairs(told.all) do list[i] = candidate(found, c) end
  return json.text(json.object { { "scene", found.job.model.name }, { "rows", found.log.rows },
    { "rate", found.log.rate }, { "by", found.by }, { "best", told.best and told.best.place or json.null },
    { "candidates", list } })
end

return report
