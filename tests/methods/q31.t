#!/usr/bin/env lua5.4
-- q31.t - the step in whole numbers: within the error that its header states, within its bounds, of order four.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The program of whole numbers is run by Lua's integers (generator/methods/q31_run.lua; that C gives the same bits is
-- tests/emit/q31.t).  What it should compute is written here anew, in doubles, from the body's tensor and torques as
-- numbers: Euler's equations by the 3/8 rule, Magnus' series, Hamilton's product.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"
local run = require "generator.methods.q31_run"

---- the same recipe in doubles ----------------------------------------------------------------------

local function cross(a, b)
  return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] }
end
local function map(f, ...)
  local out = {}
  local lists = { ... }
  for i = 1, #lists[1] do
    local args = {}
    for k, l in ipairs(lists) do args[k] = l[i] end
    out[i] = f(table.unpack(args))
  end
  return out
end
local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end
local function apply(I, w) -- I: xx yy zz xy xz yz
  return { I[1] * w[1] + I[4] * w[2] + I[5] * w[3], I[4] * w[1] + I[2] * w[2] + I[6] * w[3],
    I[5] * w[1] + I[6] * w[2] + I[3] * w[3] }
end
local function solve(I, n) -- by Cramer's rule
  local a, b, c = { I[1], I[4], I[5] }, { I[4], I[2], I[6] }, { I[5], I[6], I[3] }
  local det = dot(a, cross(b, c))
  return { dot(n, cross(b, c)) / det, dot(a, cross(n, c)) / det, dot(a, cross(b, n)) / det }
end

-- body: {I =, N = torque, h = rotor's momentum, decay = rate}
local function rates(body, w, u)
  local n = cross(map(function(x, y) return x + y end, apply(body.I, w), body.rotor or { 0, 0, 0 }), w)
  local torque = map(function(x, y) return x + y end, body.N or { 0, 0, 0 }, u or { 0, 0, 0 })
  local out = solve(body.I, map(function(x, y) return x + y end, n, torque))
  return map(function(x, y) return x - (body.decay or 0) * y end, out, w)
end

local function step(body, h, x, u)
  local q, w = { x[1], x[2], x[3], x[4] }, { x[5], x[6], x[7] }
  local function f(v) return map(function(r) return h / 3 * r end, rates(body, v, u)) end
  local k1 = f(w)
  local k2 = f(map(function(a, b) return a + b end, w, k1))
  local k3 = f(map(function(a, b, c) return a - b + 3 * c end, w, k1, k2))
  local k4 = f(map(function(a, b, c, d) return a + 3 * (b - c + d) end, w, k1, k2, k3))
  local dw = map(function(a, b, c, d) return 3 / 8 * (a + 3 * b + 3 * c + d) end, k1, k2, k3, k4)
  local a = map(function(v, b, c, d) return h / 2 * (v + 3 / 8 * (b + 2 * c + d)) end, w, k1, k2, k3)
  a = map(function(v, c) return v + h / 12 * c end, a, cross(a, dw))
  local A = dot(a, a)
  local C, z = A * (1 / 2 - A / 24), 1 - A * (1 / 6 - A / 120)
  local s = map(function(v) return v * z end, a)
  local m = cross({ q[2], q[3], q[4] }, s)
  local new = { q[1] - C * q[1] - dot({ q[2], q[3], q[4] }, s) }
  for i = 1, 3 do new[i + 1] = q[i + 1] - C * q[i + 1] + q[1] * s[i] + m[i] end
  for i = 1, 3 do new[i + 4] = w[i] + dw[i] end
  return new
end

local function unit(q)
  local n = math.sqrt(q[1] ^ 2 + q[2] ^ 2 + q[3] ^ 2 + q[4] ^ 2)
  return { q[1] / n, q[2] / n, q[3] / n, q[4] / n }, n
end

---- scenes ------------------------------------------------------------------------------------------

local full = { 150, 210, 260, 10, -5, 3 }
local brick = { 0.0025, 0.0085, 0.01, 0, 0, 0 }
local tensor = "tensor { mass = 400, xx = 150, yy = 210, zz = 260, xy = 10, xz = -5, yz = 3 }"
local box = "solid.box { x = 0.2, y = 0.1, z = 0.05, mass = 2.4 }"
for i = 1, 3 do brick[i] = 2.4 / 12 * ({ 0.01 + 0.0025, 0.04 + 0.0025, 0.04 + 0.01 })[i] end

local function text(body, more)
  return "return scene { name = \"b\", body = " .. body .. ", initial = { omega = { 0.1, 0.05, 0.02 } }, " ..
    (more or "") .. " }"
end

local cases = {
  { "free, principal axes", { I = brick }, text(box, "ranges = { omega = 8 }"), h = 0.001 },
  { "free, a long step", { I = brick }, text(box, "ranges = { omega = 8 }, time = { step = 0.01 }"), h = 0.01 },
  { "free, any axes", { I = full }, text(tensor, "ranges = { omega = 0.2 }, time = { step = 0.05 }"), h = 0.05 },
  { "free, symmetric", { I = { 0.008, 0.008, 0.012, 0, 0, 0 } }, text("tensor { mass = 1, xx = 0.008, yy = 0.008, " ..
    "zz = 0.012 }", "ranges = { omega = 8 }"), h = 0.001 },
  { "nearly symmetric", { I = { 1.5, 1.501, 2.6, 0, 0, 0 } },
    text("tensor { mass = 4, xx = 1.5, yy = 1.501, zz = 2.6 }", "ranges = { omega = 8 }"), h = 0.001 },
  { "sphere with torque", { I = { 0.4, 0.4, 0.4, 0, 0, 0 }, N = { 0.01, 0, -0.02 } }, text("solid.sphere { r = 1, " ..
    "mass = 1 }", "ranges = { omega = 2 }, effects = { effect.torque { body = { 0.01, 0, -0.02 } } }"), h = 0.001 },
  { "control", { I = brick }, text(box, "ranges = { omega = 8 }, effects = { effect.control { max = 0.02 } }"),
    h = 0.001, max = 0.02 },
  { "control, any axes, torque", { I = full, N = { 0.5, -1, 0 } }, text(tensor, "ranges = { omega = 0.5 }, " ..
    "effects = { effect.control { max = 2 }, effect.torque { body = { 0.5, -1, 0 } } }, time = { step = 0.02 }"),
    h = 0.02, max = 2 },
  { "rotor", { I = full, rotor = { 0, 0, 120 } }, text(tensor, "ranges = { omega = 0.2 }, " ..
    "effects = { effect.rotor { axis = { 0, 0, 1 }, momentum = 120 } }, time = { step = 0.01 }"), h = 0.01 },
  { "damping", { I = brick, decay = 0.25 }, text(box, "ranges = { omega = 8 }, effects = { effect.damping { rate = " ..
    "0.25 } }"), h = 0.001 },
}

local function plan(source)
  local job = assert(scene.read(source))
  return run.plan(scene.plan(job)), job
end

local rounding = 2.0 ^ -49 -- of some twenty operations in double on numbers about 1 (and their sizes for the rates)
scene.seed(31)
local function uniform() return (R.todouble(R.new(require("tests.ir.random").int(2 ^ 30 | 0), 2 ^ 29 | 0)) - 1) end

for _, c in ipairs(cases) do
  local made = plan(c[3])
  local s, worst, radial, quiet = made.step, 0, 0, 0
  local energy, e_worst = made.energy, 0
  for n = 1, 60 do
    -- over the whole range: bounds and errors are for all of it, not only for what free motion reaches
    local real = { uniform(), uniform(), uniform(), uniform() }
    local corner = n <= 8
    for i = 1, 3 do
      local w = corner and ((n - 1) >> (i - 1) & 1) * 2 - 1 or uniform()
      real[i + 4] = w * s.limit[i] * 2.0 ^ -s.x.w * 0.999
    end
    local x = run.from_real(s, map(R.fromdouble, real))
    local exact = map(R.todouble, run.to_real(s, x))
    local rates_now = { exact[5], exact[6], exact[7] }
    local T = energy.program:run({ wx = x[5], wy = x[6], wz = x[7] })(energy.node) * 2.0 ^ -energy.node.e
    e_worst = math.max(e_worst, math.abs(T - dot(rates_now, apply(c[2].I, rates_now)) / 2) / energy.node.err)
    local words, torque
    if c.max then
      words, torque = {}, {}
      for i = 1, 3 do
        words[i] = math.floor(uniform() * s.u[i].high)
        torque[i] = words[i] * 2.0 ^ -s.u[i].exponent
      end
    end
    local bits = run.step(s, x, words)
    if bits == 0 then
      quiet = quiet + 1
      local want, got = step(c[2], c.h, exact, torque), map(R.todouble, run.to_real(s, x))
      local qw, qg = unit(want), unit(got)
      local _, scale = unit(got)
      radial = math.max(radial, math.abs(scale - 1))
      for i = 1, 7 do
        local e = i <= 4 and math.abs(qw[i] - qg[i]) or math.abs(want[i] - got[i])
        local node = made.layout[i].node
        local size = i <= 4 and 1 or s.limit[i - 4] * 2.0 ^ -s.x.w
        worst = math.max(worst, e / ((node and node.err or 0) + rounding * size))
      end
    end
  end
  tap.ok(e_worst <= 1, c[1] .. ": the energy within its error", e_worst)
  tap.ok(quiet >= 30, c[1] .. ": most steps from within the range stay in it", quiet)
  -- an average error of a third of the bound would be remarkable, a thousandth would make the bound worthless
  tap.ok(worst <= 1, c[1] .. ": every step is within the error that is stated", worst)
  tap.ok(worst > 0.02, c[1] .. ": and the error stated is not idle", worst)
  -- n has four products of 2^-29 at most, and A^3/720 of what the cosine lacks is below that
  tap.ok(radial < 2.0 ^ -26, c[1] .. ": |q| = 1 after one step", radial)
end

---- every remainder -----------------------------------------------------------------------------------

-- The real number that a node stands for, in exact arithmetic from exact inputs: what its error is measured from.
local function exactly(program, given)
  local two, value = R.new(2), {}
  local function of(node)
    return node.kind == "constant" and node.q or node.kind == "input" and given[node.name] or value[node]
  end
  for _, o in ipairs(program.ops) do
    if o.kind == "mul" or o.kind == "product" then
      value[o] = of(o.a) * of(o.b)
    elseif o.kind == "sum" then
      local s = R.zero
      for _, t in ipairs(o.terms) do s = s + R.new(t[1]) * of(t[2]) * two ^ (t[2].e - o.e) end
      value[o] = s
    elseif o.a then
      value[o] = of(o.a)
    end
  end
  return of
end

-- All remainders of all components (in step with each other, shifted), all signs of the rates, inputs at their ends:
-- the words stand for word and remainder together, so a step goes from there to within the error that is stated.
for _, n in ipairs { 1, 3, 8 } do
  local c = cases[n]
  local made = plan(c[3])
  local s, layout, over, steps, beyond, most = made.step, made.layout, 0, 0, 0, 1
  for _, l in ipairs(layout) do most = math.max(most, 1 << l.k) end
  for corner = 0, 7 do
    for r = 0, most - 1, tier.quick and 32 or 1 do
      local x, u, given = {}, c.max and {}, {}
      for i, l in ipairs(layout) do
        local sign = i > 4 and (corner >> i - 5 & 1) * 2 - 1 or (corner >> i % 3 & 1) * 2 - 1
        x[i] = sign * (i <= 4 and 1 << 29 or l.limit // 2 + 1000 * i)
        x[i + 7] = (r * (2 * i + 1) + 37 * i) % (1 << l.k) - (1 << l.k) // 2
      end
      local from = run.to_real(s, x)
      for i, l in ipairs(layout) do given[l.name] = from[i] end
      for i, w in ipairs(u and s.u or {}) do
        u[i] = (corner + r + i) % 2 == 0 and w.low or w.high
        given[w.node.name] = R.new(u[i]) / R.new(2) ^ w.exponent
      end
      local of = exactly(s.program, given)
      if run.step(s, x, u) == 0 then
        steps = steps + 1
        local to, e, radial = run.to_real(s, x), {}, 0
        for i, l in ipairs(layout) do
          e[i] = R.todouble(to[i] - from[i] - (l.node and of(l.node) or R.zero))
          if i <= 4 then radial = radial + e[i] * R.todouble(from[i]) end
        end
        for i, l in ipairs(layout) do
          local half = (1 << l.k) // 2
          if x[i + 7] < -half or x[i + 7] >= math.max(half, 1) then over = over + 1 end
          if i <= 4 then e[i] = e[i] - radial * R.todouble(from[i]) end -- the error is stated without |q|
          if math.abs(e[i]) > (l.node and l.node.err or 0) then beyond = beyond + 1 end
        end
      end
    end
  end
  tap.ok(steps > (tier.quick and most // 8 or 4 * most) and beyond == 0 and over == 0, c[1] .. ": " .. steps ..
    " steps from every remainder are within the error that is stated, in exact arithmetic",
    beyond .. " beyond, " .. over .. " no remainders")
end

---- order four ----------------------------------------------------------------------------------------

-- Of the recipe in doubles, for rounding hides it in the words: with long steps half the step leaves a sixteenth of the
-- error.  That the motion is the right one is tests/emit/q31.t, which asks the library.
do
  local function brick_after(steps)
    local x = { 1, 0, 0, 0, 0.5, 5, -0.75 }
    for _ = 1, steps do x = step({ I = brick }, 0.5 / steps, x) end
    return x
  end
  local want, errors = brick_after(1600), {}
  for k, steps in ipairs { 24, 48 } do
    errors[k] = 0
    for i, v in ipairs(brick_after(steps)) do errors[k] = math.max(errors[k], math.abs(v - want[i])) end
  end
  tap.ok(errors[1] / errors[2] > 12 and errors[1] / errors[2] < 22, "half the step, a sixteenth of the error",
    errors[1] / errors[2])
end

---- what free motion cannot leave -----------------------------------------------------------------------

do
  local made = plan(cases[1][3])
  for i = 1, 3 do -- |w_i| <= sqrt(2 T/I_i), 2 T at the corner; and the momentum's bound
    local T = 64 * (brick[1] + brick[2] + brick[3])
    local L2 = 64 * (brick[1] ^ 2 + brick[2] ^ 2 + brick[3] ^ 2)
    local bound = math.min(math.sqrt(T / brick[i]), math.sqrt(L2) / brick[i])
    tap.near(made.step.limit[i] * 2.0 ^ -made.step.x.w, bound * 65 / 64, 0, 2.0 ^ -25,
      "limit of rate " .. i .. ": the bound of energy and momentum, a 64th of headroom",
      "the limit is a whole number of 2^-26, rounded up")
  end
  local quiet = true
  for n = 1, 8 do -- the corners of the declared range are the worst
    local real = { 1, 0, 0, 0 }
    for i = 1, 3 do real[i + 4] = ((n - 1) >> (i - 1) & 1) * 16 - 8 end
    local x = run.from_real(made.step, map(R.lift, real))
    for _ = 1, 150 do quiet = quiet and run.step(made.step, x) == 0 end
  end
  tap.ok(quiet, "from the corners of the declared range free motion is never limited")
end

---- refused ---------------------------------------------------------------------------------------------

local function refusal(source)
  local job, why = scene.read(source)
  if not job then return why end
  local planned = scene.plan(job)
  if run.plan(planned) then return "accepted" end
  return planned.diag:report()
end

for _, c in ipairs {
  { "no ranges", text(box), "write ranges = { omega = 5 }" },
  { "no range of the rates", text(box, "ranges = { attitude = \"any\" }"), "write ranges = { omega = 5 }" },
  { "gravity", text(box, "ranges = { omega = 5 }, origin = \"corner\", effects = { effect.gravity {} }"),
    "effect.gravity" },
  { "inertial torque", text(box, "ranges = { omega = 5 }, effects = { effect.torque { inertial = { 1, 0, 0 } } }"),
    "a torque in body axes" },
  { "torque in time", text(box, "ranges = { omega = 5 }, effects = { effect.torque { body = { sin(t), 0, 0 } } }"),
    "constant or linear in inputs" },
  { "unlimited control", text(box, "ranges = { omega = 5 }, effects = { effect.control {} }"), "inputs with limits" },
  { "wheel", text(box, "ranges = { omega = 5 }, effects = { effect.wheel { axis = { 1, 0, 0 }, inertia = 0.0001, " ..
    "included = true } }"), "effect.wheel" },
  { "a step too long", text(box, "ranges = { omega = 5 }, time = { step = 0.1 }"), "h |w| stays below 1/2" },
  { "a start outside", text(box, "ranges = { omega = 0.06 }"), "the initial wx must be within the range of omega" },
  { "no rates at all", text(box, "ranges = { omega = 0 }"), "must be" },
} do
  local why = refusal(c[2])
  tap.ok(string.find(why, c[3], 1, true) and string.find(why, "--with q31", 1, true), "refused: " .. c[1], why)
end

tap.done()
