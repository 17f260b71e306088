#!/usr/bin/env lua5.4
-- versions.t - what docs/versions.md calls stable is still there: each line of tests/docs/stable.txt, the list of the
-- last release.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- POLHODE_STABLE=refresh writes the list anew: for a release, or after a break that docs/changelog.md tells of.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local help = require "generator.commands.help"
local fields = require "generator.language.fields"
local catalogue = require "generator.mass.catalogue"
local effects = require "generator.effects.effects"

local binary = os.getenv "POLHODE" or "build/polhode"
local LIST = "tests/docs/stable.txt"

-- What there is now, a line each, sorted.
local function present()
  local list = {}
  local function put(...) list[#list + 1] = string.format(...) end
  for _, name in ipairs(help.names) do
    put("command %s", name)
    for _, row in ipairs(help.of(name).options) do
      put("option %s %s", name, row[1])
      for _, choice in ipairs(type(row[2]) == "table" and row[2] or {}) do
        put("choice %s %s %s", name, row[1], choice)
      end
    end
  end
  for _, g in ipairs(fields.groups) do
    for _, f in ipairs(g.fields) do put("field %s.%s", g.name, f[1]) end
  end
  for _, f in ipairs(fields.functions) do put("function %s", f[1]) end
  for _, s in ipairs(catalogue.list) do
    put("shape %s", s.name)
    for _, a in ipairs(s.args or {}) do put("argument %s %s", s.name, a.name) end
  end
  for _, e in ipairs(effects) do
    put("effect %s", e.name)
    for _, a in ipairs(e.args or {}) do put("argument %s %s", e.name, a.name) end
    for _, a in ipairs(e.takes or {}) do put("argument %s %s", e.name, a[1]) end
  end
  local header = io.popen(binary .. " run bodies/brick.lua --at 0"):read "l"
  for column in header:gmatch "[^,]+" do put("column run %s", column) end
  for key in io.popen(binary .. " run bodies/brick.lua --at 0 --format json"):read "a":gmatch '"([%w_]+)"%s*:' do
    put("key run %s", key)
  end
  local code = program.read "tests/golden/brick/brick.h":gsub("/%*.-%*/", ""):gsub("%s+", " ")
  for declaration in code:gmatch "([%w_]+ brick_[%w_]+%b());" do put("declaration %s", declaration) end
  for states in code:gmatch "enum { ([^}]*)}" do put("enumerators %s", (states:gsub(" $", ""))) end
  table.sort(list)
  local out = {}
  for i, line in ipairs(list) do
    if line ~= list[i - 1] then out[#out + 1] = line end
  end
  return out
end

local now, set = present(), {}
if os.getenv "POLHODE_STABLE" == "refresh" then program.write(LIST, table.concat(now, "\n") .. "\n") end
for _, line in ipairs(now) do set[line] = true end

local count, gone = 0, {}
for line in program.read(LIST):gmatch "[^\n]+" do
  count = count + 1
  if not set[line] then gone[#gone + 1] = line end
end
tap.ok(count > 400, "the list of what is stable has " .. count .. " lines")
tap.is(table.concat(gone, "\n"), "", "each of them is in the program")
tap.ok(not set["command nonsense"] and set["command gen"] and set["declaration int brick_init(brick_model *m, " ..
  "const brick_real p[])"] and set["column run qw"], "the list can tell what is there from what is not")

tap.done()
