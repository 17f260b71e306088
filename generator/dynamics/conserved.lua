-- conserved.lua -- what the motion of a scene conserves: the laws of the free body that every effect keeps.
--
--     T+V   NAME_energy: kinetic energy, the effects' potentials, and those of a frame that turns steadily
--     |L|   length of the angular momentum           L     the angular momentum, in inertial (the frame's) axes
--     T+V-n.L   NAME_jacobi_integral, T + V - n L_z: where fields turn about inertial z at one rate n, T+V and L_z
--           change together.  V of such fields depends on time, so it does.  (Landau, Lifshitz, Mechanics, section 39)
--     L_z   its component along inertial z           w3    the rate about the axis z of a body symmetric about it
-- An effect that keeps L keeps |L| and L_z too; a scene without attitude has no L in inertial axes, one without rates
-- no angular momentum.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local context = require "generator.dynamics.context"
local derivative = require "generator.dynamics.derivative"
local expr = require "generator.algebra.expr"
local laws = require "generator.dynamics.laws"
local ratio = require "generator.algebra.ratio"

local conserved = {}

conserved.laws = { "T+V", "|L|", "L", "L_z", "w3", "T+V-n.L" }

-- Is the body symmetric about z?
local function about_z(s)
  if s.kind == "sphere" then return true end
  return s.kind == "symmetric" and s.k[1] == expr.zero and s.k[2] == expr.zero
end

-- The effect's own list as a set.
local function kept(m, e)
  local set, list = {}, e.spec.conserves
  if e.spec.decided then list = laws.of(m, e) end
  if type(list) == "function" then list = list(e.a, context.with(context.dry(m), e)) end
  for _, law in ipairs(list or {}) do set[law] = true end
  if set.L then set["|L|"], set.L_z = true, true end
  return set
end

-- What an effect's module says, in words: for lists of effects.
function conserved.words(spec)
  if type(spec.conserves) == "function" or spec.decided then return spec.keeps end
  return #(spec.conserves or {}) > 0 and table.concat(spec.conserves, ", ") or "nothing"
end

-- The rate at which the scene's fields turn, or nil where none turns or two turn differently.  In a base frame that
-- turns they would turn about its z, while the frame's own integral is about its axis.
local function turning(m)
  local rate
  if m.frame or not m.has.attitude then return nil end
  for _, e in ipairs(m.record.effects) do
    local field = e.spec.turning and e.spec.turning(e.a, context.with(context.dry(m), e))
    local own = field and ratio.tidy(field.rate)
    if own and rate and own ~= rate then return nil end
    rate = rate or own
  end
  return rate
end

-- The laws of the scene: a list in the order of conserved.laws; `is`, the same by name; `words` of an effect; `rate`,
-- n of the turning fields where their law holds.  eq: its equations, along which a law that all effects keep must not
-- change.
function conserved.of(eq)
  local m = eq.model
  local has, rate = m.has, turning(m)
  local holds = { ["T+V"] = true, ["|L|"] = has.rates, L = has.attitude, L_z = has.attitude,
    w3 = has.rates and about_z(m.structure), ["T+V-n.L"] = rate ~= nil }
  for _, e in ipairs(m.record.effects) do
    local set = kept(m, e)
    local c = context.with(context.dry(m), e)
    local turns = e.spec.turning and e.spec.turning(e.a, c) ~= nil
    set["T+V-n.L"] = turns or set["T+V"] and set.L_z
    for _, law in ipairs(conserved.laws) do holds[law] = holds[law] and set[law] or false end
  end
  local together = #m.record.effects > 0 and derivative.of(eq, rate)
  for _, law in ipairs(conserved.laws) do holds[law] = holds[law] and (not together or together(law)) end
  local list = { is = holds, words = conserved.words, rate = holds["T+V-n.L"] and rate or nil }
  for _, law in ipairs(conserved.laws) do
    if holds[law] then list[#list + 1] = law end
  end
  return list
end

return conserved
