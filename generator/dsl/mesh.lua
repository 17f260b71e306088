-- mesh.lua -- mesh{file = "part.stl", units = "mm", kind = "volume", weld = 1e-6, density = ...}: a body from a mesh.
--
-- The host reads the file and integrates; its doubles become exact numbers here, so the mesh bakes to constants while
-- mass or density may stay a parameter.  Defects that leave the integrals defined are warnings with their counts.  The
-- node keeps the host's faces, for what is asked of points: holes and overlaps.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local args = require "generator.dsl.args"
local defects = require "generator.dsl.defects"
local files = require "generator.dsl.files"
local shapes = require "generator.dsl.shapes"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"
local diag = require "generator.diag"

local mesh = {}

local what = "mesh"
local specs = { { name = "file" }, { name = "units", default = "m" },
  { name = "kind", choice = { "volume", "surface", "wires" }, default = "volume" }, { name = "weld", default = 0 } }
local measures = { volume = { "volume", 3 }, surface = { "area", 2 }, wires = { "length", 1 } }

-- The exact factor of a unit of length, or nil after an error.
local function unit(ctx, line, given)
  local factor, dim
  if type(given) == "string" then factor, dim = units.parse(given) end
  if factor and units.equal(dim, units.length) then return factor end
  local meant = not factor and dim and string.match(dim, "%(write.*%)")
  ctx.diag:error(ctx.diag:locate(line, "units"), what, "units must be a unit of length such as \"mm\"",
    diag.show(given) .. (meant and " " .. meant or ""))
  return nil
end

-- The tolerance within which vertices are one, in parts of the longest side, or nil after an error.
local function tolerance(ctx, line, given)
  if given == nil then return 0 end
  local w = type(given) == "number" and given + 0.0
  if w and w >= 0 and w <= 0.01 then return w end
  ctx.diag:error(ctx.diag:locate(line, "weld"), what,
    "weld must be a number from 0 to 0.01, a part of the longest side such as 1e-6", value.show(given))
  return nil
end

-- What the host found, as expressions in metres: {measure, com, sigma}.  A double stands for the shortest decimal that
-- reads back to it, which is as near to the truth and can be read.
local function exact(m, k, power)
  local function scaled(x, n) return expr.num(x) * k ^ n end
  local com, sigma = {}, {}
  for i = 1, 3 do
    local x, tail = m.com[i], m.com_tail[i]
    com[i] = scaled(tail == 0 and R.decimal(x) or R.fromdouble(x) + R.fromdouble(tail), 1)
  end
  for i = 1, 6 do sigma[i] = scaled(R.decimal(m.sigma[i]), 2) end
  return { measure = scaled(R.decimal(m.measure), power), com = com, sigma = sigma }
end

-- The constructor.  ctx: {diag =, host =}.
function mesh.constructor(ctx)
  return function(given)
    local line = ctx.diag:here()
    if not args.plain(given) then
      ctx.diag:error(line, what, "takes a table of named arguments (file, units, kind, mass, density)",
        diag.show(given))
      return shapes.broken()
    end
    args.unknown(ctx, line, what, specs, given, { "mass", "density" })
    local kind = args.choice(ctx, ctx.diag:locate(line, "kind"), what, "kind", specs[3], given.kind or "volume")
    local k = unit(ctx, line, given.units or "m")
    local path = files.resolve(ctx, ctx.diag:locate(line, "file"), what, given.file)
    local weld = tolerance(ctx, line, given.weld)
    if not (kind and k and path and weld) then return shapes.broken() end
    local measure, power = table.unpack(measures[kind])
    local node = { shape = what, line = line, measure = measure, curved = kind ~= "volume" }
    node.broken = not shapes.amount({ measure = measure }, what, line, given, node)
    node.bare = { length = given.units == nil, mass = args.bare(given.mass), density = args.bare(given.density) }
    local m, why, failed = ctx.host.mesh(path, kind, { unit = 1, density = 1, weld = weld, shape = true })
    if not m then
      local offer = failed.reason == "mesh" and
        defects.offer(failed, function(w) return "mesh { ..., weld = " .. w .. " }" end)
      if offer then why = why .. "; " .. offer end
      ctx.diag:error(ctx.diag:locate(line, "file"), what, (failed.reason == "file" and "cannot read " or "") .. why)
      return shapes.broken()
    end
    for _, phrase in ipairs(defects.phrases(m)) do
      ctx.diag:warn(ctx.diag:locate(line, "file"), what, given.file .. ": " .. phrase)
    end
    node.a = exact(m, k, power)
    node.faces, node.unit, node.longest = m.shape, k, 0
    for i = 1, 3 do node.longest = math.max(node.longest, m.box.hi[i] - m.box.lo[i]) end -- in the file's unit
    return shapes.new(node)
  end
end

return mesh
