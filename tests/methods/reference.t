#!/usr/bin/env lua5.4
-- reference.t - two steppers that share nothing, Taylor series and splitting, against the forced tops of 32 digits.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Every row of tests/reference/forced_top.h (provenance: README.md beside it).  A rotor in an asymmetric body and
-- damping are refused by split6: those rows are for Taylor and the Runge-Kutta pair.
-- The quick tier takes a part of its cases.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local scene = require "tests.scene"

local binary = program.quick()
local dir = program.directory()

local function numbers(s)
  local out = {}
  for word in string.gmatch(s, "[^,%s]+") do out[#out + 1] = tonumber((string.gsub(word, "L$", ""))) end
  return out
end

-- The scene's effect of a row: load is m g r, the diagonal of C, a torque or the rotor's momentum.
local effect = {
  HEAVY = "", DAMPING = "effect.damping { c = {%.17g, %.17g, %.17g} }",
  BODY = "effect.torque { body = {%.17g, %.17g, %.17g} }",
  INERTIAL = "effect.torque { inertial = {%.17g, %.17g, %.17g} }",
  ROTOR = "effect.rotor { axis = {%.17g, %.17g, %.17g}, momentum = %.17g }",
}

local function text(model, I, load, x)
  local acts, com = string.format(effect[model], load[1], load[2], load[3],
    math.sqrt(load[1] ^ 2 + load[2] ^ 2 + load[3] ^ 2)), ""
  if model == "HEAVY" then -- a light arm and a strong field, so that the moments about the centre stay valid
    acts = "effect.gravity { g = 1024 }"
    com = string.format(", com = {%.17g, %.17g, %.17g}, about = 'origin'", load[1] / 1024, load[2] / 1024,
      load[3] / 1024)
  end
  local body = string.format("tensor { mass = 1, xx = %.17g, yy = %.17g, zz = %.17g%s }", I[1], I[2], I[3], com)
  return string.format("return scene { name = 'top', body = %s, origin = {0, 0, 0}, effects = { %s }, " ..
    "initial = { omega = {%.17g, %.17g, %.17g}, attitude = {%.17g, %.17g, %.17g, %.17g} } }", body, acts,
    table.unpack(x))
end

local cases, by_id = {}, {}
for id, model, moments, load, x, t, state in string.gmatch(scene.slurp("tests/reference/forced_top.h"),
  '{"([^"]+)", FORCED_(%u+), {([^}]*)}, {([^}]*)},%s*{([^}]*)}, ([^,]+),%s*{([^}]*)}}') do
  local c = by_id[id]
  if not c then
    c = { id = id, model = model, times = {}, want = {}, I = numbers(moments),
      text = text(model, numbers(moments), numbers(load), numbers(x)), load = numbers(load) }
    by_id[id], cases[#cases + 1] = c, c
  end
  c.times[#c.times + 1], c.want[#c.want + 1] = t, numbers(state)
end
tap.is(#cases > 10, true, "forced_top.h was read")

-- Largest error at each time, rates in units of their length there.
local function errors(c, method)
  program.write(dir .. "/top.lua", c.text)
  local status = program.shell(string.format("POLHODE_SOURCE=. %s run %s/top.lua --engine generated --method %s " ..
    "--at %s > %s/csv 2>&1", binary, dir, method, table.concat(c.times, ","), dir))
  local out = program.read(dir .. "/csv")
  if status ~= 0 then return nil, out end
  local list, n = {}, 0
  for line in string.gmatch(string.match(out, "\n(.*)"), "[^\n]+") do
    n = n + 1
    local got, want, e = numbers(line), c.want[n], 0.0
    local size = math.sqrt(want[1] ^ 2 + want[2] ^ 2 + want[3] ^ 2)
    for i = 1, 3 do e = math.max(e, math.abs(got[i + 5] - want[i]) / size) end
    for i = 1, 4 do e = math.max(e, math.abs(got[i + 1] - want[i + 3])) end
    list[n] = e
  end
  return n == #c.times and list or nil, out
end

local TOLERANCE = 1e-11 -- what the reference set asks for

for _, c in ipairs(tier.every(6, cases)) do
  local axial = c.I[1] == c.I[2] and c.load[1] == 0 and c.load[2] == 0
  local methods = { "taylor --tolerance 1e-15" }
  local splits = c.model ~= "DAMPING" and (c.model ~= "ROTOR" or axial)
  methods[2] = splits and "split6 --step 0.01" or "adaptive --tolerance 1e-15"
  for _, method in ipairs(methods) do
    local list, why = errors(c, method)
    local words = {}
    for i, e in ipairs(list or {}) do words[i] = string.format("t = %s: %.2g", c.times[i], e) end
    tap.ok(list and math.max(table.unpack(list)) <= TOLERANCE, c.id .. ": " .. string.match(method, "^%w+"),
      list and table.concat(words, ", ") or why)
  end
end

tap.done(program.finish())
