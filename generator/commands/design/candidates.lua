-- candidates.lua -- the initial states and parameters among which a design chooses.
--
--     candidates.read(host, job, given, wrong) -> {values = list of {name, unit, factor, kind, scale = SI units in one
--         of `unit`}, points = lists of numbers, in the units of the values}; messages are appended to wrong
-- --over is read as by polhode sweep; of --vary what is drawn evenly.  Points are Halton's (J. H. Halton, Numerische
-- Mathematik 2 (1960)), so they are the same every time: the digits of n in the base of a prime, mirrored.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local values = require "generator.commands.sweep.values"

local candidates = {}

local PRIMES = { 2, 3, 5, 7, 11, 13, 17, 19 }
local MOST = 1000000

local function mirrored(n, base)
  local x, part = 0.0, 1.0
  while n > 0 do
    part = part / base
    x = x + part * (n % base)
    n = n // base
  end
  return x
end

local function on_axis(a, i)
  if a.count == 1 then return a.low end
  local part = i / (a.count - 1)
  return a.log and a.low * (a.high / a.low) ^ part or a.low + (a.high - a.low) * part
end

local function drawn(d, n)
  local u = mirrored(n, PRIMES[d.dimension + 1])
  return d.kind == "uniform" and d.a + (d.b - d.a) * u or d.a * (d.b / d.a) ^ u
end

local function refused(list, wrong)
  local dimensions = 0
  for _, v in ipairs(list) do
    local d = v.draw
    dimensions = dimensions + (d and 1 or 0)
    if v.kind == "turn" or d and d.kind == "attitude" or string.find(v.name, "^q[wxyz]$") then
      wrong[#wrong + 1] = v.name .. ": a design chooses parameters and rates, not attitudes (let the " ..
        "scene's attitude depend on a parameter)"
    elseif d and d.kind == "normal" then
      wrong[#wrong + 1] = "--vary " .. v.name .. ": must be uniform(LOW,HIGH) or loguniform(LOW,HIGH), as " ..
        "nothing is random in a choice"
    end
  end
  if dimensions > #PRIMES then
    wrong[#wrong + 1] = "--vary: at most " .. #PRIMES .. " names are drawn, got " .. dimensions
  end
end

function candidates.read(host, job, given, wrong)
  if not (given.over or given.candidates or given.vary) then return { values = {}, points = { {} } } end
  local said = {}
  local s = values.read(host, job, { over = given.over, sample = given.candidates, vary = given.vary }, said)
  for _, text in ipairs(said) do wrong[#wrong + 1] = string.gsub(text, "%-%-sample", "--candidates") end
  refused(s.values, wrong)
  local count = s.grid * (s.samples or 1)
  if count > MOST then wrong[#wrong + 1] = "there must be at most " .. MOST .. " candidates, got " .. count end
  if #wrong > 0 then return nil end
  for _, v in ipairs(s.values) do v.scale = R.todouble(evaluate.precise(v.factor, {}, 80)) end
  local points = {}
  for n = 0, math.tointeger(count) - 1 do
    local point, rest = {}, n // s.samples
    for k = #s.values, 1, -1 do -- the last name of the grid is the fastest
      local v = s.values[k]
      if v.over then
        point[k] = on_axis(v.over, rest % v.over.count)
        rest = rest // v.over.count
      else
        point[k] = drawn(v.draw, n % s.samples + 1)
      end
    end
    points[n + 1] = point
  end
  return { values = s.values, points = points }
end

return candidates
