-- long.lua -- compiles a stepper of a scene with long.c and runs it; and its error against the library.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local build = long.build("midpoint", body, effects, { real = "float", heavy = 4, rotor = {3, 0, 4} })
--     local got = long.run(build, 0.1, 100000)      got.L, got.first = {low, high}, ...: see long.c
--     local list = long.errors("midpoint", scene text, { 0.02, 0.01, 0.005 }, t)

local tap = require "tests.tap"
local program = require "tests.cli.program"
local scene = require "tests.scene"
local driver = require "generator.driver"

local long = {}

long.start = "omega = {0.5, 1.5, 1}, attitude = { quaternion = {0.5, 0.5, 0.5, -0.5} }"

function long.scene(body, effects, start)
  return 'return scene { name = "top", body = ' .. body .. ", origin = {0, 0, 0}, effects = { " .. effects ..
    " }, initial = { " .. (start or long.start) .. " } }\n"
end

local number = 0

function long.build(method, body, effects, options)
  number = number + 1
  local folder = string.format("%s/%d", program.directory(), number)
  local job = assert(scene.read(long.scene(body, effects, options.start)))
  job = assert(driver.plan(job, { real = options.real, command = "polhode gen top.lua", methods = { method } }))
  local files, rotor = scene.files(job), options.rotor or { 0, 0, 0 }
  program.shell("mkdir -p " .. folder)
  for _, name in ipairs { "top.h", "top.c" } do program.write(folder .. "/" .. name, files[name]) end
  local strict = "-pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"
  local others = options.heavy and "'clang -std=c99' 'g++ -x c++'" or "" -- torque or none, the text has the same parts
  local code = program.shell(string.format("(for cc in 'gcc -std=c99' %s; do $cc %s -c %s/top.c -o %s/any.o || " ..
    "exit 1; done; gcc -std=c11 -O2 -ffp-contract=off -I%s -DSTEP=top_step -DHEAVY=%s -DROTOR_X=%s -DROTOR_Z=%s " ..
    "tests/methods/long.c %s/top.c -o %s/long -lm) >%s/log 2>&1", others, strict, folder, folder, folder,
    options.heavy or 0, rotor[1], rotor[3], folder, folder, folder))
  tap.ok(code == 0, method .. ", " .. body .. ": compiles without a warning", program.read(folder .. "/log"))
  return folder .. "/long"
end

function long.run(build, h, steps)
  local pipe = io.popen(string.format("%s %.17g %d", build, h, steps))
  local text, out = pipe:read "a", { }
  pipe:close()
  out.text = text
  for name, value in string.gmatch(text, "(%w+)=(%S+)") do
    local low, high = string.match(value, "^(.-):(.+)$")
    out[name] = low and { tonumber(low) or math.huge, tonumber(high) or math.huge } or tonumber(value) or math.huge
  end
  return out
end

local binary = os.getenv "POLHODE" or "build/polhode"

-- Largest error of the state at time t by the method's step sizes; the library is run to 1e-13.
function long.errors(method, text, steps, t)
  local path, rows = program.directory() .. "/scene.lua", {}
  program.write(path, text)
  local function row(more)
    local out = program.directory() .. "/csv"
    local code = program.shell(string.format("POLHODE_SOURCE=. %s run %s --at %.17g %s > %s 2>&1", binary, path, t,
      more, out))
    local list, csv = {}, program.read(out)
    if code ~= 0 then return nil, csv end
    for word in string.gmatch(string.match(csv, "\n([^\n]*)"), "[^,]+") do list[#list + 1] = tonumber(word) end
    return list
  end
  local true_row, why = row "--tolerance 1e-13"
  if not true_row then return nil, why end
  for i, h in ipairs(steps) do
    local got, wrong = row(string.format("--engine generated --method %s --step %.17g", method, h))
    if not got then return nil, wrong end
    rows[i] = 0.0
    for k = 2, 8 do rows[i] = math.max(rows[i], math.abs(got[k] - true_row[k])) end
  end
  return rows
end

return long
