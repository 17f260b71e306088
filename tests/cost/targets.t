#!/usr/bin/env lua5.4
-- targets.t - the tables of costs: complete, positive, and ordered as processors are.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The numbers themselves are counted by `make target-costs`; here is what must hold of any such numbers.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local driver = require "generator.driver"
local ops = require "generator.cost.ops"
local targets = require "generator.cost.targets"

local REALS = { "float", "double" }
local PLAIN = { "add", "mul", "div", "sqrt", "fma", "cmp", "conv", "conv64", "long" }

local function one(name)
  local c = { call = 0, calls = {}, mem = 0 }
  for _, k in ipairs(PLAIN) do c[k] = 0 end
  if c[name] then
    c[name] = 1
  else
    c.call, c.calls[name] = 1, 1
  end
  return c
end

-- ---- complete ----

tap.is(table.concat(targets.list, " "), "x86-64 cortex-m0 cortex-m3 cortex-m4f cortex-m7 rv32imac rv32imafc avr",
  "the targets of the scene language")
tap.ok(table.concat(targets.list, " "):find(targets.default, 1, true) ~= nil, "the default is one of them")
for _, target in ipairs(targets.list) do
  for _, real in ipairs(REALS) do
    local bad = {}
    local function check(name)
      local x = targets.cost(target, real, one(name))
      if not (x > 0 and x < 1e5) then bad[#bad + 1] = name .. " " .. tostring(x) end
    end
    for _, name in ipairs(PLAIN) do check(name) end
    for _, name in ipairs(ops.functions) do check(name) end
    tap.is(table.concat(bad, ", "), "", target .. ", " .. real .. ": every operation and function has a cost")
    local c = one "add"
    c.call = 1 -- a function that nobody named
    tap.ok(targets.cost(target, real, c) > targets.cost(target, real, one "add"), target .. ", " .. real ..
      ": a function without a name costs, too")
  end
end

-- ---- ordered ----

local function cost(target, real, name) return targets.cost(target, real, one(name)) end

for _, real in ipairs(REALS) do
  for _, target in ipairs(targets.list) do
    local tag = target .. ", " .. real .. ": "
    tap.ok(cost(target, real, "div") > cost(target, real, "add"), tag .. "a division costs more than an addition")
    tap.ok(cost(target, real, "sin") > cost(target, real, "mul"), tag .. "a sine costs more than a multiplication")
    tap.ok(cost(target, real, "pow") >= cost(target, real, "exp"), tag .. "a power no less than an exponential")
  end
end
local function software_costs_more(soft, soft_real, hard, hard_real)
  for _, name in ipairs { "add", "mul", "div", "sqrt", "sin" } do
    tap.ok(cost(soft, soft_real, name) > 2 * cost(hard, hard_real, name),
      string.format("%s: software (%s, %s) costs more than hardware (%s, %s)", name, soft, soft_real, hard, hard_real))
  end
end
software_costs_more("cortex-m0", "float", "cortex-m4f", "float")
software_costs_more("cortex-m3", "float", "cortex-m4f", "float")
software_costs_more("cortex-m4f", "double", "cortex-m4f", "float")
software_costs_more("cortex-m4f", "double", "cortex-m7", "double")
software_costs_more("rv32imac", "float", "rv32imafc", "float")
software_costs_more("avr", "float", "cortex-m4f", "float")
for _, target in ipairs { "cortex-m0", "cortex-m3", "rv32imac" } do
  for _, name in ipairs { "add", "mul", "div", "sqrt", "sin" } do
    tap.ok(cost(target, "double", name) > cost(target, "float", name), target .. ": " .. name ..
      " in double costs more than in float, both in software")
  end
end
tap.is(targets.fma("cortex-m4f", "float"), true, "the Cortex-M4F fuses in float")
tap.is(targets.fma("cortex-m4f", "double"), false, "and not in double")
tap.is(targets.fma("x86-64", "double"), false, "portable code for x86-64 does not fuse")

-- ---- of emitted code ----

do
  local job = driver.code(scene.plan(scene.file "bodies/brick_centroid.lua", { methods = { "rk4", "taylor", "semi" } }))
  for _, target in ipairs(targets.list) do
    local function of(candidate) return targets.cost(target, "double", ops.of(job, candidate).step) end
    local before = 0
    for order = 4, 30, 2 do
      local now = of { method = "taylor", order = order }
      if not tap.ok(now > before, target .. ": taylor of order " .. order .. " costs more than of a lower one") then
        break
      end
      before = now
    end
    tap.ok(of { method = "taylor", order = 8, setting = "tolerance" } > of { method = "taylor", order = 8 },
      target .. ": a step that chooses its size costs more")
    tap.ok(of { method = "rk4" } < of { method = "taylor", order = 30 }, target .. ": rk4 costs less than 30 orders")
  end
  local none, why = ops.of(job, { method = "split4" })
  tap.ok(none == nil and why:find("split4", 1, true) ~= nil, "a method that was not planned is named")
  local other = driver.code(scene.plan(scene.file "bodies/brick_centroid.lua", { methods = { "rk4" } }))
  none, why = ops.of(other, { method = "exact" })
  tap.ok(none == nil and why:find("closed form", 1, true) ~= nil, "so is a closed form that is not there")
  tap.ok(targets.instructions("x86-64", "double", one "add") == nil, "nobody counted instructions on x86-64")
end

tap.done()
