#!/usr/bin/env lua5.4
-- costs.t - the emitted code computes a tensor in no more operations than the formula factored by hand.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each formula below is written the way one would write it in C by hand, with shared terms named.  It runs twice: over
-- numbers that count their own operations, which is its cost, and over expressions, which must be the model's tensor.
-- A constant factor is one multiplication, a quotient of constants is free, a minus sign is free.  The emitted code's
-- operations are counted on its instructions (ir/core/count.lua), for the entries of the tensor alone.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local driver = require "generator.driver"
local init = require "generator.emit.init"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"

-- ---- numbers that count ----

local count
local number = {}
local function new() return setmetatable({}, number) end
local function counted(kind)
  return function()
    count[kind] = count[kind] + 1
    return new()
  end
end
number.__add, number.__sub, number.__mul, number.__div = counted "add", counted "add", counted "mul", counted "div"

local function c(s) return expr.lift(s) end -- a constant, as an expression; as a number that counts it is just one

-- ---- the formulas ----

local rows = {
  { "box", "solid.box { x = a, y = b, z = c, mass = M }", { "M", "a", "b", "c" }, function(e, q)
    local k, a2, b2, c2 = q "1/12" * e.M, e.a * e.a, e.b * e.b, e.c * e.c
    return { k * (b2 + c2), k * (a2 + c2), k * (a2 + b2) }
  end },
  { "cylinder", "solid.cylinder { r = r, h = h, mass = M }", { "M", "r", "h" }, function(e, q)
    local k, r2 = q "1/12" * e.M, e.r * e.r
    local x = k * (q "3" * r2 + e.h * e.h)
    return { x, x, q "1/2" * e.M * r2 }
  end },
  { "ellipsoid", "solid.ellipsoid { a = a, b = b, c = c, mass = M }", { "M", "a", "b", "c" }, function(e, q)
    local k, a2, b2, c2 = q "1/5" * e.M, e.a * e.a, e.b * e.b, e.c * e.c
    return { k * (b2 + c2), k * (a2 + c2), k * (a2 + b2) }
  end },
  { "cone", "solid.cone { r = r, h = h, mass = M }", { "M", "r", "h" }, function(e, q)
    local k, r2 = q "3/80" * e.M, e.r * e.r
    local x = k * (q "4" * r2 + e.h * e.h)
    return { x, x, q "3/10" * e.M * r2 }
  end },
  { "capsule", "solid.capsule { r = r, h = h, mass = M }", { "M", "r", "h" }, function(e, q)
    local h, r2, u, v = e.h, e.r * e.r, q "4" * e.r, q "3" * e.h
    local g = q "1/20" * e.M / (v + u)
    local x = g * (q "5" * h * (h * (h + u) + q "9" * r2) + q "8" * (u * r2))
    return { x, x, q "2" * (g * r2 * (q "5" * v + q "4" * u)) }
  end },
  { "L-bracket", "solid.box { x = a, y = b, z = c, mass = M1 } + " ..
    "solid.box { x = d, y = f, z = g, mass = M2 }:at{u, v, w}",
    { "M1", "M2", "a", "b", "c", "d", "f", "g", "u", "v", "w = 31" }, function(e, q)
      local k1, k2, mu = q "1/12" * e.M1, q "1/12" * e.M2, e.M1 * e.M2 / (e.M1 + e.M2)
      local a2, b2, c2, d2, f2, g2 = e.a * e.a, e.b * e.b, e.c * e.c, e.d * e.d, e.f * e.f, e.g * e.g
      local ux, uy, uz = mu * e.u, mu * e.v, mu * e.w
      local X, Y, Z = ux * e.u, uy * e.v, uz * e.w
      return { k1 * (b2 + c2) + k2 * (f2 + g2) + Y + Z, k1 * (a2 + c2) + k2 * (d2 + g2) + X + Z,
        k1 * (a2 + b2) + k2 * (d2 + f2) + X + Y, ux * e.v, ux * e.w, uy * e.w }
    end },
}

tap.diag(string.format("%-24s %-22s %s", "body", "emitted", "by hand"))
for _, row in ipairs(rows) do
  local name, shape, params, formula = table.unpack(row)
  local job = assert(scene.body(shape, params))
  job = driver.plan(job, { real = "double", command = "" })
  local m = job.model

  -- the formula is the tensor
  local symbols = {}
  for _, p in ipairs(m.params) do symbols[p.name] = p.sym end
  local wrong = {}
  for n, want in ipairs(formula(symbols, c)) do
    local d = m.inertia[n] - want
    if n > 3 then d = m.inertia[n] + want end
    if not ratio.iszero(d) then wrong[#wrong + 1] = n end
  end
  tap.is(table.concat(wrong, " "), "", name .. ": the formula by hand is the tensor")

  -- its cost
  count = { add = 0, mul = 0, div = 0 }
  local numbers = setmetatable({}, { __index = function(t, k)
    t[k] = new()
    return t[k]
  end })
  formula(numbers, new)
  local hand = count

  local tensor = {}
  for _, member in ipairs(m.members) do
    for _, e in ipairs(m.inertia) do
      if member.e == e and tensor[#tensor] ~= member then tensor[#tensor + 1] = member end
    end
  end
  local ctx = { name = m.name, upper = string.upper(m.name), real = "double", members = m.members, states = job.states,
    inputs = {} }
  local got = init.cost(ctx, m, tensor)
  local function show(x) return string.format("%d *, %d +, %d /", x.mul, x.add, x.div) end
  tap.diag(string.format("%-24s %-22s %s", name, show(got), show(hand)))
  tap.ok(got.mul + got.add <= hand.mul + hand.add and got.mul <= hand.mul and got.div <= hand.div and
    (got.sqrt or 0) == 0 and (got.call or 0) == 0, name .. ": the emitted code costs no more: " .. show(got) ..
    " and by hand " .. show(hand))
end

tap.done()
