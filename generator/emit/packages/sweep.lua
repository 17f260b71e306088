-- sweep.lua -- a program that computes many members of the scene: threads, MPI and HDF5 where they are.
--
-- `polhode sweep` compiles and runs it; --emit writes it.  The study stands in NAME_members.c (emit/members.lua), all
-- else in templates/sweep knows no scene.  gen --project does not offer it, as it does not know what is varied.
-- SPDX-License-Identifier: GPL-3.0-or-later

local members = require "generator.emit.members"

local sweep = { whole = true, layout = "split" }

local PLAIN = { "sweep.h", "sweep_main.c", "sweep_team.c", "sweep_blocks.c", "sweep_log.c", "sweep_seal.c",
  "sweep_draw.c", "sweep_sobol.c", "sweep_exact.c", "sweep_stats.c", "sweep_csv.c", "sweep_hdf5.c", "sweep_mpi.c" }
local PROJECT = { Makefile = "Makefile", ["cmake.txt"] = "CMakeLists.txt", ["job.slurm"] = "job.slurm",
  ["README.md"] = "README.md" }

function sweep.check(job)
  local name = job.model.name
  if name ~= "sweep" and not string.find(name, "^sweep_") then return true end
  job.diag:error(job.record.line, "sweep", "the scene must not be named like a file of the program", name)
  return false
end

function sweep.files(job, made)
  local v, render = members.fill(job, made)
  local name = job.model.name
  v.dollar, v.sweep_sources = "$", {}
  v.sources, v.source_words = made.names.sources, table.concat(made.names.sources, " ")
  local out = {}
  local function put(file, text) out[#out + 1] = { name = file, text = text } end
  put(name .. "_members.c", render "sweep/members.c")
  for _, file in ipairs(PLAIN) do put(file, job.templates["templates/sweep/" .. file]) end
  put("sweep_math.c", members.mathematics(job))
  for _, f in ipairs(out) do
    v.sweep_sources[#v.sweep_sources + 1] = string.match(f.name, "%.c$") and f.name or nil
  end
  v.sweep_words = table.concat(v.sweep_sources, " ")
  for file, as in pairs(PROJECT) do put(as, render("sweep/" .. file)) end -- in any order: sorted next
  table.sort(out, function(a, b) return a.name < b.name end)
  return out
end

return sweep
