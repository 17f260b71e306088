#!/usr/bin/env lua5.4
-- check.t - polhode check passes for every body: emitted code against the general library, in double and float.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each check of the program is shown here as one of this test's.  What they compare and how much may differ is written
-- in generator/commands/check.lua; here it is also made sure that they are there: a run that checks nothing fails.
-- The quick tier takes seven bodies.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"

local program = require "tests.cli.program"

-- gcc, whose warnings the other tests of many scenes do not see
local binary = "env " .. program.compiler "-O0" .. " " .. (os.getenv "POLHODE" or "build/polhode")

local function lines(command)
  local list = {}
  local pipe = assert(io.popen(command))
  for line in pipe:lines() do list[#list + 1] = line end
  local _, _, status = pipe:close()
  return list, status
end

-- What must be among the checks of a body and real type: parts of their names.
local WANT = { "compiles without a warning", "parameters are accepted", "tensor as the library's", "principal moments",
  "rates of change to 8 ulp", "energy to 8 ulp", "momentum to 8 ulp", "Jacobian", "halving h" }
local POINT = { "compiles without a warning", "parameters are accepted", "rates of change to 8 ulp", "energy to 8 ulp",
  "Jacobian", "halving h" }
local points = { dropped_stone = true, foucault = true } -- scenes that have no tensor

-- One of each closed form and kind of state.
local QUICK = { brick = true, symmetric_top = true, heavy_top = true, gyrostat = true, foucault = true,
  damped_brick = true, wheels = true, nasa_brick_damped = true } -- the last has states that do not move

for _, path in ipairs((lines "ls bodies/*.lua")) do
  local name = path:match "([%w_]+)%.lua"
  if tier.quick and not QUICK[name] then goto continue end
  local out, status = lines(binary .. " check " .. path .. " 2>&1")
  tap.is(out[1], "TAP version 13", name .. ": the output is TAP 13")
  local seen, passed, skipped = {}, 0, false
  for i = 2, #out - 1 do
    local verdict, number, what = out[i]:match "^(%l*%s*ok) (%d+) %- (.*)$"
    if verdict then
      tap.ok(verdict == "ok", what, out[i])
      seen[#seen + 1] = what
      passed = passed + 1
      skipped = skipped or what:find("# SKIP", 1, true) ~= nil
      if tonumber(number) ~= passed then tap.ok(false, name .. ": the checks are numbered in order", out[i]) end
    elseif not out[i]:match("^# %w+ does not take " .. name .. ": .*%a") then
      tap.ok(false, name .. ": nothing but checks is printed", out[i])
    end
  end
  tap.is(out[#out], "1.." .. passed, name .. ": the plan counts them")
  tap.is(status, 0, name .. ": status 0")
  for _, real in ipairs { "double", "float" } do
    if real == "double" or not skipped then
      local missing = {}
      for _, part in ipairs(points[name] and POINT or WANT) do
        local found = false
        for _, what in ipairs(seen) do
          found = found or what:find(name .. ", " .. real .. ": ", 1, true) and what:find(part, 1, true)
        end
        if not found then missing[#missing + 1] = part end
      end
      tap.is(table.concat(missing, "; "), "", name .. ", " .. real .. ": no check is missing")
    end
  end
  tap.ok(not skipped or name == "water", name .. ": both real types are checked; float cannot hold a molecule")
  ::continue::
end

tap.done(program.finish())
