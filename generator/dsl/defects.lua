-- defects.lua -- what is wrong with a mesh, in words: for the report of polhode mesh and the warnings of mesh{}.
-- SPDX-License-Identifier: GPL-3.0-or-later

local defects = {}

function defects.count(n, one, many) return n .. " " .. (n == 1 and one or many) end

-- Field of the host's `defects`, one of them, many of them.
defects.list = {
  { "open", "edge with one face only", "edges with one face only" },
  { "flipped", "edge between faces that look to opposite sides", "edges between faces that look to opposite sides" },
  { "nonmanifold", "edge of more than two faces", "edges of more than two faces" },
  { "duplicate", "triangle that repeats another", "triangles that repeat others" },
  { "degenerate", "face without area", "faces without area" },
  { "nonfinite", "face with a coordinate that is not finite", "faces with coordinates that are not finite" },
}

-- The phrases for what host.mesh found, in the order of the list.
function defects.phrases(found)
  local list = {}
  for _, p in ipairs(defects.list) do
    local n = found[p[1]]
    if n > 0 then list[#list + 1] = defects.count(n, p[2], p[3]) end
  end
  if found.inverted then list[#list + 1] = "inside out: the faces look inward; the volume was taken positive" end
  return list
end

return defects
