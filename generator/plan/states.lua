-- states.lua -- the states and parameters at which a plan is tried: points that fill the scene's ranges.
--
-- First the scene's own, then extremes (up to half of the points), then an even filling.  Extremes: all corners of the
-- first quantities, rates before others; ends of further ones are products of these signs, so that any two meet in all
-- four ways (a fractional factorial design: Box, Hunter 1961, Technometrics 3, 311).
-- The filling is Kronecker's sequence with powers of the root of x^(d+1) = x + 1 (Roberts 2018, "The unreasonable
-- effectiveness of quasirandom sequences").  No libm function decides a point, so all machines have the same ones.
-- Without `ranges`: rates, position and velocity within 10 % of their size in each component, attitude within 0.1 rad.
-- An input is held at a value within its limits.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local inputs = require "generator.dynamics.inputs"
local numeric = require "generator.dynamics.numeric"

local states = {}

local default_part, default_angle = 0.1, R.new(1, 10)

local narrow = numeric.narrow

-- The limits {label, unit, low, high} of all inputs, doubles; nil where one has none, or there is no input.
function states.limits(job)
  local list = {}
  for i, s in ipairs(job.model.inputs) do
    local low, high = inputs.range(job.model, s)
    if not low then return nil end
    list[i] = { label = s.label, unit = s.unit, low = R.todouble(low), high = R.todouble(high) }
  end
  return #list > 0 and list or nil
end

-- What varies: {quantities}, each {set = function(point, u), u from 0 to 1} of one number, or of three.
local function quantities(job, own)
  local list, given = {}, job.ranges
  local function put(lo, hi, set)
    if hi > lo then list[#list + 1] = function(u) set(lo + u * (hi - lo)) end end
  end
  local point -- the one that is being made
  local size = {}
  for i, s in ipairs(job.states) do size[s.kind] = (size[s.kind] or 0.0) + own[i] ^ 2 end
  for i, s in ipairs(job.states) do
    local function set(x) point.x[i] = x end
    local range = given and given.states[i]
    if range then
      put(R.todouble(range.lo), R.todouble(range.hi), set)
    elseif not given and (s.kind == "rates" or s.kind == "position" or s.kind == "velocity") then
      local d = default_part * math.sqrt(size[s.kind])
      put(own[i] - d, own[i] + d, set)
    end
  end
  for _, r in ipairs(given and given.params or {}) do
    put(R.todouble(r.lo), R.todouble(r.hi), function(x) point.values[r.name] = x end)
  end
  for k, limit in ipairs(states.limits(job) or {}) do
    put(limit.low, limit.high, function(x) point.input[k] = x end)
  end
  local angle = not given and default_angle or given and given.attitude
  if job.model.has.attitude and angle then
    local most = angle == "any" and 1.0 or R.todouble(R.apply("sin", 200, angle / R.lift(2)))
    for k = 1, most > 0 and 3 or 0 do
      list[#list + 1] = function(u) point.turn[k] = 2 * u - 1 end
    end
    return list, function(p) point = p end, most
  end
  return list, function(p) point = p end, 0.0
end

-- The attitude q turned by a rotation whose axis times sin(half its angle) is a point of the ball of radius `most`,
-- from a point c of the cube [-1, 1]^3.
local function turned(q, c, most)
  local big, sum = 0.0, 0.0
  for k = 1, 3 do
    big = math.max(big, math.abs(c[k]))
    sum = sum + c[k] ^ 2
  end
  local f = sum > 0 and most * big / math.sqrt(sum) or 0.0
  local x, y, z = f * c[1], f * c[2], f * c[3]
  local w = math.sqrt(math.max(0.0, 1 - (x * x + y * y + z * z)))
  local r = { q[1] * w - q[2] * x - q[3] * y - q[4] * z, q[1] * x + q[2] * w + q[3] * z - q[4] * y,
    q[1] * y + q[3] * w + q[4] * x - q[2] * z, q[1] * z + q[4] * w + q[2] * y - q[3] * x }
  local n = math.sqrt(r[1] ^ 2 + r[2] ^ 2 + r[3] ^ 2 + r[4] ^ 2)
  return { r[1] / n, r[2] / n, r[3] / n, r[4] / n }
end

local function ones(n) -- of its binary digits
  local count = 0
  while n > 0 do
    count, n = count + (n & 1), n >> 1
  end
  return count
end

-- The root of x^(d+1) = x + 1 by Newton's method from above, where it converges from one side.
-- d = 1: the golden ratio.
local function root(d)
  local x = 2.0
  for _ = 1, 100 do
    local p = 1.0
    for _ = 1, d do p = p * x end -- x^d
    x = x - (p * x - x - 1) / ((d + 1) * p - 1)
  end
  return x
end

-- Coordinates in [0, 1]^d of the n points after the first: extremes, then the filling from its place `skip` on.
local function coordinates(d, n, skip)
  local list = {}
  if d == 0 then return list end
  -- rows: how many extremes, a power of two; a column is a mask of bits of the row's number, and the parity of the bits
  -- that both have tells which end the quantity is at
  local rows, signs = 1, {}
  while rows < 2 ^ d and 4 * rows <= n + 1 or rows < 8 and rows < 2 ^ d do rows = 2 * rows end
  for k = 0, 62 do -- single signs, then products of three, of five, ..
    if 1 << k < rows then signs[#signs + 1] = 1 << k end
  end
  for more = 3, 1, -2 do
    for column = 1, rows - 1 do
      if ones(column) > 1 and (ones(column) % 2 == 1) == (more == 3) then signs[#signs + 1] = column end
    end
  end
  for i = 0, math.min(rows, n) - 1 do
    if skip > 0 then break end
    local u = {}
    for k = 1, d do u[k] = ones(i & signs[(k - 1) % #signs + 1]) % 2 + 0.0 end
    list[#list + 1] = u
  end
  local x, step = root(d), {}
  local p = 1.0
  for k = 1, d do
    p = p / x
    step[k] = p
  end
  local i = skip
  while #list < n do
    i = i + 1
    local u = {}
    for k = 1, d do
      u[k] = 0.5 + i * step[k]
      u[k] = u[k] - math.floor(u[k])
    end
    list[#list + 1] = u
  end
  return list
end

-- The function that makes a point {x = state, values = {parameter = rational} or nil, params = doubles for NAME_init or
-- nil, input = what is held, or nil} of coordinates u in the unit cube (nil: the scene's own), and their
-- number.
-- Everything a point has is a number of the real type, so the run from it and the truth begin at the same place.
local function maker(job, real)
  local own = numeric.initial(job)
  local list, choose, most = quantities(job, own)
  local varies = job.ranges and #job.ranges.params > 0
  local first
  for i = #job.states, 1, -1 do first = job.states[i].kind == "attitude" and i or first end
  return function(u)
    local point = { x = { table.unpack(own) }, values = {}, turn = { 0.0, 0.0, 0.0 }, input = {} }
    for k = 1, #job.model.inputs do point.input[k] = 0.0 end
    choose(point)
    for k, set in ipairs(list) do
      if u then set(u[k]) end
    end
    if most > 0 and u then
      local q = turned({ table.unpack(own, first, first + 3) }, point.turn, most)
      for k = 1, 4 do point.x[first + k - 1] = q[k] end
    end
    for i, x in ipairs(point.x) do point.x[i] = narrow(x, real) end
    local values, params
    if varies then
      values, params = {}, {}
      for i, p in ipairs(job.model.params) do
        local x = point.values[p.name] and narrow(point.values[p.name], real)
        values[p.name] = x and R.fromdouble(x) or p.default
        params[i] = x or narrow(R.todouble(p.default), real)
      end
    end
    for k = 1, #point.input do point.input[k] = narrow(point.input[k], real) end
    return { x = point.x, values = values, params = params, input = job.equations.inputs and point.input or nil }
  end, #list
end

-- n points, representable in the real type; one where nothing varies.  skip: without the first point and the extremes,
-- from there on in the filling.
function states.points(job, real, n, skip)
  local make, d = maker(job, real)
  local out = {}
  if not skip then out[1] = make(nil) end
  for _, u in ipairs(coordinates(d, skip and n or n - 1, skip or 0)) do out[#out + 1] = make(u) end
  return out
end

return states
