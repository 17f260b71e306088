#!/usr/bin/env lua5.4
-- free_top.t - the free top with many digits: the reference table, the oracle, the equations of motion.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- tests/reference has 32 digits, computed otherwise.  tests/oracle/free_top.c (Carlson's integrals, amplitudes, angles;
-- another road altogether) prints 40.  Both take doubles exactly.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local R = require "generator.algebra.rational"
local elliptic = require "generator.algebra.elliptic"
local free_top = require "generator.dynamics.free_top"
local tops = require "tests.dynamics.tops"

local BITS = 200
local slack = R.new(2) ^ -50

local function numbers(text, read)
  local list = {}
  for word in text:gmatch "[^,%s]+" do list[#list + 1] = assert(read(word:gsub("L$", "") .. "")) end
  return list
end
local function double(word) return R.fromdouble(tonumber(word) + 0.0) end

-- Largest difference of the rates over the largest of them, and of the attitudes.
local function distance(x, q, w)
  local size, rates, attitude = R.zero, R.zero, R.zero
  local function larger(a, b) return a < b and b or a end
  for i = 1, 3 do
    size = larger(size, R.abs(w[i]))
    rates = larger(rates, R.abs(w[i] - x[4 + i]))
  end
  for i = 1, 4 do attitude = larger(attitude, R.abs(q[i] - x[i])) end
  return R.todouble(R.sign(size) == 0 and rates or rates / size), R.todouble(attitude)
end

-- ---- the table ----

do
  local file = assert(io.open "tests/reference/free_top.h")
  local text = file:read "a"
  file:close()
  local pattern = '{"([%w%p]-)", {(.-)}, {(.-)}, {(.-)}, (%S+),%s*{(.-)},%s*{(.-)},'
  local n, worst, at = 0, 0, ""
  for id, tensor, w0, q0, t, w, q in text:gmatch(pattern) do
    local x0 = numbers(q0 .. "," .. w0, double)
    local top = free_top.new(numbers(tensor, double), x0, BITS, slack)
    local dw, dq = distance(top:at(double(t)), numbers(q, R.parse), numbers(w, R.parse))
    local d = math.max(dw, dq)
    if d > worst then worst, at = d, id .. " t = " .. t end
    n = n + 1
  end
  -- 32 significant digits are printed: half a unit of the last is at most 5e-32 of the largest component
  tap.ok(n >= 275 and worst <= 5e-32, string.format("%d samples, all printed digits: %.3g", n, worst), at)
end

-- ---- the oracle, at hard states ----

local program = os.getenv "POLHODE_ORACLE" or "build/oracle/free_top"

local cases, lines = {}, {}
tops.seed(20)
for n = 1, 180 do
  local v, words = tops.draw(n % tops.kinds), {}
  for i = 1, 14 do
    words[i] = string.format("%a", v[i])
    v[i] = R.fromdouble(v[i])
  end
  cases[n], lines[n] = v, table.concat(words, " ")
end
local input, output = os.tmpname(), os.tmpname()
local file = assert(io.open(input, "w"))
file:write(table.concat(lines, "\n"), "\n")
file:close()
tap.ok(os.execute(program .. " < " .. input .. " > " .. output), "the oracle runs", "make " .. program .. " builds it")
local n, worst, at = 0, {}, {}
for line in io.lines(output) do
  n = n + 1
  local v, want = cases[n], numbers(line, R.parse)
  local top = free_top.new({ table.unpack(v, 1, 6) }, { v[10], v[11], v[12], v[13], v[7], v[8], v[9] }, BITS, slack)
  local dw, dq = distance(top:at(v[14]), { table.unpack(want, 4, 7) }, { table.unpack(want, 1, 3) })
  local kind = n % tops.kinds
  local d = math.max(dw, dq)
  if d > (worst[kind] or 0) then worst[kind], at[kind] = d, lines[n] end
end
os.remove(input)
os.remove(output)
tap.is(n, #cases, "the oracle answers every line")
for kind = 0, tops.kinds - 1 do
  -- 41 digits are printed: half a unit of the last, and 200 bits
  tap.ok(worst[kind] and worst[kind] <= 1e-40, string.format("kind %d: 40 digits: %.3g", kind, worst[kind] or 0),
    at[kind])
end

-- ---- elliptic integrals ----

-- F(phi, k) over the quadrant is K; the addition theorem F(phi) + F(psi) = K with tan phi tan psi = 1/k'
local kc, bits = R.new(3, 1000000), 300
local K = elliptic.complete(kc, bits)
local function close(a, b, what) tap.ok(R.abs(a - b) <= R.abs(b) * R.new(2) ^ -290, what) end
close(elliptic.first(R.zero, R.one, kc, bits), K, "F(pi/2) = K")
for _, y in ipairs { R.new(1, 10) ^ 40, R.new(1, 3), R.one, R.new(577), R.new(10) ^ 9 } do
  close(elliptic.first(R.one, y, kc, bits) + elliptic.first(kc * y, R.one, kc, bits), K, "F(phi) + F(psi) = K")
end

tap.is(free_top.new({ R.one, R.one, R.one, R.zero, R.zero, R.zero }, { R.zero, R.zero, R.zero, R.zero, R.one, R.one,
  R.one }, BITS), nil, "no quaternion, no motion")
tap.done()
