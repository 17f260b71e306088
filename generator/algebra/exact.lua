-- exact.lua -- exact values and symmetries of the elementary functions.
--
-- Used by expr.call before a call node is made: sin and cos at multiples of pi/12, odd and even symmetry,
-- and inverse pairs.  A law stands beside each rule.  ABOVE the line.
--
-- The uniform shell on the ellipsoid of semi-axes a, b, c > 0, points (a nx, b ny, c nz) with n on the unit sphere,
-- p = (1/a^2, 1/b^2, 1/c^2), Q = sum p_i n_i^2:
--     ellipsoid_area(a, b, c)     area/(4 pi) = a b c G,  G = mean of sqrt(Q) = R_G(p)    (DLMF 19.33.1, 19.16.3)
--     ellipsoid_normal(a, b, c)   mean over the surface of N_x^2, N the unit normal, = H_x/G with
--                                 H_i = mean of p_i n_i^2/sqrt(Q), sum H_i = G
--     ellipsoid_second(a, b, c)   1/(4 pi) times the integral of x^2 over the surface; always opened:
-- With w_i = mean of n_i^2 sqrt(Q), which is a b c a_i^2 w_i = second: sum w_i = G, and the equation of Euler, Poisson
-- and Darboux that such means obey gives w_i - w_j = (H_i - H_j)/4.  Hence w_i = (G + H_i)/4, that is
--     ellipsoid_second = a^2 (1 + ellipsoid_normal)/4 ellipsoid_area.
--
-- Means whose closed forms cancel for a short curve, so that they are functions of their own:
--     arc_across(h)       mean of sin(t)^2 over |t| <= h       = (1 - sin(2 h)/(2 h))/2                h^2/3
--     arc_along(h)        variance of cos(t) over |t| <= h     = (1 + sin(2 h)/(2 h))/2 - (sin(h)/h)^2 h^4/45
--     arc_lever(h)        mean of t sin(t) over |t| <= h       = sin(h)/h - cos(h)                     h^2/3
-- (the last column: first term for small h); where sine and cosine of h are known they open.  And over the catenary
-- y = cosh(x), |x| <= u, of half length s = sinh(u), uniform in arc length:
--     catenary_rise(u)    mean of (y - 1)/s    = coth(u)/2 + u/(2 s^2) - 1/s                           u/6
--     catenary_width(u)   variance of x/u      = 1 - 2 coth(u)/u + 2/u^2                               1/3
--     catenary_height(u)  variance of y/s      = 1/12 + (3/4 - u coth(u)/2)/s^2 - u^2/(4 s^4)          u^2/45
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local choice = require "generator.algebra.choice"

local odd = { sin = true, tan = true, asin = true, atan = true, sinh = true, tanh = true, catenary_rise = true,
  side = true, sign = true }
local even = { cos = true, cosh = true, abs = true, arc_across = true, arc_along = true, arc_lever = true,
  catenary_width = true, catenary_height = true }
local at_zero = { sin = 0, tan = 0, asin = 0, atan = 0, sinh = 0, tanh = 0, cos = 1, cosh = 1, exp = 1, abs = 0,
  sign = 0, arc_across = 0, arc_along = 0, arc_lever = 0, catenary_rise = 0,
  catenary_width = "1/3", catenary_height = 0 }

local expr -- handed over by expr.lua, which needs this file when it is loaded

-- r where a is r pi with r rational, else nil
local function turns(a)
  if expr.iszero(a) then return R.zero end
  if a == expr.pi then return R.one end
  local c, rest = expr.split(a)
  if rest == expr.pi then return c end
end

-- sin(k*pi/12) for k = 0 .. 6 (15, 45 and 75 degrees by the half-angle formulas)
local function sine(k)
  local two, three, six = expr.sqrt(2), expr.sqrt(3), expr.sqrt(6)
  local table_ = { [0] = expr.zero, (six - two) / 4, expr.lift(R.half), two / 2, three / 2, (six + two) / 4,
    expr.one }
  return table_[k]
end

-- sin(r pi), nil where 12 r is no whole number: sin(x + pi) = -sin(x) and sin(pi - x) = sin(x) lead to 0 .. pi/2.
local function sin_pi(r)
  local k = (r - R.new(2) * R.floor(r / R.new(2))) * R.new(12) -- reduced to [0, 24)
  if not R.isint(k) then return nil end
  local n = R.toint(k)
  if n >= 12 then return -sine(n - 12 <= 6 and n - 12 or 24 - n) end
  return sine(n <= 6 and n or 12 - n)
end

-- Symmetric in all arguments of area, in the last two of normal: these are put in order.  A sphere is exact.
local function ellipsoid(fn, args)
  local a, b, c = args[1], args[2], args[3]
  if fn == "ellipsoid_second" then
    return a ^ 2 * (1 + expr.call("ellipsoid_normal", a, b, c)) / 4 * expr.call("ellipsoid_area", a, b, c)
  end
  if a == b and b == c then return fn == "ellipsoid_area" and a ^ 2 or expr.lift(R.new(1, 3)) end
  if expr.compare(b, c) > 0 then return expr.call(fn, a, c, b) end
  if fn == "ellipsoid_area" and expr.compare(a, b) > 0 then return expr.call(fn, b, a, c) end
end

-- Means over the arc of half angle h = r pi where sine and cosine open.
local function arc(fn, h, r)
  local s, c, double = sin_pi(r), sin_pi(r + R.half), sin_pi(r + r)
  if not (s and c and double) then return nil end
  if fn == "arc_across" then return (1 - double / (2 * h)) / 2 end
  if fn == "arc_along" then return (1 + double / (2 * h)) / 2 - (s / h) ^ 2 end
  return s / h - c
end

-- ---- rules of single functions: the value of fn(args), or nil where it stays a call ----------------------------
local rules = {}

function rules.pi() return expr.pi end

-- Of numbers alone each is a number.
local function chosen(fn, ...)
  local values = {}
  for i, a in ipairs { ... } do
    if a.kind ~= "num" then return nil end
    values[i] = a.value
  end
  return expr.lift(choice.of(fn, R.one, table.unpack(values)))
end

function rules.side(a) return chosen("side", a) or expr.nonnegative(a) and expr.one or nil end

-- c > 0: sign(c x) ==> sign(x)
function rules.sign(a)
  local c, rest = expr.split(a)
  return chosen("sign", a) or c ~= R.one and R.sign(c) > 0 and expr.call("sign", rest) or nil
end

-- The same in any order; a difference whose sign is known decides.
for fn, side in pairs { min = 1, max = -1 } do -- into a table: order is lost
  rules[fn] = function(a, b)
    local d = expr.lift(side) * (b - a)
    if expr.nonnegative(d) then return a end
    if expr.nonnegative(-d) then return b end
    if expr.compare(a, b) > 0 then return expr.call(fn, b, a) end
  end
end

function rules.abs(a)
  local value = chosen("abs", a)
  if value then return value end
  if expr.nonnegative(a) then return a end
  local c, rest = expr.split(a) -- |c x y| ==> |c| y |x| for y >= 0
  local out, inside = { expr.lift(R.abs(c)) }, {}
  for _, f in ipairs(rest.kind == "mul" and rest or { rest }) do
    local list = expr.nonnegative(f) and out or inside
    list[#list + 1] = f
  end
  if #out == 1 and out[1] == expr.one then return nil end -- nothing came out
  out[#out + 1] = expr.call("abs", expr.mul(inside))
  return expr.mul(out)
end

-- Only of numbers: what a parameter may become is not known.
function rules.clamp(a, low, high) return chosen("clamp", a, low, high) end -- a within low .. high

function rules.log(a) return a == expr.one and expr.zero or nil end

function rules.exp(a) return a.kind == "call" and a.fn == "log" and a[1] or nil end -- exp(log x) ==> x

-- Stays around what is a sum, or has one as a factor: all else is one term.
function rules.opaque(a)
  for _, f in ipairs(a.kind == "mul" and a or { a }) do
    if f.kind == "add" or f.kind == "pow" and f.base.kind == "add" then return nil end
  end
  return a
end

function rules.sin(a)
  local r = turns(a)
  return r and sin_pi(r)
end

function rules.cos(a)
  local r = turns(a)
  return r and sin_pi(r + R.half)
end

function rules.tan(a)
  local r = turns(a)
  local s, c = r and sin_pi(r), r and sin_pi(r + R.half)
  if s and c and not expr.iszero(c) then return s / c end
end

for _, fn in ipairs { "arc_across", "arc_along", "arc_lever" } do
  rules[fn] = function(h)
    local r = turns(h)
    return r and arc(fn, h, r)
  end
end

-- f(-x) ==> -f(x) of an odd function, f(x) of an even one; nil where a has no negative coefficient.
local function symmetric(fn, a)
  local c, rest = expr.split(a)
  if R.sign(c) >= 0 then return nil end
  local v = expr.call(fn, expr.mul { -c, rest })
  return odd[fn] and -v or v
end

-- The value of fn(args) where a law opens it, else nil.  Symmetry comes first: no rule sees a negative coefficient.
local function value(fn, args)
  if string.match(fn, "^ellipsoid_") then return ellipsoid(fn, args) end
  local a = args[1]
  if at_zero[fn] and expr.iszero(a) then return expr.lift(at_zero[fn]) end
  local mirrored = (odd[fn] or even[fn]) and symmetric(fn, a)
  if mirrored then return mirrored end
  local rule = rules[fn]
  return rule and rule(table.unpack(args)) or nil
end

return function(of)
  expr = of
  return value
end
