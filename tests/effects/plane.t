#!/usr/bin/env lua5.4
-- plane.t - bodies on a plane: the emitted Taylor series against reference tables of 32 digits, through scenes as users
-- write them; the reaction, where contact is lost; what cannot be, answered.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracle: tests/reference/plane.h (README there).  tests/runtime/plane.c holds the library to the same rows; `polhode
-- check` of the scenes in bodies/ compares the two.  Bars: 1e-11, or 20 times what the inputs' rounding moves.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local tier = require "tests.tier"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

-- The rows of the header, as tables: C's braces are Lua's.
local LAWS = { PH_ROLLING = "rolling", PH_SMOOTH = "smooth", PH_VISCOUS = "sliding", PH_COULOMB = "sliding" }
local text = program.read "tests/reference/plane.h":match "plane_rows%[%] = {\n(.*)\n};"
text = text:gsub("%.(%a[%w_]* =)", "%1"):gsub("(%d)L%f[%W]", "%1"):gsub("PH_%u+", function(law)
  return '"' .. law .. '"'
end)
local rows = assert(load("return {" .. text .. "}"))()

local function list(v)
  local out = {}
  for i, x in ipairs(v) do out[i] = string.format("%.17g", x) end
  return "{ " .. table.concat(out, ", ") .. " }"
end

local function surface(p)
  local at = ", at = " .. list(p.centre)
  if p.half_axes[1] == 0 then return string.format("contact.sphere { r = %.17g%s }", p.rim, at) end
  if p.half_axes[3] == 0 then
    return string.format("contact.disc { r = %.17g, edge = %.17g%s }", p.half_axes[1], p.rim, at)
  end
  return string.format("contact.ellipsoid { a = %.17g, b = %.17g, c = %.17g%s, turned = { quaternion = %s } }",
    p.half_axes[1], p.half_axes[2], p.half_axes[3], at, list(p.axes))
end

local function scene_of(row)
  local I, p = row[3], row[4]
  local law = LAWS[p.law]
  local friction = p.law == "PH_VISCOUS" and string.format(", friction = { viscous = %.17g }", p.friction) or
    p.law == "PH_COULOMB" and string.format(", friction = { coulomb = %.17g, smoothing = %.17g }", p.friction,
      p.smoothing) or ""
  local turns = p.rate ~= 0 and string.format(", turntable = %.17g", p.rate) or ""
  local damped = row[9] ~= 0 and string.format(", effect.damping { c = %.17g }", row[9]) or ""
  return string.format([[
return scene { name = "body",
  body = tensor { mass = %.17g, xx = %.17g, yy = %.17g, zz = %.17g, xy = %.17g, xz = %.17g, yz = %.17g },
  effects = { effect.plane { surface = %s, law = "%s"%s, normal = %s%s, gravity = %s }%s },
  initial = { omega = %s, attitude = %s, position = %s%s }, time = { step = 0.0005 } }
]], row[2], I[1], I[2], I[3], I[4], I[5], I[6], surface(p), law, friction, list(p.normal), turns, list(p.gravity),
    damped, list(row[6]), list(row[5]), list(row[7]), law ~= "rolling" and ", velocity = " .. list(row[8]) or "")
end

local function largest(a, b, sign)
  local d = 0
  for i = 1, #b do d = math.max(d, math.abs((sign or 1) * a[i] - b[i])) end
  return d
end

local cases = {}
for _, row in ipairs(rows) do
  local last = cases[#cases]
  if not last or last[1][1] ~= row[1] then
    last = {}
    cases[#cases + 1] = last
  end
  last[#last + 1] = row
end

for n = 1, #cases, tier.quick and 6 or 1 do
  local case = cases[n]
  local times = {}
  for i, row in ipairs(case) do times[i] = string.format("%.17g", row[10]) end
  program.write(dir .. "/body.lua", scene_of(case[1]))
  local code = program.shell(string.format("%s run %s/body.lua --engine generated --method taylor --tolerance 1e-15 " ..
    "--columns q,w,com,com_velocity,N --at %s -o %s/out.csv 2>%s/said", binary, dir, table.concat(times, ","), dir,
    dir))
  if not tap.is(code, 0, case[1][1] .. ": runs") then tap.diag(program.read(dir .. "/said")) end
  local worst, k = 0, 0
  for line in (program.read(dir .. "/out.csv") or ""):gmatch "[^\n]+" do
    local x = {}
    for word in line:gmatch "[^,]+" do x[#x + 1] = tonumber(word) end
    local row = #x == 14 and case[k + 1]
    if row then
      k = k + 1
      local q, w, com, v = row[11], row[12], row[13], row[14]
      local sign = x[1] * q[1] + x[2] * q[2] + x[3] * q[3] + x[4] * q[4] < 0 and -1 or 1
      local rate = math.sqrt(w[1] ^ 2 + w[2] ^ 2 + w[3] ^ 2)
      local function bar(sensitivity) return math.max(1e-11, 20 * sensitivity) end
      for _, ratio in ipairs { largest(x, q, sign) / bar(row[16]),
        largest({ x[5], x[6], x[7] }, w) / rate / bar(row[17]), largest({ x[8], x[9], x[10] }, com) / bar(row[18]),
        largest({ x[11], x[12], x[13] }, v) / bar(row[19]), math.abs(x[14] / row[15] - 1) / bar(row[20]) } do
        worst = ratio > worst and ratio or worst == worst and ratio == ratio and worst or 0 / 0
      end
    end
  end
  tap.ok(k == #case and worst <= 1, string.format("%s: attitude, rates, place, velocity and reaction at %d times",
    case[1][1], #case), worst)
end

-- the instant at which contact is lost, plane.json
for _, row in ipairs(rows) do
  if row[1] == "contact_lost_smooth" then program.write(dir .. "/body.lua", scene_of(row)) end
end
for _, engine in ipairs { "general", "generated --method taylor --tolerance 1e-15" } do
  program.shell(string.format("%s run %s/body.lua --engine %s --until 0.1 --columns t,N >%s/out.csv 2>&1", binary, dir,
    engine, dir))
  local t, N = (program.read(dir .. "/out.csv") or ""):match "contact_lost,([%d.e-]+),([%d.e-]+)"
  -- a hundred roundings of t; of a run by tolerance 1e-15
  tap.ok(t and math.abs(tonumber(t) - 0.026123754109169372568) < 1e-14,
    "contact is lost where N = 0, and the run ends: " .. engine, t)
  tap.ok(N and math.abs(tonumber(N)) < 1e-9, "N is 0 there", N)
end

-- ---- what cannot be ----

local function refused(what, effects, want, more)
  program.write(dir .. "/bad.lua", string.format([[
return scene { name = "bad", body = solid.box { x = 1, y = 1, z = 1, mass = 1 }, %s
  effects = { %s }, initial = { omega = { 1, 2, 3 } } }
]], more or "", effects))
  local code = program.shell(string.format("%s explain %s/bad.lua >%s/said 2>&1", binary, dir, dir))
  local said = program.read(dir .. "/said") or ""
  tap.ok(code == 1 and said:find("bad.lua:[12]") and said:find(want, 1, true), what, said)
end
local SPHERE = "surface = contact.sphere { r = 1 }"
refused("a radius that is none", "effect.plane { surface = contact.sphere { r = -1 } }", "r must be positive, got -1")
refused("no surface", "effect.plane {}", "surface is missing")
refused("a surface that is none", "effect.plane { surface = 3 }", "surface must be a contact")
refused("an unknown surface", "effect.plane { surface = contact.cone {} }", "has no \"cone\"")
refused("an unknown law", "effect.plane { " .. SPHERE .. ", law = \"gliding\" }", "law must be")
refused("sliding without friction", "effect.plane { " .. SPHERE .. ", law = \"sliding\" }", "needs friction")
refused("friction without sliding", "effect.plane { " .. SPHERE .. ", friction = { viscous = 1 } }", "needs law")
refused("negative friction", "effect.plane { " .. SPHERE .. ", law = \"sliding\", friction = { viscous = -1 } }",
  "must not be negative")
refused("Coulomb's without smoothing", "effect.plane { " .. SPHERE ..
  ", law = \"sliding\", friction = { coulomb = 1 } }",
  "smoothing is missing")
refused("no normal", "effect.plane { " .. SPHERE .. ", normal = { 0, 0, 0 } }", "normal must not be zero")
refused("a smooth plane that turns", "effect.plane { " .. SPHERE .. ", law = \"smooth\", turntable = 1 }", "no effect")
refused("gravity twice", "effect.plane { " .. SPHERE .. " }, effect.gravity {}", "effect.gravity")
refused("two planes", "effect.plane { " .. SPHERE .. " }, effect.plane { " .. SPHERE .. " }", "given twice")
refused("a wheel beside it", "effect.plane { " .. SPHERE ..
  " }, effect.wheel { axis = { 0, 0, 1 }, inertia = 0.1, included = false }", "effect.plane")
refused("a body that flies", "effect.plane { " .. SPHERE .. " }, effect.translation {}", "effect.plane")
refused("a force of the scene's own", "effect.plane { " .. SPHERE .. " }, effect.custom { force = function(s) " ..
  "return { quantity(1, \"N\"), 0, 0 } end }", "effect.custom: cannot be together with effect.plane")
refused("a torque that depends on the place", "effect.plane { " .. SPHERE .. " }, effect.torque { body = " ..
  "{ quantity(1, \"N\")*rx, 0, 0 } }", "effect.torque: depends on rx, which a body on a plane (line 2) does not have")
refused("an origin elsewhere", "effect.plane { " .. SPHERE .. " }", "must be the centroid", "origin = \"corner\",")
for _, method in ipairs { "semi", "midpoint", "split2" } do
  local code = program.shell(string.format("%s gen rolling_coin --method %s -o %s/none >%s/said 2>&1", binary, method,
    dir, dir))
  tap.ok(code == 1 and (program.read(dir .. "/said") or ""):find("touches a plane", 1, true), method .. " is refused")
end

program.finish()
tap.done()
