-- moving.lua -- what a scene may say about the motion: time, states, tables over time, and effects of its own.
--
-- `t` and the states qw .. vz are words of the language; an argument that may depend on them says so.  Every
-- expression's dimension is checked (dsl/value.lua).  A plain number may be meant in any unit, so 0.1*sin(2*t) is a
-- torque, and so is N*sin(rate*t) with N in N m and rate in rad/s, while N*t, wx and wx + qx are refused.  t without a
-- value that has a dimension beside it counts as such a number, that of the seconds.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local args = require "generator.dsl.args"
local contact = require "generator.dsl.contact"
local names = require "generator.dsl.names"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"
local diag = require "generator.diag"

local moving = {}

-- Words and their dimensions; the states as dynamics/state.lua has them.
moving.words = { { "t", "time" }, { "qw", "none" }, { "qx", "none" }, { "qy", "none" }, { "qz", "none" },
  { "wx", "rate" }, { "wy", "rate" }, { "wz", "rate" }, { "rx", "length" }, { "ry", "length" }, { "rz", "length" },
  { "vx", "velocity" }, { "vy", "velocity" }, { "vz", "velocity" } }

function moving.value(word) return value.new(motion.sym(word[1]), units[word[2]], word[1] == "t" or "bare") end

local most_rows = 100 -- of a table: each costs a product and two sums at every evaluation

-- Rows {t, v} as exact expressions, times ascending; nil after errors.
local function rows_of(ctx, line, what, name, spec, given)
  if not args.list(given, #given) or #given < 2 or #given > most_rows then
    ctx.diag:error(line, what, name .. " must be a number, an expression, or a table of 2 to " .. most_rows ..
      " rows {t, value}", diag.show(given))
    return nil
  end
  local rows, ok = {}, true
  for i = 1, #given do
    local what_row, row = name .. "[" .. i .. "]", given[i]
    if args.list(row, 2) then
      local t = args.scalar(ctx, line, what, what_row .. ", its time,", { dim = "time" }, row[1])
      local v = args.scalar(ctx, line, what, what_row .. ", its value,", { dim = spec.dim }, row[2])
      rows[i] = t and v and { t, v }
    else
      ctx.diag:error(line, what, what_row .. " must be a row {t, value}", diag.show(row))
    end
    ok = ok and rows[i]
  end
  for i = 2, ok and #rows or 0 do
    ok = args.condition(ctx, line, what, "times of " .. name .. " must ascend", rows[i][1] - rows[i - 1][1],
      value.show(given[i][1]) .. " after " .. value.show(given[i - 1][1])) and ok
  end
  return ok and rows or nil
end

-- Linear between the rows, constant beyond them: the first value and a rise for each line between two rows,
--     v1 + sum (v_k+1 - v_k) r_k,   r_k = x (1 + s_k)(1 - s_k+1)/4 + (1 + s_k+1)/2,   s_k = side(t - t_k)
-- x = (t - t_k)/(t_k+1 - t_k).  r_k is 0 before the line, 1 behind it, exactly, so that a steep line leaves nothing
-- behind; a sum of ramps k_i |t - t_i|, the shorter way to write it, leaves u |t| times its slope for ever.
local function lines(rows)
  local t, sum, one = motion.sym "t", rows[1][2], expr.one
  local function side(k) return expr.call("side", t - rows[k][1]) end
  for k = 1, #rows - 1 do
    local rise, first, last = rows[k + 1][2] - rows[k][2], side(k), side(k + 1)
    local slope = rise / (rows[k + 1][1] - rows[k][1])
    sum = sum + slope * (t - rows[k][1]) * ((one + first) * (one - last) / 4) + rise * ((one + last) / 2)
  end
  return sum
end

-- A component that may vary: {e =, rows = nil or the table}; nil after an error.
local function varying(ctx, line, what, name, spec, given)
  if args.plain(given) then
    local rows = rows_of(ctx, line, what, name, spec, given)
    return rows and { e = lines(rows), rows = rows }
  end
  local e = args.scalar(ctx, line, what, name, { dim = spec.dim, motion = true }, given)
  return e and { e = e }
end
moving.varying = varying

-- effect.torque: body or inertial, three components.
function moving.torque(ctx, line, what, given)
  args.unknown(ctx, line, what, { { name = "body" }, { name = "inertial" } }, given)
  if (given.body == nil) == (given.inertial == nil) then
    ctx.diag:error(line, what, "give body or inertial, one of them")
    return nil
  end
  local key = given.body ~= nil and "body" or "inertial"
  local at, v = ctx.diag:locate(line, key), given[key]
  if not args.list(v, 3) then
    ctx.diag:error(at, what, key .. " must be a list of 3 numbers, expressions or tables", diag.show(v))
    return nil
  end
  local a, ok = { [key] = {}, rows = {} }, true
  for i = 1, 3 do
    local x = varying(ctx, at, what, key .. "[" .. i .. "]", { dim = "torque" }, v[i])
    ok = ok and x ~= nil
    a[key][i], a.rows[i] = x and x.e, x and x.rows or false
  end
  return ok and a or nil
end

-- effect.wheel: its torque may vary.
function moving.wheel(ctx, line, what, given)
  local specs = { { name = "axis", size = 3 }, { name = "inertia", dim = "inertia", sign = "positive" },
    { name = "speed", dim = "rate", default = 0 }, { name = "torque", dim = "torque", skip = true },
    { name = "included", flag = true } }
  local fixed = {}
  for _, s in ipairs(specs) do
    if not s.skip then fixed[#fixed + 1] = s end
  end
  local a, ok = args.read(ctx, line, what, fixed, given, { "torque" })
  local u = { e = expr.zero }
  if given.torque ~= nil then
    u = varying(ctx, ctx.diag:locate(line, "torque"), what, "torque", { dim = "torque" }, given.torque)
  end
  if not ok or not u then return nil end
  a.torque, a.rows = u.e, u.rows or false
  return a
end

-- effect.spring: a number about an axis from a rest angle, or three stiffnesses (or one) from a rest attitude.
function moving.spring(ctx, line, what, given)
  args.unknown(ctx, line, what, { { name = "stiffness" }, { name = "axis" }, { name = "rest" } }, given)
  local function at(key) return ctx.diag:locate(line, key) end
  local a, spec = {}, { dim = "torque", sign = "nonnegative", size = 3 }
  if given.stiffness == nil then
    ctx.diag:error(line, what, "stiffness is missing")
    return nil
  end
  if given.axis ~= nil then
    a.k = args.scalar(ctx, at "stiffness", what, "stiffness", spec, given.stiffness)
    a.axis = args.vector(ctx, at "axis", what, "axis", { size = 3 }, given.axis)
    a.angle = args.scalar(ctx, at "rest", what, "rest", {}, given.rest == nil and 0 or given.rest)
    return a.k and a.axis and a.angle and a
  end
  if args.plain(given.stiffness) then
    a.k = args.vector(ctx, at "stiffness", what, "stiffness", spec, given.stiffness)
  else
    local k = args.scalar(ctx, at "stiffness", what, "stiffness", spec, given.stiffness)
    a.k = k and { k, k, k }
  end
  local rest = given.rest == nil and { 1, 0, 0, 0 } or given.rest
  a.rest = args.vector(ctx, at "rest", what, "rest", { size = 4 }, rest)
  return a.k and a.rest and a
end

---- effect.custom -------------------------------------------------------------------------------------

local built_in = { w = true, q = true, r = true, v = true, t = true, L = true }

-- What functions of the scene receive: w, q, r, v, L as lists, t, and the effect's own parameters and states by name.
local function received(ctx, what, own)
  local s = { t = moving.value { "t", "time" } }
  local function list(name, components, dim)
    local v = {}
    for i, n in ipairs(components) do v[i] = value.new(motion.sym(n), units[dim], "bare") end
    s[name] = v
  end
  list("w", { "wx", "wy", "wz" }, "rate")
  list("q", { "qw", "qx", "qy", "qz" }, "none")
  list("r", { "rx", "ry", "rz" }, "length")
  list("v", { "vx", "vy", "vz" }, "velocity")
  list("L", { "@Lx", "@Ly", "@Lz" }, "angular_momentum")
  for _, o in ipairs(own) do s[o[1]] = o[2] end
  local all = table.concat(args.keys(s), ", ")
  return setmetatable({}, { __index = function(_, k)
    if s[k] ~= nil then return s[k] end
    ctx.diag:error(ctx.diag:here(), what, "has no " .. diag.show(k) .. " (it has " .. all .. ")")
    return value.new(expr.one, nil)
  end, __newindex = function()
    ctx.diag:error(ctx.diag:here(), what, "what a function receives cannot be changed")
  end })
end

local reserved = {} -- members of the emitted structure and locals, of three letters and more without a digit
for word in string.gmatch([[mass com drag linear decay rest step time inertia out got lane
  real sqrt fabs size_t]], "%S+") do
  reserved[word] = true
end

-- nil if s can name a parameter or state of an effect, else the rule that it breaks.
local function name_rule(s, taken)
  if type(s) ~= "string" or not string.find(s, "^%l[%l_][%l_]+$") then
    return "must be three or more small letters or _"
  elseif names.parameter(s) then
    return names.parameter(s)
  elseif built_in[s] or reserved[s] or taken[s] or string.find(s, "_$") or string.find(s, "__", 1, true) then
    return "is taken by the emitted code or given twice"
  end
  for _, w in ipairs(moving.words) do
    if w[1] == s then return "is the name of a state" end
  end
  return nil
end

-- The function is called once, with symbols: what it returns is the expression.
local function call(ctx, line, what, name, f, s, spec)
  if type(f) ~= "function" then
    ctx.diag:error(line, what, name .. " must be a function of the motion: function(s) return ... end", diag.show(f))
    return nil
  end
  local declared = debug.getinfo(f, "uS")
  if declared.nparams > 1 then
    local own = declared.source == "@" .. ctx.diag.file and declared.linedefined or line
    ctx.diag:error(own, what, name .. " must be a function of one argument, function(s): a name of params or states " ..
      "is read as s.NAME", declared.nparams .. " arguments")
    return nil
  end
  local given = f(s)
  spec.motion = true
  return (spec.size and args.vector or args.scalar)(ctx, line, what, name, spec, given)
end

local keys = { "params", "torque", "force", "potential", "states" }

-- Of a state: SI without a factor, as it is integrated.
local function unit_of(ctx, line, what, given)
  if given == nil then return units.none end
  local factor, dim = nil, "must be a string such as \"rad/s\""
  if type(given) == "string" then factor, dim = units.parse(given) end
  if not factor or factor ~= expr.one then
    ctx.diag:error(line, what, "unit: " .. (factor and "must be an SI unit without a factor" or dim), diag.show(given))
    return units.none
  end
  return dim
end

-- The states {name = {initial =, unit =, rate =}} without their rates.
local function own_states(ctx, line, what, given, taken, checked)
  local list = {}
  if given ~= nil and not args.plain(given) then
    ctx.diag:error(line, what, "states must be a table of states by name", diag.show(given))
    return list
  end
  for _, k in ipairs(args.keys(given or {})) do
    local at, s = type(k) == "string" and ctx.diag:locate(line, k) or line, given[k]
    local rule = name_rule(k, taken)
    if rule or not args.plain(s) then
      ctx.diag:error(at, what, "name of a state " .. (rule or "must have a table {initial =, unit =, rate =}"),
        diag.show(rule and k or s))
    else
      checked(taken, k)
      args.unknown(ctx, at, what .. ", state " .. k, { { name = "initial" }, { name = "unit" }, { name = "rate" } }, s)
      local dim = unit_of(ctx, at, what .. ", state " .. k, s.unit)
      local initial = args.scalar(ctx, at, what .. ", state " .. k, "initial", { dim = dim }, s.initial or 0)
      list[#list + 1] = { name = k, initial = initial or expr.zero, unit = units.si(dim), dim = dim, rate = s.rate,
        at = at }
      ctx.own_states = ctx.own_states or {}
      ctx.own_states[k] = units.si(dim) -- a word of events
    end
  end
  return list
end

function moving.custom(ctx, line, what, given)
  local specs, taken, own = {}, {}, {}
  for i, k in ipairs(keys) do specs[i] = { name = k } end
  args.unknown(ctx, line, what, specs, given)
  local failed = #ctx.diag.errors
  local function put(set, k) set[k] = true end
  local a = { params = {}, states = {} }
  local function at(key) return ctx.diag:locate(line, key) end
  if given.params ~= nil and not args.plain(given.params) then
    ctx.diag:error(at "params", what, "params must be a table of values by name", diag.show(given.params))
  end
  for _, k in ipairs(args.keys(args.plain(given.params) and given.params or {})) do
    local rule = name_rule(k, taken)
    if rule then
      ctx.diag:error(at "params", what, "name of a parameter " .. rule, diag.show(k))
    else
      put(taken, k)
      local r, why = value.of(given.params[k])
      if not r or not motion.free(r.e) or not value.number(r.e) then
        ctx.diag:error(at "params", what, k .. " " .. (why or "must be a real number for the default parameters"),
          value.show(given.params[k]))
        own[#own + 1] = { k, value.new(expr.one, nil) } -- the slip is told
      else
        a.params[#a.params + 1] = { name = k, e = r.e, unit = units.si(r.dim or units.none) }
        own[#own + 1] = { k, value.new(expr.sym("@" .. k, 6), r.dim, r.dim == nil) }
      end
    end
  end
  local list = own_states(ctx, at "states", what, given.states, taken, put)
  for _, s in ipairs(list) do own[#own + 1] = { s.name, value.new(motion.sym("@" .. s.name), s.dim, "bare") } end
  local s = received(ctx, what, own)
  if given.torque ~= nil then
    a.torque = call(ctx, at "torque", what, "torque", given.torque, s, { dim = "torque", size = 3 })
  end
  if given.force ~= nil then
    a.force = call(ctx, at "force", what, "force", given.force, s, { dim = "force", size = 3 })
  end
  if given.potential ~= nil then
    a.potential = call(ctx, at "potential", what, "potential", given.potential, s, { dim = "energy" })
    for _, x in ipairs(a.potential and expr.symbols(a.potential) or {}) do
      local name = string.gsub(x.name, "^@", "")
      if x.rank == motion.rank and not (string.find(x.name, "^[qr][wxyz]$") or taken[name]) then
        ctx.diag:error(at "potential", what, "potential must depend on attitude, position and own states only",
          (string.gsub(name, "^u_", "the input ")))
      end
    end
  end
  for i, x in ipairs(list) do
    a.states[i] = { name = x.name, initial = x.initial, unit = x.unit,
      rate = call(ctx, x.at, what .. ", state " .. x.name, "rate", x.rate, s,
        { dim = units.times(x.dim, units.rate) }) }
  end
  if given.torque == nil and given.force == nil and given.potential == nil and #list == 0 then
    ctx.diag:error(line, what, "must have a torque, a force, a potential or states")
  end
  return #ctx.diag.errors == failed and a or nil
end

moving.plane = contact.plane

return moving
