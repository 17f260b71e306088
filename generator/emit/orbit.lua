-- orbit.lua -- the closed form's NAME_orbit of the scene's own motion, as an initialiser in C.
--
-- The one place that knows what templates/orbit/top.h stores of the quantities of dynamics/free_top.lua.  Every number
-- is rounded once from many bits; phases are pairs, the fractions of a turn for the scene's step exact to 2^-128.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local asymmetric = require "generator.dynamics.closed.asymmetric"
local free_top = require "generator.dynamics.free_top"
local vec = require "generator.algebra.vec"
local number = require "generator.emit.number"

local orbit = {}

local bits = 224 -- 128 of a fraction of a turn, some 30 that a tick's count may take, and guards
local two = R.new(2)

-- A function from a rational to the nearest number of the type, a rational again; nil beyond its range.
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

-- The coefficients of templates/orbit/theta_at.c: a, b, c, d, f, nome, and scale, which the rates take.
-- The series of dynamics/free_top.lua, in powers of the cosine or sine that polynomial() takes; here q <= exp(-pi/2),
-- the rest is for `hyperbolic`.
local function circular(top, o)
  local s, q, E = R.new(top.s), R.round(top.q, 128), R.round(top.E, 128)
  local g = R.round(top.E * top.r, 128)
  local function cosines(count, term, first, slope) return polynomial(count, list(count, term), first, slope) end
  o.a = cosines(4, function(n)
    return n == 0 and R.one or sign(n) * q ^ (n * (2 * n - 1)) * (E ^ (2 * n) + g ^ (2 * n))
  end, 0, 1)
  o.b = cosines(3, function(n)
    return -two * s * sign(n) * q ^ ((n + 1) * (2 * n + 1)) * (E ^ (2 * n + 2) - g ^ (2 * n + 2))
  end, 0, 2)
  o.c = cosines(4, function(n)
    return s * sign(n) * q ^ (n * (2 * n + 1)) * (E ^ (2 * n + 1) + g ^ (2 * n + 1))
  end, 1, 2)
  o.d = cosines(4, function(n)
    return -sign(n) * q ^ (n * (2 * n + 1)) * (E ^ (2 * n + 1) - g ^ (2 * n + 1))
  end, -1, 2)
  local theta2 = cosines(5, function(n) return q ^ (n * (n + 1)) end, -1, 2)
  local theta3 = cosines(5, function(n) return n == 0 and R.one or two * q ^ (n * n) end, 0, 1)
  o.f = table.move(theta3, 1, 5, 6, theta2)
  local t2, t3, t4 = constants(q)
  o.scale = { R.one / t2, s * t3 / (t2 * t4), R.one / t3 }
  o.start, o.rate, o.turn = top.start / two, top.rate / two, top.turn -- the rates have two periods of theta functions
end

-- Polynomials in U = p' cosh 2V; V in its periods, which 2^half measures, on the separatrix in those of no_period.
local function hyperbolic(top, o, real)
  local s, P = R.new(top.s), R.sign(top.qc) == 0 and R.zero or R.apply("sqrt", 128, top.qc)
  local function multiples(trig, factor, alternates)
    local out = {}
    for k = 0, 3 do out[k + 1] = R.zero end
    for n = 0, 3 do
      local c = {}
      for k = 0, 3 do c[k + 1] = k == n and R.one or R.zero end
      local weight = (alternates and sign(n) or R.one) * factor * R.apply(trig, 128, (2 * n + 1) * top.h)
      for k, x in ipairs(polynomial(4, c, -1, 2)) do
        if k <= n + 1 then out[k] = out[k] + weight * x * P ^ (n * (n + 1) - k + 1) end
      end
    end
    return out
  end
  o.a, o.b = multiples("cos", R.one), multiples("sin", -s, true)
  local Q = R.round(top.qc, 128)
  local Q2 = Q * Q
  o.nome = P / two
  o.f = { R.one + two * Q2 * Q2, -16 * Q2 * Q, 16 * Q2, -two * Q, R.new(4), R.one + Q2, -4 * (Q + 3 * Q2 * Q2 * Q),
    16 * Q2 * Q2 }
  local t2, t3, t4 = constants(Q)
  o.scale = { R.one / t4, s * t3 / (two * t2 * t4), R.one / t3 }
  local log2 = R.apply("log", bits, two)
  o.half = top.separatrix and two ^ (real == "float" and 40 or 100) or top.period / log2 -- no_period
  local periods = top.separatrix and two * o.half * log2 or two * top.period
  o.start, o.rate = R.round(top.start / periods, bits), R.round(top.rate / periods, bits)
  o.jump = top.separatrix and R.zero or top.jump
  o.turn = top.turn - two * o.jump * o.rate
  o.nearest = o.half >= R.new(real == "float" and 120 or 1000) -- 2 binary_limit
end

-- What is stored, as rationals, by the names of templates/orbit/top.h.  h: the step that ticks count.
function orbit.of(top, h, real)
  local o = { start = R.zero, rate = R.zero, turn = top.turn, s = R.new(top.s), tick = h, hyperbolic = top.hyperbolic }
  local r, _, odd = top:phases(R.zero)
  local y0, turned = top.y0, R.one
  if top.constant then
    o.a, o.f, o.scale = { R.one }, { [6] = R.one }, { R.zero, R.zero, R.one }
  elseif top.hyperbolic then
    hyperbolic(top, o, real)
    -- turns are counted with the part `jump` of the phase less its nearest period; x and y come without s
    y0 = top:pair(r, top.separatrix and R.zero or o.jump * r / top.period, odd)
    turned = o.s
  else
    circular(top, o)
  end
  o.rate_tick, o.rate_start, o.turn_tick, o.turn_start = o.rate * h, o.start, o.turn * h, R.zero
  -- rates are over N^2, which is this at u = 0
  local _, _, n = top:pair(R.zero, R.zero, false)
  o.w = {}
  for i = 1, 3 do o.w[i] = vec.scale(R.round(n * o.scale[i] * top.b[i], 128), top.axis[i]) end
  -- q(t) = q0 (conj(y0) y(t)), the vector part of the second turned from principal to body axes
  o.q = {}
  for k = 1, 4 do
    local unit = { R.zero, R.zero, R.zero, R.zero }
    unit[k] = (k == 2 or k == 3) and turned or R.one
    o.q[k] = vec.qmul(top.q0, top:from_principal(unit, y0))
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

-- Lines of the initialiser, in the order of the struct, which has fields for ticks or not; nil if a number
-- is beyond the range of the type.
function orbit.lines(o, real, ticks)
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
  local function halves(q) -- high, low, and the high part in halves as Dekker splits it
    local high = round(q) or R.zero
    local c = round(high * (two ^ (real == "float" and 12 or 27) + R.one))
    local upper = c and round(c - round(c - high))
    return array({ high, q - high, upper, upper and high - upper }, 4)
  end
  put(pair(o.start), halves(o.rate))
  local fastest = R.abs(o.turn) > o.rate and R.abs(o.turn) or o.rate -- the time of 2^50 turns, or the range's end
  local last_time, last_turn = two ^ (real == "float" and 97 or 990), two ^ (real == "float" and 46 or 50)
  put(halves(o.turn), one(o.jump), one(o.half),
    one(fastest * last_time > last_turn and last_turn / fastest or last_time))
  for _, name in ipairs { "a", "b", "c", "d" } do put(array(o[name], 4)) end
  put(array(o.f, 10))
  put(one(o.nome), array(o.scale, 3), one(o.s))
  matrix(o.q, 4, 4)
  matrix(o.w, 3, 3)
  if ticks then put(one(o.tick)) end
  for _, name in ipairs(ticks and { "rate_tick", "rate_start", "turn_tick", "turn_start" } or {}) do
    put("{" .. table.concat(fraction(o[name]), ", ") .. "}")
  end
  lines[#lines + 1] = not o.hyperbolic and "0" or o.nearest and "2" or "1"
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
  v.diagonal = job.model.structure.kind == "diagonal"
  v.has_rod = not (v.diagonal and asymmetric.positive(job.model))
  if job.closed.kind ~= "asymmetric" or #job.model.params > 0 then return end
  local m, real = job.model, job.real
  local top, h = orbit.own(m, real), rounder(real)(m:number(m.step))
  v.own_lines = top and h and orbit.lines(orbit.of(top, h, real), real, v.has_tick_fields) or nil
  v.has_own = v.own_lines ~= nil
end

return orbit
