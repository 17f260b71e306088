-- program.lua -- the program of a sweep, compiled for this machine and run.
--
--     program.compile(host, name, files) -> its path | nil, what is wrong
--     program.run(host, path, given) -> exit status
-- HDF5 is taken where pkg-config finds it.  Flags for this machine's vectors are tried first: clang and older compilers
-- know not all of them.  Whatever they are, the bits are the same.
-- SPDX-License-Identifier: GPL-3.0-or-later

local compiler = require "generator.commands.compiler"
local options = require "generator.commands.options"

local program = {}

local FLAGS = { "-O2", "-std=c99", "-ffp-contract=off", "-fno-math-errno", "-pthread" }
-- gcc 12 contracts in its vectors of straight-line code, whatever -ffp-contract says
local TUNED = { { "-march=native", "-mprefer-vector-width=512", "-fno-tree-slp-vectorize" },
  { "-march=native", "-mprefer-vector-width=512" }, {} }

local function joined(...)
  local out = {}
  for _, list in ipairs { ... } do
    for _, x in ipairs(list) do out[#out + 1] = x end
  end
  return out
end

-- Flags and libraries of HDF5, nothing where it is missing.
local function hdf5(host)
  local flags, libs = {}, {}
  local status, found = host.execute { "pkg-config", "--cflags", "--libs", "hdf5-serial" }
  if status ~= 0 then return flags, libs end
  flags[1] = "-DSWEEP_HDF5"
  for word in string.gmatch(found, "%S+") do
    local to = string.find(word, "^%-[lL]") and libs or flags
    to[#to + 1] = word
  end
  libs[#libs + 1] = "-lhdf5_hl"
  return flags, libs
end

function program.compile(host, name, files)
  local dir, why = host.tempdir()
  if not dir then return nil, why end
  local ok
  ok, why = host.write_files(dir, files)
  if not ok then return nil, why end
  local sources, said = {}, nil
  for _, f in ipairs(files) do
    local needed = string.find(f.name, "%.c$") and not string.find(f.name, "_test%.c$")
    sources[#sources + 1] = needed and f.name or nil
  end
  local more, libs = hdf5(host)
  for _, tuned in ipairs(TUNED) do
    local made
    made, said = host.compile(dir, sources, name .. "_sweep", { flags = joined(FLAGS, tuned, more),
      libs = joined(libs, { "-lm" }) })
    if made then return dir .. "/" .. name .. "_sweep" end
  end
  return nil, compiler.missing(host) or "the program does not compile:\n" .. said
end

function program.run(host, path, given)
  local words = { path, "-o", given.o or "-" }
  if given.threads then words = joined(words, { "--threads", string.format("%d", given.threads) }) end
  if given.block then words = joined(words, { "--block", string.format("%d", given.block) }) end
  if given.resume then words[#words + 1] = "--resume" end
  local status, why = host.hand_over(words)
  return status or options.failed(host, "sweep", why)
end

return program
