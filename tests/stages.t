#!/usr/bin/env lua5.4
-- stages.t - what one stage hands to the next: declared fields, closed when made, and a scene that plans leave alone.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local tier = require "tests.tier"
local driver = require "generator.driver"
local equations = require "generator.dynamics.equations"
local expr = require "generator.algebra.expr"
local stages = require "generator.stages"

local function raises(f, what, name)
  local ok, why = pcall(f)
  tap.ok(not ok and string.find(tostring(why), what, 1, true), name, tostring(why))
end

-- ---- fields ----

do
  local s = stages.open "scene"
  s.text = "t"
  tap.is(s.text, "t", "a declared field holds what was written")
  tap.is(s.file, nil, "one that was not written is nil")
  raises(function() return s.functions end, "scene: has no field functions", "no other is read")
  raises(function() s.functions = {} end, "scene: has no field functions", "and none written")
  local p = stages.open("plan", s)
  tap.is(p.text, "t", "a plan reads its scene")
  s.closed = { kind = "sphere" }
  tap.is(p.closed, nil, "but not in place of a field of its own")
  raises(function() return p.code end, "scene: has no field code", "nor what comes after it")
  stages.close(s)
  raises(function() s.text = "u" end, "scene: is closed, so nobody writes text", "a closed one cannot be changed")
  raises(function() s.ranges = {} end, "scene: is closed, so nobody writes ranges", "nor filled")
  local copy = stages.copy(s)
  copy.text = "v"
  tap.is(s.text .. copy.text, "tv", "a copy is another one")
end

-- ---- a scene and its plans ----

local function all(files)
  local out = {}
  for _, name in ipairs(files) do out[#out + 1] = name .. "\n" .. files[name] end
  return table.concat(out, "\n")
end

-- Everything that grows while it is planned alone, in one scene: constants of derivatives, of a series, of an orbit.
local WAYS = { { methods = { "taylor" }, jacobians = true }, { real = "float" }, {}, { only = { "step" } } }

for _, c in ipairs(tier.every(2, { { "damped_brick", true }, { "heavy_top" }, { "dropped_stone" },
  { "spun_coin" } })) do
  local path, name = "bodies/" .. c[1] .. ".lua", c[1] .. (c[2] and " baked" or "")
  local one = scene.file(path, { bake = c[2] })
  local before = #one.equations.model.members
  local alone, wrong, planned = {}, {}, {}
  for i, way in ipairs(WAYS) do
    local own = scene.plan(scene.file(path, { bake = c[2] }), way)
    alone[i], planned[i] = own and all(scene.files(own)), scene.plan(one, way)
  end
  for i = #WAYS, 0, -1 do -- all plans are made before, and used in another order; one of them twice
    local plan = planned[math.max(i, 1)]
    if (plan and all(scene.files(plan))) ~= alone[math.max(i, 1)] then wrong[#wrong + 1] = i end
  end
  tap.ok(alone[3] and alone[3] ~= alone[2], name .. ": plans differ")
  tap.is(table.concat(wrong, " "), "", name .. ": a scene planned " .. #WAYS .. " times gives what one read anew gives")
  tap.is(#one.equations.model.members, before, name .. ": the constants of plans are not the scene's")
end

do
  local s = scene.file "bodies/heavy_top.lua"
  local e = expr.sqrt(s.model.mass) * s.model.params[1].sym ^ 5
  raises(function() return s.model.constant end, "model: has no field constant", "the model makes no constants")
  raises(function() s.model.mass = expr.one end, "model: is closed", "and cannot be changed")
  raises(function() s.equations.groups = {} end, "equations: is closed", "nor can the equations")
  raises(function() s.equations.model:constant("new", e, "") end, "no constant new is made",
    "the pool of a scene is closed")
  local plan = scene.plan(s)
  raises(function() plan.model:constant("new", e, "") end, "no constant new is made", "that of a plan, too")
  raises(function() plan.real = "float" end, "plan: is closed", "and the plan")
  raises(function() driver.code(plan).code = {} end, "unit: is closed", "and its unit")
  local own = equations.fork(s.equations).model
  tap.is(own:constant("new", e, "").name, "new", "a fork makes constants")
  tap.ok(s.equations.model.by_name.new == nil and own.mass == s.model.mass, "of its own, and reads the same model")
end

-- What one plan refuses, another does not repeat.
do
  local s = assert(scene.read [[return scene { name = "b", body = tensor { mass = 1, xx = 2, yy = 3, zz = 4 },
    effects = { effect.damping { c = 1 } } }]])
  local first, why = scene.plan(s, { methods = { "split4" } })
  local again, same = scene.plan(s, { methods = { "split4" } })
  tap.ok(not first and not again and why:report() == same:report(), "a refusal is the same each time", same:report())
  tap.ok(scene.plan(s, { methods = { "rk4" } }) and not s.diag:failed(), "and another plan is not refused")
end

tap.done()
