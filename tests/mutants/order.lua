-- order.lua - in which order tests look for a planted defect: soon caught, little spent.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     order.quick(defect)   the quick tests that can see it, those first that catch most defects in files like this for
--                           their seconds
--     order.rest(defect)    what make check-all has beside them and can see it; also what is longer there
--     order.tests(tier)     "quick": those of the first, "all": those of the second
--     order.sees = { quick =, all = }: seen.by of these
--     order.killed(test, file)
--
-- A test: { file, seconds, command }, from tests/tiers.txt.

local order = {}

local tests = {}
for line in io.lines "tests/tiers.txt" do
  local quick, all, file = line:gsub("#.*", ""):match "^%s*(%S+)%s+([%d.]+)%s+(%S+)%s*$"
  if file and quick ~= "target" then
    local built = file:match "^(tests/runtime/.*)%.c$"
    tests[#tests + 1] = { file = file, quick = tonumber(quick), all = tonumber(all),
      command = built and "build/" .. built .. ".t" or "lua5.4 " .. file }
  end
end

local kills = {} -- by test and area

local function area(file) return file:match "^[^/]+" end

function order.killed(test, file)
  local key = test.file .. " " .. area(file)
  kills[key] = (kills[key] or 0) + 1
end

-- generator/mass/holes.lua: tests/mass/holes.t first, then the others there; gyrostat_at.c: gyrostat.t.  Templates are
-- seen where whole scenes are compiled and compared.
local WHOLE = { ["tests/bodies/check.t"] = true, ["tests/emit/golden.t"] = true, ["tests/emit/compile.t"] = true,
  ["tests/emit/forced.t"] = true }
local function near(test, file)
  local folder, name = file:match "([^/]+)/([^/]+)%.%w+$"
  local part, rest = file:match "^src/(%w+)/(.*)%.%w+$" -- src/runtime/mesh/stl.c: as a file mesh_stl of runtime
  if part then folder, name = part, (rest:gsub("/", "_")) end
  local tests_in, test_name = test.file:match "tests/(.-)/?([^/]+)%.%w+$"
  local score = 0
  if name:find(test_name, 1, true) == 1 then score = score + 9 end
  if folder == "templates" and WHOLE[test.file] then score = score + 9 end
  if tests_in == (folder == "templates" and "emit" or folder) then score = score + 3 end
  return score
end

-- What a test cannot see: those of the library link nothing else; those of one stage of the generator load no template.
local STAGES = { algebra = true, ir = true, dsl = true, draw = true, geometry = true, mass = true, interchange = true }
local function blind(test, file)
  local folder = test.file:match "^tests/([^/]+)/"
  if folder == "runtime" then return not file:find "^src/runtime/" end
  return area(file) == "templates" and STAGES[folder] or false
end

local function sorted(list, file)
  local score = {}
  for _, test in ipairs(list) do
    local hits = 0.2 + (kills[test.file .. " " .. area(file)] or 0) + near(test, file)
    score[test] = hits/(test.seconds + 0.3)
  end
  table.sort(list, function(a, b) return score[a] > score[b] or score[a] == score[b] and a.file < b.file end)
  return list
end

local function chosen(seconds, sees)
  local list = {}
  for _, t in ipairs(tests) do
    local s = seconds(t)
    if s and sees(t) then
      list[#list + 1] = { file = t.file, seconds = s, command = t.command }
    end
  end
  return list
end

local function seconds(tier)
  return function(t)
    if tier == "quick" then return t.quick end
    return (not t.quick or t.quick < t.all) and t.all or nil
  end
end

function order.tests(tier) return chosen(seconds(tier), function() return true end) end

local function those(tier, defect)
  local sees = order.sees[tier]
  return sorted(chosen(seconds(tier), function(t)
    return not blind(t, defect.file) and sees(t, defect.file, defect.line)
  end), defect.file)
end

function order.quick(defect) return those("quick", defect) end
function order.rest(defect) return those("all", defect) end

return order
