-- make.lua -- the plain project: a Makefile and a README; with its proof (emit/proof.lua) where that is asked for.
-- SPDX-License-Identifier: GPL-3.0-or-later

local make = {}

-- make would build its own Makefile from Makefile.c; qemu.c is a file of the project.
local taken = { Makefile = true, qemu = true }

function make.check(job)
  local name = job.model.name
  if not taken[name] then return true end
  job.diag:error(job.record.line, "project make", "the scene must not be named like a file of the project", name)
  return false
end

function make.files(job, v, render)
  v.project_files = { { name = "Makefile",
    about = "`make check` builds and runs the self-test, `make promises` shows what the object needs" } }
  v.project_files[2] = { name = "qemu.c, qemu.ld", about = "`make qemu`: the self-test on an emulated Cortex-M4F" }
  local proof
  if v.has_proof then
    proof = { name = job.model.name .. "_proof.c", text = render "templates/test/proof.c" }
    v.project_files[3] = { name = proof.name,
      about = "`make proof`: Frama-C shows that no step from within the ranges overflows or divides by zero" }
  end
  return { { name = "Makefile", text = render "templates/projects/Makefile" },
    { name = "README.md", text = render "templates/projects/README.md" },
    { name = "qemu.c", text = render "templates/test/qemu.c" },
    { name = "qemu.ld", text = render "templates/test/qemu.ld" }, proof }
end

return make
