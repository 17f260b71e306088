-- principal.lua -- the structure of an inertia tensor: which entries vanish, which moments are equal, and the
-- principal axes in closed form where they have one.
--
-- classify(I) looks for, in this order (all tests exact, see ratio.iszero):
--     sphere      I = alpha 1
--     symmetric   I = alpha 1 + beta k k^T/|k|^2   one axis k (any direction); rod if alpha + beta = 0
--     diagonal    three moments on the coordinate axes
--     full        anything else
-- A symmetric tensor off the coordinate axes is recognised by  beta k_i k_j = I_ij  (i /= j), hence
-- beta k_x^2 = I_xy I_xz / I_yz: the cube about its corner is one.
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local R = require "generator.algebra.rational"
local text = require "generator.formula.text"
local vec = require "generator.algebra.vec"

local principal = {}

local zero, one = expr.zero, expr.one
local tidy, iszero = ratio.tidy, ratio.iszero

local function unit_axis(i)
  local k = { zero, zero, zero }
  k[i] = one
  return k
end

local function symmetric(alpha, axial, k)
  return { kind = "symmetric", alpha = tidy(alpha), axial = tidy(axial), k = k }
end

-- All tests for every value of the parameters: three moments that happen to be equal stay diagonal.
local function diagonal(I)
  local same12, same13, same23 = iszero(I[1] - I[2]), iszero(I[1] - I[3]), iszero(I[2] - I[3])
  if same12 and same13 then return { kind = "sphere", alpha = I[1] } end
  if same12 then return symmetric(I[1], I[3], unit_axis(3)) end
  if same13 then return symmetric(I[1], I[2], unit_axis(2)) end
  if same23 then return symmetric(I[2], I[1], unit_axis(1)) end
  return { kind = "diagonal" }
end

-- Denominator of e as it stands: the product of its factors with negative exponents, and of its coefficient.
local function denominator(e)
  local list = { R.den((expr.split(e))) }
  for _, f in ipairs(e.kind == "mul" and e or { e }) do
    if f.kind == "pow" and R.sign(f.exp) < 0 then list[#list + 1] = expr.pow(f.base, -f.exp) end
  end
  return expr.mul(list)
end

-- The plane direction (a : b) of that candidate {a, b} which is shortest when denominators are cleared: it is
-- polynomial, so it has a value wherever the tensor has one (a turned cylinder's is (sin, cos), not (1, cos/sin)).
local function direction(candidates)
  local best, length
  for _, c in ipairs(candidates) do
    local quotient = tidy(c[2] / c[1])
    local d = denominator(quotient)
    local k = { d, (tidy(quotient * d)) }
    local size = #text.of(k[1]) + #text.of(k[2])
    if not best or size < length then best, length = k, size end
  end
  return best[1], best[2]
end

-- One off-diagonal entry I_ij, the third axis c alone: a 2x2 block.  Symmetric about a direction in the block's
-- plane iff (I_ii - I_cc)(I_jj - I_cc) = I_ij^2.
local function block(I, i, j, c)
  local x, y, z, p = I[i], I[j], I[c], I[vec.index[i][j]]
  if iszero((x - z) * (y - z) - p ^ 2) then
    local k = { zero, zero, zero }
    k[i], k[j] = direction { { x - z, p }, { p, y - z } }
    return symmetric(z, x + y - z, k)
  end
  return { kind = "full", block = { i, j, c } }
end

-- I_ij = beta k_i k_j gives I_xx - I_xy I_xz/I_yz = alpha, and the same for y and z; k = (1, I_yz/I_xz, I_yz/I_xy).
local function oblique(I)
  local xy, xz, yz = I[4], I[5], I[6]
  local alpha = I[1] - xy * xz / yz
  if iszero(alpha - (I[2] - xy * yz / xz)) and iszero(alpha - (I[3] - xz * yz / xy)) then
    alpha = tidy(alpha)
    return symmetric(alpha, vec.trace(I) - 2 * alpha, { one, tidy(yz / xz), (tidy(yz / xy)) })
  end
  return { kind = "full" }
end

-- The structure of I; see the head.
function principal.classify(I)
  local off = {}
  for n = 4, 6 do
    if not iszero(I[n]) then off[#off + 1] = n end
  end
  local s
  if #off == 0 then
    s = diagonal(I)
  elseif #off == 1 then
    local p = vec.pair[off[1]]
    s = block(I, p[1], p[2], 6 - p[1] - p[2])
  elseif #off == 3 then
    s = oblique(I)
  else
    s = { kind = "full" }
  end
  if s.kind == "symmetric" then
    s.rod = iszero(s.axial)
    s.k2 = tidy(vec.dot(s.k, s.k))
  elseif s.kind == "sphere" then
    s.rod = false
    s.nothing = iszero(s.alpha)
  end
  return s
end

-- Moments and axes in closed form, not ordered: a list of {moment, axis (not normalised), multiplicity}, or nil
-- when the characteristic cubic has no closed form worth printing.
function principal.closed(I, s)
  if s.kind == "sphere" then return { { moment = s.alpha, multiplicity = 3 } } end
  if s.kind == "symmetric" then
    return { { moment = s.alpha, multiplicity = 2 }, { moment = s.axial, axis = s.k, multiplicity = 1 } }
  end
  if s.kind == "diagonal" then
    local list = {}
    for i = 1, 3 do list[i] = { moment = I[i], axis = unit_axis(i), multiplicity = 1 } end
    return list
  end
  if s.block then
    local i, j, c = table.unpack(s.block)
    local x, y, p = I[i], I[j], I[vec.index[i][j]]
    local root = expr.sqrt(tidy((x - y) ^ 2 + 4 * p ^ 2))
    local list = { { moment = I[c], axis = unit_axis(c), multiplicity = 1 } }
    for _, sign in ipairs { -1, 1 } do
      local moment = (x + y + sign * root) / 2
      local axis = { zero, zero, zero }
      axis[i], axis[j] = p, moment - x
      list[#list + 1] = { moment = moment, axis = axis, multiplicity = 1 }
    end
    return list
  end
  return nil
end

return principal
