#!/usr/bin/env lua5.4
-- engine.t - the library as the generator sees it, and plugins.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The library's own numbers are tested in tests/runtime.  Here: that a scene's tables reach it whole (every kind
-- of tree, every effect, every option), that refusals come back as messages, and that a plugin's functions are
-- called with what was given.  Oracles: textbook formulas worked out below, and a plugin written by hand.

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()

-- A few roundings of a double in sums of a few terms.
local FEW_ULP = 4e-15

local PRELUDE = [[
local function row(v) local out = {} for i, x in ipairs(v) do out[i] = string.format("%.17g", x) end
  return table.concat(out, " ") end
local box = { shape = "solid.box", mass = 2.4, x = 0.2, y = 0.1, z = 0.05 }
local function scene(body, effects, more)
  local s = { name = "s", body = body, origin = { 0, 0, 0 }, effects = effects or {}, q = { 1, 0, 0, 0 },
    w = { 0.1, 6.0, 0.2 } }
  for k, v in next, more or {} do s[k] = v end
  return s
end
]]

local function lua(text, ...)
  local code, out, err = program.run(PRELUDE .. text, dir, ...)
  if code ~= 0 then
    tap.diag(err)
  end
  return code == 0 and out or nil
end

local function numbers(text)
  local v = {}
  for word in (text or ""):gmatch("%S+") do
    v[#v + 1] = tonumber(word)
  end
  return v
end

-- The numbers that `text` says, against `want`, each to a few units of rounding of the largest.
local function gives(name, text, want, tolerance)
  local got, largest = numbers(lua(text)), 0
  for _, x in ipairs(want) do
    largest = math.max(largest, math.abs(x))
  end
  local good = #got == #want
  for i = 1, #want do
    good = good and math.abs(got[i] - want[i]) <= (tolerance or FEW_ULP) * largest
  end
  tap.ok(good, name, "got  " .. table.concat(got, " ") .. "\nwant " .. table.concat(want, " "))
end

local function says(name, text, want)
  tap.is(lua(text), want, name)
end

-- ---- mass ----

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

-- ---- run ----

gives("the first row is the initial state with its energy and momentum", [[
  say(row(host.run(scene(box), { times = { 0 } })[1]))]], { 0, 1, 0, 0, 0, 0.1, 6, 0.2,
  (Ixx * 0.01 + Iyy * 36 + Izz * 0.04) / 2, Ixx * 0.1, Iyy * 6, Izz * 0.2 })
gives("energy and momentum of a free body are the same 5 s later", [[
  local r = host.run(scene(box), { times = { 5 } })[1]
  say(row { r[9], r[10], r[11], r[12] })]],
  { (Ixx * 0.01 + Iyy * 36 + Izz * 0.04) / 2, Ixx * 0.1, Iyy * 6, Izz * 0.2 }, 1e-14)
gives("a sphere turns at a constant rate: half a turn in 1 s", [[
  local r = host.run(scene({ shape = "solid.sphere", mass = 1, r = 1 }, nil, { w = { 0, 0, math.pi } }),
    { times = { 1 } })[1]
  say(row { r[2], r[5], r[8] })]], { 0, 1, math.pi }, 1e-14)
gives("isotropic damping: w falls as exp(-rate t)", [[
  local r = host.run(scene({ shape = "solid.sphere", mass = 1, r = 1 }, { { kind = "damping", rate = 0.5 } },
    { w = { 0, 0, 2 } }), { times = { 2 } })[1]
  say(row { r[8] })]], { 2 * math.exp(-1) }, 1e-14)
gives("a matrix of damping: c/I in the exponent", [[
  local r = host.run(scene({ shape = "solid.sphere", mass = 1, r = 1 },
    { { kind = "damping", C = { 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1 } },
      { kind = "damping", C = { 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1 } } },
    { w = { 0, 0, 2 } }), { times = { 2 } })[1]
  say(row { r[8] })]], { 2 * math.exp(-0.2 / 0.4 * 2) }, 1e-14)
gives("constant torques in body and inertial axes add up", [[
  local r = host.run(scene({ shape = "solid.sphere", mass = 1, r = 1 },
    { { kind = "torque", body = { 0, 0, 0.4 } }, { kind = "torque", inertial = { 0, 0, 0.4 } } },
    { w = { 0, 0, 0 } }), { times = { 3 } })[1]
  say(row { r[8] })]], { 2 * 3 }, 1e-14)
gives("control acts with its effect, and only then", [[
  local sphere = { shape = "solid.sphere", mass = 1, r = 1 }
  local on = host.run(scene(sphere, { { kind = "control" } }, { w = { 0, 0, 0 } }),
    { times = { 1 }, u = { 0, 0, 0.4 } })[1]
  local off = host.run(scene(sphere, {}, { w = { 0, 0, 0 } }), { times = { 1 }, u = { 0, 0, 0.4 } })[1]
  say(row { on[8], off[8] })]], { 1, 0 }, 1e-14)
-- a pendulum released at rest, horizontal: energy -M g l cos(angle), here 0
gives("gravity acts at the centre of mass, and twice when it is there twice", [[
  local rod = { shape = "points", list = { { 1, 0, 0, 0 }, { 1, 0, 0, -2 }, { 1, 0.1, 0, -1 }, { 1, -0.1, 0, -1 } } }
  local g = { kind = "gravity", g = 4, direction = { 0, 0, -2 } }
  for _, effects in ipairs { { g }, { g, g } } do
    local r = host.run(scene(rod, effects, { w = { 0, 0, 0 }, q = { 1, 1, 0, 0 } }), { times = { 0 } })[1]
    local dx = host.rates(scene(rod, effects)):rates(0, { math.sqrt(0.5), math.sqrt(0.5), 0, 0, 0, 0, 0 })
    say(row { r[9] + 1, dx[5] })
  end]], { 1, -4 * 4 / (4 + 1 + 1), 1, -2 * 4 * 4 / (4 + 1 + 1) }, 1e-14)
for _, method in ipairs { "adaptive", "taylor", "rk4", "gsl-rk4", "rkf45", "rk8pd", "exact" } do
  -- the error of rk4 at h = 1/1000 is of order h^4 w^5 t, a few 1e-9
  gives(method .. " agrees with the reference", string.format([[
    local o = { method = %q, times = { 1 } }
    if string.find(o.method, "rk4") then o.step = 0.001 end
    local a, b = assert(host.run(scene(box), o))[1], host.run(scene(box), { times = { 1 } })[1]
    for i = 2, 8 do a[i] = a[i] - b[i] + 1 end
    say(row { table.unpack(a, 2, 8) })]], method), { 1, 1, 1, 1, 1, 1, 1 }, 1e-7)
end
gives("rows come at the times asked for, backwards too", [[
  local r = host.run(scene(box), { times = { 1, 0.5, 0 }, t0 = 0 })
  say(row { r[1][1], r[2][1], r[3][1], r[3][7] })]], { 1, 0.5, 0, 6 }, 1e-13)
tap.like(lua("say(host.run(scene(box), { times = { 1 }, method = 'magic' }))"), "nil at t = 0.0 s: ",
  "an unknown method is refused")
tap.like(lua("say(host.run(scene(box, { { kind = 'control' } }), { times = { 1 }, method = 'exact' }))"),
  "nil at t = 0.0 s: ", "the exact method refuses effects")
tap.like(lua("say(host.run(scene(box), { times = { 1 }, method = 'rk4', step = -1 }))"), "nil at t = 0.0 s: ",
  "a negative step is refused")
tap.like(lua("say(host.run(scene(box), { times = { 0 / 0 } }))"), "nil at t = ", "a time that is no number is refused")

-- ---- rates ----

gives("rates: Euler's equations and q' = q w / 2, with the largest term of each", [[
  local dx, scale = host.rates(scene(box)):rates(0, { 1, 0, 0, 0, 0.1, 6, 0.2 })
  say(row(dx)) say(row(scale))]],
  { 0, 0.05, 3, 0.1, (Iyy - Izz) * 6 * 0.2 / Ixx, (Izz - Ixx) * 0.2 * 0.1 / Iyy, (Ixx - Iyy) * 0.1 * 6 / Izz,
    0, 0.05, 3, 0.1, Izz * 6 * 0.2 / Ixx, Izz * 0.2 * 0.1 / Iyy, Iyy * 0.1 * 6 / Izz })
gives("a rod's own axis has no rate and no scale", [[
  local r = host.rates(scene { shape = "rod.straight", mass = 1, length = 1 })
  local dx, scale = r:rates(0, { 1, 0, 0, 0, 1, 2, 3 })
  say(row { dx[7], scale[7] })]], { 0, 0 })
gives("energy and momentum with their scales", [[
  local r = host.rates(scene(box))
  local E, scale = r:energy { 1, 0, 0, 0, 0, 6, 0 }
  local L, most = r:momentum { 1, 0, 0, 0, 0, 6, 0 }
  say(row { E, scale }) say(row(L)) say(row { most })]], { Iyy * 18, Iyy * 18, 0, Iyy * 6, 0, Iyy * 6 })

-- ---- plugins ----

-- x' = -p x + u in one state, with every function of the table
program.write(dir .. "/decay.c", [[
#include "plugin.h"
#include <math.h>
#include <stddef.h>
struct model { double rate; };
struct orbit { double rate, x0; };
static int init(void *m, const double *p) {
  double rate = p ? p[0] : 0.5;
  if (!(rate > 0)) return 1;
  ((struct model *)m)->rate = rate;
  return 0;
}
static void params(double *p) { p[0] = 0.5; }
static void inertia(const void *m, double I[6]) { int i; (void)m; for (i = 0; i < 6; i++) I[i] = i + 1; }
static int principal(const void *m, double moments[3], double axes[9]) {
  int i;
  if (((const struct model *)m)->rate == 99) return 1;
  for (i = 0; i < 3; i++) moments[i] = i + 1;
  for (i = 0; i < 9; i++) axes[i] = i % 4 == 0;
  return 0;
}
static void rhs(const void *m, double t, const double *x, const double *u, double *dx) {
  (void)t;
  dx[0] = -((const struct model *)m)->rate*x[0] + u[0];
}
static void step(const void *m, double t, double *x, const double *u, double h) { /* explicit Euler; x[1] counts */
  double dx[2];
  rhs(m, t, x, u, dx);
  x[0] += h*dx[0];
  x[1] += 1;
}
static void jacobian(const void *m, double t, const double *x, const double *u, double *J) {
  (void)t; (void)x; (void)u;
  J[0] = -((const struct model *)m)->rate; J[1] = 0; J[2] = 0; J[3] = 7;
}
static double energy(const void *m, const double *x) { (void)m; return x[0]*x[0]/2; }
static void momentum(const void *m, const double *x, double L[3]) { (void)m; L[0] = x[0]; L[1] = x[1]; L[2] = 3; }
static int solve(void *o, const void *m, const double *x0) {
  ((struct orbit *)o)->rate = ((const struct model *)m)->rate;
  ((struct orbit *)o)->x0 = x0[0];
  return x0[0] > 0 ? 0 : 2;
}
static void at(const void *o, double t, double *x) {
  x[0] = ((const struct orbit *)o)->x0*exp(-((const struct orbit *)o)->rate*t);
  x[1] = 0;
}
#ifndef ABI
#define ABI POLHODE_PLUGIN_ABI
#endif
const struct polhode_plugin *polhode_plugin(void) {
  static const struct polhode_plugin table = {ABI, "decay", "double", 2.220446049250313e-16, 2, 1, 1,
    sizeof(struct model), sizeof(struct orbit), init, params, inertia, principal, rhs, step, FEW};
  return &table;
}
]])

-- plugin.h out of the program's own templates: what an installed program has
local BUILD = [[
local function build(few, flags)
  assert(host.write_file(args[1] .. "/plugin.h", assert(host.templates["templates/plugin.h"])))
  assert(host.compile(args[1], { "decay.c" }, "decay.so",
    { flags = { "-std=c99", "-shared", "-fPIC", "-DFEW=" .. few, flags }, libs = { "-lm" } }))
  return host.plugin(args[1] .. "/decay.so")
end
local all = "jacobian,energy,momentum,solve,at"
]]

says("a plugin tells what it is", BUILD .. [[
  local i = build(all):info()
  say(i.name, i.real, i.epsilon, i.nx, i.nu, i.np, i.params[1], i.has.solve, i.has.step)]],
  "decay double 2.2204460492503e-16 2 1 1 0.5 true true\n")
says("init with the scene's parameters, others, and wrong ones", BUILD .. [[
  local p = build(all)
  say(p:init(), p:rhs(0, { 2, 0 }, { 0 })[1], p:init { 3 }, p:rhs(0, { 2, 0 }, { 1 })[1], p:init { -1 })
  say(pcall(p.rhs, p, 0, { 2, 0 }))]], "0 -1.0 0 -5.0 1\nfalse plugin: init first\n")
says("every function is called with what was given", BUILD .. [[
  local p = build(all)
  p:init { 0.5 }
  local moments, axes = p:principal()
  say(row(p:inertia())) say(row(moments), row(axes)) say(row(p:step(0, { 1, 0 }, { 0 }, 0.1)))
  say(row(p:jacobian(0, { 1, 0 }))) say(p:energy { 3, 0 }, row(p:momentum { 1, 2 }))]],
  "1 2 3 4 5 6\n1 2 3 1 0 0 0 1 0 0 0 1\n0.94999999999999996 1\n-0.5 0 0 7\n4.5 1 2 3\n")
says("moments that the type does not hold are an error", BUILD .. [[
  local p = build(all)
  p:init { 99 }
  say(pcall(p.principal, p))]], "false plugin: a principal moment is beyond the range of the type\n")
says("integrate takes whole steps that hit the times", BUILD .. [[
  local p = build(all)
  p:init()
  for _, r in ipairs(p:integrate({ 1, 0 }, { 0 }, 0.1, { 0, 0.1, 0.35, 1, 0.5 })) do say(r[1], r[3]) end]],
  "0.0 0.0\n0.1 1.0\n0.35 4.0\n1.0 11.0\n0.5 16.0\n")
says("solve says whether there is an orbit, at follows it", BUILD .. [[
  local p = build(all)
  p:init()
  say(p:solve { -1, 0 }, pcall(p.at, p, 1))
  say(p:solve { 2, 0 }, p:at(2)[1] == 2 * math.exp(-1))]], "2 false plugin: solve first\n0 true\n")
says("what was not emitted is missing by name", BUILD .. [[
  local p = build "0,0,0,0,0"
  p:init()
  say(p:jacobian(0, { 1, 0 })) say(p:energy { 1, 0 }) say(p:solve { 1, 0 })]],
  "nil the emitted code has no Jacobian\nnil the emitted code has no energy\nnil the emitted code has no closed form\n")
tap.like(lua(BUILD .. "say(build(all, '-DABI=99'))"), "it was made for another version of polhode",
  "another ABI is refused")
tap.like(lua(BUILD .. "say(host.plugin(args[1] .. '/nothing.so'))"), "nil cannot load ",
  "a file that is not there is refused")
tap.like(lua(BUILD .. "local p = build(all) p:init() say(pcall(p.rhs, p, 0, { 1 }))"), "false ",
  "a short state is refused")

tap.done(program.finish())
