-- jobs.lua -- commands that depend on each other's files, run by make, two at a time.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local jobs = require "tests.target.jobs"
--     jobs.rule(file, needs, command)    command makes the file; needs: a list of files.  Asked for twice is one rule.
--                                        Without a command it is made with what it needs, and as old as it is
--     jobs.run(dir, name, files)         makes the files; what fails leaves FILE.log and no FILE
--
-- Tests that run at one time share what they build: make is behind a lock.

local jobs = {}

local rules = {}

function jobs.rule(file, needs, command)
  rules[file] = { needs = needs, command = command }
  return file
end

local function slurp(path)
  local file = io.open(path)
  if not file then return nil end
  local text = file:read "a"
  file:close()
  return text
end
jobs.slurp = slurp

-- What a command prints.
function jobs.output(command)
  local pipe = assert(io.popen(command))
  local text = pipe:read "a"
  pipe:close()
  return text
end

function jobs.run(dir, name, files)
  local out, done = { ".DELETE_ON_ERROR:", "all: " .. table.concat(files, " ") }, {}
  local function put(file)
    local r = rules[file]
    if done[file] or not r then return end
    done[file] = true
    for _, need in ipairs(r.needs) do put(need) end
    local command = r.command and string.gsub(r.command, "%$", "$$")
    out[#out + 1] = file .. ": " .. table.concat(r.needs, " ") .. (command and
      "\n\t@mkdir -p $(@D); { " .. command .. "; } > $@.log 2>&1" or " ;")
  end
  for _, file in ipairs(files) do put(file) end
  local path = dir .. "/" .. name .. ".mk"
  os.execute("mkdir -p " .. dir)
  local file = assert(io.open(path, "w"))
  file:write(table.concat(out, "\n"), "\n")
  file:close()
  local lock = "MAKEFLAGS= flock " .. dir .. "/lock make -r -f " .. path
  if not os.execute(string.format("%s -s -k -j2 all > %s.log 2>&1", lock, path)) then
    for _, wanted in ipairs(files) do -- nothing old may pass for new
      if not os.execute(string.format("%s -q %s > %s.log 2>&1", lock, wanted, path)) then os.remove(wanted) end
    end
  end
end

return jobs
