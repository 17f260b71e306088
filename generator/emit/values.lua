-- values.lua -- what the templates of a scene are filled with: numbers, names, lists of text.
--
--     values.common(job) -> v, ctx      shared by all templates
--     values.closed(job, v, ctx)        the closed form's part of header and source
--     values.cost_row(name, counts)     a row of the README's table of operations
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local closed = require "generator.emit.closed"
local economy = require "generator.emit.economy"
local init = require "generator.emit.init"
local libm = require "generator.emit.libm"
local listing = require "generator.emit.listing"
local number = require "generator.emit.number"
local orbit = require "generator.emit.orbit"
local selftest = require "generator.emit.selftest"
local source = require "generator.emit.source"
local special = require "generator.emit.special"
local split = require "generator.emit.split"
local stability = require "generator.emit.stability_signs"
local template = require "generator.emit.template"

local values = {}

local license = "SPDX-License-Identifier: MIT-0"

local function literals(real)
  local function n(q) return number.text(R.lift(q), real) end
  local bits = real == "float" and 24 or 53
  return { zero = n(0), one = n(1), two = n(2), three = n(3), four = n(4), half = n "1/2",
    quarter = n "1/4", eighth = n "1/8", threehalves = n "3/2", twelve = n(12), sixteen = n(16),
    epsilon = n(R.new(2) ^ (1 - bits)), negligible = n(R.new(2) ^ (2 - 2 * bits)), sign_margin = n "15/16",
    split = n(R.new(2) ^ ((bits + 1) // 2) + R.one), eight = n(8),
    least = n(R.new(2) ^ (bits == 24 and -126 or -1022)), round_off = n(R.new(3) * R.new(2) ^ (bits - 2)),
    two64 = n(R.new(2) ^ -64), two32 = n(R.new(2) ^ -32),
    two32_up = n(R.new(2) ^ 32),
    last_turn = n(R.new(2) ^ (bits == 24 and 46 or 50)), last_time = n(R.new(2) ^ (bits == 24 and 97 or 990)),
    rate_spare = bits == 24 and "12" or "26",
    bits_type = bits == 24 and "uint32_t" or "uint64_t", binary_shift = bits == 24 and "23" or "52",
    binary_one = n(R.new(3) * R.new(2) ^ (bits - 2) + R.new(bits == 24 and 127 or 1023)),
    block = bits == 24 and "16" or "8", no_period = n(R.new(2) ^ (bits == 24 and 40 or 100)),
    binary_limit = n(bits == 24 and 60 or 500),
    -- exponents (templates/numeric/wide.c): below all others, that of 0; below all that matter.  In float an int has
    -- 16 bits on some processors, and three times an exponent must fit
    no_exponent = bits == 24 and "-6000" or "-1000000", least_exponent = bits == 24 and "-3000" or "-100000",
    carlson_close = n(R.new(2) ^ -(bits // 4 - (bits == 24 and 0 or 1))) }
end

-- Constants as pairs high + low: pi, 1/pi, log 2, and the tables of templates/numeric/double.c.
local function constants(real, v)
  local function pair(x)
    local high = R.fromdouble(real == "float" and R.tofloat(x) or R.todouble(x))
    return { high = number.text(high, real), low = number.text(x - high, real) }
  end
  local function named(name, x)
    local p = pair(x)
    v[name .. "_high"], v[name .. "_low"] = p.high, p.low
  end
  local function table_of(n, f)
    local list = {}
    for j = 0, n do list[j + 1] = pair(f(R.lift(j))) end
    return list
  end
  local pi = R.apply("pi", 200)
  named("pi", pi)
  named("inverse_pi", R.one / pi)
  named("log2", R.apply("log", 200, R.lift(2)))
  v.odd_reciprocals = table_of(5, function(j) return R.one / (R.lift(2) * j + R.one) end)
  v.arctan_eighths = table_of(8, function(j) return R.apply("atan", 200, j / R.lift(8)) end)
  v.log_eighths = table_of(8, function(j) return R.apply("log", 200, R.one + j / R.lift(8)) end)
end

-- What NAME_principal_of promises (templates/analysis/principal.c).  pair_top: entries below 2^pair_top may grow by
-- 2^3 and be split (2^28, 2^13) below the largest number.  A rounding of 2^-104 (2^-46), magnified by the condition,
-- stays below half an ulp of a moment up to `digits`; the smallest number is 2^-1074 (2^-149), so that a moment
-- 10^-decades of the largest still has all its own.
local function promises(real)
  if real == "float" then return { pair_top = "110", pair_digits = "5", pair_decades = "65" } end
  return { pair_top = "990", pair_digits = "12", pair_decades = "600" }
end

-- The real members of the model, elements of arrays each by itself.
local function real_members(m, v)
  local names = {}
  for i, member in ipairs(m.members) do names[i] = member.name end
  for _, name in ipairs(v.split_setup and { "split_b", "split_c", "split_u", "split_d" } or {}) do
    for k = 0, 2 do names[#names + 1] = string.format("%s[%d]", name, k) end
  end
  if v.split_setup then names[#names + 1], names[#names + 2] = "split_fb", "split_fc" end
  return names
end

-- Statements *m = k, member by member: of the whole some compilers make a call of memcpy.
local function copies(v)
  local names, lines = table.move(v.real_members, 1, #v.real_members, 1, {}), { "" }
  for k = 0, v.has_order and 2 or -1 do names[#names + 1] = string.format("order[%d]", k) end
  for _, name in ipairs(names) do
    local s = "m->" .. name .. " = k." .. name .. ";"
    local last = lines[#lines]
    if last == "" then lines[1] = s
    elseif #last + #s < 96 then lines[#lines] = last .. " " .. s
    else lines[#lines + 1] = s end
  end
  return lines
end

local function function_values(list)
  local out = {}
  for i, f in ipairs(list) do
    local comment = {}
    for k, line in ipairs(f.doc) do
      comment[k] = (k == 1 and "/* " or " * ") .. line .. (k == #f.doc and " */" or "")
    end
    out[i] = { comment = comment, declaration = f.declaration, head = f.head, lines = f.lines }
  end
  return out
end

function values.cost_row(name, c)
  local row = { name = name }
  for _, k in ipairs { "add", "mul", "div", "sqrt", "call" } do row[k] = string.format("%d", c[k] or 0) end
  return row
end

local function costs(list)
  local out = {}
  for i, f in ipairs(list) do out[i] = values.cost_row(f.name, f.cost) end
  return out
end

-- "rhs: 12 additions, 24 multiplications": what one call costs, for the banner.
local function cost_line(f)
  local parts, c = {}, f.cost
  for _, k in ipairs { { "add", "addition" }, { "mul", "multiplication" }, { "div", "division" }, { "sqrt", "root" },
    { "call", "function call" } } do
    local n = c[k[1]] or 0
    if n > 0 then parts[#parts + 1] = string.format("%d %s%s", n, k[2], n == 1 and "" or "s") end
  end
  return f.name .. ": " .. table.concat(parts, ", ")
end

-- The files that the scene came from with their hashes; a name must neither end nor begin a comment.
local function sources(job)
  local list = {}
  for i, f in ipairs(job.hashes or {}) do
    list[i] = { name = string.gsub(string.gsub(f.name, "%*/", "_/"), "/%*", "/_"), hash = f.hash }
  end
  return list
end

-- Values shared by all templates of the scene.  job: {model, equations, closed, functions (descriptions), real,
-- command, version, title, banner, derivation}
function values.common(job)
  local m, eq, real = job.model, job.equations, job.real
  local ctx = { name = m.name, upper = string.upper(m.name), real = real, type = source.type(m), members = m.members,
    states = job.states,
    inputs = job.model.inputs, helpers = {}, own = job.libm == "own" }
  local made = {}
  for i, f in ipairs(job.functions) do made[i] = source.make(ctx, f) end
  local v = { name = m.name, upper = ctx.upper, real = real, version = job.version, build = job.build,
    source = job.source,
    hashes = sources(job), hash = job.hash or "", has_hash = job.hash ~= nil,
    command = job.command, title = job.title, license = license, banner = { table.unpack(job.banner) },
    derivation = job.derivation,
    state_enum = listing.enumeration(ctx.upper, listing.told_apart(m, job.states), "NX"), has_inputs = eq.inputs,
      has_params = #m.params > 0,
    input_enum = eq.inputs and listing.enumeration(ctx.upper, listing.described(m), "NU") or {},
    members = listing.members(m, m.name .. "_real"), functions = function_values(made),
    costs = costs(made), has_closed = job.closed.kind ~= nil,
    has_full = job.closed.full or false, free = eq.free and m.has.attitude,
    bits = string.format("%d", selftest.bits), has_q31 = job.q31 ~= nil }
  for _, f in ipairs(made) do
    if f.name == "rhs" or f.name == "step" then v.banner[#v.banner + 1] = "Operations of " .. cost_line(f) .. "." end
  end
  local list, params = {}, {}
  for i, p in ipairs(m.params) do
    local tail = " " .. p.unit -- said once if the default is given in the unit that p[] has
    local given = string.sub(p.given, -#tail) == tail and string.sub(p.given, 1, -#tail - 1) or p.given
    list[i] = { name = p.name, about = "default " .. given, unit = p.unit }
    params[i] = { upper = string.upper(p.name), value = number.text(p.default, real) }
  end
  v.param_enum, v.params = listing.enumeration(ctx.upper, list, "NP"), params
  for _, t in ipairs { libm.names(ctx, ctx.own), literals(real), promises(real) } do
    for k, x in pairs(t) do v[k] = x end -- into a table: order is lost anyway
  end
  v.step_literal, v.horizon_literal = number.text(m:number(m.step), real), number.text(m:number(m.horizon), real)
  v.step_text, v.horizon_text = number.text(m:number(m.step), "double"), number.text(m:number(m.horizon), "double")
  constants(real, v)
  init.fill(ctx, m, v, job.selection.asked "step")
  special.fill(v, ctx)
  v.has_rates, v.has_attitude = m.has.rates, m.has.attitude
  v.has_integral = job.conserved.rate ~= nil
  v.conservative = (v.has_integral or job.conserved.is["T+V"]) and not (eq.free and m.has.attitude)
  v.conserved_name = v.has_integral and "jacobi_integral" or "energy"
  v.has_ticks, v.has_compensated = job.closed.ticks or false, job.compensated or false
  v.uses_index = v.has_attitude or v.has_full
  v.stability_numeric, v.has_order = false, false
  v.has_stability = job.stability ~= nil
  if v.has_stability then stability.fill(ctx, job.stability, v) end
  split.setup(job, v)
  v.has_first_step = false
  if job.selection.asked "step" then init.first_step(m, v) end
  v.real_members = real_members(m, v)
  v.init_copies = copies(v)
  v.no_members = #m.members == 0 and not v.has_order and not v.split_setup
  return v, ctx
end

-- Named constants as C text into the values; do any stand in the model?
local function put_constants(list, v, real)
  local uses = false
  for name, e in pairs(list) do -- into a table: order is lost anyway
    if e.kind == "num" then
      v[name] = number.text(e.value, real)
    else
      v[name], uses = "m->" .. e.name, true
    end
  end
  return uses
end

-- The closed form's part of header and source.
function values.closed(job, v, ctx)
  v.closed_header, v.closed_source, v.pairs_add, v.pairs_multiply = "", "", true, true
  v.oblique, v.has_own = job.oblique ~= nil, false
  put_constants(job.oblique or {}, v, ctx.real)
  if not v.has_closed then return end
  local form = job.closed
  v.theorem, v.closed_text, v.single = form.theorem, form.text, ctx.real == "float"
  v.uses_model = put_constants(job.closed_constants, v, ctx.real)
  v.symmetric, v.rod, v.rotor, v.damped, v.axial, v.lagrange = false, false, false, false, false, false
  v.pairs_add, v.pairs_multiply = form.pairs ~= "few" or v.has_special, form.pairs == nil or v.has_special
  economy.fill(v, ctx.real)
  for name, flag in pairs(form.flags or {}) do v[name] = flag end -- into a table: order is lost anyway
  local function render(name) return template.render(name, job.templates[name], v) end
  orbit.fill(job, v)
  local contracts, texts = closed.texts(form)
  local headers, parts = {}, {}
  for i, name in ipairs(contracts) do headers[i] = render(name) end
  v.closed_header = table.concat(headers, "\n")
  for i, name in ipairs(texts) do parts[i] = render(name) end
  if v.has_own then parts[#parts + 1] = render "templates/orbit/own.c" end
  v.closed_source = table.concat(parts, "\n")
  v.clears = string.find(v.closed_source, v.name .. "_zero(", 1, true) ~= nil
  v.closed_source = render "templates/core/copy.c" .. "\n" .. v.closed_source
end

return values
