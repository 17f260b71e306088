#!/usr/bin/env lua5.4
-- commands.t: the commands as a user types them: files, columns, formats, exit statuses.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- What is computed is tested elsewhere (tests/dynamics, tests/emit, tests/runtime); wrong scenes and wrong command
-- lines are tests/dsl/errors.t's.  Here: results on standard output and nothing else there, numbers that read back,
-- options that do what they say.

local tap = require "tests.tap"
local program = require "tests.cli.program"
local json = require("tests.json").read

local dir = program.directory()
local binary = program.quick()

local function run(arguments)
  return program.output(string.format("timeout 120 %s %s", binary, arguments))
end

local function lines_of(text)
  local list = {}
  for line in text:gmatch "([^\n]*)\n" do list[#list + 1] = line end
  return list
end

-- ---- help and lists ----

do
  local status, out, err = run "--help"
  tap.ok(status == 0 and err == "" and out:find("usage: polhode COMMAND", 1, true) == 1,
    "--help prints the usage, status 0")
  status, out = run "--version"
  tap.ok(status == 0 and (out:match "^polhode %d+%.%d+%.%d+\n$" or out:match "^polhode %d+%.%d+%.%d+%+[%w.-]+\n$"),
    "--version prints name, number and commit", out)
end
for _, case in ipairs { { "shapes", "solid.box" }, { "effects", "effect.gravity" }, { "methods", "exact" },
  { "bodies", "book" }, { "constants", "A" } } do
  local what, first = case[1], case[2]
  local status, out, err = run("list " .. what)
  local lines, names, good = lines_of(out), {}, true
  for _, line in ipairs(lines) do
    local name, about = line:match "^(%S+)%s+(%S.*)$"
    good = good and name and about and not names[name] and not about:find "%s$"
    names[name or line] = true
  end
  tap.ok(status == 0 and err == "" and good and names[first] and #lines >= 4,
    "list " .. what .. ": one line each, its name first and once", out)
end
do -- the vocabulary that version 1 promises
  local _, out = run "list shapes"
  local missing = {}
  for name in ("solid.box solid.sphere solid.ellipsoid solid.cylinder solid.elliptic_cylinder solid.tube solid.cone " ..
    "solid.hemisphere solid.torus plate.disc plate.rectangle rod.straight rod.between wire.hoop points tensor")
    :gmatch "%S+" do
    if not ("\n" .. out):find("\n" .. name .. " ", 1, true) then missing[#missing + 1] = name end
  end
  tap.is(table.concat(missing, " "), "", "list shapes has every shape of the first version")
end

-- ---- gen ----

local TOP = dir .. "/top.lua"
program.write(TOP, [[
local r, h = param("r", 30, "mm"), param("h", 0.12, "m")
return scene {
  name = "top",
  body = solid.cylinder { r = r, h = h, density = quantity(2.7, "g/cm^3") },
  initial = { omega = {1, 0.5, 20} },
  time = { horizon = 2 },
}
]])
local FREE = dir .. "/free.lua"
program.write(FREE, [[
return scene { name = "free", body = solid.box { x = 1, y = 2, z = 3, mass = 6 }, initial = { omega = {1, 2, 3} },
  time = { horizon = 1 } }
]])

do
  local out_dir = dir .. "/a/b"
  local status, out, err = run("gen " .. TOP .. " -o " .. out_dir)
  tap.ok(status == 0 and out == "" and err == "", "gen is silent", err)
  for _, name in ipairs { "top.h", "top.c", "top_test.c", "Makefile", "README.md" } do
    local text = program.read(out_dir .. "/" .. name)
    tap.ok(text and #text > 100 and text:sub(-1) == "\n" and not text:find "\r" and not text:find(dir, 1, true),
      "gen writes " .. name .. ", which does not know where it was made")
  end
  local header = program.read(out_dir .. "/top.h")
  tap.like(header, "polhode gen top.lua", "the banner has the command line, without folders")
  tap.like(header, "typedef double top_real;", "the real type is double")
  run("gen " .. TOP .. " --real float -o " .. dir .. "/f")
  tap.like(program.read(dir .. "/f/top.h"), "typedef float top_real;", "--real float: the real type is float")
  tap.like(program.read(dir .. "/f/top.h"), "polhode gen top.lua --real float", "and the banner says so")
  run("gen " .. TOP .. " --set h=0.2 --set r=1/3 --bake -o " .. dir .. "/baked")
  local baked = program.read(dir .. "/baked/top.h")
  tap.like(baked, "polhode gen top.lua --bake --set h=0.2 --set r=1/3",
    "the banner lists what changes the output, in one order")
  tap.ok(not baked:find "TOP_R,", "--bake leaves no parameters")
  tap.like(header, "TOP_R,", "without it they are there")
  run("gen " .. TOP .. " --real=float -o " .. dir .. "/g")
  tap.is(program.read(dir .. "/g/top.c"), program.read(dir .. "/f/top.c"), "--real=float is --real float")
  status, out = run("gen " .. TOP .. " --show order")
  tap.ok(status == 0 and out:find("ir top_", 1, true) == 1 and out:find("\nir top_rhs", 1, true),
    "--show prints the functions' instructions instead", out:sub(1, 200))
  status, out, err = run("gen bodies/gyroscope.lua --method exact -o " .. dir .. "/no")
  tap.ok(status == 1 and out == "" and err:find("method exact: this scene has no closed form", 1, true),
    "--method exact of a driven body is refused with status 1", status .. err)
  tap.ok(program.read(dir .. "/no/gyroscope.c") == nil, "and nothing is written")
  program.write(dir .. "/ball.lua", [[return scene { name = "ball", body = solid.sphere { r = 0.1, mass = 1 },
    initial = { omega = {1, 2, 3} }, outputs = {"rates"} }]])
  for _, method in ipairs { "adaptive", "taylor" } do
    status, out, err = run("gen " .. dir .. "/ball.lua --method " .. method .. " -o " .. dir .. "/no")
    tap.ok(status == 1 and out == "" and err:find("method " .. method .. ": no state of the scene changes", 1, true),
      "a scene whose rates stay as they are has no steps of " .. method, status .. err)
  end
end

-- ---- run ----

do
  local status, out, err = run("run " .. TOP .. " --until 1 --every 0.25")
  local lines = lines_of(out)
  tap.ok(status == 0 and err == "", "run is silent but for its table", err)
  tap.is(lines[1], "t,qw,qx,qy,qz,wx,wy,wz,energy,Lx,Ly,Lz", "the columns are named in the first line")
  tap.is(#lines, 6, "--until 1 --every 0.25: five rows")
  local again, cells = true, 0
  for i = 2, #lines do
    for cell in lines[i]:gmatch "[^,]+" do
      cells = cells + 1
      local x = tonumber(cell)
      again = again and math.type(x) == "float" and tonumber(string.format("%.17g", x)) == x
    end
  end
  tap.ok(again and cells == 60, "every cell is a number")
  tap.like(lines[2], "0.0,1.0,0.0,0.0,0.0,1.0,0.5,20.0,", "the first row is the initial state")
  local _, stone = run("run bodies/dropped_stone.lua --at 0,1")
  tap.is(lines_of(stone)[1], "t,energy,rx,ry,rz,vx,vy,vz", "a point has no columns of turning")
  local _, book = run("run bodies/thrown_book.lua --at 0 --engine generated")
  tap.is(lines_of(book)[1], "t,qw,qx,qy,qz,wx,wy,wz,energy,Lx,Ly,Lz,rx,ry,rz,vx,vy,vz",
    "position and velocity follow the angular momentum")
  tap.like(lines_of(book)[2], "0.0,1.0,0.0,0.0,0.0,0.05,9.0,0.05,", "and the first row is the initial state again")
  local _, at = run("run " .. TOP .. " --at 0,0.25,0.5,0.75,1")
  tap.is(at, out, "--at with the same times gives the same table")
  local _, set = run("run " .. TOP .. " --until 1 --every 0.25 --set r=30")
  tap.is(set, out, "--set r=30 is the default of 30 mm, in its own unit")
  _, set = run("run " .. TOP .. " --until 1 --every 0.25 --set r=31")
  tap.ok(set ~= out, "--set r=31 is not")
  status = run("run " .. TOP .. " --until 1 --every 0.25 -o " .. dir .. "/table.csv")
  tap.ok(status == 0 and program.read(dir .. "/table.csv") == out, "-o writes the table to a file")
  tap.is(program.read(dir .. "/stdout"), "", "and then standard output is empty")
  local _, text = run("run " .. TOP .. " --until 1 --every 0.25 --format json")
  local t = json(text)
  tap.ok(#t.columns == 12 and #t.rows == 5 and #t.rows[5] == 12, "--format json has columns and rows")
  local last = {}
  for cell in lines[6]:gmatch "[^,]+" do last[#last + 1] = tonumber(cell) end
  local same = true
  for i = 1, 12 do same = same and last[i] == t.rows[5][i] end
  tap.ok(same, "with the same numbers")
  local _, whole = run("run " .. TOP)
  tap.ok(lines_of(whole)[102]:match "^2%.0,", "without times: a hundred steps to the scene's horizon")
end

do -- two roads to one number
  local function table_of(arguments)
    local status, out, err = run("run " .. arguments)
    local rows = {}
    for i, line in ipairs(lines_of(out)) do
      if i > 1 then
        local row = {}
        for cell in line:gmatch "[^,]+" do row[#row + 1] = tonumber(cell) end
        rows[#rows + 1] = row
      end
    end
    return rows, status, err
  end
  -- Tight adaptive integration against closed form or RK4 with h = 1e-4: h^4 w^5 t/120 is below 1e-11 for w of the
  -- size of 4 over 1 s; 1e-9 leaves room, and a slip in either road shows in the first digits.
  for _, case in ipairs { { TOP, "exact" }, { TOP, "rk4" }, { FREE, "rk4" } } do
    local times = " --at 0.3,0.7,1"
    local a, status_a, err_a = table_of(case[1] .. " --engine general --tolerance 1e-13" .. times)
    local step = case[2] == "rk4" and " --step 1e-4" or ""
    local b, status_b, err_b = table_of(case[1] .. " --engine generated --method " .. case[2] .. step .. times)
    local off = (#a == 3 and #b == 3) and 0 or math.huge
    for i = 1, math.min(#a, #b) do
      for k = 2, 12 do
        local scale = k >= 10 and math.abs(a[i][10]) + math.abs(a[i][11]) + math.abs(a[i][12]) or k == 9 and a[i][9]
          or k >= 6 and 20 or 1
        off = math.max(off, math.abs(a[i][k] - b[i][k]) / scale)
      end
    end
    tap.ok(status_a == 0 and status_b == 0 and off < 1e-9,
      "run: the general engine and the generated " .. case[2] .. " agree for " .. case[1]:match "[^/]*$",
      string.format("off by %g\n%s%s", off, err_a, err_b))
  end
end
for _, case in ipairs {
  { "--at 1 --until 2", "--at and --until/--every exclude each other" }, { "--until 0", "--until must be positive" },
  { "--until 1 --every -1", "--every must be positive" }, { "--every 1e-9", "--every is too small" },
  { "--at 1,x", "--at must be numbers with commas between, got 1,x" }, { "--step fast", "--step must be a number" },
  { "--method magic", "--engine general has the methods" },
  { "--engine generated --method magic", "--engine generated has the methods exact, rk4" },
} do
  local status, out, err = run("run " .. TOP .. " " .. case[1])
  tap.ok(status == 2 and out == "" and err:find(case[2], 1, true), "run " .. case[1] .. ": " .. case[2] .. ", status 2",
    status .. " " .. err)
end
do
  local status, out, err = run "run bodies/gyroscope.lua --engine generated --method exact"
  tap.ok(status == 2 and out == "" and err:find("no closed form", 1, true), "run: no closed form, no exact method", err)
end

-- ---- explain ----

do
  local status, out, err = run("explain " .. TOP)
  tap.ok(status == 0 and err == "" and out:find("Ixx = ", 1, true), "explain prints the tensor")
  local _, text = run("explain " .. TOP .. " --format text")
  tap.is(text, out, "text is the format without a name")
  local j
  status, text, err = run("explain " .. TOP .. " --format json")
  tap.ok(status == 0 and err == "" and pcall(function() j = json(text) end), "--format json is JSON", err)
  j = j or {}
  local missing = {}
  for key in ("name mass com inertia centroidal principal symmetry closed_form stability effects methods cost warnings")
    :gmatch "%S+" do
    if j[key] == nil then missing[#missing + 1] = key end
  end
  tap.is(table.concat(missing, " "), "", "with every key that is promised")
  -- pi 0.03^2 0.12 2700 kg, and the moments of the handbooks
  local m = math.pi * 0.03 ^ 2 * 0.12 * 2700
  local why = "a few ulp over ten operations"
  tap.near(j.mass, m, 8e-16, 0, "the mass of the cylinder", why)
  local across, along = m * (3 * 0.03 ^ 2 + 0.12 ^ 2) / 12, m * 0.03 ^ 2 / 2
  tap.near(j.inertia.numeric[1], across, 2e-15, 0, "M (3 r^2 + h^2)/12", why)
  tap.near(j.inertia.numeric[3], along, 2e-15, 0, "M r^2/2", why)
  tap.near(j.principal.moments[1], along, 2e-15, 0, "principal moments ascend", why)
  tap.ok(#j.principal.axes == 3 and #j.principal.axes[3] == 3 and #j.com == 3 and #j.inertia.numeric == 6,
    "three axes of three numbers, a centre of three, a tensor of six")
  local _, latex = run("explain " .. TOP .. " --format latex")
  tap.like(latex, "\\frac", "--format latex has formulas")
  local _, markdown = run("explain " .. TOP .. " --format markdown")
  tap.ok(markdown:find("# top", 1, true) == 1, "--format markdown begins with the name", markdown:sub(1, 40))
  local _, once, twice = nil, select(2, run("explain " .. TOP)), select(2, run("explain " .. TOP))
  tap.is(once, twice, "explain says the same twice")
  local _, set = run("explain " .. TOP .. " --set r=60 --format json")
  tap.near(json(set).mass, 4 * m, 8e-16, 0, "--set r=60 makes the mass four times as large", why)
end

-- ---- several scenes, and where they are ----

do
  local status, _, err = run("explain " .. dir .. "/nowhere.lua")
  tap.ok(status == 2 and err:find("nowhere.lua", 1, true), "a scene that cannot be read: status 2 and its name", err)
  program.write(dir .. "/empty.lua", "")
  status, _, err = run("explain " .. dir .. "/empty.lua")
  tap.ok(status == 1 and err:find("the script must end with: return scene", 1, true), "an empty scene: status 1", err)
  program.write(dir .. "/-dash.lua", program.read(FREE))
  local plain = os.getenv "POLHODE" or "build/polhode"
  status = program.shell("cd " .. dir .. " && " .. (plain:sub(1, 1) == "/" and plain or "$OLDPWD/" .. plain) ..
    " explain ./-dash.lua >/dev/null 2>&1")
  tap.is(status, 0, "a file whose name begins with a dash is given as ./-dash.lua")
end

tap.done(program.finish())
