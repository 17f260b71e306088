#!/usr/bin/env lua5.4
-- side.t - gen --name: float and double of one scene in one program; and NAME_normalise of both.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"
local WARN = "-std=c99 -O1 -ffp-contract=off -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"

local function sh(command)
  local pipe = assert(io.popen("{ " .. command .. "; } 2>&1"))
  local text = pipe:read "a"
  return text, pipe:close() == true
end

local text, ok = sh(string.format("%s gen bodies/brick_centroid.lua --name wide -o %s && "
  .. "%s gen bodies/brick_centroid.lua --name small --real float --libm own -o %s", binary, dir, binary, dir))
tap.ok(ok and text == "", "two names of one scene into one directory", text)
text, ok = sh(string.format("cd %s && cc %s -c wide.c small.c && { nm wide.o; nm small.o; } | "
  .. "sed -n 's/.* [TDBRC] //p' | sort | uniq -d", dir, WARN))
tap.ok(ok and text == "", "both compile without a warning, and no name is in both", text)
text, ok = sh(string.format("gcc -std=c11 -O1 -I%s -o %s/side tests/emit/side.c %s/wide.o %s/small.o -lm && %s/side",
  dir,
  dir, dir, dir, dir))
tap.ok(ok, "one program links both", text)
local apart, e1, e2 = text:match "apart (%S+)\nenergy (%S+) (%S+)\n"
-- |w| < 10 and |q| <= 1; 100 steps round each of the rates at most twice in an epsilon of 2^-23: 200 of 6e-7
tap.ok(apart and tonumber(apart) > 0 and tonumber(apart) < 200 * 10 * 2.0 ^ -24,
  "and both go the same way, each in its type",
  text)
tap.ok(e1 and tonumber(e1) < 1e-12 and tonumber(e2) < 1e-4, "with the energy as it was", text)
for _, name in ipairs { "wide", "small" } do
  local norm, part, wrong = text:match(name .. " (%S+) (%S+) (%d+)\n")
  norm, part = tonumber(norm), tonumber(part)
  tap.ok(norm and norm > 0.5 and norm <= 2, name .. ": | |q| - 1 | is at most 2 epsilon", norm)
  tap.ok(part and part > 0.5 and part < 3, name .. ": each component is right to 3 epsilon", part)
  tap.is(wrong, "0", name .. ": 0, infinities and what is no number are refused, and nothing else")
  if norm then tap.diag(string.format("%s: |q| off by %.2f epsilon at worst, a component by %.2f", name, norm,
    part)) end
end

program.finish()
tap.done()
