-- inertial.lua -- inertial{file = "robot.urdf", link = "base"}: a shape whose mass properties another program wrote.
--
-- The shape's coordinates are the link's frame.  It is tensor{...} with the exact decimals of the file, turned as the
-- inertial frame lies in the link's, and put at the centre of mass.  It has been judged where it was read,
-- and its node says so to mass/validity.lua.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local args = require "generator.dsl.args"
local files = require "generator.dsl.files"
local shapes = require "generator.dsl.shapes"
local diag = require "generator.diag"
local document = later "generator.interchange.document"
local reader = later "generator.interchange.reader"
local read = later "generator.interchange.read"

local inertial = {}

local specs = { { name = "file" }, { name = "link" } }

-- The shape tree of what was read.
local function tree(p, line)
  local zero3 = { expr.zero, expr.zero, expr.zero }
  local I, com = vec.map(p.rod or p.tensor, expr.num), vec.map(p.com, expr.num)
  local a = { mass = expr.num(p.mass), com = #p.turns == 0 and com or zero3, about = "com" }
  for i, name in ipairs(vec.entry) do a[name] = I[i] end
  local node = { shape = "tensor", name = "inertial", a = a, mass = a.mass, line = line,
    judged = p.judged, typed = p.rod and vec.map(p.tensor, expr.num), written = p.judged.written }
  for _, t in ipairs(p.turns) do
    local q = t.q
    if not q then
      local s = expr.call("sin", t.angle / 2)
      q = { expr.call("cos", t.angle / 2), t.axis[1] * s, t.axis[2] * s, t.axis[3] * s }
    end
    node = { op = "turned", of = node, q = q, turns = t.angle and { t }, line = line }
  end
  if #p.turns > 0 then node = { op = "at", of = node, r = com, line = line } end
  return node
end

-- The constructor.  ctx: {diag =, host =}.
function inertial.constructor(ctx)
  return function(given)
    local line = ctx.diag:here()
    if not args.plain(given) then
      ctx.diag:error(line, "inertial", "takes a table of named arguments (file, link)", diag.show(given))
      return shapes.broken()
    end
    args.unknown(ctx, line, "inertial", specs, given)
    if given.link ~= nil and type(given.link) ~= "string" then
      ctx.diag:error(ctx.diag:locate(line, "link"), "inertial", "link must be a name", diag.show(given.link))
      return shapes.broken()
    end
    local text, path = files.read(ctx, ctx.diag:locate(line, "file"), "inertial", given.file)
    if not text then return shapes.broken() end
    local root, why, at = document.tree(ctx.host.xml, text)
    if not root then
      ctx.diag:error(line, "inertial", path .. (at and ":" .. at or "") .. ": " .. why)
      return shapes.broken()
    end
    local r = reader.new(path, function(rule, got) ctx.diag:error(line, "inertial", rule, got) end,
      function(warning) ctx.diag:warn(line, "inertial", warning) end)
    local p = read.inertial(r, root, given.link)
    return p and shapes.new(tree(p, line)) or shapes.broken()
  end
end

return inertial
