#!/usr/bin/env lua5.4
-- firmware.t - gen --project firmware on this machine: is the filter a filter, does the watchdog see what it should?
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- True states are the general library's.  tests/target/firmware.t runs the same program on an emulated Cortex-M4F.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local firmware = require "tests.emit.firmware"

local dir = program.directory()

-- Sample times, true states, S and V lines of a filter's run.
local function filtered(folder, scene, step)
  local text, ok = firmware.run(folder, "make -s host")
  if not tap.ok(ok, "it builds without a warning and runs: " .. folder:match "[^/]*$", text:sub(1, 2000)) then
    return nil
  end
  local lines, times = firmware.read(text), {}
  for i = 2, #lines.S do times[i - 1] = lines.S[i][1] * step end
  return lines, firmware.truth(scene, times), text
end

-- The sum of squared innovations over their variances, from sample `from` to `to`, and the correlation of neighbours.
local function innovations(lines, from, to)
  local sum, lag, square = 0, 0, 0
  for i = from, to do
    local v = lines.V[i + 1]
    local e = v[#v] - 3
    sum, square = sum + v[#v], square + e * e
    if i > from then lag = lag + e * (lines.V[i][#v] - 3) end
  end
  return sum, lag / square
end

for _, c in ipairs { { firmware.probe, "/probe.lua", 1 / 4096 }, { "bodies/nodding_top.lua", nil, 0.001 },
  { "bodies/thruster.lua", nil, 0.001 } } do
  local folder, why = firmware.make(dir, c[1], "--project firmware")
  if not tap.ok(folder, "gen --project firmware", why) then break end
  local scene = c[2] and dir .. c[2] or c[1]
  local lines, truth = filtered(folder, scene, c[3])
  if lines then
    local name, n = folder:match "[^/]*$", #truth
    tap.is(n, 256, name .. ": a line for each of the 256 readings")
    -- The table: readings less the true rates are noise of 4 bits, rounded to a bit: over their variance, chi-square
    -- with 768 degrees of freedom, variance 2 768; their mean has a standard deviation of 4/sqrt(768) bits.
    local bit = tonumber((program.read(folder .. "/derived.h"):match "#define APP_GYRO_LSB ([%d.e-]+)"))
    local count, chi, mean = 0, 0, 0
    for x, y, z in program.read(folder .. "/readings.c"):gmatch "{(%-?%d+), (%-?%d+), (%-?%d+)}" do
      count = count + 1
      for i, raw in ipairs { x, y, z } do
        local d = tonumber(raw) - truth[count][4 + i] / bit
        chi, mean = chi + d * d / (16 + 1 / 12), mean + d / 768
      end
    end
    tap.ok(count == 256 and math.abs(chi - 768) < 4 * math.sqrt(2 * 768) and math.abs(mean) < 4 * 4 / math.sqrt(768),
      name .. ": the gyro's table is the library's rates with noise of 4 bits", chi .. " " .. mean)
    local last = lines.R[1]
    tap.ok(last[2] == 0, name .. ": the watchdog found nothing", "faults " .. last[2])

    -- The sum over K readings of three innovations, each squared over its variance, is chi-square with 3 K degrees of
    -- freedom: mean 3 K, variance 6 K.  Four standard deviations; the sequence is fixed: it passes always or never.
    for _, span in ipairs { { 1, 256 }, { 1, 128 }, { 129, 256 } } do
      local K = span[2] - span[1] + 1
      local sum = innovations(lines, span[1], span[2])
      tap.near(sum, 3 * K, 0, 4 * math.sqrt(6 * K), string.format("%s: innovations %d to %d are as large as the filter "
        .. "says", name, span[1], span[2]), "4 sigma of chi-square")
    end
    -- neighbours of a white sequence of K: correlation 0 with standard deviation 1/sqrt(K)
    local _, lag = innovations(lines, 1, 256)
    tap.near(lag, 0, 0, 4 / math.sqrt(256), name .. ": neighbouring innovations are not correlated", "4 sigma")

    -- Rates: off by FS/64 at the start; at the end within 3 sigma, which has become much smaller.
    local start, final = lines.S[1], lines.S[#lines.S]
    local var0, var1 = lines.V[1], lines.V[#lines.V]
    local inside, all, worst = 0, 0, 0
    for i = n // 2, n do
      for k = 5, 7 do
        local d = math.abs(lines.S[i + 1][k + 1] - truth[i][k]) / math.sqrt(lines.V[i + 1][k + 1])
        all, inside, worst = all + 1, inside + (d <= 3 and 1 or 0), math.max(worst, d)
      end
    end
    tap.diag(string.format("%s: rates within 3 sigma in %d of %d, worst %.2f sigma; sigma %.3g -> %.3g rad/s", name,
      inside, all, worst, math.sqrt(var0[6]), math.sqrt(math.max(var1[6], var1[7], var1[8]))))
    tap.ok(inside >= 0.98 * all and worst < 4.5, name .. ": in the second half the rates' errors are within 3 sigma")
    for k = 5, 7 do
      local s = math.sqrt(var1[k + 1])
      tap.near(final[k + 1], truth[n][k], 0, 3 * s, string.format("%s: rate %d ends within 3 sigma", name, k - 4),
        "3 sigma")
      tap.ok(s < math.sqrt(var0[k + 1]) / 15 and math.abs(start[k + 1] - truth[1][k]) > 10 * s,
        name .. ": which is less than a 15th of what it was, and of the first error a tenth")
    end
    -- attitude: known at the start, then as good as the rates let it be; float rounds each component 4096 times
    for k = 1, 4 do
      tap.near(final[k + 1], truth[n][k], 0, 3 * math.sqrt(var1[k + 1]) + 64 * 2.0 ^ -25 * 4,
        string.format("%s: attitude component %d ends within 3 sigma", name, k), "3 sigma and roundings of 4096 steps")
    end
  end
end

-- A filter that believes the gyro four times less noisy than it is must fail the test above.
do
  local folder = dir .. "/probeprojectfirmware"
  local config = program.read(folder .. "/config.h")
  local value = program.read(folder .. "/derived.h"):match "#define APP_GYRO_VARIANCE (%S+)"
  program.write(folder .. "/config.h", (config:gsub("#include \"derived.h\"", "#define APP_GYRO_VARIANCE (" ..
    value .. "/16)\n%0")))
  local text, ok = firmware.run(folder, "make -s host")
  tap.ok(not ok and text:find("\nE %x+ 00000007\n"),
    "with a noise that is four times too small the filter is blind: " ..
    "a fault, and the program fails", text:sub(-300))
  local lines = firmware.read((firmware.run(folder, "touch main.c; make -s host DEFS=-DAPP_BLIND=65535")))
  tap.ok(innovations(lines, 1, 256) > 3 * 256 + 4 * math.sqrt(6 * 256),
    "and its innovations are too large: the test can fail")
  program.write(folder .. "/config.h", config)
end

-- Each fault is seen, and a run that it befell goes on with the very bits of one without.
do
  local folder = dir .. "/probeprojectfirmware"
  local clean = firmware.run(folder, "make -s host-predict EVERY=2048")
  local want = { { 2, "a flipped bit in q" }, { 1, "a NaN" } }
  for kind, w in ipairs(want) do
    local text = firmware.run(folder, string.format("rm -f build/host-predict-4096-2048; "
      .. "make -s build/host-predict-4096-2048 CYCLES=4096 EVERY=2048 DEFS=-DAPP_INJECT=%d "
      .. "&& ./build/host-predict-4096-2048", kind))
    local lines = firmware.read(text)
    tap.ok(#lines.E == 1 and lines.E[1][1] == 100 and lines.E[1][2] == w[1],
      w[2] .. ": reported once, in its cycle, as what it is", text)
    tap.is(text:gsub("E [^\n]*\n", ""):gsub("R [^\n]*\n", ""), (clean:gsub("R [^\n]*\n", "")),
      w[2] .. ": after it the state is what it would have been")
  end
  -- with the gyro: also in cycles with a reading, whose correction is lost with the state that it corrected
  for _, at in ipairs { 15, 16, 64, 100, 160 } do
    local text = firmware.run(folder, string.format("rm -f build/host-1024-1024; make -s build/host-1024-1024 "
      .. "CYCLES=1024 EVERY=1024 DEFS='-DAPP_INJECT=1 -DAPP_INJECT_AT=%d' && ./build/host-1024-1024", at))
    local lines = firmware.read(text)
    tap.ok(#lines.E == 1 and lines.E[1][1] == at and #lines.R == 1 and lines.R[1][1] == 1024,
      "a flipped bit in cycle " .. at .. " of the filter: reported once, and the program goes on", text)
  end
  local text, ok = firmware.run(folder, "make -s faults")
  local codes = {}
  for code in text:gmatch "\nE %x+ (%x+)" do codes[#codes + 1] = tonumber(code, 16) end
  tap.is(table.concat(codes, " "), "2 1 5", "make faults: a flipped bit, a NaN and a stuck gyro, each as what it is")
  tap.ok(ok, "and the program goes on")
  local lines = firmware.read(text:match "APP_INJECT=3\n(.*)")
  tap.is(lines.E[1][1], (128 + 3) * 16, "the stuck gyro is found with the fourth equal reading")
end

-- A control law of the user's: a sphere of 1 kg m^2 under a torque of 1/4 N m about z, from rest.  With the step a
-- power
-- of two every rate is exact: w_z = t/4.  Another gen leaves it where it is.
do
  local sphere = [[return scene { name = "held", body = solid.sphere { r = 1, mass = exact("5/2") },
    effects = { effect.control {} }, initial = { omega = { 0, 0, 0 } }, time = { horizon = 1,
      step = exact("1/256") } }]]
  local folder = assert(firmware.make(dir, sphere, "--project firmware"))
  local law = program.read(folder .. "/control.c")
  program.write(folder .. "/control.c", (law:gsub("u%[i%] = 0;", "u[i] = i == 2 ? 0.25f : 0.0f;")))
  firmware.make(dir, sphere, "--project firmware")
  local text, ok = firmware.run(folder, "make -s host-predict CYCLES=256 EVERY=64")
  local lines = firmware.read(text)
  local last = ok and lines.S[#lines.S] or {}
  tap.ok(#lines.S == 5 and last[1] == 256 and last[8] == 0.25 and last[6] == 0 and #lines.E == 0,
    "a control law in control.c is what turns the body", text)
end

-- The filter sees the body that the law acts on: u = -kp q - kd w from the estimate.  Readings of the motion without
-- inputs are what it must not take for granted: rejected, a fault, and the program fails.
if not tier.quick then
  local scene = [[
local function u(name) return input(name, "N m", { min = -0.01, max = 0.01 }) end
return scene { name = "steered", body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = 8 },
  effects = { effect.torque { body = { u "a", u "b", u "c" } } },
  initial = { omega = { 0.1, -0.05, 0.02 }, attitude = { 0.9, 0.1, -0.3, 0.3 } },
  time = { horizon = 41, step = exact("1/100") } }]]
  local folder = assert(firmware.make(dir, scene, "--project firmware"))
  local text, ok = firmware.run(folder, "make -s host && cp build/host-4096-16 build/none")
  local free = firmware.read(text)
  tap.ok(ok and free.R[1][2] == 0 and free.R[1][3] == 0, "without a law nothing is rejected", text:sub(-200))
  local law = program.read(folder .. "/control.c")
  program.write(folder .. "/control.c", (law:gsub("%(void%)x;\n", ""):gsub("u%[i%] = 0;",
    "u[i] = -0.01f*x[1 + i] - 0.05f*x[4 + i];")))
  text, ok = firmware.run(folder, "make -s host")
  local lines = firmware.read(text)
  tap.ok(ok and lines.R[1][1] == 4096 and lines.R[1][2] == 0 and lines.R[1][3] == 0,
    "under a control law no reading is rejected and nothing is a fault", text:sub(-200))
  tap.near(innovations(lines, 1, 256), 768, 0, 4 * math.sqrt(6 * 256), "and the innovations are as large as the " ..
    "filter says", "4 sigma of chi-square")
  local rest = lines.S[#lines.S]
  tap.ok(math.abs(rest[6]) < 0.01 and math.abs(rest[3]) < 0.05 and math.abs(free.S[#free.S][6]) > 0.01,
    "the law holds the body", table.concat(rest, " "))

  text, ok = firmware.run(folder, "touch main.c; make -s host DEFS=-DAPP_PLANT=0")
  lines = firmware.read(text)
  local blind = #lines.E
  for _, e in ipairs(lines.E) do blind = blind - (e[2] == 7 and 1 or 0) end
  tap.ok(not ok and #lines.E == 8 and blind == 0 and lines.R[1][2] == 8 and lines.R[1][1] < 4096,
    "readings of another motion: the filter says that it is blind, and the program fails", text:sub(-300))
end

-- A clock too fast for the 24 bits of SysTick (steps of 1/4096 s, so beyond 2^36 Hz) is refused, with more ticks not.
for ticks, want in ipairs { false, true } do
  local text, ok = firmware.run(dir .. "/probeprojectfirmware", "gcc -std=c99 -fsyntax-only -DAPP_CLOCK=70000000000 "
    .. "-DAPP_TICKS=" .. ticks .. " main.c")
  tap.ok(ok == want and (ok or text:find("24 bits", 1, true)), "a period of SysTick in 24 bits, " .. ticks, text)
end

-- What cannot be firmware is refused in words.
for _, c in ipairs {
  { "bodies/dropped_stone.lua", "", "project firmware: the scene must have an attitude to estimate" },
  { "bodies/water.lua", "", "project firmware: time.step is the loop's period" },
  { "bodies/brick.lua", "--method midpoint", "project firmware: the method must be a fixed step" },
  { 'return scene { name = "gyro", body = solid.sphere { r = 1, mass = 1 }, initial = { omega = { 1, 0, 0 } } }', "",
    "project firmware: the scene must not be named like a file of the application, got gyro" },
} do
  local folder, why = firmware.make(dir, c[1], c[2] .. " --project firmware")
  tap.like(not folder and why, c[3], "refused: " .. c[3])
end

program.finish()
tap.done()
