-- meridian.lua -- a disc on a plane, in the axes of its lowest point.
--
-- The meridian is the plane of the body's axis z and the normal g.  With rho = sqrt(g1^2 + g2^2) its axes are
-- t = (g1, g2, 0)/rho, s = z x t and z.  In them, R the radius of the disc's centre circle and c its centre on z,
--     g = (rho, 0, g3),   far = c - y = (-R, 0, c3),   r = far - rim g
-- and far is constant.  They turn at the rate (w_t, w_s, g3 w_t/rho), so
--     k = (w_t, w_s, g3 w_t/rho) x far = (c3 w_s, -w_t (c3 + R g3/rho), R w_s)
-- in which nothing cancels near flat, as it does between w x (c - y) and y'.  s lies along the plane, with the
-- components (E2, -E1).z/rho along e1 and e2; so does h = s x g = (g3, 0, -rho), with those of s turned by a
-- right angle.  As r.s = 0 and r.g = -height,
--     (w x r).s = w_z r_t - w_t r_z,   (w x r).h = w.(s (r.g) - g (r.s)) = -height w_s
-- On a plane whose normal is inertial z
--     rho = 2 sqrt((qw^2 + qz^2) (qx^2 + qy^2)),   g3 = (qw^2 + qz^2) - (qx^2 + qy^2)
-- where rho has all its digits however flat the disc lies.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"

local meridian = {}

local zero, one = expr.zero, expr.one
local letters = { "t", "s", "z" }

-- Is the surface a disc about an axis z through the centre of mass?
function meridian.fits(s, origin)
  return s.disc and ratio.iszero(s.at[1] - origin[1]) and ratio.iszero(s.at[2] - origin[2])
end

-- The root in rho, g3, and what the root is of rho: 1 or 1/2.
local function lean(n, q, up, name)
  if n[1] ~= zero or n[2] ~= zero then return expr.sqrt(up[1] ^ 2 + up[2] ^ 2), up[3], one end
  local near, off = q[1] ^ 2 + q[4] ^ 2, q[2] ^ 2 + q[3] ^ 2
  return expr.sqrt(name("lean_square", { near * off })[1]), n[3] * (near - off), expr.num(R.half)
end

-- Adds to k = {n, e1, e2} what plane.place and plane.axes do, in these axes; and place, which is k above.
function meridian.place(a, c, k, name)
  local w = c.w
  k.back = vec.transpose(vec.rotation(c.q))
  local up = vec.matvec(k.back, k.n)
  local root, g3, part = lean(a.normal, c.q, up, name)
  root, g3 = name("lean", { root })[1], name("up_z", { g3 })[1]
  local over, rho = name("over", { one / root })[1], name("up_t", { root / part })[1]
  local function unit(prefix, x) return name(prefix, { x * part * over })[1] end
  local t1, t2 = unit("radial_x", up[1]), unit("radial_y", up[2])
  local s1, s2 = unit("level_1", vec.dot(k.back[3], k.e2)), unit("level_2", -vec.dot(k.back[3], k.e1))
  function k.into(v) return { t1 * v[1] + t2 * v[2], t1 * v[2] - t2 * v[1], v[3] } end
  function k.out(v) return { t1 * v[1] - t2 * v[2], t2 * v[1] + t1 * v[2], v[3] } end
  k.letters, k.w, k.up = letters, name("w_", k.into(w), letters), { rho, zero, g3 }
  local radius = c.constant("radius", a.surface.half[1], "radius of the disc's centre circle, m")
  local share = c.constant("half_radius", a.surface.half[1] * part, "half of it, m")
  local c3 = c.constant("centrez", ratio.tidy(a.surface.at[3] - c.origin[3]),
    "centre of the surface from the centre of mass, z, m")
  k.rim = c.constant("rim", a.surface.rim, "radius of the rounded edge, m")
  k.own, k.far = { -a.surface.half[1], zero, a.surface.at[3] - c.origin[3] }, { -radius, zero, c3 }
  k.r = name("arm_", vec.sub(k.far, vec.scale(k.rim, k.up)), letters)
  k.place = { c3 * k.w[2], -k.w[1] * (c3 + share * g3 * over), radius * k.w[2] }
  k.side = { zero, name("side", { c3 * rho + radius * g3 })[1], zero }
  local height = name("height", { k.rim + radius * rho - c3 * g3 })[1]
  local function along(s, h) return s * s1 + h * s2, s * s2 - h * s1 end
  function k.span(x1, x2)
    local s, h = x1 * s1 + x2 * s2, x1 * s2 - x2 * s1
    return { h * g3, s, -h * rho }
  end
  function k.reach() return along(zero, -k.side[2]) end
  function k.drift()
    return along(name("drift_s", { k.w[3] * k.r[1] - k.w[1] * k.r[3] })[1], name("drift_h", { -height * k.w[2] })[1])
  end
  k.height = height
  return k
end

return meridian
