#!/usr/bin/env lua5.4
-- turns.t - bodies that are turned several times: two general turns are one rotation, three are one, too.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The oracle turns numbers.  Every piece is its mass, centre and tensor from the handbook; a turn multiplies both by a
-- rotation matrix whose sines and cosines have 400 bits, a shift adds to the centre, and Steiner's law adds the pieces.
-- Nothing of the generator's algebra is asked but the values of what it made.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local scene = require "tests.scene"
local program = require "tests.cli.program"
local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"

local BITS = 400 -- of every number of the oracle
local AGREE = 200 -- of the 240 bits of a value of the model; the others may be lost to what cancels in some 1000 terms
local NAMES = { "xx", "yy", "zz", "xy", "xz", "yz" }

local function rounded(x) return R.round(x, BITS) end

---- the oracle ------------------------------------------------------------------------------------

local function product(A, B)
  local C = {}
  for i = 1, 3 do
    C[i] = {}
    for j = 1, 3 do C[i][j] = rounded(A[i][1] * B[1][j] + A[i][2] * B[2][j] + A[i][3] * B[3][j]) end
  end
  return C
end

-- The turn by the angle about a coordinate axis; its columns are the turned axes.
local function about(axis, angle)
  local c, s = R.apply("cos", BITS, angle), R.apply("sin", BITS, angle)
  local i = string.find("xyz", axis, 1, true)
  local j, k = i % 3 + 1, (i + 1) % 3 + 1
  local A = { { R.zero, R.zero, R.zero }, { R.zero, R.zero, R.zero }, { R.zero, R.zero, R.zero } }
  A[i][i], A[j][j], A[k][k], A[k][j], A[j][k] = R.one, c, c, s, -s
  return A
end

-- Turns about the body's axes, each as it stands after those before.
local function euler(sequence, angles)
  local A
  for n = 1, 3 do
    local one = about(string.sub(sequence, n, n), angles[n])
    A = A and product(A, one) or one
  end
  return A
end

-- A piece is {mass, centre, tensor about it as three rows}.
local function box(m, x, y, z)
  local k = m / R.new(12)
  return { { m, { R.zero, R.zero, R.zero }, { { k * (y ^ 2 + z ^ 2), R.zero, R.zero },
    { R.zero, k * (x ^ 2 + z ^ 2), R.zero }, { R.zero, R.zero, k * (x ^ 2 + y ^ 2) } } } }
end

local function cylinder(m, r, h)
  local k, a = m * (R.new(3) * r ^ 2 + h ^ 2) / R.new(12), m * r ^ 2 / R.new(2)
  return { { m, { R.zero, R.zero, R.zero }, { { k, R.zero, R.zero }, { R.zero, k, R.zero },
    { R.zero, R.zero, a } } } }
end

local function tensor(m, I)
  return { { m, { R.zero, R.zero, R.zero }, { { I[1], I[4], I[5] }, { I[4], I[2], I[6] }, { I[5], I[6], I[3] } } } }
end

local function transpose(A)
  local B = {}
  for i = 1, 3 do B[i] = { A[1][i], A[2][i], A[3][i] } end
  return B
end

local function turned(list, A)
  local out = {}
  for k, p in ipairs(list) do
    local c = p[2]
    out[k] = { p[1], {}, product(product(A, p[3]), transpose(A)) }
    for i = 1, 3 do out[k][2][i] = rounded(A[i][1] * c[1] + A[i][2] * c[2] + A[i][3] * c[3]) end
  end
  return out
end

local function moved(list, x, y, z)
  local out = {}
  for k, p in ipairs(list) do out[k] = { p[1], { p[2][1] + x, p[2][2] + y, p[2][3] + z }, p[3] } end
  return out
end

local function joined(a, b, sign)
  local out = { table.unpack(a) }
  for _, p in ipairs(b) do
    local I = {}
    for i = 1, 3 do
      I[i] = {}
      for j = 1, 3 do I[i][j] = R.new(sign or 1) * p[3][i][j] end
    end
    out[#out + 1] = { R.new(sign or 1) * p[1], p[2], I }
  end
  return out
end

-- Centre of mass and the six entries about it.
local function whole(list)
  local mass, com, I = R.zero, { R.zero, R.zero, R.zero }, {}
  for _, p in ipairs(list) do mass = mass + p[1] end
  for i = 1, 3 do
    for _, p in ipairs(list) do com[i] = com[i] + p[1] * p[2][i] / mass end
  end
  for n = 1, 6 do
    local i, j = table.unpack(vec.pair[n])
    I[n] = R.zero
    for _, p in ipairs(list) do
      local d = { p[2][1] - com[1], p[2][2] - com[2], p[2][3] - com[3] }
      local square = i == j and d[1] ^ 2 + d[2] ^ 2 + d[3] ^ 2 or R.zero
      I[n] = I[n] + p[3][i][j] + p[1] * (square - d[i] * d[j])
    end
  end
  return com, I
end

---- bodies ----------------------------------------------------------------------------------------

-- Every number of a scene has a name: as a parameter, or written in its place.
local names = { "p", "q", "r", "s", "t", "u", "f", "g", "k", "x", "m" }
local values = {
  { "0.7", "-0.6", "0.5", "0.1", "0.2", "0.3", "-1.1", "2.3", "0.9", "0.1", "3" },
  { "-2.9", "1.3", "3.1", "0.4", "-1.6", "2.2", "0.25", "-0.8", "1.7", "0.35", "0.5" }, -- the same scene, other values
}

local first = "{ euler = \"zyx\", angles = {p, q, r} }"
local second = "{ euler = \"zxz\", angles = {s, t, u} }"
local third = "{ euler = \"xyz\", angles = {f, g, k} }"
local brick, can = "solid.box { x = x, y = 0.2, z = 0.3, mass = m }", "solid.cylinder { r = x, h = 0.5, mass = m }"

local function A(e) return euler("zyx", { e.p, e.q, e.r }) end
local function B(e) return euler("zxz", { e.s, e.t, e.u }) end
local function C(e) return euler("xyz", { e.f, e.g, e.k }) end
local function brick_of(e) return box(e.m, e.x, R.parse "0.2", R.parse "0.3") end
local function can_of(e) return cylinder(e.m, e.x, R.parse "0.5") end

-- what, body, its pieces at the values e, structure
local bodies = {
  { "a box, twice", brick .. ":turned" .. first .. ":turned" .. second,
    function(e) return turned(turned(brick_of(e), A(e)), B(e)) end, "full" },
  { "a box, three times", brick .. ":turned" .. first .. ":turned" .. second .. ":turned" .. third,
    function(e) return turned(turned(turned(brick_of(e), A(e)), B(e)), C(e)) end, "full" },
  { "a cylinder, twice", can .. ":turned" .. first .. ":turned" .. second,
    function(e) return turned(turned(can_of(e), A(e)), B(e)) end, "symmetric" },
  { "a tensor with products, twice",
    "tensor { mass = m, xx = 5, yy = 4, zz = 3, xy = -0.5, xz = 0.25, yz = 1 }:turned" .. first .. ":turned" .. second,
    function(e)
      local I = { R.new(5), R.new(4), R.new(3), R.new(-1, 2), R.new(1, 4), R.one }
      return turned(turned(tensor(e.m, I), A(e)), B(e))
    end, "full" },
  { "a box moved, turned, moved, turned, joined",
    brick .. ":at{1, x, 0}:turned" .. first .. ":at{0, -2, x}:turned" .. second .. " + " .. can .. ":at{x, 2, 1}",
    function(e)
      local one = turned(moved(turned(moved(brick_of(e), R.one, e.x, R.zero), A(e)), R.zero, R.new(-2), e.x), B(e))
      return joined(one, moved(can_of(e), e.x, R.new(2), R.one))
    end, "full" },
  { "links lumped over fixed joints",
    "(" .. brick .. ":turned" .. first .. ":at{0.5, 0, 0} + (" .. can .. ":turned" .. second .. ":at{0, 0, x} + " ..
      brick .. ":turned" .. third .. ":at{0, 1, 0}):turned" .. first .. ":at{x, 0, 2})",
    function(e)
      local far = joined(moved(turned(can_of(e), B(e)), R.zero, R.zero, e.x), moved(turned(brick_of(e), C(e)), R.zero,
        R.one, R.zero))
      return joined(moved(turned(brick_of(e), A(e)), R.new(1, 2), R.zero, R.zero), moved(turned(far, A(e)), e.x, R.zero,
        R.new(2)))
    end, "full" },
  { "a box with a hole, both turned twice",
    "(solid.box { x = 20*x, y = 20*x, z = 20*x, density = 800 } - " ..
      "solid.box { x = x, y = x, z = 2*x, density = 800 }:turned" .. first .. ":at{x, 0, 0}):turned" .. second ..
      ":turned" .. third,
    function(e)
      local side, rho = R.new(20) * e.x, R.new(800)
      local cube, hole = box(rho * side ^ 3, side, side, side), box(rho * R.new(2) * e.x ^ 3, e.x, e.x, R.new(2) * e.x)
      return turned(turned(joined(cube, moved(turned(hole, A(e)), e.x, R.zero, R.zero), -1), B(e)), C(e))
    end, "full" },
  { "a box turned about x, y, z, x, y, z",
    brick .. ":turned{axis = \"x\", angle = p}:turned{axis = \"y\", angle = q}:turned{axis = \"z\", angle = r}" ..
      ":turned{axis = \"x\", angle = s}:turned{axis = \"y\", angle = t}:turned{axis = \"z\", angle = u}",
    function(e)
      local list = brick_of(e)
      for i, name in ipairs { "p", "q", "r", "s", "t", "u" } do
        list = turned(list, about(string.sub("xyzxyz", i, i), e[name]))
      end
      return list
    end, "full" },
  { "a box turned, scaled to its mirror image, turned, turned",
    brick .. ":turned" .. first .. ":mirrored \"x\":turned" .. second .. ":turned" .. third,
    function(e)
      local mirror = { { -R.one, R.zero, R.zero }, { R.zero, R.one, R.zero }, { R.zero, R.zero, R.one } }
      return turned(turned(turned(turned(brick_of(e), A(e)), mirror), B(e)), C(e))
    end, "full" },
}

-- The scene with parameters, or with the first values written in.
local function source(body, written)
  local lines = {}
  for i, name in ipairs(names) do
    local unit = name == "x" and ', "m"' or name == "m" and ', "kg"' or ""
    lines[i] = written and string.format("local %s = %s", name, values[1][i]) or
      string.format("local %s = param(%q, %s%s)", name, name, values[1][i], unit)
  end
  return table.concat(lines, "\n") .. "\nreturn scene { name = \"b\", body = " .. body .. " }\n"
end

local function point(k)
  local e = {}
  for i, name in ipairs(names) do e[name] = R.parse(values[k][i]) end
  return e
end

-- Is x = y, both of the size given, to AGREE bits?
local function agree(x, y, size)
  local d = R.abs(x - y)
  return R.sign(d) == 0 or R.log2(d) < R.log2(size) - AGREE
end

for _, b in ipairs(bodies) do
  for _, written in ipairs { false, true } do
    local m, why = scene.read(source(b[2], written))
    local wrong = { not m and why or nil }
    m = m and m.model
    for k = 1, m and (written and 1 or 2) or 0 do
      local e = point(k)
      local com, I = whole(b[3](e))
      local trace = I[1] + I[2] + I[3]
      local function value(x) return evaluate.precise(x, e, 240) end
      for n = 1, 6 do
        if not agree(value(m.inertia[n]), I[n], trace) then wrong[#wrong + 1] = NAMES[n] end
        -- the same in the steps that NAME_init takes, one after the other
        local env = setmetatable({}, { __index = e })
        for _, s in ipairs(m.parts and m.parts.list or {}) do env[s.name] = evaluate.precise(s.e, env, 240) end
        local step = m.parts and m.parts.entries[n]
        if step and not agree(evaluate.precise(step, env, 240), I[n], trace) then
          wrong[#wrong + 1] = NAMES[n] .. " in steps"
        end
      end
      for i = 1, 3 do
        if not agree(value(m.body.com[i]), com[i], R.new(100)) then wrong[#wrong + 1] = "com " .. i end
      end
    end
    if m and m.structure.kind ~= b[4] then wrong[#wrong + 1] = "structure " .. m.structure.kind end
    tap.is(table.concat(wrong, "; "), "", b[1] .. (written and ", in numbers" or ", with parameters") ..
      ": tensor, centre and steps of turned numbers; " .. b[4])
  end
end

---- what turns cannot change ------------------------------------------------------------------------

local ANGLES = {}
for i = 1, 9 do ANGLES[names[i]] = true end

local function read(body) return assert(scene.read(source(body))).model end

do
  local m = read("solid.sphere { r = x, mass = m }:turned" .. first .. ":turned" .. second .. ":turned" .. third)
  tap.is(m.structure.kind, "sphere", "a ball stays one")
  tap.ok(expr.constant(m.inertia[1], ANGLES), "and no angle is in its moment")
end
do
  local m = read(can .. ":turned" .. first .. ":turned" .. second)
  local e = point(1)
  tap.ok(expr.constant(m.structure.alpha, ANGLES),
    "no angle is in the moment of a cylinder across its axis")
  local alpha = e.m * (R.new(3) * e.x ^ 2 + R.new(1, 4)) / R.new(12)
  tap.ok(agree(evaluate.precise(m.structure.alpha, e, 240), alpha, alpha), "which is the handbook's")
  local M, k = product(B(e), A(e)), m.structure.k
  local wrong = 0
  for i = 1, 3 do
    local got = evaluate.precise(k[i], e, 240)
    if not agree(got * M[1][3], M[i][3] * evaluate.precise(k[1], e, 240), R.one) then wrong = wrong + 1 end
  end
  tap.is(wrong, 0, "and the axis is the third column of the product of both matrices")
end
do
  local back = "{ euler = \"xyz\", angles = {-r, -q, -p} }"
  local m = read(brick .. ":turned" .. first .. ":turned" .. back)
  tap.is(m.structure.kind, "diagonal", "turned and turned back: the axes are principal axes again")
  tap.ok(expr.constant(m.inertia[1], ANGLES), "and no angle is left")
end

---- the program: the library and the emitted code ---------------------------------------------------

local dir = program.directory()
program.write(dir .. "/twice.lua", source(bodies[6][2]))
local status, text = program.output(program.quick() .. " check " .. dir .. "/twice.lua")
tap.is(status, 0, "check: the library, which turns numbers, has the body of the emitted code", text)

program.write(dir .. "/tip.obj", "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
program.write(dir .. "/mesh.lua", source("mesh { file = \"tip.obj\", density = 1000 }:turned" .. first .. ":turned" ..
  second .. ":turned" .. third))
status, text = program.output(program.quick() .. " check " .. dir .. "/mesh.lua")
tap.is(status, 0, "and so of a mesh that is turned three times", text)
-- The derivatives by the angles, of which some are 0 only by what the entries of a rotation have to do with each other;
-- the self-test compares them with 240 bits.
program.write(dir .. "/by.lua", source(bodies[1][2]))
status = program.output(string.format("%s gen %s/by.lua --with jacobians --real float -o %s/by", program.quick(), dir,
  dir))
tap.is(status, 0, "derivatives by the angles are emitted in float")
status, text = program.output("make -s -C " .. dir .. "/by check")
tap.ok(status == 0 and text:find("derivative of the equations by the parameters", 1, true),
  "and are those of the formula", text)

program.finish()

tap.done()
