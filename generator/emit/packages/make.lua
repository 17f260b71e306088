-- make.lua -- the plain project: a Makefile and a README; with its proof (emit/proof.lua) where that is asked for.
-- SPDX-License-Identifier: GPL-3.0-or-later

local make = {}

function make.files(job, v, render)
  local files = { { name = "Makefile", text = render "templates/Makefile" },
    { name = "README.md", text = render "templates/README.md" } }
  if v.has_proof then files[3] = { name = job.model.name .. "_proof.c", text = render "templates/proof.c" } end
  return files
end

return make
