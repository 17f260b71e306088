-- fmu_units.lua -- units of measurement as modelDescription.xml wants them: names, exponents of the SI base units.
--
-- FMI 2.0.4, 2.2.2 (Definition of Units; the same in 3.0): a unit has integer exponents of kg, m, s, A, K and rad and a
-- factor to them.  Names are written as Modelica does, "kg.m2/s".
-- SPDX-License-Identifier: GPL-3.0-or-later

local units = {}

-- What stands in the units of states and parameters (SI), in the exponents of `base`.
local base = { "kg", "m", "s", "A", "K", "rad" }
local known = { ["1"] = {}, kg = { kg = 1 }, m = { m = 1 }, s = { s = 1 }, A = { A = 1 }, K = { K = 1 },
  rad = { rad = 1 }, N = { kg = 1, m = 1, s = -2 }, J = { kg = 1, m = 2, s = -2 }, W = { kg = 1, m = 2, s = -3 },
  T = { kg = 1, s = -2, A = -1 } }

-- The factors of "kg m^2/s": a list of {name, power, sign}; each / divides by the one that follows.  nil if a power is
-- no whole number.
local function factors(text)
  local list, rest = {}, text
  while string.find(rest, "%S") do
    local mark, name, power, tail = string.match(rest, "^%s*([*/]?)%s*([%a1]%a*)%^?(%-?%d*)(.*)$")
    if not name or string.find(tail, "^/%d") then return nil end
    list[#list + 1] = { name = name, power = power == "" and 1 or math.tointeger(tonumber(power)),
      sign = mark == "/" and -1 or 1 }
    rest = tail
  end
  return list
end

local function written(f)
  return f.name .. (f.power ~= 1 and string.format("%d", f.power) or "")
end

-- The unit's name for the file.
function units.name(text)
  local list = factors(text)
  if not list then return text end
  local top, bottom = {}, {}
  for _, f in ipairs(list) do
    if f.sign < 0 then
      bottom[#bottom + 1] = written(f)
    elseif f.name ~= "1" or #list == 1 then
      top[#top + 1] = written(f)
    end
  end
  local name = #top > 0 and table.concat(top, ".") or "1"
  if #bottom == 0 then return name end
  return name .. "/" .. (#bottom > 1 and "(" .. table.concat(bottom, ".") .. ")" or bottom[1])
end

-- Its exponents as attributes, ' kg="1" m="2" s="-1"'; nil if they are not known or no whole numbers.
function units.exponents(text)
  local sum, list = {}, factors(text)
  if not list then return nil end
  for _, f in ipairs(list) do
    if not known[f.name] then return nil end
    for _, b in ipairs(base) do sum[b] = (sum[b] or 0) + f.sign * f.power * (known[f.name][b] or 0) end
  end
  local out = ""
  for _, b in ipairs(base) do
    if sum[b] and sum[b] ~= 0 then out = out .. " " .. b .. "=\"" .. string.format("%d", sum[b]) .. "\"" end
  end
  return out
end

return units
