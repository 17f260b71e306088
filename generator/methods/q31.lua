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
local fixed = require "generator.methods.fixed"

local q31 = {}

local BITS = 200
local ONE = 1 << 30 -- of the attitude
q31.one, q31.attitude_limit = ONE, ONE + (1 << 26)
q31.norm_flag = 1 << 10
local axis, part = { "x", "y", "z" }, { "w", "x", "y", "z" }

local function root(x) return R.apply("sqrt", BITS, x) end
local function cyclic(k) return k % 3 + 1, (k + 1) % 3 + 1 end

-- g, and the factor that is left of each product (0 none at all, 1 or -1 only the sign): two lists.
local function scaling(r, h3)
  local c, least, most = {}, 1, 1
  for k = 1, 3 do
    c[k] = R.abs(r.c[k])
    least, most = c[k] < c[least] and k or least, c[k] > c[most] and k or most
  end
  if R.sign(c[most]) == 0 then return { h3, h3, h3 }, { R.zero, R.zero, R.zero } end
  local g, factor = {}, {}
  if c[least] * R.new(16) < c[most] then -- the others are nearly the same, one of either sign
    local j, l = cyclic(least)
    g[least] = h3 * root(c[j] * c[l])
    g[l], g[j] = g[least], g[least] * root(c[l] / c[j])
  else
    for k = 1, 3 do
      local j, l = cyclic(k)
      g[k] = h3 * root(c[j] * c[l])
    end
  end
  for k = 1, 3 do
    local j, l = cyclic(k)
    local f = h3 * r.c[k] * g[k] / (g[j] * g[l])
    local s = R.new(R.sign(f))
    factor[k] = R.abs(f - s) < R.new(2) ^ -60 and s or f
  end
  return g, factor
end

-- Rows E_k of the axes as they scale: to = g_k E_kj (from w to y) and from = E_kj/g_k (transposed, from y to w).
local function frames(r, g)
  local to, from = { {}, {}, {} }, { {}, {}, {} }
  for k = 1, 3 do
    for j = 1, 3 do
      local e = r.axes[k][j]
      if R.abs(e) < R.new(2) ^ -60 then e = R.zero end
      to[k][j], from[j][k] = g[k] * e, e / g[k]
    end
  end
  return to, from
end

local function times(a, b)
  local out = { {}, {}, {} }
  for i = 1, 3 do
    for j = 1, 3 do out[i][j] = a[i][1] * b[1][j] + a[i][2] * b[2][j] + a[i][3] * b[3][j] end
  end
  return out
end

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

-- Builds the step for exponents x = {w, f, k, d, a}: of w; of y; of the k; of the increment of w; of half angles.
local function build(r, h, x)
  local p = fixed.new()
  local h3 = h / R.new(3)
  local g, factor = scaling(r, h3)
  local to, from = frames(r, g)
  local out = { program = p, x = x, w = {}, q = {}, u = {}, dq = {}, dw = {}, limit = {},
    attitude_limit = q31.attitude_limit }

  for i = 1, 3 do
    local limit = r.limit[i] * (r.fed and R.one or R.new(65, 64)) * R.new(2) ^ x.w
    out.limit[i] = R.toint(R.floor(limit)) + (r.fed and 0 or 1)
    if out.limit[i] > (1 << 31) - 1 then fixed.unfit "w" end
    out.limit[i] = math.max(out.limit[i], 1)
    out.w[i] = p:input("w" .. axis[i], x.w, out.limit[i], 2.0 ^ (-x.w - 1))
  end
  for i = 1, 4 do out.q[i] = p:input("q" .. part[i], 30, q31.attitude_limit, 2.0 ^ -31) end

  -- torque: b and the columns of I^-1 in the units of y
  local B, M = {}, times(times(to, r.A), from)
  for k = 1, 3 do
    B[k] = (to[k][1] * r.b[1] + to[k][2] * r.b[2] + to[k][3] * r.b[3]) * h3
    for j = 1, 3 do M[k][j] = M[k][j] * h3 end
  end
  local input = {} -- bits 7, 8, 9, 11, ..: 10 is that of the norm
  for i, u in ipairs(r.inputs) do
    local most = R.abs(u.low) > R.abs(u.high) and R.abs(u.low) or R.abs(u.high)
    local e = fixed.finest(most)
    local node = p:input(string.find(u.label, "^u[xyz]$") and u.label or "u_" .. u.label, e, fixed.nearest(most, e),
      2.0 ^ (-e - 1))
    out.u[i] = { node = node, label = u.label, index = u.index, unit = u.unit, exponent = e,
      low = fixed.nearest(u.low, e), high = fixed.nearest(u.high, e), bit = i <= 3 and 6 + i or 7 + i }
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
      input[k] = dot(p, "b" .. k, nodes, row, h3, x.k, "h/3 times the response to the input", "k")
    end
  end
  local constant = {}
  for k = 1, 3 do
    if not negligible(B[k]) then
      constant[k] = fixed.constant(B[k], x.k, "torque that is constant, in the units of k", "k")
    end
  end

  p:block("y = g e.w: the rates about the principal axes, in units in which Euler's products have no factor")
  local y = {}
  for k = 1, 3 do
    y[k] = dot(p, "y" .. k, out.w, to[k], R.one, x.f, "g e of axis " .. k, "f") or
      error("q31: an axis that no rate turns about")
  end

  local stage = 0
  local function rate(v)
    stage = stage + 1
    p:block("k" .. stage .. " = h/3 times the rate of y" .. (stage > 1 and " at stage " .. stage or ""))
    local out_k = {}
    for k = 1, 3 do
      local j, l = cyclic(k)
      local terms, name = {}, "k" .. stage .. k
      if R.sign(factor[k]) ~= 0 then
        if R.abs(factor[k]) == R.one then
          local n = 2 * x.f - x.k
          if n < 30 then fixed.unfit "k" end
          terms[1] = { R.sign(factor[k]), p:mul(name .. "p", v[j], v[l], n, "k") }
        else
          local yy = p:mul(name .. "p", v[j], v[l])
          terms[1] = { 1, p:scale(name .. "c", yy, factor[k], x.k, "factor of the product of axis " .. k, "k") }
        end
      end
      for i = 1, 3 do
        if not negligible(M[k][i]) then
          terms[#terms + 1] = { 1, p:scale(name .. "m" .. i, v[i], M[k][i], x.k, "h/3 of the linear torque", "k") }
        end
      end
      if input[k] then terms[#terms + 1] = { 1, input[k] } end
      if constant[k] then terms[#terms + 1] = { 1, constant[k] } end
      out_k[k] = #terms > 0 and p:sum(name, terms, "k") or nil
    end
    return out_k
  end

  local s = x.k - x.f
  if s < 0 then fixed.unfit "f" end
  local K = { rate(y) }
  local weights = { { 1 }, { -1, 3 }, { 3, -3, 3 } }
  for n = 1, 3 do
    local v = {}
    for k = 1, 3 do
      v[k] = y[k]
      if K[1][k] then
        local terms = {}
        for i, c in ipairs(weights[n]) do terms[i] = { c, K[i][k] } end
        local name = "y" .. k .. "_" .. n + 1
        v[k] = p:sum(name, { { 1, y[k] }, { 1, p:right(name .. "d", p:sum(name .. "k", terms, "k"), s) } }, "f")
      end
    end
    K[n + 1] = rate(v)
  end

  local D, S = {}, {}
  p:block("dw = 3/8 (k1 + 3 k2 + 3 k3 + k4)/g, in units of 2^-" .. x.d .. " rad/s")
  for k = 1, 3 do
    if K[1][k] then
      D[k] = p:sum("d" .. k, { { 1, K[1][k] }, { 3, K[2][k] }, { 3, K[3][k] }, { 1, K[4][k] } }, "k")
    end
  end
  for i = 1, 3 do
    out.dw[i] = dot(p, "dw" .. axis[i], D, from[i], R.new(3, 8), x.d, "3/(8 g) e", "d") or false
    if out.dw[i] and out.limit[i] + ((out.dw[i].hi + (1 << x.d - x.w)) >> (x.d - x.w)) > (1 << 31) - 1 then
      fixed.unfit "w"
    end
  end

  p:block("a = (h/2)(y + 3/8 (k1 + 2 k2 + k3))/g: half of the integral of w")
  for k = 1, 3 do
    S[k] = y[k]
    if K[1][k] then
      local m = p:sum("m" .. k, { { 3, K[1][k] }, { 6, K[2][k] }, { 3, K[3][k] } }, "k")
      m.e, m.err = m.e + 3, m.err / 8 -- an eighth of it
      S[k] = p:sum("s" .. k, { { 1, y[k] }, { 1, p:right("m" .. k .. "r", m, s + 3) } }, "f")
    end
  end
  local a = {}
  for i = 1, 3 do a[i] = dot(p, "a" .. axis[i], S, from[i], h / R.new(2), x.a, "h/(2 g) e", "a") end
  out.a = a
  q31.commutator(p, h, x, a, out.dw)
  q31.turn(p, x, out, a)
  return out
end

-- The nodes as words of 16 bits of one exponent.
local function halved(p, prefix, list)
  local most, names = 0, { "x", "y", "z" }
  for i = 1, 3 do most = math.max(most, list[i] and list[i].hi or 0) end
  local s = 0
  while (most + (s > 0 and 1 << s - 1 or 0)) >> s > 32767 do s = s + 1 end
  local out = {}
  for i = 1, 3 do out[i] = list[i] and p:right(prefix .. names[i], list[i], s) or nil end
  return out
end

-- a + h^2/24 w x dw = a + a x (h/12 dw): small, so that words of 16 bits do.
function q31.commutator(p, h, x, a, dw)
  local q, most = h / R.new(12), 0.0
  for i = 1, 3 do
    local j, l = cyclic(i)
    most = math.max(most, fixed.most(a[j]) * (dw[l] and fixed.most(dw[l]) or 0.0))
  end
  if most * R.todouble(q) * 2.0 ^ x.a < 0.25 then return end
  p:block("a += a x (h/12) dw, h^2/24 w x dw: the turn of the axis of rotation (Magnus), in words of 16 bits")
  local e = 15 - R.log2(q)
  while math.abs((fixed.nearest(q, e))) > 32767 do e = e - 1 end
  local twelfth, short, t = fixed.constant(q, e, "h/12, 16 bits", "d"), halved(p, "A", a), halved(p, "D", dw)
  for i = 1, 3 do t[i] = t[i] and p:product("H" .. axis[i], t[i], twelfth, "d") end
  t = halved(p, "T", t)
  local whole = {}
  for i = 1, 3 do
    local j, l = cyclic(i)
    local terms = {}
    if t[l] then terms[1] = { 1, p:product("C" .. axis[i] .. 1, short[j], t[l], "a") } end
    if t[j] then terms[#terms + 1] = { -1, p:product("C" .. axis[i] .. 2, short[l], t[j], "a") } end
    whole[i] = a[i]
    if #terms > 0 then
      local c = p:to("E" .. axis[i], p:sum("C" .. axis[i], terms, "a"), x.a, "a")
      whole[i] = p:sum("a" .. axis[i] .. "t", { { 1, a[i] }, { 1, c } }, "a")
    end
  end
  for i = 1, 3 do a[i] = whole[i] end
end

-- dq = q (-(1 - cos a) - n/2, sin a a/|a|), n = |q|^2 - 1, in units of 2^-(a - 2).
function q31.turn(p, x, out, a)
  p:block("A = |a|^2; sin(|a|)/|a| = 1 - z, z = A (1/6 - A/120); cos a = 1 - A (1/2 - A/24)")
  local terms = {}
  for i = 1, 3 do terms[i] = { 1, p:mul("A" .. i, a[i], a[i], 32, "a", true) } end
  local A = p:sum("A", terms, "a")
  if fixed.most(A) > 0.0675 then fixed.unfit "step" end -- |a| <= 1/4, and roundings

  local s = { a[1], a[2], a[3] }
  if fixed.most(A) / 6 * 2.0 ^ 32 >= 0.5 then
    local e = 64 - A.e
    local sixth = fixed.constant(R.new(1, 6), e, "1/6", "a")
    local z = p:mul("z", A, p:less("Z", sixth, A, R.new(1, 120), "1/120", "a"))
    for i = 1, 3 do
      s[i] = p:sum("s" .. axis[i], { { 1, a[i] }, { -1, p:mul("z" .. axis[i], a[i], z) } }, "a")
    end
  end

  p:block("n = |q|^2 - 1; C = 1 - cos a + n/2 brings |q| back to 1 with the next step")
  local squares = {}
  for i = 1, 4 do squares[i] = { 1, p:mul("n" .. i, out.q[i], out.q[i], 32, "a", true) } end
  local whole = { kind = "constant", value = 1 << 28, q = R.one, e = 28, hi = 1 << 28, err = 0.0, about = "1" }
  squares[5] = { -1, whole }
  local n = p:sum("n", squares, "a")
  local limit = math.min(1 << 25, (1 << math.max(0, 59 - x.a)) - 1)
  local half = p:clip("nc", n, limit, q31.norm_flag)
  half.e, half.err, out.norm_limit = 29, 0.0, limit -- n/2; what is wrong with it changes |q| alone
  local C = { { 1, p:to("nh", half, x.a, "a") } }
  if fixed.most(A) / 2 * 2.0 ^ x.a >= 0.5 then
    local lost = x.a > 32 and 32 or 31 -- 1/2 must be a word
    local e = x.a + lost - A.e
    local one_half = fixed.constant(R.half, e, "1/2", "a")
    C[2] = { 1, p:mul("C2", A, p:less("B", one_half, A, R.new(1, 24), "1/24", "a"), lost, "a", true) }
  end
  local c = p:sum("C", C, "a")

  p:block("dq = q (-C, s), in units of 2^-" .. x.a - 2)
  local q = out.q
  -- Hamilton's product: component i is the sum of sign q[from] by[n], n = 1 .. 4
  local by = { c, s[1], s[2], s[3] }
  local table_of = { { -1, -2, -3, -4 }, { -2, 1, -4, 3 }, { -3, 4, 1, -2 }, { -4, -3, 2, 1 } }
  for i = 1, 4 do
    local sum = {}
    for k, from in ipairs(table_of[i]) do
      sum[k] = { from < 0 and -1 or 1, p:mul("q" .. part[i] .. k, q[math.abs(from)], by[k], 32, "a", true) }
    end
    out.dq[i] = p:sum("dq" .. part[i], sum, "a")
  end
end

-- Kinetic energy, the sum of I_k y_k^2/(2 g_k^2), in the finest unit that fits: {program, node}.
function q31.energy(step)
  local r, x = step.rates, step.x
  local g = scaling(r, step.h / R.new(3))
  local to = frames(r, g)
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
