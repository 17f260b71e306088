#!/usr/bin/env lua5.4
-- engine_mass.t - the library's mass properties as the generator sees them.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The library's own numbers are tested in tests/runtime.  Here: that every kind of tree reaches it whole, and that
-- refusals come back as messages.  Oracles: textbook formulas, worked out below.

local tap = require "tests.tap"
local program = require "tests.cli.program"
local engine = require "tests.cli.engine"

local lua, gives = engine.lua, engine.gives

-- a box of mass M: M (y^2 + z^2) / 12 and cyclic
local M, x, y, z = 2.4, 0.2, 0.1, 0.05
local Ixx, Iyy, Izz = M * (y * y + z * z) / 12, M * (x * x + z * z) / 12, M * (x * x + y * y) / 12

gives("a box about its centre", "local m = host.mass(scene(box)) say(m.mass, row(m.com), row(m.inertia))",
  { M, 0, 0, 0, Ixx, Iyy, Izz, 0, 0, 0 })
gives("about its corner: M/3 and -M/4 terms, the lecture's",
  "say(row(host.mass(scene(box, nil, { origin = { -0.1, -0.05, -0.025 } })).inertia))",
  { M * (y * y + z * z) / 3, M * (x * x + z * z) / 3, M * (x * x + y * y) / 3, -M * x * y / 4, -M * x * z / 4,
    -M * y * z / 4 })
gives("the centroidal tensor does not depend on the origin",
  "say(row(host.mass(scene(box, nil, { origin = { 1, 2, 3 } })).centroidal))", { Ixx, Iyy, Izz, 0, 0, 0 })
gives("com is seen from the origin, center in the body's coordinates", [[
  local m = host.mass(scene({ op = "at", of = box, r = { 1, 0, 0 } }, nil, { origin = { 0, 0, 2 } }))
  say(row(m.com), row(m.center))]], { 1, 0, -2, 1, 0, 0 })
gives("principal moments ascend, axes belong to them", [[
  local m = host.mass(scene { op = "turned", of = box, q = { math.cos(math.pi / 4), 0, 0, math.sin(math.pi / 4) } })
  say(row(m.moments)) say(row(m.axes))]], { Ixx, Iyy, Izz, 0, 1, 0, 1, 0, 0, 0, 0, -1 }, 1e-14)
gives("density is taken per volume",
  "say(host.mass(scene { shape = 'solid.box', density = 1000, x = 0.2, y = 0.1, z = 0.05 }).mass)", { 1 })
gives("scaled keeps the mass", [[
  local m = host.mass(scene { op = "scaled", of = box, k = { 2, 2, 2 } })
  say(m.mass, row(m.inertia))]], { M, 4 * Ixx, 4 * Iyy, 4 * Izz, 0, 0, 0 })
gives("a sum of three", [[
  local function p(a) return { op = "at", of = box, r = { a, 0, 0 } } end
  local m = host.mass(scene { op = "sum", p(-1), p(0), p(1) })
  say(m.mass, row(m.com), row(m.inertia))]],
  { 3 * M, 0, 0, 0, 3 * Ixx, 3 * Iyy + 2 * M, 3 * Izz + 2 * M, 0, 0, 0 })
gives("a hole", [[
  local hole = { shape = "solid.box", mass = 0.3, x = 0.1, y = 0.05, z = 0.025 }
  local m = host.mass(scene { op = "minus", box, hole })
  say(m.mass, m.inertia[1])]], { 2.1, Ixx - 0.3 * (0.05 ^ 2 + 0.025 ^ 2) / 12 })
gives("points", "say(row(host.mass(scene { shape = 'points', list = { { 1, 1, 0, 0 }, { 1, -1, 0, 0 } } }).inertia))",
  { 0, 2, 2, 0, 0, 0 })
gives("a tensor about the centre of mass", [[say(row(host.mass(scene { shape = "tensor", mass = 2,
  com = { 0, 0, 1 }, xx = 3, yy = 4, zz = 5, xy = -0.5 }).inertia))]],
  { 5, 6, 5, -0.5, 0, 0 })
gives("a tensor about the origin", [[say(row(host.mass(scene { shape = 'tensor', about = "origin", mass = 2,
  com = { 0, 0, 1 }, xx = 5, yy = 6, zz = 5, xy = -0.5 }).inertia))]], { 5, 6, 5, -0.5, 0, 0 })
gives("a rod between two points",
  "say(row(host.mass(scene { shape = 'rod.between', mass = 3, from = { 0, 0, 0 }, to = { 2, 0, 0 } }).inertia))",
  { 0, 4, 4, 0, 0, 0 })

-- shapes of points, outlines and limits; each is given by a list that could be read in the wrong order
local function shape(name, text, want)
  gives(name, "local m = host.mass(scene(" .. text .. ")) say(row { m.mass }, row(m.com), row(m.inertia))", want)
end
-- inertia about the origin from mass, centre and the moments and products <xx> ... of unit mass there
local function from(m, cx, cy, cz, xx, yy, zz, xy, xz, yz)
  return { m, cx, cy, cz, m * (yy + zz), m * (xx + zz), m * (xx + yy), -m * (xy or 0), -m * (xz or 0), -m * (yz or 0) }
end
shape("a flag and a negative size", "{ shape = 'shell.cylinder', density = 1, r = 1, h = 2, ends = true }",
  from(6 * math.pi, 0, 0, 0, 5 / 12, 5 / 12, 5 / 9))
shape("a zone below the equator: x^2 = (r^2 - z^2)/2 on a sphere",
  "{ shape = 'shell.zone', mass = 3, r = 1, z1 = -1, z2 = 0 }", from(3, 0, 0, -1 / 2, 1 / 3, 1 / 3, 1 / 3))
shape("a tetrahedron: x^2 is 1/10, xy is 1/20",
  "{ shape = 'solid.tetrahedron', density = 6, vertices = { {0,0,0}, {1,0,0}, {0,2,0}, {0,0,3} } }",
  from(6, 1 / 4, 2 / 4, 3 / 4, 1 / 10, 4 / 10, 9 / 10, 2 / 20, 3 / 20, 6 / 20))
shape("a triangle in space: x^2 is 1/6, xy is 1/12",
  "{ shape = 'plate.triangle', mass = 1, vertices = { {0,0,1}, {1,0,1}, {0,2,1} } }",
  from(1, 1 / 3, 2 / 3, 1, 1 / 6, 4 / 6, 1, 2 / 12, 1 / 3, 2 / 3))
shape("a parallelepiped", "{ shape = 'solid.parallelepiped', density = 1, edges = { {1,0,0}, {0,2,0}, {0,0,3} } }",
  from(6, 1 / 2, 1, 3 / 2, 1 / 3, 4 / 3, 9 / 3, 2 / 4, 3 / 4, 6 / 4))
shape("an open polyline: two rods", "{ shape = 'wire.polyline', density = 1, points = { {2,0,0}, {0,0,0}, {0,2,0} } }",
  from(4, 1 / 2, 1 / 2, 0, 2 / 3, 2 / 3, 0))
shape("a closed one",
  "{ shape = 'wire.polyline', density = 1, closed = true, points = { {0,0,0}, {2,0,0}, {2,2,0}, {0,2,0} } }",
  from(8, 1, 1, 0, 5 / 3, 5 / 3, 0, 1))
shape("a prism", "{ shape = 'solid.prism', density = 1, h = 2, profile = { {0,0}, {1,0}, {1,3}, {0,3} } }",
  from(6, 1 / 2, 3 / 2, 1, 1 / 3, 3, 4 / 3, 3 / 4, 1 / 2, 3 / 2))
local FRAME = "profile = { {-2,-2}, {2,-2}, {2,2}, {-2,2} }, holes = { { {-1,-1}, {1,-1}, {1,1}, {-1,1} } }"
local square = (16 * 4 / 3 - 4 / 3) / 12
shape("a plate with a hole", "{ shape = 'plate.polygon', density = 1, " .. FRAME .. "}",
  from(12, 0, 0, 0, square, square, 0))
shape("extruded", "{ shape = 'extrude', density = 1, h = 3, " .. FRAME .. "}",
  from(36, 0, 0, 3 / 2, square, square, 3))
shape("a plate with two holes, of unlike length", [[{ shape = 'plate.polygon', density = 1,
    profile = { {0,0}, {4,0}, {4,2}, {0,2} },
    holes = { { {1,0.5}, {2,0.5}, {1,1.5} }, { {2.5,0.5}, {3.5,0.5}, {3.5,1.5}, {2.5,1.5} } } }]],
  -- rectangle 8, triangle 1/2 at (4/3, 5/6), square 1 at (3, 1)
  from(6.5, (16 - 2 / 3 - 3) / 6.5, (8 - 5 / 12 - 1) / 6.5,
    0, (8 * 16 / 3 - (16 / 9 + 1 / 18) / 2 - (9 + 1 / 12)) / 6.5,
    (8 * 4 / 3 - (25 / 36 + 1 / 18) / 2 - (1 + 1 / 12)) / 6.5, 0,
    (8 * 2 - (10 / 9 - 1 / 36) / 2 - 3) / 6.5))
shape("revolved: a tube", "{ shape = 'revolve', density = 1, profile = { {1,-1}, {2,-1}, {2,1}, {1,1} } }",
  from(6 * math.pi, 0, 0, 0, 5 / 4, 5 / 4, 1 / 3))
shape("a region: z from 0 to x y over 0 < x < 1, 0 < y < 2", [[{ shape = 'region', mass = 2, order = { 2, 1, 3 },
    limits = { { {}, { {2,0,0,0} } }, { {}, { {1,0,0,0} } }, { {}, { {1,1,1,0} } } } }]],
  -- means with the weight x y: x^n is 2/(n + 2), y^n is 2^n 2/(n + 2); z is x y/2
  from(2, 2 / 3, 4 / 3, 4 / 9, 1 / 2, 2, 1 / 3, 8 / 9, 1 / 2 * 4 / 3 / 2, 2 / 3 * 2 / 2))
shape("a region of the density 1 + x", [[{ shape = 'region', density = { {1,0,0,0}, {1,1,0,0} }, order = { 1, 2, 3 },
    limits = { { {}, { {1,0,0,0} } }, { {}, { {1,0,0,0} } }, { {}, { {1,0,0,0} } } } }]],
  from(3 / 2, 5 / 9, 1 / 2, 1 / 2, 7 / 18, 1 / 3, 1 / 3, 5 / 18, 5 / 18, 1 / 4))
shape("a mesh's moments", "{ shape = 'mesh', mass = 2, com = { 1, 2, 3 }, sigma = { 3, 4, 5, 0.1, 0.2, 0.3 } }",
  from(2, 1, 2, 3, 4, 8, 14, 2.1, 3.2, 6.3))
shape("a shear: x + y", [[{ op = "affine", A = { 1, 1, 0, 0, 1, 0, 0, 0, 1 },
    of = { shape = 'solid.box', mass = 1, x = 2, y = 2, z = 2 } }]], from(1, 0, 0, 0, 2 / 3, 1 / 3, 1 / 3, 1 / 3))

tap.is(lua("say(host.mass(scene { shape = 'solid.sphere', mass = 1, r = -1 }))"),
  "nil solid.sphere: lengths and scale factors must be positive\n", "a wrong length is refused, with the shape's name")
for _, case in ipairs {
  { "an unknown shape", "{ shape = 'solid.blob', mass = 1 }", "nil solid.blob: " },
  { "a mass of zero", "{ shape = 'solid.sphere', mass = 0, r = 1 }", "nil solid.sphere: " },
  { "a hole larger than the body", "{ op = 'minus', box, { shape = 'solid.sphere', mass = 99, r = 9 } }",
    "nil minus: " },
  { "a quaternion of zero", "{ op = 'turned', of = box, q = { 0, 0, 0, 0 } }", "nil turned: " },
  { "a tensor that no body has", "{ shape = 'tensor', mass = 1, xx = 1, yy = 1, zz = 9 }", "nil tensor: " },
  { "no points", "{ shape = 'points', list = {} }", "nil points: " },
  { "a bow tie", "{ shape = 'plate.polygon', mass = 1, profile = { {0,0}, {1,1}, {1,0}, {0,1} } }",
    "nil plate.polygon: an outline must not cross" },
  { "a hole beside the profile", "{ shape = 'extrude', mass = 1, h = 1, profile = { {0,0}, {1,0}, {0,1} }, " ..
    "holes = { { {5,5}, {6,5}, {5,6} } } }", "nil extrude: a hole must lie within" },
  { "ten faces", "{ shape = 'solid.regular', mass = 1, faces = 10, edge = 1 }", "nil solid.regular: wrong number" },
  { "two vertices", "{ shape = 'plate.triangle', mass = 1, vertices = { {0,0,0}, {1,0,0} } }", "nil plate.triangle: " },
  { "a region that integrates x twice", "{ shape = 'region', mass = 1, order = { 1, 1, 2 }, limits = { " ..
    "{ {}, { {1,0,0,0} } }, { {}, { {1,0,0,0} } }, { {}, { {1,0,0,0} } } } }", "nil region: " },
  { "a power of -1", "{ shape = 'region', mass = 1, order = { 1, 2, 3 }, limits = { " ..
    "{ {}, { {1,0,0,0} } }, { {}, { {1,-1,0,0} } }, { {}, { {1,0,0,0} } } } }", "nil region: " },
  { "a power of 1e300", "{ shape = 'region', mass = 1, order = { 1, 2, 3 }, limits = { " ..
    "{ {}, { {1,0,0,0} } }, { {}, { {1,1e300,0,0} } }, { {}, { {1,0,0,0} } } } }", "nil region: " },
  { "a flattening map", "{ op = 'affine', of = box, A = { 1, 0, 0, 0, 1, 0, 0, 0, 0 } }", "nil affine: points, edges" },
  { "a mesh of negative moments", "{ shape = 'mesh', mass = 1, com = { 0, 0, 0 }, sigma = { 1, 1, -1, 0, 0, 0 } }",
    "nil mesh: " },
  { "NaN", "{ shape = 'solid.sphere', mass = 0 / 0, r = 1 }", "nil solid.sphere: " },
} do
  tap.like(lua("say(host.mass(scene(" .. case[2] .. ")))"), case[3], case[1] .. " is refused by name")
end
for _, case in ipairs {
  { "no body", "{}" },
  { "a body that is a number", "{ body = 3 }" },
  { "a shape without sizes", "scene { shape = 'solid.box', mass = 1 }" },
  { "an unknown operation", "scene { op = 'melted', of = box }" },
  { "a short vector", "scene { op = 'at', of = box, r = { 1 } }" },
  { "a profile of one number a row", "scene { shape = 'plate.polygon', mass = 1, profile = { {0}, {1}, {2} } }" },
  { "a profile that is a number", "scene { shape = 'revolve', mass = 1, profile = 3 }" },
  { "holes that are points", "scene { shape = 'plate.polygon', mass = 1, profile = { {0,0}, {1,0}, {0,1} }, " ..
    "holes = { 1 } }" },
  { "ends that are a number", "scene { shape = 'shell.cylinder', mass = 1, r = 1, h = 1, ends = 1 }" },
  { "an exponent of 1/2", "scene { shape = 'region', mass = 1, order = { 1, 2, 3 }, limits = { " ..
    "{ {}, { {1,0,0,0} } }, { {}, { {1,0.5,0,0} } }, { {}, { {1,0,0,0} } } } }" },
  { "a region of two limits", "scene { shape = 'region', mass = 1, order = { 1, 2, 3 }, " ..
    "limits = { { {}, {} }, { {}, {} } } }" },
  { "an unknown effect", "scene(box, { { kind = 'magic' } })" },
} do
  tap.is(lua("say((pcall(host.mass, " .. case[2] .. ")))"), "false\n", case[1] .. " is a bug of the caller")
end
tap.like(lua([[
  local t = box
  for _ = 1, 100000 do t = { op = "at", of = t, r = { 0, 0, 0 } } end
  say(pcall(host.mass, scene(t)))]]), "false body tree: deeper than 1000", "a tree too deep is refused, not a crash")

tap.done(program.finish())
