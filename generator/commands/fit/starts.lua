-- starts.lua -- where else a fit may begin: ranges for --starts, and the linear start of a free body.
--
--     starts.ranges(job, free) -> lists of the lowest and highest values in SI units; or nil and what is wrong
--     starts.linear(plan, free, data) -> for src/cli/fit/linear.c, of each log; nil where the scene has no such start
-- A parameter's range is that of the scene's key `ranges`, else half of its value up and down.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local expr = require "generator.algebra.expr"
local motion = require "generator.algebra.motion"

local starts = {}

local RATES = { "wx", "wy", "wz" }

function starts.ranges(job, free)
  local low, high, given = {}, {}, {}
  for _, p in ipairs(job.ranges and job.ranges.params or {}) do given[p.name] = p end
  for i, p in ipairs(free.params) do
    local x, own = R.todouble(p.default), given[p.name]
    if not own and x == 0 then
      return nil, "--starts: " .. p.name .. " is 0, so its range must be given (ranges = { " .. p.name ..
        " = {lowest, highest} } in the scene)"
    end
    low[i], high[i] = own and R.todouble(own.lo) or x * 0.5, own and R.todouble(own.hi) or x * 1.5
  end
  if #low == 0 then return nil, "--starts: no parameter is free" end
  if #low > 40 then return nil, "--starts: at most 40 parameters" end
  return low, high
end

-- The tensor's entries as constant + slope p over the free parameters: places of these, constants, slopes in one list;
-- nil where they are not linear.
local function entries(m, free)
  local names, place, constant, slope = {}, {}, {}, {}
  for _, p in ipairs(free.params) do names[p.name] = true end
  local rows = {}
  for e = 1, 6 do
    rows[e], constant[e] = {}, m:double(m.inertia[e])
    for k, p in ipairs(free.params) do
      local d = calculus.diff(m.inertia[e], p.sym)
      if not expr.constant(d, names) then return nil end
      rows[e][k] = m:double(d)
      constant[e] = constant[e] - rows[e][k] * R.todouble(p.default)
    end
    local size = math.abs(m:double(m.inertia[e]))
    if math.abs(constant[e]) <= 1e-12 * size then constant[e] = 0.0 end -- what was taken away is rounded
  end
  for k in ipairs(free.params) do
    local moves = false
    for e = 1, 6 do moves = moves or rows[e][k] ~= 0 end
    if moves then place[#place + 1] = k end
  end
  for e = 1, 6 do
    for _, k in ipairs(place) do slope[#slope + 1] = rows[e][k] end
  end
  return #place > 0 and { place = place, constant = constant, slope = slope } or nil
end

-- The column of the rate, which is scale w + bias; nil: there is none.
local function column_of(m, outputs, name)
  local column, w = 0, motion.sym(name)
  for _, o in ipairs(outputs) do
    for i = 1, #o.columns do
      local e = o.e and o.e[i]
      column = column + 1
      local d = e and calculus.diff(e, w)
      if e and d ~= expr.zero and motion.free(d) then
        local rest = calculus.substitute(e, { [w] = expr.zero })
        if motion.free(rest) then return column, m:double(d), m:double(rest) end
      end
    end
  end
  return nil
end

function starts.linear(plan, free, data)
  local m = plan.model
  if #m.record.effects > 0 or not m.has.rates then return nil end
  local made = entries(m, free)
  if not made then return nil end
  made.column, made.scale, made.bias, made.initial, made.own = {}, {}, {}, {}, {}
  local own = {}
  for _, s in ipairs(plan.fit.states) do own[#own + 1] = s.name ~= "qw" and s.name or nil end
  for i, name in ipairs(RATES) do
    made.column[i], made.scale[i], made.bias[i] = column_of(m, plan.record.measure, name)
    if not made.column[i] then return nil end
    made.initial[i], made.own[i] = 0, 0
    for k, p in ipairs(free.params) do
      if m.states.by_name[name].initial == p.sym then made.initial[i] = k end
    end
    for k, word in ipairs(own) do
      if word == name then made.own[i] = k end
    end
  end
  local list = {}
  for i in ipairs(data) do list[i] = made end
  return list
end

return starts
