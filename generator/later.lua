-- later.lua -- a module that is loaded when one of its fields is first asked for.
--
--     local q31 = later "generator.emit.q31"      in the place of require
-- Half of a short run went to loading, and most scenes need half of the modules.  For modules that are tables and that
-- only some scenes, options or commands need; nothing is written through what stands for the module.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(name)
  local meta = {}
  function meta.__index(_, key)
    meta.__index = require(name)
    return meta.__index[key]
  end
  function meta.__newindex(_, key) error(name .. " is not written to from outside: " .. tostring(key), 2) end
  return setmetatable({}, meta)
end
