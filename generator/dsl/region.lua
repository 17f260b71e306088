-- region.lua -- reads region{{x, lo, hi}, {y, lo, hi}, {z, lo, hi}, density = ...} of a scene.
--
-- The rows go from the outermost coordinate to the innermost, in any order of x, y, z; limits are polynomials in the
-- coordinates of the rows before, with parameters as coefficients; so is the density, in all three.  A polynomial with
-- plain numbers only, 1 - x^2, is one in metres; with a unit among them all units must fit.  For the default
-- parameters, limits must not cross and the density must not be negative, at 7 x 7 x 7 points of the region.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local coordinate = require "generator.algebra.coordinate"
local args = require "generator.dsl.args"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"
local diag = require "generator.diag"

local region = {}

local what = "region"
local names = coordinate.names

-- A polynomial of dimension dim in the coordinates of `known` (set of 1, 2, 3); nil after an error.
local function polynomial(ctx, line, name, given, dim, known)
  local r, why = value.of(given)
  if not r then
    ctx.diag:error(line, what, name .. " " .. why, diag.show(given))
    return nil
  end
  if r.dim and not r.plain and not units.equal(r.dim, dim) then
    ctx.diag:error(line, what, name .. " must be in " .. units.name(dim), value.show(given, true))
    return nil
  end
  local done, p = pcall(coordinate.of, r.e)
  if not done and p ~= coordinate.too_large then error(p, 0) end
  if not (done and p) then
    ctx.diag:error(line, what, name .. " must be a polynomial in x, y, z" .. (done and "" or " of fewer terms"),
      value.show(given))
    return nil
  end
  for _, t in ipairs(p) do
    for i = 1, 3 do
      if t[i] > 0 and not known[i] then
        ctx.diag:error(line, what, name .. " must not depend on " .. names[i] .. ", which is not outside of it",
          value.show(given))
        return nil
      end
    end
    if not value.number(t.c) then
      ctx.diag:error(line, what, name .. " must be real for the default parameters", value.show(given))
      return nil
    end
  end
  return p
end

-- The value of a polynomial at the point r, for the default parameters.
local function at(p, r)
  local sum = R.zero
  for _, t in ipairs(p) do
    local v = value.number(t.c)
    for i = 1, 3 do
      if t[i] > 0 then v = v * r[i] ^ t[i] end
    end
    sum = sum + v
  end
  return sum
end

-- The polynomial with numbers for coefficients.
local function defaults(p)
  local out = {}
  for i, t in ipairs(p) do out[i] = { c = expr.num(value.number(t.c)), t[1], t[2], t[3] } end
  return out
end

local function place(r)
  local list = {}
  for i = 1, 3 do list[i] = diag.show(R.todouble(r[i])) end
  return "(" .. table.concat(list, ", ") .. ")"
end

-- Reports limits that cross and a negative density, once each; true when there is none.
local function sound(ctx, line, node)
  local limits = {}
  for n = 1, 3 do limits[n] = { defaults(node.limits[n][1]), defaults(node.limits[n][2]) } end
  local density = defaults(node.density)
  local most, r, positive, bad = 6, { R.zero, R.zero, R.zero }, false, nil
  local function visit(n)
    if n > 3 then
      local d = at(density, r)
      if R.sign(d) < 0 then bad = { "density must not be negative", diag.show(R.todouble(d)) .. " at " .. place(r) } end
      positive = positive or R.sign(d) > 0
      return
    end
    local v = node.order[n]
    local lo, hi = at(limits[n][1], r), at(limits[n][2], r)
    if hi < lo or (n == 1 and lo == hi) then
      bad = { "the upper limit of " .. names[v] .. " must exceed the lower one",
        diag.show(R.todouble(lo)) .. " to " .. diag.show(R.todouble(hi)) .. (n > 1 and " near " .. place(r) or "") }
      return
    end
    for k = 0, most do
      r[v] = lo + (hi - lo) * R.new(k, most)
      visit(n + 1)
      if bad then return end
    end
    r[v] = R.zero
  end
  visit(1)
  if not bad and not positive then bad = { "density must be positive somewhere", "0" } end
  if bad then ctx.diag:error(line, what, bad[1], bad[2]) end
  return not bad
end

-- The polynomial at the point r, whose coordinates are expressions.
local function symbolic(p, r)
  local sum = expr.zero
  for _, t in ipairs(p) do
    local e = t.c
    for i = 1, 3 do
      if t[i] > 0 then e = e * r[i] ^ t[i] end
    end
    sum = sum + e
  end
  return sum
end

-- Conditions for other parameters, asked by the emitted code: at the corners of the region, where outer coordinates are
-- at their limits, limits must not cross and the density must not be negative.  That is necessary; what lies between
-- the corners is not asked again.
local function corners(ctx, line, node)
  local r = {}
  local function visit(n)
    if n > 3 then
      args.condition(ctx, line, what, "density must not be negative", symbolic(node.density, r), "a negative one", true)
      return
    end
    local v = node.order[n]
    local ends = { symbolic(node.limits[n][1], r), symbolic(node.limits[n][2], r) }
    args.condition(ctx, line, what, "the upper limit of " .. names[v] .. " must exceed the lower one",
      ends[2] - ends[1], "a lower one", n > 1)
    for k = 1, 2 do
      r[v] = ends[k]
      visit(n + 1)
    end
    r[v] = nil
  end
  visit(1)
end

-- The node {shape, a = {order, limits, density}, mass, density, measure, line, broken} of a scene's table.
function region.read(ctx, line, given)
  local node = { shape = what, line = line, measure = "volume", broken = true }
  if not args.plain(given) then
    ctx.diag:error(line, what, "takes {{x, lo, hi}, {y, lo, hi}, {z, lo, hi}, density = or mass =}", diag.show(given))
    return node
  end
  for _, k in ipairs(args.keys(given)) do
    if k ~= "density" and k ~= "mass" and not (math.type(k) == "integer" and k >= 1 and k <= 3) then
      ctx.diag:error(line, what, "unknown argument " .. diag.show(k) .. " (it has three rows, mass, density)")
    end
  end
  local known, a, ok = {}, { order = {}, limits = {} }, true
  for n = 1, 3 do
    local row = given[n]
    local r = args.list(row, 3) and value.of(row[1])
    local v = r and coordinate.index(r.e)
    if not v or known[v] then
      ctx.diag:error(line, what, "row " .. n .. " must be {coordinate, lo, hi}, each of x, y, z once", diag.show(row))
      return node
    end
    local limits = {}
    for k = 1, 2 do
      local name = (k == 1 and "lower" or "upper") .. " limit of " .. names[v]
      limits[k] = polynomial(ctx, line, name, row[k + 1], units.length, known)
      ok = ok and limits[k] ~= nil
    end
    known[v], a.order[n], a.limits[n] = true, v, limits
  end
  if given.mass ~= nil and given.density ~= nil then
    ctx.diag:error(ctx.diag:locate(line, "density"), what, "give mass or density, not both")
    return node
  elseif given.mass ~= nil then
    node.mass = args.scalar(ctx, ctx.diag:locate(line, "mass"), what, "mass", { dim = "mass", sign = "positive" },
      given.mass)
    a.density = coordinate.constant(expr.one)
    ok = ok and node.mass ~= nil
  elseif given.density ~= nil then
    a.density = polynomial(ctx, ctx.diag:locate(line, "density"), "density", given.density, units.density_volume, known)
    node.density = expr.one -- a factor: the polynomial itself is integrated
    ok = ok and a.density ~= nil
  else
    ctx.diag:error(line, what, "mass is missing (give mass or density)")
    return node
  end
  node.a = a
  node.broken = not (ok and sound(ctx, line, a))
  if not node.broken then corners(ctx, line, a) end
  return node
end

return region
