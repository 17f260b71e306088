-- linearised.lua -- what is said of the linearised free top: the scene's own amplitude, its error, where it is good.
--
-- The numbers are mass/linearised's closed forms at the parameters' defaults, of the body without its effects.  The
-- facts get f.linearised = {own = the scene's motion, axes = {one an axis}}.
-- SPDX-License-Identifier: GPL-3.0-or-later

local law = require "generator.mass.linearised"
local vec = require "generator.algebra.vec"
local json = require "generator.report.json"

local linearised = {}

linearised.periods = { 1, 100 }
local amplitudes = { 0.3, 0.1, 0.03, 0.01 }
local targets = { 1e-2, 1e-3, 1e-6 }
local wrong = 0.1 -- of the spin: where the linearised motion of an unstable axis is said to have failed

local function short(x) return string.format("%.2g", x) end

-- Of a stable axis errors[n][i], after periods[n] from amplitudes[i] (false: beyond the separatrix), and good[n][i],
-- the amplitude below which the error stays within targets[i]; of an unstable one times[i].
local function axis(I, k)
  local A = law.axis(I, k)
  local entry = { law = A, kind = A.kind, errors = {}, good = {}, times = {} }
  local x, y = law.direction(A)
  for i, e in ipairs(amplitudes) do
    if A.kind == "stable" then
      local motion = law.worst(A, e)
      for n, periods in ipairs(linearised.periods) do
        entry.errors[n] = entry.errors[n] or {}
        entry.errors[n][i] = motion and law.error(motion, periods) or false
      end
    elseif A.kind ~= "exact" then
      entry.times[i] = law.failure(A, e * x, e * y, wrong)
    end
  end
  if A.kind == "stable" then
    for n, periods in ipairs(linearised.periods) do
      entry.good[n] = vec.map(targets, function(eps) return law.amplitude(A, eps, periods) end)
    end
  end
  return entry
end

-- f: the facts with moments and axes; sets f.linearised.
function linearised.extend(f)
  local m, I = f.job.model, f.moments
  local omega = vec.map(m.omega, function(e) return m:double(e) end)
  local w = vec.map(f.axes, function(a) return a[1] * omega[1] + a[2] * omega[2] + a[3] * omega[3] end)
  local own = law.spin(I, w)
  own.law = law.axis(I, own.k)
  if own.rate == 0 or own.e == 0 or own.law.kind == "exact" then
    own.exact = true
  elseif own.law.kind == "stable" then
    own.motion = law.motion(own.law, own.x, own.y)
    own.errors = own.motion and vec.map(linearised.periods, function(n) return law.error(own.motion, n) end)
    own.period = 2 * math.pi / own.law.frequency / own.rate
  else
    own.time = law.failure(own.law, own.x, own.y, wrong) / own.rate
  end
  f.linearised = { own = own, axes = { axis(I, 1), axis(I, 2), axis(I, 3) } }
end

-- The scene's own motion in one sentence.
local function verdict(f)
  local own = f.linearised.own
  if own.rate == 0 then return "this scene starts at rest: the linearised top is exact, it stays there" end
  local start = "this scene's motion has e = " .. short(own.e) .. " about axis " .. own.k .. ": "
  if own.law.kind == "exact" and f.moments[1] == f.moments[3] then
    return "all moments are equal: the linearised top is exact, the rates stay what they are"
  elseif own.law.kind == "exact" then
    return start .. "the linearised top is exact, the moments across the axis are equal"
  elseif own.exact then
    return start .. "the linearised top is exact, a pure spin stays what it is"
  elseif own.time == math.huge then
    return start .. "the linearised top never fails, this motion ends in the spin"
  elseif own.time then
    return start .. own.law.kind .. ", the linearised top is wrong by " .. short(wrong) .. " w after " ..
      short(own.time) .. " s"
  elseif not own.motion then
    return start .. "beyond the separatrix, the polhode goes round another axis and the linearised top fails at once"
  end
  return start .. "the linearised top is wrong by " .. short(own.errors[1]) .. " w after one period (" ..
    short(own.period) .. " s), by " .. short(own.errors[2]) .. " w after 100"
end

local function row(list, unit)
  local cells = {}
  for i, x in ipairs(list) do
    cells[i] = (x and (x == math.huge and "never" or short(x) .. (unit or "")) or "past") .. " (e = " ..
      short(amplitudes[i]) .. ")"
  end
  return table.concat(cells, ", ")
end

-- Lines of the section.
function linearised.lines(f)
  local lines = { "a spin w about principal axis k, a transverse rate e w in the worst direction: the linearised top" ..
    " keeps w and lets the two other rates oscillate or grow",
    "errors: the largest of a rate along a principal axis, in parts of w; where the axis is stable, to leading order",
    "  the rate along it falls by C e^2, the frequency by C e^2/2, the third harmonic is C e^2/8 of the first,",
    "  C = |Ii - Ij|/(2 Ik min(|Ik - Ij|/Ii, |Ik - Ii|/Ij)); separatrix at e = 1/sqrt(2 C)" }
  if #f.job.record.effects > 0 then lines[#lines + 1] = "(of the body without its effects)" end
  for k, a in ipairs(f.linearised.axes) do
    local name = "axis " .. k .. ": "
    if a.kind == "exact" then
      lines[#lines + 1] = name .. "exact at any amplitude, the moments across it are equal"
    elseif a.kind == "stable" then
      local A = a.law
      lines[#lines + 1] = name .. "stable, C = " .. short(A.C) .. ", separatrix at e = " .. short(A.limit)
      for n, periods in ipairs(linearised.periods) do
        lines[#lines + 1] = "  error in " .. periods .. (periods == 1 and " period: " or " periods: ") ..
          row(a.errors[n])
      end
      for n, periods in ipairs(linearised.periods) do
        local g = a.good[n]
        lines[#lines + 1] = string.format("  %d %s right to 1e-2 below e = %s, to 1e-3 below %s, to 1e-6 below %s",
          periods, periods == 1 and "period is" or "periods are", short(g[1]), short(g[2]), short(g[3]))
      end
    else
      lines[#lines + 1] = name .. a.kind .. ", wrong by " .. short(wrong) .. " w after the time " .. row(a.times, "/w")
    end
  end
  lines[#lines + 1] = verdict(f)
  return lines
end

local function value(x) return (x == nil or x == false or x == math.huge) and json.null or x end

-- For --format json: an object.
function linearised.json(f)
  local own, axes = f.linearised.own, {}
  for k, a in ipairs(f.linearised.axes) do
    local entry = { { "axis", k }, { "kind", a.kind } }
    local function put(key, x) entry[#entry + 1] = { key, x } end
    if a.kind == "stable" then
      put("C", a.law.C)
      put("separatrix", a.law.limit)
      for n, periods in ipairs(linearised.periods) do
        local errors, good = {}, {}
        for i, e in ipairs(amplitudes) do
          errors[i] = json.object { { "amplitude", e }, { "error", value(a.errors[n][i]) } }
        end
        for i, eps in ipairs(targets) do
          good[i] = json.object { { "error", eps }, { "amplitude", a.good[n][i] } }
        end
        put("errors_" .. periods, errors)
        put("good_" .. periods, good)
      end
    elseif a.kind ~= "exact" then
      local times = {}
      for i, e in ipairs(amplitudes) do
        times[i] = json.object { { "amplitude", e }, { "time_times_rate", value(a.times[i]) } }
      end
      put("wrong_by_a_tenth", times)
    end
    axes[k] = json.object(entry)
  end
  local motion, errors = own.motion, own.errors or {}
  local exact = own.exact and 0.0 or nil
  return json.object { { "axis", own.k }, { "amplitude", own.e }, { "kind", own.law.kind },
    { "exact", own.exact or false }, { "axial_change", value(motion and motion.axial or exact) },
    { "frequency_shift", value(motion and motion.shift or exact) },
    { "third_harmonic", value(motion and motion.third or exact) }, { "error_1", value(errors[1] or exact) },
    { "error_100", value(errors[2] or exact) }, { "wrong_by_a_tenth", value(own.time) },
    { "verdict", verdict(f) }, { "axes", axes } }
end

return linearised
