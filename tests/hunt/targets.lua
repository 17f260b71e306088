-- targets.lua - what the hunt searches: each target's program, and how it is built.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A target: name; source (tests/hunt/); scene, emitted with `real` as `code`.c, or none; defines; `share`: the part of
-- the states asked for that it searches, as some are slow; `judge`: what judges, for the page.

local targets = {}

local FREE = "tests/oracle/free_top.c: the textbook's formulas in MPFR"
-- kinds of free.c: the scene, its name, what is defined, the share
local FREES = { free_top = { "tests/bench/errormap.lua", "errormap", {}, 1 },
  free_tensor = { "tests/hunt/tensor.lua", "tensor", { "FULL" }, 0.1 },
  symmetric_top = { "tests/hunt/symmetric.lua", "symmetric", { "SYMMETRIC" }, 0.1 } }

local function free(name, real)
  local scene, code, defines, share = table.unpack(FREES[name])
  return { name = name, real = real, source = "free.c", judge = FREE, scene = scene, code = code, defines = defines,
    share = share }
end

local function heavy(real)
  return { name = "heavy_top", real = real, source = "heavy.c", scene = "tests/hunt/lagrange.lua", code = "lagrange",
    defines = {}, share = 0.01, judge = "tests/oracle/heavy_top.c: a Taylor series in MPFR" }
end

local function principal(real)
  return { name = "principal", real = real, source = "principal.c", scene = "tests/hunt/tensor.lua", code = "tensor",
    defines = {}, share = 0.1, judge = "Jacobi's method in MPFR" }
end

local function own(real)
  return { name = "libm", real = real, source = "libm.c", header = "tests/hunt/own.lua", defines = {}, share = 0.1,
    judge = "MPFR" }
end

local function step(real)
  return { name = "step", real = real, source = "step.c", scene = "tests/hunt/steps.lua", code = "steps",
    method = "rk4,taylor", defines = {}, share = 0.1, judge = FREE }
end

targets.list = { free("free_top", "double"), free("free_top", "float"), free("free_tensor", "double"),
  free("free_tensor", "float"), free("symmetric_top", "double"), free("symmetric_top", "float"),
  heavy "double", heavy "float",
  principal "double", principal "float", own "double", own "float", step "double", step "float",
  { name = "elliptic", real = "double", source = "elliptic.c", defines = {}, share = 0.001,
    judge = "tests/oracle/free_top.c: Carlson's duplication and Landen's transformation in MPFR" } }

local ERRORS = {
  ["free.c"] = { "rates", "attitude", "norm", "library_rates", "library" },
  ["heavy.c"] = { "rates", "attitude", "norm" },
  ["step.c"] = { "rk4_rates", "rk4_attitude", "taylor_rates", "taylor_attitude" },
  ["principal.c"] = { "moments", "skew", "residue", "library_moments", "library_skew", "library_residue" },
  ["elliptic.c"] = { "K", "E", "Pi", "F_phi", "E_phi", "Pi_phi", "sn", "cn", "dn", "am" },
  ["libm.c"] = { "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh", "tanh", "cbrt", "atan2",
    "pow" },
}

-- The objective's name in files and tests: hunt_TARGET[_float]_ERROR; t: a target, or a row of records.lua.
function targets.label(t, error)
  return "hunt_" .. (t.target or t.name) .. (t.real == "float" and "_float_" or "_") .. error
end

-- The errors of a target, in the order in which its program prints them.
function targets.errors(t) return ERRORS[t.source] end

-- Those whose name, with or without _float, is in `words` (nil: all).
function targets.chosen(words)
  if not words or words == "" then return targets.list end
  local list = {}
  for word in string.gmatch(words, "%S+") do
    for _, t in ipairs(targets.list) do
      if word == t.name or word == t.name .. "_" .. t.real then list[#list + 1] = t end
    end
  end
  return list
end

local WARN = "-Wall -Wextra -pedantic -Wconversion -Wdouble-promotion -Wshadow -Wno-unused-function"

-- Builds the program in `directory`; its path, or nil and what was said.  What programs share is made once a run.
-- option: { define = .., level = "-O1" }; the same bits at every level.
local made = {}

function targets.build(t, directory, polhode, option)
  option = option or {}
  local cc, level = os.getenv "CC" or "cc", option.level or "-O2"
  local defines = { table.unpack(t.defines) }
  if t.real == "float" then defines[#defines + 1] = "SINGLE" end
  defines[#defines + 1] = option.define
  local flags = #defines > 0 and "-D" .. table.concat(defines, " -D") or ""
  local program = string.format("%s/%s_%s%s", directory, t.name, t.real, option.define and "_" .. option.define or "")
  local script = { "set -e" }
  -- a file that others use too
  local function once(path, format, ...)
    if not made[path] then script[#script + 1] = string.format(format, ...) end
    made[path] = true
    return path
  end
  local compile = string.format("%s -std=c11 %s -ffp-contract=off -D_XOPEN_SOURCE=700 %s -Isrc/runtime -Itests/hunt",
    cc, level, WARN)
  local from = string.format("%s/%s_%s.code", directory, t.code or t.name, t.real)
  once(from, "mkdir -p %s", from)
  local objects = ""
  for _, name in ipairs { "search", "mutate" } do
    local object = string.format("%s/%s.o", directory, name)
    objects = objects .. " " .. once(object, "%s -c -o %s tests/hunt/%s.c", compile, object, name)
  end
  if t.scene then
    local object = string.format("%s/%s.o", from, t.code)
    once(from .. "/source", "%s gen %s --layout single --with analysis%s --real %s -o %s", polhode, t.scene,
      t.method and " --method " .. t.method or ",orbit", t.real, from)
    objects = objects .. " " .. once(object, "%s -std=c99 %s -ffp-contract=off -c -o %s %s/%s.c", cc, level, object,
      from, t.code)
  end
  if t.header then once(from .. "/own.h", "lua5.4 %s %s > %s/own.h", t.header, t.real, from) end
  script[#script + 1] = string.format("%s %s -I%s -o %s tests/hunt/%s%s build/libpolhode.a $(pkg-config --libs gsl) " ..
    "-lmpfr -lgmp -lm", compile, flags, from, program, t.source, objects)
  local pipe = assert(io.popen("{ " .. table.concat(script, "\n") .. "; } 2>&1"))
  local said = pipe:read "a"
  return pipe:close() and program or nil, said
end

return targets
