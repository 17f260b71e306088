#!/usr/bin/env lua5.4
-- vec.t: vectors, tensors and quaternions obey their identities, for symbols and hence for all values.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The zero test that decides here is itself tested in ratio.t.  Conventions are pinned by examples with numbers.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local recipe = require "tests.algebra.recipe"

local function symbols(names)
  local list = {}
  for name in names:gmatch "%S+" do list[#list + 1] = expr.sym(name) end
  return list
end
local a, b, c, d = symbols "ax ay az", symbols "bx by bz", symbols "cx cy cz", symbols "dx dy dz"
local p, q, r = symbols "pw px py pz", symbols "qw qx qy qz", symbols "rw rx ry rz"
local S = symbols "xx yy zz xy xz yz"
local A = { symbols "a11 a12 a13", symbols "a21 a22 a23", symbols "a31 a32 a33" }

local function equal(u, v, name)
  local wrong = {}
  local function compare(s, t, where)
    if expr.is(s) or expr.is(t) then
      if not ratio.equal(expr.lift(s), expr.lift(t)) then wrong[#wrong + 1] = where end
      return
    end
    if #s ~= #t then wrong[#wrong + 1] = where .. " has another length" end
    for i = 1, #s do compare(s[i], t[i], where .. "[" .. i .. "]") end
  end
  compare(u, v, "")
  return tap.ok(#wrong == 0, name, "differs at " .. table.concat(wrong, " "))
end

local add, sub, scale, dot, cross, matmul = vec.add, vec.sub, vec.scale, vec.dot, vec.cross, vec.matmul
local zero, one = expr.zero, expr.one
local identity = { { one, zero, zero }, { zero, one, zero }, { zero, zero, one } }

-- ---- vectors ----

equal(cross(a, b), scale(expr.lift(-1), cross(b, a)), "a x b = -b x a")
equal(cross(a, a), { zero, zero, zero }, "a x a = 0")
equal(dot(a, cross(a, b)), zero, "a . (a x b) = 0")
equal(cross(a, cross(b, c)), sub(scale(dot(a, c), b), scale(dot(a, b), c)), "a x (b x c) = b (a.c) - c (a.b)")
equal(add(add(cross(a, cross(b, c)), cross(b, cross(c, a))), cross(c, cross(a, b))), { zero, zero, zero },
  "a x (b x c) + cyclic = 0 (Jacobi)")
equal(dot(a, cross(b, c)), dot(b, cross(c, a)), "a . (b x c) is cyclic")
equal(dot(cross(a, b), cross(c, d)), dot(a, c) * dot(b, d) - dot(a, d) * dot(b, c),
  "(a x b) . (c x d) = (a.c)(b.d) - (a.d)(b.c) (Lagrange)")
equal(cross({ one, zero, zero }, { zero, one, zero }), { zero, zero, one }, "x cross y is z: right-handed")

-- ---- tensors ----

equal(vec.apply(S, a), vec.matvec(vec.full(S), a), "S a by six entries is S a by nine")
equal(vec.full(S), vec.transpose(vec.full(S)), "the matrix of a symmetric tensor is symmetric")
equal(vec.symmetric(vec.full(S)), S, "symmetric() undoes full()")
equal(vec.full(S)[1][2], S[4], "the fourth entry is xy")
equal(vec.full(S)[1][3], S[5], "the fifth entry is xz")
equal(vec.full(S)[2][3], S[6], "the sixth entry is yz")
equal(vec.apply(vec.outer(a), b), scale(dot(a, b), a), "(a a^T) b = a (a.b)")
equal(vec.trace(vec.outer(a)), dot(a, a), "tr(a a^T) = a.a")
equal(dot(a, vec.apply(S, b)), dot(b, vec.apply(S, a)), "a.(S b) = b.(S a)")
do
  local adj, det = vec.adjugate(S)
  local D = { { det, zero, zero }, { zero, det, zero }, { zero, zero, det } }
  equal(matmul(vec.full(S), vec.full(adj)), D, "S adj(S) = det(S) 1")
  equal(matmul(vec.full(adj), vec.full(S)), D, "adj(S) S = det(S) 1")
  local F = vec.full(S)
  equal(det, dot(F[1], cross(F[2], F[3])), "det(S) is the triple product of the rows")
end
for i = 1, 3 do
  for j = 1, 3 do
    local n = vec.index[i][j]
    local pair = vec.pair[n]
    if not (pair[1] == math.min(i, j) and pair[2] == math.max(i, j)) then
      tap.ok(false, "index and pair agree at " .. i .. j)
    end
  end
end
tap.is(table.concat(vec.entry, " "), "xx yy zz xy xz yz", "the order of the six entries")

-- ---- matrices ----

equal(vec.matvec(A, add(a, b)), add(vec.matvec(A, a), vec.matvec(A, b)), "A (a + b) = A a + A b")
equal(vec.matvec(matmul(A, vec.full(S)), a), vec.matvec(A, vec.apply(S, a)), "(A S) a = A (S a)")
equal(vec.transpose(matmul(A, vec.full(S))), matmul(vec.full(S), vec.transpose(A)), "(A S)^T = S A^T")
equal(vec.congruence(A, vec.outer(a)), vec.outer(vec.matvec(A, a)), "A (a a^T) A^T = (A a)(A a)^T")
equal(vec.full(vec.congruence(A, S)), matmul(matmul(A, vec.full(S)), vec.transpose(A)),
  "the congruence A S A^T is symmetric, so six entries say it")
equal(vec.column(A, 2), symbols "a12 a22 a32", "the second column")

-- ---- quaternions ----

local function conjugate(x) return { x[1], -x[2], -x[3], -x[4] } end
local norm = q[1] ^ 2 + q[2] ^ 2 + q[3] ^ 2 + q[4] ^ 2
local function quaternion(v) return { zero, v[1], v[2], v[3] } end

equal(vec.qmul(vec.qmul(p, q), r), vec.qmul(p, vec.qmul(q, r)), "(p q) r = p (q r)")
equal(vec.qmul(q, conjugate(q)), { norm, zero, zero, zero }, "q q* = |q|^2")
equal(conjugate(vec.qmul(p, q)), vec.qmul(conjugate(q), conjugate(p)), "(p q)* = q* p*")
equal(vec.qmul({ zero, one, zero, zero }, { zero, zero, one, zero }), { zero, zero, zero, one }, "i j = k: Hamilton")
equal(vec.qmul({ zero, zero, one, zero }, { zero, one, zero, zero }), { zero, zero, zero, -one }, "j i = -k")
equal(quaternion(vec.matvec(vec.rotation(q), a)), vec.qmul(vec.qmul(q, quaternion(a)), conjugate(q)),
  "the rotation matrix times v is q v q*: body to inertial")
do
  local M = vec.rotation(q)
  local n2 = norm ^ 2
  local D = { { n2, zero, zero }, { zero, n2, zero }, { zero, zero, n2 } }
  equal(matmul(M, vec.transpose(M)), D, "R R^T = |q|^4 1: orthogonal for a unit quaternion")
  equal(matmul(vec.transpose(M), M), D, "R^T R = |q|^4 1")
  equal(dot(M[1], cross(M[2], M[3])), norm ^ 3, "det R = |q|^6: +1 for a unit quaternion, no reflection")
  equal(vec.rotation(vec.qmul(p, q)), matmul(vec.rotation(p), M), "R(p q) = R(p) R(q)")
  equal(vec.rotation(conjugate(q)), vec.transpose(M), "R(q*) = R(q)^T")
  equal(vec.rotation { -q[1], -q[2], -q[3], -q[4] }, M, "q and -q are one rotation")
end
do
  local h = expr.sqrt(expr.lift "1/2")
  equal(vec.matvec(vec.rotation { h, zero, zero, h }, { one, zero, zero }), { zero, one, zero },
    "a quarter turn about z takes x to y")
end

-- ---- rotation by an angle ----

do
  local t = expr.sym "t"
  local e = { zero, zero, one }
  local cos, sin = expr.call("cos", t), expr.call("sin", t)
  equal(vec.rodrigues(e, t), { { cos, -sin, zero }, { sin, cos, zero }, { zero, zero, one } },
    "the turn by t about z is the matrix of the textbooks")
  local n = { expr.lift "2/7", expr.lift "3/7", expr.lift "-6/7" } -- a unit vector: 4 + 9 + 36 = 49
  local M = vec.rodrigues(n, t)
  equal(matmul(M, vec.transpose(M)), identity, "the turn about any unit vector is orthogonal")
  equal(vec.matvec(M, n), n, "and keeps its axis")
  equal(vec.trace(vec.symmetric(M)), 1 + 2 * cos, "its trace is 1 + 2 cos t")
  equal(matmul(M, vec.rodrigues(n, -t)), identity, "the turn back undoes it")

  -- Against the quaternion cos(t/2) + n sin(t/2): half angles are beyond the zero test, so to 200 bits at points.
  local half = { expr.call("cos", t / 2), n[1] * expr.call("sin", t / 2), n[2] * expr.call("sin", t / 2),
    n[3] * expr.call("sin", t / 2) }
  local Q, good = vec.rotation(half), true
  for _, angle in ipairs { "1/3", "-2", "7/2", "100" } do
    local at = { t = R.parse(angle) }
    for i = 1, 3 do
      for j = 1, 3 do
        good = good and recipe.close(evaluate.precise(Q[i][j], at, 260), evaluate.precise(M[i][j], at, 260), 200)
      end
    end
  end
  tap.ok(good, "it is the rotation by the quaternion cos(t/2) + n sin(t/2)")
end

tap.done()
