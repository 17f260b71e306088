#!/usr/bin/env lua5.4
-- fuzz.t: no value in any place of a scene reaches an internal error: the status is 0 or 1, never 70.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Every word of the scene language is called with every odd value.  One script makes all calls of one word, each on a
-- line of its own; a bug of the generator in any of them would end it with 70.  That the script came to its end is seen
-- from its last call, whose error is on line 1 and so is reported first.  Scenes that are right, or wrong only as a
-- whole, are run one by one through gen, to the files.  The quick tier takes every thirtieth word.
package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function run(scene, command, environment)
  program.write(dir .. "/s.lua", scene)
  local status = program.shell(string.format("%s timeout 60 %s %s %s/s.lua >%s/stdout 2>%s/stderr", environment or "",
    binary, command, dir, dir, dir))
  return status, program.read(dir .. "/stderr")
end

-- What no message may show: a traceback, a file of the generator, an address, the sign of a nan.
local function clean(err)
  for _, trace in ipairs { "internal error", "traceback", "generator/", "function:", "table:", "0x", "-nan" } do
    if err:find(trace, 1, true) then return false end
  end
  return true
end

local VALUES = { "nil", "true", "false", "0", "-0.0", "-1", "1", "2.5", "0/0", "1/0", "-1/0", "1e308", "-1e308",
  "5e-324",
  "math.mininteger", "math.maxinteger", '""', '"x"', '"y"', '"com"', '"1/3"', '"1/0"', '"1e400"', '"1e-400"',
  '"1e999999999"', '"nan"', '" 1"', '"a\\nb"', '"\\0"', '"\\27[0m"', '("x"):rep(100000)', "{}", "{1}", "{1, 2}",
  "{1, 2, 3}", "{1, 2, 3, 4}", "{0, 0, 0}", "{0, 0, 0, 0}", "{nil, 2, 3}", "{1, 2, 3, x = 4}", "{[2] = 1}",
  "{[1.5] = 1}", "{[{}] = 1, [print or 1] = 2}", "{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}", "{{1, 2, 3, 4}}", "{x = 1}",
  '{r = 1, mass = 1}', '{axis = "x", angle = 1}', '{quaternion = {1, 1, 0, 0}}', "cyclic", "deep", "function() end",
  "math.sin", "tostring", "string", "solid", "solid.box", "solid.cube", "effect", "effect.control", "effect.wind",
  "points", "scene", "sphere", "sphere:at{1, 0, 0}", "control", "made", "length", "mass", "pure", "zero", "negative",
  "quantity",
  'quantity(1, "deg")', 'exact("1/3")', 'exact("1e-400")', "pi", "sqrt(2)", "sqrt(length)", "log(0)", "acos(2)",
  "exp(1000)", "1/zero", "negative^0.5", "atan2(0, 0)", "pi^64", "long", "length*mass/zero" }

local WORDS = { "param(%s, 1, 'm')", "param('a' .. line, %s, 'm')", "param('b' .. line, 1, %s)", "quantity(%s, 'm')",
  "quantity(1, %s)", "exact(%s)", "sqrt(%s)", "abs(%s)", "sin(%s)", "cosh(%s)", "atan2(%s, 1)", "atan2(length, %s)",
  "log(%s)", "length + (%s)", "(%s) - length", "length*(%s)", "(%s)/length", "length/(%s)", "length^(%s)", "(%s)^pure",
  "sphere + (%s)", "(%s) - sphere", "sphere:at(%s)", "sphere.at(%s)", "sphere:at{1, %s, 2}", "sphere:turned(%s)",
  "sphere:turned{axis = %s, angle = 1}", "sphere:turned{axis = 'x', angle = %s}",
  "sphere:turned{axis = {1, 0, %s}, angle = 1}", "sphere:turned{quaternion = %s}",
  "sphere:turned{quaternion = {1, 0, 0, %s}}", "sphere:scaled(%s)", "sphere:scaled{%s}",
  "sphere:scaled{1, %s, 2}", "sphere:mirrored(%s)", "points(%s)", "points{%s}", "points{{1, 0, 0, %s}}",
  "points{{%s, 0, 0, 1}}", "scene(%s)", "scene{name = %s, body = sphere}", "scene{name = 's', body = %s}",
  "scene{name = 's', body = sphere, origin = %s}", "scene{name = 's', body = sphere, origin = {1, %s, 2}}",
  "scene{name = 's', body = sphere, effects = %s}", "scene{name = 's', body = sphere, effects = {%s}}",
  "scene{name = 's', body = sphere, initial = %s}", "scene{name = 's', body = sphere, initial = {omega = %s}}",
  "scene{name = 's', body = sphere, initial = {omega = {0, 0, %s}}}",
  "scene{name = 's', body = sphere, initial = {attitude = %s}}", "scene{name = 's', body = sphere, time = %s}",
  "scene{name = 's', body = sphere, time = {horizon = %s}}", "scene{name = 's', body = sphere, time = {step = %s}}",
  "scene{name = 's', body = sphere, accuracy = %s}", "scene{[tostring(%s)] = 1}", "tostring(%s)", "('%%s'):format(%s)" }

local ARGUMENTS = { ["solid.box"] = "x y z mass density", ["solid.sphere"] = "r mass density",
  ["solid.ellipsoid"] = "a b c mass", ["solid.cylinder"] = "r h mass", ["solid.elliptic_cylinder"] = "a b h mass",
  ["solid.tube"] = "r_in r_out h mass", ["solid.cone"] = "r h mass", ["solid.hemisphere"] = "r mass",
  ["solid.torus"] = "R r mass", ["plate.disc"] = "r density", ["plate.rectangle"] = "x y density",
  ["rod.straight"] = "length density", ["rod.between"] = "from to mass", ["wire.hoop"] = "r density",
  tensor = "mass com xx yy zz xy xz yz about", ["effect.gravity"] = "g direction", ["effect.damping"] = "c rate",
  ["effect.torque"] = "body inertial", ["effect.control"] = "max" }
local ORDER = { "solid.box", "solid.sphere", "solid.ellipsoid", "solid.cylinder", "solid.elliptic_cylinder",
  "solid.tube",
  "solid.cone", "solid.hemisphere", "solid.torus", "plate.disc", "plate.rectangle", "rod.straight", "rod.between",
  "wire.hoop", "tensor", "effect.gravity", "effect.damping", "effect.torque", "effect.control" }

for _, name in ipairs(ORDER) do
  WORDS[#WORDS + 1] = name .. "(%s)"
  for argument in ARGUMENTS[name]:gmatch "%S+" do
    local fields = {}
    for other in ARGUMENTS[name]:gmatch "%S+" do
      local value = other == argument and "%s" or (other == "from" or other == "com") and "{0, 0, 0}"
        or other == "to" and "{1, 0, 0}" or other == "about" and '"com"' or "1"
      local exclusive = other ~= argument and (other == "density" and argument ~= "density" and
        ARGUMENTS[name]:find "mass" or other == "mass" and argument == "density" or other == "rate"
        or other == "inertial")
      if not exclusive then fields[#fields + 1] = other .. " = " .. value end
    end
    WORDS[#WORDS + 1] = name .. "{" .. table.concat(fields, ", ") .. "}"
  end
end

-- Line 1: what the values need, and the end.  `sink` takes results, so that no call is a tail call.
local HEAD = [[local function finish() error("came to its end", 0) end local function sink() end ]] ..
  [[local cyclic = {1, 2, 3} cyclic[2] = cyclic local deep = {} for i = 1, 1000 do deep = {deep, deep} end ]] ..
  [[local sphere = solid.sphere{r = 1, mass = 1} local control = effect.control{} ]] ..
  [[local made = scene{name = "made", body = sphere} local length, mass = param("l", 1, "m"), param("m", 1, "kg") ]] ..
  [[local pure, zero, negative = param("p", 2), param("z", 0), param("n", -1) ]] ..
  [[local long = pure for i = 1, 60 do long = sin(long + long*long) end]]

local calls = 0
for _, word in ipairs(tier.every(30, WORDS)) do
  local lines = { HEAD }
  for _, value in ipairs(VALUES) do
    local line = #lines + 1
    local call = word:gsub("%%s", function() return value end):gsub("%%%%", "%%")
    call = call:gsub("%f[%w]line%f[%W]", tostring(line))
    lines[line] = "sink(" .. call .. ")"
    calls = calls + 1
  end
  lines[#lines + 1] = "finish()"
  local status, err = run(table.concat(lines, "\n"), "explain")
  -- arithmetic on what has none stops a script, by Lua's own message: then its line is that of the call
  local ended = err:find("s.lua:1: script: came to its end", 1, true)
  local stopped = not ended and err:match "s%.lua:(%d+): script: ([^\n]*)"
  while stopped do -- skip such lines, and go on
    lines[tonumber(stopped)] = "sink()"
    status, err = run(table.concat(lines, "\n"), "explain")
    ended = err:find("s.lua:1: script: came to its end", 1, true)
    local next_one = not ended and err:match "s%.lua:(%d+): script: "
    if not clean(err) or next_one == stopped then break end
    stopped = next_one
  end
  tap.ok(status == 1 and ended and clean(err), word:gsub("%%s", "..."):gsub("%%%%", "%%") .. " takes every odd value",
    status .. "\n" .. err:sub(1, 2000))
end
tap.ok(calls > (tier.quick and 300 or 9000), "that was " .. calls .. " calls")

-- ---- whole scenes ----

local BOX = "solid.box { x = 1, y = 2, z = 3, mass = 1 }"
local LARGE = { "1e308", "-1e308", "5e-324", '"1e400"', '"1e-400"', "1e150", "1e-150", "exp(1000)", "pi^64", "sqrt(2)" }
local PLACES = { "body = solid.box { x = %s, y = 1, z = 1, mass = 1 }", "body = solid.sphere { r = 1, mass = %s }",
  "body = solid.sphere { r = 1, density = %s }", "body = " .. BOX .. ", origin = {1, %s, 2}",
  "body = " .. BOX .. ":at{1, %s, 2}, origin = {0, 0, 0}", "body = " .. BOX .. ":turned { axis = \"x\", angle = %s }",
  "body = " .. BOX .. ":turned { axis = {1, 0, %s}, angle = 1 }", "body = " .. BOX .. ":scaled { abs(%s), 1, 1 }",
  "body = " .. BOX .. ", initial = { omega = {1, %s, 2} }",
  "body = " .. BOX .. ", initial = { attitude = {1, %s, 0, 0} }",
  "body = " .. BOX .. ", time = { horizon = abs(%s) }", "body = " .. BOX .. ", time = { step = abs(%s) }",
  "body = " .. BOX .. ", origin = \"corner\", effects = { effect.gravity { g = abs(%s) } }",
  "body = " .. BOX .. ", effects = { effect.damping { c = %s } }",
  "body = " .. BOX .. ", effects = { effect.torque { inertial = {0, %s, 0} } }",
  "body = points { {1, 0, 0, %s}, {2, 1, 0, 0}, {1, 0, 1, 0} }",
  "body = tensor { mass = 1, xx = 1, yy = 1, zz = 1, xy = %s }" }
local faults, scenes = {}, 0
for _, place in ipairs(tier.every(6, PLACES)) do
  for _, value in ipairs(LARGE) do
    local scene = 'return scene { name = "s", ' .. place:gsub("%%s", function() return value end) .. " }\n"
    local status, err = run(scene, "gen -o " .. dir .. "/out")
    scenes = scenes + 1
    if status ~= 0 and status ~= 1 or status == 1 and err == "" or not clean(err) then
      faults[#faults + 1] = status .. ": " .. scene .. err:sub(1, 400)
    end
  end
end
tap.is(table.concat(faults, "\n"), "", scenes .. " scenes of extreme numbers are emitted or refused")

-- What is large in another way: refused, or done, in bounded time and memory; some by a user who is patient.
for _, case in ipairs {
  { "a body doubled forty times", "local b = solid.sphere { r = 1, mass = 1 } for i = 1, 40 do b = b + b end", "b", 1 },
  { "a body moved ten thousand times",
    "local b = solid.sphere { r = 1, mass = 1 } for i = 1, 10000 do b = b:at{1, 0, 0} end", "b", 0,
    patience = true },
  { "a hundred points", "local t = {} for i = 1, 100 do t[i] = {1, i, i*i, 1/i} end", "points(t)", 0 },
  { "an expression a thousand deep", 'local x = param("x", 1) for i = 1, 1000 do x = sqrt(x*x + 1) end',
    "solid.sphere { r = x, mass = 1 }", 0 },
  { "a power of a power", 'local x = param("x", 2) for i = 1, 10 do x = x^64 end',
    "solid.sphere { r = x, mass = 1 }", 1 },
  { "a million errors", "for i = 1, 1e6 do local b = solid.sphere { r = -i, mass = 1 } end", "b", 1 },
  { "a scene of a hundred thousand lines", "n = 1\n" .. ("n = (n or 1) + 1\n"):rep(100000),
    "solid.sphere { r = 1, mass = 1 }", 0,
    patience = true },
} do
  local start = os.time()
  local scene = case[2] .. '\nreturn scene { name = "s", body = ' .. case[3] .. " }"
  local status, err = run(scene, "gen -o " .. dir .. "/out", case.patience and "POLHODE_PATIENCE=10")
  tap.ok(status == case[4] and clean(err) and os.time() - start < 30, case[1] .. ": status " .. case[4],
    status .. " after " .. os.time() - start .. " s\n" .. err:sub(1, 1000))
end

tap.done(program.finish())
