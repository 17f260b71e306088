#!/usr/bin/env lua5.4
-- trajectory.t - polhode view --trajectory: rows that `polhode run` has, no clang needed, and messages; the formulas.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The numbers in the page are decoded here, and compared with the printed ones of run by another method.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local json = require "tests.json"
local program = require "tests.cli.program"
local panel = require "generator.report.handout.panel"
local driver = require "generator.driver"
local report = require "generator.report.facts"
local scene = require "tests.scene"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

-- An empty PATH: there is no compiler.
local function run(arguments)
  return program.output(string.format("/usr/bin/env PATH=%s/none %s %s", dir, binary, arguments))
end

local function decoded(s)
  local value, out, n, bits = {}, {}, 0, 0
  local letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"
  for i = 1, 64 do value[letters:byte(i)] = i - 1 end
  for i = 1, #s do
    local v = value[s:byte(i)]
    if v then
      n, bits = n << 6 | v, bits + 6
      if bits >= 8 then
        bits = bits - 8
        out[#out + 1] = string.char(n >> bits & 255)
        n = n & ((1 << bits) - 1)
      end
    end
  end
  return table.concat(out)
end

-- ---- the rows ----

local CLOSE = 1e-10 -- adaptive and taylor of the library: each promises 1e-12 of the state, over some hundred turns

local pushes = dir .. "/pushes.csv" -- inputs of attitude_control, in their units
program.write(pushes, "t,roll [mN m],coil [A m^2],pitch [mN m],yaw [mN m]\n0,1,0.1,0,0\n7.3,-2,0,1,0\n" ..
  "30,0,0.2,0,0.5\n60,0,0.2,0,0.5\n")

local cases = { { "tennis_racket", "" }, { "attitude_control", " --input " .. pushes }, { "wheels", "" },
  { "heavy_top", "" }, { "thrown_book", "" }, { "turntable_ball", "" },
  { "attitude_control", " --between linear --input " .. pushes } }
for _, case in ipairs { table.unpack(cases, 1, tier.quick and 3 or #cases) } do
  local name, more = case[1], case[2]
  local status, html, err = run("view bodies/" .. name .. ".lua --trajectory -o -" .. more)
  tap.ok(status == 0 and err == "", name .. ": a page without any program", err)
  tap.ok(#html < 1e6, name .. ": of less than 1 MB", #html)
  local facts = json.read(html:match '<script type="application/json" id="facts">(.-)</script>')
  local r = facts.recorded
  local data, width = decoded(r.rows), #facts.states + 5 + (name == "turntable_ball" and 7 or 0)
  tap.is(#data, 8 * r.count * width, name .. ": as many numbers as rows and columns")
  local function cell(row, k) return (string.unpack("<d", data, 8 * (row * width + k - 1) + 1)) end
  tap.ok(cell(0, 1) == 0 and cell(r.count - 1, 1) == facts.horizon, name .. ": from 0 to the horizon")
  local worst, size = 0.0, 0.0
  for _, row in ipairs { 0, r.count // 3, r.count - 1 } do
    local code, out = run(string.format("run bodies/%s.lua --method taylor --at %.17g%s", name, cell(row, 1), more))
    local got, names = {}, {}
    local head, numbers = out:match "^([^\n]+)\n([^\n]+)"
    for column in (head or ""):gmatch "[^,]+" do names[#names + 1] = column end
    for number in (numbers or ""):gmatch "[^,]+" do got[names[#got + 1]], got[#got + 1] = tonumber(number), true end
    tap.ok(code == 0 and #got > #facts.states + 3, name .. ": run has that time", out)
    for k, s in ipairs(facts.states) do
      worst = math.max(worst, math.abs(got[s.name] - cell(row, k + 1)))
      size = math.max(size, math.abs(got[s.name]))
    end
  end
  tap.ok(worst <= CLOSE * size, name .. ": the rows are those of run", worst .. " of " .. size)
end

-- ---- messages ----

program.write(dir .. "/spin.lua", [[return scene { name = "spin", body = solid.box { x = 1, y = 2, z = 3, mass = 1 },
  initial = { omega = { 1, 2, 3 } }, outputs = { "rates" } }]])
for _, name in ipairs { "dropped_stone --what path", dir .. "/spin.lua --what rates" } do -- as the messages have it
  local status, out, err = run("plot " .. name)
  tap.ok(status == 0 and err == "" and out:find("</svg>", 1, true), "plot " .. name .. ": it draws", err)
end

for _, c in ipairs {
  { "view tennis_racket -o -", 2, "needs the program clang %(Debian package clang%); %-%-trajectory makes a page" },
  { "view tennis_racket --trajectory --method rk4,taylor -o -", 2, "must be one method, got rk4,taylor" },
  { "view tennis_racket --trajectory --real float -o -", 2, "%-%-real: it is the type of the emitted code" },
  { "view heavy_top --trajectory --method exact -o -", 2, "solves free tops, and this scene has effects" },
  { "view tennis_racket --trajectory --method split4 -o -", 2, "split4" },
  { "view attitude_control --input " .. pushes .. " -o -", 2, "%-%-input: it belongs to %-%-trajectory" },
  { "view attitude_control --trajectory --between held -o -", 2, "%-%-between: it says how" },
  { "view tennis_racket --trajectory --input " .. pushes .. " -o -", 2, "no input" },
  { "view dropped_stone -o -", 2, "this body is a point: .* Its path: polhode plot .*dropped_stone.* %-%-what path" },
  { "view foucault --trajectory -o -", 2, "this body is a point" },
  { "view " .. dir .. "/spin.lua -o -", 2, "outputs does not ask for its attitude: .* polhode plot " .. dir ..
    "/spin.lua %-%-what rates" },
} do
  local status, out, err = run(c[1])
  tap.ok(status == c[2] and out == "" and err:find(c[3]), c[1] .. ": says what is wrong", status .. " " .. err)
end

-- ---- formulas ----

local function of(text)
  local job = assert(scene.read(text))
  return panel.html(report.of(assert(driver.plan(job, {}))))
end
local oblique = of [[return scene { name = "oblique", body = solid.box { x = 0.1, y = 0.1, z = 0.1,
  mass = param("rho", 1, "kg") }, origin = "corner", initial = { omega = {1, 2, 3} } }]]
for open, name in oblique:gmatch "<(/?)(m%a+)" do
  tap.ok(open == "/" or oblique:find("</" .. name .. ">", 1, true) or oblique:find("<" .. name .. "[^>]*/>"),
    name .. " is closed")
end
tap.ok(oblique:find("<mi>ρ</mi>", 1, true), "a parameter called rho is written as the letter")
tap.ok(not oblique:find('data-value="kx"', 1, true), "axes that are no principal ones have no factor of wy wz")
tap.is(select(2, oblique:gsub('data%-value="I', "")), 9, "all entries of its tensor have a number")
local straight = of [[return scene { name = "straight", body = solid.box { x = 1, y = 2, z = 3,
  mass = param("m", 1, "kg") }, effects = { effect.drag { c = 0.1 } }, initial = { omega = {1, 2, 3} } }]]
tap.is(select(2, straight:gsub('data%-value="I', "")), 3, "an entry that is always 0 has no value of its own")
tap.is(select(2, straight:gsub('data%-value="k', "")), 3, "and principal axes have the factors of the products")
tap.done(program.finish())
