-- stages.lua -- what each stage of the chain hands to the next, and the names of its fields: all are here.
--
--     scene       what was read: the record of the scene language, the model, the equations
--     plan        one way to emit a scene: options decided, functions, steppers, constants; a scene has any number
--     unit        the C text of a plan
-- A stage is open while its maker fills it, and then closed: nobody writes into it.  A field that is not declared here
-- can neither be written nor read.  What a stage does not have itself it reads from the one before it, so a unit
-- answers for its plan and its scene; modules that take any of the three call it job.
-- SPDX-License-Identifier: GPL-3.0-or-later

local stages = {}

local FIELDS = {
  -- dynamics/model.lua: the body and its states; name, file and line: of the scene
  model = [[ name file line record symbolic baked params defaults by_name limits inputs
    omega attitude given timed horizon step
    body mass origin com inertia centroidal parts structure carried carrier locked
    formal slack unlawful conditions unasked
    has frame states moving reasons ]],
  -- dynamics/equations.lua; model: with the constants that the equations use (dynamics/constants.lua)
  equations = [[ groups coupled turn inputs free touch model ]],
  -- driver.read; closed: the closed form that the scene has, or why it has none
  scene = [[ host templates version build file source text diag budget
    record model equations states closed conserved ranges ]],
  -- driver.plan; model: the scene's, with all constants of the functions; closed: the form that is emitted, or why none
  -- is; disc: constants of the functions of a rolling disc; planned: the decision of generator/plan/; fit: steps with
  -- derivatives (dynamics/tangents.lua), or false; sweep: the study of many members, or false; held: what --bake holds
  -- in constants of C; transition, compensated: are there such steps?; orders: of the series that a planner tries
  plan = [[ diag budget model equations
    real libm command selection layout package proof planned orders batch sweep fit estimator
    methods jacobians steppers functions transition compensated q31 held
    closed closed_constants oblique smooth_until stability disc
    title banner derivation ]],
  -- driver.code, driver.files; plugin: also what the program itself loads; hash, hashes: of driver.trace; counted: the
  -- sheet of --target; code: {header =, source =}, all of them in one; emitted: its functions; costs: their
  -- operations; readings: what cost/ops.lua has read of the code; sheet, counted_lines: make lists for the README;
  -- checks: what the set-up refuses, in words, by the numbers that it returns
  unit = [[ plugin hash hashes counted code emitted checks costs readings files sheet counted_lines ]],
}

local declared = {}
for stage, words in pairs(FIELDS) do -- into a table: order is lost anyway
  declared[stage] = {}
  for name in string.gmatch(words, "%S+") do declared[stage][name] = true end
end

local function refuse(stage, what, name)
  error(string.format("%s: %s %s", stage, what, tostring(name)), 3)
end

-- An open stage.  before: what it reads where it has no such field, an earlier stage or a table of methods.
function stages.open(stage, before)
  local own, plain = declared[stage], type(before) == "table" and getmetatable(before) == nil
  local values = setmetatable({}, { __index = function(_, name)
    if own[name] then return nil end
    local x = before and before[name]
    if x == nil and (plain or not before) then refuse(stage, "has no field", name) end
    return x
  end })
  return setmetatable({}, { __index = values, stage = stage, values = values, before = before,
    __newindex = function(_, name, x)
      if not own[name] then refuse(stage, "has no field", name) end
      values[name] = x
    end })
end

-- From here on nobody writes into it.
function stages.close(s)
  local meta = getmetatable(s)
  meta.__newindex = function(_, name) refuse(meta.stage, "is closed, so nobody writes", name) end
  return s
end

-- A closed stage with these values.
function stages.made(stage, values)
  local s = stages.open(stage)
  for name, x in pairs(values) do s[name] = x end -- into a table: order is lost anyway
  return stages.close(s)
end

-- An open stage with the same fields.
function stages.copy(s)
  local meta = getmetatable(s)
  local copy = stages.open(meta.stage, meta.before)
  for name, x in pairs(meta.values) do copy[name] = x end -- into a table: order is lost anyway
  return copy
end

return stages
