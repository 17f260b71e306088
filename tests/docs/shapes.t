#!/usr/bin/env lua5.4
-- shapes.t - docs/shapes.md and its pictures are what docs/tools makes; every shape is there and well formed.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The catalogue is also compared with the surfaces that are drawn: two descriptions of a shape that share nothing.
-- The quick tier compares every fifth shape, and reads every sixth example.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local catalogue = require "generator.mass.catalogue"
local evaluate = require "generator.algebra.evaluate"
local examples = require "docs.tools.examples"
local shapes = require "docs.tools.shapes"
local surface = require "generator.geometry.surface"
local integrals = require "tests.geometry.integrals"

local binary = os.getenv "POLHODE" or "build/polhode"

local function read(path)
  local file = io.open(path, "rb")
  if not file then return nil end
  local text = file:read "a"
  file:close()
  return text
end

-- A small check of XML: tags nest and close, attributes are quoted and named once, entities are known, and nothing but
-- blanks is outside the root.  Returns nil or what is wrong.
local function malformed(text)
  local open, at, roots = {}, 1, 0
  while true do
    local from, to, tag = text:find("<([^<>]*)>", at)
    local between = text:sub(at, (from or #text + 1) - 1)
    if between:find "[<>]" then return "stray < or >" end
    if between:gsub("&%a+;", { ["&amp;"] = "", ["&lt;"] = "", ["&gt;"] = "", ["&quot;"] = "" }):find "&" then
      return "unknown entity in " .. between
    end
    if #open == 0 and between:find "%S" then return "text outside the root" end
    if not from then break end
    local name = tag:match "^/([%w]+)$"
    if name then
      if table.remove(open) ~= name then return "</" .. name .. "> closes another element" end
    else
      local element, rest, empty = tag:match "^(%w+)(.-)(/?)$"
      if not element then return "no element: " .. tag end
      local seen = {}
      rest = rest:gsub('%s+([%w:%-]+)="([^"&<]*)"', function(key)
        if seen[key] then seen.twice = key end
        seen[key] = true
        return ""
      end)
      if rest:find "%S" or seen.twice then return "attributes of " .. tag end
      if #open == 0 then roots = roots + 1 end
      if empty == "" then open[#open + 1] = element end
    end
    at = to + 1
  end
  return #open > 0 and "<" .. open[#open] .. "> stays open" or roots ~= 1 and roots .. " roots" or nil
end

for text, what in pairs { ["<a><b></a>"] = "another", ["<a x=1/>"] = "attributes", ["<a>&foo;</a>"] = "entity",
  ["<a/><b/>"] = "roots", ["<a>"] = "open", ["<a>1 < 2</a>"] = "" } do
  tap.like(malformed(text) or "nothing", what, "the check of XML refuses " .. text)
end

-- ---- the files ----

local files = shapes.files(catalogue.list)
local stale, bad, large, named = {}, {}, {}, {}
for _, f in ipairs(files) do
  named[f.name] = f.text
  if read("docs/" .. f.name) ~= f.text then stale[#stale + 1] = f.name end
  if f.name:find "%.svg$" then
    local why = malformed(f.text)
    if why then bad[#bad + 1] = f.name .. ": " .. why end
    if #f.text > 24000 then large[#large + 1] = f.name .. " " .. #f.text end
    if f.text:find "nan" or f.text:find "inf" then bad[#bad + 1] = f.name .. ": not a number" end
  end
end
tap.is(table.concat(stale, " "), "", "what is in docs is what the tool makes (else: make docs)")
tap.is(table.concat(bad, "\n"), "", "the pictures are well formed")
tap.is(table.concat(large, " "), "", "and small")

do
  local missing, left = {}, {}
  for _, s in ipairs(catalogue.list) do
    if not named["shapes/" .. s.name .. ".svg"] then missing[#missing + 1] = s.name end
    if not named["shapes.md"]:find("\n## " .. s.name .. "\n", 1, true) then
      missing[#missing + 1] = s.name .. " (page)"
    end
    if not named["shapes.md"]:find("](shapes/" .. s.name .. ".svg)", 1, true) then
      missing[#missing + 1] = s.name .. " (link)"
    end
  end
  tap.is(table.concat(missing, " "), "", "every shape of the catalogue has its section and its picture")
  local pipe = assert(io.popen "ls docs/shapes")
  for name in pipe:lines() do
    if not named["shapes/" .. name] then left[#left + 1] = name end
  end
  pipe:close()
  tap.is(table.concat(left, " "), "", "no picture is left of a shape that is gone")
end

-- ---- example scenes are read by the program ----

do
  local path, refused = os.tmpname(), {}
  local lines = {}
  for line in named["shapes.md"]:gmatch "```lua\n(.-)\n```" do lines[#lines + 1] = line end
  for _, line in ipairs(tier.every(6, lines)) do
    if not line:find "file = " then
      local file = assert(io.open(path, "w"))
      file:write('return scene { name = "example", body = ', line, ", initial = { omega = {1, 2, 3} } }\n")
      file:close()
      if not os.execute(binary .. " explain " .. path .. " >/dev/null 2>&1") then refused[#refused + 1] = line end
    end
  end
  os.remove(path)
  -- a rod cannot have a rate along its line: the only refusal that is meant
  tap.is(table.concat(refused, "\n"), "", "every example is a scene that the program takes")
end

-- ---- catalogue against surface ----

for _, spec in ipairs(tier.every(5, catalogue.list)) do
  if spec.build and spec.args then
    local example = examples[spec.name]
    local made, node = shapes.example(spec), { shape = spec.name }
    for k, v in pairs(example.args) do node[k] = v end
    local function sums(n) -- 24, 48, 96: the angles of the examples are whole numbers of segments
      local s = surface.of(node, n)
      local sum = spec.measure == "volume" and integrals.volume(s.faces)
        or spec.measure == "area" and integrals.area(s.faces) or integrals.length(s.lines)
      for i = 2, 10 do sum[i] = sum[i] / sum[1] end
      return sum
    end
    local A, B, C = sums(24), sums(48), sums(96)
    local function value(e) return e and evaluate.double(e, {}) or 0 end
    local com = made.com or {}
    local want = { value(made.measure), value(com[1]), value(com[2]), value(com[3]) }
    for k, ij in ipairs { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } } do
      want[4 + k] = value(made.sigma[k]) + want[1 + ij[1]] * want[1 + ij[2]]
    end
    local size = math.sqrt(want[5] + want[6] + want[7])
    local wrong = {}
    for i = 1, 10 do -- as in tests/geometry/surface.t: two steps of Richardson, the last change bounds the error
      local scale = i == 1 and want[1] or i <= 4 and size or size ^ 2
      local b, d = B[i] + (B[i] - A[i]) / 3, C[i] + (C[i] - B[i]) / 3
      local best, left = d + (d - b) / 15, math.abs(d - b) + 1e-12 * scale
      local fine = math.abs(best - want[i]) <= left -- false for NaN
      if not fine or left > 5e-4 * scale then
        wrong[#wrong + 1] = string.format("%d: surface %.12g, catalogue %.12g, allowed %.2g", i, best, want[i], left)
      end
    end
    tap.ok(#wrong == 0, spec.name .. ": the catalogue and the surface that is drawn agree", table.concat(wrong, "\n"))
  end
end

tap.done()
