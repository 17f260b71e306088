-- sweep.lua -- polhode sweep: many members of one scene at once.
--
-- The study becomes a program of its own (emit/packages/sweep.lua) that is compiled and run; --emit writes the program
-- instead, for a cluster.  Progress, messages and the exit status of the program pass through.
-- SPDX-License-Identifier: GPL-3.0-or-later

local driven = require "generator.commands.driven"
local ends = require "generator.commands.ends"
local gen = require "generator.commands.gen"
local keep = require "generator.commands.sweep.keep"
local methods = require "generator.methods.methods"
local cuts = require "generator.commands.sweep.cuts"
local diag = require "generator.diag"
local options = require "generator.commands.options"
local outputs = require "generator.commands.outputs"
local packages = require "generator.emit.packages.packages"
local planner = require "generator.commands.planner"
local program = require "generator.commands.sweep.program"
local study = require "generator.commands.sweep.study"
local driver = require "generator.driver"

local sweep = {}

sweep.forms = { { "SCENE", "many members at once: grids, samples, maps",
  "One row a member: its number, what was varied, what is kept, its status. Parameters are in the unit that the " ..
    "scene gives them, states in SI units; a member is the same to the bit for any number of threads and ranks " ..
    "(docs/sweep.md)." } }
sweep.operands = { 1, 1, "SCENE" }
sweep.options = {
  { "--over", "text", "a grid of parameters, initial states, turns (turn_x, turn_y, turn_z: a rotation vector in " ..
    "rad about body axes; tilt_x .. about the axes of space); :log for equal ratios; the last name is the fastest",
    value = "NAME=LOW:HIGH:COUNT,...", default = "no grid" },
  { "--sample", "number", "members that are drawn (at each point of the grid)", value = "N",
    default = "nothing is drawn" },
  { "--vary", "text", "what is drawn: uniform(LOW,HIGH), loguniform(LOW,HIGH), normal(MEAN,DEVIATION); " ..
    "attitude=any() draws from all attitudes", value = "NAME=DISTRIBUTION,...", default = "nothing" },
  { "--covariance", "text", "correlated normal values: a first line name,mean,NAME1,NAME2.. and a row for each name",
    value = "FILE.csv", default = "none" },
  { "--points", { "random", "sobol", "lhs" }, "how points are drawn", value = "HOW", default = "random", each = {
    random = "independent of each other", sobol = "evenly spread (Sobol', shifted by the seed); 2^k members are best",
    lhs = "each range divided into N strata, one member in each (Latin hypercube)" } },
  { "--seed", "number", "of all that is drawn", value = "N", default = "1" },
  { "--keep", "texts", "what is kept, as KIND or KIND: [NAME =] EXPRESSION of t, states and parameters: " ..
    table.concat(keep.kinds, ", ") .. "; may be given again", value = "WHAT", default = "final" },
  { "--stats", false, "mean, covariance, quantiles and histograms of the columns instead of rows" },
  { "--until", "number", "the end of the motion, in s", value = "T", default = "the scene's time.horizon" },
  { "--method", "text", "the stepper of polhode list methods", value = "M", default = "rk4" },
  { "--order", "number", "of the Taylor series, 4 to 30", value = "N", default = "20, in float 10" },
  { "--step", "number", "the length of its step, in s", value = "H", default = "the scene's time.step" },
  { "--accuracy", "number", "error at the end, in parts of a state's size: the step is looked for, and every member " ..
    "is checked by a second run at twice the step", value = "E", default = "no check" },
  { "--real", { "double", "float" }, "the type of all numbers", default = "double" },
  { "--libm", { "own", "system" }, "sin, exp and the like: emitted with the code (the same bits on every machine), " ..
    "or the C library's", default = "own in float, system in double" },
  { "--set", "pair", "another value for a parameter of the scene, in the unit that the scene gives it" },
  { "--threads", "number", "how many compute", value = "N", default = "one for each processor" },
  { "--block", "number", "members that are computed and logged at a time", value = "N", default = "1024" },
  { "--resume", false, "go on with what an earlier run to the same file left" },
  { "--emit", "text", "write the program that computes the sweep, and do not run it: C with threads, MPI and HDF5 " ..
    "where they are", value = "DIR", default = "it is run" },
  { "-o", "text", "the result: FILE.csv, or FILE.h5 (with the library HDF5)", value = "FILE",
    default = "CSV on standard output, which is also -" },
}
sweep.examples = {
  { "polhode sweep tennis_racket --over wz=0.01:1:20:log,wx=6:10:20 --keep 'first: flip = qw' -o flips.csv",
    "a map of the first half turn over two initial rates" },
  { "polhode sweep brick --sample 1000 --vary 'wy=normal(6,0.1),turn_x=normal(0,0.02)' --stats -o brick.csv",
    "mean, covariance and quantiles of the final state of a thousand bricks" },
}

-- The part of the command line that decides what is computed: what the files are made from.
local function command(given)
  local parts = { "polhode sweep", string.match(given[1], "[^/]*$") }
  for _, row in ipairs(sweep.options) do
    local name = string.gsub(row[1], "^%-+", "")
    local value = given[name]
    if value and not ({ threads = 1, block = 1, resume = 1, emit = 1, o = 1 })[name] then
      for _, x in ipairs(type(value) == "table" and row[2] == "texts" and value or { value }) do
        local text = x == true and "" or type(x) == "number" and string.format(" %.17g", x) or
          type(x) == "string" and " " .. x or ""
        if type(x) == "table" then -- of --set
          local names = {}
          for k in pairs(x) do names[#names + 1] = k end
          table.sort(names)
          for _, k in ipairs(names) do parts[#parts + 1] = row[1] .. " " .. k .. "=" .. x[k] end
        else
          if string.find(text, "[ *()^\"]", 2) then text = " '" .. string.sub(text, 2) .. "'" end
          parts[#parts + 1] = row[1] .. text
        end
      end
    end
  end
  return table.concat(parts, " ")
end

local function steppers()
  local names = {}
  for i, m in ipairs(methods) do names[i] = m.name end
  return names
end

-- What a run of the scene has and its members have not.
local function warn(host, job)
  local names = driven.names(job.model)
  if names then host.err("warning: the members' inputs are 0: " .. names .. "\n") end
  for _, e in ipairs(job.record.events) do
    if e.stop then
      host.err("warning: event " .. e.name .. " (line " .. e.line .. ") does not end the motion of a member\n")
    end
  end
end

local function say_all(host, wrong)
  for _, why in ipairs(wrong) do host.err("polhode sweep: " .. why .. "\n") end
  host.err("(polhode help sweep)\n")
  return 2
end

-- What the command line says that no scene has to be known for.
local function plain_mistakes(given, wrong)
  local function say(s) wrong[#wrong + 1] = s end
  local file = given.o or "-"
  if file ~= "-" and not string.find(file, "[^/]%.csv$") and not string.find(file, "[^/]%.h5$") then
    say("-o must end in .csv or .h5, or be -, got " .. given.o)
  end
  for _, name in ipairs { "threads", "block" } do
    local n = given[name]
    if n and (n % 1 ~= 0 or n < 1 or n > 1 << 30) then
      say("--" .. name .. " must be a whole number from 1 on, got " .. diag.show(n))
    end
    if n and given.emit then say("--" .. name .. ": the program takes it when it runs, and --emit only writes it") end
  end
  if given.resume and (not given.o or given.o == "-") then
    say "--resume: it needs the -o FILE of the run that was stopped"
  end
  if given.emit and (given.o or given.resume) then
    say((given.o and "-o" or "--resume") .. ": the program takes it when it runs, and --emit only writes it")
  end
  if given.method then
    wrong[#wrong + 1] = options.unknown("--method", { given.method }, steppers())
  end
  local _, order = gen.order(given)
  wrong[#wrong + 1] = order or gen.orderless(given, { given.method })
end

-- The step that holds the accuracy for the scene's own member, or nil and the exit status.
local function planned(host, job, given, order)
  local q = planner.question(job, { [1] = given[1], accuracy = given.accuracy, real = given.real, set = given.set,
    method = { given.method or "rk4" } }, order)
  ends.warn(host, job, given["until"])
  local decision, why = planner.decide(host, q, given.accuracy)
  if not decision then
    return nil, why and options.failed(host, "sweep", why) or options.refuse(host, job.diag)
  end
  return tonumber(decision.value_text)
end

local function written(host, job, given, files)
  files[#files + 1] = { name = "LICENSE", text = host.templates["templates/LICENSE"], once = true }
  local ok, why, status = outputs.write(host, given.emit, job.source, files)
  return ok and 0 or options.failed(host, "sweep", why, status)
end

function sweep.run(host, given)
  local wrong = {}
  plain_mistakes(given, wrong)
  given.follows = true
  local job, d, why = driver.read(host, given[1], given)
  if not job then
    for _, line in ipairs(wrong) do host.err("polhode sweep: " .. line .. "\n") end
    return options.refuse(host, d, why)
  end
  local s = study.read(host, job, given, wrong)
  if #wrong > 0 then return say_all(host, wrong) end
  options.warn(host, job.diag)
  warn(host, job)
  s.cuts, why = cuts.find(job, s.values)
  if why then host.err("warning: " .. why .. "\n") end
  local order = gen.order(given)
  local step = given.step or job.model:double(job.model.step)
  if given.accuracy then
    local status
    step, status = planned(host, job, given, order)
    if not step then return status end
  end
  s, why = study.steps(s, step)
  if not s then return options.wrong(host, "sweep", why) end
  local method = methods.by_name[given.method or "rk4"]
  s.step, s.order = "step", method.order or order or method.own_order[given.real or "double"]
  local plan
  plan, d = driver.plan(job, { real = given.real, methods = { method.name }, order = order, command = command(given),
    libm = given.libm, batch = true, layout = "split", analysis = false, sweep = s,
    package = packages.by_name "sweep" })
  if not plan then return options.refuse(host, d) end
  if not plan.package.check(plan) then return options.refuse(host, plan.diag) end
  local traced
  traced, why = driver.trace(job)
  if not traced then return options.failed(host, "sweep", why) end
  local unit = driver.files(plan, traced)
  if not unit then return options.refuse(host, plan.diag) end
  local files = unit.files
  if given.emit then return written(host, job, given, files) end
  local path
  path, why = program.compile(host, job.model.name, files)
  if not path then return options.failed(host, "sweep", why) end
  return program.run(host, path, given)
end

return sweep
