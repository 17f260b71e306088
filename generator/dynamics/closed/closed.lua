-- closed.lua -- which closed form of the motion a scene has, and why each of the others is refused.
--
-- Decided from the effects and the structure of the tensor, never from numbers.  One file a form, tried in this order;
-- each gives {name, detect}:
--     detect(m, eq) -> form | nil, reason, near, reduced
--                                      near: only a detail is missing, so the reason is the one to tell
--                                      reduced: {theorem, text} of a motion that quadratures give, but not of the time
--     form = { kind, theorem, text = {lines},        what is proved, for explain and the header
--              free,                                 the free motion that this one is in another time, if so
--              flags = {name = bool},                what the templates ask of it
--              constants = function(m),              -> {NAME = derived constant (m:constant)}, named there ${NAME};
--                                                    called when the functions of the scene have made theirs
--              full,                                 NAME_at gives the whole state
--              centre,                               NAME_at_centre gives the centre of mass and the spin in inertial
--                                                    axes; of neither, NAME_at_rates gives the rates alone
--              ticks,                                it counts time in ticks
--              exact,                                it needs templates/numeric/exact.c
--              pairs }                               of templates/numeric/pair.c it needs all (nil), no product
--                                                    of pairs ("sums"), nor their sum ("few")
-- ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local closed = { require "generator.dynamics.closed.sphere", require "generator.dynamics.closed.symmetric",
  require "generator.dynamics.closed.asymmetric", require "generator.dynamics.closed.rotor",
  require "generator.dynamics.closed.damped", require "generator.dynamics.closed.axial",
  require "generator.dynamics.closed.lagrange", require "generator.dynamics.closed.gyrostat",
  require "generator.dynamics.closed.ball", require "generator.dynamics.closed.disc",
  require "generator.dynamics.closed.point",
  (require "generator.dynamics.closed.flight") } -- one value: require also returns where it found it

-- The form that applies, with `others`, the list {name, reason} of those refused, and `part`, what one that is not full
-- gives, as the end of a sentence; without one {refused = text, others, reduced}.
function closed.detect(m, eq)
  local found, told, others, reduced = nil, nil, {}, nil
  for _, form in ipairs(closed) do
    local made, reason, near, less = form.detect(m, eq)
    reduced = reduced or less
    if made and not found then
      found = made
    else
      others[#others + 1] = { name = form.name, reason = made and "not needed: " .. found.theorem or reason }
      if near or not told then told = reason end
    end
  end
  if found and eq.inputs then found, told = nil, "the inputs are decided while it moves" end
  found = found or { refused = told, reduced = reduced }
  found.others = others
  if not found.full then
    found.part = found.centre and "gives the centre of mass and the spin only" or "gives the rates only"
  end
  return found
end

return closed
