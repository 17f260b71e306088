#!/usr/bin/env lua5.4
-- help.t: every option is explained, every example works, and docs/commands.md says what the program says.
-- SPDX-License-Identifier: GPL-3.0-or-later
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local commands = require "docs.tools.commands"
local help = require "generator.commands.help"

local dir = program.directory()
local root = io.popen("pwd"):read "l"
local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = root .. "/" .. binary end
local quick = "env " .. program.quick_compiler() .. " " .. binary

local function run(arguments)
  local status = program.shell(string.format("cd %s && timeout 120 %s %s >stdout 2>stderr", dir, quick, arguments))
  return status, program.read(dir .. "/stdout"), program.read(dir .. "/stderr")
end

local function lines_of(text)
  local list = {}
  for line in text:gmatch "([^\n]*)\n" do list[#list + 1] = line end
  return list
end

-- ---- the tables ----

local KINDS = { text = true, texts = true, number = true, numbers = true, words = true, pair = true, pairs = true,
  ranges = true }

-- What is wrong with a row of options, in words.
local function row_faults(row)
  local name, kind, about = row[1], row[2], row[3]
  local faults = {}
  local function need(fine, what)
    if not fine then faults[#faults + 1] = name .. ": " .. what end
  end
  need(name:find "^%-%-%l[%l%-]*$" or name == "-o", "the name of an option")
  need(kind == false or type(kind) == "table" or KINDS[kind], "a kind of value")
  need(type(about) == "string" and #about >= 15 and not about:find "%.$", "an explanation without a full stop")
  if kind == false or kind == "pair" or kind == "pairs" or kind == "ranges" then
    need(row.default == nil and row.value == nil, "a flag and a pair have no value and no default")
  else
    need(type(row.default) == "string" and row.default ~= "", "what holds without it")
    need(row.value or type(kind) == "table" and not row.each, "a name for its value")
  end
  local meant = {}
  for choice in pairs(row.each or {}) do meant[choice] = true end
  for _, choice in ipairs(row.each and kind or {}) do
    need(row.each[choice], "the meaning of " .. choice)
    meant[choice] = nil
  end
  need(next(meant) == nil, "a meaning of what is no choice: " .. tostring(next(meant)))
  return faults
end

-- The text of all of the generator in which an option's value may be used.
local sources = ""
for _, folder in ipairs { "generator/commands", "generator/commands/run", "generator/commands/sweep",
  "generator/commands/design", "generator/report", "generator" } do
  for name in io.popen("ls " .. folder .. "/*.lua"):lines() do sources = sources .. program.read(name) end
end

for _, name in ipairs(help.names) do
  local command = help.of(name)
  local page, faults, known = help.page(name), {}, {}
  for _, row in ipairs(command.options) do
    for _, fault in ipairs(row_faults(row)) do faults[#faults + 1] = fault end
    if known[row[1]] then faults[#faults + 1] = row[1] .. " has two rows" end
    known[row[1]] = true
    if not page:find("\n  " .. row[1]:gsub("%-", "%%-") .. "%s") then
      faults[#faults + 1] = row[1] .. " is not on the page"
    end
    local key = row[1]:gsub("^%-+", ""):gsub("%-", "_")
    if not (sources:find("given%." .. key .. "%f[^%w_]") or sources:find('given["' .. key .. '"]', 1, true) or
        sources:find("options%." .. key .. "%f[^%w_]")) then
      faults[#faults + 1] = row[1] .. " is read by nobody"
    end
  end
  tap.ok(#faults == 0, name .. ": every option is explained and used", table.concat(faults, "\n"))
  local stray = {}
  for option in page:gmatch "%f[%w-](%-%-%l[%l-]*)" do
    if not known[option] then stray[#stray + 1] = option end
  end
  tap.ok(#stray == 0, name .. ": help explains no option that it has not", table.concat(stray, " "))
  local wide = {}
  for _, line in ipairs(lines_of(page)) do
    if utf8.len(line) > 80 and not line:find "^  polhode " and not line:find "^usage" then wide[#wide + 1] = line end
  end
  tap.ok(#wide == 0 and #command.forms >= 1 and #command.examples >= 1 and command.operands[3],
    name .. ": a page of 80 columns, with forms, operands and examples", table.concat(wide, "\n"))
  local status, out, err = run("help " .. name)
  tap.ok(status == 0 and err == "" and out == page, "polhode help " .. name .. " prints it", err)
end

do
  local status, out, err = run "help"
  local lines, wide = lines_of(out), 0
  for _, line in ipairs(lines) do wide = math.max(wide, #line) end
  tap.ok(status == 0 and err == "" and #lines <= 24 and wide <= 80, "polhode help fits a screen of 24 x 80",
    #lines .. " lines, " .. wide .. " columns")
  local missing = {}
  for _, name in ipairs(help.names) do
    if not out:find("\n  " .. name .. " ", 1, true) then missing[#missing + 1] = name end
  end
  tap.is(table.concat(missing, " "), "", "and names every command")
  tap.is(program.read "docs/commands.md", commands.page(), "docs/commands.md is up to date (make docs)")
  local _, again = run "run --help"
  tap.is(again, help.page "run", "run --help is help run")
  _, again = run "--help"
  tap.is(again, out, "--help is help")
  status, again, err = run ""
  tap.ok(status == 2 and again == "" and err == out, "no command at all: the same on standard error, status 2")
end

-- ---- the examples ----

-- A tetrahedron, a robot and inputs, for the examples that read files.
program.write(dir .. "/part.stl", [[
solid part
facet normal 0 0 -1 outer loop vertex 0 0 0 vertex 0 30 0 vertex 20 0 0 endloop endfacet
facet normal 0 -1 0 outer loop vertex 0 0 0 vertex 20 0 0 vertex 0 0 10 endloop endfacet
facet normal -1 0 0 outer loop vertex 0 0 0 vertex 0 0 10 vertex 0 30 0 endloop endfacet
facet normal 1 1 1 outer loop vertex 20 0 0 vertex 0 30 0 vertex 0 0 10 endloop endfacet
endsolid part
]])
program.write(dir .. "/robot.urdf", [[<robot name="r"><link name="arm"><inertial><mass value="2"/>
<inertia ixx="0.1" iyy="0.2" izz="0.2" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>]])

program.write(dir .. "/torques.csv", "t,roll [mN m],pitch [mN m],yaw [mN m],coil [A m^2]\n0,1,0,0,0\n60,0,0,0,0.1\n")

-- A book with a phone in it: the log is that of a reference case.
program.write(dir .. "/phone.csv", program.read "tests/reference/fit/01_free_ratios/log.csv")
program.write(dir .. "/book.lua", [[
local I2, I3 = param("I2", 1.44, "kg m^2"), param("I3", 1.8, "kg m^2")
local w1, w2, w3 = param("w1", 0.91, "rad/s"), param("w2", 1.09, "rad/s"), param("w3", -0.41, "rad/s")
return scene { name = "book", body = tensor { mass = 1, xx = 1, yy = I2, zz = I3 },
  initial = { omega = { w1, w2, w3 } }, measure = { wx = wx, wy = wy, wz = wz, sigma = 0.004 } }
]])

-- What help says that a function of effect.custom reads, it can read; the word that stays unsaid would be refused.
for _, word in ipairs { "s.w", "s.q", "s.r", "s.v", "s.L", "s.t", "s.gain", "s.heat", "s.nothing" } do
  local _, said = run "help effect.custom"
  program.write(dir .. "/own.lua", string.format([[
return scene { name = "own", body = solid.sphere { r = 1, mass = 1 }, effects = { effect.translation {},
  effect.custom { params = { gain = 2 }, states = { heat = { rate = function(s) return 0 end } },
    torque = function(s) local read = %s return { 0, 0, read and 0 } end } } }
]], word))
  local status, _, err = run "explain own.lua"
  local known = said:find(word .. "%f[%W]") ~= nil
  tap.ok(known == (word ~= "s.nothing") and status == (known and 0 or 1), "help effect.custom: " .. word, err)
end

-- The program that an example needs, beside those of `.ci/setup check`; nil if there is one or none is needed.
local function missing(line)
  local live = line:find "^polhode view" and not line:find "%-%-trajectory"
  local needs = live and "wasm-ld" or (line:find "%.png" or line:find "%.pdf") and "rsvg-convert"
  return needs and program.shell("command -v " .. needs .. " >/dev/null") ~= 0 and needs or nil
end

for _, name in ipairs(help.names) do
  for _, example in ipairs(help.of(name).examples) do
    local line = example[1]
    tap.ok(line:find("^polhode " .. name .. " ") and #example[2] > 10, line .. ": says what it shows")
    if name == "bench" then
      tap.skip(line, "it measures for a minute (tests/cli/bench.t)")
    elseif missing(line) then
      tap.skip(line, "without " .. missing(line))
    else
      local status, out, err = run(line:gsub("^polhode ", ""))
      err = err:gsub("^note: book is the installed scene[^\n]*\n", "") -- beside the book.lua of fit's example
      -- a result on standard output
      local wants = name == "fit" or name ~= "gen" and name ~= "view" and not line:find " %-o "
      tap.ok(status == 0 and err == "" and (out ~= "") == wants, line .. ": works",
        status .. "\n" .. err .. out:sub(1, 300))
    end
  end
end

tap.done(program.finish())
