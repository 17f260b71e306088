#!/usr/bin/env lua5.4
-- cosine.t - squared cosines come back out of sums that the normal form wrote in sines.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local expr = require "generator.algebra.expr"
local cosine = require "generator.algebra.cosine"
local ratio = require "generator.algebra.ratio"

local a, b, t = expr.sym("a", 3, true), expr.sym("b", 3, true), expr.sym "t"
local s, c = expr.call("sin", t), expr.call("cos", t)

for _, e in ipairs { a * c ^ 2 + b * s ^ 2, a ^ 2 * c ^ 2 + 1, 4 * a * c ^ 2 * s ^ 2 + b, 3 / (a * c ^ 2 + b * s ^ 2),
  c ^ 2 - b } do
  tap.ok(cosine(ratio.tidy(e)) == e, "as it was: " .. require("generator.algebra.text").of(e))
end
for _, e in ipairs { a - b * s ^ 2, a * s ^ 2 + b, 2 * a - a * s ^ 2, a - a * s } do
  tap.ok(cosine(e) == e, "nothing to bring back: " .. require("generator.algebra.text").of(e))
end

tap.done()
