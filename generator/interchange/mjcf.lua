-- mjcf.lua -- <inertial> of MuJoCo's format.
--
--     <body name="base"><inertial pos="0 0 0" mass="1" fullinertia="xx yy zz xy xz yz"/>
--     ... diaginertia="a b c" with at most one of quat, axisangle, xyaxes, zaxis, euler
-- The tensor is about the centre of mass pos.  Angles are in degrees unless <compiler angle="radian">; the
-- letters of eulerseq name the axes, small ones turn with the frame (MuJoCo's XML reference: body/inertial, compiler,
-- frame orientations).  <default> has nothing to say about <inertial>; <include> is not followed.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local diag = require "generator.diag"
local reader = require "generator.interchange.reader"
local turns = require "generator.interchange.turns"

local mjcf = { name = "MJCF", link = "body", model = "worldbody",
  reads = { inertial = { at = { "pos", "mass", "diaginertia", "fullinertia" } } }, -- and an orientation, below
  elsewhere = { inertia = "fullinertia= or diaginertia=", mass = "the attribute mass=", origin = "pos= and quat=",
    pose = "pos= and quat=", rpy = "euler=", xyz = "pos=" },
  inside = { "mass", "inertia", "origin", "pose" },
  without = "MuJoCo takes their geoms",
}

-- Every body, however deep: {name =, element =}.  Second result: whether the file includes others.
function mjcf.links(root)
  local list, includes = {}, false
  local function walk(element)
    for _, e in ipairs(element) do
      if e.name == "body" then list[#list + 1] = { name = e.at.name, element = e } end
      includes = includes or e.name == "include"
      walk(e)
    end
  end
  walk { root }
  return list, includes
end

-- What the compiler would do to the numbers of <inertial> beyond reading them.
local changes = { { "balanceinertia", "moments that break the triangle inequality" }, { "boundmass", "small masses" },
  { "boundinertia", "small moments" }, { "settotalmass", "all masses" } }

-- Options that say how to read; of several <compiler> the last word counts.
local function compiler(r, root)
  local at, where = {}, nil
  for _, e in ipairs(reader.children(root, "compiler")) do
    for _, name in ipairs(e.at) do at[name] = e.at[name] end
    r:mistyped(e, { "angle", "eulerseq" })
    where = e
  end
  local function must(name, default, ...)
    local given = at[name] or default
    for _, word in ipairs { ... } do
      if given == word then return given end
    end
    r:fail(where, "<compiler> " .. name .. " must be " .. table.concat({ ... }, " or "), diag.show(given))
    return default
  end
  local out = { degrees = must("angle", "degree", "degree", "radian") == "degree", sequence = at.eulerseq or "xyz" }
  if not string.find(out.sequence, "^[xyzXYZ][xyzXYZ][xyzXYZ]$") then
    r:fail(where, "<compiler> eulerseq must be three of x, y, z, X, Y, Z", diag.show(out.sequence))
    out.sequence = "xyz"
  end
  if at.coordinate == "global" then r:fail(where, "<compiler> coordinate=\"global\" is not supported any more") end
  if must("inertiafromgeom", "auto", "auto", "true", "false") == "true" then
    r:warn(where, "<compiler> inertiafromgeom=\"true\" makes MuJoCo use the geoms; read is what <inertial> says")
  end
  for _, c in ipairs(changes) do
    if at[c[1]] and not (at[c[1]] == "false" or at[c[1]] == "0" or at[c[1]] == "-1") then
      r:warn(where, "<compiler> " .. c[1] .. " lets MuJoCo change " .. c[2] .. "; read is what <inertial> says")
    end
  end
  return out
end

local function number(e) return R.todouble(evaluate.precise(e, {}, 64)) end

local forms = {
  { "quat", 4, function(v) return turns.quaternion(v) end },
  { "axisangle", 4, function(v, c) return turns.axisangle(v, c.degrees) end },
  { "euler", 3, function(v, c) return turns.euler(v, c.sequence, c.degrees) end },
  { "xyaxes", 6, function(v) return turns.xyaxes(v, number) end },
  { "zaxis", 3, function(v) return turns.zaxis(v) end },
}

local function orientation(r, inertial, options)
  local found = {}
  for _, f in ipairs(forms) do
    if inertial.at[f[1]] then found[#found + 1] = f end
  end
  if #found == 0 then return {} end
  if inertial.at.fullinertia then
    return r:fail(inertial, "<inertial> fullinertia and " .. found[1][1] .. " exclude each other")
  end
  if #found > 1 then
    return r:fail(inertial, "<inertial> " .. found[1][1] .. " and " .. found[2][1] .. " exclude each other")
  end
  local name, n, f = table.unpack(found[1])
  local v = r:attribute(inertial, name, n)
  if not v then return nil end
  if name == "euler" then r:angles(inertial, "<inertial> euler", v, options.degrees) end
  if name == "axisangle" then r:angles(inertial, "<inertial> axisangle", { v[4] }, options.degrees) end
  local list, rule = f(v, options)
  return list or r:fail(inertial, "<inertial> " .. name .. " " .. rule)
end

for _, f in ipairs(forms) do table.insert(mjcf.reads.inertial.at, f[1]) end

-- {mass =, com =, tensor =, words = of the tensor, turns =} of an <inertial>; what cannot be read is missing and has
-- been said.
function mjcf.read(r, inertial, root)
  local options = compiler(r, root)
  local mass = r:attribute(inertial, "mass", 1)
  local out = { com = r:attribute(inertial, "pos", 3), mass = mass and mass[1], mass_at = inertial,
    tensor_at = inertial, turns = orientation(r, inertial, options) }
  local full, diagonal = inertial.at.fullinertia, inertial.at.diaginertia
  if full and diagonal then
    r:fail(inertial, "<inertial> fullinertia and diaginertia exclude each other")
  elseif full then
    out.tensor = r:attribute(inertial, "fullinertia", 6)
    out.words = out.tensor and out.tensor.words
  elseif diagonal then
    local d = r:attribute(inertial, "diaginertia", 3)
    out.tensor = d and { d[1], d[2], d[3], R.zero, R.zero, R.zero }
    out.words = d and d.words
  else
    r:fail(inertial, "<inertial> diaginertia or fullinertia is missing")
  end
  return out
end

return mjcf
