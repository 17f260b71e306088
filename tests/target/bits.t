#!/usr/bin/env lua5.4
-- bits.t -- the same bits on every machine, with gcc and clang, at every level: those of tests/target/bits.txt.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/target/bits.t                     a part of the product that has all of each; a million steps
--     POLHODE_BITS=wide                              each machine, compiler and level with some of the scenes
--     make bits-all  (POLHODE_BITS=all)              the whole product
--     POLHODE_BITS=refresh                           writes bits.txt from this machine's gcc
--
-- Scenes are emitted with --libm own and compiled with -ffp-contract=off.  What is compared and how: bits.c.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local machines = require "tests.target.machines"
local scenes = require "tests.target.scenes"
local bits = require "tests.target.bits"
local jobs = require "tests.target.jobs"

local mode = os.getenv "POLHODE_BITS"
local missing = machines.missing(machines.list)
if #missing > 0 then
  tap.skip("the same bits on other machines", "missing: apt-get install --no-install-recommends " ..
    table.concat(missing, " "))
  tap.done()
end

local runs, files = {}, {}
local function run(r)
  r.out = bits.program(r.s, r.real, r.m, r.compiler, r.level, r.options, r.tag, r.driver)
  runs[#runs + 1], files[#files + 1] = r, r.out
  return r
end

local function comparison(s, real, m, compiler, level)
  return m.compile[compiler] and run { kind = "bits", s = s, real = real, m = m, compiler = compiler, level = level }
end

-- ---- what is built ----

local host, REALS = machines.by_name.host, { "float", "double" }
if mode == "refresh" then
  for _, real in ipairs(REALS) do
    for _, s in ipairs(bits.scenes) do comparison(s, real, host, "gcc", "-O0") end
  end
elseif mode == "all" or mode == "wide" then
  local k = 0
  for _, m in ipairs(machines.list) do
    for _, compiler in ipairs { "gcc", "clang" } do
      for _, level in ipairs(bits.levels) do
        k = k + 1
        for i, s in ipairs(bits.scenes) do
          local at = (i + 3 * k) % #bits.scenes
          if mode == "all" or at == 0 then comparison(s, "float", m, compiler, level) end
          if m.doubles and (mode == "all" or at == 5 and k % 3 == 0) then
            comparison(s, "double", m, compiler, level)
          end
        end
      end
    end
  end
else
  for k, m in ipairs(machines.list) do
    for i, s in ipairs(bits.scenes) do
      for _, real in ipairs(REALS) do
        for _, compiler in ipairs { "gcc", "clang" } do
          local level = bits.level[m.name][compiler]
          if bits.chosen(m, k, i, real, compiler) then comparison(s, real, m, compiler, level) end
        end
      end
    end
  end
end

-- A million steps; the machines without a floating-point unit only when there is time.
local LONG = { scene = "brick_centroid", step = "0.001", methods = "rk4,semi" }
local UNIT = { ["cortex-m4f"] = true, ["cortex-m7"] = true, rv32imafc = true, aarch64 = true, mips = true }
local function long(m)
  return run { kind = "long", s = LONG, real = "float", m = m, compiler = "gcc", level = "-O2", driver = "long.c" }
end
local first_long = mode ~= "refresh" and long(host)
for _, m in ipairs(mode ~= "refresh" and machines.list or {}) do
  local more = mode and UNIT[m.name] or mode == "all" and m.name == "cortex-m3"
  if m ~= host and (m.name == "cortex-m4f" or more) then long(m) end
end

-- What must not agree: x87's registers of 64 bits say so themselves; fused products and sums are noticed.
local x87, fused
if mode ~= "refresh" then
  if string.find(jobs.output "uname -m", "x86_64") then
    x87 = run { kind = "other", s = bits.scenes[2], real = "float", m = host, compiler = "gcc", level = "-O1",
      options = "-mfpmath=387", tag = ".x87" }
  end
  fused = run { kind = "other", s = bits.scenes[2], real = "float", m = machines.by_name.aarch64, compiler = "gcc",
    level = "-O2", options = "-ffp-contract=fast", tag = ".fused" }
end

jobs.run(scenes.dir, "bits", files)

-- ---- what they say ----

local function title(r)
  return string.format("%s, %s %s, %s, %s", r.m.name, r.compiler, r.level, r.s.scene, r.real)
end

if mode == "refresh" then
  local got = {}
  for _, r in ipairs(runs) do
    local items, order = bits.read(r.out)
    assert(items, title(r) .. ": " .. tostring(order))
    got[#got + 1] = { key = r.s.scene .. " " .. r.real, items = items, order = order }
  end
  bits.write(got)
end

local golden = bits.golden()

-- The items that differ from the golden ones or are not among them; nil and a text if it did not run.
local printed = {}
local function differing(r)
  local items, order = bits.read(r.out)
  if not items then return nil, order end
  local want, bad = golden[r.s.scene .. " " .. r.real] or {}, {}
  for _, name in ipairs(order) do
    printed[r.s.scene .. " " .. r.real .. " " .. name] = true
    if items[name] ~= want[name] then bad[#bad + 1] = name end
  end
  return bad, order
end

local agreed, group = {}, {}
for _, r in ipairs(runs) do
  if r.kind == "bits" then
    local bad, order = differing(r)
    local key = string.format("%s, %s %s", r.m.name, r.compiler, r.level)
    if not group[key] then
      group[key] = { n = 0, reals = {} }
      agreed[#agreed + 1] = key
    end
    local g = group[key]
    if not bad or #bad > 0 then
      tap.ok(false, title(r), bad and "other bits: " .. table.concat(bad, " ") or order)
      g.bad = true
    else
      g.n = g.n + #order
      g.reals[r.real] = (g.reals[r.real] or 0) + 1
    end
  end
end
for _, key in ipairs(agreed) do
  local g = group[key]
  tap.ok(not g.bad and g.n > 0, string.format("%s: %d results of %d scenes in float and %d in double have the " ..
    "golden bits", key, g.n, g.reals.float or 0, g.reals.double or 0))
end

if mode == "refresh" then tap.done() end

-- nothing that the golden file has went unprinted; a run of some scenes only (POLHODE_BITS=wide) prints the rest
if mode ~= "wide" then
  local absent = {}
  for scene, items in pairs(golden) do -- sorted below: order is lost
    for name in pairs(items) do -- in any order
      if not printed[scene .. " " .. name] then absent[#absent + 1] = scene .. " " .. name end
    end
  end
  table.sort(absent)
  tap.is(table.concat(absent, ", "), "", "every golden item was printed somewhere")
end
for _, compiler in ipairs { "gcc", "clang" } do
  local seen = {}
  for _, r in ipairs(runs) do seen[r.compiler == compiler and r.kind == "bits" and r.level or ""] = true end
  local absent = {}
  for _, level in ipairs(bits.levels) do absent[#absent + 1] = not seen[level] and level or nil end
  tap.is(table.concat(absent, " "), "", compiler .. " stands there at every level")
end

local want = bits.read(first_long.out) or {}
tap.ok(want.step and want.semi_step, "a million steps of rk4 and semi on the host", jobs.slurp(first_long.out))
for _, r in ipairs(runs) do
  if r.kind == "long" and r ~= first_long then
    local got, why = bits.read(r.out)
    tap.ok(got and got.step == want.step and got.semi_step == want.semi_step,
      r.m.name .. ": after a million steps of rk4 and of semi in float the state is the host's, bit by bit", why)
  end
end

if x87 then
  tap.like(jobs.slurp(x87.out) or "", "evaluation method 2: not compared",
    "a build for the x87 says that it evaluates in another way")
end
local bad, why = differing(fused)
tap.ok(bad and #bad > 0, "aarch64 with -ffp-contract=fast has other bits, and is noticed", why)
if bad then tap.diag("fused, other bits: " .. table.concat(bad, " ")) end
tap.done()
