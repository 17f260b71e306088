#!/usr/bin/env lua5.4
-- fit.t - docs/fit.md: its commands print what it shows and find the truth of its logs; on the logs of
-- tests/reference/fit they find what that says.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- book.lua is the page's first scene; satellite.lua is that of case 11.  What they find is within
-- 1e-6 standard errors of the reference.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local json = require "tests.json"
local program = require "tests.cli.program"
local cases = require "tests.fit.cases"
local shown = require "tests.shown"

local dir, root = program.directory(), "tests/reference/fit/"
shown.prepare(dir)
shown.run("docs/fit.md", dir, 7)

local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = os.getenv "PWD" .. "/" .. binary end
local page = program.read "docs/fit.md"

-- A log without noise: the fit is off by its steps' error only, far below a standard error.
for name, truth in page:gmatch "%-%-set (%w+)=([%d.]+)" do
  local found, sigma = page:match("\n      " .. name .. "%s+([%d.]+)%s+%+%- ([%d.e-]+)")
  tap.ok(found and math.abs(found - truth) < 0.1 * sigma, name .. " of the log is found", found)
end

program.write(dir .. "/log.csv", program.read(root .. "01_free_ratios/log.csv"))
local wheels
for _, c in ipairs(cases) do wheels = c.folder == "11_wheel_driven" and c or wheels end
local known = json.read(program.read(root .. "11_wheel_driven/case.json"))
local held = { xy = true, xz = true, yz = true } -- the page holds them; at the common minimum the others are the same
program.write(dir .. "/satellite.lua", (wheels.scene:gsub("SIGMA", wheels.sigma_text):gsub('param%("(%w+)", GUESS',
  function(name)
    local x = held[name] and known.fits[1].estimate[name] or known.parameters[name].guess
    return string.format('param("%s", "%.17g"', name, x)
  end)))
program.write(dir .. "/gyro.csv", program.read(root .. "11_wheel_driven/log.csv"))
program.write(dir .. "/wheels.csv", program.read(root .. "11_wheel_driven/wheels.csv"))

local wanted = { ["fit book.lua"] = { "01_free_ratios", { "I2", "I3" } },
  ["fit satellite.lua"] = { "11_wheel_driven", { "xx", "yy", "zz" } } }
local count = 0
for words in page:gmatch "\n    %$? ?polhode ([^\n]*)" do
  local kind = words:match "^%w+ [%w.]+"
  if not wanted[kind] and kind ~= "design book.lua" then goto continue end
  count = count + 1
  local code = program.shell(string.format("cd %s && %s %s --format json > out 2> err", dir, binary, words))
  tap.is(code, 0, "polhode " .. words)
  local got = code == 0 and json.read(program.read(dir .. "/out")) or { estimates = {} }
  local want = wanted[kind]
  local case = want and json.read(program.read(root .. want[1] .. "/case.json")).fits[1]
  for i, name in ipairs(want and want[2] or {}) do
    local e = got.estimates[i]
    tap.ok(e and math.abs(e.estimate - case.estimate[name]) <= 1e-6 * case.sigma[name], name .. " is the reference's")
  end
  ::continue::
end
tap.is(count, 3, "the page has three commands")

program.finish()
tap.done()
