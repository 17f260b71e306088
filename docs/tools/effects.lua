-- effects.lua -- docs/effects.md: every effect with formula, frame, signs, source and example, from the modules.
-- SPDX-License-Identifier: GPL-3.0-or-later

local conserved = require "generator.dynamics.conserved"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"

local effects = {}

local head = [[
# Effects

An effect is something that acts on a body. A scene lists its effects in `effects = {...}`. The equations of motion
have only these effects. An effect whose strength is the constant 0 leaves no byte in the generated code. You must
give each argument that has no default, unless another one takes its place. `make docs` makes this page from the
modules of `generator/effects`.

Units are SI. These symbols are used:

| symbol | meaning |
|---|---|
| N | torque, in body axes |
| q, R(q) | attitude from body to inertial axes, and its matrix |
| w | rates in body axes |
| r, v | position and velocity of the centre of mass, if it moves |
| T+V | total energy |
| L | angular momentum in inertial axes |
| w3 | rate about the axis z of a body that is symmetric about it |
| T+V-n.L | `NAME_jacobi_integral`, T + V - n L_z, where fields turn about inertial z at a rate n |

A scene conserves only what each of its effects conserves. `polhode explain` lists it.

polhode checks the dimension of every expression: each argument, both sides of each sum, arguments of functions (pure
numbers or angles), and the torques, forces and rates of states that a scene writes. A wrong dimension is an error at
its line. A plain number may have any unit. So `0.1*sin(2*t)` can be a torque. `wx`, `wx + qx`, and `N*t` with N in N
m cannot. Among plain numbers, `t` is the number of seconds.

]]

local function default(spec)
  if spec.optional then return "none" end
  if spec.default == nil then return "" end
  if type(spec.default) ~= "table" then return "`" .. tostring(spec.default) .. "`" end
  local list = {}
  for i, x in ipairs(spec.default) do list[i] = value.show(x) end
  return "`{" .. table.concat(list, ", ") .. "}`"
end

local signs = { positive = "positive", nonnegative = "not negative" }

-- Rows {argument, unit, default, about} of a module.
local function arguments(e)
  local rows = {}
  for i, t in ipairs(e.takes or {}) do
    rows[i] = { t[1], t[2], t[3] and "`" .. t[3] .. "`" or "", t[4] }
  end
  for _, a in ipairs(not e.takes and e.args or {}) do
    local words = { a.about, a.size and a.size .. " components", signs[a.sign] }
    local list = {}
    for k = 1, 3 do list[#list + 1] = words[k] end
    rows[#rows + 1] = { a.name, a.flag and "true or false" or units.si(units.of(a.dim or "none")), default(a),
      table.concat(list, ", ") }
  end
  return rows
end

-- What a scene of bodies/ says of itself: the comment that it begins with, without its name.
local function title(name, read)
  local words = {}
  for line in string.gmatch(read("bodies/" .. name .. ".lua") or "", "([^\n]*)\n") do
    local comment = string.match(line, "^%-%- (.*)$")
    if not comment or string.find(comment, "^SPDX") then break end
    words[#words + 1] = comment
  end
  return #words > 0 and (string.gsub(table.concat(words, " "), "^%S+%.lua %-+ ", "")) or error("no scene " .. name)
end

-- list: generator/effects/effects.lua; read(path) -> text or nil, in the project's root.
function effects.page(list, read)
  local out = { head }
  for _, e in ipairs(list) do
    out[#out + 1] = "[" .. e.name .. "](#" .. string.gsub(e.name, "[^%w_]", "") .. ")\n"
  end
  for _, e in ipairs(list) do
    out[#out + 1] = "\n## " .. e.name .. "\n\n" .. e.about .. ".\n\n`" .. e.formula .. "`\n\n"
    local rows = arguments(e)
    if #rows > 0 then
      out[#out + 1] = "| argument | unit | default | |\n|---|---|---|---|\n"
      for _, r in ipairs(rows) do
        for k = 1, 4 do r[k] = string.gsub(r[k], "|", "\\|") end
        out[#out + 1] = "| `" .. r[1] .. "` | " .. table.concat(r, " | ", 2) .. " |\n"
      end
      out[#out + 1] = "\n"
    end
    out[#out + 1] = "- Frame and signs: " .. e.signs .. ".\n- Conserves: " .. conserved.words(e) .. ".\n- Source: " ..
      e.source .. ".\n- Example: [" .. e.example .. ".lua](../bodies/" .. e.example .. ".lua): " ..
      title(e.example, read) .. "\n"
  end
  return table.concat(out)
end

return effects
