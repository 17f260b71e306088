#!/usr/bin/env lua5.4
-- comments.t - comments of emitted code say what the code does: equations, not help texts; each constant its own words.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"

local function emitted(name, plan)
  local files = scene.files(scene.plan(scene.file("bodies/" .. name .. ".lua"), plan))
  return files[name .. ".h"], files[name .. ".c"]
end

for _, name in ipairs { "wheels", "gyrostat", "dual_spin", "heavy_top", "gyroscope", "magnet_pendulum", "kapitza",
  "nasa_brick_damped", "solar_sail", "foucault", "skater" } do
  local h, c = emitted(name)
  tap.ok(not (h .. c):find("?.", 1, true) and not (h .. c):find("(number", 1, true), name .. ": no help text")
  local seen, twice = {}, {}
  for about in h:match "typedef struct [%w_]+_model {.-}":gmatch "; /%* ([^\n]-) %*/" do
    if seen[about] then twice[#twice + 1] = about end
    seen[about] = true
  end
  for line in h:match "enum { /%* state.-};":gmatch "[^\n]+" do
    local about = line:match "/%* (.-) %*/"
    if about and seen[about] then twice[#twice + 1] = about end
    if about then seen[about] = true end
  end
  tap.is(table.concat(twice, ", "), "", name .. ": no two members, no two states with the same comment")
end

local h, c = emitted("wheels", { jacobians = true })
tap.like(h, "Effect wheel (wheels.lua:13, 14, 16): J (a.w + W)' = u;", "wheels: the banner has the equation")
tap.like(c, "/* wheel: N = J (a.w + W) a x w - u a, of the wheel on the body [wheels.lua:14] */",
  "and the torque its own")
tap.like(c, "/* L = I w + J (a.w + W) a of each wheel; I without the wheels' own moments */", "L has the wheels in it")
tap.ok(not c:find("/* L = I w */\n  const wheels_real t", 1, true), "and nowhere without")
tap.like(c, "+ J (a.w + W)^2/2 of each wheel", "T, too")
tap.like(h, "while what turns or moves in the body does what the scene says. */", "NAME_torque says what the wheels do")
local step = scene.files(scene.plan(scene.file "bodies/wheels.lua", { methods = { "rk4" } }))["wheels.c"]
tap.ok(step:find("const real wheel_2S3 = ", 1, true) and not step:find "wheel_%d%d" and not step:find "N%l_%d%d",
  "the number of a wheel and that of a stage stand apart: wheel_2S3")
for name, size in pairs { jacobian = "NX*WHEELS_NX", jacobian_p = "NX*WHEELS_NP", initial_p = "NX*WHEELS_NP",
  step_transition = "NX*WHEELS_NX" } do -- independent of each other: in any order
  local arguments = h:match("void wheels_" .. name .. "(%b())")
  tap.ok(arguments and arguments:find("[WHEELS_" .. size .. "]", 1, true), name .. ": its matrix has rows and columns",
    arguments)
end
h, c = emitted "gyrostat"
tap.like(c, "/* L = I w + h of the rotor */", "gyrostat: L has the rotor in it")
tap.like(c, "/* rotor: N = h x w, h = momentum axis/|axis|", "and its torque is written as an equation")
tap.like(h, "\n#define GYROSTAT_VERSION \"polhode ", "every header has its version")

tap.done()
