#!/usr/bin/env lua5.4
-- cuts.t - members of a sweep whose hole is not in its body fail with the scene's own reason: grids, and a value drawn.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local cuts = require "generator.commands.sweep.cuts"
local values = require "generator.commands.sweep.values"
local program = require "tests.cli.program"
local scene = require "tests.scene"
local tap = require "tests.tap"
local tier = require "tests.tier"

-- A plate of 1 m with a hole of radius r whose middle is 0.1 m off: it sticks out from r = 0.4 on.  Of a plate alone
-- the emitted code asks that; with a second one it cannot.
local PLATE = [[
local r, h, rho = param("r", 200, "mm"), param("h", 0.1, "m"), param("rho", 2700, "kg/m^3")
return scene { name = "s", body = solid.box { x = 1, y = 1, z = h, density = rho } + SECOND
  - solid.cylinder { r = r, h = h, density = 2700 }:at { 0.1, 0, 0 }, initial = { omega = { 0.1, 1, 0.2 } },
  time = { horizon = 0.01 } }
]]
local ALONE = PLATE:gsub(" %+ SECOND", "")
PLATE = PLATE:gsub("SECOND", "solid.box { x = 1, y = 1, z = 0.1, density = 2700 }:at { 0, 0, 9 }")
local plate = assert(scene.read(PLATE))

local function find(given)
  local wrong = {}
  local s = values.read({}, plate, given, wrong)
  assert(#wrong == 0, wrong[1])
  return cuts.find(plate, s.values)
end

local OUT = "hole: must lie inside the body it is cut from (test.lua:3)"

local one = find { over = "r=380:440:4" }
tap.is(table.concat(one.codes, " "), "0 0 1 1", "the grid's last two stick out")
tap.is(one.texts[1], OUT, "with their reason")
tap.is(find { over = "r=380:400:4" }, nil, "flush is inside")
tap.is(find { over = "h=0.1:0.2:4" }, nil, "what changes body and hole alike")
tap.is(find { over = "wx=0:1:4" }, nil, "what the body does not depend on")
local two = find { over = "wx=0:1:2,r=380:440:3,wz=0:1:5,rho=2000:2700:2" }
tap.is(table.concat(two.codes, " "), "1 0 2 2 2 2", "two parameters, each point with its reason")
tap.is(two.texts[1], "hole: must not be denser than the body it is cut from (test.lua:3)", "also a hole that is denser")
tap.is(two.axes[1].stride .. " " .. two.axes[2].stride, "10 1", "where they stand in the grid")

local drawn, why = find { over = "wx=0:1:2", sample = 4, vary = "wz=uniform(0,1),r=uniform(380,440)" }
tap.is(why, nil, "a value that is drawn")
tap.is(#drawn.spans .. " " .. drawn.place, "1 2", "has a span in which it sticks out, behind the grid's axes")
tap.near(drawn.spans[1].low, 400, 0, 1e-6, "from where it does", "the slack of a hole, 1e-9 of its size")
tap.is(drawn.spans[1].high, nil, "to the end")
drawn = find { sample = 4, vary = "rho=normal(2700,100)" }
tap.near(drawn.spans[1].high, 2700, 1e-6, 0, "below some density the hole is denser", "a millionth is let pass")
tap.is(drawn.spans[1].low, nil, "however small it is")
local _, both = find { sample = 4, vary = "rho=normal(2700,100),r=uniform(380,440)" }
tap.is(both, OUT .. " depends on rho, which is drawn with others: it is not asked of the members",
  "two that are drawn are not asked, and that is said")

tap.is(cuts.find(assert(scene.read(ALONE)), {}), nil, "what the emitted code asks is not asked here")

if not tier.quick then
  local dir = program.directory()
  OUT = OUT:gsub("test", "s")
  local function run(arguments)
    program.shell(program.quick() .. " sweep " .. dir .. "/s.lua " .. arguments .. " --keep 'final: T = t' >" .. dir ..
      "/out 2>" .. dir .. "/err")
    local list = {}
    for line in program.read(dir .. "/out"):gmatch "[^\n]+" do list[#list + 1] = line end
    return list
  end
  for _, text in ipairs { PLATE, ALONE } do
    local what = text == ALONE and ", by the emitted code" or ", by points"
    program.write(dir .. "/s.lua", text)
    local rows = run "--over wx=0:1:2,r=380:440:4"
    local states = {}
    for i = 2, #rows do states[#states + 1] = rows[i]:find("no body: " .. OUT, 1, true) and "out" or
      rows[i]:match "ok$" end
    tap.is(table.concat(states, " "), "ok ok out out ok ok out out", "the program says so of its members" .. what)
    rows = run "--sample 20 --vary 'r=uniform(380,440)'"
    local right = 0
    for i = 2, #rows do
      local r, state = rows[i]:match "^%d+,([^,]+),.*,([^,]+)$"
      right = right + ((state == "ok") == (tonumber(r) < 400) and 1 or 0)
    end
    tap.is(right, 20, "and of those that are drawn" .. what)
  end
end

program.finish()
tap.done()
