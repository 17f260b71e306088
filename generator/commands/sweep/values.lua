-- values.lua -- what a sweep varies: --over, --sample, --vary, --covariance as the list of a study's values.
--
--     values.read(job, given, wrong) -> {values, grid = number of its points, samples}
-- Messages about the command line are appended to the list `wrong`.  Names are the scene's parameters (in the scene's
-- own unit), its states (SI units), turn_x .. turn_z (a rotation vector in rad about body axes, after the initial
-- attitude), tilt_x .. tilt_z (the same about the axes of space) and attitude=any().
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local covariance = require "generator.commands.sweep.covariance"
local diag = require "generator.diag"
local options = require "generator.commands.options"

local values = {}

local MOST_MEMBERS, MOST_DIMENSIONS = 1 << 53, 21

-- "a=uniform(1,2),b=3" in parts at the commas outside parentheses.
local function split(text)
  local list, depth, from = {}, 0, 1
  for at = 1, #text + 1 do
    local c = string.sub(text, at, at)
    depth = depth + (c == "(" and 1 or c == ")" and -1 or 0)
    if at > #text or c == "," and depth == 0 then
      list[#list + 1] = string.sub(text, from, at - 1)
      from = at + 1
    end
  end
  return list
end

local function number(text)
  local q = R.parse(text)
  local x = q and R.todouble(q)
  return x and x - x == 0 and x or nil
end

-- What a name stands for: a value without its source, or nil and what is wrong.
function values.target(job, name)
  for _, p in ipairs(job.model.params) do
    if p.name == name then
      return { kind = "param", name = name, unit = p.own or p.unit, factor = p.factor or expr.one,
        about = "parameter " .. name }
    end
  end
  local s = job.model.states.by_name[name]
  if s then return { kind = "state", name = name, unit = s.unit, factor = expr.one, about = "initial " .. name } end
  local way, axis = string.match(name, "^(t[ui][rl][nt])_([xyz])$")
  local attitude = job.model.has.attitude
  if attitude and (way == "turn" or way == "tilt") then
    return { kind = "turn", name = name, unit = "rad", body = way == "turn", place = string.byte(axis) - 119,
      about = "turn of the initial attitude about " .. (way == "turn" and "body" or "space") .. " axis " .. axis }
  end
  local names = {}
  for _, p in ipairs(job.model.params) do names[#names + 1] = p.name end
  for _, state in ipairs(job.states) do names[#names + 1] = state.name end
  for _, word in ipairs(attitude and { "turn_x", "turn_y", "turn_z", "tilt_x", "tilt_y", "tilt_z" } or {}) do
    names[#names + 1] = word
  end
  return nil, name .. " is no parameter and no state of the scene (it has " .. table.concat(names, ", ") .. ")" ..
    options.meant(name, names)
end

-- ---- grids ----

-- low:high:count[:log], or one value.
local function axis(text)
  local parts = {}
  for word in string.gmatch(text .. ":", "([^:]*):") do parts[#parts + 1] = word end
  local low, high = number(parts[1]), number(parts[2] or parts[1])
  local count = parts[3] and R.parse(parts[3]) or #parts == 1 and R.one
  if #parts == 2 or #parts > 4 or not low or not high or parts[4] and parts[4] ~= "log" then
    return nil, "must be LOW:HIGH:COUNT, with :log behind it for equal ratios"
  end
  count = count and R.isint(count) and R.toint(count)
  if not count or count < 1 then return nil, "must have a count of points from 1 on" end
  if count == 1 and low ~= high then return nil, "must have two points or more, as its ends differ" end
  if count > 1 and low == high then return nil, "must have ends that differ" end
  if high - low - (high - low) ~= 0 then return nil, "must be within the range of double" end
  if parts[4] and not (low > 0 and high > 0) then return nil, "must have positive ends, as it is logarithmic" end
  return { low = low, high = high, count = count, log = parts[4] ~= nil }
end

-- ---- distributions ----

local DISTRIBUTIONS = {
  uniform = { 2, "uniform(LOW,HIGH)", function(a, b) return a < b or "LOW must be less than HIGH" end },
  loguniform = { 2, "loguniform(LOW,HIGH)", function(a, b) return a > 0 and a < b or
    "LOW must be positive and less than HIGH" end },
  normal = { 2, "normal(MEAN,DEVIATION)", function(_, b) return b > 0 or "DEVIATION must be positive" end },
}
local SHAPES = { "uniform", "loguniform", "normal" }

local function distribution(text)
  local name, inside = string.match(text, "^(%a+)%((.*)%)$")
  local d = DISTRIBUTIONS[name or ""]
  if not d then
    local forms = {}
    for i, word in ipairs(SHAPES) do forms[i] = DISTRIBUTIONS[word][2] end
    return nil, "must be " .. options.either(forms) .. (name and options.meant(name, SHAPES) or "")
  end
  local list = {}
  for _, word in ipairs(split(inside)) do list[#list + 1] = number(word) or false end
  if #list ~= d[1] or not list[1] or not list[2] then return nil, "must be " .. d[2] .. " with two numbers" end
  local fine = d[3](list[1], list[2])
  if fine ~= true then return nil, fine end
  return { kind = name, a = list[1], b = list[2] }
end

-- ---- together ----

-- Appends what `option` says: parts NAME=WHAT, each read by `read`, given to `put`.
local function parts(option, text, wrong, put)
  for _, part in ipairs(split(text)) do
    local name, what = string.match(part, "^([%a_][%w_]*)=(.+)$")
    if not name then
      wrong[#wrong + 1] = option .. " must be NAME=..., got " .. (part == "" and "nothing" or part)
    else
      put(name, what, part)
    end
  end
end

local function attitude(job, put, dimension)
  for i, name in ipairs { "qw", "qx", "qy", "qz" } do
    local target = values.target(job, name)
    target.draw = { kind = "attitude", dimension = dimension, part = i - 1 }
    put(target)
  end
end

-- The names of the file of --covariance; the number of dimensions with them.
local function correlated(host, job, file, dimension, put, wrong)
  local rows, why = nil, nil
  if file then rows, why = covariance.read(host, file) end
  if why then wrong[#wrong + 1] = "--covariance: " .. why end
  for i, row in ipairs(rows or {}) do
    local target, unknown = values.target(job, row.name)
    if unknown then
      wrong[#wrong + 1] = "--covariance: " .. unknown
    else
      target.draw = { kind = "joint", a = row.mean, dimension = dimension, part = i, row = row.factor }
      put(target)
    end
  end
  return dimension + #(rows or {})
end

-- Is a sampled value there without --sample, and the other way round?  Messages.
local function sampled(given, list, wrong)
  local drawn = false
  for _, v in ipairs(list) do drawn = drawn or v.draw ~= nil end
  local function say(text) wrong[#wrong + 1] = text end
  if given.sample and not drawn and #wrong == 0 then
    say "--sample: --vary or --covariance says what is drawn, and there is none"
  end
  if given.sample and (given.sample % 1 ~= 0 or given.sample < 1 or given.sample > MOST_MEMBERS) then
    say("--sample must be a whole number from 1 on, got " .. diag.show(given.sample))
  end
  for _, name in ipairs { "vary", "covariance", "points", "seed" } do
    if given[name] and not given.sample then say("--" .. name .. ": --sample N says how many members are drawn") end
  end
  if given.points == "lhs" and given.sample and given.sample > 1 << 32 then
    say "--points lhs: at most 2^32 members, as it divides each range into so many strata"
  end
  if given.points == "sobol" and given.sample and given.sample > 1 << 32 then
    say "--points sobol: at most 2^32 members"
  end
end

function values.read(host, job, given, wrong)
  local list, seen, grid, dimension = {}, {}, 1, 0
  local function put(v)
    if seen[v.name] then
      wrong[#wrong + 1] = v.name .. " is varied twice"
    else
      seen[v.name] = true
      list[#list + 1] = v
    end
  end
  parts("--over", given.over or "", given.over and wrong or {}, function(name, what, part)
    local target, why = values.target(job, name)
    local a, rule = axis(what)
    if why then wrong[#wrong + 1] = "--over: " .. why end
    if rule then wrong[#wrong + 1] = "--over " .. name .. ": " .. rule .. ", got " .. part end
    if not target or not a then return end
    target.over, grid = a, grid * a.count
    put(target)
  end)
  parts("--vary", given.vary or "", given.vary and wrong or {}, function(name, what, part)
    if name == "attitude" and what == "any()" and job.model.has.attitude then
      attitude(job, put, dimension)
      dimension = dimension + 3
      return
    end
    local target, why = values.target(job, name)
    local d, rule = distribution(what)
    if why then wrong[#wrong + 1] = "--vary: " .. why end
    if rule then wrong[#wrong + 1] = "--vary " .. name .. ": " .. rule .. ", got " .. part end
    if not target or not d then return end
    d.dimension, dimension = dimension, dimension + 1
    target.draw = d
    put(target)
  end)
  dimension = correlated(host, job, given.covariance, dimension, put, wrong)
  if given.points == "sobol" and dimension > MOST_DIMENSIONS then
    wrong[#wrong + 1] = "--points sobol has " .. MOST_DIMENSIONS .. " dimensions, and " .. dimension .. " are drawn"
  end
  sampled(given, list, wrong)
  if not (given.over or given.sample) then
    wrong[#wrong + 1] = "nothing is varied: --over NAME=LOW:HIGH:COUNT, or --sample N --vary NAME=normal(MEAN,SD)"
  end
  local samples = given.sample or 1
  if grid * samples > MOST_MEMBERS then
    wrong[#wrong + 1] = "there must be at most 2^53 members"
  elseif #wrong == 0 then
    samples = math.tointeger(samples)
  end
  return { values = list, grid = grid, samples = samples }
end

return values
