#!/usr/bin/env lua5.4
-- attitude.t -- the attitude in other numbers (gen --with attitude): matrix, rotation vector, Euler angles of twelve
-- sequences, vectors turned; double and float, against the library, which computes in long double.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local WARN = "-std=c99 -O1 -ffp-contract=off -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"

-- In epsilons, for components of q that are rounded to half an epsilon, so that |q|^2 is off by up to 2 of them (q is
-- given in the type; the library divides by |q|^2, the emitted functions take it as 1).
-- matrix: three roundings of terms whose sum is at most 1, and |q|^2.  rotate: the header's bound.  back: twice that.
-- vector: the quotient of lengths, an arctangent and three products, in parts of pi.  euler: two arctangents and the
-- root; each of first and third is multiplied by the sine that its direction has left.  turned: the angles above put
-- back in, each half of it.  set: three products of sines and cosines.
local BARS = { matrix = 4, rotate = 16, back = 32, vector = 4, euler = 12, turned = 16, set = 4, range = 1 }

for _, real in ipairs { "double", "float" } do
  local out = dir .. "/" .. real
  local build = "{ BINARY gen brick_centroid --with attitude --real REAL --layout single -o OUT && " ..
    "gcc WARN -c -o OUT/brick.o OUT/brick_centroid.c && gcc -std=c11 -O1 -include OUT/brick_centroid.h " ..
    "-DNAME=brick_centroid -Isrc/runtime -o OUT/attitude tests/emit/attitude.c OUT/brick.o build/libpolhode.a -lgsl " ..
    "-lgslcblas -lexpat -lm && OUT/attitude; } >OUT.out 2>&1"
  local code = program.shell((build:gsub("%u%u%u+", { BINARY = binary, REAL = real, OUT = out, WARN = WARN })))
  local text = program.read(out .. ".out") or ""
  tap.is(code, 0, real .. ": compiles without a warning and runs")
  if code ~= 0 then tap.diag(text) end
  for _, name in ipairs { "matrix", "rotate", "back", "vector", "euler", "turned", "set", "range" } do
    local worst = tonumber(text:match("%f[%w]" .. name .. " (%S+)"))
    tap.ok(worst and worst > 0 and worst <= BARS[name], string.format("%s: %s to %s epsilon", real, name, worst))
  end
  tap.is(text:match "refused (%d+)", "0", real .. ": what is no sequence and no angle is refused")
  tap.ok(tonumber(text:match "singular (%d+)" or "0") > 2000, real .. ": singular poses are said")
  tap.is(text:match "third (%d+)", "0", real .. ": and their third angle is 0")
end

local code, text = program.shell(string.format("%s gen brick_centroid --only euler -o %s/one >%s.said 2>&1", binary,
  dir, dir)), program.read(dir .. "/one/brick_centroid.h") or ""
tap.ok(code == 0 and text:find("_euler(", 1, true) and not text:find("_matrix(", 1, true) and
  not text:find("_step(", 1, true), "--only euler: that one alone")
code = program.shell(string.format("%s gen brick_centroid -o %s/none >%s.said 2>&1", binary, dir, dir))
text = program.read(dir .. "/none/brick_centroid.h") or "_euler("
tap.ok(code == 0 and not text:find("_euler(", 1, true), "and none unless they are asked for")

program.finish()
tap.done()
