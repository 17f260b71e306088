-- readme.lua -- what the README of an emitted scene says of its files, costs and use.
--
--     readme.render(job, made, about) -> text
-- SPDX-License-Identifier: GPL-3.0-or-later

local functions = require "generator.emit.functions"
local number = require "generator.emit.number"
local selftest = require "generator.emit.selftest"
local template = require "generator.emit.template"
local selection = require "generator.selection"

local GROUP = template.group "projects/README.md"

local readme = {}

local PURPOSE = { { "motion", "the motion: state, parameters, set-up, steps, energy and momentum" },
  { "orbit", "the motion in closed form" },
  { "analysis", "what can be asked of the body, and derivatives" } }

local function rows(made, header_only)
  local has, out, name = {}, {}, made.base.name
  for _, list in ipairs { made.names.headers, made.names.sources } do
    for _, file in ipairs(list) do has[file] = true end
  end
  local function names(stem)
    local list = {}
    for _, tail in ipairs { ".h", ".c" } do
      if has[stem .. tail] then list[#list + 1] = stem .. tail end
    end
    return table.concat(list, ", ")
  end
  for _, p in ipairs(PURPOSE) do
    local list = names(name .. selection.tails[p[1]])
    if list ~= "" then out[#out + 1] = { names = list, about = p[2] } end
  end
  if has[name .. "_private.h"] then
    out[#out + 1] = { names = name .. "_private.h",
      about = "arithmetic that is equal for every body, and what these files share; no part of the interface" }
  end
  if header_only then
    out[1].about = out[1].about .. "; the code too, behind " .. made.base.upper .. "_IMPLEMENTATION"
  end
  out[#out + 1] = { names = name .. "_test.c", about = string.format("self-test with expected numbers of %d bits; " ..
    "prints TAP; runs on the target too", selftest.bits) }
  return out
end

local function example(made, header_only, horizon)
  local v, offers = made.base, made.offers
  local out, p = {}, v.name .. "_"
  local function put(...) out[#out + 1] = string.format(...) end
  if header_only then put("#define %s_IMPLEMENTATION  /* in one file of the program */", v.upper) end
  for _, h in ipairs(made.names.public) do put("#include \"%s\"", h) end
  put("")
  put("%smodel m;", p)
  put("%sreal x[%s_NX];", p, v.upper)
  put("")
  if offers.init then
    put("if (%sinit(&m, 0) != 0) { /* a parameter is out of range: the header lists the checks */ }", p)
  end
  if offers.initial then put("%sinitial(&m, x);", p) end
  if offers.step then
    if v.has_inputs then
      put("%sreal u[%s_NU] = {0};  /* the input: the scene has one, so u must not be NULL */", p, v.upper)
    end
    put("%sstep(&m, 0, x, %s, %s);  /* one step of %s s */", p, v.has_inputs and "u" or "0", v.step_literal,
      v.step_text)
  end
  local at = offers.at and "at" or offers.at_rates and "at_rates"
  if offers.solve and offers.at_centre then
    put("")
    put("%sorbit o;", p)
    put("%sreal p[2], v[2], W[3];", p)
    put("%ssolve(&o, &m, x);", p)
    put("%sat_centre(&o, %s, p, v, W);  /* the centre of mass and the spin at %s s, in one evaluation */", p,
      v.horizon_literal, horizon)
  end
  if offers.solve and at then
    put("")
    put("%sorbit o;", p)
    put("%ssolve(&o, &m, x);", p)
    put("%s%s(&o, %s, %s);  /* the %s at %s s, in one evaluation */", p, at, v.horizon_literal,
      at == "at" and "x" or "x + " .. v.upper .. "_WX", at == "at" and "state" or "rates", horizon)
  end
  return out
end

-- The cost sheet's rows (report/costs.lua): the table of cycles, and operations of what is a template.
local function sheet(job, made, v)
  local known = {}
  v.costs, v.sheet = {}, {}
  for _, f in ipairs(made.costs) do
    if made.offers[f.name] then v.costs[#v.costs + 1] = f end
    known[f.name] = true
  end
  local counted, names = job.sheet()
  for _, row in ipairs(counted) do
    if made.offers[row.name] then
      v.sheet[#v.sheet + 1] = { name = row.name, cycles = table.concat(row.cycles, " | ") }
      if not known[row.name] then v.costs[#v.costs + 1] = functions.cost_row(row.name, row.counts) end
    end
  end
  v.sheet_head, v.sheet_rule = table.concat(names, " | "), string.rep("---|", #names)
  v.has_sheet = #v.sheet > 0
  v.counted = job.counted_lines()
  v.is_counted = #v.counted > 0
end

-- made: from code.of; about: {files, use: of the package (emit/packages/), lists}
function readme.render(job, made, about)
  local header_only = job.layout == "header"
  local horizon = number.text(job.model:number(job.model.horizon), "double")
  local v = { rows = rows(made, header_only), example = example(made, header_only, horizon),
    derivation = job.derivation, q31 = job.q31 ~= nil, files = about.files or {}, use = about.use or {},
    flat = not job.package.arrange, -- all files in one folder
    source_words = table.concat(made.names.sources, " "),
    links_m = made.links_m and " -lm" or "", no_errno = readme.no_errno(made),
    link_words = made.links_m and "sin, exp and their kin are in the library m" or "no library is needed" }
  sheet(job, made, v)
  return GROUP(job.templates, made.base, v) "projects/README.md"
end

function readme.no_errno(made) return made.ctx.own and " -fno-math-errno" or "" end

return readme
