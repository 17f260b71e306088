-- exists.lua -- from when on a tensor that changes with time is that of no body.
--
-- A body's tensor I has second moments S = tr(I)/2 1 - I = sum m r r^T, which no direction makes negative: that is the
-- triangle inequality of the principal moments, and makes them positive.  S is so where none of its seven principal
-- minors is negative.  Where the entries are polynomials in t so are the minors: between two of their roots nothing
-- changes, so one time of each such interval decides.  Other entries are looked at `samples` times, and the change is
-- found by bisection.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local roots = require "generator.algebra.roots"
local vec = require "generator.algebra.vec"
local breaks = require "generator.dynamics.breaks"
local equations = require "generator.dynamics.equations"

local exists = {}

local samples, degree = 4096, 12
local rounding = 64 * 2.0 ^ -52 -- of the largest of a minor's terms

local minors = { { 1 }, { 2 }, { 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 }, { 1, 2, 3 } }
local place = { { 1, 4, 5 }, { 4, 2, 6 }, { 5, 6, 3 } } -- of xx, yy, zz, xy, xz, yz

-- The coefficients of e in t, in doubles; nil if it is no polynomial of moderate degree.
local function coefficients(e, env)
  local list, factorial = {}, 1.0
  local at = {}
  for k, v in pairs(env) do at[k] = v end -- a copy: order is lost anyway
  at.t = 0.0
  for n = 0, degree do
    list[n + 1] = evaluate.double(e, at) / factorial
    e = calculus.diff(e, motion.sym "t")
    if e == expr.zero then return list end
    factorial = factorial * (n + 1)
  end
  return nil
end

local function add(a, b, factor)
  local c = {}
  for i = 1, math.max(#a, #b) do c[i] = (a[i] or 0.0) + factor * (b[i] or 0.0) end
  return c
end

local function times(a, b)
  local c = {}
  for i = 1, #a + #b - 1 do c[i] = 0.0 end
  for i, x in ipairs(a) do
    for k, y in ipairs(b) do c[i + k - 1] = c[i + k - 1] + x * y end
  end
  return c
end

-- The determinant of the rows and columns of S in the list: entries are polynomials.
local function determinant(S, list)
  local function at(i, k) return S[place[list[i]][list[k]]] end
  if #list == 1 then return at(1, 1) end
  if #list == 2 then return add(times(at(1, 1), at(2, 2)), times(at(1, 2), at(1, 2)), -1.0) end
  local function cofactor(a, b) return add(times(at(2, a), at(3, b)), times(at(2, b), at(3, a)), -1.0) end
  return add(add(times(at(1, 1), cofactor(2, 3)), times(at(1, 2), cofactor(1, 3)), -1.0),
    times(at(1, 3), cofactor(1, 2)), 1.0)
end

-- S of a tensor whose entries are polynomials.
local function second(I)
  local half = {}
  for k = 1, 3 do half = add(half, I[k], 0.5) end
  return { add(half, I[1], -1.0), add(half, I[2], -1.0), add(half, I[3], -1.0), times(I[4], { -1.0 }),
    times(I[5], { -1.0 }), times(I[6], { -1.0 }) }
end

-- Is this the tensor of a body?  Numbers.
local function sound(I)
  local list, size = {}, 0.0
  for k = 1, 6 do
    if I[k] ~= I[k] or math.abs(I[k]) == math.huge then return false end
    list[k], size = { I[k] }, math.max(size, math.abs(I[k]))
  end
  local S = second(list)
  for _, m in ipairs(minors) do
    if determinant(S, m)[1] < -rounding * size ^ #m then return false end
  end
  return true
end

-- The first time up to `finish` from which I(t) is no body's for a while, or nil.  polynomials: of the entries, or nil;
-- value(t): the entries; corners: where they have some.
local function first(polynomials, value, corners, finish)
  local at = { 0.0, finish }
  if polynomials then
    local S = second(polynomials)
    for _, m in ipairs(minors) do
      for _, t in ipairs(roots.between(determinant(S, m), 0.0, finish)) do at[#at + 1] = t end
    end
  else
    for i = 1, samples - 1 do at[#at + 1] = finish * (i / samples) end
    for _, t in ipairs(corners) do at[#at + 1] = t > 0 and t < finish and t or nil end
  end
  table.sort(at)
  for i = 1, #at - 1 do
    local a, b = at[i], at[i + 1]
    local middle = a + (b - a) / 2
    if b > a and polynomials and not sound(value(middle)) then return a end
    if not polynomials then
      if not sound(value(a)) then return a end
      if not sound(value(b)) then return roots.bisect(function(t) return sound(value(t)) and 1 or -1 end, a, b) end
    end
  end
  return nil
end

-- The seven principal minors of S of a model whose parts move, and its trace, as expressions; else nil.
function exists.minors(model)
  for _, e in ipairs(model.record.effects) do
    if e.spec.varies and e.a.D then
      local I = vec.map(model.inertia, function(x, k) return { x + e.a.D[k] } end)
      local S, list = second(I), {}
      for i, m in ipairs(minors) do list[i] = determinant(S, m)[1] end
      list[8] = S[1][1] + S[2][1] + S[3][1]
      return list
    end
  end
  return nil
end

-- Of the effect of a scene whose parts move: the time, within 0 to `finish`, from which on the tensor is no body's, and
-- the effect's line; nil if it always is one.
function exists.fails(job, finish)
  local model = job.model
  for _, e in ipairs(model.record.effects) do
    if e.spec.varies and e.a.D and finish > 0 then
      local env, I, polynomials, corners = {}, {}, {}, {}
      for name, v in pairs(model.defaults) do env[name] = v end -- into a table: order is lost anyway
      for k = 1, 6 do
        I[k] = model:double(model.inertia[k]) + 0.0
        local p = polynomials and coefficients(e.a.D[k], env)
        if polynomials and p then polynomials[k] = add(p, { I[k] }, 1.0) else polynomials = nil end
      end
      for i, knot in ipairs(polynomials and {} or breaks.knots(equations.fork(job.equations))) do
        corners[i] = R.todouble(knot.value)
      end
      local function value(t)
        env.t = t
        return vec.map(e.a.D, function(d, k) return I[k] + evaluate.double(d, env) end)
      end
      local t = first(polynomials, value, corners, finish)
      if t then return t, e.line end
    end
  end
  return nil
end

return exists
