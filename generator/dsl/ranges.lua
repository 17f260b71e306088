-- ranges.lua -- the key `ranges` of a scene: from where its motions start, and for which parameters.
--
--     ranges = { omega = 5, attitude = "any", position = {{-1, 1}, {-1, 1}, {0, 2}}, mass = {1, 2}, speed = {0, 40} }
-- omega, position, velocity: r (each component within -r and r), {lo, hi} or three of these; attitude: "any", or the
-- angle within which it is from the initial one; parameters (plain numbers in their own unit) and further states by
-- their name.  `read` checks what stands there, `resolve` what it means for the states that the scene has.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local motion = require "generator.algebra.motion"
local args = require "generator.dsl.args"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"
local diag = require "generator.diag"

local ranges = {}

local vectors = { omega = "rate", position = "length", velocity = "velocity" }
local kinds = { omega = "rates", position = "position", velocity = "velocity" }

-- A number of the scene as {q = rational, dim = dimension or nil}, or nil after an error.
local function number(ctx, at, name, given)
  local r, why = value.of(given)
  if r and not motion.free(r.e) then r, why = nil, "must not depend on time, states or inputs" end
  local q = r and value.number(r.e)
  if r and not q then why = "must be a real number for the default parameters" end
  if not q then
    ctx.diag:error(at, "ranges", name .. " " .. why, r and value.show(given) or diag.show(given))
    return nil
  end
  return { q = q, dim = r.dim }
end

-- {lo, hi} as two numbers and how they were written.
local function pair(ctx, at, name, given)
  if not args.list(given, 2) then
    ctx.diag:error(at, "ranges", name .. " must be {lowest, highest}", diag.show(given))
    return nil
  end
  local lo, hi = number(ctx, at, name .. "[1]", given[1]), number(ctx, at, name .. "[2]", given[2])
  return lo and hi and { lo, hi, shown = diag.show(given) }
end

local function dimension(d, at, name, given, wanted)
  if not given or units.equal(given, wanted) then return true end
  local pure = units.equal(wanted, units.none)
  d:error(at, "ranges", name .. (pure and " must be a pure number" or " must be in " .. units.name(wanted)),
    units.name(given))
  return false
end

-- The two ends in SI units {lo =, hi =} of a pair, whose plain numbers are in a unit of this size; nil after an error.
local function interval(d, at, name, p, wanted, factor)
  local ends = {}
  for i = 1, 2 do
    if not dimension(d, at, name, p[i].dim, wanted) then return nil end
    ends[i] = p[i].dim and p[i].q or p[i].q * (factor or R.one)
  end
  if ends[2] < ends[1] then
    d:error(at, "ranges", name .. " must have its lowest value first", p.shown)
    return nil
  end
  return { lo = ends[1], hi = ends[2] }
end

-- Three intervals from any of the forms of a vector's range.
local function triple(ctx, at, name, given)
  local out, single = {}, nil
  if args.plain(given) and args.plain(given[1]) then
    if not args.list(given, 3) then
      ctx.diag:error(at, "ranges", name .. " must be three pairs {lowest, highest}", diag.show(given))
      return nil
    end
    for i = 1, 3 do out[i] = pair(ctx, at, name .. "[" .. i .. "]", given[i]) end
  elseif args.plain(given) then
    single = pair(ctx, at, name, given)
  else
    local r = number(ctx, at, name, given)
    if r and R.sign(r.q) < 0 then
      ctx.diag:error(at, "ranges", name .. " must not be negative", value.show(given))
      r = nil
    end
    single = r and { { q = -r.q, dim = r.dim }, { q = r.q, dim = r.dim } }
  end
  local dim = units[vectors[name]]
  for i = 1, 3 do
    local p = single or out[i]
    out[i] = p and interval(ctx.diag, at, single and name or name .. "[" .. i .. "]", p, dim)
    if not out[i] then return nil end
  end
  return out
end

local half_turn = R.parse "3.14159265358979323847" -- a little more than pi

local function attitude(ctx, at, given)
  if given == "any" then return "any" end
  if type(given) == "string" or args.plain(given) then
    ctx.diag:error(at, "ranges", "attitude must be \"any\" or an angle", diag.show(given))
    return nil
  end
  local a = number(ctx, at, "attitude", given)
  if not a or not dimension(ctx.diag, at, "attitude", a.dim, units.none) then return nil end
  if R.sign(a.q) < 0 or a.q > half_turn then
    ctx.diag:error(at, "ranges", "attitude must be an angle from 0 to pi", value.show(given))
    return nil
  end
  return a.q
end

-- {line =, omega = three intervals, ..., attitude = "any" or rational, named = {{name =, line =, ends}}} of what the
-- scene gives, or nil.
function ranges.read(ctx, line, given)
  if given == nil then return nil end
  local out = { line = ctx.diag:locate(line, "ranges"), named = {} }
  if not args.plain(given) then
    ctx.diag:error(out.line, "ranges", "must be a table such as {omega = 5, attitude = \"any\", mass = {1, 2}}",
      diag.show(given))
    return nil
  end
  for _, k in ipairs(args.keys(given)) do
    local at = ctx.diag:locate(out.line, k)
    if type(k) ~= "string" then
      ctx.diag:error(out.line, "ranges", "entry " .. diag.show(k) .. " must have the name of what it is a range of",
        diag.show(given[k]))
    elseif k == "attitude" then
      out.attitude = attitude(ctx, at, given[k])
    elseif vectors[k] then
      out[k] = triple(ctx, at, k, given[k])
    else
      local p = pair(ctx, at, k, given[k])
      if p then
        p.name, p.line = k, at
        out.named[#out.named + 1] = p
      end
    end
  end
  return out
end

-- Warns of the scene's own values that are outside its ranges: of parameters, also by --set, and of the start.
local function warn_outside(d, record, m, out)
  local function warn(line, name, x, range)
    local low, high = R.todouble(range.lo) + 0.0, R.todouble(range.hi) + 0.0
    if x >= low and x <= high then return end
    d:warn(line, "ranges", name .. " of the scene itself, " .. diag.show(x) .. ", is outside " .. diag.show(low) ..
      " to " .. diag.show(high) .. " (SI units)")
  end
  for _, range in ipairs(out.params) do
    for _, p in ipairs(record.params) do
      if p.name == range.name then warn(out.line, p.name, R.todouble(p.default) + 0.0, range) end
    end
  end
  for i, s in ipairs(m.states) do
    if out.states[i] then warn(out.line, s.name, m:double(s.initial) + 0.0, out.states[i]) end
  end
end

-- What the ranges mean for the scene: {states = {[place in x] = {lo =, hi =}}, attitude =, params = {{name =, lo =,
-- hi =}}} in SI units; nil without ranges; false after an error.  m: the model, with its states and parameters.
function ranges.resolve(d, record, m)
  local given = record.ranges
  if not given then return nil end
  local out, fine = { states = {}, params = {}, attitude = given.attitude, line = given.line }, true
  local function fail(line, ...)
    d:error(line, "ranges", ...)
    fine = false
  end
  local place, taken = {}, {}
  for i, s in ipairs(m.states) do place[s.name] = i end
  for _, k in ipairs { "omega", "position", "velocity" } do
    if given[k] and not m.has[kinds[k]] then
      fail(given.line, k .. ": the scene has no such state")
    elseif given[k] then
      for i, s in ipairs(m.states) do
        if s.kind == kinds[k] then
          out.states[i] = given[k][s.place]
          taken[s.name] = k
        end
      end
    end
  end
  if given.attitude and not m.has.attitude then fail(given.line, "attitude: the scene has no such state") end
  for _, e in ipairs(given.named) do
    local param
    for _, p in ipairs(record.params) do param = p.name == e.name and p or param end
    local s = place[e.name] and m.states[place[e.name]]
    if s and s.kind == "attitude" then
      fail(e.line, e.name .. " is a component of the attitude: give attitude = \"any\" or an angle")
    elseif s and taken[e.name] then
      fail(e.line, e.name .. " is a component of " .. taken[e.name] .. ", which is given too")
    elseif s then
      local _, dim = units.parse(s.unit)
      local range = interval(d, e.line, e.name, e, dim)
      out.states[place[e.name]], fine = range, range and fine or false
    elseif param then
      local dim = param.own and select(2, units.parse(param.own)) or units.none
      local range = interval(d, e.line, e.name, e, dim, value.number(param.factor))
      fine = range and fine or false
      if range and #m.params > 0 then -- else they are numbers (--bake)
        range.name = e.name
        out.params[#out.params + 1] = range
      end
    else
      local names = {}
      for _, p in ipairs(record.params) do names[#names + 1] = p.name end
      for _, x in ipairs(m.states) do
        if x.kind ~= "attitude" and not taken[x.name] then names[#names + 1] = x.name end
      end
      fail(e.line, "unknown name " .. diag.show(e.name) .. " (there are omega, attitude, position, velocity" ..
        (#names > 0 and " and " .. table.concat(names, ", ") or "") .. ")")
    end
  end
  if fine then warn_outside(d, record, m, out) end
  return fine and out
end

return ranges
