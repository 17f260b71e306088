-- meshes.lua -- meshes for tests: made, moved, spoiled, written in every format, and integrated by a sum of its own.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A mesh is {v = {{x, y, z}, ...}, f = {{i, j, k, ...}, ...}}, faces counter-clockwise seen from outside.  Coordinates
-- are multiples of 2^-12 below 2^8, so that a float holds them and every format says the same.

local meshes = {}

local function grid(x) return math.floor(x * 4096 + 0.5) / 4096 end

-- A box from lo to hi; quads: six faces in place of twelve triangles.
function meshes.box(lo, hi, quads)
  local v, f = {}, {}
  for k = 0, 7 do
    v[k + 1] = { k & 1 == 0 and lo[1] or hi[1], k & 2 == 0 and lo[2] or hi[2], k & 4 == 0 and lo[3] or hi[3] }
  end
  for _, q in ipairs { { 1, 3, 4, 2 }, { 5, 6, 8, 7 }, { 1, 2, 6, 5 }, { 3, 7, 8, 4 }, { 1, 5, 7, 3 }, { 2, 4, 8,
    6 } } do
    if quads then
      f[#f + 1] = q
    else
      f[#f + 1], f[#f + 2] = { q[1], q[2], q[3] }, { q[1], q[3], q[4] }
    end
  end
  return { v = v, f = f }
end

-- A ball of eight times 4^n triangles whose radius varies by a fifth: random() -> 0 .. 1; seen whole from its middle.
function meshes.boulder(n, r, at, random)
  local v = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } }
  local f = {}
  for _, s in ipairs { { 1, 3, 5 }, { 3, 2, 5 }, { 2, 4, 5 }, { 4, 1, 5 }, { 3, 1, 6 }, { 2, 3, 6 }, { 4, 2, 6 }, { 1,
    4, 6 } } do
    f[#f + 1] = s
  end
  for _ = 1, n do
    local middle, finer = {}, {}
    local function between(a, b)
      local key = math.min(a, b) .. " " .. math.max(a, b)
      if not middle[key] then
        local p = {}
        for i = 1, 3 do p[i] = v[a][i] + v[b][i] end
        v[#v + 1] = p
        middle[key] = #v
      end
      return middle[key]
    end
    for _, t in ipairs(f) do
      local a, b, c = between(t[1], t[2]), between(t[2], t[3]), between(t[3], t[1])
      for _, s in ipairs { { t[1], a, c }, { t[2], b, a }, { t[3], c, b }, { a, b, c } } do finer[#finer + 1] = s end
    end
    f = finer
  end
  for i, p in ipairs(v) do
    local k = r * (0.9 + 0.2 * random()) / math.sqrt(p[1] ^ 2 + p[2] ^ 2 + p[3] ^ 2)
    v[i] = { grid(at[1] + k * p[1]), grid(at[2] + k * p[2]), grid(at[3] + k * p[3]) }
  end
  return { v = v, f = f }
end

-- Every vertex through move; flip: faces from behind.
function meshes.map(m, move, flip)
  local out = { v = {}, f = {} }
  for i, p in ipairs(m.v) do out.v[i] = move(p) end
  for i, face in ipairs(m.f) do
    local g = {}
    for k, x in ipairs(face) do g[flip and #face + 1 - k or k] = x end
    out.f[i] = g
  end
  return out
end

function meshes.turned(m) return meshes.map(m, function(p) return p end, true) end

-- Both in one file.
function meshes.join(a, b)
  local out = meshes.map(a, function(p) return p end)
  for _, p in ipairs(b.v) do out.v[#out.v + 1] = p end
  for _, face in ipairs(b.f) do
    local g = {}
    for k, x in ipairs(face) do g[k] = x + #a.v end
    out.f[#out.f + 1] = g
  end
  return out
end

-- Every corner of every face its own vertex, off by up to e; at least the first corner is off by all of it.
function meshes.loose(m, e, random)
  local out = { v = {}, f = {} }
  for _, face in ipairs(m.f) do
    local g = {}
    for k, x in ipairs(face) do
      local p = {}
      for i = 1, 3 do p[i] = m.v[x][i] + e * (2 * random() - 1) end
      out.v[#out.v + 1] = p
      g[k] = #out.v
    end
    out.f[#out.f + 1] = g
  end
  return out
end

-- The volume by tetrahedra from the first vertex: coordinates are short, so sums are exact to some 1e-13.
function meshes.volume(m)
  local o, six = m.v[1], 0
  for _, face in ipairs(m.f) do
    for k = 2, #face - 1 do
      local c = {}
      for n, x in ipairs { face[1], face[k], face[k + 1] } do
        c[n] = { m.v[x][1] - o[1], m.v[x][2] - o[2], m.v[x][3] - o[3] }
      end
      local a, b, d = c[1], c[2], c[3]
      six = six + a[1] * (b[2] * d[3] - b[3] * d[2]) + a[2] * (b[3] * d[1] - b[1] * d[3]) +
        a[3] * (b[1] * d[2] - b[2] * d[1])
    end
  end
  return six / 6
end

-- ---- written ----

local function triangles(m, put)
  for _, face in ipairs(m.f) do
    for k = 2, #face - 1 do put(m.v[face[1]], m.v[face[k]], m.v[face[k + 1]]) end
  end
end

local function row(p) return string.format("%.17g %.17g %.17g", p[1], p[2], p[3]) end

meshes.formats = { "obj", "stl", "binary.stl", "ply", "binary.ply", "big.ply" }

local function stl(m)
  local out = { "solid test" }
  triangles(m, function(a, b, c)
    out[#out + 1] = "facet normal 0 0 0\nouter loop\nvertex " .. row(a) .. "\nvertex " .. row(b) .. "\nvertex " ..
      row(c) ..
      "\nendloop\nendfacet"
  end)
  return table.concat(out, "\n") .. "\nendsolid test\n"
end

local function binary_stl(m)
  local out, n = {}, 0
  triangles(m, function(a, b, c)
    n = n + 1
    out[n] = string.pack("<ffffffffffffI2", 0, 0, 0, a[1], a[2], a[3], b[1], b[2], b[3], c[1], c[2], c[3], 0)
  end)
  return string.rep(" ", 80) .. string.pack("<I4", n) .. table.concat(out)
end

local function obj(m)
  local out = {}
  for _, p in ipairs(m.v) do out[#out + 1] = "v " .. row(p) end
  for _, face in ipairs(m.f) do out[#out + 1] = "f " .. table.concat(face, " ") end
  return table.concat(out, "\n") .. "\n"
end

local function ply(m, how, order)
  local out = { "ply\nformat " .. how .. " 1.0\nelement vertex " .. #m.v ..
    "\nproperty double x\nproperty double y\n" ..
    "property double z\nelement face " .. #m.f .. "\nproperty list uchar int vertex_indices\nend_header\n" }
  for _, p in ipairs(m.v) do
    out[#out + 1] = order and string.pack(order .. "ddd", p[1], p[2], p[3]) or row(p) .. "\n"
  end
  for _, face in ipairs(m.f) do
    local list = {}
    for k, x in ipairs(face) do list[k] = order and string.pack(order .. "i4", x - 1) or x - 1 end
    out[#out + 1] = order and string.pack("B", #face) .. table.concat(list) or
      #face .. " " .. table.concat(list, " ") .. "\n"
  end
  return table.concat(out)
end

-- The bytes of a file of that format (as its name ends).
function meshes.text(m, format)
  if format == "obj" then return obj(m) end
  if format == "stl" then return stl(m) end
  if format == "binary.stl" then return binary_stl(m) end
  if format == "ply" then return ply(m, "ascii") end
  local big = format == "big.ply"
  return ply(m, big and "binary_big_endian" or "binary_little_endian", big and ">" or "<")
end

return meshes
