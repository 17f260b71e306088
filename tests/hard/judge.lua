-- judge.lua -- reads what the workers print and says what holds.
--
--     judge.read(results, line)            results[name] = {file =, rows = {...}, naive =, broken =}
--     judge.case(case, result)             {fine =, worst = {double = row, float = row, all = row}, faults = {...}}
--
-- An error holds when it is a number not above its bound; NaN was read as infinite.  A case without a row in
-- double or in float must say why.
-- SPDX-License-Identifier: GPL-3.0-or-later

local judge = {}

-- "inf" and "nan" as C prints them; a NaN is as bad as can be.
local function number(word)
  local x = tonumber(word)
  if x and x == x then return x end
  return math.huge
end

function judge.read(results, line)
  local words = {}
  for word in string.gmatch(line, "[^\t]+") do words[#words + 1] = word end
  local kind, now = words[1], results.now
  if kind == "case" then
    now = { file = words[2], name = words[3], rows = {} }
    results[words[3]], results.now = now, now
  elseif kind == "row" then
    local error, bound = number(words[4]), number(words[5])
    now.rows[#now.rows + 1] = { who = words[2], real = words[3], error = error, bound = bound, ratio = error / bound }
  elseif kind == "naive" then
    now.naive = number(words[2])
  elseif kind == "broken" then
    now.broken = words[2]
  elseif kind == "end" then
    now.complete = true
  end
end

function judge.case(case, result)
  local out = { worst = {}, faults = {} }
  local function fault(...) out.faults[#out.faults + 1] = string.format(...) end
  if not result then
    fault("%s: no result", case.name)
    return out
  end
  if result.broken then fault("%s: %s", case.name, result.broken) end
  if not result.complete then fault("%s: ended early", case.name) end
  if not result.naive then fault("%s: the naive formula's error is missing", case.name) end
  for _, r in ipairs(result.rows) do
    if not (r.bound > 0 and r.bound < math.huge) then
      fault("%s: %s in %s: the bound is %g", case.name, r.who, r.real, r.bound)
      r.ratio = math.huge
    elseif r.error > r.bound then
      fault("%s: %s in %s: error %.3g, bound %.3g", case.name, r.who, r.real, r.error, r.bound)
    end
    for _, key in ipairs { r.real, "all" } do
      local w = out.worst[key]
      if not w or r.ratio > w.ratio then out.worst[key] = r end
    end
  end
  for _, real in ipairs { "double", "float" } do
    if not out.worst[real] and (case.only or real) == real then fault("%s: nothing in %s", case.name, real) end
  end
  out.fine = #out.faults == 0
  return out
end

return judge
