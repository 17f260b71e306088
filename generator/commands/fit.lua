-- fit.lua -- polhode fit: parameters of a scene from logs of its sensors.
--
-- The scene says what is measured (dsl/measure.lua); its step and the derivatives of that are emitted and compiled once
-- (emit/fitted.lua), and the search runs in C (src/cli/fit).  Here the two are brought together, and the result is
-- told (report/fit.lua).  docs/fit.md has the formulas.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local breaks = require "generator.dynamics.breaks"
local compiler = require "generator.commands.compiler"
local driven = require "generator.commands.driven"
local driver = require "generator.driver"
local ends = require "generator.commands.ends"
local equations = require "generator.dynamics.equations"
local body_at = require "generator.dynamics.body_at"
local logs = require "generator.commands.fit.logs"
local observed = require "generator.commands.fit.observed"
local options = require "generator.commands.options"
local packages = require "generator.emit.packages.packages"
local diag = require "generator.diag"
local pieces = require "generator.commands.fit.pieces"
local picture = require "generator.commands.picture"
local report = require "generator.report.fit"
local sheet = require "generator.report.fit_sheet"
local starts = require "generator.commands.fit.starts"
local unknowns = require "generator.commands.fit.unknowns"
local written = require "generator.commands.fit.written"

local fit = {}

fit.forms = { { "SCENE", "parameters from measured logs",
  "The scene's key `measure` names what sensors say (docs/fit.md). Estimates, standard errors, correlations, " ..
    "whether the model fits the noise, and what the data do not determine. Exit status 3: it did not converge, or " ..
    "the model does not fit." } }
fit.operands = { 1, 1, "SCENE" }
fit.options = {
  { "--data", "texts", "a log: columns by name, each with [unit] or in SI units; an empty cell or nan is missing; " ..
    "may be given again, and the logs share the parameters", value = "FILE.csv", default = "none: it must be given" },
  { "--free", "words", "the parameters that are looked for, from the scene's values on; initial: also each log's " ..
    "own state at t = 0", value = "NAME,...", default = "none: it must be given" },
  { "--input", "texts", "inputs of the scene over time that no column of the log has; once for all logs, or once " ..
    "for each", value = "FILE.csv", default = "columns of the log" },
  { "--between", { "held", "linear" }, "an input between two of its values: the one before, or on a straight line; " ..
    "linear: an input NAME_rate without a column is the slope of NAME", default = "held" },
  { "--loss", { "squares", "huber", "cauchy" }, "what is made least", value = "L", default = "squares", each = {
    squares = "the sum of squares: the most likely parameters where the noise is normal",
    huber = "squares up to 1.345 sigma, straight lines beyond: outliers count less",
    cauchy = "c^2/2 log(1 + (z/c)^2), c = 2.385 sigma: far outliers count nothing; from Huber's minimum on" } },
  { "--starts", "number", "further starts, points of Sobol's sequence in the parameters' ranges: the scene's " ..
    "ranges, or half of the value up and down; the least minimum is taken", value = "N",
    default = "0: only if the scene's values lead to no minimum that fits, a linear start for a free body, and the " ..
      "log piece by piece" },
  { "--segments", "number", "each log in N pieces with states of their own, for motions that forget how they began; " ..
    "then the whole log from where that ended, if it fits", value = "N", default = "1: the whole log at once" },
  { "--set", "pair", "another value for a parameter of the scene, in the unit that the scene gives it" },
  { "--format", { "text", "json" }, "how the result is written", default = "text" },
  { "--sheet", "text", "also a picture: data and model, residuals, confidence ellipses", value =
    "FILE.svg, FILE.png or FILE.pdf", default = "it is not drawn" },
  { "-o", "text", "also the scene with the estimates as its values", value = "FILE.lua",
    default = "it is not written" },
}
fit.examples = {
  { "polhode fit book.lua --data phone.csv --free I2,I3,initial", "two ratios of moments and the initial rates" },
  { "polhode fit book.lua --data phone.csv --free I2,I3,w1,w2,w3 --loss huber -o fitted.lua",
    "the same for a log with outliers, and the scene with what was found" },
}

local MOST_STARTS = 1000 -- FIT_STARTS of src/cli/fit/fit.h
-- Of the losses, in sigmas: 95 % efficient where the noise is normal (P. J. Huber, Robust Statistics, 1981; P. W.
-- Holland, R. E. Welsch, Communications in Statistics A6 (1977)).
local CORNERS = { huber = 1.345, cauchy = 2.385 }

local FLAGS = { "-O2", "-ftree-vectorize", "-std=c99", "-ffp-contract=off", "-fno-math-errno", "-shared", "-fPIC",
  "-fvisibility=hidden" }

-- What the scene or the command line lacks, or nil.
local function missing(job, given)
  if not given.data then return "--data FILE.csv is missing: the log" end
  if not given.free then return "--free NAME,... is missing: the parameters that are looked for" end
  return driven.wrong(job.model, given)
end

-- The plan whose code is called; or nil and its diagnostics.
function fit.planned(job, free)
  return driver.plan(job, { real = "double", libm = "system", methods = { "rk4" }, command = "polhode fit",
    only = { "init", "defaults", "initial" }, package = packages.by_name "fit",
    fit = { free = free.params, outputs = job.record.measure, initial = free.initial and unknowns.initial } })
end

-- The path of the shared object, or nil and what is wrong.
function fit.compiled(host, job, files)
  local dir, why = host.tempdir()
  if not dir then return nil, why end
  local ok
  ok, why = host.write_files(dir, files)
  if not ok then return nil, why end
  local said
  for _, tuned in ipairs { "-march=native", "-O2" } do -- not every compiler knows this machine
    ok, said = host.compile(dir, { job.model.name .. ".c", "fitted.c" }, "fitted.so",
      { flags = { tuned, table.unpack(FLAGS) }, libs = { "-lm" } })
    if ok then return dir .. "/fitted.so" end
  end
  return nil, compiler.missing(host) or "the emitted code does not compile:\n" .. said
end

-- The channels of residuals of a log, for C; own: its sigmas, taken: of logs.read; second result: are all sigmas known?
function fit.channels(job, outputs, own, taken)
  local place = {}
  for i, s in ipairs(job.fit.states) do place[s.sym] = i end
  local list, value, column, known = {}, 1, 1, true
  for _, o in ipairs(outputs) do
    local function sigma(i)
      local stated = o.e and own[column] or o.sigma and job.model:double(o.sigma[i])
      known = known and stated and true or false
      return stated or 1.0
    end
    if o.e then
      for i = 1, #o.e do
        local how = taken[column] or {}
        list[#list + 1] = { value = value, column = column, sigma = { sigma(i) }, state = place[o.e[i]],
          wrapped = how.wrapped, low = how.low or 0 / 0, high = how.high or 0 / 0 }
        value, column = value + 1, column + 1
      end
    else
      list[#list + 1] = { value = 0, column = column, sigma = { sigma(1), sigma(2), sigma(3) }, attitude = true }
      column = column + 4
    end
  end
  return list, known
end

-- The longest step at first: the usual distance of two rows.
local function first_step(data)
  local least = math.huge
  for _, d in ipairs(data) do least = math.min(least, (d.log:spacing())) end
  return least
end

local function problem(plan, all)
  local free, data = all.free, all.data
  local m, outputs = plan.model, plan.record.measure
  local p = { free = free.places, initial = free.initial, logs = {}, channels = {}, known = true, knots = {},
    loss = "squares", corner = 0.0, step = first_step(data), states = {}, parameters = {}, inputs = all.inputs,
    sizes = unknowns.sizes(m, free), starts = all.starts, low = all.low, high = all.high,
    linear = starts.linear(plan, free, data) }
  for i, d in ipairs(data) do
    local list, known = fit.channels(plan, outputs, d.sigmas, d.taken)
    p.logs[i], p.channels[i], p.known = d.log, list, p.known and known
  end
  for i, s in ipairs(plan.fit.states) do p.states[i] = m:double(s.initial) end
  for i, q in ipairs(m.params) do p.parameters[i] = R.todouble(q.default) end
  for i, k in ipairs(breaks.knots(equations.fork(plan.equations))) do p.knots[i] = R.todouble(k.value) end
  return p
end

-- Residuals by name, in the order of the counts.
local function residuals(outputs)
  local list = {}
  for _, o in ipairs(outputs) do
    for i = 1, o.e and #o.e or 3 do
      list[#list + 1] = o.e and o.columns[i] or o.name .. "_" .. string.sub("xyz", i, i)
    end
  end
  return list
end

local function count_of(data)
  local n = 0
  for _, d in ipairs(data) do
    for _, c in ipairs(d.counts) do n = n + c end
  end
  return n
end

-- A sigma that would change with what is looked for, as a message, or nil: chi-square alone does not say how large it
-- is.
function fit.moving_sigma(outputs, free)
  for _, o in ipairs(outputs) do
    for _, e in ipairs(o.sigma or {}) do
      for _, p in ipairs(free.params) do
        if not expr.constant(e, { [p.name] = true }) then
          return "--free: " .. p.name .. " is in the sigma of " .. o.name .. ", which must be known"
        end
      end
    end
  end
  return nil
end

-- Everything that is known before the search: plan, logs; or nil and the exit status.
local function prepared(host, job, given)
  local free, wrong = nil, missing(job, given)
  if not wrong then free, wrong = unknowns.free(job, given.free) end
  if wrong then return nil, options.wrong(host, "fit", wrong) end
  if not job.record.measure then
    job.diag:error(job.record.line, "scene", "has no key measure, which says what the columns of a log are " ..
      "(measure = { wx = wx, wy = wy, wz = wz, sigma = 0.01 }; docs/fit.md)")
    return nil, options.refuse(host, job.diag)
  end
  if not observed.check(job) then return nil, options.refuse(host, job.diag) end
  local text = fit.moving_sigma(job.record.measure, free) or given.o and written.check(job, free)
  if text then return nil, options.wrong(host, "fit", text) end
  local data, why = logs.read(host, job.record.measure, driven.columns(job.model), given.data)
  local files, inputs, notes
  if data then files, why = driven.files(host, job.model, given.input) end
  if files then inputs, notes = driven.each(host, job.model, data, files, given) end
  if files and #job.model.inputs > 0 and not inputs then files, why = nil, notes end
  if not files then return nil, options.failed(host, "fit", why) end
  local plan, d = fit.planned(job, free)
  if not plan then return nil, options.refuse(host, d) end
  local list = unknowns.list(plan.fit, free, data)
  if count_of(data) <= #list then
    return nil, options.failed(host, "fit", data[1].path .. (#data > 1 and " and others" or "") ..
      ": too few values: " .. count_of(data) .. " for " .. #list .. " unknowns")
  end
  local torn = pieces.wrong(given, free, data, #list - (#data - 1) * (#list - #free.params) // #data)
  if torn then return nil, options.wrong(host, "fit", torn) end
  local count, low, high = given.starts or 0.0, nil, nil
  if count % 1 ~= 0 or count < 0 or count > MOST_STARTS then
    return nil, options.wrong(host, "fit", "--starts must be a whole number from 0 to " .. MOST_STARTS .. ", got " ..
      diag.show(count))
  elseif count > 0 then
    low, high = starts.ranges(job, free)
    if not low then return nil, options.wrong(host, "fit", high) end
  end
  return { starts = count, low = low, high = high, free = free, data = data, plan = plan, unknowns = list,
    inputs = inputs, notes = notes or {} }
end

-- What the emitted code could not ask of the result: a list of sentences.
local function no_body(job, list, result)
  local values = {}
  for i, u in ipairs(list) do
    if u.kind == "param" then values[u.name] = R.fromdouble(result.theta[i]) end
  end
  local said = #job.model.unasked > 0 and body_at(job, values)
  return { said and "the result is no body: " .. said or nil }
end

-- What host.fit says to the question, as report.of has it; or nil and what is wrong.
local function told_of(host, job, all, path, ask, more)
  local begun = host.clock()
  local result, why = host.fit(path, ask)
  if not result then return nil, why end
  result.seconds = host.clock() - begun
  return report.of({ host = host, job = job, result = result, unknowns = more.unknowns, data = more.data,
    names = residuals(job.record.measure), known = ask.known, loss = ask.loss, step = ask.step,
    refusals = all.plan.model.conditions, wrong = no_body(job, more.unknowns, result), notes = all.notes,
    segments = more.segments, whole = more.whole })
end

-- The search; with --segments in pieces, then whole from there, and the whole log's answer if that is good.
local function searched(host, job, all, path, ask, given)
  local n = given.segments and math.tointeger(given.segments)
  if not n then return told_of(host, job, all, path, ask, all) end
  local data = pieces.data(all.data, n)
  local more = { data = data, unknowns = unknowns.list(all.plan.fit, all.free, data), segments = n }
  local told, why = told_of(host, job, all, path, pieces.ask(ask, n), more)
  if not told then return nil, why end
  local whole = told_of(host, job, all, path, pieces.whole(ask, told.result, n), { data = all.data, unknowns =
    all.unknowns, segments = n, whole = true })
  return whole and whole.status == 0 and whole or told
end

function fit.run(host, given)
  local job, d, why = driver.read(host, given[1], given)
  if not job then return options.refuse(host, d, why) end
  local all, status = prepared(host, job, given)
  if not all then return status end
  options.warn(host, job.diag)
  local last = 0.0
  for _, log in ipairs(all.data) do last = math.max(last, (select(3, log.log:spacing()))) end
  ends.warn(host, job, last)
  local unit = driver.files(all.plan)
  if not unit then return options.refuse(host, all.plan.diag) end
  local path
  path, why = fit.compiled(host, job, unit.files)
  if not path then return options.failed(host, "fit", why) end
  local ask = problem(all.plan, all)
  ask.traces = given.sheet ~= nil
  ask.loss = given.loss or "squares"
  ask.corner = CORNERS[ask.loss] or 0.0
  if CORNERS[ask.loss] and not ask.known then
    return options.wrong(host, "fit", "--loss " .. ask.loss .. ": without a sigma nothing tells what is far " ..
      "(measure = { sigma = }, or a comment # sigma: in the log)")
  end
  local told
  told, why = searched(host, job, all, path, ask, given)
  if not told then return options.failed(host, "fit", why) end
  host.out(given.format == "json" and report.json(told) or report.text(told))
  status = given.sheet and picture.write(host, "fit", given.sheet, sheet.text(told)) or 0
  if status ~= 0 then return status end
  if given.o then
    local made = written.text(job, all.unknowns, told.result)
    status = options.write(host, "fit", given.o, made)
    if status ~= 0 then return status end
  end
  return told.status
end

return fit
