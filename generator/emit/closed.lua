-- closed.lua -- the closed form as C: which templates say it, and their values.
--
--     closed.render(job, base, ctx) -> {header, parts = list of {text, general = is it equal for every body?},
--                                       own = has it NAME_own_orbit?}
-- The order of the templates is that of the C: what stands first is used by what follows.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local R = require "generator.algebra.rational"
local analysis = later "generator.emit.analysis"
local base_values = require "generator.emit.base"
local economy = require "generator.emit.economy"
local number = require "generator.emit.number"
local orbit = require "generator.emit.orbit"
local source = require "generator.emit.source"
local template = require "generator.emit.template"

local closed = {}

-- The names of templates in a text; those without a folder are in `room`.
local function names(room, text)
  local list = {}
  for name in string.gmatch(text, "%S+") do
    list[#list + 1] = string.find(name, "/", 1, true) and name or room .. "/" .. name
  end
  return list
end

local function of(headers, sources)
  return { headers = names("orbit", "form.h " .. headers), sources = names("orbit", sources) }
end

-- By the form's kind.
local TEXTS = {
  sphere = of("closed.h state.h spin_periods.h", "circle.c count.c quaternion.c uniform.c closed.c"),
  symmetric = of("closed.h state.h spin_periods.h", "circle.c count.c numeric/quotient.c quaternion.c " ..
    "uniform.c closed.c"),
  asymmetric = of("top.h state.h top_periods.h", "circle.c numeric/double.c theta_at.c top.c polynomial.c " ..
    "circular.c hyperbolic.c quaternion.c setup.c many.c count.c tick.c query.c"),
  gyrostat = of("closed.h state.h spin_periods.h", "circle.c count.c numeric/quotient.c quaternion.c " ..
    "uniform.c closed.c"),
  axial = of("axial.h", "circle.c numeric/quotient.c clock.c axial.c"),
  lagrange = of("lagrange.h state.h nutation.h", "circle.c numeric/double.c numeric/integral.c numeric/wide.c " ..
    "quaternion.c polynomial.c phase.c frame.c phases.c lagrange.c lagrange_theta.c lagrange_at.c states.c " ..
    "lagrange_solve.c count.c lagrange_tick.c"),
  ["asymmetric gyrostat"] = of("gyrostat.h state.h gyrostat_periods.h", "circle.c numeric/double.c " ..
    "numeric/integral.c numeric/wide.c quaternion.c polynomial.c phase.c frame.c phases.c gyrostat.c " ..
    "gyrostat_at.c gyrostat_theta.c states.c gyrostat_solve.c count.c lagrange_tick.c"),
  point = of("point.h", "point.c"),
  ["rolling ball"] = of("ball.h", "circle.c quaternion.c uniform.c ball.c"),
  ["centre of a rolling ball"] = of("centre.h", "circle.c quaternion.c uniform.c centre.c"),
  ["centre of a sliding ball"] = of("slide.h", "circle.c quaternion.c uniform.c slide.c"),
}

-- The largest error that the search has found, and in how many states (docs/hunt.md).
local WORST = {
  asymmetric = { double = { "3.6e-15", "1.5e8" }, float = { "1.5e-6", "3e6" } },
  symmetric = { double = { "3.1e-15", "1.1e6" }, float = { "1.6e-6", "1.1e6" } },
  lagrange = { double = { "2.6e-15", "5e4" }, float = { "1.4e-6", "1.5e5" } },
}

-- What counts time in ticks, or answers for the free motion alone, and the functions that need it.
local ONLY_FREE, FOR = {}, {}
for _, row in ipairs { { "count.c", "set_tick at_tick" }, { "tick.c", "set_tick at_tick" },
  { "many.c", "at_many" }, { "query.c",
    "polhode_period precession_rate precession_period rotation_number next_flip" } } do
  local name = "orbit/" .. row[1]
  ONLY_FREE[name], FOR[name] = true, row[2]
end

-- Is a function asked for that this text is for?
local function called(name, asked)
  if not FOR[name] then return true end
  for f in string.gmatch(FOR[name], "%S+") do
    if asked(f) then return true end
  end
  return false
end

-- A free motion in another time, or carried along: the clock, or the flight, stands before what asks for the time.
local function beside(free, flags)
  local asks = { ["orbit/theta_at.c"] = true, ["orbit/closed.c"] = true }
  local list = {}
  for _, name in ipairs(TEXTS[free.kind].sources) do
    if asks[name] then
      if flags.damped and free.kind == "sphere" then list[#list + 1] = "numeric/quotient.c" end
      list[#list + 1] = flags.damped and "orbit/clock.c" or "orbit/flight.c"
    end
    if not ONLY_FREE[name] then list[#list + 1] = name end
  end
  if flags.damped then list[#list + 1] = "orbit/damped.c" end
  list[#list + 1] = "orbit/each.c"
  local headers = TEXTS[free.kind].headers
  return { headers[1], headers[2], flags.damped and "orbit/damped.h" or "orbit/flight.h" }, list
end

-- Equal for every body, as is what stands in numeric/.
local GENERAL = { ["orbit/circle.c"] = true, ["orbit/quaternion.c"] = true, ["orbit/polynomial.c"] = true }

-- The templates of headers and of sources.
local function texts(form, asked)
  if form.free then return beside(form.free, form.flags) end
  local t, list = TEXTS[form.kind], {}
  for _, name in ipairs(t.sources) do
    if called(name, asked) then list[#list + 1] = name end
  end
  return t.headers, list
end

-- What the contracts say: errors, and which fields there are.
local function contract(form, real, v, asked)
  local worst = WORST[form.kind] and WORST[form.kind][real]
  v.has_tick_fields = not form.free and (asked "set_tick" or asked "at_tick")
  v.orbit_bound = v.single and "4e-6" or "4e-15" -- the requirement of tests/emit and of docs/hunt.md
  v.orbit_worst, v.orbit_searched = worst and worst[1] or false, worst and worst[2] or false
  v.orbit_turns = v.single and "2^17" or "2^40"
  v.orbit_pace = string.find(form.kind, "gyrostat", 1, true) and " or the momentum's" or ""
  v.many_note = form.kind == "asymmetric" and "  Worth vector instructions: with GCC or Clang -O3 -march=native " ..
    "-fno-math-errno." or ""
end

-- One group: the closed forms share most of their texts.
local GROUP
do
  local list, seen = {}, {}
  local function put(name)
    if not seen[name] then list[#list + 1] = name end
    seen[name] = true
  end
  for _, t in pairs(TEXTS) do -- a set: any order
    for _, name in ipairs(t.headers) do put(name) end
    for _, name in ipairs(t.sources) do put(name) end
  end
  for _, name in ipairs { "orbit/damped.h", "orbit/damped.c", "orbit/clock.c", "orbit/flight.h", "orbit/flight.c",
    "orbit/each.c", "orbit/own.c", "core/copy.c",
    "numeric/quotient.c" } do
    put(name)
  end
  GROUP = template.group(table.unpack(list))
end

-- Literals of the real type.
local function literals(real, v)
  local digits, single = base_values.digits[real], real == "float"
  local function put(name, q) v[name] = function() return number.text(q, real) end end
  local function power(name, double_power, float_power)
    put(name, R.new(2) ^ (single and float_power or double_power))
  end
  power("least", -1022, -126)
  power("two64", -64, -64)
  power("two32", -32, -32)
  power("two32_up", 32, 32)
  power("last_turn", 50, 46)
  power("last_time", 990, 97)
  power("no_period", 100, 40)
  -- orbit/clock.c, of y = -rate t, for double (float): e^-y is below 2^-106 (2^-48); e^(y/2)/(y/2) may be split for a
  -- product, and e^y exceeds last_time; e^y is within the range; so is e^(y/4), and e^y exceeds all quotients of two
  -- numbers of the range; a time up to 64 last_time may be split
  put("clock_rest", R.new(single and 34 or 74))
  put("clock_growth", R.new(single and 156 or 1380))
  put("clock_fade", R.new(single and 86 or 700))
  put("clock_end", R.new(single and 352 or 2800))
  power("clock_late", 996, 103)
  power("carlson_close", -(digits // 4 - 1), -(digits // 4))
  -- 1.5 2^(digits - 1): added and taken away again it rounds to a whole number; binary_one + n has n + bias, the
  -- exponent field of 2^n, in its last bits
  put("round_off", R.new(3) * R.new(2) ^ (digits - 2))
  v.nearest_end = single and "2^22" or "2^51"
  put("binary_one", R.new(3) * R.new(2) ^ (digits - 2) + R.new(single and 127 or 1023))
  put("binary_limit", R.new(single and 60 or 500))
  put("binary_end", R.new(single and 120 or 1000))
  v.rate_spare, v.block = single and "12" or "26", single and "16" or "8"
  v.bits_type, v.binary_shift = single and "uint32_t" or "uint64_t", single and "23" or "52"
  -- exponents (templates/numeric/wide.c): below all others, that of 0; below all that matter.  In float an int has
  -- 16 bits on some processors, and three times an exponent must fit
  v.no_exponent, v.least_exponent = single and "-6000" or "-1000000", single and "-3000" or "-100000"
end


-- Constants as pairs high + low: pi, 1/pi, log 2, and the tables of templates/numeric/double.c.
local function constants(real, v)
  local function pair(x)
    local high = R.fromdouble(real == "float" and R.tofloat(x) or R.todouble(x))
    return { high = number.text(high, real), low = number.text(x - high, real) }
  end
  local function named(name, f)
    v[name .. "_high"], v[name .. "_low"] = function() return pair(f()).high end, function() return pair(f()).low end
  end
  local function table_of(n, f)
    return function()
      local list = {}
      for j = 0, n do list[j + 1] = pair(f(R.lift(j))) end
      return list
    end
  end
  named("pi", function() return R.apply("pi", 200) end)
  for name, factor in pairs { inverse_pi = R.one, half_inverse_pi = R.new(1, 2), quarter_inverse_pi = R.new(1, 4) } do
    named(name, function() return factor / R.apply("pi", 200) end) -- into a table: order is lost anyway
  end
  v.two_pi_high = function() return pair(R.new(2) * R.apply("pi", 200)).high end
  named("log2", function() return R.apply("log", 200, R.lift(2)) end)
  v.odd_reciprocals = table_of(5, function(j) return R.one / (R.lift(2) * j + R.one) end)
  v.arctan_eighths = table_of(8, function(j) return R.apply("atan", 200, j / R.lift(8)) end)
  v.log_eighths = table_of(8, function(j) return R.apply("log", 200, R.one + j / R.lift(8)) end)
end

function closed.render(job, base, ctx)
  local form, real = job.closed, ctx.real
  if not form.kind then return nil end
  local v = { theorem = form.theorem, closed_text = form.text, single = real == "float", has_full = form.full or false,
    has_centre = form.centre or false, rolls = false, pair_top = analysis.pair_top[real], clears = false,
    symmetric = false, rod = false, rotor = false, damped = false, flies = false, axial = false, lagrange = false }
  literals(real, v)
  constants(real, v)
  economy.fill(v, real, ctx.name .. "_real")
  local stored, uses_model = source.constants(job.closed_constants, real)
  v.uses_model = uses_model
  for _, more in ipairs { stored, form.flags or {} } do
    for name, x in pairs(more) do v[name] = x end -- into a table: order is lost anyway
  end
  for _, axis in ipairs { "x", "y", "z" } do -- against gravity's direction d
    local down = "d" .. axis
    local e = job.closed_constants[down]
    if e then v["up_" .. axis], v[down] = e.kind == "num" and number.text(-e.value, real) or "-" .. v[down], nil end
  end
  contract(form, real, v, job.selection.asked)
  v.vectorised = job.selection.asked "at_many"
  v.inline = v.vectorised and base.upper .. "_INLINE" or "static inline"
  orbit.fill(job, v)
  local render, header_names, source_names = GROUP(job.templates, base, v), texts(form, job.selection.asked)
  local headers, parts = {}, {}
  for i, name in ipairs(header_names) do headers[i] = render(name) end
  if v.has_own then source_names[#source_names + 1] = "orbit/own.c" end
  for i, name in ipairs(source_names) do
    parts[i] = { text = render(name), general = GENERAL[name] or string.find(name, "^numeric/") ~= nil }
    v.clears = v.clears or string.find(parts[i].text, ctx.name .. "_copy%(&%a+, 0,") ~= nil
  end
  table.insert(parts, 1, { text = render "core/copy.c" })
  return { header = table.concat(headers, "\n"), parts = parts, own = v.has_own }
end

return closed
