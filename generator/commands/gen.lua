-- gen.lua -- polhode gen: writes the emitted files of a scene.
-- Without -o the directory is the scene's name.  --show PASS prints the functions' IR after a pass instead.
-- SPDX-License-Identifier: GPL-3.0-or-later

local options = require "generator.commands.options"
local driver = require "generator.driver"

local gen = {}

gen.options = { ["-o"] = "text", ["--real"] = { "double", "float" }, ["--bake"] = false, ["--method"] = "words",
  ["--set"] = "pair", ["--show"] = { "lower", "power", "fold", "cse", "dce", "order" } }
gen.operands = { 1, 1 }

-- The command line as it goes into the banner: base name of the scene, options that change the output, in one order.
function gen.command(given)
  local parts = { "polhode gen", string.match(given[1], "[^/]*$") }
  if given.real == "float" then parts[#parts + 1] = "--real float" end
  if given.bake then parts[#parts + 1] = "--bake" end
  if given.method then parts[#parts + 1] = "--method " .. table.concat(given.method, ",") end
  local names = {}
  for k in pairs(given.set or {}) do names[#names + 1] = k end
  table.sort(names)
  for _, k in ipairs(names) do parts[#parts + 1] = "--set " .. k .. "=" .. given.set[k] end
  return table.concat(parts, " ")
end

-- {rk4 = true, exact = true} from --method; nil and a message for one that cannot be emitted.  NAME_linearised, like
-- the rest of the analysis, is always emitted: the name is allowed and changes nothing.
local function methods(given)
  if not given.method then return nil end
  local set = {}
  for _, name in ipairs(given.method) do
    if name ~= "rk4" and name ~= "exact" and name ~= "linearised" then
      return nil, "--method: gen emits rk4, exact and linearised, got " .. name
    end
    set[name] = true
  end
  return set
end

function gen.run(host, given)
  local chosen, wrong = methods(given)
  if wrong then
    host.err("polhode gen: " .. wrong .. "\n")
    return 2
  end
  local job, d, why = driver.read(host, given[1], given)
  if not job then return options.refuse(host, given[1], d, why) end
  if chosen and chosen.exact and not job.closed.kind then
    d = job.diag
    d:error(job.record.line, "method exact", "this scene has no closed form: " .. job.closed.refused)
    return options.refuse(host, given[1], d)
  end
  options.warn(host, job.diag)
  driver.plan(job, { real = given.real, command = gen.command(given), methods = chosen })
  if given.show then
    host.out(driver.show(host, job, given.show))
    return 0
  end
  local files = driver.files(host, job)
  if not files then return options.refuse(host, given[1], job.diag) end
  local dir = given.o or job.model.name
  local ok, written = host.write_files(dir, files)
  if not ok then
    host.err("polhode gen: " .. written .. "\n")
    return 2
  end
  return 0
end

return gen
