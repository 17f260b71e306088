#!/usr/bin/env lua5.4
-- words.t - a scene's own names against those of the emitted code: a parameter and a state of an effect are called like
-- each local variable, argument and function of the code.  Either the scene is refused at its line, or the code
-- compiles without a warning.  make check-all takes each fourth word; POLHODE_WORDS=all takes all of them.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"
local tier = require "tests.tier"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()
local STRICT = "gcc -std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror -fsyntax-only"

-- As scenes may call what is theirs: three or more small letters and _.  WORD is a parameter, WORD_own a state.
local SCENE = [[
local k, g = param("kk", 1.5, "N m"), param("gg", 0.3, "1/s")
return scene { name = "s", body = solid.box { x = 1, y = 2, z = 3, mass = param("mm", 2, "kg") },
  effects = { effect.custom { params = { WORD = k },
    states = { WORD_own = { initial = 0.1, unit = "1", rate = function(s) return g*s.WORD_own end } },
    torque = function(s) return { s.WORD*s.q[2], -s.WORD*s.q[3]*s.WORD_own, 0 } end } },
  initial = { omega = {1, 2, 3} } }
]]
local METHODS = { "rk4", "semi", "adaptive", "taylor" }

local function emitted(scene, method, to)
  return program.shell(string.format("{ rm -rf %s; %s gen %s --method %s --with batch,analysis -o %s; } >%s.said 2>&1",
    to, binary, scene, method, to, to))
end

local words, seen = {}, {}
for _, method in ipairs(METHODS) do
  program.write(dir .. "/s.lua", (SCENE:gsub("WORD", "plain")))
  emitted(dir .. "/s.lua", method, dir .. "/plain")
  for _, tail in ipairs { ".c", "_batch.c", "_analysis.c" } do
    local text = (program.read(dir .. "/plain/s" .. tail) or ""):gsub("/%*.-%*/", "")
    for word in text:gmatch "%f[%w_]%l[%l_]+%l%f[^%w_]" do
      if not seen[word] then words[#words + 1] = word end
      seen[word] = true
    end
  end
end
table.sort(words)
tap.ok(#words > 60, "words of the code", #words)

local stride = os.getenv "POLHODE_WORDS" == "all" and 1 or tier.quick and 20 or 4
for n = 1, #words, stride do
  local word = words[n]
  program.write(dir .. "/s.lua", (SCENE:gsub("WORD", word)))
  local faults = {}
  for _, method in ipairs(METHODS) do
    local to = dir .. "/out"
    local status = emitted(dir .. "/s.lua", method, to)
    if status == 0 then
      status = program.shell(string.format("for c in %s/s*.c; do %s $c || exit 1; done >%s.said 2>&1", to, STRICT, to))
    elseif status == 1 then
      status = (program.read(to .. ".said") or ""):find("/s.lua:", 1, true) and 0 or 1
    end
    if status ~= 0 then faults[#faults + 1] = method .. ": " .. (program.read(to .. ".said") or "") end
  end
  tap.ok(#faults == 0, word .. " is refused or compiles", table.concat(faults, "\n"))
end

-- ---- names of sequences in the recurrences of a series: with functions there are more of them ----

local BOTH = "taylor,semi" -- by semi the parameter is a constant of its own
local FUNCTIONS = [[
local k, one = param("kk", 1.5, "N m"), param("unit", 1, "s")
return scene { name = "s", body = solid.box { x = 1, y = 2, z = 3, mass = param("mm", 2, "kg") },
  effects = { effect.custom { params = { WORD = k }, torque = function(s)
    local w = s.w[1]*one
    return { s.WORD*(tanh(w) + atan(w) + acos(w/9)), -s.WORD*(exp(-w) + log(9 + w) + sin(w) + asin(w/8)),
      s.WORD*(sqrt(9 + w) + cosh(w)/(9 + w) + tan(w/9)) }
  end } },
  initial = { omega = {1, 2, 3} } }
]]
program.write(dir .. "/s.lua", (FUNCTIONS:gsub("WORD", "plain")))
tap.is(emitted(dir .. "/s.lua", BOTH, dir .. "/plain"), 0, "a scene with functions")
local sequences = { "slope", "arc", "square" } -- of what others alone read
for word in program.read(dir .. "/plain/s.c"):gmatch "%f[%w_](%l[%l_]+%l)[_%d]*%[n?%-?j%]" do
  if not seen[word] then sequences[#sequences + 1] = word end
  seen[word] = true
end
tap.ok(#sequences > 8, "sequences", table.concat(sequences, " "))
for n = 1, #sequences, tier.quick and 20 or 1 do
  program.write(dir .. "/s.lua", (FUNCTIONS:gsub("WORD", sequences[n])))
  local status = emitted(dir .. "/s.lua", BOTH, dir .. "/out")
  status = status == 0 and program.shell(STRICT .. " " .. dir .. "/out/s.c >" .. dir .. "/out.said 2>&1") or status
  tap.is(status, 0, sequences[n] .. " as a parameter beside the sequence", program.read(dir .. "/out.said"))
end

program.finish()
tap.done()
