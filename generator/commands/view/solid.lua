-- solid.lua -- the shape that a page draws: the body's own, or of a body without one the surface that touches a plane.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local numeric = require "generator.dynamics.numeric"
local shape = require "generator.page.shape"

local solid = {}

-- A contact surface as a tree of shapes; nil of one that is none of them.  p: the plane as numeric.scene has it.
local function contact_surface(p)
  local h = p.half_axes
  local node = { shape = "solid.ellipsoid", a = h[1], b = h[2], c = h[3] }
  if p.surface ~= 0 then
    return nil
  elseif h[1] == 0 then
    node = { shape = "solid.sphere", r = p.rim }
  elseif h[3] == 0 then
    node = { shape = "solid.cylinder", r = h[1] + p.rim, h = 2 * p.rim }
  end
  return { op = "at", r = p.centre, of = { op = "turned", q = p.axes, of = node } }
end

local function body(whole) return whole.body end

local function touching(whole)
  for _, e in ipairs(whole.effects) do
    if e.kind == "plane" then return contact_surface(e) end
  end
  return nil
end

-- The tree that `part` takes of the scene, with each parameter moved by a thousandth of itself, times a count of steps.
local function tree_of(scene, part)
  return function(steps)
    local values = {}
    for i, p in ipairs(scene.model.params) do
      local size = R.sign(p.default) == 0 and R.one or p.default
      values[p.name] = p.default + size * R.parse "0.001" * R.fromdouble((steps[i] or 0) + 0.0)
    end
    return part(numeric.scene(scene, values))
  end
end

-- What generator/page/shape.lua makes of it.
function solid.of(scene)
  local sizes = {}
  for i, p in ipairs(scene.model.params) do
    local x = R.todouble(p.default) + 0.0
    sizes[i] = { step = 1e-3 * (x == 0 and 1 or x) }
  end
  local made = shape.of(tree_of(scene, body), sizes)
  local empty = #made.faces.at + #made.holes.at + #made.lines.at + #made.points.at == 0
  if empty and touching(numeric.scene(scene)) then return shape.of(tree_of(scene, touching), sizes) end
  return made
end

return solid
