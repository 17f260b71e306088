-- run.lua -- polhode run: the motion as a table, by the general library or by the emitted code.
--
-- Events of the scene follow: a second table after an empty line (CSV), or the member `events` (JSON); an event with
-- stop = true ends the table with its row.
-- Columns t,qw,qx,qy,qz,wx,wy,wz,energy,Lx,Ly,Lz,rx,ry,rz,vx,vy,vz and further states, those that the scene has; every
-- number reads back to the same double.
-- SPDX-License-Identifier: GPL-3.0-or-later

local events = require "generator.commands.events"
local options = require "generator.commands.options"
local build = require "generator.commands.build"
local driver = require "generator.driver"
local gen = require "generator.commands.gen"
local methods = require "generator.methods.list"
local numeric = require "generator.dynamics.numeric"
local json = require "generator.report.json"

local run = {}

run.options = { ["--engine"] = { "general", "generated" }, ["--method"] = "text", ["--step"] = "number",
  ["--until"] = "number", ["--every"] = "number", ["--at"] = "numbers", ["--format"] = { "csv", "json" },
  ["-o"] = "text",
  ["--real"] = { "double", "float" }, ["--set"] = "pair", ["--tolerance"] = "number", ["--order"] = "number" }
run.operands = { 1, 1 }

-- The names of the columns, and a row of them from t, the scene's state, energy and L (nil without attitude).
local function columns(job)
  local list, first = { "t" }, {}
  for i, s in ipairs(job.states) do
    if s.kind == "attitude" or s.kind == "rates" then
      list[#list + 1], first[#first + 1] = s.name, i
    end
  end
  list[#list + 1] = "energy"
  for _, name in ipairs(job.model.has.attitude and { "Lx", "Ly", "Lz" } or {}) do list[#list + 1] = name end
  for i = #first + 1, #job.states do list[#list + 1] = job.states[i].name end
  return list, function(t, x, energy, L)
    local row = { t, table.unpack(x, 1, #first) }
    row[#row + 1] = energy
    for _, y in ipairs(job.model.has.attitude and L or {}) do row[#row + 1] = y end
    for i = #first + 1, #x do row[#row + 1] = x[i] end
    return row
  end
end

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

-- Both engines give a function of a list of times: the rows, or nil and what went wrong.
local function generated(host, job, given)
  local method = given.method or (job.closed.full and "exact" or "rk4")
  if method ~= "exact" and not methods.by_name[method] then
    local names = { "exact" }
    for _, m in ipairs(methods) do names[#names + 1] = m.name end
    return nil, "--engine generated has the methods " .. table.concat(names, ", ") .. ", got " .. method ..
      (method == "linearised" and " (--engine general has it; in C it is the function NAME_linearised)" or "")
  end
  if method == "exact" and not job.closed.full then
    return nil, "method exact: " .. (job.closed.kind and "the closed form of this scene gives the rates only" or
      "this scene has no closed form: " .. job.closed.refused)
  end
  local order, wrong = gen.order(given)
  wrong = wrong or gen.orderless(given, { method })
  if wrong then return nil, wrong end
  if given.tolerance and not (methods.by_name[method] or {}).adaptive then
    return nil, "--tolerance: the method " .. method .. " has a fixed step"
  end
  if not driver.plan(job, { real = given.real, command = "", methods = { method }, order = order }) then
    return nil, job.diag:report()
  end
  local plugin, why = build.plugin(host, job)
  if not plugin then return nil, why end
  if plugin:init() ~= 0 then return nil, "the emitted code refuses the scene's own parameters" end
  local x0 = numeric.initial(job)
  if method == "exact" and plugin:solve(x0) ~= 0 then return nil, "the closed form refuses the initial state" end
  local _, row_of = columns(job)
  return function(list)
    local rows = {}
    if method == "exact" then
      for i, t in ipairs(list) do rows[i] = { t, table.unpack(plugin:at(t)) } end
    else
      local adaptive = methods.by_name[method].adaptive and not given.step
      local step = adaptive and { given.tolerance or 1e-12 } or given.step or job.model:double(job.model.step)
      rows = plugin:integrate(x0, nil, step, list, 0, method)
      if not rows then return nil, "method " .. method .. ": no steps lead to the end; is there a singularity?" end
    end
    for i, row in ipairs(rows) do
      local x = { table.unpack(row, 2) }
      rows[i] = row_of(row[1], x, plugin:energy(x), job.model.has.attitude and plugin:momentum(x) or nil)
    end
    return rows
  end
end

local function library(host, job, given)
  local method = given.method or "adaptive"
  if not general[method] then
    return nil, "--engine general has the methods adaptive, taylor, rk4, gsl-rk4, rkf45, rk8pd, exact, linearised, " ..
      "got " .. method
  end
  if given.order then return nil, "--order: it is that of the emitted taylor, got --engine general" end
  local scene = numeric.scene(job)
  if (method == "exact" or method == "linearised") and #scene.effects > 0 then
    return nil, "--engine general --method " .. method .. " solves free tops, and this scene has effects"
  end
  local fixed = given.step or (method == "rk4" or method == "gsl-rk4") and job.model:double(job.model.step) or nil
  local _, row_of = columns(job)
  return function(list)
    local rows, why = host.run(scene, { method = method, step = fixed, tol = given.tolerance, times = list })
    if not rows then return nil, why end
    for i, row in ipairs(rows) do
      local n = #row - 4
      rows[i] = row_of(row[1], numeric.part(job, row, 1), row[n + 1], { table.unpack(row, n + 2) })
    end
    return rows
  end
end

-- The events of the scene up to the last of the times, and the rows up to one that stops: found, rows.
local function with_events(job, given, solve, list, rows)
  if #job.record.events == 0 then return {}, rows end
  local wrong = events.missing(job)
  if wrong then return nil, wrong end
  local finish = 0
  for _, t in ipairs(list) do finish = math.max(finish, t) end
  if finish == 0 then return {}, rows end
  local found
  found, wrong = events.find(job, solve, (columns(job)), finish, given.step or job.model:double(job.model.step))
  if not found then return nil, wrong end
  local last = found[#found]
  if not last or not last.event.stop then return found, rows end
  local kept = {}
  for _, row in ipairs(rows) do
    if row[1] < last.row[1] then kept[#kept + 1] = row end
  end
  kept[#kept + 1] = last.row
  return found, kept
end

local writers = {}

function writers.csv(rows, names, found)
  local out = { table.concat(names, ",") }
  for i, row in ipairs(rows) do
    local cells = {}
    for k = 1, #names do cells[k] = json.number(row[k]) end
    out[i + 1] = table.concat(cells, ",")
  end
  local text = table.concat(out, "\n") .. "\n"
  if not found then return text end
  out = { "event," .. table.concat(names, ",") }
  for i, f in ipairs(found) do
    local cells = { f.event.name }
    for k = 1, #names do cells[k + 1] = json.number(f.row[k]) end
    out[i + 1] = table.concat(cells, ",")
  end
  return text .. "\n" .. table.concat(out, "\n") .. "\n"
end

function writers.json(rows, names, found)
  local out = {}
  for i, row in ipairs(rows) do out[i] = row end
  local members = { { "columns", names }, { "rows", out } }
  if found then
    local list = {}
    for i, f in ipairs(found) do list[i] = json.object { { "name", f.event.name }, { "row", f.row } } end
    members[3] = { "events", list }
  end
  return json.text(json.object(members))
end

function run.run(host, given)
  local job, d, why = driver.read(host, given[1], given)
  if not job then return options.refuse(host, given[1], d, why) end
  local list, wrong = times(job, given)
  local solve, rows, found
  if list then
    options.warn(host, job.diag)
    solve, wrong = (given.engine == "generated" and generated or library)(host, job, given)
  end
  if solve then rows, wrong = solve(list) end
  if rows then
    found, wrong = with_events(job, given, solve, list, rows)
    if found then rows = wrong end
  end
  if not found then
    host.err("polhode run: " .. wrong .. "\n")
    return 2
  end
  local text = writers[given.format or "csv"](rows, (columns(job)), #job.record.events > 0 and found or nil)
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
