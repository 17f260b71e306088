#!/usr/bin/env lua5.4
-- throw.t - docs/throw.md: what it shows is what the program prints, and what it finds is the truth of its logs.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local json = require "tests.json"
local program = require "tests.cli.program"
local shown = require "tests.shown"
local throw = require "docs.tools.throw"

local dir = program.directory()
shown.prepare(dir)
for name, text in pairs(throw.logs()) do
  tap.ok(program.read("docs/throw/" .. name) == text, "docs/throw/" .. name .. " is what docs/tools/throw.lua makes")
  program.write(dir .. "/" .. name, text)
end
shown.run("docs/throw.md", dir, 10)
tap.ok(program.read(dir .. "/throw.svg") == program.read "docs/throw/throw.svg", "the picture is that of the page")

local sheet = program.read(dir .. "/fit.svg") or ""
for _, name in ipairs { "phone.csv: gx", "phone.csv: gy", "phone.csv: gz" } do -- its last digits are the machine's
  tap.ok(sheet:find(name, 1, true) and program.read("docs/throw/fit.svg"):find(name, 1, true), "the sheet has " .. name)
end

-- The truth within 3.9 standard errors of what the page's fits find; a right one misses once in 1e4.
local function found(command, wanted)
  local line = string.format("cd %s && PATH=%s/bin:$PATH %s --format json >found 2>&1", dir, dir, command)
  local code = program.shell(line)
  local got = code == 0 and json.read(program.read(dir .. "/found")) or { estimates = {} }
  tap.is(code, 0, command)
  for _, e in ipairs(got.estimates) do
    local want = wanted[e.name]
    if want then tap.ok(math.abs(e.estimate - want) < 3.9 * e.sigma, e.name .. " is the truth", e.estimate) end
    wanted[e.name] = nil
  end
  tap.is(next(wanted), nil, "all of them are found")
end

local t = throw.TRUTH
found("polhode fit book.lua --data phone.csv --free I2,I3,w1,w2,w3,b1,b2,b3", { I2 = t.I2 / t.I1, I3 = t.I3 / t.I1,
  w1 = t.rates[1], w2 = t.rates[2], w3 = t.rates[3], b1 = t.bias[1], b2 = t.bias[2], b3 = t.bias[3] })
found("polhode fit hinge.lua --data swing.csv --free Ih,c,bias,initial", { Ih = t.hinge, c = t.friction,
  bias = t.bias[2] })

program.finish()
tap.done()
