#!/usr/bin/env lua5.4
-- libm.t - the emitted code's own mathematical functions: their error, their bits, and that nothing else is called.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The oracle is MPFR (tests/emit/libm.c, which prints the worst error found of each function), for exact operations the
-- C library.
-- The quick tier takes a part of its cases.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local R = require "generator.algebra.rational"
local libm = require "generator.emit.libm"
local number = require "generator.emit.number"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

local function output(format, ...)
  local pipe = assert(io.popen("{ " .. string.format(format, ...) .. "; } 2>&1"))
  local text = pipe:read "a"
  return pipe:close(), text
end

-- ---- the text ----

local ALL = { "huge", "fabs", "copysign", "sqrt", "cbrt", "floor", "frexp", "ldexp", "sin", "cos", "tan", "asin",
  "acos", "atan", "atan2", "exp", "sinh", "cosh", "tanh", "log", "pow" }

local templates = {}
for path in io.popen("ls templates/numeric/libm_*.c"):lines() do templates[path] = program.read(path) end

local function own(real, functions)
  local bits = real == "float" and 24 or 53
  local function n(x) return number.text(R.lift(x), real) end
  local v = { name = "own", zero = n(0), one = n(1), two = n(2), half = n "1/2", quarter = n "1/4", arm_fma = "0",
    split = n(R.new(2) ^ ((bits + 1) // 2) + R.one) }
  local calls = {}
  for i, f in ipairs(functions) do calls[i] = "own_" .. f .. "(" end
  return libm.source(v, { name = "own", real = real }, templates, table.concat(calls, " "))
end

-- Each function alone brings all that it calls and nothing more: no warning, and no undefined symbol but of the driver.
local STRICT = "-std=c99 -O2 -ffp-contract=off -fno-math-errno -pedantic -Wall -Wextra -Wconversion " ..
  "-Wdouble-promotion -Wshadow -Werror"
local PARAMETERS = { huge = "void", frexp = "own_real x, int *e", ldexp = "own_real x, int n",
  copysign = "own_real x, own_real y", atan2 = "own_real x, own_real y", pow = "own_real x, own_real y" }
local ARGUMENTS = { huge = "", frexp = "x, e", ldexp = "x, n", copysign = "x, y", atan2 = "x, y", pow = "x, y" }
for _, real in ipairs(tier.every(2, { "float", "double" })) do
  local list = {}
  for _, f in ipairs(ALL) do
    local path = string.format("%s/%s_%s.c", dir, f, real)
    program.write(path, string.format("#include <stdint.h>\ntypedef %s own_real;\nextern own_real outer(%s);\n%s\n" ..
      "own_real outer(%s)\n{\n  return own_%s(%s);\n}\n", real, PARAMETERS[f] or "own_real x", own(real, { f }),
      PARAMETERS[f] or "own_real x", f, ARGUMENTS[f] or "x"))
    list[#list + 1] = path:match "[^/]*$"
  end
  local fine, said = output("cd %s && gcc %s -c %s && nm -u *_%s.o | grep ' U '; true", dir, STRICT,
    table.concat(list, " "), real)
  tap.ok(fine and said == "", real .. ": each function stands alone, without a warning or an undefined symbol", said)
end

-- ---- errors and bits ----

local BUILD = "-std=c11 -ffp-contract=off -fno-math-errno -Itests -Wno-unused-function"
local clang = output "command -v clang"
for _, real in ipairs(tier.every(2, { "float", "double" })) do
  local text = "#include <stdint.h>\ntypedef " .. real .. " own_real;\n" .. own(real, ALL)
  program.write(dir .. "/own.c", text)
  program.write(dir .. "/root.c", (text:gsub("#if defined __GNUC__ && %(", "#if 0 && (")))
  local function built(compiler, flags, name, source)
    return output("%s %s %s %s -DOWN='\"%s/%s\"' tests/emit/libm.c -o %s/%s -lmpfr -lgmp -lm", compiler, BUILD, flags,
      real == "float" and "-DSINGLE" or "", dir, source or "own.c", dir, name)
  end
  local fine, said = built("gcc", "-O2", "errors")
  if tap.ok(fine, real .. ": the driver compiles", said) then
    fine, said = output("%s/errors", dir)
    tap.diag(said)
    tap.ok(fine, real .. ": the errors are within their bounds", said:match "not ok[^\n]*")
  end
  local hashes = {}
  local function hashed(compiler, flags, source)
    local compiles, why = built(compiler, flags, "hash", source)
    local runs, hash = output("%s/hash bits", dir)
    local tag = compiler .. " " .. flags .. (source and ", root by integers" or "")
    if not (compiles and runs) then tap.ok(false, real .. ": " .. tag .. " compiles and runs", why .. hash) end
    hashes[#hashes + 1] = { tag, hash }
  end
  hashed("gcc", "-O0")
  hashed("gcc", "-O3")
  hashed("gcc", "-O2", "root.c")
  if clang then
    hashed("clang", "-O0")
    hashed("clang", "-O3")
  else
    tap.skip(real .. ": the same bits from clang", "no clang: apt-get install clang")
  end
  for i = 2, #hashes do
    tap.is(hashes[i][2], hashes[1][2], real .. ": the bits of " .. hashes[i][1] .. " are those of " .. hashes[1][1])
  end
end

-- ---- nothing else is called ----

-- Every kind of closed form and of stepper; -O2 -fno-math-errno, as docs/emitted.md promises.
for _, row in ipairs(tier.every(3, {
  { "brick_centroid", "float", "gcc", "exact,adaptive,split2" }, { "symmetric_top", "double", "gcc", "exact,taylor" },
  { "gyrostat", "double", "clang", "exact,rk4" }, { "damped_brick", "double", "gcc", "exact,semi" },
  { "heavy_top", "double", "clang", "exact,rk4" }, { "dual_spin", "float", "clang", "exact,midpoint" },
  { "foucault", "double", "gcc", "exact,rk4" }, { "heavy_top", "float", "clang", "taylor", "--with jacobians" },
})) do
  local name, real, compiler, methods, more = table.unpack(row)
  local tag = string.format("%s, %s, %s, %s", name, real, methods, compiler)
  if compiler == "clang" and not clang then
    tap.skip(tag, "no clang: apt-get install clang")
  else
    program.shell(string.format("rm -rf %s/%s", dir, name))
    local fine, said = output("%s gen bodies/%s.lua --layout single --real %s --libm own --method %s %s -o %s/%s " ..
      "&& cd %s/%s && " ..
      "%s -std=c99 -O2 -ffp-contract=off -fno-math-errno -c %s.c -o u.o && nm -u u.o", binary, name, real, methods,
      more or "", dir, name, dir, name, compiler, name)
    tap.ok(fine and said == "", tag .. ": no undefined symbol", said)
    local text = program.read(string.format("%s/%s/%s.c", dir, name, name))
    tap.ok(not text:find("math.h", 1, true), tag .. ": no <math.h>")
  end
end

-- ---- the choice ----

for _, row in ipairs(tier.every(3, { { "", "sin(", "double" }, { "--real float", "heavy_top_sin(", "float" },
  { "--real float --libm system", "sinf(", "float, system" }, { "--libm own", "heavy_top_sin(", "double, own" } })) do
  output("%s gen bodies/heavy_top.lua --layout single %s -o %s/choice", binary, row[1], dir)
  local text = program.read(dir .. "/choice/heavy_top.c")
  local system = not row[2]:find "_"
  local includes = text:find("#include <math.h>", 1, true) ~= nil
  tap.ok(text:find("%f[%w_]" .. row[2]:gsub("%(", "%%(")) and system == includes,
    row[3] .. ": calls " .. row[2] .. "x)")
end

program.finish()
tap.done()
