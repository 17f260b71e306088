-- fit.lua -- the time of `polhode fit` beside that of scipy's least_squares on solve_ivp, case 01 of the reference.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 tests/bench/fit.lua PROGRAM DIRECTORY        (make bench-fit)
-- From the command line: the whole of it with code generation and compiling (a scene that the cache does not know), and
-- what of it the search takes.  Both programs run in turn, and of each the least time counts, so what else the machine
-- does weighs on both alike.  scipy is Debian's (python3-scipy; .ci/setup python); without it there is no ratio.

package.path = "./?.lua;" .. package.path

local json = require "tests.json"
local files = require "tests.cli.program"

local program, dir = arg[1], arg[2]
local CASE, FREE, ROUNDS = "tests/reference/fit/01_free_ratios", "I2,I3,w1,w2,w3", 7
local BAR = 100 -- how many times faster than the peer the search must be

local SCENE = [[
-- run %s of the bench: a text that no cache knows
local I2, I3 = param("I2", %.17g, "kg m^2"), param("I3", 1.8, "kg m^2")
local w1, w2, w3 = param("w1", 0.91, "rad/s"), param("w2", 1.09, "rad/s"), param("w3", -0.41, "rad/s")
return scene { name = "tumbling", body = tensor { mass = 1, xx = 1, yy = I2, zz = I3 },
  initial = { omega = { w1, w2, w3 } }, measure = { wx = wx, wy = wy, wz = wz, sigma = 0.004 } }
]]

local function output(command)
  local pipe <close> = assert(io.popen(command))
  return pipe:read "a"
end

local function now() return tonumber(output "date +%s.%N") end

local whole, search, peer, passes = math.huge, math.huge, math.huge, 0
local python, count = "/usr/bin/python3", 0
local has_peer = os.execute(python .. " -c 'import scipy' 2> /dev/null")
local estimate, theirs = {}, {}
for round = 1, ROUNDS do
  files.write(dir .. "/tumbling.lua", SCENE:format(now(), 1.44 + round * 1e-9))
  for run = 1, 3 do -- compiled once, then from the cache
    local begun = now()
    local text = output(program .. " fit " .. dir .. "/tumbling.lua --data " .. CASE .. "/log.csv --free " .. FREE ..
      " --format json")
    local made = json.read(text)
    search = math.min(search, made.fit_seconds)
    if run == 1 then whole = math.min(whole, now() - begun) end
    passes = made.passes
    for i, e in ipairs(made.estimates) do estimate[i] = e.estimate end
  end
  if has_peer then
    local words = {}
    for word in output(python .. " tests/bench/fit_scipy.py " .. CASE .. "/log.csv 1"):gmatch "%S+" do
      words[#words + 1] = tonumber(word)
    end
    peer, count, theirs = math.min(peer, words[1]), words[2], { table.unpack(words, 3) }
  end
end

print(string.format("polhode fit, case 01: 18003 values, 5 unknowns, the least of %d runs", ROUNDS * 3))
print(string.format("  from the command line, compiling included  %8.1f ms", whole * 1e3))
print(string.format("  the search (%d passes with derivatives)     %8.2f ms", passes, search * 1e3))
if not has_peer then
  print "  no peer: Debian's python3-scipy is not there"
  os.exit(0)
end
local apart, sigma = 0, json.read(files.read(CASE .. "/case.json")).fits[1].sigma
for i, name in ipairs { "I2", "I3", "w1", "w2", "w3" } do
  apart = math.max(apart, math.abs(estimate[i] - theirs[i]) / sigma[name])
end
print(string.format("  scipy's least_squares (%d integrations)     %8.1f ms", count, peer * 1e3))
print(string.format("  %s - the search is %.0f times faster (%d wanted), %.1g standard errors apart",
  peer >= BAR * search and "ok" or "not ok", peer / search, BAR, apart))
os.exit(peer >= BAR * search and apart < 1e-5)
