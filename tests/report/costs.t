#!/usr/bin/env lua5.4
-- costs.t - the cost sheet: in the emitted README and in explain, for the scene's own functions and type.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local json = require "tests.json"
local scene = require "tests.scene"
local driver = require "generator.driver"
local costs = require "generator.report.costs"
local explain = require "generator.report.explain"
local ops = require "generator.cost.ops"
local targets = require "generator.cost.targets"

local function planned(real)
  return scene.plan(scene.file "bodies/brick_centroid.lua", { real = real, methods = { "rk4", "semi", "exact" } })
end

local function names(rows)
  local list = {}
  for i, r in ipairs(rows) do list[i] = r.name end
  return table.concat(list, " ")
end

local plan = planned "double"
local job = driver.code(plan)
local rows, list = job.sheet()
tap.is(names(rows), "step semi_step at at_rates at_attitude at_tick", "what is called again and again")
tap.is(names((job.sheet(true))), "step semi_step solve at at_rates at_attitude at_tick",
  "and the set-up when asked for")
tap.is(table.concat(list, " "), table.concat(targets.list, " "), "a column a target")
tap.is(table.concat(costs.targets, " "), table.concat(targets.list, " "), "in the same order")

-- three digits of what the model says, by another way of rounding
for _, row in ipairs(rows) do
  local bad = {}
  for i, target in ipairs(targets.list) do
    local x = targets.cost(target, "double", ops.call(job, row.name))
    local shown = tonumber(row.cycles[i])
    if math.abs(shown - x) > math.max(0.5, 0.5 * 10 ^ (math.floor(math.log(x, 10)) - 2)) * 1.0001 then
      bad[#bad + 1] = target
    end
  end
  tap.is(table.concat(bad, " "), "", row.name .. ": what is shown is the estimate to three digits")
end

local readme = scene.files(plan)["README.md"]
local function line_of(text, name) return text:match("\n| " .. name .. " (|[^\n]*)") end
tap.ok(readme:find("| function | " .. table.concat(targets.list, " | ") .. " |",
  1, true) ~= nil, "the README has the table")
tap.is(line_of(readme, "at"), string.format("| %d | %d | %d | %d | %d |", rows[3].counts.add, rows[3].counts.mul,
  rows[3].counts.div, rows[3].counts.sqrt, rows[3].counts.call), "and the operations of a template's function")
local of_float = scene.files(planned "float")["README.md"]
tap.ok(of_float:find("on a processor in float", 1, true) ~= nil, "in float it says so")
tap.ok(line_of(of_float, "semi_step") ~= nil and of_float ~= readme, "and has other numbers")

local told = json.read(explain.text(job, "json"))
tap.is(told.cycles.real, "double", "explain, JSON: the type")
tap.is(#told.cycles.functions, 7, "explain, JSON: every function")
local first = told.cycles.functions[1]
tap.is(first["function"] .. " " .. first.add .. " " .. first.mul .. " " .. first.div, "step 75 97 1",
  "explain, JSON: the operations of rk4, as the header's banner counts them")
tap.is(tostring(math.tointeger(first.cycles["cortex-m4f"])), rows[1].cycles[4], "explain, JSON: the cycles")
tap.ok(explain.text(job, "text"):find("Estimated cycles of one call, in double", 1, true) ~= nil, "explain, text")

tap.done()
