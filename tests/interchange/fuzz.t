#!/usr/bin/env lua5.4
-- fuzz.t - robot files with random damage are read or refused; the program never breaks.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Values of the sample files are overwritten with others that a format gives a meaning to, pieces of XML are put in and
-- cut out, by Park and Miller's generator.  Status must be 0, 1 or 2: an internal error has 70.
package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local run = require "tests.interchange.program"

local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = assert(io.popen "pwd"):read "l" .. "/" .. binary end

local state = 4711
local function int(n)
  state = state * 16807 % 2147483647
  return state % n + 1
end

local values = { "", " ", "0", "-1", "2e-3", "1 2", "1 2 3 4", "0 0 0", "1 0 0 0", "1e308", "1e-320", "nan",
  "0x1p3", "x", "true", "XYz", "degree", "9999999999999999999", "&lt;", "-.5", "0.3 0.2 0.1", "lower", "quat_xyzw" }
local pieces = { "<inertial>", "</inertial>", "<mass/>", "<mass value='1'/>", " auto='true'", " quat='1 0 0 0'", "\0",
  " zaxis='0 0 -1'", " name='x'", " rpy='0 0 1'", "<pose>1 2 3 4 5 6</pose>", " fullinertia='1 1 1 0 0 0'", "\xff",
  "<!DOCTYPE a>", "<include file='x'/>", "<compiler angle='x'/>", "<!-- -->", "<", ">", "/>", "\"" }

-- One value becomes another, or (rarely, for it mostly ends the XML) a piece goes in anywhere or something goes out.
local function damaged(text)
  for _ = 1, int(3) do
    local spans = {}
    for from, to in text:gmatch '"()[^"<>]*()"' do spans[#spans + 1] = { from, to } end
    for from, to in text:gmatch ">()[^<>%s]+()<" do spans[#spans + 1] = { from, to } end
    local span, word = spans[int(#spans)], values[int(#values)]
    local kind = int(12)
    if kind <= 2 then
      local at = int(#text)
      span, word = { at, at }, pieces[int(#pieces)]
    elseif kind == 3 then
      local at = int(#text)
      span, word = { at, at + int(20) }, ""
    end
    text = text:sub(1, span[1] - 1) .. word .. text:sub(span[2])
  end
  return text
end

local counts, faults = { [0] = 0, [1] = 0, [2] = 0 }, {}
for _, name in ipairs { "arm.urdf", "arm.xml", "arm.sdf" } do
  local whole = program.read("tests/interchange/" .. name)
  for _ = 1, 150 do
    local text = damaged(whole)
    run.write("x.xml", text)
    local status = program.shell(string.format("cd %s && timeout 60 %s links x.xml >out 2>err", run.dir, binary))
    if counts[status] then
      counts[status] = counts[status] + 1
    else
      faults[#faults + 1] = "status " .. status .. "\n" .. program.read(run.dir .. "/err") .. text
    end
  end
end
tap.ok(#faults == 0, "450 damaged files are read or refused", faults[1])
tap.ok(counts[0] > 10 and counts[1] > 10 and counts[2] > 10, "some of them are good, some wrong, some no XML",
  string.format("%d, %d, %d", counts[0], counts[1], counts[2]))

run.finish()
tap.done()
