#!/usr/bin/env lua5.4
-- bench.t - polhode bench: errors fall as the methods' orders have it, fronts are fronts, files are whole, bad options
-- are refused.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- No time is judged: times are only known to be positive, and to make the fronts that the rows say.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

program.write(dir .. "/box.lua", [[
local a = param("a", 0.2, "m")
return scene { name = "box", body = solid.box { x = a, y = 0.1, z = 0.05, mass = 1 },
  initial = { omega = {1, 6, 2} }, time = { horizon = 1 } }
]])
program.write(dir .. "/bad.lua", [[
return scene { name = "bad", body = solid.box { x = -1, y = 0.1, z = 0.05, mass = 1 } }
]])

local function run(arguments)
  return program.output(string.format("timeout 120 %s bench %s", binary, arguments))
end

local function parse(text)
  local rows, head = {}, nil
  for line in text:gmatch "[^\n]+" do
    local cells = {}
    for cell in (line .. ","):gmatch "([^,]*)," do cells[#cells + 1] = cell end
    if head then
      local r = { cells = #cells }
      for i, name in ipairs(head) do r[name] = tonumber(cells[i]) or cells[i] end
      rows[#rows + 1] = r
    else
      head = cells
    end
  end
  return rows, head
end

local function select_rows(rows, fields)
  local list = {}
  for _, r in ipairs(rows) do
    local fits = true
    for k, v in pairs(fields) do fits = fits and r[k] == v end -- any order
    if fits then list[#list + 1] = r end
  end
  return list
end

local status, out, err, _
status, out, err = run(dir .. "/box.lua --method exact,rk4 -o " .. dir .. "/out")
tap.is(status, 0, "a scene is measured")
if status ~= 0 then tap.diag(err) end
local csv = program.read(dir .. "/out/box.csv") or ""
local rows, head = parse(csv)

-- ---- the files ----

do
  local whole, positive = #rows > 0, true
  for _, r in ipairs(rows) do
    whole = whole and r.cells == #head and r.scene == "box"
    positive = positive and type(r.seconds) == "number" and r.seconds > 0 and type(r.error) == "number"
      and r.seconds_step > 0 and r.spread >= 0
  end
  tap.ok(whole, "every line of the CSV has all cells")
  tap.ok(positive, "and an error and times")
  tap.like(program.read(dir .. "/out/box.svg") or "", "</svg>\n", "the diagram is there")
  tap.like(out, "condition number", "the condition number is said")
  tap.like(out, "exact", "the table is printed")
  tap.ok(not err:find("[", 1, true) or err:find "^warning", "no progress where no terminal is")
end

-- ---- the numbers ----

-- Where rounding and the coarsest steps are far, halving h divides the error by 2^p: from the first to the last rung
-- with errors between 1e-3 and 1e-10.  0.2: the first neglected order, some h of the leading one, and the steps of the
-- last tenth, which the end times cut shorter, each at most a tenth of an error that falls by 10 at least.
local function slopes(list, order, name)
  local first, last
  for _, r in ipairs(list) do
    if r.error < 1e-3 and r.error > 1e-10 then first, last = first or r, r end
  end
  local slope = first and math.log(first.error / last.error) / math.log(first.setting / last.setting) or 0
  tap.ok(math.abs(slope - order) < 0.2 and first.error > 10 * last.error, name .. ": errors fall with order " .. order,
    "slope " .. slope)
end

for _, group in ipairs { "portable", "host" } do
  slopes(select_rows(rows, { method = "rk4", group = group }), 4, "rk4, " .. group)
end

do
  local exact = select_rows(rows, { method = "exact", group = "closed" })[1]
  -- rates of 6 rad/s for 1 s: less than 30 ulp, and as much again for the reference
  tap.ok(exact and exact.error < 64 * 30 * 2 ^ -52, "the closed form is exact to rounding")
  tap.ok(exact and (exact.note == "rounding" or exact.note == "reference"), "and its error is named so")
  tap.ok(exact and exact["drift T+V"] < 64 * 2 ^ -52 and exact["drift L"] < 64 * 2 ^ -52, "it conserves to rounding")
  local float = select_rows(rows, { method = "exact float" })[1]
  tap.ok(float and float.error > exact.error and float.error < 64 * 30 * 2 ^ -23, "in float to that of float")
  local rk4 = select_rows(rows, { method = "rk4", group = "portable" })
  tap.ok(#rk4 > 0 and rk4[1]["drift T+V"] > 1e3 * rk4[#rk4]["drift T+V"], "rk4 drifts, with small steps less")
  -- methods/rk4.lua: one division; a free body in principal axes
  tap.ok(#rk4 > 0 and rk4[1].div == 1 and rk4[1].add > 50 and rk4[1].mul > 50, "operations are counted")
  local steps = true
  for _, r in ipairs(rk4) do steps = steps and math.abs(r.steps * r.setting - 1) <= r.setting end
  tap.ok(steps, "a fixed step covers the horizon in as many steps as fit")
end

do
  local peers = {}
  for _, r in ipairs(select_rows(rows, { group = "peer" })) do
    if r.error < 1e-6 then peers[r.method] = true end
  end
  tap.ok(peers["hand RK4"] and peers["GSL rk8pd"], "peers solve the same motion")
end

do -- the marks, anew
  local same, fronts = true, 0
  for _, r in ipairs(rows) do
    local beaten = r.error >= 1
    for _, o in ipairs(select_rows(rows, { group = r.group })) do
      beaten = beaten or o.error <= r.error and o.seconds <= r.seconds and (o.error < r.error or o.seconds < r.seconds)
    end
    same, fronts = same and (r.front == 1) == not beaten, fronts + r.front
  end
  tap.ok(same and fronts > 5, "the marks are those of the Pareto fronts")
end

-- ---- options ----

do
  status, out = run(dir .. "/box.lua --method midpoint,semi --accuracy 0.0001 --no-peers --until 2 --format csv -o "
    .. dir .. "/two")
  local few = parse(out)
  tap.ok(status == 0 and #few > 0, "--format csv prints the rows")
  tap.is(out, program.read(dir .. "/two/box.csv"), "the same as in the file")
  tap.is(#select_rows(few, { group = "peer" }), 0, "--no-peers leaves peers out")
  for _, name in ipairs { "midpoint", "semi" } do
    local list = select_rows(few, { method = name, group = "portable" })
    slopes(list, 2, name)
    local least = 1
    for _, r in ipairs(list) do least = math.min(least, r.error) end
    tap.ok(least <= 1e-5 and least > 1e-6, "--accuracy: a ladder ends a decade below what is asked for", least)
    tap.ok(name ~= "midpoint" or #list > 0 and list[1]["drift T+V"] < 1e-12,
      "midpoint keeps the energy of a free body at any step")
  end
  status, out = run(dir .. "/box.lua --method exact --no-closed -o " .. dir .. "/three")
  tap.is(status, 2, "nothing left to measure is refused")
  tap.is(out, "", "and prints nothing")
end

do -- what cannot be had is left out and said
  program.write(dir .. "/huge.lua", [[
return scene { name = "huge", body = tensor { mass = 1e37, xx = 1e41, yy = 1.1e41, zz = 1.3e41 },
  initial = { omega = {1, 6, 2} }, time = { horizon = 1 } }
]])
  program.write(dir .. "/cc", '#!/bin/sh\ncase "$*" in *march=native*) echo no such thing; exit 1;; esac\n' ..
    'exec cc "$@"\n')
  program.shell("chmod +x " .. dir .. "/cc")
  local plain
  binary, plain = "env CC=" .. dir .. "/cc " .. binary, binary
  status, out = run(dir .. "/huge.lua --method rk4 --accuracy 0.01 --no-peers -o " .. dir .. "/four")
  binary = plain
  tap.is(status, 0, "a scene beyond float, and a compiler without a flag")
  tap.like(out, "float: .*within its range", "float is left out, and it is said why", true)
  tap.like(out, "double, for this machine: .*no such thing", "so is what does not compile", true)
  tap.like(out, "\nrk4 +%d", "the rest is measured", true)
end

for arguments, want in pairs { -- any order
  ["box.lua --method magic"] = "--method must be some of exact, rk4",
  ["box.lua --method rk4,rk4"] = "twice",
  ["box.lua --accuracy 0"] = "between 0 and 1",
  ["box.lua --accuracy 1"] = "between 0 and 1",
  ["box.lua --until -1"] = "must be positive",
  ["box.lua --until 0"] = "must be positive",
  ["box.lua --format svg"] = "--format must be",
  ["box.lua --fast"] = "no option --fast",
  ["box.lua bad.lua"] = "too many operands",
  [""] = "SCENE is missing",
} do
  status, _, err = run(arguments ~= "" and dir .. "/" .. arguments or "")
  tap.is(status, 2, "refused: bench " .. arguments)
  tap.like(err, want, "and said why")
end
status, _, err = run(dir .. "/bad.lua")
tap.is(status, 1, "a scene that is wrong is refused")
tap.like(err, "bad.lua:1:", "with its line")
tap.is((run(dir .. "/none.lua")), 2, "so is one that is not there")
tap.is((run(dir .. "/box.lua --set b=1")), 2, "and a parameter that the scene does not have")
status, _, err = run(dir .. "/box.lua --method exact --no-peers -o " .. dir .. "/box.lua/no")
tap.is(status, 2, "a directory that cannot be made")
tap.like(err, "polhode bench:", "is said")

program.finish()
tap.done()
