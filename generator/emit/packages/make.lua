-- make.lua -- the plain project: a Makefile and a README.
-- SPDX-License-Identifier: GPL-3.0-or-later

local make = {}

function make.files(_, v, render)
  v.project_files = { { name = "Makefile",
    about = "`make check` builds and runs the self-test, `make promises` shows what the object needs" } }
  return { { name = "Makefile", text = render "templates/Makefile" },
    { name = "README.md", text = render "templates/README.md" } }
end

return make
