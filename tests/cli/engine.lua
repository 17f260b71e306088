-- engine.lua - asks the library through the program: what engine.t and engine_mass.t share.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The texts are Lua for the program's host; before them stand a box, a scene around a body, and row(), which prints.

local tap = require "tests.tap"
local program = require "tests.cli.program"

local engine = { dir = program.directory() }

-- A few roundings of a double in sums of a few terms.
local FEW_ULP = 4e-15

local PRELUDE = [[
local function row(v) local out = {} for i, x in ipairs(v) do out[i] = string.format("%.17g", x) end
  return table.concat(out, " ") end
local box = { shape = "solid.box", mass = 2.4, x = 0.2, y = 0.1, z = 0.05 }
local function scene(body, effects, more)
  local s = { name = "s", body = body, origin = { 0, 0, 0 }, effects = effects or {}, q = { 1, 0, 0, 0 },
    w = { 0.1, 6.0, 0.2 } }
  for k, v in next, more or {} do s[k] = v end
  return s
end
]]

-- What the text says, or nil and its message as a diagnostic.
function engine.lua(text, ...)
  local code, out, err = program.run(PRELUDE .. text, engine.dir, ...)
  if code ~= 0 then
    tap.diag(err)
  end
  return code == 0 and out or nil
end

function engine.numbers(text)
  local v = {}
  for word in (text or ""):gmatch("%S+") do
    v[#v + 1] = tonumber(word)
  end
  return v
end

-- The numbers that `text` says, against `want`, each to a few units of rounding of the largest.
function engine.gives(name, text, want, tolerance)
  local got, largest = engine.numbers(engine.lua(text)), 0
  for _, x in ipairs(want) do
    largest = math.max(largest, math.abs(x))
  end
  local good = #got == #want
  for i = 1, #want do
    good = good and math.abs(got[i] - want[i]) <= (tolerance or FEW_ULP) * largest
  end
  tap.ok(good, name, "got  " .. table.concat(got, " ") .. "\nwant " .. table.concat(want, " "))
end

function engine.says(name, text, want)
  tap.is(engine.lua(text), want, name)
end

return engine
