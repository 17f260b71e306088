-- motion.lua -- runs what motion.h measures and judges it: for lagrange.t and gyrostat.t.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- One scene, compiled once as double (top) and once as float (small).  A test is {source, bar, norm, ...}: the bars of
-- errors and of |q| - 1, and what else the functions below name; the test says why.
-- POLHODE_STATES: how many random states; POLHODE_HEAVY_ORACLE: another program than the one `make tests` builds.

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local scene = require "tests.scene"

local motion = {}

local oracle = os.getenv "POLHODE_HEAVY_ORACLE" or "build/oracle/heavy_top"
local states = tonumber(os.getenv "POLHODE_STATES" or "20000")

-- Writes the two scenes' code; text with %s for the name.
local function emit(dir, text, kind)
  for _, s in ipairs { { "top", "double" }, { "small", "float" } } do
    local name = s[1]
    local job = assert(scene.read(string.format(text, name)))
    job = scene.plan(job, { real = s[2] })
    tap.is(job.closed.kind, kind, name .. ": " .. kind)
    local files = scene.files(job)
    program.write(dir .. "/" .. name .. ".h", files[name .. ".h"])
    program.write(dir .. "/" .. name .. ".c", files[name .. ".c"])
  end
end

local function lines(dir, arguments)
  local code = program.shell(string.format("timeout 300 %s/measure %s >%s/out", dir, arguments, dir))
  tap.is(code, 0, "measure " .. arguments .. " runs")
  local list = {}
  for line in string.gmatch(program.read(dir .. "/out"), "[^\n]+") do list[#list + 1] = line end
  return list
end

local function words(line)
  local list = {}
  for word in string.gmatch(line, "%S+") do list[#list + 1] = word end
  return list
end

-- The table: at least t.rows samples.
local function rows(t)
  local n, worst = 0, { 0, 0 }
  for _, line in ipairs(lines(t.dir, "rows")) do
    local l = words(line)
    local rates, angle, norm = tonumber(l[4]), tonumber(l[5]), tonumber(l[6])
    if not (rates and rates <= t.bar and angle <= t.bar and norm <= t.norm) then tap.ok(false, line) end
    n, worst[1], worst[2] = n + 1, math.max(worst[1], rates or 0), math.max(worst[2], angle or 0)
  end
  tap.ok(n >= t.rows, string.format("%d samples of the table: rates to %.2g of the largest, attitude to %.2g", n,
    worst[1], worst[2]))
end

-- Motions against the oracle's series: arguments of measure, options of the oracle, how many at least.  Returns their
-- names.
function motion.cases(t, arguments, options, least)
  local names, norms, paces, input = {}, {}, {}, {}
  for _, line in ipairs(lines(t.dir, arguments)) do
    local name, norm, pace, numbers = string.match(line, "^(.-); (%S+) (%S+); (.+)$")
    if not name then tap.ok(false, line) end
    names[#names + 1], norms[#norms + 1], input[#input + 1] = name, tonumber(norm), numbers
    paces[#paces + 1] = tonumber(pace)
  end
  program.write(t.dir .. "/lines", table.concat(input, "\n") .. "\n")
  tap.is(program.shell(string.format("%s %s -e <%s/lines >%s/errors", oracle, options, t.dir, t.dir)), 0,
    "the oracle runs")
  local n, worst = 0, { 0, 0 }
  for line in string.gmatch(program.read(t.dir .. "/errors"), "[^\n]+") do
    n = n + 1
    local l = words(line)
    local rates, angle = (tonumber(l[1]) or math.huge) / paces[n], 2 * (tonumber(l[2]) or math.huge)
    if not (rates <= t.bar and angle <= t.bar and norms[n] <= t.norm) then tap.ok(false, names[n] .. ": " .. line) end
    worst[1], worst[2] = math.max(worst[1], rates), math.max(worst[2], angle)
  end
  tap.ok(n == #names and n >= least, string.format("%d motions, %s: rates to %.2g, attitude to %.2g", n, arguments,
    worst[1], worst[2]))
  return names
end

-- t.refused: the part of the states that may be refused; t.energy, t.momentum: {bar, what is constant}; t.derivative:
-- the bar of the equations of motion.
local function random(t, command, count)
  local l = words(lines(t.dir, "random " .. count)[1])
  local who = string.format("%s: %s random states: ", command, l[2])
  local function below(k, bar, what) tap.ok(tonumber(l[k]) <= bar, who .. what, l[k]) end
  below(3, t.refused * count, "hardly one is refused")
  tap.is(l[4], "0", who .. "every number is finite")
  below(5, t.bar, "at t = 0 the initial state")
  below(6, t.norm, "|q| = 1")
  below(7, t.energy[1], t.energy[2])
  below(8, t.momentum[1], t.momentum[2])
  -- compiled as other loops and vectors, the same sums may be fused otherwise
  below(9, t.bar, "many at once, rates alone, attitude alone: the same")
  below(11, 2 * t.bar, "in ticks, of either sign: the same")
  below(10, t.derivative, "the motion obeys the equations of motion")
end

-- t.float_bar, t.float_refused
local function floats(t, command)
  local l = words(lines(t.dir, "float " .. states)[1])
  tap.ok(tonumber(l[3]) <= t.float_refused * states, command .. ": float: hardly one is refused", l[3])
  tap.ok(tonumber(l[4]) <= t.float_bar and tonumber(l[5]) <= t.float_bar, string.format(
    "%s: float against double, %s states: rates to %s, attitude to %s", command, l[2], l[4], l[5]))
end

-- Everything, of a scene's text and kind; first() is called once with the first compiler; `most` random states there.
function motion.run(t, text, kind, most, first)
  t.dir = program.directory()
  emit(t.dir, text, kind)
  for i, command in ipairs(tier.every(3, { "gcc -std=c11 -O2 -ffp-contract=off",
    "gcc -std=c11 -O3 -march=native -ffp-contract=fast", "clang -std=c11 -O1" })) do
    local code = program.shell(string.format("(cd %s && %s -c top.c small.c) >%s/log 2>&1 && gcc -std=c11 -O1 " ..
      "-D_DEFAULT_SOURCE -Itests/reference -I%s -o %s/measure tests/emit/%s %s/top.o %s/small.o -lm >>%s/log 2>&1",
      t.dir, command, t.dir, t.dir, t.dir, t.source, t.dir, t.dir, t.dir))
    if tap.ok(code == 0, command .. ": compiles", program.read(t.dir .. "/log")) then
      rows(t)
      if i == 1 then first() end
      random(t, command, i == 1 and math.max(states, tier.quick and most // 10 or most) or states)
      floats(t, command)
    end
  end
  program.finish()
  tap.done()
end

return motion
