-- view.lua -- what is seen of a surface: parallel projection, faces in layers, edges, what hides a point.
--
-- Screen coordinates are {right, up, towards the viewer}, in pixels.  Two faces that overlap on the screen are put into
-- layers, the nearer one into a later layer: painted layer by layer the picture is right without splitting anything, as
-- long as faces do not pass through each other.  All faces of a convex body are in one layer.
-- Newell, Newell, Sancha 1972 (depth order by pairwise tests); Appel 1967 (visible parts of a line by sampling).
-- SPDX-License-Identifier: GPL-3.0-or-later

local view = {}

local sharp = math.cos(math.rad(32)) -- faces whose normals differ by more have an edge between them

-- The map of space to the screen, before scaling.  Directions of the eye in degrees: azimuth from x, height over z = 0.
function view.camera(azimuth, height)
  local a, e = math.rad(azimuth), math.rad(height)
  local ca, sa, ce, se = math.cos(a), math.sin(a), math.cos(e), math.sin(e)
  return function(p)
    return { -sa * p[1] + ca * p[2], -se * ca * p[1] - se * sa * p[2] + ce * p[3],
      ce * ca * p[1] + ce * sa * p[2] + se * p[3] }
  end
end

local function normal(f) -- Newell's: twice the area vector
  local n, o = { 0, 0, 0 }, f[1]
  for i = 2, #f - 1 do
    local a, b = f[i], f[i + 1]
    local ax, ay, az, bx, by, bz = a[1] - o[1], a[2] - o[2], a[3] - o[3], b[1] - o[1], b[2] - o[2], b[3] - o[3]
    n[1], n[2], n[3] = n[1] + ay * bz - az * by, n[2] + az * bx - ax * bz, n[3] + ax * by - ay * bx
  end
  local l = math.sqrt(n[1] ^ 2 + n[2] ^ 2 + n[3] ^ 2)
  if l == 0 then return nil end
  return { n[1] / l, n[2] / l, n[3] / l }, l / 2
end

local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end

-- The part of the convex polygon p (on the screen) inside the convex counter-clockwise polygon q.
local function overlap(p, q)
  for i = 1, #q do
    local a, b = q[i], q[i % #q + 1]
    local ex, ey, out = b[1] - a[1], b[2] - a[2], {}
    local before = p[#p]
    local d0 = before and ex * (before[2] - a[2]) - ey * (before[1] - a[1])
    for _, v in ipairs(p) do
      local d = ex * (v[2] - a[2]) - ey * (v[1] - a[1])
      if d0 * d < 0 then
        local t = d0 / (d0 - d)
        out[#out + 1] = { before[1] + t * (v[1] - before[1]), before[2] + t * (v[2] - before[2]) }
      end
      if d >= 0 then out[#out + 1] = v end
      before, d0 = v, d
    end
    p = out
    if #p < 3 then return nil end
  end
  local area, cx, cy = 0, 0, 0
  for i = 2, #p - 1 do
    local w = (p[i][1] - p[1][1]) * (p[i + 1][2] - p[1][2]) - (p[i][2] - p[1][2]) * (p[i + 1][1] - p[1][1])
    area, cx, cy = area + w, cx + w * (p[1][1] + p[i][1] + p[i + 1][1]) / 3,
      cy + w * (p[1][2] + p[i][2] + p[i + 1][2]) / 3
  end
  if area < 0.02 then return nil end
  return cx / area, cy / area
end

-- How near the plane of a face is to the viewer at the screen point (x, y).
local function depth(f, x, y)
  local n, o = f.n, f.seen[1]
  return o[3] - (n[1] * (x - o[1]) + n[2] * (y - o[2])) / n[3]
end

local function box(f)
  local x1, x2, y1, y2 = math.huge, -math.huge, math.huge, -math.huge
  for _, p in ipairs(f.seen) do
    x1, x2, y1, y2 = math.min(x1, p[1]), math.max(x2, p[1]), math.min(y1, p[2]), math.max(y2, p[2])
  end
  f.x1, f.x2, f.y1, f.y2 = x1, x2, y1, y2
end

-- Gives every face its layer.
local function layers(faces)
  table.sort(faces, function(a, b)
    if a.x1 ~= b.x1 then return a.x1 < b.x1 end
    return a.index < b.index
  end)
  local behind = {}
  for i, f in ipairs(faces) do behind[f] = {} f.rank = i end
  for i, f in ipairs(faces) do
    for j = i + 1, #faces do
      local g = faces[j]
      if g.x1 >= f.x2 then break end
      if g.y1 < f.y2 and f.y1 < g.y2 then
        local x, y = overlap(f.seen, g.seen)
        if x then
          local d = depth(f, x, y) - depth(g, x, y)
          if d > 0.01 then table.insert(behind[f], g) elseif d < -0.01 then table.insert(behind[g], f) end
        end
      end
    end
  end
  local function layer(f)
    if f.layer then return f.layer end
    f.layer = 1 -- stands while we are at it: a cycle ends here
    local most = 0
    for _, g in ipairs(behind[f]) do most = math.max(most, layer(g)) end
    f.layer = most + 1
    return f.layer
  end
  local top = 0
  for _, f in ipairs(faces) do top = math.max(top, layer(f)) end
  return top
end

-- The same point, to a thousandth of a pixel.
local function key(p)
  local function round(x) return math.floor(x * 1000 + 0.5) end
  return round(p[1]) .. " " .. round(p[2]) .. " " .. round(p[3])
end

-- Is the screen point behind one of the faces, by more than `least`?
local function covered(faces, p, least)
  for _, f in ipairs(faces) do
    if p[1] >= f.x1 and p[1] <= f.x2 and p[2] >= f.y1 and p[2] <= f.y2 then
      local within = true
      for k, a in ipairs(f.seen) do
        local b = f.seen[k % #f.seen + 1]
        if (b[1] - a[1]) * (p[2] - a[2]) - (b[2] - a[2]) * (p[1] - a[1]) < 0 then
          within = false
          break
        end
      end
      if within and depth(f, p[1], p[2]) > p[3] + least then return true end
    end
  end
  return false
end

function view.hidden(seen, p) return covered(seen.faces, p, 0.5) end

local function towards(p, q, t)
  return { p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2]), p[3] + t * (q[3] - p[3]) }
end

-- How many of the points (drawn in a little) and their middle are covered: 0 in full sight, 1 out of sight.
local function hidden_part(faces, points, least)
  local c, count = { 0, 0, 0 }, 0
  for _, p in ipairs(points) do c = { c[1] + p[1] / #points, c[2] + p[2] / #points, c[3] + p[3] / #points } end
  if covered(faces, c, least) then count = 1 end
  for _, p in ipairs(points) do
    if covered(faces, towards(p, c, 0.15), least) then count = count + 1 end
  end
  return count / (#points + 1)
end

-- The faces of s as {index, n, area, seen, front, painted, ..}: those to paint, the faces at each point and beside each
-- directed side; keys: point -> its text.
local function read(s, open)
  local G = { faces = {}, at = {}, sides = {} }
  local keys = setmetatable({}, { __index = function(t, p)
    local k = key(p)
    t[p] = k
    return k
  end })
  G.keys = keys
  for i, f in ipairs(s.faces) do
    local n, area = normal(f)
    if n then
      local g = { index = i, n = n, area = area, seen = f, cut = f.cut, front = n[3] > 1e-4 }
      g.painted = g.front or open and n[3] < -1e-4
      if g.painted and not g.front then
        g.seen, g.inside, g.n = {}, true, { -n[1], -n[2], -n[3] }
        for k, p in ipairs(f) do g.seen[#f + 1 - k] = p end
      end
      for k, p in ipairs(f) do
        local here, there = keys[p], keys[f[k % #f + 1]]
        G.at[here] = G.at[here] or {}
        table.insert(G.at[here], g)
        G.sides[here .. "|" .. there] = g
      end
      g.raw = f
      if g.painted then
        box(g)
        G.faces[#G.faces + 1] = g
      end
    end
  end
  return G
end

-- The normal that a face has at each of its corners: the mean, by area, over the faces that meet there without an edge.
local function round_corners(G, f)
  f.corner = {}
  for k, p in ipairs(f.seen) do
    local c = { 0, 0, 0 }
    for _, g in ipairs(G.at[G.keys[p]]) do
      local flip = g.inside == f.inside and g.painted and 1 or (g.inside and -1 or 1) * (f.inside and -1 or 1)
      local d = dot(f.n, g.n) * flip
      if d > sharp and g.cut == f.cut then
        for i = 1, 3 do c[i] = c[i] + flip * g.area * g.n[i] end
      end
    end
    local l = math.sqrt(dot(c, c))
    f.corner[k] = l > 0 and { c[1] / l, c[2] / l, c[3] / l } or f.n
  end
end

-- The edges to draw: outlines, where a face to paint has no other beyond, and folds and creases between two.
local function edges(G, s, layer_count)
  local keys, crease, list = G.keys, {}, {}
  for _, line in ipairs(s.creases) do
    for i = 2, #line do
      local a, b = keys[line[i - 1]], keys[line[i]]
      crease[a .. "|" .. b], crease[b .. "|" .. a] = true, true
    end
  end
  for _, f in ipairs(G.faces) do
    for k, p in ipairs(f.raw) do
      local q = f.raw[k % #f.raw + 1]
      local a, b = keys[p], keys[q]
      local g = G.sides[b .. "|" .. a]
      local other = g and g.painted and g or nil
      local fold = not other or (other.inside or false) ~= (f.inside or false)
      local line = fold or dot(f.n, g.n) < sharp or g.cut ~= f.cut or crease[a .. "|" .. b] and dot(f.n, g.n) < 0.9999
      if line and a ~= b and not (other and other.index < f.index) then -- of two faces the first draws it
        local part = hidden_part(G.faces, { p, q }, 0.05)
        local layer = math.max(f.layer or 1, other and other.layer or 1)
        if part == 0 then layer = layer_count end -- nothing covers it
        if part < 1 then list[#list + 1] = { p, q, layer = layer, outline = fold } end
      end
    end
  end
  return list
end

-- s: a surface in screen coordinates (see surface.tree); open: both sides of its faces can be seen.
-- Returns {faces = those to paint, each {seen = points counter-clockwise, n = unit normal towards the viewer, layer,
-- inside = true for the wrong side, corner = normals at the points}, edges = {{p, q, layer, outline =}}, layers}.
function view.of(s, open)
  local G, visible = read(s, open), {}
  for _, f in ipairs(G.faces) do
    if hidden_part(G.faces, f.seen, 0.5) < 1 then visible[#visible + 1] = f end
  end
  local out = { faces = visible, layers = layers(visible) }
  for _, f in ipairs(visible) do round_corners(G, f) end
  out.edges = edges(G, s, out.layers)
  return out
end

return view
