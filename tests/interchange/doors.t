#!/usr/bin/env lua5.4
-- doors.t - one fault of a tensor has the same words at every door: a scene's tensor{}, polhode links of URDF, SDF and
-- MJCF, and inertial{} of the three.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Each row is {what it is, "error" | "warning" | "ok", entries xx yy zz xy xz yz as they are typed, words}.  The faulty
-- tensors are right ones of bodies (said in the row) with one slip; the words name it and the numbers.
package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local program = require "tests.cli.program"
local run = require "tests.interchange.program"
local scene = require "tests.scene"

local binary = os.getenv "POLHODE" or "build/polhode"
if binary:sub(1, 1) ~= "/" then binary = assert(io.popen "pwd"):read "l" .. "/" .. binary end

local two_rows = "most likely: the numbers are two rows of the matrix, xx xy xz and yx yy yz, and zz is missing"
local signs = "most likely: xy, xz, yz are products of inertia and want the other sign"

-- A body of 4 kg in a plane: particles of 1 kg at (2, 1, 3), (1, -1, 1) and opposite (tests/mass/slips.t).
local faults = {
  { "right", "ok", "24 30 14 -2 -14 -4" },
  { "signs", "error", "24 30 14 2 14 4", signs },
  { "swapped", "error", "24 30 14 -14 -2 -4", "xy and xz are swapped" },
  { "point", "error", "24 300 14 -2 -14 -4", "triangle inequality about the centre of mass: yy <= zz + xx must " ..
    "hold, got 300 > 14 + 24; most likely: yy has a slipped decimal point (30 would satisfy it)" },
  { "negative", "error", "24 -30 14 0 0 0", "yy must not be negative, got -30" },
  { "product", "error", "24 30 14 0 -140 0", "|xz| <= sqrt((zz + yy - xx)(yy + xx - zz))/2 must hold about the " ..
    "centre of mass, got 140 > 14.142135623730951; most likely: xz has a slipped decimal point (-14 would " ..
    "satisfy it)" },
  -- moments of the matrix 0.031 -0.0042 0; -0.0042 0.028 0; 0 0 0.05, its first two rows in both orders of the six
  { "rows", "error", "0.031 -0.0042 0 -0.0042 0 0.028", "yy must not be negative, got -0.0042; " .. two_rows },
  { "rows2", "error", "0.031 -0.0042 0 -0.0042 0.028 0", "yy must not be negative, got -0.0042; " .. two_rows },
  { "triangle", "error", "0.031 -0.0042 0 0.028 0 0.05", "yy must not be negative, got -0.0042; most likely: the " ..
    "numbers are the rows of the upper triangle, xx xy xz yy yz zz" },
  { "moments", "error", "0.031 -0.0042 0.001 0.028 0.05 0", "yy must not be negative, got -0.0042; most likely: the " ..
    "numbers are xx yy zz xy xz yz and were written to xx xy xz yy yz zz" },
  { "large", "warning", "720e3 760e3 240e3 0 0 0", "the moments look too large for the mass: the radius of gyration " ..
    "sqrt(I/mass) is 436 m (in kg mm^2 it would be 0.436 m)" },
  { "nanometre", "warning", "8.2e-18 8.0e-18 7.8e-18 0 0 0", "the moments look too small for the mass, denser than " ..
    "any metal: the radius of gyration sqrt(I/mass) is 1.43e-09 m" },
  { "rounded", "warning", "0.615 1.155 1.771 0 0 0", "got 1.771 > 0.615 + 1.155: too large by 0.001, which rounding " ..
    "to the digits that are written explains (up to 0.0015); the numbers are taken as they are" },
  { "more", "error", "0.615 1.155 1.773 0 0 0", "got 1.773 > 0.615 + 1.155" },
  -- m L^2/12 = 1/3 along an oblique line, computed in doubles; and one digit of it changed
  { "computed", "ok", "0.2903578429289842 0.2571565325675642 0.11915229117011789 0.05721656552383503 " ..
    "-0.09594026955496174 0.12773263708493615" },
  { "changed", "error", "0.2903578429289842 0.2571565325675642 0.11915229117011789 0.05721656552388503 " ..
    "-0.09594026955496174 0.12773263708493615", "|xy| <= sqrt(" },
}

-- ---- the doors ----

local names = { "xx", "yy", "zz", "xy", "xz", "yz" }

local function split(text)
  local list = {}
  for word in text:gmatch "%S+" do list[#list + 1] = word end
  return list
end

local formats = {
  urdf = { "robot", "link", function(I)
    local at = {}
    for i, name in ipairs(names) do at[i] = "i" .. name .. '="' .. I[i] .. '"' end
    return '<inertial><mass value="4"/><inertia ' .. table.concat(at, " ") .. "/></inertial>"
  end },
  sdf = { "sdf", "link", function(I)
    local in_it = {}
    for i, name in ipairs(names) do in_it[i] = "<i" .. name .. ">" .. I[i] .. "</i" .. name .. ">" end
    return "<inertial><mass>4</mass><inertia>" .. table.concat(in_it) .. "</inertia></inertial>"
  end },
  mjcf = { "mujoco", "body", function(I)
    return '<inertial pos="0 0 0" mass="4" fullinertia="' .. table.concat(I, " ") .. '"/>'
  end },
}

-- What was said of each row: {errors = text, warnings = text} by its name.  Lines are those that name it.
local function by_row(text, warnings)
  local said = {}
  for _, f in ipairs(faults) do said[f[1]] = "" end
  for line in text:gmatch "[^\n]+" do
    local name = line:match '%l+ "m::(%w+)": ' or line:match '%l+ "(%w+)": '
    if said[name] and (line:find("^warning") ~= nil) == warnings then said[name] = said[name] .. line .. "\n" end
  end
  return said
end

local function judged(kind, words, errors, warnings)
  if kind == "ok" then return errors == "" and warnings == "" end
  local right, other = errors, warnings
  if kind == "warning" then right, other = warnings, errors end
  return other == "" and right:find(words, 1, true) ~= nil
end

for _, f in ipairs(faults) do
  local I, entries = split(f[3]), {}
  for i, name in ipairs(names) do entries[i] = name .. " = " .. I[i] end
  local job, why = scene.body("tensor { mass = 4, " .. table.concat(entries, ", ") .. " }")
  local warnings = {}
  for i, w in ipairs(job and job.diag.warnings or {}) do
    if not w.message:find "condition number" then warnings[i] = w.message end -- of the rod, as a body alone
  end
  warnings = table.concat(warnings)
  tap.ok(judged(f[2], f[4], job and "" or why, warnings), "tensor{}: " .. f[1], why or warnings)
end

-- errors are said without warnings, so each kind has a scene of its own
local function imported(file, kind)
  local parts = {}
  for _, f in ipairs(faults) do
    if (f[2] == "error") == (kind == "error") then
      parts[#parts + 1] = string.format('inertial { file = "%s", link = "%s" }', file, f[1])
    end
  end
  -- a line each: what is said twice of one line is said once
  local _, _, err = run.explain('return scene { name = "b", body = ' .. table.concat(parts, " +\n") .. " }", "urdf")
  return err
end

for _, format in ipairs { "urdf", "sdf", "mjcf" } do
  local root, link, write = table.unpack(formats[format])
  local text = {}
  for i, f in ipairs(faults) do
    text[i] = string.format('<%s name="%s">%s</%s>\n', link, f[1], write(split(f[3])), link)
  end
  local all, file = table.concat(text), "r." .. format
  if format == "sdf" then all = '<model name="m">' .. all .. "</model>" end
  if format == "mjcf" then all = "<worldbody>" .. all .. "</worldbody>" end
  run.write(file, "<" .. root .. ">" .. all .. "</" .. root .. ">")
  program.shell(string.format("cd %s && timeout 60 %s links %s >out 2>err", run.dir, binary, file))
  local out = program.read(run.dir .. "/out")
  local links = by_row(out:gsub("\n      ", "\n"), false)
  local errors, warnings = by_row(imported(file, "error"), false), by_row(imported(file, "warning"), true)
  for _, f in ipairs(faults) do
    local word = ({ error = "no", warning = "warn", ok = "ok" })[f[2]]
    local name = (format == "sdf" and "m::" or "") .. f[1]
    tap.ok(("\n" .. out):find("\n" .. word .. ' +"' .. name .. '"'), format .. ": links: " .. f[1] .. " is " .. word,
      out)
    tap.ok(links[f[1]]:find(f[4] or "", 1, true), format .. ": links: " .. f[1], links[f[1]])
    tap.ok(judged(f[2], f[4], errors[f[1]], warnings[f[1]]), format .. ": inertial{}: " .. f[1], errors[f[1]] ..
      warnings[f[1]])
  end
end

run.finish()
tap.done()
