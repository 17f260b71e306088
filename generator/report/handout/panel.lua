-- panel.lua -- the hand-out's tensor and equations for the HTML page of a scene, with numbers that the page puts in.
--
--     panel.html(facts) -> text
-- An element with data-value="Ixx" takes that entry's number, "kx" the factor of wy wz in the equation of wx.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local read = require "generator.formula.read"
local tree = require "generator.formula.tree"
local html = require "generator.report.handout.html"
local mass = require "generator.report.handout.mass"
local motion = require "generator.report.handout.motion"
local page = require "generator.report.handout.page"

local panel = {}

local function live(name) return { kind = "live", name } end

local function numbers(p, f)
  local rows = {}
  for i = 1, 3 do
    rows[i] = {}
    for k = 1, 3 do
      local n = mass.entry[i][k]
      rows[i][k] = f.inertia[n] == expr.zero and tree.num "0" or live("I" .. vec.entry[n])
    end
  end
  p:display { { left = p.symbols:own "I", tree.op "=",
    { kind = "quantity", tree.matrix(rows), { kind = "unit", "kg m^2" } } } }
end

-- w'x = k wy wz + ... where the body's axes are principal ones and nothing else has inertia.
local function factors(p, f)
  local m, lines = f.job.model, {}
  for n = 4, 6 do
    if m.inertia[n] ~= expr.zero then return end
  end
  if m.carried ~= m.inertia or m.locked ~= m.inertia or m.structure.rod then return end
  local acted = #m.record.effects > 0
  for i, x in ipairs { "x", "y", "z" } do
    local y, z = string.sub("xyz", i % 3 + 1, i % 3 + 1), string.sub("xyz", (i + 1) % 3 + 1, (i + 1) % 3 + 1)
    local function symbol(text) return read.of(text, p.names) end
    lines[i] = { left = symbol("omega_" .. x .. "'"), tree.op "=", tree.product { live("k" .. x),
      symbol("omega_" .. y), symbol("omega_" .. z) } }
    if acted then
      lines[i][2] = { kind = "sum", { minus = false, node = lines[i][2] },
        { minus = false, node = symbol("{N_" .. x .. "|I_" .. x .. x .. "}") } }
    end
  end
  p:words "In numbers:"
  p:display(lines)
end

function panel.html(f)
  local p = page.of(html, f)
  p:heading "Tensor of inertia"
  p:display(mass.matrix(p, f, nil, f.inertia))
  p:where()
  numbers(p, f)
  p:heading "Euler's equations"
  p:equations { "I ~omega' = " .. (#f.job.record.effects > 0 and "~N " or "") .. "- ~omega x I ~omega" }
  for _, e in ipairs(f.job.record.effects) do motion.effect(p, f, e) end
  motion.components(p, f)
  factors(p, f)
  p:put(mass.said(p))
  return p:done()
end

return panel
