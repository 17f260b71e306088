-- plot.lua -- polhode plot: pictures of a motion, as SVG, PNG or PDF.
--
-- The motion comes from the engines of `polhode run`, or from the table that it wrote; what is drawn of it, and when
-- that has no meaning, is in generator/plot/panels.lua.
-- SPDX-License-Identifier: GPL-3.0-or-later

local driven = require "generator.commands.driven"
local options = require "generator.commands.options"
local picture = require "generator.commands.picture"
local course = require "generator.commands.plot.course"
local run = require "generator.commands.run"
local bounce = require "generator.commands.run.bounce"
local driver = require "generator.driver"
local rotation = require "generator.attitude.rotation"
local panels = require "generator.plot.panels"
local sheet = require "generator.plot.sheet"
local times = require "generator.plot.times"

local plot = {}

plot.forms = {
  { "SCENE", "the motion as pictures: SVG, PNG, PDF" },
  { "--from FILE.csv", "the same of a table that run wrote",
    "Pictures that need the body's moments need the SCENE beside it.", page = true },
}
plot.operands = { 0, 1, "SCENE" }

local function of_run(name) return options.row(run, name) end

local what = { several = true }
for i, name in ipairs(panels.names) do what[i] = name end

local meanings = {
  rates = "angular velocity in body axes and in inertial axes",
  attitude = "the quaternion",
  axes = "the paths of the body's axes in space, on the unit sphere",
  euler = "Euler angles, of the --sequence",
  energy = "energy, kinetic and potential; its drift, if it is conserved",
  momentum = "angular momentum in inertial axes; its drift, if it is conserved",
  polhode = "w on the ellipsoid of energy, among its neighbours, with the separatrix",
  herpolhode = "w in the invariable plane",
  cones = "body cone and space cone of a free symmetric top",
  phase = "L in the body on the sphere of momentum, with lines of equal energy",
  path = "the centre of mass",
  contact = "the path of the contact point on the plane, of scenes with effect.plane",
  normal_force = "the reaction N of that plane over time, with a mark where contact is lost",
  error = "the difference of two methods (--method A,B), on a logarithmic scale" }

plot.options = {
  { "--what", what, "the pictures that are drawn", value = "WHAT,...", default = "what tells most of the motion",
    each = meanings },
  of_run "--engine",
  { "--method", "words", "the method, as in run; two of them for their difference", value = "A[,B]",
    default = "general: adaptive; generated: exact if there is one, else rk4" },
  of_run "--step", of_run "--tolerance", of_run "--order",
  { "--until", "number", "the end of what is drawn, in s", value = "T", default = "the scene's time.horizon" },
  { "--sequence", rotation.sequences, "the axes of the Euler angles, each as it stands after the turns before",
    value = "ABC", default = "zxz" },
  of_run "--real", of_run "--set", of_run "--input", of_run "--between",
  { "--from", "text", "the table that is drawn", value = "FILE.csv", default = "none; the motion is computed" },
  { "-o", "text", "the file that is written; PNG and PDF by rsvg-convert", value = "FILE.svg|.png|.pdf",
    default = "SVG on standard output, which is also -" },
}
plot.examples = {
  { "polhode plot tennis_racket -o racket.svg", "a sheet of what tells most" },
  { "polhode plot heavy_top --what axes,euler --sequence zyx --until 0.12 -o top.pdf",
    "the path of the axis, and angles" },
  { "polhode plot nodding_top --what error --method rk4,adaptive --step 0.02 -o error.png",
    "what steps of 0.02 s cost in digits" },
  { "polhode plot heavy_top --from top.csv --what rates -o table.svg", "of a table that `polhode run -o` wrote" },
}

-- What is wrong with the command line, or nil.
local function mistake(given)
  if not given[1] and not given.from then return "SCENE is missing" end
  if given.o and given.o ~= "-" and not string.find(given.o, "[^/]%.svg$") and not string.find(given.o, "[^/]%.png$")
    and not string.find(given.o, "[^/]%.pdf$") then
    return "-o must end in .svg, .png or .pdf, or be -, got " .. given.o
  end
  for _, name in ipairs(given.from and { "engine", "method", "step", "tolerance", "order", "until", "real", "input",
    "between" } or {}) do
    if given[name] then return "--" .. name .. ": it belongs to a motion that is computed, and --from has rows" end
  end
  if given.from and given.set and not given[1] then return "--set: it belongs to a SCENE, and there is only --from" end
  if given["until"] and given["until"] <= 0 then return "--until must be positive" end
  local methods = given.method or {}
  if #methods > 2 then return "--method must be one method or two, got " .. table.concat(methods, ",") end
  if methods[2] and methods[1] == methods[2] then return "--method: " .. methods[1] .. " stands there twice" end
  if methods[2] and given.what and not given.what.error then
    return "--method " .. table.concat(methods, ",") .. ": two methods are for --what error"
  end
  if given.sequence and given.what and not given.what.euler then
    return "--sequence: it belongs to the Euler angles, and --what does not name euler"
  end
  return nil
end

-- The pictures that are drawn, or nil and why one of those that are asked for cannot be.
local function chosen(c, asked)
  if not asked then
    local names = panels.usual(c)
    return #names > 0 and names or nil, "the file has none of the columns that run writes"
  end
  local why = {}
  for _, name in ipairs(asked) do
    local reason = panels.refused(c, name)
    why[#why + 1] = reason and name .. ": " .. reason or nil
  end
  if #why > 0 then return nil, "--what " .. table.concat(why, "; ") end
  return asked
end

local function drawn(host, given, c, title, note)
  local names, why = chosen(c, given.what)
  if not names then return options.wrong(host, "plot", why) end
  local last = c.samples[#c.samples].t
  local list, to, finish = panels.of(c, names)
  local text = sheet.text({ title = title, note = note, about = "Pictures of a motion from t = 0 to " ..
    times.number(last) .. " s: " .. table.concat(names, ", ") .. "." }, list)
  local status = picture.write(host, "plot", given.o, text)
  if to and status == 0 then
    host.err(string.format("note: curves over time show the first %s s of %s s, where the fastest has turned as " ..
      "often as a panel can show; --until sets another end\n", times.number(to), times.number(finish)))
  end
  return status
end

-- The scene's parameters in one line, as they are written.
local function parameters(job)
  local list = {}
  for i, p in ipairs(job.model.params) do list[i] = p.name .. " = " .. p.given end
  local text = table.concat(list, ", ")
  return #list > 0 and utf8.len(text) < 110 and text or nil
end

local function computed(host, given, job)
  local said, inputs = driven.one(host, job, given)
  if not said then return options.wrong(host, "plot", inputs) end
  options.warn(host, job.diag)
  local c, failure = course.compute(host, job, given, inputs)
  if not c then return run.refuse(host, failure, nil, "plot") end
  local status = drawn(host, given, c, job.model.name, parameters(job))
  for _, list in ipairs(status == 0 and { said, failure } or {}) do
    for _, w in ipairs(list) do host.err("warning: " .. w) end
  end
  return status
end

function plot.run(host, given)
  local wrong = mistake(given)
  if wrong then return options.wrong(host, "plot", wrong) end
  local job
  if given[1] then
    local d, why
    given.follows = true
    job, d, why = driver.read(host, given[1], given)
    if job then job, d, why = bounce.scene(job, given) end
    if not job then return options.refuse(host, d, why) end
  end
  if not given.from then return computed(host, given, job) end
  if job then options.warn(host, job.diag) end
  local c, why = course.read(host, job, given)
  if not c then return options.wrong(host, "plot", why) end
  return drawn(host, given, c, job and job.model.name or string.match(given.from, "[^/]*$"),
    job and parameters(job))
end

return plot
