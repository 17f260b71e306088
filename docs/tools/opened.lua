-- opened.lua -- a surface without its quarter x > 0, y > 0: to look into a closed shell.
-- SPDX-License-Identifier: GPL-3.0-or-later

local opened = {}

-- The part of a polygon where side * coordinate d >= 0.
local function clip(face, d, side)
  local out = {}
  for i, p in ipairs(face) do
    local q = face[i % #face + 1]
    local u, v = side * p[d], side * q[d]
    if u >= 0 then out[#out + 1] = p end
    if u * v < 0 then
      local a, b = p, q
      if a[d] > b[d] then a, b = b, a end -- the same point from both faces at this edge
      local t, r = a[d] / (a[d] - b[d]), {}
      for k = 1, 3 do r[k] = a[k] + t * (b[k] - a[k]) end
      r[d] = 0
      out[#out + 1] = r
    end
  end
  return out
end

local function flat_in(face, d) -- nothing of it off the plane: clipping left an edge
  for _, p in ipairs(face) do
    if p[d] ~= 0 then return false end
  end
  return true
end

-- Faces are cut along both planes, so that neighbours still share their edges.
function opened.of(s)
  local out = { faces = {}, lines = s.lines, points = s.points, creases = s.creases }
  for _, face in ipairs(s.faces) do
    for _, side in ipairs { { 1, -1 }, { -1, 1 }, { -1, -1 } } do
      local part = clip(clip(face, 1, side[1]), 2, side[2])
      local degenerate = #part < 3
      for d = 1, 2 do degenerate = degenerate or flat_in(part, d) and not flat_in(face, d) end
      if not degenerate then
        part.flat = face.flat
        out.faces[#out.faces + 1] = part
      end
    end
  end
  return out
end

return opened
