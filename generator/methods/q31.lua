-- q31.lua -- the step in whole numbers of 32 bits: which products in which scaling.
--
-- The rates do not need the attitude (dynamics/bounded.lua), so they go first, by Kutta's 3/8 rule.  With k = h f/3,
--     k1 = k(w), k2 = k(w + k1), k3 = k(w - k1 + 3 k2), k4 = k(w + 3 (k1 - k2 + k3))
--     w(t + h) - w = 3/8 (k1 + 3 k2 + 3 k3 + k4),      integral of w = h (w + 3/8 (k1 + 2 k2 + k3))
-- whose weights are powers of two and threes: nothing is divided.  The stages run on y_k = g_k (e_k.w), e_k the
-- principal axes, with g chosen so that the products of the rates have no factor left:
--     h/3 c_k w_j w_l = +- y_j y_l/g_k,   g_k = h/3 sqrt(|c_j c_l|)
-- (where one |c_k| is much less than the others, its own product keeps a factor).  The attitude follows by Magnus'
-- series of order four, a = (half of the integral of w) + h^2/24 w x dw, q(t + h) = q (cos a, sin a a/|a|).
-- Sources: Kutta 1901 (the 3/8 rule: Hairer, Norsett, Wanner, Solving ODEs I, 2nd ed., table II.1.2); Magnus 1954,
-- Comm. Pure Appl. Math. 7, 649; Blanes, Casas, Oteo, Ros 2009, Phys. Rep. 470, 151.
--
-- Increments have finer units than the state; what is left of them below its last place stays in words of its own (the
-- remainders), so adding them up loses nothing.  ABOVE the line but for the whole numbers that it decides on.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local axes = require "generator.methods.q31_axes"
local fixed = require "generator.methods.fixed"
local turn = require "generator.methods.q31_turn"

local q31 = { attitude_limit = (1 << 30) + (1 << 26) } -- of a component of q, 1 being 2^30

local axis, part, cyclic = { "x", "y", "z" }, { "w", "x", "y", "z" }, axes.cyclic

local function negligible(x) return R.abs(x) < R.new(2) ^ -100 end

-- sum over j of row[j] v[j] as one node of exponent e; nil where the row is zero or v[j] are.
local function dot(p, name, v, row, s, e, about, blame)
  local which, terms = {}, {}
  for j = 1, #row do
    if v[j] and not negligible(row[j]) then which[#which + 1] = j end
  end
  for n, j in ipairs(which) do
    local down = n < #which or #which % 2 == 0 -- an even number of them
    local own = n > 1 and (axis[j] or string.format("%d", j)) or ""
    terms[n] = { 1, p:scale(name .. own, v[j], row[j] * s, e, about, blame, down) }
  end
  if #terms == 0 then return nil end
  return p:sum(name .. "s", terms, blame)
end

-- ---- the step in its parts ------------------------------------------------------------------------------------------
--
-- S is a step in the making: p its program, r the rates (dynamics/bounded.lua), h the step and h3 a third of it, x the
-- exponents {w, f, k, d, a}: of w; of y; of the k; of the increment of w; of half angles.  factor, to, from:
-- q31_axes.lua; out: what is returned.

-- Inputs: words of w and q with their limits.  A word of w is within what the scene declares, and where no input feeds
-- the motion a 64th more, for rates that the declared ones lead to are within it (bounded.lua).
local function state(S)
  local p, r, x, out = S.p, S.r, S.x, S.out
  for i = 1, 3 do
    local limit = r.limit[i] * (r.fed and R.one or R.new(65, 64)) * R.new(2) ^ x.w
    out.limit[i] = R.toint(R.floor(limit)) + (r.fed and 0 or 1)
    if out.limit[i] > (1 << 31) - 1 then fixed.unfit "w" end
    out.limit[i] = math.max(out.limit[i], 1)
    out.w[i] = p:input("w" .. axis[i], x.w, out.limit[i], 2.0 ^ (-x.w - 1))
  end
  for i = 1, 4 do out.q[i] = p:input("q" .. part[i], 30, q31.attitude_limit, 2.0 ^ -31) end
end

-- The scene's inputs u, each in the finest unit in which its limits are words.  Flags of inputs beyond their limits are
-- bits 7, 8, 9, 11, ..: 10 is that of the norm.
local function inputs(S)
  local p, r, out = S.p, S.r, S.out
  for i, u in ipairs(r.inputs) do
    local most = R.abs(u.low) > R.abs(u.high) and R.abs(u.low) or R.abs(u.high)
    local e = fixed.finest(most)
    local node = p:input(string.find(u.label, "^u[xyz]$") and u.label or "u_" .. u.label, e, fixed.nearest(most, e),
      2.0 ^ (-e - 1))
    out.u[i] = { node = node, label = u.label, index = u.index, unit = u.unit, exponent = e,
      low = fixed.nearest(u.low, e), high = fixed.nearest(u.high, e), bit = i <= 3 and 6 + i or 7 + i }
  end
end

-- The torque in the units of the k: w' = A w + b + B u besides Euler's products, so k_k has
--     h/3 g_k e_k.(A w)  the row S.linear[k] of y,   h/3 g_k e_k.b  S.constant[k],   h/3 g_k e_k.(B u)  S.input[k].
local function torque(S)
  local p, r, h3, to, out = S.p, S.r, S.h3, S.to, S.out
  local b = {}
  S.linear, S.input, S.constant = axes.times(axes.times(to, r.A), S.from), {}, {}
  for k = 1, 3 do
    b[k] = (to[k][1] * r.b[1] + to[k][2] * r.b[2] + to[k][3] * r.b[3]) * h3
    for j = 1, 3 do S.linear[k][j] = S.linear[k][j] * h3 end
  end
  if #out.u > 0 then
    p:block("torque in the units of k: h/3 g e.(B u), B the response of w' to the inputs")
    local nodes = {}
    for i, u in ipairs(out.u) do nodes[i] = u.node end
    for k = 1, 3 do
      local row = {}
      for i, u in ipairs(r.inputs) do
        row[i] = to[k][1] * u.response[1] + to[k][2] * u.response[2] + to[k][3] * u.response[3]
      end
      S.input[k] = dot(p, "b" .. k, nodes, row, h3, S.x.k, "h/3 times the response to the input", "k")
    end
  end
  for k = 1, 3 do
    if not negligible(b[k]) then
      S.constant[k] = fixed.constant(b[k], S.x.k, "torque that is constant, in the units of k", "k")
    end
  end
end

-- y = g e.w
local function scaled_rates(S)
  local p, y = S.p, {}
  p:block("y = g e.w: the rates about the principal axes, in units in which Euler's products have no factor")
  for k = 1, 3 do
    y[k] = dot(p, "y" .. k, S.out.w, S.to[k], R.one, S.x.f, "g e of axis " .. k, "f") or
      error("q31: an axis that no rate turns about")
  end
  return y
end

-- k_n = h/3 f(v), v the rates of stage n: Euler's product, of which the sign is left where g took its factor, and
-- torque.
local function slope(S, n, v)
  local p, x, factor, out = S.p, S.x, S.factor, {}
  p:block("k" .. n .. " = h/3 times the rate of y" .. (n > 1 and " at stage " .. n or ""))
  for k = 1, 3 do
    local j, l = cyclic(k)
    local terms, name = {}, "k" .. n .. k
    if R.sign(factor[k]) ~= 0 then
      if R.abs(factor[k]) == R.one then
        local down = 2 * x.f - x.k
        if down < 30 then fixed.unfit "k" end
        terms[1] = { R.sign(factor[k]), p:mul(name .. "p", v[j], v[l], down, "k") }
      else
        local yy = p:mul(name .. "p", v[j], v[l])
        terms[1] = { 1, p:scale(name .. "c", yy, factor[k], x.k, "factor of the product of axis " .. k, "k") }
      end
    end
    for i = 1, 3 do
      if not negligible(S.linear[k][i]) then
        local node = p:scale(name .. "m" .. i, v[i], S.linear[k][i], x.k, "h/3 of the linear torque", "k")
        terms[#terms + 1] = { 1, node }
      end
    end
    if S.input[k] then terms[#terms + 1] = { 1, S.input[k] } end
    if S.constant[k] then terms[#terms + 1] = { 1, S.constant[k] } end
    out[k] = #terms > 0 and p:sum(name, terms, "k") or nil
  end
  return out
end

-- Kutta's weights of the k before each later stage, as h f/3 has them.
local weights = { { 1 }, { -1, 3 }, { 3, -3, 3 } }

-- The four slopes K[n][k]; an axis without product and torque has none.  The k are finer than y by S.shift bits.
local function stages(S, y)
  local p = S.p
  S.shift = S.x.k - S.x.f
  if S.shift < 0 then fixed.unfit "f" end
  local K = { slope(S, 1, y) }
  for n = 1, 3 do
    local v = {}
    for k = 1, 3 do
      v[k] = y[k]
      if K[1][k] then
        local terms = {}
        for i, c in ipairs(weights[n]) do terms[i] = { c, K[i][k] } end
        local name = "y" .. k .. "_" .. n + 1
        v[k] = p:sum(name, { { 1, y[k] }, { 1, p:right(name .. "d", p:sum(name .. "k", terms, "k"), S.shift) } }, "f")
      end
    end
    K[n + 1] = slope(S, n + 1, v)
  end
  return K
end

-- out.dw, the increment of w; w and it must stay a word together.
local function increment(S, K)
  local p, x, out, D = S.p, S.x, S.out, {}
  p:block("dw = 3/8 (k1 + 3 k2 + 3 k3 + k4)/g, in units of 2^-" .. x.d .. " rad/s")
  for k = 1, 3 do
    if K[1][k] then
      D[k] = p:sum("d" .. k, { { 1, K[1][k] }, { 3, K[2][k] }, { 3, K[3][k] }, { 1, K[4][k] } }, "k")
    end
  end
  for i = 1, 3 do
    out.dw[i] = dot(p, "dw" .. axis[i], D, S.from[i], R.new(3, 8), x.d, "3/(8 g) e", "d") or false
    if out.dw[i] and out.limit[i] + ((out.dw[i].hi + (1 << x.d - x.w)) >> (x.d - x.w)) > (1 << 31) - 1 then
      fixed.unfit "w"
    end
  end
end

-- Half of the integral of w over the step, in units of 2^-a.
local function half_angle(S, y, K)
  local p, means, a = S.p, {}, {}
  p:block("a = (h/2)(y + 3/8 (k1 + 2 k2 + k3))/g: half of the integral of w")
  for k = 1, 3 do
    means[k] = y[k]
    if K[1][k] then
      local m = p:sum("m" .. k, { { 3, K[1][k] }, { 6, K[2][k] }, { 3, K[3][k] } }, "k")
      m.e, m.err = m.e + 3, m.err / 8 -- an eighth of it
      means[k] = p:sum("s" .. k, { { 1, y[k] }, { 1, p:right("m" .. k .. "r", m, S.shift + 3) } }, "f")
    end
  end
  for i = 1, 3 do a[i] = dot(p, "a" .. axis[i], means, S.from[i], S.h / R.new(2), S.x.a, "h/(2 g) e", "a") end
  return a
end

-- Builds the step for exponents x.
local function build(r, h, x)
  local p = fixed.new()
  local S = { p = p, r = r, h = h, h3 = h / R.new(3), x = x }
  local g
  g, S.factor = axes.scaling(r, S.h3)
  S.to, S.from = axes.frames(r, g)
  S.out = { program = p, x = x, w = {}, q = {}, u = {}, dq = {}, dw = {}, limit = {},
    attitude_limit = q31.attitude_limit }
  state(S)
  inputs(S)
  torque(S)
  local y = scaled_rates(S)
  local K = stages(S, y)
  increment(S, K)
  local a = half_angle(S, y, K)
  S.out.a = a
  turn.commutator(p, h, x, a, S.out.dw)
  turn.increment(p, x, S.out, a)
  return S.out
end

-- Kinetic energy, the sum of I_k y_k^2/(2 g_k^2), in the finest unit that fits: {program, node}.
-- Exponents are tried from the finest down; the first with which all nodes fit is taken.
function q31.energy(step)
  local r, x = step.rates, step.x
  local g = axes.scaling(r, step.h / R.new(3))
  local to = axes.frames(r, g)
  for e = 62 + R.log2(R.one / r.moments[1]), -200, -1 do
    local p, terms = fixed.new(), {}
    local ok, why = pcall(function()
      p:block("y = g e.w, energy = the sum of I y^2/(2 g^2)")
      for k = 1, 3 do
        local y = dot(p, "y" .. k, step.w, to[k], R.one, x.f, "g e of axis " .. k, "f")
        terms[k] = { 1, p:scale("t" .. k, p:mul("s" .. k, y, y), r.moments[k] / (R.new(2) * g[k] * g[k]), e,
          "I/(2 g^2) of axis " .. k, "e") }
      end
      return p:sum("energy", terms, "e")
    end)
    if ok then return { program = p, node = why } end
    if getmetatable(why) ~= fixed.misfit then error(why, 0) end
  end
end

-- The step of a scene: what build returns for the finest exponents that fit, or nil after an error in job.diag.
-- r: dynamics/bounded.lua
-- Each exponent starts at its finest and is lowered where a node does not fit (`blame`).  Those that depend on it start
-- again: k on f (30 bits finer), and f, k and d on w.  That ends, for below x.f = 8 or x.a = 32 the step is refused.
function q31.of(job, r)
  local h = job.model:number(job.model.step)
  local most = R.zero
  for i = 1, 3 do most = r.limit[i] > most and r.limit[i] or most end
  if R.sign(most) == 0 then
    job.diag:error(job.ranges.line, "--with q31", "the range of omega must not be zero", "0")
    return nil
  end
  local w = 31 - R.log2(most)
  local x = { w = w, f = 62, k = 92, d = w + 30, a = 62 }
  while true do
    local ok, step = xpcall(build, function(e)
      return getmetatable(e) == fixed.misfit and e or debug.traceback(tostring(e), 2)
    end, r, h, x)
    if ok then
      step.rates, step.h = r, h
      return step
    end
    if getmetatable(step) ~= fixed.misfit then error(step, 0) end
    local blame = step.blame
    if blame == "step" or x.a < 32 or x.f < 8 then
      job.diag:error(job.record.line, "--with q31", "the step h must be short enough that h |w| stays below 1/2, " ..
        "and h times each rate of the torque too; |w| may be as large as " ..
        string.format("%.17g", R.todouble(most)) .. " rad/s here", "h = " .. string.format("%.17g", R.todouble(h)))
      return nil
    end
    if blame == "k" and x.k <= x.f then blame = "f" end
    if blame == "d" and x.d <= x.w + 1 then blame = "w" end
    x[blame] = x[blame] - 1
    if blame == "f" then x.k = x.f + 30 end
    if blame == "w" then x.f, x.k, x.d = 62, 92, x.w + 30 end
  end
end

return q31
