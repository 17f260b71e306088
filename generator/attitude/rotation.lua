-- rotation.lua -- what an attitude is in numbers: quaternion, rotation matrix, rotation vector, Euler angles.
--
-- q = {w, x, y, z} takes vectors of the body to space: v_space = q v_body q*.  Angles are in radians.
-- Euler angles of a sequence "abc" (letters x, y, z, neighbours different, so there are twelve): turn by the first
-- angle about the body's axis a, by the second about its axis b as it then stands, by the third about its axis c:
-- q = q_a(first) q_b(second) q_c(third).  First and third lie in (-pi, pi], the second in [0, pi] where the first and
-- last letter are equal, else in [-pi/2, pi/2].
-- At the ends of the second's range only a sum or difference of the two others is defined: there the third is 0.
-- Half sums and half differences of angles are arctangents of pairs of components, so no digit is lost near the ends
-- (Shepperd 1978; Bernardes and Viollet 2022).
-- SPDX-License-Identifier: GPL-3.0-or-later

local rotation = {}

rotation.sequences = { "xyx", "xzx", "yxy", "yzy", "zxz", "zyz", "xyz", "xzy", "yxz", "yzx", "zxy", "zyx" }

local place = { x = 2, y = 3, z = 4 }
local singular = 2.0 ^ -50 -- below this a length is rounding, and its direction says nothing

function rotation.product(p, q)
  return { p[1] * q[1] - p[2] * q[2] - p[3] * q[3] - p[4] * q[4],
    p[1] * q[2] + p[2] * q[1] + p[3] * q[4] - p[4] * q[3], p[1] * q[3] - p[2] * q[4] + p[3] * q[1] + p[4] * q[2],
    p[1] * q[4] + p[2] * q[3] - p[3] * q[2] + p[4] * q[1] }
end

function rotation.conjugate(q) return { q[1], -q[2], -q[3], -q[4] } end

-- A vector of the body in space.
function rotation.apply(q, v)
  local r = rotation.product(rotation.product(q, { 0.0, v[1], v[2], v[3] }), rotation.conjugate(q))
  return { r[2], r[3], r[4] }
end

-- A vector of space in the body.
function rotation.back(q, v) return rotation.apply(rotation.conjugate(q), v) end

-- The columns are the body's axes in space: {{R11, R12, R13}, {R21, ..}, ..}.
function rotation.matrix(q)
  local w, x, y, z = q[1], q[2], q[3], q[4]
  return { { w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y) },
    { 2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x) },
    { 2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z } }
end

-- Axis times angle, the angle in [0, pi].
function rotation.vector(q)
  local s, most = q[1] < 0 and -1.0 or 1.0, math.max(math.abs(q[2]), math.abs(q[3]), math.abs(q[4]))
  if most == 0 then return { 0.0, 0.0, 0.0 } end
  local length = most * math.sqrt((q[2] / most) ^ 2 + (q[3] / most) ^ 2 + (q[4] / most) ^ 2)
  local factor = s * 2 * math.atan(length, math.abs(q[1])) / length
  return { factor * q[2], factor * q[3], factor * q[4] }
end

local function wrapped(angle)
  if angle > math.pi then return angle - 2 * math.pi end
  if angle <= -math.pi then return angle + 2 * math.pi end
  return angle
end

-- The sign of the permutation of two axes and the third, and the third's place.
local function third(i, j)
  local k = 9 - i - j
  return (j - i) % 3 == 1 and 1 or -1, k
end

-- Angles of q_i(first) q_j(second) q_i(third), and whether first and third are not unique.
local function proper(q, i, j)
  local sign, k = third(i, j)
  local a, b, c, d = q[1], q[i], q[j], sign * q[k]
  local near, far = math.sqrt(a * a + b * b), math.sqrt(c * c + d * d)
  local second, sum, difference = 2 * math.atan(far, near), math.atan(b, a), math.atan(d, c)
  if far < singular then return wrapped(2 * sum), 0.0, 0.0, true end
  if near < singular then return wrapped(2 * difference), math.pi, 0.0, true end
  return wrapped(sum + difference), second, wrapped(sum - difference), false
end

local half = math.sqrt(0.5)

-- The three angles of a sequence, and true where the third is 0 by convention.
function rotation.euler(q, sequence)
  local i, j, k = place[string.sub(sequence, 1, 1)], place[string.sub(sequence, 2, 2)], place[string.sub(sequence, 3)]
  if i == k then
    local first, second, last, free = proper(q, i, j)
    return { first, second, last }, free
  end
  -- a quarter turn about j takes the third axis into the first, up to the sign
  local quarter = { half, 0.0, 0.0, 0.0 }
  quarter[j] = half
  local first, second, last, free = proper(rotation.product(q, quarter), i, j)
  return { first, second - math.pi / 2, free and 0.0 or -third(i, j) * last }, free
end

return rotation
