-- order.lua - in which order tests look for a planted defect: soon caught, little spent.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     order.quick(defect, most)   the quick tests of at most so many seconds that can see it, those first that catch
--                                 most defects in files like this for their seconds
--     order.rest(defect)          what make check-all has beside them and can see it; also what is longer there
--     order.longer(defect)        the longer tests and those of make check-target that are near the file by name
--     order.tests(tier, most)     "quick": those of the first, "all": those of the second
--     order.sees = { quick =, all = }: seen.by of these
--     order.met(test, file, found)    what a test did with a defect in a file: `sorted` learns from it
--
-- A test: { file, seconds, command }, from tests/tiers.txt.

local order = {}

local tests = {}
for line in io.lines "tests/tiers.txt" do
  local quick, all, file = line:gsub("#.*", ""):match "^%s*(%S+)%s+([%d.]+)%s+(%S+)%s*$"
  if file then
    local built = file:match "^(tests/runtime/.*)%.c$"
    tests[#tests + 1] = { file = file, quick = tonumber(quick), all = tonumber(all), target = quick == "target",
      command = built and "build/" .. built .. ".t" or "lua5.4 " .. file }
  end
end

local function area(file) return file:match "^[^/]+" end

-- By test and area, by test and folder: how many defects it has met and found.
local met = {}

local function places(test, file) return { test.file .. " " .. area(file), test.file .. " " .. file:match "^(.*)/" } end

function order.met(test, file, found)
  for _, key in ipairs(places(test, file)) do
    met[key] = met[key] or { all = 0, found = 0 }
    met[key].all, met[key].found = met[key].all + 1, met[key].found + (found and 1 or 0)
  end
end

-- generator/mass/holes.lua: tests/mass/holes.t first, then the others there; orbit/gyrostat_at.c: gyrostat.t;
-- projects/firmware/watchdog.c: firmware.t.  Templates are seen where whole scenes are compiled and compared.
local WHOLE = { ["tests/bodies/check.t"] = true, ["tests/emit/golden.t"] = true, ["tests/emit/compile.t"] = true,
  ["tests/emit/forced.t"] = true }
local TESTED = { steppers = "methods", orbit = "emit", core = "emit", numeric = "emit", analysis = "emit",
  test = "emit", projects = "emit", firmware = "emit", packages = "emit", host = "cli", commands = "cli",
  target = "cost", shapes = "mass", draw = "report" }
local function near(test, file)
  local folder, name = file:match "([^/]+)/([^/]+)%.%w+$"
  local part, rest = file:match "^src/(%w+)/(.*)%.%w+$" -- src/runtime/mesh/stl.c: as a file mesh_stl of runtime
  if part then folder, name = part, (rest:gsub("/", "_")) end
  local tests_in, test_name = test.file:match "tests/(.-)/?([^/]+)%.%w+$"
  local score = 0
  if name:find(test_name, 1, true) == 1 or folder == test_name then score = score + 9 end
  if area(file) == "templates" and WHOLE[test.file] then score = score + 9 end
  if tests_in == (TESTED[folder] or folder) then score = score + 3 end
  return score
end

-- What a test cannot see: those of the library link nothing else; those of one stage of the generator load no template.
local STAGES = { algebra = true, ir = true, dsl = true, draw = true, geometry = true, mass = true, interchange = true }
local function blind(test, file)
  local folder = test.file:match "^tests/([^/]+)/"
  if folder == "runtime" then return not file:find "^src/runtime/" end
  return area(file) == "templates" and STAGES[folder] or false
end

-- The share of defects here that it may find, for its seconds.  Before it has met any: one in twenty, more the nearer
-- it is and the more of what it runs is of this file.
local function sorted(list, file)
  local score = {}
  for _, test in ipairs(list) do
    local prior = 0.05 + 0.05*near(test, file) + test.share
    local all, found = 1, math.min(prior, 0.9)
    for _, key in ipairs(places(test, file)) do
      local m = met[key]
      if m then all, found = all + m.all, found + m.found end
    end
    score[test] = found/all/(test.seconds + 0.3)
  end
  table.sort(list, function(a, b) return score[a] > score[b] or score[a] == score[b] and a.file < b.file end)
  return list
end

local function chosen(seconds, most, sees)
  local list = {}
  for _, t in ipairs(tests) do
    local s = seconds(t)
    local sight, share = sees(t)
    if s and s <= most and sight and not t.target then
      list[#list + 1] = { file = t.file, seconds = s, command = t.command, share = share or 0 }
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

-- Those that are longer outside of the quick tier, or not in it, and near the file.
function order.longer(defect)
  local list, score = {}, {}
  for _, t in ipairs(tests) do
    local close = (not t.quick or t.quick < t.all) and not blind(t, defect.file) and near(t, defect.file) or 0
    if close > 0 then
      list[#list + 1] = { file = t.file, seconds = t.all, command = t.command }
      score[list[#list]] = close/(t.all + 5)
    end
  end
  table.sort(list, function(a, b) return score[a] > score[b] or score[a] == score[b] and a.file < b.file end)
  return list
end

function order.tests(tier, most) return chosen(seconds(tier), most, function() return true end) end

local function those(tier, defect, most)
  local sees = order.sees[tier]
  return sorted(chosen(seconds(tier), most, function(t)
    if blind(t, defect.file) then return false end
    return sees(t, defect.file, defect.line)
  end), defect.file)
end

function order.quick(defect, most) return those("quick", defect, most) end
function order.rest(defect) return those("all", defect, math.huge) end

return order
