-- start.lua -- does `initial` say of a body on a plane what the plane leaves open?
--
-- The height of the centre of mass follows from the attitude, and so does the speed at which it rises from attitude and
-- rates; of a body that rolls the whole velocity does: V = U - w x r.  None of them is a state, so a number that says
-- otherwise would be dropped in silence.  A component of 0 along the normal says nothing: initial = {0.1, 0, 0} is a
-- place on a level plane.
-- Slack: `rounded` of the height, or of the speeds that are added up.  It is what numbers of four digits leave, so a
-- height or speed that was worked out by hand is right; another radius, unit, sign or a body in the air is not.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local context = require "generator.dynamics.context"

local start = {}

local rounded = 1e-3

local function norm(v) return math.sqrt(vec.dot(v, v)) end

local function shown(v) return string.format("{%.6g, %.6g, %.6g} m/s", v[1] + 0.0, v[2] + 0.0, v[3] + 0.0) end

-- As doubles, inertial axes: the normal; the arm from the centre of mass to the contact point; w x arm; U, the velocity
-- of the plane under it.
local function contact_of(m, e, position)
  local a, c = e.a, context.dry(m)
  c.q = m.attitude
  local k = e.spec.place(a, c, { n = a.normal }, function(_, v) return v end)
  local out = vec.transpose(k.back)
  local arm = vec.matvec(out, k.r)
  local moved = vec.scale(a.rate, vec.cross(a.normal, vec.add(position, arm)))
  local function numbers(v) return vec.map(v, function(x) return m:double(x) end) end
  return numbers(a.normal), numbers(arm), numbers(vec.matvec(out, vec.cross(m.omega, k.r))), numbers(moved)
end

-- A component along the normal that is neither 0 nor what follows, within the slack.
local function contradicts(given, follows, size)
  return math.abs(given) > 2.0 ^ -40 * size and math.abs(given - follows) > rounded * size
end

local function place(d, m, e, n, arm)
  local position = vec.map(m.given.position, function(x) return m:double(x) end)
  local given, height = vec.dot(n, position), -vec.dot(n, arm)
  if not contradicts(given, height, math.max(math.abs(given), norm(arm))) then return true end
  d:error(d:locate(m.given.line, "position"), "initial", string.format("position must have the centre of mass as " ..
    "high as the attitude puts it where the body touches the plane (line %d): %.6g m above, or 0, which leaves it " ..
    "to the attitude (a body that starts in the air needs effect.translation, and impact of effect.plane)", e.line,
    height), string.format("%.6g m", given))
  return false
end

local function motion(d, m, e, velocity, contact)
  local n, turning, moved = contact[1], contact[3], contact[4]
  local given = vec.map(velocity, function(x) return m:double(x) end)
  local size, line = math.max(norm(given), norm(turning), norm(moved)), d:locate(m.given.line, "velocity")
  local rise, follows = vec.dot(n, given), 0.0 - vec.dot(n, turning)
  if e.a.law == "rolling" then
    local rolled = vec.sub(moved, turning)
    local along = vec.sub(vec.sub(given, rolled), vec.scale(rise - follows, n))
    if norm(along) <= rounded * size and not contradicts(rise, follows, size) then return true end
    d:error(line, "initial", "velocity must be that of rolling, V = U - w x r of effect.plane (line " .. e.line ..
      "): omega and attitude give " .. shown(rolled) .. " (leave velocity out, or give the omega that rolls so)",
      shown(given))
    return false
  end
  if not contradicts(rise, follows, size) then return true end
  d:error(line, "initial", string.format("velocity must keep the body on the plane (line %d): omega and attitude " ..
    "give %.6g m/s along its normal, or 0, which leaves it to them", e.line, follows), string.format("%.6g m/s", rise))
  return false
end

-- Reports what contradicts the plane e at the start: false.  velocity: what `initial` gives, or nil.
function start.check(d, m, e, velocity)
  local position = m.given.position
  if not position and not velocity then return true end
  local none = { expr.zero, expr.zero, expr.zero }
  local contact = { contact_of(m, e, position or none) }
  local fine = not position or place(d, m, e, contact[1], contact[2])
  return (not velocity or motion(d, m, e, velocity, contact)) and fine
end

return start
