-- packages.lua -- the kinds of project that scenes are emitted as (gen --project), one file each.
--
-- A package is a table
--     files(job, made) -> list        what stands beside NAME.h, NAME.c and NAME_test.c: {name =, text =, once = (the
--                                     user edits it: it is written once)}; made: from code.of
--     arrange(files) -> files         optional: all files of the project, put where the kind wants them
--     real, methods, jacobians        optional: its own defaults of --real and --method; "transition": it calls
--                                     NAME_step_transition
--     whole, layout                   optional: it calls functions of its own choice; the layout if none is asked for
--     check(job) -> bool              optional: can the scene be such a project?  If not, with an error in job.diag
--     finish(host, job, files)        optional: what needs the host (compiling); files | nil, what went wrong
-- SPDX-License-Identifier: GPL-3.0-or-later

local list = { names = { "make", "cmake", "arduino", "platformio", "zephyr", "firmware", "fmu", "python" },
  default = "make" }

-- Words that are looked for here, and what to ask instead.
list.names.elsewhere = {
  sweep = "what is varied has to be said; `polhode sweep SCENE --over ... --emit DIR` writes that program",
}

list.about = {
  make = "a Makefile with self-test, library, install",
  cmake = "a CMake project with ctest and package",
  arduino = "an Arduino library with an example",
  platformio = "a PlatformIO library with an example",
  zephyr = "a Zephyr module with a sample",
  firmware = "an attitude filter for a Cortex-M4F",
  python = "a Python package with a C extension and NumPy arrays",
  fmu = "a unit for co-simulation, FMI 2.0 and 3.0",
}

function list.by_name(name) return require("generator.emit.packages." .. name) end

return list
