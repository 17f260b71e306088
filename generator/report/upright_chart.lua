-- upright_chart.lua -- the upright spins of a body on a plane (dynamics/upright.lua) as report/chart.lua draws a spin.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local upright = require "generator.dynamics.upright"

local upright_chart = {}
upright_chart.__index = upright_chart

local shown = { up = "the normal, z up", down = "the normal, z down", straight = "the axis, rolling straight",
  edge = "the normal, on the edge" }

-- What chart.text takes of the model, for the rate n, a rational; nil where no spin is upright.
function upright_chart.of(m, n)
  local self = setmetatable({ margins = {}, axes = {}, conditions = {}, by = {} }, upright_chart)
  for i, u in ipairs(upright.of(m)) do
    local e = expr.num(n) ^ 2 * u.a - u.c
    self.margins[i], self.axes[i], self.conditions[i], self.by[e] = e, shown[u.key], u.condition, u.condition
  end
  local by = self.by
  self.critical = { condition = function(_, e) return string.gsub(by[e] or "", ">", "=") end }
  return #self.margins > 0 and self or nil
end

function upright_chart:atoms() return self.margins end

function upright_chart:signs(sign)
  local list = {}
  for i, e in ipairs(self.margins) do list[i] = sign(e) end
  return list
end

function upright_chart.verdict(signs, k) return signs[k] end
function upright_chart:condition(k) return self.conditions[k] end
function upright_chart.equality() return "" end

return upright_chart
