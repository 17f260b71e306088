#!/usr/bin/env lua5.4
-- product.t - every effect in every form of its flags, on three kinds of body, by every method: polhode check passes.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- For each scene all steppers that take it go to the library's motion, rates, energy and momentum agree to 8 ulp, and
-- the laws that are claimed hold (generator/commands/check.lua).  Then random scenes of two to five effects, half of
-- their numbers parameters; and in float some whose numbers are decimals of 4 to 8 digits, none a parameter: algebra
-- makes whole numbers of up to 1e30 of them, and float ends at 3e38 (generator/ir/lower/size.lua).
-- POLHODE_SCENES=2000 POLHODE_SEED=7: random ones alone, that many of each, from that seed; finds are printed whole.
-- The quick tier takes every tenth of the first kind and no more than four of the second and two of the third;
-- make check-all takes every second of the first.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local scenes = require "tests.effects.scenes"

local dir = program.directory()
local quick = program.quick_compiler() -- these scenes are all equations: little to run, much to compile
local binary = os.getenv "POLHODE" or "build/polhode"

local function put(name, text)
  local path = dir .. "/" .. name .. ".lua"
  program.write(path, text)
  return { name = name, path = path, text = text }
end

-- Runs check over a batch; what failed is said with the scene.  Returns how many scenes and checks passed.
local function run(batch, real)
  local paths = {}
  for i, s in ipairs(batch) do paths[i] = s.path end
  local status = program.shell(string.format("%s timeout 1200 %s check --real %s --states 60 %s >%s/stdout " ..
    "2>%s/stderr", quick, binary, real, table.concat(paths, " "), dir, dir))
  local out, err, checks, bad = program.read(dir .. "/stdout"), program.read(dir .. "/stderr"), 0, {}
  for line in out:gmatch "[^\n]+" do
    local verdict, what = line:match "^(n?o?t? ?ok) %d+ %- (.*)$"
    if verdict then checks = checks + 1 end
    if verdict and verdict ~= "ok" then bad[#bad + 1] = what end
  end
  return { status = status, err = err, checks = checks, bad = bad,
    methods = select(2, out:gsub("library's motion", "")), skipped = out:find "# SKIP its constants" }
end

local total, stepped = 0, 0
local function judge(list, what, real)
  for first = 1, #list, 12 do
    local batch = { table.unpack(list, first, math.min(first + 11, #list)) }
    local r = run(batch, real or "double")
    total, stepped = total + r.checks, stepped + r.methods
    local detail = table.concat(r.bad, "\n") .. "\n" .. r.err:sub(1, 3000)
    if r.status ~= 0 then
      for _, s in ipairs(batch) do
        if r.status == 70 or detail:find(s.name, 1, true) then detail = detail .. "\n" .. s.text end
      end
    end
    tap.ok(r.status == 0 and #r.bad == 0 and not r.skipped and not r.err:find "error",
      string.format("%s %s .. %s: %d checks", what,
      batch[1].name, batch[#batch].name, r.checks), detail)
  end
end

-- ---- each effect on each body ----

local list = {}
for i, v in ipairs(scenes.variants) do
  for n, body in ipairs { "diagonal", "symmetric", "full" } do
    if v.where ~= "plane" or i % 6 == n then -- on a plane, 24 ways: newton.t has them all, here are twelve
      local s = scenes.new(#list * 7919 + n, 0)
      list[#list + 1] = put(v.name .. "_" .. body, scenes.text(s, v.name .. "_" .. body, body, { v }))
    end
  end
end
local asked = tonumber(os.getenv "POLHODE_SCENES")
if not asked then judge(tier.every(10, list, 2), "effects") end

-- ---- together, with parameters ----

local seed = tonumber(os.getenv "POLHODE_SEED") or 1758

-- So many random scenes on these bodies; share of their numbers that are parameters; digits of the others.
local function drawn(count, what, bodies, share, digits)
  local random, made = scenes.new(seed, 0), {}
  while #made < count do
    local chosen, n = {}, 1 + random:random(4)
    for i = 1, n do chosen[i] = scenes.draw(random) end
    if select(2, scenes.fits(chosen)) then
      local body, name = bodies[random:random(#bodies)], what .. "_" .. #made + 1
      local s = scenes.new(seed + 7919 * #made, share)
      s.digits = digits and digits[#made % #digits + 1]
      made[#made + 1] = put(name, scenes.text(s, name, body, chosen))
    end
  end
  return made
end

local together = drawn(asked or tier.quick and 4 or 40, "together", { "diagonal", "symmetric", "full" }, 0.5)
judge(together, "random")

-- ---- decimals of many digits, in float ----

local decimals = drawn(asked or tier.quick and 2 or 24, "decimal", { "diagonal", "full", "points", "points" }, 0,
  { 4, 5, 6, 7, 8 })
judge(decimals, "float", "float")

tap.ok(total > 10 * (#together + (asked and 0 or 10)) and stepped > 2 * #together, total .. " checks, " .. stepped ..
  " of steppers against the library's motion")

tap.done(program.finish())
