#!/usr/bin/env lua5.4
-- oracle.t: random programs mean the same before lower, after every pass, and as compiled C.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Three roads: the expressions in 400-bit arithmetic (algebra/evaluate), the ir in double and float
-- (tests/ir/eval.lua), the C text compiled by gcc without contraction.  Expression against ir: within the running
-- error bound of that ir at that point.  Pass against pass and ir against C: to the last bit.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath
-- The quick tier takes a part of its cases.

local tap = require "tests.tap"
local tier = require "tests.tier"
local R = require "polhode_rational"
local evaluate = require "generator.algebra.evaluate"
local lower = require "generator.ir.lower.lower"
local passes = require "generator.ir.passes.passes"
local eval = require "tests.ir.eval"
local cprint = require "generator.emit.cprint"
local random = require "tests.ir.random"
local running = require "tests.ir.running"
local compiled = require "tests.ir.compiled"

local BITS = 400      -- of the reference; the programs have < 2^12 operations of condition < 2^60
local PROGRAMS, POINTS = tier.quick and 8 or 40, 3

local families = {
  { name = "polynomials and quotients", kinds = {}, size = 9, seed = 11, floats = true },
  { name = "roots", kinds = { roots = true }, size = 9, seed = 12, floats = true },
  { name = "functions", kinds = { roots = true, calls = true }, size = 8, seed = 13 },
}

-- The results of the expressions themselves, defs in order.
local function reference(program, point)
  local env, results = {}, {}
  for _, sym in ipairs(random.inputs) do env[sym] = R.fromdouble(point[sym]) end
  for _, group in ipairs(program.groups) do
    for _, def in ipairs(group.defs) do env[def.name] = evaluate.precise(def.expr, env, BITS) end
    for _, out in ipairs(group.outs) do results[out.c] = evaluate.precise(out.expr, env, BITS) end
  end
  return results
end

-- Does every constant have a place in float, well inside its range?
local function fits_float(ir)
  for _, i in ipairs(ir.consts) do
    local size = math.abs(R.todouble(i.value))
    if size ~= 0 and (size < 1e-30 or size > 1e30) then return false end
  end
  return true
end

local function same(a, b)
  if a ~= a then return b ~= b end
  return a == b and 1 / a == 1 / b
end

for _, family in ipairs(families) do
  random.seed(family.seed)
  local wrong, loose, checks, moved = {}, 0, 0, {}
  local programs = {}
  for k = 1, PROGRAMS do
    local program, outs = random.program("p" .. k, family.size, family.kinds)
    local stages = { { name = "lower", ir = lower.run(program) } }
    for _, pass in ipairs(passes.list) do
      stages[#stages + 1] = { name = pass.name, ir = pass.run(stages[#stages].ir) }
    end
    local final = stages[#stages].ir
    local points = {}
    for p = 1, POINTS do
      local point = random.point()
      points[p] = point
      local want = reference(program, point)
      local got, bound = running.run(final, point)
      local before = { eval.run(stages[1].ir, point), eval.run(stages[1].ir, point, "float") }
      for o = 0, outs - 1 do
        local c = "out[" .. o .. "]"
        checks = checks + 1
        -- A bound that says nothing checks nothing: count those that leave less than half the digits,
        -- overflow included.
        local sharp = bound[c] <= 1e-8 * math.abs(got[c])
        if not sharp then loose = loose + 1 end
        if bound[c] < math.huge then
          local off = R.abs(R.fromdouble(got[c]) - want[c])
          if off > R.fromdouble(bound[c]) then wrong[#wrong + 1] = k .. " " .. c end
        end
        for s = 2, #stages do
          local after = { eval.run(stages[s].ir, point), eval.run(stages[s].ir, point, "float") }
          if not same(before[1][c], after[1][c]) or not same(before[2][c], after[2][c]) then
            moved[#moved + 1] = k .. " " .. c .. " by " .. stages[s].name
          end
        end
      end
    end
    programs[k] = { ir = final, outs = outs, points = points }
  end
  tap.is(table.concat(wrong, ", "), "", family.name .. ": ir = expression within its running error bound")
  tap.ok(loose * 20 < checks, family.name .. ": that bound is sharp at 19 points of 20",
    loose .. " of " .. checks .. " are loose")
  tap.is(table.concat(moved, ", "), "", family.name .. ": no pass moves a bit, in double and in float")

  for _, real in ipairs(family.floats and { "double", "float" } or { "double" }) do
    local printed = {}
    for _, p in ipairs(programs) do
      if real == "double" or fits_float(p.ir) then
        p.text = cprint.statements(p.ir, real, { type = "real" })
        printed[#printed + 1] = p
      end
    end
    tap.ok(#printed * 4 > PROGRAMS * 3, family.name .. ", " .. real .. ": the constants of 3 programs in 4 fit")
    local values = compiled.run(printed, real, random.inputs)
    local differ, n = {}, 0
    for k, p in ipairs(printed) do
      for q, point in ipairs(p.points) do
        local want = eval.run(p.ir, point, real)
        for o = 0, p.outs - 1 do
          n = n + 1
          if not same(want["out[" .. o .. "]"], values[n]) then differ[#differ + 1] = k .. "/" .. q .. "/" .. o end
        end
      end
    end
    tap.is(#values, n, family.name .. ", " .. real .. ": the compiled programs give all results")
    tap.is(table.concat(differ, ", "), "", family.name .. ", " .. real .. ": compiled C = ir to the bit")
  end
end

tap.done()
