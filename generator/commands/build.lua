-- build.lua -- emits scenes, compiles them, and loads them into this program.
--
-- The compiler is the user's (CC, else cc, gcc, clang); the flags are the ones the emitted code promises to be clean
-- under, warnings as errors, so a warning in emitted code is a failure here.  At -O1: without contraction every level
-- gives the same bits, and a project compiles in less than half the time of -O2, which no single run wins back; what is
-- timed asks for another level.
-- SPDX-License-Identifier: GPL-3.0-or-later

local compiler = require "generator.commands.compiler"
local driver = require "generator.driver"

local build = {}

build.flags = { "-O1", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Wshadow",
  "-Werror", "-ffp-contract=off" }

-- What item number i needs to be compiled in its own folder of dir, as host.compile_many has it: {dir, sources, output,
-- options} | nil, message, and "range" if the real type cannot hold the scene's constants.
local function prepare(host, item, dir, i)
  local job = item.job
  local unit = driver.files(job, { plugin = { peers = item.peers } })
  if not unit then return nil, job.diag:report(), "range" end
  local files = unit.files
  dir = dir .. "/" .. string.format("%d", i)
  local ok, why = host.write_files(dir, files)
  if not ok then return nil, why end
  -- hidden: compilers may inline and call as in a program that the code is linked into
  local sources, flags = { job.model.name .. ".c", "plugin.c" }, { "-shared", "-fPIC", "-fvisibility=hidden" }
  for _, f in ipairs(files) do
    if f.name == "peers.c" then sources[3] = f.name end
  end
  for _, f in ipairs(build.flags) do flags[#flags + 1] = f end
  for _, f in ipairs(item.flags or {}) do flags[#flags + 1] = f end
  return { dir, sources, "plugin.so", { flags = flags, libs = { "-lm" } } }
end

-- Compiles plans as shared objects, as many at a time as there are processors, and loads them.  list: of {job =,
-- flags = {more flags}, peers = true (with what other integrators need)}.  Returns the list of plugins, false for one
-- that failed, and a table {[its number] = {message =, kind =}}, nil if none did.  kind: "range", "compiler" (there is
-- none that works), or nil.
function build.plugins(host, list)
  local plugins, failed, sources, numbers = {}, {}, {}, {}
  local dir, why = host.tempdir()
  local missing -- what is wrong with the compiler, "none" if nothing is; asked once
  for i, item in ipairs(list) do
    local source, kind
    if dir then source, why, kind = prepare(host, item, dir, i) end
    if source then
      sources[#sources + 1], numbers[#numbers + 1] = source, i
    else
      failed[i] = { message = why, kind = kind }
    end
    plugins[i] = false
  end
  for k, made in ipairs(host.compile_many(sources)) do
    local i = numbers[k]
    if made.command then
      plugins[i], why = host.plugin(sources[k][1] .. "/plugin.so")
      if not plugins[i] then plugins[i], failed[i] = false, { message = why } end
    else
      missing = missing or compiler.missing(host) or "none"
      failed[i] = missing ~= "none" and { message = missing, kind = "compiler" } or
        { message = "the emitted code does not compile:\n" .. made.message }
    end
  end
  return plugins, next(failed) and failed or nil
end

-- One of them: plugin | nil, message, kind; "range": the real type cannot hold the scene's constants.
function build.plugin(host, job)
  local plugins, failed = build.plugins(host, { { job = job } })
  if failed then return nil, failed[1].message, failed[1].kind end
  return plugins[1]
end

-- Sets a plugin up with the scene's own parameters; nil, or why it refuses them.
function build.refusal(job, plugin)
  local text = job.model:refusal(plugin:init())
  return text and "the emitted code refuses the scene's own parameters: " .. text
end

return build
