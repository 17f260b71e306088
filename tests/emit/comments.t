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

-- ---- words that were wrong ----

-- the stages' angles are called a where v is the velocity
local function text_of(source, plan, options)
  return scene.files(scene.plan(assert(scene.read(source, options)), plan))
end
local function box(name, more, effects)
  return string.format([[
local l = param("l", 0.02, "N m")
local function spun(k)
  local wheel = effect.wheel { axis = {1, 0, 0}, inertia = 0.001 * k, torque = l, included = false }
  return wheel
end
return scene { name = "%s", body = solid.box { x = param("a", 0.3, "m"), y = 0.2, z = 0.1, mass = param("M", 2, "kg") },
  initial = { omega = {1, 2, 3}%s }, effects = { %s } }]], name, more, effects)
end
local files = text_of(box("moved", ", position = {0, 0, 1}, velocity = {1, 0, 0}",
  'effect.torque { body = {l, 0, 0} }, effect.translation { force = {0, 0, 1} }'), { methods = { "rk4" } })
c = files["moved.c"]
tap.ok(c:find("/* stage 1: at the start; a = w h/4 */\n  const real ax1 = h4*wx", 1, true), "a = w h/4 stands over ax1",
  c:match "/%* stage 1[^\n]*\n[^\n]*")
tap.ok(not c:find("v = w h/4", 1, true), "and v nowhere")
tap.like(files["moved.h"], "/* torque, over the moment of inertia xx", "a quotient by a moment says which in words")

files = text_of(box("same", "", "spun(1), spun(2), spun(3)"))
tap.like(files["same.h"], "Effect wheel (test.lua:3, 3 times):", "three wheels of one helper: its line once")
for k = 1, 3 do
  tap.like(files["same.h"], "relative to the body (test.lua:3, no. " .. k .. " of that line) [rad/s]",
    "and each of their states apart")
end

local custom = "effect.custom { %s }"
local torque, potential = "torque = function(s) return {s.w[2], 0, 0} end",
  "potential = function(s) return l * s.q[2]^2 end"
torque = torque:gsub("s%.w%[2%]", "l * s.q[2]")
h = text_of(box("own", "", custom:format(torque)))["own.h"]
tap.ok(h:find("as the scene writes it.\n", 1, true) and not h:find("potential", 1, true),
  "a custom torque cites no potential", h:match "Effect custom[^\n]*\n[^\n]*")
h = text_of(box("own", "", custom:format(potential)))["own.h"]
tap.like(h, "from a potential N_i = -dV along a turn about", "a custom potential does")

for _, row in ipairs { { true, "nothing is left of them" }, { false, "computed once by own_init" } } do
  h = text_of(box("own", "", "effect.torque { body = {l, 0, 0} }"), { only = { "step" } }, { bake = row[1] })["own.h"]
  tap.like(h, row[2], "the model says who computes it: " .. tostring(row[1]))
  tap.is(h:find("own_init", 1, true) ~= nil, not row[1], "NAME_init is named only where it is emitted")
end

tap.done()
