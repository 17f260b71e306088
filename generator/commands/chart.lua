-- chart.lua -- polhode chart: where in the plane of two parameters a spin persists, as SVG.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local options = require "generator.commands.options"
local driver = require "generator.driver"
local stability = require "generator.mass.stability"
local report = require "generator.report.chart"

local chart = {}

chart.options = { ["--over"] = "words", ["--axis"] = { "x", "y", "z", "0", "1", "2" }, ["--dissipation"] = false,
  ["--set"] = "pair", ["-o"] = "text" }
chart.operands = { 1, 1 }

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
        (#names > 0 and " (it has " .. table.concat(names, ", ") .. ")" or "")
    end
    if over[i].low >= over[i].high then return nil, "--over " .. r.name .. ": the range is empty in double" end
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

function chart.run(host, given)
  local job, d, why = driver.read(host, given[1], given)
  if not job then return options.refuse(host, given[1], d, why) end
  options.warn(host, job.diag)
  local over, wrong = plane(job, given.over)
  local s = over and stability.of(job.model)
  if s and not s.axes then wrong = "the principal axes of this body have no simple closed form" end
  local list
  if s and s.axes then
    list, wrong = axes(job, s, given.axis)
  end
  if not list then
    host.err("polhode chart: " .. wrong .. "\n")
    return 2
  end
  local text = report.text(job, over, list, given.dissipation)
  if not given.o then
    host.out(text)
    return 0
  end
  local ok, failure = host.write_file(given.o, text)
  if not ok then
    host.err("polhode chart: " .. failure .. "\n")
    return 2
  end
  return 0
end

return chart
