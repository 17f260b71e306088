-- cores.lua -- the small processors that tests/target knows: how to compile for them, run them, count instructions.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local cores = require "tests.target.cores"
--     cores.missing(list)                     packages to install for these cores, a list
--     cores.build(core, dir, elf, sources, flags)
--     cores.counts(core, dir, elf)            what was executed between each begin() and end(), a list; and cycles
--
-- The processors, their compilers and emulators: generator/cost/cores.lua, which the program itself uses too (gen
-- --target); here their options become words of a shell (core.flags, core.link, core.run).  The same numbers each time.

local data = require "generator.cost.cores"

local cores = { list = {}, by_name = {} }

-- Words for a shell.
local function words(list)
  local quoted = {}
  for i, word in ipairs(list) do
    quoted[i] = string.find(word, "[^%w%-=+.,_/:]") and "'" .. word .. "'" or word
  end
  return table.concat(quoted, " ")
end

for i, core in ipairs(data.list) do
  local own = setmetatable({ flags = words(core.flags), link = words(core.link), run = words(core.run or {}) },
    { __index = core })
  if core.script then own.link = own.link .. " -L " .. data.folder .. " -T " .. core.script end
  cores.list[i], cores.by_name[core.name] = own, own
end

function cores.run(format, ...)
  local pipe = assert(io.popen(string.format(format, ...) .. " 2>&1"))
  local text = pipe:read "a"
  return pipe:close(), text
end

function cores.must(format, ...)
  local ok, text = cores.run(format, ...)
  if not ok then
    io.stderr:write(string.format(format, ...), "\n", text)
    os.exit(1)
  end
  return text
end

function cores.missing(list)
  local missing, seen = {}, {}
  local function put(package)
    if not seen[package] then missing[#missing + 1] = package end
    seen[package] = true
  end
  for _, core in ipairs(list) do
    local gcc = core.prefix .. "gcc"
    for _, p in ipairs(core.packages) do
      if not cores.run("command -v %s", p[1]) then put(p[2]) end
    end
    for _, h in ipairs(core.header) do
      local compiler = h.host and "cc" or gcc .. " " .. core.flags
      if cores.run("command -v %s", h.host and "cc" or gcc) and
          not cores.run("echo '#include <%s>' | %s -E -x c -", h[1], compiler) then put(h[2]) end
    end
  end
  table.sort(missing)
  return missing
end

-- sources: C files; flags: more options of the compiler
function cores.build(core, dir, elf, sources, flags)
  cores.must("%sgcc %s %s -Wl,--gc-sections -std=gnu11 -I%s -I%s %s %s %s %s -lm -o %s/%s", core.prefix, core.flags,
    words(data.options), dir, data.folder, flags or "", core.link, core.start and data.folder .. core.start or "",
    sources, dir, elf)
end

local function address(core, path, symbol)
  return (string.match(cores.must("%snm %s", core.prefix, path), "(%x+) T " .. symbol .. "\n"))
end

function cores.counts(core, dir, elf)
  local path = dir .. "/" .. elf
  local from, to = address(core, path, "begin"), address(core, path, "end")
  if core.name == "avr" then
    cores.must("cc -std=gnu11 -O2 %savr.c -o %s/avr -lsimavr -l:libelf.so.1", data.folder, dir)
    cores.must("timeout 60 %s/avr %s 0x%s 0x%s 0x%s > %s.counts", dir, path, from, to, address(core, path, "finish"),
      path)
  else
    cores.must("cc -std=c11 -O2 -shared -fPIC %scount.c -o %s/count.so", data.folder, dir)
    cores.must("timeout 60 %s -nographic -monitor none -serial none -plugin %s/count.so,begin=0x%s,end=0x%s%s " ..
      "-d plugin -D %s.counts -kernel %s", core.run, dir, from, to, data.plugin[core.name] or "", path, path)
  end
  local counts, cycles = {}, {}
  for line in io.lines(path .. ".counts") do
    local n, c = string.match(line, "^(%d+) ?(%d*)$") -- simavr also says what it has loaded
    if n then counts[#counts + 1], cycles[#cycles + 1] = tonumber(n), tonumber(c) or 0 end
  end
  return counts, cycles
end

return cores
