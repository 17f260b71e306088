-- accuracy.lua -- the keys `accuracy` and `budget` of a scene: what its emitted code shall hold, and may cost.
--
--     accuracy = 1e-9, budget = { ops = 5000, real = "float", target = "cortex-m4f" }
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local args = require "generator.dsl.args"
local value = require "generator.dsl.value"
local diag = require "generator.diag"

local accuracy = {}

accuracy.targets = { "x86-64", "cortex-m0", "cortex-m3", "cortex-m4f", "cortex-m7", "rv32imac", "rv32imafc", "avr" }

-- The accuracy as a double, or nil without one or after an error.
function accuracy.read(ctx, line, given)
  if given == nil then return nil end
  local at = ctx.diag:locate(line, "accuracy")
  local e = args.scalar(ctx, at, "scene", "accuracy", { dim = "none" }, given)
  local q = e and value.number(e)
  if not q then return nil end
  if R.sign(q) <= 0 or q >= R.one then
    ctx.diag:error(at, "scene", "accuracy must be between 0 and 1", value.show(given))
    return nil
  end
  return R.todouble(q)
end

-- {ops =, real =, target =, line =}, each as given.
function accuracy.budget(ctx, line, given)
  if given == nil then return nil end
  local at = ctx.diag:locate(line, "budget")
  local specs = { { name = "ops", optional = true }, { name = "real", optional = true, choice = { "double", "float" } },
    { name = "target", optional = true, choice = accuracy.targets } }
  local b, ok = args.read(ctx, at, "budget", specs, given)
  local n = b.ops and value.number(b.ops)
  if n and (R.sign(n) <= 0 or not R.isint(n)) then
    ctx.diag:error(ctx.diag:locate(at, "ops"), "budget", "ops must be a whole number, at least 1", diag.show(given.ops))
    return nil
  end
  return ok and { ops = n and R.todouble(n), real = b.real, target = b.target, line = at } or nil
end

return accuracy
