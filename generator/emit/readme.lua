-- readme.lua -- what the README of an emitted scene says of its files, costs and use.
--
--     readme.fill(job, v)     file_rows, example, costs and the sheet of cycles; v.offers: the functions there are
-- SPDX-License-Identifier: GPL-3.0-or-later

local values = require "generator.emit.values"
local selection = require "generator.selection"

local readme = {}

local PURPOSE = { { "motion", "the motion: state, parameters, set-up, steps, energy and momentum" },
  { "orbit", "the motion in closed form" },
  { "analysis", "what can be asked of the body, and derivatives" } }

local function rows(v)
  local has, out = {}, {}
  for _, list in ipairs { v.headers, v.sources } do
    for _, name in ipairs(list) do has[name] = true end
  end
  local function names(stem)
    local list = {}
    for _, tail in ipairs { ".h", ".c" } do
      if has[stem .. tail] then list[#list + 1] = stem .. tail end
    end
    return table.concat(list, ", ")
  end
  for _, p in ipairs(PURPOSE) do
    local list = names(v.name .. selection.tails[p[1]])
    if list ~= "" then out[#out + 1] = { names = list, about = p[2] } end
  end
  if has[v.name .. "_private.h"] then
    out[#out + 1] = { names = v.name .. "_private.h", about = "what these files share; no part of the interface" }
  end
  if v.header_only then out[1].about = out[1].about .. "; the code too, behind " .. v.upper .. "_IMPLEMENTATION" end
  out[#out + 1] = { names = v.name .. "_test.c", about = "self-test with expected numbers of " .. v.bits ..
    " bits; prints TAP; runs on the target too" }
  return out
end

local function example(v)
  local out, p = {}, v.name .. "_"
  local function put(...) out[#out + 1] = string.format(...) end
  if v.header_only then put("#define %s_IMPLEMENTATION  /* in one file of the program */", v.upper) end
  for _, h in ipairs(v.public_headers) do put("#include \"%s\"", h) end
  put("")
  put("%smodel m;", p)
  put("%sreal x[%s_NX];", p, v.upper)
  put("")
  if v.offers.init then
    put("if (%sinit(&m, 0) != 0) { /* a parameter is out of range: the header lists the checks */ }", p)
  end
  if v.offers.initial then put("%sinitial(&m, x);", p) end
  if v.offers.step then
    if v.has_inputs then
      put("%sreal u[%s_NU] = {0};  /* the input: the scene has one, so u must not be NULL */", p, v.upper)
    end
    put("%sstep(&m, 0, x, %s, %s);  /* one step of %s s */", p, v.has_inputs and "u" or "0", v.step_literal,
      v.step_text)
  end
  local at = v.offers.at and "at" or v.offers.at_rates and "at_rates"
  if v.offers.solve and at then
    put("")
    put("%sorbit o;", p)
    put("%ssolve(&o, &m, x);", p)
    put("%s%s(&o, %s, %s);  /* the %s at %s s, in one evaluation */", p, at, v.horizon_literal,
      at == "at" and "x" or "x + " .. v.upper .. "_WX", at == "at" and "state" or "rates", v.horizon_text)
  end
  return out
end

-- The cost sheet's rows (report/costs.lua): the table of cycles, and operations of what is a template.
local function sheet(job, v)
  local list, known = {}, {}
  for _, f in ipairs(v.costs) do
    if v.offers[f.name] then list[#list + 1] = f end
    known[f.name] = true
  end
  v.sheet = {}
  local counted, names = job.sheet()
  for _, row in ipairs(counted) do
    if v.offers[row.name] then
      v.sheet[#v.sheet + 1] = { name = row.name, cycles = table.concat(row.cycles, " | ") }
      if not known[row.name] then list[#list + 1] = values.cost_row(row.name, row.counts) end
    end
  end
  v.costs = list
  v.sheet_head, v.sheet_rule = table.concat(names, " | "), string.rep("---|", #names)
  v.has_sheet = #v.sheet > 0
  v.counted = job.counted_lines()
  v.is_counted = #v.counted > 0
end

function readme.fill(job, v)
  v.file_rows, v.example = rows(v), example(v)
  sheet(job, v)
end

return readme
