#!/usr/bin/env lua5.4
-- free_top.t -- the oracle of many digits against the 32 digits of the reference set, all samples.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"

-- The program is built by `make tests`; POLHODE_ORACLE names another.
local program = os.getenv "POLHODE_ORACLE" or "build/oracle/free_top"

-- Rows of a header as lines: tensor, w0, q0, t, and the rates and attitude with all their digits.
local function rows(name)
  local file = assert(io.open(name))
  local text = file:read "a"
  file:close()
  local lines, ids = {}, {}
  local pattern = '{"([%w%p]-)", {(.-)}, {(.-)}, {(.-)}, (%S+),%s*{(.-)},%s*{(.-)},'
  for id, tensor, w0, q0, t, w, q in text:gmatch(pattern) do
    local line = table.concat({ tensor, w0, q0, t, w, q }, " "):gsub("[,L]", " ")
    lines[#lines + 1], ids[#ids + 1] = line, id .. " t = " .. t
  end
  return lines, ids
end

do
  local lines, ids = rows "tests/reference/free_top.h"
  local input, output = os.tmpname(), os.tmpname()
  local file = assert(io.open(input, "w"))
  file:write(table.concat(lines, "\n"), "\n")
  file:close()
  local ran = os.execute(program .. " -e < " .. input .. " > " .. output)
  local worst, at, n = { 0, 0 }, { "", "" }, 0
  for line in io.lines(output) do
    n = n + 1
    local i = 0
    for word in line:gmatch "%S+" do
      i = i + 1
      local e = tonumber(word) or math.huge -- "nan" is no number
      if i <= 2 and e > worst[i] then worst[i], at[i] = e, ids[n] end
    end
  end
  os.remove(input)
  os.remove(output)
  tap.ok(ran and n == #lines and n >= 275, n .. " samples")
  -- 32 significant digits: half a unit of the last is at most 5e-32 of the largest component
  tap.ok(worst[1] <= 5e-32, string.format("rates agree to the last printed digit: %.3g (%s)", worst[1], at[1]))
  tap.ok(worst[2] <= 1e-31, string.format("attitudes agree, signs too: %.3g (%s)", worst[2], at[2]))
end
tap.done()
