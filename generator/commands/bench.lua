-- bench.lua -- polhode bench: what each method of a scene costs and how exact it is, on this machine.
--
-- The tables go to standard output, NAME.csv (every row) and NAME.svg (the diagram) into the directory of -o.
-- SPDX-License-Identifier: GPL-3.0-or-later

local driven = require "generator.commands.driven"
local options = require "generator.commands.options"
local progress = require "generator.commands.progress"
local driver = require "generator.driver"
local ends = require "generator.commands.ends"
local methods = require "generator.methods.methods"
local study = require "generator.commands.study"
local report = require "generator.report.bench"

local bench = {}

bench.forms = { { "SCENE", "time and error of each method, measured here",
  "The fronts (nothing else is both faster and more accurate) go to standard output, every row and a diagram into " ..
  "a folder." } }
bench.operands = { 1, 1, "SCENE" }
bench.options = {
  { "--method", "words", "the methods that are measured, commas between", value = "M,...",
    default = "all that the scene admits" },
  { "--accuracy", "number", "the error for which the fastest is named, between 0 and 1", value = "E",
    default = "1e-3, 1e-6, 1e-9 and 1e-11" },
  { "--until", "number", "length of the motion in s", value = "T", default = "the scene's time.horizon" },
  { "--no-closed", false, "without the closed form" },
  { "--no-peers", false, "without the integrators of others (GSL, and SUNDIALS where it is built in)" },
  { "--all", false, "print every row, not the fronts alone" },
  { "--set", "pair", "another value for a parameter of the scene, in the unit that the scene gives it" },
  { "--format", { "text", "csv", "markdown" }, "how the table is written", default = "text" },
  { "-o", "text", "the folder of NAME.csv and NAME.svg", value = "DIR", default = "NAME-bench" },
}
bench.examples = { { "polhode bench brick --method taylor,rk4 --no-peers --accuracy 1e-9",
  "which of two methods reaches 1e-9 sooner (a minute)" } }

-- What is wrong with the options, or nil.
local function wrong(given)
  local names = { "exact" }
  for _, m in ipairs(methods) do names[#names + 1] = m.name end
  local unknown = options.unknown("--method", given.method, names)
  if unknown then return unknown end
  if given.o == "-" then return "-o must be the name of a folder, as bench writes two files, got -" end
  local a, T = given.accuracy, given["until"]
  if a and not (a > 0 and a < 1) then return "--accuracy must be between 0 and 1" end
  if T and not (T > 0 and T < math.huge) then return "--until must be positive" end
end

function bench.run(host, given)
  local bad = wrong(given)
  if bad then return options.wrong(host, "bench", bad) end
  given.follows = true
  local job, d, why = driver.read(host, given[1], given)
  if not job then return options.refuse(host, d, why) end
  options.warn(host, job.diag)
  local over = ends.refused(host, job, "bench", given["until"])
  if over then return over end
  local inputs = driven.names(job.model)
  if inputs then host.err("warning: the inputs are 0: " .. inputs .. "\n") end
  local bar = progress.of(host, "bench")
  local s, failure, numbers = study.of(host, job, given, bar.show)
  bar.clear()
  if not s then return options.failed(host, "bench", failure, numbers and 3) end
  report.mark(s)
  local csv = report.csv(s)
  local files = { { name = s.name .. ".csv", text = csv } }
  local picture = report.picture(s)
  if picture then files[2] = { name = s.name .. ".svg", text = picture } end
  local ok, written = host.write_files(given.o or s.name .. "-bench", files)
  if not ok then return options.failed(host, "bench", written) end
  host.out(given.format == "csv" and csv or report.text(s, given))
  local noise = report.noise(s)
  if noise then host.err("warning: " .. noise .. "\n") end
  return 0
end

return bench
