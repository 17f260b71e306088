-- turned.lua -- surfaces of revolution about z: balls, cylinders, cones, tori, their shells and plates.
--
-- A profile is a chain of points {rho, z} that is walked with the body on its left (counter-clockwise), so that
-- normals point outwards.  It either closes or begins and ends on the axis.  Fineness n: segments of a full turn.
-- An ellipsoid is the image of a ball, and so on: `stretch` names the factors of the y axis (and z).
-- A segment of the chain becomes n quadrilaterals, or triangles where one end is on the axis; neighbours use the same
-- points, computed by the same operations, so the surface closes to the bit.  Vertices are on the true surface; with
-- chords of 1/n of a turn volumes and areas are short by O(1/n^2), which Richardson's extrapolation takes out where the
-- surface is compared with the catalogue: so counts of segments double exactly when n does.
-- SPDX-License-Identifier: GPL-3.0-or-later

local polygon = require "generator.geometry.polygon"

local turned = {}

local pi = math.pi

-- cosine and sine of a fraction of the full turn: exact at the quarters
function turned.circle(t)
  local q = t * 4
  local k = math.floor(q + 0.5)
  local c, s = math.cos((q - k) * pi / 2), math.sin((q - k) * pi / 2)
  k = k % 4
  if k == 0 then return c, s elseif k == 1 then return -s, c elseif k == 2 then return -c, -s end
  return s, -c
end

-- Adds n segments of an arc about (cx, cz), from angle a to b (measured from rho towards z), its ends given exactly.
local function arc(chain, cx, cz, r, a, b, n, first, last)
  for i = 0, n do
    local p = i == 0 and first or i == n and last
    if not p then
      local t = a + (b - a) * i / n
      p = { cx + r * math.cos(t), cz + r * math.sin(t) }
    end
    local before = chain[#chain]
    if not before or before[1] ~= p[1] or before[2] ~= p[2] then chain[#chain + 1] = p end
    p.curved = i > 0 -- what leads to it is no straight segment
  end
  return chain
end

-- The part z1 .. z2 of a circle about (0, cz), walked upwards.
local function bow(chain, r, cz, z1, z2, n)
  local function at(z) return { math.sqrt(math.max(0, (r - z) * (r + z))), cz + z } end
  local a, b = math.asin(z1 / r), math.asin(z2 / r)
  local quarters = (b - a) / (pi / 2) - 1e-9 -- steps double when n does
  return arc(chain, 0, cz, r, a, b, quarters > 1 and n // 2 or quarters > 0.5 and n // 4 or n // 8, at(z1), at(z2))
end

-- Straight segments cut into pieces no longer than `fine`, for those who want many points.
local function refined(chain, fine)
  if not fine then return chain end
  local out = { chain[1] }
  for i = 2, #chain do
    local p, q = chain[i - 1], chain[i]
    local k = q.curved and 1 or math.max(1, math.ceil(math.sqrt((q[1] - p[1]) ^ 2 + (q[2] - p[2]) ^ 2) / fine))
    for j = 1, k do
      out[#out + 1] = j == k and q or { p[1] + (q[1] - p[1]) * j / k, p[2] + (q[2] - p[2]) * j / k }
    end
  end
  return out
end

-- Turns the chain about z.  from, angle in turns (default: the full one); with `closing` (a list of polygons: the
-- profile and its holes) a part of a turn is closed by two flat faces.  stretch = {ky, kz}: factors of y and z.
function turned.add(out, chain, n, o)
  o = o or {}
  chain = refined(chain, o.fine)
  local from, angle = o.from or 0, o.angle or 1
  local steps = math.max(1, math.ceil(n * angle - 1e-9))
  local ky, kz = 1, 1
  if o.stretch then ky, kz = o.stretch[1], o.stretch[2] end
  local ring = {}
  for j = 0, steps do
    local c, s = turned.circle(angle == 1 and j % steps / steps or from + angle * j / steps)
    ring[j] = { c, s }
  end
  local function at(p, j) return { p[1] * ring[j][1], ky * p[1] * ring[j][2], kz * p[2] } end
  for i = 1, #chain - 1 do
    local p, q = chain[i], chain[i + 1]
    local flat = p[2] == q[2]
    for j = 0, steps - 1 do
      local face = { flat = flat }
      if p[1] ~= 0 then
        face[1], face[2] = at(p, j), at(p, j + 1)
      else
        face[1] = at(p, j)
      end
      if q[1] ~= 0 then
        face[#face + 1] = at(q, j + 1)
        face[#face + 1] = at(q, j)
      elseif p[1] ~= 0 then
        face[#face + 1] = at(q, j)
      end
      if #face > 2 then out.faces[#out.faces + 1] = face end
    end
  end
  if angle < 1 and o.closing then
    local holes = { table.unpack(o.closing, 2) }
    for _, t in ipairs(polygon.triangles(o.closing[1], holes)) do
      -- rho, z, phi is left-handed: a triangle counter-clockwise in (rho, z) looks back along phi
      out.faces[#out.faces + 1] = { at(t[1], 0), at(t[2], 0), at(t[3], 0), flat = true, cut = o.cut }
      out.faces[#out.faces + 1] = { at(t[1], steps), at(t[3], steps), at(t[2], steps), flat = true, cut = o.cut }
    end
  end
end

-- The whole outline as one polygon: a chain that ends on the axis is closed along it.
local function outline(chain)
  local p = {}
  for i, v in ipairs(chain) do p[i] = v end
  if #p > 1 and p[1][1] == p[#p][1] and p[1][2] == p[#p][2] then p[#p] = nil end
  return p
end

local function closed(p)
  local chain = {}
  for i, v in ipairs(p) do chain[i] = v end
  chain[#chain + 1] = p[1]
  return chain
end

-- The section of a torus.
local function circle_chain(R, r, n)
  local chain = {}
  for i = 0, n do
    local c, s = turned.circle(i % n / n)
    chain[i + 1] = { R + r * c, r * s, curved = true }
  end
  return chain
end

local function zone(z1, z2, r, n)
  local chain = bow({ { 0, z1 } }, r, 0, z1, z2, n)
  if chain[#chain][1] ~= 0 then chain[#chain + 1] = { 0, z2 } end
  return chain
end

-- name -> function(a, n): the outer chain, holes' chains (clockwise), stretch.  Solids are closed; shells and plates
-- are open unless the surface closes by itself.
local profile = {}

function profile.sphere(a, n) return bow({}, a.r, 0, -a.r, a.r, n) end
function profile.ellipsoid(a, n) return bow({}, a.a, 0, -a.a, a.a, n), nil, { a.b / a.a, a.c / a.a } end
function profile.tube_wall(a) return { { a.r, -a.h / 2 }, { a.r, a.h / 2 } } end
function profile.cylinder(a) return { { 0, -a.h / 2 }, { a.r, -a.h / 2 }, { a.r, a.h / 2 }, { 0, a.h / 2 } } end
function profile.elliptic_cylinder(a) return profile.cylinder { r = a.a, h = a.h }, nil, { a.b / a.a, 1 } end
function profile.cone(a) return { { 0, 0 }, { a.r, 0 }, { 0, a.h } } end
function profile.elliptic_cone(a) return profile.cone { r = a.a, h = a.h }, nil, { a.b / a.a, 1 } end
function profile.frustum(a) return { { 0, 0 }, { a.r_base, 0 }, { a.r_top, a.h }, { 0, a.h } } end
function profile.hemisphere(a, n) return bow({ { 0, 0 } }, a.r, 0, 0, a.r, n) end
function profile.cap(a, n) return bow({ { 0, 0 } }, a.r, a.h - a.r, a.r - a.h, a.r, n) end
function profile.zone(a, n) return zone(a.z1, a.z2, a.r, n) end
function profile.sector(a, n) return bow({ { 0, 0 } }, a.r, 0, a.r - a.h, a.r, n) end
function profile.torus(a, n) return circle_chain(a.R, a.r, n // 2) end

function profile.capsule(a, n)
  return bow(bow({}, a.r, -a.h / 2, -a.r, 0, n), a.r, a.h / 2, 0, a.r, n)
end

-- Points equally far apart in rho.
function profile.paraboloid(a, n)
  local chain, k = {}, math.max(2, n // 4)
  for i = 0, k do chain[i + 1] = { a.r * i / k, a.h * (i / k) ^ 2, curved = true } end
  chain[#chain + 1] = { 0, a.h }
  return chain
end

function profile.tube(a)
  local z = a.h / 2
  return { { a.r_in, -z }, { a.r_out, -z }, { a.r_out, z }, { a.r_in, z }, { a.r_in, -z } }
end

function profile.hollow_sphere(a, n)
  local inner, back = bow({}, a.r_in, 0, -a.r_in, a.r_in, n), {}
  for i, p in ipairs(inner) do back[#inner + 1 - i] = { p[1], p[2], curved = true } end
  return bow({}, a.r_out, 0, -a.r_out, a.r_out, n), { back }
end

function profile.revolve(a)
  local holes = {}
  for i, h in ipairs(a.holes or {}) do holes[i] = closed(polygon.oriented(h, true)) end
  return closed(polygon.oriented(a.profile)), holes
end

local function without_first(f) -- the curved part alone
  return function(a, n)
    local chain = f(a, n)
    table.remove(chain, 1)
    return chain
  end
end

local function disc(r) return { { 0, 0 }, { r, 0 } } end

-- z upwards seen from above is counter-clockwise the other way round: a plate looks up
local function facing_up(f)
  return function(a, n)
    local chain, _, stretch = f(a, n)
    return { chain[2], chain[1] }, nil, stretch
  end
end

local solids = { "sphere", "ellipsoid", "cylinder", "elliptic_cylinder", "cone", "elliptic_cone", "frustum",
  "hemisphere", "cap", "zone", "sector", "torus", "capsule", "paraboloid", "tube", "hollow_sphere" }
local shape = { revolve = profile.revolve,
  ["shell.sphere"] = profile.sphere, ["shell.ellipsoid"] = profile.ellipsoid, ["shell.torus"] = profile.torus,
  ["shell.hemisphere"] = without_first(profile.hemisphere), ["shell.cone"] = without_first(profile.cone),
  ["shell.zone"] = function(a, n) return bow({}, a.r, 0, a.z1, a.z2, n) end,
  ["shell.cylinder"] = function(a) return (a.ends and profile.cylinder or profile.tube_wall)(a) end,
  ["plate.disc"] = facing_up(function(a) return disc(a.r) end),
  ["plate.ellipse"] = facing_up(function(a) return disc(a.a), nil, { a.b / a.a, 1 } end),
  ["plate.annulus"] = facing_up(function(a) return { { a.r_in, 0 }, { a.r_out, 0 } } end) }
for _, name in ipairs(solids) do shape["solid." .. name] = profile[name] end

-- The two part-turns and the sector of a disc.
local part = {
  ["solid.half_cylinder"] = { profile.cylinder, -1 / 4, 1 / 2 },
  ["solid.quarter_cylinder"] = { profile.cylinder, 0, 1 / 4 },
}

-- family: name -> function(out, a, n, options); options.fine: longest straight piece; options.turn = {from, angle}:
-- a cutaway, in turns, closed with flat faces marked `cut`.
turned.family = {}
for name, f in pairs(shape) do -- order does not matter: a table is filled
  turned.family[name] = function(out, a, n, o)
    local chain, holes, stretch = f(a, n)
    local turn = { stretch = stretch, fine = o.fine, cut = true }
    if o.turn then
      turn.from, turn.angle = o.turn[1], o.turn[2]
      if name == "revolve" or string.sub(name, 1, 6) == "solid." then
        turn.closing = { outline(chain) }
        for _, h in ipairs(holes or {}) do
          if h[1][1] == 0 then -- a hole from axis to axis: one outline, along the axis between
            for _, q in ipairs(h) do table.insert(turn.closing[1], q) end
          else
            turn.closing[#turn.closing + 1] = outline(h)
          end
        end
      end
    end
    turned.add(out, chain, n, turn)
    for _, h in ipairs(holes or {}) do
      turned.add(out, h, n, { fine = o.fine, from = turn.from, angle = turn.angle })
    end
  end
end
for name, p in pairs(part) do -- order does not matter: a table is filled
  turned.family[name] = function(out, a, n, o)
    local chain = p[1](a, n)
    turned.add(out, chain, n, { from = p[2], angle = p[3], closing = { outline(chain) }, fine = o.fine })
  end
end
turned.family["plate.sector"] = function(out, a, n, o)
  turned.add(out, { { a.r, 0 }, { 0, 0 } }, n, { angle = math.min(1, a.angle / (2 * pi)), fine = o.fine })
end

return turned
