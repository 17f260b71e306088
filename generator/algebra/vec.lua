-- vec.lua -- vectors, symmetric tensors, matrices and quaternions of expressions.
--
-- ABOVE the line.  A vector is {x, y, z}; a matrix is three rows; a symmetric tensor is the six entries
-- {xx, yy, zz, xy, xz, yz} (entries, so the off-diagonals are MINUS the products of inertia); a quaternion is
-- {w, x, y, z}, scalar first, Hamilton product, body to inertial.  Entries are anything with + and *
-- (expressions here, rationals or doubles as well).
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"

local vec = {}

function vec.map(a, f)
  local b = {}
  for i = 1, #a do b[i] = f(a[i], i) end
  return b
end

function vec.add(a, b) return vec.map(a, function(x, i) return x + b[i] end) end
function vec.sub(a, b) return vec.map(a, function(x, i) return x - b[i] end) end
function vec.scale(k, a) return vec.map(a, function(x) return k * x end) end

function vec.dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end

function vec.cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end

---- symmetric tensors -----------------------------------------------------------------------------

-- position of entry (i, j) among the six
vec.index = { { 1, 4, 5 }, { 4, 2, 6 }, { 5, 6, 3 } }
vec.entry = { "xx", "yy", "zz", "xy", "xz", "yz" }
vec.pair = { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } }

-- S a
function vec.apply(S, a)
  return { S[1] * a[1] + S[4] * a[2] + S[5] * a[3], S[4] * a[1] + S[2] * a[2] + S[6] * a[3],
    S[5] * a[1] + S[6] * a[2] + S[3] * a[3] }
end

-- symmetric product a aT
-- as six entries
function vec.outer(a) return { a[1] * a[1], a[2] * a[2], a[3] * a[3], a[1] * a[2], a[1] * a[3], a[2] * a[3] } end

-- adjugate (matrix of cofactors) and determinant: S adj = det 1
function vec.adjugate(S)
  local xx, yy, zz, xy, xz, yz = table.unpack(S)
  local adj = { yy * zz - yz * yz, xx * zz - xz * xz, xx * yy - xy * xy, xz * yz - xy * zz, xy * yz - xz * yy,
    xy * xz - yz * xx }
  return adj, xx * adj[1] + xy * adj[4] + xz * adj[5]
end

-- The solution of S a = n for a positive S; `name(prefix, e)` may give a quantity a name.
-- Golub and Van Loan, Matrix Computations, 4th ed., section 4.1.2: S = L diag(S_xx, dy, dz) L^T.  For a positive S no
-- order of the pivots is needed.  What is lost is what the last digits of S's entries decide: less than by adjugate and
-- determinant, which lose along every axis what the smallest eigenvalue loses along its own, and leave the numbers'
-- range with an eigenvalue's cube.
function vec.solve(S, n, name)
  local xx, yy, zz, xy, xz, yz = table.unpack(S)
  local rx = name("Inversex", 1 / xx)
  local lxy, lxz = name("Lowxy", xy * rx), name("Lowxz", xz * rx)
  local ry = name("Inversey", 1 / name("Pivoty", yy - lxy * xy))
  local left = name("Leftyz", yz - lxy * xz)
  local lyz = name("Lowyz", left * ry)
  local uy = name("Lefty", n[2] - lxy * n[1])
  local z = name("Turnz", (n[3] - lxz * n[1] - lyz * uy) / name("Pivotz", zz - lxz * xz - lyz * left))
  local y = name("Turny", uy * ry - lyz * z)
  return { n[1] * rx - lxy * y - lxz * z, y, z }
end

function vec.trace(S) return S[1] + S[2] + S[3] end

-- The tensor of inertia  tr(S) 1 - S  of the second moments S, and the second moments  tr(I)/2 1 - I  of a tensor.
function vec.inertia(S)
  return { S[2] + S[3], S[1] + S[3], S[1] + S[2], -S[4], -S[5], -S[6] }
end

function vec.second(I)
  local half = vec.trace(I) * R.half
  return { half - I[1], half - I[2], half - I[3], -I[4], -I[5], -I[6] }
end

---- matrices --------------------------------------------------------------------------------------

-- column j of a matrix
function vec.column(A, j) return { A[1][j], A[2][j], A[3][j] } end

function vec.matvec(A, v)
  return { vec.dot(A[1], v), vec.dot(A[2], v), vec.dot(A[3], v) }
end

function vec.transpose(A) return { vec.column(A, 1), vec.column(A, 2), vec.column(A, 3) } end

-- A B
function vec.matmul(A, B)
  local C = {}
  for i = 1, 3 do
    C[i] = {}
    for j = 1, 3 do C[i][j] = vec.dot(A[i], vec.column(B, j)) end
  end
  return C
end

-- The six entries as three rows, and back.
function vec.full(S)
  local A = {}
  for i = 1, 3 do A[i] = { S[vec.index[i][1]], S[vec.index[i][2]], S[vec.index[i][3]] } end
  return A
end

function vec.symmetric(A) return { A[1][1], A[2][2], A[3][3], A[1][2], A[1][3], A[2][3] } end

-- A S AT for a symmetric S
function vec.congruence(A, S) return vec.symmetric(vec.matmul(vec.matmul(A, vec.full(S)), vec.transpose(A))) end

---- quaternions -----------------------------------------------------------------------------------

-- Hamilton's product, i j = k: turning by p q is turning by q and then by p.
function vec.qmul(p, q)
  local a, b, c, d = table.unpack(p)
  local w, x, y, z = table.unpack(q)
  return { a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y, a * y - b * z + c * w + d * x,
    a * z + b * y - c * x + d * w }
end

-- The matrix R with v_inertial = R v_body for a UNIT quaternion.
function vec.rotation(q)
  local w, x, y, z = table.unpack(q)
  return {
    { w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y) },
    { 2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x) },
    { 2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z },
  }
end

-- The same for the turn by `angle` about the unit vector n (Rodrigues): cos 1 + (1 - cos) n n^T + sin [n]x.
function vec.rodrigues(n, angle)
  local c, s = expr.call("cos", angle), expr.call("sin", angle)
  local A = {}
  for i = 1, 3 do
    A[i] = {}
    for j = 1, 3 do A[i][j] = (1 - c) * n[i] * n[j] end
    A[i][i] = A[i][i] + c
  end
  for i = 1, 3 do
    local j, k = i % 3 + 1, (i + 1) % 3 + 1
    A[k][j], A[j][k] = A[k][j] + s * n[i], A[j][k] - s * n[i]
  end
  return A
end

return vec
