-- targets.lua -- what operations cost on the processors that emitted code is made for: estimates, said to be such.
--
--     targets.list                             names, in order; targets.default
--     targets.cost(target, real, counts)       cycles of what cost/ops.lua counted
--     targets.instructions(target, real, counts)   instructions; nil where none were counted (x86-64, avr)
--     targets.fma(target, real)                has it fused multiplication and addition in the type?  (for ops.of)
-- Instructions: the sum over the operations of what each was counted to take, times `part`, and `mem` for each number
-- in memory; both are fitted to emitted code (cost/measured.lua; `make target-costs` remakes it).  Cycles: by the
-- makers' tables below, memory without wait states; so they are near what a small core takes, and below what it takes
-- from slow flash.  docs/targets.md shows predicted against counted.
-- SPDX-License-Identifier: GPL-3.0-or-later

local measured = require "generator.cost.measured"

local targets = { default = "x86-64",
  list = { "x86-64", "cortex-m0", "cortex-m3", "cortex-m4f", "cortex-m7", "rv32imac", "rv32imafc", "avr" } }

-- x86-64: cycles at -O2 without vectors, between reciprocal throughput and latency as emitted steppers have them:
-- chosen by hand from three scenes on one server processor (tests/target/host.c, docs/targets.md).
local x86 = { part = 1, mem = 0, add = 0.39, mul = 0.39, fma = 0.39, cmp = 1, conv = 2, conv64 = 2, long = 0.5,
  frexp = 8, ldexp = 12, floor = 7 }
local function host(own)
  for k, v in pairs(x86) do own[k] = v end -- into a table: order is lost anyway
  return own
end
measured["x86-64"] = {
  float = host { div = 8, sqrt = 10, sin = 13, cos = 13, exp = 10, log = 11, sinh = 35, cosh = 16, other = 40 },
  double = host { div = 10, sqrt = 14, sin = 19, cos = 20, exp = 13, log = 14, sinh = 34, cosh = 17, other = 50 },
}

-- Cycles beyond: `cycles` an instruction as counted by Arm's tables (templates/target/count.c), and what hardware takes
-- more than one for.
--   cortex-m0, -m3, -m4f  Arm DDI 0432C, DDI 0337I, DDI 0439B, table 3-1 each: loads and stores 2, taken branches 3;
--                         M4F, table 7-1: VFMA 3, VDIV and VSQRT 14
--   cortex-m7   Arm publishes no timings; VDIV and VSQRT as on the M4F, twice as long in double: an assumption
--   rv32imafc   depends on the core; one cycle each but for division and root, 15 more: an assumption
--   avr         simavr counts cycles, by Atmel 0856L (AVR instruction set manual)
local extra = {
  ["cortex-m4f"] = { float = { fma = 2, div = 13, sqrt = 13 } },
  ["cortex-m7"] = { float = { div = 13, sqrt = 13 }, double = { div = 27, sqrt = 27 } },
  rv32imafc = { float = { div = 15, sqrt = 15 } },
}
local TIMED = { ["cortex-m0"] = true, ["cortex-m3"] = true, ["cortex-m4f"] = true }

local FUSED = { ["cortex-m4f"] = { float = true }, ["cortex-m7"] = { float = true, double = true },
  rv32imafc = { float = true } }

local OPERATIONS = { "add", "mul", "div", "sqrt", "fma", "cmp", "conv", "conv64", "long" }

function targets.fma(target, real) return FUSED[target] ~= nil and FUSED[target][real] or false end

-- What one operation or function costs: instructions, on AVR and x86-64 cycles.
function targets.unit(target, real, name)
  local own = measured[target][real]
  return own[name] or own.other or own.atan2
end

-- Calls that counts does not name are as dear as a sine.
local function sum(target, real, counts)
  local own, total = measured[target][real], 0
  for _, name in ipairs(OPERATIONS) do total = total + (counts[name] or 0) * targets.unit(target, real, name) end
  local named = 0
  for name, n in pairs(counts.calls or {}) do -- a sum of few terms, each exact in a double: in any order
    total, named = total + n * targets.unit(target, real, name), named + n
  end
  total = total + (counts.call - named) * targets.unit(target, real, "sin")
  return own.part * total + own.mem * (counts.mem or 0)
end

function targets.instructions(target, real, counts)
  if target == "x86-64" or target == "avr" then return nil end
  return sum(target, real, counts)
end

function targets.cost(target, real, counts)
  local cycles = sum(target, real, counts) * (TIMED[target] and measured[target][real].cycles or 1)
  local more = extra[target] and extra[target][real] or {}
  for _, name in ipairs { "fma", "div", "sqrt" } do cycles = cycles + (counts[name] or 0) * (more[name] or 0) end
  return cycles
end

return targets
