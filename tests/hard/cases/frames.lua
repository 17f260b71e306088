-- frames.lua -- hard cases: attitudes next to half a turn, turning frames, energy and momentum far from the axis.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(kit)
  local bodies = kit.use "bodies"
  local M, q, R = bodies.moments, bodies.q, kit.R

  local scene = [[
local A, B, C = param("A", 1, "kg m^2"), param("B", 2, "kg m^2"), param("C", 3, "kg m^2")
return scene { name = "body", body = tensor { mass = 1, xx = A, yy = B, zz = C }, effects = { effect.control{} } }
]]
  local particles = [[
local m = param("m", 1, "kg")
local x, y, z = param("x", 1, "m"), param("y", 2, "m"), param("z", 3, "m")
return scene { name = "body", effects = { effect.control{} }, origin = {0, 0, 0},
  body = points { {m, x, y, z}, {m, x + 1, y, z}, {m, x, y + 1, z}, {m, x, y, z + 2} } }
]]

  local function exact(list)
    local out = {}
    for i, x in ipairs(list) do out[i] = q(x) end
    return out
  end
  local function cross(a, b)
    return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
  end
  local function dot(a, b)
    local sum = a[1] * b[1] + a[2] * b[2] + a[3] * b[3]
    return a[4] and sum + a[4] * b[4] or sum
  end
  -- q v q* of a quaternion of any length: its rotation times |q|^2
  local function sandwich(s, v)
    local w, x, y, z = s[1], s[2], s[3], s[4]
    local two = q(2)
    return { (w * w + x * x - y * y - z * z) * v[1] + two * (x * y - w * z) * v[2] + two * (x * z + w * y) * v[3],
      two * (x * y + w * z) * v[1] + (w * w - x * x + y * y - z * z) * v[2] + two * (y * z - w * x) * v[3],
      two * (x * z - w * y) * v[1] + two * (y * z + w * x) * v[2] + (w * w - x * x - y * y + z * z) * v[3] }
  end
  local function length(v) return R.apply("sqrt", 200, dot(v, v)) end
  -- the worst component of a list of doubles against rationals, over size
  local function off(got, want, size)
    local worst = 0.0
    for i, x in ipairs(want) do worst = kit.worst(worst, bodies.error(got[i], x, size)) end
    return worst
  end
  local function unit(v)
    local n = 0.0
    for _, x in ipairs(v) do n = n + x * x end
    local out = {}
    for i, x in ipairs(v) do out[i] = x / math.sqrt(n) end
    return out
  end

  -- Attitudes half a turn and almost half a turn from 1, and where the matrix' trace is nearly 0.
  local function attitudes(real)
    local e, list = real == "double" and 1e-12 or 1e-5, {}
    for _, s in ipairs { { 0, 1, 0, 0 }, { 0, 1, 2, -2 }, { e, 0, 0, 1 }, { e * e, 3, -1, 2 }, { -e, 1, e, 1 }, {
      0.5, 0.5, 0.5, 0.5 },
      { 0.5, 0.5 + e, 0.5, 0.5 }, { 0.5, 0.5, -0.5, 0.5 - e }, { 1, e, 0, -e } } do
      list[#list + 1] = kit.rounded(real, unit(s))
    end
    return list
  end

  -- The commands in the emitted code of both types and, where the library has them, there: fn(commands, real) judges.
  local function both(row, text, o)
    for _, real in ipairs(kit.reals) do
      local inputs = o.inputs(real)
      local commands = { { "init", table.unpack(o.init or {}) } }
      for i, x in ipairs(inputs) do commands[i + 1] = { o.word, table.unpack(x) } end
      local worst = 0.0
      local rows = bodies.ask(text, real, commands)
      for i, x in ipairs(inputs) do worst = kit.worst(worst, rows[1][1] == 0 and o.error(rows[i + 1], x) or
        math.huge) end
      row(o.word, real, worst, o.count * kit.u[real])
      if real == "double" then
        worst = 0.0
        commands = {}
        for i, x in ipairs(inputs) do commands[i] = { o.library or o.word, table.unpack(o.as and o.as(x) or x) } end
        for i, a in ipairs(bodies.library(commands)) do
          worst = kit.worst(worst, a[1] == 0 and o.error({ table.unpack(a, 2) }, inputs[i]) or math.huge)
        end
        row("library", "long double", worst, o.count * kit.u.double)
      end
    end
  end

  return { title = "Frames and kinematics", about = "Half turns, gimbal lock, turning frames, energy and momentum " ..
    "of far bodies.",
    cases = {
      { name = "momentum_turned_by_almost_half_a_turn", fast = true,
        why = "q L q* with w = 0 and 1e-12, and where the matrix' trace is 0",
        naive = "the matrix' angle by acos((trace - 1)/2) and its axis by the antisymmetric part, then Rodrigues",
        oracle = "q L q* in exact rationals of the rounded q",
        bound = "12 u of |L|: I w, two cross products and sums of three, |q|^2 off by 4 u",
        run = function(row)
          local s = unit { 1e-9, 3, -1, 2 }
          local trace = 4 * s[1] ^ 2 - 1
          local angle = math.acos(math.max(-1, (trace - 1) / 2))
          local sine = math.sin(angle)
          local function axis(i) return 4 * s[1] * s[i] / (2 * sine) end -- (R_jk - R_kj)/(2 sin)
          local worst = 0.0
          for i = 2, 4 do worst = kit.worst(worst, math.abs(axis(i) - s[i])) end
          row.naive(worst)
          local w = { 0.7, -0.3, 0.5 }
          both(row, scene, { word = "momentum", count = 12, init = { 1, 2, 3 }, inputs = function(real)
              local list = {}
              for i, a in ipairs(attitudes(real)) do
                list[i] = { a[1], a[2], a[3], a[4], table.unpack(kit.rounded(real, w)) }
              end
              return list
            end,
            as = function(x) return { 1, 1, 2, 3, 0, 0, 0, table.unpack(x) } end,
            error = function(got, x)
              local e = exact(x)
              local L = { e[5], q(2) * e[6], q(3) * e[7] }
              local square = dot({ table.unpack(e, 1, 4) }, { table.unpack(e, 1, 4) })
              local want = sandwich(e, L)
              for i = 1, 3 do want[i] = want[i] / square end
              return off(got, want, length(L))
            end })
        end },
      { name = "momentum_of_a_quaternion_that_is_not_unit", fast = true,
        why = "|q| = 1.03: what a stepper may hand over within a step; q L q* is then |q|^2 times as long",
        naive = "2 w (v x L) and its kin with 1 - 2 (y^2 + z^2) on the diagonal: no rotation when |q| is not 1",
        oracle = "q L q* in exact rationals",
        bound = "12 u of |L|: both take the polynomial q L q*, which is |q|^2 times the rotation (NAME_momentum " ..
          "says |q| = 1)",
        run = function(row)
          local s, k = unit { 1, 2, -1, 3 }, 1.03
          for i = 1, 4 do s[i] = k * s[i] end
          row.naive(math.abs((1 - 2 * (s[3] ^ 2 + s[4] ^ 2)) - (s[1] ^ 2 + s[2] ^ 2 - s[3] ^ 2 - s[4] ^ 2)))
          local function want(x)
            local e = exact(x)
            local L = { e[5], q(2) * e[6], q(3) * e[7] }
            return sandwich(e, L), length(L)
          end
          both(row, scene, { word = "momentum", count = 12, init = { 1, 2, 3 }, inputs = function(real)
              return { kit.rounded(real, { s[1], s[2], s[3], s[4], 0.7, -0.3, 0.5 }) }
            end,
            as = function(x) return { 1, 1, 2, 3, 0, 0, 0, table.unpack(x) } end,
            error = function(got, x) return off(got, want(x)) end })
        end },
      { name = "quaternion_of_a_matrix_at_half_a_turn", fast = true,
        only = "double", because = "the emitted code has quaternions throughout and reads no matrix",
        why = "trace -1, where 1 + trace vanishes, and trace 0, where a switch of cases would lie",
        naive = "w = sqrt(1 + trace)/2 and the differences over 4 w",
        oracle = "the quaternion that the matrix was made of, rounded entries: there and back",
        bound = "16 u: rounding nine entries moves the rotation by at most 3 u in angle, the largest of four sums " ..
          "has no " ..
          "condition above 4, and one rounding of each component",
        run = function(row)
          local list, worst = attitudes "double", 0.0
          local there = {}
          for i, s in ipairs(list) do there[i] = { "to_matrix", table.unpack(s) } end
          local matrices, back, naive = bodies.library(there), {}, 0.0
          for i, a in ipairs(matrices) do back[i] = { "from_matrix", table.unpack(a, 2) } end
          for i, a in ipairs(bodies.library(back)) do
            local four = exact(list[i])
            local n, sign = length(four), R.new(R.sign(dot(exact { table.unpack(a, 2, 5) }, four)))
            local want = {}
            for k = 1, 4 do want[k] = sign * four[k] / n end
            worst = kit.worst(worst, a[1] == 0 and off({ table.unpack(a, 2, 5) }, want, q(1)) or math.huge)
            local m = { table.unpack(matrices[i], 2) }
            local w = math.sqrt(1 + m[1] + m[5] + m[9]) / 2
            local x = (m[8] - m[6]) / (4 * w)
            naive = kit.worst(naive, off({ math.abs(w), math.abs(x) }, { R.abs(want[1]), R.abs(want[2]) }, q(1)))
          end
          row.naive(naive)
          row("from_matrix", "double", worst, 16 * kit.u.double)
        end },
      { name = "yaw_pitch_roll_at_the_pole", fast = true,
        only = "double", because = "the emitted code has no yaw, pitch and roll",
        why = "pitch 90 degrees less 1e-3 .. 1e-16 rad: yaw and roll turn about one line",
        naive = "pitch = asin(2 (w y - x z)), yaw and roll by atan2 of two products that vanish",
        oracle = "the attitude itself: there and back, in the exact rationals of the rounded angles",
        bound = "20 u of a turn: three angles of up to 2 pi rounded once move the attitude by 3 pi u, products 3 u",
        run = function(row)
          local there, list, naive, worst = {}, {}, 0.0, 0.0
          for _, d in ipairs { 0, 1e-16, 1e-12, 1e-8, 1e-5, 1e-3 } do
            for _, s in ipairs { 1, -1 } do there[#there + 1] = { "from_ypr", 0.7, s * (math.pi / 2 - d), -1.1 } end
          end
          for i, a in ipairs(bodies.library(there)) do
            list[i] = { table.unpack(a, 2, 5) }
          end
          local angles, back = {}, {}
          for i, s in ipairs(list) do angles[i] = { "to_ypr", table.unpack(s) } end
          for i, a in ipairs(bodies.library(angles)) do back[i] = { "from_ypr", table.unpack(a, 2, 4) } end
          for i, a in ipairs(bodies.library(back)) do
            worst = kit.worst(worst, kit.angle({ table.unpack(a, 2, 5) }, list[i]))
          end
          for _, s in ipairs(list) do
            local w, x, y, z = table.unpack(s)
            local ypr = { "from_ypr", math.atan(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)),
              math.asin(math.max(-1, math.min(1, 2 * (w * y - x * z)))), math.atan(2 * (w * x + y * z), 1 - 2 *
                (x * x + y * y)) }
            naive = kit.worst(naive, kit.angle({ table.unpack(bodies.library { ypr }[1], 2, 5) }, s))
          end
          row.naive(naive)
          row("to_ypr, from_ypr", "double", worst, 20 * kit.u.double)
        end },
      { name = "transport_of_huge_and_tiny_terms", fast = true,
        why = "dA/dt = dA'/dt + w x A with terms that are 1e8 apart, and A along w to 1e-8",
        naive = "the difference quotient of the turned vector over 1e-6 s",
        oracle = "the definition in exact rationals",
        bound = "3 u of |dA'/dt| + |w||A|: a product, a difference, a sum",
        run = function(row)
          local h, w = 1e-6, 3.0
          row.naive(math.abs((math.sin(w * h) - 0) / h - w) / w + math.abs((math.cos(w * h) - 1) / h) / w)
          both(row, scene, { word = "rate", count = 3, init = { 1, 2, 3 }, inputs = function(real)
              local list = {}
              for _, x in ipairs { { 1e8, 2, -3, 1e8, 2, -3.00000001, 1e-8, 2e-8, -1 }, { 1, 2, 3, 1, 2, 3, 1e-9,
                -1e9, 1 },
                { 1e-12, 1e12, 1, 1e12, 1e-12, 1, 1, 1, 1 }, { 1e9, 1e9, -1e9, 1e9, 1e9 + 64, -1e9, 0, 0, 1 } } do
                list[#list + 1] = kit.rounded(real, x)
              end
              return list
            end,
            error = function(got, x)
              local e = exact(x)
              local w_, A, d = { e[1], e[2], e[3] }, { e[4], e[5], e[6] }, { e[7], e[8], e[9] }
              local c = cross(w_, A)
              return off(got, { d[1] + c[1], d[2] + c[2], d[3] + c[3] }, length(d) + length(w_) * length(A))
            end })
        end },
      { name = "acceleration_of_a_point_along_the_axis", fast = true,
        why = "w x (w x r) for r along w to 1e-8, 2 w x v and w' x r of other sizes: each term is asked for",
        naive = "w (w . r) - r w^2: two terms that cancel where r lies along w",
        oracle = "the definition in exact rationals",
        bound = "9 u of |a| + 2|w||v| + |w'||r| + |w|^2|r|: the inner product w x r is off by 2 u |w||r|, the outer " ..
          "one by as much",
        run = function(row)
          local w, r = { 1, 2, 3 }, { 1, 2, 3.00000001 }
          local wr, ww = 0.0, 0.0
          for i = 1, 3 do wr, ww = wr + w[i] * r[i], ww + w[i] * w[i] end
          local terms, double = cross(exact(w), cross(exact(w), exact(r))), {}
          for i = 1, 3 do double[i] = w[i] * wr - r[i] * ww end
          row.naive(off(double, terms, length(terms)))
          both(row, scene, { word = "acceleration", count = 9, init = { 1, 2, 3 }, inputs = function(real)
              local list = {}
              for _, x in ipairs { { 1, 2, 3, 1e-3, 0, 1, 1, 2, 3.00000001, 1e-6, 1, 0, 1, 1, 1 },
                { 1e6, 2e6, -1e6, 1, 1e-9, 3, 1e9, 2e9, -1e9, 1, 2, 3, 1e-5, 1, 2 },
                { 1e-9, 1, 1e-9, 1e-12, 1, 1e6, 1e6, 1e-6, 1, 1e3, 1e-3, 1, 0, 0, 0 } } do
                list[#list + 1] = kit.rounded(real, x)
              end
              return list
            end,
            error = function(got, x)
              local e, v = exact(x), {}
              for k = 1, 5 do v[k] = { e[3 * k - 2], e[3 * k - 1], e[3 * k] } end
              local w_, dw, r_, dr, a = table.unpack(v)
              local coriolis, euler, inner = cross(w_, dr), cross(dw, r_), cross(w_, r_)
              local central, want = cross(w_, inner), {}
              for i = 1, 3 do
                want[i], want[3 + i], want[6 + i] = q(2) * coriolis[i], euler[i], central[i]
                want[9 + i] = a[i] + want[i] + want[3 + i] + want[6 + i]
              end
              local size = length(a) + q(2) * length(w_) * length(dr) + length(dw) * length(r_) + dot(w_, w_) *
                length(r_)
              return off(got, want, size)
            end })
        end },
      { name = "energy_of_particles_far_and_along_the_axis", fast = true,
        why = "four particles 1e6 m away that turn about a line almost through them: w.I.w/2 is 1e12 times the energy",
        naive = "w.I.w/2 with the tensor about the origin",
        oracle = "the definition, sum m (w x r)^2/2, in exact rationals",
        bound = "8 u of sum m |w||r||w x r|: by the definition each w x r is off by 2 u |w||r|, and is squared",
        run = function(row)
          local D = { double = 2.0 ^ 20, float = 2.0 ^ 10 }
          local function places(x)
            local m, a, b, c = x[1], x[2], x[3], x[4]
            return { { m, a, b, c }, { m, a + q(1), b, c }, { m, a, b + q(1), c }, { m, a, b, c + q(2) } }
          end
          local function energy(p, w)
            local T, size = q(0), q(0)
            for _, b in ipairs(places(p)) do
              local r = { b[2], b[3], b[4] }
              local v = cross(w, r)
              T, size = T + b[1] * dot(v, v) / q(2), size + b[1] * length(w) * length(r) * length(v)
            end
            return T, size
          end
          for _, real in ipairs(kit.reals) do
            local d = D[real]
            local p = kit.rounded(real, { 1.5, d + 0.3, 2 * d + 0.1, 0.7 - d })
            local w = kit.rounded(real, { 1, 2 + 1 / d, -1 })
            local x = { 1, 0, 0, 0, w[1], w[2], w[3] }
            local T, size = energy(exact(p), exact(w))
            local rows = bodies.ask(particles, real, { { "init", table.unpack(p) }, { "particles",
              table.unpack(x) }, { "inertia" } },
              "#define PARTICLES\n")
            row("particle_energy", real, rows[1][1] == 0 and bodies.error(rows[2][1], T, size) or math.huge, 8 *
              kit.u[real])
            if real == "double" then
              local I = rows[3]
              local L = { I[1] * w[1] + I[4] * w[2] + I[5] * w[3], I[4] * w[1] + I[2] * w[2] + I[6] * w[3],
                I[5] * w[1] + I[6] * w[2] + I[3] * w[3] }
              row.naive(bodies.error((L[1] * w[1] + L[2] * w[2] + L[3] * w[3]) / 2, T, size))
              local command = { "particles", 4, w[1], w[2], w[3] }
              for _, b in ipairs(places(exact(p))) do
                for k = 1, 4 do command[#command + 1] = R.todouble(b[k]) end
              end
              local a = bodies.library { command }[1]
              row("library", "long double", a[1] == 0 and bodies.error(a[2], T, size) or math.huge, 8 * kit.u.double)
            end
          end
        end },
      { name = "momentum_with_a_far_centre_of_mass", fast = true,
        why = "L = I w about an origin 1e6 m from a body of 1 m: its own spin is 1e-12 of the sum",
        naive = "M R x (w x R) alone, without the body's own tensor",
        oracle = "sum m r x (w x r), exact rationals",
        bound = "10 u of |I||w|: an entry to 6 u, products, a sum of three",
        run = function(row)
          local function body(p)
            local out = M.none()
            for _, s in ipairs { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 2 } } do
              out = M.add(out, M.point(p[1], { p[2] + q(s[1]), p[3] + q(s[2]), p[4] + q(s[3]) }))
            end
            return out
          end
          for _, real in ipairs(kit.reals) do
            local p = kit.rounded(real, real == "double" and { 1.5, 1e6 + 0.1, 5e5, 0.3 - 1e6 } or { 1.5, 256.1,
              128.3, -255.7 })
            local w = kit.rounded(real, { 0.3, -0.7, 0.2 })
            local I, e = M.tensor(body(exact(p))), exact(w)
            local want = { I[1] * e[1] + I[4] * e[2] + I[5] * e[3], I[4] * e[1] + I[2] * e[2] + I[6] * e[3],
              I[5] * e[1] + I[6] * e[2] + I[3] * e[3] }
            local size = bodies.largest(I) * length(e)
            local rows = bodies.ask(particles, real, { { "init", table.unpack(p) }, { "momentum_body", 1, 0, 0, 0,
              w[1], w[2], w[3] } },
              "#define PARTICLES\n")
            row("momentum_body", real, rows[1][1] == 0 and off(rows[2], want, size) or math.huge, 10 * kit.u[real])
            if real == "double" then
              local command, heavy = { "energy" }, { 4 * p[1], p[2], p[3], p[4] }
              for n = 1, 6 do command[1 + n] = R.todouble(I[n]) end
              for k = 1, 3 do command[7 + k] = w[k] end
              local a = bodies.library { command }[1]
              local T = dot(want, e) / q(2)
              row("library (energy)", "long double", a[1] == 0 and bodies.error(a[2], T, size * length(e)) or
                math.huge, 10 * kit.u.double)
              local r = { heavy[2] + 0.25, heavy[3] + 0.25, heavy[4] + 0.5 }
              local rr, wr = r[1] ^ 2 + r[2] ^ 2 + r[3] ^ 2, r[1] * w[1] + r[2] * w[2] + r[3] * w[3]
              local L = {}
              for k = 1, 3 do L[k] = heavy[1] * (w[k] * rr - r[k] * wr) end
              row.naive(off(L, want, size))
            end
          end
        end },
    } }
end
