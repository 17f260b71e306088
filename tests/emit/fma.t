#!/usr/bin/env lua5.4
-- fma.t - fused multiplication is used only where the processor has it in the real type.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A Cortex-M4F says __ARM_FEATURE_FMA and fuses in float alone (__ARM_FP 4); newlib's fma() of doubles is a*b + c,
-- rounded twice, so that the low part of a pair's product would be lost.  The preprocessor is told what such processors
-- say.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local program = require "tests.cli.program"
local driver = require "generator.driver"

local dir = program.directory()
local rows = {
  { "a processor that says nothing", "", false, false },
  { "a Cortex-M4F", "-D__ARM_FEATURE_FMA=1 -D__ARM_FP=4", false, true },
  { "a Cortex-M7", "-D__ARM_FEATURE_FMA=1 -D__ARM_FP=12", true, true },
  { "an AArch64", "-D__ARM_FEATURE_FMA=1 -D__ARM_FP=14", true, true },
}
for _, path in ipairs { "brick_centroid", "symmetric_top" } do
  for i, real in ipairs { "double", "float" } do
    local job = scene.plan(scene.file("bodies/" .. path .. ".lua"), { real = real })
    local code = driver.code(job).code
    program.write(dir .. "/" .. path .. ".h", code.header)
    program.write(dir .. "/" .. path .. ".c", (code.source:gsub("#include <math.h>", "")))
    for _, row in ipairs(rows) do
      local pipe = assert(io.popen(string.format("cc -E -U__FMA__ -U__FP_FAST_FMA -U__FP_FAST_FMAF %s %s/%s.c 2>&1",
        row[2], dir, path)))
      local text = pipe:read "a"
      tap.ok(pipe:close(), path .. ", " .. real .. ", " .. row[1] .. ": read")
      -- by name, or where the functions are the code's own (float) the compiler's
      local fused = text:find "%f[%w_]fmaf?%(" or text:find "%f[%w_]__builtin_fmaf?%("
      tap.is(fused ~= nil, row[2 + i], path .. ", " .. real .. ": fused on " .. row[1])
    end
  end
end

program.finish()
tap.done()
