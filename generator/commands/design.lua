-- design.lua -- polhode design: before anything is measured, what a log would tell, and which one tells most.
--
-- The scene is emitted and compiled as for polhode fit; src/cli/fit/design.c makes the log that each candidate would
-- give, without noise, and takes Fisher's information of it.  The result is told by report/design.lua; docs/fit.md has
-- the formulas.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local breaks = require "generator.dynamics.breaks"
local candidates = require "generator.commands.design.candidates"
local diag = require "generator.diag"
local driven = require "generator.commands.driven"
local driver = require "generator.driver"
local ends = require "generator.commands.ends"
local equations = require "generator.dynamics.equations"
local body_at = require "generator.dynamics.body_at"
local fit = require "generator.commands.fit"
local observed = require "generator.commands.fit.observed"
local options = require "generator.commands.options"
local report = require "generator.report.design"
local unknowns = require "generator.commands.fit.unknowns"

local design = {}

design.forms = { { "SCENE", "which motion tells most, before measuring",
  "The standard errors that polhode fit would state for a log that is still to be measured, for each candidate, and " ..
    "the best of them (docs/fit.md). The scene's key `measure` says what is measured, and its sigma how well. Exit " ..
    "status 3: no candidate determines what is asked for." } }
design.operands = { 1, 1, "SCENE" }
design.options = {
  { "--free", "words", "the parameters that the log shall tell, near the scene's values; initial: the log's own " ..
    "state at t = 0 is not known either", value = "NAME,...", default = "none: it must be given" },
  { "--over", "text", "candidates on a grid: initial rates, and parameters such as a pulse's strength or its time; " ..
    ":log for equal ratios", value = "NAME=LOW:HIGH:COUNT,...",
    default = "the scene alone, as it stands" },
  { "--candidates", "number", "candidates that are spread evenly in the ranges of --vary (at each point of the grid)",
    value = "N", default = "none" },
  { "--vary", "text", "these ranges: uniform(LOW,HIGH), loguniform(LOW,HIGH)", value = "NAME=RANGE,...",
    default = "none" },
  { "--input", "texts", "the scene's inputs over time; may be given again: each file is a candidate, at each point " ..
    "of --over and --vary", value = "FILE.csv", default = "none: a scene with inputs needs one" },
  { "--between", { "held", "linear" }, "an input between two of its values, as polhode fit has it", default = "held" },
  { "--until", "number", "the log's end, in s", value = "T", default = "the scene's time.horizon" },
  { "--rate", "number", "how many rows a second has", value = "HZ", default = "100" },
  { "--of", "words", "the free parameters whose errors count", value = "NAME,...",
    default = "all of --free, without initial" },
  { "--best", { "D", "A", "E" }, "by which number the candidates are ordered, all of them relative standard errors",
    default = "D", value = "BY", each = {
      D = "the geometric mean over the axes of the ellipsoid of errors: its volume",
      A = "the root of the mean square of the parameters' errors",
      E = "the largest error of any combination: the longest axis" } },
  { "--top", "number", "how many candidates are listed", value = "N", default = "10" },
  { "--set", "pair", "another value for a parameter of the scene, in the unit that the scene gives it" },
  { "--format", { "text", "json" }, "how the result is written; json has all candidates", default = "text" },
}
design.examples = {
  { "polhode design book.lua --free I2,I3,initial --over wx=-3:3:7,wy=0.5:3:6 --until 2",
    "how a book should be thrown so that two seconds of a gyro tell its moments" },
  { "polhode design book.lua --free I2,I3,initial --candidates 200 --vary 'wx=uniform(-5,5),wy=uniform(-5,5)' " ..
    "--best E", "two hundred throws, by the worst combination" },
}

local MOST_ROWS, MOST_VALUES = 10000000, 20000000

-- The files of --input, each with what src/cli/fit takes of it: {path =, inputs =}; without any one that has none.
-- nil and a message if one cannot be read or lacks an input.
local function driven_by(host, m, given)
  if #m.inputs == 0 then return { {} } end
  local files, why = driven.files(host, m, given.input)
  if not files then return nil, why end
  local list = {}
  for i, file in ipairs(files) do
    local inputs, wrong = driven.each(host, m, { { path = "the log", inputs = {} } }, { file }, given)
    if not inputs then return nil, wrong end
    list[i] = { path = file.path, inputs = inputs }
  end
  return list
end

-- The places of the unknowns whose errors count.
local function counted(given, list, wrong)
  local names, of = {}, {}
  for _, u in ipairs(list) do names[#names + 1] = u.kind == "param" and u.name or nil end
  local bad = given.of and options.unknown("--of", given.of, names)
  if bad then
    wrong[#wrong + 1] = bad
    return of
  end
  local chosen = {}
  for _, word in ipairs(given.of or names) do chosen[word] = true end
  for i, u in ipairs(list) do of[#of + 1] = (u.kind == "param" and chosen[u.name] or #names == 0) and i or nil end
  return of
end

-- With what an error is compared: the parameter's own size; where that is 0 the largest of the same unit, or 1.
local function sizes(list)
  local size, largest = {}, {}
  for i, u in ipairs(list) do
    size[i] = u.param and math.abs(R.todouble(u.param.default)) or 0.0
    largest[u.unit] = math.max(largest[u.unit] or 0.0, size[i])
  end
  for i, u in ipairs(list) do
    if size[i] == 0 then size[i] = largest[u.unit] > 0 and largest[u.unit] or u.factor end
  end
  return size
end

-- Is there a corner in time that would move with a candidate?
local function moving_corner(plan, values)
  local varied = false
  for _, v in ipairs(values) do varied = varied or v.kind == "param" end
  for _, k in ipairs(varied and breaks.knots(equations.fork(plan.equations)) or {}) do
    if k.time.kind ~= "num" then
      return "a table over time has a corner that depends on parameters: only initial states can be varied"
    end
  end
  return nil
end

-- Where the values of a candidate go: k for parameter k, -k for the followed state k.
local function places(values, plan, wrong)
  local list, own = {}, {}
  for i, s in ipairs(plan.fit.states) do own[s.name] = i end
  for i, v in ipairs(values) do
    for k, p in ipairs(plan.model.params) do
      if v.kind == "param" and p.name == v.name then list[i] = k end
    end
    if v.kind == "state" then list[i] = own[v.name] and -own[v.name] end
    if not list[i] then wrong[#wrong + 1] = v.name .. ": nothing that is measured depends on it" end
  end
  return list
end

local function log_of(given, job, columns, wrong)
  local function say(...) wrong[#wrong + 1] = string.format(...) end
  local rate, finish = given.rate or 100.0, given["until"] or job.model:double(job.model.horizon)
  if rate <= 0 then say("--rate must be positive, got %s", diag.show(rate)) end
  if finish <= 0 then say("--until must be positive, got %s", diag.show(finish)) end
  if #wrong > 0 then return nil end
  local rows = math.floor(finish * rate * (1 + 1e-12)) + 1
  if rows > MOST_ROWS or rows * columns > MOST_VALUES then
    say("--rate, --until: %.0f rows of %d values are too many", rows, columns)
  elseif rows < 2 then
    say("--until %s: there must be two rows or more at --rate %s", diag.show(finish), diag.show(rate))
  end
  return { rows = rows, spacing = 1 / rate, rate = rate, finish = finish }
end

local function columns_of(outputs)
  local n = 0
  for _, o in ipairs(outputs) do n = n + #o.columns end
  return n
end

-- What host.design is asked, but for the candidates.
local function problem(plan, free, log, of, size)
  local m, outputs = plan.model, plan.record.measure
  local channels, known = fit.channels(plan, outputs, {}, {})
  local p = { free = free.places, initial = free.initial, logs = { false }, channels = { channels }, known = known,
    knots = {}, loss = "squares", corner = 0.0, step = log.spacing, states = {}, parameters = {}, rows = log.rows + 0.0,
    sizes = unknowns.sizes(m, free), spacing = log.spacing, columns = columns_of(outputs) + 0.0, of = of, size = size }
  for i, s in ipairs(plan.fit.states) do p.states[i] = m:double(s.initial) end
  for i, q in ipairs(m.params) do p.parameters[i] = R.todouble(q.default) end
  for i, k in ipairs(breaks.knots(equations.fork(plan.equations))) do p.knots[i] = R.todouble(k.value) end
  return p, known
end

local function told_of(host, path, ask, points, values, inputs)
  ask.candidates, ask.count, ask.inputs = {}, #points + 0.0, inputs
  for _, point in ipairs(points) do
    for k, v in ipairs(values) do ask.candidates[#ask.candidates + 1] = point[k] * v.scale end
  end
  return host.design(path, ask)
end

-- What the command line and the scene lack: a list of messages, and an exit status where it is the scene's fault.
local function mistakes(host, job, given)
  local wrong, free = {}, nil
  if not given.free then wrong[1] = "--free NAME,... is missing: what the log shall tell" end
  wrong[#wrong + 1] = driven.wrong(job.model, given)
  if #job.model.inputs > 0 and not given.input then
    wrong[#wrong + 1] = "the scene has inputs: --input FILE.csv says what they are over time"
  end
  if given.free then
    local bad
    free, bad = unknowns.free(job, given.free)
    wrong[#wrong + 1] = bad
  end
  if given.top and (given.top < 1 or given.top % 1 ~= 0) then
    wrong[#wrong + 1] = "--top must be a whole number from 1 on, got " .. diag.show(given.top)
  end
  return wrong, free, candidates.read(host, job, given, wrong)
end

local function scene_lacks(job)
  if not job.record.measure then
    job.diag:error(job.record.line, "scene", "has no key measure, which says what is measured and how well " ..
      "(measure = { wx = wx, wy = wy, wz = wz, sigma = 0.01 }; docs/fit.md)")
    return true
  end
  if not observed.check(job) then return true end
  for _, o in ipairs(job.record.measure) do
    if not o.sigma then
      job.diag:error(o.line, "measure", "sigma must be given: how uncertain a log will be depends on its noise")
      return true
    end
  end
  return false
end

local function say_all(host, wrong)
  for _, why in ipairs(wrong) do host.err("polhode design: " .. why .. "\n") end
  host.err("(polhode help design)\n")
  return 2
end

-- How the errors of the best candidate fall with the log's length: its halves.
local function growth(host, path, ask, best, values, log, inputs)
  local list = {}
  for k = 3, 1, -1 do
    local rows = (log.rows - 1) // 2 ^ k + 1
    if rows >= 4 then
      ask.rows = rows
      local made = told_of(host, path, ask, { best }, values, inputs)
      list[#list + 1] = { t = (rows - 1) * log.spacing, result = made and made[1] }
    end
  end
  return list
end

-- A varied parameter must be no part of a sigma: a message, or nil.
local function misplaced(job, values)
  local params = {}
  for _, v in ipairs(values) do
    for _, p in ipairs(v.kind == "param" and job.model.params or {}) do
      params[#params + 1] = p.name == v.name and p or nil
    end
  end
  local text = fit.moving_sigma(job.record.measure, { params = params })
  return text and string.gsub(text, "^%-%-free", "--over, --vary")
end

-- What the emitted code cannot ask of the candidates: {of each that is no body its place -> why}.
local MOST_ASKED = 4000 -- some 10 ms each
local function no_bodies(host, job, among)
  local said = {}
  if #job.model.unasked == 0 then return said end
  if #among.points > MOST_ASKED then
    options.unasked(host, job, "is not asked of more than " .. MOST_ASKED .. " candidates")
    return said
  end
  for i, point in ipairs(among.points) do
    local values = {}
    for k, v in ipairs(among.values) do
      if v.kind == "param" then values[v.name] = R.fromdouble(point[k] * v.scale) end
    end
    said[i] = next(values) and body_at(job, values)
  end
  return said
end

function design.run(host, given)
  local job, d, why = driver.read(host, given[1], given)
  if not job then return options.refuse(host, d, why) end
  local wrong, free, among = mistakes(host, job, given)
  if #wrong > 0 then return say_all(host, wrong) end
  if scene_lacks(job) then return options.refuse(host, job.diag) end
  local files
  files, why = driven_by(host, job.model, given)
  if not files then return options.failed(host, "design", why) end
  wrong[1] = misplaced(job, among.values)
  local plan
  plan, d = fit.planned(job, free)
  if not plan then return options.refuse(host, d) end
  local list = unknowns.list(plan.fit, free, { { path = "log" } })
  local log = log_of(given, job, columns_of(job.record.measure), wrong)
  local of, put = counted(given, list, wrong), places(among.values, plan, wrong)
  wrong[#wrong + 1] = moving_corner(plan, among.values)
  if #wrong > 0 then return say_all(host, wrong) end
  options.warn(host, job.diag)
  ends.warn(host, job, log.finish)
  local unit = driver.files(plan)
  if not unit then return options.refuse(host, plan.diag) end
  local path
  path, why = fit.compiled(host, job, unit.files)
  if not path then return options.failed(host, "design", why) end
  local ask = problem(plan, free, log, of, sizes(list))
  ask.places = put
  local found = { job = job, unknowns = list, of = of, values = among.values, points = {}, inputs = {}, results = {},
    log = log, by = given.best or "D", top = given.top or 10, refusals = plan.model.conditions }
  local said = no_bodies(host, job, among)
  for _, file in ipairs(files) do
    local results
    results, why = told_of(host, path, ask, among.points, among.values, file.inputs)
    if not results then return options.failed(host, "design", why) end
    for i, r in ipairs(results) do
      if r.refused == 0 and said[i] then r.refused, r.said = -2, said[i] end
      local n = #found.results + 1
      found.results[n], found.points[n], found.inputs[n] = r, among.points[i], file
    end
  end
  local told = report.of(found)
  local best = told.best and told.best.place
  if best then
    told.growth = growth(host, path, ask, found.points[best], among.values, log, found.inputs[best].inputs)
  end
  host.out(given.format == "json" and report.json(told) or report.text(told))
  return told.status
end

return design
