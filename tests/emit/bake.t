#!/usr/bin/env lua5.4
-- bake.t - gen --bake: no function takes more operations than without; the constants say what they are.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The bodies are those in which numbers in the place of names once made equations longer.  That the baked code is right
-- is seen by its own self-test, whose numbers come from expressions without names (tests/emit/compile.t, kinds.t).

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local source = require "generator.emit.source"

local function total(c) return c.add + c.mul + c.div + c.sqrt + c.call end

-- Operations of each function by its name, and the job.
local function costs(path, bake, plan)
  local job = scene.plan(scene.file(path, { bake = bake }), plan)
  local m, out = job.model, {}
  local ctx = { name = m.name, upper = string.upper(m.name), real = job.real, members = m.members, states = job.states,
    inputs = m.inputs, helpers = {}, own = false }
  for _, f in ipairs(job.functions) do out[f.name] = source.cost(ctx, f) end
  return out, job
end

local names = 0
for _, body in ipairs { "bracket", "damped_brick", "gyroscope", "magnet_pendulum", "skater", "spun_coin", "wheels" } do
  local plain = costs("bodies/" .. body .. ".lua", false)
  local baked, job = costs("bodies/" .. body .. ".lua", true)
  local more = {}
  for name, c in pairs(plain) do -- only named if there are any
    local b = baked[name]
    if b and total(b) > total(c) then
      more[#more + 1] = string.format("%s %d -> %d", name, total(c), total(b))
    end
  end
  tap.is(table.concat(more, ", "), "", body .. ": no function takes more operations")
  for _, f in ipairs(job.functions) do names = names + (f.constants and 1 or 0) end
end
tap.ok(names > 30, "most functions have their constants by name", names)

do
  local plain = costs("bodies/brick.lua", false, { jacobians = true })
  local baked = costs("bodies/brick.lua", true, { jacobians = true })
  local c, b = plain.step_transition, baked.step_transition
  tap.ok(c and b and total(b) <= total(c), "nor does the step with its transition matrix",
    c and b and total(c) .. " " .. total(b))
end

-- a = 0.2, b = 0.1, c = 0.05 m, M = 2.4 kg about a corner: README.md
for _, real in ipairs { "double", "float" } do
  local text = scene.files(scene.plan(scene.file("bodies/brick.lua", { bake = true }), { real = real }))["brick.c"]
  local suffix = real == "float" and "F" or ""
  for _, want in ipairs { { "Ixx", "0.01", "moment of inertia xx, kg m^2: M*(b^2 + c^2)/3" },
    { "Iyy", "0.034", "moment of inertia yy, kg m^2: M*(a^2 + c^2)/3" },
    { "Ixy", "-0.012", "tensor entry xy, kg m^2: -M*a*b/4" } } do
    local line = string.format("static const real k_%s = %s%s; /* %s */\n", want[1], want[2], suffix,
      want[3])
    tap.like(text, line, real .. ": " .. want[1] .. " with its meaning, its unit and its formula")
  end
  local before = 0
  for name in text:gmatch "static const real (k_[%w_]+) = " do
    local uses = select(2, text:gsub("%f[%w_]" .. name .. "%f[^%w_]", ""))
    tap.ok(uses >= 2, real .. ": " .. name .. " is used")
    before = before + 1
  end
  tap.ok(before >= 6 and not text:find "m%->[IJ]", real
    .. ": there are such constants, and nothing is read from the model")
end

tap.done()
