#!/usr/bin/env lua5.4
-- absent.t - an effect that is absent leaves no trace, and one of zero strength is absent.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- For every effect in effects/effects.lua (an effect without a row in tests/effects/rows.lua fails):
--   * the files of a scene with it at constant zero strength are those of the scene without it, byte for byte, alone
--     and beside the two next effects of the list at full strength;
--   * no state, parameter, input or derived constant that it would bring stands in the header, in the code or among the
--     symbols of the object of the scene without it.
-- The quick tier asks every fifth effect.
-- What has no zero strength (an input, a motion through space) says why, and only the second is asked.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"
local program = require "tests.cli.program"
local effects = require "generator.effects.effects"
local rows = require("tests.effects.rows").strengths

local BOX = "solid.box { x = 2, y = 3, z = 5, mass = 7 }"

-- The planned job and the files of a scene with the effects; their strength is a parameter where it is used.
local function emitted(list, place)
  local text = table.concat(list, ", ")
  local strength = string.find(text, "strength", 1, true) and 'local strength = param("strength", 1.5)' or ""
  local job, why = scene.read(strength .. "\nlocal r = scene {\n  name = \"b\",\n  body = " .. BOX ..
    ",\n  effects = {" .. text .. "}, initial = { omega = {1, 2, 3} },\n  " ..
    (place == "corner" and 'origin = "corner"' or "") .. " }\nreturn r\n")
  if not job then return nil, nil, why end
  job = scene.plan(job)
  return scene.files(job, true), job
end

local function same(a, b, what)
  local different = {}
  for _, name in ipairs(b) do
    if a[name] ~= b[name] then different[#different + 1] = name end
  end
  tap.ok(#a == #b and #different == 0, what .. ": the same bytes", "different: " .. table.concat(different, " "))
end

-- ---- zero strength ----

local names = {}
for i, e in ipairs(effects) do names[i] = string.gsub(e.name, "^effect%.", "") end

-- The two next effects of the list that may stand beside the i-th, with their strength.
local function beside(i)
  local row, list = rows[names[i]], {}
  for k = 1, #names - 1 do
    local other = rows[names[(i + k - 1) % #names + 1]]
    if #list < 2 and other and not other.alone and not (row.place and other.place and row.place ~= other.place) and
      not (row.place == "moves" and other.place == "moves") then
      list[#list + 1] = other
    end
  end
  return list
end

for i = 1, #names, tier.quick and 5 or 1 do
  local name = names[i]
  local row = rows[name]
  if tap.ok(row ~= nil, name .. ": has a row in this test") and row.zero then
    local without = emitted({ row.absent }, row.place)
    for _, text in ipairs { row.zero, table.unpack(row.also or {}) } do
      local zero, _, why = emitted({ text }, row.place)
      if tap.ok(zero ~= nil, text .. " is a scene", why) then same(zero, without, text .. ", no strength") end
    end
    for _, other in ipairs(beside(i)) do
      local place = row.place or other.place
      local with, _, why = emitted({ row.zero, other.full }, place)
      if tap.ok(with ~= nil, name .. " at zero strength beside another effect is a scene", why) then
        same(with, emitted(row.absent and { row.absent, other.full } or { other.full }, place), name ..
          " at zero strength beside " .. other.full)
      end
    end
  end
end

-- ---- no names ----

local dir = program.directory()
local plain, nothing = emitted({}, "corner")
program.write(dir .. "/b.h", plain["b.h"])
program.write(dir .. "/b.c", plain["b.c"])
tap.is(program.shell("cd " .. dir .. " && gcc -std=c99 -c b.c && nm b.o > symbols"), 0,
  "the code without effects compiles")
local symbols = program.read(dir .. "/symbols")
program.finish()

-- What a job names: states, parameters, inputs, derived constants.
local function words(job)
  local list = {}
  for _, group in ipairs { job.states, job.model.params, job.model.inputs,
    job.model.members } do
    for _, x in ipairs(group) do list[#list + 1] = x.name end
  end
  return list
end

local own = {}
for _, w in ipairs(words(nothing)) do own[w] = true end

for i = 1, #names, tier.quick and 5 or 1 do
  local name = names[i]
  local row = rows[name]
  if row then
    local files, job, why = emitted({ row.full }, row.place)
    if tap.ok(files ~= nil, name .. ": a scene with it", why) then
      local missing, found = {}, {}
      for _, w in ipairs(words(job)) do
        if not own[w] then
          local here, there = false, string.find(symbols, "%f[%w]" .. w .. "%f[%W]") ~= nil
          for k, part in ipairs { " B_" .. string.upper(w) .. ",", "_real " .. w .. ";", "m->" .. w } do
            local file = k < 3 and "b.h" or "b.c"
            here = here or string.find(files[file], part, 1, true) ~= nil
            there = there or string.find(plain[file], part, 1, true) ~= nil
          end
          if there then found[#found + 1] = w end
          if not here then missing[#missing + 1] = w end
        end
      end
      tap.ok(string.find(files["b.h"], "Effect " .. name, 1, true) ~= nil and
        string.find(plain["b.h"], "Effect " .. name, 1, true) == nil,
        name .. ": the header names it where it is there, and only there")
      tap.ok(#missing == 0, name .. ": what it brings is found where it is there", table.concat(missing, " "))
      tap.ok(#found == 0, name .. ": nothing of it in the scene without effects", table.concat(found, " "))
    end
  end
  tap.ok(row ~= nil and (row.zero ~= nil or row.why ~= nil), name .. ": has a zero strength, or says why not")
end

-- ---- states as needed ----

local function header(text, place) return assert(emitted({ text }, place))["b.h"] end
for _, orbit in ipairs { { "{ radius = 2 }", false }, { "{ a = 2, e = 0.5 }", true } } do
  local text = header("effect.gravity_gradient { mu = 1, orbit = " .. orbit[1] .. " }", "centroid")
  tap.is(string.find(text, "B_ANOMALY,", 1, true) ~= nil, orbit[2], "orbit " .. orbit[1] ..
    (orbit[2] and ": no circle, so the anomaly is a state" or ": a circle, no state"))
end
local wheel = rows.wheel.full
tap.ok(string.find(plain["b.h"], "WHEEL", 1, true) == nil, "no wheel, no state of a wheel")
tap.ok(string.find(header(wheel), "B_WHEEL,", 1, true) ~= nil, "a wheel has a state")
tap.ok(string.find(header(wheel .. ", " .. wheel), "B_WHEEL_2,", 1, true) ~= nil, "two wheels have two")

tap.done()
