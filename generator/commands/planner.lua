-- planner.lua -- the plan that an accuracy asks for: compiled candidates, the cache, progress.
--
-- A decision is kept under the user's cache folder by what determines it (decision.question); without such a folder, or
-- with a file that is not whole, it is made again.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local build = later "generator.commands.build"
local progress = later "generator.commands.progress"
local driver = require "generator.driver"
local candidates = later "generator.plan.candidates"
local decision = later "generator.plan.decision"
local plan = later "generator.plan.plan"
local targets = require "generator.cost.targets"
local known = require "generator.methods.methods"

local planner = {}

-- What is asked of the scene: accuracy of the command line or its own, and the rest; nil if nobody asks.
function planner.question(scene, given, order)
  local budget, methods = scene.record.budget or {}, nil
  local accuracy = given.accuracy or scene.record.accuracy
  if not accuracy then return nil end
  for _, name in ipairs(given.method or {}) do
    methods = methods or {}
    if name ~= "linearised" then methods[#methods + 1] = name end
  end
  return { job = scene, accuracy = accuracy, real = given.real or budget.real or "double",
    target = budget.target or targets.default, ops = budget.ops, methods = methods, order = order }
end

-- The methods that the scene admits, for stiff equations or the others; second result: is the series among them?
local function admitted(q, stiff)
  local names, seen = {}, {}
  for _, c in ipairs(candidates.of(q.job, { real = q.real, orders = { 8 } })) do
    local m = known.by_name[c.method]
    if (m and m.stiff or false) == stiff and not c.refused and not seen[c.method] then
      names[#names + 1], seen[c.method] = c.method, true
    end
  end
  return names, seen.taylor
end

-- Code to count in and a plugin with these methods; nil and what went wrong.  real: nil, the question's.
local function compiled(host, q, names, series, real)
  local function planned(orders)
    return assert(driver.plan(q.job, { real = real or q.real, methods = names, order = q.order or plan.top,
      command = "", orders = orders }))
  end
  local all = planned(series and (q.order and { q.order } or plan.orders) or {})
  local plugins, failed = build.plugins(host, { { job = all } })
  if failed then return nil, failed[1].message end
  failed = build.refusal(all, plugins[1])
  if failed then return nil, failed end
  return { code = driver.code(planned()), plugin = plugins[1] }
end

-- Compiles what the question needs: its `code` to count in and its `plugin`; and where the motion is `stiff`
-- (plan/stiffness.lua), or a method for that is asked for, the same with these methods, by their names, as `apart`; in
-- double, which serves as truth, as `sure`.
-- True, or nil and what went wrong.
function planner.prepare(host, q)
  local made, why = compiled(host, q, admitted(q, false))
  if not made then return nil, why end
  q.host, q.code, q.plugin, q.stiff, q.apart = host, made.code, made.plugin, nil, {}
  q.stiff = plan.stiff(q)
  local asked = q.stiff ~= nil
  for _, name in ipairs(q.methods or {}) do
    local m = known.by_name[name]
    asked = asked or m and m.stiff
  end
  local names = asked and admitted(q, true) or {}
  if #names == 0 then return true end
  made, why = compiled(host, q, names)
  for _, name in ipairs(names) do q.apart[name] = made end
  q.sure = made
  if made and q.stiff and q.real ~= "double" then q.sure, why = compiled(host, q, names, nil, "double") end
  return q.sure and true, why
end

-- Makes the decision; nil and what went wrong outside.
local function decided(host, q)
  local bar = progress.of(host)
  bar.show("compiling", 0)
  local fine, why = planner.prepare(host, q)
  q.progress = function(part) bar.show("planning", 0.3 + 0.7 * part) end
  q.progress(0)
  local found, instead
  if fine then found, instead = plan.find(q) end
  bar.clear()
  if not fine then return nil, why end
  return found and decision.made(q, found) or decision.refusal(q, instead)
end

-- The decision that was kept for the question, or nil; its text and file name.
function planner.kept(host, q)
  local print = host.fingerprint()
  if not print then return nil end
  local text = decision.question(q, print)
  local name = decision.key(text)
  return decision.kept(text, host.cache_read(name), #q.job.states), text, name
end

-- Accuracy, budget and ranges of the scene as lines of a report, with the plan where one was kept; nil without any.
function planner.asked(host, scene, given)
  local record, q = scene.record, planner.question(scene, given)
  if not (q or record.budget or scene.ranges) then return nil end
  local lines = decision.asked(scene, q)
  local d = q and planner.kept(host, q)
  if d and d.refused then
    lines[#lines + 1] = "cannot be held: " .. d.refused
  elseif d then
    lines[#lines + 1] = "planned: " .. d.title
  elseif q then
    lines[#lines + 1] = "not planned yet: polhode gen does it"
  end
  return lines
end

-- The decision for the question, or nil after an error in the scene's diagnostics (or second result: what went wrong).
-- told: the accuracy is the command line's.
function planner.decide(host, q, told)
  local d, text, name = planner.kept(host, q)
  if not d then
    local why
    d, why = decided(host, q)
    if not d then return nil, why end
    if name then host.cache_write(name, decision.text(text, d)) end
  end
  if d.refused then
    local line = q.job.record.line
    q.job.diag:error(told and line or q.job.diag:locate(line, "accuracy"), "accuracy", d.refused, d.got)
    return nil
  end
  return d
end

return planner
