-- handbook.lua - the tables of tests/handbook in doubles, for surface.t; and what only pictures need.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A row: {node, measure =, com = {x, y, z}, and I or S as tests/handbook.lua says}.  Nodes are the numeric form of a
-- shape (the library's), which a region has of its own.

local handbook = require "tests.handbook"

local pi, sqrt, sin = math.pi, math.sqrt, math.sin
local rows = {}

local function sinh(x) return (math.exp(x) - math.exp(-x)) / 2 end
local function cosh(x) return (math.exp(x) + math.exp(-x)) / 2 end
local doubles = { pi = pi, abs = math.abs, sqrt = sqrt, sin = sin, cos = math.cos, sinh = sinh, cosh = cosh }

for _, r in ipairs(handbook.rows) do
  local node = assert(load("return {" .. r.args .. "}", r.args, "t", r.at))()
  node.shape = r.shape
  if r.shape == "shell.cylinder" then node.ends = node.ends or false end
  local v = handbook.values(r, r.at, doubles)
  rows[#rows + 1] = { node = node, measure = v.measure, com = v.com, I = v.I }
end

do -- prolate spheroid, s = sin(latitude): dA = 2 pi a sqrt(p - q s^2) ds, p = l^2, q = l^2 - a^2, sin u = e
  local a, l = 1.4, 2
  local p, q = l ^ 2, l ^ 2 - a ^ 2
  local u = math.asin(sqrt(q / p))
  local I0 = p / (2 * sqrt(q)) * (u + sin(2 * u) / 2) -- int_0^1 sqrt(p - q s^2)
  local I2 = p ^ 2 / (8 * q ^ 1.5) * (u - sin(4 * u) / 4) -- int_0^1 s^2 sqrt(p - q s^2)
  local xx = a ^ 2 / 2 * (1 - I2 / I0)
  local measure, long = 4 * pi * a * I0, p * I2 / I0
  rows[#rows + 1] = { node = { shape = "shell.ellipsoid", a = a, b = a, c = l }, measure = measure,
    S = { xx, xx, long } }
  rows[#rows + 1] = { node = { shape = "shell.ellipsoid", a = l, b = a, c = a }, measure = measure,
    S = { long, xx, xx } }
end

-- regions: a slab over the parabola 0 <= q <= 1 - p^2, |p| <= 1, in all six orders of the variables
for _, o in ipairs { { 1, 2, 3 }, { 1, 3, 2 }, { 2, 1, 3 }, { 2, 3, 1 }, { 3, 1, 2 }, { 3, 2, 1 } } do
  local square = { -1, 0, 0, 0 }
  square[1 + o[1]] = 2
  local com, S = { 0, 0, 0 }, {}
  com[o[2]], com[o[3]] = 2 / 5, 1 / 2
  S[o[1]], S[o[2]], S[o[3]] = 1 / 5, 8 / 35, 1 / 3
  local product = { [3] = 4, [4] = 5, [5] = 6 } -- (1,2) (1,3) (2,3) by their sum
  S[4], S[5], S[6] = 0, 0, 0
  S[product[o[2] + o[3]]] = 1 / 5
  rows[#rows + 1] = { measure = 4 / 3, com = com, S = S, node = { shape = "region", order = o,
    limits = { { { { -1, 0, 0, 0 } }, { { 1, 0, 0, 0 } } }, { {}, { { 1, 0, 0, 0 }, square } },
      { {}, { { 1, 0, 0, 0 } } } } } }
end

return rows
