-- code.lua -- header and source of a scene, in files by their purpose.
--
--     code.of(job) -> { files = list of {name =, text =}, v =, ctx =, header =, source =, functions = }
-- header and source: all of them in one, with the scene's prefix everywhere, for what counts and calls the functions.
-- job.layout: "split": NAME (the motion), NAME_orbit (the closed form), NAME_analysis, NAME_private.h (what several of
-- them share), each only where there is something in it; "single": one header and one source; "header": one header,
-- whose implementation stands behind a macro.
-- SPDX-License-Identifier: GPL-3.0-or-later

local batch = require "generator.emit.batch"
local baked = require "generator.emit.baked"
local columns = require "generator.emit.columns"
local guard = require "generator.emit.guard"
local layout = require "generator.emit.layout"
local libm = require "generator.emit.libm"
local proof = require "generator.emit.proof"
local special = require "generator.emit.special"
local steppers = require "generator.emit.steppers"
local template = require "generator.emit.template"
local values = require "generator.emit.values"
local selection = require "generator.selection"

local code = {}

-- The headers of the C library that a text needs, less those that it already has.
local function includes(text, already)
  local list, has = {}, {}
  for _, name in ipairs(already or {}) do has[name] = true end
  for _, h in ipairs { { "<stddef.h>", "%f[%w_]size_t%f[^%w_]" }, { "<stdint.h>", "%f[%w_]u?int%d+_t%f[^%w_]" } } do
    if string.find(text, h[2]) and not has[h[1]] then list[#list + 1] = h[1] end
  end
  return list
end

-- The texts in the order of the C: what stands first is used by what follows.
local function fragments(job, v, ctx)
  local function render(name) return template.file(name, job.templates[name], v) end
  local list = {}
  local function put(header, source, room)
    list[#list + 1] = { header = header or "", source = source or "", room = room or "motion" }
  end
  if v.has_special then put(nil, v.pair_source .. "\n" .. v.special_source) end
  if v.has_exact then put(nil, render "templates/numeric/exact.c") end
  if v.has_order then put(nil, render "templates/numeric/order.c") end
  put(render "templates/core/init.h", render "templates/core/init.c")
  local declarations = {}
  for i, f in ipairs(v.functions) do declarations[i] = table.concat(f.comment, "\n") .. "\n" .. f.declaration end
  put(table.concat(declarations, "\n\n") .. "\n", render "templates/core/functions.c")
  if v.has_attitude then put(render "templates/core/normalise.h", render "templates/core/normalise.c") end
  if not v.has_special and (v.has_rates or v.has_closed) then put(nil, v.pair_source) end
  if v.has_rates then put(nil, render "templates/analysis/principal.c", "analysis") end
  if v.has_closed then put(v.closed_header, v.closed_source, "orbit") end
  if v.stepper_source ~= "" then put(v.stepper_header, v.stepper_source) end
  if job.batch then
    local header, source = batch.texts(job, ctx, v)
    if header then put(header, source, "batch") end
  end
  if v.has_guard then put(v.guard_header, v.guard_source) end
  if v.has_rates then
    put(render "templates/analysis/principal.h", nil, "analysis")
    put(render "templates/analysis/analysis.h", render "templates/analysis/analysis.c", "analysis")
    if v.has_stability then
      put(render "templates/analysis/stability.h", render "templates/analysis/stability.c", "analysis")
    end
  end
  local all = {}
  for i, f in ipairs(list) do all[i] = f.source end
  local text = table.concat(all, "\n")
  v.baked = baked.lines(job, ctx, text)
  if v.baked[1] then
    local heading = "/* ---- constants: the scene's parameters are in them ---- */\n\n"
    table.insert(list, 1, { header = "", room = "motion", source = heading .. table.concat(v.baked, "\n") .. "\n" })
  end
  local own = ctx.own and libm.source(v, ctx, job.templates, text) or ""
  if own ~= "" then table.insert(list, 1, { header = "", source = own, room = "motion" }) end
  return list
end

local ABOUT = { batch = "many bodies at once", orbit = "its motion in closed form",
  analysis = "what can be asked of the body, and derivatives" }

-- header, source: texts with the prefix; rooms: the texts of each file.
local function sorted(job, v, ctx)
  local prefix, s = v.name .. "_", job.selection
  local function short(name) return string.sub(name, #prefix + 1) end
  local base = { init = true, defaults = true }
  local function asked(name)
    local own = short(name)
    if base[own] and not s.asked(own) then return not v.no_members end
    return s.asked(own)
  end
  local function room(name, of)
    return job.layout == "split" and selection.room(short(name), of) or "motion"
  end
  local list = fragments(job, v, ctx)
  local keeps = job.layout == "header" or job.proof -- several in one program; Frama-C's options name functions
  return layout.sort(v.name, ctx.type, list, asked, room, keeps)
end

function code.of(job)
  local v, ctx = values.common(job)
  values.closed(job, v, ctx)
  steppers.render(job, v, ctx)
  special.render(job, v)
  guard.fill(job, v)
  proof.fill(job, v)
  v.has_exact = v.order_sums or job.closed.exact or false
  local all = sorted(job, v, ctx)
  local function render(name) return template.file(name, job.templates[name], v) end
  local files, used, sources, headers, texts = {}, {}, {}, {}, { header = {}, source = {} }
  local function put(name, text) files[#files + 1] = { name = name, text = columns.fit(text) } end
  local function library(text, already)
    local list = includes(text, already)
    if libm.included(ctx, text) then table.insert(list, 1, "<math.h>") end
    for _, h in ipairs(list) do used[h] = true end
    return list
  end
  local function add(name, list) list[#list + 1] = name end
  v.real_type, v.header_only = all.real, job.layout == "header"
  v.has_private, v.definitions, v.implementation = all.private ~= "", "", ""
  if v.has_private then
    v.definitions, v.source_includes = all.private, library(all.private)
    put(v.name .. "_private.h", render "templates/core/private.h")
    add(v.name .. "_private.h", headers)
    add(all.plain_private, texts.source)
  end
  for _, r in ipairs(all.order) do
    local own, stem = all.rooms[r], v.name .. selection.tails[r]
    v.file, v.file_upper, v.about_file = stem, string.upper(stem), ABOUT[r] or ""
    v.declarations, v.definitions = own.header, own.source
    v.header_includes = includes(own.header)
    for _, h in ipairs(v.header_includes) do used[h] = true end
    v.source_includes = library(own.source, v.header_includes)
    v.own_includes = {}
    for _, other in ipairs { "orbit", "analysis" } do
      if own.calls[other] and other ~= r then add(v.name .. selection.tails[other] .. ".h", v.own_includes) end
    end
    local main = r == "motion"
    v.implementation = v.header_only and render "templates/core/implementation.c" or ""
    put(stem .. ".h", render(main and "templates/core/scene.h" or "templates/core/part.h"))
    add(stem .. ".h", headers)
    if own.source ~= "" and not v.header_only then
      put(stem .. ".c", render(main and "templates/core/scene.c" or "templates/core/part.c"))
      add(stem .. ".c", sources)
    end
    add(own.header, texts.header)
    add(own.plain, texts.source)
  end
  v.sources, v.headers, v.public_headers, v.stems = sources, headers, {}, {}
  for i, s in ipairs(sources) do v.stems[i] = string.match(s, "^(.*)%.c$") end
  for _, h in ipairs(headers) do
    if not string.find(h, "_private.h", 1, true) then add(h, v.public_headers) end
  end
  v.source_words, v.header_words = table.concat(sources, " "), table.concat(headers, " ")
  v.public_words = table.concat(v.public_headers, " ")
  local list = {}
  for _, h in ipairs { "<math.h>", "<stddef.h>", "<stdint.h>" } do list[#list + 1] = used[h] and h or nil end
  local text = table.concat(texts.source, "\n")
  v.links_m = libm.linked(ctx, text) and " -lm" or ""
  v.link_words = v.links_m ~= "" and "sin, exp and their kin are in the library m" or "no library is needed"
  v.own_libm, v.no_errno = ctx.own, ctx.own and " -fno-math-errno" or ""
  v.libm_text = ctx.own and "mathematical functions of its own" or "the C library's mathematical functions"
  v.included = #list > 0 and "`" .. table.concat(list, "`, `") .. "`" or "C itself"
  v.declarations, v.definitions, v.header_includes, v.source_includes = table.concat(texts.header, "\n"), text,
    includes(table.concat(texts.header, "\n")), list
  v.real_type, v.own_includes, v.has_private = ctx.type, {}, false
  v.file, v.file_upper, v.implementation = v.name, v.upper, ""
  local header, source = render "templates/core/scene.h", render "templates/core/scene.c"
  for k, name in pairs(libm.names(ctx, false)) do v[k] = name end -- for other files; into a table: order is lost
  return { files = files, v = v, ctx = ctx, header = header, source = source, functions = all.functions }
end

return code
