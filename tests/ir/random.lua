-- random.lua: random programs over exact expressions, the same ones in every run.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Programs that lower accepts: several groups with named intermediates and results, subexpressions in
-- common, polynomials, quotients with denominators away from zero, roots of what is positive, and
-- functions inside their domain.  Values stay moderate: inputs are in (1/4, 2), functions get bounded
-- arguments.  Every random choice comes from one generator with a fixed seed.

local expr = require "generator.algebra.expr"
local R = require "generator.algebra.rational"

local random = {}

local inputs = { "x", "y", "z", "u", "w" }

local state = 1

function random.seed(n) state = n end

-- A whole number in [1, n] (Park and Miller's generator: 16807^k mod 2^31 - 1).
function random.int(n)
  state = state * 16807 % 2147483647
  return state % n + 1
end

local function rational()
  local q = R.new(random.int(12), random.int(9))
  return random.int(3) == 1 and -q or q
end

-- An expression of about `size` operations over the expressions in `pool`.  kinds.roots and kinds.calls
-- say what may occur beside + - * / and integer powers.
local function expression(size, pool, kinds)
  if size <= 0 then
    if random.int(5) == 1 then return expr.num(rational()) end
    return pool[random.int(#pool)]
  end
  local function part() return expression(size - random.int(3), pool, kinds) end
  local function positive() return 1 + part() ^ 2 end
  local function bounded() -- in [0, 1)
    local e = part() ^ 2
    return e / (1 + e)
  end
  local pick = random.int(12 + (kinds.roots and 3 or 0) + (kinds.calls and 6 or 0))
  if pick <= 3 then return part() + part() end
  if pick <= 6 then return part() - part() end
  if pick <= 9 then return part() * part() end
  if pick == 10 then return part() / positive() end
  if pick == 11 then return expression(size - 3, pool, kinds) ^ (1 + random.int(5)) end
  if pick == 12 then return expr.num(rational()) * (part() ^ 2 - part() ^ 2) end
  pick = pick - 12
  if kinds.roots then
    local exponents = { "1/2", "-1/2", "3/2", "-3/2", "1/4", "3/4", "5/2" }
    if pick == 1 then return expr.pow(positive(), R.parse(exponents[random.int(#exponents)])) end
    if pick == 2 then return expr.call("abs", part()) end
    if pick == 3 then return expr.sqrt(positive()) / expr.sqrt(positive()) end
    pick = pick - 3
  end
  local names = { "sin", "cos", "atan", "exp", "asin", "log" }
  local fn = names[pick]
  if fn == "log" then return expr.call(fn, positive()) end
  if fn == "exp" or fn == "asin" then return expr.call(fn, bounded()) end
  if random.int(4) == 1 then return expr.call("atan2", part(), positive()) end
  return expr.call(fn, part())
end

-- A program of several groups, and its expressions' list in the order of evaluation.
function random.program(name, size, kinds)
  local program = { name = name, inputs = {}, groups = {} }
  local pool = {}
  for k, sym in ipairs(inputs) do
    program.inputs[k] = { sym = sym, c = "in[" .. k - 1 .. "]" }
    pool[k] = expr.sym(sym)
  end
  local outs, defs = 0, 0
  for g = 1, 1 + random.int(2) do
    local group = { why = "group " .. g, defs = {}, outs = {} }
    for _ = 1, random.int(3) - 1 do
      local e = expression(size // 2, pool, kinds)
      if random.int(3) == 1 then
        pool[#pool + 1] = e -- in common, but not named
      else
        defs = defs + 1
        group.defs[#group.defs + 1] = { name = "d" .. defs, expr = e }
        pool[#pool + 1] = expr.sym("d" .. defs)
      end
    end
    for _ = 1, random.int(3) do
      outs = outs + 1
      group.outs[#group.outs + 1] = { c = "out[" .. outs - 1 .. "]", expr = expression(size, pool, kinds) }
    end
    program.groups[g] = group
  end
  return program, outs
end

-- Values for the inputs: doubles that are floats too, in (1/4, 2).
function random.point()
  local env = {}
  for _, sym in ipairs(inputs) do
    local x = 0.25 + 1.75 * random.int(1 << 20) / (1 << 20)
    env[sym] = (string.unpack("<f", string.pack("<f", x)))
  end
  return env
end

random.inputs = inputs

return random
