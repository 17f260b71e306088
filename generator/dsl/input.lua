-- input.lua -- input(name, unit, {min =, max =}): what is decided while the body moves, by a controller or a pilot.
--
--     local u = input("motor", "N m", { min = -0.1, max = 0.1 })
-- The value is a symbol of the motion, so it may stand wherever an expression of time and states may; it has its unit's
-- dimension.  With limits it means the limited number: clamp(u, min, max), by comparing.  Plain limits are in the
-- input's own unit; the emitted u[] is in SI units, as p[] is.  Both limits or none: one alone would leave it open
-- whether the other is its negative, zero or nothing.
-- The record of the scene gets {name (the scene's), symbol, e, unit, dim, low, high (expressions or nil), line}.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local args = require "generator.dsl.args"
local names = require "generator.dsl.names"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"
local diag = require "generator.diag"

local input = {}

local most = 32 -- and three of effect.control: the program's own bound is 64

-- The SI unit of u[], as a controller's author would write it.
local function si(dim)
  if units.equal(dim, units.torque) then return "N m" end
  return units.equal(dim, units.force) and "N" or units.si(dim)
end

-- A limit as an expression in SI units; nil after an error.
local function limit(ctx, at, key, given, factor, dim)
  local r = value.of(given)
  if r and not r.dim and motion.free(r.e) and value.number(r.e) then return r.e * factor end
  return args.scalar(ctx, at, "input", key, { dim = dim }, given)
end

-- ctx.named: parameters and inputs by name in capitals, {name, kind}; unit(given): factor and dimension.
function input.constructor(ctx, list, unit)
  return function(name, u, limits)
    local line, failed = ctx.diag:here(), #ctx.diag.errors
    local rule = names.parameter(name)
    local other = not rule and ctx.named[string.upper(name)]
    if other then
      rule = other[1] == name and "is already " .. other[2] or "differs only in capitals from " .. other[1]
    end
    if rule then
      ctx.diag:error(line, "input", "name " .. rule, diag.show(name))
      return value.new(expr.one, nil)
    end
    if #list == most then
      ctx.diag:error(line, "input", "a scene must have at most " .. most .. " inputs", diag.show(name))
      return value.new(expr.one, nil)
    end
    ctx.named[string.upper(name)] = { name, "an input" }
    local factor, dim = unit(u)
    local s = { name = name, symbol = motion.sym("u_" .. name), dim = dim, line = line }
    s.e, s.unit = s.symbol, dim and factor == expr.one and u or si(dim or units.none)
    s.own, s.factor = dim and factor ~= expr.one and u or nil, factor
    if limits ~= nil and not args.plain(limits) then
      ctx.diag:error(line, "input", "takes name, unit and a table { min =, max = }", diag.show(limits))
      limits = nil
    end
    if limits then
      args.unknown(ctx, line, "input", { { name = "min" }, { name = "max" } }, limits)
      if (limits.min == nil) ~= (limits.max == nil) then
        ctx.diag:error(line, "input", "give both min and max of " .. name .. ", or neither", limits.min == nil and
          "max alone" or "min alone")
      elseif limits.min ~= nil then
        s.low = limit(ctx, ctx.diag:locate(line, "min"), "min", limits.min, factor, dim)
        s.high = limit(ctx, ctx.diag:locate(line, "max"), "max", limits.max, factor, dim)
        if s.low and s.high then
          args.condition(ctx, line, "input", "max of " .. name .. " must be above min", s.high - s.low,
            value.show(limits.min) .. " to " .. value.show(limits.max))
          s.e = expr.call("clamp", s.symbol, s.low, s.high)
        end
      end
    end
    if #ctx.diag.errors == failed then list[#list + 1] = s end
    return value.new(s.e, dim)
  end
end

return input
