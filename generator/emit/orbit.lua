-- orbit.lua -- the closed form's NAME_orbit of the scene's own motion, as an initialiser in C.
--
-- The one place that knows what templates/top.h stores of the quantities of dynamics/free_top.lua.  Every number is
-- rounded once from many bits; phases are pairs, the fractions of a turn for the scene's step exact to 2^-128.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local free_top = require "generator.dynamics.free_top"
local vec = require "generator.algebra.vec"
local number = require "generator.emit.number"

local orbit = {}

local bits = 224 -- 128 of a fraction of a turn, some 30 that a tick's count may take, and guards
local two = R.new(2)

local function rounder(real)
  return function(q)
    local x = real == "float" and R.tofloat(q) or R.todouble(q)
    if x ~= x or x == math.huge or x == -math.huge then return nil end
    return R.fromdouble(x)
  end
end
orbit.rounder = rounder

-- sum of c[n] y[n] with y[0] = 1, y[1] = first + slope X, y[n + 1] = 2 X y[n] - y[n - 1]: `count` coefficients in X
local function polynomial(count, c, first, slope)
  local before, now, out = { R.one }, { R.new(first), R.new(slope) }, {}
  for k = 1, count do out[k] = k == 1 and c[1] or R.zero end
  for i = 2, count do
    for k = 1, i do out[k] = out[k] + c[i] * (now[k] or R.zero) end
    local next_one = {}
    for k = 1, count do next_one[k] = (k > 1 and two * (now[k - 1] or R.zero) or R.zero) - (before[k] or R.zero) end
    before, now = now, next_one
  end
  return out
end

local function list(count, term)
  local out = {}
  for n = 0, count - 1 do out[n + 1] = term(n) end
  return out
end

local function sign(n) return n % 2 == 1 and -R.one or R.one end

-- theta2, theta3, theta4 of 0, the first without 2 q^(1/4)
local function constants(q)
  local t2, t3, t4 = R.one, R.one, R.one
  for n = 1, 9 do
    t2 = t2 + q ^ (n * (n + 1))
    t3, t4 = t3 + two * q ^ (n * n), t4 + two * sign(n) * q ^ (n * n)
  end
  return t2, t3, t4
end

-- The coefficients of templates/theta.c: a_re, a_im, b_re, b_im, f, nome, scale.
local function circular(top, o)
  local s, q, E = R.new(top.s), R.round(top.q, 128), R.round(top.E, 128)
  local g = R.round(top.E * top.r, 128)
  o.a_re = polynomial(4, list(4, function(n)
    return n == 0 and R.one or sign(n) * q ^ (n * (2 * n - 1)) * (E ^ (2 * n) + g ^ (2 * n))
  end), 0, 1)
  o.a_im = polynomial(3, list(3, function(n)
    return -s * sign(n) * q ^ ((n + 1) * (2 * n + 1)) * (E ^ (2 * n + 2) - g ^ (2 * n + 2))
  end), 0, 2)
  o.b_re = polynomial(4, list(4, function(n)
    return s * sign(n) * q ^ (n * (2 * n + 1)) * (E ^ (2 * n + 1) + g ^ (2 * n + 1))
  end), 1, 2)
  o.b_im = polynomial(4, list(4, function(n)
    return -sign(n) * q ^ (n * (2 * n + 1)) * (E ^ (2 * n + 1) - g ^ (2 * n + 1))
  end), -1, 2)
  local t2, t3, t4 = constants(q)
  o.f = { polynomial(5, list(5, function(n) return q ^ (n * (n + 1)) end), -1, 2),
    polynomial(5, list(5, function(n) return s * sign(n) * q ^ (n * (n + 1)) end), 1, 2),
    polynomial(5, list(5, function(n) return n == 0 and R.one or two * q ^ (n * n) end), 0, 1) }
  o.scale = { R.one / t2, t3 / (t2 * t4), R.one / t3 }
end

local function hyperbolic(top, o)
  local s, nome = R.new(top.s), R.sign(top.qc) == 0 and R.zero or R.apply("sqrt", 128, top.qc)
  local function series(trig, exponent)
    return list(4, function(n)
      return (trig == "sin" and s or R.one) * R.apply(trig, 128, (2 * n + 1) * top.h) * nome ^ exponent(n)
    end)
  end
  local function to(n) return n * n end
  local function from(n) return n * (n + 1) end
  o.a_re, o.a_im = series("cos", to), series("sin", to)
  o.b_re, o.b_im = series("cos", from), series("sin", from)
  local t2, t3, t4 = constants(R.round(top.qc, 128))
  o.nome = nome
  o.scale = { R.one / t4, s * t3 / (two * t2 * t4), R.one / t3 }
end

-- Phases of two periods and of turns about L, as fractions in units of 2^-128, for the step h.
local function ticks(top, o, h)
  local per, first = R.zero, R.zero
  if top.period then per, first = top.rate / top.period, top.start / top.period end
  o.tick = h
  o.rate_tick, o.rate_start = per * h / two, first / two
  o.turn_tick, o.turn_start = (top.turn - top.jump * per) * h, -top.jump * first
end

-- What is stored, as rationals, by the names of templates/top.h.  h: the step that ticks count.
function orbit.of(top, h)
  local o = { start = top.start, rate = top.rate, period = top.period or R.zero, turn = top.turn, jump = top.jump,
    inverse = top.period and R.one / top.period or R.zero, s = R.new(top.s), hyperbolic = top.hyperbolic }
  if top.constant then
    o.a_re, o.f, o.scale = { R.one }, { {}, {}, { R.one } }, { R.zero, R.zero, R.one }
  elseif top.hyperbolic then
    hyperbolic(top, o)
  else
    circular(top, o)
  end
  ticks(top, o, h)
  -- rates are over N^2, which is this at u = 0
  local _, _, n = top:pair(R.zero, R.zero, false)
  o.w = {}
  for i = 1, 3 do o.w[i] = vec.scale(R.round(n * o.scale[i] * top.b[i], 128), top.axis[i]) end
  -- q(t) = q0 (conj(y0) y(t)), the vector part of the second turned from principal to body axes
  o.q = {}
  for k = 1, 4 do
    local unit = { R.zero, R.zero, R.zero, R.zero }
    unit[k] = R.one
    o.q[k] = vec.qmul(top.q0, top:from_principal(unit))
  end
  return o
end

-- a less whole turns, {high, low} of 128 bits
local function fraction(a)
  local all = R.floor((a - R.floor(a)) * two ^ 128 + R.half)
  local high = R.floor(all / two ^ 64)
  local function word(x) -- 64 bits, in two halves
    local upper = R.floor(x / two ^ 32)
    return string.format("UINT64_C(0x%08X%08X)", R.toint(upper) & 0xFFFFFFFF, R.toint(x - upper * two ^ 32))
  end
  return { word(high), word(all - high * two ^ 64) }
end

-- Lines of the initialiser, in the order of the struct; nil if a number is beyond the range of the type.
function orbit.lines(o, real)
  local round, lines, fits = rounder(real), {}, true
  local function one(q)
    local x = round(q or R.zero)
    fits = fits and x ~= nil
    return number.text(x or R.zero, real)
  end
  local function pair(q)
    local high = round(q) or R.zero
    return "{" .. one(q) .. ", " .. one(q - high) .. "}"
  end
  local function array(a, count)
    local out = {}
    for k = 1, count do out[k] = one(a and a[k]) end
    return "{" .. table.concat(out, ", ") .. "}"
  end
  local function matrix(a, rows, columns)
    for k = 1, rows do
      lines[#lines + 1] = (k == 1 and "{" or " ") .. array(a and a[k], columns) .. (k == rows and "}," or ",")
    end
  end
  local function put(...) lines[#lines + 1] = table.concat({ ... }, ", ") .. "," end
  put(pair(o.start), pair(o.rate))
  put(pair(o.period), one(o.inverse))
  put(pair(o.turn), pair(o.jump))
  for _, name in ipairs { "a_re", "a_im", "b_re", "b_im" } do put(array(o[name], 4)) end
  matrix(o.f, 3, 5)
  put(one(o.nome), array(o.scale, 3), one(o.s))
  matrix(o.q, 4, 4)
  matrix(o.w, 3, 3)
  put(one(o.tick))
  for _, name in ipairs { "rate_tick", "rate_start", "turn_tick", "turn_start" } do
    put("{" .. table.concat(fraction(o[name]), ", ") .. "}")
  end
  lines[#lines + 1] = o.hyperbolic and "1" or "0"
  return fits and lines or nil
end

-- The scene's own motion: its tensor, initial state and step, rounded to the real type; nil if it has none or the type
-- cannot hold one of them.
function orbit.own(m, real)
  local round = rounder(real)
  local tensor, x0 = {}, {}
  for i = 1, 6 do tensor[i] = round(m:number(m.inertia[i])) end
  for i = 1, 4 do x0[i] = round(m:number(m.attitude[i])) end
  for i = 1, 3 do x0[4 + i] = round(m:number(m.omega[i])) end
  if #tensor < 6 or #x0 < 7 then return nil end
  return free_top.new(tensor, x0, bits, two ^ (real == "float" and -20 or -49)), tensor, x0
end

-- Into the values of the templates: has_own and own_lines, for a scene without parameters with this closed form.
function orbit.fill(job, v)
  v.has_own, v.own_bits = false, string.format("%d", bits)
  if job.closed.kind ~= "asymmetric" or #job.model.params > 0 then return end
  local m, real = job.model, v.real
  local top, h = orbit.own(m, real), rounder(real)(m:number(m.step))
  v.own_lines = top and h and orbit.lines(orbit.of(top, h), real)
  v.has_own = v.own_lines ~= nil
end

return orbit
