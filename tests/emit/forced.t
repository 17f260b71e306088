#!/usr/bin/env lua5.4
-- forced.t - the emitted closed forms of motions with effects, to the last digit and for long times.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Expected states with 400 bits: of damped motion and gyrostats from the free symmetric top in `precise` (which
-- tests/dynamics/closed.t puts into the equations of motion), by a change of time and by the moment I3 + h/s that turns
-- a gyrostat into a top with the same motion; of axial torque and damping from the textbook's formula.  The rows of
-- tests/reference/forced_top.h that have a closed form come with 32 digits.  That these formulas are true is also
-- asked of the library, by `polhode check`.  forced.c measures.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"
local precise = require "generator.dynamics.closed.precise"

local dir = program.directory()
local BITS = 400

-- As in symmetric.t: 18 units of 2^-52, and of 2^-23.  The phase of axial torque is a sum of three, each to 2^-100.
local BAR, NORM = { double = 4e-15, float = 4e-6 }, { double = 4e-16, float = 4e-16 * 2.0 ^ 29 }

local function exp(x) return R.apply("exp", BITS, x) end
local function list(v)
  local out = {}
  for i, x in ipairs(v) do out[i] = R.lift(x) end
  return out
end

-- ---- expected states ----

-- (1 - exp(-rate t))/rate
local function clock(rate, t) return R.sign(rate) == 0 and t or R.round((R.one - exp(-rate * t)) / rate, BITS) end

local function damped(I1, I3, k, rate, x0, t)
  local x = precise(I1, I3, k, x0, clock(rate, t), BITS)
  local fade = R.sign(rate) == 0 and R.one or exp(-rate * t)
  for i = 5, 7 do x[i] = x[i] * fade end
  return x
end

-- h: the momentum along k, over |k|
local function gyrostat(I1, I3, k, h, x0, t)
  local s = (k[1] * x0[5] + k[2] * x0[6] + k[3] * x0[7]) / (k[1] ^ 2 + k[2] ^ 2 + k[3] ^ 2)
  return precise(I1, I3 + h / s, k, x0, t, BITS)
end

-- axis z; n torque, h momentum, c1 and c3 damping
local function axial(I1, I3, n, h, c1, c3, x0, t)
  local l1, l3, f2 = c1 / I1, c3 / I3, t * t / 2
  local tau = clock(l3, t)
  if R.sign(l3) ~= 0 then f2 = (t - tau) / l3 end -- integral of tau
  local s = x0[7] * (R.sign(l3) == 0 and R.one or exp(-l3 * t)) + n / I3 * tau
  local angle = (I3 - I1) / I1 * (x0[7] * tau + n / I3 * f2) + h / I1 * t
  local fade = R.sign(l1) == 0 and R.one or exp(-l1 * t)
  local sine, cosine = R.apply("sin", BITS, angle), R.apply("cos", BITS, angle)
  return { R.zero, R.zero, R.zero, R.zero, fade * (cosine * x0[5] - sine * x0[6]), fade * (sine * x0[5] +
    cosine * x0[6]), s }
end

-- ---- scenes ----

local x0 = list { "1/2", "-1/2", "1/2", "1/2", "1/2", "-1/4", "2" }
local z = list { 0, 0, 1 }
local short, long = { "1/8", "21/2", "1000", "-1/4" }, { 1048576, "-1048575/8", 1000000007 }

local cases = {}
local function case(name, body, effects, full, times, f)
  cases[#cases + 1] = { name = name, body = body, effects = effects, full = full, times = times, f = f, x0 = x0 }
end
local function all(more)
  local out = {}
  for _, t in ipairs(short) do out[#out + 1] = t end
  for _, t in ipairs(more or {}) do out[#out + 1] = t end
  return out
end

local top, ball = "tensor { mass = 1, xx = 3, yy = 3, zz = 5 }", "tensor { mass = 1, xx = 3, yy = 3, zz = 3 }"
local function n(x) return R.lift(x) end
case("gyrostat", top, "effect.rotor { axis = {0, 0, 1}, momentum = 7 }", true, all(long), function(t)
  return gyrostat(n(3), n(5), z, n(7), x0, t)
end)
case("despun gyrostat", top, "effect.rotor { axis = {0, 0, -2}, momentum = 4 }, effect.rotor { axis = {0, 0, 1}, " ..
  "momentum = 0.0078125 }", true, all(long), function(t) -- L3 is all but 0
  return gyrostat(n(3), n(5), z, n(-4) + n "1/128", x0, t)
end)
case("ball with a rotor", ball, "effect.rotor { axis = {0, 3, 4}, momentum = 10 }", true, all(long), function(t)
  return gyrostat(n(3), n(3), list { 0, 3, 4 }, n(2), x0, t)
end)
case("damped top", top, "effect.damping { rate = 0.1015625 }", true, { "1/8", "21/2", "-33/4", 300, 700 }, function(t)
  return damped(n(3), n(5), z, n "13/128", x0, t)
end)
case("top damped for long", top, "effect.damping { rate = 0.1015625 }", true, { 1000, 6925 }, function(t)
  return damped(n(3), n(5), z, n "13/128", x0, t) -- exp(y) is 1e-44 and 4e-306, in float not a normal number
end)
cases[#cases].double_only = true
-- rates of 2^-86 grow 10^26 times, of 2^-960 10^295 times: exp(y)/y alone is too large for a product of pairs
for _, c in ipairs { { 86, 590 }, { 960, 6690 } } do
  local start = { table.unpack(x0) }
  for i = 5, 7 do start[i] = start[i] * n(2) ^ -c[1] end
  case("top growing from 2^-" .. c[1], top, "effect.damping { rate = -0.1015625 }", true, { "1/8", c[2] }, function(t)
    return damped(n(3), n(5), z, n "-13/128", start, t)
  end)
  cases[#cases].x0, cases[#cases].double_only = start, c[1] > 100
end
case("top growing", top, "effect.damping { rate = -0.1015625 }", true, { "1/8", "21/2", "-33/4", 64 }, function(t)
  return damped(n(3), n(5), z, n "-13/128", x0, t)
end)
case("top damped by C = I/2^20", top, "effect.damping { c = {3/1048576, 3/1048576, 5/1048576} }", true,
  { "1/8", 1000, 1048576, 16777216 }, function(t) return damped(n(3), n(5), z, n(2) ^ -20, x0, t) end)
case("top damped by nothing", top, "effect.damping { rate = 0 }", true, all(long), function(t)
  return damped(n(3), n(5), z, n(0), x0, t)
end)
case("damped ball", ball, "effect.damping { c = 0.1875 }", true, { "1/8", "21/2", "-33/4", 300 }, function(t)
  return damped(n(3), n(3), nil, n "1/16", x0, t)
end)
case("torque", top, "effect.torque { body = {0, 0, 0.25} }", false, all { 1048576 }, function(t)
  return axial(n(3), n(5), n "1/4", n(0), n(0), n(0), x0, t)
end)
case("damping", top, "effect.damping { c = {0.25, 0.25, 0.03125} }", false, { "1/8", "21/2", "-33/4", 100, 1000 },
  function(t) return axial(n(3), n(5), n(0), n(0), n "1/4", n "1/32", x0, t) end)
case("torque, damping and rotor", top, "effect.torque { body = {0, 0, 6.5} }, effect.damping { c = {0.0078125, " ..
  "0.0078125, 0.25} }, effect.rotor { axis = {0, 0, 1}, momentum = -7 }", false,
  { "1/8", "21/2", "-33/4", 1000, 65536 }, function(t)
  return axial(n(3), n(5), n "13/2", n(-7), n "1/128", n "1/4", x0, t)
end)
case("torque and growth", top, "effect.torque { body = {0, 0, -0.5} }, effect.damping { c = {-0.125, -0.125, -0.25} }",
  false, { "1/8", "21/2", "-33/4", 64 }, function(t)
  return axial(n(3), n(5), n "-1/2", n(0), n "-1/8", n "-1/4", x0, t)
end)
case("torque, all but undamped", top, "effect.torque { body = {0, 0, 0.25} }, effect.damping { c = {0, 0, " ..
  "5/1099511627776} }", false, all { 1048576 }, function(t) -- y from 2^-43 to 2^-20
  return axial(n(3), n(5), n "1/4", n(0), n(0), R.lift(5) * n(2) ^ -40, x0, t)
end)

-- the rows that have a closed form
do
  local wanted = { damping_proportional_to_L = { "effect.damping { c = {%s} }", true },
    body_torque_symmetric_fresnel = { "effect.torque { body = {%s} }", false } }
  local rows = {}
  for id, moments, load, x, t, state in scene.slurp("tests/reference/forced_top.h"):gmatch(
    '{"([^"]+)", FORCED_%u+, {([^}]*)}, {([^}]*)},%s*{([^}]*)}, ([^,]+),%s*{([^}]*)}}') do
    if wanted[id] then
      local function numbers(s, read)
        local out = {}
        for word in s:gmatch "[^,%s]+" do out[#out + 1] = read((word:gsub("L$", ""))) end
        return out
      end
      local c = rows[id]
      if not c then
        local I = numbers(moments, tostring)
        local s = numbers(x, function(w) return R.fromdouble(tonumber(w) + 0.0) end)
        c = { name = id, body = string.format("tensor { mass = 1, xx = %s, yy = %s, zz = %s }", I[1], I[2], I[3]),
          effects = string.format(wanted[id][1], load), full = wanted[id][2], times = {}, rows = {}, double_only = true,
          x0 = { s[4], s[5], s[6], s[7], s[1], s[2], s[3] } }
        rows[id], cases[#cases + 1] = c, c
      end
      local w = numbers(state, R.parse)
      c.times[#c.times + 1] = R.fromdouble(tonumber(t) + 0.0)
      c.rows[#c.rows + 1] = { w[4], w[5], w[6], w[7], w[1], w[2], w[3] }
    end
  end
  tap.ok(rows.damping_proportional_to_L and rows.body_torque_symmetric_fresnel, "forced_top.h was read")
end

-- ---- measured ----

local function two(x) -- the sum of two doubles
  local high = R.todouble(x)
  return string.format("{%a, %a}", high, R.todouble(x - R.fromdouble(high)))
end

-- A float's pairs have 48 bits: beyond a million seconds they are used up.
local function header(c, real)
  local lines, start = {}, {}
  for i, x in ipairs(c.x0) do start[i] = string.format("%a", R.todouble(x)) end
  for i, time in ipairs(c.times) do
    local t = R.lift(time)
    if real == "double" or R.abs(t) <= R.lift(2) ^ 20 then
      local x, row = c.rows and c.rows[i] or c.f(t), {}
      for k = 1, 7 do row[k] = two(x[k]) end
      lines[#lines + 1] = string.format("  {%a, {%s}},", R.todouble(t), table.concat(row, ", "))
    end
  end
  return #lines, "#define FULL " .. (c.full and 1 or 0) .. "\nstatic const double START[7] = {" ..
    table.concat(start, ", ") .. "};\nstatic const struct {\n  double t, x[7][2];\n} expected[] = {\n" ..
    table.concat(lines, "\n") .. "\n};\n"
end

local compilers = { "gcc -std=c11 -O2 -ffp-contract=off", "gcc -std=c11 -O3 -march=native -ffp-contract=fast",
  "clang -std=c11 -O1" }

for number, c in ipairs(tier.every(5, cases)) do
  for _, real in ipairs(c.double_only and { "double" } or { "double", "float" }) do
    local folder = string.format("%s/%d%s", dir, number, real)
    local rows, expected = header(c, real)
    local job = assert(scene.read('return scene { name = "top", body = ' .. c.body .. ", effects = { " .. c.effects ..
      " } }\n"))
    job = scene.plan(job, { real = real })
    if tap.ok(job.closed.kind and job.closed.full == c.full, c.name .. ": has a closed form", job.closed.refused) then
      local files = scene.files(job)
      program.shell("mkdir -p " .. folder)
      for _, name in ipairs { "top.h", "top.c" } do program.write(folder .. "/" .. name, files[name]) end
      program.write(folder .. "/expected.h", expected)
      local command = compilers[number % 3 + 1]
      local what = string.format("%s, %s, %s", c.name, real, command)
      local code = program.shell(string.format("(cd %s && %s -c top.c && gcc -std=c11 -O1 -I%s -o measure " ..
        "$OLDPWD/tests/emit/forced.c top.o -lm && ./measure >out) >%s/log 2>&1", folder, command, folder, folder))
      if tap.ok(code == 0, what .. ": compiles and runs", program.read(folder .. "/log")) then
        local worst, count = 0, 0
        for line in string.gmatch(program.read(folder .. "/out"), "[^\n]+") do
          local t, dw, dq, norm, same = line:match "^row (%S+) (%S+) (%S+) (%S+) (%S+)$"
          dw, dq, norm, same = tonumber(dw), tonumber(dq), tonumber(norm), tonumber(same)
          if not (dw and dw <= BAR[real] and dq <= BAR[real] and norm <= NORM[real] and same == 0) then
            tap.ok(false, what .. ": t = " .. tostring(t and tonumber(t)), line)
          end
          worst, count = math.max(worst, dw or 0, dq or 0), count + 1
        end
        tap.is(count, rows, string.format("%s: %d times, to %.2g", what, count, worst))
      end
    end
  end
end

program.finish()
tap.done()
