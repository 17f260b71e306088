-- firmware.lua -- a small application around the scene: a fixed-rate loop with gyro, filter and watchdog for a
-- Cortex-M4F, and the same natively.  Single precision is the default, because it is all that this processor has; and
-- rk4 alone, because a closed form would never be called.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"
local orbit = require "generator.emit.orbit"
local samples = require "generator.emit.samples"
local template = require "generator.emit.template"

local firmware = { real = "float", methods = { "rk4" }, jacobians = "transition", whole = true, layout = "single" }

local FOLDER = "projects/firmware/"
local FILES = { "config.h", "derived.h", "main.c", "estimator.h", "estimator.c", "gyro.h", "gyro.c", "readings.c",
  "control.h", "control.c", "watchdog.h", "watchdog.c", "telemetry.h", "telemetry.c", "inject.h", "inject.c", "port.h",
  "port_m4f.c", "port_host.c", "startup.h", "startup.c", "link.ld", "Makefile", "README.md" }
local GROUP
do
  local list = {}
  for i, name in ipairs(FILES) do list[i] = FOLDER .. name end
  GROUP = template.group(table.unpack(list))
end

-- What a project edits.  No version, name or number of the scene stands in them, so that they fit what is made later.
local once = { ["config.h"] = true, ["gyro.c"] = true, ["control.c"] = true, ["port_m4f.c"] = true,
  ["startup.c"] = true, ["link.ld"] = true }

local most_ticks = 1 << 24 -- of SysTick's counter
local clock = 25000000     -- Hz, of mps2-an386

local function has(job, name)
  for _, f in ipairs(job.functions) do
    if f.name == name then return true end
  end
  return false
end

function firmware.check(job)
  local m, d, line = job.model, job.diag, job.record.line
  local function refuse(rule, got)
    d:error(line, "project firmware", rule, got)
    return false
  end
  if not m.has.attitude then
    return refuse("the scene must have an attitude to estimate", "a scene without attitude")
  elseif not m.has.rates then
    return refuse("the scene must have rates that a gyro measures", "a scene without rates")
  elseif not has(job, "step_transition") then
    return refuse("the method must be a fixed step that is one function (rk4, semi)",
      "method " .. job.steppers[1].method.name)
  end
  for _, file in ipairs(FILES) do
    if file == m.name .. ".c" or file == m.name .. ".h" then
      return refuse("the scene must not be named like a file of the application", m.name)
    end
  end
  local step = m:number(m.step)
  if step < R.new(1, 10000) or step > R.new(3600) then
    return refuse("time.step is the loop's period: 1e-4 s to 3600 s", number.text(step, "double") .. " s")
  end
  return true
end

local function law_values(v, name, list, text)
  local place = 0
  v.laws, v.has_laws, v.laws_count = {}, #list > 0, "0"
  local names, jump, band = {}, {}, {}
  for i, law in ipairs(list) do
    local upper = law.name == "jacobi_integral" and "INTEGRAL" or string.upper(law.name)
    local word = law.name == "jacobi_integral" and "the Jacobi integral" or
      law.name == "momentum" and "the angular momentum in inertial axes" or "the energy"
    local t = law.timed and "(" .. name .. "_real)e->cycle*APP_STEP, " or ""
    local f = name .. "_" .. law.name .. "(&e->model, " .. t .. "e->x"
    local at = string.format("%d", place)
    v.laws[i] = { upper = upper, jump = text(law.jump), band = text(law.size / R.new(64)),
      unit = law.name == "momentum" and "kg m^2/s" or "J",
      call = law.count == 1 and "c[" .. at .. "] = " .. f .. ");" or f .. ", c + " .. at .. ");" }
    names[i] = word
    for _ = 1, law.count do
      jump[#jump + 1], band[#band + 1] = "APP_" .. upper .. "_JUMP", "APP_" .. upper .. "_BAND"
    end
    place = place + law.count
  end
  v.laws_count, v.laws_text = string.format("%d", place), table.concat(names, ", ")
  v.laws_words = #names > 0 and ", " .. table.concat(names, " and ") .. " as they were" or ""
  v.jump_list, v.band_list = table.concat(jump, ", "), table.concat(band, ", ")
end

local function sample_lines(rows)
  local out, line = {}, ""
  for i, r in ipairs(rows) do
    local cell = string.format("{%d, %d, %d}", r[1], r[2], r[3]) .. (i < #rows and "," or "")
    if #line + #cell > 96 then out[#out + 1], line = line, "" end
    line = line == "" and cell or line .. " " .. cell
  end
  out[#out + 1] = line
  return out
end

-- The values, or nil after an error in job.diag.
local function values_of(job, base)
  local m, real, v = job.model, job.real, {}
  local round = orbit.rounder(real)
  local epsilon = R.new(2) ^ (real == "float" and -23 or -52)
  local params = {}
  for _, p in ipairs(m.params) do params[p.name] = round(p.default) end
  local s, why = samples.of(job, params, round, epsilon)
  if not s then
    job.diag:error(job.record.line, "project firmware", why, m.name)
    return nil
  end
  local function text(q) return number.text(round(q), real) end
  local function whole(n) return string.format("%d", n) end
  local step = m:number(m.step)
  local ticks = R.toint(R.floor(step * R.new(clock) / R.new(most_ticks))) + 1
  v.app_step, v.app_ticks = text(step), whole(ticks)
  v.app_clock_most = whole(R.toint(R.floor(R.new(most_ticks) / step))) -- Hz, with one tick a cycle
  v.samples_count, v.samples_every, v.noise = whole(samples.count), whole(s.every), whole(samples.noise)
  v.sample_lines, v.gyro_range, v.gyro_lsb = sample_lines(s.table), text(s.full), text(s.lsb)
  v.gyro_variance = text(s.lsb * s.lsb * (R.new(samples.noise) ^ 2 + R.new(1, 12)))
  v.rate_variance, v.gate = text((s.lsb / R.new(64)) ^ 2), text(R.new(25))
  v.start_sigma, v.norm_limit = text(s.full / R.new(64)), text(s.norm)
  v.run_cycles = whole(s.every * samples.count)
  v.telemetry, v.fault_limit = v.samples_every, "8"
  -- what a rejected reading counts, and when there were too many: docs/projects.md
  v.blind_each, v.blind_limit, v.blind_share, v.gyro_most = "4", "12", "5", text(R.new(samples.full - 1))
  v.control_file, v.control_words = base.has_inputs and " control.c" or "", base.has_inputs and " control.c," or ""
  v.single = real == "float"
  v.bits_type, v.binary_shift = v.single and "uint32_t" or "uint64_t", v.single and "23" or "52"
  v.digits_blank = real == "float" and "9" or "17"
  v.nan_bits = real == "float" and "0x7FC00000U" or "0x7FF8000000000000U"
  v.states_count = whole(#job.states)
  v.step_name = base.name .. "_step"
  local function short(q) -- four decimals
    return number.text(R.floor(q * R.new(10000) + R.half) / R.new(10000), "double")
  end
  v.samples_span, v.app_rate = short(step * R.new(s.every * samples.count)), short(R.one / step)
  v.exact_cycles = real == "float" and "2^24" or "2^32"
  v.start_sigma_text, v.lsb_text = number.text(s.full / R.new(64), "double"), number.text(s.lsb, "double")
  v.libm_words = job.libm == "own" and "" or " and what the scene needs of <math.h>"
  law_values(v, base.name, s.laws, text)
  return v
end

function firmware.files(job, made)
  local v = values_of(job, made.base)
  if not v then return nil end
  local render, out = GROUP(job.templates, made.base, v), {}
  for _, name in ipairs(FILES) do
    if made.base.has_inputs or not string.find(name, "^control") then
      out[#out + 1] = { name = name, text = render(FOLDER .. name), once = once[name] }
    end
  end
  return out
end

return firmware
