-- fmu.lua -- units for co-simulation: NAME_fmi2.fmu and NAME_fmi3.fmu, zip archives with sources and a binary.
--
-- FMI 2.0.4 and FMI 3.0 (fmi-standard.org).  What both have in common is NAME_unit.c; NAME_fmi2.c and NAME_fmi3.c are
-- the standard's functions.  The token (guid) is a hash of all files: it changes with any of them and nothing else.
-- SPDX-License-Identifier: GPL-3.0-or-later

local hash = require "generator.hash"
local expr = require "generator.algebra.expr"
local state = require "generator.dynamics.state"
local number = require "generator.emit.number"
local functions = require "generator.emit.packages.fmu_functions"
local variables = require "generator.emit.packages.fmu_variables"
local zip = require "generator.emit.packages.zip"
local template = require "generator.emit.template"

local UNIT = template.group("projects/fmu_unit.h", "projects/fmu_unit.c", "projects/fmu_description2.xml",
  "projects/fmu_description3.xml", "projects/fmu_build.xml", "projects/fmu_README.md")
local INTERFACE = template.group("projects/fmu_fmi2.h", "projects/fmu_fmi2.c", "projects/fmu_fmi3.h",
  "projects/fmu_fmi3.c", "projects/fmu_phases.c", "projects/fmu_modes.c", "projects/fmu_states.c",
  "projects/fmu_refused.c")

local fmu = { whole = true, layout = "single" }

-- The closed form drives the unit where it is asked for first, or planned, and gives the whole state.
local function exact(job)
  local asked = job.methods and job.methods[1] == "exact"
  return (asked or job.planned ~= nil and job.planned.setting == "none") and job.closed.full or false
end

function fmu.check(job)
  if job.methods and job.methods[1] == "exact" and not job.closed.full then
    job.diag:error(job.record.line, "project fmu", "method exact must have a closed form of the whole state",
      "one that " .. (job.closed.part or "is not there"))
    return false
  end
  for _, p in ipairs(job.model.params) do
    if string.find(string.upper(p.name), "^UNIT_") then
      job.diag:error(p.line, "project fmu", "a parameter's name must not begin with unit_", string.format("%q", p.name))
      return false
    end
  end
  return true
end

-- Text inside a C string literal; ? is marked because ??/ is a trigraph.
local function literal(s)
  return (string.gsub(string.gsub(s, "[\\\"?]", "\\%0"), "%c", " "))
end

local function wrapped(words)
  local out, line = {}, ""
  for i, w in ipairs(words) do
    local word = w .. (i < #words and "," or "")
    if #line + #word > 100 then
      out[#out + 1] = line
      line = word
    else
      line = line == "" and word or line .. " " .. word
    end
  end
  out[#out + 1] = line
  return out
end

-- Does the time stand in the equations of motion?
local function timed(eq)
  for _, g in ipairs(eq.groups) do
    for _, list in ipairs { g.defs, g.outs } do
      for _, x in ipairs(list) do
        for _, s in ipairs(expr.symbols(x.expr)) do
          if s == state.t then return true end
        end
      end
    end
  end
  return false
end

local ways = {
  stepper = { method = " by whole inner steps of h and a shorter last one",
    tolerance = "the inner step is fixed" },
  planned = { method = " by the method that was planned", tolerance = "the method was planned for an accuracy" },
  exact = { method = " by the closed form, from the start each time", tolerance = "the closed form knows no steps" },
}

-- The values of what both versions share; what their functions say of the tolerance.
local function values_of(job, made)
  local way = exact(job) and "exact" or job.planned and "planned" or "stepper"
  local m, base = job.model, made.base
  local v = { exact = way == "exact", planned = way == "planned", stepper = way == "stepper",
    timed = timed(job.equations), method = ways[way].method,
    derivatives = job.jacobians or false, derivatives_text = job.jacobians and "true" or "false",
    rates_text = job.jacobians and ", their rates of change" or "", integral = job.conserved.rate ~= nil,
    momentum = m.has.rates, momentum_function = base.has_attitude and "momentum" or "momentum_body",
    most = job.real == "float" and "3.4028234663852886e+38" or "1.7976931348623157e+308", checks = {}, token = "",
    title_attribute = variables.attribute("description", job.title),
    scene_file = string.gsub(variables.escaped(job.source), "%-%-+", "-"), -- no -- in a comment of XML
    tool = variables.attribute("generationTool", "polhode " .. job.build),
    stop_time = number.decimal(m:number(m.horizon), "double"), step_size = number.decimal(m:number(m.step), "double") }
  for i, c in ipairs(made.parts.init.checks) do v.checks[i] = literal(c.text) end
  local names, settable = {}, {}
  for i, x in ipairs(variables.fill(job, v)) do
    names[i] = "\"" .. literal(x.name) .. "\""
    if x.state then settable[x.state] = x.initial == "exact" and "1" or "0" end
  end
  v.names, v.settable = wrapped(names), table.concat(settable, ", ")
  return v, ways[way].tolerance
end

-- What the standards call alike things.
local WORDS = { ["2"] = { fmi = "fmi2", component = "fmi2Component", whole = "FMUstate", de = "DeSerialize" },
  ["3"] = { fmi = "fmi3", component = "fmi3Instance", whole = "FMUState", de = "Deserialize" } }

-- The two files of a version: the standard's header and its functions.
local function interface(job, base, version, shared, tolerance)
  local words = WORDS[version]
  local v = { token = shared.token, tolerance = tolerance, derivatives = shared.derivatives,
    fmi = words.fmi, component = words.component, whole = words.whole, de = words.de }
  v.functions, v.refused = functions.of(version, { derivatives = shared.derivatives })
  local render = INTERFACE(job.templates, base, v)
  local function part(name) return (string.gsub(render("projects/fmu_" .. name .. ".c"), "\n$", "")) end
  v.phases, v.modes, v.states, v.refusals = part "phases", part "modes", part "states", part "refused"
  local stem = "projects/fmu_fmi" .. version
  return render(stem .. ".h"), render(stem .. ".c")
end

function fmu.files(job, made)
  local name = job.model.name
  local v, tolerance = values_of(job, made)
  local render = UNIT(job.templates, made.base, v)
  local function all()
    local files = {}
    local function put(file, text) files[#files + 1] = { name = file, text = text } end
    for _, tail in ipairs { "_unit.h", "_unit.c" } do put(name .. tail, render("projects/fmu" .. tail)) end
    for _, version in ipairs { "2", "3" } do
      local header, source = interface(job, made.base, version, v, tolerance)
      put(name .. "_fmi" .. version .. ".h", header)
      put(name .. "_fmi" .. version .. ".c", source)
    end
    put("modelDescription2.xml", render "projects/fmu_description2.xml")
    put("modelDescription3.xml", render "projects/fmu_description3.xml")
    put("buildDescription.xml", render "projects/fmu_build.xml")
    put("README.md", render "projects/fmu_README.md")
    return files
  end
  local texts = { made.header, made.source }
  for _, f in ipairs(all()) do texts[#texts + 1] = f.text end
  local four = "(%x%x%x%x)" -- written as a GUID is: 8-4-4-4-12
  v.token = "{" .. string.gsub(hash.of(table.concat(texts, "\0")), "^(%x%x%x%x%x%x%x%x)" .. four .. four .. four,
    "%1-%2-%3-%4-") .. "}"
  return all()
end

-- What kind of binary the compiler has made: bytes 0x04 and 0x12 of an ELF header (class, machine) and the names that
-- the standards give its platform (FMI 2.0.4, 2.3; FMI 3.0, Platform Tuple Definition).
local platforms = { ["\2\62\0"] = { "linux64", "x86_64-linux" }, ["\1\3\0"] = { "linux32", "x86-linux" },
  ["\2\183\0"] = { nil, "aarch64-linux" } }

local compiling = { "-c", "-fPIC", "-O2", "-std=c99", "-ffp-contract=off", "-fvisibility=hidden", "-fno-ident",
  "-ffunction-sections", "-fdata-sections", "-DFMI2_OVERRIDE_FUNCTION_PREFIX", "-DFMI3_OVERRIDE_FUNCTION_PREFIX" }
-- no identifier of this build, no symbols but those that are exported: same sources, same compiler, same bytes
local linking = { "-shared", "-Wl,--gc-sections", "-Wl,--build-id=none", "-Wl,--no-undefined", "-Wl,--as-needed", "-s" }

-- Runs the compiler for each of the list {sources, output, options}; an error's text, or nil.
local function compile(host, dir, list)
  local items = {}
  for i, x in ipairs(list) do items[i] = { dir, x[1], x[2], x[3] } end
  for _, made in ipairs(host.compile_many(items)) do
    if not made.command then return "the unit's binary does not compile:\n" .. made.message end
  end
end

-- The binaries of both versions from the sources in dir: {[2] = text, [3] = text} | nil, what went wrong.
local function binaries(host, dir, name)
  local objects, links, out = {}, {}, {}
  for i, tail in ipairs { "", "_unit", "_fmi2", "_fmi3" } do
    objects[i] = { { name .. tail .. ".c" }, name .. tail .. ".o", { flags = compiling } }
  end
  for version = 2, 3 do
    local d = string.format("%d", version)
    links[version - 1] = { { name .. ".o", name .. "_unit.o", name .. "_fmi" .. d .. ".o" }, name .. d .. ".so",
      { flags = linking, libs = { "-lm" } } }
  end
  local why = compile(host, dir, objects) or compile(host, dir, links)
  if why then return nil, why end
  for version = 2, 3 do
    out[version], why = host.read(dir .. "/" .. links[version - 1][2])
    if not out[version] then return nil, why end
  end
  return out
end

-- The name of its platform in the standard of the version, or nil.
local function platform_of(binary, version)
  local kind = string.sub(binary, 1, 4) == "\127ELF" and
    platforms[string.sub(binary, 5, 5) .. string.sub(binary, 19, 20)]
  return kind and kind[version - 1]
end

-- Compiles and packs.  Where the standard has no name for the machine, the unit has sources only.
function fmu.finish(host, job, files)
  local name, text = job.model.name, {}
  for _, f in ipairs(files) do text[f.name] = f.text end
  local dir, why = host.tempdir()
  if not dir then return nil, why end
  local ok
  ok, why = host.write_files(dir, files)
  if not ok then return nil, why end
  local made, failed = binaries(host, dir, name)
  if not made then return nil, failed end
  local out = {}
  for version = 2, 3 do
    local so, platform = made[version], platform_of(made[version], version)
    local d = string.format("%d", version)
    local list = { { name = "modelDescription.xml", text = text["modelDescription" .. d .. ".xml"] } }
    if platform then list[2] = { name = "binaries/" .. platform .. "/" .. name .. ".so", text = so } end
    for _, tail in ipairs { ".h", ".c", "_unit.h", "_unit.c", "_fmi" .. d .. ".h", "_fmi" .. d .. ".c" } do
      list[#list + 1] = { name = "sources/" .. name .. tail, text = text[name .. tail] }
    end
    if version == 3 then
      list[#list + 1] = { name = "sources/buildDescription.xml", text = text["buildDescription.xml"] }
    end
    out[#out + 1] = { name = name .. "_fmi" .. d .. ".fmu", text = zip.archive(list) }
  end
  out[#out + 1] = { name = "README.md", text = text["README.md"] }
  return out
end

return fmu
