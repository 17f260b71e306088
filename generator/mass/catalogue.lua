-- catalogue.lua -- the shapes: their arguments, and their mass distribution per unit mass.
--
-- One entry a shape, in the natural frame of vocabulary (mass/shapes/): `args` is the contract the scene language
-- checks, `requires` further conditions ({expression, rule, may be zero}: expressions that must be positive),
-- `polygons` asks for the checks of polygons, `build(a)` returns
--     measure   volume, area or length, by which a density is multiplied
--     com       centroid; the origin when absent
--     sigma     second moments about the centroid PER UNIT MASS, {xx, yy, zz, xy, xz, yz} of  mean(r r^T)
--     points    named points
-- `pieces(a)`, of a shape that is a sum of simpler ones, returns these: {measure, com, sigma} each.  `curved` says that
-- it does not stay uniform under a general affine map.  The tensor of inertia is never written down here: it is
-- tr(sigma) 1 - sigma times the mass (body.lua), so a formula of the handbooks can be checked against it.
-- SPDX-License-Identifier: GPL-3.0-or-later

local kit = require "generator.mass.shapes.kit"

local families = { require "generator.mass.shapes.solids", require "generator.mass.shapes.round",
  require "generator.mass.shapes.polyhedra", require "generator.mass.shapes.shells",
  require "generator.mass.shapes.plates", require "generator.mass.shapes.wires" }

local inertia = { name = "xx", dim = "inertia", sign = "nonnegative" }
local product = { name = "xy", dim = "inertia", default = 0 }

local function entry(spec, name)
  return { name = name, dim = spec.dim, sign = spec.sign, default = spec.default }
end

-- What is no integral over a fixed figure; the scene language has a reader of its own for each.
local others = {
  require "generator.mass.shapes.region",
  { name = "mesh", reader = "mesh", measure = "volume, area or length", frame = "as in the file",
    about = "STL, OBJ or PLY file in the scene's folder or below; kind = \"volume\", \"surface\" or \"wires\"",
    takes = "{file, units, kind, weld}", build = function(a) return a end },
  { name = "inertial", reader = "inertial", frame = "the link's",
    about = "mass, centre and tensor of a link in a URDF, MJCF or SDF file", takes = "{file, link}" },
  { name = "points", reader = "points", frame = "as given", about = "particles {{m, x, y, z}, ...}",
    takes = "{{m, x, y, z}, ...}" },
  { name = "tensor", frame = "as given",
    about = "mass, com, tensor entries xx .. yz about the centre of mass or the origin; any positive one with " ..
      "physical = false",
    args = {
      { name = "mass", dim = "mass", sign = "positive" }, kit.vector("com", { 0, 0, 0 }),
      entry(inertia, "xx"), entry(inertia, "yy"), entry(inertia, "zz"),
      entry(product, "xy"), entry(product, "xz"), entry(product, "yz"),
      { name = "about", choice = { "com", "origin" }, default = "com" },
      { name = "physical", flag = true, default = true },
    } },
}
families[#families + 1] = others

local catalogue = { list = {}, by_name = {} }
for _, family in ipairs(families) do
  for _, s in ipairs(family) do
    catalogue.list[#catalogue.list + 1] = s
    catalogue.by_name[s.name] = s
  end
end

return catalogue
