-- study.lua -- measures every method that a scene admits, with peers beside them; report/bench.lua shows it.
--
-- The order of things: reference and conditioning by the general library; one shared object for each combination of
-- real type, compiler flags and order of a series; ladders of settings, whose errors are exact and whose times only
-- steer; then all rows in rounds, a baseline before each and after the last, and of each row the least of its medians.
-- SPDX-License-Identifier: GPL-3.0-or-later

local build = require "generator.commands.build"
local candidates = require "generator.plan.candidates"
local condition = require "generator.plan.condition"
local drift = require "generator.plan.drift"
local driver = require "generator.driver"
local err = require "generator.plan.error"
local happenings = require "generator.dynamics.happenings"
local ladder = require "generator.plan.ladder"
local methods = require "generator.methods.methods"
local motion = require "generator.dynamics.motion"
local numeric = require "generator.dynamics.numeric"
local ops = require "generator.cost.ops"
local reference = require "generator.plan.reference"

local study = {}

study.orders = { double = { 8, 12, 16, 20, 24 }, float = { 8, 12 } } -- of Taylor series
local epsilon = { double = 2.0 ^ -52, float = 2.0 ^ -23 }
local near_rounding = 8 -- an error of at most so many ulp of the input, moved to the end, is rounding's
local near_reference = 4
local many = 1e3 -- the root of a large number of steps
local better = 8 -- by so much is a rung better that is not only luckier
local rounds, repeats, limit = 3, 5, 0.05 -- of the timing: samples of a row in a round, and s for them
local slow, far = 5e-3, 4 -- s, and times the time of the best: such rows are timed in one round
local patience = 0.6 -- s for a run of a peer
local noisy = 1.10 -- the baseline's largest time over its least
local violent = 8 -- growth of the conditioning over the second half of the run
local levels = { 1e-3, 1e-6, 1e-9, 1e-11 }

-- The level of the emitted Makefile; for this machine also what makes the code fast there and nowhere else.
local function level(u)
  if not u.host then return { "-O2" } end
  return { "-O2", "-march=native", "-ffp-contract=fast", "-D" .. string.upper(u.job.model.name) .. "_VECTOR" }
end

-- ---- what is measured ----

local function group_of(c) return (c.method == "exact" and "closed" or c.vector and "host" or "portable") end

-- The candidates that the scene admits, each as {c = candidate, name =, group =, order =}, and why others are not
-- there.
local function chosen(job, given)
  local list, refused, seen = {}, {}, {}
  for _, real in ipairs { "double", "float" } do
    local all = candidates.of(job, { real = real, orders = study.orders[real], vector = true, methods = given.method })
    for _, c in ipairs(all) do
      local left_out = given.no_closed and c.method == "exact"
      if c.refused and not left_out and not seen[c.method] then
        seen[c.method] = true
        local why = seen[c.refused] -- of a method before: said once
        if why then
          refused[why] = c.method .. ", " .. refused[why]
        else
          refused[#refused + 1] = c.method .. ": " .. c.refused
          seen[c.refused] = #refused
        end
      end
      if not c.refused and not left_out then
        local name = string.gsub(c.name, " vector", "") .. (real == "float" and " float" or "")
        list[#list + 1] = { c = c, name = name, group = group_of(c), order = c.order or methods.by_name[c.method] and
          methods.by_name[c.method].order }
        if not c.order and real == "double" then -- every other method, compiled for this machine
          local twin = {}
          for k, v in pairs(c) do twin[k] = v end -- order does not matter: a table of named fields
          twin.vector = true
          list[#list + 1] = { c = twin, name = name, group = c.method == "exact" and "closed host" or "host",
            order = list[#list].order }
        end
      end
    end
  end
  return list, refused
end

-- The shared objects that the candidates need: sets e.unit.  Methods without orders go where a series is made anyway.
local function units(list)
  local out, by_key, some = {}, {}, {}
  local function unit(c, order)
    local kind = c.real .. (c.vector and " host" or "")
    local key = kind .. (order or "")
    if not by_key[key] then
      by_key[key] = { real = c.real, host = c.vector, order = order, methods = {}, has = {} }
      out[#out + 1] = by_key[key]
      some[kind] = some[kind] or by_key[key]
    end
    return by_key[key], some[kind]
  end
  local function put(e, u)
    if not u.has[e.c.method] then
      u.has[e.c.method] = true
      u.methods[#u.methods + 1] = e.c.method
    end
    e.unit = u
  end
  for _, e in ipairs(list) do
    if e.c.order then put(e, (unit(e.c, e.c.order))) end
  end
  for _, e in ipairs(list) do
    if not e.c.order then
      local kind = e.c.real .. (e.c.vector and " host" or "")
      put(e, some[kind] or (unit(e.c)))
    end
  end
  return out
end

-- Plans, compiles and loads the units.  Where one cannot be had (a type too small for the constants, a compiler without
-- these flags), u.plugin stays nil and the reason joins the remarks.
local function load_units(host, scene, list, remarks)
  local wanted = {}
  for i, u in ipairs(list) do
    local d
    u.job, d = driver.plan(scene, { real = u.real, methods = u.methods, order = u.order, command = "" })
    if not u.job then return nil, d:report() end
    wanted[i] = { job = u.job, flags = level(u), peers = u.peers }
  end
  local plugins, failed = build.plugins(host, wanted)
  local said = {}
  for i, u in ipairs(list) do
    local why = failed and failed[i] and failed[i].message
    why = why or build.refusal(u.job, plugins[i])
    if not why then
      u.plugin = plugins[i]
    elseif u.carrier then
      return nil, why
    elseif not said[u.real .. tostring(u.host)] then
      said[u.real .. tostring(u.host)] = true
      remarks[#remarks + 1] = u.real .. (u.host and ", for this machine" or "") .. ": " ..
        string.gsub(string.match(why, "^[^\n]*\n?[^\n]*"), "%s+", " ")
    end
  end
  return true
end

-- ---- errors ----

-- A table of what all ladders need.
local function ground(host, job, given, tick)
  local g = { host = host, job = job, T = given["until"] or job.model:double(job.model.horizon),
    x0 = numeric.initial(job) }
  g.times = err.times(g.T)
  local why
  local truth = reference.new(host, job)
  g.reference, why = truth:motion(g.x0, g.times)
  if not g.reference then return nil, "no reference: " .. why, true end
  g.own_error = why
  tick("conditioning", 0.01)
  g.condition = condition.of(truth, g.x0, g.T)
  local c = g.condition
  g.number = math.max(c and c.number or 1, 1)
  g.state = math.max(c and c.state or 1, g.number)
  return g
end

-- Names the errors that say nothing of the method: those of the reference's own size, and those that rounding makes.
-- That is a few ulp of the input; and where the ladder no longer goes down, up to an ulp of the state in each step, a
-- random walk.
local function explain_floors(g, rows)
  local least = {} -- of the finer rungs of the same ladder
  for i = #rows, 1, -1 do
    local r, before, after = rows[i], rows[i - 1], rows[i + 1]
    local flat = before and before.entry == r.entry and r.error > before.error / 2
      or after and after.entry == r.entry and after.error > r.error / 2
    local walk = g.state * epsilon[r.real] * math.max(near_rounding, math.sqrt(r.steps or 0))
    if r.error <= near_reference * g.own_error then
      r.note = "reference"
    elseif r.error <= near_rounding * g.number * epsilon[r.real]
      or flat and r.error <= walk and r.error <= better * (least[r.entry] or math.huge) then
      r.note = "rounding"
    end
    least[r.entry] = math.min(r.error, least[r.entry] or math.huge)
  end
end

-- One entry's rows: of a closed form one, else a ladder's.
local function climb(g, e, best)
  local out, real, kind = {}, e.c and e.c.real or "double", (e.c or e).setting
  local m, failure = motion.emitted(g.job, (e.unit or e).plugin, e.c and { x = g.x0, method = e.c.method } or
    { x = g.x0, peer = e.name, patience = patience })
  local function run(setting)
    local start, list = g.host.clock(), nil
    if m then list, failure = m.solve(g.times, { [kind] = setting }) end
    local seconds = g.host.clock() - start
    if not list then return math.huge, seconds end
    local states = err.states(list)
    return err.of(g.job, states, g.reference), seconds, states
  end
  local found = {}
  if kind == "none" then
    local error, _, states = run()
    found[1] = states and { error = error, seconds = 1e-5, what = states }
    g.remarks[#g.remarks + 1] = not states and e.name .. ": " .. happenings.said(failure) or nil
  else
    found = ladder.climb { order = e.order or 4, T = g.T, kind = kind, least = epsilon[real], enough = g.enough,
      floor = math.max(2 * g.number * epsilon[real], g.own_error), noise = many * g.state * epsilon[real], best = best,
      behind = e.behind, run = run }
  end
  for i, r in ipairs(found) do
    out[i] = { name = e.name, family = e.family or e.c.method, group = e.group, real = real, kind = kind,
      setting = r.setting, error = r.error, about = r.seconds, entry = e, drift = g.drift(r.what) }
  end
  return out
end

-- All rows without their times: list, peers -> rows in the order of the list.
local function ladders(g, list, peers, tick)
  local of, fronts = {}, {}
  local function done(e, rows)
    of[e] = rows
    local group = e.group .. (e.c and e.c.real or "")
    fronts[group] = fronts[group] or {}
    for _, r in ipairs(rows) do table.insert(fronts[group], r) end
  end
  local function best_of(e)
    return function(error)
      local least
      for _, r in ipairs(fronts[e.group .. (e.c and e.c.real or "")] or {}) do
        if r.error <= error and (not least or r.about < least) then least = r.about end
      end
      return least
    end
  end
  local count, turns = 0, { {}, {}, peers } -- series first: what falls far behind them is cut short
  for _, e in ipairs(list) do table.insert(turns[e.c.order and 1 or 2], e) end
  for _, turn in ipairs(turns) do
    for _, e in ipairs(turn) do
      count = count + 1
      tick(e.name, 0.45 + 0.1 * count / (#list + #peers))
      done(e, climb(g, e, best_of(e)))
    end
  end
  local rows = {}
  for _, part in ipairs { list, peers } do
    for _, e in ipairs(part) do
      for _, r in ipairs(of[e]) do rows[#rows + 1] = r end
    end
  end
  return rows
end

-- ---- times ----

-- One round's measure of a row: seconds for the horizon (nil: it cannot), steps, seconds of one evaluation of a closed
-- form.
local function timed(g, r)
  local e = r.entry
  local what = { x0 = g.x0, to = g.T, repeats = repeats, limit = math.max(limit, 4 * r.about) }
  local t
  if r.kind == "none" then
    t = e.unit.plugin:time_closed(what)
    if not t then return nil end
    return t.setup.median + t.at.median, nil, t.at.median
  elseif e.c then
    what.method, what[r.kind] = e.c.method, r.setting
    t = e.unit.plugin:time(what)
  else
    what.name, what.setting = e.name, r.setting
    t = e.plugin:time_peer(what)
  end
  if not t then return nil end
  return t.median, t.steps
end

-- Rows that the first times of the ladders put far from the front of their kind.
local function hopeless(rows)
  local list, kinds = {}, {}
  for _, r in ipairs(rows) do
    kinds[r.group] = kinds[r.group] or {}
    table.insert(kinds[r.group], r)
  end
  for _, r in ipairs(rows) do
    for _, o in ipairs(kinds[r.group]) do
      if o.error <= r.error and far * o.about < r.about then list[r] = true end
    end
  end
  return list
end

-- Times of all rows, and the baseline: {least =, most =, noisy =}.
local function measure(g, rows, tick)
  local noise = { least = math.huge, most = 0 }
  local function baseline()
    local ns = g.host.baseline().ns
    noise.least, noise.most = math.min(noise.least, ns * 1e-9), math.max(noise.most, ns * 1e-9)
  end
  local once = hopeless(rows)
  for _, r in ipairs(rows) do r.time, r.all = math.huge, {} end
  for round = 1, rounds do
    for i, r in ipairs(rows) do
      if i % 64 == 1 then baseline() end
      if i % 16 == 1 then tick("times, round " .. round, 0.55 + 0.45 * (round - 1 + i / #rows) / rounds) end
      if round == 1 or r.about < slow and not once[r] then
        local seconds, steps, evaluation = timed(g, r)
        if seconds then
          if seconds < r.time then r.time, r.evaluation = seconds, evaluation end
          r.steps = steps
          table.insert(r.all, seconds)
        end
      end
    end
  end
  baseline()
  for _, r in ipairs(rows) do
    table.sort(r.all)
    r.spread, r.all = #r.all > 0 and r.all[(#r.all + 1) // 2] / r.time - 1 or 0, nil
  end
  noise.noisy = noise.most > noisy * noise.least
  return noise
end

-- Operations of a step of each entry; code for this machine differs in nothing that is counted.
local function counts(list, tick)
  local known = {}
  for _, e in ipairs(list) do
    local c = e.c
    local key = table.concat({ c.method, c.real, c.setting, c.order or "" }, " ")
    if not known[key] then
      tick("operations", 0.4)
      local u = e.unit
      u.code = u.code or driver.code(u.job)
      known[key] = ops.of(u.code, c)
    end
    e.operations = known[key] and known[key].step
  end
end

-- ---- the whole ----

-- given: the command's options; tick(what, part): called before each piece of work, part: of the
-- whole, as far as can be said.  Returns the study, or nil and why.
function study.of(host, job, given, tick)
  tick("reference", 0)
  local g, why, numbers = ground(host, job, given, tick)
  if not g then return nil, why, numbers end
  g.enough = given.accuracy and given.accuracy / 10
  local list, refused = chosen(job, given)
  if #list == 0 then return nil, "no method that the scene admits: " .. table.concat(refused, "; ") end
  local wanted = units(list)
  local carrier
  for _, u in ipairs(wanted) do
    if u.real == "double" and not u.host then carrier = carrier or u end
  end
  carrier.carrier, carrier.peers = true, not given.no_peers
  tick("compiling", 0.02)
  local ok
  ok, why = load_units(host, job, wanted, refused)
  if not ok then return nil, why end
  g.remarks = refused
  for i = #list, 1, -1 do
    if not list[i].unit.plugin then table.remove(list, i) end
  end
  g.drift = drift.of(job, carrier.plugin, g.x0)
  local peers = {}
  for _, p in ipairs(given.no_peers and {} or host.peers()) do
    peers[#peers + 1] = { name = p.name, family = p.name, group = "peer", setting = p.setting, plugin = carrier.plugin,
      order = string.find(p.name, "rk8") and 8 or nil, behind = 400 } -- their curves are drawn further
  end
  counts(list, tick)
  local tried = ladders(g, list, peers, tick)
  local noise = measure(g, tried, tick)
  explain_floors(g, tried)
  local rows = {}
  for _, r in ipairs(tried) do
    r.operations, r.entry = r.entry.operations, nil
    if r.time < math.huge then rows[#rows + 1] = r end
  end
  local c, growth = g.condition, nil
  if c and c.growth and c.growth > violent then
    growth = "what is uncertain at the start grows faster than regular motion has it: unstable or chaotic"
  end
  return { name = job.model.name, horizon = g.T, own_error = g.own_error, epsilon = epsilon, noise = noise, rows = rows,
    reference = "the general library in long double, by two roads",
    condition = c and { number = c.number, input = c.input, state = c.state, growth = growth },
    conserved = job.conserved, levels = given.accuracy and { given.accuracy } or levels, remarks = refused }
end

return study
