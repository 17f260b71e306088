-- calls.lua -- a program that calls each function of an emitted scene, for an emulator to count.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     calls.modules(job, files)  the emitted files with functions of the scene: {stem =, header =, source =}, and
--                                private = what they share, if there is such a file
--     calls.of(job, modules)     {list =, when =, step = (text), program = (C)}, the list of
--                                {name =, symbol =, text = (of the call) or nil, why = (it is not called)}
-- The functions are read from the emitted headers' prototypes, so none is forgotten; what an argument is given is
-- decided by its type and name.  State: the scene's initial one; t: a time within its horizon; h: its step.  What goes
-- from one time to another goes one step, with a tolerance of 1e-6.  templates/target/calls.c is not emitted.

local R = require "generator.algebra.rational"
local base_values = require "generator.emit.base"
local number = require "generator.emit.number"
local template = require "generator.emit.template"

local GROUP = template.group "target/calls.c"

local calls = {}

local WITHIN = "309/500" -- of the horizon: the golden section, at no special point of anything

-- Numbers by their arguments' names; other reals are `spin`, other integers 1.
local reals = { dt = "step", t = "when", t0 = "when", t1 = "when + step", h = "step", tolerance = "tolerance" }
local integers = { window = "64", n = "2", most = "1000", axis = "2", k = "2" }

-- In steps of real numbers, and of integers (gen --with q31); what is made of them for a host alone is left out.
function calls.modules(job, files)
  local list, by_name = {}, {}
  for _, f in ipairs(files) do by_name[string.match(f.name, "[^/]*$")] = f.text end
  for _, tail in ipairs { "", "_orbit", "_estimator", "_analysis", "_attitude", "_batch", "_q31" } do
    local stem = job.model.name .. tail
    if by_name[stem .. ".c"] then
      list[#list + 1] = { stem = stem, header = by_name[stem .. ".h"], source = by_name[stem .. ".c"] }
    end
  end
  list.private = by_name[job.model.name .. "_private.h"]
  return list
end

-- Adds {symbol, name, {arguments as text}} of the functions that the module declares and defines, in its order.
local function prototypes(module, name, list)
  local text = string.gsub(string.gsub(module.header, "/%*.-%*/", " "), "%s+", " ")
  for f, arguments in string.gmatch(text, "[%w_]+ %*?(" .. name .. "_[%w_]+) ?%(([^()]*)%) ?;") do
    local own = {}
    for a in string.gmatch(arguments .. ",", " *(.-) *,") do own[#own + 1] = a end
    if string.find(module.source, f .. "%([^;{]*%)%s*{") then
      list[#list + 1] = { symbol = f, name = string.sub(f, #name + 2), arguments = own }
    end
  end
end

-- Numbers that an array takes: of [n], of [NAME_NX*NAME_NP] or [] alone.
-- [] and [] behind a name that is not known: NX*NX, the most that any function writes.
local function room(brackets, job)
  local of = { NX = #job.states, NP = #job.model.params, NU = #job.model.inputs }
  local n = 1
  for word in string.gmatch(brackets, "[%w_]+") do
    n = n * (math.tointeger(tonumber(word)) or of[string.match(word, "_(%u+)$")] or #job.states)
  end
  return n > 1 and n or brackets ~= "[1]" and #job.states * #job.states or 1
end

-- What is given for the argument a of the call; nil for one of no known type.  The call's `out` counts the numbers that
-- it writes, `vectors` the given ones.
local function value(job, call, a)
  local const, rest = string.match(a, "^(const) (.*)$")
  local base, pointer, name, brackets = string.match(rest or a, "^([%w_]+) ?(%*?)([%w_]+) ?([%[%]%w_*]*)$")
  if not base then return nil end
  local kind = string.match(base, "^" .. job.model.name .. "_(%w+)$") or base
  if pointer == "*" and (kind == "model" or kind == "orbit") and brackets == "" then return "&" .. kind end
  if pointer == "*" and kind == "estimator" then -- one whose window is complete, but for samples
    return string.find(call.name, "_add$") and "&estimator" or "&complete"
  end
  if pointer == "" and brackets == "" then
    if kind == "real" then return reals[name] or "spin" end
    if kind == "int64_t" then return "1234567" end
    return kind == "int" and (integers[name] or "1") or nil
  end
  if kind == "int32_t" and name == "x" then return "whole" end
  if kind == "int32_t" and name == "u" then return job.equations.inputs and "whole_input" or "0" end
  if kind ~= "real" then return nil end
  if string.find(brackets, "%]%[") then
    call.series = true
    return "series"
  elseif name == "u" then
    return job.equations.inputs and "input" or "0"
  elseif name == "p" then
    return call.defaults and "parameters" or "0" -- NULL: the scene's own
  elseif name == "x" or name == "x0" then
    return "state"
  elseif const and (name == "sigma" or name == "error") then
    return "errors"
  elseif const then
    if brackets == "[]" then return name == "t" and "times" or nil end
    if brackets == "[6]" then return "tensor" end
    if brackets == "[3]" and name == "I" then return "moments" end
    if brackets ~= "[3]" then return nil end
    call.vectors = call.vectors + 1
    return string.format("vectors[%d]", call.vectors - 1)
  end
  local at = call.out
  call.out = at + (pointer == "*" and 1 or room(brackets, job))
  return string.format("out + %d", at)
end

-- What a function says by its result: these are 0 if all is well.
local answers = { init = true, solve = true, set_tick = true }

-- The call as text, or why it cannot be made.  defaults: are the parameters filled in?
local function prepare(job, f, defaults)
  local call, given = { name = f.name, symbol = f.symbol, out = 0, vectors = 0, defaults = defaults }, {}
  for i, a in ipairs(f.arguments) do
    given[i] = value(job, call, a)
    if not given[i] then
      call.why = "argument " .. a
      return call
    end
  end
  call.text = (answers[f.name] and "bad |= " or "(void)") .. f.symbol .. "(" .. table.concat(given, ", ") .. ")"
  return call
end

function calls.of(job, modules)
  local m, list, has, declared = job.model, {}, {}, {}
  local v = { calls = {}, has_series = false, has_whole = false, has_orbit = false, stems = {},
    has_defaults = false }
  for i, module in ipairs(modules) do
    prototypes(module, m.name, declared)
    v.stems[i] = module.stem or m.name
    v.has_defaults = v.has_defaults or
      #m.params > 0 and string.find(module.header, m.name .. "_defaults(", 1, true) ~= nil
    v.has_whole = v.has_whole or v.stems[i] == m.name .. "_q31"
    v.has_orbit = v.has_orbit or string.find(module.header, "} " .. m.name .. "_orbit;", 1, true) ~= nil
  end
  local out, vectors = 1, 1
  for i, f in ipairs(declared) do
    local call = prepare(job, f, v.has_defaults)
    list[i], has[f.name] = call, true
    if call.text then
      v.calls[#v.calls + 1] = { text = call.text }
      out, vectors = math.max(out, call.out), math.max(vectors, call.vectors)
      v.has_series = v.has_series or call.series or false
    end
  end
  local when = m:number(m.horizon) * R.lift(WITHIN)
  v.has_inertia, v.has_principal = has.inertia or false, has.principal or false
  v.has_estimator = has.estimator_add or false
  v.out, v.vectors = string.format("%d", out), string.format("%d", vectors)
  v.when, v.step = number.text(when, job.real), number.text(m:number(m.step), job.real)
  return { list = list, when = number.text(when, "double"), step = number.text(m:number(m.step), "double"),
    program = GROUP(job.templates, base_values.of(job, false), v) "target/calls.c" }
end

return calls
