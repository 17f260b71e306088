#!/usr/bin/env lua5.4
-- flight.t - bodies under constant forces at the centre of mass, in closed form: a parabola, and a free top.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracles: the formula r0 + v0 t + (g + F/m) t^2/2 in rationals; for the turning, the general library's exact solver on
-- the same body without effects; and `check`, in which the library integrates the whole motion.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"

local ROUND = 4 * 2.0 ^ -52 -- three operations on numbers that are themselves rounded, of the largest term
local TURN = 1e-12 -- both solvers promise some 4e-15; a phase of 20 turns is rounded by each in its last place

local dir = program.directory()
local polhode = program.quick()

local bodies = {
  { "box", "solid.box { x = 0.1, y = 0.2, z = 0.5, mass = m }" },
  { "cylinder", "solid.cylinder { r = 0.1, h = 0.5, mass = m }" },
  { "ball", "solid.sphere { r = 0.1, mass = m }" },
  { "rod", "rod.straight { length = 0.1, mass = m }" },
  { "turned box",
    "solid.box { x = 0.1, y = 0.2, z = 0.5, mass = m }:turned { euler = \"zyx\", angles = {0.3, 0.2, 0.1} }" },
}

local function text(body, effects, omega, more)
  return "local F, m = param('F', 2, 'N'), param('m', 1.5, 'kg')\nreturn scene { name = 'b', body = " .. body ..
    ", effects = {" .. effects .. "}, initial = { " .. (omega and "omega = {1, 2, 3}, " or "") .. (more or "") ..
    " }, time = { horizon = 40 } }\n"
end

local START = "position = {0.1, 0.2, 3}, velocity = {1, 2, 0.25}"
local PUSH = "effect.translation { gravity = {0, 0, -9.81}, force = {F, 0, -0.5} }"
local function number(s) return R.parse(s) end
local r0, v0 = { number "0.1", number "0.2", R.new(3) }, { R.one, R.new(2), number "0.25" }
local g = { R.new(2) / number "1.5", R.zero, -number "9.81" - number "0.5" / number "1.5" }

-- The rows {t = .., rx = ..} of a run.
local function rows(name, source, arguments)
  program.write(dir .. "/" .. name .. ".lua", source)
  local status, out, err = program.output(string.format("%s run %s/%s.lua --at 0.5,7,-3,40 %s", polhode, dir, name,
    arguments))
  if status ~= 0 then return nil, err end
  local names, list
  for line in out:gmatch "[^\n]+" do
    local fields = {}
    for f in line:gmatch "[^,]+" do fields[#fields + 1] = f end
    if names then
      local row = {}
      for i, n in ipairs(names) do row[n] = tonumber(fields[i]) end
      list[#list + 1] = row
    else
      names, list = fields, {}
    end
  end
  return list
end

local function parabola(list)
  local worst = 0.0
  for _, row in ipairs(list) do
    local t = R.fromdouble(row.t)
    for i, c in ipairs { "x", "y", "z" } do
      local terms = { r0[i], v0[i] * t, g[i] * t * t / R.new(2) }
      local size = 0.0
      for _, x in ipairs(terms) do size = math.max(size, math.abs(R.todouble(x))) end
      worst = math.max(worst, math.abs(row["r" .. c] - R.todouble(terms[1] + terms[2] + terms[3])) / size)
      size = math.max(math.abs(R.todouble(v0[i])), math.abs(R.todouble(g[i] * t)))
      worst = math.max(worst, math.abs(row["v" .. c] - R.todouble(v0[i] + g[i] * t)) / size)
    end
  end
  return worst
end

for _, b in ipairs(bodies) do
  local got, why = rows("flight", text(b[2], PUSH, true, START), "--engine generated --method exact")
  tap.ok(got and #got == 4, b[1] .. ": the closed form is run", why)
  local worst = got and parabola(got) or math.huge
  tap.ok(worst <= ROUND, b[1] .. ": its centre is on the parabola of gravity and force", worst)
  local free
  free, why = rows("free", text(b[2], "", true), "--engine general --method exact")
  worst = free and 0.0 or math.huge
  for i, row in ipairs(free or {}) do
    for _, c in ipairs { "qw", "qx", "qy", "qz", "wx", "wy", "wz" } do
      worst = math.max(worst, math.abs(got[i][c] - row[c]) / (c:sub(1, 1) == "w" and math.sqrt(14) or 1.0))
    end
  end
  tap.ok(worst <= TURN, b[1] .. ": and it turns as the library's free body does", why or worst)
  program.write(dir .. "/flight.lua", text(b[2], PUSH, true, START):gsub("horizon = 40", "horizon = 2"))
  local status, out = program.output(polhode .. " check " .. dir .. "/flight.lua")
  tap.ok(status == 0 and out:find("the closed form agrees with the library's integration", 1, true),
    b[1] .. ": check: so says the library, which integrates it", out)
end

do -- no attitude is asked for
  local got, why = rows("point", text(bodies[1][2], PUSH, false, START), "--engine generated --method exact")
  tap.ok(got and parabola(got) <= ROUND, "a point under gravity and a force is on the same parabola", why)
end

---- what has no such form, and why ----

local function refused(effects, omega)
  local job = assert(scene.read(text(bodies[1][2], effects, omega)))
  local reasons = { job.closed.kind and "has " .. job.closed.kind or job.closed.refused }
  for _, o in ipairs(job.closed.others) do reasons[#reasons + 1] = o.reason end
  return table.concat(reasons, "; ")
end

for _, row in ipairs {
  { "effect.translation { thrust = {F, 0, 0} }", "the thrust turns with the body" },
  { "effect.translation { drag = 0.1 }", "drag slows the centre of mass" },
  { "effect.translation { stiffness = 2 }", "a force on the centre of mass depends on its place" },
  { "effect.translation { force = {quantity(1, \"N/s\")*t, 0, 0} }", "the force varies with the motion" },
  { "effect.translation { force = {F, 0, 0} }, effect.damping { rate = 0.1 }", "beside constant forces, damping acts" },
} do
  local got = refused(row[1], true)
  tap.ok(not got:find "^has" and got:find(row[2], 1, true), row[1] .. ": " .. row[2], got)
end

program.finish()

tap.done()
