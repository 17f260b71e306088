#!/usr/bin/env lua5.4
-- difference.t - explain --diff A B: what is added, removed and changed between two scenes; the rows of `rhs`.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local json = require "tests.json"
local program = require "tests.cli.program"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()

local function scene(name, effects, more)
  local path = dir .. "/" .. name .. ".lua"
  program.write(path, "return scene { name = \"" .. name .. "\",\n  body = solid.box { x = param(\"a\", 1, \"m\"), " ..
    "y = 2, z = 3, mass = 4 },\n  effects = {" .. effects .. "}, " .. (more or "") .. " }\n")
  return path
end

local function run(words)
  local code = program.shell(binary .. " explain " .. words .. " >" .. dir .. "/out 2>" .. dir .. "/err")
  return code, program.read(dir .. "/out"), program.read(dir .. "/err")
end

local free = scene("free", "")
local damped = scene("damped", 'effect.damping { c = param("k", 2, "N m s") }')
local spun = scene("spun", "effect.wheel { axis = {0, 0, 1}, inertia = 0.1, included = false }")
local rates = scene("rates", "", "outputs = { \"rates\" }")

-- the changes of a section as "change what", in order
local function changes(j, section)
  local list = {}
  for i, c in ipairs(j[section]) do list[i] = c.change .. " " .. c.what end
  return table.concat(list, ", ")
end

local SECTIONS = { "parameters", "states", "constants", "equations", "terms", "conserved", "closed_form", "operations" }

do
  local code, text = run("--diff " .. free .. " " .. damped .. " --format json")
  tap.is(code, 0, "a damped body and a free one: exit status")
  local j = json.read(text)
  tap.is(changes(j, "parameters"), "added k", "one more parameter")
  tap.is(changes(j, "states"), "", "the same states")
  tap.is(changes(j, "conserved"), "removed T+V, removed |L|, removed L, removed L_z", "what is no longer conserved")
  tap.is(changes(j, "equations"), "changed Euler, principal axes, added damping", "the groups of equations")
  tap.is(#j.terms, 3, "three terms more")
  for i, name in ipairs { "wx", "wy", "wz" } do
    tap.ok(j.terms[i].change == "added" and j.terms[i].what:find("^d" .. name .. "/dt: %-"), "a term of " .. name,
      j.terms[i].what)
  end
  tap.is(changes(j, "closed_form"), "changed closed form", "another closed form, or none")

  -- and back
  local _, back = run("--diff " .. damped .. " " .. free .. " --format json")
  local b, swapped = json.read(back), true
  for _, s in ipairs(SECTIONS) do
    local opposite = { added = "removed", removed = "added", changed = "changed" }
    local there, here = {}, {}
    for _, c in ipairs(j[s]) do there[#there + 1] = opposite[c.change] .. c.what end
    for _, c in ipairs(b[s]) do here[#here + 1] = c.change .. c.what end
    table.sort(there)
    table.sort(here)
    swapped = swapped and table.concat(there, "\n") == table.concat(here, "\n")
  end
  tap.ok(swapped, "the other way round it is the opposite")
end

do
  local code, text = run("--diff " .. free .. " " .. spun .. " --format json")
  tap.is(code, 0, "a wheel: exit status")
  tap.is(changes(json.read(text), "states"), "added wheel", "a wheel is a state more")
  code, text = run("--diff " .. free .. " " .. rates .. " --format json")
  tap.is(code, 0, "rates alone: exit status")
  tap.is(changes(json.read(text), "states"), "removed qw, removed qx, removed qy, removed qz", "four states less")
end

for _, path in ipairs { free, damped, spun } do
  local code, text = run("--diff " .. path .. " " .. path)
  tap.ok(code == 0 and text:find "\nno difference\n$", "a scene and itself: no difference", text)
end

do
  local code, text = run("--diff " .. free .. " " .. damped)
  tap.is(code, 0, "text: exit status")
  tap.ok(text:find("\nParameters\n  + k: 2 N m s\n", 1, true), "text: the parameter", text)
  tap.ok(text:find("\n  - T+V\n", 1, true), "text: the energy", text)
end

-- what cannot be
for _, c in ipairs {
  { "--diff " .. free, "--diff needs two scenes" }, { free .. " " .. damped, "too many operands" },
  { "--diff " .. free .. " " .. damped .. " --format latex", "--format must be text or json" },
  { "--diff " .. free .. " " .. dir .. "/nowhere.lua", "nowhere.lua" },
} do
  local code, text, err = run(c[1])
  tap.ok(code == 2 and text == "" and err:find(c[2], 1, true), c[2], err)
end

-- the table of the right-hand side, in the three formats
do
  local _, text = run(damped)
  tap.ok(text:find("\n    damping (line 3): 3 + -, 3 *; constants that only it needs: Cxx_I, Cxx_Iyy, Cxx_Izz\n", 1,
    true), "text: operations and constants of the damping", text:match "rhs: .*")
  tap.ok(text:find("rhs: 11 + -, 24 *; of these", 1, true), "text: of all")
  local _, markdown = run(damped .. " --format markdown --sections costs")
  tap.ok(markdown:find("damping (line 3): 3 + -, 3 *", 1, true), "markdown: the same")
  local _, out = run(damped .. " --format json")
  local j = json.read(out).rhs
  tap.is(j.total.mul .. " " .. j.total.add, "24 11", "json: of all")
  local row = j.rows[#j.rows]
  tap.is(row.what .. " " .. row.line .. " " .. row.mul .. " " .. row.add .. " " .. #row.constants, "damping 3 3 3 3",
    "json: of the damping")
end

program.finish()
tap.done()
