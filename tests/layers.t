#!/usr/bin/env lua5.4
-- layers.t - which part may know which, and the house rules that no linter knows.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Dependencies are read from the `require` and `#include` lines.  The tables below are the whole truth: an
-- arrow that they do not have fails the test, and the way to add one is to add it here and in docs/design.md.

local sources = require "tests.sources"
local tap = require "tests.tap"
local circles = require "tests.circles"

-- A part of the generator is a folder (or a file at the top) and may require itself and what is listed here.
local ARROWS = {
  algebra = { "polhode_rational" },
  formula = { "algebra" }, -- expressions and theory as formulas, in five styles
  diag = {},
  hash = {},
  later = {}, -- known to all
  nearest = {},
  selection = {}, -- names of functions
  stages = {}, -- fields of what one part hands to the next
  functions = { "dynamics", "methods" }, -- which ones a plan has
  -- interchange: shapes whose numbers another program wrote; mass: what is said of a tensor
  dsl = { "algebra", "formula", "diag", "interchange", "nearest", "mass" },
  interchange = { "algebra", "diag", "nearest", "mass" },
  mass = { "algebra", "formula", "diag", "geometry" }, -- geometry: does a hole lie inside its body?
  effects = { "algebra" },
  geometry = {},
  draw = {},
  attitude = {}, -- quaternion, matrix, angles: plain numbers
  plot = { "draw", "attitude" }, -- what is drawn of a motion
  language = {}, -- the scene language as definitions for editors; tables of other parts are handed to it
  page = { "algebra", "geometry" }, -- the HTML file of a scene
  dynamics = { "algebra", "formula", "mass", "stages" }, -- mass: principal axes and validity of the tensor that moves
  methods = { "algebra", "dynamics" },
  ir = { "algebra", "polhode_rational" },
  -- dynamics: the free top with many digits, for constants and expected states
  emit = { "algebra", "formula", "ir", "dynamics", "hash", "selection" },
  plan = { "algebra", "formula", "dynamics", "methods", "ir", "cost", "hash" },
  cost = {}, -- operations counted in text that was made, and what they take
  -- dynamics: equations with an effect left out; cost: of functions
  report = { "algebra", "formula", "mass", "dynamics", "emit", "draw", "cost" },
  driver = { "algebra", "diag", "dsl", "mass", "effects", "dynamics", "methods", "ir", "emit", "report", "nearest",
    "selection", "stages", "functions", "attitude" },
  commands = { "algebra", "diag", "dsl", "mass", "effects", "dynamics", "methods", "ir", "emit", "cost", "plan",
    "report", "driver", "interchange", "nearest", "selection", "plot", "page", "attitude", "language" },
  main = { "commands", "driver", "diag", "nearest" },
}

-- Inside ir/: which room may require which, of ir and of the exact side.  The line between real algebra and IEEE
-- arithmetic is the edge of lower/: it alone knows the algebra, and of that the numbers; what it gives is data, so it
-- knows no other room.  Below, constants are rationals of the C module, nothing is simplified, and a pass knows the
-- instruction table and not its neighbours.
local ROOMS = {
  lower = { "generator.ir.lower", "generator.algebra.rational", "generator.algebra.choice" },
  core = { "generator.ir.core", "generator.ir.special", "polhode_rational" },
  passes = { "generator.ir.core.instr", "polhode_rational" },
  special = { "generator.ir.special" },
}
local PASS_LIST = "generator/ir/passes/passes.lua" -- knows them all

-- A link unit of C: the folders of ours that it may include, and the outside headers that only it may.
local INCLUDES = {
  ["src/runtime"] = { own = { "src/runtime" }, outside = { "^gsl/" } },
  ["src/cli"] = { own = { "src/cli/", "src/runtime/polhode.h",
      "src/runtime/effects/effect.h", "templates/host/plugin.h" }, -- the fields that an effect reads, and its terms
    outside = { "^lua%.h$", "^lauxlib%.h$", "^lualib%.h$", "^expat%.h$", "^gmp%.h$", "^mpfr%.h$" } },
  -- the integrators of others, which the emitted code is timed against
  ["src/cli/bench"] = { own = { "src/cli/", "src/runtime/polhode.h", "templates/host/plugin.h" }, outside = { "^gsl/",
    "^arkode/", "^cvode/", "^nvector/", "^sundials/", "^sunlinsol/", "^sunmatrix/", "^sunnonlinsol/" } },
  ["src/cli/fit"] = { own = { "src/cli/", "templates/fit/fitted.h" },
    outside = { "^gsl/", "^lua%.h$", "^lauxlib%.h$" } },
  ["templates"] = { own = { "templates" }, outside = {} },
  -- not emitted: what is compiled to count instructions, for an emulator and for what it runs
  ["templates/target"] = { own = { "templates/target" }, outside = { "^simavr/" } },
  -- the program in the process of a fuzzer
  ["tests/fuzz"] = { own = { "tests/fuzz", "src/cli", "src/runtime" },
    outside = { "^lua%.h$", "^lauxlib%.h$", "^lualib%.h$" } },
  ["tests"] = { own = { "tests", "src/runtime", "templates/target" }, outside = { "^gsl/", "^gmp%.h$", "^mpfr%.h$",
    "^simavr/" } },
  -- the hook that sees which lines of the generator run
  ["tests/coverage"] = { own = { "tests/coverage" }, outside = { "^lua%.h$" } },
  ["tests/bench"] = { own = { "tests", "src/runtime" }, outside = { "^gsl/", "^gmp%.h$", "^mpfr%.h$", "^arkode/",
    "^cvode/", "^nvector/", "^sundials/", "^sunlinsol/", "^sunmatrix/", "^sunnonlinsol/" } },
}
-- Emitted code needs these of the C library and no more; stdio and float only for its self-test.
local EMITTED = { ["math.h"] = true, ["stddef.h"] = true, ["stdio.h"] = true, ["stdint.h"] = true,
  ["float.h"] = true }

-- Whole applications and examples, which have a machine under them.
local APPLICATIONS = { ["string.h"] = true, ["stdlib.h"] = true, ["zephyr/kernel.h"] = true,
  ["zephyr/sys/printk.h"] = true }
-- What stands between a scene and FMI keeps instances and messages, and FMI 3.0 has the type bool.
local GLUE = { ["stdbool.h"] = true, ["stdlib.h"] = true, ["string.h"] = true }
-- The program of a sweep has threads, files and signals, and MPI and HDF5 where they are.
local PROGRAM = {}
for word in string.gmatch([[dirent errno fcntl hdf5 hdf5_hl mpi pthread signal stdarg stdlib string sys/stat time
  unistd]], "%S+") do
  PROGRAM[word .. ".h"] = true
end

-- Files that turn numbers into text by design: literals of C, messages, and the listing of the IR.
local PRINTS_NUMBERS = { ["generator/emit/number.lua"] = true, ["generator/draw/svg.lua"] = true,
  ["generator/diag.lua"] = true,
  ["generator/emit/q31.lua"] = true, -- three digits in comments
  ["generator/ir/core/show.lua"] = true, ["generator/report/json.lua"] = true, ["generator/report/facts.lua"] = true,
  ["generator/report/fit.lua"] = true, ["generator/report/design.lua"] = true,
  ["generator/report/explain.lua"] = true, ["generator/commands/run.lua"] = true,
  ["generator/commands/run/advice.lua"] = true, ["generator/commands/run/limits.lua"] = true,
  ["generator/report/stability_conditions.lua"] = true, ["generator/report/chart.lua"] = true,
  ["generator/report/linearised.lua"] = true,
  ["generator/commands/check.lua"] = true, ["generator/commands/comparison.lua"] = true,
  ["generator/commands/touch_checks.lua"] = true, ["generator/commands/run/bounce.lua"] = true, -- in messages
  ["generator/commands/events.lua"] = true, ["generator/commands/chart.lua"] = true, -- in a message and a title
  ["generator/dynamics/happenings.lua"] = true, ["generator/dynamics/landing.lua"] = true,
  ["generator/dynamics/start.lua"] = true, -- in a message
  ["generator/commands/stepper_checks.lua"] = true,
  ["generator/commands/motion_checks.lua"] = true,
  ["generator/commands/forced.lua"] = true,
  ["generator/plan/decision.lua"] = true, ["generator/plan/search.lua"] = true,
  ["generator/commands/mesh.lua"] = true, ["generator/report/bench.lua"] = true,
  ["generator/plot/times.lua"] = true, ["generator/report/values.lua"] = true }

local METHODS = { "gsub", "match", "format", "sub", "rep", "find", "gmatch", "byte", "lower", "upper", "len",
  "reverse" }

-- ---- reading ----

local files, lines_of = sources.files, sources.lines

-- Lua lines without comments and with strings emptied, so that prose about pairs() is not code. Long strings and
-- comments are blanked as wholes, line by line.
local function code_of(path)
  local list, closing = {}, nil
  for i, line in ipairs(lines_of(path)) do
    local out = ""
    while line ~= "" do
      if closing then
        local _, to = line:find(closing, 1, true)
        line = to and line:sub(to + 1) or ""
        closing = to == nil and closing or nil
      else
        local from, to, mark = line:find("(%-?%-?%[=*%[)")
        local quote = line:find("[\"']")
        local comment = line:find("--", 1, true)
        if quote and (not from or quote < from) and (not comment or quote < comment) then
          local q, at = line:sub(quote, quote), quote + 1
          while at <= #line and line:sub(at, at) ~= q do
            at = at + (line:sub(at, at) == "\\" and 2 or 1)
          end
          out = out .. line:sub(1, quote - 1) .. "''"
          line = line:sub(at + 1)
        elseif from and mark:find("%[=*%[$") and (not comment or from <= comment) then
          closing = "]" .. mark:match("%[(=*)%[") .. "]"
          out = out .. line:sub(1, from - 1)
          line = line:sub(to + 1)
        elseif comment then
          out = out .. line:sub(1, comment - 1)
          line = ""
        else
          out = out .. line
          line = ""
        end
      end
    end
    list[i] = out
  end
  return list
end

-- One test: nothing in `faults` (a list of "file:line: what").
local function clean(name, faults)
  return tap.ok(#faults == 0, name, table.concat(faults, "\n"))
end

local function contains(list, x)
  for _, y in ipairs(list) do
    if x == y then
      return true
    end
  end
  return false
end

local GENERATOR = files("generator -name '*.lua'")
local C_FILES = files("src", "templates", "tests -name '*.[ch]'")
tap.ok(#GENERATOR > 10 and #C_FILES > 10, "there are files to look at: the test runs in the project's root")

-- ---- arrows ----

local function part_of(module)
  return module:match("^generator%.([%w_]+)") or module
end

do
  local unknown, new, rooms = {}, {}, {}
  for _, path in ipairs(GENERATOR) do
    local module = path:gsub("%.lua$", ""):gsub("/", ".")
    local part = part_of(module)
    if ARROWS[part] == nil then
      unknown[#unknown + 1] = path .. ": part '" .. part .. "' has no row in ARROWS"
    end
    for n, line in ipairs(lines_of(path)) do
      -- only a string that can be required, now or later: comments talk about require too
      local code = line:gsub("^%s*%-%-.*", ""):gsub("%f[%w]later ", "require ")
      for target in code:gmatch("require%s*%(?%s*[\"']([%w_.]+)[\"']") do
        local to = part_of(target)
        if to ~= part and to ~= "later" and not contains(ARROWS[part] or {}, to) then
          new[#new + 1] = string.format("%s:%d: %s -> %s", path, n, part, to)
        end
        local room = path:match("^generator/ir/(%w+)/")
        local inside = false
        for _, known in ipairs(ROOMS[room] or {}) do
          inside = inside or target == known or target:sub(1, #known + 1) == known .. "."
        end
        if room and not inside and path ~= PASS_LIST then
          rooms[#rooms + 1] = string.format("%s:%d: requires %s", path, n, target)
        end
      end
    end
  end
  clean("every part of the generator has its row in the table of arrows", unknown)
  clean("the generator's parts require only what the table allows", new)
  clean("the algebra ends at the edge of ir/lower; passes know the instruction table and not each other", rooms)
end

-- "src/cli" + "../runtime/polhode.h" -> "src/runtime/polhode.h"
local function join(folder, name)
  local parts = {}
  for part in (folder .. "/" .. name):gmatch("[^/]+") do
    if part == ".." then
      parts[#parts] = nil
    else
      parts[#parts + 1] = part
    end
  end
  return table.concat(parts, "/")
end

local function exists(path)
  local file = io.open(path)
  if file then
    file:close()
  end
  return file ~= nil
end

local function unit_of(path)
  return path:match("^src/cli/bench%f[/]") or path:match("^src/cli/fit%f[/]") or path:match("^src/[^/]+")
    or path:match("^templates/target%f[/]")
    or path:match("^tests/coverage%f[/]") or path:match("^tests/bench%f[/]") or path:match("^tests/fuzz%f[/]")
    or path:match("^[^/]+")
end

-- Where a quoted include leads: beside the file, or on the include path of its unit.
local function resolve(path, name)
  local folder = path:match("^(.*)/")
  for _, base in ipairs { folder, "tests", "src/cli", "src/runtime", "templates/target" } do
    if exists(join(base, name)) then
      return join(base, name)
    end
  end
  return join(folder, name)
end

do
  local own, outside = {}, {}
  for _, path in ipairs(C_FILES) do
    local rule = INCLUDES[unit_of(path)] or { own = {}, outside = {} }
    for n, line in ipairs(lines_of(path)) do
      local quoted, system = line:match('^%s*#%s*include%s+"([^"]+)"'), line:match("^%s*#%s*include%s+<([^>]+)>")
      if quoted and not quoted:find("${", 1, true) then
        local target, allowed = resolve(path, quoted), false
        for _, prefix in ipairs(rule.own) do
          allowed = allowed or target:sub(1, #prefix) == prefix
        end
        if not allowed then
          own[#own + 1] = string.format("%s:%d: includes %s", path, n, target)
        end
      end
      local glue = path:find("^templates/projects/") and APPLICATIONS[system] or
          path:find("^templates/projects/fmu_") and GLUE[system] or
          path:find("^templates/projects/python_") and system == "Python.h" or
          path:find("^templates/sweep/sweep") and PROGRAM[system] or system and system:find("${", 1, true)
      if system and unit_of(path) == "templates" and not EMITTED[system] and not glue then
        outside[#outside + 1] = string.format("%s:%d: emitted code includes <%s>", path, n, system)
      end
      for _, other in pairs(INCLUDES) do -- any order
        for _, pattern in ipairs(other.outside) do
          if system and system:find(pattern) and not contains(rule.outside, pattern) then
            outside[#outside + 1] = string.format("%s:%d: includes <%s>", path, n, system)
          end
        end
      end
    end
  end
  clean("C units include only their own headers and the library's public one", own)
  clean("Lua, GMP, MPFR and GSL stay in the units that may know them; emitted code needs only the C library", outside)
end

-- ---- circles, and names that say nothing ----

do
  local found, home = circles.find(files("src -name '*.c'"))
  clean("no circle among the files of C: of two that use each other, one is in the wrong place", found)
  tap.ok(home.ph_top_wheel and home.effect_wheel and home.rational_charge and not home.wheel,
    "which is read off functions and objects that are not static")
end

-- ---- habits that would break sameness ----

do
  local order, numbers, methods = {}, {}, {}
  for _, path in ipairs(GENERATOR) do
    local text, code = lines_of(path), code_of(path)
    for n, line in ipairs(code) do
      local where = string.format("%s:%d: %s", path, n, text[n])
      -- a line that copies or compares whole tables must say so in a comment: "-- any order"
      local sensitive = path:find("^generator/emit/") or path:find("^generator/ir/") or path:find("^generator/methods/")
        or path:find("^generator/dynamics/") or path:find("^generator/report/")
      if sensitive and (line:find("%f[%w_]pairs%s*%(") or line:find("%f[%w_.]next%s*,"))
        and not text[n]:find("%-%-.*order") then
        order[#order + 1] = where
      end
      if not PRINTS_NUMBERS[path] then
        -- the format is in the string: look at the text of a line whose code formats; %.17g loses nothing
        if line:find("string%.format") and text[n]:gsub("%%%.17g", ""):find("%%[%-+ #0]*%d*%.?%d*[aAeEfgG]%f[^%w]")
          and not line:find("error") then
          numbers[#numbers + 1] = where
        end
        if path:find("^generator/emit/") and line:find("%f[%w_]tostring%s*%(") and not line:find("error") then
          numbers[#numbers + 1] = where
        end
      end
      for _, method in ipairs(METHODS) do
        if line:find(":" .. method .. "%s*[%(\"'{]") then
          methods[#methods + 1] = where
        end
      end
    end
  end
  for _, path in ipairs(files("templates")) do
    for n, line in ipairs(lines_of(path)) do
      if line:find("^%%%%") and line:find("tostring", 1, true) then
        numbers[#numbers + 1] = string.format("%s:%d: %s", path, n, line)
      end
    end
  end
  clean("no hash order on the way to output", order)
  clean("numbers become text in one place", numbers)
  clean("strings have no methods in the generator: their metatable is the scene's", methods)
end

do
  local faults = {}
  for _, path in ipairs(files("tests -name '*.t'")) do
    local handle = io.popen("test -x " .. path .. " && echo yes")
    if handle:read("l") ~= "yes" then
      faults[#faults + 1] = path .. " is not executable"
    end
    handle:close()
  end
  clean("every test can be executed", faults)
end

tap.done()
