-- engines.lua -- the two ways to a motion, as one kind of object: by the general library or by the emitted code.
--
-- A motion has `method`; `step`, the fixed step it goes by, or nil; `order`, the method's; `longest`, the most steps
-- that it does (`between`: of two rows, else of the whole run); `quick`, steps that take less than a second;
-- `adaptive`, that it could choose its steps; `closed`, that it takes none; `exact`, that the scene has a closed form;
-- `epsilon` of its numbers; `emitted`, that it is generated code; `tolerance` by which it chooses its steps, or nil,
-- and `least`, the smallest; `stiff`, that what was had of it turned to an implicit method; and
--     motion.solve(times, o)   a list of {t =, x = state as the scene has it, ...}, all numbers finite; or nil and a
--                              failure {status =, text =, t = the time at which it went wrong}.  o: {step = another
--                              step, tolerance = another, from = one of these states, to start there}
--     motion.twin()            of a motion in float: the same in double, or nil
--     motion.judge()           of generated code: the library's motion, near rounding, or nil
--     motion.measured(state)   its energy and L, or nil and a failure
-- What cannot be run is answered by nil and {status =, text =}, {command = true, text =} where the command line is
-- wrong, {diag =} where diagnostics say it.  scene: what was read; course: the inputs over time, or nil.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local options = require "generator.commands.options"
local build = require "generator.commands.build"
local breaks = require "generator.dynamics.breaks"
local driver = require "generator.driver"
local equations = require "generator.dynamics.equations"
local gen = require "generator.commands.gen"
local happenings = require "generator.dynamics.happenings"
local limits = require "generator.commands.run.limits"
local methods = require "generator.methods.methods"
local numeric = require "generator.dynamics.numeric"
local reference = require "generator.plan.reference"

local engines = {}

-- The command line is wrong.
local function refused(text) return nil, { command = true, text = text } end

-- That an engine has no such method: a message.
local function no_method(engine, method, list)
  return "--engine " .. engine .. " has the methods " .. table.concat(list, ", ") .. ", got " .. method ..
    (method == "linearised" and " (--engine general has it; in C it is the function NAME_linearised)" or
      options.meant(method, list))
end

local function finite(list)
  for _, x in ipairs(list) do
    if x ~= x or x == math.huge or x == -math.huge then return false end
  end
  return true
end

local function failed(t, text) return nil, { status = 3, t = t, text = text } end

-- ---- the emitted code ----

-- Where the steps that follow a tolerance end, between a time that is reached and one that is not.
local function last_reached(plugin, method, x, from, t, course, tolerance)
  for _ = 1, 40 do
    local middle = from + (t - from) / 2
    if middle == from or middle == t then break end
    local rows = plugin:integrate(x, course, { tolerance }, { middle }, from, method)
    if rows then x, from = { table.unpack(rows[1], 2) }, middle else t = middle end
  end
  return t
end

-- The times and the corners of tables between them, where fixed steps shall end too: over a corner a step has no order.
-- Second result: which of them were asked for.
local function with_corners(times, corners, from)
  local all, asked, c = {}, {}, 1
  for _, t in ipairs(times) do
    while corners[c] and corners[c] < t do
      if corners[c] > from then all[#all + 1] = corners[c] end
      c = c + 1
    end
    all[#all + 1] = t
    asked[#all] = true
    while corners[c] and corners[c] <= t do c = c + 1 end
    from = math.max(from, t)
  end
  return all, asked
end

-- The knots of the scene's tables, for its own parameters, in their order.
local function corners_of(scene)
  local list = {}
  for i, k in ipairs(breaks.knots(equations.fork(scene.equations))) do list[i] = R.todouble(k.value) end
  return list
end

-- The places of q among the states.
local function attitude_of(job)
  local places = {}
  for i, s in ipairs(job.states) do places[#places + 1] = s.kind == "attitude" and i or nil end
  return places
end

-- The first time at which |q| is not 1 to some per cent: a step with an h |w| beyond what the method can do
-- loses it.  As templates/sweep/members.c has it.
local function shortened(rows, places)
  for _, row in ipairs(#places == 4 and rows or {}) do
    local square = 0.0
    for _, i in ipairs(places) do square = square + row[i + 1] ^ 2 end
    if not (square >= 0.9 and square <= 1.1) then return row[1] end
  end
  return nil
end

local function stepped(plugin, method, x0, course, usual, step, corners, places)
  return function(asked, o)
    local h, tolerance = o.step or step, o.tolerance or usual
    local from = o.from or { t = 0.0, x = x0 }
    local times, wanted = asked, nil
    if h and #corners > 0 then times, wanted = with_corners(asked, corners, from.t) end
    local rows, last, infinite = plugin:integrate(from.x, course, h or { tolerance }, times, from.t, method)
    if not rows then
      local reached, next_time = from, nil
      for i, t in ipairs(times) do
        if (times[i - 1] or from.t) == last then next_time = next_time or t end
      end
      if last ~= from.t then
        local row = plugin:integrate(from.x, course, { tolerance }, { last }, from.t, method)
        if row then reached = { t = last, x = { table.unpack(row[1], 2) } } end
      end
      local t = last_reached(plugin, method, reached.x, reached.t, next_time or times[#times], course, tolerance)
      return failed(t, "no steps lead on")
    end
    if infinite then return failed(infinite, happenings.infinite) end
    local long = shortened(rows, places)
    if long then return failed(long, happenings.long_step) end
    local list = {}
    for i, row in ipairs(rows) do
      if not wanted or wanted[i] then list[#list + 1] = { t = row[1], x = { table.unpack(row, 2) } } end
    end
    return list
  end
end

local function closed(plugin)
  return function(times)
    local rows = {}
    for i, t in ipairs(times) do
      rows[i] = { t = t, x = plugin:at(t) }
      if not finite(rows[i].x) then return failed(t, happenings.infinite) end
    end
    return rows
  end
end

function engines.generated(host, scene, given, course)
  local exact = scene.closed.full
  local method = given.method or (exact and "exact" or "rk4")
  local m = methods.by_name[method]
  if method ~= "exact" and not m then
    local names = { "exact" }
    for _, other in ipairs(methods) do names[#names + 1] = other.name end
    return refused(no_method("generated", method, names))
  end
  if method == "exact" and not exact then
    return refused("method exact: " .. (scene.closed.kind and "the closed form of this scene " .. scene.closed.part or
      "this scene has no closed form: " .. scene.closed.refused))
  end
  local order, wrong = gen.order(given)
  wrong = wrong or gen.orderless(given, { method }) or limits.refused(scene, given,
    { method = method, closed = method == "exact", adaptive = m and m.adaptive,
      tolerances = limits.tolerances[given.real or "double"] })
  if course and course:linear() and m.adaptive and not given.step then
    wrong = "--between linear: the emitted " .. method .. " holds its inputs for steps of its own choice"
  end
  if wrong then return refused(wrong) end
  local job, d = driver.plan(scene, { real = given.real, command = "", methods = { method }, order = order })
  if not job then return nil, { diag = d } end
  local plugin, why, kind = build.plugin(host, job)
  if not plugin then return nil, { status = kind == "range" and 3 or 2, text = why } end
  local refusal = build.refusal(job, plugin)
  if refusal then return nil, { status = 3, text = refusal } end
  local x0 = numeric.initial(job)
  local real = given.real or "double"
  local motion = { method = method, order = m and (m.order or order or m.own_order[real]), longest = limits.emitted,
    quick = 300000, epsilon = limits.tolerances[real][1], adaptive = m and m.adaptive or false, exact = exact,
    emitted = true, least = limits.tolerances[real][1] }
  if method == "exact" then
    if plugin:solve(x0) ~= 0 then return nil, { status = 3, text = "the closed form refuses the initial state" } end
    motion.solve, motion.closed = closed(plugin), true
  else
    if not (m.adaptive and not given.step) then motion.step = given.step or job.model:double(job.model.step) end
    local tolerance = given.tolerance or limits.usual[real]
    motion.tolerance = not motion.step and tolerance or nil
    motion.solve = stepped(plugin, method, x0, course, tolerance, motion.step, corners_of(scene), attitude_of(job))
  end
  function motion.measured(state)
    local energy, L = plugin:energy(state.x), job.model.has.attitude and plugin:momentum(state.x) or {}
    if not finite { energy } then return failed(state.t, "the energy is not finite") end
    if not finite(L) then return failed(state.t, "the angular momentum is not finite") end
    return energy, L
  end
  function motion.judge() return (engines.general(host, scene, {}, course)) end
  if real == "float" then
    motion.double = {}
    for k, v in pairs(given) do motion.double[k] = v end -- a copy: order is lost anyway
    motion.double.real, motion.double.method = "double", method
    motion.double.order = method == "taylor" and motion.order or nil
    function motion.twin() return (engines.generated(host, scene, motion.double, course)) end
  end
  return motion
end

-- ---- the general library ----

-- Of the methods that choose their steps, where none is asked for; GSL's are in double.
local tolerances = { adaptive = 1e-18, taylor = 1e-18, rkf45 = 1e-10, rk8pd = 1e-13, implicit = 1e-18 }
local orders = { adaptive = 24, taylor = 24, rk4 = 4, rkf45 = 5, rk8pd = 8, ["gsl-rk4"] = 4, implicit = 17, exact = 0,
  linearised = 0 }
local names = { "adaptive", "taylor", "rk4", "gsl-rk4", "rkf45", "rk8pd", "implicit", "exact", "linearised" }

-- Can the method of these options have --step, --tolerance or --order?  Unknown methods can: their engine answers.
function engines.takes(given, option)
  local method, emitted = given.method, given.engine == "generated"
  if option == "order" then return emitted and method == "taylor" end
  local none = method == "exact" or method == "linearised" or emitted and not method
  if none or option == "step" then return not none end
  local m = emitted and methods.by_name[method]
  if m then return m.adaptive or false end
  return not (method == "rk4" or method == "gsl-rk4")
end

function engines.general(host, job, given, course)
  local method = given.method or "adaptive"
  if not orders[method] then return refused(no_method("general", method, names)) end
  if given.order then return refused "--order: it is that of the emitted taylor, got --engine general" end
  if given.real then
    return refused "--real: it is the type of the emitted code (--engine generated), got --engine general"
  end
  local fixed, closed_form = method == "rk4" or method == "gsl-rk4", orders[method] == 0
  local adaptive = not fixed and not closed_form
  local wrong = limits.refused(job, given, { method = method, closed = closed_form, adaptive = adaptive,
    tolerances = limits.tolerances.general })
  if wrong then return refused(wrong) end
  local lines = course and course:linear()
  local scene = numeric.scene(job, nil, lines)
  if closed_form and #scene.effects > 0 then
    return refused("--engine general --method " .. method .. " solves free tops, and this scene has effects" ..
      (method == "exact" and job.closed.full and "; --engine generated has its closed form" or ""))
  end
  local motion = { method = method, order = orders[method], longest = limits.library, between = true,
    quick = 20000, epsilon = 2.0 ^ -52, closed = closed_form, adaptive = adaptive, exact = job.closed.full }
  motion.least = limits.tolerances.general[1]
  if not closed_form then motion.step = given.step or fixed and job.model:double(job.model.step) or nil end
  motion.tolerance = not motion.step and (given.tolerance or tolerances[method]) or nil
  function motion.solve(times, o)
    local rows, why, kind, t = host.run(o.from and reference.from(scene, job, o.from.x) or scene, {
      method = method, step = o.step or motion.step, tol = o.tolerance or motion.tolerance, times = times, u = course,
      seen = given.seen, t0 = o.from and o.from.t or 0.0 })
    if not rows then
      return nil, { status = kind == "numbers" and 3 or 2, t = t, text = string.gsub(why, "^at t = %S+ s: ", "") }
    end
    motion.stiff = motion.stiff or method ~= "implicit" and why > 0
    for i, row in ipairs(rows) do
      local n = #row - 4
      rows[i] = { t = row[1], x = numeric.part(job, row, 1), energy = row[n + 1], L = { table.unpack(row, n + 2) } }
    end
    return rows
  end
  function motion.measured(state) return state.energy, state.L end
  return motion
end

return engines
