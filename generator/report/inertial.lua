-- inertial.lua -- the mass properties of a scene as <inertial> of URDF, MJCF or SDF, for its default parameters.
--
-- The link's frame is the coordinate system of the scene's shape; the inertial frame is parallel to it, at the centre
-- of mass.  Every number is a double in the shortest digits that read back, so reading and writing again gives the same
-- bytes.  All three formats want tensor entries about the centre of mass (interchange/*.lua name the sources).
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"

local inertial = {}

local function words(v) return table.concat(v, " ") end

local writers = {}

function writers.urdf(p)
  return { "<inertial>", '  <origin xyz="' .. words(p.com) .. '" rpy="0 0 0"/>', '  <mass value="' .. p.mass .. '"/>',
    string.format('  <inertia ixx="%s" ixy="%s" ixz="%s" iyy="%s" iyz="%s" izz="%s"/>', p.I[1], p.I[4], p.I[5], p.I[2],
      p.I[6], p.I[3]), "</inertial>" }
end

function writers.mjcf(p)
  local tensor = p.diagonal and 'diaginertia="' .. words { p.I[1], p.I[2], p.I[3] } or 'fullinertia="' .. words(p.I)
  return { '<inertial pos="' .. words(p.com) .. '" mass="' .. p.mass .. '" ' .. tensor .. '"/>' }
end

function writers.sdf(p)
  local lines = { "<inertial>", "  <pose>" .. words(p.com) .. " 0 0 0</pose>", "  <mass>" .. p.mass .. "</mass>",
    "  <inertia>" }
  for _, e in ipairs { { "ixx", 1 }, { "ixy", 4 }, { "ixz", 5 }, { "iyy", 2 }, { "iyz", 6 }, { "izz", 3 } } do
    lines[#lines + 1] = "    <" .. e[1] .. ">" .. p.I[e[2]] .. "</" .. e[1] .. ">"
  end
  lines[#lines + 1] = "  </inertia>"
  lines[#lines + 1] = "</inertial>"
  return lines
end

-- The text of the job (driver.read) in the format "urdf", "mjcf" or "sdf".
function inertial.text(job, format)
  local m = job.model
  local function digits(e) return number.text(R.fromdouble(m:double(e)), "double") end
  local function all(v)
    local out = {}
    for i, e in ipairs(v) do out[i] = digits(e) end
    return out
  end
  local one = #m.body.pieces == 1 and m.body.pieces[1].typed -- of a rod that was straightened (mass/law.lua)
  local p = { mass = digits(m.mass), com = all(m.body.com), I = all(one or m.centroidal) }
  p.diagonal = p.I[4] == "0.0" and p.I[5] == "0.0" and p.I[6] == "0.0"
  local head = { '<!-- body "' .. m.name .. '" in kg, m, kg m^2.  The link\'s frame is the coordinate system of the ' ..
    "scene's shape;", "     the tensor is about the centre of mass; off-diagonals are its entries " ..
    "(ixy = - integral of x y dm)." }
  for i = 1, 3 do
    if p.I[i] == "0.0" then
      head[#head + 1] = "     A moment is zero (a rod): most simulators refuse that."
      break
    end
  end
  head[#head] = head[#head] .. " -->"
  return table.concat(head, "\n") .. "\n" .. table.concat(writers[format](p), "\n") .. "\n"
end

return inertial
