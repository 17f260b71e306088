#!/usr/bin/env lua5.4
-- cosine.t - squared cosines come back out of sums that the normal form wrote in sines.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local expr = require "generator.algebra.expr"
local cosine = require "generator.algebra.cosine"
local ratio = require "generator.algebra.ratio"

local a, b, t = expr.sym("a", 3, true), expr.sym("b", 3, true), expr.sym "t"
local s, c = expr.call("sin", t), expr.call("cos", t)

for _, e in ipairs { a * c ^ 2 + b * s ^ 2, a ^ 2 * c ^ 2 + 1, 4 * a * c ^ 2 * s ^ 2 + b, 3 / (a * c ^ 2 + b * s ^ 2),
  c ^ 2 - b } do
  tap.ok(cosine(ratio.tidy(e)) == e, "as it was: " .. require("generator.formula.text").of(e))
end
for _, e in ipairs { a - b * s ^ 2, a * s ^ 2 + b, 2 * a - a * s ^ 2, a - a * s } do
  tap.ok(cosine(e) == e, "nothing to bring back: " .. require("generator.formula.text").of(e))
end

-- Sums in squared sines of two angles: a term that is in two pairs goes into one of them.  The oracle is the value, at
-- a point of 400 bits.
do
  local z, state, wrong = expr.call("sin", expr.sym "u"), 1, 0
  local function random(n)
    state = state * 48271 % 2147483647
    return state % n
  end
  local point = { a = R.new(3), b = R.new(7, 5), t = R.new(2, 3), u = R.new(-9, 7) }
  local function value(e) return evaluate.precise(e, point, 400) end
  for _ = 1, 500 do
    local e = expr.zero
    for _ = 1, 3 + random(6) do
      e = e + (random(3) - 1) * (random(2) == 0 and a or b) * s ^ (2 * random(3)) * z ^ (2 * random(2))
    end
    local d = R.abs(value(cosine(e)) - value(e))
    if R.sign(d) ~= 0 and R.log2(d) > -380 then wrong = wrong + 1 end -- 20 bits for some 10 terms below 10
  end
  tap.is(wrong, 0, "500 sums in squared sines of two angles keep their value")
end

tap.done()
