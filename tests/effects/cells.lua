-- cells.lua -- many scenes by many methods against the library, in one run of the program.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     cells.run(list) -> results       list: of {name =, text = the scene's, methods = {name = true} or nil: all,
--                                      vector = the series in rows of vectors (where the compiler has them)}
--     results: by name, by method {kind =, off =, why =}: "off", by how much; "why", the method does not take the
--              scene; "path", which special path it takes.  A refused scene: scene = {kind = "refused", why =}
--
-- From five states, the scene's own and four at random, over SPAN each: some radian.  off is the largest distance from
-- the library's motion, which it integrates in long double to 1e-13, in parts of `bound`:
--     exact       1e-11: phases of a few radians, to 18 units (tests/emit/top.t), and the library's own tolerance
--     a tolerance of 1e-11: 1e4 of it, as polhode check has it (generator/commands/stepper_checks.lua)
--     a step      h and h/2 say the error's leading term by Richardson's rule (of the method's order, or of the next
--                 one where that term vanishes); a tenth of it may be left, (h |w|)^(order + 1) with |w| = 2, and
--                 rounding: 1e-11
-- A method that goes to another motion is off by what the motions differ, whatever its step.

local program = require "tests.cli.program"
local tree = require "tests.plan.tree"

local cells = {}

local RUNNER = [==[
local list = ...
local SPAN, STEPS = 0.7, 128
local build = require "generator.commands.build"
local driver = require "generator.driver"
local drawn = require "generator.commands.drawn"
local numeric = require "generator.dynamics.numeric"
local stepper_checks = require "generator.commands.stepper_checks"

local text
local own = setmetatable({ read = function() return text end }, { __index = host })

local function distance(job, a, b)
  local d, sign = 0.0, 1.0
  local dot = 0.0
  for i, s in ipairs(job.states) do dot = dot + (s.kind == "attitude" and a[i] * b[i] or 0.0) end
  for i, s in ipairs(job.states) do
    local x = math.abs(a[i] - (s.kind == "attitude" and dot < 0 and -1.0 or 1.0) * b[i]) / (1 + math.abs(b[i]))
    d = (x ~= x or x > d) and x or d
  end
  return d ~= d and math.huge or d
end

local function report(cell, method, ...) say(cell.name, method, ...) end

local function steppers(cell, job, plugin)
  local random, scale = drawn.numbers(0x9E3779B97F4A7C15), { attitude = 1.0 }
  local x0, runs = numeric.initial(job), {}
  for i, s in ipairs(job.states) do
    scale[s.kind] = math.max(scale[s.kind] or (s.kind == "rates" and 1.0 or 0.0), math.abs(x0[i]))
  end
  plugin:init()
  for n = 1, 5 do
    local x = n == 1 and x0 or drawn.state(job, random, scale, "double")
    if n > 1 then
      for i, s in ipairs(job.states) do
        if s.kind ~= "attitude" and s.kind ~= "rates" then x[i] = x0[i] end -- a clock starts at 0
      end
    end
    local from = numeric.from(numeric.scene(job), job, x)
    local rows, why = host.run(from, { method = "adaptive", times = { SPAN }, tol = 1e-13 })
    if not rows then return report(cell, "library", "fails", why) end
    runs[n] = { x = x, want = numeric.part(job, rows[1], 1) }
  end
  for _, s in ipairs(job.steppers) do
    local m, worst, bound, p = s.method, 0.0, 0.0, s.program
    if m.name == "taylor" then
      report(cell, "taylor_path", "path", p.top and "heavy top" or p.axis and "frame about an axis" or p.shift and
        "frame of L" or "none")
    elseif p and p.drift then
      report(cell, "split_path", "path", p.drift.kind)
    end
    for _, r in ipairs(runs) do
      local function at(h)
        local got = plugin:integrate(r.x, nil, h, { SPAN }, nil, m.name)
        return got and { table.unpack(got[1], 2) } or nil
      end
      if m.adaptive then
        local got = at { 1e-11 }
        local e = got and distance(job, got, r.want) or math.huge
        worst, bound = math.max(worst, e / 1e-7), 1e-7
        if m.name == "taylor" then
          got = at(SPAN / 16)
          worst = math.max(worst, got and distance(job, got, r.want) / 1e-9 or math.huge)
        end
      else
        local a, b = at(SPAN / STEPS), at(SPAN / STEPS / 2)
        if a and b then
          local least = math.huge
          for _, order in ipairs { m.order, m.order + 1 } do
            local best, p = {}, 2.0 ^ order
            for i = 1, #a do best[i] = (p * b[i] - a[i]) / (p - 1) end
            least = math.min(least, distance(job, best, r.want))
          end
          bound = 0.1 * distance(job, a, b) / (2.0 ^ m.order - 1) + (2 * SPAN / STEPS) ^ (m.order + 1) + 1e-11
          worst = math.max(worst, least / bound)
        else
          worst = math.huge
        end
      end
    end
    report(cell, m.name, "off", string.format("%.17g", worst))
  end
  if job.closed.kind and job.closed.full then
    local worst = 0.0
    for _, r in ipairs(runs) do
      if plugin:solve(r.x) == 0 then
        worst = math.max(worst, distance(job, { table.unpack(plugin:at(SPAN), 1, #r.x) }, r.want) / 1e-11)
      else
        worst = math.huge
      end
    end
    report(cell, "exact", "off", string.format("%.17g", worst))
  end
end

for first = 1, #list, 16 do
  local plans, of = {}, {}
  for i = first, math.min(first + 15, #list) do
    local cell = list[i]
    text = cell.text
    local ok, scene, d, why = pcall(driver.read, own, cell.name .. ".lua", {})
    if not ok then
      report(cell, "scene", "crash", scene)
    elseif not scene then
      report(cell, "scene", "refused", (string.gsub(d and d:report() or tostring(why), "\n", " ")))
    else
      local done, names, others = pcall(stepper_checks.choice, scene)
      if not done then report(cell, "choice", "crash", names) names, others = {}, {} end
      local asked = {}
      for _, name in ipairs(names) do
        if not cell.methods or cell.methods[name] then asked[#asked + 1] = name end
      end
      for _, o in ipairs(others) do report(cell, o[1], "why", o[2]) end
      if #asked > 0 then
        local good, job, wrong = pcall(driver.plan, scene, { real = "double", command = "", methods = asked })
        if good and job then
          plans[#plans + 1] = { job = job, flags = { "-O0", "-w",
            table.unpack(cell.vector and { "-march=native", "-DS_VECTOR" } or {}) } }
          of[#of + 1] = cell
        else
          report(cell, "plan", "crash", (string.gsub(tostring(good and wrong and wrong:report() or job), "\n", " ")))
        end
      end
    end
  end
  local fine, plugins, failed = pcall(build.plugins, host, plans)
  for i, plan in ipairs(plans) do
    local plugin, why = fine and plugins[i], fine and failed and failed[i] and failed[i].message
    if not fine then -- one of them stops the program: which?
      local good, one, wrong = pcall(build.plugins, host, { plan })
      plugin, why = good and one[1], good and wrong and wrong[1].message or one
    end
    local good, raised = true, nil
    if plugin then good, raised = pcall(steppers, of[i], plan.job, plugin) end
    if not plugin or not good then report(of[i], "code", "crash", (string.gsub(tostring(why or raised), "\n", " "))) end
  end
end
]==]

function cells.run(list)
  local rows = {}
  for i, c in ipairs(list) do
    local methods = {}
    for name in pairs(c.methods or {}) do methods[#methods + 1] = string.format("[%q] = true", name) end -- a set
    rows[i] = string.format("{ name = %q, text = %q, vector = %s, methods = %s }", c.name, c.text,
      tostring(c.vector or false), c.methods and "{ " .. table.concat(methods, ", ") .. " }" or "nil")
  end
  local out, err, status = tree("return (function(...)\n" .. RUNNER .. "\nend)({\n" .. table.concat(rows, ",\n") ..
    "})", program.quick_compiler())
  local results = { err = err, status = status }
  for line in out:gmatch "[^\n]+" do
    local name, method, kind, rest = line:match "^(%S+) (%S+) (%S+) ?(.*)$"
    if name then
      results[name] = results[name] or {}
      results[name][method] = { kind = kind, off = kind == "off" and tonumber(rest) or nil, why = rest }
    end
  end
  return results
end

return cells
