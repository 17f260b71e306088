-- sleeping.lua -- how fast a heavy symmetric top must spin to stay upright on its point.
--
-- Linearised about the upright spin n, with alpha the horizontal part of the axis and i the quarter turn about the
-- vertical (Goldstein, section 5.7; Klein and Sommerfeld, chapter 5):
--     I1 alpha'' - i I3 n alpha' - M g l alpha = 0                          stable for (I3 n)^2 > 4 I1 M g l
-- The free body's verdict about its axis says nothing of this: gravity turns the axis over however the moments lie.
-- The same law on a plane is upright.lua's.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local critical = require "generator.mass.critical"

local sleeping = {}
sleeping.__index = sleeping

sleeping.law = "(I3 n)^2 > 4 I1 M g l"

-- |v| where v is along a coordinate axis: without a root, as v points at the parameters' defaults.
local function length(m, v)
  local along = {}
  for i = 1, 3 do
    if v[i] ~= expr.zero then along[#along + 1] = v[i] end
  end
  if #along > 1 then return expr.sqrt(ratio.tidy(vec.dot(v, v))) end
  return along[1] and m:double(along[1]) < 0 and -along[1] or along[1] or expr.zero
end

-- A name for the rate that no parameter has.
local function free(m)
  local taken = {}
  for _, p in ipairs(m.params) do taken[p.name] = true end
  for _, name in ipairs { "n", "spin", "n_spin" } do
    if not taken[name] then return name end
  end
  return "n_upright"
end

-- Of a scene whose motion is Lagrange's top and has a weight, else nil:
--     {a, c: expressions of the parameters, stable for a n^2 > c; n: the symbol of the rate, spin: the scene's own, an
--      expression; rate: the least |n|, rad/s, nil where no rate is enough}
-- with the methods of mass/spin_stability that a report of one axis needs.
function sleeping.of(m, closed)
  if not closed or closed.kind ~= "lagrange" then return nil end
  local s, g = m.structure, m.record.effects[1].a.g
  local l = length(m, m.com)
  if l == expr.zero or m:double(g) <= 0 or m:double(m.mass * l) <= 0 then return nil end
  local k = s.kind == "symmetric" and s.k or m.com
  local I3 = s.kind == "sphere" and s.alpha or s.rod and expr.zero or s.axial
  local self = setmetatable({ a = ratio.tidy(I3 ^ 2), c = ratio.tidy(4 * s.alpha * m.mass * g * l) }, sleeping)
  self.critical = critical.of(m.conditions)
  self.n = expr.sym(free(m), 6, true)
  self.spin = ratio.tidy(vec.dot(k, m.omega) / length(m, k))
  self.margin = ratio.tidy(self.a * self.spin ^ 2 - self.c)
  if I3 ~= expr.zero then self.rate = math.sqrt(m:double(self.c) / m:double(self.a)) end
  return self
end

function sleeping:atoms() return { self.margin } end
function sleeping:signs(sign) return { sign(self.margin) } end
function sleeping.verdict(signs) return signs[1] end

-- The condition on the rate, solved for it: "n > .." in the parameters; "never" without a moment about the axis.
function sleeping:condition(_, _, style)
  if self.a == expr.zero then return "never" end
  local quotient = self.critical:plain(self.c / self.a)
  local root = self.critical:root(quotient, style)
  return (style == "plain" and "abs(" .. self.n.name .. ")" or "|" .. self.n.name .. "|") .. " > " .. root
end

-- Is the spin of the scene's own parameters enough?  1, 0, -1
function sleeping:here(m) return R.sign(m:number(self.margin)) end

return sleeping
