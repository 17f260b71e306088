-- fields.lua -- hard cases: gravity gradient in resonance and past perigee, springs at half a turn, sails edge on.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local cases = {}
  local function case(c) cases[#cases + 1] = c end

  -- Pitch theta over the true anomaly f on an orbit of mu = a = 1 (Beletsky's equation, derived here from C phi'' =
  -- -3 mu/r^3 (B - A) sin theta cos theta with phi = f + theta):
  --     (1 + e cos f) theta'' = 2 e sin f (1 + theta') - 3 K sin theta cos theta,   K = (B - A)/C
  -- by RK4 with n steps in f; and the time, by Kepler's equation.
  local function beletsky(e, K, theta, rate, f, n)
    local h, x = f / n, { theta, rate }
    local function slope(at, p, r)
      local s, c = math.sin(at), math.cos(at)
      return r, (2 * e * s * (1 + r) - 3 * K * math.sin(p) * math.cos(p)) / (1 + e * c)
    end
    for i = 0, n - 1 do
      local g = i * h
      local a1, b1 = slope(g, x[1], x[2])
      local a2, b2 = slope(g + h / 2, x[1] + h / 2 * a1, x[2] + h / 2 * b1)
      local a3, b3 = slope(g + h / 2, x[1] + h / 2 * a2, x[2] + h / 2 * b2)
      local a4, b4 = slope(g + h, x[1] + h * a3, x[2] + h * b3)
      x[1] = x[1] + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
      x[2] = x[2] + h / 6 * (b1 + 2 * b2 + 2 * b3 + b4)
    end
    local turns = math.floor((f + math.pi) / (2 * math.pi))
    local half = (f - 2 * math.pi * turns) / 2
    local E = 2 * math.atan(math.sqrt((1 - e) / (1 + e)) * math.sin(half), math.cos(half))
    local rate_f = (1 - e * e) ^ -1.5 * (1 + e * math.cos(f)) ^ 2
    return { t = E - e * math.sin(E) + 2 * math.pi * turns, angle = f + x[1], w = rate_f * (1 + x[2]) }
  end

  local satellite = [[
return scene { name = "boom", body = tensor { mass = 1, xx = 1, yy = 2, zz = 3 },
  effects = { effect.gravity_gradient { mu = 1, orbit = { a = 1, e = %s } } }, time = { step = 0.001 } }
]]
  local function librate(row, e, theta, f, o)
    local want = beletsky(e, 1 / 3, theta, 0, f, o.fine)
    local other = beletsky(e, 1 / 3, theta, 0, f, o.fine // 2)
    assert(math.abs(want.angle - other.angle) < 1e-9, "the oracle's own error")
    row.naive(o.naive(want))
    kit.each({ text = string.format(satellite, e), methods = { "rk4", "adaptive" } }, function(b, real)
      assert(b.plugin:init() == 0)
      local w0 = (1 - e * e) ^ -1.5 * (1 + e) ^ 2
      local x0 = kit.initial(b)
      for i, v in ipairs { math.cos(theta / 2), 0, 0, math.sin(theta / 2), 0, 0, w0 } do x0[i] = kit.round(real, v) end
      local q = { math.cos(want.angle / 2), 0, 0, math.sin(want.angle / 2) }
      local tolerance = real == "double" and 1e-12 or 1e-6
      local a = b.plugin:integrate(x0, nil, { tolerance }, { want.t }, 0, "adaptive")
      row("adaptive", real, a and kit.angle({ table.unpack(a[1], 2) }, q) or math.huge, o.adaptive * tolerance)
      local n = real == "double" and o.steps or o.float_steps or o.steps
      local x = b.plugin:march(0, x0, nil, want.t / n, n, "rk4")
      row("rk4", real, kit.angle(x, q), o.rk4 + o.grows * math.sqrt(n) * b.u)
      if real == "double" then
        row("library", "long double", kit.angle(kit.library(b.job, x0, { want.t })[1], q), o.library)
      end
    end)
  end

  case { name = "gravity_gradient_in_resonance", fast = true,
    why = "3 (B - A)/C = 1: the pitch swings at the orbit's own rate, and its eccentricity 0.1 drives it up",
    naive = "the linear swing at the orbital rate, theta cos f, without the drive",
    oracle = "Beletsky's equation over the true anomaly, with Kepler's for the time, in steps whose halving changes " ..
      "1e-9",
    bound = "growth of a disturbance in resonance: f = 20 times, and of the nonlinear swing as much again: 400. " ..
      "adaptive: 400 times the tolerance times 1 a radian, 20; rk4: (h w)^4/120 on 20 rad times 400, w = 2: 2e-11, " ..
      "roundings; library: the oracle's 2e-9",
    run = function(row)
      librate(row, 0.1, 0.2, 20, { fine = 200000, steps = 20000, adaptive = 8000, rk4 = 2e-9, library = 2e-9,
        grows = 400,
        naive = function(want) return math.abs(want.angle - 20 - 0.2 * math.cos(20)) end })
    end }

  case { name = "gravity_gradient_past_a_close_perigee",
    why = "e = 0.9: at the perigee the torque is 1000 times that at mean distance, for a hundredth of the time; " ..
      "then it tumbles",
    naive = "the circular orbit's torque and time",
    oracle = "as above",
    bound = "torque 3 mu/r^3 K at r = 0.1 over 0.05 of time is 50 rad/s: a disturbance grows by 1e4 at most over " ..
      "two passages. adaptive: 1e4 times 40 tolerances; rk4 1e4 (h w)^4/120 w t with h w = 5e-4: 1e-7; in float, " ..
      "20000 steps, 1e4 sqrt(n) u; library: the oracle's 1e-7",
    run = function(row)
      librate(row, 0.9, 0.1, 8, { fine = 400000, steps = 400000, float_steps = 20000, adaptive = 4e5, rk4 = 1e-7,
        library = 1e-7, grows = 1e4,
        naive = function(want) return math.abs(want.angle - want.t) end })
    end }

  case { name = "spring_from_nothing_to_half_a_turn", fast = true,
    why = "angles from 1e-200 to pi, and past it: the axis of no turn does not exist, at pi it has two signs, as has q",
    naive = "angle 2 acos(qw) about the axis v/sin: 0/0 at rest, half the digits near it",
    oracle = "-k sin(angle) about the axis; the same for q and -q",
    bound = "8 u of k: five products and two sums of unit quaternions; at small angles relative to the angle",
    run = function(row)
      local most = 0.0
      for _, angle in ipairs { 0, 1e-9, 1e-7 } do
        local half = math.acos(math.cos(angle / 2))
        local torque = 2 * half * math.sin(angle / 2) / math.sin(half)
        most = kit.worst(most, angle == 0 and torque or math.abs(torque - angle) / angle)
      end
      row.naive(most)
      local text = [[
return scene { name = "coil", body = tensor { mass = 1, xx = 1, yy = 2, zz = 2.5 },
  effects = { effect.spring { stiffness = 2.5, axis = { 0, 0, 1 } } }, time = { step = 0.01 } }]]
      kit.each({ text = text }, function(b, real)
        assert(b.plugin:init() == 0)
        local worst = 0.0
        for _, angle in ipairs { real == "double" and 1e-200 or 1e-30, 1e-9, 1e-4, 0.1, 1, 2, 3, 3.1415926, 4, 6 } do
          for sign = -1, 1, 2 do
            local c, s = kit.round(real, sign * math.cos(angle / 2)), kit.round(real, sign * math.sin(angle / 2))
            local dx = b.plugin:rhs(0, { c, 0, 0, s, 0, 0, 0 })
            local want = -2 * c * s -- k/I = 1: -sin(angle) of the rounded quaternion
            worst = kit.worst(worst, math.abs(dx[7] - want) / math.min(1, math.abs(want) > 0 and angle or 1))
          end
        end
        row("model", real, worst, 8 * b.u)
      end)
    end }

  case { name = "sail_edge_on", fast = true,
    why = "the sun in the plane of a plate: light and shadow change at the last place of the attitude",
    naive = "c as the sine of an angle that comes from acos: 1e-9 rad from the edge there is no light",
    oracle = "F = flux/c0 A c (2 c n) of a mirror, c the cosine of the rounded quaternion, exactly",
    bound = "8 u of c^2 A flux/c0: what c itself is off by, absolutely, is u, so 8 u (c + u)",
    run = function(row)
      local true_c = 1e-9
      local lit = math.sin(math.acos(math.cos(true_c)))
      row.naive(math.abs(2 * lit * lit - 2 * true_c * true_c) / (true_c + kit.u.double))
      local text = [[
return scene { name = "edge", body = tensor { mass = 1, xx = 1, yy = 2, zz = 2.5 },
  effects = { effect.solar_pressure { flux = 299792458, sun = { 1, 0, 0 },
    plates = { { area = 1, normal = { 0, 1, 0 }, centre = { 2.5, 0, 0 }, reflectivity = 1 } } } },
  time = { step = 0.01 } }]]
      kit.each({ text = text }, function(b, real)
        assert(b.plugin:init() == 0)
        local worst = 0.0
        for _, angle in ipairs { 0, 1e-300, 1e-20, 1e-16, 1e-9, 1e-3, 0.5, 1.5 } do
          for sign = -1, 1, 2 do
            -- turned by -angle about z: the normal's x component, c, is sin(angle) = 2 qw (-qz)
            local w, z = kit.round(real, math.cos(angle / 2)), kit.round(real, sign * math.sin(angle / 2))
            local dx = b.plugin:rhs(0, { w, 0, 0, -z, 0, 0, 0 })
            local c = math.max(0, 2 * w * z)
            local want = -2 * c * c -- torque 2.5 x 2 c^2 about z, from pushing along -n, over I = 2.5
            worst = kit.worst(worst, math.abs(dx[7] - want) / (c + b.u))
          end
        end
        row("model", real, worst, 16 * b.u)
      end)
    end }

  return { title = "Fields, springs and light", about = "Torques that depend on the attitude, where they change " ..
    "fast " ..
    "or not at all.", cases = cases }
end
