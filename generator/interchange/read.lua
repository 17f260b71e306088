-- read.lua -- from the XML of a robot to the mass properties of one of its links.
--
-- The format is told by the root: <robot> URDF, <mujoco> MJCF, <sdf> (<gazebo> until version 1.2) SDF; a fragment that
-- is an <inertial> by itself by what is in it.  Numbers are exact rationals (the decimals that are written), tensors
-- six entries {xx, yy, zz, xy, xz, yz} about the centre of mass.  What mass/law.lua says of a tensor is said here,
-- where its line is known.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local diag = require "generator.diag"
local digits = require "generator.mass.digits"
local law = require "generator.mass.law"
local document = require "generator.interchange.document"
local reader = require "generator.interchange.reader"
local urdf = require "generator.interchange.urdf"
local sdf = require "generator.interchange.sdf"
local mjcf = require "generator.interchange.mjcf"

local read = {}

local roots = { robot = urdf, mujoco = mjcf, mujocoinclude = mjcf, sdf = sdf, gazebo = sdf, world = sdf,
  model = sdf, body = mjcf }

-- The format of an <inertial> or <link> without the document around it, or nil.
local function fragment(root)
  local inertial = root.name == "link" and reader.children(root, "inertial")[1] or root
  if inertial.name ~= "inertial" then return nil end
  if inertial.at.mass or inertial.at.pos then return mjcf end
  for _, e in ipairs(inertial) do
    if e.name == "pose" or e.name == "mass" and not e.at.value or e.name == "inertia" and #e > 0 then return sdf end
    if e.name == "origin" or e.name == "mass" or e.name == "inertia" then return urdf end
  end
  return inertial.at.auto and sdf or nil
end

function read.format(root) return roots[root.name] or fragment(root) end

local function show(q) return diag.show(R.todouble(q)) end

-- The first element of Xacro, which nobody has expanded, or nil.
function read.macro(root)
  if string.find(root.name, "^xacro:") then return root end
  for _, e in ipairs(root) do
    local found = read.macro(e)
    if found then return found end
  end
end

local function expand(e) return "<" .. e.name .. "> is not expanded (run xacro first)" end

-- Warns of what stands where links do and may have been meant as one, and of macros.
function read.around(r, root, format)
  local macro = read.macro(root)
  if macro then r:warn(macro, expand(macro) .. "; links that it makes are not read") end
  if root.name ~= "inertial" and root.name ~= "link" then
    for _, name in ipairs { format.link, format.model } do r:misplaced(format, root, name) end
  end
end

-- The links that have an <inertial>, {name =, element =, inertial =}, and all links' names for a message.
function read.links(root, format)
  if root.name == "inertial" then return { { element = root, inertial = root } }, {} end
  local all, includes = format.links(root)
  local list, names_of = {}, {}
  for _, l in ipairs(all) do
    l.inertial = reader.children(l.element, "inertial")[1]
    if l.inertial then
      list[#list + 1] = l
      names_of[#names_of + 1] = l.name and diag.show(l.name) or "one without a name"
    end
  end
  return list, names_of, all, includes
end

-- The link asked for; nil after a complaint.
local function choose(r, root, format, wanted)
  local list, names_of, all, includes = read.links(root, format)
  local word = format.link
  local macro = read.macro(root)
  local more = (includes and "; files that it includes are not read" or "") .. (macro and "; line " .. macro.line ..
    ": " .. expand(macro) or "")
  if root.name == "inertial" then
    if wanted then return r:fail(root, "the file is one <inertial>, which has no name", diag.show(wanted)) end
    return list[1]
  end
  local some = #list == 0 and "there are none" or "there are " .. diag.cut(table.concat(names_of, ", "), 400)
  if not wanted then
    if #list == 1 then return list[1] end
    return r:fail(root, "link must name a <" .. word .. "> with <inertial> (" .. some .. more .. ")")
  end
  local found, bare = {}, nil
  local function collect(fits)
    for _, l in ipairs(list) do
      if l.name and fits(l.name) then found[#found + 1] = l end
    end
  end
  collect(function(name) return name == wanted end)
  if #found == 0 and format == sdf then -- its models may be left out while that is clear
    collect(function(name) return string.sub(name, -#wanted - 2) == "::" .. wanted end)
  end
  if #found == 1 then return found[1] end
  if #found > 1 then
    local others = {}
    for i, l in ipairs(found) do others[i] = diag.show(l.name) .. " in line " .. l.element.line end
    return r:fail(root, "more than one <" .. word .. "> has this name (" .. table.concat(others, ", ") .. ")",
      diag.show(wanted))
  end
  for _, l in ipairs(all) do bare = bare or l.name == wanted and l end
  if bare then return r:fail(bare.element, "<" .. word .. "> " .. diag.show(wanted) .. " has no <inertial>") end
  return r:fail(root, "no <" .. word .. "> with <inertial> has this name (" .. some .. more .. ")", diag.show(wanted))
end

local function zero(I)
  for _, q in ipairs(I) do
    if R.sign(q) ~= 0 then return false end
  end
  return true
end

-- What law.lua says of the numbers that were read, with the words of their entries.
local function judge(r, p)
  local list = {}
  for i = 1, 6 do list[i] = digits.of(p.words and p.words[i]) or false end
  local at, tag = p.tensor_at, "<" .. p.tensor_at.name .. "> "
  local zeros = { R.zero, R.zero, R.zero }
  local written = digits.written(list, 6)
  p.rod = law.rod(written, p.tensor)
  return law.judge({ I = p.rod or p.tensor, mass = p.mass or R.zero, com = p.com or zeros, about = "com",
    written = written }, function(rule, got) r:fail(at, tag .. rule, got) end,
    function(text) r:warn(at, tag .. text) end)
end

-- What one chosen link says, checked; nil after a complaint.  alone: no other part is added to it; then the second
-- result is why it is a body that never moves, if it is one.
function read.link(r, root, format, link, alone)
  r.owner = link.name and format.link .. " " .. diag.show(link.name) or nil
  local inertial = link.element == link.inertial and link.inertial or r:child(link.element, "inertial")
  if link.element ~= inertial then r:misplaced(format, link.element, "inertial") end
  r:unread(format, inertial)
  local p = format.read(r, inertial, root)
  if alone and p.mass and p.tensor and R.sign(p.mass) == 0 and zero(p.tensor) then
    return p, "no mass and no moments"
  end
  if p.mass and R.sign(p.mass) <= 0 then r:fail(p.mass_at, "mass must be positive", show(p.mass)) end
  if p.tensor and alone and zero(p.tensor) then
    r:fail(p.tensor_at, "<" .. p.tensor_at.name .. "> " .. law.nothing "the centre of mass")
  elseif p.tensor then
    p.judged = judge(r, p)
  end
  return not r.failed and p or nil
end

-- {mass =, com =, tensor =, turns =} of the link (nil: the only one) in the tree, or nil after a complaint.
function read.inertial(r, root, wanted)
  local format = read.format(root)
  if not format then
    return r:fail(root, document.unknown(root))
  end
  local link = choose(r, root, format, wanted)
  return link and read.link(r, root, format, link)
end

return read
