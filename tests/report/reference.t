#!/usr/bin/env lua5.4
-- reference.t - the reference of the scene language: its page is up to date, and its examples run.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local reference = require "generator.commands.reference"
local language = require "generator.language.reference"

local program = os.getenv "POLHODE" or "build/polhode"

local function run(command)
  local pipe = assert(io.popen(program .. " " .. command .. " 2>&1"))
  local text = pipe:read "a"
  return text, select(3, pipe:close())
end

local list = reference.entries()
local file = assert(io.open "docs/reference.md")
tap.ok(file:read "a" == language.page(list), "docs/reference.md is up to date (make docs)")
file:close()

local seen, name = {}, os.tmpname()
for _, e in ipairs(list) do
  tap.ok(not seen[e.name] and #e.about > 0, e.name .. ": one entry, which says something")
  seen[e.name] = true
  if e.example then
    local out = assert(io.open(name, "w"))
    out:write(e.example, "\n")
    out:close()
    local said, status = run("run " .. name .. " --until 0.01 --step 0.01 --method rk4")
    tap.is(status, 0, e.name .. ": its example runs", said)
  end
end
os.remove(name)

for _, word in ipairs { "scene.initial", "effect.wheel", "solid.cone", "s.q", "units" } do
  local said, status = run("help " .. word)
  tap.ok(status == 0 and seen[word] and #said > 40, "polhode help " .. word)
end
-- functions and words of events: rows of one entry, and each found by its name
for word, wanted in pairs { sqrt = "sqrt(x)", abs = "abs(x)", sign = "0 at 0", min = "min(x, y, ...)", max = "greatest",
  atan2 = "atan2(x, y)", N = "reaction of the plane", slip = "Unit: m/s", com_y = "centre of mass", v1 = "along e1" } do
  local said, status = run("help " .. word)
  tap.ok(status == 0 and string.find(said, wanted, 1, true), "polhode help " .. word, said)
end
-- every function that a scene may call, and no other
do
  local out = assert(io.open(name, "w"))
  local calls = {}
  for _, e in ipairs(list) do
    for i, r in ipairs(e.name == "functions" and e.rows or {}) do
      calls[i] = r[1] .. (r.call == "(x)" and "(x)" or "(x, x)")
    end
  end
  out:write('local x = param("x", 0.5)\nlocal sum = ', table.concat(calls, " + "), '\nreturn scene { name = "all", ',
    'body = solid.box { x = 1, y = 1, z = 1, mass = 1 }, initial = { omega = { sum, 0, 0 } } }\n')
  out:close()
  local said, status = run("run " .. name .. " --until 0.01")
  tap.ok(#calls == 17 and status == 0, "all functions of the reference are called by a scene", said)
  os.remove(name)
end
local said, status = run "help effect.weel"
tap.ok(status == 2 and string.find(said, "did you mean effect.wheel?", 1, true), "a name that is nearly one", said)
tap.done()
