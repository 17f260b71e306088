#!/usr/bin/env lua5.4
-- rotation.t - the forms of an initial attitude against products of elementary matrices, through the whole program.
-- SPDX-License-Identifier: GPL-3.0-or-later

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local program = require "tests.cli.program"

local dir = program.directory()
local binary = os.getenv "POLHODE" or "build/polhode"

-- The matrix at t = 0 of a scene with the attitude, as run gives it; nil and the message after an error.
local function matrix(attitude, before)
  program.write(dir .. "/a.lua", (before or "") .. 'return scene { name = "a", ' ..
    "body = solid.box { x = 3, y = 2, z = 1, mass = 1 }, initial = { omega = {1, 2, 3}, attitude = " .. attitude ..
    "} }")
  local status = program.shell(string.format("%s run %s/a.lua --at 0 --columns matrix >%s/out 2>%s/err", binary, dir,
    dir, dir))
  if status ~= 0 then return nil, program.read(dir .. "/err") end
  local m, i = { {}, {}, {} }, 0
  for x in program.read(dir .. "/out"):match("\n(.*)\n"):gmatch "[^,]+" do
    m[i // 3 + 1][i % 3 + 1] = tonumber(x)
    i = i + 1
  end
  return m
end

local function turn(axis, angle)
  local i = ({ x = 1, y = 2, z = 3 })[axis]
  local j, k = i % 3 + 1, (i + 1) % 3 + 1
  local m = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } }
  m[i][i], m[j][j], m[k][k] = 1, math.cos(angle), math.cos(angle)
  m[j][k], m[k][j] = -math.sin(angle), math.sin(angle)
  return m
end

local function product(a, b)
  local m = {}
  for i = 1, 3 do
    m[i] = {}
    for j = 1, 3 do m[i][j] = a[i][1] * b[1][j] + a[i][2] * b[2][j] + a[i][3] * b[3][j] end
  end
  return m
end

local function same(got, want, name)
  local most = 0.0
  for i = 1, 3 do
    for j = 1, 3 do most = math.max(most, got and math.abs(got[i][j] - want[i][j]) or math.huge) end
  end
  tap.near(most, 0, 0, 2e-15, name, "four rounded components, squared and added; sines of the test")
end

for _, sequence in ipairs { "xyx", "xzx", "yxy", "yzy", "zxz", "zyz", "xyz", "xzy", "yxz", "yzx", "zxy", "zyx" } do
  local m = matrix('{ euler = "' .. sequence .. '", angles = {quantity(20, "deg"), 0.7, quantity(-130, "deg")} }')
  local want = product(product(turn(sequence:sub(1, 1), math.rad(20)), turn(sequence:sub(2, 2), 0.7)),
    turn(sequence:sub(3), math.rad(-130)))
  same(m, want, "Euler angles " .. sequence)
end

same(matrix '{ vector = {0, 0, 0.5} }', turn("z", 0.5), "a rotation vector along z")
same(matrix '{ vector = {0, 0, 0} }', turn("z", 0), "a rotation vector of length 0")
same(matrix '{ vector = {-0.3, 0, 0} }', turn("x", -0.3), "a rotation vector against x")
for _, axis in ipairs { "x", "y", "z" } do -- each of the four columns is the largest once
  for _, angle in ipairs { 0.2, math.pi, 3.0 } do
    local t, rows = turn(axis, angle), {}
    for i = 1, 3 do rows[i] = string.format("{%.17g, %.17g, %.17g}", t[i][1], t[i][2], t[i][3]) end
    same(matrix("{ matrix = {" .. table.concat(rows, ", ") .. "} }"), t,
      string.format("a matrix that turns by %.3g about %s", angle, axis))
  end
end
same(matrix '{ matrix = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}} }',
  { { 0.36, 0.48, -0.8 }, { -0.8, 0.6, 0 }, { 0.48, 0.64, 0.6 } }, "a matrix of decimals")
same(matrix('{ euler = "zxz", angles = {a, 0, 0} }', 'local a = param("a", 30, "deg")\n'), turn("z", math.rad(30)),
  "an angle may be a parameter")
do
  local m, err = matrix '{ euler = "zxz", angles = {30, 0, 0} }'
  tap.ok(m, "plain numbers are rad", err)
  tap.like(program.read(dir .. "/err"), "looks like degrees", "and what looks like degrees is told")
  m, err = matrix '{ matrix = {{1, 0, 0}, {0, 1, 0}, {0, 0.01, 1}} }'
  tap.ok(not m and err:find("at right angles", 1, true), "what is no rotation is refused", err)
end

program.finish()
tap.done()
