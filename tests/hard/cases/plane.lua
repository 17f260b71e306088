-- plane.lua -- hard cases: bodies that roll and slide on a plane.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local cases = {}
  local function case(c) cases[#cases + 1] = c end

  local function place(b, name)
    for i, s in ipairs(b.job.states) do
      if s.name == name then return i end
    end
  end

  -- The emitted rates beside the library's at the states, in units of the library's largest term.
  local function rates(row, text, states, bar)
    local numeric = require "generator.dynamics.numeric"
    kit.each({ text = text }, function(b, real)
      assert(b.plugin:init() == 0)
      local library, worst = kit.host.rates(numeric.scene(b.job)), 0.0
      for _, x in ipairs(states) do
        x = kit.rounded(real, x)
        local full = numeric.whole(b.job, x)
        local want, size = library:rates(0, full)
        want, size = numeric.part(b.job, want), numeric.part(b.job, size)
        local got = b.plugin:rhs(0, x)
        for i = 1, #x do
          if size[i] > 0 then worst = kit.worst(worst, math.abs(got[i] - want[i]) / size[i]) end
        end
      end
      row("model", real, worst, bar * b.u)
    end)
  end

  -- Motion by adaptive and taylor against want(state name) at the time; tolerance and bar by real type.
  local function motion(row, o)
    kit.each({ text = o.text, methods = { "adaptive", "taylor" } }, function(b, real)
      assert(b.plugin:init() == 0)
      local tolerance = real == "double" and 1e-13 or 2e-7
      for _, method in ipairs { "adaptive", "taylor" } do
        local rows = b.plugin:integrate(kit.initial(b), nil, { tolerance }, { o.t }, 0, method)
        local worst = rows and 0.0 or math.huge
        for name, want in pairs(rows and o.want or {}) do -- a maximum: no order
          local x = rows[1][1 + place(b, name)]
          worst = kit.worst(worst, math.abs(x - want) / (o.size or math.max(math.abs(want), 1e-3)))
        end
        row(method, real, worst, o.bar * tolerance)
      end
    end)
  end

  case { name = "disc_nearly_flat", fast = true,
    why = "g.Bg of the disc's edge is R^2 sin^2(tilt): as it falls flat the contact point runs round ever faster",
    naive = "sin(tilt) from acos of the cosine, which loses half the digits and all of them below 1e-8",
    oracle = "steady precession of a thin disc about its fixed centre of mass: w along the radius, p^2 sin(tilt) = " ..
      "4 g/R, w = p sin(tilt), so w' = p cos(tilt) w across it",
    bound = "64 u: the attitude's half angle is a state and sin(tilt) 2 products of it; Newton's law has some 30 " ..
      "operations on terms of the size of g/R, which w p = 4 g/R is too",
    run = function(row)
      local worst = 0.0
      for _, a in ipairs { 1e-3, 1e-6, 1e-8 } do
        worst = kit.worst(worst, math.abs(math.sin(math.acos(math.cos(a))) / math.sin(a) - 1))
      end
      row.naive(worst)
      local text = [[
return scene { name = "flat", body = tensor { mass = 1, xx = 0.25, yy = 0.25, zz = 0.5 },
  effects = { effect.plane { surface = contact.disc { r = 1 }, gravity = 1 } },
  initial = { attitude = { axis = "x", angle = 0.5 } }, time = { step = 0.001 } }]]
      kit.each({ text = text }, function(b, real)
        assert(b.plugin:init() == 0)
        local most = 0.0
        for _, angle in ipairs { 0.5, 0.1, 1e-2, 1e-3, 1e-5, 1e-7 } do
          local x = kit.initial(b)
          for i = 1, #x do x[i] = 0.0 end
          x[1], x[2] = kit.round(real, math.cos(angle / 2)), kit.round(real, math.sin(angle / 2))
          local s = 2 * x[1] * x[2] / (x[1] * x[1] + x[2] * x[2]) -- sine of the tilt that was rounded
          local p = math.sqrt(4 / s)
          local c = math.sqrt(1 - s * s)
          -- z of the body leans to -y; the lowest point is at -y of the body
          x[6] = kit.round(real, p * s)
          local dx = b.plugin:rhs(0, x)
          -- w keeps its direction in space but for the precession; in the body the radius turns back by p cos(tilt)
          local across, along = math.abs(dx[5]), kit.worst(math.abs(dx[6]), math.abs(dx[7]))
          local want = p * c * x[6]
          most = kit.worst(most, math.abs(across / want - 1), along / want)
        end
        row("model", real, most, 64 * b.u)
      end)
    end }

  case { name = "contact_of_a_flat_ellipsoid", fast = true,
    why = "axes 1, 1, 0.001: while the tilt changes by 0.001 the contact point moves from the centre to the edge",
    naive = "sqrt(g.Bg) of the sum of squares with g1^2 + g2^2 as 1 - g3^2",
    oracle = "the library: the image of the unit sphere's point, in long double",
    bound = "256 u of the library's largest term: about 40 operations for the point and its rate, 60 for Newton's " ..
      "law, each rounding once",
    run = function(row)
      local worst = 0.0
      for _, a in ipairs { 1e-8, 1e-6 } do
        local g3 = math.cos(a)
        worst = kit.worst(worst, math.abs(math.sqrt(1 - g3 * g3) / math.sin(a) - 1))
      end
      row.naive(worst)
      local text = [[
return scene { name = "plate", body = tensor { mass = 1, xx = 0.25, yy = 0.3, zz = 0.5 },
  effects = { effect.plane { surface = contact.ellipsoid { a = 1, b = 1, c = 0.001 } } },
  initial = { attitude = { axis = "x", angle = 0.5 } }, time = { step = 0.001 } }]]
      local states = {}
      for _, a in ipairs { 1.5, 0.3, 1e-2, 1e-4, 1e-5, 1e-6, 1e-9, 0 } do
        states[#states + 1] = { math.cos(a / 2), math.sin(a / 2), 0, 0, 0.3, -0.2, 0.1, 0, 0 }
      end
      rates(row, text, states, 256)
    end }

  case { name = "needle_of_an_egg", fast = true,
    why = "axes 1, 1e-4, 1e-4 and moments in the ratio 1e8: the matrix of rolling is nearly singular about the length",
    naive = "the inverse by its adjugate and determinant, whose terms cancel by the ratio of the moments",
    oracle = "the library: nine equations with the contact force unknown, in long double",
    bound = "16 u of the largest term, the inverse matrix's entries times the torques: L D L^T of a positive matrix " ..
      "subtracts only what is smaller",
    run = function(row)
      local I, r = { 1e-8, 0.2, 0.2 }, 1e-4
      local det = (I[1] + r * r) * (I[2] + r * r) - (r * r) * (r * r)
      row.naive(math.abs((I[1] * I[2] + r * r * (I[1] + I[2])) / det - 1) + 2 ^ -53 * 1e8)
      local text = [[
return scene { name = "needle", body = tensor { mass = 1, xx = 4e-9, yy = 0.2, zz = 0.2 },
  effects = { effect.plane { surface = contact.ellipsoid { a = 1, b = 0.0001, c = 0.0001 } } },
  time = { step = 0.001 } }]]
      local states = {}
      for _, a in ipairs { 0, 1e-6, 1e-3, 0.1, 0.7 } do
        states[#states + 1] = { math.cos(a / 2), 0, math.sin(a / 2), 0, 0.3, 0.2, 0.1, 0, 0 }
      end
      rates(row, text, states, 16)
    end }

  case { name = "exactly_upright", fast = true,
    why = "an egg that spins on its very end, unstable: any rounding of a torque would start the fall",
    naive = "the lever arm r x g with the height and the angle from acos: 1e-8 of itself",
    oracle = "by symmetry it stays: the rates do not change, whatever the spin",
    bound = "u, of which nothing is used: every product of the torque has a factor that is exactly 0",
    run = function(row)
      row.naive(math.sin(math.acos(1 - 2 ^ -53)))
      local text = [[
return scene { name = "upright", body = tensor { mass = 1, xx = 0.3, yy = 0.3, zz = 0.2 },
  effects = { effect.plane { surface = contact.ellipsoid { a = 0.7, b = 0.7, c = 1.1, at = {0, 0, 0.1} } } },
  initial = { omega = {0, 0, 0.5} }, time = { step = 0.001 } }]]
      kit.each({ text = text, methods = { "rk4", "taylor" } }, function(b, real)
        assert(b.plugin:init() == 0)
        local x = b.plugin:march(0, kit.initial(b), nil, 0.001, 20000, "rk4")
        row("rk4", real, kit.worst(math.abs(x[2]), math.abs(x[3]), math.abs(x[5]), math.abs(x[6]),
          math.abs(x[7] - 0.5)), b.u)
      end)
    end }

  local incline = [[
return scene { name = "rim", body = tensor { mass = 2, xx = %s, yy = %s, zz = %s },
  effects = { effect.plane { surface = contact.sphere { r = 0.5 }, normal = {3, 0, 4}, gravity = 10 } },
  time = { step = 0.001 } }]]
  case { name = "ball_with_all_mass_at_its_rim_or_centre", fast = true,
    why = "J/(m r^2) = 2/3, the most that a ball can have, and 1e-12: then nothing but the plane resists its turning",
    naive = "a = g sin/(1 + 2/5), the solid ball's",
    oracle = "a = g sin(slope)/(1 + J/(m r^2)) along the slope, w = v/r",
    bound = "16 u, relative: the constants, the matrix's diagonal and one product each",
    run = function(row)
      row.naive(math.abs((1 + 2 / 3) / (1 + 2 / 5) - 1))
      for _, ratio in ipairs { { "1/3", 2 / 3 }, { "1/2000000000000", 1e-12 } } do
        kit.each({ text = string.format(incline, ratio[1], ratio[1], ratio[1]) }, function(b, real)
          assert(b.plugin:init() == 0)
          local dx = b.plugin:rhs(0, kit.initial(b))
          local want = 10 * 3 / 5 / (1 + ratio[2]) / 0.5
          row("model, J/(m r^2) = " .. string.format("%.2g", ratio[2]), real,
            kit.worst(math.abs(math.sqrt(dx[5] ^ 2 + dx[6] ^ 2 + dx[7] ^ 2) / want - 1)), 16 * b.u)
        end)
      end
    end }

  local slides = [[
return scene { name = "slides", body = tensor { mass = 1, xx = 0.4, yy = 0.4, zz = 0.4 },
  effects = { effect.plane { surface = contact.sphere { r = 1 }, law = "sliding", friction = { viscous = %s },
    gravity = 10 } }, initial = { velocity = {7, 0, 0} }, time = { step = 0.001 } }]]
  for _, c in ipairs { { "nearly_smooth", 1e-6 }, { "nearly_rigid", 200 } } do
    case { name = c[1] .. "_friction", fast = true,
      why = c[2] < 1 and "friction of 1e-6 s/m: the slip changes by some millionths of itself in a second" or
        "friction of 200 s/m: the slip is gone in a millisecond, 7000/s beside a motion of seconds",
      naive = c[2] < 1 and "smooth, without friction" or "Euler's step of 1 ms, which grows by 6 each time",
      oracle = "the slip falls as exp(-g c (1 + m r^2/J) t); m r^2 v + J w = 7 is kept, so v = 5 + 2 slip share",
      bound = "8 tolerances of the first speed" .. (c[2] > 1 and ": errors of steps die out with the slip, those of " ..
        "the last decay time remain" or ": a few steps, as nothing changes"),
      run = function(row)
        local s = math.exp(-10 * c[2] * 3.5)
        local want = { v1 = 5 + 2 * s, wy = 5 - 5 * s }
        row.naive(c[2] < 1 and math.abs(7 - want.v1) or math.huge)
        motion(row, { text = string.format(slides, c[2] < 1 and "0.000001" or "200"), t = 1, want = want, bar = 8,
          size = 7 })
      end }
  end

  -- The relative drift of fn(plugin, x) over a motion by adaptive and taylor.
  local function kept(row, o)
    kit.each({ text = o.text, methods = { "adaptive", "taylor" } }, function(b, real)
      assert(b.plugin:init() == 0)
      local x0 = kit.initial(b)
      local first = o.fn(b.plugin, x0)
      for _, method in ipairs(real == "float" and o.float or { "adaptive", "taylor" }) do
        local tolerance = real == "double" and o.tolerance or 2e-7
        local rows = b.plugin:integrate(x0, nil, { tolerance }, { o.t }, 0, method)
        local x = rows and { table.unpack(rows[1], 2) }
        row(method, real, x and kit.finite(x) and math.abs(o.fn(b.plugin, x) / first - 1) or math.huge,
          o.bound(real, method, b.u, tolerance))
      end
    end)
  end

  case { name = "tippe_top_turns_over", fast = true,
    why = "the top passes through the horizontal, where the friction is largest and the spin about its axis changes " ..
      "its sign",
    naive = "the energy as what is kept: friction takes a third of it",
    oracle = "Jellett's integral L.(r g - at), whatever the friction",
    bound = "taylor: tolerance 1e-15 and 16 u; adaptive: its tolerance a step over some thousand steps, which are " ..
      "of both signs: 100 tolerances; float: 2e-7 and, over some 500 steps, 16 u sqrt(500) = 360 u",
    run = function(row)
      row.naive(1 / 3)
      kept(row, { t = 2.5, tolerance = 1e-15, text = [[
return scene { name = "tippe", body = tensor { mass = 0.006, xx = 8e-7, yy = 8e-7, zz = 7e-7 },
  effects = { effect.plane { surface = contact.sphere { r = 0.015, at = {0, 0, 0.003} }, law = "sliding",
    friction = { viscous = 1 } } },
  initial = { omega = {0, 0, 180}, attitude = { axis = "x", angle = 0.1 } }, time = { step = 0.0005 } }]],
        fn = function(_, x)
          local n = x[1] ^ 2 + x[2] ^ 2 + x[3] ^ 2 + x[4] ^ 2
          local g = { 2 * (x[2] * x[4] - x[1] * x[3]) / n, 2 * (x[3] * x[4] + x[1] * x[2]) / n,
            (x[1] ^ 2 - x[2] ^ 2 - x[3] ^ 2 + x[4] ^ 2) / n }
          return 8 * 0.015 * (x[5] * g[1] + x[6] * g[2]) + 7 * x[7] * (0.015 * g[3] - 0.003)
        end,
        bound = function(real, method, u, tolerance)
          if real == "float" then return 360 * u + (method == "adaptive" and 100 or 16) * tolerance end
          return 16 * u + (method == "adaptive" and 100 or 1) * tolerance
        end })
    end }

  case { name = "rattleback_for_an_hour",
    why = "it rocks at 20 rad/s and turns back each few seconds: energy goes to and fro a thousand times",
    naive = "rk4 with the step of 1 ms, which is fine for a second",
    oracle = "rolling on a plane at rest keeps the energy",
    bound = "1e-12 in double by taylor; adaptive at 1e-14 a step, 1e6 steps of one sign: 1e-8; float: steps " ..
      "of u each, walking: sqrt(1e6) u, and 15 times that for the weight, of which the energy of the motion is a " ..
      "part; its adaptive method stops after minutes, as t then has no digits left for its steps",
    run = function(row)
      local text = [[
return scene { name = "celt", body = tensor { mass = 1, xx = 0.0002, yy = 0.0016, zz = 0.0017, xy = -0.00002 },
  effects = { effect.plane { surface = contact.ellipsoid { a = 0.2, b = 0.03, c = 0.02, at = { 0, 0, 0.01 } },
    gravity = 9.81 } },
  initial = { omega = { 0, 0, -5 }, attitude = { axis = "x", angle = 0.01 } }, time = { step = 0.001 } }]]
      local function energy(plugin, x) return plugin:energy(x) - 0.0098 end -- about the weight's least
      local rk4 = kit.emitted({ text = text, methods = { "rk4" }, reals = { "double" } }).double
      assert(rk4.plugin:init() == 0)
      local x0 = kit.initial(rk4)
      row.naive(math.abs(energy(rk4.plugin, rk4.plugin:march(0, x0, nil, 0.001, 3600000, "rk4")) /
        energy(rk4.plugin, x0) - 1))
      kept(row, { t = 3600, tolerance = 1e-14, text = text, fn = energy, float = { "taylor" },
        bound = function(real, method)
          return real == "float" and 1e-3 or method == "taylor" and 1e-12 or 1e-8
        end })
    end }

  case { name = "reaction_through_zero", fast = true,
    why = "N is a difference of weight and inertia; where contact is lost nothing is left of it",
    naive = "N = m g",
    oracle = "the library's rates, whose force is unknown and not eliminated, at states around N = 0",
    bound = "8 u of the largest term, as polhode check: N enters the rates with the terms that make it",
    run = function(row)
      row.naive(1.0)
      local text = [[
return scene { name = "leaves", body = tensor { mass = 1, xx = 0.02, yy = 0.02, zz = 0.01 },
  effects = { effect.plane { surface = contact.ellipsoid { a = 0.1, b = 0.1, c = 0.2 }, law = "smooth",
    gravity = 10 } }, time = { step = 0.001 } }]]
      local states = {}
      for _, w in ipairs { 0, 5, 9, 9.99, 10, 10.01, 12, 20 } do
        states[#states + 1] = { math.cos(0.4), math.sin(0.4), 0, 0, w, 1, 2 }
      end
      rates(row, text, states, 8)
    end }

  return { title = "On a plane", about = "Bodies that touch a plane, where the contact point runs, the matrix is " ..
    "nearly singular, or nothing holds them but symmetry.", cases = cases }
end
