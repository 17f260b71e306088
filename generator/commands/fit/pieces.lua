-- pieces.lua -- `fit --segments N`: multiple shooting, and then the whole log once more.
--
--     pieces.wrong(given, free, data, states) -> what is wrong with --segments, or nil
--     pieces.data(data, n)  -> the logs as the pieces are told: paths "log.csv, piece 2 of 8"
--     pieces.ask(ask, n)    -> the problem for host.fit with every log in n pieces
--     pieces.whole(ask, result, n) -> the problem of the whole logs, from where the pieces ended
-- SPDX-License-Identifier: GPL-3.0-or-later

local diag = require "generator.diag"

local pieces = {}

local MOST = 192 -- unknowns: FIT_MOST of src/cli/fit/fit.h

function pieces.wrong(given, free, data, states)
  local n = given.segments
  if not n then return nil end
  if n % 1 ~= 0 or n < 2 then return "--segments must be a whole number from 2 on, got " .. diag.show(n) end
  if not free.initial then
    return "--segments: --free must have initial, as each piece begins with a state of its own"
  end
  local own = states - #free.params
  local all = math.tointeger(#free.params + n * own)
  if all > MOST then
    return "--segments " .. diag.show(n) .. ": " .. diag.show(all) .. " unknowns, and at most " .. MOST ..
      " are possible: at most " .. diag.show((MOST - #free.params) // own) .. " segments"
  end
  for _, d in ipairs(data) do
    if d.rows < 4 * n then return "--segments " .. diag.show(n) .. ": " .. d.path .. " has only " ..
      diag.show(d.rows) .. " rows" end
  end
  return nil
end

function pieces.data(data, n)
  local list = {}
  for _, d in ipairs(data) do
    for k = 1, n do
      list[#list + 1] = setmetatable({ path = d.path .. ", piece " .. k .. " of " .. n,
        unused = k == 1 and d.unused or {} }, { __index = d })
    end
  end
  return list
end

-- Each entry n times.
local function repeated(list, n)
  if not list then return nil end
  local out = {}
  for _, x in ipairs(list) do
    for _ = 1, n do out[#out + 1] = x end
  end
  return out
end

function pieces.ask(ask, n)
  return setmetatable({ logs = repeated(ask.logs, n), channels = repeated(ask.channels, n),
    inputs = repeated(ask.inputs, n), linear = false, pieces = n + 0.0,
    starts = 0.0 }, { __index = ask })
end

function pieces.whole(ask, result, n)
  local free, logs = #ask.free, #ask.logs
  local own = (#result.theta - free) // (logs * n)
  local theta, reference = table.move(result.theta, 1, free, 1, {}), {}
  for log = 0, logs - 1 do
    table.move(result.theta, free + log * n * own + 1, free + log * n * own + own, #theta + 1, theta)
    table.move(result.reference, 4 * log * n + 1, 4 * log * n + 4, #reference + 1, reference)
  end
  return setmetatable({ theta = theta, reference = reference, near = true, starts = 0.0 }, { __index = ask })
end

return pieces
