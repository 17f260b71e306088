-- driver.lua -- the whole chain on one screen: from a scene's text to a job that can be emitted, shown or run.
--
--     text -> dsl (record) -> dynamics/model -> equations -> closed form, functions -> emit/project (files)
-- The only module that knows all the others.  It opens no file: the host hands it text and takes text.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local diag = require "generator.diag"
local env = require "generator.dsl.env"
local ranges = require "generator.dsl.ranges"
local unused_params = require "generator.dsl.unused"
local catalogue = require "generator.mass.catalogue"
local effects = require "generator.effects.effects"
local stability = require "generator.mass.spin_stability"
local model = require "generator.dynamics.model"
local equations = require "generator.dynamics.equations"
local closed = require "generator.dynamics.closed.closed"
local breaks = require "generator.dynamics.breaks"
local context = require "generator.dynamics.context"
local conserved = require "generator.dynamics.conserved"
local symmetric = require "generator.dynamics.closed.symmetric"
local quantities = require "generator.dynamics.quantities"
local sensitivity = require "generator.dynamics.sensitivity"
local compensated = require "generator.methods.compensated"
local methods = require "generator.methods.methods"
local fixed_point = require "generator.methods.q31_run"
local costs = require "generator.report.costs"
local counted = require "generator.report.counted"
local derivation = require "generator.report.derivation"
local baked = require "generator.emit.baked"
local number = require "generator.emit.number"
local packages = require "generator.emit.packages.packages"
local poly = require "generator.algebra.poly"
local project = require "generator.emit.project"
local nearest = require "generator.nearest"
local selection = require "generator.selection"

local driver = { version = "0.1.0" }

-- What follows from a scene is bounded as the scene itself is: gen of the largest of bodies/ takes less than half of
-- that.  What the user asks for beyond the plain code is allowed for.
local function budget(options)
  local more = math.max(0, #(options.methods or options.method or {}) - 1) + (options.accuracy and 8 or 0)
  local with = options.with or {}
  if options.jacobians or with.jacobians then more = more + 3 end
  if options.q31 or with.q31 or options.compensated or with.compensated then more = more + 3 end
  return { steps = 64000000 * (1 + more), bytes = (40 << 20) * (1 + more), seconds = 10.0 * (1 + more) }
end

-- f(...), or nil and an error in the job's diagnostics.  Hosts of tests have no bounds.
local function bounded(job, f, ...)
  if not job.host.bounded then return f(...) end
  local r = table.pack(job.host.bounded(f, job.budget, ...))
  if r[1] then return table.unpack(r, 2, r.n) end
  poly.budget = nil -- it was raised at whatever instruction came next
  job.diag:error(job.record.line, "scene", r[2] .. " (POLHODE_PATIENCE=10 allows ten times as much)")
  return nil
end

local function model_of(job, options)
  local d, record = job.diag, job.record
  unused_params.warn(d, record)
  local m = model.new(d, record, options)
  if not m then return nil end
  local within = ranges.resolve(d, record, m)
  local eq = equations.of(d, m)
  if not eq or within == false then return nil end
  job.model, job.equations, job.closed, job.states = m, eq, closed.detect(m, eq), m.states
  job.conserved, job.ranges = conserved.of(eq), within
  return job
end

-- Which parameters there are instead of the one that is not.
local function instead(name, record)
  local names = {}
  for i, p in ipairs(record.params) do names[i] = p.name end
  local best = nearest.one(name, names)
  return (#names > 0 and " (it has " .. table.concat(names, ", ") .. ")" or "") ..
    (best and "; did you mean " .. best .. "?" or "")
end

-- Reads and checks the scene of a file, - for standard input.  options: {set =, bake =, name = (in place of the scene's
-- own)}.  Returns the job so far {diag, record, model, equations, closed} or nil, the diagnostics, and (a name in --set
-- that is no parameter).  job.ranges: see dsl/ranges.lua.
function driver.read(host, file, options)
  local text, why = host.read(file)
  if not text then return nil, nil, why end
  if file == "-" then file = "stdin" end
  local d = diag.new(file, text)
  local record, unused = env.record(host, d, text, { shapes = catalogue.list, effects = effects }, options.set,
    options.name)
  if not record then return nil, d end
  if unused then return nil, d, "--set " .. unused .. ": the scene has no such parameter" .. instead(unused, record) end
  if record.body.broken then return nil, d end
  local job = { diag = d, record = record, templates = host.templates, file = file,
    source = string.match(file, "[^/]*$"), version = driver.version, build = host.build or driver.version, host = host,
    text = text, budget = budget(options) }
  if not bounded(job, model_of, job, options) then return nil, d end
  return job
end

-- What the emitted header says of its sources: job.hash, the SHA-256 of the scene's text and of all files that it
-- names, one after the other, and job.hashes, of each: {name =, hash =}.  nil and a message if one cannot be read.
function driver.trace(host, job)
  local list, paths = { { name = job.source, hash = host.sha256(job.text) } }, {}
  for i, f in ipairs(job.record.files) do
    local digest, why = host.sha256("", f.path)
    if not digest then return nil, why end
    list[#list + 1], paths[i] = { name = f.name, hash = digest }, f.path
  end
  local whole, why = host.sha256(job.text, table.unpack(paths))
  job.hash, job.hashes = whole, list
  return whole, why
end

-- The steppers that are asked for, the first one as NAME_step; rk4 if none is: a list of {method, program}.
local function steppers(job, options)
  local list = {}
  for _, name in ipairs(options.methods or {}) do
    local method, program = methods.by_name[name], nil
    if method and method.program and job.plain then
      program = { transition = true } -- its name is all that counts
    elseif method and method.program then
      local why
      program, why = method.program(job.equations, options)
      if not program then
        job.diag:error(job.record.line, "method " .. name, why)
        return nil
      end
    end
    if method then list[#list + 1] = { method = method, program = program } end
  end
  if #list == 0 then list[1] = { method = methods.by_name.rk4 } end
  return list
end

-- The gradients of energy and momentum.
local function gradients(job)
  local m, list = job.model, {}
  local function put(f, name, what)
    list[#list + 1] = sensitivity.of_made(m, f, name, { "Derivative of " .. what .. " by the states, row major: G[" ..
      (name == "momentum_gradient" and "i*NX + " or "") .. "k] = d/dx[k]." })
  end
  put(quantities.energy(m), "energy_gradient", "the energy")
  if job.conserved.rate then
    put(quantities.jacobi_integral(m, job.conserved.rate), "integral_gradient", "Jacobi's integral")
  end
  if m.has.rates then
    put(m.has.attitude and quantities.momentum(m) or quantities.momentum_body(m), "momentum_gradient",
      "the angular momentum")
  end
  return list
end

-- The list of functions in the order they are emitted, into the job; nil after an error in its diagnostics.
local function functions(job, options)
  local m, eq = job.model, job.equations
  local exact = not options.methods
  for _, name in ipairs(options.methods or {}) do exact = exact or name == "exact" end
  if not job.selection.orbit then
    job.closed = { refused = "not called for (--only)", others = {} }
  elseif not exact then job.closed = { refused = "not asked for (--method)", others = {} } end
  job.methods, job.jacobians = options.methods, options.jacobians
  job.steppers = steppers(job, options)
  if not job.steppers then return nil end
  local list, made = {}, job.selection.made
  local function put(name, of, ...)
    if made(name) then list[#list + 1] = of(...) end
  end
  put("initial", quantities.initial, m)
  put("mass", function() return (quantities.mass(m)) end)
  if m.has.rates then
    put("inertia", quantities.inertia, m)
    put("inertia_at", quantities.inertia_at, m)
    if context.parts(m) then put("inertia_now", quantities.inertia_now, m) end
  end
  put("energy", quantities.energy, m)
  if job.conserved.rate then put("jacobi_integral", quantities.jacobi_integral, m, job.conserved.rate) end
  local particles = m.has.rates and made "particle_energy" and quantities.particle_energy(m)
  if particles then list[#list + 1] = particles end
  if m.has.rates then put("momentum_body", quantities.momentum_body, m) end
  if m.has.attitude then put("momentum", quantities.momentum, m) end
  if m.has.rates then put("torque", quantities.torque, m) end
  put("rhs", quantities.rhs, eq)
  for i, s in ipairs(job.steppers) do
    local name = i == 1 and "step" or s.method.name .. "_step"
    if s.method.groups then put(name, quantities.step, m, eq, s.method, name) end
  end
  put("jacobian", quantities.jacobian, eq)
  if options.jacobians then
    local more = sensitivity.list(job, options.jacobians)
    if not more then return nil end
    for _, f in ipairs(more) do put(f.name, function() return f end) end
    if options.outputs then
      for _, f in ipairs(gradients(job)) do put(f.name, function() return f end) end
    end
  end
  if options.compensated then
    local more = compensated.list(job)
    if not more then return nil end
    for _, f in ipairs(more) do put(f.name, function() return f end) end
  end
  put("rate", quantities.rate)
  put("acceleration", quantities.acceleration)
  job.functions = list
  return list
end

-- With --bake: each function as cheap as it is without.
local function bake(job, options)
  local plain = { diag = diag.new(job.file, job.text), record = job.record, host = job.host, plain = true,
    selection = job.selection }
  if not (model_of(plain, {}) and functions(plain, options)) or #plain.states ~= #job.states then return end
  for i, s in ipairs(plain.states) do
    if s.name ~= job.states[i].name then return end
  end
  baked.choose(job, plain)
end

-- Completes the job for emission; nil after an error in its diagnostics.  options: {real =, command =, methods =
-- {"rk4", "exact", ...}, order = (of taylor), jacobians = bool or "transition" (of the step alone), compensated =
-- bool, q31 =
-- bool, libm = "own" | "system" (the default: own in float), outputs = bool: also derivatives of energy and momentum}
local function plan(job, options)
  local m, eq = job.model, job.equations
  job.real, job.command = options.real or "double", options.command
  job.libm = options.libm or (job.real == "float" and "own" or "system")
  job.selection, job.layout, job.batch = selection.new(options), options.layout or "single", options.batch
  if not functions(job, options) then return nil end
  if options.q31 then
    job.q31 = fixed_point.plan(job)
    if not job.q31 then return nil end
  end
  if m.has.rates and m.structure.kind == "symmetric" and not equations.coordinate(m.structure.k) then
    job.oblique = symmetric.constants(m)
  end
  local form = job.closed
  job.closed_constants = form.constants and form.constants(m) or {}
  job.smooth_until = breaks.first(eq)
  job.stability = m.has.rates and job.selection.asked "spin_stable" and stability.of(m) or nil
  if m.baked then bake(job, options) end
  job.title, job.banner = derivation.title(job), derivation.banner(job)
  job.derivation = derivation.markdown(job)
  job.sheet = function(set_up)
    driver.code(job)
    return costs.rows(job, set_up), costs.targets
  end
  job.counted_lines = function() return job.counted and counted.markdown(job.counted) or {} end
  return job
end

function driver.plan(job, options)
  local own = budget(options)
  if job.budget.bytes < own.bytes then job.budget = own end
  return bounded(job, plan, job, options)
end

-- Header and source of a planned job: what generator/cost/ops.lua counts, kept in the job.
function driver.code(job)
  if not job.code then
    local header, source = project.code(job)
    job.code = { header = header, source = source }
  end
  return job.code
end

-- Do the scene's own parameters and the constants made from them survive in the real type?  Reports the first that
-- becomes zero or infinite.
function driver.representable(job)
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

local function emit(job, plugin)
  local ok, files = xpcall(project.files, function(e)
    return getmetatable(e) == number.out_of_range and e or debug.traceback(tostring(e), 2)
  end, job, plugin)
  if ok then return files end
  if getmetatable(files) ~= number.out_of_range then error(files, 0) end
  job.diag:error(job.record.line, "real " .. job.real, "every constant must be within its range", files.message)
  return nil
end

-- The emitted files of a planned job, or nil after an error in its diagnostics (a constant that the real type cannot
-- hold); plugin: also what the program itself loads.
function driver.files(host, job, plugin)
  job.templates = host.templates
  job.package = job.package or packages.by_name(packages.default)
  if not driver.representable(job) then return nil end
  return bounded(job, emit, job, plugin)
end

function driver.show(host, job, pass)
  job.templates = host.templates
  return bounded(job, project.show, job, pass)
end

return driver
