-- build.lua -- emits a scene, compiles it, and loads it into this program.
--
-- The compiler is the user's (CC, else cc, gcc, clang); the flags are the ones the emitted code promises to be clean
-- under, warnings as errors, so a warning in emitted code is a failure here.
-- SPDX-License-Identifier: GPL-3.0-or-later

local driver = require "generator.driver"

local build = {}

build.flags = { "-O2", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Wshadow",
  "-Werror", "-ffp-contract=off" }

-- Compiles a planned job as a shared object and loads it: plugin | nil, message, and "range" if the real type cannot
-- hold the scene's constants.  own: other flags than build.flags.
function build.plugin(host, job, own)
  local dir, why = host.tempdir()
  if not dir then return nil, why end
  local ok
  local files = driver.files(host, job, true)
  if not files then return nil, job.diag:report(), "range" end
  ok, why = host.write_files(dir, files)
  if not ok then return nil, why end
  local flags = { "-shared", "-fPIC" }
  for _, f in ipairs(own or build.flags) do flags[#flags + 1] = f end
  ok, why = host.compile(dir, { job.model.name .. ".c", "plugin.c" }, "plugin.so", { flags = flags, libs = { "-lm" } })
  if not ok then return nil, "the emitted code does not compile:\n" .. why end
  return host.plugin(dir .. "/plugin.so")
end

return build
