-- chart.lua -- polhode chart: where in the plane of two parameters a spin persists, as SVG; with --linearised the
-- error of the linearised top against the exact motion.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local vec = require "generator.algebra.vec"
local csv = require "generator.commands.csv"
local options = require "generator.commands.options"
local picture = require "generator.commands.picture"
local driver = require "generator.driver"
local stability = require "generator.mass.spin_stability"
local contact = require "generator.dynamics.contact"
local numeric = require "generator.dynamics.numeric"
local report = require "generator.report.chart"
local linearised = require "generator.report.linearised_chart"
local members = require "generator.report.members_chart"
local upright_chart = require "generator.report.upright_chart"

local chart = {}

chart.forms = {
  { "SCENE --over A=..,B=..", "where a spin persists, as SVG" },
  { "SCENE --linearised", "the error of the linearised top, as SVG", page = true },
  { "--from FILE.csv --x A", "members of a sweep: map, points, histogram",
    "With --x a histogram, with --x and --y points, with --z too a map whose colours are its values." },
}
chart.operands = { 0, 1, "SCENE" }
chart.options = {
  { "--over", "words", "two parameters and their ranges, each in the parameter's own unit",
    value = "A=LOW:HIGH,B=LOW:HIGH", default = "none; needed without --linearised" },
  { "--axis", { "x", "y", "z", "0", "1", "2" }, "the axis of the spin: a coordinate axis, or a principal axis by " ..
    "its number", default = "each axis that differs from the others" },
  { "--rate", "number", "of a body of revolution on a plane: the rate of its upright spin, in rad/s", value = "N",
    default = "the size of the scene's omega" },
  { "--dissipation", false, "with dissipation inside the body" },
  { "--linearised", false, "the error of the linearised motion against the exact one instead" },
  { "--from", "text", "the rows that `polhode sweep` wrote", value = "FILE.csv", default = "none; a scene instead" },
  { "--x", "text", "the column of the horizontal axis", value = "COLUMN", default = "none; needed with --from" },
  { "--y", "text", "the column of the vertical axis", value = "COLUMN", default = "how many members" },
  { "--z", "text", "the column of the colour", value = "COLUMN", default = "points" },
  { "--set", "pair", "another value for a parameter of the scene, in the unit that the scene gives it" },
  { "-o", "text", "the file that is written; PNG and PDF by rsvg-convert", value = "FILE.svg|.png|.pdf",
    default = "standard output, which is also -" },
}
chart.examples = {
  { "polhode chart brick_centroid --over a=0.05:0.4,b=0.05:0.4 -o brick.svg", "over two edges of a brick" },
  { "polhode chart book --linearised -o book.svg", "how long the linearised motion is good" },
  { "polhode chart --from flips.csv --x wx --y wz --z flip -o flips.svg", "a map of a sweep" },
}

-- "a=0.05:0.4" as {name, low, high}, or nil and what is wrong.
local function range(word)
  local name, low, high = string.match(word, "^(%a[%w_]*)=([^:]+):([^:]+)$")
  low, high = low and R.parse(low), high and R.parse(high)
  if not low or not high then return nil, "--over must be NAME=LOW:HIGH,NAME=LOW:HIGH, got " .. word end
  if low >= high then return nil, "--over " .. name .. ": LOW must be less than HIGH, got " .. word end
  return { name = name, low = low, high = high }
end

-- The two parameters with their ranges in SI and in their own units, or nil and what is wrong.
local function plane(job, words)
  if not words or #words ~= 2 then return nil, "--over must name two parameters: NAME=LOW:HIGH,NAME=LOW:HIGH" end
  local m, over = job.model, {}
  for i, word in ipairs(words) do
    local r, why = range(word)
    if not r then return nil, why end
    local names = {}
    for _, p in ipairs(m.params) do
      names[#names + 1] = p.name
      if p.name == r.name then
        local factor = m:number(p.factor)
        over[i] = { name = p.name, unit = p.own, here = R.todouble(p.default), low = R.todouble(r.low * factor),
          high = R.todouble(r.high * factor), given_low = R.todouble(r.low), given_high = R.todouble(r.high) }
      end
    end
    if not over[i] then
      return nil, "--over " .. r.name .. ": the scene has no such parameter" ..
        (#names > 0 and " (it has " .. table.concat(names, ", ") .. ")" or "") .. options.meant(r.name, names)
    end
    local o = over[i]
    if o.low >= o.high then return nil, "--over " .. r.name .. ": the range is empty in double" end
    if not (o.high - o.low < math.huge and o.given_high - o.given_low < math.huge) then
      return nil, "--over " .. r.name .. ": the range must be within that of double, got " .. word
    end
  end
  if over[1].name == over[2].name then return nil, "--over must name two different parameters, got " .. over[1].name end
  return over
end

-- The axes to draw: the one asked for, or all that differ.
local function axes(job, s, asked)
  if asked then
    local letter = ({ x = 1, y = 2, z = 3 })[asked]
    local kind = job.model.structure.kind
    local c = s.block and s.block.c
    if letter and (s.line or s.block and letter ~= c) then
      return nil, "--axis " .. asked .. ": no principal axis of this " .. kind .. " body; 0, 1 and 2 are " ..
        s.axes[1] .. ", " .. s.axes[2] .. ", " .. s.axes[3]
    end
    return { letter or math.tointeger(tonumber(asked)) + 1 }
  end
  local list, pair = {}, false
  for k = 1, 3 do
    if not (s:paired(k) and pair) then list[#list + 1] = k end
    pair = pair or s:paired(k)
  end
  return list
end

-- The chart of a body on a plane: where it spins upright at a rate, the scene's unless it is given.
local function upright_text(job, over, given)
  if given.dissipation then return nil, "--dissipation: it is that of a free body, with --axis" end
  local m = job.model
  local w = vec.map(m.omega, function(e) return m:double(e) end)
  local rate = given.rate or math.sqrt(vec.dot(w, w))
  local s = upright_chart.of(m, R.fromdouble(rate))
  if not s then
    return nil, "no spin of this scene is upright: that needs a body of revolution on a level plane at rest, and " ..
      "effect.plane alone (--axis has the spin of the free body)"
  end
  local list = {}
  for i in ipairs(s.axes) do list[i] = i end
  return report.text(job, over, list, nil, s, string.format(" at n = %.6g rad/s on the plane", rate))
end

-- The stability chart's text, or nil and what is wrong.
local function stability_text(job, given)
  local over, wrong = plane(job, given.over)
  if not over then return nil, wrong end
  if contact.of(job.model) and not given.axis then return upright_text(job, over, given) end
  if given.rate then return nil, "--rate: it is that of an upright spin of a body on a plane, without --axis" end
  local s = stability.of(job.model)
  if not s.axes then return nil, "the principal axes of this body have no simple closed form" end
  local list
  list, wrong = axes(job, s, given.axis)
  if not list then return nil, wrong end
  return report.text(job, over, list, given.dissipation)
end

-- The chart of the linearised top, or nil and what is wrong; the exact motion is the general library's.
local function linearised_text(host, job, given)
  if given.over or given.axis or given.rate or given.dissipation then
    return nil, "--linearised excludes --over, --axis, --rate and --dissipation"
  end
  local scene = numeric.scene(job)
  scene.effects, scene.q = {}, { 1.0, 0.0, 0.0, 0.0 }
  return linearised.text(job, function(w, times)
    scene.w = w
    local rows, why = host.run(scene, { method = "exact", times = times })
    if not rows then return nil, why end
    for i, row in ipairs(rows) do rows[i] = { row[6], row[7], row[8] } end
    return rows
  end)
end

-- The chart of a sweep's rows, or nil and what is wrong.
local function members_text(host, given)
  for _, name in ipairs { "over", "axis", "rate", "dissipation", "linearised", "set" } do
    if given[name] then return nil, "--" .. name .. ": it belongs to a scene, and --from has rows of members" end
  end
  if given[1] then return nil, "too many operands: " .. given[1] .. " (--from has rows of members)" end
  if string.find(given.from, "%.h5$") then
    return nil, "--from must be a CSV file: polhode sweep -o FILE.csv writes it, got " .. given.from
  end
  if not given.x then return nil, "--x is missing: the column of the horizontal axis" end
  if given.z and not given.y then return nil, "--y is missing: the column of the vertical axis" end
  local names = { given.x, given.y, given.z }
  local f, why = csv.open(host, given.from)
  if not f then return nil, why end
  local wanted, columns = {}, {}
  for i, name in ipairs(names) do wanted[i] = { name = name } end
  local rows, wrong = f:read(wanted)
  if not rows then return nil, wrong end
  for i in ipairs(names) do columns[i] = f.object:values(i) end
  return members.text(names, columns)
end

function chart.run(host, given)
  if given.from then
    local text, wrong = members_text(host, given)
    if not text then return options.wrong(host, "chart", wrong) end
    return picture.write(host, "chart", given.o, text)
  end
  if not given[1] then return options.wrong(host, "chart", "SCENE is missing") end
  for _, name in ipairs { "x", "y", "z" } do
    if given[name] then return options.wrong(host, "chart", "--" .. name .. ": it names a column of --from") end
  end
  local job, d, why = driver.read(host, given[1], given)
  if not job then return options.refuse(host, d, why) end
  options.warn(host, job.diag)
  options.unasked(host, job, "the chart does not show")
  local text, wrong
  if given.linearised then
    text, wrong = linearised_text(host, job, given)
  else
    text, wrong = stability_text(job, given)
  end
  if not text then return options.wrong(host, "chart", wrong) end
  return picture.write(host, "chart", given.o, text)
end

return chart
