-- examples.lua -- every shape in pleasant proportions: arguments, what its dimensions measure, how to look at it.
--
-- An entry: {args = {name = number, vector or list}, dims = function(a) -> {{label, from, to, out =}, ...},
-- open = true for shells and plates, view = {azimuth, height}, turn = {from, angle}: cut open, in turns; cut = true: a
-- shell without the quarter x > 0, y > 0; node = what is drawn instead of the shape with these arguments;
-- scene = {name = text}: arguments as a person would type them; line = the whole constructor as text}.
-- SPDX-License-Identifier: GPL-3.0-or-later

local pi = math.pi
local examples = {}

local function entry(name, args, dims, more)
  local e = more or {}
  e.name, e.args, e.dims = name, args, dims or function() return {} end
  local kind = string.match(name, "^%a+")
  e.open = kind == "shell" or kind == "plate"
  examples[name] = e
end

local function at(r, turns, z) return { r * math.cos(2 * pi * turns), r * math.sin(2 * pi * turns), z or 0 } end
local function arc(label, r, from, to, z, fields)
  local list = fields or {}
  list[1] = label
  for i = 0, 12 do list[2 + i] = at(r, from + (to - from) * i / 12, z) end
  return list
end
local quarter = { 1 / 4, 3 / 4 } -- without the quarter x > 0, y > 0
local rim = 0.15 -- where a radius is drawn: towards the viewer's right

-- edges along the axes of a box from p to q
local function edges(p, q, names)
  return { { names[1], { p[1], q[2], p[3] }, { q[1], q[2], p[3] }, out = true },
    { names[2], { q[1], p[2], p[3] }, { q[1], q[2], p[3] }, out = true },
    { names[3], { p[1], q[2], p[3] }, { p[1], q[2], q[3] }, out = true } }
end
local function box_edges(a)
  return edges({ -a.x / 2, -a.y / 2, -a.z / 2 }, { a.x / 2, a.y / 2, a.z / 2 }, { "x", "y", "z" })
end

-- a height beside the body: right of the screen is the direction (-sin 32, cos 32)
local function upright(label, r, z1, z2)
  local c, s = -math.sin(math.rad(32)), math.cos(math.rad(32))
  return { label, { r * c, r * s, z1 }, { r * c, r * s, z2 }, out = true }
end
local function radius(label, r, z, turns) return { label, { 0, 0, z }, at(r, turns or rim, z) } end

-- ---- solids ----

entry("solid.box", { x = 2, y = 3, z = 1.2 }, box_edges)
entry("solid.sphere", { r = 1 }, function(a) return { radius("r", a.r, 0, 0.22) } end)
entry("solid.ellipsoid", { a = 1, b = 1.5, c = 0.8 }, function(a)
  local o = { 0, 0, 0 }
  return { { "a", o, { a.a, 0, 0 } }, { "b", o, { 0, a.b, 0 } }, { "c", o, { 0, 0, a.c } } }
end)
entry("solid.cylinder", { r = 1, h = 2 }, function(a)
  return { radius("r", a.r, a.h / 2), upright("h", a.r, -a.h / 2, a.h / 2) }
end)
entry("solid.elliptic_cylinder", { a = 0.8, b = 1.4, h = 1.6 }, function(a)
  local z = a.h / 2
  return { { "a", { 0, 0, z }, { a.a, 0, z } }, { "b", { 0, 0, z }, { 0, a.b, z } },
    upright("h", 1.3, -z, z) }
end)
entry("solid.tube", { r_in = 0.6, r_out = 1, h = 2 }, function(a)
  local z = a.h / 2
  return { radius("r_in", a.r_in, z, 0.5), radius("r_out", a.r_out, z, 0.88), upright("h", a.r_out, -z, z) }
end, { turn = quarter })
entry("solid.cone", { r = 1, h = 2 }, function(a) return { radius("r", a.r, 0), upright("h", a.r, 0, a.h) } end)
entry("solid.elliptic_cone", { a = 0.8, b = 1.3, h = 1.8 }, function(a)
  return { { "a", { 0, 0, 0 }, { a.a, 0, 0 } }, { "b", { 0, 0, 0 }, { 0, a.b, 0 } }, upright("h", 1.25, 0, a.h) }
end)
entry("solid.frustum", { r_base = 1.2, r_top = 0.6, h = 1.4 }, function(a)
  return { radius("r_base", a.r_base, 0, 0.05), radius("r_top", a.r_top, a.h), upright("h", a.r_base, 0, a.h) }
end)
entry("solid.capsule", { r = 0.7, h = 1.4 }, function(a)
  return { radius("r", a.r, a.h / 2), upright("h", a.r, -a.h / 2, a.h / 2) }
end)
entry("solid.hemisphere", { r = 1 }, function(a) return { radius("r", a.r, 0, 0.05) } end)
entry("solid.cap", { r = 1, h = 0.6 }, function(a)
  local c = a.h - a.r
  local rho = math.sqrt(a.h * (2 * a.r - a.h))
  return { { "r", { 0, 0, c }, { 0, rho, 0 } }, upright("h", rho, 0, a.h) }
end)
entry("solid.zone", { r = 1, z1 = -0.3, z2 = 0.7 }, function(a)
  return { { "r", { 0, 0, 0 }, at(a.r, 0.22) }, upright("z_1", -1, 0, a.z1), upright("z_2", 1, 0, a.z2) }
end)
entry("solid.sector", { r = 1.2, h = 0.5 }, function(a)
  local z = a.r - a.h
  local rho = math.sqrt(a.r ^ 2 - z ^ 2)
  return { { "r", { 0, 0, 0 }, { rho * -math.sin(math.rad(32)), rho * math.cos(math.rad(32)), z }, out = true },
    upright("h", rho, z, a.r) }
end, { view = { 32, 10 } })
entry("solid.half_cylinder", { r = 1, h = 1.6 }, function(a)
  return { radius("r", a.r, a.h / 2, 0), { "h", { 0, a.r, -a.h / 2 }, { 0, a.r, a.h / 2 }, out = true } }
end, { view = { 55, 28 } })
entry("solid.quarter_cylinder", { r = 1, h = 1.4 }, function(a)
  return { radius("r", a.r, a.h / 2, 0), { "h", { 0, a.r, -a.h / 2 }, { 0, a.r, a.h / 2 }, out = true } }
end)
entry("solid.hoof", { r = 1, h = 1.4 }, function(a)
  return { { "r", { 0, 0, 0 }, { 0, a.r, 0 }, out = true }, { "h", { a.r, 0, 0 }, { a.r, 0, a.h }, out = true } }
end, { view = { 118, 22 } })
entry("solid.torus", { R = 1.4, r = 0.5 }, function(a)
  return { { "R", { 0, 0, 0 }, { 0, a.R, 0 } }, { "r", { 0, a.R, 0 }, { 0, a.R + a.r * 0.6, a.r * 0.8 } } }
end, { view = { 32, 46 }, turn = quarter })
entry("solid.hollow_sphere", { r_in = 0.65, r_out = 1 }, function(a)
  return { { "r_in", { 0, 0, 0 }, { a.r_in * 0.8, 0, a.r_in * 0.6 } },
    { "r_out", { 0, 0, 0 }, { 0, a.r_out * 0.8, a.r_out * -0.6 } } }
end, { turn = quarter })
entry("solid.paraboloid", { r = 1, h = 1.6 },
  function(a) return { radius("r", a.r, a.h), upright("h", a.r, 0, a.h) } end)
entry("solid.pyramid", { x = 1.6, y = 2.2, h = 1.8 }, function(a)
  local e = edges({ -a.x / 2, -a.y / 2, 0 }, { a.x / 2, a.y / 2, a.h }, { "x", "y", "h" })
  return { e[1], e[2], { "h", { -a.x / 2, a.y / 2, 0 }, { -a.x / 2, a.y / 2, a.h }, out = true } }
end)
entry("solid.prism", { profile = { { 0, 0 }, { 2, 0 }, { 2, 0.7 }, { 0.7, 0.7 }, { 0.7, 2 }, { 0, 2 } }, h = 1 },
  function(a) return { { "h", { 0, 2, 0 }, { 0, 2, a.h }, out = true } } end, { view = { 32, 32 } })
entry("solid.wedge", { x = 1.6, y = 2, z = 1.2 }, function(a)
  return { { "x", { 0, 0, a.z }, { a.x, 0, a.z }, out = true }, { "y", { 0, 0, a.z }, { 0, a.y, a.z }, out = true },
    { "z", { 0, a.y, 0 }, { 0, a.y, a.z }, out = true } }
end)
entry("solid.tetrahedron", { vertices = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2.4, 0 }, { 0.4, 0.5, 1.8 } } }, function(a)
  local list = {}
  for i, v in ipairs(a.vertices) do list[i] = { "v_" .. i, v, v } end
  return list
end)
entry("solid.parallelepiped", { edges = { { 1.6, 0, 0 }, { 0.4, 2, 0 }, { 0.3, 0.3, 1.2 } } }, function(a)
  local list, o, e = {}, { 0, 0, 0 }, a.edges
  for i, v in ipairs(e) do list[i] = { "e_" .. i, o, v } end
  return list
end)
entry("solid.regular", { faces = 12, edge = 1 }, nil)
entry("solid.bicylinder", { r = 1 }, function(a) return { { "r", { 0, 0, 0 }, { 0, a.r, 0 } } } end)

-- ---- shells ----

entry("shell.sphere", { r = 1 }, function(a)
  return { { "r", { 0, 0, 0 }, { 0, a.r * 0.8, a.r * -0.6 } } }
end, { cut = true })
entry("shell.hemisphere", { r = 1 }, function(a) return { radius("r", a.r, 0, 0.25) } end, { cut = true })
entry("shell.zone", { r = 1, z1 = -0.3, z2 = 0.7 }, function(a)
  return { { "r", { 0, 0, 0 }, at(a.r, 0.25) }, upright("z_1", -1, 0, a.z1), upright("z_2", 1, 0, a.z2) }
end, { cut = true })
entry("shell.ellipsoid", { a = 1, b = 1.5, c = 0.8 }, examples["solid.ellipsoid"].dims, { cut = true })
entry("shell.cylinder", { r = 1, h = 2, ends = false }, function(a)
  return { radius("r", a.r, a.h / 2, 0.5), upright("h", a.r, -a.h / 2, a.h / 2) }
end, { cut = true })
entry("shell.cone", { r = 1, h = 2 }, function(a)
  return { radius("r", a.r, 0, 0.25), upright("h", a.r, 0, a.h) }
end, { cut = true })
entry("shell.torus", { R = 1.4, r = 0.5 }, function(a)
  return { { "R", { 0, 0, 0 }, { 0, a.R, 0 } }, { "r", { 0, a.R, 0 }, { 0, a.R + a.r * 0.6, a.r * 0.8 } } }
end, { view = { 32, 46 }, cut = true })
entry("shell.box", { x = 2, y = 3, z = 1.2 }, box_edges, { cut = true })

-- ---- plates ----

local above = { 32, 40 }
entry("plate.disc", { r = 1 }, function(a) return { radius("r", a.r, 0) } end, { view = above })
entry("plate.annulus", { r_in = 0.5, r_out = 1 }, function(a)
  return { radius("r_in", a.r_in, 0, 0.5), radius("r_out", a.r_out, 0, 0.75) }
end, { view = above })
entry("plate.ellipse", { a = 0.8, b = 1.3 }, function(a)
  return { { "a", { 0, 0, 0 }, { a.a, 0, 0 } }, { "b", { 0, 0, 0 }, { 0, a.b, 0 } } }
end, { view = above })
entry("plate.rectangle", { x = 1.6, y = 2.4 }, function(a)
  local e = edges({ -a.x / 2, -a.y / 2, 0 }, { a.x / 2, a.y / 2, 0 }, { "x", "y", "z" })
  return { e[1], e[2] }
end, { view = above })
entry("plate.sector", { r = 1, angle = 2 * pi / 3 }, function(a)
  return { { "r", { 0, 0, 0 }, { a.r, 0, 0 } }, arc("angle", 0.35 * a.r, 0, a.angle / (2 * pi)) }
end, { view = above, scene = { angle = "2*pi/3" } })
entry("plate.triangle", { vertices = { { 1.5, 0, 0 }, { 0, 2, 0 }, { 0, 0, 1.5 } } },
  examples["solid.tetrahedron"].dims, { view = { 40, 24 } })
entry("plate.polygon", { profile = { { 0, 0 }, { 3, 0 }, { 3, 1.2 }, { 1.2, 2 }, { 0, 2 } },
  holes = { { { 0.4, 0.4 }, { 1.2, 0.4 }, { 1.2, 1.2 }, { 0.4, 1.2 } } } }, nil, { view = { 60, 44 } })

-- ---- rods and wires ----

entry("rod.straight", { length = 2 }, function(a)
  return { { "length", { 0, 0, -a.length / 2 }, { 0, 0, a.length / 2 }, out = 20, other = true } }
end)
entry("rod.between", { from = { 1, 0, 0.2 }, to = { 0.2, 1.8, 1.2 } }, function(a)
  return { { "from", a.from, a.from }, { "to", a.to, a.to } }
end)
entry("wire.hoop", { r = 1 }, function(a) return { radius("r", a.r, 0) } end, { view = above })
entry("wire.arc", { r = 1, angle = 3 * pi / 4 }, function(a)
  return { { "r", { 0, 0, 0 }, { a.r, 0, 0 } }, arc("angle", 0.35 * a.r, 0, a.angle / (2 * pi)) }
end, { view = above, scene = { angle = "3*pi/4" } })
entry("wire.polyline", { points = { { 0, 0, 0 }, { 1.5, 0, 0 }, { 1.5, 1.5, 0 }, { 1.5, 1.5, 1.2 } }, closed = false },
  function(a)
    local list = {}
    for i, v in ipairs(a.points) do list[i] = { "p_" .. i, v, v } end
    return list
  end)
entry("wire.helix", { r = 1, pitch = 0.6, turns = 3 }, function(a)
  return { radius("r", a.r, a.pitch * a.turns, 0), { "pitch", { a.r, 0, 0 }, { a.r, 0, a.pitch }, out = 16 } }
end)
entry("wire.catenary", { a = 1, span = 2.4 }, function(a)
  local y = (math.exp(a.span / (2 * a.a)) + math.exp(-a.span / (2 * a.a))) * a.a / 2
  return { { "a", { 0, 0, 0 }, { 0, a.a, 0 } }, { "span", { -a.span / 2, y, 0 }, { a.span / 2, y, 0 }, out = true } }
end, { view = { -75, 68 } })

-- ---- others ----

entry("points", { list = { { 1, 1.2, 0, 0 }, { 2, 0, 1.4, 0 }, { 1, -0.6, -0.6, 0.8 } } }, function(a)
  local list = {}
  for i, p in ipairs(a.list) do list[i] = { "m_" .. i, { p[2], p[3], p[4] }, { p[2], p[3], p[4] }, out = 4 } end
  return list
end, { line = "points{{1, 1.2, 0, 0}, {2, 0, 1.4, 0}, {1, -0.6, -0.6, 0.8}}" })
entry("extrude", { profile = { { 0, 0 }, { 2.4, 0 }, { 2.4, 1 }, { 1, 2 }, { 0, 2 } }, h = 0.6,
  holes = { { { 0.4, 0.4 }, { 1.2, 0.4 }, { 1.2, 1.2 }, { 0.4, 1.2 } } } },
  function(a) return { { "h", { 0, 2, 0 }, { 0, 2, a.h }, out = true } } end, { view = { 32, 40 } })
entry("revolve", { profile = { { 0.5, 0 }, { 1.3, 0 }, { 1.3, 0.4 }, { 0.9, 0.5 }, { 0.8, 1.4 }, { 0.5, 1.4 } } }, nil,
  { turn = quarter })
entry("region", { order = { 1, 2, 3 }, limits = { { { { -1, 0, 0, 0 } }, { { 1, 0, 0, 0 } } },
  { {}, { { 1.5, 0, 0, 0 }, { -1.5, 2, 0, 0 } } }, { {}, { { 0.3, 0, 0, 0 }, { 0.6, 0, 1, 0 } } } } }, nil,
  { view = { -58, 30 }, density = { { 1000, 0, 0, 0 }, { 200, 0, 0, 1 } },
    line = 'region{{x, -1, 1}, {y, 0, 1.5 - 1.5*x^2}, {z, 0, 0.3 + 0.6*y},\n'
      .. '  density = 1000 + 200*z}' })
entry("tensor", { mass = 5, xx = 2.89, yy = 1.64, zz = 3.25 }, examples["solid.ellipsoid"].dims,
  { node = { shape = "solid.ellipsoid", a = 1, b = 1.5, c = 0.8 },
    line = "tensor{mass = 5, xx = 2.89, yy = 1.64, zz = 3.25}",
    note = "The picture shows the ellipsoid that has this mass and this tensor." })
entry("mesh", { com = { 0, 0, 0 } }, nil, { node = { shape = "solid.regular", faces = 20, edge = 1 },
  line = 'mesh{file = "part.stl", units = "mm", kind = "volume", density = 2700}',
  note = "Scaled, cut and joined like any other shape. `weld = 1e-6` makes one of vertices that are nearer than a " ..
    "millionth of the longest side ([mass.md](mass.md#meshes))." })
entry("inertial", {}, examples["solid.ellipsoid"].dims, { node = { shape = "solid.ellipsoid", a = 1, b = 1.5, c = 0.8 },
  line = 'inertial{file = "robot.urdf", link = "base"}',
  note = "The picture stands for any body: its tensor is that of the link, turned as its frame lies." })

return examples
