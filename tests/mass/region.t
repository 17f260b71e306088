#!/usr/bin/env lua5.4
-- region.t - bodies between polynomial limits with polynomial densities, integrated another way.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Oracles: closed forms of handbooks, and nested Newton-Cotes quadrature on 15 rational nodes, which is exact for the
-- polynomials of degree 15 that occur here; both in exact rationals at random sizes, so without any tolerance.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"

local POINTS = 2
local ZERO, ONE = R.zero, R.one
local PAIRS = { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } }

-- ---- quadrature ----

local NODES = 15

-- Weights of the rule on k/(NODES - 1): integral over (0, 1) of each Lagrange polynomial, multiplied out.
local weights, nodes = {}, {}
for k = 1, NODES do nodes[k] = R.new(k - 1, NODES - 1) end
for k = 1, NODES do
  local p, scale = { ONE }, ONE -- coefficients from degree 0
  for j = 1, NODES do
    if j ~= k then
      local q = {}
      for d = 1, #p + 1 do q[d] = (p[d - 1] or ZERO) - nodes[j] * (p[d] or ZERO) end
      p, scale = q, scale * (nodes[k] - nodes[j])
    end
  end
  local sum = ZERO
  for d, c in ipairs(p) do sum = sum + c / R.new(d) end
  weights[k] = sum / scale
end
do
  local sum = ZERO
  for k = 1, NODES do sum = sum + weights[k] * nodes[k] ^ 15 end
  tap.ok(sum == R.new(1, 16), "the rule is exact for x^15")
end

-- order: coordinates from outermost; limits[n](r) -> lo, hi; density(r).  Mass, first moments, second moments.
local function integrate(order, limits, density)
  local out = { ZERO, ZERO, ZERO, ZERO, ZERO, ZERO, ZERO, ZERO, ZERO, ZERO }
  local r = { ZERO, ZERO, ZERO }
  local function visit(n, weight)
    if n > 3 then
      local w = weight * density(r)
      out[1] = out[1] + w
      for i = 1, 3 do out[1 + i] = out[1 + i] + w * r[i] end
      for k, ij in ipairs(PAIRS) do out[4 + k] = out[4 + k] + w * r[ij[1]] * r[ij[2]] end
      return
    end
    local lo, hi = limits[n](r)
    for k = 1, NODES do
      r[order[n]] = lo + (hi - lo) * nodes[k]
      visit(n + 1, weight * weights[k] * (hi - lo))
    end
    r[order[n]] = ZERO
  end
  visit(1, ONE)
  return out
end

-- Mass, centre and tensor about the origin from the integrals, scaled to the mass M if that is given.
local function properties(s, M)
  local k = M and M / s[1] or ONE
  local t = s[5] + s[6] + s[7]
  return { s[1] * k, s[2] / s[1], s[3] / s[1], s[4] / s[1], (t - s[5]) * k, (t - s[6]) * k, (t - s[7]) * k, -s[8] * k,
    -s[9] * k, -s[10] * k }
end

local function holds(name, body, params, want)
  local m = assert(scene.body(body, params, "origin = {0, 0, 0}")).model
  local wrong = {}
  for _ = 1, POINTS do
    local e = {}
    for _, p in ipairs(params) do
      e[p:match "^%w+"] = scene.rational()
    end
    local got = { m.mass, m.com[1], m.com[2], m.com[3], table.unpack(m.inertia) }
    for i, w in ipairs(want(e)) do
      if scene.exact(got[i], e) ~= R.lift(w) then wrong[i] = i end
    end
  end
  local list = {}
  for i = 1, 10 do list[#list + 1] = wrong[i] end
  tap.is(table.concat(list, " "), "", name)
end

-- ---- closed forms ----

-- the corner of a box cut off: mean x = a/4, x^2 = a^2/10, x y = a b/20 (Beer and Johnston; Tonon 2004)
local function simplex(V)
  return function(e)
    local a, b, c, m = e.a, e.b, e.c, V(e)
    return { m, a / 4, b / 4, c / 4, m * (b ^ 2 + c ^ 2) / 10, m * (a ^ 2 + c ^ 2) / 10, m * (a ^ 2 + b ^ 2) / 10,
      -m * a * b / 20, -m * a * c / 20, -m * b * c / 20 }
  end
end
holds("a tetrahedron, by its density",
  "region { {x, 0, a}, {y, 0, b*(1 - x/a)}, {z, 0, c*(1 - x/a - y/b)}, density = rho }", { "rho", "a", "b", "c" },
  simplex(function(e) return e.rho * e.a * e.b * e.c / 6 end))
holds("by its mass, from the other side",
  "region { {z, 0, c}, {x, 0, a*(1 - z/c)}, {y, 0, b*(1 - z/c - x/a)}, mass = M }", { "M", "a", "b", "c" },
  simplex(function(e) return e.M end))
-- a slab over a parabola: mean x^2 = a^2/5, y = 2 h/5, y^2 = 8 h^2/35
holds("a parabolic cylinder", "region { {x, -a, a}, {y, 0, h*(1 - x^2/a^2)}, {z, 0, c}, density = rho }",
  { "rho", "a", "h", "c" }, function(e)
    local a, h, c = e.a, e.h, e.c
    local m, xx, yy, zz = 4 * e.rho * a * h * c / 3, a ^ 2 / 5, 8 * h ^ 2 / 35, c ^ 2 / 3
    return { m, 0, 2 * h / 5, c / 2, m * (yy + zz), m * (xx + zz), m * (xx + yy), 0, 0, -m * h * c / 5 }
  end)
-- density rho (1 + k x/a) in a box from the origin: x^n has the weight 1/(n + 1) + k/(n + 2)
holds("a graded box", "region { {x, 0, a}, {y, 0, b}, {z, 0, c}, density = quantity(1, \"kg/m^3\")*rho*(1 + k1*x/a) }",
  { "rho", "k1", "a", "b", "c" }, function(e)
    local k, a, b, c = e.k1, e.a, e.b, e.c
    local w = 1 + k / 2
    local x, xx = a * (R.new(1, 2) + k / 3) / w, a ^ 2 * (R.new(1, 3) + k / 4) / w
    local m = e.rho * a * b * c * w
    return { m, x, b / 2, c / 2, m * (b ^ 2 + c ^ 2) / 3, m * (xx + c ^ 2 / 3), m * (xx + b ^ 2 / 3), -m * x * b / 2,
      -m * x * c / 2, -m * b * c / 4 }
  end)

-- ---- quadrature, in all orders of the coordinates ----

local names = { "x", "y", "z" }
for _, o in ipairs { { 1, 2, 3 }, { 1, 3, 2 }, { 2, 1, 3 }, { 2, 3, 1 }, { 3, 1, 2 }, { 3, 2, 1 } } do
  local u, v, w = names[o[1]], names[o[2]], names[o[3]]
  local text = string.format("region { {%s, -a, 2*a}, {%s, -%s^2/a, b + %s}, {%s, %s/2 - %s, 2*c + %s + %s}, ",
    u, v, u, u, w, u, v, u, v)
  local limits = {
    function(e) return -e.a, 2 * e.a end,
    function(e, r) return -r[o[1]] ^ 2 / e.a, e.b + r[o[1]] end,
    function(e, r) return r[o[1]] / 2 - r[o[2]], 2 * e.c + r[o[1]] + r[o[2]] end,
  }
  local function at(e)
    return { function() return limits[1](e) end, function(r) return limits[2](e, r) end,
      function(r) return limits[3](e, r) end }
  end
  local sizes = { "a = 1", "b = 4", "c = 20" }
  holds(u .. v .. w .. ": uniform, by mass", text .. "mass = M }", { "M", table.unpack(sizes) }, function(e)
    return properties(integrate(o, at(e), function() return ONE end), e.M)
  end)
  holds(u .. v .. w .. ": graded in all three", text ..
    string.format('density = quantity(1, "kg/m^3")*rho*(1001 + %s^2/a^2 + 30*%s*%s/(b*c) + 9*%s/c + 99*%s/b) }',
      u, v, w, w, u),
    { "rho", table.unpack(sizes) }, function(e)
      return properties(integrate(o, at(e), function(r)
        return e.rho * (1001 + r[o[1]] ^ 2 / e.a ^ 2 + 30 * r[o[2]] * r[o[3]] / (e.b * e.c) + 9 * r[o[3]] / e.c +
          99 * r[o[1]] / e.b)
      end))
    end)
end

tap.done()
