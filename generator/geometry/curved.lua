-- curved.lua -- surfaces made of patches (hoof, bicylinder, region) and curves (rods and wires), and loose points.
--
-- A patch is the image of a grid of squares under a map at(i, j); its normal is d/di x d/dj, which must point out of
-- the body, so maps are written with i and j in that order.  Two patches that meet must have the same points along
-- their common border: both maps give the same numbers there.  Squares that the map makes triangles lose a point, and
-- lines are left out.  Curves are chains of points on the true curve, n of them a turn.
-- SPDX-License-Identifier: GPL-3.0-or-later

local turned = require "generator.geometry.turned"

local curved = { family = {} }
local family = curved.family

-- Adds the grid at(i, j), 0 <= i <= m, 0 <= j <= n, with normals d/di x d/dj; what has collapsed to a line is left out.
local function grid(out, m, n, at, flat)
  local function same(p, q) return p[1] == q[1] and p[2] == q[2] and p[3] == q[3] end
  for i = 0, m - 1 do
    for j = 0, n - 1 do
      local face = { flat = flat }
      for _, p in ipairs { at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) } do
        if #face == 0 or not same(face[#face], p) then face[#face + 1] = p end
      end
      if #face > 1 and same(face[1], face[#face]) then face[#face] = nil end
      if #face > 2 then out.faces[#out.faces + 1] = face end
    end
  end
end

-- x >= 0, x^2 + y^2 <= r^2, 0 <= z <= h x/r: half a disc, half an ellipse over it, a wall between.
family["solid.hoof"] = function(out, a, n, o)
  local m = math.max(2, n // 2)
  local k = o.fine and math.max(1, math.ceil(a.r / o.fine)) or 1
  local function rim(j, s, up)
    local c, sn = turned.circle(-1 / 4 + j / (2 * m))
    return { a.r * s * c, a.r * s * sn, up * a.h * s * c }
  end
  grid(out, k, m, function(i, j) return rim(j, 1 - i / k, 0) end, true)
  grid(out, k, m, function(i, j) return rim(j, i / k, 1) end, true)
  grid(out, m, k, function(j, i) return rim(j, 1, i / k) end)
end

-- x^2 + z^2 <= r^2 and y^2 + z^2 <= r^2: squares of half side w over z = +-sqrt(r^2 - w^2).
family["solid.bicylinder"] = function(out, a, n, o)
  local m, k = math.max(4, n // 2), o.fine and math.max(1, math.ceil(2 * a.r / o.fine)) or 1
  for side = 0, 3 do
    local c, s = turned.circle(side / 4)
    local function at(i, j)
      local t = { turned.circle(-1 / 4 + i / (2 * m)) }
      local w, z = a.r * t[1], a.r * t[2]
      local v = w * (1 - 2 * j / k)
      return { w * c - v * s, w * s + v * c, z }
    end
    grid(out, m, k, at)
    local crease = {}
    for i = 0, m do crease[i + 1] = at(i, 0) end
    out.creases[#out.creases + 1] = crease
  end
end

-- A polynomial {{coefficient, i, j, k}, ...} at p.
local function value(terms, p)
  local s = 0.0
  for _, t in ipairs(terms) do
    local v = t[1]
    for d = 1, 3 do for _ = 1, t[d + 1] do v = v * p[d] end end
    s = s + v
  end
  return s
end

-- The image of the unit cube under the iterated limits: six patches.
family.region = function(out, a, n)
  local m = n // 2
  local o = a.order
  local function at(s)
    local p = { 0, 0, 0 }
    for level = 1, 3 do
      local lo, hi = value(a.limits[level][1], p), value(a.limits[level][2], p)
      p[o[level]] = s[level] == 1 and hi or lo + (hi - lo) * s[level]
    end
    return p
  end
  local even = (o[2] - o[1]) % 3 == 1 -- the coordinates in this order are right-handed
  for d = 1, 3 do
    local u, v = d % 3 + 1, (d + 1) % 3 + 1
    for side = 0, 1 do
      local swap = (side == 1) ~= even
      grid(out, m, m, function(i, j)
        local s = {}
        s[d] = side
        s[u], s[v] = (swap and j or i) / m, (swap and i or j) / m
        return at(s)
      end)
    end
    -- the four edges along d, which the limits may make sharp or smooth
    for corner = 0, 3 do
      local crease = {}
      for i = 0, m do
        local s = {}
        s[d], s[u], s[v] = i / m, corner % 2, corner // 2
        crease[i + 1] = at(s)
      end
      out.creases[#out.creases + 1] = crease
    end
  end
end

-- ---- curves ----

local function put(out, line) out.lines[#out.lines + 1] = line end

-- From p to q in pieces no longer than o.fine; the last point is q itself.
local function straight(out, p, q, o)
  local d = { q[1] - p[1], q[2] - p[2], q[3] - p[3] }
  local length = math.sqrt(d[1] ^ 2 + d[2] ^ 2 + d[3] ^ 2)
  local k, line = o.fine and math.max(1, math.ceil(length / o.fine)) or 1, {}
  for i = 0, k do
    line[i + 1] = i == k and q or { p[1] + d[1] * i / k, p[2] + d[2] * i / k, p[3] + d[3] * i / k }
  end
  put(out, line)
end

family["rod.straight"] = function(out, a, _, o)
  straight(out, { 0, 0, -a.length / 2 }, { 0, 0, a.length / 2 }, o)
end
family["rod.between"] = function(out, a, _, o) straight(out, a.from, a.to, o) end

local function curve(out, k, at)
  local line = {}
  for i = 0, k do line[i + 1] = at(i / k) end
  put(out, line)
end

-- n segments for a full turn; 1e-9: a product that should be whole may be a little above
local function arc(out, r, turns, n)
  curve(out, math.max(2, math.ceil(n * turns - 1e-9)), function(t)
    local c, s = turned.circle(turns * t)
    return { r * c, r * s, 0 }
  end)
end
family["wire.hoop"] = function(out, a, n) arc(out, a.r, 1, n) end
family["wire.arc"] = function(out, a, n) arc(out, a.r, a.angle / (2 * math.pi), n) end
family["wire.helix"] = function(out, a, n)
  curve(out, math.max(2, math.ceil(n * a.turns - 1e-9)), function(t)
    local c, s = turned.circle(a.turns * t)
    return { a.r * c, a.r * s, a.pitch * a.turns * t }
  end)
end
family["wire.catenary"] = function(out, a, n)
  curve(out, n, function(t)
    local x = a.span * (t - 1 / 2)
    return { x, a.a * (math.exp(x / a.a) + math.exp(-x / a.a)) / 2, 0 }
  end)
end
family["wire.polyline"] = function(out, a, _, o)
  local p = a.points
  for i = 1, #p - (a.closed and 0 or 1) do straight(out, p[i], p[i % #p + 1], o) end
end

-- ---- no surface ----

family.points = function(out, a)
  for i, row in ipairs(a.list) do out.points[i] = { row[2], row[3], row[4] } end
end
local function centre(out, a) out.points[1] = a.com or { 0, 0, 0 } end
family.tensor = centre

-- The triangles of a mesh; of a large one every k-th, which is enough for samples.  Wires are its edges.
local most = 4000
function family.mesh(out, a, _, o)
  if not a.faces then return centre(out, a) end
  local n = a.faces:count()
  for i = 1, n, (n - 1) // most + 1 do
    local c, face = a.faces:triangle(i), { flat = true }
    for k = 1, 3 do
      local p = {}
      for d = 1, 3 do p[d] = a.unit * (c[3 * k - 3 + d] - a.at[d]) end
      face[k] = p
    end
    if a.measure == "length" then
      straight(out, face[1], face[2], o)
    else
      out.faces[#out.faces + 1] = face
    end
  end
end

return curved
