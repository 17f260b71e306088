-- main.lua - a generator for testing the host alone: runs a Lua file with the host's table at hand.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     POLHODE_SOURCE=tests/cli/tree polhode FILE [ARGUMENT...]
--
-- The file is the body of a function (host, args) and may return an exit status.  It has the whole library of
-- the generator, as generator/main.lua has.

local function show(...)
  local out = {}
  for i = 1, select("#", ...) do
    out[i] = tostring((select(i, ...)))
  end
  return table.concat(out, " ")
end

return function(host, args)
  local env = setmetatable({
    host = host, args = args,
    say = function(...) return host.out(show(...) .. "\n") end,
  }, { __index = _G })
  local file = table.remove(args, 1)
  local text = assert(host.read(file))
  local status = assert(load(text, "@" .. file, "t", env))(host, args)
  return status or 0
end
