-- choice.lua -- functions whose values come from comparing: |x|, signs, the smaller and the larger of two, limits.
--
-- Exact for every kind of number, and where nearly all functions are smooth these have corners or jumps
-- (dynamics/switching.lua).  `sign` is the scenes' own, 0 at 0.  `side` is the side of 0 that x is on, 1 at 0: what
-- |x| has for a derivative is then that from the right.  ABOVE the line; ir/special has those of IEEE numbers in C.
-- SPDX-License-Identifier: GPL-3.0-or-later

local choice = {}

-- fn -> value of (one, arguments), `one` the 1 of the arguments' kind
local values = {
  abs = function(one, x) return x < one - one and -x or x end,
  side = function(one, x) return x < one - one and -one or one end,
  sign = function(one, x) return x < one - one and -one or x > one - one and one or one - one end,
  min = function(_, x, y) return y < x and y or x end,
  max = function(_, x, y) return x < y and y or x end,
  clamp = function(one, x, low, high) -- NaN counts as 0
    local number = x == x and x or one - one
    return number < low and low or number > high and high or number
  end,
}
choice.values = values

-- fn(arguments), or nil if fn is another function.
function choice.of(fn, one, ...)
  local value = values[fn]
  return value and value(one, ...)
end

return choice
