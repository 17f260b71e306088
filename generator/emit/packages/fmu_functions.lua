-- fmu_functions.lua -- the C functions of FMI 2.0 and 3.0: their arguments, and why a unit refuses some.
--
-- A row is {name =, args =, reason =, result =, given =}.  Without a reason the function is written out in the
-- template; with given = NAME it is if the set that functions.of is asked with has NAME.  A refused function returns an
-- error with the reason in the log, or nothing to do when it is asked about n = 0 variables.
-- SPDX-License-Identifier: GPL-3.0-or-later

local functions = {}

local exchange = "the unit is for co-simulation only"
local derivatives = "the unit was made without derivatives (gen --with jacobians)"

local rows2, rows3 = {}, {}

do -- FMI 2.0.4: 44 functions
  local c = "fmi2Component c"
  local many = c .. ", const fmi2ValueReference vr[], size_t n"
  local function row(name, args, reason, more)
    rows2[#rows2 + 1] = { name = name, args = args, reason = reason, result = more and more.result,
      given = more and more.given }
  end
  row("GetTypesPlatform", "void", nil, { result = "const char *" })
  row("GetVersion", "void", nil, { result = "const char *" })
  row("SetDebugLogging", c .. ", fmi2Boolean loggingOn, size_t n, const fmi2String categories[]")
  row("Instantiate", "fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources, " ..
    "const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean loggingOn", nil,
    { result = "fmi2Component " })
  row("FreeInstance", c, nil, { result = "void " })
  row("SetupExperiment", c .. ", fmi2Boolean toleranceDefined, fmi2Real tolerance, fmi2Real startTime, " ..
    "fmi2Boolean stopTimeDefined, fmi2Real stopTime")
  for _, name in ipairs { "EnterInitializationMode", "ExitInitializationMode", "Terminate", "Reset" } do
    row(name, c)
  end
  for _, kind in ipairs { "Real", "Integer", "Boolean", "String" } do
    local why = kind ~= "Real" and "every variable of the unit is a Real" or nil
    row("Get" .. kind, many .. ", fmi2" .. kind .. " value[]", why)
    row("Set" .. kind, many .. ", const fmi2" .. kind .. " value[]", why)
  end
  row("GetFMUstate", c .. ", fmi2FMUstate *state")
  row("SetFMUstate", c .. ", fmi2FMUstate state")
  row("FreeFMUstate", c .. ", fmi2FMUstate *state")
  row("SerializedFMUstateSize", c .. ", fmi2FMUstate state, size_t *size")
  row("SerializeFMUstate", c .. ", fmi2FMUstate state, fmi2Byte bytes[], size_t size")
  row("DeSerializeFMUstate", c .. ", const fmi2Byte bytes[], size_t size, fmi2FMUstate *state")
  row("GetDirectionalDerivative", c .. ", const fmi2ValueReference unknown[], size_t nUnknown, " ..
    "const fmi2ValueReference known[], size_t nKnown, const fmi2Real dKnown[], fmi2Real dUnknown[]", derivatives,
    { given = "derivatives" })
  row("EnterEventMode", c, exchange)
  row("NewDiscreteStates", c .. ", fmi2EventInfo *info", exchange)
  row("EnterContinuousTimeMode", c, exchange)
  row("CompletedIntegratorStep", c .. ", fmi2Boolean noSetFMUStatePriorToCurrentPoint, fmi2Boolean *enterEventMode, " ..
    "fmi2Boolean *terminateSimulation", exchange)
  row("SetTime", c .. ", fmi2Real time", exchange)
  row("SetContinuousStates", c .. ", const fmi2Real x[], size_t nx", exchange)
  row("GetDerivatives", c .. ", fmi2Real derivatives[], size_t nx", exchange)
  row("GetEventIndicators", c .. ", fmi2Real indicators[], size_t ni", exchange)
  row("GetContinuousStates", c .. ", fmi2Real x[], size_t nx", exchange)
  row("GetNominalsOfContinuousStates", c .. ", fmi2Real nominal[], size_t nx", exchange)
  row("SetRealInputDerivatives", many .. ", const fmi2Integer order[], const fmi2Real value[]",
    "inputs are held during a step (canInterpolateInputs is false)")
  row("GetRealOutputDerivatives", many .. ", const fmi2Integer order[], fmi2Real value[]",
    "outputs have no derivatives here (maxOutputDerivativeOrder is 0)")
  row("DoStep", c .. ", fmi2Real point, fmi2Real size, fmi2Boolean noSetFMUStatePriorToCurrentPoint")
  row("CancelStep", c, "no step is pending: fmi2DoStep returns when it is done")
  local kind = ", const fmi2StatusKind kind, "
  row("GetStatus", c .. kind .. "fmi2Status *value")
  row("GetRealStatus", c .. kind .. "fmi2Real *value")
  row("GetIntegerStatus", c .. kind .. "fmi2Integer *value", "there is no status of this type")
  row("GetBooleanStatus", c .. kind .. "fmi2Boolean *value")
  row("GetStringStatus", c .. kind .. "fmi2String *value", "no step is pending")
end

do -- FMI 3.0: 75 functions
  local c = "fmi3Instance c"
  local many = c .. ", const fmi3ValueReference vr[], size_t n"
  local clocks = "the unit has no clocks"
  local function row(name, args, reason, more)
    rows3[#rows3 + 1] = { name = name, args = args, reason = reason, result = more and more.result,
      given = more and more.given }
  end
  row("GetVersion", "void", nil, { result = "const char *" })
  row("SetDebugLogging", c .. ", fmi3Boolean loggingOn, size_t n, const fmi3String categories[]")
  local create, back = "fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, " ..
    "fmi3Boolean loggingOn, ", "fmi3InstanceEnvironment environment, fmi3LogMessageCallback log"
  local made = { result = "fmi3Instance " }
  row("InstantiateModelExchange", create .. back, nil, made)
  row("InstantiateCoSimulation", create .. "fmi3Boolean eventModeUsed, fmi3Boolean earlyReturnAllowed, " ..
    "const fmi3ValueReference intermediate[], size_t n, " .. back ..
    ", fmi3IntermediateUpdateCallback update", nil, made)
  row("InstantiateScheduledExecution", create .. back .. ", fmi3ClockUpdateCallback clock, " ..
    "fmi3LockPreemptionCallback lock, fmi3UnlockPreemptionCallback unlock", nil, made)
  row("FreeInstance", c, nil, { result = "void " })
  row("EnterInitializationMode", c .. ", fmi3Boolean toleranceDefined, fmi3Float64 tolerance, " ..
    "fmi3Float64 startTime, fmi3Boolean stopTimeDefined, fmi3Float64 stopTime")
  row("ExitInitializationMode", c)
  row("EnterEventMode", c, "the unit has no Event Mode")
  row("Terminate", c)
  row("Reset", c)
  for _, kind in ipairs { "Float32", "Float64", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64",
    "UInt64", "Boolean", "String", "Binary" } do
    local why = kind ~= "Float64" and "every variable of the unit is a Float64" or nil
    local sizes = kind == "Binary" and "size_t sizes[], " or ""
    row("Get" .. kind, many .. ", " .. sizes .. "fmi3" .. kind .. " values[], size_t nValues", why)
    sizes = kind == "Binary" and "const size_t sizes[], " or ""
    row("Set" .. kind, many .. ", " .. sizes .. "const fmi3" .. kind .. " values[], size_t nValues", why)
  end
  row("GetClock", many .. ", fmi3Clock values[]", clocks)
  row("SetClock", many .. ", const fmi3Clock values[]", clocks)
  local elements = "no variable is an array (providesPerElementDependencies is false)"
  row("GetNumberOfVariableDependencies", c .. ", fmi3ValueReference vr, size_t *number", elements)
  row("GetVariableDependencies", c .. ", fmi3ValueReference dependent, size_t elementsOfDependent[], " ..
    "fmi3ValueReference independents[], size_t elementsOfIndependents[], fmi3DependencyKind kinds[], size_t number",
    elements)
  row("GetFMUState", c .. ", fmi3FMUState *state")
  row("SetFMUState", c .. ", fmi3FMUState state")
  row("FreeFMUState", c .. ", fmi3FMUState *state")
  row("SerializedFMUStateSize", c .. ", fmi3FMUState state, size_t *size")
  row("SerializeFMUState", c .. ", fmi3FMUState state, fmi3Byte bytes[], size_t size")
  row("DeserializeFMUState", c .. ", const fmi3Byte bytes[], size_t size, fmi3FMUState *state")
  local along = c .. ", const fmi3ValueReference unknowns[], size_t nUnknowns, const fmi3ValueReference knowns[], " ..
    "size_t nKnowns, const fmi3Float64 seed[], size_t nSeed, fmi3Float64 sensitivity[], size_t nSensitivity"
  row("GetDirectionalDerivative", along, derivatives, { given = "derivatives" })
  row("GetAdjointDerivative", along, "the unit has no adjoint derivatives")
  row("EnterConfigurationMode", c, "the unit has no structural parameters")
  row("ExitConfigurationMode", c, "the unit has no structural parameters")
  for _, verb in ipairs { "Get", "Set" } do
    local const = verb == "Set" and "const " or ""
    for _, what in ipairs { "Interval", "Shift" } do
      local tail = verb .. what == "GetInterval" and ", fmi3IntervalQualifier qualifiers[]" or ""
      row(verb .. what .. "Decimal", many .. ", " .. const .. "fmi3Float64 values[]" .. tail, clocks)
      row(verb .. what .. "Fraction", many .. ", " .. const .. "fmi3UInt64 counters[], " .. const ..
        "fmi3UInt64 resolutions[]" .. tail, clocks)
    end
  end
  row("EvaluateDiscreteStates", c, "the unit has no Event Mode")
  row("UpdateDiscreteStates", c .. ", fmi3Boolean *discreteStatesNeedUpdate, fmi3Boolean *terminateSimulation, " ..
    "fmi3Boolean *nominalsOfContinuousStatesChanged, fmi3Boolean *valuesOfContinuousStatesChanged, " ..
    "fmi3Boolean *nextEventTimeDefined, fmi3Float64 *nextEventTime", "the unit has no Event Mode")
  row("EnterContinuousTimeMode", c, exchange)
  row("CompletedIntegratorStep", c .. ", fmi3Boolean noSetFMUStatePriorToCurrentPoint, " ..
    "fmi3Boolean *enterEventMode, fmi3Boolean *terminateSimulation", exchange)
  row("SetTime", c .. ", fmi3Float64 time", exchange)
  row("SetContinuousStates", c .. ", const fmi3Float64 x[], size_t nx", exchange)
  row("GetContinuousStateDerivatives", c .. ", fmi3Float64 derivatives[], size_t nx", exchange)
  row("GetEventIndicators", c .. ", fmi3Float64 indicators[], size_t ni", exchange)
  row("GetContinuousStates", c .. ", fmi3Float64 x[], size_t nx", exchange)
  row("GetNominalsOfContinuousStates", c .. ", fmi3Float64 nominals[], size_t nx", exchange)
  row("GetNumberOfEventIndicators", c .. ", size_t *number", exchange)
  row("GetNumberOfContinuousStates", c .. ", size_t *number", exchange)
  row("EnterStepMode", c, "the unit has no Event Mode, so it is in Step Mode")
  row("GetOutputDerivatives", many .. ", const fmi3Int32 orders[], fmi3Float64 values[], size_t nValues",
    "outputs have no derivatives here (maxOutputDerivativeOrder is 0)")
  row("DoStep", c .. ", fmi3Float64 point, fmi3Float64 size, fmi3Boolean noSetFMUStatePriorToCurrentPoint, " ..
    "fmi3Boolean *eventHandlingNeeded, fmi3Boolean *terminateSimulation, fmi3Boolean *earlyReturn, " ..
    "fmi3Float64 *lastSuccessfulTime")
  row("ActivateModelPartition", c .. ", fmi3ValueReference clock, fmi3Float64 time", clocks)
end

-- Text broken at its commas into lines of at most 118 columns.
local function lines(text)
  local out, line = {}, ""
  for part in string.gmatch(text, "[^,]+,?") do
    if #line + #part > 118 then
      out[#out + 1] = line
      line = "   " .. part
    else
      line = line .. part
    end
  end
  out[#out + 1] = line
  return out
end

-- The functions of version "2" or "3" for the templates; has: the set of what the unit can do (derivatives).
-- Returns all: a list of {name, prototype = lines}, and the refused: {name, definition = lines, reason, unused, empty}.
function functions.of(version, has)
  local all, refused = {}, {}
  for i, row in ipairs(version == "2" and rows2 or rows3) do
    local name = "fmi" .. version .. row.name
    local head = (row.result or "fmi" .. version .. "Status ") .. name .. "(" .. row.args .. ")"
    all[i] = { name = name, prototype = lines("FMI" .. version .. "_EXPORT " .. head .. ";") }
    if row.reason and not (row.given and has[row.given]) then
      local unused, empty = {}, false
      for part in string.gmatch(row.args, "[^,]+") do
        local argument = string.match(part, "([%w_]+)[%[%]]*$")
        if argument == "n" then empty = true end
        if argument ~= "c" and argument ~= "n" then unused[#unused + 1] = argument end
      end
      refused[#refused + 1] = { name = name, definition = lines(head), reason = row.reason, unused = unused,
        empty = empty }
    end
  end
  return all, refused
end

return functions
