-- bench.lua -- polhode bench: what each method of a scene costs and how exact it is, on this machine.
--
-- The tables go to standard output, NAME.csv (every row) and NAME.svg (the diagram) into the directory of -o.
-- SPDX-License-Identifier: GPL-3.0-or-later

local options = require "generator.commands.options"
local driver = require "generator.driver"
local methods = require "generator.methods.list"
local study = require "generator.commands.study"
local report = require "generator.report.bench"

local bench = {}

bench.options = { ["--accuracy"] = "number", ["-o"] = "text", ["--method"] = "words", ["--until"] = "number",
  ["--format"] = { "text", "csv", "markdown" }, ["--set"] = "pair", ["--no-closed"] = false, ["--no-peers"] = false,
  ["--all"] = false }
bench.operands = { 1, 1 }

-- What is wrong with the options, or nil.
local function wrong(given)
  local names, known, seen = { "exact" }, { exact = true }, {}
  for _, m in ipairs(methods) do names[#names + 1], known[m.name] = m.name, true end
  for _, name in ipairs(given.method or {}) do
    if not known[name] then
      return "--method: there are " .. table.concat(names, ", ") .. ", got " .. name
    end
    if seen[name] then return "--method: " .. name .. " stands there twice" end
    seen[name] = true
  end
  local a, T = given.accuracy, given["until"]
  if a and not (a > 0 and a < 1) then return "--accuracy must be between 0 and 1" end
  if T and not (T > 0 and T < math.huge) then return "--until must be positive" end
end

-- A function that shows on a terminal what is done and how far the work is, and one that clears the line.
local function progress(host)
  if not host.isatty("err") then return function() end, function() end end
  local wide, words = 24, 30
  return function(what, part)
    local full = math.floor(wide * part)
    host.err("\r[" .. string.rep("#", full) .. string.rep(".", wide - full) .. "] " ..
      string.sub(what .. string.rep(" ", words), 1, words))
  end, function() host.err("\r" .. string.rep(" ", wide + words + 3) .. "\r") end
end

function bench.run(host, given)
  local bad = wrong(given)
  if bad then
    host.err("polhode bench: " .. bad .. "\n")
    return 2
  end
  local job, d, why = driver.read(host, given[1], given)
  if not job then return options.refuse(host, given[1], d, why) end
  options.warn(host, job.diag)
  local tick, finished = progress(host)
  local s, failure = study.of(host, job, given, tick)
  finished()
  if not s then
    host.err("polhode bench: " .. failure .. "\n")
    return 2
  end
  report.mark(s)
  local csv = report.csv(s)
  local files = { { name = s.name .. ".csv", text = csv } }
  local picture = report.picture(s)
  if picture then files[2] = { name = s.name .. ".svg", text = picture } end
  local ok, written = host.write_files(given.o or s.name .. "-bench", files)
  if not ok then
    host.err("polhode bench: " .. written .. "\n")
    return 2
  end
  host.out(given.format == "csv" and csv or report.text(s, given))
  local noise = report.noise(s)
  if noise then host.err("warning: " .. noise .. "\n") end
  return 0
end

return bench
