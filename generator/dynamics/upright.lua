-- upright.lua -- how fast a body of revolution must spin to stay upright on a plane, or a disc to roll on.
--
-- G is the gravity.  Derived by linearising about the upright spin n, with alpha the horizontal part of the axis, h the
-- height of the centre of mass and rho the surface's radius of curvature under it, i the quarter turn about the
-- vertical, C = m G (h - rho):
--     smooth    I1 alpha'' - i I3 n alpha' - C alpha = 0                             stable for (I3 n)^2 > 4 I1 C
--     rolling   A alpha'' - i B n alpha' - C alpha = 0, A = I1 + m h^2, B = I3 + m h rho            (B n)^2 > 4 A C
--     sliding   friction F = -c N slip leaves a vibration mu alone only where it does not slip, h mu = rho n; it damps
--               both where this lies between the two of the smooth plane:     D n^2 > C, D = (I3 - I1 rho/h) rho/h
-- and of a disc of centre circle R and rounding rho, h = R + rho, with lean delta:
--     rolling straight at w3    (I1 + m h^2) delta'' = (m G R - (I3 + m h^2)(I3/I1) w3^2) delta
--     spinning at n on its edge (I1 + m h^2) delta'' = (m G R - (I1 + m h^2) n^2) delta
-- (Routh, Advanced Rigid Dynamics, 241-244; Moffatt, Shimomura, Branicki 2004 for the sliding one; O'Reilly 1996.)
-- Each is a n^2 > c.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local contact = require "generator.dynamics.contact"
local touch_laws = require "generator.dynamics.touch_laws"

local upright = {}

local zero, rate = expr.zero, expr.sym("n", 6)

-- Height of the centre of mass and radius of curvature with z up and down; nil where there is no contact.
local function ends(f)
  local s, c = f.surface, f.centre[3]
  if s.paraboloid then return { -c, s.half[1] }, nil end
  if f.sphere then return { s.rim - c, s.rim }, { s.rim + c, s.rim } end
  if s.half[3] == zero then return nil, nil end
  local rho = s.half[1] ^ 2 / s.half[3]
  return { s.half[3] - c, rho }, { s.half[3] + c, rho }
end

-- By the plane's law: a and c of a n^2 > c, and the condition in words.
local laws = {}
function laws.smooth(I1, I3, _, _, _, C)
  return I3 ^ 2, 4 * I1 * C, "(I3 n)^2 > 4 I1 m G (h - rho)"
end
function laws.rolling(I1, I3, m, h, rho, C)
  return (I3 + m * h * rho) ^ 2, 4 * (I1 + m * h ^ 2) * C,
    "((I3 + m h rho) n)^2 > 4 (I1 + m h^2) m G (h - rho)"
end
function laws.sliding(I1, I3, _, h, rho, C)
  return (I3 - I1 * rho / h) * rho / h, C, "(I3 - I1 rho/h) (rho/h) n^2 > m G (h - rho)"
end

-- A body of revolution about z and its surface on a level plane at rest, with nothing else that acts, and no ball: {e,
-- f = touch_laws.facts, G = gravity towards the plane, I1, I3}; nil and the reason for others.
function upright.revolved(m)
  local e = contact.of(m)
  if not e then return nil, "no plane is touched" end
  local a, f = e.a, touch_laws.facts(m, e)
  local G = -e.spec.weight(a)
  if #m.record.effects > 1 then return nil, "not the plane alone acts on the body" end
  if a.spinning or a.rolling_resistance then return nil, "the plane resists its spinning or rolling" end
  if not ratio.iszero(a.rate) then return nil, "the plane turns" end
  if not f.level then return nil, "the plane is not level" end
  if not f.revolved or f.ball then return nil, "body and surface are not of revolution about one axis z" end
  if ratio.iszero(G) then return nil, "it has no weight" end
  return { e = e, f = f, G = G, I1 = f.I1, I3 = f.I3 }
end

-- A list of {key = "up" | "down" | "straight" | "edge", what, a, c: expressions of the parameters, condition: a n^2 > c
-- in words}; empty where the scene is of no such body.  z up: the body's z is along the normal.
function upright.of(m)
  local at, list = upright.revolved(m), {}
  if not at then return list end
  local a, f, G, mass, I1, I3 = at.e.a, at.f, at.G, m.mass, at.I1, at.I3
  local function put(key, what, x, c, condition)
    list[#list + 1] = { key = key, what = what, a = ratio.tidy(x), c = ratio.tidy(c), condition = condition }
  end
  if f.surface.disc then
    if a.law ~= "rolling" or not ratio.iszero(f.centre[3]) then return list end
    local R, h = f.surface.half[1], f.surface.half[1] + f.surface.rim
    put("straight", "upright and rolling straight at the rate n", (I3 + mass * h ^ 2) * I3, mass * G * R * I1,
      "(I3 + m (R + rho)^2) I3 n^2 > m G R I1")
    put("edge", "upright and spinning about the normal at the rate n", I1 + mass * h ^ 2, mass * G * R,
      "(I1 + m (R + rho)^2) n^2 > m G R")
    return list
  end
  local up, down = ends(f)
  for _, end_up in ipairs { { "up", up }, { "down", down } } do
    local key, low = end_up[1], end_up[2] -- low: height and radius of curvature
    if low and m:double(low[1]) > 0 then
      local x, c, condition = laws[a.law](I1, I3, mass, low[1], low[2], mass * G * (low[1] - low[2]))
      put(key, "spinning upright with z " .. key .. " at the rate n", x, c, condition)
    end
  end
  return list
end

-- The function of the emitted code for an entry: its margin a n^2 - c.
function upright.margin(m, u)
  local a = m:constant("spin_" .. u.key, u.a, "factor of n^2, " .. u.what)
  local c = m:constant("fall_" .. u.key, u.c, "what a n^2 must be above, " .. u.what)
  return { name = "stable_" .. u.key, args = { "m", "n" }, result = true,
    doc = { "Positive where the body is stable " .. u.what .. ", rad/s: what", u.condition ..
      " has on its left less its right side." },
    groups = { { why = u.condition .. " (" .. u.what .. ")", defs = {}, outs = { { result = true,
      expr = a * rate ^ 2 - c } } } } }
end

return upright
