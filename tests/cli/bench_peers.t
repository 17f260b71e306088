#!/usr/bin/env lua5.4
-- bench_peers.t - other integrators on the emitted right-hand side: do they solve the scene, to what they were asked?
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Reference: the general library, its exact free top and its series at 1e-18 for the heavy top.  Nothing here depends
-- on how fast anything is.
--
-- Bound.  A step that is accepted errs by at most tolerance (1 + |x_n|) in state n by the method's own estimate
-- (SUNDIALS: in the mean square of the states, so that one of seven may err by sqrt 7 of that: SLACK); what it errs
-- grows until the end by the derivative of the end state in the state then.  That growth is measured with the library:
-- the largest change of any state at any end time when one initial state is moved by 1e-6, over 1e-6, times 1 + |x_n|,
-- summed over the states; a step errs later than the start, so its growth is no larger than that of the whole way.
-- The error is at most that sum times the tolerance times the number of steps.

local tap = require "tests.tap"
local program = require "tests.cli.program"
local lua = require "tests.cli.whole"

local dir = program.directory()

program.write(dir .. "/free.lua", [[
return scene { name = "free", body = solid.box { x = 0.2, y = 0.1, z = 0.0333, mass = 1 },
  initial = { omega = {1, 6.5, 1} }, time = { horizon = 4 } }
]])
program.write(dir .. "/heavy.lua", [[
return scene { name = "heavy", origin = {0, 0, 0},
  body = tensor { mass = 0.4, com = {0, 0, 0.03}, xx = 7.5e-4, yy = 7.5e-4, zz = 5.4e-4, about = "origin" },
  effects = { effect.gravity { g = 9.81 } }, time = { horizon = 0.8 },
  initial = { omega = {0.4, -0.3, 60}, attitude = {0.9689124217106447, 0.24740395925452294, 0, 0} } }
]])

-- The lines that the text says, each a test of its own: "true what" or something else.
local function holds(text)
  local out = lua(text)
  tap.ok(out ~= nil, "the program runs")
  for line in (out or ""):gmatch "[^\n]+" do
    local good, what = line:match "^(%S+) (.*)$"
    tap.ok(good == "true", what, line)
  end
end

holds [[
local SLACK = math.sqrt(7)
local names = { "free", "heavy" }
local list = {}
for i, name in ipairs(names) do list[i] = { job = plan(name, { methods = { "rk4" } }), peers = true } end
local plugins = assert(build.plugins(host, list))
local order = { ["hand RK4"] = 4, ["GSL rk4"] = 4, ["GSL rk8pd fixed"] = 8 }

for i, p in ipairs(plugins) do
  p:init()
  local job, x0 = list[i].job, numeric.initial(list[i].job)
  local T, times, nx = job.model:double(job.model.horizon), {}, #x0
  for k = 1, 10 do times[k] = T * (0.9 + 0.1 * k / 10) end

  local function library(x)
    local s = numeric.scene(job)
    s.q, s.w = { table.unpack(x, 1, 4) }, { table.unpack(x, 5, 7) }
    return assert(host.run(s, { times = times, method = i == 1 and "exact" or "taylor", tol = 1e-18 }))
  end
  local reference = library(x0)
  local function distance(rows)
    local worst = 0
    for k = 1, #times do
      for n = 2, nx + 1 do worst = math.max(worst, math.abs(rows[k][n] - reference[k][n])) end
    end
    return worst
  end
  local growth = 0
  for n = 1, nx do
    local x, size = { table.unpack(x0) }, math.abs(x0[n])
    x[n] = x[n] + 1e-6
    for k = 1, #times do size = math.max(size, math.abs(reference[k][n + 1])) end
    growth = growth + (1 + size) * distance(library(x)) / 1e-6
  end

  for _, peer in ipairs(host.peers()) do
    local tag = names[i] .. ", " .. peer.name
    local function at(setting)
      local rows, why = p:peer(peer.name, setting, x0, times)
      local r = p:time_peer { name = peer.name, setting = setting, x0 = x0, to = T, repeats = 3 }
      if not rows or not r then say(false, tag .. ": " .. tostring(why)) return math.huge, math.huge end
      say(#rows == 10 and rows[3][1] == times[3] and #rows[3] == nx + 1, tag .. ": a row for every time")
      say(r.least > 0 and r.least <= r.median and r.median <= r.most and r.steps > 0 and r.part == 1,
        tag .. ": times in order")
      return distance(rows), r.steps
    end
    if peer.setting == "step" then
      -- steps where order 8 is still far above rounding and order 4 close to its law
      local h = T / (order[peer.name] == 8 and 100 or 400)
      local one, steps = at(h)
      local two, twice = at(h / 2)
      say(steps == T / h and twice == 2 * steps, tag .. ": the steps asked for")
      local got = math.log(one / two, 2)
      say(math.abs(got - order[peer.name]) < 0.8, tag .. ": half the step, " .. got .. " bits less error")
    else
      local loose, fine = at(1e-5), at(1e-10)
      for _, run in ipairs { { 1e-5, loose }, { 1e-10, fine } } do
        local _, steps = at(run[1])
        local bound = SLACK * steps * run[1] * growth
        say(run[2] <= bound, string.format("%s: at %g error %.2g, bound %.2g", tag, run[1], run[2], bound))
      end
      -- Error control per step gives tolerance^(p/(p + 1)) with the order p of the estimate, at least 4 here: 0.8; or 1
      -- where order varies.  Five decades, of which the constant of the law may take one.
      say(fine <= loose * 10 ^ -(5 * 0.8 - 1), string.format("%s: from %.2g to %.2g by five decades of tolerance", tag,
        loose, fine))
    end
  end
end
]]

-- ---- what is refused ----

holds [[
local list = { { job = plan("free", { methods = { "rk4" } }), peers = true },
  { job = plan("free", { methods = { "rk4" } }) },
  { job = plan("free", { methods = { "rk4" }, real = "float" }), peers = true } }
local with, without, float = table.unpack(assert(build.plugins(host, list)))
local x0 = numeric.initial(list[1].job)
local function refused(part, f, ...)
  local ok, why = pcall(f, ...)
  say(not ok and string.find(why, part, 1, true) ~= nil, "refused: " .. part .. " (" .. tostring(why) .. ")")
end
refused("init first", with.peer, with, "hand RK4", 0.1, x0, { 1 })
for _, p in ipairs { with, without, float } do p:init() end
say(with:info().has.peers and not without:info().has.peers and not float:info().has.peers, "who has peers")
for _, p in ipairs { without, float } do
  local rows, why = p:peer("hand RK4", 0.1, x0, { 1 })
  say(rows == nil and string.find(why, "without peers", 1, true) ~= nil, "a plugin without peers says so")
  rows, why = p:time_peer { name = "GSL rkf45", setting = 0.1, x0 = x0, to = 1 }
  say(rows == nil and string.find(why, "without peers", 1, true) ~= nil, "and when timed")
end
refused("there is no peer heun", with.peer, with, "heun", 0.1, x0, { 1 })
refused("there is no peer heun", with.time_peer, with, { name = "heun", setting = 0.1, x0 = x0, to = 1 })
for _, setting in ipairs { 0, -1, 0 / 0, 1 / 0 } do
  refused("must be positive", with.peer, with, "GSL rkf45", setting, x0, { 1 })
  refused("a positive number", with.time_peer, with, { name = "GSL rkf45", setting = setting, x0 = x0, to = 1 })
end
refused("a positive number", with.time_peer, with, { name = "GSL rkf45", x0 = x0, to = 1 })
refused("times must ascend", with.peer, with, "GSL rkf45", 1e-6, x0, { 1, 0.5 })
refused("times must ascend", with.peer, with, "GSL rkf45", 1e-6, x0, { -1 })
refused("a list of 7 numbers", with.peer, with, "GSL rkf45", 1e-6, { 1 }, { 1 })
say(#with:peer("GSL rkf45", 1e-6, x0, {}) == 0, "no times, no rows")
say(same({ table.unpack(with:peer("GSL rkf45", 1e-6, x0, { 0 })[1], 2) }, x0), "at time 0 the initial state")

local seen = {}
for _, peer in ipairs(host.peers()) do
  seen[peer.name] = (seen[peer.name] or 0) + 1
  local setting = peer.setting == "step" and 1e-9 or 1e-13
  local rows, why = with:peer(peer.name, setting, x0, { 1e9 }, nil, 0.02)
  say(rows == nil and (why == "not done within the limit" or why == "the integrator gives up"),
    peer.name .. " ends when the limit is over")
  local r
  r, why = with:time_peer { name = peer.name, setting = setting, x0 = x0, to = peer.setting == "step" and 1 or 1e9,
    limit = 0.02 }
  if peer.setting == "step" then
    say(r and r.part < 1 and r.steps == 1e9 and r.least > 0, peer.name .. " is timed over a part of the way")
  else
    say(r == nil and (why == "not done within the limit" or why == "the integrator gives up"),
      peer.name .. " is not timed when it does not reach the end")
  end
end
local every = true
for _, name in ipairs { "hand RK4", "GSL rk4", "GSL rk8pd fixed", "GSL rkf45", "GSL rk8pd", "GSL msadams" } do
  every = every and seen[name] == 1
end
say(every, "the peers that need nothing more than GSL are always there")
say((seen["CVODE Adams"] or 0) == (seen["ARKODE ERK8"] or 0), "SUNDIALS as a whole or not at all")
]]

tap.done(program.finish())
