#!/usr/bin/env lua5.4
-- faded.t - damped motions in closed form at any time: no state is without an answer, however large |t| or the rates.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Whatever the body, |L| = |L(0)| exp(-rate t): asked in long double, whose exponents have 15 bits.  Rates that this
-- takes beyond the range are infinite.  That attitudes are true is asked in forced.t, with 400 bits; here that they are
-- unit quaternions, and stay where the rates have faded.  faded.c measures.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local scene = require "tests.scene"

local dir = program.directory()

-- That of forced.t for the free state, and four factors of exp, each to 1.5 roundings.
local BAR = { double = 4e-15 + 6 * 2.0 ^ -52, float = 4e-6 + 6 * 2.0 ^ -23 }
local NORM = { double = 4e-16, float = 4e-16 * 2.0 ^ 29 }

local bodies = { { "ball", 3, 3, 3 }, { "top", 3, 3, 5 }, { "brick", 3, 4, 5 } }
local number = 0
for _, body in ipairs(bodies) do
  for _, real in ipairs { "double", "float" } do
    for _, rate in ipairs { "0.25", "-0.25" } do
      number = number + 1
      local folder = dir .. "/" .. number
      local job = assert(scene.read(string.format('return scene { name = "top", body = tensor { mass = 1, xx = %d, ' ..
        'yy = %d, zz = %d }, effects = { effect.damping { rate = %s } } }\n', body[2], body[3], body[4], rate)))
      local files = scene.files(scene.plan(job, { real = real }))
      program.shell("mkdir -p " .. folder)
      for _, name in ipairs { "top.h", "top.c" } do program.write(folder .. "/" .. name, files[name]) end
      program.write(folder .. "/scene.h", string.format("#define RATE (%s)\n#define SINGLE %d\n#define MOMENTS " ..
        "{%d, %d, %d}\n#define BAR %.3gL\n#define NORM %.3gL\n", rate, real == "float" and 1 or 0, body[2], body[3],
        body[4], BAR[real], NORM[real]))
      local code = program.shell(string.format("(cd %s && gcc -std=c11 -O1 -ffp-contract=off -c top.c && gcc " ..
        "-std=c11 -O1 -I. -o measure $OLDPWD/tests/emit/faded.c top.o -lm && ./measure >out) >%s/log 2>&1", folder,
        folder))
      local what = string.format("%s, %s, rate %s", body[1], real, rate)
      if tap.ok(code == 0, what .. ": compiles and runs", program.read(folder .. "/log")) then
        local count, none, length, wrong, infinite, off = program.read(folder .. "/out"):match(
          "^(%d+) (%d+) (%d+) (%d+) (%d+) (%d+)\n")
        tap.is(none, "0", what .. ": of " .. tostring(count) .. " states none is without a number")
        tap.is(length, "0", what .. ": unit quaternions")
        tap.is(wrong, "0", what .. ": |L| is |L(0)| exp(-rate t), or beyond the range")
        tap.is(infinite, "1", what .. ": some are beyond it")
        tap.is(off, "0", what .. ": where the rates have faded they are 0 and the attitude stays")
      end
    end
  end
end

program.finish()
tap.done()
