-- stability_conditions.lua -- stability of spins in words: conditions, whether they hold, how far a parameter may go.
--
-- The axes of mass/stability are matched with the ascending principal moments of report/facts, whose entries get
--     condition, condition_dissipative               text in the parameters (plain form), or nil without a closed form
--     about, place                                   the axis in words, and its number in mass/stability
--     stable, stable_dissipative                     1, 0, -1 at the parameters' defaults
--     by                                             what decides: mass/stability, or dynamics/sleeping of a heavy top
--     margins, margins_dissipative                   {name, unit, default, below, above}: the nearest values of a
--                                                    parameter at which the verdict changes and there is a body, the
--                                                    others at defaults
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local roots = require "generator.algebra.roots"
local vec = require "generator.algebra.vec"
local sleeping = require "generator.dynamics.sleeping"
local extent = require "generator.mass.extent"
local mass = require "generator.mass.spin_stability"
local json = require "generator.report.json"

local stability = {}

local words = { [1] = "stable", [0] = "neutral", [-1] = "unstable" }

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

local near = 1e-9 -- of a parameter: a verdict that changes so close to the end of the body changes there

-- Does the parameter, the others at their defaults, come as far as x with a body beyond it?
local function exists(m, name, x)
  local here = R.todouble(m.defaults[name])
  local beyond = x + near * (x - here)
  local low, high = extent.of(m, name, math.min(here, beyond), math.max(here, beyond))
  return low <= math.min(here, beyond) and high >= math.max(here, beyond)
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
        local c = extent.polynomial(m, atom, p.name)
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
      local unit = p.own == "rad/s" and p.own or p.unit -- a rate of turning is no frequency
      list[#list + 1] = { name = p.name, sym = p.sym, unit = unit, below = below, above = above, default = here }
    end
  end
  return list
end

-- What dynamics/sleeping says of a heavy top, and the number of the facts' axis that is the top's; nil for others.
-- About an axis across it no spin is steady, so those have no verdict.
local function heavy(f)
  local m = f.job.model
  local top, axis = sleeping.of(m, f.closed), 1
  if not top then return nil end
  local k = f.structure.kind == "symmetric" and f.structure.k or m.com
  local function along(a)
    return math.abs(a[1] * m:double(k[1]) + a[2] * m:double(k[2]) + a[3] * m:double(k[3]))
  end
  for i = 2, 3 do
    if along(f.axes[i]) > along(f.axes[axis]) then axis = i end
  end
  return top, axis
end

-- Extends the entries of f.stability; sets f.design where there are closed forms, and of a heavy top f.upright, the
-- verdict of its upright spin in a word.
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
  local top, axis = heavy(f)
  f.upright = top and words[top:here(m)]
  for k, entry in ipairs(f.stability) do
    local n = place[k]
    entry.place, entry.about, entry.by = n, s.axes[n], s
    entry.condition, entry.condition_dissipative = s:condition(n, false, "plain"), s:condition(n, true, "plain")
    entry.stable, entry.stable_dissipative = s.verdict(signs, n, false), s.verdict(signs, n, true)
    entry.margins, entry.margins_dissipative = margins(f, s, n, false), margins(f, s, n, true)
    if top then
      entry.by, entry.stable, entry.stable_dissipative = top, k == axis and top:here(m) or nil, nil
      entry.condition, entry.condition_dissipative = k == axis and top:condition(n, false, "plain") or nil, nil
      entry.margins, entry.margins_dissipative = k == axis and margins(f, top, n, false) or {}, {}
    end
  end
end

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

-- How far each parameter may go.
local function margin_lines(list, verdict)
  return vec.map(list, function(m)
    return "  " .. verdict .. " while " .. range(m) .. " (now " .. number(m.default) .. ")"
  end)
end

-- Lines about the upright spin of a heavy top.
local function top_lines(f, e)
  local top, m = e.by, f.job.model
  local n, verdict = top.n.name, words[e.stable]
  local lines = { "gravity acts on the body: it is a heavy top, and a free body's verdicts do not hold",
    "upright on its point, spinning about " .. (e.about or "its axis") .. " at the rate " .. n .. ": stable iff " ..
      top.law .. "; here " .. verdict }
  if top.rate then
    local bound = top:condition(1, false, "unicode")
    if utf8.len(bound) > longest then bound = "|" .. n .. "| > 2 sqrt(I1 M g l)/I3" end
    local now = number(m:double(top.spin))
    lines[#lines + 1] = "  " .. bound .. " = " .. number(top.rate) .. " rad/s (now " .. now .. ")"
  end
  for _, line in ipairs(margin_lines(e.margins, verdict)) do lines[#lines + 1] = line end
  lines[#lines + 1] = "hanging under its point: always stable"
  return lines
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
  for _, line in ipairs(margin_lines(e["margins" .. way], verdict)) do lines[#lines + 1] = line end
end

-- Lines of a section "Stability by design".
function stability.lines(f)
  for _, e in ipairs(f.stability) do
    if e.by and e.by.law and e.stable then return top_lines(f, e) end
  end
  local lines = { "a free spin about a principal axis; with dissipation the body loses energy inside and keeps L" }
  if not f.design then
    lines[2] = "the principal axes have no simple closed form: verdicts at the parameters' defaults"
  end
  if #f.job.record.effects > 0 then lines[#lines + 1] = "(of the body without its effects)" end
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
  put(list, "holds", e.stable and e.stable == 1)
  put(list, "holds_dissipative", e.stable_dissipative and e.stable_dissipative == 1)
  put(list, "verdict_dissipative", words[e.stable_dissipative])
  put(list, "verdict_upright", e.by and e.by.law and words[e.stable])
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
