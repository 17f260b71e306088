#!/usr/bin/env lua5.4
-- fmu.t - units for co-simulation: valid by the standards' schemas, and right when an importing tool drives them.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Expected motion comes from the general library (polhode run --engine general), which shares no formula's code with
-- the unit.  Schemas: see fmu.lua.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local fmu = require "tests.target.fmu"

local x86 = fmu.must("uname -sm"):find "^Linux x86_64"

if not x86 then
  tap.skip("units with a binary for this machine", "the test knows Linux on x86-64")
  tap.done()
end

tap.is(#fmu.functions[2] .. " " .. #fmu.functions[3], "44 75", "44 functions in FMI 2.0, 75 in 3.0")

-- All outputs of the unit after steps of `size` up to `at` = `size` times `count`, against the general library's.  Each
-- kind of quantity is judged by its length: components of a vector that happen to be zero have no digits.
local kinds = { qw = "q", qx = "q", qy = "q", qz = "q" }
for _, kind in ipairs { "w", "r", "v", "L" } do
  for _, c in ipairs { "x", "y", "z" } do kinds[kind .. c] = kind end
end
local function follows(unit, tag, want, setup, size, count, tolerance, why)
  local commands = { "new 0 TOKEN 0" }
  for _, c in ipairs(setup) do commands[#commands + 1] = c end
  commands[#commands + 1] = "start 0 0 -"
  commands[#commands + 1] = "ready 0"
  for i = 0, count - 1 do commands[#commands + 1] = string.format("step 0 %.17g %.17g", i * size, size) end
  local names = {}
  for _, a in ipairs(unit.variables) do
    if a.causality == "output" and a.name ~= "jacobi_integral" then names[#names + 1] = a.name end
  end
  commands[#commands + 1] = "get 0 $" .. table.concat(names, " $")
  local answers = fmu.drive(unit, commands)
  local values, lengths, worst, where, refused = answers[#answers], {}, 0, "", ""
  for i, a in ipairs(answers) do
    if a.status ~= 0 then refused = refused .. commands[i] .. ": " .. a.log .. "\n" end
  end
  tap.is(refused, "", tag .. ": nothing is refused")
  for _, name in ipairs(names) do
    local kind = kinds[name] or name
    lengths[kind] = math.max(lengths[kind] or 0, math.abs(want[name] or 0))
  end
  for i, name in ipairs(names) do
    local length = lengths[kinds[name] or name]
    local off = math.abs(values[i] - (want[name] or math.huge)) / (length > 0 and length or 1)
    if off ~= off then off = math.huge end
    if off > worst then worst, where = off, name end
  end
  tap.near(worst, 0, 0, tolerance, string.format("%s: after %g s every output is the general library's", tag,
    size * count), why .. "; worst is " .. where)
  return answers
end

-- ---- six scenes ----

local rk4 = "ten times the measured error of the Runge-Kutta method with the scene's step; or rounding, if more"
local scenes = { { "heavy_top", 0.01, 20, 1e-6 }, { "dropped_stone", 0.25, 8, 1e-13 }, { "ring", 60, 10, 1e-13 },
  { "gyroscope", 0.01, 20, 2e-7 }, { "thrown_book", 0.05, 10, 1e-10 }, { "wheels", 0.5, 8, 1e-13 } }
local ring = program.directory() .. "/ring.lua"
program.write(ring, [[
local r = param("radius", 7000, "km")
return scene {
  name = "ring",
  body = solid.box { x = 0.4, y = 0.3, z = 0.2, mass = 50 },
  effects = { effect.gravity_gradient { mu = quantity(3.986004418e14, "m^3/s^2"), orbit = { radius = r } } },
  initial = { omega = { 1e-5, 0, 1.1e-3 } },
  time = { horizon = 6000, step = 1 },
}
]])
local units = {}
for _, s in ipairs(scenes) do
  local name = s[1]
  local scene = name == "ring" and ring or "bodies/" .. name .. ".lua"
  local options = { gyroscope = "--with jacobians", ring = "--with jacobians", heavy_top = "--method rk4" }
  units[name] = assert(fmu.make(scene, options[name]))
  local want = fmu.general(scene, string.format("%.17g", s[2] * s[3]))
  for version = 2, 3 do
    local unit, tag = units[name][version], name .. ", FMI " .. version
    fmu.valid(unit, tag)
    fmu.consistent(unit, tag)
    tap.is(fmu.exported(unit.binary), table.concat(fmu.functions[version], " "), tag ..
      ": the binary exports the standard's functions and nothing else")
    local platform = version == 2 and "linux64" or "x86_64-linux"
    local files = "modelDescription.xml binaries/" .. platform .. "/" .. name .. ".so"
    for _, tail in ipairs { ".h", ".c", "_unit.h", "_unit.c", "_fmi" .. version .. ".h", "_fmi" .. version .. ".c" } do
      files = files .. " sources/" .. name .. tail
    end
    tap.is(table.concat(unit.list, " "), files .. (version == 3 and " sources/buildDescription.xml" or ""), tag ..
      ": its files")
    follows(unit, tag, want, {}, s[2], s[3], s[4], rk4)
  end
end

-- ---- parameters and inputs: a held input is a constant torque of the general library ----

local top = units.gyroscope
local held = program.directory() .. "/gyroscope.lua"
program.write(held, (program.read "bodies/gyroscope.lua":gsub("effect%.control{}",
  "effect.torque { body = {0.002, 0, 0.01} }")))
for version = 2, 3 do
  follows(top[version], "gyroscope with a torque and another rim, FMI " .. version,
    fmu.general(held, "0.1", "--set rim_in=28"),
    { "set 0 $rim_in 0.028", "set 0 $ux 0.002", "set 0 $uz 0.01" }, 0.02, 5, 2e-7, rk4)
end

-- ---- time, bits, states, instances ----

-- The lines of numbers as text, every bit of them.
local function bits(answers, from, to)
  local out = {}
  for i = from or 1, to or #answers do
    for _, x in ipairs(answers[i]) do out[#out + 1] = string.format("%a", x) end
  end
  return table.concat(out, " ")
end

local state = "$time $qw $qx $qy $qz $wx $wy $wz $energy $Lx $Ly $Lz"
for version = 2, 3 do
  local unit, tag = top[version], "FMI " .. version .. ": "
  local function ask(...) return fmu.drive(unit, { "new 0 TOKEN 0", ... }) end
  local one = ask("set 0 $ux 0.001", "start 0 0 -", "ready 0", "step 0 0 0.01", "get 0 " .. state)
  local two = ask("set 0 $ux 0.001", "start 0 0 -", "ready 0", "step 0 0 0.004", "step 0 0.004 0.006",
    "get 0 " .. state)
  tap.is(bits(two, 7), bits(one, 6), tag .. "two communication steps of whole inner steps are one, to the bit")
  local odd = { "start 0 0 -", "ready 0" }
  for i = 0, 19 do odd[#odd + 1] = string.format("step 0 %.17g 0.00033", i * 0.00033) end
  odd[#odd + 1] = "get 0 $time $qw $qx $qy $qz"
  local uneven = ask(table.unpack(odd))
  local want = fmu.general("bodies/gyroscope.lua", "0.0066")
  local worst = 0
  for i, name in ipairs { "t", "qw", "qx", "qy", "qz" } do
    worst = math.max(worst, math.abs(uneven[#uneven][i] - want[name]))
  end
  tap.near(worst, 0, 0, 1e-9, tag .. "steps that are no whole number of inner steps end where they should", rk4)

  -- an importing tool that adds up its own time is late by the roundings of its sum
  local sum, late = { "start 0 0 -", "ready 0" }, 0.0
  for _ = 1, 30 do
    sum[#sum + 1] = string.format("step 0 %.17g 0.1", late)
    late = late + 0.1
  end
  sum[#sum + 1] = "get 0 $time"
  local answers = ask(table.unpack(sum))
  tap.ok(late ~= 3.0 and answers[#answers][1] == 3.0 and answers[#answers - 1].status == 0,
    tag .. "30 steps of 0.1 s end at 3 s, whatever the sum of the importing tool says")

  answers = ask("set 0 $uy 0.003", "start 0 1 -", "ready 0", "step 0 1 0.00705", "save 0 0", "bytes 0 0", "set 0 $uy 1",
    "step 0 1.00705 0.01", "get 0 " .. state, "load 0 0", "get 0 $uy", "set 0 $uy 1", "step 0 1.00705 0.01",
    "get 0 " .. state, "new 1 TOKEN 0", "unbytes 1 1 0", "load 1 1", "set 1 $uy 1", "step 1 1.00705 0.01",
    "get 1 " .. state, "unbytes 1 1 20", "free 0 0", "free 1 1")
  tap.is(bits(answers, 15), bits(answers, 10, 10) .. " " .. bits(answers, 21), tag ..
    "a saved state replays to the bit, in another instance too, by way of bytes")
  tap.ok(answers[12][1] == 0.003 and answers[10][1] == 1.01705, tag .. "with its inputs and its time")
  tap.ok(answers[22].status == 3 and answers[22].log:find("no state of this unit", 1, true),
    tag .. "bytes of another length are refused")

  answers = ask("new 1 TOKEN 0", "set 1 $width 0.02", "set 0 $wx 0.4", "set 0 $qx 1", "start 0 0 -", "start 1 0 -",
    "ready 0", "ready 1", "step 0 0 0.01", "step 1 0 0.01", "step 0 0.01 0.01", "get 0 " .. state, "get 1 $wx $width",
    "drop 1", "reset 0", "get 0 " .. state, "set 0 $wx 0.4", "set 0 $qx 1", "start 0 0 -", "ready 0", "step 0 0 0.02",
    "get 0 " .. state, "end 0", "get 0 $time", "drop 0")
  tap.ok(answers[14][1] ~= answers[13][6] and answers[14][2] == 0.02, tag .. "instances have parameters of their own")
  tap.is(bits(answers, 13, 13), bits(answers, 23, 23), tag .. "after a reset the same run has the same bits")
  local first = fmu.general("bodies/gyroscope.lua", "0")
  local again = answers[17]
  tap.ok(again[1] == 0 and again[6] == first.wx and again[8] == first.wz, tag .. "a reset puts the start values back")
  tap.ok(answers[24].status == 0 and answers[25].status == 0 and answers[25][1] == 0.02,
    tag .. "outputs can be read after the end")
  local q = answers[13]
  tap.near(q[2] ^ 2 + q[3] ^ 2 + q[4] ^ 2 + q[5] ^ 2, 1, 0, 1e-12, tag .. "an attitude that was set becomes |q| = 1",
    "rounding, and what some hundred steps leave of |q| = 1")
end

-- Jacobi's integral of the satellite on a circle stays while its energy does not, and is the sum that it is said to be.
for version = 2, 3 do
  local answers = fmu.drive(units.ring[version], { "new 0 TOKEN 0", "set 0 $qx 0.3", "start 0 0 -", "ready 0",
    "get 0 $jacobi_integral $energy", "along 0 $jacobi_integral $wx", "along 0 $energy $wx", "along 0 $Lz $wx",
    "step 0 0 3000", "get 0 $jacobi_integral $energy" })
  local before, after = answers[5], answers[10]
  tap.ok(math.abs(after[1] / before[1] - 1) < 1e-9 and math.abs(after[2] / before[2] - 1) > 1e-3, "FMI " .. version ..
    ": Jacobi's integral is kept", before[1] .. " " .. after[1] .. "; " .. before[2] .. " " .. after[2])
  local n = math.sqrt(3.986004418e14 / 7e6 ^ 3) -- H = T + V - n L_z, Kepler's third law
  tap.near(answers[6][1], answers[7][1] - n * answers[8][1], 1e-12, 1e-18, "FMI " .. version ..
    ": the derivative of Jacobi's integral", "a few roundings of numbers of this size")
end

-- ---- what is refused, and how it is told ----

local refusals = { -- command, what the log says; the commands before are needed to come there
  { "step 0 0 0.1", "not allowed in this phase" },
  { "set 0 $rim_in 0.05" }, { "set 0 $rim_in nan", "rim_in (value reference 1): must be a finite number" },
  { "set 0 77 1", "value reference 77" }, { "get 0 77", "value reference 77" },
  { "set 0 $time 1", "time (value reference 0): the independent variable" },
  { "set 0 $energy 1", "is calculated" }, { "set 0 $der(wx) 1", "is calculated" },
  { "start 0 0 1" }, { "ready 0", "check 4 of gyroscope_init: tube: r_out must be larger than r_in" },
  { "set 0 $rim_in 0.03" }, { "set 0 $qw 0" }, { "ready 0", "quaternion must not be 0" }, { "set 0 $qw 1" },
  { "ready 0" }, { "start 0 0 1", "not allowed in this phase" },
  { "set 0 $rim_in 0.03", "is fixed" }, { "set 0 $wx 0.03", "is fixed" },
  { "set 0 $ux inf", "ux (value reference 4): must be a finite number" },
  { "step 0 0 -0.1", "must be positive and finite, got -0.1" }, { "step 0 0 0", "must be positive" },
  { "step 0 0 nan", "must be positive" }, { "step 0 nan 0.1", "is not the unit's time" },
  { "step 0 0.5 0.1", "the communication point 0.5 is not the unit's time 0" },
  { "step 0 0 1.5", "beyond the stop time 1" }, { "step 0 0 0.1" },
  { "along 0 $wx $rim_in", "by states and inputs only" }, { "along 0 $time $wx", "derivatives are those of" },
  { "set 0 $ux 1e300" }, { "step 0 0.1 0.1", "is no finite number any more" },
  { "step 0 0.1 0.1", "not allowed in this phase" }, { "end 0" }, { "end 0", "not allowed in this phase" },
  { "log 0 0 logStatusError" }, { "set 0 $energy 1" }, { "log 0 1 nonsense" } }
for version = 2, 3 do
  local unit, commands, faults = top[version], { "new 0 TOKEN 0" }, {}
  for i, r in ipairs(refusals) do commands[i + 1] = r[1] end
  local answers = fmu.drive(unit, commands)
  for i, r in ipairs(refusals) do
    local a = answers[i + 1]
    local quiet = i > #refusals - 2
    if quiet and a.status ~= 3 or not quiet and a.status ~= (r[2] and 3 or 0) or
      r[2] and not a.log:find("logStatusError 3 .*" .. r[2]:gsub("%p", "%%%0")) or not r[2] and a.log ~= "" then
      faults[#faults + 1] = string.format("%s: %d %s", r[1], a.status, a.log)
    end
  end
  tap.ok(#faults == 0, "FMI " .. version .. ": wrong calls are refused with an error and the reason in the log",
    table.concat(faults, "\n"))
  answers = fmu.drive(unit, { "new 0 {another} 0", "new 1 TOKEN 1" })
  tap.ok(answers[1].status == 1 and answers[1].log:find "that of this unit", "FMI " .. version ..
    ": no instance for another unit's token")
  tap.ok(answers[2].log:find "^logEvents 0 ", "FMI " .. version .. ": events are logged where that is asked for")
  local wrong = {}
  commands = { "new 0 TOKEN 0", "start 0 0 -", "ready 0" }
  local names = version == 2 and "GetInteger SetBoolean GetString EnterEventMode SetTime GetDerivatives CancelStep"
    or "GetFloat32 SetInt8 GetBinary SetClock GetAdjointDerivative EnterEventMode SetTime EnterStepMode GetShiftDecimal"
  for name in names:gmatch "%S+" do commands[#commands + 1] = "other 0 " .. name end
  answers = fmu.drive(unit, commands)
  for i = 4, #commands do
    if answers[i].status ~= 3 or answers[i].log == "" then wrong[#wrong + 1] = commands[i] end
  end
  tap.is(table.concat(wrong, ", "), "", "FMI " .. version .. ": what the unit does not have is an error with a reason")
end

-- ---- derivatives: against differences of what the unit gives for other initial values ----

for version = 2, 3 do
  local unit, faults = top[version], {}
  local names = { "der(qw)", "der(wx)", "der(wy)", "wx", "energy", "Lx", "Lz" }
  local function values(by, step)
    local asked = fmu.drive(unit, { "new 0 TOKEN 0", "set 0 $wz 20", "set 0 $wy 3",
      string.format("set 0 $%s %.17g", by, step), "start 0 0 -", "get 0 $" .. table.concat(names, " $") })
    return asked[6]
  end
  for by, x in pairs { wx = 0.2, wy = 3, ux = 0, qx = 0 } do -- any order
    local h = 2.0 ^ -12
    local up, down, commands = values(by, x + h), values(by, x - h), { "new 0 TOKEN 0", "set 0 $wz 20", "set 0 $wy 3",
      "start 0 0 -" }
    for _, name in ipairs(names) do commands[#commands + 1] = "along 0 $" .. name .. " $" .. by end
    local answers = fmu.drive(unit, commands)
    for i, name in ipairs(names) do
      local want = (up[i] - down[i]) / (2 * h)
      local got = answers[4 + i]
      -- all are polynomials of degree two in w and q and linear in u, so central differences only round: 2^12 ulp
      local off = math.abs(got[1] - want)
      if got.status ~= 0 or off ~= off or off > 1e-11 * (1 + math.abs(want)) then
        faults[#faults + 1] = string.format("d %s/d %s = %s, want %.17g", name, by, tostring(got[1]), want)
      end
    end
  end
  tap.ok(#faults == 0, "FMI " .. version .. ": directional derivatives are those of the unit's own values",
    table.concat(faults, "\n"))
end
-- ---- other ways through time: the closed form, a planned method, float ----

local exact, late = assert(fmu.make("bodies/symmetric_top.lua", "--method exact")),
  fmu.general("bodies/symmetric_top.lua", "3000")
for version = 2, 3 do
  local tag = "symmetric_top by its closed form, FMI " .. version
  fmu.valid(exact[version], tag)
  follows(exact[version], tag, late, {}, 1000, 3, 1e-12,
    "both are closed forms; some units of the last place, and the phase's own after 3000 s")
  tap.ok(not exact[version].xml:find("fixedInternalStepSize", 1, true), tag .. ": no inner step")
end

local planned = assert(fmu.make("bodies/dropped_stone.lua", "--accuracy 1e-9"))
follows(planned[2], "dropped_stone by a planned method", fmu.general("bodies/dropped_stone.lua", "4"), {}, 0.5, 8, 1e-9,
  "the accuracy that was asked for")

-- in float, and of a file whose name XML would stumble over
local odd = program.directory() .. "/a&b--<c>.lua"
program.write(odd, program.read "bodies/dropped_stone.lua")
local float = assert(fmu.make(odd, "--real float --with jacobians"))
for version = 2, 3 do
  local tag = "dropped_stone of " .. odd:match "[^/]*$" .. " in float, FMI " .. version
  fmu.valid(float[version], tag)
  follows(float[version], tag, fmu.general("bodies/dropped_stone.lua", "1"), {}, 0.25, 4, 1e-5,
    "100 steps, each of which rounds some numbers of 24 bits")
end
local answers = fmu.drive(float[3], { "new 0 TOKEN 0", "set 0 $g 1e39" })
tap.ok(answers[2].status == 3 and answers[2].log:find "finite", "float: a number beyond its range is refused")

-- ---- the same bytes ----

fmu.must("mkdir -p %s/elsewhere && cp bodies/dropped_stone.lua %s/elsewhere", program.directory(), program.directory())
local again = assert(fmu.make(program.directory() .. "/elsewhere/dropped_stone.lua"))
for version = 2, 3 do
  local file = "/dropped_stone_fmi" .. version .. ".fmu"
  local text = program.read(again.dir .. file)
  tap.ok(text == program.read(units.dropped_stone.dir .. file), "FMI " .. version ..
    ": made in another place the unit has the same bytes")
  tap.ok(not text:find(program.directory(), 1, true), "and no path in it")
  if fmu.run "command -v unzip" then
    local ok, out = fmu.run("unzip -t %s%s", again.dir, file)
    tap.ok(ok, "FMI " .. version .. ": unzip finds nothing wrong with the archive", out)
  else
    tap.skip("unzip finds nothing wrong with the archive", "no unzip (Debian package unzip)")
  end
  tap.ok(units.dropped_stone[version].token ~= float[version].token, "another source has another token")
end

-- ---- sources as an importing tool compiles them ----

local warnings = "-std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Wstrict-prototypes " ..
  "-Wmissing-prototypes -Werror"
for version = 2, 3 do
  local unit, tag = top[version], "FMI " .. version .. ": "
  local list = {}
  local named = version == 2 and unit.xml or program.read(unit.dir .. "/sources/buildDescription.xml")
  for file in named:gmatch(version == 2 and "<File name=\"([^\"]*)\"/>" or "<SourceFile name=\"([^\"]*)\"/>") do
    list[#list + 1] = unit.dir .. "/sources/" .. file
  end
  local sources, so = table.concat(list, " "), unit.dir .. "/sanitized.so"
  local sanitizers = "-fsanitize=address,undefined -fno-sanitize-recover=all"
  local ok, text = fmu.run("gcc %s -g %s -fPIC -shared -DFMI%d_OVERRIDE_FUNCTION_PREFIX %s -lm -o %s", warnings,
    sanitizers, version, sources, so)
  if tap.ok(ok, tag .. "the sources that the description names compile without a warning", text) then
    local commands = { "new 0 TOKEN 0" }
    for i, r in ipairs(refusals) do commands[i + 1] = r[1] end
    for _, c in ipairs { "reset 0", "log 0 1 logStatusError", "start 0 0 -", "ready 0", "set 0 $ux 0.01",
      "step 0 0 0.00123", "save 0 0", "bytes 0 0", "step 0 0.00123 0.01", "get 0 " .. state, "unbytes 0 1 0",
      "load 0 1", "free 0 0", "free 0 1", "along 0 $der(wx) $ux", "along 0 $Lx $qz", "end 0", "drop 0" } do
      commands[#commands + 1] = c
    end
    local plain, watched = fmu.drive(unit, commands), fmu.drive(unit, commands, so, sanitizers)
    tap.ok(bits(watched) == bits(plain) and #watched == #commands, tag ..
      "with sanitizers they run through all of the above, without a leak, with the bits of the binary")
  end
  ok, text = fmu.run("cd %s && g++ -std=c++11 -Wall -Wextra -Wshadow -Werror -fsyntax-only -x c++ sources/*_unit.c " ..
    "sources/*_fmi%d.c", unit.dir, version)
  tap.ok(ok, tag .. "they are valid C++", text)
  fmu.must("cd %s && gcc -c sources/*_fmi%d.c -o static.o", unit.dir, version)
  local prefixed = fmu.must("nm --defined-only %s/static.o", unit.dir)
  local _, with = prefixed:gsub(" T gyroscope_fmi" .. version, "")
  local _, all = prefixed:gsub(" T ", "")
  tap.ok(with == #fmu.functions[version] and all == with, tag ..
    "linked statically all functions begin with the unit's name")
end

-- ---- what cannot be a unit ----

local function refused(text, options, part, name)
  local path = program.directory() .. "/refused.lua"
  program.write(path, text)
  local made, out = fmu.make(path, options)
  tap.ok(not made and out:find(part, 1, true), name, out or "it was made")
end
refused([[
local unit_a = param("unit_a", 1, "m")
return scene { name = "s", body = solid.box { x = unit_a, y = 2, z = 3, mass = 1 } }]], nil,
  "must not begin with unit_, got \"unit_a\"", "a parameter whose name would collide is refused")
refused(program.read "bodies/heavy_top.lua":gsub("0.2, 0.96, 0.1, 0", "1, 0, 0, 0"):gsub("solid%.cone.-}",
  "solid.box { x = r, y = 2*r, z = h, mass = 1 }"), "--method exact", "no closed form",
  "the closed form is refused where there is none")

program.finish()
tap.done()
