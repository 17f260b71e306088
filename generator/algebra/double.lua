-- double.lua -- doubles as text.
-- SPDX-License-Identifier: GPL-3.0-or-later

local double = {}

-- A finite x in the fewest digits, at least `least` of them, that read back to it.
function double.shortest(x, least)
  for digits = least, 17 do
    local s = string.format("%." .. digits .. "g", x)
    if tonumber(s) == x then return s end
  end
end

return double
