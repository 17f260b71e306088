-- levels.lua -- the curves c1 u1^2 + c2 u2^2 + c3 u3^2 = level on the unit sphere, c in ascending or descending order.
--
-- With c = the moments these are polhodes on the energy ellipsoid (u_i = sqrt(I_i/2T) w_i, level = L^2/2T); with c =
-- their reciprocals, lines of equal energy on the sphere of momentum (u = L/|L|, level = 2T/L^2).  Both are the same
-- curves: a pair around the first axis or around the third, or the separatrix, two great circles through the second.
-- SPDX-License-Identifier: GPL-3.0-or-later

local levels = {}

local steps = 96

-- A closed curve around axis k (1 or 3) on the side `sign`, u_i^2/p + u_j^2/q = 1 seen along it; nil where the level
-- has none there.
function levels.around(c, k, level, sign)
  local i, j = k % 3 + 1, (k + 1) % 3 + 1
  local p, q = (c[k] - level) / (c[k] - c[i]), (c[k] - level) / (c[k] - c[j])
  if not (p >= 0 and p <= 1 and q >= 0 and q <= 1) then return nil end
  local list = {}
  for n = 0, steps do
    local a, u = 2 * math.pi * n / steps, {}
    u[i], u[j] = math.sqrt(p) * math.cos(a), math.sqrt(q) * math.sin(a)
    u[k] = sign * math.sqrt(math.max(0.0, 1 - u[i] * u[i] - u[j] * u[j]))
    list[n + 1] = u
  end
  return list
end

-- The separatrix, level = c2: |c2 - c1| u1^2 = |c3 - c2| u3^2, two great circles; none where two of c are equal.
function levels.separatrix(c)
  local a, b = math.abs(c[2] - c[1]), math.abs(c[3] - c[2])
  if a == 0 or b == 0 then return {} end
  local x, z, list = math.sqrt(b / (a + b)), math.sqrt(a / (a + b)), {}
  for n, sign in ipairs { 1, -1 } do
    list[n] = {}
    for i = 0, steps do
      local phi = 2 * math.pi * i / steps
      list[n][i + 1] = { x * math.cos(phi), math.sin(phi), sign * z * math.cos(phi) }
    end
  end
  return list
end

-- The family: `count` levels around each axis that has some, evenly spaced in the longer half axis's angle.
function levels.family(c, count)
  local list = {}
  for _, k in ipairs { 1, 3 } do
    local far = c[2] -- where the curves around k end
    for n = 1, c[2] ~= c[k] and count or 0 do
      local reach = math.sin(math.pi / 2 * n / (count + 1))
      local level = c[k] + (far - c[k]) * reach * reach
      for _, sign in ipairs { 1, -1 } do list[#list + 1] = levels.around(c, k, level, sign) end
    end
  end
  return list
end

return levels
