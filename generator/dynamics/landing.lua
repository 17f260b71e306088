-- landing.lua -- a body in the air above a plane: how far it is from it, and what happens when they meet.
--
-- In body axes: g = `up`, the plane's normal; d = `arm`, from the centre of mass to the lowest point; v the velocity of
-- that point against the plane's; p = P/m, the impulse over the mass.
--     gap = n.r + g.d        p changes v by K p,   K = 1 + m [I^-1 (d x ..)] x d
-- The impact is that of Chatterjee and Ruina (J. Appl. Mech. 65 (1998) 939), in the space of impulses: from
--     p1 = -(v_n/g.K g) g  (takes the normal velocity, without friction)      p2 = -K^-1 v  (takes all of it)
-- to   p = (1 + e) p1 + kappa (1 + e_t) (p2 - p1)
-- kappa = 1, or where |p_t| would be more than mu p_n the one that makes them equal.  For 0 <= e <= 1, |e_t| <= 1 no
-- energy is made.  All of it is 0 where the point leaves the plane.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local context = require "generator.dynamics.context"
local start = require "generator.dynamics.start"
local state = require "generator.dynamics.state"
local touch = require "generator.dynamics.touch"

local landing = {}

-- Bounds of maxima, in m/s: the largest float and less than any speed that is meant.
local huge, tiny = expr.num(R.new(2) ^ 127), expr.num(R.new(2) ^ -100)

local function at_least(x, low) return expr.call("clamp", x, low, huge) end

-- A start below the plane by more than rounding, reported: false.
local function above(d, m, e, lever)
  local a, p = e.a, m.given.position
  local function number(v) return m:double(vec.dot(a.normal, v)) end
  local height, down = number(p), number(lever)
  if height + down >= -(2.0 ^ -40) * (math.abs(height) + math.abs(down)) then return true end
  d:error(m.given.line, "initial", "position must not put the body below the plane (line " .. e.line .. ")",
    string.format("its lowest point %.6g m below", -(height + down)))
  return false
end

-- Where a scene in the air begins: without an initial position on the plane, with the velocity that it has there.
-- False after an error.
function landing.place(d, m)
  local e, given = m.record.landing, m.given
  if not e then return true end
  local a, c, none = e.a, context.dry(m), { expr.zero, expr.zero, expr.zero }
  c.q = m.attitude
  local k = e.spec.place(a, c, { n = a.normal }, function(_, v) return v end)
  local out, v = vec.transpose(k.back), given.velocity or none
  local function along(x) return vec.scale(x, a.normal) end
  local lever = vec.matvec(out, k.r)
  if given.position then return above(d, m, e, lever) end
  if not start.check(d, m, e, given.velocity) then return false end
  local turning = vec.matvec(out, vec.cross(m.omega, k.r))
  local position = along(-vec.dot(a.normal, lever))
  if a.law == "rolling" then
    v = vec.sub(vec.scale(a.rate, vec.cross(a.normal, vec.add(position, lever))), turning)
  else
    v = vec.sub(v, along(vec.dot(a.normal, vec.add(v, turning))))
  end
  given.position, given.velocity = vec.map(position, ratio.tidy), vec.map(v, ratio.tidy)
  return true
end

-- The contact's vectors as definitions of a group.
local function geometry(m, e, c, group)
  local name = touch.namer(m, group, {})
  local k = { n = vec.map(e.a.normal, function(x, i)
    local letter = string.sub("xyz", i, i)
    return c.constant("plane" .. letter, ratio.tidy(x), "normal of the plane, " .. letter)
  end) }
  return e.spec.place(e.a, c, k, name), name
end

-- The height of the lowest point, m.
function landing.gap(m)
  local e, c, group = m.record.landing, context.of(m), { why = "gap = n.r + g.d, d to the lowest point", defs = {} }
  local k = geometry(m, e, c, group)
  group.outs = { { result = true, expr = vec.dot(k.n, state.r) + vec.dot(k.up, k.r) } }
  return { name = "gap", args = { "m", "x" }, result = true,
    groups = { group },
    doc = { "Distance of the body's lowest point from the plane, m; negative below it.  |q| = 1." } }
end

-- K, six entries.
-- K = 1 + m [I^-1 (d x ..)] x d is symmetric, so six of its columns' nine entries do.
local function compliance(m, c, name, d)
  local columns = {}
  for j = 1, 3 do
    local e = { expr.zero, expr.zero, expr.zero }
    e[j] = expr.one
    columns[j] = vec.add(e, vec.cross(touch.inverse_per_mass(m, c, function(_, v) return v end, vec.cross(d, e)), d))
  end
  return name("K", vec.map(vec.pair, function(p) return columns[p[2]][p[1]] end))
end

-- NAME_impact: the state behind the impact, w + m I^-1 (d x p) and v + R(q) p, and the impulse m p.g along the normal.
function landing.impact(m)
  local e, c = m.record.landing, context.of(m)
  local a, group = e.a, { why = "impact at the lowest point: p = (1 + e) p1 + kappa (1 + e_t) (p2 - p1)", defs = {} }
  local law = a.impact
  local k, name = geometry(m, e, c, group)
  local v = vec.add(vec.matvec(k.back, state.v), vec.cross(state.w, k.r))
  if a.rate ~= expr.zero then
    local rate = c.constant("Omega_plane", a.rate, "rate of the plane, rad/s")
    v = vec.sub(v, vec.scale(rate, vec.cross(k.up, vec.add(vec.matvec(k.back, state.r), k.r))))
  end
  v = name("touch_v", v)
  local restitution = c.constant("restitution", law.restitution, "restitution of the impact")
  local K = compliance(m, c, name, k.r)
  local push = name("push", { at_least(-vec.dot(k.up, v), expr.zero) / vec.dot(k.up, vec.apply(K, k.up)) })[1]
  local normal = name("normal", { (1 + restitution) * push })[1]
  local p = vec.scale(normal, k.up)
  if law.friction ~= expr.zero then
    local stick = vec.solve(K, v, function(prefix, x) return name(prefix, { x })[1] end)
    local more = name("more_", vec.map(stick, function(x, i) return -x - push * k.up[i] end))
    local share
    if law.friction then
      local mu = c.constant("impact_mu", law.friction, "friction of the impact")
      local tangential = c.constant("tangential", law.tangential, "tangential restitution of the impact")
      local up = name("more_up", { vec.dot(k.up, more) })[1]
      local across = name("across_", vec.sub(more, vec.scale(up, k.up)))
      -- share = kappa (1 + e_t): share |across| <= mu (normal + share up) is share (|across| - mu up) <= mu normal
      local most = name("most", { mu * normal })[1]
      local need = name("need", { (1 + tangential) * (expr.sqrt(vec.dot(across, across)) - mu * up) })[1]
      share = (1 + tangential) * most / at_least(need, at_least(most, tiny))
    else
      -- friction without a limit: 1, and 0 where the point leaves
      share = push / at_least(push, tiny)
    end
    p = vec.add(p, vec.scale(name("share", { share })[1], more))
  end
  p = name("p", p)
  local turn = touch.inverse_per_mass(m, c, name, vec.cross(k.r, p))
  local move = vec.matvec(vec.rotation(state.q), p)
  local outs = {}
  for i = 1, 3 do
    outs[i] = { array = "x", state = state.w[i].name, expr = state.w[i] + turn[i] }
    outs[3 + i] = { array = "x", state = state.v[i].name, expr = state.v[i] + move[i] }
  end
  outs[7] = { result = true, expr = context.mass(m) * vec.dot(k.up, p) }
  group.outs = outs
  return { name = "impact", args = { "m", "x!" }, result = true,
    doc = { "What the state x becomes when the body meets the plane: call it where the gap becomes 0.  Returns the",
      "impulse along the normal, N s; 0, and x as it is, where the lowest point does not approach.  |q| = 1." },
    groups = { group } }
end

return landing
