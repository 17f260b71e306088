#!/usr/bin/env lua5.4
-- list.t - polhode list: one line each, the name first, and nothing missing.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local catalogue = require "generator.mass.catalogue"
local effects = require "generator.effects.effects"

local binary = os.getenv "POLHODE" or "build/polhode"

local function lines(what, redirect)
  local list = {}
  local pipe = assert(io.popen(binary .. " list " .. what .. " " .. (redirect or "2>/dev/null")))
  for line in pipe:lines() do list[#list + 1] = line end
  local _, _, status = pipe:close()
  return list, status
end

-- Every line is a name, two or more blanks, and words; names are in the list `want`, all of them.
local function complete(what, want)
  local list, status = lines(what)
  tap.is(status, 0, "list " .. what .. ": status 0")
  local names, bad = {}, {}
  for _, line in ipairs(list) do
    local name = line:match "^(%S+)  +%S"
    if name then names[name] = (names[name] or 0) + 1 else bad[#bad + 1] = line end
  end
  tap.is(#bad, 0, "list " .. what .. ": every line is a name and what it is")
  local missing = {}
  for _, name in ipairs(want) do
    if names[name] ~= 1 then missing[#missing + 1] = name end
  end
  tap.is(table.concat(missing, " "), "", "list " .. what .. ": each of " .. #want .. " names once")
  return list
end

local shapes, effect_names, bodies = {}, {}, {}
for i, s in ipairs(catalogue.list) do shapes[i] = s.name end
for i, e in ipairs(effects) do effect_names[i] = e.name end
do
  local pipe = assert(io.popen "ls bodies/*.lua")
  for path in pipe:lines() do bodies[#bodies + 1] = path:match "([%w_]+)%.lua" end
  pipe:close()
end

local list = complete("shapes", shapes)
tap.is(#list, #shapes, "list shapes: nothing else")
for _, s in ipairs(catalogue.list) do
  for _, line in ipairs(list) do
    if line:match "^%S+" == s.name then
      local said = true
      for _, a in ipairs(s.args or {}) do said = said and line:find("%f[%w_]" .. a.name .. "%f[^%w_]") ~= nil end
      tap.ok(said, "list shapes: " .. s.name .. " has its arguments", line)
    end
  end
end
list = complete("effects", effect_names)
tap.is(#list, #effect_names, "list effects: nothing else")
complete("methods", { "rk4", "exact" })
complete("constants", { "m", "kg", "s", "deg", "rpm", "slug", "ft", "day", "u" })
list = complete("bodies", bodies)
for _, line in ipairs(list) do
  tap.like(line, "%.$", "list bodies: one sentence: " .. line:match "^%S+", true)
end

local _, status = lines "nothing"
tap.is(status, 2, "list of something else: status 2")
local out = lines("nothing", "2>&1 >/dev/null")
tap.like(out[1] or "", "must be shapes, effects, methods, bodies, constants or commands", "and says what there is")

tap.done()
