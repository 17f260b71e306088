-- promise.lua - what a plan promises, kept? Runs inside the program (tests/plan/tree.lua).
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Arguments: scene, real type, methods with commas (or -), number of states, accuracies.  For each accuracy one line
--     accuracy got cost ratio tried name
-- got: the largest error over states of the ranges that the planner did not see, by the library; ratio: the plan's cost
-- over the least that meets the accuracy at those states in a sweep of all methods and of settings that cost down to a
-- third of the plan's, in steps of 2 %.

local host, args = ...

local driver = require "generator.driver"
local planner = require "generator.commands.planner"
local candidates = require "generator.plan.candidates"
local ops = require "generator.cost.ops"
local plan = require "generator.plan.plan"
local states = require "generator.plan.states"
local targets = require "generator.cost.targets"
local trial = require "generator.plan.trial"

local file, real, methods, count = args[1], args[2], args[3], math.tointeger(args[4])
local given = { file, real = real, accuracy = 0.5, method = {} }
for name in string.gmatch(methods ~= "-" and methods or "", "[^,]+") do table.insert(given.method, name) end
if methods == "-" then given.method = nil end
local job = driver.read(host, file, given)
local q = planner.question(job, given)
assert(planner.prepare(host, q))
local unseen = states.points(job, real, count, 5000)
local judge = trial.new { host = host, job = job, plugin = q.plugin, T = job.model:double(job.model.horizon) }

-- Every candidate with its cost at a setting, by what the planner counts with but not through it.
local function all()
  local list = {}
  for _, c in ipairs(candidates.of(job, { real = real, methods = q.methods,
    orders = plan.orders, mild = true })) do
    local tolerance = c.method == "taylor" and c.setting == "tolerance"
    if not c.refused and (not tolerance or c.order == plan.orders[1]) then
      if tolerance then c.order = plan.top end
      c.weigh = function(setting)
        local order = tolerance and plan.order(setting, real) or c.order
        local o = ops.of(q.code, { method = c.method, order = order, setting = c.setting })
        return targets.cost(q.target, real, o.step), o.setup and targets.cost(q.target, real, o.setup) or 0
      end
      list[#list + 1] = c
    end
  end
  return list
end

-- The least cost in the sweep, and how many settings were run.
local function sweep(list, cost, accuracy)
  local best, tried = math.huge, 0
  local function try(c, setting)
    local e, steps = judge:worst(c, setting, unseen, accuracy)
    local one, setup = c.weigh(setting)
    tried = tried + 1
    if e <= accuracy then best = math.min(best, setup + steps * one) end
  end
  for _, c in ipairs(list) do
    if c.setting == "none" then
      try(c)
    elseif c.setting == "step" then
      local one, last = c.weigh(), nil
      for _, p in ipairs(unseen) do judge:truth(p) end
      local least = plan.least_steps(job, c, unseen, judge.T)
      for k = 0, 55 do
        local n = math.floor(cost / 3 * 1.02 ^ k / one)
        if n >= least and n ~= last and n * one < best then try(c, judge.T / n) end
        last = n
      end
    else
      local low, high = 1e-15, 1e-2
      for k = 0, 60 do
        local setting = high * (low / high) ^ (k / 60)
        local _, steps = judge:worst(c, setting, { unseen[1] }) -- what a state costs, before a hundred are run
        local one = c.weigh(setting)
        if steps * one > 1.5 * math.min(cost, best) then break end
        try(c, setting)
      end
    end
  end
  return best, tried
end

local list = all()
for k = 5, #args do
  q.accuracy = tonumber(args[k])
  local r, bad = plan.find(q)
  if r then
    local got = judge:worst(r.candidate, r.setting, unseen)
    local least, tried = sweep(list, r.cost, q.accuracy)
    host.out(string.format("%s %.3g %.4g %.4g %d %s\n", args[k], got, r.cost, r.cost / math.min(least, r.cost), tried,
      r.candidate.name))
  else
    host.out(string.format("%s none %s\n", args[k], bad.why or ""))
  end
end
