-- solid.lua -- the shape that a page draws: the body's own, or of a body without one the surface that touches a plane.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local numeric = require "generator.dynamics.numeric"
local shape = require "generator.page.shape"
local facts = require "generator.report.facts"

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

-- The corners by kind, as lists of numbers.  A body without a shape is the ellipsoid of the same moments.
function solid.corners(scene)
  local made, f, out = solid.of(scene), facts.of(scene), {}
  for _, kind in ipairs { "faces", "holes", "lines", "points" } do out[kind] = made[kind].at end
  if #out.faces + #out.holes + #out.lines + #out.points > 0 then return out end
  local I, half, most = f.moments, {}, 0.0
  for k = 1, 3 do
    half[k] = math.sqrt(math.max(0.0, 2.5 * (I[1] + I[2] + I[3] - 2 * I[k]) / f.mass_number))
    most = math.max(most, half[k])
  end
  for k = 1, 3 do half[k] = math.max(half[k], 1e-3 * most) end -- of a rod or a plate, too
  local own = shape.of(function()
    return { shape = "solid.ellipsoid", a = half[1], b = half[2], c = half[3] }
  end, {}).faces.at
  for i = 1, #own, 3 do
    for d = 1, 3 do
      out.faces[i + d - 1] = own[i] * f.axes[1][d] + own[i + 1] * f.axes[2][d] + own[i + 2] * f.axes[3][d]
    end
  end
  return out
end

return solid
