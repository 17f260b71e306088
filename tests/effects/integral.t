#!/usr/bin/env lua5.4
-- integral.t - Jacobi's integral T + V - n L_z of fields that turn about inertial z: where it is, its value; it stays.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Value: the formulas of effects/gravity_gradient.lua and effects/magnetic.lua written out here for numbers, to 16 ulp
-- of the terms (some 60 roundings, each of half an ulp, of terms of both signs).  Constant: over 40 s of rates of some
-- rad/s by the emitted Taylor stepper at 1e-15, whose roundings, one of each of some hundred steps, stay below 1e-13.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"
local compiled = require "tests.ir.compiled"

local Q, W = { 0.9, 0.1, 0.3, -0.3 }, { 0.3, -0.2, 1.1 } -- |Q| = 1

-- v of inertial axes in body axes, by R(q)^T.
local function turned(q, v)
  local w, x, y, z = q[1], q[2], q[3], q[4]
  return { (w * w + x * x - y * y - z * z) * v[1] + 2 * (x * y + w * z) * v[2] + 2 * (x * z - w * y) * v[3],
    2 * (x * y - w * z) * v[1] + (w * w - x * x + y * y - z * z) * v[2] + 2 * (y * z + w * x) * v[3],
    2 * (x * z + w * y) * v[1] + 2 * (y * z - w * x) * v[2] + (w * w - x * x - y * y + z * z) * v[3] }
end

local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end

-- I w; I: xx, yy, zz, xy, xz, yz
local function apply(I, w)
  return { I[1] * w[1] + I[4] * w[2] + I[5] * w[3], I[4] * w[1] + I[2] * w[2] + I[6] * w[3],
    I[5] * w[1] + I[6] * w[2] + I[3] * w[3] }
end

local function gradient(n, I)
  return function(t, q)
    local o = turned(q, { math.cos(n * t), math.sin(n * t), 0 })
    return 1.5 * n * n * dot(o, apply(I, o))
  end
end

local function magnetic(n, m, B)
  return function(t, q)
    local c, s = math.cos(n * t), math.sin(n * t)
    return -dot(m, turned(q, { B[1] * c - B[2] * s, B[1] * s + B[2] * c, B[3] }))
  end
end

local field = "effect.magnetic { moment = { 1, 2, 3 }, rotating = { 0.5, 0.25, -1 }, rate = %s }"
local orbit = "effect.gravity_gradient { mu = 4, orbit = { radius = 1 } }"
local three, full, sym = { 1, 2.5, 3, 0, 0, 0 }, { 2, 2.5, 3, 0.25, -0.5, 0.125 }, { 2, 2, 3, 0, 0, 0 }

-- {what, tensor, effects, n, parts of V, momentum held by a rotor}; without n: no such integral.
local rows = {
  { "gravity gradient", three, orbit, 2, { gradient(2, three) } },
  { "gravity gradient, full tensor", full, orbit, 2, { gradient(2, full) } },
  { "gravity gradient, symmetric body", sym, orbit, 2, { gradient(2, sym) } },
  { "gravity gradient and a rotor", three, orbit .. ", effect.rotor { axis = { 0, 3, 4 }, momentum = 2 }", 2,
    { gradient(2, three) }, { 0, 1.2, 1.6 } },
  { "rotating field", three, string.format(field, "0.75"), 0.75, { magnetic(0.75, { 1, 2, 3 }, { 0.5, 0.25, -1 }) } },
  { "two fields at one rate", three, string.format(field, "2") .. ", " .. orbit, 2,
    { magnetic(2, { 1, 2, 3 }, { 0.5, 0.25, -1 }), gradient(2, three) } },
  { "rotating field and one along z", three, string.format(field, "0.75") ..
    ", effect.magnetic { moment = { 0, 1, 0 }, field = { 0, 0, 2 } }", 0.75,
    { magnetic(0.75, { 1, 2, 3 }, { 0.5, 0.25, -1 }), magnetic(0, { 0, 1, 0 }, { 0, 0, 2 }) } },
  { "two fields at two rates", three, string.format(field, "0.75") .. ", " .. orbit },
  { "rotating field and one across z", three, string.format(field, "0.75") ..
    ", effect.magnetic { moment = { 0, 1, 0 }, field = { 0, 1, 2 } }" },
  { "gravity gradient and damping", three, orbit .. ", effect.damping { c = 0.5 }" },
  { "elliptic orbit", three, "effect.gravity_gradient { mu = 4, orbit = { a = 1, e = 0.25 } }" },
  { "rotating field in a turning frame", three, string.format(field, "0.75") ..
    ", effect.rotating_frame { rate = { 0, 0, 0.5 } }" },
  { "fixed field", three, "effect.magnetic { moment = { 0, 1, 0 }, field = { 0, 1, 2 } }" },
}

local function list(v) return table.concat(v, ", ") end

local function text(row)
  local I = row[2]
  return string.format("return scene { name = \"b\", body = tensor { mass = 1, com = {0, 0, 0}, xx = %s, yy = %s, " ..
    "zz = %s, xy = %s, xz = %s, yz = %s },\n  effects = { %s },\n  initial = { omega = { %s }, attitude = { %s } } }\n",
    I[1], I[2], I[3], I[4], I[5], I[6], row[3], list(W), list(Q))
end

-- Lines t, q, w, J of the emitted code.
local main = [[
int main(void)
{
  b_model m;
  double x[B_NX], t;
  int i, k;
  if (b_init(&m, 0)) return 1;
  b_initial(&m, x);
  for (i = 0, t = 0; i <= 8; i++, t += 5) {
    printf("%.17e\n", t);
    for (k = 0; k < 7; k++) printf("%.17e\n", x[k]);
    printf("%.17e\n", b_jacobi_integral(&m, t, x));
    if (b_taylor_run(&m, t, x, 0, t + 5, 1e-15, 100000) < 0) return 1;
  }
  return 0;
}
]]

for _, row in ipairs(tier.every(3, rows)) do
  local job = scene.plan(assert(scene.read(text(row))), { methods = { "taylor" } })
  local files = scene.files(job)
  local there = string.find(files["b.h"], "b_jacobi_integral", 1, true) ~= nil
  tap.is(there, row[4] ~= nil, row[1] .. (row[4] and ": there is an integral" or ": there is none"))
  tap.is(job.conserved.is["T+V-n.L"], row[4] ~= nil, row[1] .. ": and the list of what is conserved says so")
  if row[4] and there then
    local unit = files["b.c"]:gsub('#include "[^\n]*\n', function() return files["b.h"] end)
    local out = compiled.numbers("#include <stdio.h>\n" .. unit .. main)
    tap.is(#out, 81, row[1] .. ": it runs")
    local first
    for i = 1, #out, 9 do
      local t, q, w, J = out[i], { table.unpack(out, i + 1, i + 4) }, { table.unpack(out, i + 5, i + 7) }, out[i + 8]
      local L = apply(row[2], w)
      local T, V, size = dot(L, w) / 2, 0.0, 0.0
      for k = 1, 3 do L[k] = L[k] + (row[6] or { 0, 0, 0 })[k] end
      for _, f in ipairs(row[5]) do
        V = V + f(t, q)
        size = size + math.abs(f(t, q))
      end
      local Lz = dot(turned(q, { 0, 0, 1 }), L)
      size = size + T + row[4] * math.sqrt(dot(L, L)) + 8 -- 8: above any sum of moduli of the terms of V
      first = first or J
      tap.near(J, T + V - row[4] * Lz, 0, 16 * 2.0 ^ -52 * size, row[1] .. ": value at t = " .. t,
      "16 roundings of the largest term")
      tap.near(J, first, 0, 1e-13 * size, row[1] .. ": constant at t = " .. t,
      "1e-13 of the terms, the tolerance of the run")
    end
  end
end

tap.done()
