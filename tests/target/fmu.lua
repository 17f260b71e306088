-- fmu.lua - units for co-simulation in tests: emitted, unpacked, driven through the standard's functions (fmu.c).
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local units = fmu.make("bodies/brick.lua", "--real float")      -- {[2] = unit, [3] = unit}; nil, output
--     unit.version, unit.dir (unpacked), unit.list (names of its files), unit.binary, unit.xml, unit.token
--     unit.by_name["wx"]                   -- its attributes as text {valueReference = "11", unit =, start =, ...}
--     local answers = fmu.drive(unit, "new 0 TOKEN 0", "get 0 $wx $wy", ...)
--     answers[2].status, answers[2][1], answers[2].log
--
-- The archive is read by its central directory here, not by what wrote it; the XML by patterns, which is enough for
-- what the schemas have accepted.

local tap = require "tests.tap"
local program = require "tests.cli.program"

local fmu = {}

local binary = os.getenv "POLHODE" or "build/polhode"

function fmu.run(format, ...)
  local pipe = assert(io.popen(string.format(format, ...) .. " 2>&1"))
  local text = pipe:read "a"
  return pipe:close(), text
end

function fmu.must(format, ...)
  local ok, text = fmu.run(format, ...)
  if not ok then error(string.format(format, ...) .. "\n" .. text, 2) end
  return text
end

-- The files of a zip archive without compression: a list of {name =, text =, date =, crc =}.
function fmu.unzip(text)
  local at = text:find("PK\5\6", -22, true)
  assert(at, "no end of a central directory")
  local count, _, place = string.unpack("<I2I4I4", text, at + 10)
  local out = {}
  place = place + 1
  for i = 1, count do
    local mark, method, time, date, crc, packed, size, named, extra, comment, where =
      string.unpack("<c4xxxxxxI2I2I2I4I4I4I2I2I2xxxxxxxxI4", text, place)
    assert(mark == "PK\1\2" and method == 0 and packed == size)
    local name = text:sub(place + 46, place + 45 + named)
    local local_mark, local_named, local_extra = string.unpack("<c4xxxxxxxxxxxxxxxxxxxxxxI2I2", text, where + 1)
    assert(local_mark == "PK\3\4" and text:sub(where + 31, where + 30 + local_named) == name)
    local from = where + 30 + local_named + local_extra
    out[i] = { name = name, text = text:sub(from + 1, from + size), date = date, time = time, crc = crc }
    place = place + 46 + named + extra + comment
  end
  return out
end

local entities = { amp = "&", lt = "<", gt = ">", quot = "\"", apos = "'" }

local function attributes(text)
  local out = {}
  for name, value in text:gmatch "([%w_]+)=\"([^\"]*)\"" do out[name] = value:gsub("&(%a+);", entities) end
  return out
end

local function unpacked(path, version, dir)
  local unit = { version = version, dir = dir, list = {}, by_name = {}, variables = {} }
  for i, f in ipairs(fmu.unzip(assert(program.read(path)))) do
    unit.list[i] = f.name
    fmu.must("mkdir -p '%s/%s'", dir, f.name:match "^(.*)/" or ".")
    program.write(dir .. "/" .. f.name, f.text)
    if f.name:find "%.so$" then unit.binary = dir .. "/" .. f.name end
  end
  unit.xml = program.read(dir .. "/modelDescription.xml")
  unit.token = unit.xml:match(version == 2 and " guid=\"([^\"]*)\"" or " instantiationToken=\"([^\"]*)\"")
  local pattern = version == 2 and "<ScalarVariable ([^>]*)>%s*<Real ([^>]*)/>" or "<Float64 ([^>]*)()/>"
  for head, rest in unit.xml:gmatch(pattern) do
    local a = attributes(head .. (version == 2 and " " .. rest or ""))
    unit.variables[#unit.variables + 1], unit.by_name[a.name] = a, a
  end
  return unit
end

-- Emits and unpacks both versions.
local made = 0
function fmu.make(scene, options)
  made = made + 1
  local dir = program.directory() .. "/unit" .. made
  local ok, text = fmu.run("timeout 60 %s gen '%s' --project fmu -o %s %s", binary, scene, dir, options or "")
  if not ok then return nil, text end
  local name = fmu.must("ls %s", dir):match "([%w_]+)_fmi2%.fmu"
  local units = { dir = dir, name = name }
  for version = 2, 3 do
    units[version] = unpacked(dir .. "/" .. name .. "_fmi" .. version .. ".fmu", version, dir .. "/" .. version)
    units[version].name = name
  end
  return units
end

-- ---- what is in a unit ----

-- The schemas of FMI: in POLHODE_FMI_SCHEMAS, else in ../shared/fmi, as fmi2/*.xsd and fmi3/*.xsd.
local schemas = os.getenv "POLHODE_FMI_SCHEMAS" or "../shared/fmi"
local has_schemas = program.read(schemas .. "/fmi3/fmi3ModelDescription.xsd") ~= nil
local has_xmllint = fmu.run "command -v xmllint"

function fmu.valid(unit, tag)
  local files = { { "modelDescription.xml", "ModelDescription" } }
  if unit.version == 3 then files[2] = { "sources/buildDescription.xml", "BuildDescription" } end
  for _, f in ipairs(files) do
    local name = tag .. ": " .. f[1] .. " is valid"
    if not has_xmllint then
      tap.skip(name, "no xmllint (Debian package libxml2-utils)")
    elseif not has_schemas then
      tap.skip(name, "no schemas in " .. schemas .. " (POLHODE_FMI_SCHEMAS)")
    else
      local ok, text = fmu.run("xmllint --noout --schema %s/fmi%d/fmi%d%s.xsd %s/%s", schemas, unit.version,
        unit.version, f[2], unit.dir, f[1])
      tap.ok(ok, name, text)
    end
  end
end

-- The functions of the standards (FMI 2.0.4, 2.1, 3.2, 4.2; FMI 3.0, chapters 2 to 5).
fmu.functions = { [2] = {}, [3] = {} }
for word in ([[GetTypesPlatform GetVersion SetDebugLogging Instantiate FreeInstance SetupExperiment
  EnterInitializationMode ExitInitializationMode Terminate Reset GetReal GetInteger GetBoolean GetString SetReal
  SetInteger SetBoolean SetString GetFMUstate SetFMUstate FreeFMUstate SerializedFMUstateSize SerializeFMUstate
  DeSerializeFMUstate GetDirectionalDerivative EnterEventMode NewDiscreteStates EnterContinuousTimeMode
  CompletedIntegratorStep SetTime SetContinuousStates GetDerivatives GetEventIndicators GetContinuousStates
  GetNominalsOfContinuousStates SetRealInputDerivatives GetRealOutputDerivatives DoStep CancelStep GetStatus
  GetRealStatus GetIntegerStatus GetBooleanStatus GetStringStatus]]):gmatch "%S+" do
  table.insert(fmu.functions[2], "fmi2" .. word)
end
for word in ([[GetVersion SetDebugLogging InstantiateModelExchange InstantiateCoSimulation
  InstantiateScheduledExecution FreeInstance EnterInitializationMode ExitInitializationMode EnterEventMode Terminate
  Reset GetClock SetClock GetNumberOfVariableDependencies GetVariableDependencies GetFMUState SetFMUState FreeFMUState
  SerializedFMUStateSize SerializeFMUState DeserializeFMUState GetDirectionalDerivative GetAdjointDerivative
  EnterConfigurationMode ExitConfigurationMode GetIntervalDecimal GetIntervalFraction GetShiftDecimal GetShiftFraction
  SetIntervalDecimal SetIntervalFraction SetShiftDecimal SetShiftFraction EvaluateDiscreteStates UpdateDiscreteStates
  EnterContinuousTimeMode CompletedIntegratorStep SetTime SetContinuousStates GetContinuousStateDerivatives
  GetEventIndicators GetContinuousStates GetNominalsOfContinuousStates GetNumberOfEventIndicators
  GetNumberOfContinuousStates EnterStepMode GetOutputDerivatives DoStep ActivateModelPartition]]):gmatch "%S+" do
  table.insert(fmu.functions[3], "fmi3" .. word)
end
for kind in ("Float32 Float64 Int8 UInt8 Int16 UInt16 Int32 UInt32 Int64 UInt64 Boolean String Binary"):gmatch "%S+" do
  table.insert(fmu.functions[3], "fmi3Get" .. kind)
  table.insert(fmu.functions[3], "fmi3Set" .. kind)
end
table.sort(fmu.functions[2])
table.sort(fmu.functions[3])
function fmu.exported(path)
  local list = {}
  for name in fmu.must("nm -D --defined-only %s", path):gmatch " T (%S+)" do list[#list + 1] = name end
  table.sort(list)
  return table.concat(list, " ")
end

-- What the schemas cannot say of the variables.
function fmu.consistent(unit, tag)
  local faults, units = {}, {}
  for name in unit.xml:gmatch "<Unit name=\"([^\"]*)\"" do units[name] = true end
  for i, a in ipairs(unit.variables) do
    if a.valueReference ~= tostring(i - 1) then faults[#faults + 1] = a.name .. " is not reference " .. i - 1 end
    if not units[a.unit] then faults[#faults + 1] = a.name .. " has the unknown unit " .. tostring(a.unit) end
    local starts = a.causality == "parameter" or a.causality == "input" or a.initial == "exact"
    if starts ~= (a.start ~= nil) then faults[#faults + 1] = a.name .. ": start where there must be none, or none" end
    local key = unit.version == 2 and "<Unknown index=\"" .. i .. "\"" or "<Output valueReference=\"" .. i - 1 .. "\""
    local outputs = unit.version == 2 and unit.xml:match "<Outputs>.*</Outputs>" or unit.xml
    if (a.causality == "output") ~= (outputs:find(key, 1, true) ~= nil) then
      faults[#faults + 1] = a.name .. " is an output, or is in the list of outputs, but not both"
    end
  end
  tap.ok(#faults == 0, tag .. ": references, units, starts and outputs belong together", table.concat(faults, "\n"))
end

-- ---- driving it ----

local harness = {}

-- The answers to the commands; $NAME stands for a value reference, TOKEN for the unit's.  other: another binary of the
-- unit, and flags with which the harness is compiled for it.
function fmu.drive(unit, commands, other, flags)
  local key = unit.version .. (flags or "")
  if not harness[key] then
    harness[key] = program.directory() .. "/harness" .. unit.version .. (flags and "_other" or "")
    fmu.must("cc -std=c11 -D_XOPEN_SOURCE=700 -Wall -Wextra -Werror -O1 -DVERSION=%d %s tests/target/fmu.c -o %s -ldl",
      unit.version, flags or "", harness[key])
  end
  local text = table.concat(commands, "\n"):gsub("TOKEN", unit.token):gsub("$([%w_()]+)", function(name)
    return assert(unit.by_name[name], name).valueReference
  end)
  local script = program.directory() .. "/commands"
  program.write(script, text .. "\n")
  local answers, out = {}, fmu.must("timeout 60 %s %s < %s", harness[key], other or unit.binary, script)
  for line in out:gmatch "[^\n]+" do
    local numbers, log = line:match "^(.-) # (.*)$"
    local answer = { log = log or "" }
    for word in (numbers or line):gmatch "%S+" do answer[#answer + 1] = tonumber(word) end
    answer.status = table.remove(answer)
    answers[#answers + 1] = answer
  end
  answers.version = table.remove(answers, 1).status
  return answers
end

-- The general library's motion at a time: {name of a column = number}.
function fmu.general(scene, at, options)
  local text = fmu.must("timeout 60 %s run '%s' --engine general --at %s %s", binary, scene, at, options or "")
  local names, values = text:match "([^\n]+)\n([^\n]+)"
  local out, next_value = {}, values:gmatch "[^,]+"
  for name in names:gmatch "[^,]+" do out[name] = tonumber(next_value()) end
  return out
end

return fmu
