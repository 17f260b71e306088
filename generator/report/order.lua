-- order.lua -- which principal axis is called 1, 2, 3 in every report, and how the free motion goes about them.
--
--     order.of(f) -> {places}        of the principal moments of report/facts.lua, which ascend, those of axes 1, 2, 3
--     order.motion(f) -> top         dynamics/free_top.lua of the initial state, or nil where no body turns freely
-- Axis 3 is the axis of symmetry of a symmetric top; else axis 1 has the least moment and axis 3 the largest.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"
local free_top = require "generator.dynamics.free_top"

local order = {}

local BITS = 128

function order.of(f)
  if f.structure.kind == "symmetric" and f.moments[1] ~= f.moments[2] then return { 2, 3, 1 } end
  return { 1, 2, 3 }
end

function order.motion(f)
  local m = f.job.model
  local x0 = { R.one, R.zero, R.zero, R.zero }
  for i = 1, 3 do x0[4 + i] = m:number(m.omega[i]) end
  return free_top.new(vec.map(m.inertia, function(e) return m:number(e) end), x0, BITS, R.new(2) ^ -49)
end

return order
