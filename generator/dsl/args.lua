-- args.lua -- checks the arguments of a shape or an effect against its declared list.
--
-- One place says "must be": every constructor of the scene language hands its table here.  A condition that
-- depends on parameters is checked twice: now, with their defaults, and (as an entry of `checks`) by the emitted
-- NAME_init for whatever values it is given.  Every problem is reported on the line where the argument is written.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local R = require "generator.algebra.rational"
local coordinate = require "generator.algebra.coordinate"
local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local turns = later "generator.interchange.turns"
local slips = require "generator.dsl.slips"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"
local diag = require "generator.diag"

local args = {}

-- ctx: {diag =, checks = list}.  Condition `e > 0` (or >= 0): reported now if false for the defaults.
-- Returns whether it holds; one that depends on parameters is kept for NAME_init, too.
function args.condition(ctx, line, what, rule, e, given, allow_zero)
  local n = value.number(e)
  if not n then
    ctx.diag:error(line, what, rule, "no number for the default parameters")
    return false
  end
  local s = R.sign(n)
  if s < 0 or s == 0 and not allow_zero then
    ctx.diag:error(line, what, rule, given)
    return false
  end
  if not expr.constant(e) then
    ctx.checks[#ctx.checks + 1] = { e = e, what = what, rule = rule, line = line, allow_zero = allow_zero }
  end
  return true
end

-- A table that the scene wrote: no shape, value or effect, which are objects.
function args.plain(x) return type(x) == "table" and getmetatable(x) == nil end

-- A plain list of exactly n entries and nothing else.
function args.list(x, n)
  if not args.plain(x) or #x ~= n then return false end
  for k in pairs(x) do
    if math.type(k) ~= "integer" or k < 1 or k > n then return false end
  end
  return true
end

-- The arguments that a rule speaks of, as they were given: "r_in 2, r_out 1".
function args.named(specs, rule, given)
  local list = {}
  for _, s in ipairs(specs) do
    if string.find(rule, "%f[%w_]" .. s.name .. "%f[^%w_]") then
      list[#list + 1] = s.name .. " " .. value.show(given[s.name])
    end
  end
  return table.concat(list, ", ")
end

-- Does the expression have a word that only events know?
function args.watched(e)
  for _, s in ipairs(expr.symbols(e)) do
    if string.find(s.name, "^" .. value.watched) then return true end
  end
  return false
end

local words = { positive = "must be positive", nonnegative = "must not be negative" }

local most_rows = 1000 -- of one list: a polygon is checked for crossings pair by pair

-- A list of rows of spec.rows scalars each: spec.count of them, or spec.least and more.
function args.rows(ctx, line, what, name, spec, given)
  local n = spec.count
  local rule = string.format("%s must be a list of %s rows of %d numbers", name, n or spec.least .. " or more",
    spec.rows)
  if not args.plain(given) or (n and #given ~= n) or #given < (spec.least or 1) or #given > most_rows or
    not args.list(given, #given) then
    ctx.diag:error(line, what, #(args.plain(given) and given or {}) > most_rows and
      name .. " must have at most " .. most_rows .. " rows" or rule, diag.show(given))
    return nil
  end
  local out, ok = {}, true
  for i = 1, #given do
    out[i] = args.vector(ctx, line, what, name .. "[" .. i .. "]", { dim = spec.dim, size = spec.rows }, given[i])
    ok = ok and out[i] ~= nil
  end
  return ok and out or nil
end

-- A list of lists of rows; may be empty.
function args.lists(ctx, line, what, name, spec, given)
  if not args.plain(given) or not args.list(given, #given) then
    ctx.diag:error(line, what, name .. " must be a list of lists of rows of " .. spec.rows .. " numbers",
      diag.show(given))
    return nil
  end
  local out, ok = {}, true
  for i = 1, #given do
    out[i] = args.rows(ctx, line, what, name .. "[" .. i .. "]", spec, given[i])
    ok = ok and out[i] ~= nil
  end
  return ok and out or nil
end

function args.flag(ctx, line, what, name, _, given)
  if type(given) == "boolean" then return given end
  ctx.diag:error(line, what, name .. " must be true or false", diag.show(given))
  return nil
end

-- One scalar of dimension `spec.dim` (its name in units, a unit, or itself), as an expression; nil after an error.
-- spec.motion: it may depend on time and states, which, multiplied by plain numbers, take any dimension unless a value
-- that has one is beside them.
function args.scalar(ctx, line, what, name, spec, given)
  local r, why = value.of(given)
  if not r then
    why = why .. slips.number(given, "a number with a unit is quantity(%s, \"%s\")")
    ctx.diag:error(line, what, name .. " " .. why, diag.show(given))
    return nil
  end
  local dim = type(spec.dim) == "table" and spec.dim or units.of(spec.dim or "none")
  local moves = not motion.free(r.e)
  if moves and args.watched(r.e) then return nil end -- it is told where the word stands (dsl/watched.lua)
  if moves and not spec.motion then
    ctx.diag:error(line, what, name .. " must not depend on time, states or inputs", value.show(given))
    return nil
  end
  if r.dim and not units.equal(r.dim, dim) and not (spec.motion and r.plain == true) then
    local pure = units.equal(dim, units.none)
    ctx.diag:error(line, what, name .. (pure and " must be a pure number" or " must be in " .. units.name(dim)),
      value.show(given, true))
    return nil
  end
  if r.cycles and spec.dim == "rate" and not spec.decay then
    ctx.diag:error(line, what, name .. " must be an angular rate: a cycle is 2 pi rad, so 1 Hz is 2 pi rad/s or " ..
      "60 rpm (write 2*pi*.., or the unit rad/s, rev/s or rpm)", value.show(given) .. " Hz")
    return nil
  end
  if moves then return r.e end
  local number = value.number(r.e)
  if not number then
    ctx.diag:error(line, what, name .. (coordinate.inside(r.e) and
      " must not depend on x, y, z, which are the coordinates of a region" or
      " must be a real number for the default parameters"), value.show(given))
    return nil
  end
  if spec.sign and not spec.elsewhere and not args.condition(ctx, line, what, name .. " " .. words[spec.sign], r.e,
    value.show(given), spec.sign == "nonnegative") then
    return nil
  end
  local x = name == "angle" and r.e.kind == "num" and not r.dim and value.show(given) -- a plain number, without pi
  local other = x and turns.suspect(number, false, x)
  if other then
    ctx.diag:warn(line, what, string.format("angle %s: write quantity(%s, \"deg\") or quantity(%s, \"rad\")", other, x,
      x))
  end
  return r.e
end

-- A list of spec.size scalars; each entry is checked.
function args.vector(ctx, line, what, name, spec, given)
  if not args.list(given, spec.size) then
    local rule = name .. " must be a list of " .. spec.size .. " numbers"
    ctx.diag:error(line, what, rule .. slips.comma(ctx.diag, line), diag.show(given))
    return nil
  end
  local v, ok = {}, true
  for i = 1, spec.size do
    v[i] = args.scalar(ctx, line, what, name .. "[" .. i .. "]", spec, given[i])
    ok = ok and v[i] ~= nil
  end
  return ok and v or nil
end

function args.choice(ctx, line, what, name, spec, given)
  for _, c in ipairs(spec.choice) do
    if c == given then return c end
  end
  local list = {}
  for i, c in ipairs(spec.choice) do list[i] = diag.show(c) end
  ctx.diag:error(line, what, name .. " must be " .. table.concat(list, ", "), diag.show(given))
  return nil
end

-- Is x made of plain numbers only, so that its unit is nowhere written?  Lists of rows of points are the deepest.
function args.bare(x, depth)
  local r = value.of(x)
  depth = depth or 0
  if r then return not r.dim and expr.constant(r.e) end
  if not args.plain(x) or depth > 3 then return false end
  for _, y in pairs(x) do -- all of them or not: the order does not matter
    if not args.bare(y, depth + 1) then return false end
  end
  return true
end

-- All names that are allowed, for a message.
local function names(specs, extra)
  local list = {}
  for _, s in ipairs(specs) do list[#list + 1] = s.name end
  for _, s in ipairs(extra or {}) do list[#list + 1] = s end
  return table.concat(list, ", ")
end

local key_rank = { number = 1, string = 2 }

-- Keys of a user's table in a fixed order (hash order would change the order of messages): numbers, strings, others.
function args.keys(t)
  local list = {}
  for k in pairs(t) do list[#list + 1] = k end
  table.sort(list, function(a, b)
    local x, y = key_rank[type(a)] or 3, key_rank[type(b)] or 3
    if x ~= y then return x < y end
    if x == 3 then return diag.show(a) < diag.show(b) end
    return a < b
  end)
  return list
end

-- The keys of a user's table as a list of specs.
function args.specs(given)
  local list = {}
  for i, k in ipairs(args.keys(given or {})) do list[i] = { name = tostring(k) } end
  return list
end

-- Reports keys that nothing will read.  specs: list with .name; specs.elsewhere: {key = the option of the command line
-- that says this}; extra: further allowed names.  Returns true where `x = 0,5` made the second half an entry of
-- its own: that is all that is said.
function args.unknown(ctx, line, what, specs, given, extra)
  local known = {}
  local torn, comma = nil, nil
  if given[1] ~= nil then torn, comma = slips.entry(ctx.diag, line) end
  if torn then
    ctx.diag:error(torn, what, comma)
    return true
  end
  for _, s in ipairs(specs) do known[s.name] = true end
  for _, s in ipairs(extra or {}) do known[s] = true end
  for _, k in ipairs(args.keys(given)) do
    if not known[k] then
      local at = type(k) == "string" and ctx.diag:locate(line, k) or line
      local option = specs.elsewhere and specs.elsewhere[k]
      ctx.diag:error(at, what, "unknown argument " .. diag.show(k) .. " (it has " .. names(specs, extra) ..
        (option and "; this is an option of the command line: " .. option or "") .. ")")
    end
  end
end

-- The checked arguments of a table, by name, as expressions.  Second result: true when all are good.
function args.read(ctx, line, what, specs, given, extra)
  if not args.plain(given) then
    ctx.diag:error(line, what, "takes a table of named arguments (" .. names(specs, extra) .. ")", diag.show(given))
    return {}, false
  end
  if args.unknown(ctx, line, what, specs, given, extra) then return {}, false end
  local out, ok = {}, true
  for _, spec in ipairs(specs) do
    local x = given[spec.name]
    local at = ctx.diag:locate(line, spec.name)
    if x == nil then x = spec.default end
    if x == nil then
      if not spec.optional then
        ctx.diag:error(line, what, spec.name .. " is missing")
        ok = false
      end
    else
      local read = spec.choice and args.choice or spec.flag and args.flag or spec.lists and args.lists or
        spec.rows and args.rows or spec.size and args.vector or args.scalar
      out[spec.name] = read(ctx, at, what, spec.name, spec, x)
      ok = ok and out[spec.name] ~= nil
    end
  end
  return out, ok
end

return args
