-- driver.lua -- the whole chain on one screen: from a scene's text to files, in stages (generator/stages.lua).
--
--     text -> record -> model -> equations     driver.read                   the scene
--     -> functions, steppers, constants        driver.plan                   a plan; a scene has any number of them
--     -> C text                                driver.code, driver.files     the unit
-- The only module that knows all the others.  It opens no file: the host hands it text and takes text.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local R = require "generator.algebra.rational"
local quantities = require "generator.attitude.quantities"
local diag = require "generator.diag"
local env = require "generator.dsl.env"
local phases = require "generator.dsl.phases"
local ranges = require "generator.dsl.ranges"
local unused_params = require "generator.dsl.unused"
local catalogue = require "generator.mass.catalogue"
local effects = require "generator.effects.effects"
local stability = later "generator.mass.spin_stability"
local model = require "generator.dynamics.model"
local equations = require "generator.dynamics.equations"
local exists = require "generator.dynamics.exists"
local closed = require "generator.dynamics.closed.closed"
local breaks = require "generator.dynamics.breaks"
local conserved = require "generator.dynamics.conserved"
local constants = require "generator.dynamics.constants"
local symmetric = require "generator.dynamics.closed.symmetric"
local fixed_point = later "generator.methods.q31_run"
local costs = require "generator.report.costs"
local counted = later "generator.report.counted"
local derivation = require "generator.report.derivation"
local baked = require "generator.emit.baked"
local number = require "generator.emit.number"
local packages = require "generator.emit.packages.packages"
local poly = require "generator.algebra.poly"
local project = require "generator.emit.project"
local functions = require "generator.functions"
local nearest = require "generator.nearest"
local selection = require "generator.selection"
local stages = require "generator.stages"
local disc = require "generator.dynamics.closed.disc"

local driver = { version = "0.1.0" }

-- What follows from a scene is bounded as the scene itself is: gen of the largest of bodies/ takes a tenth of that.
-- What the user asks for beyond the plain code is allowed for.
local function budget(options)
  local more = math.max(0, #(options.methods or options.method or {}) - 1) + (options.accuracy and 8 or 0)
  local with = options.with or {}
  if options.jacobians or with.jacobians then more = more + 3 end
  if options.q31 or with.q31 or options.compensated or with.compensated then more = more + 3 end
  return { turnover = (256 << 20) * (1 + more), bytes = (40 << 20) * (1 + more), seconds = 10.0 * (1 + more) }
end

-- A body on a plane has a mass matrix and a contact point to differentiate: three times as much.
local function allowed(job)
  local b, k = job.budget, 1
  for _, e in ipairs(job.record.effects) do k = e.spec.touches and 3 or k end
  return { turnover = b.turnover * k, bytes = b.bytes * k, seconds = b.seconds * k, used = b.used }
end

-- f(...), or nil and an error in the diagnostics of a scene or plan.  Hosts of tests have no bounds.
local function bounded(job, f, ...)
  if not job.host.bounded then return f(...) end
  local limits = allowed(job)
  local r = table.pack(job.host.bounded(f, limits, ...))
  job.budget.used = limits.used -- the plan has what the scene leaves
  if r[1] then return table.unpack(r, 2, r.n) end
  poly.budget = nil -- it was raised at whatever instruction came next
  job.diag:error(job.record.line, "scene", r[2] .. " (POLHODE_PATIENCE=10 allows ten times as much)")
  return nil
end

-- The model, equations and what follows from them, into an open scene; nil after an error.
local function model_of(scene, options)
  local d, record = scene.diag, scene.record
  unused_params.warn(d, record)
  local m = model.new(d, record, options)
  if not m then return nil end
  local within = ranges.resolve(d, record, m)
  local eq = equations.of(d, constants.open(m))
  if not eq or within == false then return nil end
  scene.model, scene.equations, scene.closed, scene.states = m, eq, closed.detect(m, eq), m.states
  scene.conserved, scene.ranges = conserved.of(eq), within
  eq.model:close()
  return scene
end

-- Which parameters there are instead of the one that is not.
local function instead(name, record)
  local names = {}
  for i, p in ipairs(record.params) do names[i] = p.name end
  local best = nearest.one(name, names)
  return (#names > 0 and " (it has " .. table.concat(names, ", ") .. ")" or "") ..
    (best and "; did you mean " .. best .. "?" or "")
end

-- Reports that the body of a scene ceases to be one before its motion ends: false.  options: until, at = times of rows,
-- follows = does the command follow the motion to its horizon?  Where nobody said how long it lasts this is a warning.
local function lasts(scene, options)
  local last = options["until"] or not options.at and scene.model:double(scene.model.horizon) or 0.0
  for _, t in ipairs(options.at or {}) do last = math.max(last, t) end
  local ends, line = exists.fails(scene, last)
  if not ends then return true end
  local asked = options["until"] or options.at or options.follows or scene.record.timed
  local error_words = string.format("I + D(t) must be a body's tensor up to t = %.6g s: from t = %.6g s on a " ..
    "principal moment is more than the other two together", last, ends)
  local report = asked and scene.diag.error or scene.diag.warn
  report(scene.diag, line, "effect.inertia_rate", error_words)
  return not asked
end

-- The scene of a file's text: what driver.read returns.
local function opened(host, file, text, options)
  local d = diag.new(file, text)
  local record, unused = env.record(host, d, text, { shapes = catalogue.list, effects = effects,
    quantities = quantities.words() }, options.set, options.name)
  if not record then return nil, d end
  if unused then return nil, d, "--set " .. unused .. ": the scene has no such parameter" .. instead(unused, record) end
  if record.body.broken then return nil, d end
  record = phases.of(d, record, options.phase)
  if not record then return nil, d end
  if options.phase and not record.flies and not record.landing then
    return nil, d, "--phase " .. options.phase .. ": the scene has no effect.plane with impact"
  end
  if record.flies and not options.phase then
    d:warn(record.line, "scene", "is that of the body on the plane: polhode run, plot and view follow it into the " ..
      "air, " ..
      "--phase flight of gen and explain is the scene in the air")
  end
  local scene = stages.open "scene"
  scene.host, scene.templates, scene.version, scene.build = host, host.templates, driver.version, host.build or
    driver.version
  scene.file, scene.source, scene.text, scene.diag = file, string.match(file, "[^/]*$"), text, d
  scene.record, scene.budget = record, budget(options)
  if not bounded(scene, model_of, scene, options) or not lasts(scene, options) then return nil, d end
  return stages.close(scene)
end

-- Reads and checks the scene of a file, - for standard input.  options: {set =, bake =, name = (in place of the scene's
-- own), phase = "contact" (the default) or "flight" of a body that flies and lands, until, at, follows = see
-- `lasts`}.  Returns the scene, a stage of generator/stages.lua, or nil, the diagnostics, and what is wrong with the
-- options (a name in --set that is no parameter).  scene.ranges: see dsl/ranges.lua.
function driver.read(host, file, options)
  local text, why = host.read(file)
  if not text then return nil, nil, why end
  return opened(host, file == "-" and "stdin" or file, text, options)
end

-- The phase in the air of a scene that was read with these options; the same results.
function driver.flight(scene, options)
  return opened(scene.host, scene.file, scene.text, { set = options.set, bake = options.bake, name = options.name,
    phase = "flight" })
end

-- What the emitted header says of its sources: {hash =, the SHA-256 of the scene's text and of all files that it names,
-- one after the other; hashes =, of each: {name =, hash =}}; nil and a message if one cannot be read.
function driver.trace(scene)
  local host = scene.host
  local list, paths = { { name = scene.source, hash = host.sha256(scene.text) } }, {}
  for i, f in ipairs(scene.record.files) do
    local digest, why = host.sha256("", f.path)
    if not digest then return nil, why end
    list[#list + 1], paths[i] = { name = f.name, hash = digest }, f.path
  end
  local whole, why = host.sha256(scene.text, table.unpack(paths))
  return whole and { hash = whole, hashes = list }, why
end

-- The closed form that a plan emits, or why none.
local function form(scene, chosen, options)
  local exact = not options.methods
  for _, name in ipairs(options.methods or {}) do exact = exact or name == "exact" end
  if not chosen.orbit then return { refused = "not called for (--only)", others = {} } end
  return exact and scene.closed or { refused = "not asked for (--method)", others = {} }
end

-- An open plan of a scene, with constants of its own.
local function plan_of(scene, options, d)
  local plan = stages.open("plan", scene)
  plan.diag, plan.equations = d, equations.fork(scene.equations)
  plan.model = plan.equations.model
  plan.real, plan.command = options.real or "double", options.command
  plan.libm = options.libm or (plan.real == "float" and "own" or "system")
  plan.selection, plan.layout = selection.new(options, scene.closed.full), options.layout or "single"
  plan.closed = form(scene, plan.selection, options)
  plan.package = options.package or packages.by_name(packages.default)
  plan.planned, plan.proof, plan.orders = options.planned, options.proof or false, options.orders
  plan.batch, plan.sweep = options.batch or false, options.sweep or false
  plan.estimator = options.estimator or false
  return plan
end

-- With --bake: each function as cheap as it is without.
local function bake(plan, options)
  local plain = stages.open "scene"
  plain.diag, plain.record, plain.host = diag.new(plan.file, plan.text), plan.record, plan.host
  if not model_of(plain, {}) or #plain.states ~= #plan.states then return end
  local other = plan_of(plain, options, plain.diag)
  if not functions.of(other, options, true) then return end
  for i, s in ipairs(plain.states) do
    if s.name ~= plan.states[i].name then return end
  end
  plan.functions, plan.held = baked.choose(plan, other)
end

local function complete(plan, options)
  local m, eq = plan.model, plan.equations
  if not functions.of(plan, options) then return nil end
  if options.q31 then
    plan.q31 = fixed_point.plan(plan)
    if not plan.q31 then return nil end
  end
  if m.has.rates and m.structure.kind == "symmetric" and not equations.coordinate(m.structure.k) then
    plan.oblique = symmetric.constants(m)
  end
  local closed_form = plan.closed
  plan.closed_constants = closed_form.constants and closed_form.constants(m) or {}
  if disc.of(m) and (plan.selection.asked "disc_integrals" or plan.selection.asked "disc_rates" or
    plan.selection.asked "disc_swing") then
    plan.disc = disc.constants(m)
  end
  plan.smooth_until = breaks.first(eq)
  plan.stability = m.has.rates and plan.selection.asked "spin_stable" and stability.of(m) or nil
  if m.baked then bake(plan, options) end
  plan.title, plan.banner = derivation.title(plan), derivation.banner(plan)
  plan.derivation = derivation.markdown(plan)
  m:close()
  return stages.close(plan)
end

-- A plan of the scene, a stage of generator/stages.lua; nil and its diagnostics after an error.  options: {real =,
-- command =, methods = {"rk4", "exact", ...}, order = (of taylor), and those of generator/selection.lua}; bool:
-- compensated, q31, batch, estimator, proof, outputs (also derivatives of energy and momentum); and
--     jacobians   bool, or "transition": of the step alone
--     libm        "own" | "system"; the default: own in float
--     package     what is written around the code (emit/packages/)
--     planned     a decision of generator/plan/;   orders   those of the series, for the planner
--     sweep       a study of many members;         fit      {free =, outputs =, initial =} (dynamics/tangents.lua)
function driver.plan(scene, options)
  local d, own, before = scene.diag:fork(), budget(options), scene.budget
  if before.bytes >= own.bytes then
    own = { turnover = before.turnover, bytes = before.bytes, seconds = before.seconds, used = before.used }
  end
  local plan = plan_of(scene, options, d)
  plan.budget = own
  if not bounded(plan, complete, plan, options) then return nil, d end
  return plan
end

-- Do the scene's own parameters and the constants made from them survive in the real type?  Reports the first that
-- becomes zero or infinite.
local function representable(job)
  local m = job.model
  local function survives(q) -- zero stays zero; anything else must not become zero or infinite
    local x = job.real == "float" and R.tofloat(q) or R.todouble(q)
    return (x ~= 0 or R.sign(q) == 0) and x ~= math.huge and x ~= -math.huge
  end
  local list = {}
  for _, p in ipairs(m.params) do list[#list + 1] = { "parameter " .. p.name, p.default, p.line } end
  for _, member in ipairs(m.members) do
    local what = "the constant " .. member.name .. " (" .. member.about .. ")"
    list[#list + 1] = { what, m:number(member.e), job.record.line }
  end
  for _, c in ipairs(list) do
    if not survives(c[2]) then
      job.diag:error(c[3], "real " .. job.real, c[1] .. " must be within the range of " .. job.real, "about 2^" ..
        R.log2(c[2]))
      return false
    end
  end
  return true
end

-- The unit of a plan, open.  with: {plugin =, hash =, hashes =, counted =}, see generator/stages.lua.
local function unit_of(plan, with)
  local unit = stages.open("unit", plan)
  for name, x in pairs(with or {}) do unit[name] = x end -- into a table: order is lost anyway
  unit.sheet = function(set_up) return costs.rows(unit, set_up), costs.targets end
  unit.counted_lines = function() return unit.counted and counted.markdown(unit.counted) or {} end
  unit.readings = {}
  return unit
end

-- make(unit), or nil after an error: a constant of the code that the real type cannot hold.
local function within(make, unit)
  local ok, made = xpcall(make, function(e)
    return getmetatable(e) == number.out_of_range and e or debug.traceback(tostring(e), 2)
  end, unit)
  if ok then return made end
  if getmetatable(made) ~= number.out_of_range then error(made, 0) end
  unit.diag:error(unit.record.line, "real " .. unit.real, "every constant must be within its range", made.message)
  return nil
end

-- The unit of a plan closed, with what `make` puts into it; nil after an error in the plan's diagnostics (a constant
-- that the real type cannot hold).
local function made(plan, with, make)
  if not representable(plan) then return nil end
  local unit = unit_of(plan, with)
  return bounded(plan, within, make, unit) and stages.close(unit)
end

-- The unit of a plan with header and source alone, all of them in one: what generator/cost/ops.lua counts.
function driver.code(plan, with) return made(plan, with, project.code) end

-- The unit of a plan with the emitted files.  with: what is said of them.
function driver.files(plan, with)
  return made(plan, with, function(unit)
    unit.files = project.files(unit)
    return unit.files
  end)
end

-- The instructions of all functions after a pass, as text; nil after an error.
function driver.show(plan, pass) return bounded(plan, project.show, unit_of(plan), pass) end

return driver
