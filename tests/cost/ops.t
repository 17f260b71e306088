#!/usr/bin/env lua5.4
-- ops.t - the operations that generator/cost/ops.lua counts are those that the emitted code does.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The oracle: the emitted C, read as C++ with a number that counts (counted.h) in the place of NAME_real, is compiled,
-- run, and says what it did.  Where no branch depends on the numbers the counts must be equal; where one does, they lie
-- between the cheapest and the costliest way, and reach one of them where the state is chosen so.
-- The quick tier takes fewer bodies.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"
local equations = require "generator.dynamics.equations"
local program = require "tests.cli.program"
local driver = require "generator.driver"
local ops = require "generator.cost.ops"
local methods = require "generator.methods.methods"

local dir = program.directory()
-- clang takes half of g++'s time
local compiler = program.shell "command -v clang++ >/dev/null 2>&1" == 0 and "clang++" or "g++"
local KINDS = { "add", "mul", "div", "sqrt", "fma", "call" }

local function shown(c)
  local list = {}
  for i, k in ipairs(KINDS) do list[i] = string.format("%s %d", k, c[k]) end
  return table.concat(list, ", ")
end

-- What each line of C does, by its name.  calls: {name, C}; fma: as on a processor that has it.
local function run(job, tag, calls, fma)
  local name, native = job.model.name, job.real
  local text = { '#define NATIVE ' .. native, '#include "counted.h"', '#include "' .. tag .. '.c"', "",
    "static " .. name .. "_model model;", "#ifdef SOLVES", "static " .. name .. "_orbit orbit;", "#endif",
    "static " .. name .. "_real x[" .. name:upper() .. "_NX], y[" .. name:upper() .. "_NX], u[16];",
    "int main() {", "  " .. name .. "_init(&model, 0);" }
  for _, c in ipairs(calls) do
    text[#text + 1] = "  " .. name .. "_initial(&model, x);"
    text[#text + 1] = string.format("  SHOW(\"%s\", %s);", c[1], (c[2]:gsub("NAME", name)))
  end
  text[#text + 1] = "}\n"
  local function changed(s)
    s = s:gsub("%f[%w_]" .. native .. "%f[^%w_]", "counted")
    return (s:gsub('extern "C" {', ""):gsub("#ifdef __cplusplus\n}", "#ifdef __cplusplus\n"))
  end
  program.write(dir .. "/" .. name .. ".h", changed(job.code.header))
  program.write(dir .. "/" .. tag .. ".c", changed(job.code.source))
  program.write(dir .. "/" .. tag .. ".main.cc", table.concat(text, "\n"))
  local pipe = assert(io.popen(string.format("cd %s && %s -std=c++11 -w -O0 -I%s/tests/cost %s %s.main.cc " ..
    "-o %s.run -lm 2>&1 && ./%s.run", dir, compiler, os.getenv "PWD",
    fma and "-DFP_FAST_FMA -DFP_FAST_FMAF" or "", tag, tag, tag)))
  local out, text_out = {}, {}
  for line in pipe:lines() do
    local words = {}
    for w in line:gmatch "%S+" do words[#words + 1] = w end
    local c = {}
    for i, k in ipairs(KINDS) do c[k] = math.tointeger(tonumber(words[i + 1])) end
    if c.call then out[words[1]] = c end
    text_out[#text_out + 1] = line
  end
  if not pipe:close() then tap.diag(table.concat(text_out, "\n")) end
  return out
end

local function same(a, b) return shown(a) == shown(b) end

local function within(c, least, most)
  return ops.weight(least) <= ops.weight(c) and ops.weight(c) <= ops.weight(most)
end

local function planned(path, real, names)
  return driver.code(scene.plan(scene.file("bodies/" .. path .. ".lua"), { real = real, methods = names,
    libm = "system" }))
end

-- ---- steppers: equal ----

local STEP = "(&model, 0, x, u, 1e-3)"
local rows = {
  { "brick_centroid", { "rk4", "adaptive", "taylor", "midpoint", "semi", "split2", "split4", "split6" } },
  { "heavy_top", { "taylor", "rk4", "adaptive", "midpoint", "semi", "split2", "split4", "split6" } },
  { "brick", { "rk4", "split2", "split4" } },
  { "gyrostat", { "rk4", "adaptive", "taylor", "midpoint", "semi" } },
  { "damped_brick", { "adaptive", "rk4", "taylor", "midpoint", "semi", "split2" } },
  { "gravity_gradient", { "rk4", "adaptive", "taylor", "semi" } },
  { "foucault", { "rk4", "adaptive", "taylor", "semi" } },
}
for _, row in ipairs(tier.every(7, rows)) do
  for _, real in ipairs { "double", "float" } do
    local job, calls = planned(row[1], real, row[2]), {}
    for i, m in ipairs(row[2]) do calls[i] = { m, "NAME_" .. (i == 1 and "" or m .. "_") .. "step" .. STEP } end
    local did = run(job, row[1] .. "_" .. real, calls)
    for _, m in ipairs(row[2]) do
      local tag = string.format("%s, %s, %s", row[1], real, m)
      local got = did[m]
      if not got then
        tap.ok(false, tag .. ": compiled and run as C++")
      elseif m:find "^split" then -- short steps take the series, the cheaper branch
        local most, least = ops.of(job, { method = m }).step, ops.of(job, { method = m }, { least = true }).step
        tap.is(shown(least), shown(got), tag .. ": a short step is the cheapest")
        tap.ok(within(got, least, most), tag .. ": not above the largest", shown(most))
      else
        tap.is(shown(ops.of(job, { method = m }).step), shown(got), tag)
      end
    end
  end
end

-- ---- a step with a tolerance: what one more of them takes ----

for _, path in ipairs(tier.every(2, { "brick_centroid", "heavy_top" })) do
  for _, m in ipairs { "taylor", "adaptive" } do
    local job = planned(path, "double", { m })
    local run_to = "NAME_" .. m .. "_run(&model, 0, x, u, 1e3, 1e-13, "
    local did = run(job, path .. "_run_" .. m, { { "some", run_to .. "60)" }, { "more", run_to .. "61)" } })
    local got = {}
    for _, k in ipairs(KINDS) do got[k] = did.more[k] - did.some[k] end
    local wanted = { method = m, order = m == "taylor" and 20 or nil, setting = "tolerance" } -- 1e-13 asks for all 20
    local most = ops.of(job, wanted).step
    tap.ok(within(got, ops.of(job, wanted, { least = true }).step, most), path .. ", " .. m .. "_run: one more step",
      shown(got) .. "\n" .. shown(most))
    tap.ok(ops.weight(most) < 1.05 * ops.weight(got), path .. ", " .. m .. "_run: the largest is near",
      shown(got) .. "\n" .. shown(most))
  end
end

-- ---- another order than the emitted one ----

for _, order in ipairs { 4, 9, 30 } do
  local job = driver.code(scene.plan(scene.file "bodies/heavy_top.lua", { methods = { "taylor" }, order = order }))
  tap.is(shown(ops.of(planned("heavy_top", "double", { "taylor" }), { method = "taylor", order = order }).step),
    shown(ops.of(job, { method = "taylor" }).step), "taylor of order " .. order .. " counted in code of order 20")
end

-- ---- fused operations ----

for _, real in ipairs { "double", "float" } do
  local job, path = planned("brick_centroid", real, { "exact" }), "brick_centroid_fma_" .. real
  job.code.header = "#define SOLVES\n" .. job.code.header
  local did = run(job, path, { { "solve", "NAME_solve(&orbit, &model, x)" }, { "at", "NAME_at(&orbit, 1.25, y)" } },
    true)
  local most, least = ops.call(job, "at", { fma = true }), ops.call(job, "at", { fma = true, least = true })
  tap.ok(did.at.fma > 0 and (same(did.at, most) or same(did.at, least)), real .. ": at with fused operations",
    shown(did.at) .. "\n" .. shown(most))
end

-- ---- closed forms: between the cheapest and the costliest way ----

-- Whose NAME_at takes another way near the start, or where the decay has ended.
local BRANCHES = { foucault = true, damped_brick = true }

for _, path in ipairs(tier.every(4, { "brick_centroid", "symmetric_top", "gyroscope", "gyrostat", "damped_brick",
  "foucault", "tennis_racket" })) do
  for _, real in ipairs { "double", "float" } do
    local job = planned(path, real, { "exact" })
    local tag = path .. ", " .. real
    local list, calls = { "solve", "at_rates", "at_attitude", "at", "set_tick", "at_tick" }, {}
    -- where a loop runs as often as the template says
    local at = path == "damped_brick" and "(&orbit, 10, y)" or "(&orbit, 1.25, y)"
    local after = { at_rates = at, at_attitude = at, at = at, solve = "(&orbit, &model, x)",
      set_tick = "(&orbit, 0.01)", at_tick = "(&orbit, 1234567, y)" }
    for _, f in ipairs(list) do
      if ops.call(job, f) then calls[#calls + 1] = { f, "NAME_" .. f .. after[f] } end
    end
    job.code.header = "#define SOLVES\n" .. job.code.header
    local did = run(job, path .. "_exact_" .. real, calls)
    for _, c in ipairs(calls) do
      local most, least, got = ops.call(job, c[1]), ops.call(job, c[1], { least = true }), did[c[1]]
      if c[1] == "solve" then least = got end -- rods, spheres and rest end early
      local name = tag .. ": " .. c[1]
      if tap.ok(got and within(got, least, most), name .. " between the cheapest and the costliest",
          (got and shown(got) or "not run") .. "\n" .. shown(least) .. "\n" .. shown(most)) and
          (c[1] == "at" and not BRANCHES[path] or same(least, most)) then
        tap.ok(same(got, most) or same(got, least), name .. " exactly one of them")
      end
    end
  end
end

-- ---- the text of whatever is emitted can be read ----

do
  local read, refused = 0, {}
  for _, path in ipairs(tier.quick and {} or { "wheels", "thruster", "magnet_pendulum", "solar_sail", "earth",
    "kapitza", "dual_spin", "spun_coin", "dropped_stone", "dumbbell", "cube_corner" }) do
    local s, admitted = scene.file("bodies/" .. path .. ".lua"), { "exact" }
    for _, m in ipairs(methods) do
      if m.name ~= "exact" and (not m.program or m.program(equations.fork(s.equations), {})) then
        admitted[#admitted + 1] = m.name
      end
    end
    local job = driver.code(scene.plan(s, { methods = admitted }))
    for _, m in ipairs(admitted) do
      for _, setting in ipairs { "step", "tolerance" } do
        local ok, cost, why = pcall(ops.of, job, { method = m, setting = setting })
        if not ok then
          refused[#refused + 1] = path .. ", " .. m .. ": " .. tostring(cost)
        elseif cost then
          read = read + 1
        elseif m ~= "exact" then
          refused[#refused + 1] = path .. ", " .. m .. ": " .. why
        end
      end
    end
  end
  tap.is(table.concat(refused, "\n"), "", "every stepper of many bodies can be counted")
  tap.ok(read > 100 or tier.quick, "and there are many", read)
end

program.finish()
tap.done()
