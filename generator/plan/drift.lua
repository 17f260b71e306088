-- drift.lua -- how far what a scene conserves has moved along a run: one number for each law of job.conserved.
--
-- T+V relative to its value at the start, |L|, L and L_z to |L|, w3 to |w| at the start; absolutely where that is zero.
-- Values are those of the emitted code in double, whatever type the run had.
-- SPDX-License-Identifier: GPL-3.0-or-later

local drift = {}

local function norm(v) return math.sqrt(v[1] * v[1] + v[2] * v[2] + v[3] * v[3]) end

-- plugin: in double, with its parameters set.  Returns a function of rows (states) -> {[law] = largest drift}; laws
-- that the plugin has no function for are left out.
function drift.of(job, plugin, x0)
  local wx
  for i, s in ipairs(job.states) do
    if s.name == "wx" then wx = i end
  end
  local has = plugin:info().has
  local measures = {}
  local function measure(law, scale, value)
    if job.conserved.is[law] then measures[#measures + 1] = { law, scale ~= 0 and math.abs(scale) or 1.0, value } end
  end
  local E = has.energy and plugin:energy(x0)
  if E then measure("T+V", E, function(x) return plugin:energy(x) - E end) end
  local L = has.momentum and plugin:momentum(x0)
  if L then
    local size = norm(L)
    measure("|L|", size, function(_, l) return norm(l) - size end)
    measure("L", size, function(_, l) return norm { l[1] - L[1], l[2] - L[2], l[3] - L[3] } end)
    measure("L_z", size, function(_, l) return l[3] - L[3] end)
  end
  if wx then
    measure("w3", norm { x0[wx], x0[wx + 1], x0[wx + 2] }, function(x) return x[wx + 2] - x0[wx + 2] end)
  end
  return function(rows)
    local out = {}
    for _, m in ipairs(measures) do out[m[1]] = 0.0 end
    for _, x in ipairs(rows) do
      local l = L and plugin:momentum(x)
      for _, m in ipairs(measures) do
        local d = math.abs(m[3](x, l)) / m[2]
        out[m[1]] = (d ~= d or d > out[m[1]]) and d or out[m[1]]
      end
    end
    for _, m in ipairs(measures) do
      if out[m[1]] ~= out[m[1]] then out[m[1]] = math.huge end
    end
    return out
  end
end

return drift
