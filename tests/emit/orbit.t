#!/usr/bin/env lua5.4
-- orbit.t - constant orbits, as a baked scene gets one: their states against the oracle's, beside those of NAME_solve.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Two scenes (double, float), a tensor whose six entries are parameters; the orbits of many bodies and states are put
-- beside them in a table and compiled.  The oracle (tests/oracle/free_top.c) takes the same numbers exactly.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local scene = require "tests.scene"
local tops = require "tests.dynamics.tops"
local R = require "generator.algebra.rational"
local free_top = require "generator.dynamics.free_top"
local number = require "generator.emit.number"
local orbit = require "generator.emit.orbit"

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

local text = [[
local function entry(name, value) return param(name, value, "kg m^2") end
return scene { name = "body", body = tensor { mass = 1, xx = entry("xx", 1), yy = entry("yy", 2), zz = entry("zz", 2.5),
  xy = entry("xy", 0), xz = entry("xz", 0), yz = entry("yz", 0) } }
]]

-- Bodies above and random ones: {name, tensor, state, step, times}, rounded to the real type.
local function cases(real)
  local round, list = orbit.rounder(real), {}
  local function put(name, tensor, w, q)
    local c = { name = name, tensor = {}, state = {}, t = {} }
    local largest = 0.0
    for i = 1, 6 do c.tensor[i] = round(R.lift(tensor[i])) end
    for i = 1, 4 do c.state[i] = round(R.lift(q[i])) end
    for i = 1, 3 do
      c.state[4 + i] = round(R.lift(w[i]))
      largest = math.max(largest, math.abs(R.todouble(c.state[4 + i])))
    end
    local unit = 1 / (largest > 0 and largest or 1)
    -- 10^6 radians and more; in pairs of floats 2^-47 of a turn is lost in each
    for i, t in ipairs { 0, 0.7, -11, 300, -5e3, real == "float" and 2e4 or 7e6 } do
      c.t[i] = round(R.fromdouble(t * unit))
    end
    c.h = round(R.fromdouble(unit / 512))
    c.top = free_top.new(c.tensor, c.state, 224, R.new(2) ^ -20)
    list[#list + 1] = c
  end
  for _, b in ipairs(bodies) do
    if not b[4] or b[4] == real then put(b[1], b[2], b[3], { 0.5, -0.1, 0.7, 0.3 }) end
  end
  tops.seed(7)
  for n = 1, 2 * tops.kinds do
    local kind = n % tops.kinds
    local v = tops.draw(kind)
    -- a float holds no moment and no rate of some of them
    if real == "double" or not (kind == 7 or kind == 8 or kind == 1) then
      for i = 1, 13 do v[i] = R.fromdouble(v[i]) end
      put("kind " .. kind, { table.unpack(v, 1, 6) }, { table.unpack(v, 7, 9) }, { table.unpack(v, 10, 13) })
    end
  end
  return list
end

local function hex(list)
  local out = {}
  for i, q in ipairs(list) do out[i] = string.format("%a", R.todouble(q)) end
  return table.concat(out, " ")
end

for _, real in ipairs { "double", "float" } do
  local job = assert(scene.read(text))
  job = scene.plan(job, { real = real })
  local files = scene.files(job)
  local list, rows = cases(real), {}
  for n, c in ipairs(list) do
    local function numbers(a)
      local out = {}
      for i, q in ipairs(a) do out[i] = number.text(q, real) end
      return "{" .. table.concat(out, ", ") .. "}"
    end
    local lines = orbit.lines(orbit.of(c.top, c.h, real), real, true)
    rows[n] = string.format("{ %s, %s, %s,\n{%s} },", numbers(c.tensor), numbers(c.state), numbers(c.t),
      table.concat(lines, "\n"))
  end
  program.write(dir .. "/body.h", files["body.h"])
  program.write(dir .. "/body.c", files["body.c"])
  program.write(dir .. "/list.h", "static const struct {\n  body_real tensor[6], state[BODY_NX], t[6];\n" ..
    "  body_orbit orbit;\n} list[] = {\n" .. table.concat(rows, "\n") .. "\n};\n")
  local code = program.shell(string.format("(gcc -std=c11 -O1 -Wall -Wextra -Wconversion -ffp-contract=off -I%s " ..
    "-o %s/run tests/emit/orbit.c %s/body.c -lm && %s/run >%s/out) >%s/log 2>&1", dir, dir, dir, dir, dir, dir))
  tap.ok(code == 0 and program.read(dir .. "/log") == "", real .. ": compiles without a warning, and runs",
    program.read(dir .. "/log"))
  local lines, asked, got, refused = {}, {}, {}, 0
  for line in string.gmatch(program.read(dir .. "/out"), "[^\n]+") do
    local kind, n, t, x = string.match(line, "(%a+) (%d+) (%S+) (.+)")
    if kind then
      local c = list[tonumber(n) + 1]
      local question = table.concat({ hex(c.tensor), hex { table.unpack(c.state, 5, 7) },
        hex { table.unpack(c.state, 1, 4) }, t }, " ")
      if not asked[question] then
        lines[#lines + 1] = question
        asked[question] = #lines
      end
      got[#got + 1] = { kind = kind, of = asked[question], name = c.name .. " t = " .. t, x = x }
    else
      refused = refused + 1
    end
  end
  -- NAME_init refuses what breaks the triangle inequality by rounding
  tap.ok(refused <= #list // 8, real .. ": few bodies are none after rounding", tostring(refused))
  program.write(dir .. "/lines", table.concat(lines, "\n") .. "\n")
  tap.is(program.shell(string.format("%s <%s/lines >%s/states", oracle, dir, dir)), 0, "the oracle answers")
  local want = {}
  for line in string.gmatch(program.read(dir .. "/states"), "[^\n]+") do
    local x = {}
    for word in string.gmatch(line, "%S+") do -- 1e-1000000, on the separatrix, is 0
      x[#x + 1] = string.find(word, "e%-%d%d%d%d") and R.zero or assert(R.parse(word), line)
    end
    want[#want + 1] = x
  end
  tap.is(#want, #lines, "to every line")
  local worst, at = { own = 0, solved = 0, tick = 0 }, {}
  for _, g in ipairs(got) do
    local x, rates, largest, square = want[g.of], 0, 0, 0
    local i = 0
    for word in string.gmatch(g.x, "%S+") do
      i = i + 1
      local y = tonumber(word)
      -- not a number: infinitely wrong
      local e = y == y and math.abs(R.todouble(R.fromdouble(y) - x[i])) or math.huge
      if i <= 3 then
        rates, largest = math.max(rates, e), math.max(largest, math.abs(R.todouble(x[i])))
      else
        square = square + e * e
      end
    end
    -- the attitude as an angle
    local e = math.max(largest > 0 and rates / largest or rates, 2 * math.sqrt(square))
    if e > worst[g.kind] then worst[g.kind], at[g.kind] = e, g.name end
  end
  for _, kind in ipairs { "own", "tick" } do
    local told = string.format("%s, %s: %d states, worst %.2g", real, kind, #got, worst[kind])
    tap.ok(worst[kind] > 0 and worst[kind] <= BAR[real], told, at[kind])
  end
  -- coefficients rounded once from many digits are no worse than those computed; two roundings may fall otherwise
  tap.ok(worst.own <= worst.solved + BAR[real] / 9, string.format("%s: worst %.2g, after NAME_solve %.2g", real,
    worst.own, worst.solved), at.own)
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
