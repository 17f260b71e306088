#!/usr/bin/env lua5.4
-- surfaces.t - a body on a plane: paraboloids and support functions, resistance to spinning and rolling.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracles: the same surface written in two ways moves the same; the library, which differentiates a support function by
-- its own rules (src/cli/engine/jet.c); balls, whose resistance has a solution in closed form; energy.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function run(arguments)
  return program.shell(string.format("timeout 60 %s %s >%s/out 2>%s/err", binary, arguments, dir, dir))
end

-- The rows of a run as lists of numbers, after the line of names.
local function rows(text, options)
  program.write(dir .. "/s.lua", text)
  local status = run("run " .. dir .. "/s.lua " .. options)
  if status ~= 0 then return nil, program.read(dir .. "/err") end
  local list = {}
  for line in program.read(dir .. "/out"):gmatch "[^\n]+" do
    local row = {}
    for x in line:gmatch "[^,]+" do row[#row + 1] = tonumber(x) end
    if #row > 1 then list[#list + 1] = row end
  end
  return list
end

local engines = { general = "--engine general --tolerance 1e-14", generated = "--engine generated --method taylor " ..
  "--tolerance 1e-14" }
local names = { "general", "generated" }

---- one surface in two ways ----------------------------------------------------------------------------

local function stone(surface, more)
  local angle = surface:find("disc", 1, true) and 1.2 or surface:find("sqrt(n[1]^2 + n[2]^2)", 1, true) and 1.2 or 0.15
  return string.format([[
return scene { name = "stone", body = solid.ellipsoid { a = 0.1, b = 0.03, c = 0.02, mass = 0.7 },
  effects = { effect.plane { surface = %s, %s } },
  initial = { omega = {0.1, -0.4, 4}, attitude = { axis = {1, 0.3, 0}, angle = %g }, position = {0.3, -0.2, %s} } }
]], surface, more, angle, more:find("{0.1, 0, 1}", 1, true) and "-0.03" or "0") -- in the plane
end

local placing = "at = {0.001, 0, 0.002}, turned = { axis = {0.1, 0, 1}, angle = 0.2 }"
local pairs_of = {
  { "an ellipsoid", "contact.ellipsoid { a = 0.1, b = 0.03, c = 0.02, " .. placing .. " }",
    "contact.support { h = function(n) return sqrt((n[1]/10)^2 + (0.03*n[2])^2 + (n[3]/50)^2) end, " .. placing ..
    " }" },
  { "an ellipsoid, h right for n.n = 1 only", "contact.ellipsoid { a = 0.1, b = 0.03, c = 0.02, " .. placing .. " }",
    "contact.support { h = function(n) return sqrt((n[1]/10)^2 + (0.03*n[2])^2 + (n[3]/50)^2)*" ..
    "(n[1]^2 + n[2]^2 + n[3]^2)^2 + 1 - n[1]^2 - n[2]^2 - n[3]^2 end, " .. placing .. " }" },
  { "a paraboloid", "contact.paraboloid { a = 0.4, b = 0.05, at = {0.002, 0, -0.02}, turned = { axis = {0, 0.1, 1}, " ..
    "angle = 0.3 } }", "contact.support { h = function(n) return (n[1]^2*0.2 + n[2]^2/40)/abs(n[3]) end, " ..
    "at = {0.002, 0, -0.02}, turned = { axis = {0, 0.1, 1}, angle = 0.3 } }", -- no series of |n3|
    generated = "--engine generated --method adaptive --tolerance 1e-13" },
  { "a sphere", "contact.sphere { r = 0.1, at = {0, 0, 0.05} }",
    "contact.support { h = function(n) return 0.1 + n[3]*0.05 end }" },
  { "a disc with a round edge", "contact.disc { r = 0.1, edge = 0.01 }",
    "contact.support { h = function(n) return 0.1*sqrt(n[1]^2 + n[2]^2) + 0.01 end }" },
}
local laws = { "law = \"rolling\"", "law = \"rolling\", turntable = 0.7",
  "law = \"sliding\", friction = { coulomb = 0.3, smoothing = 0.01 }, spinning = { viscous = 0.002 }, " ..
  "rolling_resistance = { coulomb = 0.003, smoothing = 0.2 }", "law = \"smooth\"",
  "law = \"rolling\", normal = {0.1, 0, 1}, spinning = { coulomb = 0.002, smoothing = 0.1 }, " ..
  "rolling_resistance = { viscous = 0.001 }" }

-- Two motions at a tolerance of 1e-14 a step, over some 100 steps of a motion whose errors grow by 10 at most.
local bar = 1e-11
for n, pair in ipairs(pairs_of) do
  local law = laws[#laws + 1 - n]
  local got = {}
  for i = 2, 3 do
    for _, engine in ipairs(names) do
      local list, why = rows(stone(pair[i], law), "--until 0.5 --every 0.5 " .. (pair[engine] or engines[engine]))
      if not list then tap.ok(false, pair[1] .. ", " .. engine, why) end
      got[#got + 1] = list and list[#list] or nil
    end
  end
  local worst = 0.0
  for i = 2, #got do
    for k = 1, 8 do worst = math.max(worst, math.abs(got[i][k] - got[1][k]) / math.max(1, math.abs(got[1][k]))) end
  end
  tap.ok(#got == 4 and #got[1] > 8 and worst < bar, pair[1] .. " in two ways and by two roads moves the same, " .. law,
    string.format("%.2g", worst))
end

-- Two roads for a surface that is none of the others: of constant width, h(n) + h(-n) = 0.2.
local wide = "contact.support { h = function(n) return 0.1 + 0.004*n[3]*(n[3]^2 - 3*n[1]^2) end }"
program.write(dir .. "/s.lua", stone(wide, laws[5]))
tap.is(run("check " .. dir .. "/s.lua"), 0, "check of a body of constant width", program.read(dir .. "/out"))
program.write(dir .. "/s.lua", stone(pairs_of[3][2], laws[3]))
tap.is(run("check " .. dir .. "/s.lua"), 0, "check of a paraboloid that slides", program.read(dir .. "/out"))

-- Nothing but the support function says how large the body is.  The library must not measure the error of v1 by v1
-- alone, which passes 0 on the way: it took steps without end.
program.write(dir .. "/s.lua", [[
return scene { name = "wide", body = solid.box { x = 0.913, y = 2.13, z = 2.79, mass = 2.97 },
  effects = { effect.plane { surface = contact.support { h = function(n)
    return 1.94 + 0.05*n[3]*(n[3]^2 - 3*n[1]^2) end }, law = "sliding", friction = { coulomb = 0.12,
    smoothing = 0.275 }, spinning = { viscous = 0.0148 }, rolling_resistance = { coulomb = 0.0164, smoothing = 0.207 },
    normal = {0.1, -0.2, 1} } },
  initial = { omega = {0.7, -0.3, 0.9}, attitude = {3, 0.6, -0.7, 0.3} } }
]])
tap.is(run("check --real double --states 10 " .. dir .. "/s.lua"), 0, "check of a velocity that passes 0")

-- Rolling without resistance keeps the energy; the tolerance of 1e-14 a step, some 100 steps.
for _, surface in ipairs { wide, pairs_of[3][2] } do
  local list = rows(stone(surface, laws[1]), "--until 1 --every 1 --columns t,energy " .. engines.generated)
  tap.ok(list and math.abs(list[#list][2] / list[1][2] - 1) < 1e-12, "energy of " .. surface:match "contact.%w+",
    list and string.format("%.17g %.17g", list[1][2], list[#list][2]))
end

---- beside other effects -------------------------------------------------------------------------------

-- One effect takes L, which rolling computes as well; another one has states by the names that the contact defines.
for _, case in ipairs {
  { "L is computed twice", "effect.damping { rate = 0.3 }" },
  { "states called spin and up_x", "effect.custom { states = { spin = { initial = 1, unit = \"rad\", rate = " ..
    "function(s) return s.w[1] end }, up_x = { initial = 1, unit = \"rad\", rate = function(s) return s.w[1] + " ..
    "quantity(1, \"1/s\")*s.spin end } }, torque = function(s) return {-0.1*s.spin*quantity(1, \"N m\"), 0, 0} end }" },
} do
  program.write(dir .. "/s.lua", "return scene { name = \"s\", body = solid.box { x = 1, y = 2, z = 3, mass = 3 },\n" ..
    "effects = { effect.plane { surface = contact.sphere { r = 2, at = {0.1, 0, 0.2} }, spinning = { viscous = 0.1 " ..
    "} },\n" .. case[2] .. " }, initial = { omega = {0.7, -0.3, 0.9}, attitude = {1, 0.2, -0.3, 0.4} } }\n")
  tap.is(run("check --real double --states 10 " .. dir .. "/s.lua"), 0, case[1], program.read(dir .. "/out"))
end

---- resistance of balls --------------------------------------------------------------------------------

local m, r, g = 0.5, 0.1, 9.80665
local I = 0.4 * m * r * r

local function ball(arguments, omega)
  return string.format([[
return scene { name = "ball", body = solid.sphere { r = %g, mass = %g },
  effects = { effect.plane { surface = contact.sphere { r = %g }, %s } }, initial = { omega = %s } }
]], r, m, r, arguments, omega)
end

-- Some hundred steps at 1e-14.
local function near(got, want, what)
  tap.ok(tonumber(got) and math.abs(got - want) <= 1e-12 * math.abs(want), what,
    string.format("%s for %.17g", got, want))
end

for _, engine in ipairs(names) do
  local last = { engines[engine], engine }
  local function at_end(arguments, omega, column)
    local list, why = rows(ball(arguments, omega), "--until 2 --every 2 --columns t," .. column .. " " .. last[1])
    return list and list[#list][2] or why
  end
  local function said(what) return what .. ", " .. engine end
  -- I w' = -c m g w
  near(at_end("law = \"rolling\", spinning = { viscous = 0.001 }", "{0, 0, 30}", "wz"),
    30 * math.exp(-0.001 * m * g * 2 / I), said "a ball that spins on the spot")
  -- towards the rate of the turntable that it stands in the middle of
  near(at_end("law = \"rolling\", turntable = 3, spinning = { viscous = 0.001 }", "{0, 0, 0}", "wz"),
    3 - 3 * math.exp(-0.001 * m * g * 2 / I), said "a turntable takes it along")
  -- (I + m r^2) w' = -d m g w about the contact point
  near(at_end("law = \"rolling\", rolling_resistance = { viscous = 0.001 }", "{0, 10, 0}", "wy"),
    10 * math.exp(-0.001 * m * g * 2 / (I + m * r * r)), said "a ball that rolls")
  near(at_end("law = \"rolling\", rolling_resistance = { viscous = 0.001 }", "{0, 10, 0}", "p1"),
    r * 10 * (1 - math.exp(-0.001 * m * g * 2 / (I + m * r * r))) / (0.001 * m * g / (I + m * r * r)),
    said "how far it rolls")
  -- sqrt(w^2 + e^2) - e asinh(e/w) falls at the rate a m g/I
  local function fallen(w, e)
    local x = e / w
    return math.sqrt(w * w + e * e) - e * math.log(x + math.sqrt(x * x + 1))
  end
  local w = at_end("law = \"rolling\", spinning = { coulomb = 0.001, smoothing = 0.5 }", "{0, 0, 30}", "wz")
  near(tonumber(w) and fallen(w, 0.5), fallen(30, 0.5) - 0.001 * m * g * 2 / I, said "dry resistance to spinning")
  w = at_end("law = \"rolling\", rolling_resistance = { coulomb = 0.001, smoothing = 0.5 }", "{0, 20, 0}", "wy")
  near(tonumber(w) and fallen(w, 0.5), fallen(20, 0.5) - 0.001 * m * g * 2 / (I + m * r * r),
    said "dry resistance to rolling")
  -- what slides is turned by the resistance alone where friction is 0
  near(at_end("law = \"sliding\", friction = { viscous = 0 }, rolling_resistance = { viscous = 0.001 }", "{0, 10, 0}",
    "wy"), 10 * math.exp(-0.001 * m * g * 2 / I), said "a ball that slides without friction")
end

---- what cannot be -------------------------------------------------------------------------------------

for _, case in ipairs {
  { "surface = contact.paraboloid { a = 0.1, b = -1 }", "b must be positive, got -1" },
  { "surface = contact.paraboloid { a = 0.1, b = 1, h = 2 }", "unknown argument \"h\"" },
  { "surface = contact.support { at = {0, 0, 0} }", "h must be a function of the outward normal" },
  { "surface = contact.support { h = 0.1 }", "h must be a function of the outward normal" },
  { "surface = contact.support { h = function(n) return 0.1 end, r = 1 }", "unknown argument \"r\" (it has at, h)" },
  { "surface = contact.support { h = function(n) return quantity(1, \"kg\") end }", "h must be in m" },
  { "surface = contact.support { h = function(n) return t end }", "on the normal and on parameters only, got t" },
  { "surface = contact.support { h = function(n) return 0.1 + 0.001*wx end }", "on the normal and on parameters only" },
  { "surface = contact.support { h = function(n) return 0.1 - sqrt(n[1]^2 + n[3]^2/4) end }",
    "h must belong to a convex surface" },
  { "surface = contact.support { h = function(n) return log(-1 - n[1]^2) end }", "h has no value" },
  { "surface = contact.support { h = function(n) return 0.1 + n[3]^2*sqrt(n[3])/1000 end }",
    "must have a value for the normal" },
  { "surface = contact.paraboloid { a = 0.1, b = 0.1, turned = { axis = {1, 0, 0}, angle = 3 } }",
    "its open side faces the plane" },
  { "surface = contact.sphere { r = 1 }, law = \"smooth\", spinning = { viscous = 1 }", "spinning needs law" },
  { "surface = contact.sphere { r = 1 }, spinning = { viscous = -1 }", "viscous must not be negative" },
  { "surface = contact.sphere { r = 1 }, rolling_resistance = { coulomb = 1 }", "smoothing is missing" },
  { "surface = contact.sphere { r = 1 }, rolling_resistance = { coulomb = 1, smoothing = 0 }",
    "smoothing must be positive" },
  { "surface = contact.sphere { r = 1 }, spinning = 1", "takes a table of named arguments" },
} do
  program.write(dir .. "/s.lua", string.format("return scene { name = \"s\", body = solid.sphere { r = 1, " ..
    "mass = 1 },\neffects = { effect.plane { %s } } }\n", case[1]))
  local status = run("gen " .. dir .. "/s.lua -o " .. dir .. "/gen")
  local text = program.read(dir .. "/err")
  tap.ok(status == 1 and text:find("s.lua:2: ", 1, true) and text:find(case[2], 1, true), case[2], text)
end

tap.done()
