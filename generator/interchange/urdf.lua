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

local urdf = { name = "URDF", link = "link" }

local zeros = { R.zero, R.zero, R.zero }

-- Every link: {name =, element =}.
function urdf.links(root)
  local list = {}
  if root.name == "link" then return { { name = root.at.name, element = root } } end
  for _, e in ipairs(reader.children(root, "link")) do list[#list + 1] = { name = e.at.name, element = e } end
  return list
end

local function orientation(r, origin)
  local quaternion, rpy = origin.at.quat_xyzw, origin.at.rpy
  if quaternion and rpy then return r:fail(origin, "<origin> must have rpy or quat_xyzw, not both") end
  if not quaternion then
    rpy = r:attribute(origin, "rpy", 3, zeros)
    return rpy and turns.rpy(rpy)
  end
  local q = r:attribute(origin, "quat_xyzw", 4)
  if not q then return nil end
  local list, rule = turns.quaternion { q[4], q[1], q[2], q[3] }
  return list or r:fail(origin, "<origin> quat_xyzw " .. rule)
end

-- {mass =, com =, tensor =, turns =} of an <inertial>; what cannot be read is missing and has been said.
function urdf.read(r, inertial)
  local out = { com = zeros, turns = {} }
  local origin, mass, inertia = r:child(inertial, "origin"), r:child(inertial, "mass"), r:child(inertial, "inertia")
  if origin then
    r:unread(origin, { xyz = true, rpy = true, quat_xyzw = true })
    out.com, out.turns = r:attribute(origin, "xyz", 3, zeros), orientation(r, origin)
  end
  if mass then out.mass = r:attribute(mass, "value", 1) else r:fail(inertial, "<inertial> has no <mass>") end
  out.mass, out.mass_at = out.mass and out.mass[1], mass
  if not inertia then
    r:fail(inertial, "<inertial> has no <inertia>")
    return out
  end
  local I, known, whole = {}, {}, true
  for i, name in ipairs { "ixx", "iyy", "izz", "ixy", "ixz", "iyz" } do
    local q = r:attribute(inertia, name, 1)
    I[i], known[name], whole = q and q[1], true, whole and q ~= nil
  end
  r:unread(inertia, known)
  out.tensor, out.tensor_at = whole and I or nil, inertia
  return out
end

return urdf
