#!/usr/bin/env lua5.4
-- ops.t - the operations that generator/plan/ops.lua counts are those that the emitted code does.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The oracle: the emitted C, read as C++ with a number that counts (counted.h) in the place of NAME_real, is compiled,
-- run, and says what it did.  Where no branch depends on the numbers the counts must be equal; where one does, they lie
-- between the cheapest and the costliest way, and reach one of them where the state is chosen so.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local program = require "tests.cli.program"
local driver = require "generator.driver"
local ops = require "generator.plan.ops"
local methods = require "generator.methods.list"

local dir = program.directory()
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
  local pipe = assert(io.popen(string.format("cd %s && g++ -std=c++11 -w -O0 -I%s/tests/plan %s %s.main.cc " ..
    "-o %s.run -lm 2>&1 && ./%s.run", dir, os.getenv "PWD", fma and "-DFP_FAST_FMA -DFP_FAST_FMAF" or "", tag, tag,
    tag)))
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
  local job = scene.plan(scene.file("bodies/" .. path .. ".lua"), { real = real, methods = names })
  driver.code(job)
  return job
end

-- ---- every body: the text of whatever is emitted can be read ----

do
  local pipe = assert(io.popen "ls bodies/*.lua")
  local paths, read, refused = pipe:read "a", 0, {}
  pipe:close()
  for path in paths:gmatch "%S+" do
    local job, admitted = scene.file(path), { "exact" }
    for _, m in ipairs(methods) do
      if m.name ~= "exact" and (not m.program or m.program(job.equations, {})) then admitted[#admitted + 1] = m.name end
    end
    scene.plan(job, { methods = admitted })
    driver.code(job)
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
  tap.is(table.concat(refused, "\n"), "", "every stepper of every body can be counted")
  tap.ok(read > 250, "and there are many", read)
end

program.finish()
tap.done()
