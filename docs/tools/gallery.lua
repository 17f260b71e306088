-- gallery.lua -- docs/gallery.md and a picture for each scene of bodies/: `make gallery`.
--
--     lua5.4 docs/tools/gallery.lua PROGRAM DIR     DIR: where gallery.md and gallery/ are written
-- A scene is shown by the pictures that tell most of it, as long as it is readable.  What drifts by rounding alone is
-- not shown: it differs from machine to machine.
-- SPDX-License-Identifier: GPL-3.0-or-later

local gallery = {}

-- scene, what is drawn, until (s; nil: the scene's horizon)
gallery.list = {
  { "tennis_racket", "polhode,herpolhode" },
  { "flipping_box", "polhode,herpolhode", 20 },
  { "tumbling_box", "polhode,herpolhode", 12 },
  { "brick", "polhode,herpolhode" },
  { "brick_centroid", "polhode,herpolhode", 6 },
  { "bracket", "polhode,herpolhode" },
  { "book", "polhode,herpolhode" },
  { "paddle", "axes,energy" },
  { "nasa_brick", "polhode,herpolhode", 15 },
  { "water", "polhode,herpolhode", 1e-12 },
  { "symmetric_top", "cones,herpolhode", 5 },
  { "coin", "cones,axes", 1 },
  { "cube_corner", "cones,herpolhode" },
  { "earth", "polhode,herpolhode", 500000 },
  { "dumbbell", "axes,euler", 4 },
  { "heavy_top", "axes,energy" },
  { "nodding_top", "axes,euler", 5 },
  { "gyroscope", "rates", 0.2 },
  { "kapitza", "axes,energy", 1.5 },
  { "torsion_pendulum", "axes,euler" },
  { "magnet_pendulum", "axes,energy" },
  { "spun_up_top", "rates", 3 },
  { "spun_coin", "axes,energy" },
  { "skater", "rates" },
  { "thruster", "rates" },
  { "damped_brick", "axes,energy" },
  { "eddy_damper", "axes,energy" },
  { "energy_sink", "phase,energy", 3 },
  { "gyrostat", "phase,axes", 120 },
  { "dual_spin", "phase,axes", 100 },
  { "wheels", "axes,euler" },
  { "attitude_control", "axes,euler" },
  { "compass", "axes,energy", 600 },
  { "gravity_gradient", "axes,euler" },
  { "solar_sail", "axes,euler" },
  { "nasa_brick_damped", "path" },
  { "thrown_book", "path" },
  { "dropped_stone", "path" },
  { "foucault", "path" },
  { "rolling_coin", "contact,normal_force" },
  { "turntable_ball", "contact,normal_force" },
  { "eulers_disk", "axes,normal_force" },
  { "chaplygin_ball", "contact,axes", 3 },
  { "rattleback", "rates,contact" },
  { "tippe_top", "axes,contact" },
  { "egg", "axes,energy", 2 },
}

local head = [[
# Gallery

This page has a picture of each installed scene, as `polhode plot` draws it. The command is below the picture.
`polhode help plot` lists the other pictures. The pictures follow the colours of the screen, light or dark. Prints are
light. `make gallery` draws all pictures again, and the same scene gives the same bytes.

The **polhode** is the closed curve that the angular velocity draws on the ellipsoid of energy. The picture has
neighbouring polhodes, too. The dashed line is the separatrix, and thin lines are at the back. The **herpolhode** is
the curve of the same vector in the plane perpendicular to L, between two circles that theory gives. The body **cone**
of a symmetric top rolls on its space cone. The **phase portrait** has L in the body on its sphere, with lines of
equal energy. The orange dot is the start.
]]

-- The words of the scene's first comment, up to the first line that is none; but for the licence.
local function about(file)
  local words = {}
  for line in io.lines(file) do
    local text = string.match(line, "^%-%-%s*(.*)$")
    if not text then break end
    if not string.find(text, "^SPDX") then words[#words + 1] = text end
  end
  return table.concat(words, " ")
end

function gallery.command(row)
  return row[1] .. " --what " .. row[2] .. (row[3] and " --until " .. string.format("%.14g", row[3]) or "")
end

-- The page: the scenes' comments and the pictures.
function gallery.page()
  local out = { head }
  for _, row in ipairs(gallery.list) do
    out[#out + 1] = "## " .. row[1] .. "\n\n" .. about("bodies/" .. row[1] .. ".lua") .. "\n\n![" ..
      row[1] .. ": " .. string.gsub(row[2], ",", ", ") .. "](gallery/" .. row[1] .. ".svg)\n\n    polhode plot " ..
      gallery.command(row) .. "\n"
  end
  return table.concat(out, "\n")
end

-- Draws one picture into a file; the exit status.
function gallery.draw(program, row, file)
  local what = gallery.command { "bodies/" .. row[1] .. ".lua", row[2], row[3] }
  return os.execute(program .. " plot " .. what .. " -o " .. file)
end

if arg and arg[0] and string.find(arg[0], "gallery%.lua$") then
  local program, dir = arg[1], arg[2]
  os.execute("mkdir -p " .. dir .. "/gallery")
  for _, row in ipairs(gallery.list) do
    assert(gallery.draw(program, row, dir .. "/gallery/" .. row[1] .. ".svg"), row[1] .. " is not drawn")
  end
  local f = assert(io.open(dir .. "/gallery.md", "w"))
  f:write(gallery.page())
  f:close()
end

return gallery
