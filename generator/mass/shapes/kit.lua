-- kit.lua -- words that the entries of the catalogue are written in.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"

local kit = {}

local zero = expr.zero

function kit.q(s) return expr.lift(s) end

---- arguments -------------------------------------------------------------------------------------

function kit.length(name) return { name = name, dim = "length", sign = "positive" } end
function kit.vector(name, default) return { name = name, dim = "length", size = 3, default = default } end

-- A list of rows of coordinates: exactly `count` of them, or `least` and more.
-- size: coordinates of a row
function kit.rows(name, size, least, count)
  return { name = name, dim = "length", rows = size, least = least, count = count }
end

function kit.flag(name) return { name = name, flag = true, default = false } end

kit.profile = kit.rows("profile", 2, 3)
kit.holes = { name = "holes", dim = "length", lists = true, rows = 2, least = 3, default = {} }
kit.angle = { name = "angle", dim = "none", sign = "positive" }

function kit.coordinate(name) return { name = name, dim = "length" } end

-- 0 < angle <= 2 pi
function kit.full_turn(a) return { 2 * expr.pi - a.angle, "angle must not exceed 2 pi", true } end

-- -r <= z1 < z2 <= r
function kit.zone_limits(a)
  return { { a.z2 - a.z1, "z2 must be larger than z1" }, { a.z1 + a.r, "z1 must not be below -r", true },
    { a.r - a.z2, "z2 must not exceed r", true } }
end

---- results ---------------------------------------------------------------------------------------

function kit.diagonal(x, y, z) return { x, y, z, zero, zero, zero } end

-- The centroid at the origin.
function kit.centred(measure, sigma, points) return { measure = measure, sigma = sigma, points = points } end

-- Matter in z = 0 symmetric about the ray at the angle h whose sine and cosine are s, c: second moments about its
-- centroid, the variances along the ray and across it given.  The natural frame's x axis is where the arc of half
-- angle h begins.
function kit.fan(s, c, along, across)
  return { c ^ 2 * along + s ^ 2 * across, s ^ 2 * along + c ^ 2 * across, zero, s * c * (along - across), zero, zero }
end

-- On the z axis at height z.
function kit.axial(z) return { zero, zero, z } end

return kit
