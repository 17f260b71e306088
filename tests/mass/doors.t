#!/usr/bin/env lua5.4
-- doors.t - each check on a body has the same words at each door; the table of checks is that of docs/mass.md.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- From the rows of checks.lua: one parameter of a lawful scene takes a bad value, and each door must refuse it with the
-- rule's words; where the emitted code cannot ask (open rows), it must say so, and sweep, design and fit ask all the
-- same.  One scene is compiled once for all its rows, but for design.  The doors here are the scene (with --set),
-- NAME_init, sweep, design, fit, chart, view, and the projects python and fmu.  Mesh files and files of other programs
-- have tests of their own (the field `by`); so have the ways by which a page, a module or an FMU tells of a check: here
-- their lists of checks must be NAME_init's.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local checks = require "tests.mass.checks"
local program = require "tests.cli.program"
local scene = require "tests.scene"
local tap = require "tests.tap"

local dir = program.directory()

local function polhode(arguments)
  local code, out, err = program.output(program.quick() .. " " .. arguments)
  return out .. err, code
end

local function rows_of(name)
  local list = {}
  for _, row in ipairs(checks.rows) do
    if row[2] == name then list[#list + 1] = row end
  end
  return list
end

local function title(door, row) return door .. ": " .. row[2] .. ", " .. row[3] .. " = " .. row[4] .. ": " .. row[5] end

-- ---- the table of the manual ----

do
  local page, by = scene.slurp "docs/mass.md", {}
  for _, c in ipairs(checks.list) do
    by[c[1]] = c
    tap.ok(page:find(checks.line(c), 1, true), "docs/mass.md: " .. c.about, checks.line(c))
  end
  local asked = {}
  for _, row in ipairs(checks.rows) do asked[row[1]] = by[row[1]].code end
  local missing = {}
  for _, c in ipairs(checks.list) do
    if not asked[c[1]] and not c.by and c[1] ~= "range" then missing[#missing + 1] = c[1] end
  end
  tap.is(table.concat(missing, " "), "", "each check has a row here or a test of its own")
end

-- ---- the scene ----

local jobs, names = {}, {}
for name in pairs(checks.scenes) do names[#names + 1] = name end
table.sort(names)
for _, name in ipairs(names) do
  local text = checks.scenes[name]
  local job, why = scene.read(text, { file = name .. ".lua" })
  tap.ok(job, "the scene " .. name .. " is lawful", why)
  jobs[name] = job
  program.write(dir .. "/" .. name .. ".lua", text)
end

for _, row in ipairs(checks.rows) do
  local job, why = scene.read(checks.scenes[row[2]], { set = { [row[3]] = tostring(row[4]) } })
  tap.ok(not job and why:find(row[5], 1, true), title("--set", row), why)
end

-- ---- NAME_init, and the lists of checks of what is made from it ----

local MAIN = [[
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "NAME.h"
int main(int n, char **given)
{
  static const char *const names[] = { NAMES };
  for (int i = 1; i + 1 < n; i += 2) {
    NAME_real p[NAME_COUNT];
    NAME_model m;
    NAME_defaults(p);
    for (int k = 0; k < NAME_COUNT; k++)
      if (strcmp(names[k], given[i]) == 0) p[k] = (NAME_real)atof(given[i + 1]);
    printf("%d\n", NAME_init(&m, p));
  }
  return 0;
}
]]

-- What NAME_init returns for each row, compiled from `folder`.
local function statuses(name, folder, rows)
  local params, words = {}, { "g 0.1" }
  for i, p in ipairs(jobs[name].model.params) do params[i] = '"' .. p.name .. '"' end
  program.write(folder .. "/main.c", (MAIN:gsub("NAMES", table.concat(params, ", ")):gsub("NAME_COUNT", #params)
    :gsub("NAME", name)))
  for i, row in ipairs(rows) do words[i + 1] = row[3] .. " " .. row[4] end
  program.shell(string.format("cc -std=c99 -O0 -o %s/main %s/main.c %s/%s.c -lm", folder, folder, folder, name))
  local _, out = program.output(folder .. "/main " .. table.concat(words, " "))
  local list = {}
  for word in out:gmatch "%d+" do list[#list + 1] = tonumber(word) end
  return list
end

local has_clang = program.shell "command -v clang wasm-ld >/dev/null" == 0

for _, name in ipairs(names) do
  local rows, file = rows_of(name), dir .. "/" .. name .. ".lua"
  local made = {}
  for _, kind in ipairs { "make", "python", "fmu" } do
    made[kind] = polhode(string.format("gen --project %s -o %s/%s_%s %s", kind, dir, name, kind, file))
  end
  local folder = dir .. "/" .. name .. "_make"
  local header = program.read(folder .. "/" .. name .. ".h"):gsub("\n %* ", " "):gsub("%s+", " ")
  local list = statuses(name, folder, rows)
  tap.is(list[1], 0, "NAME_init: " .. name .. ": the defaults are accepted")
  local texts = jobs[name].model.conditions
  for i, row in ipairs(rows) do
    local status = list[i + 1]
    if row.open then
      tap.is(status, 0, title("NAME_init does not ask", row))
      tap.ok(header:find("Not a check of the set-up, for there is no formula: " .. row[5], 1, true),
        title("the header says so", row), header)
      for _, kind in ipairs { "make", "python", "fmu" } do
        tap.like(made[kind], row[5] .. ", which the generated code does not ask", title(kind .. " warns", row))
      end
    else
      local text = texts[status] and texts[status].text or "status " .. status
      tap.ok(text:find(row[5], 1, true), title("NAME_init", row), text)
      tap.ok(header:find(status .. " " .. text, 1, true), title("header", row), header)
    end
  end
  -- projects and the page have these texts, each as it stands (an FMU is an archive that stores its sources)
  local has = {}
  for door, files in pairs { python = "src/*.c", fmu = "*.fmu" } do
    has[door] = select(2, program.output(string.format("cat %s/%s_%s/%s", dir, name, door, files)))
  end
  if has_clang then
    local said = polhode(string.format("view -o %s/%s.html %s", dir, name, file))
    has.view = program.read(dir .. "/" .. name .. ".html")
    if #jobs[name].model.unasked > 0 then tap.like(said, ", which the page does not ask", "view warns: " .. name) end
  end
  for door, text in pairs(has) do
    local lost = {}
    for _, c in ipairs(texts) do
      if not text:find(c.text, 1, true) then lost[#lost + 1] = c.text end
    end
    tap.is(table.concat(lost, "\n"), "", door .. ": the list of checks of " .. name)
  end
end

-- ---- sweep: all rows of a scene at once, on a grid of lawful and bad values ----

for _, name in ipairs(names) do
  local rows, over, lawful = rows_of(name), {}, {}
  for _, p in ipairs(jobs[name].model.params) do lawful[p.name] = tonumber((p.given:match "^%S+")) end
  local seen = {}
  for _, row in ipairs(rows) do
    if not seen[row[3]] then
      local good = lawful[row[3]]
      over[#over + 1] = string.format("%s=%s:%s:2", row[3], math.min(good, row[4]), math.max(good, row[4]))
      seen[row[3]] = row
    end
  end
  local out = polhode(string.format("sweep %s/%s.lua --over %s --keep 'final: T = t'", dir, name,
    table.concat(over, ",")))
  local heads = {}
  for word in out:match "^[^\n]*":gmatch "[^,]+" do heads[#heads + 1] = word end
  for _, row in pairs(seen) do
    local found
    for line in out:gmatch "[^\n]+" do
      local values, alone = {}, true
      for word in line:gmatch "[^,]+" do values[#values + 1] = word end
      for i, head in ipairs(heads) do
        if seen[head] then
          local x = tonumber(values[i])
          alone = alone and x == (head == row[3] and row[4] or lawful[head])
        end
      end
      if alone then found = line end
    end
    tap.ok(found and found:find("no body: ", 1, true) and found:find(row[5], 1, true), title("sweep", row),
    found or out)
  end
  tap.like(out, ",ok\n", "sweep: " .. name .. ": the lawful member is computed")
end

-- ---- design and chart ----

for _, row in ipairs(checks.rows) do
  local good
  for _, p in ipairs(jobs[row[2]].model.params) do
    if p.name == row[3] then good = tonumber((p.given:match "^%S+")) end
  end
  local low, high = math.min(good, row[4]), math.max(good, row[4])
  local file = dir .. "/" .. row[2] .. ".lua"
  local out = polhode(string.format("design %s --free g --until 0.1 --over %s=%s:%s:2", file, row[3], low, high))
  tap.ok(out:find "note: 1 of the candidates are refused" and out:find(row[5], 1, true), title("design", row), out)
  local function invalid(a, b)
    local text = polhode(string.format("chart %s --over %s=%.17g:%.17g,g=0.1:0.2", file, row[3], a, b))
    if not text:find "<svg" then return text end
    return text:find 'class="invalid"' ~= nil
  end
  if row.open then
    tap.like(polhode(string.format("chart %s --over %s=%s:%s,g=0.1:0.2", file, row[3], low, high)),
      row[5] .. ", which the chart does not show", title("chart says", row))
  elseif row[4] ~= 0 then -- at 0 the bad value is a line of no width
    tap.is(invalid(low, high), true, title("chart", row))
    local near = good - (row[4] - good) * 1e-3 -- on the other side
    tap.is(invalid(math.min(good, near), math.max(good, near)), false, title("chart, lawful", row))
  end
end

-- ---- fit: a log of a body whose hole is 1.1 m wide, and scenes in which it may have 1 m at most ----
--
-- The log is that of a tensor, from the formulas of box and cylinder: cubes of 1 m and 1000 kg, at y = 0 and, where the
-- emitted code cannot ask, also at y = 3 and -3; the hole of radius 0.55 and height 0.5 along z.

for _, far in ipairs { false, true } do
  local M, R, h = 1000, 0.55, 0.5
  local m, cubes, steiner = 1000 * math.pi * R ^ 2 * h, far and 3 or 1, far and 18 * M or 0
  local across, along = m * (3 * R ^ 2 + h ^ 2) / 12, m * R ^ 2 / 2
  local more = [[ initial = { omega = { 1, 2, 3 } }, time = { horizon = 5, step = 0.01 }, measure = { wx = wx, wy = wy,
    wz = wz, sigma = 1e-3 } }]]
  local function cube(y) return "solid.box { x = 1, y = 1, z = 1, density = 1000 }:at { 0, " .. y .. ", 0 }" end
  program.write(dir .. "/log.lua", string.format("return scene { name = 'log', body = tensor { mass = %.17g, " ..
    "xx = %.17g, yy = %.17g, zz = %.17g }, " .. more, cubes * M - m, cubes * M / 6 + steiner - across, cubes * M / 6 -
    across, cubes * M / 6 + steiner - along))
  program.write(dir .. "/wide.lua", 'local r = param("r", 0.3, "m") return scene { name = "wide", body = ' .. cube(0) ..
    (far and " + " .. cube(3) .. " + " .. cube(-3) or "") .. " - solid.cylinder { r = r, h = 0.5, density = 1000 }, " ..
    more)
  polhode(string.format("run %s/log.lua --columns t,wx,wy,wz -o %s/log.csv", dir, dir))
  local out, status = polhode(string.format("fit %s/wide.lua --data %s/log.csv --free r", dir, dir))
  tap.is(status, 3, "fit: a hole that would be too wide is no answer")
  tap.like(out, (far and "WRONG: the result is no body: " or "WRONG: the search ended at the border of the rule ") ..
    "hole: must lie inside the body it is cut from", "fit says why, " .. (far and "by points" or "by the emitted code"))
end

tap.done(program.finish())
