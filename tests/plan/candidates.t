#!/usr/bin/env lua5.4
-- candidates.t - which methods a scene admits, and which it is told why not.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- What must be refused is known from docs/methods.md and docs/effects.md, which say so of each method.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local candidates = require "generator.plan.candidates"

local function named(list, real)
  local out = {}
  for _, c in ipairs(list) do
    if not real or c.real == real then out[c.name] = c end
  end
  return out
end

local function refused(path, options)
  local seen, names = {}, {}
  for _, c in ipairs(candidates.of(scene.file(path), options)) do
    if c.refused and not seen[c.method] then
      seen[c.method] = true
      names[#names + 1] = c.method
    end
  end
  return table.concat(names, " ")
end

tap.is(refused "bodies/tumbling_box.lua", "", "a free diagonal body: everything")
tap.is(refused "bodies/brick.lua", "", "a free body of a full tensor: everything")
tap.is(refused "bodies/damped_brick.lua", "split4 split6", "damping: no kicks back in time")
tap.is(refused "bodies/thruster.lua", "exact", "corners at known times, over which every stepper has a way")
tap.is(refused "bodies/foucault.lua", "midpoint split2 split4 split6", "a turning base")

local list = candidates.of(scene.file "bodies/gravity_gradient.lua")
tap.like(named(list).exact.refused, "no closed form: ", "the closed form's refusal says why")
local reals = { double = 0, float = 0 }
for _, c in ipairs(list) do reals[c.real] = reals[c.real] + 1 end
tap.is(reals.double > 20 and reals.double == reals.float, true, "as many of double as of float")

list = candidates.of(scene.file "bodies/nodding_top.lua", { real = "double" })
local c = named(list)
tap.is(c.exact.setting, "none", "the closed form has no setting")
tap.is(c.rk4.setting, "step", "rk4 has a step")
tap.is(c["rk4 tol"], nil, "and no tolerance")
tap.is(c.adaptive.setting .. " " .. c["adaptive tol"].setting, "step tolerance", "the pair has both")
tap.is(c["taylor 16"].setting .. " " .. c["taylor 16 tol"].setting, "step tolerance", "and so has the series")
tap.is(c["taylor 16"].method .. c["taylor 16"].order, "taylor16", "method and order")
tap.is(named(list, "float").rk4, nil, "only the real type that was asked for")
local n = 0
for _, x in ipairs(list) do
  n = n + 1
  for _, y in ipairs(list) do
    if x ~= y and x.name == y.name then n = -1000 end
  end
end
tap.is(n == #list, true, "no name stands twice")

list = candidates.of(scene.file "bodies/nodding_top.lua", { real = "float", methods = { "rk4", "taylor" },
  orders = { 9 } })
local names = {}
for i, x in ipairs(list) do names[i] = x.name end
tap.is(table.concat(names, ", "), "rk4, taylor 9, taylor 9 tol", "methods and orders as given")

list = candidates.of(scene.file "bodies/nodding_top.lua", { real = "double", methods = { "taylor" }, orders = { 9 },
  vector = true })
names = {}
for i, x in ipairs(list) do names[i] = x.name .. (x.vector and "!" or "") end
tap.is(table.concat(names, ", "), "taylor 9, taylor 9 tol, taylor 9 vector!, taylor 9 vector tol!",
  "the host's variants are marked")

tap.done()
