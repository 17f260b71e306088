-- run.lua -- polhode run: the motion as a table, by the general library or by the emitted code.
--
-- Events of the scene are a table of their own, --events FILE, and the member `events` in JSON; an event with
-- stop = true ends the rows with its own.
-- Columns t,qw,qx,qy,qz,wx,wy,wz,energy,Lx,Ly,Lz,rx,ry,rz,vx,vy,vz and further states, those that the scene has, or
-- what --columns asks for; every number reads back to the same double.  Nothing is printed unless all numbers are
-- finite: if one is not, the status is 3.  A motion that is off by more than --warn is printed, with a warning.
-- SPDX-License-Identifier: GPL-3.0-or-later

local accuracy = require "generator.commands.run.accuracy"
local bounce = require "generator.commands.run.bounce"
local columns = require "generator.commands.run.columns"
local engines = require "generator.commands.run.engines"
local limits = require "generator.commands.run.limits"
local tables = require "generator.commands.run.table"
local events = require "generator.commands.events"
local driven = require "generator.commands.driven"
local options = require "generator.commands.options"
local progress = require "generator.commands.progress"
local quantities = require "generator.attitude.quantities"
local driver = require "generator.driver"
local happenings = require "generator.dynamics.happenings"

local run = {}

-- The words of --columns, with what they are.
local function listed()
  local words = {}
  for _, q in ipairs(quantities.list) do
    if not string.find(q[1], "^euler_") and not q.plain then words[#words + 1] = q[1] .. " (" .. q.about .. ")" end
  end
  return table.concat(words, ", ") .. "; euler_zyx and so on for the other sequences; angles are in " ..
    "rad; where effect.rotating_frame turns the frame, q, L and all quantities but omega_inertial are in its axes"
end

run.forms = { { "SCENE", "the motion as a table",
  "Columns: t in s, the state, energy in J, angular momentum L in N m s. What happens on the way (the scene's " ..
    "events, contact lost, rest, impacts) is a table of its own." } }
run.operands = { 1, 1, "SCENE" }
run.options = {
  { "--engine", { "general", "generated" }, "the general library, or the emitted code, compiled by $CC (cc, gcc or " ..
    "clang without it)", default = "general" },
  { "--method", "text", "general: adaptive, taylor, rk4, gsl-rk4, rkf45, rk8pd, implicit, exact, linearised; " ..
    "generated: those of polhode list methods", value = "M",
    default = "general: adaptive; generated: exact if there is one, else rk4" },
  { "--step", "number", "a fixed step in s", value = "H", default = "the scene's time.step, for fixed steps" },
  { "--tolerance", "number", "error allowed in a step, relative to the state, of methods that choose their step",
    value = "E", default = "general: near rounding; generated: 1e-12, in float 1e-6" },
  { "--warn", "number", "the estimated error above which there is a warning", value = "E", default = "1e-3" },
  { "--order", "number", "of the emitted Taylor series, 4 to 30", value = "N", default = "20, in float 10" },
  { "--until", "number", "time of the last row, in s", value = "T", default = "the scene's time.horizon" },
  { "--every", "number", "time between rows, in s", value = "DT", default = "a hundredth of the whole" },
  { "--at", "numbers", "the times of the rows in s instead, in any order", value = "T1,T2,...",
    default = "--until and --every" },
  { "--real", { "double", "float" }, "the type of the emitted code's numbers", default = "double" },
  { "--set", "pair", "another value for a parameter of the scene, in the unit that the scene gives it" },
  { "--input", "text", "the inputs of the scene over time; the first line names t and inputs, each with [unit] or " ..
    "in SI units", value = "FILE.csv", default = "all 0" },
  { "--between", { "held", "linear" }, "the inputs between two rows of the file: those of the row before, or on " ..
    "straight lines", default = "held" },
  { "--columns", "text", "the columns: t, states, energy, Lx .., groups of them (q, w, r, v, L, states), " ..
    listed() .. "; expressions of them and of parameters, [NAME =] EXPRESSION",
    value = "COLUMN,...", default = "t, q, w, energy, L, further states" },
  { "--events", "text", "what happened, as CSV with the same columns behind the event's name", value = "FILE.csv",
    default = "name and time on standard error" },
  { "--format", { "csv", "json" }, "how the table is written", default = "csv" },
  { "-o", "text", "the file that is written", value = "FILE", default = "standard output, which is also -" },
}
run.examples = {
  { "polhode run brick --until 2 --every 0.5", "five rows by the general library" },
  { "polhode run heavy_top --until 1 --columns 't,euler,tilt,omega_inertial,rim = 0.03*wz'",
    "Euler angles, tilt, w in inertial axes, and an expression" },
  { "polhode run heavy_top --engine generated --method taylor --tolerance 1e-12 --at 1,2 -o top.csv",
    "two rows by the emitted code" },
}

-- What the end of a file's name promises and run does not write.
local promised = { json = "json" }
for word in string.gmatch("xlsx xls ods tsv mat npy npz h5 hdf5 parquet svg png pdf html md tex", "%w+") do
  promised[word] = "other"
end

-- Why a table is not written into a file of this name, or nil.
local function misnamed(given)
  local ending = given.o and string.lower(string.match(given.o, "%.(%w+)$") or "")
  local kind, format = promised[ending], given.format or "csv"
  if not kind or kind == format then return nil end
  if kind == "json" then return "-o " .. given.o .. ": its name says JSON, and it would have CSV (--format json)" end
  return "-o " .. given.o .. ": run writes CSV or JSON, not " .. ending .. "; name it .csv" ..
    (string.find(ending, "^xls") and ", which spreadsheets open" or "") ..
    (string.find(ending, "^[sp]%wg$") and " (pictures: polhode plot)" or "")
end

-- The output times, or nil and what is wrong.
local function times(job, given)
  if given.at then
    if given["until"] or given.every then return nil, "--at and --until/--every exclude each other" end
    return given.at
  end
  local finish = given["until"] or job.model:double(job.model.horizon)
  local every = given.every or finish / 100
  if finish <= 0 then return nil, "--until must be positive" end
  if every <= 0 then return nil, "--every must be positive" end
  if finish / every > limits.rows then return nil, "more than " .. limits.rows .. " rows: --every is too small" end
  local list = {}
  for i = 0, math.floor(finish / every * (1 + 1e-12)) do list[#list + 1] = i * every end
  if list[#list] < finish * (1 - 1e-12) then list[#list + 1] = finish end
  return list
end

-- A --step that is longer than all intervals between rows, at which steps end: a warning, or nil.
local function idle(motion, given, list)
  local before, longest = 0.0, 0.0
  for _, t in ipairs(list) do longest, before = math.max(longest, math.abs(t - before)), t end
  if not (motion.step and given.step and longest > 0 and longest < given.step * (1 - 1e-9)) then return nil end
  return string.format("--step %.4g has no effect: a step ends at every row, and no two are more than %.4g s apart\n",
    given.step, longest)
end

-- The events of the scene up to the last of the times, or nil and the failure.
local function happened(host, job, given, motion, solve, list)
  local finish = 0
  for _, t in ipairs(list) do finish = math.max(finish, t) end
  if #events.of(job) == 0 or finish <= 0 then return {} end
  return events.find(host, job, motion, solve, finish, given.step or job.model:double(job.model.step), given.course)
end

local shown = 20 -- events that are named on standard error; a ball may bounce for ever

-- Writes what happened where it was asked for; the exit status.
local function report(host, given, found)
  if given.events then return options.write(host, "run", given.events, tables.events(found, given.chosen.names)) end
  for i, f in ipairs(given.format ~= "json" and found or {}) do
    if i > shown then
      host.err(string.format("and %d events more: --events FILE.csv has them all\n", #found - shown))
      break
    end
    host.err(string.format("event %s at t = %.9g s\n", f.event.name, f.row.t))
  end
  return 0
end

local function before(list, stop)
  local kept = {}
  for _, t in ipairs(list) do
    if t < stop then kept[#kept + 1] = t end
  end
  kept[#kept + 1] = stop
  return kept
end

-- The events with impacts, landings and lift-offs among them, in the order of time, up to one that stops.
local function with_phases(motion, found, list, solve)
  local finish, stop = 0, found[#found]
  for _, t in ipairs(list) do finish = math.max(finish, t) end
  if stop and stop.event.stop then finish = stop.row.t end
  local at, happened_at = {}, motion.phases(finish)
  for i, p in ipairs(happened_at) do at[i] = p.t end
  local rows, out = solve(at), { table.unpack(found) }
  for i, p in ipairs(happened_at) do out[#out + 1] = { event = { name = p.name }, row = rows[i], place = i } end
  table.sort(out, function(a, b)
    if a.row.t ~= b.row.t then return a.row.t < b.row.t end
    return (a.place or 0) < (b.place or 0)
  end)
  return out
end

-- The motion's rows at the times of the list, and the events; or nil and the failure.  Warnings are appended.
local function computed(host, job, given, motion, list, warnings)
  local solve = tables.solver(motion, given.chosen.row)
  local found, wrong = happened(host, job, given, motion, solve, list)
  if not found then return nil, wrong end
  local last = found[#found]
  last = last and last.event.stop and last or nil
  if motion.phases then found = with_phases(motion, found, list, solve) end
  if last then list = before(list, last.row.t) end
  local rows, states = solve(list)
  if rows and last then rows[#rows] = last.row end
  if last and last.event.said then
    warnings[#warnings + 1] = happenings.at(last.event.said, string.format("%.9g", last.row.t)) ..
      "; the run ends there\n"
  end
  if not rows then return nil, states end
  warnings[#warnings + 1] = idle(motion, given, list)
  warnings[#warnings + 1] = accuracy.warning(job, motion, list, states, function()
    return engines.general(host, job, { method = "exact" })
  end, given.warn)
  return rows, found
end

-- Prints why there is no motion (of another command that has one: its name); the exit status.
function run.refuse(host, failure, help, command)
  command = command or "run"
  if failure.diag then return options.refuse(host, failure.diag) end
  if failure.command then return options.wrong(host, command, failure.text) end
  return options.failed(host, command, happenings.said(failure) ..
    (help and help ~= "" and "\n  what helps: " .. help or ""), failure.status)
end

function run.run(host, given)
  given.follows = true
  local job, d, why = driver.read(host, given[1], given)
  if not job then return options.refuse(host, d, why) end
  job, d, why = bounce.scene(job, given)
  if not job then return options.refuse(host, d, why) end
  local list, wrong = times(job, given)
  if given.events and (given.format == "json" or not job.record.landing and #events.of(job) == 0) then
    wrong = wrong or "--events: " .. (given.format == "json" and "JSON has the events among its members" or
      "nothing happens on the way: the scene has no events = { .. } and no plane")
  end
  if not events.check(job) then return options.refuse(host, job.diag) end
  wrong = wrong or misnamed(given)
  wrong = wrong or given.warn and given.warn <= 0 and "--warn must be positive" or nil
  local warnings, course
  if not wrong then given.chosen, wrong = columns.of(host, job, given.columns, given) end
  if not wrong then
    warnings, course = driven.one(host, job, given)
    wrong = not warnings and course
    given.course = warnings and course
  end
  if not warnings then return options.wrong(host, "run", wrong) end
  local last = 0.0
  for _, t in ipairs(list) do last = math.max(last, t) end
  local bar
  given.seen, bar = progress.along(host, last, function(t)
    return string.format("t = %.4g s of %.4g s", t, last)
  end)
  local motion, failure = bounce.motion(host, job, given, course)
  wrong = motion and limits.exceeded(motion, list, given) or failure and failure.command and failure.text
  if wrong then return options.wrong(host, "run", wrong) end
  options.warn(host, job.diag)
  if not motion then return run.refuse(host, failure) end
  local solve = motion.solve
  function motion.solve(at, o)
    if given.seen and #at > 0 then given.seen(at[1]) end
    return solve(at, o)
  end
  local rows, found = computed(host, job, given, motion, list, warnings)
  bar()
  if not rows then
    return run.refuse(host, found, found.status == 3 and accuracy.help(job, motion, list, found.t))
  end
  local happens = motion.phases or #events.of(job) > 0
  local status = options.write(host, "run", given.o, tables.writers[given.format or "csv"](rows, given.chosen.names,
    happens and found or nil))
  if status == 0 and happens then status = report(host, given, found) end
  for _, w in ipairs(status == 0 and warnings or {}) do host.err("warning: " .. w) end
  if status == 0 and motion.stiff then
    host.err("note: something decays much faster than the motion changes: --method " .. motion.method ..
      " went on by implicit there\n")
  end
  return status
end

return run
