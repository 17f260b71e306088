#!/usr/bin/env lua5.4
-- simulation.t - docs/simulation.md and docs/sweep.md: their commands print what they show, and the fit finds the
-- parameter of the log.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local shown = require "tests.shown"

local dir, page = program.directory(), program.read "docs/simulation.md"
shown.prepare(dir)
shown.run("docs/simulation.md", dir, 6)
shown.run("docs/sweep.md", dir, 1)

-- The log has no noise: the fit is off by its steps' error only, far below a standard error.
local truth = tonumber(page:match 'param%("k", ([%d.e-]+)')
local found, error_of = page:match "\n    %s+k%s+([%d.e-]+)%s+%+%- ([%d.e-]+)"
tap.ok(found and math.abs(found - truth) < 0.1 * error_of, "k of the log is found", found)

program.finish()
tap.done()
