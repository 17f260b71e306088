-- panels.lua -- what can be drawn of a motion: each picture's panels, or the reason why the motion has none.
--
-- A course is what the pictures are made from: {samples, body, conserved = {law = true}, sequence = of Euler's angles,
-- kinetic = function(sample) or nil, along = I v along the body's axes, momentum = L of a sample along them, carries =
-- does a rotor or wheel have momentum of its own?, error = {names of two runs, ts, curves = {{name, values}, ..}},
-- column = are the samples rows of a file?, asked = {[what a user wrote] = panels of its columns (times.asked)}}.  A
-- sample has t and, where they are known, q, w, space (w in inertial axes), L, energy, r (of a body on a plane: its
-- centre of mass), N and point: the reaction of that plane and where the body touches it; asked = values of those
-- columns.  course.plane: its normal, e1 and e2; course.lost: when N becomes 0, where the motion ends.
-- A body: {moments (ascending), axes (rows), kind, rod, k = the axis of a symmetric one}; nil without a scene.
-- Whether a motion is a free body's is seen from its numbers, so rows of a file are judged, too.
-- SPDX-License-Identifier: GPL-3.0-or-later

local rotation = require "generator.attitude.rotation"
local cones = require "generator.plot.cones"
local plane = require "generator.plot.plane"
local quadric = require "generator.plot.quadric"
local space = require "generator.plot.space"
local times = require "generator.plot.times"
local trails = require "generator.plot.trails"

local panels = { names = { "rates", "attitude", "axes", "euler", "energy", "momentum", "L_body", "polhode",
  "herpolhode", "cones", "phase", "path", "contact", "normal_force", "error" } }

local still = 1e-6 -- what changes by less is constant on paper

local list = times.list

-- ---- what a motion lacks ----

local absent = { w = { "wx, wy, wz", "the body is a point: it does not turn" },
  q = { "qw, qx, qy, qz", "the scene has no attitude" }, L = { "Lx, Ly, Lz", "the scene has no attitude, so no L" },
  r = { "rx, ry, rz", "nothing moves the body: it turns about a fixed point" }, energy = { "energy", "" },
  N = { "N", "the body touches no plane (effect.plane)" },
  point = { "contact_point_x, contact_point_y, contact_point_z", "the body touches no plane (effect.plane)" } }

-- Why a picture that needs these parts of the samples cannot be drawn, or nil.
local function lacks(course, ...)
  for _, part in ipairs { ... } do
    if not course.samples[1][part] then
      return course.column and "the file has no columns " .. absent[part][1] or absent[part][2]
    end
  end
  return nil
end

-- A vector of each sample along the principal axes.
local function principal(course, f)
  local a = course.body.axes
  return list(course.samples, function(s)
    local v = f(s)
    return { space.dot(a[1], v), space.dot(a[2], v), space.dot(a[3], v) }
  end)
end

-- Why there are no moments to draw with, or nil.
local function no_body(course)
  local wrong = lacks(course, "w")
  if wrong then return wrong end
  if not course.body then return "it needs the body's moments: name the SCENE, too" end
  if course.body.rod then return "the body is a rod: it has no moment about its line" end
  return nil
end

-- Why w does not run as a free body's, or nil.
local function not_free(course)
  local wrong = no_body(course)
  if wrong then return wrong end
  local I, w = course.body.moments, principal(course, function(s) return s.w end)
  local T = list(w, function(v) return I[1] * v[1] ^ 2 + I[2] * v[2] ^ 2 + I[3] * v[3] ^ 2 end)
  local L = list(w, function(v) return space.length { I[1] * v[1], I[2] * v[2], I[3] * v[3] } end)
  if T[1] == 0 then return "the body is at rest" end
  if course.carries then return "the motion is not a free body's: a rotor or a wheel has momentum of its own" end
  local much = math.max(times.change(T), times.change(L))
  if much > still then
    return "the motion is not a free body's: its energy of rotation or |I w| changes by " .. times.number(100 * much) ..
      " %"
  end
  return nil
end

-- Why the lines of a free sphere's motion are no picture, or nil.
local function round(course)
  return course.body.kind == "sphere" and "all moments are equal: w stays where it is, in the body and in space" or nil
end

-- ---- the pictures ----

-- reasons[name](course) -> why the motion has no such picture, or nil; makers[name](course), of one that it has -> its
-- panels {title =, note =, draw = function(d, box)}.
local reasons, makers = {}, {}

function reasons.rates(course) return lacks(course, "w") end
makers.rates = times.rates

function reasons.attitude(course) return lacks(course, "q") end
function makers.attitude(course) return { times.quaternion(course) } end

reasons.axes = reasons.attitude
function makers.axes(course)
  local body = course.body
  local axes = { { { 1.0, 0.0, 0.0 }, "cx", "x" }, { { 0.0, 1.0, 0.0 }, "cy", "y" }, { { 0.0, 0.0, 1.0 }, "cz", "z" } }
  local title = "Paths of the body's axes in space"
  if body and body.kind == "symmetric" then
    axes, title = { { space.unit(body.k), "cx", "" } }, "Path of the axis of symmetry in space"
  end
  return { { title = title, draw = function(d, box) trails.draw(d, box, course.samples, axes) end } }
end

function reasons.euler(course) return lacks(course, "q") end
function makers.euler(course) return { times.euler(course) } end

function reasons.energy(course) return lacks(course, "energy") end
makers.energy = times.energy

function reasons.momentum(course) return lacks(course, "L") end
makers.momentum = times.momentum

function reasons.L_body(course) return lacks(course, "q", "L") end
function makers.L_body(course) return { times.momentum_body(course) } end

function reasons.polhode(course) return not_free(course) or round(course) end
function makers.polhode(course)
  local I, w = course.body.moments, principal(course, function(s) return s.w end)
  local T2, a = 0.0, {}
  for i = 1, 3 do T2 = T2 + I[i] * w[1][i] ^ 2 end
  for i = 1, 3 do a[i] = math.sqrt(T2 / I[i]) end
  return { { title = "Polhode on the ellipsoid of energy", note = "moments I_1 ≤ I_2 ≤ I_3; half axes " ..
    times.number(a[1]) .. ", " .. times.number(a[2]) .. ", " .. times.number(a[3]) .. " rad/s",
    draw = function(d, box)
      quadric.draw(d, box, { a = a, c = I, points = w, names = { "ω_1", "ω_2", "ω_3" } })
    end } }
end

function reasons.herpolhode(course) return not_free(course) or lacks(course, "q", "L") or round(course) end
function makers.herpolhode(course)
  local w = principal(course, function(s) return s.w end)
  local least, most = plane.radii(course.body.moments, w[1])
  return { { title = "Herpolhode in the invariable plane", note = "ω across L; between " .. times.number(least) ..
    " and " .. times.number(most) .. " rad/s", draw = function(d, box)
      plane.draw(d, { box = box, points = plane.herpolhode(course.samples), circles = { least, most },
        x = { "ω_a", "rad/s" }, y = { "ω_b", "rad/s" } })
    end } }
end

function reasons.cones(course)
  local wrong = no_body(course)
  if wrong then return wrong end
  if course.body.kind ~= "symmetric" then
    return (round(course) or "no two moments are equal") .. "; cones are those of a symmetric top"
  end
  local no = not_free(course)
  if no then return no end
  local s = course.samples[1]
  local c = cones.of(s.w, course.along(s.w), course.body.k)
  return math.min(c.body, c.space) < 1e-6 and "w lies in the axis of symmetry, or across it: there is no cone" or nil
end
function makers.cones(course)
  local s = course.samples[1]
  local c = cones.of(s.w, course.along(s.w), course.body.k)
  return { { title = "Cones: the body's rolls on the one in space", note = "half angles: body " ..
    times.number(math.deg(c.body)) .. "°, space " .. times.number(math.deg(c.space)) .. "°" ..
    (cones.opened(c) > 1 and "; drawn " .. times.number(cones.opened(c)) .. " times as large" or ""),
    draw = function(d, box) cones.draw(d, box, c) end } }
end

function reasons.phase(course)
  local wrong = no_body(course)
  if wrong then return wrong end
  if course.body.kind == "sphere" then return round(course) end
  if course.carries and not course.samples[1].L then return "it needs L: the scene has no attitude" end
  local L = list(course.samples, course.momentum)
  if space.length(L[1]) == 0 then return "there is no angular momentum" end
  local much = times.change(list(L, space.length))
  return much > still and "|L| changes by " .. times.number(100 * much) .. " %: the momentum leaves its sphere" or nil
end
function makers.phase(course)
  local I, L = course.body.moments, principal(course, course.momentum)
  local size, c, plain = space.length(L[1]), {}, true
  for i = 1, 3 do c[i] = 1 / I[i] end
  for i, s in ipairs(course.samples) do -- with a rotor, energy has other lines
    local own, v = course.along(s.w), course.momentum(s)
    plain = plain and space.length { own[1] - v[1], own[2] - v[2], own[3] - v[3] } < still * size
    L[i] = { L[i][1] / size, L[i][2] / size, L[i][3] / size }
  end
  return { { title = "Phase portrait on the sphere of momentum", note = (plain and "lines of equal energy; " or "") ..
    "|L| = " .. times.number(size) .. " N m s", draw = function(d, box)
      quadric.draw(d, box, { a = { 1.0, 1.0, 1.0 }, c = plain and c or nil, points = L,
        names = { "L_1", "L_2", "L_3" } })
    end } }
end

function reasons.path(course) return lacks(course, "r") end
function makers.path(course)
  local ts, curves = list(course.samples, function(s) return s.t end), {}
  for k, name in ipairs { "x", "y", "z" } do
    curves[k] = { name, list(course.samples, function(s) return s.r[k] end) }
  end
  local across = { 1, 2 } -- the two coordinates that change most
  local spread = list(curves, function(c) return (times.extent(c[2])) end)
  if spread[3] > spread[1] and spread[1] < spread[2] then
    across = { 2, 3 }
  elseif spread[3] > spread[2] then
    across = { 1, 3 }
  end
  local x, y = curves[across[1]], curves[across[2]]
  local points = {}
  for i = 1, #ts do points[i] = { x[2][i], y[2][i] } end
  return { times.panel(ts, { title = "Centre of mass", y = { "x, y, z", "m" }, curves = curves }),
    { title = "Path of the centre of mass", draw = function(d, box)
      plane.draw(d, { box = box, points = points, x = { x[1], "m" }, y = { y[1], "m" } })
    end } }
end

function reasons.contact(course)
  return lacks(course, "point") or
    (not course.plane and "it needs the plane's axes: name the SCENE, too, which has effect.plane" or nil)
end
function makers.contact(course)
  local e1, e2 = course.plane.e1, course.plane.e2
  local level = e1[1] == 1 and e2[2] == 1
  local points = list(course.samples, function(s) return { space.dot(s.point, e1), space.dot(s.point, e2) } end)
  local function words(v)
    return "(" .. table.concat(list(v, times.number), ", ") .. ")"
  end
  return { { title = course.plane.flies and "Path of the lowest point over the plane" or
    "Path of the contact point on the plane", note = not level and "e_1 = " .. words(e1) ..
    ", e_2 = " .. words(e2) or nil, draw = function(d, box)
      plane.draw(d, { box = box, points = points, x = { level and "x" or "s_1", "m" },
        y = { level and "y" or "s_2", "m" }, stop = course.lost and "contact lost" })
    end } }
end

function reasons.normal_force(course) return lacks(course, "N") end
function makers.normal_force(course) return { times.reaction(course) } end

function reasons.error(course)
  if course.error then return nil end
  return course.column and "a file has one motion" or "it needs two runs: --method A,B or --step H,H/2"
end
function makers.error(course) return { times.difference(course) } end

-- ---- for the command ----

-- The reason why a picture has no meaning for the motion, or nil.
function panels.refused(course, name) return reasons[name] and reasons[name](course) end

-- A sheet of what has a meaning, without saying the same twice.
function panels.usual(course)
  local names = {}
  local function put(name)
    local fits = not reasons[name](course)
    if fits then names[#names + 1] = name end
    return fits
  end
  local touches = not (course.plane and course.plane.flies) and put "contact"
  put "normal_force"
  if not touches then put "path" end
  put "rates"
  put "attitude"
  put "axes"
  local free = not course.samples[1].w or not not_free(course)
  if not put "cones" then put "polhode" end
  put "herpolhode"
  if not free or not course.samples[1].L then put "phase" end
  if course.error then put "error" end
  if not free then put "euler" end
  if not (course.conserved["T+V"] and free and course.samples[1].energy and times.exact(course)) then put "energy" end
  if not free then put "momentum" end
  return names
end

-- The panels of the pictures, and of the columns that a user asks for, in their order.
function panels.of(course, names)
  local out = {}
  for i, name in ipairs(names) do
    out[i] = makers[name] and makers[name](course) or list(course.asked[name], function(one)
      return times.asked(course, one)
    end)
  end
  return out
end

-- The parts of a sample that follow from others.
function panels.complete(s)
  if s.q and s.w then s.space = rotation.apply(s.q, s.w) end
  return s
end

return panels
