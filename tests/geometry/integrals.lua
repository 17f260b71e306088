-- integrals.lua - measure and moments of faces and lines, for tests: sums over tetrahedra, triangles and segments.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each sum returns {measure, x, y, z, xx, yy, zz, xy, xz, yz}: integrals of 1, the coordinates and their products.
-- Over a simplex with vertices v_i (d of them):  int x_i x_j = measure/(d (d+1)) (sum v v^T + s s^T), s = sum v.

local integrals = {}

local function simplex(sum, measure, vertices)
  local d = #vertices
  local s = { 0, 0, 0 }
  for _, v in ipairs(vertices) do
    for i = 1, 3 do s[i] = s[i] + v[i] end
  end
  sum[1] = sum[1] + measure
  for i = 1, 3 do sum[1 + i] = sum[1 + i] + measure * s[i] / d end
  for k, ij in ipairs { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } } do
    local q = s[ij[1]] * s[ij[2]]
    for _, v in ipairs(vertices) do q = q + v[ij[1]] * v[ij[2]] end
    sum[4 + k] = sum[4 + k] + measure * q / (d * (d + 1))
  end
end

local function fresh() return { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 } end

local function minus(a, b) return { a[1] - b[1], a[2] - b[2], a[3] - b[3] } end
local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end
local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end

-- Of the body that closed faces enclose: every triangle with the origin is a tetrahedron (the divergence theorem).
function integrals.volume(faces)
  local sum, o = fresh(), { 0, 0, 0 }
  for _, f in ipairs(faces) do
    for i = 2, #f - 1 do simplex(sum, dot(f[1], cross(f[i], f[i + 1])) / 6, { o, f[1], f[i], f[i + 1] }) end
  end
  return sum
end

function integrals.area(faces)
  local sum = fresh()
  for _, f in ipairs(faces) do
    for i = 2, #f - 1 do
      local n = cross(minus(f[i], f[1]), minus(f[i + 1], f[1]))
      simplex(sum, math.sqrt(dot(n, n)) / 2, { f[1], f[i], f[i + 1] })
    end
  end
  return sum
end

function integrals.length(lines)
  local sum = fresh()
  for _, l in ipairs(lines) do
    for i = 2, #l do
      local d = minus(l[i], l[i - 1])
      simplex(sum, math.sqrt(dot(d, d)), { l[i - 1], l[i] })
    end
  end
  return sum
end

-- Integral of the outward normal times the vertex: a closed surface has sum zero; and edges that have no partner.
function integrals.open_edges(faces)
  local count, open = {}, 0
  local function key(p) -- 1e-9 apart is another point; adding zero makes -0 zero
    return string.format("%.9f,%.9f,%.9f", p[1] + 0, p[2] + 0, p[3] + 0):gsub("%-(0%.0+)%f[^%d]", "%1")
  end
  for _, f in ipairs(faces) do
    for i = 1, #f do
      local a, b = key(f[i]), key(f[i % #f + 1])
      count[a .. "|" .. b] = (count[a .. "|" .. b] or 0) + 1
    end
  end
  for edge, n in pairs(count) do
    local a, b = edge:match("^(.*)|(.*)$")
    if n ~= 1 or count[b .. "|" .. a] ~= 1 then open = open + 1 end
  end
  return open
end

return integrals
