-- judged.lua -- what a sweep's members are judged by on their way, and how often.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"
local vec = require "generator.algebra.vec"
local contact = require "generator.dynamics.contact"
local exists = require "generator.dynamics.exists"
local flat = require "generator.dynamics.flat"

local judged = {
  flat = "a disc that lies flat: k, 2 k top, -g.g', g'.g' and the square of g x g', of what of g is across the " ..
    "axis; g' = g x w",
  parts = "a body's tensor: the principal minors of its second moments, and their trace",
}

-- Expressions beside |q| and the reaction, and which they are, judged.flat or judged.parts; nil where there are none.
-- Beside a plane no part moves.
function judged.laws(job)
  local plane = contact.of(job.model)
  local disc = plane and flat.disc(job.model, plane)
  if disc and job.model:double(disc.lever) > 0 then
    local v = flat.law(disc, vec.map({ "qw", "qx", "qy", "qz" }, motion.sym), vec.map({ "wx", "wy", "wz" },
      motion.sym), expr.sqrt)
    return { v.pull, v.rise, v.toward, v.speed, v.miss }, judged.flat
  end
  local minors = exists.minors(job.model)
  return minors, minors and judged.parts
end

-- Steps after which members are looked at: on a plane each, for a hop may be short; where t enters the equations each,
-- whose time is that of a run, to the last bit.
local PIECE = 16
function judged.piece(job)
  if job.equations.touch then return 1 end
  for _, g in ipairs(job.equations.groups) do
    for _, list in ipairs { g.defs, g.outs } do
      for _, d in ipairs(list) do
        if not expr.constant(d.expr, { t = true }) then return 1 end
      end
    end
  end
  return PIECE
end

return judged
