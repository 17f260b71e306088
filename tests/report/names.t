#!/usr/bin/env lua5.4
-- names.t - documents of scenes whose parameters have any two letters as names: no two things share a symbol.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- First the table alone, for every pair of letters (PI and NU are names of the emitted code): each family of the theory
-- has symbols of its own.  Then the documents of a scene, in every format; POLHODE_PAIRS=all takes all pairs.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"
local driver = require "generator.driver"
local symbols = require "generator.formula.symbols"
local theory = require "generator.formula.theory"
local tree = require "generator.formula.tree"
local facts = require "generator.report.facts"
local handout = require "generator.report.handout.handout"

local letters = {}
for c in string.gmatch("abcdefghijklmnopqrstuvwxyzABCDEFGHJKLMNOPQRSTUVWXYZ", ".") do letters[#letters + 1] = c end
local greek = {}
for word in pairs(tree.greek) do greek[#greek + 1] = word end -- sorted below
table.sort(greek)
for _, word in ipairs(greek) do
  if word ~= "pi" and word ~= "Pi" and word ~= "nu" then letters[#letters + 1] = word end
end

local function key(node) return node[1] .. "_" .. (node.sub or "") end

-- Two things with one symbol, or nil.
local function clash(a, b)
  local s, seen = symbols.new({ a, b }), {}
  for _, name in ipairs { a, b } do
    local k = key(s:of(name))
    if seen[k] then return k .. ": " .. name .. " and " .. seen[k] end
    seen[k] = name
  end
  for _, family in ipairs(theory.families) do
    for _, sub in ipairs(family.subs) do
      local vector = sub == "~"
      local k = key(s:own(family.base, not vector and sub ~= "" and sub or nil, { vector = vector }))
      local other = seen[k]
      -- families of one letter differ by their indices, and a vector and its size share theirs
      if other and other ~= family and not (type(other) == "table" and other.base == family.base) then
        return k .. ": " .. family.meaning .. " and " .. (type(other) == "table" and other.meaning or other)
      end
      seen[k] = other or family
    end
  end
  return nil
end

local wrong, count = {}, 0
for i, a in ipairs(letters) do
  for k = i + 1, #letters, tier.quick and 13 or 1 do
    count = count + 1
    wrong[#wrong + 1] = clash(a, letters[k])
  end
end
tap.is(wrong[1], nil, count .. " pairs of names: every symbol has one meaning")

-- ---- documents ----

local function pair(a, b)
  local job, why = scene.read(string.format([[local x, y = param(%q, 3, "cm"), param(%q, 5, "cm")
    return scene { name = "pair", body = solid.box { x = x, y = y, z = x + y, mass = 1 }, origin = {x/3, 0, 0},
      effects = { effect.damping { c = 1e-4 } }, initial = { omega = {1, 2, 3} } }]], a, b))
  if not job then return why end
  local plan = driver.plan(job, {})
  for _, format in ipairs { "markdown", "latex", "html", "typst" } do
    local fine, text = pcall(handout.text, facts.of(plan), format)
    if not fine then return text end
    for _, name in ipairs { a, b } do
      local letter = tree.greek[name] and format ~= "html" and name or #name == 1 and name
      if letter and not string.find(text, letter, 1, true) then return format .. ": no " .. name end
    end
  end
  return nil
end

local all, list = os.getenv "POLHODE_PAIRS" == "all", {}
for i, a in ipairs(letters) do
  for k = i + 1, #letters do
    if string.lower(a) ~= string.lower(letters[k]) then list[#list + 1] = { a, letters[k] } end
  end
end
local taken, fine = all and list or tier.every(800, list, 40), 0
for _, two in ipairs(taken) do
  local said = pair(two[1], two[2])
  if said then tap.ok(false, two[1] .. " and " .. two[2], said) else fine = fine + 1 end
end
tap.is(fine, #taken, #taken .. " of " .. #list .. " pairs: hand-outs in four formats")
tap.done()
