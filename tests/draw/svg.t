#!/usr/bin/env lua5.4
-- svg.t - the SVG writer: numbers, escaping, ticks, the scale of a chart, sameness.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local svg = require "generator.draw.svg"

-- ---- numbers and text ----

for x, want in pairs { [0] = "0", [-0.001] = "0", [1] = "1", [100] = "100", [0.5] = ".5", [-0.25] = "-.25",
  [12.345] = "12.35", [-3.10] = "-3.1", [1e3] = "1000" } do
  tap.is(svg.number(x), want, "the number " .. x .. " is written " .. want)
end
tap.throws(function() svg.number(0 / 0) end, "not finite", "a coordinate that is no number is an error")
tap.throws(function() svg.number(math.huge) end, "not finite", "an infinite one too")
tap.is(svg.escape 'a<b & "c">', "a&lt;b &amp; &quot;c&quot;&gt;", "text is escaped")

local function drawn(fn, options)
  local d = svg.new(100, 80, options)
  fn(d)
  return svg.text(d)
end

do
  local text = drawn(function(d)
    d:math(1, 2, "r_in < h^2")
    d:math(1, 2, "⟨ω⟩_x / (rad/s)", "label")
    d:path({ { 0, 0 }, { 1.5, 2 } }, "curve a")
    d:group("label", function() d:circle(1, 2, 3, "dot") end)
  end, { title = "a < b", about = "c & d" })
  tap.like(text, 'r<tspan dy="4" font-size="75%">in</tspan><tspan dy="-4" xml:space="preserve"> &lt;</tspan> h',
    "subscripts")
  tap.like(text, '<tspan dy="-6" font-size="75%">2</tspan></text>', "superscripts")
  tap.like(text, '<tspan font-style="italic">ω</tspan><tspan dy="4" font-size="75%">x</tspan>',
    "a quantity in italics")
  tap.like(text, "<title>a &lt; b</title>\n<desc>c &amp; d</desc>", "title and description")
  tap.like(text, '<path class="curve a" d="M0,0 1.5,2"/>', "a path")
  tap.like(text, '<g class="label">\n<circle class="dot" cx="1" cy="2" r="3"/>\n</g>', "a group")
  tap.like(text, ".dot{", "the styles that are used are there")
  tap.ok(not text:find(".dashed{", 1, true), "those that are not used are left out")
  tap.like(text, "@media screen and (prefers-color-scheme:dark){", "dark on screens only")
end

-- ---- ticks ----

local function values(list)
  local out = {}
  for i, t in ipairs(list) do out[i] = t[2] end
  return table.concat(out, " ")
end

tap.is(values(svg.ticks(0, 1, 5)), "0 0.2 0.4 0.6 0.8 1", "ticks of 0 .. 1")
tap.is(values(svg.ticks(-1, 1, 4)), "−1 −0.5 0 0.5 1", "ticks of -1 .. 1, with a true minus")
tap.is(values(svg.ticks(0.1, 0.35, 5)), "0.1 0.15 0.2 0.25 0.3 0.35", "ends that are multiples are ticks")
tap.is(values(svg.ticks(3e5, 9e5, 3)), "400000 600000 800000", "ticks of large numbers")
tap.is(values(svg.ticks(1e-7, 3e-7, 4)), "1e-07 1.5e-07 2e-07 2.5e-07 3e-07", "ticks of small numbers")
tap.is(values(svg.log_ticks(1, 1000)), "1 10 100 1000", "powers of ten")
tap.is(values(svg.log_ticks(1e-6, 1e-3)), "10^{−6} 10^{−5} 10^{−4} 0.001", "small powers of ten")
tap.is(values(svg.log_ticks(1, 30)), "1 2 5 10 20", "a short logarithmic range has 2 and 5 too")
do
  local bad = 0
  for i = 1, 400 do -- a step is 1 to 2.5 sixths of the range: 2 to 7 ticks, all inside
    local lo = (i * 37 % 101 - 50) * 10.0 ^ (i % 9 - 4)
    local hi = lo + (1 + i * 53 % 97) * 10.0 ^ (i % 7 - 3)
    local list = svg.ticks(lo, hi, 6)
    if #list < 2 or #list > 7 then bad = bad + 1 end
    for _, t in ipairs(list) do
      if t[1] < lo - 1e-6 * (hi - lo) or t[1] > hi + 1e-6 * (hi - lo) then bad = bad + 1 end
    end
  end
  tap.is(bad, 0, "2 to 7 ticks in any range, none outside")
end

-- ---- frames ----

do
  local d = svg.new(200, 100)
  local s = svg.frame(d, { x0 = 40, y0 = 10, x1 = 190, y1 = 80, xrange = { 0, 3 }, yrange = { 1, 100 }, ylog = true,
    xlabel = "h/r_out", ylabel = "error" })
  local x, y = s.at(0, 1)
  tap.ok(x == 40 and y == 80, "the lower left corner")
  x, y = s.at(3, 100)
  tap.near(x, 190, 1e-15, 0, "the upper right corner, x", "one multiplication")
  tap.near(y, 10, 1e-14, 0, "the upper right corner, y", "a logarithm and one multiplication")
  tap.near(s.y(10), 45, 1e-14, 0, "the middle of a logarithmic axis", "a logarithm and one multiplication")
  tap.is(svg.text(d), svg.text(d), "a document may be written twice")
end

tap.done()
