#!/usr/bin/env lua5.4
-- closed.t - the free symmetric top in closed form: chosen when it should be, and true.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- precise, which gives the expected numbers of self-tests, is put into the differential equation with hundreds
-- of bits, and compared with tests/reference/free_top.h (closed form at 200 digits and more by other means, checked by
-- Taylor integration; 32 digits printed).  What is emitted is compared with it by the self-tests and by `check`.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"
local precise = require "generator.dynamics.closed.precise"

local BITS = 600

local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end
local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end

local function lifted(list)
  local out = {}
  for i, x in ipairs(list) do out[i] = R.lift(x) end
  return out
end

-- 2^n >= |x|, as an integer; -infinity for 0
local function size(x) return R.sign(x) == 0 and -math.huge or R.log2(x) + 1 end

-- The rates of change of (q, w) for I = alpha 1 + (axial - alpha) k k^T/k^2, from I w' = -w x I w by the inverse
-- I^-1 = 1/alpha + (1/axial - 1/alpha) k k^T/k^2; a rod (axial = 0) keeps its rate along k.
local function rates(alpha, axial, k, x)
  local w = { x[5], x[6], x[7] }
  local dw = { R.zero, R.zero, R.zero }
  if k then
    local k2, kw = dot(k, k), dot(k, w)
    local L = {}
    for i = 1, 3 do L[i] = alpha * w[i] + (axial - alpha) * kw * k[i] / k2 end
    local N = cross(L, w)
    local kN = dot(k, N) / k2
    for i = 1, 3 do
      dw[i] = N[i] / alpha + (R.sign(axial) == 0 and R.zero or (R.one / axial - R.one / alpha) * kN * k[i])
    end
  end
  local a, b, c, d = x[1], x[2], x[3], x[4]
  return { (-b * w[1] - c * w[2] - d * w[3]) / 2, (a * w[1] + c * w[3] - d * w[2]) / 2,
    (a * w[2] + d * w[1] - b * w[3]) / 2, (a * w[3] + b * w[2] - c * w[1]) / 2, dw[1], dw[2], dw[3] }
end

local function energy(alpha, axial, k, x)
  local w = { x[5], x[6], x[7] }
  local T = alpha * dot(w, w)
  if k then T = T + (axial - alpha) * dot(k, w) ^ 2 / dot(k, k) end
  return T / 2
end

-- L in inertial axes, q L q*
local function momentum(alpha, axial, k, x)
  local L = {}
  for i = 1, 3 do
    L[i] = alpha * x[4 + i]
    if k then L[i] = L[i] + (axial - alpha) * dot(k, { x[5], x[6], x[7] }) * k[i] / dot(k, k) end
  end
  local v, a = { x[2], x[3], x[4] }, x[1]
  local once = cross(v, L)
  local twice, out = cross(v, once), {}
  for i = 1, 3 do out[i] = L[i] * (a * a + dot(v, v)) + 2 * (a * once[i] + twice[i]) end
  return out -- (a^2 + v^2) L + 2 a v x L + 2 v x (v x L)
end

-- ---- the differential equation and the integrals ----

local tops = {
  { "prolate about z", "3/100", "1/200", { 0, 0, 1 }, { 1, 0, 0, 0, 1, "1/2", 20 } },
  { "oblate about y", 2, "7/2", { 0, 3, 0 }, { 1, 2, -1, "1/2", "-1/3", 4, "2/5" } },
  { "cube about its corner", "11/12", "1/6", { 1, 1, 1 }, { "1/2", "1/2", "-1/2", "1/2", 2, -1, 5 } },
  { "oblique axis of irrational length", "5/3", "3", { 1, -2, 4 }, { 1, 1, 1, 1, "1/7", "-2/3", 1 } },
  { "rod along (1, 2, 2)", "9/4", 0, { 1, 2, 2 }, { 1, 0, "1/3", 0, 1, -2, "1/2" } },
  { "sphere", 2, 2, nil, { 1, -1, 2, 0, 1, 2, 3 } },
  { "no spin along the axis", 2, 3, { 0, 0, 1 }, { 1, 0, 0, 0, 1, 2, 0 } },
  { "pure spin about the axis", 2, 3, { 0, 0, 1 }, { 1, 0, 0, 0, 0, 0, 7 } },
  { "at rest", 2, 3, { 1, 1, 0 }, { 1, 2, 3, 4, 0, 0, 0 } },
  { "moments of 1e-47, rates of 1e12", "3e-47", "2e-47", { 1, 2, 3 }, { 1, 0, 0, 0, "1e12", "3e12", "-2e12" }, 1e-12 },
  { "moments of 1e30, rates of 1e-20", "1e30", "2e30", { 1, 2, 3 }, { 1, 0, 0, 0, "1e-20", "3e-20", "-2e-20" }, 1e20 },
  { "nearly a sphere, 1e-20", "1", "1.00000000000000000001", { 0, 1, 1 }, { 1, 1, 0, 0, 1, 2, 3 } },
}

for _, top in ipairs(tops) do
  local name, alpha, axial, k = top[1], R.lift(top[2]), R.lift(top[3]), top[4] and lifted(top[4])
  local x0, scale = lifted(top[5]), R.lift(top[6] or 1)
  local function at(t) return precise(alpha, axial, k, x0, t, BITS) end
  -- unit: the size of the rates, so that "small" means small beside the terms of the equation
  local unit = math.max(0, -R.log2(scale))
  for _, time in ipairs { 0, "1/3", "-5/2", 1000 } do
    local t = R.lift(time) * scale
    local h = scale * R.new(2) ^ -150
    local before, here, after = at(t - h), at(t), at(t + h)
    local want, worst = rates(alpha, axial, k, here), -math.huge
    for i = 1, 7 do
      worst = math.max(worst, size((after[i] - before[i]) / (2 * h) - want[i]) - unit * (i > 4 and 2 or 1))
    end
    -- (w h)^2 x'''/6 with w <= 2^6: 2^(-300 + 20); the quotient loses BITS - 150 - 10 bits to rounding
    tap.ok(worst < -270, name .. ", t = " .. time .. ": the central difference is the right-hand side to 2^-270",
      "2^" .. worst)
    local norm = here[1] ^ 2 + here[2] ^ 2 + here[3] ^ 2 + here[4] ^ 2
    local T0, T = energy(alpha, axial, k, at(R.zero)), energy(alpha, axial, k, here)
    local L0, L = momentum(alpha, axial, k, at(R.zero)), momentum(alpha, axial, k, here)
    local drift = size(norm - R.one)
    if R.sign(T0) ~= 0 then
      local length = size(alpha) + unit + 6
      drift = math.max(drift, size((T - T0) / T0))
      for i = 1, 3 do drift = math.max(drift, size(L[i] - L0[i]) - length) end
    else
      drift = math.max(drift, size(T - T0), size(L[1] - L0[1]), size(L[2] - L0[2]), size(L[3] - L0[3]))
    end
    -- a few dozen roundings at BITS bits, the angle of 1000 units losing ten of them
    tap.ok(drift < -BITS + 40, name .. ", t = " .. time .. ": |q| = 1, T and the inertial L are constant to 2^-560",
      "2^" .. drift)
  end
  local start = at(R.zero)
  local n = R.apply("sqrt", BITS, x0[1] ^ 2 + x0[2] ^ 2 + x0[3] ^ 2 + x0[4] ^ 2)
  local worst = -math.huge
  for i = 1, 7 do worst = math.max(worst, size(start[i] - (i <= 4 and x0[i] / n or x0[i])) - (i > 4 and unit or 0)) end
  tap.ok(worst < -BITS + 20, name .. ": at t = 0 it is the initial state, q normalised", "2^" .. worst)
end

-- ---- the lecture's numbers ----

do
  -- I1 = I2 = 1, I3 = 3/2, w3 = 2: Omega = (I3 - I1)/I1 w3 = 1, so w goes round the body's axis in 2 pi s
  local x0 = lifted { 1, 0, 0, 0, "3/10", 0, 2 }
  local pi = R.apply("pi", BITS)
  local function at(t) return precise(R.one, R.lift "3/2", lifted { 0, 0, 1 }, x0, t, BITS) end
  local quarter, whole = at(pi / 2), at(pi * 2)
  tap.ok(size(quarter[5]) < -500 and size(quarter[6] - R.lift "3/10") < -500 and quarter[7] == R.new(2),
    "Omega = (I3 - I1)/I1 w3 = 1 rad/s: after pi/2 s the rates are (0, w1, w3)")
  tap.ok(size(whole[5] - R.lift "3/10") < -500 and size(whole[6]) < -500, "after 2 pi/Omega the rates are back")
  -- seen from the inertial frame the axis goes round L at |L|/I1
  local L = momentum(R.one, R.lift "3/2", lifted { 0, 0, 1 }, x0)
  local turn = 2 * pi / R.apply("sqrt", BITS, dot(L, L))
  local function axis(x) -- q e_z q*
    return { 2 * (x[2] * x[4] + x[1] * x[3]), 2 * (x[3] * x[4] - x[1] * x[2]),
      x[1] ^ 2 - x[2] ^ 2 - x[3] ^ 2 + x[4] ^ 2 }
  end
  local a, b, c = axis(at(R.zero)), axis(at(turn)), axis(at(turn / 2))
  tap.ok(size(a[1] - b[1]) < -500 and size(a[2] - b[2]) < -500 and size(a[3] - b[3]) < -500
    and size(a[1] - c[1]) > -10, "the body's axis is back after 2 pi I1/|L|, and not after half of it")
end

-- ---- published and independent values ----

-- 25 of the 32 printed digits: 2^-83 of the size of each quantity
local DIGITS = -83

local function numbers(s)
  local out = {}
  for word in s:gmatch "[^,%s]+" do out[#out + 1] = word end
  return out
end

local rows, names = 0, {}
local pattern = '{"([^"]+)", {([^}]*)}, {([^}]*)}, {([^}]*)}, ([^,]+),%s*{([^}]*)},%s*{([^}]*)}'
for id, tensor, w0, q0, t, w, q in scene.slurp("tests/reference/free_top.h"):gmatch(pattern) do
  local function doubles(s)
    local out = {}
    for i, word in ipairs(numbers(s)) do out[i] = R.fromdouble(tonumber(word) + 0.0) end
    return out
  end
  local I = doubles(tensor)
  local axis = I[1] == I[2] and 3 or I[1] == I[3] and 2 or I[2] == I[3] and 1
  if axis and R.sign(I[4]) == 0 and R.sign(I[5]) == 0 and R.sign(I[6]) == 0 then
    local k = lifted { 0, 0, 0 }
    k[axis] = R.one
    local sphere = I[1] == I[2] and I[2] == I[3]
    local x0 = doubles(q0)
    for i, x in ipairs(doubles(w0)) do x0[4 + i] = x end
    local got = precise(I[axis % 3 + 1], I[axis], not sphere and k or nil, x0, R.fromdouble(tonumber(t)), 400)
    local want, scale = {}, R.zero
    for i, s in ipairs(numbers(q)) do want[i] = R.parse((s:gsub("L$", ""))) end
    for i, s in ipairs(numbers(w)) do
      want[4 + i] = R.parse((s:gsub("L$", "")))
      if R.abs(want[4 + i]) > scale then scale = R.abs(want[4 + i]) end
    end
    local worst = -math.huge
    for i = 1, 7 do worst = math.max(worst, size((got[i] - want[i]) / (i > 4 and scale or R.one))) end
    tap.ok(worst < DIGITS, id .. " at t = " .. t .. ": agrees to 25 digits", "2^" .. worst)
    rows, names[id] = rows + 1, true
  end
end
tap.ok(rows >= 15 and names.principia_tall_skinny_symmetric and names.sym_exact_oblate and names.sphere_exact
  and names.drake_cylinder, "free_top.h was read: " .. rows .. " samples of symmetric tops and spheres")

-- ---- when it is chosen ----

local function detected(shape, params, more)
  return assert(scene.body(shape, params, more)).closed
end

tap.is(detected("solid.sphere { r = 1, mass = 1 }").kind, "sphere", "a free sphere: uniform rotation")
tap.is(detected("solid.cylinder { r = a, h = b, mass = M }", { "M", "a", "b" }).kind, "symmetric",
  "a free cylinder: the symmetric top")
tap.is(detected("solid.box { x = a, y = a, z = a, mass = M }", { "M", "a" }, 'origin = "corner"').kind, "symmetric",
  "a free cube about its corner: the symmetric top about the space diagonal")
tap.is(detected("rod.between { from = {0, 0, 0}, to = {a, a, 2*a}, mass = M }", { "M", "a" }).kind, "symmetric",
  "a free rod: the symmetric top without a moment about its line")
do
  local c = detected("solid.box { x = a, y = b, z = b, mass = M }", { "M", "a", "b" }, "effects = {effect.control{}}")
  tap.is(c.kind, nil, "a driven body has none")
  tap.like(c.refused, "control acts on the body", "and says why")
  tap.like(c.others[4].name .. ": " .. c.others[4].reason, "axial gyrostat: control acts", "each of them why")
  c = detected("solid.box { x = a, y = b, z = c, mass = M }", { "M", "a", "b", "c" })
  tap.is(c.kind, "asymmetric", "a free body of three moments: the asymmetric top")
  c = detected("solid.box { x = a, y = b, z = c, mass = M }", { "M", "a", "b = 5", "c = 5" })
  tap.is(c.kind, "asymmetric", "moments equal for the defaults alone make no symmetric top: the structure decides")
end

-- body, parameters, effects; the kind, whether the attitude is in it; or no kind, and the reason of one form
local box, disc, ball = "solid.box { x = a, y = b, z = c, mass = M }", "plate.disc { r = a, mass = M }",
  "solid.sphere { r = a, mass = M }"
local chosen = {
  { disc, "effect.rotor { axis = {0, 0, 1}, momentum = rho }", "gyrostat", true },
  { ball, "effect.rotor { axis = {1, 2, 3}, momentum = rho }", "gyrostat", true },
  { disc, "effect.rotor { axis = {0, 0, 1}, momentum = rho }, effect.rotor { axis = {0, 0, -2}, momentum = 3 }",
    "gyrostat", true },
  { disc, "effect.rotor { axis = {0, 1, 1}, momentum = rho }", nil, "axial gyrostat: the rotor is not along" },
  { box, "effect.rotor { axis = {0, 0, 1}, momentum = rho }", "asymmetric gyrostat", true },
  { box, "effect.rotor { axis = {0, 2, 0}, momentum = rho }, effect.rotor { axis = {0, 1, 0}, momentum = 3 }",
    "asymmetric gyrostat", true },
  { box, "effect.rotor { axis = {0, 1, 1}, momentum = rho }", nil, "asymmetric gyrostat: the rotors are along no" },
  { box .. ":turned { axis = {0, 0, 1}, angle = 1 }", "effect.rotor { axis = {1, 0, 0}, momentum = rho }", nil,
    "asymmetric gyrostat: the axes x, y, z are not principal" },
  { box, "effect.rotor { axis = {0, 0, 1}, momentum = rho }, effect.damping { c = rho }", nil,
    "asymmetric gyrostat: damping or a torque" },
  { disc, "effect.rotor { axis = {0, 1, 0}, momentum = rho }", "asymmetric gyrostat", true },
  { disc, "effect.rotor { axis = {0, 0, 1}, momentum = rho }, effect.control {}", nil, "axial gyrostat: control acts" },
  { box, "effect.damping { rate = rho }", "damped asymmetric", true },
  { box, "effect.damping { rate = rho }, effect.damping { rate = 2*rho }", "damped asymmetric", true },
  { box .. '\nlocal k = param("k", 2, "1/s")', "effect.damping { c = {k*M*(b^2 + c^2)/12, k*M*(a^2 + c^2)/12, " ..
    "k*M*(a^2 + b^2)/12} }", "damped asymmetric", true },
  { box, "effect.damping { c = rho }", nil, "damping proportional to L: the damping is not proportional" },
  { box, "effect.damping { rate = rho }, effect.torque { body = {0, 0, 1} }", nil,
    "proportional to L: beside the damping" },
  { ball, "effect.damping { c = rho }", "damped sphere", true },
  { disc, "effect.damping { c = {rho, rho, 2*rho} }", "damped symmetric", true },
  { disc, "effect.damping { c = {rho, rho, 3*rho} }", "axial", false },
  { disc, "effect.damping { c = {rho, 2*rho, 3*rho} }", nil, "rates: the damping is not symmetric about" },
  { disc, "effect.torque { body = {0, 0, rho} }", "axial", false },
  { disc, "effect.torque { body = {0, rho, 1} }", nil, "rates: the torque is not along the symmetry axis" },
  { disc, "effect.torque { inertial = {0, 0, rho} }", nil, "rates: a torque that is constant in inertial axes" },
  { ball, "effect.torque { body = {1, rho, 3} }", "axial", false },
  { ball, "effect.damping { c = {rho, 1, 1} }", "axial", false },
  { "rod.straight { length = a, mass = M }", "effect.damping { rate = rho }", "damped symmetric", true },
}
for _, row in ipairs(chosen) do
  local c = detected(row[1], { "M", "a", "b", "c", "rho" }, "effects = {" .. row[2] .. "}")
  local what = string.match(row[1], "^[%w.]+") .. ", " .. row[2]
  tap.is(c.kind, row[3], what .. ": " .. (row[3] or "none"))
  if row[3] then
    tap.is(c.full, row[4], what .. (row[4] and ": the whole state" or ": the rates"))
  else
    local told = {}
    for i, o in ipairs(c.others) do told[i] = o.name .. ": " .. o.reason end
    tap.like(table.concat(told, "\n"), row[4], what .. ": says why not")
  end
end

tap.done()
