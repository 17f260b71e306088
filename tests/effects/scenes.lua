-- scenes.lua -- scenes made at random: bodies, effects with their flags, any number of them a parameter.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     scenes.variants              all ways to write each effect: { effect, name, where, text(S) }
--     scenes.new(seed, share)      S, the source of numbers; share of them that become parameters, 0 to 1
--     scenes.text(S, name, body, list)   the scene; body: "diagonal", "symmetric", "full", "points"; list: of variants
--     scenes.parts(S, body, list)        the same in parts, which scenes.joined(name, parts) puts together
--     S.renamed, S.mirrored, S.others, S.scale     the same scene otherwise: see below
--     scenes.fits(list)            can these variants be in one scene?  Then where the origin is: "point" or "centroid"
--
-- where: as in rows.lua.

local rows = require "tests.effects.rows"

local scenes = {}

local S = {}
S.__index = S

function scenes.new(seed, share) return setmetatable({ state = seed % 2147483646 + 1, share = share or 0 }, S) end

-- A whole number in [1, n] (Park and Miller's generator with 48271).
function S:random(n)
  self.state = self.state * 48271 % 2147483647
  return self.state * n // 2147483647 + 1
end

-- The same in other units: how many of them one is.
local OTHER = { m = { "mm", 1000 }, kg = { "g", 1000 }, ["m/s^2"] = { "mm/s^2", 1000 }, ["N m"] = { "N mm", 1000 },
  ["N m s"] = { "N mm s", 1000 }, ["1/s"] = { "1/min", 60 }, ["kg m^2"] = { "kg cm^2", 10000 },
  ["kg/m"] = { "g/mm", 1 }, ["N/m"] = { "mN/mm", 1 }, ["rad/s"] = { "rad/min", 60 } }
-- Exponents of length, mass and time.
local POWERS = { m = { 1, 0, 0 }, kg = { 0, 1, 0 }, ["m/s^2"] = { 1, 0, -2 }, ["N m"] = { 2, 1, -2 },
  ["N m s"] = { 2, 1, -1 }, ["1/s"] = { 0, 0, -1 }, ["rad/s"] = { 0, 0, -1 }, ["kg m^2"] = { 2, 1, 0 },
  ["A m^2"] = { 2, 0, 0 }, T = { 0, 1, -2 } }

-- The value x of the unit where lengths, masses and times are so many times as long: scale = {length, mass, time}.
function scenes.scaled(scale, x, unit)
  local n = POWERS[unit]
  return x * scale[1] ^ n[1] * scale[2] ^ n[2] * scale[3] ^ n[3]
end

-- A number of three digits (S.digits: of so many) with the unit (nil: none), low .. high, as a literal or the name of a
-- parameter.  S.others: with other units; S.scale: see scenes.scaled.
function S:num(low, high, unit)
  local digits = self.digits or 3
  local parts = math.tointeger(10^digits)
  local x = string.format("%." .. digits .. "g", low + (high - low) * self:random(parts) / parts)
  local literal = self:random(1000) > 1000 * self.share
  if self.scale and unit then x = string.format("%.17g", scenes.scaled(self.scale, tonumber(x), unit)) end
  if self.others and OTHER[unit] then
    return string.format("quantity(%.10g, \"%s\")", tonumber(x) * OTHER[unit][2], OTHER[unit][1])
  end
  if literal then return x end
  local name = "par" .. #self.params + 1
  self.params[#self.params + 1] = string.format("local %s = param(%q, %s%s)\n", name, name, x,
    unit and ", \"" .. unit .. "\"" or "")
  return name
end

local function negative(x) return x:match "^%-(.*)" or "-" .. x end

-- Three components, renamed with the axes: x is y, y is z, z is x where S.renamed.  S.mirrored: seen in a mirror across
-- x, in which a polar vector (a place, a velocity, a force) has its x the other way round, and an axial one (a rate, a
-- torque, a magnetic field) its y and z; kind: "polar", "axial", or nil for what a mirror leaves alone.
function S:axes(x, y, z, kind)
  if self.renamed then x, y, z = z, x, y end
  if self.mirrored and kind == "polar" then x = negative(x) end
  if self.mirrored and kind == "axial" then y, z = negative(y), negative(z) end
  return "{" .. x .. ", " .. y .. ", " .. z .. "}"
end

-- Three of them, both signs.
function S:vec(size, unit, kind)
  local list = {}
  for i = 1, 3 do
    local x = self:num(size / 8, size, unit)
    list[i] = self:random(2) == 1 and x or "-" .. x
  end
  return self:axes(list[1], list[2], list[3], kind)
end

scenes.variants = rows.variants

local alone = { gravity_gradient = true, inertia_rate = true, dissipation = true, rotating_frame = true,
  translation = true, control = true, plane = true }
-- What cannot stand beside a plane (dynamics/contact.lua).
local off = { translation = true, rotating_frame = true, inertia_rate = true, dissipation = true, wheel = true,
  solar_pressure = true }

function scenes.fits(list)
  local point, centroid, plane, air, seen = false, false, false, false, {}
  for _, v in ipairs(list) do
    point = point or v.where == "point"
    plane, air = plane or v.where == "plane", air or off[v.effect]
    centroid = centroid or v.where == "centroid" or v.where == "flight" or v.where == "plane"
    if alone[v.effect] and seen[v.effect] then return nil end
    seen[v.effect] = true
  end
  if point and centroid or plane and air then return nil end
  return centroid and "centroid" or point and "point" or nil, true
end

local BODIES = {
  diagonal = function(s)
    local x, y, z = s:num(0.8, 1.2, "m"), s:num(1.6, 2.2, "m"), s:num(2.5, 3, "m")
    if s.renamed then x, y, z = z, x, y end
    return "solid.box { x = " .. x .. ", y = " .. y .. ", z = " .. z .. ", mass = " .. s:num(2, 4, "kg") .. " }"
  end,
  symmetric = function(s)
    return "solid.cylinder { r = " .. s:num(0.8, 1.2, "m") .. ", h = " .. s:num(2, 3, "m") .. ", mass = " ..
      s:num(2, 4, "kg") .. " }" .. (s:random(2) == 1 and ":turned { axis = {1, 2, 0}, angle = 0.7 }" or "")
  end,
  axial = function(s) -- about z, its centre of mass above that of the shapes
    return "(solid.cylinder { r = " .. s:num(0.8, 1.2, "m") .. ", h = " .. s:num(2, 3, "m") .. ", mass = " ..
      s:num(2, 4, "kg") .. " } + solid.cylinder { r = 0.5, h = 1, mass = " .. s:num(0.3, 0.6, "kg") ..
      " }:at { 0, 0, 0.6 })"
  end,
  points = function(s) -- no zero among the products, no round number anywhere
    local list = {}
    for i = 1, 6 do
      list[i] = "{" .. s:num(0.5, 1, "kg") .. ", " .. s:vec(0.6, "m", "polar"):sub(2)
    end
    return "points { " .. table.concat(list, ", ") .. " }"
  end,
  full = function(s)
    local x, y, z = "1", s:num(1.6, 2.2, "m"), "3"
    if s.renamed then x, y, z = z, x, y end
    local m, at = s:num(0.3, 0.6, "kg"), string.sub(s:axes("1", "0.5", "1", "polar"), 2)
    return "(solid.box { x = " .. x .. ", y = " .. y .. ", z = " .. z .. ", mass = 3 } + points { {" .. m .. ", " ..
      at .. " })"
  end,
}

-- The parts of a scene: { params, body, origin, effects (a list), initial }, all as text.  origin: as scenes.fits says;
-- nil: the centroid or a point, at random.
function scenes.parts(s, body, list, origin)
  s.params = {}
  local p = { effects = {}, body = BODIES[body](s) }
  origin = origin or (scenes.fits(list)) or s:random(2) == 1 and "centroid" or "point"
  local flies, upright = false, "1"
  for i, v in ipairs(list) do
    if v.where == "plane" then upright = "3" end -- a paraboloid turns its closed side to the plane
    p.effects[i] = "effect." .. v.effect .. " { " .. v.text(s) .. " }"
    flies = flies or v.where == "flight"
  end
  p.origin = origin == "point" and s:axes("0.1", "0.2", "-0.3", "polar") or "\"centroid\""
  local q = s:axes("0." .. s:random(9), "-0." .. s:random(9), "0." .. s:random(9), "axial")
  p.initial = "omega = " .. s:axes("0.7", "-0.3", "0.9", "axial") .. ", attitude = {" .. upright .. ", " ..
    string.sub(q, 2) .. (flies and ", position = " .. s:axes("0.1", "0", "1", "polar") .. ", velocity = " ..
      s:axes("0.5", "0.2", "-0.1", "polar") or "")
  p.params = table.concat(s.params)
  return p
end

function scenes.joined(name, p)
  return p.params .. "return scene {\n  name = \"" .. name .. "\",\n  body = " .. p.body .. ",\n  origin = " ..
    p.origin .. ",\n  effects = {\n    " .. table.concat(p.effects, ",\n    ") .. "\n  },\n  initial = { " ..
    p.initial .. " },\n}\n"
end

function scenes.text(s, name, body, list, origin) return scenes.joined(name, scenes.parts(s, body, list, origin)) end

-- A variant drawn at random.  A plane has 24 of them and its scenes take longest: three draws of four are drawn again.
function scenes.draw(random)
  local v
  repeat v = scenes.variants[random:random(#scenes.variants)] until v.where ~= "plane" or random:random(4) == 1
  return v
end

return scenes
