-- turns.lua -- how an inertial frame lies in its link's frame, as rotations in the order in which they are done.
--
-- A turn is {axis = {x, y, z} of unit length, angle =} or {q = unit quaternion}, of exact expressions; a vector of the
-- inertial frame, taken through all turns of a list, is the same vector in the link's axes.  No turn: the axes are
-- parallel.  An angle is the decimal that is written, in degrees times pi/180: so right angles given in degrees are
-- exact, and those given in radians are what their digits say.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"

local turns = {}

local zero, one = expr.zero, expr.one
local unit = { x = { one, zero, zero }, y = { zero, one, zero }, z = { zero, zero, one } }

local function angle(q, degrees)
  if degrees then return expr.num(q) * expr.pi / 180 end
  return expr.num(q)
end

local turn, radian = R.parse "6.284", R.parse "0.001" -- a full turn, also one that was typed as 6.2832
local eighth = math.pi / 4

-- What is wrong with the unit of an angle, if anything, as the end of a message: whole multiples of 45 degrees are
-- typed as 1.57 and 3.1416, with two decimals and more, and nobody means 1.5708 degrees.
function turns.suspect(q, degrees, shown)
  if not degrees then return R.abs(q) > turn and "is in radians and " .. shown .. " looks like degrees" or nil end
  local x = math.abs(R.todouble(q))
  local n = math.floor(x / eighth + 0.5)
  if n < 1 or n > 8 or R.isint(q) or math.abs(x - n * eighth) > R.todouble(radian) * n then return nil end
  return "is in degrees and " .. shown .. " looks like radians"
end

-- Fixed axes x, y, z in this order: R = Rz(yaw) Ry(pitch) Rx(roll).
function turns.rpy(rpy, degrees)
  local list = {}
  for i, name in ipairs { "x", "y", "z" } do
    if R.sign(rpy[i]) ~= 0 then list[#list + 1] = { axis = unit[name], angle = angle(rpy[i], degrees) } end
  end
  return list
end

-- Axes in the order of `sequence`: a small letter turns about the axis that has been turned so far, a capital about the
-- one that stays.
function turns.euler(angles, sequence, degrees)
  local list = {}
  for i = 1, 3 do
    local letter = string.sub(sequence, i, i)
    local small = string.lower(letter)
    if R.sign(angles[i]) ~= 0 then
      table.insert(list, letter == small and 1 or #list + 1, { axis = unit[small], angle = angle(angles[i], degrees) })
    end
  end
  return list
end

local function squared(v)
  local n = expr.zero
  for _, x in ipairs(v) do n = n + x * x end
  return n
end

local function exact(v) return vec.map(v, expr.num) end

local function zero_vector(v)
  for _, x in ipairs(v) do
    if R.sign(x) ~= 0 then return false end
  end
  return true
end

-- Everything below returns nil and a rule for what has no direction.

-- Scalar first; any length.
function turns.quaternion(q)
  if zero_vector(q) then return nil, "must not be zero" end
  if R.sign(q[2]) == 0 and R.sign(q[3]) == 0 and R.sign(q[4]) == 0 then return {} end
  local e = exact(q)
  local length = expr.sqrt(squared(e))
  return { { q = vec.map(e, function(x) return x / length end) } }
end

function turns.axisangle(v, degrees)
  local n = { v[1], v[2], v[3] }
  if zero_vector(n) then return nil, "must have an axis that is not zero" end
  if R.sign(v[4]) == 0 then return {} end
  local e = exact(n)
  local length = expr.sqrt(squared(e))
  return { { axis = vec.map(e, function(x) return x / length end), angle = angle(v[4], degrees) } }
end

-- The least rotation that takes z to v: about z x v, by half-angle tangent |z x v| / (|v| + v.z).
function turns.zaxis(v)
  if zero_vector(v) then return nil, "must not be zero" end
  if R.sign(v[1]) == 0 and R.sign(v[2]) == 0 then
    if R.sign(v[3]) > 0 then return {} end
    return { { q = { zero, one, zero, zero } } } -- opposite: about x
  end
  local e = exact(v)
  local q = { expr.sqrt(squared(e)) + e[3], -e[2], e[1], zero }
  local length = expr.sqrt(squared(q))
  return { { q = vec.map(q, function(x) return x / length end) } }
end

-- The quaternion of a rotation matrix: 4 q qT is linear in the matrix, and the row of its largest diagonal entry is q
-- up to a factor (Shepperd 1978, J. Guidance and Control 1, 223).  D: which entry is largest, decided on doubles.
local function of_matrix(A, D)
  local trace = D[1][1] + D[2][2] + D[3][3]
  local best, row = trace, 0
  for i = 1, 3 do
    if D[i][i] > best then best, row = D[i][i], i end
  end
  local q
  if row == 0 then
    q = { one + A[1][1] + A[2][2] + A[3][3], A[3][2] - A[2][3], A[1][3] - A[3][1], A[2][1] - A[1][2] }
  else
    local i, j, k = row, row % 3 + 1, (row + 1) % 3 + 1
    q = { A[k][j] - A[j][k] }
    q[i + 1], q[j + 1], q[k + 1] = one + A[i][i] - A[j][j] - A[k][k], A[j][i] + A[i][j], A[k][i] + A[i][k]
  end
  local length = expr.sqrt(squared(q))
  return vec.map(q, function(x) return x / length end)
end

-- Columns of the matrix: x, then y made orthogonal to it, then their cross product.  number: expression -> double.
function turns.xyaxes(v, number)
  local x, y = { v[1], v[2], v[3] }, { v[4], v[5], v[6] }
  local dot, square = vec.dot(x, y), vec.dot(x, x)
  if zero_vector(x) or zero_vector(y) then return nil, "must have axes that are not zero" end
  y = vec.map(y, function(c, i) return c * square - dot * x[i] end)
  if zero_vector(y) then return nil, "must have axes that are not parallel" end
  local function normal(w)
    local e = exact(w)
    local length = expr.sqrt(squared(e))
    return vec.map(e, function(c) return c / length end)
  end
  local A = vec.transpose { normal(x), normal(y), normal(vec.cross(x, y)) }
  local D = vec.map(A, function(row) return vec.map(row, number) end)
  return { { q = of_matrix(A, D) } }
end

return turns
