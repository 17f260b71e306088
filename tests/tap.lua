-- tap.lua - TAP 13 for the tests that are written in Lua.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local tap = require "tests.tap"          -- package.path has "./?.lua": tests run from the project's root
--     tap.is(got, want, "a sentence of fact")
--     tap.done()                               -- prints the plan; exit status 1 when anything failed
--
-- Each check prints one line and returns whether it passed, so that a test can skip what depends on it.
-- Comparisons of numbers are made by near() only, which wants its two tolerances and a reason for them.
-- Nothing global is set or changed.

local tap = {}

local count, failed, planned = 0, 0, nil

-- Every digit of a double; other values as tostring gives them, strings quoted.
local function text(value)
  if math.type(value) == "float" then
    return string.format("%.17g", value)
  elseif type(value) == "string" then
    return (string.gsub(string.format("%q", value), "\\\n", "\\n"))
  end
  return tostring(value)
end

function tap.diag(message)
  io.stdout:write("# ", (string.gsub(tostring(message), "\n", "\n# ")), "\n")
end

-- "tests/x.t:12": the innermost running line outside this file.
local function caller()
  local here, level = debug.getinfo(1, "S").source, 2
  while true do
    local info = debug.getinfo(level, "Sl")
    if info == nil then
      return "an unknown line"
    elseif info.source ~= here and info.currentline > 0 then
      return info.short_src .. ":" .. info.currentline
    end
    level = level + 1
  end
end

local function result(passed, name, ...)
  if count == 0 and planned == nil then
    io.stdout:write("TAP version 13\n")
  end
  count = count + 1
  name = string.gsub(name or "unnamed", "[\n#]", " ")
  io.stdout:write(passed and "ok " or "not ok ", count, " - ", name, "\n")
  if not passed then
    failed = failed + 1
    tap.diag("at " .. caller())
    for _, line in ipairs { ... } do
      tap.diag("  " .. line)
    end
  end
  return passed
end

-- State the number of checks beforehand; without it done() prints the plan at the end.
function tap.plan(n)
  planned = n
  io.stdout:write("TAP version 13\n1..", n, "\n")
end

function tap.done()
  if planned == nil then
    io.stdout:write("1..", count, "\n")
  elseif planned ~= count then
    tap.diag(string.format("planned %d checks, ran %d", planned, count))
    failed = failed + 1
  end
  io.stdout:flush()
  os.exit(failed == 0 and 0 or 1, true)
end

-- A check that this machine cannot make: counts as passed, says why.
function tap.skip(name, why)
  count = count + 1
  io.stdout:write("ok ", count, " - ", name, " # SKIP ", why, "\n")
end

function tap.ok(condition, name, why)
  return result(not not condition, name, why)
end

function tap.is(got, want, name)
  return result(got == want and math.type(got) == math.type(want), name,
    "got  " .. text(got), "want " .. text(want))
end

-- |got - want| <= abs + rel |want|. `why` argues the tolerances and is shown on failure; NaN never passes.
function tap.near(got, want, rel, abs, name, why)
  if math.type(rel) == nil or math.type(abs) == nil then
    error("near: tolerances must be given", 2)
  elseif type(why) ~= "string" then
    error("near: the tolerances need a reason", 2)
  end
  local fine = type(got) == "number" and type(want) == "number"
  local passed = fine and (got == want or math.abs(got - want) <= abs + rel * math.abs(want))
  return result(passed, name, "got  " .. text(got), "want " .. text(want),
    fine and "off by " .. text(got - want) .. ", allowed " .. text(abs + rel * math.abs(want)) or "not numbers",
    "tolerance: " .. why)
end

-- `part` occurs in `got` (plain text), or matches as a Lua pattern when `pattern` is true.
function tap.like(got, part, name, pattern)
  return result(type(got) == "string" and string.find(got, part, 1, not pattern) ~= nil, name,
    "got  " .. text(got), "want " .. (pattern and "a match of " or "that contains ") .. text(part))
end

-- fn() raises an error; with `part`, one whose text contains it.
function tap.throws(fn, part, name)
  local fine, message = pcall(fn)
  local passed = not fine and (part == nil or string.find(tostring(message), part, 1, true) ~= nil)
  return result(passed, name, fine and "no error" or "got  " .. text(message), "want " .. text(part))
end

return tap
