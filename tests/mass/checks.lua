-- checks.lua - what must hold of a body, as a table: each check with the doors that ask it, and scenes that break it.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A check is {about = words for the table of docs/mass.md, file = do links and inertial{} ask it? mesh = does polhode
-- mesh? code = does NAME_init? (true, "-" for what no parameter changes, or words), by = the test of those doors}.
-- A row is {check, scene, parameter, a bad value, what all doors say of it}; defaults of all scenes are lawful.

local checks = {}

checks.list = {
  { "argument", about = "masses, densities, sizes and factors of scaling positive; r_in < r_out and the like",
    code = true },
  { "axis", about = "an axis of a turn, a quaternion not zero; a matrix a rotation", code = true },
  { "area", about = "a profile encloses an area, and is not left of its axis", code = true },
  { "simple", about = "a profile does not cross itself; its holes are inside it and apart",
    code = "if it stays convex" },
  { "total", about = "the total mass positive", file = true, code = true },
  { "entries", about = "moments of inertia not negative", file = true, code = true,
    by = "tests/interchange/doors.t" },
  { "triangle", about = "the second moments positive semidefinite (triangle inequality)", file = true, code = true,
    by = "tests/interchange/doors.t" },
  { "definite", about = "with `physical = false`, the principal moments positive", code = true,
    by = "tests/mass/formal.t" },
  { "wheel", about = "the tensor without the wheels in it positive", code = true, by = "tests/dynamics" },
  { "range", about = "mass and moments within the range of double", code = "as finite constants" },
  { "inside", about = "a hole inside its body, and holes apart", code = "where there is a formula" },
  { "denser", about = "a hole not denser than its body", code = "where there is a formula" },
  { "kind", about = "a hole of its body's kind (volume, area, length, particles)", code = "-",
    by = "tests/mass/holes.t" },
  { "closed", about = "a mesh closed, its parts apart and right side out", mesh = true, code = "-",
    by = "tests/mass/mesh_defects.t" },
  { "likely", about = "units, sizes and densities likely; parts that are joined apart (warnings)",
    file = "units", mesh = "units", code = "no", by = "tests/interchange/doors.t, tests/dsl/warnings.t" },
}

-- A body of these parameters, with what design and sweep ask for beside it.
local function scene(name, params, body)
  return params .. '\nlocal g = param("g", 0.1, "1/s")\nreturn scene { name = "' .. name .. '", body = ' .. body .. [[,
  effects = { effect.damping { rate = g } }, initial = { omega = { 0.1, 1, 0.2 } },
  time = { horizon = 0.01, step = 0.001 }, measure = { w = { wx, wy, wz }, sigma = 0.01 } }
]]
end

checks.scenes = {
  parts = scene("parts", [[
local a, m, d = param("a", 1, "m"), param("m", 1, "kg"), param("d", 1000, "kg/m^3")
local q, k, e, n = param("q", 0.1, "m"), param("k", 1), param("e", 0.2, "m"), param("n", 1)
]], [[solid.box { x = a, y = 1, z = 1, mass = m } +
  (solid.tube { r_in = q, r_out = 0.3, h = 0.2, density = d }:scaled { k }:at { 0, 3, 0 }) +
  (extrude { profile = { {-e, 0}, {e, 0}, {0, 1} }, h = 0.1, density = 1000 }:at { 0, 6, 0 }) +
  (solid.sphere { r = 0.3, density = 1000 }:turned { axis = { 0, 0, n }, angle = 0.3 }:at { 0, 9, 0 })]]),
  hole = scene("hole", 'local r, x, d = param("r", 0.2, "m"), param("x", 0.2, "m"), param("d", 1000, "kg/m^3")\n', [[
  solid.box { x = 1, y = 1, z = 1, density = 1000 } - solid.cylinder { r = 0.1, h = 0.5, density = 1000 } -
  solid.cylinder { r = r/2, h = r, density = d }:at { x + 0.1, 0, 0 }]]),
  apart = scene("apart", 'local r = param("r", 0.2, "m")\n', [[
  solid.box { x = 1, y = 1, z = 1, density = 1000 } + solid.box { x = 1, y = 1, z = 1, density = 1000 }:at { 0, 3, 0 } -
  solid.cylinder { r = r, h = 0.5, density = 1000 } ]]),
  outline = scene("outline", 'local v = param("v", 0.5, "m")\n', [[
  extrude { profile = { {0, 0}, {1, 0}, {1, 1}, {v, 0.5}, {0, 1} }, h = 0.1, density = 1000 } ]]),
  total = scene("total", 'local c = param("c", 1, "kg")\n', [[
  solid.box { x = 1, y = 1, z = 1, mass = 5 } - solid.sphere { r = 0.4, mass = c } ]]),
  tensor = scene("tensor", 'local J = param("J", 1, "kg m^2")\n', "tensor { mass = 2, xx = J, yy = 1.2, zz = 1.5 } "),
}

local INSIDE = "hole: must lie inside the body it is cut from"

checks.rows = {
  { "argument", "parts", "a", -1, "box: x must be positive" },
  { "argument", "parts", "m", -1, "param: m must be positive" },
  { "argument", "parts", "d", -1, "tube: density must be positive" },
  { "argument", "parts", "q", 0.4, "tube: r_out must be larger than r_in" },
  { "argument", "parts", "k", -1, "scaled: factor[1] must be positive" },
  { "area", "parts", "e", 0, "extrude: profile must enclose an area" },
  { "axis", "parts", "n", 0, "turned: axis must not be zero" },
  { "inside", "hole", "r", 0.6, INSIDE },
  { "inside", "hole", "x", -0.05, INSIDE }, -- in the other hole
  { "denser", "hole", "d", 1100, "hole: must not be denser than the body it is cut from" },
  { "inside", "apart", "r", 0.6, INSIDE, open = true },
  { "simple", "outline", "v", 1.5, "extrude: profile must not cross or touch itself", open = true },
  { "total", "total", "c", 6, "total mass must be positive" },
  { "entries", "tensor", "J", -1, "tensor: xx must not be negative" },
  { "triangle", "tensor", "J", 3, "triangle inequality" },
}

-- The row of a check in docs/mass.md.
function checks.line(c)
  local function word(x) return x == true and "yes" or x or "-" end
  return "| " .. c.about .. " | yes | " .. word(c.file) .. " | " .. word(c.mesh) .. " | " .. word(c.code) .. " |"
end

return checks
