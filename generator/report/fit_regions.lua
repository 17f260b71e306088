-- fit_regions.lua -- where two estimates of a fit are together: ellipses of 95 %, as text and JSON.
--
--     regions.of(told)        list of {first, second = estimates, rho, together, against = semi-axes}
--     regions.text(out, told) lines into the list `out`
--     regions.json(told)      list of objects
-- SPDX-License-Identifier: GPL-3.0-or-later

local json = require "generator.report.json"

local regions = {}

local REGION = 5.991464547107979 -- the 95 % point of chi-square with two degrees of freedom, -2 log 0.05
local THIN = 0.5 -- correlations below this are circles, nearly

local function put(list, ...) list[#list + 1] = string.format(...) end

-- Of each pair the semi-axes of the ellipse that has the truth inside with a probability of 95 %, in standard errors:
-- d' C^-1 d = 5.991 has them along (1, 1) and (1, -1), sqrt(5.991 (1 + rho)) and sqrt(5.991 (1 - rho)).
function regions.of(told)
  local list = {}
  for k = 1, #told.estimates do
    for i = 1, k - 1 do
      local rho = told.correlation[k][i]
      if rho == rho then
        list[#list + 1] = { first = told.estimates[i], second = told.estimates[k], rho = rho,
          together = math.sqrt(REGION * math.max(0, 1 + rho)), against = math.sqrt(REGION * math.max(0, 1 - rho)) }
      end
    end
  end
  return list
end

-- The ellipses that are far from circles, the thinnest first.
function regions.text(out, told)
  local list = {}
  for _, a in ipairs(told.regions) do
    if math.abs(a.rho) > THIN and #told.estimates <= 12 then list[#list + 1] = a end
  end
  table.sort(list, function(a, b)
    if a.rho ^ 2 ~= b.rho ^ 2 then return a.rho ^ 2 > b.rho ^ 2 end
    return a.first.name .. " " .. a.second.name < b.first.name .. " " .. b.second.name
  end)
  if #list > 0 then put(out, "\n95 %% regions of pairs that go together, semi-axes in standard errors") end
  for i = 1, math.min(4, #list) do
    local a = list[i]
    put(out, "  %s, %s: %.2f where both grow, %.2f where one falls", a.first.name, a.second.name, a.together, a.against)
  end
end

function regions.json(told)
  local list = {}
  for i, a in ipairs(told.regions) do
    list[i] = json.object { { "first", a.first.name }, { "second", a.second.name }, { "correlation", a.rho },
      { "semi_axes", { a.together, a.against } } }
  end
  return list
end

return regions
