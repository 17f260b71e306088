-- rolling.lua -- the rates of a body that rolls on a plane (contact.lua has the equations).
--
-- F = f + r x w' is the contact's force over the mass, and
--     w' = w0' + m I^-1 (r x F),   w0' of the torques alone
-- In general that is three equations for w', whose matrix I/m + r.r 1 - r r^T is positive.  A sphere about the centre
-- of mass has a matrix that is inverted by its diagonal and g g^T.  A body of revolution on its disc has r_s = 0 in the
-- axes of the meridian (effects/meridian.lua), so only F_s and w_s' remain to be solved for:
--     F_s = (f_s + r_z w0_t' - r_t w0_z')/(1 + m/I1 r_z^2 + m/I3 r_t^2)
--     w_s' = (w0_s' + m/I1 (r_z f_t - r_t f_z))/(1 + m/I1 (r_t^2 + r_z^2))
--     w_t' = w0_t' - m/I1 r_z F_s,   w_z' = w0_z' + m/I3 r_t F_s
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local nest = require "generator.algebra.nest"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local touch = require "generator.dynamics.touch"

local rolling = {}

local axes = { "x", "y", "z" }
local zero = expr.zero

-- factor (g x G + Omega X') of a sphere about the centre of mass, whose velocity X' = U + r' has the components
-- p1', p2' and none along g:  r x f with the factor R, and  g x G = -(G.e2) e1 + (G.e1) e2.
local function driven(a, c, k, name, rates, factor, of)
  local rate = c.constant("rolling_Omega", ratio.tidy(factor * a.rate), "rate of the plane times " .. of)
  local function pull(i, e)
    return c.constant("rolling_g" .. i, ratio.tidy(factor * vec.dot(a.gravity, e)), "gravity along e" .. i ..
      " times " .. of)
  end
  local x1 = name("roll1", { rate * rates.p1 - pull(2, a.e2) })[1]
  local x2 = name("roll2", { rate * rates.p2 + pull(1, a.e1) })[1]
  return k.span(x1, x2)
end

-- What is left of (g x G + Omega X'), as text; nil: nothing is.
local function driving(a)
  local turns = not ratio.iszero(a.rate)
  local tilted = not (ratio.iszero(vec.dot(a.gravity, a.e1)) and ratio.iszero(vec.dot(a.gravity, a.e2)))
  if tilted and turns then return "(g x G + Omega X')" end
  return tilted and "g x G" or turns and "Omega X'" or nil
end

local function isotropic(I)
  return I[1] == I[2] and I[2] == I[3] and I[4] == zero and I[5] == zero and I[6] == zero
end

-- w' of such a body: with D = I/m + R^2 the matrix is D - R^2 g g^T, whose inverse is (Sherman, Morrison 1950)
--     D^-1 + R^2 (D^-1 g) (D^-1 g)^T / den,   den = 1 - R^2 g.D^-1 g = sum g_i^2 (I_i/m)/D_i
-- A ball has den = (I/m)/D, and where no other torque acts g.n = 0: what is left is n/D, as `ball` has it.
local function round(m, e, c, k, name, n)
  local R2, I = e.a.surface.rim ^ 2, m.carried
  local function constant(i, prefix, x, about)
    return c.constant(prefix .. axes[i], ratio.tidy(x), about .. " about " .. axes[i])
  end
  local over, share = {}, {}
  for i = 1, 3 do
    local D = I[i] / m.mass + R2
    over[i] = constant(i, "roll", 1 / D, "1/(moment/mass + radius^2), 1/m^2,")
    share[i] = constant(i, "share", I[i] / m.mass / D, "moment over that about the contact point,")
  end
  local ball = I[1] == I[2] and I[2] == I[3]
  local y = name("n", vec.map(n, function(x, i) return over[i] * x end))
  local radius = c.constant("rim2", ratio.tidy(R2), "radius squared, m^2")
  local den = ball and share[1] or vec.dot(share, vec.map(k.up, function(x) return x ^ 2 end))
  local factor = name("support", { radius * vec.dot(k.up, y) / den })[1]
  return vec.map(y, function(x, i) return x + over[i] * k.up[i] * factor end)
end

-- f, and what it is, as text.  level: gravity is along the normal and counted elsewhere.
local function force(k, moving, level)
  local f, said = vec.scale(-expr.one, level and k.bend or vec.add(k.G, k.bend)), level and "f = -w x k" or
    "f = -G - w x k"
  if not moving.rate then return f, said end
  local P = vec.add(moving.u, vec.sub(k.place, k.turning)) -- u + r'
  return vec.add(f, vec.scale(moving.rate, vec.cross(k.up, P))), said .. " + Omega g x (U + r')"
end

-- (I/m w) x w + N/m + r x f, and what f is, as text.  moving: {u, rates = of the centre, rate = of the plane or nil}.
local function couple(m, a, c, I, k, name, N, moving)
  local n = vec.scale(c.constant("over_m", expr.one / m.mass, "1/mass, 1/kg"), N)
  if not isotropic(m.carried) then
    n = vec.add(n, vec.cross(name("Lm", vec.apply(I, k.w)), k.w)) -- Lx .. may be those of a torque that takes L
  end
  if k.centred then
    local of = driving(a)
    return vec.add(n, driven(a, c, k, name, moving.rates, a.surface.rim, "R")), "r x f = " .. (of and "R " .. of or "0")
  end
  local f, said = force(k, moving)
  return vec.add(n, vec.cross(k.r, name("drive_", f))), said
end

-- solved(n) -> w', how it is done (nil: by elimination).
local function solver(m, e, c, I, k, name)
  if k.centred and I[4] == zero and I[5] == zero and I[6] == zero then
    local function inverted(n) return round(m, e, c, k, name, vec.map(n, ratio.tidy)) end
    return inverted, "inverted by its diagonal and g g^T"
  end
  local r, S = k.r, nil
  return function(n)
    S = S or name("S", vec.add(I, { r[2] ^ 2 + r[3] ^ 2, r[1] ^ 2 + r[3] ^ 2, r[1] ^ 2 + r[2] ^ 2, -r[1] * r[2],
      -r[1] * r[3], -r[2] * r[3] }))
    return vec.solve(S, name("n", n), function(prefix, x) return name(prefix, { x })[1] end)
  end
end

-- w' of a ball with equal moments on which nothing else acts: r x f is along the plane, and so is w'; and its
-- law as text.
local function ball(m, a, c, k, name, rates)
  local factor, of = a.surface.rim / (m.carried[1] / m.mass + a.surface.rim ^ 2), driving(a)
  return driven(a, c, k, name, rates, factor, "R/(I/m + R^2)"),
    "Newton and Euler of a ball that rolls: w' = " .. (of and "R/(I/m + R^2) " .. of or "0")
end

local function none(v) return v[1] == zero and v[2] == zero and v[3] == zero end

local function parallel(a, b)
  local v = vec.cross(a, b)
  return ratio.iszero(v[1]) and ratio.iszero(v[2]) and ratio.iszero(v[3])
end

-- In body axes: w', why, and the solution for a torque per mass.
local function whole(m, e, c, k, name, N, moving)
  local I = vec.map(m.carried, function(x, n)
    return c.constant("I" .. vec.entry[n] .. "_m", ratio.tidy(x / m.mass), "tensor entry " .. vec.entry[n] ..
      " per mass, m^2")
  end)
  local solved, how = solver(m, e, c, I, k, name)
  if k.centred and isotropic(m.carried) and none(N) then
    local dw, why = ball(m, e.a, c, k, name, moving.rates)
    return dw, why, solved
  end
  local n, said = couple(m, e.a, c, I, k, name, N, moving)
  return solved(n), "Newton and Euler, rolling: (I/m + r.r 1 - r r^T) w' = (I w/m) x w + N/m + r x f, " .. said ..
    (how and ", " .. how or ""), solved
end

-- w0' in the axes of the meridian; as text, what it is.  level: with the torque of gravity about the contact point,
-- r x (weight g) = weight far x g.
local function free(m, e, c, k, name, N, level)
  local I = m.carried
  local Omega = name("Omega", { c.constant("cs", (I[3] - I[1]) / I[1], "(I3 - I1)/I1") * k.w[3] })[1]
  local w0, said = { -Omega * k.w[2], Omega * k.w[1], zero }, "w0' = (I3 - I1)/I1 w_z z x w"
  if not none(N) then
    local over1 = c.constant("over_I1", 1 / I[1], "1/moment of inertia across the axis, 1/(kg m^2)")
    local over3 = c.constant("over_I3", 1 / I[3], "1/moment of inertia about the axis, 1/(kg m^2)")
    local n = k.into(N)
    w0, said = vec.add(w0, { over1 * n[1], over1 * n[2], over3 * n[3] }), said .. " + I^-1 N"
  end
  w0[1] = name("free_t", { w0[1] })[1]
  if not level then return w0, said end
  local fall = -m.mass * e.spec.weight(e.a) / I[1]
  local function part(x, axis)
    return c.constant("fall_" .. axis, ratio.tidy(fall * x), "weight times arm " .. axis ..
      " of the centre of the edge over the moment of inertia, 1/s^2")
  end
  w0[2] = w0[2] + part(k.own[3], "z") * k.up[1] - part(k.own[1], "t") * k.up[3]
  return w0, said .. " + m I^-1 (r x -G)"
end

-- Of a body of revolution: m/I1 r_z, m/I1 r_t, m/I3 r_t, and one over the two denominators.  Constants where the edge
-- is sharp, for then r is.
local function levers(m, c, k, name)
  local I, r = m.carried, k.r
  local sharp = k.rim == zero
  if sharp then r = k.own end
  local function put(prefix, x, about)
    return sharp and c.constant(prefix, ratio.tidy(x), about) or name(prefix, { x })[1]
  end
  local over1, over3 = m.mass / I[1], m.mass / I[3]
  if not sharp then over1, over3 = touch.per_moment(m, c, 1), touch.per_moment(m, c, 3) end
  local z = put("grip_z", over1 * r[3], "mass times arm z over the moment of inertia xx, 1/m")
  local t = put("grip_t", over1 * r[1], "mass times arm t over the moment of inertia xx, 1/m")
  local twist = put("twist", over3 * r[1], "mass times arm t over the moment of inertia zz, 1/m")
  if sharp then
    return z, t, twist, put("along", 1 / (1 + over1 * r[3] ^ 2 + over3 * r[1] ^ 2), "share of the force along s"),
      put("across", 1 / (1 + over1 * (r[1] ^ 2 + r[3] ^ 2)), "moment over that about the contact point")
  end
  local base = name("base", { 1 + z * r[3] })[1]
  return z, t, twist, 1 / (base + twist * r[1]), 1 / (base + t * r[1])
end

-- The same in the axes of the meridian, for body and disc of one axis.
local function revolved(m, e, c, k, name, N, moving)
  local r, a = k.r, e.a
  local z, t, twist, along, across = levers(m, c, k, name)
  if a.spinning or a.rolling_resistance then -- two right sides
    along, across = name("along", { along })[1], name("across", { across })[1]
  end
  local function solved(w0, f)
    local F = name("grip", { (f[2] + r[3] * w0[1] - r[1] * w0[3]) * along })[1]
    return name("turn_", { w0[1] - z * F, nest(w0[2] + z * f[1] - t * f[3]) * across, w0[3] + twist * F })
  end
  local level = parallel(a.gravity, a.normal)
  local w0, about = free(m, e, c, k, name, N, level)
  local f, said = force(k, moving, level)
  local function yield(T)
    local b0 = vec.map(T, function(x, i) return touch.per_moment(m, c, i) * x end)
    return solved(b0, { zero, zero, zero })
  end
  return solved(w0, f), "Newton and Euler, rolling: w' = w0' + m I^-1 (r x F), F = f + r x w', " .. about .. ", " ..
    said, yield
end

-- The group of w', and what else contact.lua asks for.
function rolling.turning(m, e, c, N, groups)
  local k = touch.geometry(m, e, c, groups)
  local a, g = e.a, { defs = {} }
  local u, u1, u2, rate = touch.table_of(a, c, k)
  local rates = { p1 = u1 - k.v1, p2 = u2 - k.v2 }
  local name = touch.namer(m, g, c.taken, k.letters)
  local way = k.letters and revolved or whole
  local dw, why, yield = way(m, e, c, k, name, N, { u = u, rates = rates, rate = rate })
  local T, nu = touch.resisting(a, c, k, name), nil
  if T then
    why = why .. "; N T against spinning and rolling by the solution b for T: w' = w0' + N/m b"
    local w0, b = name("free_", dw), name("yield_", yield(T))
    nu = touch.support(k, name, w0, b)
    dw = vec.add(w0, vec.scale(nu, b))
  end
  g.why, g.outs = why, k.out(dw)
  groups[#groups + 1] = g
  -- N/m = g.(A - G), A = Omega g x (..) - w' x r - w x k
  local function reaction()
    if nu or k.centred then return nu or -k.weight end
    return -vec.dot(dw, k.side) - k.pull - k.weight
  end
  return g, { coordinates = function() return rates end, reaction = reaction, k = k, c = c, a = a }
end

return rolling
