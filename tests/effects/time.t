#!/usr/bin/env lua5.4
-- time.t - gravity gradient and changing tensors against tables of 32 digits, by two emitted steppers and the library;
-- and what holds exactly: Jacobi's integral, L in space, Kepler's equation, the bound of Kapitza's pendulum.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Emitted rk4 with steps of 1e-3 rad of the fastest rate: its error of about (h w)^4 w t/2000 is below 1e-13, what
-- rounding adds in up to 1e5 steps below 1e-11.  Emitted Taylor: its tolerance of 1e-15 a step, up to some hundreds of
-- steps.  Library: 1e-12, all steps being in long double.  Conserved quantities: the same bounds.
--
-- The satellite in low orbit tumbles past the separatrix: at 30000 s half a unit of a double in each input counts
-- 4.5e-9 together (measured here, see conditioning), so that is the measure of what can be asked for.  Library: its
-- inputs are the table's but for mu = n^2, a quarter of a unit of n; its some 300 steps round to 2^-64, 2^-11 of a
-- unit, walking: 0.01 of the measure; asked for 1/32.  Emitted Taylor: 300 steps in double, walking, before the
-- growth sets in at 6000 s some 60: asked for 1.  Emitted rk4 rounds the state once a step, 13000 times before 6000
-- s, by 0.3 units on average of components that on average are half of the largest: in quadrature 114 0.3 0.5 = 17
-- units of an average input, 2 of the eight together; asked for 8.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local rows = require "tests.reference.effects_time"

local dir = program.directory()
local binary = program.quick()

local tensors = { -- I(t) of the table: the body's at t = 0 and what is added, as a scene and as numbers
  ["(1+t/8, 2-t/32, 2.5+t/16)"] = { { "1", "2", "2.5" }, "xx = t/8, yy = -t/32, zz = t/16",
    function(t) return { 1 + t / 8, 2 - t / 32, 2.5 + t / 16 } end },
  ["(2,2,1+0.5 cos t)"] = { { "2", "2", "1" }, "zz = 0.5*cos(t)",
    function(t) return { 2, 2, 1 + 0.5 * math.cos(t) } end },
}

local function scene(I, effects, w, q, head)
  return string.format("%s\nreturn scene { name = \"row\", body = tensor { mass = 1, com = {0, 0, 0}, xx = %s, " ..
    "yy = %s, zz = %s },\n  effects = { %s },\n  initial = { omega = { %s }, attitude = { %s } } }\n", head or "",
    I[1], I[2], I[3], effects, table.concat(w, ", "), table.concat(q, ", "))
end

-- The rows of the run as tables by column.
local function run(text, times, options)
  program.write(dir .. "/row.lua", text)
  local command = string.format("timeout 120 %s run %s/row.lua --at %s %s >%s/stdout 2>%s/stderr", binary, dir,
    table.concat(times, ","), options, dir, dir)
  assert(program.shell(command) == 0, program.read(dir .. "/stderr"))
  local out, names = {}, nil
  for line in program.read(dir .. "/stdout"):gmatch "([^\n]*)\n" do
    local cells, row = {}, {}
    for cell in line:gmatch "[^,]+" do cells[#cells + 1] = cell end
    for i, name in ipairs(names or {}) do row[name] = tonumber(cells[i]) end
    if names then out[#out + 1] = row end
    names = names or cells
  end
  return out
end

local function roads(fastest)
  return { { "emitted rk4", string.format("--engine generated --method rk4 --step %.17g", 1e-3 / fastest), 1e-11,
    8 }, { "emitted Taylor", "--engine generated --method taylor --tolerance 1e-15", 1e-11, 1 },
    { "library", "", 1e-12, 1 / 32 } }
end

local function worst_of(got, want, names)
  local size, error = 0.0, 0.0
  for i, n in ipairs(names) do
    size, error = math.max(size, math.abs(want[i])), math.max(error, math.abs(got[n] - want[i]))
    if got[n] ~= got[n] then error = math.huge end
  end
  return error / size
end

local rates, attitude = { "wx", "wy", "wz" }, { "qw", "qx", "qy", "qz" }

-- How far each sample moves, as worst_of measures, when each input (n, w, q) does by 2^-53, half a unit of a double:
-- of n by itself, of w by the largest, of q by 1; the moduli added up.  By the library, whose steps are in long double;
-- moves of 2^-48 are divided by 32, so that what rounding the results adds is below 1e-17.  make(n, w, q): the scene.
local function conditioning(make, n, w, q, times)
  local before, out, most = run(make(n, w, q), times, ""), {}, 0.0
  for i = 1, 3 do most = math.max(most, math.abs(tonumber(w[i]))) end
  local function exact(x) return string.format("%.17g", x) end
  local function add(list)
    for i, g in ipairs(list) do
      local x, y = {}, {}
      for k, name in ipairs(rates) do x[k] = before[i][name] end
      for k, name in ipairs(attitude) do y[k] = before[i][name] end
      out[i] = (out[i] or 0.0) + math.max(worst_of(g, x, rates), worst_of(g, y, attitude)) / 32
    end
  end
  add(run(make(exact(tonumber(n) * (1 + 2.0 ^ -48)), w, q), times, ""))
  for k = 1, 7 do
    local v, u = { table.unpack(w) }, { table.unpack(q) }
    if k <= 3 then v[k] = exact(tonumber(v[k]) + most * 2.0 ^ -48) end
    if k > 3 then u[k - 3] = exact(tonumber(u[k - 3]) + 2.0 ^ -48) end
    add(run(make(n, v, u), times, ""))
  end
  return out
end

for _, row in ipairs(tier.every(4, rows)) do
  local times, fastest, w = {}, row.n and tonumber(row.n) or 1.0, { table.unpack(row.x0, 1, 3) }
  local text, make
  local q = { table.unpack(row.x0, 4, 7) }
  local changing = tensors[row.I_of_t]
  if changing then
    local I = changing[3](0.0)
    for i = 1, 3 do w[i] = string.format("%s/%s", row.x0[i], tostring(I[i])) end
    text = scene(changing[1], "effect.inertia_rate { " .. changing[2] .. " }", w, q)
  else
    make = function(n, rate, turn)
      return scene(row.I, "effect.gravity_gradient { mu = n^2 * quantity(1, \"m^3\"), orbit = { radius = 1 } }", rate,
        turn, "local n = param(\"n\", " .. n .. ", \"rad/s\")")
    end
    text = make(row.n, w, q)
  end
  local want = {}
  for i, s in ipairs(row) do
    times[i], want[i] = s.t, {}
    for k = 1, 7 do want[i][k] = tonumber(s[k]) end
    local I = changing and changing[3](tonumber(s.t)) or { 1, 1, 1 }
    for k = 1, 3 do
      want[i][k] = want[i][k] / I[k]
      fastest = math.max(fastest, math.abs(want[i][k]))
    end
  end
  if changing then -- |w| is at most |L| over the least moment
    for t = 0, 20 do fastest = math.max(fastest, 3 / math.min(table.unpack(changing[3](t)))) end
  end
  if row.n and tonumber(row.n) < 1 then fastest = 2 * tonumber(row.n) end
  local unit = make and conditioning(make, row.n, w, q, times) or {}
  for _, road in ipairs(roads(fastest)) do
    local got, worst = run(text, times, road[2]), 0.0
    tap.is(#got, #row, row.id .. ", " .. road[1] .. ": a state for every time")
    for i, g in ipairs(got) do
      local e = math.max(worst_of(g, want[i], rates), worst_of(g, { table.unpack(want[i], 4, 7) }, attitude))
      if (unit[i] or 0) > 1e-11 then
        tap.ok(e <= road[4] * unit[i], string.format("%s, %s: t = %s, %g times what half units of the inputs " ..
          "count, %.2g", row.id, road[1], row[i].t, road[4], unit[i]), string.format("%.3g", e))
      else
        worst = math.max(worst, e)
      end
    end
    tap.ok(worst <= road[3], string.format("%s, %s: %g", row.id, road[1], road[3]), string.format("%.3g", worst))
  end
end

-- Jacobi's integral T + 3/2 n^2 o.I o - n L_z of the circular orbit, from columns alone.
local function turned(q, v) -- v of inertial axes in body axes
  local w, x, y, z = q[1], q[2], q[3], q[4]
  return { (w * w + x * x - y * y - z * z) * v[1] + 2 * (x * y + w * z) * v[2] + 2 * (x * z - w * y) * v[3],
    2 * (x * y - w * z) * v[1] + (w * w - x * x + y * y - z * z) * v[2] + 2 * (y * z + w * x) * v[3],
    2 * (x * z + w * y) * v[1] + 2 * (y * z - w * x) * v[2] + (w * w - x * x - y * y + z * z) * v[3] }
end

do
  local I, n = { 1.0, 2.5, 3.0 }, 1.0
  local text = scene({ "1", "2.5", "3" }, "effect.gravity_gradient { mu = 1, orbit = { radius = 1 } }",
    { "0.3", "-0.2", "1.1" }, { "0.9", "0.1", "0.3", "-0.3" })
  for _, road in ipairs(roads(2.0)) do
    local first
    for _, g in ipairs(run(text, { "0", "1", "10", "50" }, road[2])) do
      local o = turned({ g.qw, g.qx, g.qy, g.qz }, { math.cos(n * g.t), math.sin(n * g.t), 0.0 })
      local J = g.energy - n * g.Lz
      for i = 1, 3 do J = J + 1.5 * n * n * I[i] * o[i] * o[i] end
      first = first or J
      tap.near(J, first, 10 * road[3], 0, string.format("%s: Jacobi's integral at t = %g", road[1], g.t),
      "ten times the tolerance of the road")
    end
  end
end

-- The true anomaly of an elliptic orbit by Kepler's equation M = E - e sin E, tan(f/2) = sqrt((1+e)/(1-e)) tan(E/2):
-- from the perigee with a = mu = 1 the time of E is E - e sin E.
do
  local e, E, times, want = 0.6, { 0.5, 1.5, 3.0, 3.2, 5.0 }, {}, {}
  for i, x in ipairs(E) do
    times[i] = string.format("%.17g", x - e * math.sin(x))
    want[i] = 2 * math.atan(math.sqrt((1 + e) / (1 - e)) * math.sin(x / 2), math.cos(x / 2))
  end
  local text = scene({ "1", "2", "2.5" }, "effect.gravity_gradient { mu = 1, orbit = { a = 1, e = 0.6 } }",
    { "0.1", "0", "0.2" }, { "1", "0", "0", "0" })
  for _, road in ipairs(roads(8.0)) do
    for i, g in ipairs(run(text, times, road[2])) do
      tap.near(g.anomaly, want[i], 4 * road[3], 0, road[1] .. ": true anomaly at E = " .. E[i],
      "four times the tolerance of the road")
    end
  end
end

-- The energy sink: L in space stays, |L| too, the energy falls to that of the turn about the largest moment.
do
  local text = scene({ "1", "2", "2.5" }, "effect.dissipation { k = 0.2 }", { "0.7", "-0.3", "0.9" },
    { "0.5", "0.5", "0.5", "0.5" })
  for _, road in ipairs(roads(2.0)) do
    local list, before = run(text, { "0", "1", "5", "20", "120" }, road[2]), math.huge
    for i, g in ipairs(list) do
      if i < 5 then tap.ok(g.energy < before, road[1] .. ": the energy falls") end
      before = g.energy
      for _, n in ipairs { "Lx", "Ly", "Lz" } do
        tap.near(g[n], list[1][n], 2 * road[3], 0, string.format("%s: %s at t = %g", road[1], n, g.t),
      "twice the tolerance of the road")
      end
    end
    local last = list[#list]
    local L2 = last.Lx ^ 2 + last.Ly ^ 2 + last.Lz ^ 2
    tap.near(last.energy, L2 / 5, 10 * road[3], 0, road[1] .. ": at last L^2/(2 I3)",
      "ten times the tolerance of the road")
  end
  -- dT/dt = -k |L x w|^2 at the start, by a difference over 1e-4 s whose error is T'' 1e-4/2, T'' being below 10
  local g = run(text, { "0", "0.0001" }, "")
  local L, w = { 0.7, -0.6, 2.25 }, { 0.7, -0.3, 0.9 }
  local c = { L[2] * w[3] - L[3] * w[2], L[3] * w[1] - L[1] * w[3], L[1] * w[2] - L[2] * w[1] }
  tap.near((g[2].energy - g[1].energy) / 1e-4, -0.2 * (c[1] ^ 2 + c[2] ^ 2 + c[3] ^ 2), 0, 5e-4, "T' = -k |L x w|^2",
      "a difference over 1e-4 s of a function that bends by 5 1/s")
end

-- One lit plate in the sun, the other in the dark: N = centre x F by hand, and I w' = N from rest.
do
  local P, A, rho, c = 1361 / 299792458, 3.0, 0.25, 0.8 -- normal x, sun at cosine 0.8
  local text = scene({ "1e-9", "1e-9", "1e-9" }, "effect.solar_pressure { sun = { 4, 3, 0 }, plates = { { area = 3, " ..
    "normal = { 2, 0, 0 }, centre = { 0, 0, 1 }, reflectivity = 1/4 }, { area = 5, normal = { -1, 0, 0 }, " ..
    "centre = { 1, 2, 3 } } } }", { "0", "0", "0" }, { "1", "0", "0", "0" })
  local Fx, Fy = -P * A * c * ((1 - rho) * 0.8 + 2 * rho * c), -P * A * c * (1 - rho) * 0.6
  local h = 1e-6 -- w/h is N/I up to changes of the attitude, N/I h^2/2 = 6e-9 of the whole
  for _, road in ipairs { { "library", "" }, { "emitted", "--engine generated --method rk4 --step 1e-7" } } do
    local g = run(text, { "0.000001" }, road[2])[1]
    tap.near(g.wx / h * 1e-9, -Fy, 2e-8, 0, road[1] .. ": Nx = -Fy",
      "the angle that has turned in 1e-9 s, and the rounding of h")
    tap.near(g.wy / h * 1e-9, Fx, 2e-8, 0, road[1] .. ": Ny = Fx",
      "the angle that has turned in 1e-9 s, and the rounding of h")
    tap.near(g.wz, 0, 0, 1e-12, road[1] .. ": no Nz",
      "the rounding of h")
  end
end

-- Kapitza: the rod upside down stands when amplitude^2 rate^2 > 2 g l, and falls when it does not.
local shaken = "local rate = param(\"rate\", 200, \"rad/s\")\nreturn scene { name = \"row\",\n" ..
  "  body = tensor { mass = 0.1, com = {0, 0, 0.15}, xx = 75e-5, yy = 75e-5, zz = 1e-5 }, origin = {0, 0, 0},\n" ..
  "  effects = { effect.gravity {}, %s },\n  initial = { attitude = { axis = \"y\", angle = 0.1 } } }\n"
local function height(amplitude, at, options)
  local effect = string.format("effect.pivot { amplitude = %s, rate = rate }", amplitude)
  if not amplitude then
    effect = "effect.pivot { acceleration = { 0, 0, quantity(-0.02, \"m\")*rate^2*cos(rate*t) } }"
  end
  local low, list = 1.0, run(string.format(shaken, effect), at, options)
  for _, g in ipairs(list) do low = math.min(low, 1 - 2 * (g.qx ^ 2 + g.qy ^ 2)) end
  return low, list[#list]
end
local at = {}
for i = 1, 40 do at[i] = tostring(i / 20) end
for _, options in ipairs { "", "--engine generated --method rk4 --step 0.0001" } do
  tap.ok(height("0.02", at, options) > 0.97, "shaken it stands " .. options)
  tap.ok(height("0.005", at, options) < -0.5, "shaken too little it falls " .. options)
  local _, a = height("0.02", { "1.5" }, options)
  local _, b = height(nil, { "1.5" }, options)
  tap.near(a.wy, b.wy, 1e-9, 1e-11, "the same acceleration as an expression of t " .. options,
      "the tolerance of both runs")
end

program.finish()
tap.done()
