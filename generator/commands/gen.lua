-- gen.lua -- polhode gen: writes the emitted files of a scene.
-- Without -o the directory is the scene's name.  --show PASS prints the functions' IR after a pass instead.  With an
-- accuracy (of the scene, or --accuracy) commands/planner.lua decides on the method, from those of --method.
-- SPDX-License-Identifier: GPL-3.0-or-later

local options = require "generator.commands.options"
local measure = require "generator.commands.measure"
local packages = require "generator.emit.packages.list"
local planner = require "generator.commands.planner"
local driver = require "generator.driver"
local methods = require "generator.methods.list"
local proof = require "generator.emit.proof"
local shortest = require("generator.plan.decision").shortest

local gen = {}

gen.options = { ["-o"] = "text", ["--real"] = { "double", "float" }, ["--bake"] = false, ["--method"] = "words",
  ["--order"] = "number", ["--accuracy"] = "number",
  ["--with"] = { "jacobians", "compensated", "proof", "q31", several = true },
  ["--libm"] = { "own", "system" }, ["--project"] = packages.names, ["--target"] = "words",
  ["--set"] = "pair", ["--show"] = { "lower", "power", "fold", "cse", "dce", "order" } }
gen.operands = { 1, 1 }

-- The command line as it goes into the banner: base name of the scene, options that change the output, in one order.
function gen.command(given)
  local parts = { "polhode gen", string.match(given[1], "[^/]*$") }
  local usual = packages.by_name(given.project or packages.default).real or "double"
  if given.real and given.real ~= usual then parts[#parts + 1] = "--real " .. given.real end
  if given.bake then parts[#parts + 1] = "--bake" end
  if given.libm then parts[#parts + 1] = "--libm " .. given.libm end
  if given.with then
    local list = {}
    for _, word in ipairs(gen.options["--with"]) do list[#list + 1] = given.with[word] and word or nil end
    parts[#parts + 1] = "--with " .. table.concat(list, ",")
  end
  if given.project then parts[#parts + 1] = "--project " .. given.project end
  if given.target then parts[#parts + 1] = "--target " .. table.concat(given.target, ",") end
  if given.accuracy then parts[#parts + 1] = "--accuracy " .. shortest(given.accuracy) end
  if given.order then parts[#parts + 1] = string.format("--order %d", given.order) end
  if given.method then parts[#parts + 1] = "--method " .. table.concat(given.method, ",") end
  local names = {}
  for k in pairs(given.set or {}) do names[#names + 1] = k end
  table.sort(names)
  for _, k in ipairs(names) do parts[#parts + 1] = "--set " .. k .. "=" .. given.set[k] end
  return table.concat(parts, " ")
end

-- The list of --method; nil and a message for one that cannot be emitted.  NAME_linearised, like the rest of the
-- analysis, is always emitted: the name is allowed and changes nothing.
local function chosen_methods(given)
  local names, known = { "exact" }, { exact = true, linearised = true }
  for _, m in ipairs(methods) do
    names[#names + 1] = m.name
    known[m.name] = true
  end
  local seen = {}
  for _, name in ipairs(given.method or {}) do
    if not known[name] then
      return nil, "--method: gen emits " .. table.concat(names, ", ") .. " and linearised, got " .. name
    end
    if seen[name] then return nil, "--method: " .. name .. " stands there twice" end
    seen[name] = true
  end
  return given.method
end

-- The order of --order, or a message.
function gen.order(given)
  local least, most = table.unpack(methods.by_name.taylor.orders)
  local n = given.order
  if n and (n < least or n > most or n % 1 ~= 0) then
    return nil, string.format("--order must be a whole number from %d to %d, got %s", least, most, given.order)
  end
  return n and math.tointeger(n)
end

-- An order that nothing has: a message, else nil.  names: the methods that are there.
function gen.orderless(given, names)
  for _, name in ipairs(names) do
    if name == "taylor" then return nil end
  end
  return given.order and "--order: of the methods taylor alone has one, got " ..
    (#names > 0 and "--method " .. table.concat(names, ",") or "no --method")
end

-- What a kind of project other than the plain one has no place for, or nil.
local function refused_by_project(given)
  local kind, with = given.project or packages.default, given.with or {}
  if kind == "make" then return nil end
  if with.proof then return "--with proof: the proof is a rule of --project make, got --project " .. kind end
  if with.q31 then return "--with q31: its files come with --project make, got --project " .. kind end
  if given.target and (kind == "fmu" or kind == "firmware") then
    return "--target: its README has no sheet of costs (explain --target prints one), got --project " .. kind
  end
  return nil
end

function gen.run(host, given)
  local chosen, wrong = chosen_methods(given)
  local order, bad = gen.order(given)
  local _, unknown = measure.cores(given.target, given.real or "float") -- the type may be the budget's
  wrong = wrong or bad or unknown
  if given.accuracy and not (given.accuracy > 0 and given.accuracy < 1) then
    wrong = "--accuracy must be between 0 and 1, got " .. shortest(given.accuracy)
  end
  wrong = wrong or refused_by_project(given)
  if given.o == "" then wrong = "-o needs the name of a directory" end
  if wrong then
    host.err("polhode gen: " .. wrong .. "\n")
    return 2
  end
  local job, d, why = driver.read(host, given[1], given)
  if not job then return options.refuse(host, given[1], d, why) end
  local exact = false
  for _, name in ipairs(chosen or {}) do exact = exact or name == "exact" end
  if exact and not job.closed.kind then
    d = job.diag
    d:error(job.record.line, "method exact", "this scene has no closed form: " .. job.closed.refused)
    return options.refuse(host, given[1], d)
  end
  options.warn(host, job.diag)
  local package = packages.by_name(given.project or packages.default)
  given.real = given.real or package.real
  local real, decision = given.real, nil
  local question = not given.show and planner.question(job, given, order)
  wrong = gen.orderless(given, chosen or question and { "taylor" } or {})
  if wrong then
    host.err("polhode gen: " .. wrong .. "\n")
    return 2
  end
  if question then
    decision, why = planner.decide(host, question, given)
    if not decision and why then
      host.err("polhode gen: " .. why .. "\n")
      return 2
    elseif not decision then
      return options.refuse(host, given[1], job.diag)
    end
    real, chosen, order = decision.real, { decision.method }, decision.order
  end
  if not driver.plan(job, { real = real, command = gen.command(given), methods = chosen or package.methods,
    order = order, jacobians = given.with and given.with.jacobians or package.jacobians,
    compensated = given.with ~= nil and given.with.compensated, q31 = given.with ~= nil and given.with.q31,
    libm = given.libm, outputs = given.project == "fmu" }) then
    return options.refuse(host, given[1], job.diag)
  end
  job.planned = decision
  job.proof = given.with ~= nil and given.with.proof
  if job.proof and not proof.check(job) then return options.refuse(host, given[1], job.diag) end
  if given.show then
    local shown = driver.show(host, job, given.show)
    if not shown then return options.refuse(host, given[1], job.diag) end
    host.out(shown)
    return 0
  end
  local cores, short = measure.cores(given.target, job.real)
  if short then
    host.err("polhode gen: " .. short .. "\n")
    return 2
  end
  if package.check and not package.check(job) then return options.refuse(host, given[1], job.diag) end
  job.package = package
  local files = driver.files(host, job)
  if not files then return options.refuse(host, given[1], job.diag) end
  if cores then -- the code is made; once more for the README with its numbers
    job.counted, why = measure.run(host, job, cores, files)
    files = job.counted and driver.files(host, job)
    if not files then
      host.err("polhode gen: " .. why .. "\n")
      return 2
    end
  end
  if package.finish then
    files, why = package.finish(host, job, files)
    if not files then
      host.err("polhode gen: " .. why .. "\n")
      return 2
    end
  end
  local dir = given.o or job.model.name
  local ok, written = host.write_files(dir, files)
  if not ok then
    host.err("polhode gen: " .. written .. "\n")
    return 2
  end
  return 0
end

return gen
