-- colours.lua -- messages on a terminal: what kind they are, and of which line, stands out.
--
--     colours.of(text) -> the same text with escape sequences
--     colours.host(host) -> the host, with an err that colours where host.coloured() says so
-- host.coloured() is true where standard error is a terminal, NO_COLOR is not set (no-color.org) and TERM is not dumb.
-- Results, on standard output, never have colours.
-- SPDX-License-Identifier: GPL-3.0-or-later

local colours = {}

local red, yellow, bold, plain = "\27[1;31m", "\27[1;33m", "\27[1m", "\27[0m"

-- The beginnings of lines that stand out, the first that fits.
local beginnings = {
  { "^(warning: )(%S+:%d+: )(.*)$", yellow, bold },
  { "^(warning: )()(.*)$", yellow },
  { "^(polhode: )()(.*)$", red },
  { "^(polhode %l+: )()(.*)$", red },
  { "^(%S+:%d+: )()(.*)$", bold },
}

local function line_of(line)
  for _, b in ipairs(beginnings) do
    local first, second, rest = string.match(line, b[1])
    if first then
      return b[2] .. first .. plain .. (b[3] and b[3] .. second .. plain or "") .. rest
    end
  end
  return line
end

function colours.of(text) return (string.gsub(text, "[^\n]+", line_of)) end

function colours.host(host)
  if not host.coloured() then return host end
  return setmetatable({ err = function(text) return host.err(colours.of(text)) end }, { __index = host })
end

return colours
