-- costs.lua -- what floating point costs on small processors: counted, fitted, written down.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/target/costs.lua PROGRAM DIRECTORY [generator/cost/measured.lua docs/targets.md]
--
-- Counts, under the emulators of cores.lua, each operation and function of the C library on 16 pairs of operands
-- (costs.c), then what emitted steppers and closed forms of three scenes execute (steps.c).  From that it fits two
-- numbers for each core and type: what part of the first an operation takes in emitted code, and how many instructions
-- go with each number in memory.  Writes both as Lua, and the tables between the document's marks.
-- Without files it prints the tables.  Says which packages are missing and does nothing if one is.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local program, dir, lua_file, doc_file = arg[1], arg[2], arg[3], arg[4]
local cores = require "tests.target.cores"
local scene = require "tests.scene"
local driver = require "generator.driver"
local ops = require "generator.cost.ops"

local missing = cores.missing(cores.list)
if #missing > 0 then
  print("target-costs: skipped; missing: apt-get install --no-install-recommends " .. table.concat(missing, " "))
  os.exit(0)
end
cores.must("mkdir -p %s", dir)

local REALS = { "float", "double" }

-- ---- operations ----

-- In the order of costs.c, after the loop that copies.
local UNITS = { "add", "mul", "div", "sqrt", "cmp", "conv", "toint", "conv64", "long", "fma", "sin", "cos", "exp",
  "log", "sinh", "cosh", "floor", "frexp", "ldexp", "tan", "tanh", "asin", "acos", "atan", "atan2", "pow", "fmod",
  "hypot", "cbrt", "ceil" }

-- One instruction each where the processor has them; a comparison also moves its flags.
local HARDWARE = { ["cortex-m4f"] = { float = true }, ["cortex-m7"] = { float = true, double = true },
  rv32imafc = { float = true } }
local ONE = { add = 1, mul = 1, div = 1, sqrt = 1, fma = 1, conv = 1, toint = 1, cmp = 2 }

local measured = {}
for _, core in ipairs(cores.list) do
  measured[core.name] = {}
  for _, real in ipairs(REALS) do
    local elf = core.name .. "." .. real .. ".elf"
    cores.build(core, dir, elf, "-I tests/target tests/target/costs.c", "-DREAL=" .. real .. " -DF=" ..
      (real == "float" and "f" or ""))
    local counts, own = cores.counts(core, dir, elf), {}
    assert(#counts == #UNITS + 1, core.name .. ": the firmware has not run to its end, but to " .. #counts)
    local hard = HARDWARE[core.name] and HARDWARE[core.name][real]
    for i, name in ipairs(UNITS) do
      -- a product, a sum, a shift; half of those in emitted code only take one half of a number, which is free
      if name == "long" then counts[i + 1] = counts[1] + (counts[i + 1] - counts[1]) / 6 end
      own[name] = hard and ONE[name] or math.max(1, math.floor((counts[i + 1] - counts[1]) / 16 + 0.5))
    end
    own.toint = nil -- a cast, hardly ever met
    measured[core.name][real] = own
  end
end

-- ---- emitted code ----

local SCENES = { "brick_centroid", "heavy_top", "symmetric_top" }
local METHODS = { "rk4", "semi", "midpoint", "taylor", "split4", "exact" }
local CALLED = { "step", "semi_step", "midpoint_step", "taylor_step", "split4_step", "solve", "set_tick", "at",
  "at_tick" }
local SHOWN = { "step", "semi_step", "midpoint_step", "taylor_step", "at", "at_tick" } -- fitted and shown
local TITLE = { step = "rk4", semi_step = "semi", midpoint_step = "midpoint", taylor_step = "taylor 8" }

-- rows[core][real]: list of {scene, counted, cycles = {name -> n}, ops = {name -> counts}}
local rows = {}
for _, name in ipairs(SCENES) do
  for _, real in ipairs(REALS) do
    local own = dir .. "/" .. name .. "." .. real
    cores.must("mkdir -p %s && %s gen bodies/%s.lua --layout single --with orbit --real %s --method %s --order 8 -o " ..
      "%s", own, program, name, real, table.concat(METHODS, ","), own)
    local job = driver.code(scene.plan(scene.file("bodies/" .. name .. ".lua"), { real = real, methods = METHODS,
      order = 8 }))
    for _, core in ipairs(cores.list) do
      if core.name ~= "avr" or real == "float" then -- its double is a float
        cores.build(core, own, core.name .. ".elf",
          "-I tests/target tests/target/steps.c " .. own .. "/" .. name .. ".c",
          "-DSCENE=" .. name .. " -DSCENE_H='\"" .. name .. ".h\"'")
        local counts, cycles = cores.counts(core, own, core.name .. ".elf")
        local row = { scene = name, counted = {}, ops = {}, cycles = {} }
        assert(#counts == #CALLED + 1, "the firmware has not run to its end")
        local fma = HARDWARE[core.name] and HARDWARE[core.name][real]
        for i, f in ipairs(CALLED) do
          row.counted[f] = counts[i + 1] - counts[1]
          if core.arm then row.cycles[f] = cycles[i + 1] - cycles[1] end
          row.ops[f] = ops.call(job, f, { fma = fma })
        end
        rows[core.name] = rows[core.name] or {}
        rows[core.name][real] = rows[core.name][real] or {}
        table.insert(rows[core.name][real], row)
      end
    end
  end
end

-- ---- the fit ----

local OPERATIONS = { "add", "mul", "div", "sqrt", "fma", "cmp", "conv", "conv64", "long" }

local function plain(unit, counts)
  local sum = 0
  for _, k in ipairs(OPERATIONS) do sum = sum + counts[k] * unit[k] end
  for _, k in ipairs(ops.functions) do sum = sum + (counts.calls[k] or 0) * (unit[k] or 0) end
  return sum
end

-- Least squares of the logarithm of predicted over counted, on a grid: the same numbers each time.
local function fit(unit, list)
  local best
  for part = 50, 200 do
    for mem = 0, 60 do
      local sum = 0
      for _, row in ipairs(list) do
        for _, f in ipairs(SHOWN) do
          local e = math.log((part / 100 * plain(unit, row.ops[f]) + mem / 20 * row.ops[f].mem) / row.counted[f])
          sum = sum + e * e
        end
      end
      if not best or sum < best.sum then best = { sum = sum, part = part / 100, mem = mem / 20 } end
    end
  end
  unit.part, unit.mem = best.part, best.mem
end

-- Cycles an instruction, the mean of what is shown, each function alike; hard: but for divisions, roots and fused
-- operations of a floating point unit, which targets.lua adds (count.c has what they take).
local function cycles_each(list, hard)
  local sum, n = 0, 0
  for _, row in ipairs(list) do
    for _, f in ipairs(SHOWN) do
      if not row.cycles[f] then return 1 end
      local c = row.ops[f]
      local slow = hard and 13 * (c.div + c.sqrt) + 2 * c.fma or 0
      sum, n = sum + (row.cycles[f] - slow) / row.counted[f], n + 1
    end
  end
  return math.floor(100 * sum / n + 0.5) / 100
end

for _, core in ipairs(cores.list) do
  for _, real in ipairs(REALS) do
    local own = rows[core.name][real]
    if own then
      fit(measured[core.name][real], own)
      measured[core.name][real].cycles = cycles_each(own, HARDWARE[core.name] and HARDWARE[core.name][real])
    end
  end
end
measured.avr.double = measured.avr.float

-- ---- as text ----

local function number(x) return x == math.floor(x) and string.format("%d", x) or string.format("%.2f", x) end

local NAMES = { "part", "mem", "cycles" }
for _, k in ipairs(UNITS) do
  if k ~= "toint" then NAMES[#NAMES + 1] = k end
end

local function as_lua()
  local out = { "-- measured.lua -- what operations take on small processors, by `make target-costs`: do not edit.",
    "-- SPDX-License-Identifier: GPL-3.0-or-later", "--",
    "-- Instructions an operation or function, on AVR cycles; part, mem, cycles: see generator/cost/targets.lua.", "",
    "return {" }
  for _, core in ipairs(cores.list) do
    out[#out + 1] = string.format("  [%q] = {", core.name)
    for _, real in ipairs(REALS) do
      local line = "    " .. real .. " = {"
      for _, k in ipairs(NAMES) do
        local item = string.format(" %s = %s,", k, number(measured[core.name][real][k]))
        if #line + #item > 116 then
          out[#out + 1] = line
          line = "     "
        end
        line = line .. item
      end
      out[#out + 1] = string.sub(line, 1, -2) .. " },"
    end
    out[#out + 1] = "  },"
  end
  out[#out + 1] = "}"
  return table.concat(out, "\n") .. "\n"
end

local function as_markdown()
  local out = {}
  local function put(...) out[#out + 1] = string.format(...) end
  local columns = { "add", "mul", "div", "sqrt", "cmp", "conv", "sin", "cos", "exp", "log", "atan2" }
  put("Instructions an operation, on AVR cycles; mean of 16 pairs of operands, the load of the second and the call " ..
    "included:")
  put ""
  put("| core | type | %s | part | mem | cycles each |", table.concat(columns, " | "))
  put("|---|---|%s---|---|---|", string.rep("---|", #columns))
  for _, core in ipairs(cores.list) do
    for _, real in ipairs(REALS) do
      local own, cells = measured[core.name][real], {}
      for i, k in ipairs(columns) do cells[i] = number(own[k]) end
      if rows[core.name][real] then
        put("| %s | %s | %s | %.2f | %.2f | %s |", core.name, real, table.concat(cells, " | "), own.part, own.mem,
          core.arm and string.format("%.2f", own.cycles) or "")
      end
    end
  end
  put ""
  put "Counted a call, and by how much the prediction is off:"
  put ""
  local titles = {}
  for i, f in ipairs(SHOWN) do titles[i] = TITLE[f] or f end
  put("| scene | core | type | %s |", table.concat(titles, " | "))
  put("|---|---|---|%s", string.rep("---|", #SHOWN))
  for i, name in ipairs(SCENES) do
    for _, core in ipairs(cores.list) do
      for _, real in ipairs(REALS) do
        local row = rows[core.name][real] and rows[core.name][real][i]
        if row then
          local own, cells = measured[core.name][real], {}
          for k, f in ipairs(SHOWN) do
            local predicted = own.part * plain(own, row.ops[f]) + own.mem * row.ops[f].mem
            cells[k] = string.format("%d (%+.0f %%)", row.counted[f], 100 * (predicted / row.counted[f] - 1))
          end
          put("| %s | %s | %s | %s |", name, core.name, real, table.concat(cells, " | "))
        end
      end
    end
  end
  return table.concat(out, "\n") .. "\n"
end

local function slurp(path)
  local file = assert(io.open(path))
  local text = file:read "a"
  file:close()
  return text
end

local function spit(path, text)
  local file = assert(io.open(path, "w"))
  file:write(text)
  file:close()
end

if not lua_file then
  io.write(as_markdown())
  os.exit(0)
end
spit(lua_file, as_lua())
local text, mark, last = slurp(doc_file), "<!-- costs -->\n", "\n<!-- end of costs -->"
local _, from = string.find(text, mark, 1, true)
local to = string.find(text, last, 1, true)
spit(doc_file, string.sub(text, 1, from) .. "\n" .. as_markdown() .. string.sub(text, to))
