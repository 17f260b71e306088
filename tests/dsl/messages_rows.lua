-- messages_rows.lua: the messages about lists of points, polygons, regions and shears, for errors.t.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The form of a row: messages_shapes.lua.

local forms = require "tests.dsl.forms"
local BOX, body = forms.BOX, forms.body

local function polyline(points, more)
  return body("wire.polyline { points = " .. points .. ", mass = 1" .. (more or "") .. " }")
end
local function plate(profile, holes)
  return body("plate.polygon { profile = " .. profile .. ", mass = 1" .. (holes and ", holes = " .. holes or "") ..
    " }")
end
local function region(rows) return body("region { " .. rows .. " }") end

local SQUARE = "{{0, 0}, {4, 0}, {4, 4}, {0, 4}}"

local lists = { about = "rows, lists, flags",
  { polyline "3", 2, "wire.polyline: points must be a list of 2 or more rows of 3 numbers, got 3" },
  { polyline "{}", 2, "wire.polyline: points must be a list of 2 or more rows of 3 numbers, got a table" },
  { polyline "{{0, 0, 0}}", 2, "wire.polyline: points must be a list of 2 or more rows of 3 numbers, got {{0, 0, 0}}" },
  { polyline "{{0, 0, 0}, {1, 0}}", 2, "wire.polyline: points[2] must be a list of 3 numbers, got {1, 0}" },
  { polyline "{{0, 0, 0}, 7}", 2, "wire.polyline: points[2] must be a list of 3 numbers, got 7" },
  { polyline '{{0, 0, 0}, {1, 0, "x"}}', 2,
    "wire.polyline: points[2][3] must be a number such as \"0.1\", \"1e-3\" or \"1/3\", got \"x\"" },
  { polyline "{{0, 0, 0}, {1, 0, 0}, x = 1}", 2,
    "wire.polyline: points must be a list of 2 or more rows of 3 numbers, got {{0, 0, 0}, {1, 0, 0}}" },
  { polyline "{{0, 0, 0}, {0, 0, 0}}", 2,
    "wire.polyline: points must differ from their neighbours, got points {{0, 0, 0}, {0, 0, 0}}" },
  { polyline '{{0, 0, 0}, {1, 0, quantity(1, "kg")}}', 2, "wire.polyline: points[2][3] must be in m, got 1 kg" },
  { polyline("{{0, 0, 0}, {1, 0, 0}}", ", closed = 1"), 2, "wire.polyline: closed must be true or false, got 1" },
  { body 'shell.cylinder { r = 1, h = 1, mass = 1, ends = "yes" }', 2,
    "shell.cylinder: ends must be true or false, got \"yes\"" },
  { "local t = {}\nfor i = 1, 1001 do t[i] = {i, 0, 0} end\n" ..
    'return scene { name = "s", body = wire.polyline { points = t, mass = 1 } }\n', 3,
    "wire.polyline: points must have at most 1000 rows, got {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, " ..
    "{4, 0, 0}, {5, 0, 0}, {6, 0, 0}, ...}" },
  { body "solid.tetrahedron { vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, mass = 1 }", 2,
    "tetrahedron: vertices must be a list of 4 rows of 3 numbers, got {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}" },
  { body "solid.tetrahedron { vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, mass = 1 }", 2,
    "tetrahedron: vertices must not lie in one plane, got vertices {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}" },
  { body "solid.parallelepiped { edges = {{0, 0, 1}, {1, 0, 0}, {1, 0, 1}}, mass = 1 }", 2,
    "parallelepiped: edges must not lie in one plane, got edges {{0, 0, 1}, {1, 0, 0}, {1, 0, 1}}" },
  { body "plate.triangle { vertices = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, mass = 1 }", 2,
    "plate.triangle: vertices must not lie on one line, got vertices {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}" },
  { body "solid.regular { faces = 10, edge = 1, mass = 1 }", 2, "regular: faces must be 4, 6, 8, 12, 20, got 10" },
  { body 'solid.regular { faces = "6", edge = 1, mass = 1 }', 2, "regular: faces must be 4, 6, 8, 12, 20, got \"6\"" },
  { body "solid.regular { edge = 1, mass = 1 }", 2, "regular: faces is missing" },
}

local limits = { about = "limits of sizes",
  { body "plate.sector { r = 1, angle = 7, mass = 1 }", 2, "plate.sector: angle must not exceed 2 pi, got angle 7" },
  { body "plate.sector { r = 1, angle = 0, mass = 1 }", 2, "plate.sector: angle must be positive, got 0" },
  { body 'wire.arc { r = 1, angle = quantity(1, "m"), mass = 1 }', 2,
    "wire.arc: angle must be a pure number, got 1 m" },
  { body "wire.arc { r = 1, angle = 6.3, mass = 1 }", 2, "wire.arc: angle must not exceed 2 pi, got angle 6.3" },
  { body "solid.cap { r = 1, h = 2.5, mass = 1 }", 2, "cap: h must not exceed 2 r, got r 1, h 2.5" },
  { body "solid.sector { r = 1, h = 3, mass = 1 }", 2, "sector: h must not exceed 2 r, got r 1, h 3" },
  { body "solid.zone { r = 1, z1 = 0.5, z2 = 0.5, mass = 1 }", 2,
    "zone: z2 must be larger than z1, got z1 0.5, z2 0.5" },
  { body "solid.zone { r = 1, z1 = -2, z2 = 3, mass = 1 }",
    { 2, "zone: z1 must not be below -r, got r 1, z1 -2" },
    { 2, "zone: z2 must not exceed r, got r 1, z2 3" } },
  { body "shell.zone { r = 1, z1 = 0.7, z2 = 0.5, mass = 1 }", 2,
    "shell.zone: z2 must be larger than z1, got z1 0.7, z2 0.5" },
  { body "solid.hollow_sphere { r_in = 2, r_out = 1, mass = 1 }", 2,
    "hollow_sphere: r_out must be larger than r_in, got r_in 2, r_out 1" },
  { body "plate.annulus { r_in = 1, r_out = 1, mass = 1 }", 2,
    "plate.annulus: r_out must be larger than r_in, got r_in 1, r_out 1" },
  { body "shell.torus { R = 1, r = 1, mass = 1 }", 2, "shell.torus: R must be larger than r, got R 1, r 1" },
  { body "wire.helix { r = 1, pitch = 1, turns = 0, mass = 1 }", 2, "wire.helix: turns must be positive, got 0" },
  { body "wire.catenary { a = -1, span = 1, mass = 1 }", 2, "wire.catenary: a must be positive, got -1" },
}

local polygons = { about = "polygons",
  { plate "{{0, 0}, {1, 1}}", 2,
    "plate.polygon: profile must be a list of 3 or more rows of 2 numbers, got {{0, 0}, {1, 1}}" },
  { plate "{{0, 0}, {1, 1}, {1, 0}, {0, 1}}", 2, "plate.polygon: profile must not cross itself, got sides 1 and 3" },
  { plate "{{0, 0}, {1, 1}, {2, 2}}", 2, "plate.polygon: profile must enclose an area, got 0" },
  { plate(SQUARE, "{{{5, 5}, {6, 5}, {6, 6}}}"), 2, "plate.polygon: holes[1] must lie inside the profile, got (5, 5)" },
  { plate(SQUARE, "{{{3, 3}, {6, 3}, {3, 3.5}}}"), 2,
    "plate.polygon: holes[1] must lie inside the profile, got sides that cross" },
  { plate(SQUARE, "{{{1, 1}, {2, 1}, {2, 2}}, {{1.5, 1.2}, {3, 1}, {3, 3}}}"), 2,
    "plate.polygon: holes[2] must not overlap holes[1]" },
  { plate(SQUARE, "{{{1, 1}, {2, 1}, {2, 2}}, {{1, 1}, {2, 1}, {2, 2}}}"), 2,
    "plate.polygon: holes[2] must not overlap holes[1]" },
  { plate(SQUARE, "{{{1, 1}, {2, 2}, {2, 1}, {1, 2}}}"), 2,
    "plate.polygon: holes[1] must not cross itself, got sides 1 and 3" },
  { plate(SQUARE, "{{1, 1}, {2, 1}, {2, 2}}"),
    { 2, "plate.polygon: holes[1] must be a list of 3 or more rows of 2 numbers, got {1, 1}" },
    { 2, "plate.polygon: holes[2] must be a list of 3 or more rows of 2 numbers, got {2, 1}" },
    { 2, "plate.polygon: holes[3] must be a list of 3 or more rows of 2 numbers, got {2, 2}" } },
  { plate(SQUARE, "3"), 2, "plate.polygon: holes must be a list of lists of rows of 2 numbers, got 3" },
  { body "revolve { profile = {{-1, 0}, {1, 0}, {1, 1}}, mass = 1 }", 2,
    "revolve: profile[1] must not be left of the axis, got (-1, 0)" },
  { body "extrude { profile = {{0, 0}, {1, 0}, {0, 1}}, h = 0, mass = 1 }", 2, "extrude: h must be positive, got 0" },
  { body "solid.prism { profile = {{0, 0}, {1, 0}, {0, 1}}, h = 1, holes = {}, mass = 1 }", 2,
    "prism: unknown argument \"holes\" (it has profile, h, mass, density)" },
}

local regions = { about = "regions",
  { body "region(3)", 2, "region: takes {{x, lo, hi}, {y, lo, hi}, {z, lo, hi}, density = or mass =}, got 3" },
  { region "{x, 0, 1}, {y, 0, 1}, {z, 0, 1}", 2, "region: mass is missing (give mass or density)" },
  { region "{x, 0, 1}, {y, 0, 1}, mass = 1", 2,
    "region: row 3 must be {coordinate, lo, hi}, each of x, y, z once, got nothing" },
  { region "{x, 0, 1}, {x, 0, 1}, {z, 0, 1}, mass = 1", 2,
    "region: row 2 must be {coordinate, lo, hi}, each of x, y, z once, got {x, 0, 1}" },
  { region "{x, 0, 1}, {y, 0}, {z, 0, 1}, mass = 1", 2,
    "region: row 2 must be {coordinate, lo, hi}, each of x, y, z once, got {y, 0}" },
  { region "{1, 0, 1}, {y, 0, 1}, {z, 0, 1}, mass = 1", 2,
    "region: row 1 must be {coordinate, lo, hi}, each of x, y, z once, got {1, 0, 1}" },
  { region "{x, 0, 1}, {y, 0, 1}, {z, 0, 1}, mass = 1, height = 2", 2,
    "region: unknown argument \"height\" (it has three rows, mass, density)" },
  { region "{x, 0, 1}, {y, 0, 1}, {z, 0, 1}, mass = 1, density = 1", 2, "region: give mass or density, not both" },
  { region "{x, 0, 1}, {y, 0, 1}, {z, 0, 1}, mass = -1", 2, "region: mass must be positive, got -1" },
  { region "{x, 0, y}, {y, 0, 1}, {z, 0, 1}, mass = 1", 2,
    "region: upper limit of x must not depend on y, which is not outside of it, got y" },
  { region "{x, 0, 1}, {y, 0, z}, {z, 0, 1}, mass = 1", 2,
    "region: upper limit of y must not depend on z, which is not outside of it, got z" },
  { region "{x, 0, 1}, {y, 0, sqrt(x)}, {z, 0, 1}, mass = 1", 2,
    "region: upper limit of y must be in m, got sqrt(x) m^1/2" },
  { region "{x, 1, 2}, {y, 0, 1/x}, {z, 0, 1}, mass = 1", 2, "region: upper limit of y must be in m, got 1/x 1/m" },
  { region "{x, 0, 1}, {y, 0, x^2}, {z, 0, 1}, mass = 1", 2, "region: upper limit of y must be in m, got x^2 m^2" },
  { region '{x, 0, quantity(1, "s")}, {y, 0, 1}, {z, 0, 1}, mass = 1', 2,
    "region: upper limit of x must be in m, got 1 s" },
  { region '{x, 0, "one"}, {y, 0, 1}, {z, 0, 1}, mass = 1', 2,
    "region: upper limit of x must be a number such as \"0.1\", \"1e-3\" or \"1/3\", got \"one\"" },
  { region "{x, 1, 0}, {y, 0, 1}, {z, 0, 1}, mass = 1", 2,
    "region: the upper limit of x must exceed the lower one, got 1 to 0" },
  { region "{x, 0, 1}, {y, 0, x - 0.5}, {z, 0, 1}, mass = 1", 2,
    "region: the upper limit of y must exceed the lower one, got 0 to -0.5 near (0, 0, 0)" },
  { region "{x, 0, 1}, {y, 0, 1}, {z, 0, 1}, density = -1", 2,
    "region: density must not be negative, got -1 at (0, 0, 0)" },
  { region "{x, 0, 1}, {y, 0, 1}, {z, 0, 1}, density = x/2 - 0.4", 2,
    "region: density must be in kg/m^3, got (5*x - 4)/10 m" },
  { region "{x, 0, 1}, {y, 0, 1}, {z, 0, 1}, density = 0", 2, "region: density must be positive somewhere, got 0" },
  { region '{x, 0, 1}, {y, 0, 1}, {z, 0, 1}, density = quantity(1, "kg")', 2,
    "region: density must be in kg/m^3, got 1 kg" },
  { region '{x, 0, 1}, {y, 0, 1}, {z, 0, 1}, density = quantity(1, "kg/m^3")*sin(x/quantity(1, "m"))', 2,
    "region: density must be a polynomial in x, y, z, got sin(x)" },
}

local outside = { about = "coordinates outside a region",
  { body "solid.sphere { r = x, mass = 1 }", 2,
    "sphere: r must not depend on x, y, z, which are the coordinates of a region, got x" },
  { body("solid.sphere { r = 1, mass = 1 }:at{x, 0, 0}"), 2,
    "at: position[1] must not depend on x, y, z, which are the coordinates of a region, got x" },
  { body "plate.polygon { profile = {{0, 0}, {x, 0}, {0, 1}}, mass = 1 }", 2,
    "plate.polygon: profile[2][1] must not depend on x, y, z, which are the coordinates of a region, got x" },
  { 'return scene { name = "s", body = solid.sphere { r = 1, mass = 1 }, origin = {x, 0, 0} }\n', 1,
    "origin: origin[1] must not depend on x, y, z, which are the coordinates of a region, got x" },
}

local shears = { about = "shears",
  { body(BOX .. ":sheared(3)"), 2, "sheared: takes a table of named arguments (xy, xz, yx, yz, zx, zy), got 3" },
  { body(BOX .. ":sheared{xx = 1}"), 2, "sheared: unknown argument \"xx\" (it has xy, xz, yx, yz, zx, zy)" },
  { body(BOX .. ':sheared{xy = quantity(1, "m")}'), 2, "sheared: xy must be a pure number, got 1 m" },
  { body(BOX .. ":sheared{xy = 1, yx = 1}"), 2, "sheared: the determinant must be positive, got 0" },
  { body(BOX .. ":sheared{xy = 2, yx = 1}"), 2, "sheared: the determinant must be positive, got -1" },
  { body(BOX .. ":sheared{xy = \"a\"}"), 2,
    "sheared: xy must be a number such as \"0.1\", \"1e-3\" or \"1/3\", got \"a\"" },
  { body "shell.sphere { r = 1, mass = 1 }:sheared{xy = 1}", 2,
    "sheared: a curved wire or shell can only be scaled by one factor" },
  { body "wire.hoop { r = 1, mass = 1 }:scaled{1, 2, 1}", 2,
    "scaled: a curved wire or shell can only be scaled by one factor, got {1, 2, 1}" },
  { body "plate.disc { r = 1, density = 1 }:sheared{xy = 1}", 2,
    "sheared: a plate or rod given by its density can only be scaled by one factor" },
  { body "(solid.sphere { r = 1, mass = 1 } + shell.box { x = 1, y = 1, z = 1, mass = 1 }):sheared{xy = 1}", 2,
    "sheared: a curved wire or shell can only be scaled by one factor" },
}

return { lists, limits, polygons, regions, outside, shears }
