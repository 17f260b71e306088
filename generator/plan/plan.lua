-- plan.lua -- from an accuracy to a method: which one, at which step or tolerance, and on what evidence.
--
-- Candidates compete at a few states (search.lua); the winner is then run from all of them, and the states where it
-- errs most join the few until it holds everywhere.  What must hold is: the largest error, times `margin`, is below the
-- accuracy.
-- SPDX-License-Identifier: GPL-3.0-or-later

local candidates = require "generator.plan.candidates"
local ops = require "generator.cost.ops"
local search = require "generator.plan.search"
local states = require "generator.plan.states"
local stiffness = require "generator.plan.stiffness"
local targets = require "generator.cost.targets"
local trial = require "generator.plan.trial"
local methods = require "generator.methods.methods"

local plan = {}

-- By how much the error at states that were not tried may be larger; and where rounding leaves no room for that.
plan.margin, plan.least_margin = 2, 1.25

-- All even orders of the series: they share one compiled plugin.
plan.orders = {}
for order = 4, 30, 2 do plan.orders[#plan.orders + 1] = order end
plan.top = 30
local top = plan.top

local epsilon = { double = 2.0 ^ -52, float = 2.0 ^ -23 }

-- The order that NAME_taylor_run takes for a tolerance (templates/steppers/taylor_run.c, emit/taylor.lua): bits of an
-- IEEE number as an integer are its logarithm.  most: the order of the emitted series.
function plan.order(tolerance, real, most)
  local log2
  if real == "float" then
    log2 = string.unpack("i4", string.pack("f", tolerance)) * 2.0 ^ -23 - 127
  else
    log2 = string.unpack("i8", string.pack("d", tolerance)) * 2.0 ^ -52 - 1023
  end
  -- `least` and `slope` of emit/taylor.lua: order 9.5 and 3/8 for each further bit
  local n = 9.5 - 0.375 * log2
  most = most or top
  return n < most and (n > 4 and math.floor(n) or 4) or most
end

local function total(counts)
  return counts.add + counts.mul + counts.div + counts.sqrt + counts.call
end

local rank = { exact = 1, rosenbrock = 2, taylor = 3, adaptive = 4, split6 = 5, split4 = 6, midpoint = 7, split2 = 8,
  rk4 = 9, semi = 10 }
local first_orders = { [16] = 1, [20] = 2, [12] = 3 }

-- The candidates that compete, the promising first, with what search.lua wants to know; and those that were refused.
-- q: the question (plan.find).
local function competitors(q)
  local list, refused, fused = {}, {}, { fma = targets.fma(q.target, q.real) }
  local all = candidates.of(q.job, { methods = q.methods, real = q.real,
    orders = q.order and { q.order } or plan.orders, mild = not q.stiff })
  local seen = {}
  for _, c in ipairs(all) do
    local fixed = c.method == "taylor" and c.setting == "tolerance"
    local twice = fixed and seen.taylor -- one run has all orders
    if fixed then
      seen.taylor = true
      c.name, c.order = "taylor tol", q.order or top
    end
    local code = (q.apart[c.method] or q).code
    local costs = not c.refused and not twice and
      assert(ops.of(code, { method = c.method, order = c.order, setting = c.setting }, fused))
    if c.refused then
      if not seen[c.method] then refused[#refused + 1] = c end
      seen[c.method] = true
    elseif not twice then
      local function weight(counts) return targets.cost(q.target, q.real, counts) end
      c.counts, c.setup_counts = costs.step, costs.setup
      local memo = {}
      c.counts_at = function(setting)
        if not fixed then return costs.step end
        local n = plan.order(setting, q.real, q.order)
        memo[n] = memo[n] or ops.of(code, { method = "taylor", order = n, setting = "tolerance" }, fused).step
        return memo[n]
      end
      c.weight = function(setting) return weight(c.counts_at(setting)) end
      c.setup = costs.setup and weight(costs.setup) or 0.0
      c.power = c.order or (methods.by_name[c.method] or {}).order or 1
      c.spread = c.power < 8 and 1.3 or 2
      c.ops = total(costs.step) + (costs.setup and total(costs.setup) or 0)
      if fixed then c.ops = total(c.counts_at(0.5)) end -- its order, and so its operations, follow the tolerance
      c.allowed = function(setting) return not q.ops or not fixed or total(c.counts_at(setting)) <= q.ops end
      if q.ops and c.ops > q.ops then
        c.over = true
        refused[#refused + 1] = c
      else
        list[#list + 1] = c
      end
    end
  end
  local place = {}
  for i, c in ipairs(list) do place[c] = i end
  local function key(c)
    local inner = c.setting == "tolerance" and 0 or first_orders[c.order] or 10
    return (rank[c.method] or 11) * 1000 + inner * 50 + place[c]
  end
  table.sort(list, function(a, b) return key(a) < key(b) end)
  return list, refused
end

-- What may serve as truth once the library has confirmed it, the best first: the closed form, or the series near
-- rounding; of a stiff motion the series in double where its stability leaves it few steps, and the implicit method,
-- also in double.  Where the code is in float, its own series tells nothing.
local least, most_true = 16, 2e9 -- states of a stiff motion, and cycles that their true motions may take
local function surrogates(q)
  if q.real == "float" and not q.stiff then return {} end
  if q.job.closed.full then return { { { method = "exact", setting = "none" } } } end
  local list = {}
  local function put(name, tolerance, made)
    for _, c in ipairs(candidates.of(q.job, { methods = { name }, orders = { top }, real = "double" })) do
      c.made = made
      if not c.refused and c.setting == "tolerance" then list[#list + 1] = { c, tolerance } end
    end
  end
  local long = q.stiff and (q.real == "float" or least * q.stiff.decays / stiffness.reach("taylor", top) *
    targets.cost(targets.default, "double", ops.of(q.code, { method = "taylor", order = top,
      setting = "tolerance" }).step) > most_true)
  if not long then put("taylor", 2.0 ^ -51) end
  if q.stiff then put("rosenbrock", math.max(1e-13, 1e-6 * q.accuracy), q.sure) end
  return list
end

-- The states, those first from which the candidate errs most.
local function by_error(s, c, setting, points)
  local e, place, sorted = {}, {}, {}
  for i, p in ipairs(points) do
    e[p], place[p], sorted[i] = s:worst(c, setting, { p }), i, p
  end
  table.sort(sorted, function(a, b)
    if e[a] ~= e[b] then return e[a] > e[b] end
    return place[a] < place[b]
  end)
  return sorted
end

-- The states with which the competition starts: the scene's own and those from which a rough run errs most.
local function first_states(s, list, points, n)
  local c
  for _, x in ipairs(list) do
    if x.setting ~= "none" then c = c or x end
  end
  local out = { points[1] }
  for _, p in ipairs(c and by_error(s, c, c.setting == "tolerance" and 1e-4 or s.T / 64, points) or points) do
    if #out < n and p ~= points[1] then out[#out + 1] = p end
  end
  return out
end

local many, some, few, confirmed = 128, 64, 5, 8
local most, work = 1024, 4e8 -- states at last: as many as take so many cycles at the plan's cost
local sound = 1000 -- decays of a stiff motion up to which the library follows it, in a second or so

-- All states: {setting, error, steps, cost, errors by point}.  limit: stop where the error is above, if given.
-- At each point the run's own error; steps is their mean.
local function verify(s, c, setting, points, limit)
  local out = { candidate = c, setting = setting, error = 0.0, steps = 0.0, errors = {} }
  for i, p in ipairs(points) do
    local e, steps = s:worst(c, setting, { p })
    out.errors[i], out.steps = e, out.steps + steps / #points
    out.error = math.max(out.error, e)
    if limit and e > limit then break end
  end
  out.cost = (c.setup or 0.0) + out.steps * c.weight(setting)
  return s:measured(out, #out.errors == #points)
end

-- The setting of a candidate that was good enough at few states, made so for all by the law of its order.
-- error ~ h^p: the step goes by (limit/error)^(1/p), with a hundredth to spare; a tolerance by limit/error.
local function corrected(s, r, points, limit, stop)
  local c, setting = r.candidate, r.setting
  local out
  if r.errors and r.fits and setting then -- at all points before: what was added asks for more
    setting = setting * (c.setting == "step" and 0.99 * (limit / r.error) ^ (1 / c.power) or 0.7 * limit / r.error)
  end
  for _ = 1, 6 do
    if setting then setting = search.rounded(setting, c.setting == "step" and 4 or 2) end
    out = verify(s, c, setting, points, stop)
    out.fits = out.error <= limit and c.allowed(setting)
    if out.fits or not setting then break end
    local ratio = math.max(1e-3, limit / out.error)
    setting = setting * (c.setting == "step" and 0.99 * ratio ^ (1 / c.power) or 0.7 * ratio)
  end
  return out
end

-- Places, those of the largest errors first.
local function by_size(errors)
  local order = {}
  for i in ipairs(errors) do order[i] = i end
  table.sort(order, function(a, b)
    if errors[a] ~= errors[b] then return errors[a] > errors[b] end
    return a < b
  end)
  return order
end

-- The n points of the largest errors that are not among the chosen ones join them.
local function add_worst(list, chosen, points, errors, n)
  for _, i in ipairs(by_size(errors)) do
    if n > 0 and not chosen[points[i]] then
      list[#list + 1], chosen[points[i]], n = points[i], true, n - 1
    end
  end
end

-- The cheapest plan of the list that stays below the limit at all points, or nil; what the first round found; of what
-- was run from all points the one that came closest.  What a candidate costs at few states is a lower bound of what it
-- costs at all of them; so once the verified plan costs no more than `enough` times the best at few, there is nothing
-- to win.
local enough = 1.1
local function compete(s, list, points, limit, real, progress)
  local tried = { trial = s, points = first_states(s, list, points, few), epsilon = epsilon[real] }
  local chosen, incumbent, first, closest = {}, nil, nil, nil
  for _, p in ipairs(tried.points) do chosen[p] = true end
  for round = 1, 6 do
    local best, found = search.cheapest(tried, list, limit, incumbent)
    first = first or found
    progress(round / 6)
    if not best then break end
    local r = corrected(s, best, points, limit)
    if r.fits and (not incumbent or r.cost < incumbent.cost) then incumbent = r end
    if not closest or r.error < closest.error then closest = r end
    if incumbent and incumbent.cost <= enough * best.cost then break end
    add_worst(tried.points, chosen, points, r.errors, 3)
  end
  return incumbent, first, closest
end

-- The winner alone at more states of the filling, as long steps resonate with the motion in narrow parts of the ranges.
-- They join the points, for all of which the plan is made to hold.
local function widened(s, job, r, points, limit, real)
  local n = math.min(most, math.floor(work / r.cost)) - #points
  if n <= 0 or #points == 1 or s.early then return r end
  local before = #points
  for _, p in ipairs(states.points(job, real, n, before)) do
    if s:truth(p) then points[#points + 1] = p end
  end
  local added = verify(s, r.candidate, r.setting, { table.unpack(points, before + 1) })
  table.move(added.errors, 1, #added.errors, before + 1, r.errors)
  r.error = math.max(r.error, added.error)
  if r.error <= limit then return r end
  local order, sorted = by_size(r.errors), {} -- where it fails it fails at once
  for i, k in ipairs(order) do sorted[i] = points[k] end
  local bad, good = r.setting, corrected(s, r, sorted, limit, limit)
  for _ = 1, good.fits and 2 or 0 do -- the law of a peak takes too much
    local middle = verify(s, r.candidate, search.rounded(math.sqrt(bad * good.setting), 4), sorted, limit)
    middle.fits = middle.error <= limit and r.candidate.allowed(middle.setting)
    if middle.fits then good = middle else bad = middle.setting end
  end
  return good
end

-- The true motion from all points; how far it is from that, or nil and why not.  bearable: what is further off will not
-- do, and not all points have their motion then.
local function truths(s, points, bearable, progress)
  local own = 0.0
  for i, p in ipairs(points) do
    local rows, why, doubt
    if i <= (s.early and 2 or confirmed) or not s.sure then
      doubt, why = s:doubt(p, not s.sure and i <= confirmed or i == 1)
      rows = doubt
      own = math.max(own, doubt or 0.0)
      if own > bearable then return own end
    else
      rows, why = s:truth(p)
    end
    if not rows then return nil, why end
    progress(i / #points)
  end
  return own
end

-- The exact drift of a free asymmetric body cuts a step of more than a radian or so into pieces
-- (templates/steppers/split_diagonal.c), which are counted as one: such steps are no candidates.
-- The least number of steps; 1 elsewhere.
function plan.least_steps(job, c, points, T)
  if not string.find(c.method, "^split") or job.model.structure.kind ~= "diagonal" then return 1 end
  local fastest = 0.0
  for _, p in ipairs(points) do
    for _, row in ipairs(p.truth) do
      local square = 0.0
      for i, s in ipairs(job.states) do
        if s.kind == "rates" then square = square + row[i] ^ 2 end
      end
      fastest = math.max(fastest, square)
    end
  end
  return math.max(1, math.ceil(T * math.sqrt(fastest)))
end

-- The stiffness of the scene's own motion (stiffness.lua), or nil.
function plan.stiff(q)
  if not stiffness.sought(q.job) then return nil end
  local follows
  for _, c in ipairs(q.plugin:info().steppers) do follows = follows or c.name == "adaptive" end
  if not follows then return nil end
  return stiffness.of(q.job, q.plugin, states.points(q.job, q.real, 1)[1], q.job.model:double(q.job.model.horizon),
    epsilon[q.real])
end

-- How many states: of a stiff motion as many as can be followed in time.
local function number_of(s, q)
  if not s.early then return s.sure and many or some end
  local c = s.sure[1]
  local own = states.points(q.job, q.real, 1)[1]
  local _, steps = s:run(c, s.sure[2], own)
  local costs = ops.of((q.apart[c.method] and q.sure or q).code, { method = c.method, order = c.order,
    setting = c.setting })
  local cost = (steps or 1) * targets.cost(targets.default, "double", costs.step) -- it runs here
  return math.max(least, math.min(many, math.floor(most_true / cost)))
end

-- The states with their true motions, by the first of the surrogates that is good enough, and how far these are from
-- the truth; or nil and why there are none.  Where no surrogate serves, the library computes them, which takes a stiff
-- motion too long.
local function with_truths(s, q, progress)
  local list, points, own, why = surrogates(q), nil, nil, nil
  local good, bearable = q.accuracy / plan.margin / 4, q.accuracy / plan.least_margin
  if not q.stiff or #list == 0 then list[#list + 1] = false end
  for i, sure in ipairs(list) do
    s.sure = sure or nil
    if q.stiff and sure then s:briefly(s.T * math.min(1, sound / q.stiff.decays)) end
    points = states.points(q.job, q.real, number_of(s, q))
    own, why = truths(s, points, i < #list and good or bearable, progress)
    if own and own <= good then break end
  end
  if not own then return nil, why end
  return points, own
end

-- The plan for a question q: {host, job (read), code (planned, with its methods), plugin, apart = {method's name =
-- {code, plugin}} of those that are not in the plugin, stiff, sure = {code, plugin} of rosenbrock in double for what is
-- stiff, accuracy, real, target, ops, methods, order, progress}.  Returns
--     {candidate, setting, error, steps, cost, counts, setup_counts, order, margin, limit, stiff = the question's,
--     early = the time up to which the library confirmed a stiff motion or nil, found = what the competitors showed,
--     refused, states = number, log = what was measured (trial.lua), own = error of the truth, rows = the scene's own
--     true motion, expected = its end}
-- or nil and {found, closest, refused, own, why}; generator/plan/decision.lua puts both into words.
function plan.find(q)
  local T = q.job.model:double(q.job.model.horizon)
  local say = q.progress or function() end
  local s = trial.new { host = q.host, job = q.job, plugin = q.plugin, apart = q.apart, T = T }
  if q.job.equations.inputs and not states.limits(q.job) then
    return nil, { why = "needs the limits of all inputs: effect.control{ max = }, input(name, unit, { min =, max = })",
      refused = {}, found = {} }
  end
  local list, refused = competitors(q)
  local function share(from, to) return function(part) say(from + (to - from) * part) end end
  local points, own = with_truths(s, q, share(0, 0.4))
  local result = { refused = refused, found = {}, own = 0.0, least_margin = plan.least_margin, stiff = q.stiff,
    early = s.early and s.early.T, log = s.log }
  if not points then
    result.why = "the library cannot follow the motion from all states of the ranges: " .. own
    return nil, result
  end
  result.own, result.states = own, #points
  if own > q.accuracy / plan.least_margin then return nil, result end
  result.rows, result.expected = points[1].truth, points[1].truth[#points[1].truth]
  for _, c in ipairs(list) do
    c.least_steps = plan.least_steps(q.job, c, points, T)
    local m = methods.by_name[c.method]
    if q.stiff and m and not m.stiff then -- half of what stability asks for: other states may be less stiff
      c.stable_steps = q.stiff.decays / stiffness.reach(c.method, c.order)
      c.least_steps = math.max(c.least_steps, math.floor(c.stable_steps / 2))
    end
  end
  local best, limit
  for turn, margin in ipairs { plan.margin, plan.least_margin } do
    if best or #list == 0 or q.accuracy / margin <= own then break end
    limit = q.accuracy / margin - own
    local step = share(0.2 + 0.2 * turn, 0.6 + 0.2 * turn)
    best, result.found, result.closest = compete(s, list, points, limit, q.real, step)
    if best and s.sure and best.setting then
      best = widened(s, q.job, best, points, limit, q.real)
      if not best.fits then best, result.closest = nil, best end
    end
    result.states = #points
  end
  if not best then return nil, result end
  local c = best.candidate
  for k, v in pairs(best) do result[k] = v end -- into a table: order is lost anyway
  result.margin, result.limit = q.accuracy / (best.error + own), limit
  result.counts, result.setup_counts = c.counts_at(best.setting), c.setup_counts
  if c.method == "taylor" and c.setting == "tolerance" then
    result.order = plan.order(best.setting, q.real, q.order)
  end
  return result
end

return plan
