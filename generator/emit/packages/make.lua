-- make.lua -- the plain project: a Makefile and a README; with its proof (emit/proof.lua) where that is asked for.
-- SPDX-License-Identifier: GPL-3.0-or-later

local readme = require "generator.emit.readme"
local template = require "generator.emit.template"

local GROUP = template.group("projects/Makefile", "test/qemu.c", "test/qemu.ld")

local make = {}

-- make would build its own Makefile from Makefile.c; qemu.c is a file of the project.
local taken = { Makefile = true, qemu = true }

function make.check(job)
  local name = job.model.name
  if not taken[name] then return true end
  job.diag:error(job.record.line, "project make", "the scene must not be named like a file of the project", name)
  return false
end

function make.files(job, made)
  local p, names, name = made.parts.proof, made.names, job.model.name
  local about = { { name = "Makefile",
    about = "`make check` builds and runs the self-test, `make promises` shows what the object needs" },
    { name = "qemu.c, qemu.ld", about = "`make qemu`: the self-test on an emulated Cortex-M4F" },
    p and { name = name .. "_proof.c",
      about = "`make proof`: Frama-C shows that no step from within the ranges overflows or divides by zero" } }
  local v = { proof = p ~= nil, order = made.parts.order, q31 = job.q31 ~= nil, many = made.offers.at_many,
    header_only = job.layout == "header", header_words = table.concat(names.headers, " "),
    public_words = table.concat(names.public, " "), source_words = table.concat(names.sources, " "),
    stems = names.stems, no_errno = readme.no_errno(made), own_libm = made.ctx.own,
    no_memory = made.ctx.own and job.real == "float" } -- in double compilers copy structures by it: docs/promises.md
  for k, x in pairs(p and p.make or {}) do v[k] = x end -- into a table: order is lost anyway
  local render = GROUP(job.templates, made.base, v)
  return { { name = "Makefile", text = render "projects/Makefile" },
    { name = "README.md", text = readme.render(job, made, { files = about }) },
    { name = "qemu.c", text = render "test/qemu.c" }, { name = "qemu.ld", text = render "test/qemu.ld" },
    p and { name = name .. "_proof.c", text = p.text } }
end

return make
