-- document.lua -- the text of a robot file as a tree of elements; what is no such text is named, with the remedy.
--
-- Editors and file systems leave marks that are no part of the text: a byte order mark, blank lines before the XML
-- declaration, zero bytes at the end.  They are passed over; lines are counted as they are written.
-- SPDX-License-Identifier: GPL-3.0-or-later

local diag = require "generator.diag"

local document = {}

local read = "read are URDF, MJCF and SDF"

-- How files of other formats begin (patterns), and what to do with them.
local beginnings = {
  { "^version https://git%-lfs", "is a pointer of Git's large-file storage, not the file (git lfs pull fetches it)" },
  { "^#usda", "is a USD scene, which is not read; " .. read },
  { "^PXR%-USDC", "is a USD scene, which is not read; " .. read },
  { "^PK\3\4", "is a ZIP archive (also USDZ, 3MF, FMU); unpack it first" },
  { "^\31\139", "is compressed by gzip; unpack it first" },
  { "^glTF", "is a glTF scene, which has no inertials; " .. read },
  { "^ISO%-10303%-21", "is a STEP file, which is not read; " .. read },
  { "^solid%s", "is a mesh (STL): polhode mesh reads it" },
  { "^ply%s", "is a mesh (PLY): polhode mesh reads it" },
  { "^[{%[]", "is JSON, which is not read; " .. read },
  { "^%%YAML", "is YAML, which is not read; " .. read },
  { "^%-%-%-%s", "is YAML, which is not read; " .. read },
  { "^%%PDF", "is a PDF document; " .. read },
}

-- Roots of other formats in XML.
local roots = {
  COLLADA = "COLLADA, which is not read", OpenSimDocument = "an OpenSim model, which is not read",
  KinBody = "an OpenRAVE model, which is not read", Robot = "an OpenRAVE model, which is not read",
  Environment = "an OpenRAVE model, which is not read", VTKFile = "a VTK file, which is not read",
  html = "a web page: fetch the file itself", launch = "a launch file of ROS, which names the model's file",
  package = "a manifest of a ROS package", svg = "a picture", fmiModelDescription = "the description of an FMU",
  X3D = "an X3D scene, which is not read", amf = "a mesh (AMF), which is not read",
}

-- What is wrong with a root that no reader takes: a rule, and what was got.
function document.unknown(root)
  local known = roots[root.name]
  return "the root must be <robot> (URDF), <mujoco> (MJCF), <sdf> (SDF) or an <inertial> of one of them", "<" ..
    diag.cut(root.name, 40) .. ">" .. (known and ": it is " .. known or "")
end

-- xml: the host's parser.  The root element; or nil, what is wrong and in which line (nil: in no line).
function document.tree(xml, text)
  text = string.gsub(text, "^\239\187\191", "")
  local blank, rest = string.match(text, "^(%s*)(.*)$")
  for _, b in ipairs(beginnings) do
    if string.find(rest, b[1]) then return nil, b[2], nil end
  end
  -- nothing may stand before a declaration, but blanks may stand in it: so lines keep their numbers
  if blank ~= "" and string.sub(rest, 1, 5) == "<?xml" then text = "<?xml" .. blank .. string.sub(rest, 6) end
  if string.find(rest, "^[<]") then text = string.gsub(text, "[%s%z\26]+$", "\n") end
  local root, why, line = xml(text)
  if root or rest == "" then return root, why, line end
  if why == "junk after document element" then why = "text after the end of the root element" end
  if not string.find(rest, "^<") and not string.find(rest, "^[\254\255]") then why = "this is no XML; " .. read end
  return nil, why, line
end

return document
