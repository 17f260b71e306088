-- runs.lua -- one motion that is drawn, or two: an option of the motion with two values makes two runs.
--
--     runs.of(given) -> {run, ...}: one or two tables of options with one value each, as `polhode run` takes them, and
--                       {[option] = true} of those that differ; or nil and what is wrong
--     runs.labels(list, differs, motions, jobs) -> what each run is called, and what both have in common, or nil
-- SPDX-License-Identifier: GPL-3.0-or-later

local engines = require "generator.commands.run.engines"
local shortest = require("generator.plan.decision").shortest

local runs = {}

-- In the order in which a label has them.
local twofold = { "engine", "method", "step", "tolerance", "order", "real" }

-- What of the parameters' values a run has.
local function set_of(set, n)
  local out = {}
  for name, values in pairs(set) do out[name] = values[n] or values[1] end -- into a table: order is lost anyway
  return out
end

-- A value that stands for both runs belongs to those that can have it: h of rk4 is none of exact.  Where neither can,
-- both keep it, and the engine says why not.
local function left_out(list, given)
  for _, name in ipairs { "step", "tolerance", "order" } do
    local one, other = engines.takes(list[1], name), engines.takes(list[2], name)
    if given[name] and #given[name] == 1 and one ~= other then list[one and 2 or 1][name] = nil end
  end
  if given.real and #given.real == 1 then
    for n, own in ipairs(list) do
      if own.engine ~= "generated" and list[3 - n].engine == "generated" then own.real = nil end
    end
  end
end

function runs.of(given)
  local count, differs = 1, { set = {} }
  for _, name in ipairs(twofold) do
    local values = given[name] or {}
    if #values > 2 then
      return nil, "--" .. name .. " must have one value, or two for two runs, got " .. #values .. " values"
    end
    if #values == 2 then
      if values[1] == values[2] then
        return nil, "--" .. name .. ": " .. (math.type(values[1]) and shortest(values[1]) or values[1]) ..
          " stands there twice"
      end
      count, differs[name] = 2, true
    end
  end
  for name, values in pairs(given.set or {}) do -- into a set: order is lost anyway
    if values[2] then count, differs.set[name] = 2, true end
  end
  local list = {}
  for n = 1, count do
    local own = {}
    for k, v in pairs(given) do own[k] = v end -- into a table: order is lost anyway
    for _, name in ipairs(twofold) do
      local values = given[name]
      own[name] = values and (values[n] or values[1])
    end
    own.set = given.set and set_of(given.set, n)
    list[n] = own
  end
  if count == 2 then left_out(list, given) end
  return list, differs
end

local function seconds(h) return "h = " .. shortest(h) .. " s" end

-- What tells a run from the other: "rk4 (h = 0.01 s)", "a = 0.3 m".
local function label(own, differs, motion, job, same_step)
  local parts = {}
  if differs.engine then parts[#parts + 1] = own.engine end
  if differs.method or differs.engine then parts[#parts + 1] = motion.method end
  if motion.step and not same_step then
    local method = table.concat(parts, " ")
    parts = { method == "" and seconds(motion.step) or method .. " (" .. seconds(motion.step) .. ")" }
  end
  if differs.tolerance then parts[#parts + 1] = "tolerance " .. shortest(own.tolerance) end
  if differs.order then parts[#parts + 1] = "order " .. shortest(own.order) end
  if differs.real then parts[#parts + 1] = own.real end
  for _, p in ipairs(job.model.params) do
    if differs.set[p.name] then parts[#parts + 1] = p.name .. " = " .. p.given end
  end
  return table.concat(parts, ", ")
end

function runs.labels(list, differs, motions, jobs)
  local names, first, second = {}, motions[1], motions[2]
  local same = not second or first.step == second.step
  for n, own in ipairs(second and list or {}) do names[n] = label(own, differs, motions[n], jobs[n], same) end
  return names, same and first.step and (not second and first.method .. ", " or "") .. seconds(first.step) or nil
end

return runs
