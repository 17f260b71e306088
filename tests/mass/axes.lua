-- axes.lua - an exact judge of principal moments and axes, and tensors that are hard for them.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Nothing is solved here.  A symmetric matrix has only real eigenvalues, so by Descartes' rule the number of its
-- positive ones IS the number of sign changes in the coefficients of its characteristic polynomial (zeros left out).
-- With the coefficients of A - x 1 as exact rationals that counts the eigenvalues above and below any x, hence proves
-- that the k-th lies within a tolerance of a computed one, however close or graded they are.  Orthonormality,
-- handedness and residuals are sums of exact products.
--
--     for family, I in axes.families("double", 100) do ... end      -- I: six doubles (or floats)
--     local e = axes.measure(I, moments, vectors, format)           -- axes.double or axes.float

local R = require "generator.algebra.rational"

local axes = {}

local two = R.new(2)

-- p: the bits of the significand; tiny: the spacing below the normal numbers; decades: exponents of graded tensors
axes.double = { name = "double", p = 53, tiny = two ^ -1074, lowest = -1074, highest = 1024, decades = 300 }
axes.float = { name = "float", p = 24, tiny = two ^ -149, lowest = -149, highest = 128, decades = 30 }

-- ---- the judge ----

-- How many eigenvalues of A (six rationals) are above and below x.
local function count(A, x)
  local a, b, c, f, g, h = A[1] - x, A[2] - x, A[3] - x, A[4], A[5], A[6] -- f = xy, g = xz, h = yz
  local c1 = a + b + c
  local c2 = a * b + a * c + b * c - f * f - g * g - h * h
  local c3 = a * b * c + two * f * g * h - a * h * h - b * g * g - c * f * f
  local function changes(list)
    local last, n = 1, 0
    for _, q in ipairs(list) do
      local s = R.sign(q)
      if s ~= 0 and s ~= last then last, n = s, n + 1 end
    end
    return n
  end
  return changes { -c1, c2, -c3 }, changes { c1, c2, c3 }
end

-- Is the k-th eigenvalue (1: the smallest) within tol of m?
function axes.encloses(A, k, m, tol)
  local _, below = count(A, m - tol)
  local above = count(A, m + tol)
  return below < k and above <= 3 - k
end

function axes.positive(A) return select(1, count(A, R.zero)) == 3 end

-- The spacing of the format's numbers at |x|.
function axes.ulp(x, format)
  if R.sign(x) == 0 then return format.tiny end
  local u = two ^ (R.log2(R.abs(x)) - format.p + 1)
  return u > format.tiny and u or format.tiny
end

-- The eighths of `unit` that enclose the k-th eigenvalue around m, as a number of units; at most `most`.
local function error_in(A, k, m, unit, most)
  for eighths = 4, 8 * most do -- half a unit is what rounding costs
    -- 2^-20 of a unit: rounding of the pairs themselves
    if axes.encloses(A, k, m, unit * (R.new(eighths, 8) + two ^ -20)) then return eighths / 8 end
  end
  return math.huge
end

local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end

-- Errors of three moments and nine components: norm and own in units in the last place of the largest moment and of
-- the moment itself (own only if `graded`), skew = max |X X^T - 1| and residue = max |A x - m x| / (largest moment or
-- the format's smallest number) in units of 2^(1-p); handed and ascending are booleans.
function axes.measure(I, moments, vectors, format, graded)
  local A, m, x = {}, {}, {}
  for n = 1, 6 do A[n] = R.fromdouble(I[n]) end
  for k = 1, 3 do
    m[k], x[k] = R.fromdouble(moments[k]), {}
    for n = 1, 3 do x[k][n] = R.fromdouble(vectors[3 * k - 3 + n]) end
  end
  local size = R.abs(m[1]) > R.abs(m[3]) and R.abs(m[1]) or R.abs(m[3])
  local unit, e = axes.ulp(size, format), { norm = 0.0, own = 0.0, skew = 0.0, residue = 0.0 }
  local epsilon = two ^ (1 - format.p)
  local function worse(field, q) e[field] = math.max(e[field], R.todouble(q)) end
  for k = 1, 3 do
    e.norm = math.max(e.norm, error_in(A, k, m[k], unit, 4))
    if graded then e.own = math.max(e.own, error_in(A, k, m[k], axes.ulp(m[k], format), 64)) end
    for j = 1, 3 do worse("skew", R.abs(dot(x[k], x[j]) - R.new(j == k and 1 or 0)) / epsilon) end
    local rows = { { A[1], A[4], A[5] }, { A[4], A[2], A[6] }, { A[5], A[6], A[3] } }
    for n = 1, 3 do
      -- below the normal numbers the moment is off by half their spacing
      local r = R.abs(dot(rows[n], x[k]) - m[k] * x[k][n]) - format.tiny / two
      if R.sign(r) > 0 then worse("residue", r / (size * epsilon)) end
    end
  end
  local cross = { x[1][2] * x[2][3] - x[1][3] * x[2][2], x[1][3] * x[2][1] - x[1][1] * x[2][3],
    x[1][1] * x[2][2] - x[1][2] * x[2][1] }
  e.handed = R.sign(dot(cross, x[3])) > 0
  e.ascending = m[1] <= m[2] and m[2] <= m[3]
  e.signed = axes.signed(vectors, format)
  return e
end

-- The rule of sign: in the first two axes the first component within 1/16 of the largest is positive.  At 15/16 itself,
-- as in (15, -4, -16), rounding decides whether a component is within.
function axes.signed(v, format)
  local slack = 4 * 2.0 ^ (1 - format.p)
  for k = 0, 1 do
    local largest = math.max(math.abs(v[3 * k + 1]), math.abs(v[3 * k + 2]), math.abs(v[3 * k + 3]))
    for n = 1, 3 do
      local ratio = math.abs(v[3 * k + n]) / largest
      if ratio >= 15 / 16 - slack and v[3 * k + n] > 0 then break end
      if ratio >= 15 / 16 + slack then return false end
    end
  end
  return true
end

-- ---- tensors ----

local state = 1
local function int(n) -- Park and Miller's generator, as everywhere in the tests
  state = state * 16807 % 2147483647
  return state % n + 1
end
local function unit() return (int(2 ^ 30) + int(2 ^ 20) / 2 ^ 20) / 2.0 ^ 30 end -- in (0, 1]
local function either() return 2 * unit() - 1 end
local function decades(format) return 10.0 ^ (either() * format.decades / 2) end

-- A random rotation's rows, to rounding: what is made with it is judged as it is.
local function frame()
  local q, n = {}, 0.0
  for i = 1, 4 do q[i] = either() end
  for i = 1, 4 do n = n + q[i] * q[i] end
  local w, x, y, z = q[1], q[2], q[3], q[4]
  local s = 2 / n
  return { { 1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y) },
    { s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x) },
    { s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y) } }
end

local places = { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } }

local function turned(values)
  local f, I = frame(), {}
  for n, ij in ipairs(places) do
    I[n] = 0.0
    for k = 1, 3 do I[n] = I[n] + values[k] * f[k][ij[1]] * f[k][ij[2]] end
  end
  return I
end

-- d_i d_j B_ij with d spread over the format's decades
local function graded(B, format)
  local d, I = {}, {}
  for k = 1, 3 do d[k] = decades(format) end
  for n, ij in ipairs(places) do I[n] = d[ij[1]] * B[n] * d[ij[2]] end
  return I
end

local function small() return int(9) - 5.0 end

-- A positive definite B with unit diagonal and condition at most 36/delta: (1 - delta) of the singular matrix of ones
-- and delta of a dominant one, whose eigenvalues are at least 1 - 2*0.45 = 0.1.
local function nearly_singular(delta, format)
  local B = { 1.0, 1.0, 1.0 }
  for n = 4, 6 do B[n] = 1 - delta + delta * 0.45 * either() end
  return graded(B, format)
end

-- In this order.  The number: these are positive definite and so is their unit-diagonal form, with at most this
-- condition; moments are then good to their own last place.
local families = {
  { "generic", function() return { either(), either(), either(), either(), either(), either() } end },
  { "diagonal, graded", function(f)
      return { decades(f) ^ 2, decades(f) ^ 2, decades(f) ^ 2, 0.0, 0.0, 0.0 }
    end, 1 },
  { "dominant, graded", function(f)
      return graded({ 1.0, 1.0, 1.0, 0.45 * either(), 0.45 * either(), 0.45 * either() }, f)
    end, 20 },
  { "condition 4e3, graded", function(f) return nearly_singular(0.01, f) end, 4e3 },
  { "condition of some digits, graded", function(f)
      return nearly_singular(f.name == "float" and 1e-4 or 1e-10, f)
    end, function(f) return f.name == "float" and 4e5 or 4e11 end },
  { "block, graded", function(f) return graded({ 1.0, 1.0, 1.0, 0.0, 0.9 * either(), 0.0 }, f) end, 20 },
  { "two nearly equal", function(f) return turned { 1.0, 1 + 2.0 ^ -int(f.p + 2), 2.0 } end },
  { "all nearly equal", function(f)
      local e = 2.0 ^ -int(f.p + 2)
      return turned { 1.0, 1 + e, 1 - e * either() }
    end },
  { "one and roundings", function(f)
      local e, I = 2.0 ^ (1 - f.p), { 1.0, 1.0, 1.0, 0.0, 0.0, 0.0 }
      for n = 1, 6 do I[n] = I[n] + e / 4 * (int(17) - 9) end
      return I
    end },
  { "twice the same, exactly", function()
      local a, b, k = small(), small(), { small(), small(), small() }
      local I = {}
      for n, ij in ipairs(places) do I[n] = (n < 4 and a or 0.0) + b * k[ij[1]] * k[ij[2]] end
      return I
    end },
  { "point mass", function()
      local x, y, z = small(), small(), small()
      return { y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z }
    end },
  { "rank one, graded", function(f) return graded({ 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 }, f) end },
  { "rank two", function()
      local u, v, I = { small(), small(), small() }, { small(), small(), small() }, {}
      for n, ij in ipairs(places) do I[n] = u[ij[1]] * u[ij[2]] + v[ij[1]] * v[ij[2]] end
      return I
    end },
  { "no diagonal", function() return { 0.0, 0.0, 0.0, small(), small(), small() } end },
  { "needle", function() return turned { 1e-16 * unit(), 1.0, 1 + unit() } end },
  { "negative definite", function() return turned { -unit(), -2.0, -2 - unit() } end },
  { "graded, of any sign, entries missing", function(f)
      local I = {}
      for n = 1, 6 do I[n] = int(3) == 1 and 0.0 or either() * decades(f) ^ 2 end
      return I
    end },
  { "subnormal", function(f)
      local I = {}
      for n = 1, 6 do I[n] = (small() + small()) * 2.0 ^ f.lowest end
      return I
    end },
  { "nearly too large", function(f)
      local I = {}
      for n = 1, 6 do I[n] = either() * 2.0 ^ (f.highest - 3) end
      return I
    end },
  { "small whole numbers", function()
      return { small(), small(), small(), small(), small(), small() }
    end },
}

-- Iterates over `each` tensors of every family: name, six numbers of the format, condition (or false).
function axes.families(format, each)
  state = 20240229
  return coroutine.wrap(function()
    for _, f in ipairs(families) do
      for _ = 1, each do
        local I = f[2](format)
        for n = 1, 6 do
          if format.name == "float" then I[n] = R.tofloat(R.fromdouble(I[n])) end
        end
        coroutine.yield(f[1], I, type(f[3]) == "function" and f[3](format) or f[3] or false)
      end
    end
  end)
end

-- The rows of tests/reference/eigen.h: iterates over id, category, six doubles, three exact moments, simple axes
-- ({[k] = three exact components}).
function axes.reference(text)
  local row = '{"([^"]+)", "([^"]*)", {([^}]*)},%s*{([^}]*)},%s*{([^}]*)}, {(.-)}},?\n'
  local function each(list, fn)
    local out = {}
    for word in string.gmatch(list, "[%d%.eE+%-]+") do out[#out + 1] = fn(word) end
    return out
  end
  return coroutine.wrap(function()
    for id, category, tensor, moments, simple, vectors in string.gmatch(text, row) do
      local list, k = {}, 0
      for v in string.gmatch(vectors .. "}", "{(.-)}") do
        k = k + 1
        if each(simple, tonumber)[k] == 1 then list[k] = each(v, R.parse) end
      end
      coroutine.yield(id, category, each(tensor, tonumber), each(moments, R.parse), list)
    end
  end)
end

return axes
