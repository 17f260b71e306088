-- q31_turn.lua -- how the step in whole numbers turns the attitude: Magnus' second term, the quaternion of an angle.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Given a, half of the integral of w over the step, and dw (q31.lua).  For w = w0 + (t/h) dw the second term of
-- Magnus' series for q' = q w/2 is h^2/24 w x dw, at half the angle; with w = 2 a/h + O(dw), and dw x dw = 0, it is
-- a x (h/12) dw.  The increment of the attitude is q (cos a - 1, sin a a/|a|), not a turned quaternion: what is small
-- is computed as a small number, in units of its own.  |a| is at most 1/4 (else `step` is to blame), so with A = |a|^2
--     sin|a|/|a| = 1 - A/6 + A^2/120 - ..,      1 - cos a = A/2 - A^2/24 + ..
-- and what is left out is below A^3/5040 < 5e-8 of a, and below A^3/720 < 4e-7.
-- |q| = 1 is restored by the next step: q (1 - n/2), n = |q|^2 - 1, is q/|q| up to 3/8 n^2.

local R = require "generator.algebra.rational"
local axes = require "generator.methods.q31_axes"
local fixed = require "generator.methods.fixed"

local turn = {}

local NORM_FLAG = 1 << 10 -- |q| is so far from 1 that no word holds the difference
local axis, part, cyclic = { "x", "y", "z" }, { "w", "x", "y", "z" }, axes.cyclic

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
function turn.commutator(p, h, x, a, dw)
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
function turn.increment(p, x, out, a)
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
  local half = p:clip("nc", n, limit, NORM_FLAG)
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

return turn
