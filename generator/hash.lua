-- hash.lua -- a fingerprint of a text.
-- SPDX-License-Identifier: GPL-3.0-or-later

local hash = {}

-- 128 bits of Fowler, Noll and Vo's hash (FNV-1a, twice 64 with different starts) as 32 hexadecimal digits.
function hash.of(text)
  local a, b = 0xcbf29ce484222325, 0x84222325cbf29ce4
  for i = 1, #text do
    local c = string.byte(text, i)
    a, b = (a ~ c) * 0x100000001b3, (b ~ c ~ 0x5a) * 0x100000001b3
  end
  return string.format("%016x%016x", a, b)
end

return hash
