#!/usr/bin/env lua5.4
-- python.t - gen --project python: the wheel is built and used; its numbers have the bits of a C program with the same
-- code; wrong arrays and parameters are refused; types are right; the same wheel twice.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- It needs Debian's python3-numpy, python3-setuptools, python3-wheel, python3-pip and python3-dev (.ci/setup python).

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local root = io.popen("pwd"):read "l"
local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = root .. "/" .. binary end
local dir = program.directory()
local PYTHON = "/usr/bin/python3"

local function shell(command)
  local status = program.shell(string.format("cd %s && { %s\n} >out 2>&1", dir, command))
  return status, program.read(dir .. "/out")
end

if shell(PYTHON .. " -c 'import numpy, setuptools, wheel, pip'") ~= 0 or
  shell("echo '#include <Python.h>' | cc $(python3-config --includes) -I/usr/include/python3.11 -E - ") ~= 0 then
  tap.skip("gen --project python", "no NumPy, setuptools, wheel, pip or Python.h here (.ci/setup python)")
  tap.done(program.finish())
  return
end

-- Scenes: with a closed form, in float, with inputs and time, without parameters and attitude.
local scenes = {
  { name = "racket", orbit = true, text = [[
local head, handle = param("head", 0.13, "m"), param("handle", 0.33, "m")
local frame = wire.hoop { r = head, mass = quantity(160, "g") }
local grip = solid.cylinder { r = 0.016, h = handle, mass = quantity(160, "g") }
  :turned { axis = "x", angle = pi/2 } :at { 0, -head - handle/2, 0 }
return scene { name = "racket", body = frame + grip, initial = { omega = {8, 0.02, 0.01} } }
]] },
  { name = "boxf", orbit = true, float = true, text = [[
local a = param("a", 200, "mm")
return scene { name = "boxf", body = solid.box { x = a, y = 0.1, z = 0.05, mass = 1 }, initial = { omega = {1, 2, 3} } }
]] },
  { name = "craft", inputs = 2, text = [[
local motor = input("motor", "N m", { min = -0.1, max = 0.1 })
local push = input("push", "N m")
return scene { name = "craft", body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = 4 },
  initial = { omega = {1, 2, 3} }, effects = { effect.torque { body = { motor, push, 0.01*sin(3*t) } } } }
]] },
  { name = "rates", text = [[
return scene { name = "rates", body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = 4 },
  initial = { omega = {1, 2, 3} }, effects = { effect.drag { c = 0.001 } }, outputs = { "rates" } }
]] },
}

-- A C program that prints, in hexadecimal: the state after 1000 steps, energy, momentum, the state of the closed form.
local function c_program(s)
  local n, N = s.name, s.name:upper()
  local u = s.inputs and "u" or "0"
  return string.format([[
#include "%s.h"
#include <stdio.h>
static void show(const %s_real *x, int n) { int i; for (i = 0; i < n; i++) printf("%%a\n", (double)x[i]); }
int main(void)
{
  static %s_model m;
  %s_real x[%s_NX], L[3], E%s;
  int k;
  if (%s_init(&m, 0) != 0) return 1;
  %s_initial(&m, x);
  for (k = 0; k < 1000; k++) %s_step(&m, (%s_real)0.5 + (%s_real)0.001*(%s_real)k, x, %s, (%s_real)0.001);
  show(x, %s_NX);
  E = %s_energy(&m, x); show(&E, 1);
  %s_momentum_body(&m, x, L); show(L, 3);
]], n, n, n, n, N, s.inputs and ", u[2] = {(" .. n .. "_real)0.05, (" .. n .. "_real)-0.02}" or "", n, n, n, n, n, n, u,
    n, N, n, n) .. (s.orbit and string.format([[
  { static %s_orbit o; %s_initial(&m, x); if (%s_solve(&o, &m, x) != 0) return 2;
    %s_at(&o, (%s_real)7.25, x); show(x, %s_NX); }
]], n, n, n, n, n, N) or "") .. "  return 0;\n}\n"
end

local function python_program(s)
  return string.format([[
import numpy as np
import %s as p
m = p.Model()
x = m.initial()
u = %s
def show(a):
    for v in np.atleast_1d(a): print(float(v).hex())
many = np.stack([x, x, x])
start = np.array(x)
assert m.step(x, 0.001, t=0.5, u=u, count=1000) is x
show(x); show(m.energy(x)); show(m.momentum_body(x))
assert np.array_equal(m.step(many, 0.001, t=0.5, u=u, count=1000), np.stack([x, x, x]))
assert m.energy(many).shape == (3,) and m.momentum_body(many).shape == (3, 3) and m.rhs(many, u=u).shape == many.shape
assert np.array_equal(m.rhs(many, t=0.3, u=u)[2], m.rhs(x, t=0.3, u=u))
t, states = m.run(start, 0.001, 10, every=5, u=u)
assert states.shape == (3, p.NX) and t.tolist() == [0.0, 0.005, 0.01] and np.array_equal(states[0], start)
assert m.run(many, 0.001, 10, every=5, u=u)[1].shape == (3, 3, p.NX)
if %s:
    o = m.solve(start)
    show(o.at(7.25))
    assert np.array_equal(o.at([1.0, 7.25])[1], o.at(7.25)) and o.at([]).shape == (0, p.NX)
]], s.name, s.inputs and "[0.05, -0.02]" or "None", s.orbit and "True" or "False")
end

-- Numbers as doubles: C and Python write hexadecimal digits each in its own way.
local function numbers(text)
  local list = {}
  for line in text:gmatch "[^\n]+" do list[#list + 1] = string.format("%a", tonumber(line) or 0 / 0) end
  return table.concat(list, " ")
end

local build = "SOURCE_DATE_EPOCH=1700000000 PIP_DISABLE_PIP_VERSION_CHECK=1 " .. PYTHON ..
  " -m pip wheel -q --no-index --no-deps --no-build-isolation"
for _, s in ipairs(scenes) do
  program.write(dir .. "/" .. s.name .. ".lua", s.text)
  local status, text = shell(string.format("%s gen %s.lua --project python%s -o %s", binary, s.name,
    s.float and " --real float" or "", s.name))
  tap.ok(status == 0, s.name .. ": gen --project python", text)
  status, text = shell(string.format("%s -w %s/wheels ./%s", build, s.name, s.name))
  tap.ok(status == 0, s.name .. ": pip wheel builds it", text)
  _, text = shell("ls " .. s.name .. "/wheels")
  tap.like(text, s.name .. "-0.1.0-cp311-abi3-", s.name .. ": a wheel of the stable interface")
  status, text = shell(string.format("%s -m pip install -q --no-index --no-deps " ..
    "--root-user-action=ignore --target site %s/wheels/*.whl", PYTHON, s.name))
  tap.ok(status == 0, s.name .. ": pip installs it", text)
  status, text = shell(string.format("cd %s && PYTHONPATH=../site %s -m unittest discover tests", s.name, PYTHON))
  tap.ok(status == 0, s.name .. ": its own test passes", text)
  program.write(dir .. "/main.c", c_program(s))
  status, text = shell(string.format(
    "cc -std=c99 -O2 -ffp-contract=off -I%s/src main.c %s/src/%s.c -o main -lm && ./main", s.name, s.name, s.name))
  local want = numbers(text)
  tap.ok(status == 0, s.name .. ": the C program runs", text)
  program.write(dir .. "/main.py", python_program(s))
  status, text = shell("PYTHONPATH=site " .. PYTHON .. " main.py")
  tap.ok(status == 0, s.name .. ": the Python program runs", text)
  tap.is(numbers(text), want, s.name .. ": the same bits")
  status, text = shell(string.format("gcc -std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow " ..
    "-Werror -fsyntax-only $(python3-config --includes) -I/usr/include/python3.11 %s/src/%s_native.c", s.name, s.name))
  tap.ok(status == 0, s.name .. ": the extension compiles without a warning", text)
end

-- ---- what is refused, and how ----

program.write(dir .. "/refused.py", [[
import numpy as np
import racket, craft
m, c = racket.Model(), craft.Model()
x = m.initial()
def told(what, kind, f):
    try:
        f()
        print(what, "passed")
    except kind as e:
        print(what + ":", e)
told("check", ValueError, lambda: racket.Model(head=-1.0))
told("name", TypeError, lambda: racket.Model(haed=1.0))
told("nan", ValueError, lambda: racket.Model(head=float("nan")))
told("shape", ValueError, lambda: m.step(np.zeros(3), 0.1))
told("type", TypeError, lambda: m.step(np.zeros(7, dtype="float32"), 0.1))
told("stride", TypeError, lambda: m.step(np.zeros((3, 14))[:, ::2], 0.1))
read_only = np.array(x); read_only.flags.writeable = False
told("write", TypeError, lambda: m.step(read_only, 0.1))
told("list", ValueError, lambda: m.step([1.0]*7, 0.1))
told("no input", ValueError, lambda: m.step(x, 0.1, u=[1.0]))
told("input", ValueError, lambda: c.step(c.initial(), 0.1))
told("inputs", ValueError, lambda: c.step(c.initial(), 0.1, u=[1.0]))
told("count", ValueError, lambda: m.step(x, 0.1, count=-1))
told("motion", ValueError, lambda: m.solve(np.zeros(7)))
]])
local status, text = shell("PYTHONPATH=site " .. PYTHON .. " refused.py")
tap.is(text, [[
check: check 1: wire.hoop: r must be positive (racket.lua:2)
name: no parameter 'haed' (there are: head, handle)
nan: check 1: wire.hoop: r must be positive (racket.lua:2)
shape: x must be an array of the shape (7,) or (n, 7)
type: x must be an array of float64
stride: x must be a C-contiguous, writable array of float64
write: x must be a C-contiguous, writable array of float64
list: x must be an array of the shape (7,) or (n, 7)
no input: the scene has no inputs, so u must be None
input: u must have 2 numbers: the scene has inputs
inputs: u must have the shape (2,), got (1,)
count: count must not be negative
motion: no motion through x: q is 0, a number not finite, or a rate too large
]], "what is wrong is told, with the check's own words")
tap.is(status, 0, "and nothing else is raised")

program.write(dir .. "/lambda.lua", [[
local self = param("self", 1, "m")
return scene { name = "lambda", body = solid.sphere { r = self, mass = 1 } }
]])
status, text = shell(binary .. " gen lambda.lua --project python")
tap.ok(status == 1 and text:find("must not be named like a word or a module of Python", 1, true), "a name of Python's",
  text)
status, text = shell(binary .. " gen racket.lua --project python --only step")
tap.ok(status == 2 and text:find("--only", 1, true), "--only is refused", text)

-- ---- types, and the same bytes ----

if shell(PYTHON .. " -c 'import mypy'") == 0 then
  status, text = shell("for p in racket craft rates; do PYTHONPATH=site " .. PYTHON ..
    " -m mypy --strict site/$p && PYTHONPATH=site " .. PYTHON .. " -m mypy.stubtest $p._native || exit 1; done")
  tap.ok(status == 0, "mypy --strict and stubtest find nothing", text)
else
  tap.skip("mypy --strict and stubtest find nothing", "no mypy here")
end
status, text = shell("cp racket/wheels/*.whl first.whl && rm -rf racket/wheels racket/build && " .. build ..
  " -w racket/wheels ./racket && cmp first.whl racket/wheels/*.whl")
tap.ok(status == 0, "the same wheel once more", text)

tap.done(program.finish())
