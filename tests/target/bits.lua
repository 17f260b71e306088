-- bits.lua -- programs of tests/target/bits.c: which scenes, how they are built, and what they print.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local bits = require "tests.target.bits"
--     bits.scenes                                  list of {scene, step, methods, more}
--     local file = bits.program(s, real, m, compiler, level, options)     leaves rules in jobs.lua
--     bits.read(file) -> {item -> hash}, or nil and what was printed      also: the items' order, a list
--
-- The golden file is read and written here too: bits.golden(), bits.write(table).

local jobs = require "tests.target.jobs"
local scenes = require "tests.target.scenes"

local bits = { path = "tests/target/bits.txt" }

-- One of each kind of emitted code.  The first method is NAME_step, which the self-test runs too.  The free top stands
-- in two scenes, because with all steppers it is too large for an AVR.  large: takes seconds to compile; its number.
bits.scenes = {
  { scene = "brick_centroid", step = "0.01", methods = "taylor,rk4,adaptive,midpoint,semi,split2,split4" },
  { scene = "brick_centroid", step = "0.01", methods = "rk4,exact", large = 1 }, -- free, three moments: theta functions
  { scene = "symmetric_top", step = "0.01", methods = "split4,rk4,adaptive,taylor,midpoint,semi,split2,exact" },
  { scene = "heavy_top", step = "0.001", methods = "rk4,taylor,midpoint,semi,split2,exact", large = 2 }, -- Lagrange
  { scene = "gyrostat", step = "0.01", methods = "midpoint,rk4,semi,exact" }, -- a rotor along a symmetry axis
  { scene = "dual_spin", step = "0.01", methods = "rk4,semi,exact", large = 3 }, -- a rotor in an asymmetric body
  { scene = "thruster", step = "0.01", methods = "adaptive,rk4,taylor,midpoint,semi", more = " --with jacobians",
    large = 4 },
  { scene = "kapitza", step = "0.0005", methods = "semi,rk4,adaptive,taylor,midpoint,split2" }, -- functions of time
  { scene = "foucault", step = "0.05", methods = "rk4,exact" }, -- position, a turning frame
  { scene = "damped_brick", step = "0.01", methods = "rk4,exact", large = 5 }, -- exponentials
}

-- What CI builds with gcc, the self-tests too, and with clang: the level on each machine.  Every level stands there
-- for each compiler; POLHODE_BITS=all takes the whole product.
bits.levels = { "-O0", "-O1", "-O2", "-O3", "-Os" }
bits.level = {
  host = { gcc = "-O0", clang = "-O2" },
  ["cortex-m0"] = { gcc = "-Os", clang = "-O2" },
  ["cortex-m3"] = { gcc = "-O1", clang = "-O0" },
  ["cortex-m4f"] = { gcc = "-O2", clang = "-O3" },
  ["cortex-m7"] = { gcc = "-O3", clang = "-O1" },
  rv32imac = { gcc = "-O1", clang = "-Os" },
  rv32imafc = { gcc = "-O2", clang = "-O3" },
  avr = { gcc = "-Os" },
  aarch64 = { gcc = "-O1", clang = "-O2" },
  mips = { gcc = "-O0", clang = "-O1" },
}
-- Of every how many scenes one is in double too: where the processor has it, where it is another one altogether, and
-- once where all is software.
bits.doubles = { host = 1, ["cortex-m7"] = 10, rv32imac = 10, aarch64 = 5, mips = 5 }

-- Is the i-th scene for the k-th machine in what CI runs?  gcc in float: the five that are quick to compile and one
-- of the large ones, which take turns: six bodies; a third of the machines have the free top, too.
function bits.chosen(machine, k, i, real, compiler)
  local host = machine.name == "host"
  if compiler == "clang" then return machine.compile.clang and (real == "float" or host) and (i + k) % 10 == 5 end
  local large = bits.scenes[i].large
  if real == "float" then return host or not large or large == 2 + k % 4 or large == 1 and k % 3 == 0 end
  local some = bits.doubles[machine.name]
  return some and (i + k) % some == 0
end

-- What the header declares, as options of the compiler; read when make runs.
local function declared(name, header)
  return string.format([[$(grep -o '\b%s_[a-z0-9_]*[(;]' %s | sed 's/^%s_\(.*\)[(;]$/-DHAS_\1=1/')]], name, header,
    name)
end

function bits.source(s, real) return scenes.source(s.scene, real, s.methods, (s.more or "") .. " --libm own") end

-- driver: bits.c, long.c
function bits.program(s, real, m, compiler, level, options, tag, driver)
  local source = bits.source(s, real)
  local own, name = string.match(source, "^(.*)/(.*)%.c$")
  local flags = string.format("-I %s -I tests/target -DSCENE=%s -DUPPER=%s -DSCENE_H='\"%s.h\"' -DH=%s " ..
    "-DFIRST='\"%s\"' %s %s", own, name, string.upper(name), name, s.step, string.match(s.methods, "%w+"),
    declared(name, own .. "/" .. name .. ".h"), options or "")
  local path = "tests/target/" .. (driver or "bits.c")
  local copy = jobs.rule(own .. "/" .. (driver or "bits.c"), { path, "tests/target/hash.h", source },
    "cp " .. path .. " " .. own)
  local objects = { scenes.object(m, compiler, level, source, options, nil, tag),
    scenes.object(m, compiler, level, copy, flags, nil, tag) }
  local large = m.large and (not m.doubles or real == "double" or level == "-O0") and m.large or {}
  local elf = scenes.program(m, (string.gsub(objects[2], "%.o$", ".elf")), objects, large.link)
  return scenes.output(m, elf, large.run)
end

function bits.read(file)
  local text = jobs.slurp(file)
  if not text then return nil, "not built: " .. (jobs.slurp((string.gsub(file, "%.out$", "")) .. ".log") or "") end
  local items, order = {}, {}
  for line in string.gmatch(text, "[^\n]+") do
    local name, hash = string.match(line, "^([%w_]+) (%x+)$")
    if name and #hash == 16 then
      if items[name] and items[name] ~= hash then return nil, name .. " twice, with different bits" end
      if not items[name] then order[#order + 1] = name end
      items[name] = hash
    elseif not string.find(line, "^#") and line ~= "status 0" then
      return nil, line
    end
  end
  if not string.find(text, "\nstatus 0\n$") then return nil, text end
  return items, order
end

-- {"scene real" -> {item -> hash}}
function bits.golden()
  local all = {}
  for line in string.gmatch(jobs.slurp(bits.path) or "", "[^\n]+") do
    local scene, real, item, hash = string.match(line, "^([%w_]+) (%a+) ([%w_]+) (%x+)$")
    if scene then
      local key = scene .. " " .. real
      all[key] = all[key] or {}
      all[key][item] = hash
    end
  end
  return all
end

-- list: {key = "scene real", items, order}; one scene may stand there twice, with other items or the same bits
function bits.write(list)
  local out = { "# bits.txt -- hashes of what emitted code computes: scene, type, result, hash; bits.c says how.",
    "# One file for all machines, compilers and levels.  Written by POLHODE_BITS=refresh lua5.4 tests/target/bits.t" }
  local seen = {}
  for _, r in ipairs(list) do
    for _, item in ipairs(r.order) do
      local key = r.key .. " " .. item
      assert(not seen[key] or seen[key] == r.items[item], key .. ": two hashes")
      if not seen[key] then out[#out + 1] = key .. " " .. r.items[item] end
      seen[key] = r.items[item]
    end
  end
  local file = assert(io.open(bits.path, "w"))
  file:write(table.concat(out, "\n"), "\n")
  file:close()
end

return bits
