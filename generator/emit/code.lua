-- code.lua -- header and source of a scene, in files by their purpose.
--
--     code.of(job) -> made:
--       files         list of {name =, text =}
--       header, source      all of them in one, with the scene's prefix everywhere, for what counts and calls the
--                     functions
--       functions     all public ones: {name, room, asked, lines, uses}; offers: those asked for, a set of short names
--       parts         what they were made of (parts_of): guard, proof, stepper, closed, stability, init
--       costs         rows of the README's table
--       names         of the files: lists headers, public (headers), sources, stems (of sources)
--       links_m       must it be linked with -lm?
--       base, ctx     for templates beside the code (emit/base.lua, the C library's functions), for emit/source.lua
-- job.layout: "split": NAME (the motion), NAME_orbit (the closed form), NAME_analysis, NAME_private.h (what several of
-- them share, and arithmetic that is equal for every body), each only where there is something in
-- it; "single": one header and one source; "header": one header, whose implementation stands behind a macro.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local R = require "generator.algebra.rational"
local analysis = later "generator.emit.analysis"
local base_values = require "generator.emit.base"
local batch = later "generator.emit.batch"
local baked = require "generator.emit.baked"
local closed = require "generator.emit.closed"
local columns = require "generator.emit.columns"
local disc = later "generator.emit.disc"
local estimator = later "generator.emit.estimator"
local functions = require "generator.emit.functions"
local guard = require "generator.emit.guard"
local head = require "generator.emit.head"
local init = require "generator.emit.init"
local layout = require "generator.emit.layout"
local libm = require "generator.emit.libm"
local number = require "generator.emit.number"
local plain = require "generator.emit.plain"
local proof = require "generator.emit.proof"
local source = require "generator.emit.source"
local special = require "generator.emit.special"
local split = require "generator.emit.split"
local stability = require "generator.emit.stability_signs"
local steppers = require "generator.emit.steppers"
local template = require "generator.emit.template"
local selection = require "generator.selection"

local FILES = template.group("core/scene.h", "core/scene.c", "core/part.h", "core/part.c", "core/private.h",
  "core/implementation.c", "core/preamble.c")
local PLAIN = template.group("core/normalise.h", "core/normalise.c", "numeric/exact.c")
local ATTITUDE = template.group("core/attitude.h", "core/attitude.c")

local code = {}

-- The headers of the C library that a text needs, less those that it already has.
local function includes(text, already)
  local list, has = {}, {}
  for _, name in ipairs(already or {}) do has[name] = true end
  for _, h in ipairs { { "<stddef.h>", "size_t" }, { "<stdint.h>", "int8_t", "int16_t", "int32_t", "int64_t" } } do
    local needed = false
    for i = 2, has[h[1]] and 0 or #h do
      needed = needed or plain.has(text, h[i]) and (plain.word(text, h[i]) or plain.word(text, "u" .. h[i]))
    end
    if needed then list[#list + 1] = h[1] end
  end
  return list
end

-- What is made before the texts are put together, in the order in which functions are printed.
-- unread: set of members that no function reads, or nil.
local function parts_of(job, ctx, base, unread)
  local m = job.model
  local p = { functions = functions.of(job, ctx), helpers = {} }
  p.init = init.of(ctx, m, job.selection.asked "step", unread)
  for name in pairs(ctx.helpers) do p.helpers[name] = true end -- a set: any order
  p.special = special.used(ctx)
  p.stability = stability.of(ctx, job.stability)
  p.order = p.stability.order ~= nil
  p.setup_code = split.needs_setup(job) and init.check_setup(p.init.checks) or nil
  p.step_code = job.selection.asked "step" and init.check_step(p.init.checks, m, base.step_text) or nil
  p.kept = init.kept(m, unread)
  p.real_members = init.real_members(p.kept, p.setup_code ~= nil)
  p.no_members = #p.kept == 0 and not p.order and not p.setup_code
  p.defaults = head.defaults(m, ctx.real)
  p.closed = closed.render(job, base, ctx)
  p.stepper = steppers.render(job, base, ctx)
  p.guard = guard.of(job, base)
  p.proof = proof.of(job, base, p.order)
  return p
end

-- The attitude in other numbers.  Below `singular` the length of two components of a unit quaternion is rounding.
local function attitude(job, ctx, base)
  local digits = base_values.digits[ctx.real]
  local render = ATTITUDE(job.templates, base, { singular = number.text(R.new(2) ^ (3 - digits), ctx.real),
    pi = number.text(R.apply("pi", digits + 8), ctx.real) })
  return render "core/attitude.h", render "core/attitude.c"
end

-- The texts in the order of the C: what stands first is used by what follows.
local function fragments(job, p, ctx, base)
  local list, has, templates = {}, job.model.has, job.templates
  local function put(room, declared, defined, general)
    list[#list + 1] = { header = declared or "", source = defined or "", room = room, general = general }
  end
  local function bare(name) return PLAIN(templates, base, {})(name) end
  local few = p.closed and job.closed.pairs or nil -- nil: all the arithmetic of pairs
  local pair = (p.special or has.rates or p.closed) and
    special.pair(templates, base, few ~= "few" or p.special, few == nil or p.special)
  local sums = p.order and p.stability.order.sums or job.closed.exact
  if pair and (p.special or sums) then put("motion", nil, pair, true) end
  if p.special then put("motion", nil, special.text(templates, base, ctx, p.helpers), true) end
  if sums then put("motion", nil, bare "numeric/exact.c", true) end
  if p.order then put("motion", nil, stability.order(p.stability, job, base)) end
  put("motion", init.fragment(p.init, job, base, p))
  put("motion", functions.fragment(p.functions, templates, base))
  if has.attitude then put("motion", bare "core/normalise.h", bare "core/normalise.c") end
  if pair and not (p.special or sums) then put("motion", nil, pair, true) end
  local s, axes = job.selection, nil
  if has.attitude and selection.attitude(s.asked) then put("motion", attitude(job, ctx, base)) end
  local studied = has.rates and (s.asked "stability" or s.asked "spin_stable" or s.asked "linearised")
  local called = { p.stepper.source }
  for i, part in ipairs(p.closed and p.closed.parts or {}) do called[i + 1] = part.text end
  -- also of splitting methods and of the closed form of a tensor with products
  if has.rates and (studied or s.asked "principal" or s.asked "principal_of" or
    string.find(table.concat(called), "_principal", 1, true)) then
    local defined
    axes, defined = analysis.principal(job, base, ctx)
    put("analysis", nil, defined)
  end
  if p.closed then
    put("orbit", p.closed.header)
    for _, part in ipairs(p.closed.parts) do put("orbit", nil, part.text, part.general) end
  end
  if p.stepper.source ~= "" then put("motion", p.stepper.header, p.stepper.source) end
  if job.batch then
    local declared, defined
    declared, defined, p.each = batch.texts(job, ctx, base, p) -- each: are there functions of a model a body?
    if declared then put("batch", declared, defined) end
  end
  if (job.estimator or s.estimator) and has.rates then put("estimator", estimator.texts(job, ctx, base)) end
  if p.guard then put("motion", p.guard.header, p.guard.source) end
  if axes then put("analysis", axes) end
  if studied then
    put("analysis", analysis.rest(job, base))
    if p.stability.say then put("analysis", stability.fragment(p.stability, job, base)) end
  end
  if job.disc then put("analysis", disc.texts(job, base, ctx)) end
  local all = {}
  for i, f in ipairs(list) do all[i] = f.source end
  local text = table.concat(all, "\n")
  local constants = baked.lines(job, ctx, text)
  if constants[1] then
    local heading = "/* ---- constants: the scene's parameters are in them ---- */\n\n"
    table.insert(list, 1, { header = "", room = "motion", source = heading .. table.concat(constants, "\n") .. "\n" })
  end
  local own = ctx.own and libm.source(base, ctx, templates, text) or ""
  if own ~= "" then table.insert(list, 1, { header = "", source = own, room = "motion", general = true }) end
  return list
end

local ABOUT = { batch = "many bodies at once", orbit = "its motion in closed form",
  estimator = "its tensor of inertia from a gyro", analysis = "what can be asked of the body, and derivatives" }

-- All that is called for, sorted by file: see emit/layout.lua.
local function sorted(job, p, ctx, base)
  local prefix, s = ctx.name .. "_", job.selection
  local function short(name) return string.sub(name, #prefix + 1) end
  local function asked(name)
    local own = short(name)
    return s.asked(own) or own == "init" and not p.no_members
  end
  local function room(name, of)
    return job.layout == "split" and selection.room(short(name), of) or "motion"
  end
  local list = fragments(job, p, ctx, base)
  local keeps = job.layout == "header" or job.proof -- several in one program; Frama-C's options name functions
  return layout.sort(ctx.name, ctx.type, list, asked, room, keeps)
end

-- Renders a file of the scene: what head.lua says, and the file's own.
local function renderer(job, base, about)
  return function(name, own)
    local v = {}
    for k, x in pairs(about) do v[k] = x end -- into a table: order is lost anyway
    for k, x in pairs(own) do v[k] = x end -- into a table: order is lost anyway
    return FILES(job.templates, base, v)(name)
  end
end

-- Those that a user includes.
local function headers_of(names)
  local out = {}
  for _, name in ipairs(names) do
    if not string.find(name, "_private.h", 1, true) then out[#out + 1] = name end
  end
  return out
end

-- The files, and all code in one as plain texts.
local function written(job, all, ctx, base, about)
  local render, header_only = renderer(job, base, about), job.layout == "header"
  local out = { files = {}, sources = {}, headers = {}, stems = {} }
  local texts, used = { header = {}, source = {} }, {}
  local function put(name, text) out.files[#out.files + 1] = { name = name, text = columns.fit(text) } end
  local function add(name, list) list[#list + 1] = name end
  local function library(text, already)
    local list = includes(text, already)
    if libm.included(ctx, text) then table.insert(list, 1, "<math.h>") end
    for _, h in ipairs(list) do used[h] = true end
    return list
  end
  local function preamble(list, declares_real)
    if #list == 0 and not declares_real then return "" end
    return render("core/preamble.c", { source_includes = list, declares_real = declares_real })
  end
  local has_private = all.private ~= ""
  if has_private then
    put(ctx.name .. "_private.h", render("core/private.h", { definitions = all.private,
      preamble = preamble(library(all.private), all.real == "real") }))
    add(ctx.name .. "_private.h", out.headers)
    add(all.plain_private, texts.source)
  end
  for _, r in ipairs(all.order) do
    local own, stem, main = all.rooms[r], ctx.name .. selection.tails[r], r == "motion"
    local v = { file = stem, file_upper = string.upper(stem), about_file = ABOUT[r] or "",
      has_private = own.reads_private == true, declarations = own.header, definitions = own.source, own_includes = {},
      header_includes = includes(own.header), header_only = header_only }
    for _, h in ipairs(v.header_includes) do used[h] = true end
    v.preamble = preamble(library(own.source, v.header_includes), all.real == "real" and not own.reads_private and
      not header_only)
    for _, other in ipairs { "orbit", "analysis" } do
      if own.calls[other] and other ~= r then add(ctx.name .. selection.tails[other] .. ".h", v.own_includes) end
    end
    v.implementation = header_only and render("core/implementation.c", v) or ""
    put(stem .. ".h", render(main and "core/scene.h" or "core/part.h", v))
    add(stem .. ".h", out.headers)
    if own.source ~= "" and not header_only then
      put(stem .. ".c", render(main and "core/scene.c" or "core/part.c", v))
      add(stem .. ".c", out.sources)
      add(stem, out.stems)
    end
    add(own.header, texts.header)
    add(own.plain, texts.source)
  end
  local whole = {} -- what all files together include
  for _, h in ipairs { "<math.h>", "<stddef.h>", "<stdint.h>" } do
    if used[h] then add(h, whole) end
  end
  out.text = table.concat(texts.source, "\n")
  local declarations = table.concat(texts.header, "\n")
  local v = { declarations = declarations, definitions = out.text, header_includes = includes(declarations),
    preamble = preamble(whole, ctx.type == "real"), own_includes = {}, has_private = false,
    header_only = header_only, implementation = "" }
  out.header, out.source = render("core/scene.h", v), render("core/scene.c", v)
  return out
end

local function banner(job, p)
  local list = {}
  for _, lines in ipairs { job.banner, p.functions.banner, job.planned and job.planned.report or {} } do
    for _, line in ipairs(lines) do list[#list + 1] = line end
  end
  return list
end

function code.of(job)
  local ctx = source.context(job)
  local base = base_values.of(job, ctx.own)
  local p = parts_of(job, ctx, base)
  local all = sorted(job, p, ctx, base)
  local unread = job.selection.only and not job.fit and init.unread(job.model, all.read) -- fitted.c reads all
  if unread then
    ctx = source.context(job)
    p = parts_of(job, ctx, base, unread)
    all = sorted(job, p, ctx, base)
  end
  local files = written(job, all, ctx, base, head.of(job, ctx, { banner = banner(job, p), order = p.order,
    kept = p.kept, split_setup = p.setup_code ~= nil, no_members = p.no_members }))
  local offers = setmetatable({}, { __index = function() return false end })
  for _, f in ipairs(all.functions) do offers[string.sub(f.name, #ctx.name + 2)] = f.asked end
  return { files = files.files, header = files.header, source = files.source, functions = all.functions,
    offers = offers, ctx = ctx, base = base_values.of(job, false), parts = p, costs = p.functions.costs,
    names = { headers = files.headers, sources = files.sources, stems = files.stems,
      public = headers_of(files.headers) },
    links_m = libm.linked(ctx, files.text) }
end

return code
