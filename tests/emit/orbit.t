#!/usr/bin/env lua5.4
-- orbit.t - the constant orbit that a baked scene gets: its states against the oracle's, beside those of NAME_solve.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The oracle (tests/oracle/free_top.c) takes the doubles that NAME_initial and the tensor are, exactly.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"

local dir = program.directory()
local oracle = os.getenv "POLHODE_ORACLE" or "build/oracle/free_top"

-- As tests/emit/top.t argues: 18 units, of 2^-52 or 2^-23 (float: as required).
local BAR = { double = 4e-15, float = 4e-6 }

local bodies = {
  { "generic, about the largest", { 1, 2, "5/2", 0, 0, 0 }, { 0.3, -0.7, 2 } },
  { "generic, about the smallest", { 5, 7, 9, 0, 0, 0 }, { 3, 1, -0.5 }, "double" },
  { "brick of NASA", { 0.001894220, 0.006211019, 0.007194665, 0, 0, 0 }, { 0.1745, 0.349, 0.5236 }, "float" },
  { "full tensor", { 2, 3, "7/2", "1/3", "-1/5", "2/7" }, { 1, 2, -0.5 } },
  { "lamina", { 1, 2, 3, 0, 0, 0 }, { 1, 0.5, 0.7 } },
  { "on the separatrix", { 4, 5, 9, 0, 0, 0 }, { 3, 0.5, 1 } },
  { "one unit beside it", { 4, 5, 9, 0, 0, 0 }, { 3, 0.5, "1.0000000000000002" }, "double" },
  { "beside it, one part in 10^6", { 9, 4, 5, 0, 0, 0 }, { 1, 3.000003, 0.5 } },
  { "1e-8 from the saddle", { 2, 3, 4, 0, 0, 0 }, { 1e-8, 1, 0 } },
  { "1e-100 from the saddle", { 2, 3, 4, 0, 0, 0 }, { 0, -1, 1e-100 }, "double" },
  { "k^2 near 0.99, where the series are used longest", { 1, 2, 3, 0, 0, 0 }, { 1.74, 0.1, 1 } },
  { "symmetric to 1e-12", { 1, "1.000000000001", "3/2", 0, 0, 0 }, { 0.5, 0.1, 2 } },
  { "almost a rod", { "1e-12", 1, "1.0000000000005", 0, 0, 0 }, { 4, 0.1, 2 }, "double" },
  { "large and slow", { "1e30", "2e30", "2.5e30", 0, 0, 0 }, { "1e-20", "2e-20", "-1e-20" } },
  { "spin about the middle axis", { 2, 3, 4, 0, 0, 0 }, { 0, 2, 0 } },
  { "at rest", { 2, 3, 4, 0, 0, 0 }, { 0, 0, 0 } },
}

local function text(list)
  local out = {}
  for i, x in ipairs(list) do out[i] = type(x) == "string" and string.format("%q", x) or tostring(x) end
  return table.concat(out, ", ")
end

local function source(b)
  local keys, entries = { "xx", "yy", "zz", "xy", "xz", "yz" }, {}
  for i, k in ipairs(keys) do entries[i] = k .. " = " .. text { b[2][i] } end
  return string.format([[return scene { name = "body", body = tensor { mass = 1, %s },
    initial = { omega = { %s }, attitude = { 0.5, -0.1, 0.7, 0.3 } }, time = { step = 1/512, horizon = 1 } }]],
    table.concat(entries, ", "), text(b[3]))
end

-- Errors by kind of line: {rates, attitude} at worst.
local function measure(b, real, times, ticks)
  local job = assert(scene.read(source(b)))
  scene.plan(job, { real = real })
  local files = scene.files(job)
  program.write(dir .. "/body.h", files["body.h"])
  program.write(dir .. "/body.c", files["body.c"])
  program.write(dir .. "/times", table.concat(times, "\n") .. "\n")
  local code = program.shell(string.format("(gcc -std=c11 -O0 -I%s -o %s/run tests/emit/orbit.c " ..
    "%s/body.c -lm 2>&1 && %s/run %s <%s/times) >%s/out", dir, dir, dir, dir, ticks and "y" or "n", dir, dir))
  local out = program.read(dir .. "/out")
  if not tap.is(code, 0, real .. ", " .. b[1] .. ": compiles and runs", out) then return end
  local tensor, kinds, lines, start = {}, {}, {}, nil
  for i = 1, 6 do
    local q = R.lift(b[2][i])
    tensor[i] = string.format("%a", real == "float" and R.tofloat(q) or R.todouble(q))
  end
  for kind, t, x in string.gmatch(out, "(%a+) (%S+) ([^\n]+)") do
    if kind == "start" then
      start = x
    else
      kinds[#kinds + 1] = kind
      lines[#lines + 1] = table.concat({ table.concat(tensor, " "), start, t, x }, " ")
    end
  end
  program.write(dir .. "/lines", table.concat(lines, "\n") .. "\n")
  tap.is(program.shell(string.format("%s -e <%s/lines >%s/errors", oracle, dir, dir)), 0, "the oracle answers")
  local worst, n = {}, 0
  for rates, attitude in string.gmatch(program.read(dir .. "/errors"), "(%S+) (%S+)") do
    n = n + 1
    local w = worst[kinds[n]] or { 0, 0 }
    w[1] = math.max(w[1], tonumber(rates) or math.huge)
    w[2] = math.max(w[2], 2 * (tonumber(attitude) or math.huge)) -- as an angle
    worst[kinds[n]] = w
  end
  tap.is(n, #lines, "to every line")
  return worst
end

local all = {}
for _, real in ipairs { "double", "float" } do
  for _, b in ipairs(bodies) do
    if not b[4] or b[4] == real then
      local w = 0.0
      for i = 1, 3 do w = math.max(w, math.abs(R.todouble(R.lift(b[3][i])))) end
      local unit = 1 / (w > 0 and w or 1)
      -- up to 1e6 radians and more; a float holds 2^-47 of a turn for each
      local times = {}
      for _, t in ipairs { 0, 0.7, -3, 11, 40, 300, -5e3, real == "float" and 2e4 or 7e6 } do
        times[#times + 1] = string.format("%a", t * unit)
      end
      local worst = measure(b, real, times, unit < 100 and unit > 0.01)
      if worst then
        for _, kind in ipairs { "own", "tick" } do
          local e = worst[kind]
          if e then
            tap.ok(e[1] <= BAR[real] and e[2] <= BAR[real], string.format("%s, %s, %s: rates %.2g, attitude %.2g (" ..
              "solved %.2g, %.2g)", real, b[1], kind, e[1], e[2], worst.solved[1], worst.solved[2]))
            all[real .. kind] = math.max(all[real .. kind] or 0, e[1], e[2])
          end
        end
        all[real .. "solved"] = math.max(all[real .. "solved"] or 0, worst.solved[1], worst.solved[2])
      end
    end
  end
  -- coefficients rounded once from many digits are no worse than those computed; two roundings may fall otherwise
  tap.ok(all[real .. "own"] <= all[real .. "solved"] + BAR[real] / 9, string.format(
    "%s: worst %.2g, in ticks %.2g, after NAME_solve %.2g", real, all[real .. "own"], all[real .. "tick"],
    all[real .. "solved"]))
end

-- ---- who gets one ----

local with = [[local a = param("a", 2, "kg m^2")
return scene { name = "body", body = tensor { mass = 1, xx = a, yy = 3, zz = 4 } }]]
for bake, expected in pairs { [true] = true, [false] = false } do -- order does not matter
  local job = scene.plan(assert(scene.read(with, { bake = bake })), {})
  local header = scene.files(job)["body.h"]
  tap.is(string.find(header, "extern const body_orbit body_own_orbit;", 1, true) ~= nil, expected,
    "a scene with parameters has a constant orbit only when it is baked")
end

program.finish()
tap.done()
