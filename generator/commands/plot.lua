-- plot.lua -- polhode plot: pictures of a motion, as SVG, PNG or PDF.
--
-- The motion comes from the engines of `polhode run`, or from the table that it wrote; what is drawn of it, and when
-- that has no meaning, is in generator/plot/panels.lua.
-- SPDX-License-Identifier: GPL-3.0-or-later

local csv = require "generator.commands.csv"
local driven = require "generator.commands.driven"
local options = require "generator.commands.options"
local picture = require "generator.commands.picture"
local course = require "generator.commands.plot.course"
local runs = require "generator.commands.plot.runs"
local what = require "generator.commands.plot.what"
local run = require "generator.commands.run"
local bounce = require "generator.commands.run.bounce"
local driver = require "generator.driver"
local rotation = require "generator.attitude.rotation"
local pair = require "generator.plot.pair"
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

-- An option of run with one value more: for a second run.
local function twice(name, kind, value)
  local row = of_run(name)
  return { name, kind, row[3] .. "; two for two runs", value = value, default = row.default }
end

local pictures = { several = true, open = true }
for i, name in ipairs(panels.names) do pictures[i] = name end

local meanings = {
  rates = "angular velocity in body axes and in inertial axes",
  attitude = "the quaternion",
  axes = "the paths of the body's axes in space, on the unit sphere",
  euler = "Euler angles, of the --sequence",
  energy = "energy, kinetic and potential; its drift, if it is conserved",
  momentum = "angular momentum in inertial axes; its drift, if it is conserved",
  L_body = "angular momentum in body axes",
  polhode = "w on the ellipsoid of energy, among its neighbours, with the separatrix",
  herpolhode = "w in the invariable plane",
  cones = "body cone and space cone of a free symmetric top",
  phase = "L in the body on the sphere of momentum, with lines of equal energy",
  path = "the centre of mass",
  contact = "the path of the contact point on the plane, of scenes with effect.plane",
  normal_force = "the reaction N of that plane over time, with a mark where contact is lost",
  error = "the difference of two runs, on a logarithmic scale" }

plot.options = {
  { "--what", pictures, "the pictures that are drawn; also columns and expressions, as polhode run has them, each " ..
    "over time in a panel, {A,B} in one", value = "WHAT,...", default = "what tells most of the motion",
    each = meanings },
  twice("--engine", { "general", "generated", several = true }),
  { "--method", "words", "the method, as in run; two of them for two runs", value = "A[,B]",
    default = "general: adaptive; generated: exact if there is one, else rk4" },
  twice("--step", "numbers", "H[,H2]"), twice("--tolerance", "numbers", "E[,E2]"),
  twice("--order", "numbers", "N[,N2]"),
  { "--until", "number", "the end of what is drawn, in s", value = "T", default = "the scene's time.horizon" },
  { "--range", "ranges", "what the axis of a panel over time shows: t=0.5:2 the time of all, tilt=0:1 the values of " ..
    "one that --what names, in its unit" },
  { "--sequence", rotation.sequences, "the axes of the Euler angles, each as it stands after the turns before",
    value = "ABC", default = "zxz" },
  twice("--real", { "double", "float", several = true }),
  { "--set", "pairs", "another value for a parameter of the scene, in the unit that the scene gives it; two for two " ..
    "runs" },
  of_run "--input", of_run "--between",
  { "--from", "text", "the table that is drawn", value = "FILE.csv", default = "none; the motion is computed" },
  { "-o", "text", "the file that is written; PNG and PDF by rsvg-convert", value = "FILE.svg|.png|.pdf",
    default = "SVG on standard output, which is also -" },
}
plot.examples = {
  { "polhode plot tennis_racket -o racket.svg", "a sheet of what tells most" },
  { "polhode plot heavy_top --what axes,euler --sequence zyx --until 0.12 -o top.pdf",
    "the path of the axis, and angles" },
  { "polhode plot brick --what error --method rk4,exact --step 0.01 -o error.png",
    "what steps of 0.01 s cost in digits" },
  { "polhode plot brick --what rates,L_body --method rk4 --step 0.1,0.05 -o halved.svg",
    "two runs in each panel: h and h/2" },
  { "polhode plot heavy_top --what 'tilt,{wx,wy},rim = 0.03*wz' --range t=0:0.2 --range tilt=0:3.2 -o tilt.svg",
    "columns and expressions, with ranges" },
  { "polhode plot book --set thickness=25,40 --what polhode,tilt -o books.svg", "two values of a parameter" },
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
  local t = given.range and given.range.t
  if t and t[1] < 0 then return "--range t must begin at 0 or later, got " .. times.number(t[1]) end
  if t and given["until"] and t[2] > given["until"] then
    return "--range t must end by --until " .. times.number(given["until"]) .. ", got " .. times.number(t[2])
  end
  if given.sequence and given.what and not given.what.euler then
    return "--sequence: it belongs to the Euler angles, and --what does not name euler"
  end
  return nil
end

-- The pictures that are drawn of one course or two, or nil and why one of those that are asked for cannot be.
local function chosen(courses, asked)
  local names, why = asked or panels.usual(courses[1]), {}
  if #names == 0 then return nil, "the file has none of the columns that run writes" end
  local kept = {}
  for _, name in ipairs(names) do
    local reason
    for _, c in ipairs(courses) do reason = reason or panels.refused(c, name) end
    why[#why + 1] = reason and name .. ": " .. reason or nil
    kept[#kept + 1] = not reason and name or nil
  end
  if asked and #why > 0 then return nil, "--what " .. table.concat(why, "; ") end
  return kept
end

local blank = { title = "", draw = function() end } -- so that figures of two runs stand side by side

-- The panels of all pictures, with the ranges that are asked for; or nil and what is wrong.
local function panels_of(courses, names, given)
  local out, left = {}, {}
  for name in pairs(given.range or {}) do left[name] = name ~= "t" or nil end -- into a set: order is lost anyway
  local first, second = panels.of(courses[1], names), courses[2] and panels.of(courses[2], names)
  for i, name in ipairs(names) do
    local own = second and name ~= "error" and pair.of(first[i], second[i], courses.names) or first[i]
    local key = what.key(name)
    local range, unit = given.range and given.range[key], nil
    if second and #own > 1 and not own[1].over and #out % 2 == 1 then out[#out + 1] = blank end
    for _, p in ipairs(own) do
      unit = unit or p.over and p.y[2]
      if p.over and p.y[2] == unit then p.yrange = range or p.yrange end
      if p.log and range and range[1] <= 0 then
        return nil, "--range " .. key .. " must be above 0 on its logarithmic scale, got " .. times.number(range[1])
      end
      if p.over then p.xrange = given.range and given.range.t end
      out[#out + 1] = p
    end
    if range and not unit then return nil, "--range " .. key .. ": it is no picture over time" end
    left[key] = nil
  end
  local unknown = what.sorted(left)[1]
  if unknown then
    return nil, "--range " .. unknown .. ": " .. (given.what and "--what does not name it" or "it is not drawn") ..
      options.meant(unknown, names)
  end
  return out
end

-- courses: one or two with names = what tells them apart.
local function drawn(host, given, courses, title, note)
  local names, why = chosen(courses, given.what)
  local list
  if names then list, why = panels_of(courses, names, given) end
  if not list then return options.wrong(host, "plot", why) end
  local to, finish
  if not (given.range and given.range.t) then to, finish = times.together(list) end
  local last = 0.0
  for _, c in ipairs(courses) do last = math.max(last, c.samples[#c.samples].t) end
  local text = sheet.text({ title = title, note = note, about = "Pictures of a motion from t = 0 to " ..
    times.number(last) .. " s: " .. table.concat(names, ", ") .. "." }, list)
  local status = picture.write(host, "plot", given.o, text)
  if to and status == 0 then
    host.err(string.format("note: curves over time show the first %s s of %s s, where the fastest has turned as " ..
      "often as a panel can show; --until sets another end, --range t=0:%s another range\n", times.number(to),
      times.number(finish), times.number(finish)))
  end
  return status
end

-- The scene's parameters in one line, as they are written, without those of which there are two values; and more.
local function noted(job, differs, more)
  local list = {}
  for _, p in ipairs(job.model.params) do
    if not differs[p.name] then list[#list + 1] = p.name .. " = " .. p.given end
  end
  local text = table.concat(list, ", ")
  text = utf8.len(text) < 110 and text or ""
  return text ~= "" and more and text .. "; " .. more or more or text ~= "" and text or nil
end

-- The scene as it is read for one run, or nil and the exit status.
local function scene_of(host, given, file)
  local job, d, why
  given.follows = true
  job, d, why = driver.read(host, file, given)
  if job then job, d, why = bounce.scene(job, given) end
  if not job then return nil, options.refuse(host, d, why) end
  return job
end

local function computed(host, given, list, differs, jobs)
  local courses, warnings, motions = {}, {}, {}
  local finish = given["until"] or given.range and given.range.t and given.range.t[2] or
    jobs[1].model:double(jobs[1].model.horizon)
  for n, own in ipairs(list) do
    local job = jobs[n]
    local said, inputs = driven.one(host, job, own)
    if not said then return options.wrong(host, "plot", inputs) end
    if n == 1 then
      options.warn(host, job.diag)
      for _, w in ipairs(said) do warnings[#warnings + 1] = w end
    end
    local asked, wanted = what.of(given.what, what.of_scene(host, job))
    if not asked then return options.wrong(host, "plot", wanted) end
    own.wanted = wanted
    local c, failure = course.compute(host, job, own, finish, inputs, #list == 1)
    if not c then return run.refuse(host, failure, nil, "plot") end
    c.asked, courses[n], motions[n] = asked, c, c.motion
    for _, w in ipairs(failure) do warnings[#warnings + 1] = w end
  end
  local common
  courses.names, common = runs.labels(list, differs, motions, jobs)
  if courses[2] then
    local e, failure = course.difference(courses[1], courses[2])
    if not e then return run.refuse(host, failure, nil, "plot") end
    e.names = courses.names
    courses[1].error, courses[2].error = e, e
  end
  local status = drawn(host, given, courses, jobs[1].model.name, noted(jobs[1], differs.set, common))
  for i, w in ipairs(status == 0 and warnings or {}) do
    if w ~= warnings[i - 1] then host.err("warning: " .. w) end
  end
  return status
end

local function of_file(host, given, own, job)
  if job then options.warn(host, job.diag) end
  local f, why = csv.open(host, given.from)
  local asked, c
  if f then asked, why = what.of(given.what, function(name) return course.column(f, name) end) end
  if asked then
    own.wanted = why
    c, why = course.read(f, job, own)
  end
  if not c then return options.wrong(host, "plot", why) end
  c.asked = asked
  return drawn(host, given, { c }, job and job.model.name or string.match(given.from, "[^/]*$"),
    job and noted(job, {}))
end

function plot.run(host, given)
  local wrong, list, differs = mistake(given), nil, nil
  if not wrong then
    list, differs = runs.of(given)
    wrong = not list and differs or nil
  end
  if not wrong and list[2] and given.from then wrong = "--set: --from has one motion, got two values" end
  if wrong then return options.wrong(host, "plot", wrong) end
  local jobs = {}
  for n, own in ipairs(given[1] and list or {}) do
    local status
    jobs[n], status = jobs[1] and not next(differs.set) and not jobs[1].record.flies and jobs[1], nil
    if not jobs[n] then jobs[n], status = scene_of(host, own, given[1]) end
    if not jobs[n] then return status end
  end
  if given.from then return of_file(host, given, list[1], jobs[1]) end
  return computed(host, given, list, differs, jobs)
end

return plot
