-- run.lua -- polhode run: the motion as a table, by the general library or by the emitted code.
--
-- Columns t,qw,qx,qy,qz,wx,wy,wz,energy,Lx,Ly,Lz; every number reads back to the same double.
-- SPDX-License-Identifier: GPL-3.0-or-later

local options = require "generator.commands.options"
local build = require "generator.commands.build"
local driver = require "generator.driver"
local numeric = require "generator.dynamics.numeric"
local json = require "generator.report.json"

local run = {}

run.options = { ["--engine"] = { "general", "generated" }, ["--method"] = "text", ["--step"] = "number",
  ["--until"] = "number", ["--every"] = "number", ["--at"] = "numbers", ["--format"] = { "csv", "json" },
  ["-o"] = "text",
  ["--real"] = { "double", "float" }, ["--set"] = "pair", ["--tolerance"] = "number" }
run.operands = { 1, 1 }

local columns = { "t", "qw", "qx", "qy", "qz", "wx", "wy", "wz", "energy", "Lx", "Ly", "Lz" }
local general = { adaptive = true, taylor = true, rk4 = true, rkf45 = true, rk8pd = true, ["gsl-rk4"] = true,
  exact = true, linearised = true }

-- Most rows that one call prints; more is a slip of --every.
local most = 1000000

-- The output times, or nil and what is wrong.
local function times(job, given)
  if given.at then
    if given["until"] or given.every then return nil, "--at and --until/--every exclude each other" end
    return given.at
  end
  local finish = given["until"] or job.model:double(job.model.horizon)
  local every = given.every or finish / 100
  if finish <= 0 then return nil, "--until must be positive" end
  if every <= 0 then return nil, "--every must be positive" end
  if finish / every > most then return nil, "more than " .. most .. " rows: --every is too small" end
  local list = {}
  for i = 0, math.floor(finish / every * (1 + 1e-12)) do list[#list + 1] = i * every end
  if list[#list] < finish * (1 - 1e-12) then list[#list + 1] = finish end
  return list
end

local function generated(host, job, given, list)
  local method = given.method or (job.closed.full and "exact" or "rk4")
  if method ~= "rk4" and method ~= "exact" then
    return nil, "--engine generated has the methods rk4 and exact, got " .. method ..
      (method == "linearised" and " (--engine general has it; in C it is the function NAME_linearised)" or "")
  end
  if method == "exact" and not job.closed.full then
    return nil, "method exact: " .. (job.closed.kind and "the closed form of this scene gives the rates only" or
      "this scene has no closed form: " .. job.closed.refused)
  end
  driver.plan(job, { real = given.real, command = "" })
  local plugin, why = build.plugin(host, job)
  if not plugin then return nil, why end
  if plugin:init() ~= 0 then return nil, "the emitted code refuses the scene's own parameters" end
  local s = numeric.scene(job)
  local x0 = { s.q[1], s.q[2], s.q[3], s.q[4], s.w[1], s.w[2], s.w[3] }
  local rows = {}
  if method == "exact" then
    if plugin:solve(x0) ~= 0 then return nil, "the closed form refuses the initial state" end
    for i, t in ipairs(list) do rows[i] = { t, table.unpack(plugin:at(t)) } end
  else
    rows = plugin:integrate(x0, nil, given.step or job.model:double(job.model.step), list)
  end
  for _, row in ipairs(rows) do
    local x = { table.unpack(row, 2, 8) }
    row[9] = plugin:energy(x)
    local L = plugin:momentum(x)
    row[10], row[11], row[12] = L[1], L[2], L[3]
  end
  return rows
end

local function library(host, job, given, list)
  local method = given.method or "adaptive"
  if not general[method] then
    return nil, "--engine general has the methods adaptive, taylor, rk4, gsl-rk4, rkf45, rk8pd, exact, linearised, " ..
      "got " .. method
  end
  local scene = numeric.scene(job)
  if (method == "exact" or method == "linearised") and #scene.effects > 0 then
    return nil, "--engine general --method " .. method .. " solves free tops, and this scene has effects"
  end
  local fixed = given.step or (method == "rk4" or method == "gsl-rk4") and job.model:double(job.model.step) or nil
  return host.run(scene, { method = method, step = fixed, tol = given.tolerance, times = list })
end

local writers = {}

function writers.csv(rows)
  local out = { table.concat(columns, ",") }
  for i, row in ipairs(rows) do
    local cells = {}
    for k = 1, #columns do cells[k] = json.number(row[k]) end
    out[i + 1] = table.concat(cells, ",")
  end
  return table.concat(out, "\n") .. "\n"
end

function writers.json(rows)
  local out = {}
  for i, row in ipairs(rows) do out[i] = row end
  return json.text(json.object { { "columns", columns }, { "rows", out } })
end

function run.run(host, given)
  local job, d, why = driver.read(host, given[1], given)
  if not job then return options.refuse(host, given[1], d, why) end
  local list, wrong = times(job, given)
  local rows
  if list then
    options.warn(host, job.diag)
    rows, wrong = (given.engine == "generated" and generated or library)(host, job, given, list)
  end
  if not rows then
    host.err("polhode run: " .. wrong .. "\n")
    return 2
  end
  local text = writers[given.format or "csv"](rows)
  if given.o then
    local ok, failure = host.write_file(given.o, text)
    if not ok then
      host.err("polhode run: " .. failure .. "\n")
      return 2
    end
  else
    host.out(text)
  end
  return 0
end

return run
