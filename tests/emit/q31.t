#!/usr/bin/env lua5.4
-- q31.t - what `gen --with q31` emits: compiles everywhere, gives the same bits, is as near as it says to the motion.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The words that the emitted self-test expects were made by Lua's integers.  The motion that the step should follow is
-- the library's (`polhode run --engine general`), which shares no formula with it.  The quick tier takes fewer builds.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

local binary = os.getenv "POLHODE" or "build/polhode"
local dir = program.directory()
local WARN = "-std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"
local UB = "-fsanitize=undefined,address -fno-sanitize-recover=all"

local function shell(format, ...)
  local ok = program.shell(string.format(format, ...) .. " >" .. dir .. "/log 2>&1")
  return ok, program.read(dir .. "/log")
end

local box = "solid.box { x = 0.2, y = 0.1, z = 0.05, mass = 2.4 }"
local tensor = "tensor { mass = 400, xx = 150, yy = 210, zz = 260, xy = 10, xz = -5, yz = 3 }"

local function emit(name, body, w, more)
  local at = dir .. "/" .. name
  program.write(at .. ".lua", string.format("return scene { name = \"b\", body = %s, " ..
    "initial = { omega = { %s } }, %s }", body, w, more))
  local status, log = shell("%s gen %s.lua --with q31 -o %s", binary, at, at)
  tap.ok(status == 0, name .. ": gen --with q31", log)
  return at
end

local scenes = {
  { "free", box, "0.1, 1.5, 0.2", "ranges = { omega = 2 }, time = { step = 0.001 }", range = 2 },
  { "oblique", tensor, "0.1, 0.06, 0.02", "ranges = { omega = 0.2 }, time = { step = 0.01 }", range = 0.2 },
  { "control", box, "0.1, 1.5, 0.2", "effects = { effect.control { max = 0.003 } }, ranges = { omega = 4 }, " ..
    "time = { step = 0.001 }", range = 4, input = true },
  { "damped", box, "0.1, 1.5, 0.2", "effects = { effect.damping { rate = 0.25 } }, ranges = { omega = 2 }, " ..
    "time = { step = 0.001 }", range = 2 },
  { "rotor", tensor, "0.1, 0.06, 0.02", "effects = { effect.rotor { axis = { 0, 0, 1 }, momentum = 30 }, " ..
    "effect.control { max = 3 } }, ranges = { omega = 0.5 }, time = { step = 0.01 }", range = 0.5, input = true },
}
for _, s in ipairs(scenes) do s.at = emit(s[1], s[2], s[3], s[4]) end

---- warnings, C++, undefined behaviour, the same bits -----------------------------------------------------

local FILES = "b_q31.c b_q31_real.c"

for _, s in ipairs(tier.every(4, scenes)) do
  local ok, log = shell("cd %s && gcc %s -O1 %s %s b_q31_test.c -lm -o t && ./t", s.at, WARN, UB, FILES)
  tap.ok(ok == 0, s[1] .. ": the self-test passes, without a warning, under sanitizers", log)
  ok, log = shell("cd %s && gcc %s -D__ARM_ARCH_6M__ -O1 %s %s b_q31_test.c -lm -o t && ./t", s.at, WARN, UB, FILES)
  tap.ok(ok == 0, s[1] .. ": and with products from halves", log)
end

local most = scenes[5] -- has everything
local hashes, built = {}, 0
for _, cc in ipairs { "gcc", "clang" } do
  if shell("command -v %s", cc) == 0 then
    for _, define in ipairs { "", "-D__ARM_ARCH_6M__" } do
      for level = 0, 3, tier.quick and 3 or 1 do
        local ok, log = shell("%s -std=c99 -O%d %s -DRANGE=%g -I%s tests/emit/q31.c %s/b_q31.c %s/b_q31_real.c -lm " ..
          "-o %s/h && %s/h hash 40000", cc, level, define, most.range * 1.1, most.at, most.at, most.at, dir, dir)
        if ok ~= 0 then tap.diag(log) end
        hashes[ok == 0 and log or "failed"], built = true, built + 1
      end
    end
  end
end
local count = 0
for _ in pairs(hashes) do count = count + 1 end
tap.ok(count == 1 and not hashes.failed, built .. " builds, gcc and clang, -O0 to -O3, both products: the same bits")
local ok, log = shell("gcc %s -D__AVR__ %s -DRANGE=%g -I%s tests/emit/q31.c %s/b_q31.c %s/b_q31_real.c -lm " ..
  "-o %s/h && %s/h hash 20000", WARN, UB, most.range * 1.1, most.at, most.at, most.at, dir, dir)
tap.ok(ok == 0, "any words whatever: nothing undefined happens", log)
for _, cc in ipairs { "g++", "clang++" } do
  if shell("command -v %s", cc) == 0 then
    ok, log = shell("cd %s && %s -x c++ -std=c++11 -pedantic -Wall -Wextra -Werror %s b_q31_test.c -lm -o t && ./t",
      most.at, cc, FILES)
    tap.ok(ok == 0, cc .. ": it is C++, too", log)
  else
    tap.skip(cc .. ": it is C++, too", "no " .. cc .. " (Debian: g++, clang)")
  end
end

-- no floating point but in its own file; no symbol of the compiler's that a freestanding build lacks
ok, log = shell("cd %s && gcc -std=c99 -O2 -mgeneral-regs-only -c b_q31.c -o n.o && nm -u n.o", most.at)
tap.ok(ok == 0 and not string.find(log, "U [^_]"), "the step has no floating point and calls nothing", log)

-- the library, installed, has the step in whole numbers too
program.write(scenes[1].at .. "/use.c", '#include "b_q31.h"\n' ..
  "int main(void) { int32_t x[B_Q31_NX]; b_q31_initial(x); return (int)b_q31_step(x, 0); }\n")
ok, log = shell("cd %s && make install CC=gcc DESTDIR=%s/root PREFIX=/usr && gcc -std=c99 -I%s/root/usr/include " ..
  "use.c -L%s/root/usr/lib -lb -lm -o use && ./use", scenes[1].at, dir, dir, dir)
tap.ok(ok == 0, "make install: header and library of the step in whole numbers", log)

-- Remainders are less than a unit: whatever stands there, one step is that of some remainder, at most a unit away, and
-- leaves a valid one; gcc's sanitizer sees no overflow.
for _, s in ipairs { scenes[1], scenes[3] } do
  program.write(s.at .. "/disturbed.c", [[
#include "b_q31.h"
#include <stdio.h>
int main(void)
{
  static const int32_t bad[] = {INT32_MAX, INT32_MIN, -1, 1 << 30, 0x55555555, 12345};
  int32_t x[B_Q31_NX], y[B_Q31_NX], u[3] = {0, 0, 0};
  unsigned i, k, n = 0, bits = 0, wrong = 0;
  b_q31_initial(x);
  for (k = 0; k < 6; k++) {
    for (i = 0; i < B_Q31_NX; i++) y[i] = i < B_Q31_RQW ? x[i] : bad[(k + i) % 6];
    bits |= b_q31_step(y, u) | b_q31_step(x, u);
    for (i = 0; i < B_Q31_RQW; i++) {
      const int32_t d = x[i] - y[i];
      n++;
      wrong += d < -1 || d > 1;
    }
    for (i = 0; i < 10; i++) bits |= b_q31_step(y, u);
  }
  printf("%u %u %u\n", n, bits, wrong);
  return 0;
}
]])
  ok, log = shell("cd %s && gcc -std=c99 -Wall -Wextra -Werror -fsanitize=undefined -fno-sanitize-recover=all " ..
    "disturbed.c b_q31.c -o disturbed && ./disturbed", s.at)
  tap.ok(ok == 0 and log == "42 0 0\n", s[1] .. ": disturbed remainders move the state by at most a unit", log)
end

-- the self-test notices a constant that is off by one unit
local source = program.read(scenes[1].at .. "/b_q31.c")
local broken, changes = string.gsub(source, "(static const int32_t K3 = INT32_C%()(%d+)", function(a, n)
  return a .. tonumber(n) + 1
end)
program.write(dir .. "/broken.c", broken)
ok, log = shell("cd %s && gcc -I%s ../broken.c b_q31_test.c -o t && ./t", scenes[1].at, scenes[1].at)
tap.ok(changes == 1 and ok ~= 0 and string.find(log, "\nnot ok 5", 1, true), "a constant off by one is noticed", log)

---- saturation is never silent ----------------------------------------------------------------------------

for _, s in ipairs(scenes) do
  shell("gcc -O2 -DRANGE=%g -I%s tests/emit/q31.c %s/b_q31.c %s/b_q31_real.c -lm -o %s/run", s.range, s.at, s.at, s.at,
    s.at)
  if not s.input then
    ok, log = shell("%s/run free 400", s.at)
    tap.ok(ok == 0 and log == "0\n", s[1] .. ": 400 motions from within the range never reach a limit")
  end
end
-- 0.003 N m on 2.4/12 (0.1^2 + 0.05^2) = 0.0025 kg m^2: 1.2 rad/s^2 at first, so wx = 4 rad/s takes about 3250 steps
ok, log = shell("%s/run driven", scenes[3].at)
local steps, bits, held = string.match(log, "^(%d+) (%d+) (%d+)")
tap.ok(ok == 0 and tonumber(steps) and tonumber(steps) > 2000 and tonumber(steps) < 6000,
  "a torque drives the rate to its limit", log)
tap.is(tonumber(bits) and tonumber(bits) & 127, 1 << 4, "bit 4: wx")
tap.is(tonumber(bits) and tonumber(bits) & 896, 1 << 7, "bit 7: ux is more than the scene allows")
tap.is(held, "1", "and every further step says so")
-- from_real leaves remainders as a step does, -2^(k-1) .. 2^(k-1) - 1: half a unit belongs to the next word, for a step
-- reads a remainder of 2^(k-1) as -2^(k-1), a unit less
for _, i in ipairs(tier.every(3, { 1, 2, 3 })) do
  local s, faults, values = scenes[({ 1, 2, 5 })[i]], {}, 0
  shell("gcc -O2 -DRANGE=%g -I%s tests/emit/q31.c %s/b_q31.c %s/b_q31_real.c -lm -o %s/run", s.range, s.at, s.at, s.at,
    s.at)
  local header, place = program.read(s.at .. "/b_q31.h"), 0
  local row = "\n %* +([qw][wxyz]) +2%^%-(%d+)[ rad/s]* +2%^%-(%d+) +%+%-([%d.e+-]+)"
  for name, e, k, limit in string.gmatch(header, row) do
    local reach = string.sub(name, 1, 1) == "q" and 0.75 or 0.99 * tonumber(limit)
    local _, out = shell("%s/run remainders %d %s %s %d", s.at, place, e, k, math.floor(reach * 2.0 ^ tonumber(e)))
    local n, wrong, far = string.match(out, "^(%d+) (%d+) (%d+)\n$")
    if wrong ~= "0" or far ~= "0" then faults[#faults + 1] = name .. ": " .. out end
    values, place = values + (tonumber(n) or 0), place + 1
  end
  tap.ok(place == 7 and values > 7 * 4000 and #faults == 0, s[1] .. ": from_real, " .. values ..
    " values between all remainders: the nearest that a step leaves", table.concat(faults))
end
ok, log = shell("%s/run run 0 1 0 0 0 nan 0 99", scenes[1].at)
tap.ok(ok == 0 and string.find(log, " 80\n", 1, true), "from_real: what is no number or too large is reported", log)

---- as near as it says to the library's motion --------------------------------------------------------------

-- Errors of single steps (the header's) add up, those of the rates for the time that is left, and grow with the motion
-- itself: by less than 4 in these motions of one or two radians.  The method's own error is h |w| to the fifth a step
-- over 500 at least: below 1e-8 in all, of which the stated errors are more.
local function stated(s, name)
  local header = program.read(s.at .. "/b_q31.h")
  return tonumber(string.match(header, "%* +" .. name .. " .-([%d.e+-]+)[ rads/]*\n"))
end

local function compare(s, what, n, h, library, torque)
  local out = select(2, shell("%s run %s --engine general --at %.17g", binary, library, n * h))
  local want = {}
  for x in string.gmatch(string.match(out, "\n([^\n]+)\n$") or "", "[^,]+") do want[#want + 1] = tonumber(x) end
  local got = {}
  local w = string.gsub(s[3], ",", "")
  for x in string.gmatch(select(2, shell("%s/run run %d 1 0 0 0 %s %s", s.at, n, w, torque or "")), "%S+") do
    got[#got + 1] = tonumber(x)
  end
  tap.is(got[8], 0, s[1] .. ": nothing is limited")
  local e_q, e_w = 0, 0
  for i = 1, 4 do e_q = math.max(e_q, stated(s, "q" .. string.sub("wxyz", i, i))) end
  for i = 1, 3 do e_w = math.max(e_w, stated(s, "w" .. string.sub("xyz", i, i))) end
  for i = 1, 7 do
    local tolerance = i <= 4 and 4 * n * (e_q + n * h * e_w) or 4 * n * e_w
    tap.near(got[i], want[i + 1], 0, tolerance, s[1] .. ": " .. what .. ", component " .. i .. " after " .. n ..
      " steps", "the stated errors of all steps")
  end
end

for i, s in ipairs(scenes) do
  if not s.input then compare(s, "the library's motion", 1000, i == 2 and 0.01 or 0.001, s.at .. ".lua") end
end
-- a torque by the input, against the same by effect.torque
local function torqued(body, w, effects)
  return string.format("return scene { name = \"b\", body = %s, initial = { omega = { %s } }, effects = { %s } }", body,
    w, effects)
end
program.write(dir .. "/torque.lua", torqued(box, scenes[3][3], "effect.torque { body = { 0.001, -0.002, 0.0015 } }"))
compare(scenes[3], "the library's motion with torque", 1000, 0.001, dir .. "/torque.lua", "0.001 -0.002 0.0015")
program.write(dir .. "/spun.lua", torqued(tensor, scenes[5][3],
  "effect.rotor { axis = { 0, 0, 1 }, momentum = 30 }, effect.torque { body = { 1, -2, 0.5 } }"))
compare(scenes[5], "the library's motion with torque", 500, 0.01, dir .. "/spun.lua", "1 -2 0.5")

-- a step so long that the turn of the axis of rotation counts: left out, it would cost 3e-5 rad a step
local long = { "long steps", box, "0.5, 5, -0.75", "ranges = { omega = { { -1, 1 }, { -6, 6 }, { -1, 1 } } }, " ..
  "time = { step = 0.02 }" }
long.at = emit("long", long[2], long[3], long[4])
shell("gcc -O2 -DRANGE=1 -I%s tests/emit/q31.c %s/b_q31.c %s/b_q31_real.c -lm -o %s/run", long.at, long.at, long.at,
  long.at)
compare(long, "the library's motion", 25, 0.02, long.at .. ".lua")

---- the same bytes; what is refused ---------------------------------------------------------------------------

shell("%s gen %s.lua --with q31 -o %s/again", binary, most.at, dir)
for _, name in ipairs { "b_q31.h", "b_q31.c", "b_q31_real.c", "b_q31_test.c" } do
  tap.ok(program.read(dir .. "/again/" .. name) == program.read(most.at .. "/" .. name), name .. ": the same again")
end
ok, log = shell("%s gen bodies/heavy_top.lua --with q31 -o %s/no", binary, dir)
tap.is(ok, 1, "a heavy top is refused")
tap.ok(string.find(log, "heavy_top.lua:%d+: %-%-with q31: .*got effect.gravity"), "by the effect's name and line", log)
ok, log = shell("%s gen bodies/brick_centroid.lua --with q31 -o %s/no", binary, dir)
tap.is(ok, 1, "a scene without ranges is refused")
tap.ok(string.find(log, "write ranges = { omega = 5 }", 1, true), "and told what to write", log)

program.finish()
tap.done()
