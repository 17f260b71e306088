-- handbook.lua - measure, centroid and moments of every shape as handbooks print them: the tables of tests/handbook.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A row is {shape, args = the arguments as a scene writes them, params = the names in them, at = sizes for a picture,
-- of = function(e, f)}, e the sizes by name and f the functions pi, abs, sqrt, sin, cos, sinh, cosh of the same kind of
-- number: doubles (tests/geometry) or expressions with exact rationals (tests/mass).  So no literal in a row is a
-- fraction: 2 x/5, not 0.4 x.  of returns
--   measure  volume, area or length     com  centroid (default the origin)      points  named points
--   I  tensor about the centroid per unit mass, xx yy zz xy xz yz with tensor entries off the diagonal; or
--   S  means of x_i x_j about the frame's origin
-- Names beginning with phi and k are pure numbers, other sizes lengths (tests/scene.lua).

local handbook = { rows = {} }

for _, name in ipairs { "solids", "flat", "thin" } do
  for _, row in ipairs(require("tests.handbook." .. name)) do handbook.rows[#handbook.rows + 1] = row end
end

local PAIRS = { { 1, 1 }, { 2, 2 }, { 3, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } }

-- The row's values, with com, I and points filled in.
function handbook.values(row, e, f)
  local v = row.of(e, f)
  v.com = v.com or { 0, 0, 0 }
  v.points = v.points or {}
  if not v.I then -- sigma = S - c c^T, I = tr(sigma) 1 - sigma
    local s, c = {}, v.com
    for n, ij in ipairs(PAIRS) do s[n] = v.S[n] - c[ij[1]] * c[ij[2]] end
    v.I = { s[2] + s[3], s[1] + s[3], s[1] + s[2], -s[4], -s[5], -s[6] }
  end
  return v
end

return handbook
