-- read.lua -- from the XML of a robot to the mass properties of one of its links.
--
-- The format is told by the root: <robot> URDF, <mujoco> MJCF, <sdf> SDF; a fragment that is an <inertial> by itself by
-- what is in it.  Numbers are exact rationals (the decimals that are written), tensors six entries {xx, yy, zz, xy, xz,
-- yz} about the centre of mass.  A tensor that no body can have is refused here, where its line is known.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"
local diag = require "generator.diag"
local reader = require "generator.interchange.reader"
local urdf = require "generator.interchange.urdf"
local sdf = require "generator.interchange.sdf"
local mjcf = require "generator.interchange.mjcf"

local read = {}

local roots = { robot = urdf, mujoco = mjcf, mujocoinclude = mjcf, sdf = sdf, world = sdf, model = sdf, body = mjcf }

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

-- Numbers of a file are rounded ones, so the conditions may fail by a few units of the last place of a double: a thin
-- plate's zz = xx + yy need not hold to the last bit.  Each of the six has at most one such unit, 2^-52 of the trace.
local slack = R.new(2) ^ -49

local function semidefinite(S, trace)
  for i = 1, 3 do
    if S[i] < -slack * trace then return false end
  end
  local adj, det = vec.adjugate(S)
  for i = 1, 3 do
    if adj[i] < -slack * trace * trace then return false end
  end
  return det >= -slack * trace * trace * trace
end

local names = { "xx", "yy", "zz" }

-- Can a body have this tensor about its centre of mass?  nil, or the rule that it breaks and with what.  Necessary and
-- sufficient: tr(I)/2 1 - I is positive semidefinite (Wensing, Kim, Slotine 2018, IEEE RA-L 3, 60).
function read.impossible(I)
  local trace = R.abs(I[1]) + R.abs(I[2]) + R.abs(I[3])
  for i = 1, 3 do
    if R.sign(I[i]) < 0 then return names[i] .. " must not be negative", show(I[i]) end
  end
  for i = 1, 3 do
    local j, k = i % 3 + 1, (i + 1) % 3 + 1
    if I[i] - I[j] - I[k] > slack * trace then
      return string.format("triangle inequality: %s <= %s + %s must hold", names[i], names[j], names[k]),
        string.format("%s > %s + %s", show(I[i]), show(I[j]), show(I[k]))
    end
  end
  if semidefinite(vec.second(I), trace) then return nil end
  local entries = {}
  for i, q in ipairs(I) do entries[i] = vec.entry[i] .. " " .. show(q) end
  local rule = semidefinite(I, trace) and "the triangle inequality of the principal moments must hold"
    or "the tensor must be positive semidefinite"
  return rule, table.concat(entries, ", ")
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
  local more = includes and "; files that it includes are not read" or ""
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

-- What one chosen link says, checked; nil after a complaint.
function read.link(r, root, format, link)
  r.owner = link.name and format.link .. " " .. diag.show(link.name) or nil
  local inertial = link.element == link.inertial and link.inertial or r:child(link.element, "inertial")
  local p = format.read(r, inertial, root)
  if p.mass and R.sign(p.mass) <= 0 then r:fail(p.mass_at, "mass must be positive", show(p.mass)) end
  if p.tensor then
    local rule, got = read.impossible(p.tensor)
    if rule then r:fail(p.tensor_at, "<" .. p.tensor_at.name .. "> " .. rule, got) end
  end
  return not r.failed and p or nil
end

-- {mass =, com =, tensor =, turns =} of the link (nil: the only one) in the tree, or nil after a complaint.
function read.inertial(r, root, wanted)
  local format = read.format(root)
  if not format then
    return r:fail(root, "the root must be <robot> (URDF), <mujoco> (MJCF), <sdf> (SDF) or an <inertial> of one of them",
      "<" .. diag.cut(root.name, 40) .. ">")
  end
  local link = choose(r, root, format, wanted)
  return link and read.link(r, root, format, link)
end

return read
