#!/usr/bin/env lua5.4
-- project.t - the list of emitted files and what each of them must say.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Whether the code is right is seen by its self-test and by polhode check; here is what a reader and a linker need:
-- names, enumerators, units, checks, licence, the promises about headers and state.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"

-- As tap.like, but without the whole file in the message.
local function says(text, part, name)
  return tap.ok(text:find(part, 1, true) ~= nil, name, "it does not contain: " .. part)
end

local function emitted(path, options, plan, plugin)
  local job = scene.plan(scene.file("bodies/" .. path .. ".lua", options), plan)
  return scene.files(job, plugin), job
end

-- ---- files ----

do
  local files = emitted "brick"
  tap.is(table.concat(files, " "), "brick.h brick.c brick_test.c Makefile README.md qemu.c qemu.ld",
    "the files of a scene, in order")
  files = emitted("brick", nil, nil, true)
  tap.is(table.concat(files, " "), "brick.h brick.c brick_test.c Makefile README.md qemu.c qemu.ld plugin.c plugin.h",
    "the program itself also gets the plugin's table")
  files = emitted("brick", nil, nil, { peers = true })
  tap.is(table.concat(files, " ", 8), "peers.c plugin.c plugin.h", "and what other integrators call, if it asks")
  files = emitted("brick", nil, { real = "float" }, { peers = true })
  tap.is(table.concat(files, " ", 8), "plugin.c plugin.h", "but those calculate in double")
end

-- ---- licence, headers, state ----

for _, path in ipairs { "brick", "symmetric_top", "gyroscope", "dumbbell", "water" } do
  for _, bake in ipairs { false, true } do
    local files, job = emitted(path, { bake = bake })
    local tag = path .. (bake and ", baked" or "")
    for _, name in ipairs(files) do
      says(files[name], "MIT-0", tag .. ": " .. name .. " says that it is MIT-0")
      tap.ok(not files[name]:find("GPL", 1, true), tag .. ": " .. name .. " names no other licence")
      tap.ok(not files[name]:find("${", 1, true) and not files[name]:find("%% ", 1, true) and
        not files[name]:find("nil", 1, true), tag .. ": " .. name .. " has nothing of its template left")
    end
    local includes = {}
    for _, name in ipairs { path .. ".h", path .. ".c", path .. "_test.c" } do
      for what in files[name]:gmatch "\n#include%s+(%S+)" do includes[#includes + 1] = name .. " " .. what end
    end
    local q = '"' .. path .. '.h"'
    local function uses(ext, what) return files[path .. ext]:gsub("/%*.-%*/", ""):find(what) ~= nil end
    local ticks = uses(".h", "_at_tick%(") -- times are int64_t then; blocks of many times are counted in size_t
    local integers = not ticks and uses(".c", "[ (]u?int%d+_t ")
    local want = (ticks and path .. ".h <stdint.h>, " or "") ..
      string.format("%s.c %s, %s.c <math.h>, ", path, q, path) ..
      (uses(".c", "[ (]size_t ") and path .. ".c <stddef.h>, " or "") ..
      (integers and path .. ".c <stdint.h>, " or "") ..
      string.format("%s_test.c %s, ", path, q) ..
      ("NAME_test.c <float.h>, NAME_test.c <math.h>, NAME_test.c <stdio.h>"):gsub("NAME", path)
    tap.is(table.concat(includes, ", "), want, tag .. ": the code needs math.h, the test also float.h and stdio.h")
    local code = files[path .. ".c"]:gsub("/%*.-%*/", "") .. files[path .. ".h"]:gsub("/%*.-%*/", "")
    for _, word in ipairs { "malloc", "free", "static", "extern", "errno", "printf", "goto", "long double" } do
      local found = code:find("%f[%w_]" .. word .. "%f[^%w_]") ~= nil
      if word == "static" then -- static functions and constants are fine, static data is not
        local rest = code:gsub("static const ", "")
        found = rest:find "\n[ \t]+static " ~= nil or rest:find "\nstatic [^(\n]*[;=]" ~= nil
      elseif word == "extern" then
        local rest = code:gsub("extern const [%w_]+_orbit [%w_]+_own_orbit;", "") -- a constant
        found = rest:find 'extern [^"]' ~= nil
      end
      tap.ok(not found, tag .. ": no " .. word .. (word == "static" and " data" or ""))
    end
    -- every function is declared with its contract, and defined once
    local header, source = files[path .. ".h"], files[path .. ".c"]
    local missing = {}
    for _, f in ipairs(job.functions) do
      local name = path .. "_" .. f.name
      local at = header:find("[%w_]+ " .. name .. "%(")
      if not at or not header:sub(1, at - 1):find "%*/\n$" then missing[#missing + 1] = name .. ": no contract" end
      local defined = select(2, source:gsub("\n[%w_]+ " .. name .. "%(", ""))
      if defined ~= 1 then missing[#missing + 1] = name .. ": defined " .. defined .. " times" end
    end
    tap.ok(#missing == 0, tag .. ": every function has a contract in the header and one definition",
      table.concat(missing, ", "))
    for name in source:gmatch "\n[%w_]+ ([%w_]+)%(" do
      if name:sub(1, #path + 1) ~= path .. "_" then
        tap.ok(false, tag .. ": public names begin with the scene's", name)
      end
    end
  end
end

-- ---- the header ----

do
  local files = emitted "brick"
  local h = files["brick.h"]
  says(h, "typedef double brick_real;", "the real type is named once")
  for _, line in ipairs { "BRICK_QW, BRICK_QX, BRICK_QY, BRICK_QZ, /* attitude, body to inertial [1] */",
    "BRICK_WX, BRICK_WY, BRICK_WZ, /* rates, body axes [rad/s] */", "BRICK_NX\n",
    "BRICK_A, /* default 0.2 [m] */", "BRICK_M, /* default 2.4 [kg] */", "BRICK_NP\n",
    "enum { BRICK_NU = 0 }; /* no input: u may be NULL */", "Ixx = M*(b^2 + c^2)/3", "Ixy = -M*a*b/4",
    "No effects: torque-free motion", "polhode gen test.lua", "param: M must be positive (brick.lua:3)",
    "box: x must be positive (brick.lua:6)", "every derived constant must be finite", 'extern "C"' } do
    says(h, line, "brick.h: " .. line:gsub("\n", ""))
  end
  local guard = h:match "#ifndef (%S+)\n#define (%S+)\n"
  tap.ok(guard and guard:find "^%u" and not guard:find "^_", "the include guard has no leading underscore")
  h = emitted("brick", { bake = true })["brick.h"]
  tap.ok(h:find("enum { BRICK_NP = 0 }; /* no parameters: p may be NULL */", 1, true) and h:find("--bake", 1, true)
    and h:find("there is nothing to check", 1, true), "baked: no parameters, nothing to check, and the banner says it")
  h = emitted("brick", nil, { real = "float" })["brick.h"]
  says(h, "typedef float brick_real;", "float: one typedef")
  h = emitted "gyroscope"["gyroscope.h"]
  for _, line in ipairs { "GYROSCOPE_UX, GYROSCOPE_UY, GYROSCOPE_UZ, /* torque, body axes [N m] */", "GYROSCOPE_NU\n",
    "Effect control" } do
    says(h, line, "gyroscope.h: " .. line:gsub("\n", ""))
  end
  h = emitted "symmetric_top"["symmetric_top.h"]
  for _, line in ipairs { "typedef struct symmetric_top_orbit {", "int symmetric_top_solve(", "void symmetric_top_at(",
    "free symmetric top, regular precession" } do
    says(h, line, "symmetric_top.h: " .. line)
  end
  tap.ok(not emitted("symmetric_top", nil, { methods = { "rk4" } })["symmetric_top.h"]:find("orbit", 1, true),
    "--method rk4: no closed form is emitted")
  h = emitted("brick")["brick.h"]
  says(h, "free asymmetric top, theta functions", "brick.h: the theorem of its closed form")
  h = emitted "gyroscope"["gyroscope.h"]
  tap.ok(not h:find("orbit", 1, true), "a scene without a closed form has no orbit")
end

-- ---- README and Makefile ----

do
  local files, job = emitted "cube_corner"
  local readme = files["README.md"]
  for _, f in ipairs(job.functions) do
    says(readme, "| " .. f.name .. " | ", "README: cost of " .. f.name)
  end
  for _, part in ipairs { "cube_corner.c", "cube_corner.h", "cube_corner_test.c", "make check", "Ixx = 2 M a²/3",
    "Ixy = -M a²/4", "Closed form: free symmetric top, regular precession", "cube_corner_init(&m, 0)",
    "cube_corner_solve(&o, &m, x)" } do
    says(readme, part, "README: " .. part)
  end
  local make = files.Makefile
  tap.ok(make:find "\nCC %?= cc" and make:find "\nCFLAGS %?= " and make:find("-ffp-contract=off", 1, true)
    and make:find "\ncheck:" and make:find "\n%.PHONY:", "Makefile: CC and CFLAGS are the user's; check; phony targets")
  for line in make:gmatch "\n([ \t][^\n]*)" do
    tap.ok(line:find "^\t", "Makefile: recipes begin with a tab: " .. line:gsub("%s+", " "))
  end
  -- the derivation names the scene's line of every equation that has one
  says(files["cube_corner.c"], "[cube_corner.lua:5]", "an equation's comment names the law and the scene's line")
end

-- ---- the IR, after each pass ----

do
  local driver = require "generator.driver"
  local passes = require "generator.ir.passes.passes"
  local before
  for _, pass in ipairs { "lower", "power", "fold", "cse", "dce", "order" } do
    local job = scene.plan(scene.file "bodies/brick.lua")
    local text = driver.show(job, pass)
    tap.ok(text:find("brick_rhs", 1, true) and text:find("brick_step", 1, true) and #text > 1000,
      "--show " .. pass .. ": the IR of every function")
    tap.ok(text ~= before or pass == "dce" or pass == "cse", "--show " .. pass .. ": differs from what was before it")
    before = text
  end
  tap.ok(type(passes) == "table", "passes are a module")
end

-- ---- names of constants against names of arguments ----

do -- a wheel's axis of parameters: its constants would be ax, ay, az, and NAME_acceleration_at has arguments so called
  local job = scene.read [[
return scene { name = "slanted", body = tensor { mass = 750, com = {0, 0, 0}, xx = 900, yy = 800, zz = 600 },
  effects = { effect.wheel { axis = { param("p1", 0.6), 0, param("p2", 0.8) }, inertia = 0.1, speed = 3,
    included = true } }, initial = { omega = {1, 2, 3} } }
]]
  local files = scene.files(scene.plan(job), true)
  says(files["slanted.h"], " ax2;", "a constant is not called like a component of an argument")
end

-- ---- a corner at the start ----

do
  local job = scene.read [[
return scene { name = "corner", body = solid.box { x = 0.2, y = 0.1, z = 0.05, mass = 1 }, effects = {
  effect.custom { params = { rub = quantity(0.1, "kg m^2") }, torque = function(s)
    return { -s.rub*s.w[1]*abs(s.w[1]), 0, 0 } end } }, initial = { omega = {0, 1, 2} } }
]]
  says(scene.files(scene.plan(job), true)["corner.c"], "copysign(1.0, wx)",
    "the derivative of |wx| is one of its sides at wx = 0 and no quotient")
end

tap.done()
