-- decision.lua -- a plan as text: what the emitted files say of it, and what is kept for the next time.
--
-- A decision is {method, order (of taylor) or nil, setting = "step", "tolerance" or "none", value_text, title,
-- accuracy_text, real, target, expected = {texts}, bounds = {texts}, report = {lines of the header}}, or {refused =
-- rule, got = text}: no candidate holds the accuracy.  Numbers are cut to digits that no machine's last bits reach.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local double = require "generator.algebra.double"
local hash = require "generator.hash"
local text = require "generator.formula.text"
local err = require "generator.plan.error"
local rates = require "generator.plan.rates"
local states = require "generator.plan.states"
local stiffness = require "generator.plan.stiffness"
local methods = require "generator.methods.methods"

local decision = {}

local function plain(s) -- 1e+02 is 100, 1e-09 is 1e-9
  local x = tonumber(s)
  if string.find(s, "e") and x >= 1 and x < 1e6 then return string.format("%.0f", x) end
  return (string.gsub(string.gsub(s, "e([+-])0+", "e%1"), "e%+", "e"))
end

local function short(x, digits) return plain(string.format("%." .. (digits or 2) .. "g", x)) end

-- The fewest digits that read back.
local function shortest(x) return plain(double.shortest(x, 1)) end
decision.shortest = shortest

-- An error: two digits; what is far below the accuracy by its decade alone, as its digits are those of roundings.
local function decade(e)
  return string.format("1e%d", math.max(-15, math.ceil(math.log(math.max(e, 1e-16), 10) + 0.3)))
end

local function measured(e, accuracy)
  return e > accuracy / 100 and short(e) or "below " .. decade(e)
end

-- How a candidate is called in a sentence: "taylor, order 14, steps of 0.057 s".
local function title(c, order, value)
  if c.setting == "none" then return "the closed form" end
  local name = c.method .. (order and ", order " .. string.format("%d", order) or "")
  return name .. (c.setting == "step" and ", steps of " .. value .. " s" or ", tolerance " .. value)
end

local operations = { { "add", "additions" }, { "mul", "multiplications" }, { "div", "divisions" }, { "sqrt", "roots" },
  { "call", "function calls" } }

local function counted(counts)
  local parts, sum = {}, 0
  for _, o in ipairs(operations) do
    local n = counts[o[1]] or 0
    sum = sum + n
    if n > 0 then parts[#parts + 1] = string.format("%d %s", n, n == 1 and string.sub(o[2], 1, -2) or o[2]) end
  end
  return string.format("%d operations (%s)", sum, table.concat(parts, ", "))
end

-- From where the motions started: the declared ranges, in words.
local function whence(job)
  local r = job.ranges
  local function interval(range)
    return "from " .. short(R.todouble(range.lo), 6) .. " to " .. short(R.todouble(range.hi), 6)
  end
  if not r then
    local parts, m = {}, job.model
    if m.has.rates then parts[#parts + 1] = "rates within 10 % of |omega| of the scene's" end
    if m.has.position then parts[#parts + 1] = "position and velocity within 10 % of theirs" end
    if m.has.attitude then parts[#parts + 1] = "attitude within 0.1 rad" end
    return table.concat(parts, ", ")
  end
  local parts = {}
  for i, s in ipairs(job.states) do
    if r.states[i] then parts[#parts + 1] = s.name .. " " .. interval(r.states[i]) end
  end
  if r.attitude then
    parts[#parts + 1] = r.attitude == "any" and "any attitude" or "attitude within " ..
      short(R.todouble(r.attitude), 4) .. " rad of the scene's"
  end
  for _, p in ipairs(r.params) do parts[#parts + 1] = p.name .. " " .. interval(p) end
  return #parts > 0 and table.concat(parts, ", ") or "the scene's own"
end

-- What a scene asks for, line by line: `explain` shows it.
function decision.asked(job, q)
  local lines, budget = {}, job.record.budget
  local horizon = shortest(job.model:double(job.model.horizon))
  if q then lines[1] = "accuracy: " .. shortest(q.accuracy) .. " over the horizon of " .. horizon .. " s" end
  if budget then
    local parts = {}
    if budget.ops then parts[#parts + 1] = "at most " .. string.format("%d", budget.ops) .. " operations a step" end
    if budget.real then parts[#parts + 1] = budget.real end
    if budget.target then parts[#parts + 1] = "by the costs of " .. budget.target end
    lines[#lines + 1] = "budget: " .. table.concat(parts, ", ")
  end
  lines[#lines + 1] = (job.ranges and "ranges: " or "no ranges; a plan is tried with ") .. whence(job)
  return lines
end

-- ", inputs .. held within ..", or nothing.
local function held(job)
  local list = {}
  for i, s in ipairs(states.limits(job) or {}) do
    list[i] = string.format("%s held within %s .. %s %s", s.label, short(s.low, 4), short(s.high, 4), s.unit)
  end
  return #list > 0 and ", inputs " .. table.concat(list, ", ") or ""
end

-- The next best: of each other method or setting the cheapest, as a multiple of the cost of the best.
local function runners(r)
  local list, seen = {}, { [r.candidate.method .. r.candidate.setting] = true }
  for i, f in ipairs(r.found) do
    local c = f.candidate
    local ratio, about = math.huge, ""
    -- one that was given up before its steps were short enough: error ~ h^p, so its cost grows as error^(1/p)
    if f.fits then
      ratio = f.cost / r.cost
    elseif f.error and f.error < 0.1 and f.cost then -- by the law of its order
      ratio, about = f.cost * math.max(1, f.error / r.limit) ^ (1 / c.power) / r.cost, "about "
    end
    if f.should then ratio, about = f.should / r.cost, "about " end
    local name = c.setting == "none" and "the closed form" or c.method
    if c.setting == "tolerance" then
      name = name .. " by tolerance"
    elseif c.order then
      name = name .. " of order " .. string.format("%d", c.order)
    end
    list[i] = { name = name, key = c.method .. c.setting, ratio = ratio, about = about, place = i }
  end
  table.sort(list, function(a, b)
    if a.ratio ~= b.ratio then return a.ratio < b.ratio end
    return a.place < b.place
  end)
  local out = {}
  for _, x in ipairs(list) do
    if not seen[x.key] and #out < 4 and x.ratio < 1e4 then
      seen[x.key] = true
      out[#out + 1] = x.name .. " " .. x.about .. string.format("%.1f", math.max(1, x.ratio)) .. " times"
    end
  end
  return out
end

-- The state at the horizon and its bounds, to a hundredth of the accuracy.
local function expected(job, r, accuracy, real)
  local values, bounds = {}, {}
  local rounding = real == "float" and 2.0 ^ -22 or 2.0 ^ -51
  for _, g in ipairs(err.groups(job)) do
    local scale = 0.0
    for _, i in ipairs(g) do scale = scale + r.expected[i] ^ 2 end
    for _, row in ipairs(r.rows) do
      local sum = 0.0
      for _, i in ipairs(g) do sum = sum + row[i] ^ 2 end
      scale = math.max(scale, sum)
    end
    scale = math.sqrt(scale)
    if scale == 0 or g.name == "attitude" then scale = 1.0 end
    -- the last decimal place that is printed
    local unit = 10.0 ^ math.floor(math.log(accuracy * scale / 100, 10))
    for _, i in ipairs(g) do
      local places = math.max(0, math.floor(0.5 - math.log(unit, 10)))
      values[i] = places < 300 and string.format("%." .. places .. "f", r.expected[i]) or "0"
      bounds[i] = shortest(tonumber(short((accuracy + rounding) * scale, 3)))
    end
  end
  return values, bounds
end

-- Appends the words to the list as lines, those after the first indented.
local function wrapped(list, first, words, width)
  local line = first
  for _, w in ipairs(words) do
    if #line + 1 + #w > width then
      list[#list + 1] = line
      line = "    " .. w
    else
      line = line .. (line == "" and "" or " ") .. w
    end
  end
  list[#list + 1] = line
end

local function paragraph(list, s)
  local words = {}
  for w in string.gmatch(s, "%S+") do words[#words + 1] = w end
  wrapped(list, table.remove(words, 1), words, 112)
end

-- What the equations become where friction is infinite, for a body that slides on a plane, and how far the true motion
-- (r.rows, known to r.own) is from that in the last tenth of the horizon.
local function limit(q, r)
  local slides
  for _, e in ipairs(q.job.record.effects) do slides = slides or e.a and e.a.law == "sliding" end
  if not slides then return "" end
  local slip, speed
  if r.rows then slip, speed = rates.new(q.job):slip(r.rows, states.points(q.job, q.real, 1)[1].input) end
  local left = ""
  if speed and speed > 0 then
    local share = slip / speed
    left = "; in the last tenth of the time the slip is " .. (share > 10 * r.own and short(share) or "below " ..
      decade(math.max(share, r.own))) .. " of the speed"
  end
  return '; the limit of such friction where the body does not slide is law = "rolling", which is not stiff' .. left
end

-- What makes a motion stiff, in numbers; r: of plan.find, its `stiff` is {rate, decays} of plan/stiffness.lua.
local function stiff(q, r)
  local s = r.stiff
  return "something decays at " .. short(s.rate) .. " 1/s, " .. short(s.decays) .. " times within " ..
    shortest(q.job.model:double(q.job.model.horizon)) .. " s, so that rk4 needs steps below " ..
    short(stiffness.longest(s.rate)) .. " s whatever the accuracy" .. limit(q, r)
end

-- The decision for the result of plan.find; q: the question.
function decision.made(q, r)
  local c, real, target = r.candidate, q.real, q.target
  local d = { method = c.method, setting = c.setting, accuracy_text = shortest(q.accuracy), real = real,
    target = target, order = c.method == "taylor" and (c.setting == "tolerance" and r.order or c.order) or nil,
    value_text = r.setting and shortest(r.setting) or nil }
  d.title = title(c, d.order, d.value_text)
  d.expected, d.bounds = expected(q.job, r, q.accuracy, real)
  local T, upper = q.job.model:double(q.job.model.horizon), string.upper(q.job.model.name)
  local lines = {}
  paragraph(lines, "Planned for an accuracy of " .. d.accuracy_text .. " over " .. shortest(T) .. " s: " .. d.title ..
    (c.setting == "step" and " (" .. upper .. "_PLANNED_STEP)" or c.setting == "tolerance" and " (" .. upper ..
    "_PLANNED_TOLERANCE)" or "") .. ", by " .. q.job.model.name .. "_advance.")
  local margin = r.error > q.accuracy / 100 and ", a margin of " .. short(r.margin) .. "," or ""
  paragraph(lines, "Measured: largest error " .. measured(r.error, q.accuracy) .. margin .. " from " ..
    string.format("%d", r.states) .. " states" .. (real == "float" and " in float" or "") .. ": " .. whence(q.job) ..
    held(q.job) .. "; the true motion is known to " .. decade(r.own) ..
    (r.early and ", the library confirms it up to " .. short(r.early) .. " s" or "") .. ".")
  local one = counted(r.counts)
  local work = r.setup_counts and counted(r.setup_counts) .. " once, " .. one .. " for each time"
  if not work then
    work = short(r.steps, 4) .. " step" .. (r.steps == 1 and "" or "s") ..
      (c.setting == "tolerance" and " on average" or "") .. " of " .. one
  end
  paragraph(lines, "Cost: " .. work .. "; by the table for " .. target .. " " .. short(r.cost) .. " cycles.")
  if r.stiff then paragraph(lines, "Stiff: " .. stiff(q, r) .. ".") end
  local beside = runners(r)
  if #beside > 0 then paragraph(lines, "At other costs: " .. table.concat(beside, ", ") .. ".") end
  d.report = lines
  return d
end

-- Why nothing holds, from what plan.find found instead.
function decision.refusal(q, r)
  local cheapest
  for _, c in ipairs(r.refused) do
    if c.over and (not cheapest or c.ops < cheapest.ops) then cheapest = c end
  end
  local got = shortest(q.accuracy)
  local tail = ""
  if r.stiff then
    tail = "; the motion is stiff: " .. stiff(q, r)
  end
  if r.why then return { refused = r.why .. tail, got = got } end
  local best = r.closest
  for _, f in ipairs(best and {} or r.found) do
    if f.error and f.error < math.huge and (not best or f.error < best.error) then best = f end
  end
  if not best and cheapest then
    return { refused = string.format("budget.ops leaves no method: the least, %s, takes %d operations", cheapest.name,
      cheapest.ops), got = string.format("%d", q.ops) }
  end
  local limits = {}
  if r.own > q.accuracy / 8 then
    limits[1] = (r.early and "the true motion, which the library takes too long for, is known to " or
      "the motion magnifies roundings so much that the library itself knows it to ") .. short(r.own) .. " only"
  elseif q.real == "float" then
    limits[1] = "the rounding of float"
  else
    limits[1] = "rounding, as far as the motion magnifies it"
  end
  if cheapest then limits[#limits + 1] = "budget.ops" end
  if not best then return { refused = "cannot be planned: " .. limits[1] .. tail, got = got } end
  local c = best.candidate
  local order = c.method == "taylor" and c.setting == "step" and c.order or nil
  local name = title(c, order, best.setting and short(best.setting))
  return { refused = string.format("must be one that a method can hold with a margin of %s: the best is %s, " ..
    "error %s at %s cycles of %s; what limits it is %s", shortest(r.least_margin), name, short(best.error),
    short(best.cost), q.target, table.concat(limits, " and ")) .. tail, got = got }
end

-- ---- kept as text ----

local lists = { "expected", "bounds", "report" }
local words = { "method", "setting", "accuracy_text", "real", "target", "order", "value_text", "title", "refused",
  "got" }

-- The question as a text with everything that decides its answer.  fingerprint: that of the generator, so another
-- version of it answers anew.
function decision.question(q, fingerprint)
  local job, out = q.job, { "polhode plan 1", fingerprint }
  local m, node = job.model, text.nodes()
  local function put(...) out[#out + 1] = table.concat({ ... }, " ") end
  put("accuracy", shortest(q.accuracy), q.real, q.target, tostring(q.ops), tostring(q.order),
    table.concat(q.methods or { "all" }, ","))
  put("name", m.name, "closed", job.closed.theorem or "none")
  put("horizon", tostring(m:number(m.horizon)))
  for _, s in ipairs(job.states) do put("state", s.name, tostring(m:number(s.initial))) end
  for _, p in ipairs(m.params) do put("parameter", p.name, tostring(p.default)) end
  for _, x in ipairs(job.equations.model.members) do put("constant", x.name, node(x.e)) end
  for i, e in ipairs(m.inertia or {}) do put("inertia", i, node(e)) end
  for _, g in ipairs(job.equations.groups) do
    for _, x in ipairs(g.defs) do put(x.name, node(x.expr)) end
    for _, x in ipairs(g.outs) do put(x.state, node(x.expr)) end
  end
  put("expressions", hash.of(node()))
  for _, s in ipairs(states.limits(job) or {}) do put("input", s.label, tostring(s.low), tostring(s.high)) end
  local r = job.ranges
  if r then
    put("ranges", tostring(r.attitude))
    for i in ipairs(job.states) do
      if r.states[i] then put(i, tostring(r.states[i].lo), tostring(r.states[i].hi)) end
    end
    for _, p in ipairs(r.params) do put(p.name, tostring(p.lo), tostring(p.hi)) end
  end
  return (string.gsub(table.concat(out, "\n"), "\n\n+", "\n"))
end

-- The question as a file's name.
function decision.key(question) return hash.of(question) end

-- question, empty line, `name value` lines, end: what decision.kept reads back.
function decision.text(question, d)
  local out = { question, "" }
  for _, k in ipairs(words) do
    if d[k] then out[#out + 1] = k .. " " .. (math.type(d[k]) and string.format("%d", d[k]) or d[k]) end
  end
  for _, k in ipairs(lists) do
    for _, x in ipairs(d[k] or {}) do out[#out + 1] = k .. " " .. x end
  end
  out[#out + 1] = "end"
  return table.concat(out, "\n") .. "\n"
end

local known = {}
for _, k in ipairs(words) do known[k] = "word" end
for _, k in ipairs(lists) do known[k] = "list" end

-- The decision of a text that was kept for just this question, or nil.
function decision.kept(question, kept, count)
  local head = question .. "\n\n"
  if type(kept) ~= "string" or string.sub(kept, 1, #head) ~= head then return nil end
  local d, ended = { expected = {}, bounds = {}, report = {} }, false
  for line in string.gmatch(string.sub(kept, #head + 1), "([^\n]*)\n") do
    if string.find(line, "[^\32-\126]") or string.find(line, "[*]/") then return nil end -- it goes into comments of C
    local k, x = string.match(line, "^([%a_]+) (.*)$")
    if ended then return nil end
    if line == "end" then
      ended = true
    elseif known[k] == "word" then
      d[k] = x
    elseif known[k] == "list" then
      d[k][#d[k] + 1] = x
    else
      return nil
    end
  end
  if not ended then return nil end
  if d.refused then return d end
  d.order = d.order and math.tointeger(tonumber(d.order))
  local whole = (d.method == "exact" or methods.by_name[d.method]) and d.title and d.accuracy_text and
    #d.expected == count and #d.bounds == count
  for _, k in ipairs { "expected", "bounds" } do
    for _, x in ipairs(d[k]) do whole = whole and R.parse(x) end
  end
  if d.setting ~= "none" then whole = whole and d.value_text and R.parse(d.value_text) end
  return whole and d or nil
end

return decision
