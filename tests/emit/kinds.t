#!/usr/bin/env lua5.4
-- kinds.t - same input, same bytes, of what `gen` makes beside the plain files: projects, extras, other methods.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- determinism.t has every body with the usual options; here is one body for each option that it does not have.  Two
-- processes, other folders, another locale and time zone; nothing of this machine in the text.
-- The quick tier takes a part of its cases.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()

local pipe = io.popen "pwd"
local here = pipe:read "l"
pipe:close()
if not binary:find "^/" then binary = here .. "/" .. binary end

-- one that declares ranges, which proof and q31 ask for
program.write(dir .. "/spinner.lua", [[return scene { name = "spinner",
  body = solid.box { x = 1, y = 2, z = 3, mass = 1 },
  ranges = { omega = 5 }, initial = { omega = {1, 2, 3} }, time = { horizon = 1, step = exact("1/1024") } }]])

-- body, options
local all = {
  { "gyroscope", "--project firmware" }, { "heavy_top", "--project firmware --real float" },
  { "heavy_top", "--project fmu" }, { "brick", "--project arduino" }, { "coin", "--project platformio" },
  { "coin", "--project zephyr" }, { "coin", "--project cmake" }, { "spinner", "--with proof" },
  { "damped_brick", "--with jacobians" }, { "spinner", "--with q31" }, { "heavy_top", "--method midpoint,semi" },
  { "gyrostat", "--method split4,split2" }, { "kapitza", "--method adaptive" },
  { "torsion_pendulum", "--method taylor --order 8" }, { "skater", "--libm system" },
  { "gyrostat", "--libm own --real float" }, { "tumbling_box", "--show lower" }, { "solar_sail", "--method semi" },
}

for i, one in ipairs(tier.every(5, all)) do
  local body, option = one[1], one[2]
  local function gen(where, before)
    local to = string.format("%s/%d-%s", dir, i, where)
    local scene = (body == "spinner" and dir or here .. "/bodies") .. "/" .. body .. ".lua"
    local out = option:find "%-%-show" and "" or string.format("-o %s/%s", to, body) -- --show prints, writes no file
    return program.shell(string.format("mkdir %s && { %s %s gen %s %s %s; } >%s/said 2>%s.err", to, before or "true;",
      binary, scene, option, out, to, to)), to
  end
  local first, a = gen "a"
  local second, b = gen("b", "cd / && export LC_ALL=C.UTF-8 TZ=Asia/Tokyo HOME=/nowhere;")
  -- what is said on the way names the folder, which is another one
  local same = program.shell(string.format("sed -i 's|%s|DIR|g' %s/said && sed -i 's|%s|DIR|g' %s/said && " ..
    "diff -r %s %s", a, a, b, b, a, b)) == 0
  local name = string.format("gen %s %s", body, option)
  tap.ok(first == 0 and second == 0 and same, name .. ": the same bytes in two processes", program.read(a .. ".err"))
  local foreign = program.shell(string.format("grep -rqF -e '%s' -e '%s' %s", here, dir, a))
  tap.is(foreign, 1, name .. ": no path of this machine")
end

program.finish()
tap.done()
