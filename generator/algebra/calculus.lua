-- calculus.lua -- derivative and substitution of expressions.
--
-- ABOVE the line.  Both walk the shared graph once (memoised by node), so their cost is the number of
-- distinct subexpressions.  d|x|/dx is x/|x|, its value everywhere but at 0.
--
-- diff is the chain rule from the leaves up, d f(u, v) = f_1 du + f_2 dv, with simplifying constructors, so that what
-- does not depend on x is 0 at once and is not multiplied out.  A product of n factors of which k depend on x has k
-- terms of n factors.  Functions of exact.lua are differentiated into functions of the same kind, so that what is
-- computed without loss near 0 has a derivative that is, too.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"

local calculus = {}

-- d fn(args) / d args[i], one entry a function; source: any table of derivatives (DLMF 4.20, 4.34).
-- An entry gets the arguments and returns one derivative for each of them.
local rules = {
  sin = function(a) return { expr.call("cos", a) } end,
  cos = function(a) return { -expr.call("sin", a) } end,
  tan = function(a) return { 1 + expr.call("tan", a) ^ 2 } end,
  asin = function(a) return { (1 - a ^ 2) ^ R.new(-1, 2) } end,
  acos = function(a) return { -((1 - a ^ 2) ^ R.new(-1, 2)) } end,
  atan = function(a) return { 1 / (1 + a ^ 2) } end,
  atan2 = function(y, x) return { x / (x ^ 2 + y ^ 2), -y / (x ^ 2 + y ^ 2) } end,
  exp = function(a) return { expr.call("exp", a) } end,
  log = function(a) return { 1 / a } end,
  sinh = function(a) return { expr.call("cosh", a) } end,
  cosh = function(a) return { expr.call("sinh", a) } end,
  tanh = function(a) return { 1 - expr.call("tanh", a) ^ 2 } end,
  opaque = function() return { expr.one } end,
  abs = function(a) return { expr.call("side", a) } end, -- at a = 0 the derivative from the right
  side = function() return { expr.zero } end,
  sign = function() return { expr.zero } end,
  min = function(a, b) -- the derivative of the smaller one; of both together where they are equal that of the first
    local above = expr.call("side", b - a)
    return { (1 + above) / 2, (1 - above) / 2 }
  end,
  max = function(a, b)
    local above = expr.call("side", a - b)
    return { (1 + above) / 2, (1 - above) / 2 }
  end,
  clamp = function(x, low, high) -- low <= high; at a limit the derivative from within
    local above, below = expr.call("side", x - low), expr.call("side", high - x)
    return { (1 + above) * (1 + below) / 4, (1 - above) / 2, (1 - below) / 2 }
  end,
  -- R_G's partial derivatives are the means H_i (exact.lua): a d/da (a b c G) = a b c (G - H_a) = a b c (H_b + H_c)
  ellipsoid_area = function(a, b, c)
    local area = expr.call("ellipsoid_area", a, b, c)
    local function normal(...) return expr.call("ellipsoid_normal", ...) end
    local x, y, z = normal(a, b, c), normal(b, c, a), normal(c, a, b)
    return { area * (y + z) / a, area * (z + x) / b, area * (x + y) / c }
  end,
  -- of the closed forms in exact.lua
  -- of arcs all by (sin(u)/u)' = -arc_lever(u)/u
  arc_across = function(h) return { expr.call("arc_lever", 2 * h) / (2 * h) } end,
  arc_along = function(h)
    local function lever(x) return expr.call("arc_lever", x) end
    return { (2 * expr.call("sin", h) / h * lever(h) - lever(2 * h) / 2) / h }
  end,
  arc_lever = function(h) return { expr.call("sin", h) - expr.call("arc_lever", h) / h } end,
  catenary_rise = function(u)
    local s = expr.call("sinh", u)
    return { expr.call("cosh", u) / s ^ 2 * (1 - u / s) }
  end,
  catenary_width = function(u)
    local s = expr.call("sinh", u)
    return { 2 * (1 / (u * s ^ 2) + expr.call("cosh", u) / (u ^ 2 * s) - 2 / u ^ 3) }
  end,
  catenary_height = function(u)
    local s, c = expr.call("sinh", u), expr.call("cosh", u)
    return { c / s ^ 3 * (u * c / s + u ^ 2 / s ^ 2 - 2) }
  end,
}

-- The function e -> its derivative with respect to the symbol x, for many expressions: what they share is
-- differentiated once.  `known` (optional: node -> derivative) gives the derivatives of symbols that stand for
-- functions of x (chain rule through named definitions).
function calculus.by(x, known)
  local memo = {}
  local function d(u)
    local v = memo[u]
    if v then return v end
    if u == x then
      v = expr.one
    elseif u.kind == "num" then
      v = expr.zero
    elseif u.kind == "sym" then
      v = known and known[u] or expr.zero
    elseif u.kind == "add" then
      local list = {}
      for i = 1, #u do list[i] = d(u[i]) end
      v = expr.add(list)
    elseif u.kind == "mul" then
      local list = {}
      for i = 1, #u do
        local di = d(u[i])
        if di ~= expr.zero then
          local factors = { di }
          for j = 1, #u do
            if j ~= i then factors[#factors + 1] = u[j] end
          end
          list[#list + 1] = expr.mul(factors)
        end
      end
      v = expr.add(list)
    elseif u.kind == "pow" then
      v = d(u.base)
      if v ~= expr.zero then v = expr.mul { u.exp, expr.pow(u.base, u.exp - R.one), v } end
    elseif u.fn == "pi" then
      v = expr.zero
    else
      local inner, constant = {}, true
      for i = 1, #u do
        inner[i] = d(u[i])
        constant = constant and inner[i] == expr.zero
      end
      if constant then
        v = expr.zero
      else
        local rule = rules[u.fn] or error("no derivative rule for " .. u.fn)
        local partial = rule(table.unpack(u))
        for i = 1, #u do inner[i] = partial[i] * inner[i] end
        v = expr.add(inner)
      end
    end
    memo[u] = v
    return v
  end
  return d
end

-- The derivative of e alone.
function calculus.diff(e, x, known) return calculus.by(x, known)(e) end

-- The function e -> e with each node that is a key of `map` replaced by its value, for many expressions.
function calculus.substitution(map)
  local memo = {}
  local function s(u)
    local v = map[u] or memo[u]
    if not v then
      v = expr.map(u, s)
      memo[u] = v
    end
    return v
  end
  return s
end

-- The same for e alone.
function calculus.substitute(e, map) return calculus.substitution(map)(e) end

return calculus
