-- ops.lua -- what one step, or one evaluation of a closed form, costs in operations: counted in the emitted code.
--
--     ops.of(job, candidate) -> { step = counts, setup = counts or nil }, or nil and why
-- job: the unit (driver.code) of a plan with the candidate's method and real type.  candidate:
-- {method, order (of taylor; any up to 30, the emitted one by default), setting = "step" | "tolerance"}.  A step with
-- a tolerance is one that is accepted, its share of the control included.  A closed form ("exact") has NAME_solve as
-- set-up and NAME_at as its step.
-- counts: {add, mul, div, sqrt, call} of the whole, and besides, for what a processor takes: fma, cmp (comparisons),
-- conv and conv64 (conversions from and to integers), long (operations on integers of 64 bits), mem (numbers in
-- memory), calls (name -> how many of `call`).  Exact where no branch depends on the numbers, else the largest but for
-- what the code calls rare (generator/cost/tally.lua); options.least: the cheapest instead.  For a processor without
-- fused multiplication and addition, as portable C is; options.fma: with it.
-- SPDX-License-Identifier: GPL-3.0-or-later

local tally = require "generator.cost.tally"

local ops = {}

local OPERATION = { add = true, mul = true, div = true, sqrt = true, fma = true, cmp = true, conv = true,
  conv64 = true, mem = true, long = true }

-- The list of functions of the C library that counts may name, for loops in a fixed order.
ops.functions = { "sin", "cos", "exp", "log", "sinh", "cosh", "floor", "frexp", "ldexp", "tan", "tanh", "asin", "acos",
  "atan", "atan2", "pow", "fmod", "hypot", "cbrt", "ceil" }

local function counts(total)
  local c = { call = 0, calls = {} }
  for name in pairs(OPERATION) do c[name] = total[name] or 0 end -- into a table: order is lost anyway
  for _, name in ipairs(ops.functions) do
    if total[name] then c.call, c.calls[name] = c.call + total[name], total[name] end
  end
  return c
end

local function difference(a, b)
  local d = {}
  for name, n in pairs(a) do d[name] = n - (b[name] or 0) end -- into a table: order is lost anyway
  return d
end

-- What was read of the code, kept with it.
local function read(job, options, order)
  local code, readings = job.code, job.readings
  local key = (options.fma and "fma " or "") .. (options.least and "least " or "") .. (order or "")
  if not readings[key] then
    local name = job.model.name
    local top = name .. "_taylor_top"
    readings[key] = tally.read(name, code.header, code.source, { fma = options.fma, least = options.least,
      values = { [top] = order, [name .. "_taylor_lost"] = 0 }, -- where a series is lost, its steps do not count
      constants = order and { [string.upper(name) .. "_ORDER"] = order } })
  end
  return readings[key]
end

-- The operations of one call of an emitted function; nil if there is none.
function ops.call(job, name, options)
  local u = read(job, options or {})
  local full = job.model.name .. "_" .. name
  return tally.has(u, full) and counts(tally.run(u, full)) or nil
end

-- One more step of NAME_..._run, whose seventh argument says how many steps it may do.  Of a run that ends steps at
-- corners the text is counted as that of one step, whatever is asked for: with what begins the run, which is little.
local function controlled(u, run)
  local function cost(steps) return tally.run(u, run, { [7] = steps }) end
  local more = difference(cost(3), cost(2))
  for _, n in pairs(more) do -- any order: is one of them more than 0?
    if n ~= 0 then return counts(more) end
  end
  return counts(cost(1))
end

-- One number of a table of counts, to compare two: divisions and roots count some times as much, functions 30 times.
function ops.weight(c)
  return c.add + c.mul + c.fma + 4 * c.div + 6 * c.sqrt + 30 * c.call
end

function ops.of(job, candidate, options)
  options = options or {}
  local name, method = job.model.name, candidate.method
  if method == "exact" then
    local u = read(job, options)
    local at = "_at" .. (job.closed.full and "" or job.closed.centre and "_centre" or "_rates")
    if not tally.has(u, name .. at) then return nil, "the scene has no closed form" end
    return { step = counts(tally.run(u, name .. at)), setup = counts(tally.run(u, name .. "_solve")) }
  end
  local order = method == "taylor" and (candidate.order or
    math.tointeger(tonumber(string.match(job.code.header, "_ORDER = (%d+)")))) or nil
  local u = read(job, options, order)
  local step = name .. "_" .. method .. "_step"
  if not tally.has(u, step) and job.steppers[1].method.name == method then step = name .. "_step" end
  if not tally.has(u, step) then return nil, "the job was not planned with the method " .. method end
  local run = name .. "_" .. method .. "_run"
  if candidate.setting == "tolerance" and tally.has(u, run) then return { step = controlled(u, run) } end
  return { step = counts(tally.run(u, step)) }
end

return ops
