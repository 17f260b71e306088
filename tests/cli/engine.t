#!/usr/bin/env lua5.4
-- engine.t - the library's motions as the generator sees them, and plugins.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The library's own numbers are tested in tests/runtime.  Here: that every effect and every option of a scene reach it,
-- that refusals come back as messages, and that a plugin's functions are called with what was given.  Oracles: textbook
-- formulas worked out below, and a plugin written by hand.  Bodies: engine_mass.t.

local tap = require "tests.tap"
local program = require "tests.cli.program"
local engine = require "tests.cli.engine"

local lua, gives, says, dir = engine.lua, engine.gives, engine.says, engine.dir

-- a box of mass M: M (y^2 + z^2) / 12 and cyclic
local M, x, y, z = 2.4, 0.2, 0.1, 0.05
local Ixx, Iyy, Izz = M * (y * y + z * z) / 12, M * (x * x + z * z) / 12, M * (x * x + y * y) / 12

-- ---- run ----

gives("the first row is the initial state with its energy and momentum", [[
  say(row(host.run(scene(box), { times = { 0 } })[1]))]], { 0, 1, 0, 0, 0, 0.1, 6, 0.2,
  (Ixx * 0.01 + Iyy * 36 + Izz * 0.04) / 2, Ixx * 0.1, Iyy * 6, Izz * 0.2 })
gives("energy and momentum of a free body are the same 5 s later", [[
  local r = host.run(scene(box), { times = { 5 } })[1]
  say(row { r[9], r[10], r[11], r[12] })]],
  { (Ixx * 0.01 + Iyy * 36 + Izz * 0.04) / 2, Ixx * 0.1, Iyy * 6, Izz * 0.2 }, 1e-14)
gives("a sphere turns at a constant rate: half a turn in 1 s", [[
  local r = host.run(scene({ shape = "solid.sphere", mass = 1, r = 1 }, nil, { w = { 0, 0, math.pi } }),
    { times = { 1 } })[1]
  say(row { r[2], r[5], r[8] })]], { 0, 1, math.pi }, 1e-14)
gives("isotropic damping: w falls as exp(-rate t)", [[
  local r = host.run(scene({ shape = "solid.sphere", mass = 1, r = 1 }, { { kind = "damping", rate = 0.5 } },
    { w = { 0, 0, 2 } }), { times = { 2 } })[1]
  say(row { r[8] })]], { 2 * math.exp(-1) }, 1e-14)
gives("a matrix of damping: c/I in the exponent", [[
  local r = host.run(scene({ shape = "solid.sphere", mass = 1, r = 1 },
    { { kind = "damping", C = { 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1 } },
      { kind = "damping", C = { 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1 } } },
    { w = { 0, 0, 2 } }), { times = { 2 } })[1]
  say(row { r[8] })]], { 2 * math.exp(-0.2 / 0.4 * 2) }, 1e-14)
gives("constant torques in body and inertial axes add up", [[
  local r = host.run(scene({ shape = "solid.sphere", mass = 1, r = 1 },
    { { kind = "torque", body = { 0, 0, 0.4 } }, { kind = "torque", inertial = { 0, 0, 0.4 } } },
    { w = { 0, 0, 0 } }), { times = { 3 } })[1]
  say(row { r[8] })]], { 2 * 3 }, 1e-14)
gives("control acts with its effect, and only then", [[
  local sphere = { shape = "solid.sphere", mass = 1, r = 1 }
  local on = host.run(scene(sphere, { { kind = "control" } }, { w = { 0, 0, 0 } }),
    { times = { 1 }, u = { 0, 0, 0.4 } })[1]
  local off = host.run(scene(sphere, {}, { w = { 0, 0, 0 } }), { times = { 1 }, u = { 0, 0, 0.4 } })[1]
  say(row { on[8], off[8] })]], { 1, 0 }, 1e-14)
gives("a torque by tables: their integrals over 2/5", [[
  local function ramp(slope) return { rows = { 0, 0, 1, slope, 2, 2 * slope } } end
  local r = host.run(scene({ shape = "solid.sphere", mass = 1, r = 1 },
    { { kind = "torque", varying = { ramp(0.4), ramp(1.2), ramp(2.0) } } }, { w = { 0, 0, 0 } }), { times = { 2 } })[1]
  say(row { r[6], r[7], r[8] })]], { 2, 6, 10 }, 1e-13)
-- Half a megabyte each, so that Lua's collector runs between them, which may not take what the rates need.
gives("a table outlives the reading of the next", [[
  local function ramp(slope)
    local rows = {}
    for i = 0, 32767 do
      rows[2 * i + 1], rows[2 * i + 2] = i / 16384, slope * i / 16384
    end
    return { rows = rows }
  end
  local effect = { kind = "torque", varying = { ramp(0.4), ramp(1.2), ramp(2.0) } }
  collectgarbage("setpause", 100)
  local library = host.rates(scene({ shape = "solid.sphere", mass = 1, r = 1 }, { effect }))
  local dx = library:rates(1.5, { 1, 0, 0, 0, 0, 0, 0 })
  say(row { dx[5], dx[6], dx[7] })]], { 1.5, 4.5, 7.5 }, 1e-13)
-- a pendulum released at rest, horizontal: energy -M g l cos(angle), here 0
gives("gravity acts at the centre of mass, and twice when it is there twice", [[
  local rod = { shape = "points", list = { { 1, 0, 0, 0 }, { 1, 0, 0, -2 }, { 1, 0.1, 0, -1 }, { 1, -0.1, 0, -1 } } }
  local g = { kind = "gravity", g = 4, direction = { 0, 0, -2 } }
  for _, effects in ipairs { { g }, { g, g } } do
    local r = host.run(scene(rod, effects, { w = { 0, 0, 0 }, q = { 1, 1, 0, 0 } }), { times = { 0 } })[1]
    local dx = host.rates(scene(rod, effects)):rates(0, { math.sqrt(0.5), math.sqrt(0.5), 0, 0, 0, 0, 0 })
    say(row { r[9] + 1, dx[5] })
  end]], { 1, -4 * 4 / (4 + 1 + 1), 1, -2 * 4 * 4 / (4 + 1 + 1) }, 1e-14)
for _, method in ipairs { "adaptive", "taylor", "rk4", "gsl-rk4", "rkf45", "rk8pd", "implicit", "exact" } do
  -- the error of rk4 at h = 1/1000 is of order h^4 w^5 t, a few 1e-9
  gives(method .. " agrees with the reference", string.format([[
    local o = { method = %q, times = { 1 } }
    if string.find(o.method, "rk4") then o.step = 0.001 end
    local a, b = assert(host.run(scene(box), o))[1], host.run(scene(box), { times = { 1 } })[1]
    for i = 2, 8 do a[i] = a[i] - b[i] + 1 end
    say(row { table.unpack(a, 2, 8) })]], method), { 1, 1, 1, 1, 1, 1, 1 }, 1e-7)
end
gives("rows come at the times asked for, backwards too", [[
  local r = host.run(scene(box), { times = { 1, 0.5, 0 }, t0 = 0 })
  say(row { r[1][1], r[2][1], r[3][1], r[3][7] })]], { 1, 0.5, 0, 6 }, 1e-13)
-- Steps of rk4 between rows a step apart are no halves, though the distance of two rows is rounded: with halves the
-- difference would be most of the error of the steps, 1e-3.
gives("rows at every step leave the steps as they are", [[
  local times = {}
  for i = 1, 200 do times[i] = i * 0.05 end
  local a = assert(host.run(scene(box), { times = times, method = "rk4", step = 0.05 }))[200]
  local b = host.run(scene(box), { times = { 10 }, method = "rk4", step = 0.05 })[1]
  for i = 2, 8 do a[i] = a[i] - b[i] + 1 end
  say(row { table.unpack(a, 2, 8) })]], { 1, 1, 1, 1, 1, 1, 1 }, 1e-9)
tap.like(lua("say(host.run(scene(box), { times = { 1 }, method = 'magic' }))"), "nil at t = 0.0 s: ",
  "an unknown method is refused")
tap.like(lua("say(host.run(scene(box, { { kind = 'control' } }), { times = { 1 }, method = 'exact' }))"),
  "nil at t = 0.0 s: ", "the exact method refuses effects")
tap.like(lua("say(host.run(scene(box), { times = { 1 }, method = 'rk4', step = -1 }))"), "nil at t = 0.0 s: ",
  "a negative step is refused")
tap.like(lua("say(host.run(scene(box), { times = { 0 / 0 } }))"), "nil at t = ", "a time that is no number is refused")

-- ---- rates ----

gives("rates: Euler's equations and q' = q w / 2, with the largest term of each", [[
  local dx, scale = host.rates(scene(box)):rates(0, { 1, 0, 0, 0, 0.1, 6, 0.2 })
  say(row(dx)) say(row(scale))]],
  { 0, 0.05, 3, 0.1, (Iyy - Izz) * 6 * 0.2 / Ixx, (Izz - Ixx) * 0.2 * 0.1 / Iyy, (Ixx - Iyy) * 0.1 * 6 / Izz,
    0, 0.05, 3, 0.1, Izz * 6 * 0.2 / Ixx, Izz * 0.2 * 0.1 / Iyy, Iyy * 0.1 * 6 / Izz })
-- by hand: 4 k, each of the quaternion's products being at most 1; |m| |B|; c |w| w_i; T w_i/hypot(|w|, s); over 2/5
gives("the largest terms of a spring, a magnet, drag and friction", [[
  for _, e in ipairs {
    { kind = "spring", rest = { 1, 0, 0, 0 }, stiffness = { 100, 50, 20 } },
    { kind = "spring", rest = { 1, 0, 0, 0 }, stiffness = { 20, 50, 100 } },
    { kind = "magnetic", moment = { 0, 0, 100 }, field = { 3, 4, 0 }, rate = 0, rotating = false },
    { kind = "drag", c = 100 }, { kind = "friction", torque = 90, smoothing = 2 } } do
    local sphere = { shape = "solid.sphere", mass = 1, r = 1 }
    local dx, scale = host.rates(scene(sphere, { e })):rates(0, { 0.6, 0, 0, 0.8, 2, 1, 0 })
    say(row { scale[5], scale[6] })
  end]], { 1000, 1000, 1000, 1000, 1250, 1250, 500 * math.sqrt(5), 250 * math.sqrt(5), 150, 75 })
-- I = 2/5, so that |L| = 2/5 sqrt 5 and the loss, k L x (L x w), is at most k |L|^2 |w|; half the stiffness times 2^2
gives("the largest terms of a dissipation and of a restoring force's energy", [[
  local sphere = { shape = "solid.sphere", mass = 1, r = 1 }
  local dx, scale = host.rates(scene(sphere, { { kind = "dissipation", k = 100 } })):rates(0, { 1, 0, 0, 0, 2, 1, 0 })
  local moved = { kind = "translation", gravity = { 0, 0, 0 }, stiffness = { 100, 0, 0 }, linear = 0, drag = 0 }
  local E, most = host.rates(scene(sphere, { moved })):energy { 1, 0, 0, 0, 0, 0, 0.1, 2, 0, 0, 0, 0, 0 }
  say(row { scale[5], scale[6], E, most })]], { 200 * math.sqrt(5), 200 * math.sqrt(5), 200.002, 200 })
gives("a rod's own axis has no rate and no scale", [[
  local r = host.rates(scene { shape = "rod.straight", mass = 1, length = 1 })
  local dx, scale = r:rates(0, { 1, 0, 0, 0, 1, 2, 3 })
  say(row { dx[7], scale[7] })]], { 0, 0 })
gives("energy and momentum with their scales", [[
  local r = host.rates(scene(box))
  local E, scale = r:energy { 1, 0, 0, 0, 0, 6, 0 }
  local L, most = r:momentum { 1, 0, 0, 0, 0, 6, 0 }
  say(row { E, scale }) say(row(L)) say(row { most })]], { Iyy * 18, Iyy * 18, 0, Iyy * 6, 0, Iyy * 6 })

-- ---- plugins ----

-- x' = -p x + u in one state, with every function of the table
program.write(dir .. "/decay.c", [[
#include "plugin.h"
#include <math.h>
#include <stddef.h>
struct model { double rate; };
struct orbit { double rate, x0; };
static int init(void *m, const double *p) {
  double rate = p ? p[0] : 0.5;
  if (!(rate > 0)) return 1;
  ((struct model *)m)->rate = rate;
  return 0;
}
static void params(double *p) { p[0] = 0.5; }
static void inertia(const void *m, double I[6]) { int i; (void)m; for (i = 0; i < 6; i++) I[i] = i + 1; }
static int principal(const void *m, double moments[3], double axes[9]) {
  int i;
  if (((const struct model *)m)->rate == 99) return 1;
  for (i = 0; i < 3; i++) moments[i] = i + 1;
  for (i = 0; i < 9; i++) axes[i] = i % 4 == 0;
  return 0;
}
static void rhs(const void *m, double t, const double *x, const double *u, double *dx) {
  (void)t;
  dx[0] = -((const struct model *)m)->rate*x[0] + u[0];
}
static void step(const void *m, double t, double *x, const double *u, double h) { /* explicit Euler; x[1] counts */
  double dx[2];
  rhs(m, t, x, u, dx);
  x[0] += h*dx[0];
  x[1] += 1;
}
static void march(const void *m, double t, double *x, const double *u, double h, long n) {
  long i;
  for (i = 0; i < n; i++) step(m, t + i*h, x, u, h);
}
static void jacobian(const void *m, double t, const double *x, const double *u, double *J) {
  (void)t; (void)x; (void)u;
  J[0] = -((const struct model *)m)->rate; J[1] = 0; J[2] = 0; J[3] = 7;
}
static double energy(const void *m, const double *x) { (void)m; return x[0]*x[0]/2; }
static void momentum(const void *m, const double *x, double L[3]) { (void)m; L[0] = x[0]; L[1] = x[1]; L[2] = 3; }
static int solve(void *o, const void *m, const double *x0) {
  ((struct orbit *)o)->rate = ((const struct model *)m)->rate;
  ((struct orbit *)o)->x0 = x0[0];
  return x0[0] > 0 ? 0 : 2;
}
static void at(const void *o, double t, double *x) {
  x[0] = ((const struct orbit *)o)->x0*exp(-((const struct orbit *)o)->rate*t);
  x[1] = 0;
}
#ifndef MARCH
#define MARCH march
#endif
#ifndef NU
#define NU 1
#endif
#ifndef ABI
#define ABI POLHODE_PLUGIN_ABI
#endif
static int run(const void *m, double t0, double *x, const double *u, double t1, double tolerance, int most) {
  (void)u; (void)tolerance;
  x[0] *= exp(-((const struct model *)m)->rate*(t1 - t0));
  x[1] += 1;
  return most > 0 && t1 < 100 ? 1 : -1;
}
static const struct polhode_stepper steppers[] = {{"euler", step, NULL, MARCH, 1}, {"exact", step, run, march, 0},
  {NULL, NULL, NULL, NULL, 0}};
const struct polhode_plugin *polhode_plugin(void) {
  static const struct polhode_plugin table = {ABI, "decay", "double", 2.220446049250313e-16, 2, NU, 1,
    sizeof(struct model), sizeof(struct orbit), init, params, inertia, principal, rhs, steppers, FEW};
  return &table;
}
]])

-- plugin.h out of the program's own templates: what an installed program has
local BUILD = [[
local function build(few, flags)
  assert(host.write_file(args[1] .. "/plugin.h", assert(host.templates["templates/host/plugin.h"])))
  assert(host.compile(args[1], { "decay.c" }, "decay.so",
    { flags = { "-std=c99", "-shared", "-fPIC", "-DFEW=" .. few, flags }, libs = { "-lm" } }))
  return host.plugin(args[1] .. "/decay.so")
end
local all = "jacobian,energy,momentum,NULL,solve,at"
]]

says("a plugin tells what it is", BUILD .. [[
  local i = build(all):info()
  say(i.name, i.real, i.epsilon, i.nx, i.nu, i.np, i.params[1], i.has.solve, i.has.step, i.has.peers)
  for _, s in ipairs(i.steppers) do say(s.name, s.order, s.adaptive) end]],
  "decay double 2.2204460492503e-16 2 1 1 0.5 true true false\neuler 1 false\nexact 0 true\n")
for _, case in ipairs { { "jacobian,energy,momentum,NULL,solve,at",
  "energy inertia jacobian momentum principal rhs solve step\n" }, { "0,0,0,0,0", "inertia principal rhs step\n" } } do
  local few, names = table.unpack(case)
  says("and which functions it has: " .. few, BUILD .. string.format([[
    local names = {}
    for name, there in next, build(%q):info().has do names[#names + 1] = there and name or nil end
    table.sort(names)
    say(table.concat(names, " "))]], few), names)
end
says("as many inputs as states may be, 64", BUILD .. [[
  local p, u = build(all, "-DNU=64"), {}
  for i = 1, 64 do u[i] = i end
  say(p:init(), p:rhs(0, { 2, 0 }, u)[1])]], "0 0.0\n")
tap.like(lua(BUILD .. [[say(build(all, "-DNU=65"))]]), "its table is not filled in properly", "and not one more")
says("init with the scene's parameters, others, and wrong ones", BUILD .. [[
  local p = build(all)
  say(p:init(), p:rhs(0, { 2, 0 }, { 0 })[1], p:init { 3 }, p:rhs(0, { 2, 0 }, { 1 })[1], p:init { -1 })
  say(pcall(p.rhs, p, 0, { 2, 0 }))]], "0 -1.0 0 -5.0 1\nfalse plugin: init first\n")
says("every function is called with what was given", BUILD .. [[
  local p = build(all)
  p:init { 0.5 }
  local moments, axes = p:principal()
  say(row(p:inertia())) say(row(moments), row(axes)) say(row(p:step(0, { 1, 0 }, { 0 }, 0.1)))
  say(row(p:jacobian(0, { 1, 0 }))) say(p:energy { 3, 0 }, row(p:momentum { 1, 2 }))]],
  "1 2 3 4 5 6\n1 2 3 1 0 0 0 1 0 0 0 1\n0.94999999999999996 1\n-0.5 0 0 7\n4.5 1 2 3\n")
says("moments that the type does not hold are an error", BUILD .. [[
  local p = build(all)
  p:init { 99 }
  say(pcall(p.principal, p))]], "false plugin: a principal moment is beyond the range of the type\n")
says("integrate takes whole steps that hit the times", BUILD .. [[
  local p = build(all)
  p:init()
  for _, r in ipairs(p:integrate({ 1, 0 }, { 0 }, 0.1, { 0, 0.1, 0.35, 1, 0.5 })) do say(r[1], r[3]) end]],
  "0.0 0.0\n0.1 1.0\n0.35 4.0\n1.0 11.0\n0.5 16.0\n")
says("a stepper is found by its name, and one with a tolerance chooses its steps", BUILD .. [[
  local p = build(all)
  p:init { 1 }
  say(p:step(0, { 1, 0 }, { 0 }, 0.5, "exact")[1], pcall(p.step, p, 0, { 1, 0 }, { 0 }, 0.5, "heun"))
  local rows = p:integrate({ 1, 0 }, { 0 }, { 1e-9 }, { 1, 2 }, 0, "exact")
  say(rows[2][2] == math.exp(-1) * math.exp(-1), rows[2][3])
  say(p:integrate({ 1, 0 }, { 0 }, { 1e-9 }, { 1, 200 }, 0, "exact"))
  say(pcall(p.integrate, p, { 1, 0 }, { 0 }, { 1e-9 }, { 1 }))]],
  "0.5 false plugin: there is no stepper heun in it\ntrue 2.0\nnil 1.0\n" ..
  "false bad argument #4 to '?' (this stepper has a fixed step)\n")
says("solve says whether there is an orbit, at follows it", BUILD .. [[
  local p = build(all)
  p:init()
  say(p:solve { -1, 0 }, pcall(p.at, p, 1))
  say(p:solve { 2, 0 }, p:at(2)[1] == 2 * math.exp(-1))]], "2 false plugin: solve first\n0 true\n")
says("what was not emitted is missing by name", BUILD .. [[
  local p = build "0,0,0,0,0"
  p:init()
  say(p:jacobian(0, { 1, 0 })) say(p:energy { 1, 0 }) say(p:solve { 1, 0 })]],
  "nil the emitted code has no Jacobian\nnil the emitted code has no energy\nnil the emitted code has no closed form\n")
tap.like(lua(BUILD .. "say(build(all, '-DABI=99'))"), "it was made for another version of polhode",
  "another ABI is refused")
tap.like(lua(BUILD .. "say(build(all, '-DMARCH=NULL'))"), "one of its steppers is not whole",
  "a stepper without a loop is refused")
tap.like(lua(BUILD .. "say(host.plugin(args[1] .. '/nothing.so'))"), "nil cannot load ",
  "a file that is not there is refused")
tap.like(lua(BUILD .. "local p = build(all) p:init() say(pcall(p.rhs, p, 0, { 1 }))"), "false ",
  "a short state is refused")

tap.done(program.finish())
