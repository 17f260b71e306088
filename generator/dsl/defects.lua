-- defects.lua -- what is wrong with a mesh, in words: for the report of polhode mesh and the warnings of mesh{}.
-- SPDX-License-Identifier: GPL-3.0-or-later

local diag = require "generator.diag"

local defects = {}

function defects.count(n, one, many) return n .. " " .. (n == 1 and one or many) end

-- Faces that are not flat by the digits of a file only: a share of the whole that nobody weighs.
local least_bend = 1e-6

-- Field of the host's `defects`, one of them, many of them.
defects.list = {
  { "open", "edge with one face only", "edges with one face only" },
  { "flipped", "edge between faces that look to opposite sides", "edges between faces that look to opposite sides" },
  { "nonmanifold", "edge of more than two faces", "edges of more than two faces" },
  { "duplicate", "triangle that repeats another", "triangles that repeat others" },
  { "degenerate", "face without area", "faces without area" },
  { "nonfinite", "face with a coordinate that is not finite", "faces with coordinates that are not finite" },
}

local rough = diag.rough

local function place(p) return "(" .. rough(p[1]) .. ", " .. rough(p[2]) .. ", " .. rough(p[3]) .. ")" end

local function triangles(f) return defects.count(f.triangles, "triangle", "triangles") end

-- A part that lies wrong; f: {kind, part, other, triangles, at, share}, places in the file's unit.
local words = {
  inward = function(f)
    return "part " .. f.part .. " (" .. triangles(f) .. " around " .. place(f.at) ..
      ") is inside out: it was turned, and its volume taken positive"
  end,
  outward = function(f)
    return "part " .. f.part .. " (" .. triangles(f) .. " around " .. place(f.at) .. ") lies inside part " .. f.other ..
      " and looks outward as well: it was turned, and is a cavity"
  end,
  solid = function(f)
    return "part " .. f.part .. " (" .. triangles(f) .. " around " .. place(f.at) .. ") lies in a cavity of part " ..
      f.other .. " and looks inward as well: it was turned, and is matter"
  end,
  overlap = function(f)
    return "parts " .. f.part .. " and " .. f.other .. " overlap at " .. place(f.at) ..
      ": what both hold, a volume of some " .. rough(f.share) .. ", counts twice"
  end,
}

-- How to close an open mesh, or nil; m: what host.mesh found; show: writes the option that welds.
function defects.offer(m, show)
  if m.defects.unbalanced == 0 or m.weld == 0 or m.merged > 0 then return nil end
  return "vertices up to " .. rough(m.gap) .. " apart are taken for different ones; " ..
    show((string.gsub(rough(m.weld), "e%-0", "e-"))) ..
    " joins them and closes it"
end

-- The phrases for what host.mesh found, in the order of the list.
function defects.phrases(m)
  local found, list = m.defects, {}
  for _, p in ipairs(defects.list) do
    local n = found[p[1]]
    if n > 0 then list[#list + 1] = defects.count(n, p[2], p[3]) end
  end
  if found.inverted then list[#list + 1] = "inside out: the faces look inward; the volume was taken positive" end
  for _, f in ipairs(found.faults) do list[#list + 1] = words[f.kind](f) end
  if found.faults.count > #found.faults then
    list[#list + 1] = (found.faults.count - #found.faults) .. " more parts or pairs of parts that lie wrong"
  end
  if found.unseen then list[#list + 1] = "so many parts that not all pairs of them were looked at" end
  if found.bend > least_bend then
    list[#list + 1] = defects.count(found.bent, "face that is not flat", "faces that are not flat") ..
      ": other diagonals would change the whole by up to " .. rough(100 * found.bend) .. " %"
  end
  if m.merged > 0 then
    list[#list + 1] = "welded as asked: " .. defects.count(m.merged, "vertex was", "vertices were") ..
      " joined to others up to " .. rough(m.gap) .. " away"
  end
  return list
end

return defects
