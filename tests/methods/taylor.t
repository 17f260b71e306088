#!/usr/bin/env lua5.4
-- taylor.t - the Taylor series stepper: every recurrence against derivatives, the stepper against rk4 and the library.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Coefficients: x' = f(x, t) is differentiated symbolically, x^(n+1) = (d/dt + f.grad) x^(n), evaluated with 200 bits
-- and divided by n!; the emitted C (printed, compiled) must agree.  Bound: term n is a sum of at most n products whose
-- factors carry their own errors, so 8 n units of the last place of the largest coefficient that the same recurrence
-- makes.
-- The quick tier takes a part of its cases.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"
local program = require "tests.cli.program"
local compiled = require "tests.ir.compiled"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local number = require "generator.emit.number"
local taylor = require "generator.methods.taylor"
local emit = require "generator.emit.taylor"
local series = require "generator.methods.series"
local fork = require("generator.dynamics.equations").fork

local ORDER, BITS = 9, 200
local x, y, t, k = expr.sym("one", 8), expr.sym("two", 8), expr.sym("t", 8), expr.sym("kk", 3)
local function call(fn, e) return expr.call(fn, e) end

-- x' and y' in x, y, t and the constant kk; values at the start.
local systems = {
  { "products", x * y - k, x ^ 2 + 2 * y * t, "3/4", "-5/8" },
  { "powers up to the fourth", x ^ 3 - y, x * y ^ 2 + x ^ 4 / 8, "1/2", "-3/4" },
  { "a power of higher exponent", x ^ 7 * y, -x, "7/8", "1/2" },
  { "quotients", y / (1 + x ^ 2), x * t / y, "1/2", "5/4" },
  { "a reciprocal", 1 / (x + 2), 1 / (x * y), "1/2", "3/4" },
  { "roots", call("abs", k) * (x ^ 2 + y ^ 2) ^ R.new(1, 2), -x / (1 + y ^ 2) ^ R.new(3, 2), "1/2", "-3/4" },
  { "a root of a negative multiple", (-k * x) ^ R.new(1, 2), -y, "-1/2", "1/4" },
  { "sine and cosine", call("sin", x * y), k * call("cos", 3 * x) + call("sin", 3 * x), "3/4", "1/2" },
  { "sine and cosine of time", call("sin", k * t + 1), x * call("cos", t), "1/2", "1/2" },
  { "hyperbolic sine and cosine", call("sinh", x) - y, call("cosh", x - y) / 4, "1/2", "3/4" },
  { "exponential", call("exp", -x * y), call("exp", 2 * t) * y, "1/2", "3/4" },
  { "logarithm", call("log", 2 + x ^ 2), call("log", x) * y, "3/2", "1/2" },
  { "tangent", call("tan", x), call("tan", k * y - x) / 2, "1/2", "3/8" },
  { "hyperbolic tangent", -call("tanh", 2 * x), call("tanh", x + y) + x, "1/2", "3/8" },
  { "arc tangent", call("atan", x + y), -call("atan", 2 * x), "3/4", "1/2" },
  { "arc sine and cosine", call("asin", x / 2), call("acos", y) * x, "3/4", "1/2" },
  { "dry friction", -x / (x ^ 2 + k ^ 2) ^ R.new(1, 2), -x * y / (1 + call("exp", -y)), "3/4", "1/2" },
  { "a rate that is constant", expr.zero, k * x * y, "3/4", "1/2" },
}

local kk = "5/8"

-- Terms 0 .. ORDER of x and y.
local function derivatives(s)
  local env = { one = R.lift(s[4]), two = R.lift(s[5]), t = R.new(1, 4), kk = R.lift(kk) }
  local out = { {}, {} }
  for i, start in ipairs { x, y } do
    local e, factorial = start, R.one
    for n = 0, ORDER do
      if n > 0 then
        factorial = factorial * R.new(n)
        e = calculus.diff(e, x) * s[2] + calculus.diff(e, y) * s[3] + calculus.diff(e, t)
      end
      out[i][n] = R.todouble(evaluate.precise(e, env, BITS) / factorial)
    end
  end
  return out
end

local names = { { name = "one", sym = x, about = "first" }, { name = "two", sym = y, about = "second" } }

-- The equations as dynamics would give them.
local function equations(s)
  return { groups = { { defs = {}, outs = { { state = "one", expr = s[2] }, { state = "two", expr = s[3] } } } },
    model = { states = names, has = {}, structure = {} } }
end

local function literal(q) return number.text(R.lift(q), "double") end

-- The emitted series function of a system as C text.
local function printed(s, name)
  local ctx = { name = name, upper = string.upper(name), real = "double", helpers = {}, inputs = {}, states = names,
    members = { { name = "kk", sym = k } } }
  local made, why = taylor.program(equations(s), { order = ORDER })
  if not made then return nil, why end
  local kit = { ctx = ctx, compensated = false, planning = false, base = { name = name, upper = ctx.upper,
    has_inputs = false, zero = "0.0", one = "1.0", half = "0.5", two = "2.0", four = "4.0", quarter = "0.25",
    eight = "8.0", n = { [64] = "64.0" }, fabs = "fabs", sqrt = "sqrt", sin = "sin", cos = "cos" },
    templates = setmetatable({}, { __index = function(_, path) return scene.slurp(path) end }) }
  local header, sources = emit.render({ program = made, first = false, has_knots = false }, kit)
  local lines = { "typedef double " .. name .. "_real; typedef struct { double kk; } " .. name .. "_model;",
    "enum { " .. ctx.upper .. "_ONE, " .. ctx.upper .. "_TWO, " .. ctx.upper .. "_NX };",
    -- for what leaves a root's zero
    (("void RHS; void RHS { (void)m; (void)t; (void)u; dx[0] = x[0]; dx[1] = x[1]; }"):gsub("RHS", name ..
      "_rhs(const " .. name .. "_model *m, double t, const double x[], const double u[], double dx[])")),
    header, table.concat(sources, "\n") }
  return table.concat(lines, "\n"), made
end

if tier.quick then systems = { systems[1], systems[6], systems[#systems] } end
do
  local text, main = { "#include <math.h>", "#include <stdint.h>", "#include <stdio.h>" }, {}
  for i, s in ipairs(systems) do
    local name = "s" .. i
    local c, made = printed(s, name)
    text[#text + 1] = assert(c, made)
    main[#main + 1] = string.format("{ %s_model m = {%s}; double x[2] = {%s, %s}, c[%s_ORDER + 1][%s_ROW]; int n;",
      name, literal(kk), literal(s[4]), literal(s[5]), string.upper(name), string.upper(name))
    main[#main + 1] = string.format("%s_taylor_series(&m, 0.25, x, 0, c); for (n = 0; n <= %s_ORDER; n++) {", name,
      string.upper(name))
    s.moving = {}
    for column, state in ipairs(made.states) do
      s.moving[column] = state.name
      main[#main + 1] = string.format("printf(\"%%a\\n\", c[n][%d]);", column - 1)
    end
    main[#main + 1] = "} }"
  end
  text[#text + 1] = "int main(void) {" .. table.concat(main, "\n") .. " return 0; }"
  local got, at = compiled.numbers(table.concat(text, "\n")), 0
  for _, s in ipairs(systems) do
    local want, worst = derivatives(s), 0.0
    for n = 0, ORDER do
      for _, state in ipairs(s.moving) do
        at = at + 1
        local list, size = want[state == "one" and 1 or 2], 0.0
        for i = 0, n do size = math.max(size, math.abs(want[1][i]), math.abs(want[2][i])) end
        worst = math.max(worst, math.abs(got[at] - list[n]) / (8 * (n + 1) * size * 2.0 ^ -52))
      end
    end
    tap.ok(worst <= 1, s[1] .. ": terms 0 to " .. ORDER .. " are the derivatives",
      string.format("%.2g of the bound", worst))
  end
  tap.is(#systems[#systems].moving, 1, "a state with rate 0 has no series")
end

-- A function without a recurrence is named.
do
  local made, why = taylor.program(equations { "", call("atan2", x) and expr.call("atan2", y, x), y }, {})
  tap.ok(made == nil and string.find(why, "atan2", 1, true), "a function without recurrence is refused by its name")
  tap.is(type(series.missing), "table", "by a value of its own")
end

-- Lanes that scenes need: fewer is faster.
do
  local function lanes(path, order)
    local job = scene.file(path)
    return assert(taylor.program(fork(job.equations), { order = order }))
  end
  local free = lanes "bodies/brick_centroid.lua"
  tap.is(#free.lanes, 11, "free asymmetric top: 8 products of the attitude in a turning frame, 3 of the rates")
  tap.is(free.order, 20, "the order is 20 unless another is asked for")
  local top = lanes "bodies/symmetric_top.lua"
  tap.is(#top.lanes, 8, "free symmetric top: its rates are linear, 8 products of the attitude are left")
  tap.ok(top.axis == 3, "and the series run in a frame that turns about its axis")
  tap.ok(lanes("bodies/nodding_top.lua").top ~= nil, "a heavy symmetric top has Lame's equation")
  tap.ok(lanes("bodies/damped_brick.lua").top == nil and top.top == nil, "what is no heavy symmetric top has not")
end

-- A quantity of the equations of which one component is needed: the others are not made, nor is what they would read.
do
  local job = assert(scene.read [[
local r = param("r", 1, "m")
return scene { name = "b", origin = "centroid",
  body = solid.cylinder { r = r, h = 2, mass = 3 }:turned { axis = {1, 2, 0}, angle = 0.7 },
  effects = { effect.custom { torque = function(s) return { 0, 0, -quantity(0.05, "rad/s")*s.L[3] } end } } }]])
  local made, files = pcall(function() return scene.files(scene.plan(job, { methods = { "taylor" } })) end)
  tap.ok(made and files["b.c"]:find("b_step", 1, true),
    "one component of the angular momentum in the torque", tostring(files))
end

-- The emitted stepper as a whole: order, reversal, dense output, adaptive run, events of failure.
local dir = program.directory()
program.write(dir .. "/top.lua", [[
local I1, I3, c = param("I1", 7.5e-4, "kg m^2"), param("I3", 5.4e-4, "kg m^2"), param("c", 0.03, "m")
return scene { name = "top", origin = {0, 0, 0},
  body = tensor { mass = 0.4, com = {0, 0, c}, xx = I1, yy = I1, zz = I3, about = "origin" },
  effects = { effect.gravity { g = 9.81 } },
  initial = { omega = {0.4, -0.3, 60}, attitude = {0.9689124217106447, 0.24740395925452294, 0, 0} } }]])
local binary = program.quick()
local WARN = "-std=c99 -O2 -ffp-contract=off -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"

for _, case in ipairs(tier.every(2, { { "--order 12", "double" }, { "--order 8 --real float", "float" } })) do
  local out = dir .. "/" .. case[2]
  local status = program.shell(string.format("POLHODE_SOURCE=. %s gen --layout single --method taylor,rk4 %s -o " ..
    "%s %s/top.lua", binary,
    case[1], out, dir))
  tap.is(status, 0, case[2] .. ": gen --method taylor,rk4 " .. case[1])
  program.write(out .. "/main.c", [[
#include "top.h"
#include <math.h>
#include <stdio.h>
static double far(const top_real a[], const top_real b[])
{
  double d = 0;
  int i;

  for (i = 0; i < TOP_NX; i++) d = fmax(d, fabs((double)a[i] - (double)b[i])/(i < 4 ? 1 : 60));
  return d;
}
int main(void)
{
  top_model m;
  top_real x0[TOP_NX], x[TOP_NX], y[TOP_NX], c[TOP_ORDER + 1][TOP_ROW], t;
  int i, n;

  top_init(&m, 0);
  top_initial(&m, x0);
  for (n = 1; n <= 4; n *= 2) { /* one step of 0.1 s by 1, 2, 4 steps against 64 */
    for (i = 0; i < TOP_NX; i++) x[i] = y[i] = x0[i];
    for (i = 0; i < n; i++) top_taylor_step(&m, 0, x, 0, (top_real)0.1/(top_real)n);
    for (i = 0; i < 64; i++) top_taylor_step(&m, 0, y, 0, (top_real)0.1/64);
    printf("%a\n", far(x, y));
  }
  for (i = 0; i < 4096; i++) top_rk4_step(&m, 0, x0, 0, (top_real)0.1/4096);
  printf("%a\n", far(x0, y)); /* the same motion by rk4 */
  top_initial(&m, x0);
  for (i = 0; i < TOP_NX; i++) x[i] = x0[i];
  printf("%d\n", top_taylor_run(&m, 0, x, 0, 5, (top_real)EPS, 100000));
  printf("%d\n", top_taylor_run(&m, 5, x, 0, 0, (top_real)EPS, 100000));
  printf("%a\n", far(x, x0)); /* there and back */
  printf("%a\n", fabs((double)(x[0]*x[0] + x[1]*x[1] + x[2]*x[2] + x[3]*x[3]) - 1));
  top_taylor_series(&m, 0, x0, 0, c);
  for (i = 0; i < TOP_NX; i++) x[i] = y[i] = x0[i];
  top_taylor_at(&m, c, (top_real)0.01, x);
  top_taylor_step(&m, 0, y, 0, (top_real)0.01);
  printf("%a\n", far(x, y)); /* dense output is the step */
  top_taylor_at(&m, c, 0, x);
  printf("%a\n", far(x, x0));
  for (i = 0; i < TOP_NX; i++) x[i] = x0[i];
  t = top_taylor_adapt(&m, 0, x, 0, -1, (top_real)EPS);
  printf("%d\n", t < 0 && t > -1);
  for (i = 0; i < TOP_NX; i++) x[i] = x0[i];
  printf("%d\n", top_taylor_run(&m, 0, x, 0, 5, (top_real)EPS, 3)); /* too few steps */
  printf("%d\n", top_taylor_run(&m, 1, x, 0, 1, (top_real)EPS, 3));
  x[TOP_WX] = (top_real)HUGE_VAL;
  printf("%d\n", top_taylor_run(&m, 0, x, 0, 5, (top_real)EPS, 100));
  return 0;
}
]])
  local double = case[2] == "double"
  local eps = double and 2.0 ^ -52 or 2.0 ^ -23
  local command = "gcc %s -DEPS=%g -I%s -o %s/main %s/main.c %s/top.c -lm 2>&1 && %s/main > %s/log"
  status = program.shell(string.format(command, WARN, eps, out, out, out, out, out, out))
  tap.is(status, 0, case[2] .. ": compiles without a warning and runs")
  local v = {}
  for word in string.gmatch(program.read(out .. "/log") or "", "%S+") do v[#v + 1] = tonumber(word) end
  -- halving a step divides its error by 2^12 (2^8), while that stands above the rounding of 64 steps
  local order = double and 12 or 8
  local floor = 64 * eps
  tap.ok(v[1] > 100 * floor and v[2] <= v[1] / 2 ^ order * 4 + floor and v[3] <= v[2] / 2 ^ order * 4 + floor,
    case[2] .. ": the error falls with the order", string.format("%.3g %.3g %.3g", v[1], v[2], v[3]))
  -- rk4's own error at this step: (30 rad/s 2.4e-5 s)^4 over 3 rad, below the rounding of 4096 steps
  tap.ok(v[4] <= 4096 * eps, case[2] .. ": rk4 finds the same motion", string.format("%.3g", v[4]))
  tap.ok(v[5] > 0 and v[6] > 0, case[2] .. ": adaptive runs arrive, forwards and backwards", v[5] .. ", " .. v[6])
  -- some 300 steps each way, each with errors of a few units
  tap.ok(v[7] <= (v[5] + v[6]) * 16 * eps, case[2] .. ": there and back again", string.format("%.3g", v[7]))
  tap.ok(v[8] <= 4 * eps, case[2] .. ": |q| = 1 after the run", string.format("%.3g", v[8]))
  tap.ok(v[9] <= 4 * eps and v[10] == 0, case[2] .. ": dense output", string.format("%.3g %.3g", v[9], v[10]))
  tap.is(v[11], 1, case[2] .. ": a step backwards, shorter than allowed")
  tap.is(v[12], -1, case[2] .. ": too few steps are told")
  tap.is(v[13], 0, case[2] .. ": no time, no step")
  tap.is(v[14], -1, case[2] .. ": an infinite state is told")
end

-- The turning frames, the order from the tolerance and the vector text: free bodies against their closed form.
program.write(dir .. "/free.lua", [[
return scene { name = "free", body = tensor { mass = 1, xx = param("A", 2, "kg m^2"), yy = param("B", 3, "kg m^2"),
  zz = param("C", 4, "kg m^2") }, initial = { omega = {0.4, 3, 0.5} } }]])
program.write(dir .. "/free.c", [[
#include "free.h"
#include <math.h>
#include <stdio.h>
int main(void)
{
  static const double moments[][3] = {{2, 3, 4}, {4, 2, 3}, {3, 4, 2}, {2, 2, 3}, {3, 3, 3}, {1, 2, 3}, {2, 3, 3}};
  static const double rates[][3] = {{0.4, 3, 0.5}, {0, 0, 0}, {0, 3, 0}, {1e-9, 3, 0}, {0, 0, -3}, {3, 1e-3, 1}};
  double worst = 0, miss = 0;
  unsigned int i, j;
  int k, e, more = 0, before = 0;

  for (i = 0; i < sizeof moments/sizeof moments[0]; i++)
    for (j = 0; j < sizeof rates/sizeof rates[0]; j++) {
      double x0[FREE_NX] = {0.5, 0.5, -0.1, 0.7}, x[FREE_NX], y[FREE_NX];
      free_model m;
      free_orbit o;

      if (free_init(&m, moments[i])) return 1;
      for (k = 0; k < 3; k++) x0[4 + k] = rates[j][k];
      if (free_solve(&o, &m, x0)) return 1;
      free_at(&o, j == 3 ? 4 : 20, y);
      for (e = -3; e >= -15; e -= 3) {
        double d = 0;

        for (k = 0; k < FREE_NX; k++) x[k] = x0[k];
        if (free_taylor_run(&m, 0, x, 0, j == 3 ? 4 : 20, pow(10, e), 4000) < 0) return 2;
        for (k = 0; k < FREE_NX; k++) d = fmax(d, fabs(x[k] - y[k])/(k < 4 ? 1 : 3));
        if (j == 3) d /= 1000; /* growth about a middle axis: exp(4 s 3/s sqrt(1/3)) */
        if (e == -15) worst = fmax(worst, d);
        else miss = fmax(miss, d/pow(10, e));
      }
    }
  for (e = -3; e >= -12; e -= 3) { /* a tolerance 1000 times finer by far fewer than 1000^(1/4) times the steps */
    double x[FREE_NX] = {1, 0, 0, 0, 0.4, 3, 0.5};
    free_model m;

    free_init(&m, 0);
    k = free_taylor_run(&m, 0, x, 0, 20, pow(10, e), 4000);
    if (before && k > before*5/2) more++;
    before = k;
  }
  printf("%a %a %d\n", worst, miss, more);
  return 0;
}
]])
tap.is(program.shell(string.format(
  "POLHODE_SOURCE=. %s gen --layout single --method taylor,exact --order 24 -o %s/free %s/free.lua", binary,
  dir, dir)), 0, "gen of a free body")
for _, build in ipairs(tier.every(2, { WARN, "-O2 -march=native -DFREE_VECTOR -Wall -Werror" })) do
  local status = program.shell(string.format("gcc %s -I%s/free -o %s/free/main %s/free.c %s/free/free.c -lm 2>&1" ..
    " && %s/free/main > %s/free/log", build, dir, dir, dir, dir, dir, dir))
  local v = {}
  for word in string.gmatch(program.read(dir .. "/free/log") or "", "%S+") do v[#v + 1] = tonumber(word) end
  local text = build == WARN and "portable" or "vectors"
  tap.is(status, 0, text .. ": free bodies of all kinds and states arrive")
  -- some 200 steps, an error of a few units each, which grows with the angle w t = 60
  tap.ok(v[1] and v[1] <= 60 * 200 * 2.0 ^ -52, text .. ": the turning frame gives the closed form's state",
    string.format("%.3g", v[1] or 0))
  -- truncation is at most the tolerance of the whole; differences grow at most like the angle, 60
  tap.ok(v[2] and v[2] <= 60, text .. ": the error follows the tolerance", string.format("%.3g", v[2] or 0))
  tap.is(v[3], 0, text .. ": the order rises with the digits asked for")
end

-- By the program: the emitted stepper against the library.
do
  local function run(more, name)
    local log = dir .. "/csv"
    local command = "POLHODE_SOURCE=. %s run %s/%s.lua --at 2 %s > %s 2>&1"
    local status = program.shell(string.format(command, binary, dir, name or "top", more, log))
    local row, text = {}, program.read(log)
    for word in string.gmatch(string.match(text, "\n([^\n]*)") or "", "[^,]+") do row[#row + 1] = tonumber(word) end
    return row, status, text
  end
  local want = run ""
  local got = run "--engine generated --method taylor --tolerance 1e-13 --order 16"
  local d = 0.0
  for i = 1, 8 do d = math.max(d, math.abs(got[i] - want[i])) end
  tap.ok(#got == 12 and d <= 1e-10, "run --method taylor agrees with the library", string.format("%.3g", d))
  program.write(dir .. "/frame.lua", [[
return scene { name = "frame", body = tensor { mass = 1, xx = 2, yy = 3, zz = 4 }, effects = {
  effect.rotating_frame { rate = {0.25, 0, 0.5} }, effect.translation {} }, initial = { omega = { 1, 2, 0.5 } } }]])
  want, got, d = run("", "frame"), run("--engine generated --method taylor --tolerance 1e-14", "frame"), 0.0
  for i = 1, 8 do d = math.max(d, math.abs(got[i] - want[i])) end
  tap.ok(#got > 8 and d <= 1e-12, "and so does a free body seen from a turning frame", string.format("%.3g", d))
  local _, status, text = run "--engine generated --method taylor --order 3"
  tap.ok(status == 2 and string.find(text, "--order must be a whole number from 4 to 30, got 3", 1, true),
    "an order out of range is refused")
  for _, how in ipairs(tier.every(3, { "--engine generated --method rk4", "--engine generated", "" })) do
    _, status, text = run(how .. " --order 8")
    tap.ok(status == 2 and string.find(text, "--order: ", 1, true), "so is one that nothing has: run " .. how, text)
  end
  for _, how in ipairs { "", "--method rk4,semi" } do
    status = program.shell(string.format("%s gen --order 8 %s -o %s/none %s/top.lua 2>%s/err", binary, how, dir, dir,
      dir))
    text = program.read(dir .. "/err")
    tap.ok(status == 2 and string.find(text, "gen: --order: of the methods taylor alone", 1, true), "and gen " .. how,
      text)
  end
  _, status, text = run "--engine generated --method rk4 --tolerance 1e-9"
  tap.ok(status == 2 and string.find(text, "fixed step", 1, true), "a tolerance for a fixed step is refused")
end

tap.done(program.finish())
