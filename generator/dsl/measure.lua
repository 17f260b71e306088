-- measure.lua -- the key `measure` of a scene: what sensors say of the motion, for `polhode fit`.
--
--     measure = { gyro = {wx + bias, wy, wz}, angle = theta, attitude = "q",
--                 columns = { gyro = {"gx", "gy", "gz"} }, sigma = { gyro = 0.004, angle = {0.01} } }
-- An output is an expression of t, states and parameters, or a list of them; a string is the name of a state, also of
-- one that an effect brings along (commands/fit/observed.lua looks it up).  Its columns in a log: NAME; of a list of
-- three NAME_x, NAME_y, NAME_z, of another length NAME_1, NAME_2 ..; or those of `columns`.  "q" is the attitude, in
-- the columns qw, qx, qy, qz.  sigma: the standard deviation of the noise, one number or a list as long as the
-- output's; a plain number is in SI units.  Of an attitude it is that of a small turn, in rad.
-- The record gets a list of outputs {name, columns = list, e = list of expressions (nil: attitude), dims, sigma = list
-- of expressions or nil, line}.
-- SPDX-License-Identifier: GPL-3.0-or-later

local motion = require "generator.algebra.motion"
local expr = require "generator.algebra.expr"
local args = require "generator.dsl.args"
local names = require "generator.dsl.names"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"
local diag = require "generator.diag"

local measure = {}

local most = 64 -- columns of all outputs

local function default_columns(name, n)
  if n == 1 then return { name } end
  local list = {}
  for i = 1, n do list[i] = name .. "_" .. (n == 3 and string.sub("xyz", i, i) or string.format("%d", i)) end
  return list
end

-- One expression of an output: expression and dimension (false: of a state that is looked up), or nil after an error.
local function expression(ctx, at, what, given)
  if type(given) == "string" and not names.identifier(given) then return motion.sym(given), false end
  local r, why = value.of(given)
  if not r then
    ctx.diag:error(at, "measure", what .. " " .. why, diag.show(given))
    return nil
  end
  for _, s in ipairs(expr.symbols(r.e)) do
    if string.find(s.name, "^u_") and s.rank == motion.rank then
      ctx.diag:error(at, "measure", what .. " must not depend on an input", value.show(given))
      return nil
    end
  end
  if args.watched(r.e) then return nil end
  if motion.free(r.e) then
    ctx.diag:error(at, "measure", what .. " must depend on t or on states", value.show(given))
    return nil
  end
  return r.e, r.dim or units.none
end

-- One output; nil after an error.
local function output(ctx, at, name, given)
  local out = { name = name, line = at, dims = {} }
  if given == "q" then
    out.columns = { "qw", "qx", "qy", "qz" }
    for i = 1, 4 do out.dims[i] = units.none end
    return out
  end
  local list = args.plain(given) and given or { given }
  if #list == 0 or not args.list(list, #list) then
    ctx.diag:error(at, "measure", name .. " must be an expression or a list of them", diag.show(given))
    return nil
  end
  out.columns, out.e = default_columns(name, #list), {}
  for i = 1, #list do
    local e, dim = expression(ctx, at, args.plain(given) and name .. "[" .. i .. "]" or name, list[i])
    if not e then return nil end
    out.e[i], out.dims[i] = e, dim
  end
  return out
end

-- What `columns` or `sigma` says of each output, as given[name]; unknown names are reported.
local function by_output(ctx, at, key, given, list)
  if not args.plain(given) then
    ctx.diag:error(at, "measure", key .. " must be a table by the outputs' names", diag.show(given))
    return {}
  end
  args.unknown(ctx, at, "measure, " .. key, list, given)
  return given
end

-- A column belongs to one output, and t to none.
local function columns(ctx, line, list, given)
  local at, taken = ctx.diag:locate(line, "columns"), {}
  local own = given == nil and {} or by_output(ctx, at, "columns", given, list)
  for _, o in ipairs(list) do
    local words = own[o.name]
    if type(words) == "string" then words = { words } end
    if words ~= nil then
      local ok = args.list(words, #o.columns)
      for i = 1, ok and #o.columns or 0 do ok = ok and type(words[i]) == "string" and words[i] ~= "" end
      if ok then
        o.columns = table.move(words, 1, #words, 1, {})
      else
        ctx.diag:error(at, "measure", "columns of " .. o.name .. " must be " .. #o.columns .. " names",
          diag.show(words))
      end
    end
    for _, name in ipairs(o.columns) do
      if taken[name] or name == "t" then
        ctx.diag:error(at, "measure", name == "t" and "the column t is the time" or
          "two outputs have the column " .. name)
      end
      taken[name] = true
    end
  end
end

-- One number may stand for all outputs, whatever their units: it is then the same number of each.
local function sigmas(ctx, line, list, given)
  if given == nil then return end
  local at, all = ctx.diag:locate(line, "sigma"), not args.plain(given)
  local own = all and {} or by_output(ctx, at, "sigma", given, list)
  for _, o in ipairs(list) do
    local s, n = all and given or own[o.name], o.e and #o.e or 3
    if not all and s == nil then
      ctx.diag:error(at, "measure", "sigma must be given for all outputs or for none, got none for " .. o.name)
      return
    end
    local words = args.plain(s) and s or nil
    if words and not args.list(words, n) then
      ctx.diag:error(at, "measure", "sigma of " .. o.name .. " must be a number or a list of " .. n, diag.show(s))
      return
    end
    o.sigma = {}
    for i = 1, n do
      local what = "sigma of " .. o.name .. (words and "[" .. i .. "]" or "")
      local given_one = words and words[i] or s
      local e = args.scalar(ctx, at, "measure", what, { dim = o.e and o.dims[i] or units.none }, given_one)
      if not e then return end
      args.condition(ctx, at, "measure", what .. " must be positive", e, value.show(given_one))
      o.sigma[i] = e
    end
  end
end

function measure.read(ctx, line, given)
  if given == nil then return nil end
  local at, list, count = ctx.diag:locate(line, "measure"), {}, 0
  if not args.plain(given) then
    ctx.diag:error(at, "measure", "must be a table of outputs, with sigma = and columns =", diag.show(given))
    return nil
  end
  for _, name in ipairs(args.keys(given)) do
    if name ~= "sigma" and name ~= "columns" then
      local rule = names.identifier(name)
      local here = ctx.diag:locate(at, type(name) == "string" and name or "measure")
      if rule then ctx.diag:error(here, "measure", "an output's name " .. rule, diag.show(name)) end
      local o = not rule and output(ctx, here, name, given[name])
      if o then
        list[#list + 1] = o
        count = count + #o.columns
      end
    end
  end
  if ctx.diag:failed() then return nil end
  if #list == 0 or count > most then
    ctx.diag:error(at, "measure", "must have one output or more, of at most " .. most .. " columns", diag.show(count))
    return nil
  end
  columns(ctx, at, list, given.columns)
  sigmas(ctx, at, list, given.sigma)
  return list
end

return measure
