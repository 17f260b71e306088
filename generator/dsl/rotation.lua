-- rotation.lua -- a rotation as a scene writes it, for attitudes and turned shapes:
--
--     { axis = "x" or {x, y, z}, angle = a }          a turn by the angle about the axis
--     { euler = "zxz", angles = {a, b, c} }           turns about the body's axes, each as it stands after those before
--     { vector = {x, y, z} }                          axis times angle, in rad
--     { matrix = {{..}, {..}, {..}} }                 columns: the body's axes in space
--     { quaternion = {w, x, y, z} }                   of any length but 0
-- All become the exact unit quaternion, body to space.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local args = require "generator.dsl.args"
local value = require "generator.dsl.value"
local diag = require "generator.diag"

local rotation = {}

local unit = { x = { 1, 0, 0 }, y = { 0, 1, 0 }, z = { 0, 0, 1 } }
local place = { x = 2, y = 3, z = 4 }

rotation.sequences = { "xyx", "xzx", "yxy", "yzy", "zxz", "zyz", "xyz", "xzy", "yxz", "yzx", "zxy", "zyx" }

-- A matrix of rounded decimals is one: R R^T may differ from 1 by some 1e-6, as the square of the norm.
local tolerance = expr.num(R.parse "1e-12")

local function nonzero(c, line, what, name, v, given)
  return args.condition(c, line, what, name .. " must not be zero", vec.dot(v, v), diag.show(given))
end

local function normalised(q)
  local n = expr.zero
  for _, x in ipairs(q) do n = n + x ^ 2 end
  return vec.map(q, function(x) return x / expr.sqrt(n) end)
end

-- Hamilton's product
local function product(p, q)
  return { p[1] * q[1] - p[2] * q[2] - p[3] * q[3] - p[4] * q[4],
    p[1] * q[2] + p[2] * q[1] + p[3] * q[4] - p[4] * q[3], p[1] * q[3] - p[2] * q[4] + p[3] * q[1] + p[4] * q[2],
    p[1] * q[4] + p[2] * q[3] - p[3] * q[2] + p[4] * q[1] }
end

-- forms[word](ctx, line, what, given) -> the unit quaternion, nil after an error.
local forms = {}

-- Of any length: it is divided by it.
function forms.quaternion(c, line, what, given)
  local q = args.vector(c, line, what, "quaternion", { size = 4 }, given.quaternion)
  if not q then return nil end
  local n = q[1] ^ 2 + q[2] ^ 2 + q[3] ^ 2 + q[4] ^ 2
  local fine = args.condition(c, line, what, "quaternion must not be zero", n, diag.show(given.quaternion))
  return fine and normalised(q) or nil
end

-- (cos a/2, n sin a/2)
function forms.axis(c, line, what, given)
  local axis = given.axis
  if type(axis) == "string" then axis = unit[axis] end
  if axis == nil or given.angle == nil then
    c.diag:error(line, what, "needs axis (\"x\", \"y\", \"z\" or a vector) and angle")
    return nil
  end
  local v = args.vector(c, line, what, "axis", { size = 3 }, axis)
  local angle = args.scalar(c, line, what, "angle", {}, given.angle)
  if not v or not angle or not nonzero(c, line, what, "axis", v, given.axis) then return nil end
  local n = expr.sqrt(vec.dot(v, v))
  local s, k = expr.call("sin", angle / 2) / n, expr.call("cos", angle / 2)
  return { k, v[1] * s, v[2] * s, v[3] * s }, { { axis = vec.map(v, function(x) return x / n end), angle = angle } }
end

-- First and last turn about one axis: half their sum and difference, so that what cancels does so exactly.  About axes
-- i, j, i (places 2, 3, 4 in the quaternion) with half angles a, b, c:
--     cos b cos(a + c);  along i  cos b sin(a + c),  along j  sin b cos(a - c),  along k  +-sin b sin(a - c)
-- with + where i, j, k are in cyclic order.
local function proper(a, i, j)
  local function half(fn, x) return expr.call(fn, x / 2) end
  local sum, difference, k = a[1] + a[3], a[1] - a[3], 9 - i - j
  local q = { half("cos", a[2]) * half("cos", sum) }
  q[i], q[j] = half("cos", a[2]) * half("sin", sum), half("sin", a[2]) * half("cos", difference)
  q[k] = half("sin", a[2]) * half("sin", difference) * ((j - i) % 3 == 1 and 1 or -1)
  return q
end

-- Turns about axes of the body as it then is multiply from the right.
function forms.euler(c, line, what, given)
  local known = false
  for _, s in ipairs(rotation.sequences) do known = known or s == given.euler end
  if not known then
    c.diag:error(line, what, "euler must be three of x, y, z, neighbours different, such as \"zxz\" or \"zyx\"",
      diag.show(given.euler))
    return nil
  end
  if not args.list(given.angles, 3) then
    c.diag:error(line, what, "angles must be a list of 3 angles", diag.show(given.angles))
    return nil
  end
  local angles, at, turns = {}, {}, {}
  for n = 1, 3 do
    angles[n] = args.scalar(c, line, what, "angle", {}, given.angles[n]) -- so called, degrees are noticed
    if not angles[n] then return nil end
    local letter = string.sub(given.euler, n, n)
    at[n] = place[letter]
    turns[n] = { axis = vec.map(unit[letter], expr.lift), angle = angles[n] }
  end
  if at[1] == at[3] then return proper(angles, at[1], at[2]), turns end
  local q
  for n = 1, 3 do
    local one = { expr.call("cos", angles[n] / 2), expr.zero, expr.zero, expr.zero }
    one[at[n]] = expr.call("sin", angles[n] / 2)
    q = q and product(q, one) or one
  end
  return q, turns
end

-- The zero vector is no turn; one that becomes zero for some parameters is refused by NAME_init.
function forms.vector(c, line, what, given)
  local v = args.vector(c, line, what, "vector", { size = 3 }, given.vector)
  if not v then return nil end
  if v[1] == expr.zero and v[2] == expr.zero and v[3] == expr.zero then
    return { expr.one, expr.zero, expr.zero, expr.zero }
  end
  if not nonzero(c, line, what, "vector", v, given.vector) then return nil end
  local n = expr.sqrt(vec.dot(v, v))
  local s = expr.call("sin", n / 2) / n
  return { expr.call("cos", n / 2), v[1] * s, v[2] * s, v[3] * s }
end

-- The four columns of 4 q q^T, of which each is q times a number; the one with the largest is taken (Shepperd 1978).
local function candidates(m)
  local one = expr.one
  local a, b, d = m[3][2] - m[2][3], m[1][3] - m[3][1], m[2][1] - m[1][2]
  local e, f, g = m[1][2] + m[2][1], m[1][3] + m[3][1], m[2][3] + m[3][2]
  return { { one + m[1][1] + m[2][2] + m[3][3], a, b, d }, { a, one + m[1][1] - m[2][2] - m[3][3], e, f },
    { b, e, one - m[1][1] + m[2][2] - m[3][3], g }, { d, f, g, one - m[1][1] - m[2][2] + m[3][3] } }
end

-- Which candidate is the largest is decided at the parameters' defaults and must stay positive for all others.
function forms.matrix(c, line, what, given)
  if not args.list(given.matrix, 3) then
    c.diag:error(line, what, "matrix must be a list of 3 rows of 3 numbers", diag.show(given.matrix))
    return nil
  end
  local m = {}
  for i = 1, 3 do
    m[i] = args.vector(c, line, what, "matrix[" .. i .. "]", { size = 3 }, given.matrix[i])
    if not m[i] then return nil end
  end
  local off = expr.zero
  for i = 1, 3 do
    for j = 1, 3 do off = off + (vec.dot(m[i], m[j]) - (i == j and expr.one or expr.zero)) ^ 2 end
  end
  local det = vec.dot(m[1], vec.cross(m[2], m[3]))
  local fine = args.condition(c, line, what, "matrix must have rows of length 1 at right angles (to 1e-6)",
    tolerance - off, "an error of " .. diag.show(math.sqrt(R.todouble(value.number(off) or R.new(0))))) and
    args.condition(c, line, what, "matrix must be a rotation, not a reflection", det, "a determinant below 0")
  if not fine then return nil end
  local best, size
  for i, q in ipairs(candidates(m)) do
    local x = value.number(q[i])
    if x and (not size or R.todouble(x) > size) then best, size = i, R.todouble(x) end
  end
  local q = candidates(m)[best]
  fine = args.condition(c, line, what, "matrix must stay within half a turn of what it is for the defaults", q[best],
    diag.show(size))
  return fine and normalised(q) or nil
end

local order = { "quaternion", "axis", "euler", "vector", "matrix" }
local companions = { axis = "angle", euler = "angles" }

-- A rotation as a unit quaternion, of angles also the list of turns {axis, angle} that it is the product of, from the
-- left; nil after an error.
function rotation.read(c, line, what, given)
  local all = "{axis =, angle =}, {euler =, angles =}, {vector =}, {matrix =} or {quaternion =}"
  if not args.plain(given) then
    c.diag:error(line, what, "takes " .. all, diag.show(given))
    return nil
  end
  local specs, chosen = {}, {}
  for _, name in ipairs(order) do
    local more = companions[name]
    specs[#specs + 1] = { name = name }
    if more then specs[#specs + 1] = { name = more } end
    if given[name] ~= nil or more and given[more] ~= nil then chosen[#chosen + 1] = name end
  end
  args.unknown(c, line, what, specs, given)
  if #chosen ~= 1 then
    c.diag:error(line, what, #chosen == 0 and "needs " .. all or "takes one form of a rotation, not both " ..
      chosen[1] .. " and " .. chosen[2])
    return nil
  end
  return forms[chosen[1]](c, line, what, given)
end

return rotation
