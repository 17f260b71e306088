-- samples.lua -- random numbers that repeat, and errors that a NaN cannot hide in: for the checks of emitted code.
-- SPDX-License-Identifier: GPL-3.0-or-later

local samples = {}

-- xorshift64*: the same sequence on every machine (Marsaglia 2003, Vigna 2016)
function samples.generator(seed)
  local s = seed
  return function() -- uniform in (-1, 1)
    s = s ~ (s >> 12)
    s = s ~ (s << 25)
    s = s ~ (s >> 27)
    return ((s * 2685821657736338717) >> 11) * 2.0 ^ -52 - 1
  end
end

-- The larger of two; a NaN counts as infinite, so that it cannot pass a test (math.max would drop it).
local function worse(a, b)
  if b ~= b then return math.huge end
  return b > a and b or a
end

function samples.largest(v)
  local m = 0.0
  for i = 1, #v do m = worse(m, math.abs(v[i])) end
  return m
end

-- A double that the scene's real type holds exactly.
function samples.narrow(x, real)
  if real == "float" then return string.unpack("f", string.pack("f", x)) end
  return x
end

samples.worse = worse

return samples
