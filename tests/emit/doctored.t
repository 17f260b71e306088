#!/usr/bin/env lua5.4
-- doctored.t - each check of an emitted self-test fails when what it checks is wrong.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The self-test is compiled against functions that do almost what the emitted ones do: an energy that is a thousandth
-- too large, a step of Euler's explicit method, which is of order 1, and so on.  Each slip must fail the check that is
-- named beside it; without a slip the self-test passes.  The slips are a thousandth, so that a check with a bound that
-- is far too wide is found as well.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()

local SLIPS = {
  { "init", "the scene's own parameters are accepted", "int slip_init(top_model *m, const top_real p[])",
    "return top_init(m, p) + 1;" },
  { "inertia", "tensor of inertia about the origin", "void slip_inertia(const top_model *m, top_real I[6])",
    "top_inertia(m, I); I[4] *= MORE;" },
  { "initial", "initial state", "void slip_initial(const top_model *m, top_real x[])",
    "top_initial(m, x); x[TOP_WZ] *= MORE;" },
  { "mass", "mass and centre of mass", "top_real slip_mass(const top_model *m, top_real com[3])",
    "return top_mass(m, com)*MORE;" },
  { "mass", "mass and centre of mass", "top_real slip_mass(const top_model *m, top_real com[3])",
    "top_real all = top_mass(m, com); com[2] *= MORE; return all;" },
  { "rhs", "rates of change at state %d", "void slip_rhs(const top_model *m, top_real t, const top_real x[], " ..
    "const top_real u[], top_real dx[])", "top_rhs(m, t, x, u, dx); dx[TOP_WY] *= MORE;" },
  { "energy", "energy at state %d", "top_real slip_energy(const top_model *m, const top_real x[])",
    "return top_energy(m, x)*MORE;" },
  { "momentum", "angular momentum at state %d", "void slip_momentum(const top_model *m, const top_real x[], " ..
    "top_real L[3])", "top_momentum(m, x, L); L[1] *= MORE;" },
  { "momentum_body", "angular momentum in body axes", "void slip_momentum_body(const top_model *m, " ..
    "const top_real x[], top_real L[3])", "top_momentum_body(m, x, L); L[2] *= MORE;" },
  { "step", "halving the step divides the error by about %d", "STEP", "euler(m, t, x, u, h);" },
  { "step", "the stepper goes where the rates of change lead", "STEP", "top_step(m, t, x, u, h*MORE);" },
  { "step", "the quaternion stays a unit quaternion", "STEP", "top_step(m, t, x, u, h); x[TOP_QW] *= ONE + h*SMALL;" },
  { "step", "energy is conserved without torque", "STEP", "top_step(m, t, x, u, h); x[TOP_WX] *= ONE + h*SMALL;" },
  { "step", "angular momentum is conserved without torque", "STEP",
    "top_step(m, t, x, u, h); x[TOP_QX] += h*SMALL; top_normalise(x);" },
  { "normalise", "a quaternion of length 13 is brought back to 1", "int slip_normalise(top_real x[])",
    "int status = top_normalise(x); x[TOP_QW] *= MORE; return status;" },
  { "normalise", "and a zero quaternion is refused", "int slip_normalise(top_real x[])",
    "top_normalise(x); return 0;" },
}

local STEP = "void slip_step(const top_model *m, top_real t, top_real x[], const top_real u[], top_real h)"
local EULER = "static " .. STEP:gsub("slip_step", "euler") .. [[

{
  top_real dx[TOP_NX];
  int k;
  top_rhs(m, t, x, u, dx);
  for (k = 0; k < TOP_NX; k++) x[k] += h*dx[k];
  top_normalise(x);
}
]]

-- The names of the checks that fail.
local function failing(at)
  local failed = {}
  for line in (program.read(at .. "/log") or ""):gmatch "[^\n]+" do
    local name = line:match "^not ok %d+ %- top: (.*)$"
    if name then failed[#failed + 1] = name end
  end
  return failed
end

local function check(at, real, order, names)
  local compile = string.format("cd %s && ${CC:-cc} -std=c99 -O0 -include slip.h -o t top_test.c top.o -lm && " ..
    "./t >log", at)
  local number = real == "float" and "%sF" or "%s"
  for n, slip in ipairs(SLIPS) do
    local name = slip[2]:gsub("%%d", tostring(slip[1] == "step" and order or 2))
    if names[name] then
      local head = slip[3]:gsub("^STEP$", STEP)
      program.write(at .. "/slip.h", table.concat { '#include "top.h"\n',
        "#define ONE ", number:format "1.0", "\n#define MORE ", number:format "1.001", "\n#define SMALL ",
        number:format "0.01", "\n", EULER, "static ", head, "\n{ ", slip[4], " }\n",
        "#define top_", slip[1], " slip_", slip[1], "\n" })
      local status, found = program.shell(compile), false
      local failed = failing(at)
      for _, f in ipairs(failed) do found = found or f == name end
      tap.ok(status == 1 and found, string.format("order %d, %s, slip %d: '%s' fails", order, real, n, name),
        "what failed: " .. table.concat(failed, "; "))
      names[name] = "failed"
    end
  end
end

program.write(dir .. "/top.lua", [[
return scene { name = "top", body = solid.box { mass = 2, x = 1, y = 2, z = 3 }, origin = "corner",
  initial = { omega = { 1, 2, 3 } }, time = { step = 0.01 } }
]])
local cases = { { "rk4", "double", 16 }, { "split2", "double", 4 } }
if not tier.quick then cases[3] = { "rk4", "float", 16 } end
for _, case in ipairs(cases) do
  local method, real, order = table.unpack(case)
  local at = dir .. "/" .. method .. real
  local status = program.shell(string.format("%s gen --layout single --method %s --real %s %s/top.lua -o %s " ..
    ">/dev/null && cd %s && ${CC:-cc} -std=c99 -O0 -c top.c && ${CC:-cc} -std=c99 -O0 -o t top_test.c top.o -lm && " ..
    "./t >log", binary, method, real, dir, at, at))
  if tap.is(status, 0, method .. ", " .. real .. ": without a slip the self-test passes") then
    local names = {}
    for name in program.read(at .. "/log"):gmatch "\nok %d+ %- top: ([^\n]*)" do names[name] = "passed" end
    check(at, real, order, names)
    local left = {}
    for name, fate in pairs(names) do -- any order: sorted
      if fate == "passed" and not name:find "state [13]$" then left[#left + 1] = name end
    end
    table.sort(left)
    tap.is(table.concat(left, "; "), "", method .. ", " .. real .. ": no check is left for which there is no slip")
  end
end
program.finish()
tap.done()
