-- gen.lua -- polhode gen: writes the emitted files of a scene.
-- Without -o the directory is the scene's name.  --show PASS prints the functions' IR after a pass instead.  With an
-- accuracy (of the scene, or --accuracy) commands/planner.lua decides on the method, from those of --method.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local compiler = later "generator.commands.compiler"
local dependencies = later "generator.commands.dependencies"
local identifiers = require "generator.dsl.names"
local options = require "generator.commands.options"
local measure = require "generator.commands.measure"
local outputs = require "generator.commands.outputs"
local packages = require "generator.emit.packages.packages"
local ends = later "generator.commands.ends"
local planner = require "generator.commands.planner"
local driver = require "generator.driver"
local listed = later "generator.commands.listed"
local nearest = require "generator.nearest"
local methods = require "generator.methods.methods"
local estimator = require "generator.emit.estimator"
local proof = require "generator.emit.proof"
local decided = later "generator.plan.decision"

local gen = {}

gen.forms = { { "SCENE", "write the C of a scene into a folder",
  "NAME, below, is the name that the scene gives itself." } }
gen.operands = { 1, 1, "SCENE" }
gen.options = {
  { "-o", "text", "the folder that is written; it is made if it is not there", value = "DIR", default = "NAME" },
  { "--name", "text", "the name in place of the scene's own: prefix of functions, files and macros, so that float " ..
    "and double of a scene fit into one program", value = "NAME", default = "the scene's" },
  { "--real", { "double", "float" }, "the type of the code's numbers",
    default = "double; float for the projects arduino and firmware, and where a budget asks for it" },
  { "--bake", false, "parameters become constants of the code" },
  { "--method", "words", "what is emitted: exact (the closed form) and steppers, of which the first becomes " ..
    "NAME_step; polhode list methods explains them. With an accuracy: which ones may be chosen from",
    value = "M,...", default = "exact where the scene has a closed form, and rk4" },
  { "--order", "number", "order of the Taylor series, 4 to 30", value = "N", default = "20, in float 10" },
  { "--accuracy", "number", "the largest error of the state over the scene's horizon, relative to its size, between " ..
    "0 and 1: the cheapest method, order and step that hold it are looked for (docs/planner.md)", value = "E",
    default = "the scene's accuracy, if it has one" },
  { "--with", { "analysis", "orbit", "attitude", "batch", "jacobians", "compensated", "proof", "q31", "estimator",
    several = true },
    "what is added, commas between", value = "WHAT,...", default = "nothing", each = {
      analysis = "principal axes, stability, small oscillations, the tensor about a point, torques, the Jacobian, " ..
        "accelerations in a turning frame",
      orbit = "of the closed form also rates or attitude alone, many times in one call, time in ticks, periods",
      attitude = "the attitude as rotation matrix, rotation vector and Euler angles of the twelve sequences; " ..
        "vectors from body to inertial axes and back",
      batch = "NAME_batch: set-up, steps and rates of many bodies at once, in vector instructions (docs/sweep.md)",
      jacobians = "derivatives of steppers and closed form by state and parameters",
      compensated = "steppers that carry what rounding takes away",
      proof = "a rule `make proof` for Frama-C",
      q31 = "the step in whole numbers of 32 bits; the scene needs ranges",
      estimator = "NAME_estimator: the tensor of inertia from a gyro, by recursive least squares in fixed memory " ..
        "(docs/fit.md)" } },
  { "--only", "words", "these functions and what they need, and no others: step,energy; --list names all",
    value = "FUNCTION,...", default = "the motion: set-up, steppers, closed form, energy, momentum" },
  { "--layout", { "split", "single", "header" }, "how the code is cut into files", value = "HOW",
    default = "split; single for the projects fmu and firmware", each = {
      split = "NAME the motion, NAME_orbit the closed form, NAME_analysis the rest, each where it has something",
      single = "NAME.h and NAME.c",
      header = "NAME.h alone: one file of the program defines NAME_IMPLEMENTATION before it includes it" } },
  { "--list", false, "name the functions that the scene can have, with the file, lines and operations of each, and " ..
    "write nothing" },
  { "--libm", { "own", "system" }, "sin, exp and the like: emitted with the code (the same bits on every machine), " ..
    "or the C library's", default = "own in float, system in double" },
  { "--project", packages.names, "what the code is packed as (docs/projects.md)", value = "KIND", default = "make",
    each = packages.about },
  { "--deps", "text", "write a rule for make as well: the generated files depend on the scene and on the files that " ..
    "it reads, such as meshes", value = "FILE.d", default = "no rule is written" },
  { "--target", "words", "count instructions, flash and stack on small processors under emulators, for the README " ..
    "of the project: all, or some of " .. table.concat(measure.names, ", "), value = "CORE,...",
    default = "nothing is counted" },
  { "--phase", { "contact", "flight" }, "of a body that flies and lands (effect.plane with impact): the scene on " ..
    "the plane, or in the air", default = "contact" },
  { "--set", "pair", "another value for a parameter of the scene, in the unit that the scene gives it" },
  { "--show", { "lower", "power", "fold", "cse", "dce", "order" }, "print the instructions of all functions after " ..
    "this pass, and write nothing", value = "PASS", default = "files are written", each = {
      lower = "before the first pass", power = "powers as products", fold = "constants and signs folded",
      cse = "common subexpressions once", dce = "unused values dropped", order = "the order of the C code" } },
}
gen.examples = {
  { "polhode gen brick -o brick", "the C of an installed scene in the folder brick; make -C brick check compiles it " ..
    "and runs its self-test" },
  { "polhode gen heavy_top --method taylor,rk4 --order 16 --set h=100", "two steppers, and another height: 100 mm" },
  { "polhode gen brick --name brick_f --real float -o both", "in float, its functions being brick_f_step and so on" },
  { "polhode gen brick --real float --project cmake -o brick_f", "in float, as a CMake project" },
  { "polhode gen brick --only step,energy --layout header -o small", "two functions, in a header of their own" },
}

-- The command line as it goes into the banner: base name of the scene, options that change the output, in one order.
function gen.command(given)
  local parts = { "polhode gen", string.match(given[1], "[^/]*$") }
  local usual = packages.by_name(given.project or packages.default).real or "double"
  if given.name then parts[#parts + 1] = "--name " .. given.name end
  if given.real and given.real ~= usual then parts[#parts + 1] = "--real " .. given.real end
  if given.bake then parts[#parts + 1] = "--bake" end
  if given.libm then parts[#parts + 1] = "--libm " .. given.libm end
  if given.with then
    local list = {}
    for _, word in ipairs(options.row(gen, "--with")[2]) do list[#list + 1] = given.with[word] and word or nil end
    parts[#parts + 1] = "--with " .. table.concat(list, ",")
  end
  if given.only then parts[#parts + 1] = "--only " .. table.concat(given.only, ",") end
  if given.layout and given.layout ~= "split" then parts[#parts + 1] = "--layout " .. given.layout end
  if given.project then parts[#parts + 1] = "--project " .. given.project end
  if given.target then parts[#parts + 1] = "--target " .. table.concat(given.target, ",") end
  if given.accuracy then parts[#parts + 1] = "--accuracy " .. decided.shortest(given.accuracy) end
  if given.order then parts[#parts + 1] = string.format("--order %d", given.order) end
  if given.method then parts[#parts + 1] = "--method " .. table.concat(given.method, ",") end
  local names = {}
  for k in pairs(given.set or {}) do names[#names + 1] = k end
  table.sort(names)
  for _, k in ipairs(names) do parts[#parts + 1] = "--set " .. k .. "=" .. given.set[k] end
  return table.concat(parts, " ")
end

-- What a run is of, for the manifest: scenes side by side in one directory keep to their own files.
local function source(job, given) return job.source .. (given.name and " as " .. given.name or "") end

-- The list of --method; nil and a message for one that cannot be emitted.  linearised is no stepper: it calls for
-- NAME_linearised.
local function chosen_methods(given)
  local names = { "exact" }
  for _, m in ipairs(methods) do names[#names + 1] = m.name end
  names[#names + 1] = "linearised"
  local wrong = options.unknown("--method", given.method, names)
  if wrong then return nil, wrong end
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
  if with.proof and given.layout and given.layout ~= "single" then
    return "--layout: the proof is of one file, got --layout " .. given.layout
  end
  if kind == "make" then return nil end
  for _, name in ipairs { "only", "layout" } do
    if given[name] and packages.by_name(kind).whole then
      return "--" .. name .. ": the project's own files decide what they call, got --project " .. kind
    end
  end
  if with.proof then return "--with proof: the proof is a rule of --project make, got --project " .. kind end
  if with.q31 then return "--with q31: its files come with --project make, got --project " .. kind end
  if given.target and (kind == "fmu" or kind == "firmware") then
    return "--target: its README has no sheet of costs (explain --target prints one), got --project " .. kind
  end
  return nil
end

-- What has no effect beside --show, which writes nothing, or nil.
local function shown_alone(given)
  for _, way in ipairs { "show", "list" } do
    for _, name in ipairs(given[way] and { "o", "project", "target", "layout", "deps" } or {}) do
      local dashes = #name > 1 and "--" or "-"
      if given[name] then return dashes .. name .. ": --" .. way .. " prints and writes no files" end
    end
  end
  if given.list and given.only then return "--only: --list names all functions" end
  for _, word in ipairs { "analysis", "orbit", "attitude" } do
    local with = given.list and given.with and given.with[word]
    if with then return "--with " .. word .. ": --list names all functions" end
  end
  if given.list and given.show then return "--list: --show prints the instructions" end
  return nil
end

-- What --only leaves without effect, or nil.
local function without_effect(given)
  local seen, named, with = {}, "", given.with or {}
  for _, name in ipairs(given.only or {}) do
    if seen[name] then return "--only: " .. name .. " is given twice" end
    seen[name], named = true, named .. " " .. name
  end
  for _, row in ipairs { { "jacobians", { "_p$", "_p ", "_u$", "_u ", "jacobian", "transition" } },
    { "compensated", { "compensated" } } } do
    local calls = not (given.only and with[row[1]])
    for _, pattern in ipairs(row[2]) do calls = calls or string.find(named, pattern) ~= nil end
    if not calls then return "--with " .. row[1] .. ": --only names none of its functions" end
  end
  for _, word in ipairs { "analysis", "orbit", "attitude", "estimator" } do
    if given.only and with[word] then return "--with " .. word .. ": --only names the functions" end
    if with[word] and packages.by_name(given.project or packages.default).whole then
      return "--with " .. word .. ": the project's own files decide what they call, got --project " .. given.project
    end
  end
  return nil
end

-- What the code is made of; nothing that is called for may be missing in a package that calls it.
local function contents(given, package)
  local with = given.with or {}
  if package.whole then return nil, nil, nil, package.layout end
  local analysis, orbit = given.list or with.analysis or false, given.list or with.orbit or false
  if with.proof then return given.only, analysis, orbit, "single" end -- Frama-C is given one file
  return given.only, analysis, orbit, given.layout or package.layout or "split"
end

-- A function of --only that the scene does not have: a message, else nil.
local function missing_function(given, scene, unit, chosen)
  local has = {}
  for _, f in ipairs(unit.emitted) do has[string.sub(f.name, #unit.model.name + 2)] = f.asked end
  for _, name in ipairs(given.only or {}) do
    if not has[name] then
      local with = given.with or {}
      local names = listed.names(driver.code(driver.plan(scene, { real = unit.real, methods = chosen,
        command = unit.command, jacobians = with.jacobians, compensated = with.compensated,
        batch = with.batch, attitude = true, estimator = true })) or unit)
      local best = nearest.one(name, names)
      return "--only: the scene has no function " .. name .. (best and "; did you mean " .. best .. "?" or "") ..
        " (it has " .. table.concat(names, ", ") .. ")"
    end
  end
end

-- What is wrong with the command line before the scene is read, or nil.
local function wrongly_given(given)
  local _, wrong = measure.cores(given.target, given.real or "float") -- the type may be the budget's
  if given.accuracy and not (given.accuracy > 0 and given.accuracy < 1) then
    wrong = "--accuracy must be between 0 and 1, got " .. decided.shortest(given.accuracy)
  end
  wrong = wrong or refused_by_project(given)
  local rule = given.name and identifiers.scene(given.name)
  if rule then wrong = "--name " .. rule .. ", got " .. given.name end
  if given.o == "" then wrong = "-o needs the name of a directory" end
  if given.o == "-" then wrong = "-o must be the name of a folder, as gen writes several files, got -" end
  return wrong or shown_alone(given) or without_effect(given)
end

-- Prints what --list or --show ask for.
local function printed(host, given, plan)
  local unit = given.list and driver.code(plan)
  local text = unit and listed.text(unit) or given.show and driver.show(plan, given.show)
  if not text then return options.refuse(host, plan.diag) end
  host.out(text)
  return 0
end

-- The files of a plan, counted on small processors if that is asked for, written.
local function written(host, given, scene, plan, names)
  local package = plan.package
  local said, why = driver.trace(scene)
  if not said then return options.failed(host, "gen", why) end
  local cores, short = measure.cores(given.target, plan.real)
  if short then return options.wrong(host, "gen", short) end
  if package.check and not package.check(plan) then return options.refuse(host, plan.diag) end
  local unit = driver.files(plan, said)
  if not unit then return options.refuse(host, plan.diag) end
  local wrong = missing_function(given, scene, unit, names)
  if wrong then return options.wrong(host, "gen", wrong) end
  if cores then -- the code is made; once more for the README with its numbers
    said.counted, why = measure.run(host, unit, cores, unit.files)
    unit = said.counted and driver.files(plan, said)
    if not unit then return options.failed(host, "gen", why) end
  end
  local files = unit.files
  if package.finish then
    files, why = package.finish(host, unit, files)
    if not files then return options.failed(host, "gen", compiler.missing(host) or why) end
  end
  files[#files + 1] = { name = "LICENSE", text = host.templates["templates/LICENSE"], once = true }
  local ok, status
  ok, why, status = outputs.write(host, given.o or plan.model.name, source(plan, given), files)
  if ok and given.deps then
    ok, why, status = host.write_file(given.deps, dependencies.rule(given.o or plan.model.name, files, given[1],
      scene.record.files))
  end
  return ok and 0 or options.failed(host, "gen", why, status)
end

function gen.run(host, given)
  local chosen, wrong = chosen_methods(given)
  local order, bad = gen.order(given)
  local package = packages.by_name(given.project or packages.default)
  wrong = wrong or bad or wrongly_given(given)
  if wrong then return options.wrong(host, "gen", wrong) end
  local scene, d, why = driver.read(host, given[1], given)
  if not scene then return options.refuse(host, d, why) end
  local exact, orbit = false, given.with ~= nil and given.with.orbit
  for _, name in ipairs(chosen or {}) do exact = exact or name == "exact" end
  if orbit and chosen and not exact then
    return options.wrong(host, "gen", "--with orbit: of the methods exact alone has one, got --method " ..
      table.concat(chosen, ","))
  end
  if exact and not scene.closed.kind then
    d = scene.diag
    d:error(scene.record.line, "method exact", "this scene has no closed form: " .. scene.closed.refused)
    return options.refuse(host, d)
  end
  if orbit and not scene.closed.kind then
    scene.diag:warn(scene.record.line, "with orbit", "this scene has no closed form: " .. scene.closed.refused)
  end
  if given.with and given.with.attitude and not scene.model.has.attitude then
    scene.diag:warn(scene.record.line, "with attitude", "this scene has no attitude among its states")
  end
  options.warn(host, scene.diag)
  if not given.bake then options.unasked(host, scene, "the generated code does not ask") end
  given.real = given.real or package.real
  local real, decision = given.real, nil
  local question = not given.show and planner.question(scene, given, order)
  wrong = gen.orderless(given, chosen or question and { "taylor" } or {})
  if wrong then return options.wrong(host, "gen", wrong) end
  if question then
    local over = ends.refused(host, scene, "gen")
    if over then return over end
    decision, why = planner.decide(host, question, given.accuracy)
    if not decision and why then return options.failed(host, "gen", why) end
    if not decision then return options.refuse(host, scene.diag) end
    real, chosen, order = decision.real, { decision.method }, decision.order
  end
  local only, analysis, whole, layout = contents(given, package)
  local with, also = given.with or {}, nil
  for _, name in ipairs(chosen or {}) do
    if name == "linearised" then also = { "linearised", "stability" } end
  end
  local plan
  plan, d = driver.plan(scene, { also = also, real = real, only = only, analysis = analysis, orbit = whole,
    layout = layout, command = gen.command(given), methods = chosen or package.methods, order = order,
    jacobians = with.jacobians or package.jacobians, compensated = with.compensated or false, q31 = with.q31 or false,
    batch = with.batch or false, attitude = given.list or with.attitude or false,
    estimator = given.list or with.estimator or false, libm = given.libm,
    outputs = given.project == "fmu", package = package, planned = decision, proof = with.proof })
  if not plan then return options.refuse(host, d) end
  if with.estimator and not estimator.check(plan) then return options.refuse(host, plan.diag) end
  if plan.proof and not proof.check(plan) then return options.refuse(host, plan.diag) end
  if given.list or given.show then return printed(host, given, plan) end
  return written(host, given, scene, plan, chosen or package.methods)
end

return gen
