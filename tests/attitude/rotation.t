#!/usr/bin/env lua5.4
-- rotation.t - the twelve sequences of Euler angles, matrix and rotation vector against products of matrices.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The oracle multiplies the matrices of turns about coordinate axes, as every textbook has them; the code under test
-- goes by quaternions.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local rotation = require "generator.attitude.rotation"

local why = "a product of three matrices of sines has errors of a few 1e-16; angles near the ends of the second's " ..
  "range come from lengths of 1e-3, whose arctangent keeps the error absolute"
local bound = 4e-15

-- The matrix of a turn by angle about a coordinate axis.
local function turn(axis, angle)
  local i = ({ x = 1, y = 2, z = 3 })[axis]
  local j, k = i % 3 + 1, (i + 1) % 3 + 1
  local m = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } }
  m[i][i], m[j][j], m[k][k] = 1, math.cos(angle), math.cos(angle)
  m[j][k], m[k][j] = -math.sin(angle), math.sin(angle)
  return m
end

local function product(a, b)
  local m = {}
  for i = 1, 3 do
    m[i] = {}
    for j = 1, 3 do m[i][j] = a[i][1] * b[1][j] + a[i][2] * b[2][j] + a[i][3] * b[3][j] end
  end
  return m
end

local function of_angles(sequence, a)
  local m = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }
  for n = 1, 3 do m = product(m, turn(sequence:sub(n, n), a[n])) end
  return m
end

local function distance(a, b)
  local most = 0.0
  for i = 1, 3 do
    for j = 1, 3 do most = math.max(most, math.abs(a[i][j] - b[i][j])) end
  end
  return most
end

local seed = 12345
local function random() -- the same on every machine
  seed = (seed * 1103515245 + 12345) % 2147483648
  return seed / 2147483648
end

local function random_unit()
  local q, s
  repeat
    q, s = {}, 0
    for i = 1, 4 do
      q[i] = 2 * random() - 1
      s = s + q[i] ^ 2
    end
  until s <= 1 and s > 0.01
  for i = 1, 4 do q[i] = q[i] / math.sqrt(s) end
  return q
end

local letters = {}
for _, sequence in ipairs(rotation.sequences) do letters[sequence] = true end
do
  local all = 0
  for _, a in ipairs { "x", "y", "z" } do
    for _, b in ipairs { "x", "y", "z" } do
      for _, c in ipairs { "x", "y", "z" } do
        if a ~= b and b ~= c then
          all = all + 1
          tap.ok(letters[a .. b .. c], "there is the sequence " .. a .. b .. c)
        end
      end
    end
  end
  tap.is(#rotation.sequences, all, "and there is no other")
end

for _, sequence in ipairs(rotation.sequences) do
  local same = sequence:sub(1, 1) == sequence:sub(3, 3)
  local worst, inside = 0.0, true
  for _ = 1, 200 do
    local q = random_unit()
    local a, free = rotation.euler(q, sequence)
    worst = math.max(worst, distance(of_angles(sequence, a), rotation.matrix(q)))
    local low, high = same and 0 or -math.pi / 2, same and math.pi or math.pi / 2
    inside = inside and not free and a[2] >= low and a[2] <= high and math.abs(a[1]) <= math.pi
      and math.abs(a[3]) <= math.pi
  end
  tap.near(worst, 0, 0, bound, sequence .. ": the angles of 200 attitudes make their matrices", why)
  tap.ok(inside, sequence .. ": they are within their ranges, and none is called singular")

  -- and back: angles inside the ranges return
  worst = 0.0
  for _ = 1, 50 do
    local a = { (2 * random() - 1) * 3, (same and 0.1 or -1.4) + 2.8 * random(), (2 * random() - 1) * 3 }
    local q = { 1, 0, 0, 0 }
    for n = 1, 3 do
      local p = { math.cos(a[n] / 2), 0, 0, 0 }
      p[({ x = 2, y = 3, z = 4 })[sequence:sub(n, n)]] = math.sin(a[n] / 2)
      q = rotation.product(q, p)
    end
    local b = rotation.euler(q, sequence)
    for n = 1, 3 do worst = math.max(worst, math.abs(a[n] - b[n])) end
  end
  tap.near(worst, 0, 0, 1e-13, sequence .. ": angles become a quaternion and these angles again",
    "angles are conditioned by 1/sin of the distance to the ends, at least 0.1")

  -- the two singular poses: only a sum or difference of the outer angles is defined; the third is 0
  for _, second in ipairs(same and { 0, math.pi } or { -math.pi / 2, math.pi / 2 }) do
    local q = { 1, 0, 0, 0 }
    for n, angle in ipairs { 0.7, second, 0.4 } do
      local p = { math.cos(angle / 2), 0, 0, 0 }
      p[({ x = 2, y = 3, z = 4 })[sequence:sub(n, n)]] = math.sin(angle / 2)
      q = rotation.product(q, p)
    end
    local a, free = rotation.euler(q, sequence)
    tap.ok(free and a[3] == 0.0, sequence .. ": at a second angle of " .. second .. " the third is 0")
    tap.near(distance(of_angles(sequence, a), rotation.matrix(q)), 0, 0, bound,
      sequence .. ": and the angles make the matrix", why)
  end
end

-- 90 degrees about z, by hand: x goes to y, y to -x
do
  local h = math.sqrt(0.5)
  local q = { h, 0, 0, h }
  tap.near(distance(rotation.matrix(q), { { 0, -1, 0 }, { 1, 0, 0 }, { 0, 0, 1 } }), 0, 0, 1e-15, "a quarter about z",
    "two roundings")
  local v = rotation.vector(q)
  tap.near(v[3], math.pi / 2, 1e-15, 0, "its rotation vector", "an arctangent")
  tap.is(v[1], 0.0, "has no other component")
  v = rotation.vector { -h, 0, 0, -h }
  tap.near(v[3], math.pi / 2, 1e-15, 0, "-q is the same rotation", "an arctangent")
  v = rotation.vector { 0, 0, 1, 0 }
  tap.near(v[2], math.pi, 1e-15, 0, "half a turn about y", "an arctangent")
  v = rotation.vector { 1, 1e-200, 0, 0 }
  tap.near(v[1], 2e-200, 1e-15, 0, "tiny turns keep their digits", "sin x = x")
  tap.is(rotation.vector({ 1.0, 0.0, 0.0, 0.0 })[1], 0.0, "none has length 0")
  v = rotation.apply(q, { 1, 0, 0 })
  tap.near(v[2], 1, 1e-15, 0, "apply takes x to y", "two roundings")
  v = rotation.back(q, { 0, 1, 0 })
  tap.near(v[1], 1, 1e-15, 0, "back takes y to x", "two roundings")
end

tap.done()
