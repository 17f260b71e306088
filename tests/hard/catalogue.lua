-- catalogue.lua -- the files of hard cases in their order, and what a case must say.
--
-- A file cases/NAME.lua is a function of the kit that returns {title =, about =, cases = {...}}.  A case:
--     name     unique, in the words of its trouble: "moments_equal_to_1e16"
--     fast     true: it is in make check-all, too
--     why      why it is hard
--     naive    the formula that one would write first; row.naive(error) tells what comes of it
--     oracle   whence the truth
--     bound    what the bound is and why that much: roundings counted, a law, a condition number
--     run      function(row): row(who, real, error, bound) for everything of ours that can do it: the emitted "at",
--              "rk4", "init" .. in "double" and in "float", the "library" in "long double"
--     only     "double" or "float" where the other cannot hold the case, with `because`
-- Every error and bound of a case is in one unit, and the bound is that of the type.  naive: in double.
-- SPDX-License-Identifier: GPL-3.0-or-later

local catalogue = {}

catalogue.files = { "separatrix", "free_moments", "free_axis", "time_free", "scale_free", "symmetric",
  "heavy_sleeping", "heavy_motion", "gyrostat", "steppers_free", "steppers_heavy",
  "rest", "inputs", "fields", "moving", "plane",
  "mass_walls", "mass_limits", "mass_far", "mass_sums", "mass_scale", "axes_near", "frames" }

local wanted = { "name", "why", "naive", "oracle", "bound" }

-- All cases, by file, as data; their functions are not run.  Loads with a kit that has nothing.
function catalogue.load(files)
  local list, seen = {}, {}
  local nothing = setmetatable({ u = { double = 0, float = 0 } }, { __index = function() return function() end end })
  function nothing.use() return nothing end
  for _, name in ipairs(files or catalogue.files) do
    local file = assert(loadfile("tests/hard/cases/" .. name .. ".lua"))()(nothing)
    assert(file.title and file.about, name .. ": a file has a title and a word about it")
    for _, case in ipairs(file.cases) do
      for _, key in ipairs(wanted) do
        assert(type(case[key]) == "string" and case[key] ~= "", name .. ": " .. tostring(case.name) .. " lacks " .. key)
      end
      assert(type(case.run) == "function", case.name .. " does nothing")
      assert(not seen[case.name], case.name .. " stands twice")
      assert((case.only == nil) == (case.because == nil), case.name .. ": only goes with because")
      seen[case.name] = true
    end
    file.name = name
    list[#list + 1] = file
  end
  return list
end

return catalogue
