-- sdf.lua -- <inertial> of the Simulation Description Format (1.2 to 1.12).
--
--     <link name="base"><inertial>
--       <mass>1</mass> <pose>x y z roll pitch yaw</pose> <inertia><ixx>1</ixx> ... </inertia>
-- The tensor is about the centre of mass, the origin of the inertial frame; products follow the convention -m x y, so
-- they are entries; the pose is relative to the link, its angles are turns about fixed axes (the format's own
-- description, sdformat's sdf/1.11/inertial.sdf).  What is left out has the format's default, mass 1 and unit moments,
-- which is hardly what anybody meant: a warning says so.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local diag = require "generator.diag"
local reader = require "generator.interchange.reader"
local turns = require "generator.interchange.turns"

local entries = { "ixx", "iyy", "izz", "ixy", "ixz", "iyz" }

local number = { text = true }
local sdf = { name = "SDF", link = "link", model = "model",
  reads = {
    inertial = { at = { "auto" }, has = { "mass", "pose", "inertia" } },
    mass = number,
    pose = { at = { "degrees", "rotation_format", "relative_to", "frame" }, text = true },
    inertia = { has = entries },
  },
  elsewhere = { origin = "<pose>", value = "the number between the tags", rpy = "<pose>", xyz = "<pose>" },
  inside = { "mass", "inertia", "origin" },
  without = "the format's default is 1 kg and unit moments",
}
for _, name in ipairs(entries) do sdf.reads[name] = number end

local zeros = { R.zero, R.zero, R.zero }
local holders = { sdf = true, gazebo = true, world = true, model = true } -- <gazebo>: the root until version 1.2

local function says(element, name, what)
  local e = reader.children(element, name)[1]
  return e and string.match(e.text, "^%s*(.-)%s*$") == what
end

-- Which links of a model a fixed joint holds to the world, by name.
local function held(model)
  local list = {}
  for _, joint in ipairs(reader.children(model, "joint")) do
    local child = reader.children(joint, "child")[1]
    if joint.at.type == "fixed" and child and says(joint, "parent", "world") then
      list[string.match(child.text, "^%s*(.-)%s*$")] = "fixed to the world"
    end
  end
  return list
end

-- Every link, with the names of the models around it ("arm::base"): {name =, element =, static = why nothing moves it,
-- or nil}.  Second result: whether the file includes others.
function sdf.links(root)
  local list, includes = {}, false
  local function walk(element, scope, static)
    local fixed = element.name == "model" and held(element) or {}
    if says(element, "static", "true") or says(element, "static", "1") then static = "its model is static" end
    for _, e in ipairs(element) do
      local name = e.at.name and scope .. e.at.name
      if e.name == "link" then
        list[#list + 1] = { name = name, element = e, static = static or fixed[e.at.name or false] }
      end
      includes = includes or e.name == "include"
      if holders[e.name] then walk(e, e.name == "model" and name and name .. "::" or scope, static) end
    end
  end
  walk({ root, text = "" }, "")
  return list, includes
end

-- Place and turns; nil in place of what cannot be read, which has been said.
local function pose(r, element)
  for _, name in ipairs { "relative_to", "frame" } do
    if (element.at[name] or "") ~= "" then
      r:warn(element, "<pose> " .. name .. " is ignored: the pose of <inertial> is relative to its link")
    end
  end
  local form = element.at.rotation_format or "euler_rpy"
  if form ~= "euler_rpy" and form ~= "quat_xyzw" then
    return r:fail(element, "<pose> rotation_format must be euler_rpy or quat_xyzw", diag.show(form))
  end
  if not string.find(element.text, "%S") then return zeros, {} end
  local quaternion = form == "quat_xyzw"
  local v = r:numbers(element, "<pose>", element.text, quaternion and 7 or 6)
  if not v then return nil end
  local com = { v[1], v[2], v[3] }
  if not quaternion then
    local degrees, rpy = reader.yes(element.at.degrees), { v[4], v[5], v[6] }
    r:angles(element, "<pose>", rpy, degrees)
    return com, turns.rpy(rpy, degrees)
  end
  local list, rule = turns.quaternion { v[7], v[4], v[5], v[6] }
  return com, list or r:fail(element, "<pose> quaternion " .. rule)
end

-- One number between tags, and its word.
local function scalar(r, element)
  local q = r:numbers(element, "<" .. element.name .. ">", element.text, 1)
  return q and q[1], q and q.words[1]
end

-- {mass =, com =, tensor =, words = of the tensor, turns =} of an <inertial>; what cannot be read is missing and has
-- been said.
function sdf.read(r, inertial)
  local out = { com = zeros, turns = {}, words = {} }
  if reader.yes(inertial.at.auto) then
    r:fail(inertial, "<inertial auto=\"true\"> leaves the numbers to the simulator; write them out")
    return out
  end
  local mass, frame, inertia = r:child(inertial, "mass"), r:child(inertial, "pose"), r:child(inertial, "inertia")
  if frame then out.com, out.turns = pose(r, frame) end
  if mass then
    out.mass, out.mass_at = scalar(r, mass), mass
  else
    r:warn(inertial, "<inertial> has no <mass>: the format's default is 1 kg")
    out.mass, out.mass_at = R.one, inertial
  end
  local I, lacking, broken = {}, {}, false
  for i, name in ipairs(entries) do
    local e = inertia and r:child(inertia, name)
    if e then
      I[i], out.words[i] = scalar(r, e)
      broken = broken or not I[i]
    else
      I[i] = i <= 3 and R.one or R.zero
      lacking[#lacking + 1] = name
    end
  end
  if not inertia then
    r:warn(inertial, "<inertial> has no <inertia>: the format's default is ixx = iyy = izz = 1 kg m^2")
  elseif #lacking > 0 then
    r:warn(inertia, "<inertia> has no " .. table.concat(lacking, ", ") .. ": the format's default is " ..
      "1 for moments, 0 for products")
  end
  out.tensor, out.tensor_at = not broken and I or nil, inertia or inertial
  return out
end

return sdf
