#!/usr/bin/env lua5.4
-- readback.t - every formula of a hand-out is read back from its LaTeX and evaluated: it is what stands beside it.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The scene's own numbers are put in: parameters, the initial state, the tensor, and the values of the motion, which
-- tests/report/values.t compares with the library.  Formulas of general laws, about i, j, k or about times to come,
-- have no value here, and are counted apart.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"
local scenes = require "tests.effects.scenes"
local document = require "tests.report.document"
local driver = require "generator.driver"
local facts = require "generator.report.facts"
local handout = require "generator.report.handout.handout"
local order = require "generator.report.order"
local symbols = require "generator.report.symbols"
local values = require "generator.report.values"

local function key(node) return (string.gsub(node[1] .. (node.sub and "_" .. node.sub or ""), ",", "_")) end

-- What the scene knows by itself, by the names of its symbols.
local function known(f)
  local m, s, env = f.job.model, symbols.of(f), { t = 0.0 }
  for _, p in ipairs(f.params) do env[key(s:of(p.name))] = m:double(p.sym) end
  for _, q in ipairs(m.states) do
    local ok, x = pcall(m.double, m, q.initial)
    if ok then env[key(s:of(q.name))] = x end
  end
  local function own(name, sub, v) env[key(s:own(name, sub))] = v end
  own("M", nil, f.mass_number)
  own("I", nil, document.tensor(f.inertia_number))
  own("I", "c", document.tensor(f.centroidal_number))
  for n, sub in ipairs { "xx", "yy", "zz", "xy", "xz", "yz" } do own("I", sub, f.inertia_number[n]) end
  env["vec_" .. key(s:own("R"))] = nil
  if m.has.rates then
    local w = {}
    for i = 1, 3 do w[i] = m:double(m.omega[i]) end
    env["vec_" .. key(s:own("omega", nil, { vector = true }))] = document.vector(w)
    env["vec_" .. key(s:own("L", nil, { vector = true }))] = document.tensor(f.inertia_number) * document.vector(w)
    for n, k in ipairs(order.of(f)) do
      own("I", tostring(n), f.moments[k])
      local e = f.axes[k]
      env["vec_" .. key(s:own("e", tostring(n), { vector = true }))] = document.vector(e)
      own("omega", tostring(n), w[1] * e[1] + w[2] * e[2] + w[3] * e[3])
    end
  end
  env["vec_" .. key(s:own("R", nil, { vector = true }))] = document.vector(f.arm_number)
  for _, v in ipairs(values.of(f)) do
    local base, sub = string.match(v.symbol, "^(%a+)_?([%w,]*)'?$")
    local dot = string.find(v.symbol, "'") and "dot_" or ""
    if base then
      local name = key(s:own(base, sub ~= "" and sub or nil))
      if dot ~= "" then name = dot .. name end
      env[name] = v.unit == "deg" and math.rad(v.number) or v.number
    end
  end
  return env
end

local total, others = 0, 0
local function check(path, text)
  local job, why = scene.read(text or assert(scene.slurp(path)))
  if not job then return tap.ok(false, path .. " is read", why) end
  local plan, d = driver.plan(job, {})
  if not plan then return tap.ok(false, path .. " is planned", d) end
  local f = facts.of(plan)
  local found = document.check(document.equations(handout.text(f, "latex", { "tensor", "principal", "euler",
    "attitude", "motion", "stability" })), known(f), 4)
  total, others = total + found.fine, others + #found.left
  tap.is(found.wrong[1], nil, string.format("%s: %d formulas are what stands beside them", path, found.fine))
  if os.getenv "POLHODE_LEFT" then
    for _, l in ipairs(found.left) do print("# " .. path .. ": " .. l) end
  end
end

local pipe = assert(io.popen "ls bodies/*.lua")
local bodies = {}
for path in pipe:lines() do bodies[#bodies + 1] = path end
pipe:close()
for _, path in ipairs(tier.every(6, bodies, 2)) do check(path) end
for i = 1, select("#", ...) do check((select(i, ...))) end

-- Parametric scenes at random: POLHODE_SCENES=200 takes so many.
local draw, made = scenes.new(tonumber(os.getenv "POLHODE_SEED" or 37), 0), 0
local wanted = tonumber(os.getenv "POLHODE_SCENES") or tier.quick and 2 or 20
while made < wanted do
  local chosen, kind = {}, ({ "diagonal", "symmetric", "full", "points" })[draw:random(4)]
  for i = 1, draw:random(3) - 1 do chosen[i] = scenes.draw(draw) end
  if #chosen == 0 or select(2, scenes.fits(chosen)) then
    made = made + 1
    local name = "random_" .. made
    check(name, scenes.text(scenes.new(7919 * made, 0.8), name, kind, chosen))
  end
end
print("# " .. total .. " formulas evaluated, " .. others .. " general ones")
tap.ok(total > 10 * #bodies // (tier.quick and 6 or 2), "there are many")
tap.done()
