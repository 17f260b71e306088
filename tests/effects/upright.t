#!/usr/bin/env lua5.4
-- upright.t - which upright spins on a plane are stable: the emitted margins, and the chart.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The critical rates that explain states are held to the library's motions in touch.t; the emitted margin must change
-- its sign there.  The border of a chart is that of a closed form: a smooth sphere whose centre of mass is `low` above
-- its centre is stable for (I3 n)^2 > 4 I1 m G low, whatever its radius.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local json = require "tests.json"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function scene_of(name, body, plane)
  return string.format([[
local r, low = param("r", 15, "mm"), param("low", 3, "mm")
return scene { name = %q, body = %s, effects = { effect.plane { %s } },
  initial = { omega = { 0, 0, 180 }, attitude = { axis = "x", angle = 1 } } }]], name, body, plane)
end

local TOP = "tensor { mass = 0.006, xx = 8e-7, yy = 8e-7, zz = 7e-7 }"
local SPHERE = "surface = contact.sphere { r = r, at = { 0, 0, low } }"
local cases = {
  { "smooth", TOP, SPHERE .. ", law = 'smooth'" }, { "rolls", TOP, SPHERE .. ", law = 'rolling'" },
  { "slides", TOP, SPHERE .. ", law = 'sliding', friction = { viscous = 1 }" },
  { "disc", "tensor { mass = 0.01, xx = 1e-6, yy = 1e-6, zz = 2e-6 }", "surface = contact.disc { r = r, edge = low }" },
}
local KEYS = { upright_z_up_above = "stable_up", upright_z_down_above = "stable_down", upright_z_up_below = "stable_up",
  upright_z_down_below = "stable_down", rolling_straight_above = "stable_straight",
  spinning_on_edge_above = "stable_edge" }

local function shell(format, ...) return program.shell(string.format(format, ...)) end

for _, case in ipairs(cases) do
  local name = case[1]
  program.write(dir .. "/" .. name .. ".lua", scene_of(table.unpack(case)))
  tap.is(shell("%s explain %s/%s.lua --format json >%s/out 2>%s/err", binary, dir, name, dir, dir), 0, name ..
    ": explained")
  local values, lines, found = json.read(program.read(dir .. "/out")).values, {}, {}
  for key, f in pairs(KEYS) do
    local v = values and values[key]
    if v then
      found[#found + 1] = { f, v.value, key:find "below" and -1 or 1 }
      for _, part in ipairs { 0.999, 1.001 } do
        lines[#lines + 1] = string.format('printf("%%d\\n", %s_%s(&m, %.17g) > 0);', name, f, v.value * part)
      end
    end
  end
  tap.ok(#found == 2, name .. ": two critical rates")
  program.write(dir .. "/main.c", string.format("#include \"%s.h\"\n#include \"%s_analysis.h\"\n#include <stdio.h>\n" ..
    "int main(void) {\n%s_model m;\n%s_init(&m, NULL);\n%s\nreturn 0; }\n", name, name, name, name, table.concat(lines,
    "\n")))
  local code = shell("%s gen %s/%s.lua --with analysis --method rk4 -o %s/%s >%s/out 2>%s/err && cd %s && " ..
    "%s -std=c99 -Wall -Werror -I%s -o run main.c %s/*_analysis.c %s/%s.c -lm && ./run >out", binary, dir, name, dir,
    name, dir, dir, dir, os.getenv "CC" or "cc", name, name, name, name)
  tap.is(code, 0, name .. ": emitted and compiled")
  local next_line = (program.read(dir .. "/out") or ""):gmatch "%d"
  for _, f in ipairs(found) do
    local below, above = next_line(), next_line()
    local want = f[2] == 0 and { "1", "1" } or f[3] > 0 and { "0", "1" } or { "1", "0" }
    if f[2] == 0 and f[3] < 0 then want = { "0", "0" } end
    tap.is((below or "") .. (above or ""), want[1] .. want[2], string.format("%s: %s about %.6g rad/s", name, f[1],
      f[2]))
  end
end

-- ---- the chart ----

local rate, I1, I3, G, mass = 60, 8e-7, 7e-7, 9.80665, 0.006
local low = (I3 * rate) ^ 2 / (4 * I1 * mass * G) * 1000 -- mm
tap.is(shell("%s chart %s/smooth.lua --over r=12:20,low=0:10 --rate %d -o %s/chart.svg 2>%s/err", binary, dir, rate,
  dir, dir), 0, "a chart of upright spins")
local text, borders = program.read(dir .. "/chart.svg") or "", 0
local box = 270 -- pixels of a panel's height, from y = 100 on
for path in text:gmatch '<path[^>]*class="curve"[^>]*>' do
  for _, y in path:gmatch "([%d.]+)[ ,]([%d.]+)" do
    -- a tenth of a pixel is what the file rounds to
    tap.near(tonumber(y), 100 + box * (1 - low / 10), 0, 0.11, "its border lies at low = " .. low .. " mm", "rounding")
    borders = borders + 1
  end
end
tap.ok(low > 0 and low < 10 and borders >= 2, "there is a border")

local function refused(arguments, message)
  tap.ok(shell("%s chart %s >%s/out 2>%s/err", binary, arguments, dir, dir) ~= 0 and
    program.read(dir .. "/err"):find(message, 1, true), arguments:gsub(dir, "") .. ": " .. message)
end
local over = "--over r=12:20,low=0:10"
refused(dir .. "/smooth.lua " .. over .. " --dissipation", "--dissipation: it is that of a free body, with --axis")
refused(dir .. "/smooth.lua " .. over .. " --axis z --rate 3", "--rate: it is that of an upright spin")
program.write(dir .. "/slope.lua", scene_of("slope", TOP, SPHERE .. ", normal = { 1, 0, 5 }"))
refused(dir .. "/slope.lua " .. over, "no spin of this scene is upright")
tap.is(shell("%s chart %s/smooth.lua %s --axis z -o %s/free.svg 2>%s/err", binary, dir, over, dir, dir), 0,
  "with --axis it is the free body's")

-- A tensor of parameters: its conditions know the roundoff of the code.
program.write(dir .. "/free.lua", [[
local a, b = param("a", 8, "kg m^2"), param("b", 7, "kg m^2")
return scene { name = "free", body = tensor { mass = 1, xx = a, yy = a, zz = b } }]])
tap.is(shell("%s chart %s/free.lua --over a=7:9,b=6:9 -o %s/free.svg 2>%s/err", binary, dir, dir, dir), 0,
  "the chart of a tensor that depends on parameters")

program.finish()
tap.done()
