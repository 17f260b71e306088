-- slips.lua -- which single slip of the pen would explain a tensor that no body has?
--
-- A tensor that breaks a law of mass distributions was usually right somewhere else: a decimal point slipped, the
-- products of inertia were copied without their sign, two entries changed places, the reference point or the unit is
-- another one.  Each such slip is undone, alone, and the result is put to the same exact test; what passes is named.
-- A slip of form (sign, place, point of reference) changes no digits and is believed before a slip of digits.  Only
-- what is unlikely to be a coincidence is said: more than `most` ways of one kind explain nothing and are not listed.
-- Numbers are rationals, a tensor is {xx, yy, zz, xy, xz, yz} of tensor entries.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"
local diag = require "generator.diag"

local slips = {}

local most = 3

local names = { "xx", "yy", "zz", "xy", "xz", "yz" }
local function ten(n) return R.new(10) ^ n end
local function show(q) return diag.show(R.todouble(q)) end

-- Steiner's term of the mass m at c, which the tensor about the origin has more than the one about the centre.
function slips.steiner(m, c)
  return vec.scale(m, vec.inertia(vec.outer(c)))
end

-- I with entries replaced: {place = value}
local function with(I, changes)
  local J = { table.unpack(I) }
  for i, x in pairs(changes) do J[i] = x end
  return J
end

local function scaled(v, k)
  local w = {}
  for i = 1, #v do w[i] = v[i] * k end
  return w
end

-- ---- rounding ----

-- A lamina or a rod lies on the border of what is lawful, and digits that were cut, to five or more, push it over: then
-- Sigma + 1e-5 tr 1 is lawful, whose tensor is I + 2e-5 tr 1.
local function rounded(g)
  if g.about ~= "com" then return {} end
  local I, more = g.I, (g.I[1] + g.I[2] + g.I[3]) * R.parse "0.00002"
  if not g.lawful { I[1] + more, I[2] + more, I[3] + more, I[4], I[5], I[6] } then return {} end
  return { "the entries of a flat or thin body were rounded (more digits, or the sum itself, would satisfy it)" }
end

-- ---- slips of form: no digit is wrong ----

local swaps = { { 4, 5 }, { 4, 6 }, { 5, 6 }, { 1, 2 }, { 1, 3 }, { 2, 3 } }

-- Numbers of a matrix that were written to the wrong entries: where xx .. xz, yz are then, by place among the six.  The
-- six have two orders, by moments (here and in MJCF) and by rows (URDF's attributes); the first two rows of the matrix
-- have yx, which is xy `again`, and lack zz.
local two_rows = "the numbers are two rows of the matrix, xx xy xz and yx yy yz, and zz is missing"
local orders = {
  { text = "the numbers are the rows of the upper triangle, xx xy xz yy yz zz", 1, 4, 6, 2, 3, 5 },
  { text = "the numbers are xx yy zz xy xz yz and were written to xx xy xz yy yz zz", 1, 4, 5, 2, 6, 3 },
  { text = two_rows, again = true, 1, 6, false, 4, 5, 3 },
  { text = two_rows, again = true, 1, 5, false, 2, 3, 6 },
}

-- f for each value that zz may have beside xx and yy: it is between their difference and their sum.
local function any_zz(I, f)
  for n = 1, 8 do
    if f(with(I, { [3] = (I[1] + I[2]) * R.new(n) / R.new(8) })) then return true end
  end
  return false
end

-- valid(I, mass, com): is this what some body has?
local function form(g, valid)
  local found = {}
  local function try(I, text)
    if valid(I, g.mass, g.com) then found[#found + 1] = text end
  end
  local I = g.I
  -- about the centre of mass with a zero among them, the other sign is a mirror image and changes nothing
  try(with(I, { [4] = -I[4], [5] = -I[5], [6] = -I[6] }),
    "xy, xz, yz are products of inertia and want the other sign")
  for _, s in ipairs(swaps) do
    local a, b = s[1], s[2]
    if I[a] ~= I[b] then try(with(I, { [a] = I[b], [b] = I[a] }), names[a] .. " and " .. names[b] .. " are swapped") end
  end
  for _, o in ipairs(orders) do
    local J = {}
    for i = 1, 6 do J[i] = o[i] and I[o[i]] or R.zero end
    if not o.again then
      try(J, o.text)
    elseif #found == 0 and I[2] == I[4] and R.sign(J[2]) > 0 and
      any_zz(J, function(K) return valid(K, g.mass, g.com) end) then
      found[#found + 1] = o.text
    end
  end
  return found
end

-- ---- slips of what is given beside the entries: the point of reference, the units of com and mass ----

local lengths = { { "1/1000", "mm" }, { "1/100", "cm" }, { "0.0254", "in" } } -- no ft, lb: near one
local masses = { { "1/1000", "g" } }

-- The least mass of a body with the tensor I about the origin and the given p = mass*com; nil if there is none.
-- Sigma - p p^T/m >= 0 with Sigma > 0: m >= p.Sigma^-1 p (Schur's complement).
local function least(I, p)
  local Sigma = vec.second(I)
  local adj, det = vec.adjugate(Sigma)
  local positive = R.sign(Sigma[1]) > 0 and R.sign(adj[3]) > 0 and R.sign(det) > 0 -- the leading minors
  return positive and vec.dot(p, vec.apply(adj, p)) / det or nil
end

-- About the origin the mass and the centre's position take part; about the centre neither does.  A change that leaves
-- Steiner's term below a hundredth of the entries explains nothing: it is the tensor about the centre once more.
local function beside(g, lawful)
  local found = {}
  local function valid(I, m, c)
    local shift = slips.steiner(m, c)
    return (shift[1] + shift[2] + shift[3]) * R.new(100) > I[1] + I[2] + I[3] and lawful(I, m, c)
  end
  if g.about ~= "origin" then return found end
  if g.lawful(g.I) then found[1] = "the entries are about the centre of mass already (about = \"com\")" end
  for _, u in ipairs(lengths) do
    if valid(g.I, g.mass, scaled(g.com, R.parse(u[1]))) then
      found[#found + 1] = "com is in " .. u[2]
      break
    end
  end
  for _, u in ipairs(masses) do
    if valid(g.I, g.mass * R.parse(u[1]), g.com) then
      found[#found + 1] = "mass is in " .. u[2]
      break
    end
  end
  for n = 3, #found > 0 and 0 or 9, 3 do
    if valid(scaled(g.I, ten(n)), g.mass, g.com) then
      found[#found + 1] = "all entries are too small by 1e" .. n
      break
    end
  end
  local mass = least(g.I, scaled(g.com, g.mass))
  if mass and mass > g.mass and #found < most then
    found[#found + 1] = "mass is too small (with the same mass*com, " .. diag.rough(1.005 * R.todouble(mass)) ..
      " kg and more would satisfy it)" -- rounded to three digits upwards
  end
  return found
end

-- ---- one entry with another power of ten, or in another unit ----

-- A moment may be too large or too small; a product that is too small breaks no law.
local function digits(g, valid)
  local found = {}
  for i = 1, 6 do
    local x = g.I[i]
    for n = 1, R.sign(x) ~= 0 and 9 or 0 do -- the smallest step that helps, up or down
      local down, up = x / ten(n), x * ten(n)
      local value = valid(with(g.I, { [i] = down }), g.mass, g.com) and down
        or i <= 3 and valid(with(g.I, { [i] = up }), g.mass, g.com) and up -- a larger product never helps
      if value then
        local unit = n % 3 == 0 and " or is off by a unit's 1e" .. n or ""
        found[#found + 1] = string.format("%s has a slipped decimal point%s (%s would satisfy it)", names[i], unit,
          show(value))
        break
      end
    end
  end
  return found
end

-- Factors near one (pounds, slugs times square feet) would explain anything and are left out.  Exact by definition of
-- the inch, foot and pound (NIST SP 811, appendix B).
local foreign = { { "0.00064516", "kg in^2" }, { "0.09290304", "kg ft^2" }, { "0.0002926396534292", "lb in^2" },
  { "0.0421401100938048", "lb ft^2" } }

-- Of the moments alone.
local function units(g, valid)
  local found = {}
  for i = 1, 3 do
    for _, u in ipairs(foreign) do
      local value = g.I[i] * R.parse(u[1])
      if R.sign(value) ~= 0 and valid(with(g.I, { [i] = value }), g.mass, g.com) then
        found[#found + 1] = string.format("%s is in %s (%s would satisfy it)", names[i], u[2], show(value))
        break
      end
    end
  end
  return found
end

local kinds = { rounded, form, beside, digits, units }

-- given: {I =, mass =, com =, about = "com" | "origin", lawful = the test of a central tensor}.  Returns the
-- most likely explanation as "most likely: ...", or nil.
function slips.hint(given)
  local function valid(I, m, c)
    for i = 1, 3 do
      if R.sign(I[i]) < 0 then return false end
    end
    if given.about == "com" then return given.lawful(I) end
    local shift, J = slips.steiner(m, c), {}
    for i = 1, 6 do J[i] = I[i] - shift[i] end
    return given.lawful(J)
  end
  for _, kind in ipairs(kinds) do
    local found = kind(given, valid)
    if #found > 0 and #found <= most then return "most likely: " .. table.concat(found, ", or ") end
  end
  return nil
end

return slips
