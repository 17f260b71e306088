#!/usr/bin/env lua5.4
-- touch.t - what a body on a plane conserves, and how fast it must spin: the values that explain states.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Laws: the derivative along the emitted equations, in exact arithmetic of 200 bits and more: a law that is claimed has
-- the rate 0, one that is not claimed changes.  (`polhode check` does so with the library's rates.)
-- Critical speeds: the library's motion of a body that is nearly upright, a tenth below and above; steady rolling: the
-- tilt that the library's motion keeps.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local program = require "tests.cli.program"
local json = require "tests.json"
local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local quantities = require "generator.dynamics.quantities"
local selftest = require "generator.emit.selftest"
local state = require "generator.dynamics.state"
local touch_laws = require "generator.dynamics.touch_laws"

---- laws ------------------------------------------------------------------------------------------------

local BOXY = "tensor { mass = 2, xx = 0.02, yy = 0.03, zz = 0.04 }"
local TOP = "tensor { mass = 2, xx = 0.02, yy = 0.02, zz = 0.03 }"
local BALL = "tensor { mass = 2, xx = 0.02, yy = 0.02, zz = 0.02 }"
local SPHERE, LOW = "contact.sphere { r = 0.1 }", "contact.sphere { r = 0.1, at = {0, 0, 0.03} }"
local ASIDE = "contact.sphere { r = 0.1, at = {0.01, 0, 0.03} }"
local EGG = "contact.ellipsoid { a = 0.1, b = 0.1, c = 0.2 }"
local STONE = "contact.ellipsoid { a = 0.1, b = 0.2, c = 0.1 }"
local ROLL, TABLE = "law = \"rolling\"", "law = \"rolling\", turntable = 3"
local SLOPE = "law = \"rolling\", normal = {1, 0, 5}"
local SLIDE, SMOOTH = "law = \"sliding\", friction = { viscous = 0.4 }", "law = \"smooth\""
local SOFT = "law = \"rolling\", spinning = { viscous = 0.01 }"

-- body, surface, law: the laws that hold; the others that exist for this law of contact must vary.
local cases = {
  { TOP, LOW, ROLL, "jellett routh" }, { TOP, ASIDE, ROLL, "" }, { BOXY, LOW, ROLL, "" },
  { TOP, LOW, TABLE, "turntable_energy jellett" }, { TOP, LOW, SLOPE, "jellett" }, { TOP, LOW, SLIDE, "jellett" },
  { TOP, LOW, SMOOTH, "jellett momentum_about_normal momentum_about_axis" }, { TOP, EGG, ROLL, "" },
  { BOXY, SPHERE, ROLL, "jellett chaplygin_e1 chaplygin_e2 chaplygin_n" },
  { BOXY, SPHERE, SLOPE, "jellett chaplygin_e1 chaplygin_e2 chaplygin_n" },
  { BOXY, SPHERE, TABLE, "turntable_energy jellett chaplygin_e1 chaplygin_e2 chaplygin_n" },
  { BOXY, SPHERE, SLIDE, "jellett chaplygin_e1 chaplygin_e2 chaplygin_n" },
  { BALL, SPHERE, TABLE, "turntable_energy jellett chaplygin_e1 chaplygin_e2 chaplygin_n spin_about_normal" },
  { BALL, SPHERE, TABLE .. ", normal = {1, 0, 5}", "jellett chaplygin_e1 chaplygin_e2 chaplygin_n spin_about_normal" },
  { BALL, ASIDE, ROLL, "jellett routh" }, { TOP, EGG, SMOOTH, "momentum_about_normal momentum_about_axis" },
  { TOP, STONE, SMOOTH, "momentum_about_normal" }, { BOXY, STONE, SMOOTH, "momentum_about_normal" },
  { TOP, LOW, SOFT, "" },
}

-- Unit quaternions: four numbers over a fifth.
local units = { { 40, 8, -4, 1, 41 }, { 24, -3, 6, 2, 25 }, { 8, -1, 0, 4, 9 } }

-- The largest rate of a law at three states, as a part of its terms.
local function rate(job, law)
  local env = selftest.environment(job.model, {}, job.held)
  local worst = 0.0
  for n, q in ipairs(units) do
    local x = {}
    for i, s in ipairs(job.states) do
      x[s.name] = s.kind == "attitude" and R.new(q[s.place], q[5]) or R.new(5 * i - 11 * n, 16)
    end
    x.t = R.new(n, 8)
    local at, f = {}, quantities.rhs(job.equations)
    for name, value in pairs(x) do at[name] = value end -- into a table: order is lost
    local place = {}
    for i, s in ipairs(job.states) do place[s.name] = i end
    local rates = selftest.expect(f, env, at, function(o) return place[o.state] end, R.one)
    local sum = evaluate.precise(calculus.diff(law.e, state.t), x, 300)
    local size = R.abs(sum) + R.abs(evaluate.precise(law.e, x, 300)) -- times 1 rad/s
    for i, s in ipairs(job.states) do
      local term = evaluate.precise(calculus.diff(law.e, s.sym), x, 300) * rates[i]
      sum, size = sum + term, size + R.abs(term)
    end
    local part = R.sign(size) > 0 and R.todouble(R.abs(sum) / size) or 0.0
    worst = math.max(worst, part)
  end
  return worst
end

for _, case in ipairs(cases) do
  local text = string.format([[
return scene { name = "b", body = %s, effects = { effect.plane { surface = %s, %s } },
  initial = { omega = {1, 2, 3}, position = {%s} } }
]], case[1], case[2], case[3], case[3]:find("normal", 1, true) and "1, 0, \"-1/5\"" or "1, 0, 0") -- in the plane
  local job = scene.plan(assert(scene.read(text)))
  local claimed, what = {}, case[2]:match "contact.%w+" .. ", " .. case[3]
  for _, law in ipairs(touch_laws.all(job.model)) do
    if law.holds then claimed[#claimed + 1] = law.key end
    local worst = rate(job, law)
    -- the equations' values are right to 200 bits
    if law.holds then
      tap.ok(worst < 1e-55, what .. ": " .. law.key .. " is conserved", string.format("%.2g", worst))
    elseif not (law.key:find "^chaplygin" and case[3] == SOFT) then
      tap.ok(worst > 1e-6, what .. ": " .. law.key .. " is not, and varies", string.format("%.2g", worst))
    end
  end
  tap.is(table.concat(claimed, " "), case[4], what .. ": the laws that are claimed")
end

---- critical speeds -------------------------------------------------------------------------------------

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function output(arguments)
  local status = program.shell(string.format("%s %s >%s/out 2>%s/err", binary, arguments, dir, dir))
  return status == 0 and program.read(dir .. "/out") or nil, program.read(dir .. "/err")
end

local function values(text)
  program.write(dir .. "/s.lua", text)
  return json.read(assert(output("explain " .. dir .. "/s.lua --format json"))).values
end

-- The largest sine of the tilt on the way, of an axis that is upright (or, of a disc, level) at the start but for TILT.
local function grown(text, until_, level)
  program.write(dir .. "/s.lua", text)
  local out = assert(output(string.format("run %s/s.lua --until %g --every %g --columns qw,qx,qy,qz", dir, until_,
    until_ / 200)))
  local most = 0.0
  for line in out:gmatch "[^\n]+" do
    local w, x, y, z = line:match "^([^,]+),([^,]+),([^,]+),([^,]+)"
    w, x, y, z = tonumber(w), tonumber(x), tonumber(y), tonumber(z)
    if z then
      local c = w * w - x * x - y * y + z * z
      most = math.max(most, level and math.abs(c) or 2 * math.sqrt((w * x + y * z) ^ 2 + (w * y - x * z) ^ 2))
    end
  end
  return most
end

local TILT = 1e-6
-- A tenth above the critical rate 1.1^2 - 1 = 0.21 of the torque that upsets it is left to bring it back: swings of
-- some ten disturbances.  A tenth below, the least growth here is e^4 of them.
local STABLE = 15
local function upright(surface, law, spin, down)
  return string.format([[
return scene { name = "b", body = tensor { mass = 0.006, xx = 8e-7, yy = 8e-7, zz = 7e-7 },
  effects = { effect.plane { surface = %s, %s } },
  initial = { omega = {0, 0, %.17g}, attitude = { axis = "x", angle = quantity(%.17g, "rad") } } }
]], surface, law, spin, (down and math.pi or 0) + TILT)
end

local ROUND = "contact.sphere { r = 0.015, at = {0, 0, 0.003} }"
-- surface, law, which end, the key, seconds
for _, case in ipairs {
  { ROUND, SMOOTH, true, "upright_z_down_above", 2 }, { ROUND, ROLL, true, "upright_z_down_above", 2 },
  { ROUND, "law = \"sliding\", friction = { viscous = 1 }", true, "upright_z_down_above", 20 },
  { ROUND, "law = \"sliding\", friction = { viscous = 1 }", false, "upright_z_up_below", 20 },
  { "contact.ellipsoid { a = 0.012, b = 0.012, c = 0.02 }", ROLL, false, "upright_z_up_above", 2 },
  { "contact.ellipsoid { a = 0.012, b = 0.012, c = 0.02 }", "law = \"sliding\", friction = { viscous = 1 }", true,
    "upright_z_down_above", 8 },
  { "contact.paraboloid { a = 0.01, b = 0.01, at = {0, 0, -0.014} }", SMOOTH, false, "upright_z_up_above", 2 },
} do
  local critical = values(upright(case[1], case[2], 1, case[3]))[case[4]].value
  local below = grown(upright(case[1], case[2], 0.9 * critical, case[3]), case[5])
  local above = grown(upright(case[1], case[2], 1.1 * critical, case[3]), case[5])
  if case[4]:find "below$" then below, above = above, below end
  tap.ok(below > 30 * TILT and above < STABLE * TILT, string.format("%s, %s: %s is %.6g rad/s",
    case[1]:match "contact.%w+", case[2], case[4], critical), string.format("grown by %.3g and %.3g", below / TILT,
    above / TILT))
end

local function disc(edge, angle, omega)
  return string.format([[
return scene { name = "b", body = solid.cylinder { r = 0.1, h = 0.01, mass = 1 },
  effects = { effect.plane { surface = contact.disc { r = 0.1, edge = %g } } },
  initial = { omega = {0, %.17g, %.17g}, attitude = { axis = "x", angle = quantity(%.17g, "rad") } } }
]], edge, omega[1], omega[2], angle)
end

for _, edge in ipairs { 0, 0.03 } do
  local v = values(disc(edge, math.pi / 2, { 0, 1 }))
  for k, key in ipairs { "spinning_on_edge_above", "rolling_straight_above" } do
    local found = {}
    for i, factor in ipairs { 0.9, 1.1 } do
      local omega = { 0, 0 }
      omega[k] = factor * v[key].value
      found[i] = grown(disc(edge, math.pi / 2 + TILT, omega), 2, true)
    end
    tap.ok(found[1] > 30 * TILT and found[2] < STABLE * TILT, string.format("a disc, edge %g: %s is %.6g rad/s", edge,
      key, v[key].value), string.format("grown by %.3g and %.3g", found[1] / TILT, found[2] / TILT))
  end
end

for n = 1, 2 do
  local angle, w3 = 1.1, 12
  local p = values(disc(0, angle, { 0, w3 }))["steady_precession_" .. n].value
  local text = disc(0, angle, { p * math.sin(angle), w3 })
  -- 17 digits of the start, and a hundred radians of a motion that is stable or not, for a second
  tap.ok(math.abs(grown(text, 1, true) - math.cos(angle)) < 1e-9, string.format("steady rolling %d: %.6g rad/s", n, p),
    string.format("%.17g", grown(text, 1, true) - math.cos(angle)))
end

tap.done()
