-- laws_runs.lua -- what is measured: stepper, scene, type, step, number of steps, and the laws that are expected.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A law is {exponent, from = least n of its window, to = largest}.  Windows of phases begin after some radians, where
-- the integral of the frequency's error is larger than what the attitude has got by itself.

local runs = {}

local MEMBERS = 32

local function laws(energy, momentum, direction, norm, phase, from)
  local out = { energy = { energy, from = from }, momentum = { momentum, from = from }, norm = { norm, from = from } }
  if direction then out.direction = { direction, from = from } end
  if phase then out.phase = { phase, from = from } end
  return out
end

local list

-- A list of its own is what the functions below add to: runs.list, and tests/methods/laws.t by runs.few.
local function run(regime, scene, real, method, h, steps, set)
  list[#list + 1] = { regime = regime, scene = scene, real = real, method = method, h = h, steps = steps,
    members = MEMBERS, laws = set }
end

-- Steps after which the body has turned by that many radians: 1 rad/s free, 3 rad/s heavy.
local function after(radians, scene, h) return math.max(radians / (scene == "free" and 1 or 3) / h, 100) end

-- Rounding: each step is wrong by a rounding of its own; sums of n of them grow like sqrt(n), and the phase, the
-- integral of a frequency that walks, like n^(3/2).  least: of the window, where what is below it is lost in measuring.
local function rounding(scene, real, method, h, steps, no_phase, least)
  local set = laws(0.5, 0.5, scene == "free" and 0.5 or nil, 0, 1.5, least)
  set.phase.from = math.max(after(100, scene, h), least or 0)
  if no_phase then set.phase = nil end
  run("rounding", scene, real, method, h, steps, set)
end

-- Truncation, of a method that knows no invariant: energy and |L| drift steadily, the frequency with them; its own
-- constant error leads before.
local function creeping(scene, method, h, steps)
  local set = laws(1, 1, scene == "free" and 0 or nil, 0, 2, after(300, scene, h))
  set.norm, set.phase.from = { 0 }, after(scene == "free" and 1500 or 100, scene, h)
  run("truncation", scene, "double", method, h, steps, set)
end

-- Truncation, of a geometric method: a free body's energy and L in space, a heavy top's Lz are exact but for
-- rounding; a heavy top's energy, and that of semi, is off by a bounded amount; the frequencies are constant and a
-- little wrong.
local function geometric(scene, method, h, steps, bounded)
  local set = laws((scene == "heavy" or bounded) and 0 or 0.5, 0.5, scene == "free" and 0.5 or nil, 0, 1)
  set.phase.from = after(10, scene, h)
  run("truncation", scene, "double", method, h, steps, set)
end

local function closed(scene, real, method, h, steps)
  run("closed form", scene, real, method, h, steps, laws(0, 0, scene == "free" and 0 or nil, 0, 0))
end

function runs.list()
  list = {}
  for _, scene in ipairs { "free", "heavy" } do
    local free = scene == "free"
    local k = free and 1 or 0.5
    creeping(scene, "rk4", 0.05 * k, free and 1000000 or 100000)
    creeping(scene, "library rk4", 0.05 * k, 100000)
    creeping(scene, "adaptive", 0.1 * k, 100000)
    creeping(scene, "taylor 8", 0.3 * k, 100000)
    geometric(scene, "midpoint", 0.05 * k, 300000)
    geometric(scene, "semi", free and 0.05 or 0.0005, free and 300000 or 60000, true)
    geometric(scene, "split2", free and 0.5 or 0.05, 300000)
    geometric(scene, "split4", free and 0.5 or 0.1, 100000)
    geometric(scene, "split6", free and 0.5 or 0.1, 100000)
    for _, real in ipairs { "double", "float" } do
      local double = real == "double"
      local long = free and 1000000 or 300000
      rounding(scene, real, "rk4", double and 1e-4 * k or 0.01 * k, free and double and 10000000 or long,
        double and not free)
      rounding(scene, real, "rk4, compensated", double and 1e-4 * k or 0.001 * k, long, double, double and 30000)
      rounding(scene, real, "adaptive", double and 1e-3 * k or 0.02 * k, long)
      rounding(scene, real, "adaptive, compensated", double and 3e-4 * k or 0.002 * k, 1000000, double, double and
        30000)
      rounding(scene, real, "taylor 8", double and 0.02 * k or 0.05 * k, 100000)
      rounding(scene, real, "taylor 8, compensated", double and 0.005 * k or 0.05 * k, 100000, double)
      rounding(scene, real, "taylor 20", 0.3 * k, 30000)
      if free then
        rounding(scene, real, "split6", double and 0.02 or 0.2, 300000)
        closed(scene, real, "closed form by ticks", 0.01, 100000000)
      end
    end
    if free then
      rounding(scene, "float", "semi", 0.01 * k, 1000000, true)
      rounding(scene, "float", "semi, compensated", 0.001 * k, 1000000, true)
    end
  end
  rounding("free", "float", "q31", 0.001953125, 1000000)
  return list
end

-- Pairs of a plain and a compensated run with the same step, the plain one first: what compensation gains.
function runs.pairs()
  list = {}
  for _, p in ipairs {
    { "free", "float", "rk4", 0.1, 0.01, 0.001 }, { "heavy", "float", "rk4", 0.01 }, { "free", "double", "rk4", 0.01,
      0.001 },
    { "free", "float", "adaptive", 0.1, 0.01 }, { "free", "float", "semi", 0.01, 0.001 },
    { "free", "float", "taylor 8", 0.5, 0.1 }, { "free", "float", "taylor 20", 1 },
  } do
    for i = 4, #p do
      local steps = string.find(p[3], "taylor") and 100000 or 1000000
      run("gain", p[1], p[2], p[3], p[i], steps, {})
      run("gain", p[1], p[2], p[3] .. ", compensated", p[i], steps, {})
    end
  end
  return list
end

-- One scene for each law, small numbers of steps: tests/methods/laws.t.
function runs.few()
  list = {}
  creeping("free", "few: rk4", 0.05, 300000)
  rounding("free", "float", "few: rk4", 0.01, 300000)
  rounding("free", "float", "few: rk4, compensated", 0.001, 100000, true)
  closed("free", "float", "few: closed form by ticks", 0.01, 1000000)
  geometric("heavy", "few: split2", 0.05, 10000)
  return list
end

return runs
