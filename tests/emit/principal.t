#!/usr/bin/env lua5.4
-- principal.t - principal axes of the emitted code and of the library: every tensor of the reference table and random
-- ones that are hard, judged exactly (tests/mass/axes.lua).
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The emitted function is compiled as it is delivered, in double and in float, by gcc and clang, with and without
-- optimisation and with products fused into sums; the library's is called through the same program.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local axes = require "tests.mass.axes"
local scene = require "tests.scene"
local R = require "generator.algebra.rational"

local dir = program.directory()
local two = R.new(2)

-- ---- what is promised ----

-- Rounding once costs half a unit; the judge's steps are an eighth.  The requirement is 2 and, for a graded positive
-- definite tensor, 1e-14 of itself, which is 45 units of 2^-52.
local NORM, OWN = 1.0, 1.0
-- `bits` that the method works with, a dozen roundings of these magnified by the condition on top of the unit.
local function own_bar(condition, format, bits) return OWN + 12 * condition * 2.0 ^ (format.p - bits) end
local REQUIRED = 1e-14 * 2.0 ^ 52 -- a library of 64 bits is held to what the condition leaves, where that is enough
-- Unit vectors rounded once: |x.y| <= 2 * 2^-p sum |x_i y_i| <= 2^(1-p), and the square of 2^-p; the requirement is
-- 4e-16 = 1.8 units.
local SKEW = 1 + 2.0 ^ -20
-- A x - m x for x off by half a unit, |A dx| <= |A| 2^-p, and m off by half a unit of the largest.  Library: as much.
local RESIDUE = 1 + 2.0 ^ -8 -- 2^-8: its long double has 11 bits more than the result

-- ---- programs that read tensors and print axes, as hexadecimal numbers ----

local main = [[
#include <stdio.h>
%s
int main(void)
{
  double in[6];
  while (scanf("%%lf %%lf %%lf %%lf %%lf %%lf", in, in + 1, in + 2, in + 3, in + 4, in + 5) == 6) {
    real I[6], moments[3], axes[9];
    int i;
    for (i = 0; i < 6; i++) I[i] = (real)in[i];
    for (i = 0; i < 3; i++) moments[i] = (real)-7;
    for (i = 0; i < 9; i++) axes[i] = (real)-7;
    printf("%%d", principal(I, moments, axes));
    for (i = 0; i < 3; i++) printf(" %%a", (double)moments[i]);
    for (i = 0; i < 9; i++) printf(" %%a", (double)axes[i]);
    printf("\n");
  }
  return 0;
}
]]

local emitted = [[
#include "top.h"
typedef top_real real;
static int principal(const real *I, real *moments, real *axes) { return top_principal_of(I, moments, axes); }
]]

local library = [[
#include "polhode.h"
typedef double real;
static int principal(const real *I, real *moments, real *axes)
{
  ph_axes p;
  int i, status = ph_principal(I, &p);
  if (status) return status;
  for (i = 0; i < 9; i++) axes[i] = p.axis[i/3][i%3];
  for (i = 0; i < 3; i++) moments[i] = p.moment[i];
  return 0;
}
]]

local function build(name, command)
  local log = dir .. "/log"
  local code = program.shell(string.format("%s -o %s/%s >%s 2>&1", command, dir, name, log))
  tap.ok(code == 0, name .. ": compiles without a warning", program.read(log))
  return code == 0
end

local function spelled(I) return string.format("%a %a %a %a %a %a", table.unpack(I)) end

-- The answers of program `name` to a list of tensors: lines, and the numbers {status, moments, vectors}.
local function ask(name, tensors)
  local lines = {}
  for i, I in ipairs(tensors) do lines[i] = spelled(I) .. "\n" end
  program.write(dir .. "/in", table.concat(lines))
  local code = program.shell(string.format("timeout 60 %s/%s <%s/in >%s/out", dir, name, dir, dir))
  local text = program.read(dir .. "/out")
  local answers = {}
  for line in text:gmatch "[^\n]+" do
    local n = {}
    for word in line:gmatch "%S+" do n[#n + 1] = tonumber(word) or 0.0 / 0.0 end
    answers[#answers + 1] = { status = n[1], moments = { n[2], n[3], n[4] }, vectors = { table.unpack(n, 5, 13) } }
  end
  return tap.ok(code == 0 and #answers == #tensors, name .. ": answers " .. #tensors .. " tensors") and answers, text
end

-- Judges answers by family: one check for each promise, and the worst numbers for the reader.
local function judge(name, format, bits, cases, answers)
  local order, worst = {}, {}
  for i, c in ipairs(cases) do
    local family, I, condition = table.unpack(c)
    local bar = condition and own_bar(condition, format, bits)
    local graded = bar and bar <= REQUIRED
    local w = worst[family]
    if not w then
      w = { n = 0, norm = 0.0, own = 0.0, skew = 0.0, residue = 0.0, sane = true, bar = bar or 0.0 }
      worst[family], order[#order + 1] = w, family
    end
    local a = answers[i]
    local e = axes.measure(I, a.moments, a.vectors, format, graded)
    w.n = w.n + 1
    for _, field in ipairs { "norm", "own", "skew", "residue" } do
      if e[field] > w[field] then w[field], w[field .. "_at"] = e[field], spelled(I) end
    end
    if not (a.status == 0 and e.handed and e.ascending and e.signed) then w.sane, w.sane_at = false, spelled(I) end
  end
  local function within(family, field, bar, what)
    local w = worst[family]
    tap.ok(w[field] <= bar, string.format("%s, %s: %s", name, family, what),
      string.format("%.4g, at %s", w[field], tostring(w[field .. "_at"])))
  end
  for _, family in ipairs(order) do
    local w = worst[family]
    within(family, "norm", NORM, "moments to a unit of the largest")
    if w.own > 0 then within(family, "own", w.bar, "moments to a unit of their own, magnified by the condition") end
    within(family, "skew", SKEW, "axes orthonormal")
    within(family, "residue", RESIDUE, "I axis = moment axis")
    tap.ok(w.sane, string.format("%s, %s: right-handed, ascending, signs by the rule", name, family), w.sane_at)
    tap.diag(string.format("%-16s %-45s %4d: %.3f ulp of the largest, %.3f of its own, skew %.3f eps, residue %.3f eps",
      name, family, w.n, w.norm, w.own, w.skew, w.residue))
  end
end

-- ---- the tensors ----

local EACH = 60
local rows = {}
for id, category, I, moments, simple in axes.reference(scene.slurp "tests/reference/eigen.h") do
  rows[#rows + 1] = { id = id, category = category, I = I, moments = moments, simple = simple }
end
tap.is(#rows, 44, "the reference table was read")

local function cases(format)
  local list, tensors = {}, {}
  local function add(family, I, graded)
    list[#list + 1], tensors[#tensors + 1] = { family, I, graded }, I
  end
  for _, row in ipairs(rows) do
    local I = {}
    for n = 1, 6 do
      I[n] = format.name == "float" and R.tofloat(R.fromdouble(row.I[n])) or row.I[n]
    end
    -- what leaves the range of float, or becomes another tensor there, is left to the families
    local held = true
    for n = 1, 6 do held = held and math.abs(I[n]) < math.huge and (I[n] ~= 0 or row.I[n] == 0) end
    if held then add("reference: " .. row.category, I, row.category == "graded" and 20) end
  end
  for family, I, graded in axes.families(format, EACH) do add(family, I, graded) end
  return list, tensors
end

-- ---- emitted ----

local function emit(real)
  local job = assert(scene.read('return scene { name = "top", body = solid.box { x = 1, y = 2, z = 3, mass = 4 } }'))
  local where = dir .. "/" .. real
  program.shell("mkdir -p " .. where)
  job = scene.plan(job, { real = real })
  local files = scene.files(job)
  program.write(where .. "/top.c", files["top.c"])
  program.write(where .. "/top.h", files["top.h"])
  program.write(where .. "/main.c", string.format(main, emitted))
end

local WARN = "-std=c99 -pedantic -Wall -Wextra -Wconversion -Wdouble-promotion -Wshadow -Werror"
local builds = { -- the first one is judged, the others must agree with it to the bit
  { "gcc", "gcc -O2 -ffp-contract=off" }, { "gcc0", "gcc -O0 -ffp-contract=off" },
  { "clang", "clang -O2 -ffp-contract=off" },
}
local fused = { "fused", "gcc -O3 -march=native -ffp-contract=fast" } -- other bits, the same promises

local answers_of = {}

for _, real in ipairs { "double", "float" } do
  local format = axes[real]
  local bits = 2 * format.p - 6 -- of the pairs, after their own roundings
  emit(real)
  local list, tensors = cases(format)
  local first
  for _, b in ipairs(builds) do
    local name = real .. "-" .. b[1]
    if build(name, string.format("%s %s %s/%s/top.c %s/%s/main.c -lm", b[2], WARN, dir, real, dir, real)) then
      local answers, text = ask(name, tensors)
      if answers and not first then
        first, answers_of[real] = text, answers
        judge("emitted " .. real, format, bits, list, answers)
      elseif answers then
        tap.ok(text == first, name .. ": the same bits as " .. builds[1][1])
      end
    end
  end
  local name = real .. "-" .. fused[1]
  if build(name, string.format("%s %s %s/%s/top.c %s/%s/main.c -lm", fused[2], WARN, dir, real, dir, real)) then
    local answers = ask(name, tensors)
    if answers then judge("fused " .. real, format, bits, list, answers) end
  end
end

-- ---- the library ----

do
  program.write(dir .. "/library.c", string.format(main, library))
  local command = string.format("gcc -O2 -Wall -Wextra -Werror -Isrc/runtime %s/library.c build/libpolhode.a -lm", dir)
  if build("library", command) then
    local list, tensors = cases(axes.double)
    local answers = ask("library", tensors)
    answers_of.library = answers
    if answers then judge("library", axes.double, 64, list, answers) end
  end
end

-- ---- the table's own digits ----

-- bits: those the method works with.  A simple axis is off by its rounding and by 2^-bits norm/gap, times a dozen.
local function table_digits(name, answers, bits)
  for i, row in ipairs(rows) do
    local a, want = answers[i], row.moments
    local norm = R.abs(want[1]) > R.abs(want[3]) and R.abs(want[1]) or R.abs(want[3])
    local unit, near, own, turned = axes.ulp(norm, axes.double), true, true, true
    for k = 1, 3 do
      local off = R.abs(R.fromdouble(a.moments[k]) - want[k])
      near = near and off <= unit
      if row.category == "graded" then own = own and off <= want[k] * R.parse "1e-14" end
      local axis = row.simple[k]
      if axis then
        local gap, along = nil, R.zero
        for j = 1, 3 do
          local d = R.abs(want[j] - want[k])
          if j ~= k and (not gap or d < gap) then gap = d end
          along = along + axis[j] * R.fromdouble(a.vectors[3 * k - 3 + j])
        end
        for j = 1, 3 do
          local d = R.abs(R.fromdouble(a.vectors[3 * k - 3 + j]) - R.new(R.sign(along)) * axis[j])
          turned = turned and d <= two ^ -53 + R.new(16) * norm / gap / two ^ bits
        end
      end
    end
    tap.ok(near and own, string.format("%s, %s: the table's moments", name, row.id))
    tap.ok(turned, string.format("%s, %s: the table's axes", name, row.id))
  end
end

if answers_of.double then table_digits("emitted", answers_of.double, 100) end
if answers_of.library then table_digits("library", answers_of.library, 63) end

-- ---- what must not change, and what is refused ----

local permutations = { { 1, 2, 3 }, { 1, 3, 2 }, { 2, 1, 3 }, { 2, 3, 1 }, { 3, 1, 2 }, { 3, 2, 1 } }
local place = { { 1, 4, 5 }, { 4, 2, 6 }, { 5, 6, 3 } }

-- The tensor with coordinate axis i renamed s[i].
local function renamed(I, s)
  local J = {}
  for i = 1, 3 do
    for j = i, 3 do J[place[s[i]][s[j]]] = I[place[i][j]] end
  end
  return J
end

local function invariance(name, format)
  local list = {}
  for family, I in axes.families(format, 20) do
    if family == "generic" then list[#list + 1] = I end
  end
  local tensors = {}
  for _, I in ipairs(list) do
    for _, s in ipairs(permutations) do tensors[#tensors + 1] = renamed(I, s) end
    for _, power in ipairs { format.lowest + 2 * format.p, format.highest - 4 } do
      local J = {}
      for n = 1, 6 do J[n] = I[n] * 2.0 ^ power end
      tensors[#tensors + 1] = J
    end
  end
  local answers = ask(name, tensors)
  if not answers then return end
  local ulp = 2.0 ^ (1 - format.p)
  local same, scaled = true, true
  for i = 1, #list do
    local base = 8 * (i - 1)
    local a = answers[base + 1]
    for n, s in ipairs(permutations) do
      local b = answers[base + n]
      for k = 1, 3 do
        -- moments of order 1 that differ by more than 2^-20: rounding turns the axes by nothing that shows
        if math.abs(a.moments[k] - b.moments[k]) > ulp * math.abs(a.moments[k]) then same = false end
        local along = 0.0
        for j = 1, 3 do along = along + a.vectors[3 * k - 3 + j] * b.vectors[3 * k - 3 + s[j]] end
        for j = 1, 3 do
          local x, y = a.vectors[3 * k - 3 + j], b.vectors[3 * k - 3 + s[j]]
          if math.abs(math.abs(x) - math.abs(y)) > ulp * math.abs(x) or x * y * along < 0 then same = false end
        end
      end
    end
    for n = 7, 8 do
      local b = answers[base + n]
      for k = 1, 9 do scaled = scaled and a.vectors[k] == b.vectors[k] end
    end
  end
  tap.ok(same, name .. ": other names of the coordinate axes rename the principal axes, signs apart")
  tap.ok(scaled, name .. ": a tensor scaled by a power of two has the same axes to the bit")

  local infinite, most = math.huge, (2 - ulp) * 2.0 ^ (format.highest - 1)
  local odd = { { infinite, 1.0, 1.0, 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0, 0.0, -infinite, 0.0 },
    { 1.0, 0.0 / 0.0, 1.0, 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0, 0.0, 0.0, 0.0 / 0.0 },
    { most, most, most, most, most, most } }
  answers = ask(name, odd)
  for i, a in ipairs(answers or {}) do
    local untouched = a.status ~= 0
    for k = 1, 3 do untouched = untouched and a.moments[k] == -7 end
    for k = 1, 9 do untouched = untouched and a.vectors[k] == -7 end
    tap.ok(untouched, name .. ": refuses, and leaves the results alone: " .. spelled(odd[i]))
  end
  answers = ask(name, { { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 }, { most, -most, 2.0 ^ format.lowest, 0.0, 0.0, 0.0 },
    { 2.0, 2.0, 1.0, 0.0, 0.0, 0.0 }, { 3.0, 2.0, 1.0, 0.0, 0.0, 0.0 } })
  local want = { { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 },
    { -most, 2.0 ^ format.lowest, most, 0, 1, 0, 0, 0, 1, 1, 0, 0 },
    { 1, 2, 2, 0, 0, 1, 1, 0, 0, 0, 1, 0 }, { 1, 2, 3, 0, 0, 1, 0, 1, 0, -1, 0, 0 } }
  for i, a in ipairs(answers or {}) do
    local got = { a.moments[1], a.moments[2], a.moments[3], table.unpack(a.vectors) }
    local equal = a.status == 0
    for k = 1, 12 do equal = equal and got[k] == want[i][k] and (got[k] ~= 0 or 1 / got[k] > 0) end
    tap.ok(equal, name .. ": a diagonal tensor's entries and the coordinate axes, to the bit", table.concat(got, " "))
  end
end

for _, real in ipairs { "double", "float" } do
  if answers_of[real] then invariance(real .. "-gcc", axes[real]) end
end
if answers_of.library then invariance("library", axes.double) end

tap.done()
