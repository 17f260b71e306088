-- region.lua -- a volume between polynomial limits, with a polynomial density.
--
-- The integrals of 1, x_i and x_i x_j times the density, one coordinate after the other from the innermost, are exact:
-- all integrands stay polynomials in what is left.  Frame: as given.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local coordinate = require "generator.algebra.coordinate"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"

-- a: {order = {outermost, .., innermost coordinate}, limits = {{lo, hi}, ...} in that order, density = polynomial}
-- integral(i, j): of x_i x_j times the density; of x_i or 1 with fewer arguments.
local function build(a)
  local function integral(i, j)
    local e = { 0, 0, 0 }
    for _, k in ipairs { i, j } do e[k] = e[k] + 1 end
    local p = coordinate.mul(a.density, coordinate.monomial(e[1], e[2], e[3]))
    for n = 3, 1, -1 do p = coordinate.integrate(p, a.order[n], a.limits[n][1], a.limits[n][2]) end
    return ratio.tidy(p[1] and p[1].c or expr.zero)
  end
  local mass = integral()
  if mass == expr.zero then return { measure = mass, sigma = vec.map(vec.pair, function() return mass end) } end
  local com = {}
  for i = 1, 3 do com[i] = ratio.tidy(integral(i) / mass) end
  local sigma = vec.map(vec.pair, function(p)
    return ratio.tidy(integral(p[1], p[2]) / mass - com[p[1]] * com[p[2]])
  end)
  return { measure = mass, com = com, sigma = sigma, points = { origin = { expr.zero, expr.zero, expr.zero } } }
end

return { name = "region", reader = "region", measure = "volume", frame = "as given", build = build,
  about = "iterated limits, polynomial in the outer coordinates; density = polynomial in x, y, z, or mass",
  takes = "{{x, lo, hi}, {y, lo, hi}, {z, lo, hi}, density =}" }
