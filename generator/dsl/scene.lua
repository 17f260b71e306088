-- scene.lua -- the scene{} call: reads and checks the whole description, and only that.
--
-- The result is a plain record (expressions, no numbers yet):
--     {name, line, body = shape tree, origin = {kind, ...}, effects = {...}, omega, attitude, given, outputs, events,
--     measure, timed (is a horizon given?), horizon, step, accuracy, budget, ranges}
-- given tells what `initial` says: {omega = bool, attitude = bool, position = vector or nil, velocity = so, line}.
-- Defaults: origin at the centroid, attitude 1, all else 0, horizon 10 s, step 1 ms.  What the record means is decided
-- in mass/ and dynamics/.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local expr = require "generator.algebra.expr"
local accuracy = require "generator.dsl.accuracy"
local args = require "generator.dsl.args"
local events = later "generator.dsl.events"
local measure = later "generator.dsl.measure"
local names = require "generator.dsl.names"
local ranges = require "generator.dsl.ranges"
local rotation = later "generator.dsl.rotation"
local shapes = require "generator.dsl.shapes"
local diag = require "generator.diag"

local scene = {}

local keys = { "name", "body", "origin", "effects", "initial", "time", "accuracy", "budget", "ranges", "outputs",
  "events", "measure" }

-- What a scene leaves to the command line.
local elsewhere = { method = "--method", integrator = "--method", order = "--order", tolerance = "--tolerance",
  real = "--real", target = "--target" }

local function list(strings)
  local out = {}
  for i, s in ipairs(strings) do out[i] = { name = s } end
  return out
end

local function origin(ctx, line, given)
  if given == nil then return { kind = "named", name = "centroid", line = line } end
  local at = ctx.diag:locate(line, "origin")
  if type(given) == "string" then return { kind = "named", name = given, line = at } end
  local v = args.vector(ctx, at, "origin", "origin", { dim = "length", size = 3 }, given)
  return v and { kind = "point", r = v, line = at }
end

local function initial(ctx, line, given, out)
  out.omega = { expr.zero, expr.zero, expr.zero }
  out.attitude, out.given = { expr.one, expr.zero, expr.zero, expr.zero }, {}
  if given == nil then return end
  local at = ctx.diag:locate(line, "initial")
  if not args.plain(given) then
    ctx.diag:error(at, "initial", "must be a table with omega, attitude, position, velocity", diag.show(given))
    return
  end
  args.unknown(ctx, at, "initial", list { "omega", "attitude", "position", "velocity" }, given)
  local function vector(name, dim)
    if given[name] == nil then return nil end
    return args.vector(ctx, ctx.diag:locate(at, name), "initial", name, { dim = dim, size = 3 }, given[name])
  end
  out.omega = vector("omega", "rate") or out.omega
  out.given = { omega = given.omega ~= nil, attitude = given.attitude ~= nil, position = vector("position", "length"),
    velocity = vector("velocity", "velocity"), line = at }
  local q = given.attitude
  if q == nil then return end
  local where = ctx.diag:locate(at, "attitude")
  if args.plain(q) and #q > 0 then q = { quaternion = q } end
  out.attitude = rotation.read(ctx, where, "attitude", q) or out.attitude
end

local function time(ctx, line, given, out)
  out.timed, out.horizon, out.step = false, expr.lift(10), expr.lift "1/1000"
  if given == nil then return end
  local specs = { { name = "horizon", dim = "time", sign = "positive", default = 10 },
    { name = "step", dim = "time", sign = "positive", default = 0.001 }, elsewhere = elsewhere }
  local t = args.read(ctx, ctx.diag:locate(line, "time"), "time", specs, given)
  out.horizon, out.step = t.horizon or out.horizon, t.step or out.step
  out.timed = args.plain(given) and given.horizon ~= nil -- t has the default
end

-- Their records; a broken one has had its message.
local function effects(ctx, line, given, record_of)
  local out = {}
  if given == nil then return out end
  local at = ctx.diag:locate(line, "effects")
  if not args.plain(given) then
    ctx.diag:error(at, "effects", "must be a list of effects", diag.show(given))
    return out
  end
  for _, k in ipairs(args.keys(given)) do
    local e = record_of(given[k])
    if math.type(k) ~= "integer" or not e then
      ctx.diag:error(at, "effects", "entry " .. diag.show(k) .. " must be an effect such as effect.control{}",
        diag.show(given[k]))
    elseif not e.broken then
      out[#out + 1] = e
    end
  end
  return out
end

-- What is asked for: a list of names, {list =, line =}; which names there are is decided in dynamics/states.lua.
local function outputs(ctx, line, given)
  if given == nil then return nil end
  local at, names_given = ctx.diag:locate(line, "outputs"), {}
  local ok = args.plain(given) and args.list(given, #given)
  for i = 1, ok and #given or 0 do
    ok = ok and type(given[i]) == "string"
    names_given[i] = given[i]
  end
  if ok then return { list = names_given, line = at } end
  ctx.diag:error(at, "outputs", "must be a list of names", diag.show(given))
  return nil
end

-- The function `scene` of the environment; `put` takes the checked record and returns what the script gets.  effect_of:
-- handle -> record.
function scene.constructor(ctx, effect_of, put)
  return function(given)
    local line = ctx.diag:here()
    if not args.plain(given) then
      ctx.diag:error(line, "scene", "takes a table", diag.show(given))
      return nil
    end
    local fields = list(keys)
    fields.elsewhere = elsewhere
    args.unknown(ctx, line, "scene", fields, given)
    local s = { line = line, name = given.name }
    local rule = names.scene(given.name)
    if given.name == nil then
      ctx.diag:error(line, "scene", "name is missing")
    elseif rule then
      ctx.diag:error(ctx.diag:locate(line, "name"), "scene", "name " .. rule, diag.show(given.name))
    end
    s.body = shapes.record(given.body)
    if given.body == nil then
      ctx.diag:error(line, "scene", "body is missing")
    elseif not s.body then
      ctx.diag:error(ctx.diag:locate(line, "body"), "scene", "body must be a shape", diag.show(given.body))
    end
    s.origin = origin(ctx, line, given.origin)
    s.effects = effects(ctx, line, given.effects, effect_of)
    initial(ctx, line, given.initial, s)
    s.outputs = outputs(ctx, line, given.outputs)
    s.events = events.read(ctx, line, given.events)
    s.measure = measure.read(ctx, line, given.measure)
    time(ctx, line, given.time, s)
    s.accuracy = accuracy.read(ctx, line, given.accuracy)
    s.budget = accuracy.budget(ctx, line, given.budget)
    s.ranges = ranges.read(ctx, line, given.ranges)
    return put(s)
  end
end

return scene
