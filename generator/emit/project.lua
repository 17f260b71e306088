-- project.lua -- the files that are emitted for one scene.
--
-- One function per artifact prepares lists of text; templates/ put them in place.  Nothing here decides what is
-- computed (dynamics/ and methods/ do) or how an expression looks (cprint does).  No clock, no host, no path but the
-- scene's base name: same input, same bytes.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local code = require "generator.emit.code"
local columns = require "generator.emit.columns"
local plugins = later "generator.emit.plugins"
local q31 = later "generator.emit.q31"
local source = require "generator.emit.source"
local tested = require "generator.emit.tested"

local project = {}

-- Header and source of an open unit, all of them in one.
function project.code(unit)
  local made = code.of(unit)
  unit.code, unit.emitted, unit.costs = { header = made.header, source = made.source }, made.functions, made.costs
  unit.checks = {}
  for i, c in ipairs(made.parts.init.checks) do unit.checks[i] = c.text end
  return made
end

-- The list of files {name, text} of the package in job.package.  job.plugin: also the table that the program polhode
-- loads; plugin = {peers = true}: with what other integrators need, if the scene is in double.
function project.files(job)
  local made, plugin = project.code(job), job.plugin
  local files, written = made.files, #made.files
  files[#files + 1] = { name = job.model.name .. "_test.c", text = tested.render(job, made) }
  for _, f in ipairs(job.q31 and q31.files(job, made.base) or {}) do files[#files + 1] = f end
  local more = job.package.files(job, made)
  if not more then return nil end -- with an error in job.diag
  for _, f in ipairs(more) do files[#files + 1] = f end
  for i = written + 1, #files do
    if string.find(files[i].name, "%.[ch]$") and not files[i].once then files[i].text = columns.fit(files[i].text) end
  end
  for _, f in ipairs(plugin and plugins.files(job, made, plugin) or {}) do files[#files + 1] = f end
  if job.package.arrange then return job.package.arrange(files) end
  return files
end

-- The IR of every function after a pass, as text.
function project.show(job, stop)
  local ctx, out = source.context(job), {}
  for i, f in ipairs(job.functions) do out[i] = source.show(ctx, f, stop) end
  return table.concat(out, "\n")
end

return project
