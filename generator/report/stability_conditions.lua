-- stability_conditions.lua -- stability of spins in words: conditions, whether they hold, how far a parameter may go.
--
-- The axes of mass/stability are matched with the ascending principal moments of report/facts, whose entries get
--     condition, condition_dissipative               text in the parameters (plain form), or nil without a closed form
--     about, place                                   the axis in words, and its number in mass/stability
--     stable, stable_dissipative                     1, 0, -1 at the parameters' defaults
--     margins, margins_dissipative                   {name, unit, default, below, above}: the nearest values of a
--                                                    parameter at which the verdict changes and there is a body, the
--                                                    others at defaults
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local expr = require "generator.algebra.expr"
local poly = require "generator.algebra.poly"
local roots = require "generator.algebra.roots"
local section = require "generator.algebra.section"
local mass = require "generator.mass.spin_stability"
local validity = require "generator.mass.validity"
local json = require "generator.report.json"

local stability = {}

-- Which axis of mass/stability (1, 2, 3) is the k-th ascending moment of the facts.
local function matched(f, s)
  local structure, place = f.structure, {}
  local function largest(a)
    local n = 1
    for i = 2, 3 do
      if math.abs(a[i]) > math.abs(a[n]) then n = i end
    end
    return n
  end
  if s.line or structure.kind == "symmetric" then
    local m = f.job.model
    local own = 3
    for i = 1, 3 do
      if not s.line and structure.k[i] ~= expr.zero then own = i end
    end
    local first = R.sign(m:number(structure.axial - structure.alpha)) < 0
    place[first and 1 or 3] = own
    place[2], place[first and 3 or 1] = own % 3 + 1, (own + 1) % 3 + 1
    if place[2] > place[first and 3 or 1] then place[2], place[first and 3 or 1] = place[first and 3 or 1], place[2] end
  elseif structure.kind == "sphere" then
    place = { 1, 2, 3 }
  else
    for k = 1, 3 do place[k] = largest(f.axes[k]) end
    if s.block then -- the plane's two axes in the order of their moments
      local b, plane = s.block, {}
      for k = 1, 3 do
        local a = f.axes[k]
        if math.abs(a[b.c]) < 0.5 then plane[#plane + 1] = k else place[k] = b.c end
      end
      place[plane[1]], place[plane[2]] = b.i, b.j
    end
  end
  return place
end

-- The sign of an atom at the model's defaults.
local function at_defaults(m) return function(atom) return R.sign(m:number(atom)) end end

-- The atom as a polynomial in one parameter, the others at their defaults: coefficients in doubles, or nil.
local function in_one(m, atom, name)
  if not poly.modest(atom) then return nil end
  local terms = section.terms(atom, m.defaults, { name })
  return terms and section.coefficients(terms)
end

local exactly = validity.exactly

-- Is there a body for every value of the parameter from its default to x, the others at their defaults?  A condition
-- holds at the default; it is asked for at x, and between where it is a polynomial in the parameter.
local function exists(m, name, x)
  local here, env = R.todouble(m.defaults[name]), {}
  for k, v in pairs(m.defaults) do env[k] = v end -- into a table: order is lost anyway
  env[name] = R.fromdouble(x)
  for _, c in ipairs(m.conditions) do
    if not expr.constant(c.e, { [name] = true }) then
      local e = calculus.substitute(c.e, exactly)
      local fine, value = pcall(evaluate.precise, e, env, 128)
      local polynomial = in_one(m, e, name)
      if not fine or R.sign(value) < 0 then return false end
      if polynomial and #roots.between(polynomial, math.min(here, x), math.max(here, x)) > 0 then return false end
    end
  end
  return true
end

-- How far each parameter may go until the verdict about axis k changes, while there is a body.  It can only change
-- where an atom is zero, so the atoms' zeros are candidates and the verdict half-way between two neighbours is that of
-- the interval.  A parameter in which some atom is no polynomial has no row.
local function margins(f, s, k, dissipation)
  local m, list = f.job.model, {}
  local sign = at_defaults(m)
  local now = s.verdict(s:signs(sign), k, dissipation)
  for _, p in ipairs(m.params) do
    local here = R.todouble(p.default)
    local positive = s.critical.map[p.sym] ~= nil
    local candidates, usable, polynomials = {}, true, {}
    for _, atom in ipairs(s:atoms()) do
      if not expr.constant(atom, { [p.name] = true }) then
        local c = in_one(m, atom, p.name)
        usable = usable and c ~= nil
        polynomials[atom] = c
        local far = 2.0 ^ 20 * (here ~= 0 and math.abs(here) or 1)
        for _, x in ipairs(c and roots.between(c, positive and 0.0 or -far, far) or {}) do
          candidates[#candidates + 1] = x
        end
      end
    end
    table.sort(candidates)
    local function verdict(x)
      return s.verdict(s:signs(function(atom)
        local c = polynomials[atom]
        if not c then return sign(atom) end
        local y = roots.value(c, x)
        return y > 0 and 1 or y < 0 and -1 or 0
      end), k, dissipation)
    end
    local below, above
    for i, x in ipairs(candidates) do -- the verdict between neighbouring candidates
      local before = candidates[i - 1] or (positive and 0.0 or x - 1)
      local after = candidates[i + 1] or 2 * math.abs(x) + x
      if x > here and not above and verdict((x + after) / 2) ~= now then above = x end
      if x < here and verdict((x + before) / 2) ~= now then below = x end
    end
    if below and not exists(m, p.name, below) then below = nil end
    if above and not exists(m, p.name, above) then above = nil end
    if usable and (below or above) then
      list[#list + 1] = { name = p.name, sym = p.sym, unit = p.unit, below = below, above = above, default = here }
    end
  end
  return list
end

-- Extends the entries of f.stability; sets f.design, or f.design_numeric = true when there are only numbers.
function stability.extend(f)
  local m = f.job.model
  local s = mass.of(m)
  if not s.axes then
    for k, entry in ipairs(f.stability) do
      entry.stable = entry.verdict == "stable" and 1 or entry.verdict == "unstable" and -1 or 0
      entry.stable_dissipative = f.moments[k] < f.moments[3] and -1 or f.moments[2] < f.moments[3] and 1 or 0
    end
    return
  end
  f.design = s
  local place, signs = matched(f, s), s:signs(at_defaults(m))
  for k, entry in ipairs(f.stability) do
    local n = place[k]
    entry.place, entry.about = n, s.axes[n]
    entry.condition, entry.condition_dissipative = s:condition(n, false, "plain"), s:condition(n, true, "plain")
    entry.stable, entry.stable_dissipative = s.verdict(signs, n, false), s.verdict(signs, n, true)
    entry.margins, entry.margins_dissipative = margins(f, s, n, false), margins(f, s, n, true)
  end
end

local words = { [1] = "stable", [0] = "neutral", [-1] = "unstable" }

local longest = 160 -- characters of a condition in a report

local function number(x) return string.format("%.4g", x) end

-- "0.05 m < b < 0.2 m" or "h > 0.05 m": where the verdict stays as it is.
local function range(m)
  local name, unit = m.name, m.unit ~= "" and m.unit ~= "1" and " " .. m.unit or ""
  local below, above = m.below and number(m.below) .. unit, m.above and number(m.above) .. unit
  if not below then return name .. " < " .. above end
  if not above then return name .. " > " .. below end
  return below .. " < " .. name .. " < " .. above
end

-- Lines about one axis with or without dissipation.
local function axis_lines(f, e, name, dissipation, lines)
  local way = dissipation and "_dissipative" or ""
  local verdict = words[e["stable" .. way]]
  local said = name .. (dissipation and ", with dissipation: " or ": ")
  if not f.design then
    lines[#lines + 1] = said .. verdict
    return
  end
  local condition = f.design:condition(e.place, dissipation, "unicode")
  local whatever = string.find(condition, "^never") or string.find(condition, "^always")
  if not whatever then said = said .. "stable iff " end
  if utf8.len(condition) > longest then condition = "(a long polynomial)" end
  lines[#lines + 1] = said .. condition .. "; here " .. verdict
  for _, m in ipairs(e["margins" .. way]) do
    local now = " (now " .. number(m.default) .. ")"
    lines[#lines + 1] = "  " .. verdict .. " while " .. range(m) .. now
  end
end

-- Lines of a section "Stability by design".
function stability.lines(f)
  local lines = { "a free spin about a principal axis; with dissipation the body loses energy inside and keeps L" }
  if not f.design then
    lines[2] = "the principal axes have no simple closed form: verdicts at the parameters' defaults"
  end
  local pair = false
  for k, e in ipairs(f.stability) do
    local paired = f.design and f.design:paired(e.place)
    if not (paired and pair) then
      local name = e.about and string.gsub(e.about, "^axis ", "about axis ") or "about axis " .. k
      if paired then name = "about any axis" .. (f.structure.kind == "sphere" and "" or " across the symmetry axis") end
      for _, dissipation in ipairs { false, true } do axis_lines(f, e, name, dissipation, lines) end
    end
    pair = pair or paired
  end
  return lines
end

-- Further members of a JSON entry of stability[]: {key, value} pairs.  What is not known has no member: a condition
-- without axes in closed form, a side on which the verdict never changes.
function stability.json(e)
  local list = {}
  local function put(to, key, value)
    if value ~= nil then to[#to + 1] = { key, value } end
  end
  put(list, "about", e.about)
  put(list, "condition", e.condition)
  put(list, "condition_dissipative", e.condition_dissipative)
  put(list, "holds", e.stable == 1)
  put(list, "holds_dissipative", e.stable_dissipative == 1)
  put(list, "verdict_dissipative", words[e.stable_dissipative])
  for _, way in ipairs { "margins", "margins_dissipative" } do
    local rows = {}
    for i, m in ipairs(e[way] or {}) do
      local row = { { "parameter", m.name }, { "default", m.default } }
      put(row, "below", m.below)
      put(row, "above", m.above)
      rows[i] = json.object(row)
    end
    put(list, way, rows)
  end
  return list
end

return stability
