-- economy.lua -- short polynomials for the functions that emitted loops compute without a call, and their C text.
--
-- A power series on 0 <= u <= h with terms to spare loses its last ones by subtracting multiples of Chebyshev's
-- polynomial of the same degree (economisation: Lanczos 1938, J. Math. Phys. 17, 123): each takes off no more than the
-- multiple, far less than the term itself.  As many terms go as their multiples together stay below the given bound.
-- In exact rationals, so the coefficients are those of mathematics, rounded once.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"

local economy = {}

-- Chebyshev's polynomials T_n(2 u/h - 1), n = 0 .. last, as lists of coefficients from u^0.
-- By T_(n+1) = 2 x T_n - T_(n-1) at x = 2 u/h - 1.
local function chebyshev(last, h)
  local two, twice = R.new(2), R.new(4) / h
  local list = { [0] = { [0] = R.one }, { [0] = -R.one, two / h } }
  for n = 2, last do
    local before, now, next_one = list[n - 2], list[n - 1], {}
    for k = 0, n do
      local a = now[k] and -two * now[k] or R.zero
      if k > 0 then a = a + twice * now[k - 1] end
      next_one[k] = a - (before[k] or R.zero)
    end
    list[n] = next_one
  end
  return list
end

local known = {} -- {degree, h, list}: they are the same for many series

local function chebyshev_of(last, h)
  for _, k in ipairs(known) do
    if k[1] == last and k[2] == h then return k[3] end
  end
  known[#known + 1] = { last, h, chebyshev(last, h) }
  return known[#known][3]
end

-- series: coefficients from u^0, as rationals.  Returns fewer of them, to `bound` on 0 <= u <= h.
-- |T_n| <= 1 on the interval, so what is lost is at most the sum of the multiples.
function economy.shorten(series, h, bound)
  local n, lost, power = #series, R.zero, {}
  for k = 0, n do power[k] = series[k] end
  local T = chebyshev_of(n, h)
  while n > 0 do
    local multiple = power[n] / T[n][n]
    lost = lost + R.abs(multiple)
    if lost > bound then break end
    for k = 0, n - 1 do power[k] = power[k] - multiple * T[n][k] end
    power[n] = nil
    n = n - 1
  end
  return power
end

-- sum of sign^n x^(2n + odd)/(2n + odd)! at x = scale y as a series in u = y^2, over y if odd; each term to 200 bits,
-- as the scale is
local function series(scale, sign, odd)
  local out, term, step = {}, odd == 1 and scale or R.one, sign * scale * scale
  for n = 0, 20 do
    out[n] = term
    term = R.round(term * step / R.new((2 * n + odd + 1) * (2 * n + odd + 2)), 200)
  end
  return out
end

-- Statements for the value of a polynomial in u, where u, u2 = u^2 and u4 = u^4 are known, into `name`: halves side by
-- side (Estrin), small terms first:
-- (c0 + c1 u) + u^2 (c2 + c3 u) + u^4 ((c4 + c5 u) + u^2 ..), at most twelve coefficients.
local function statements(name, c, real, type_name)
  local lines, parts = {}, {}
  for k = 0, #c, 2 do
    local text = number.text(c[k], real)
    if c[k + 1] then
      local next_one = c[k + 1]
      text = text .. (R.sign(next_one) < 0 and " - " or " + ") .. number.text(R.abs(next_one), real) .. "*u"
    end
    local part = string.format("%s%d", name, k)
    if c[k + 1] then lines[#lines + 1] = string.format("const %s %s = %s;", type_name, part, text) else part = text end
    parts[#parts + 1] = part
  end
  local function quarter(i)
    local a, b = parts[i], parts[i + 1]
    return b and string.format("%s + u2*%s", a, string.match(b, "^%-") and "(" .. b .. ")" or b) or a
  end
  local text = quarter(1)
  if parts[3] then
    local inner = quarter(3)
    if parts[5] then inner = inner .. " + u4*" .. (parts[6] and "(" .. quarter(5) .. ")" or parts[5]) end
    text = string.format(parts[4] and "(%s) + u4*(%s)" or "(%s) + u4*%s", text, inner)
  end
  lines[#lines + 1] = string.format("const %s %s = %s;", type_name, name, text)
  return lines
end

-- into v: sine_lines and cosine_lines (sin(pi x)/x and cos(pi x), u = x^2 <= 1/4), even_lines and odd_lines (the even
-- part of 2^f and the odd one over f, u = f^2 <= 1/4), for 2^-4 of a unit of the last place; type_name: what the code
-- calls the real type
function economy.fill(v, real, type_name)
  local bits = real == "float" and 24 or 53
  local pi, log2 = R.apply("pi", 200), R.apply("log", 200, R.lift(2))
  local function make(name, scale, sign, odd)
    local c = economy.shorten(series(scale, R.new(sign), odd), R.new(1, 4), R.new(2) ^ -(bits + 4))
    for k = 0, #c do
      c[k] = R.fromdouble(real == "float" and R.tofloat(c[k]) or R.todouble(c[k]))
    end
    return statements(name, c, real, type_name)
  end
  function v.sine_lines() return make("s", pi, -1, 1) end
  function v.cosine_lines() return make("c", pi, -1, 0) end
  function v.even_lines() return make("e", log2, 1, 0) end
  function v.odd_lines() return make("o", log2, 1, 1) end
end

return economy
