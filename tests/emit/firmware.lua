-- firmware.lua - helper of the tests of `gen --project firmware`: makes projects, runs them, reads their telemetry.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local firmware = require "tests.emit.firmware"
--     firmware.make(dir, scene, options)            -> the project's folder, or nil and the message
--     firmware.run(folder, "make -s host")          -> text, did it end well
--     firmware.read(text)                           -> {S = {{cycle, x1, ..}, ..}, V =, E =, R =, F =}
--     firmware.truth(dir, scene, times)             -> states by the general library, long double inside

local program = require "tests.cli.program"

local firmware = {}

local binary = os.getenv "POLHODE" or "build/polhode"

function firmware.run(folder, command)
  local quoted = string.gsub(command, "'", "'\\''")
  local pipe = assert(io.popen(string.format("cd '%s' && timeout -s KILL 120 sh -c '%s' 2>&1", folder, quoted)))
  local text = pipe:read "a"
  return text, pipe:close() == true
end

-- scene: a path, or a scene's text and the name of a file for it
function firmware.make(dir, scene, options)
  local name = string.match(scene, "([%w_]+)%.lua$")
  if not name then
    name = string.match(scene, "name = \"([%w_]+)\"")
    program.write(dir .. "/" .. name .. ".lua", scene)
    scene = dir .. "/" .. name .. ".lua"
  end
  local folder = dir .. "/" .. name .. string.gsub(options or "", "[^%w]", "")
  local text, ok = firmware.run(".", string.format("%s gen %s %s -o %s", binary, scene, options or "", folder))
  if not ok then return nil, text end
  return folder, text
end

local function value(word)
  if #word == 16 then return (string.unpack(">d", (string.gsub(word, "%x%x", function(h)
    return string.char(tonumber(h, 16))
  end)))) end
  return (string.unpack("<f", string.pack("<I4", tonumber(word, 16))))
end

-- Lines by their letter; of S and V the first word is a whole number and the rest numbers of the type.
function firmware.read(text)
  local out = { S = {}, V = {}, E = {}, R = {}, F = {} }
  for letter, rest in string.gmatch(text, "%f[^\n\0](%u)( [%x ]+)%f[\n\0]") do
    local row = {}
    for word in string.gmatch(rest, "%x+") do
      local number = (letter == "S" or letter == "V") and #row > 0
      row[#row + 1] = number and value(word) or tonumber(word, 16)
    end
    if out[letter] then table.insert(out[letter], row) end
  end
  return out
end

-- States by the general library at the times, one row each.
function firmware.truth(scene, times)
  local list = {}
  for i, t in ipairs(times) do list[i] = string.format("%.17g", t) end
  local text, ok = firmware.run(".", string.format("%s run %s --engine general --at %s", binary, scene,
    table.concat(list, ",")))
  if not ok then error(text) end
  local rows = {}
  for line in string.gmatch(text, "[^\n]+") do
    local row = {}
    for word in string.gmatch(line, "[^,]+") do row[#row + 1] = tonumber(word) end
    if #row > 7 and row[1] then rows[#rows + 1] = { table.unpack(row, 2) } end
  end
  assert(#rows == #times, "one row a time")
  return rows
end

-- A box that tumbles about no axis in particular; all its numbers are exact in float, so that target and library are
-- given the same body, and the step is a power of two.
firmware.probe = [[
local a, b, c = param("a", 0.25, "m"), param("b", 0.125, "m"), param("c", 0.0625, "m")
return scene {
  name = "probe",
  body = solid.box { x = a, y = b, z = c, mass = 1 },
  initial = { omega = { 0.375, 0.25, 3 } },
  time = { horizon = 32, step = exact("1/4096") },
}
]]

return firmware
