-- engines.lua -- the motion that a command line asks for: by the general library or by the emitted code.
--
-- It is one of dynamics/motion.lua and has also `method`; `step`, the fixed step it goes by, or nil; `order`, the
-- method's; `longest`, the most steps that it does (`between`: of two rows, else of the whole run); `quick`, steps that
-- take less than a second; `adaptive`, that it could choose its steps; `closed`, that it takes none; `exact`, that the
-- scene has a closed form; `epsilon` of its numbers; `emitted`, that it is generated code; `tolerance` by which it
-- chooses its steps, or nil, and `least`, the smallest; and
--     twin()    of a motion in float: the same in double, or nil
--     judge()   of generated code: the library's motion, near rounding, or nil
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
local limits = require "generator.commands.run.limits"
local methods = require "generator.methods.methods"
local motion = require "generator.dynamics.motion"
local numeric = require "generator.dynamics.numeric"

local engines = {}

-- The command line is wrong.
local function refused(text) return nil, { command = true, text = text } end

-- That an engine has no such method: a message.
local function no_method(engine, method, list)
  return "--engine " .. engine .. " has the methods " .. table.concat(list, ", ") .. ", got " .. method ..
    (method == "linearised" and " (--engine general has it; in C it is the function NAME_linearised)" or
      options.meant(method, list))
end

-- ---- the emitted code ----

-- The knots of the scene's tables, for its own parameters, in their order.
local function corners_of(scene)
  local list = {}
  for i, k in ipairs(breaks.knots(equations.fork(scene.equations))) do list[i] = R.todouble(k.value) end
  return list
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
  local real = given.real or "double"
  local step = m and (given.step or not m.adaptive and job.model:double(job.model.step)) or nil
  local tolerance = not step and (given.tolerance or limits.usual[real]) or nil
  local way, failure = motion.emitted(job, plugin, { method = method, step = step, tolerance = tolerance,
    course = course, corners = corners_of(scene), dated = true, order = m and (m.order or order or m.own_order[real]),
    longest = limits.emitted, quick = 300000, emitted = true, exact = exact, closed = not m,
    epsilon = limits.tolerances[real][1], least = limits.tolerances[real][1], adaptive = m and m.adaptive or false })
  if not way then return nil, failure end
  function way.judge() return (engines.general(host, scene, {}, course)) end
  if real == "float" then
    way.double = {}
    for k, v in pairs(given) do way.double[k] = v end -- a copy: order is lost anyway
    way.double.real, way.double.method = "double", method
    way.double.order = method == "taylor" and way.order or nil
    function way.twin() return (engines.generated(host, scene, way.double, course)) end
  end
  return way
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
  local step = not closed_form and (given.step or fixed and job.model:double(job.model.step)) or nil
  local tolerance = not step and (given.tolerance or tolerances[method]) or nil
  return motion.library(host, job, scene, { method = method, step = step, tolerance = tolerance, course = course,
    seen = given.seen, order = orders[method], longest = limits.library, between = true, quick = 20000,
    exact = job.closed.full, closed = closed_form, epsilon = 2.0 ^ -52, least = limits.tolerances.general[1],
    adaptive = adaptive })
end

return engines
