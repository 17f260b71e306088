-- unused.lua -- parameters that no expression of the scene reaches: a warning on the line of each.
--
-- A parameter that only names a range, or that cancels, is one of them: the emitted code would carry a number that
-- changes nothing.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"

local unused = {}

-- record: what env.record returns.
function unused.warn(d, record)
  local used, seen = {}, {}
  local function reach(x)
    if type(x) ~= "table" or seen[x] then return end
    seen[x] = true
    if expr.is(x) then
      if x.kind == "sym" then used[x] = true end
      for _, child in ipairs(expr.children(x)) do reach(child) end
      return
    end
    for k, v in pairs(x) do -- into sets: order is lost anyway
      if k ~= "spec" then reach(v) end
    end
  end
  for k, v in pairs(record) do
    if k ~= "params" and k ~= "checks" then reach(v) end
  end
  for _, p in ipairs(record.params) do
    if not used[p.sym] then
      d:warn(p.line, "param", p.name .. " is used nowhere: nothing in the scene depends on it")
    end
  end
end

return unused
