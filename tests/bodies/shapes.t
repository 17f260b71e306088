#!/usr/bin/env lua5.4
-- shapes.t - polhode check passes for every shape, its sizes parameters: emitted code against the general library.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The scenes are the rows of tests/handbook with their sizes, by mass and by density, and bodies that are sheared,
-- scaled, mirrored, turned, summed and cut.  What is compared and how much may differ: generator/commands/check.lua.
-- Twenty states are few, but the tensor is the point here: equal tensors have equal motions.  The quick tier takes
-- every eighth.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local handbook = require "tests.handbook"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()

local scenes = {}
local function add(shape, params, at, amount, name)
  local lines = {}
  for _, p in ipairs(params) do
    local unit = (p:find "^phi" or p:find "^k") and '"rad"' or '"m"'
    lines[#lines + 1] = string.format('local %s = param("%s", %.17g, %s)', p, p, at[p], unit)
  end
  lines[#lines + 1] = 'local M, rho = param("M", 2, "kg"), param("rho", 7)'
  local id = string.format("s%03d", #scenes + 1)
  program.write(dir .. "/" .. id .. ".lua", table.concat(lines, "\n") .. "\nreturn scene { name = \"" .. id ..
    "\", body = " .. shape:gsub("AMOUNT", amount) .. " }\n")
  scenes[#scenes + 1] = { id = id, name = name .. ", " .. amount }
end

-- Each by mass or by density, in turn; tests/mass holds both forms of every shape against the handbook.
for i, row in ipairs(handbook.rows) do
  for _, amount in ipairs { i % 2 == 0 and "mass = M" or "density = rho" } do
    add(row.shape .. " { " .. row.args .. ", AMOUNT }", row.params, row.at, amount, row.shape)
  end
end

local ABC, AT = { "a", "b", "c" }, { a = 0.5, b = 0.4, c = 0.3 }
for _, body in ipairs {
  "region { {x, 0, a}, {y, 0, b*(1 - x/a)}, {z, 0, c*(1 - x/a)}, AMOUNT }",
  "region { {z, 0, c}, {x, -a, a}, {y, 0, b + x^2/a}, AMOUNT }",
  "solid.box { x = a, y = b, z = c, AMOUNT }:sheared{xy = 0.3, zx = 0.2}:turned{axis = {1, 1, 0}, angle = b/a}" ..
    ":at{a, 0, 0}",
  "solid.cone { r = a, h = b, AMOUNT }:scaled{1, 2, c/a}:mirrored \"z\"",
  "solid.box { x = a, y = b, z = c, AMOUNT } + solid.sphere { r = a, AMOUNT }:at{b, c, a} + " ..
    "solid.cone { r = a, h = c, AMOUNT }:at{-1, 0, b}",
  "solid.box { x = 4*a, y = 4*a, z = 4*a, density = rho } - solid.sphere { r = a, density = rho }" ..
    ":at{a/2, a/4, -a/2} + points { {M, a, b, c}, {M, -a, 0, 0} }",
} do
  for _, amount in ipairs { "mass = M", "density = rho" } do
    if body:find "AMOUNT" or amount == "mass = M" then add(body, ABC, AT, amount, body) end
  end
end
-- shells of three unlike axes, which the handbooks do not have
add("shell.ellipsoid { a = a, b = b, c = c, AMOUNT }", ABC, AT, "mass = M", "shell.ellipsoid of three axes")
add("shell.ellipsoid { a = a, b = b, c = c, AMOUNT }", ABC, AT, "density = rho", "shell.ellipsoid of three axes")

scenes = tier.every(8, scenes, 2)
do
  local list = {}
  for i, s in ipairs(scenes) do list[i] = s.id .. "\n" end
  program.write(dir .. "/list", table.concat(list))
  local path = binary:sub(1, 1) == "/" and binary or '"$PWD"/' .. binary
  program.shell(string.format("p=%s; cd %s && %s xargs -P 2 -I N sh -c '%s check --real double --states 20 N.lua " ..
    ">N.out 2>&1; echo status $? >>N.out' <list", path, dir, program.quick_compiler(), "'$p'"))
end

local WANT = { "compiles without a warning", "tensor as the library's", "principal moments",
  "rates of change to 8 ulp" }
local worst = { 0, "" }
for _, s in ipairs(scenes) do
  local out = program.read(dir .. "/" .. s.id .. ".out") or ""
  local fine = out:find "status 0\n$" ~= nil and not out:find "not ok"
  for _, part in ipairs(WANT) do fine = fine and out:find(part, 1, true) ~= nil end
  local bad = {}
  for line in out:gmatch "[^\n]+" do
    if not line:find "^ok " then bad[#bad + 1] = line end
  end
  tap.ok(fine, s.name .. ": the emitted code agrees with the library", table.concat(bad, "\n"))
  local ulp = tonumber(out:match "shapes %(([%d%.]+) ulp")
  if ulp and ulp > worst[1] then worst = { ulp, s.name } end
end
tap.diag(string.format("the worst tensor: %s ulp of its largest entry (%s)", worst[1], worst[2]))

tap.done(program.finish())
