-- tops.lua - bodies and states that are hard for the free top, the same in every run.
-- SPDX-License-Identifier: GPL-3.0-or-later

local random = require "tests.ir.random"

local tops = { kinds = 12, seed = random.seed }

local function below(n) return random.int(n) - 1 end
local function uniform() return (below(1 << 30) + 0.5) / (1 << 30) end
local function signed() return 2 * uniform() - 1 end

-- Tensor, rates, attitude and time, 14 doubles.  Every kind of degeneracy, to the last bit and nearly.
function tops.draw(kind)
  local a, b = 1.0, 1.0 + uniform()
  if kind == 0 then b = 1.0 + 2.0 ^ -52 * below(4) end
  if kind == 1 then a = 10.0 ^ (-12 * uniform()) end
  local c = kind == 2 and b or kind == 3 and a + b or b + uniform() * a
  if kind == 4 then b, c = a, a end
  local I, turn = { a, b, c, 0.0, 0.0, 0.0 }, below(3)
  local w = { signed(), signed(), signed() }
  if kind == 5 then w[3] = w[1] * math.sqrt(a * (b - a) / (c * (c - b))) * (1 + 2.0 ^ -52 * (below(5) - 2)) end
  if kind == 6 then w[1 + below(3)] = 0.0 end
  if kind == 7 then w[1 + below(3)], w[1 + below(3)] = 1e-100 * signed(), 1e-13 * signed() end
  if kind == 8 then a = 2.0 ^ -40; I[1] = a end
  I[1], I[2], I[3] = I[1 + turn], I[1 + (turn + 1) % 3], I[1 + (turn + 2) % 3]
  w[1], w[2], w[3] = w[1 + turn], w[1 + (turn + 1) % 3], w[1 + (turn + 2) % 3]
  if kind == 9 or kind == 10 then
    local size = kind == 9 and 0.1 or 1e-9
    for i = 4, 6 do I[i] = size * signed() end
  end
  if kind == 11 then I, w = { 2.0, 2.0, 3.0, 1.0, 0.0, 0.0 }, { signed(), signed(), signed() } end -- 1, 3, 3: I2 = I3
  local t = signed() * 10.0 ^ (6 * uniform())
  return { I[1], I[2], I[3], I[4], I[5], I[6], w[1], w[2], w[3], signed(), signed(), signed(), signed(), t }
end

return tops
