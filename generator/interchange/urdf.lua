-- urdf.lua -- <inertial> of the Unified Robot Description Format.
--
--     <link name="base"><inertial>
--       <origin xyz="0 0 0" rpy="0 0 0"/> <mass value="1"/> <inertia ixx= ixy= ixz= iyy= iyz= izz=/>
-- The tensor is about the centre of mass, which is the origin of the inertial frame; its off-diagonals are entries
-- (minus the integral of x y); rpy are turns about the link's fixed axes x, y, z, in this order
-- (wiki.ros.org/urdf/XML/link).  mass and all six attributes are required, as urdfdom's parser has them.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local reader = require "generator.interchange.reader"
local turns = require "generator.interchange.turns"

local entries = { "ixx", "iyy", "izz", "ixy", "ixz", "iyz" }

local urdf = { name = "URDF", link = "link",
  reads = {
    inertial = { has = { "origin", "mass", "inertia" } },
    origin = { at = { "xyz", "rpy", "quat_xyzw" } },
    mass = { at = { "value" } },
    inertia = { at = entries },
  },
  elsewhere = { pose = "<origin xyz= rpy=>", com = "<origin xyz=>" }, -- names of other formats
  inside = { "origin", "mass", "inertia", "pose" }, -- what a link itself does not have
  bare = true, -- links without <inertial> are static: simulators fix them or leave them out
}

local zeros = { R.zero, R.zero, R.zero }

-- The links that nothing can move: fixed joints lead from them to a link "world".
local function fixed(root)
  local parent = {}
  for _, joint in ipairs(reader.children(root, "joint")) do
    local above, below = reader.children(joint, "parent")[1], reader.children(joint, "child")[1]
    if joint.at.type == "fixed" and above and below and below.at.link then parent[below.at.link] = above.at.link end
  end
  return function(name)
    local steps = 0
    while name and name ~= "world" and steps < 1000 do -- a ring of joints has no end
      name, steps = parent[name], steps + 1
    end
    return name == "world" and 'fixed to "world"' or nil
  end
end

-- Every link: {name =, element =, static = why nothing moves it, or nil}.
function urdf.links(root)
  local list, why = {}, fixed(root)
  if root.name == "link" then return { { name = root.at.name, element = root } } end
  for _, e in ipairs(reader.children(root, "link")) do
    list[#list + 1] = { name = e.at.name, element = e, static = why(e.at.name) }
  end
  return list
end

local function orientation(r, origin)
  local quaternion, rpy = origin.at.quat_xyzw, origin.at.rpy
  if quaternion and rpy then return r:fail(origin, "<origin> must have rpy or quat_xyzw, not both") end
  if not quaternion then
    rpy = r:attribute(origin, "rpy", 3, zeros)
    if rpy then r:angles(origin, "<origin> rpy", rpy) end
    return rpy and turns.rpy(rpy)
  end
  local q = r:attribute(origin, "quat_xyzw", 4)
  if not q then return nil end
  local list, rule = turns.quaternion { q[4], q[1], q[2], q[3] }
  return list or r:fail(origin, "<origin> quat_xyzw " .. rule)
end

-- {mass =, com =, tensor =, words = of the tensor, turns =} of an <inertial>; what cannot be read is missing and has
-- been said.
function urdf.read(r, inertial)
  local out = { com = zeros, turns = {}, words = {} }
  local origin, mass, inertia = r:child(inertial, "origin"), r:child(inertial, "mass"), r:child(inertial, "inertia")
  if origin then out.com, out.turns = r:attribute(origin, "xyz", 3, zeros), orientation(r, origin) end
  if mass then out.mass = r:attribute(mass, "value", 1) else r:fail(inertial, "<inertial> has no <mass>") end
  out.mass, out.mass_at = out.mass and out.mass[1], mass
  if not inertia then
    r:fail(inertial, "<inertial> has no <inertia>")
    return out
  end
  local I, whole = {}, true
  for i, name in ipairs(entries) do
    local q = r:attribute(inertia, name, 1)
    I[i], out.words[i], whole = q and q[1], q and q.words[1], whole and q ~= nil
  end
  out.tensor, out.tensor_at = whole and I or nil, inertia
  return out
end

return urdf
