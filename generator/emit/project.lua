-- project.lua -- the files that are emitted for one scene.
--
-- One function per artifact prepares lists of text; templates/ put them in place.  Nothing here decides what is
-- computed (dynamics/ and methods/ do) or how an expression looks (cprint does).  No clock, no host, no path but the
-- scene's base name: same input, same bytes.
-- SPDX-License-Identifier: GPL-3.0-or-later

local code = require "generator.emit.code"
local columns = require "generator.emit.columns"
local q31 = require "generator.emit.q31"
local readme = require "generator.emit.readme"
local source = require "generator.emit.source"
local template = require "generator.emit.template"
local values = require "generator.emit.values"
local vectors = require "generator.emit.vectors"

local project = {}

-- Header and source of an open unit, all of them in one.
function project.code(unit)
  local made = code.of(unit)
  unit.code, unit.emitted, unit.costs = { header = made.header, source = made.source }, made.functions, made.v.costs
  return made
end

-- The list of files {name, text} of the package in job.package.  job.plugin: also the table that the program polhode
-- loads; plugin = {peers = true}: with what other integrators need, if the scene is in double.
function project.files(job)
  local made, plugin = project.code(job), job.plugin
  local v, ctx = made.v, made.ctx
  local function render(name) return template.file(name, job.templates[name], v) end
  v.offers = setmetatable({}, { __index = function() return false end })
  for _, f in ipairs(made.functions) do v.offers[string.sub(f.name, #v.name + 2)] = f.asked end
  vectors.fill(job, v, ctx)
  readme.fill(job, v)
  local n = job.model.name
  v.normalise_test = v.offers.normalise and render "templates/test/test_normalise.c" or ""
  v.tangent_test = render "templates/test/test_tangent.c"
  v.follows_test = render "templates/test/test_follows.c"
  v.compensated_test = v.test_compensated and render "templates/test/test_compensated.c" or ""
  local files = made.files
  local made_of = #files
  files[#files + 1] = { name = n .. "_test.c", text = render "templates/test/test.c" }
  for _, f in ipairs(job.q31 and q31.files(job, v) or {}) do files[#files + 1] = f end
  v.flat = not job.package.arrange -- all files in one folder
  v.project_files, v.project_use, v.dollar = {}, {}, "$" -- of the package, for README.md; for CMake's own ${}
  local more = job.package.files(job, v, render)
  if not more then return nil end -- with an error in job.diag
  for _, f in ipairs(more) do files[#files + 1] = f end
  for i = made_of + 1, #files do
    if string.find(files[i].name, "%.[ch]$") and not files[i].once then files[i].text = columns.fit(files[i].text) end
  end
  if plugin then
    v.has_peers = type(plugin) == "table" and plugin.peers and job.real == "double" or false
    if v.has_peers then files[#files + 1] = { name = "peers.c", text = render "templates/host/peers.c" } end
    files[#files + 1] = { name = "plugin.c", text = render "templates/host/plugin.c" }
    files[#files + 1] = { name = "plugin.h", text = job.templates["templates/host/plugin.h"] }
  end
  if job.package.arrange then return job.package.arrange(files) end
  return files
end

-- The IR of every function after a pass, as text.
function project.show(job, stop)
  local _, ctx = values.common(job)
  local out = {}
  for i, f in ipairs(job.functions) do out[i] = source.show(ctx, f, stop) end
  return table.concat(out, "\n")
end

return project
