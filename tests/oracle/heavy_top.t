#!/usr/bin/env lua5.4
-- heavy_top.t -- the oracle of many digits against the 32 digits of the reference set: heavy tops and a gyrostat.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"

-- The program is built by `make tests`; POLHODE_HEAVY_ORACLE names another.
local program = os.getenv "POLHODE_HEAVY_ORACLE" or "build/oracle/heavy_top"

-- model: of the rows; option: of the program; least: how many rows there are
local function compare(model, option, least)
  -- Rows as lines: moments, m g r or the rotor's momentum, w0, q0, t, and the state with all its digits.
  local lines, ids = {}, {}
  local file = assert(io.open "tests/reference/forced_top.h")
  local pattern = '{"([%w_]+)", FORCED_' .. model .. ', {(.-)}, {(.-)},%s*{(.-)}, (%S+),%s*{(.-)}}'
  for id, I, r, x0, t, x in string.gmatch(file:read("a"), pattern) do
    local line = string.gsub(table.concat({ I, r, x0, t, x }, " "), "[,L]", " ")
    lines[#lines + 1], ids[#ids + 1] = line, id .. " t = " .. t
  end
  file:close()

  local input, output = os.tmpname(), os.tmpname()
  file = assert(io.open(input, "w"))
  file:write(table.concat(lines, "\n"), "\n")
  file:close()
  -- 160 bits: 48 digits, of which the motions with 200 rad/s over 10 s lose some
  local ran = os.execute(program .. " -b 160 " .. option .. " -e < " .. input .. " > " .. output)
  local worst, at, n = { 0, 0 }, { "", "" }, 0
  for line in io.lines(output) do
    n = n + 1
    local i = 0
    for word in string.gmatch(line, "%S+") do
      i = i + 1
      local e = tonumber(word) or math.huge -- "nan" is no number
      if e > worst[i] then worst[i], at[i] = e, ids[n] end
    end
  end
  os.remove(input)
  os.remove(output)
  tap.ok(ran and n == #lines and n >= least, n .. " samples")
  -- 32 significant digits: half a unit of the last is at most 5e-32 of the largest component
  tap.ok(worst[1] <= 5e-32, string.format("rates agree to the last printed digit: %.3g (%s)", worst[1], at[1]))
  tap.ok(worst[2] <= 1e-31, string.format("attitudes agree: %.3g (%s)", worst[2], at[2]))
end

compare("HEAVY", "", 25)
compare("ROTOR", "-r", 5)
tap.done()
