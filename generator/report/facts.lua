-- facts.lua -- what there is to say about a scene, once: every report and banner is written from this.
--
-- Symbolic entries are expressions of the parameters; numbers belong to the parameters' defaults.  The numeric
-- principal axes are Jacobi's on the tensor's values; closed forms stand beside them where they exist.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local principal = require "generator.mass.principal"
local jacobi = require "generator.mass.jacobi"
local law = require "generator.mass.law"

local design = require "generator.report.stability_conditions"
local linearised = require "generator.report.linearised"
local order = require "generator.report.order"

local facts = {}

local words = {
  sphere = "spherical top: all moments equal",
  symmetric = "symmetric top: two moments equal",
  diagonal = "asymmetric top on its principal axes",
  full = "asymmetric top, axes oblique to the body's",
}

-- Omega1, Omega2 per unit spin about principal axis k (Landau, Lifshitz, section 37), and the verdict; I: rationals,
-- for differences of rounded moments have lost digits.
local function stability(I)
  local list = {}
  local function number(q) return R.todouble(R.round(q, 128)) end
  for k = 1, 3 do
    local i, j = k % 3 + 1, (k + 1) % 3 + 1
    local entry = { axis = k, moment = number(I[k]), verdict = "neutral", omega1 = 0.0, omega2 = 0.0, square = 0.0 }
    if R.sign(I[i]) ~= 0 and R.sign(I[j]) ~= 0 then
      local o1, o2 = (I[k] - I[j]) / I[i], (I[k] - I[i]) / I[j]
      local square = number(o1 * o2)
      entry.omega1, entry.omega2, entry.square = number(o1), number(o2), square
      entry.verdict = square > 0 and "stable" or square < 0 and "unstable" or "neutral"
      if square > 0 then entry.period = 2 * math.pi / math.sqrt(square) end
      if square < 0 then entry.growth = math.sqrt(-square) end
    end
    list[k] = entry
  end
  return list
end

-- The axes 1, 2, 3 of order.lua become right-handed, 3 of a symmetric top on the side of the centre of mass, seen from
-- the origin, or if that is the origin on that of the spin.
local function orient(f, w)
  local places = order.of(f)
  local function flip(n) f.axes[places[n]] = vec.scale(-1.0, f.axes[places[n]]) end
  local lever = vec.dot(f.axes[places[3]], f.arm_number)
  local side = lever ~= 0 and lever or vec.dot(f.axes[places[3]], w)
  if f.structure.kind == "symmetric" and side < 0 then flip(3) end
  local e = vec.map(places, function(k) return f.axes[k] end)
  if vec.dot(vec.cross(e[1], e[2]), e[3]) < 0 then flip(2) end
end

-- Everything a report needs of a job (driver.read).
function facts.of(job)
  local m = job.model
  local f = { name = m.name, file = m.file, params = m.params, job = job }
  local function doubles(v) return vec.map(v, function(e) return m:double(e) end) end
  f.mass, f.mass_number = m.mass, m:double(m.mass)
  f.com, f.com_number = m.body.com, doubles(m.body.com) -- in the coordinates of the shape
  f.arm, f.arm_number = m.com, doubles(m.com) -- from the origin of rotation
  f.origin, f.origin_number = m.origin, doubles(m.origin)
  f.inertia, f.inertia_number = m.inertia, doubles(m.inertia)
  f.centroidal, f.centroidal_number = m.centroidal, doubles(m.centroidal)
  local precise
  f.moments, f.axes, precise = jacobi.run(vec.map(m.inertia, function(e) return m:number(e) end))
  local s = m.structure
  if s.kind == "symmetric" then -- equal moments are equal, whatever rounding made of them
    local alpha, axial = m:number(s.alpha), m:number(s.axial)
    precise = axial < alpha and { axial, alpha, alpha } or { alpha, alpha, axial }
    f.moments = vec.map(precise, R.todouble)
  end
  f.closed_moments = principal.closed(m.inertia, m.structure)
  -- a root of a quadratic is written in the entries of the tensor, which are listed above it
  f.closed_named = m.structure.block and principal.closed(vec.map(m.inertia, function(e, n)
    return e.kind == "num" and e or expr.sym("I" .. vec.entry[n], 3)
  end), m.structure) or f.closed_moments
  f.is_central = m.com[1] == expr.zero and m.com[2] == expr.zero and m.com[3] == expr.zero
  f.structure = m.structure
  f.physical = not m.formal or law.lawful(vec.map(m.centroidal, function(e) return m:number(e) end))
  f.symmetry = m.structure.rod and "rod: no moment about its line" or words[m.structure.kind]
  f.stability = stability(precise)
  local w = m.has.rates and doubles(m.omega) or { 0.0, 0.0, 0.0 }
  orient(f, w)
  f.rate = m.has.rates and math.sqrt(vec.dot(w, w)) or 0.0
  f.closed = job.closed
  f.warnings = job.diag.warnings
  -- the same with symbols, for bodies whose principal axes are coordinate axes and whose moments all differ
  if m.structure.kind == "diagonal" then
    f.conditions = {}
    for k = 1, 3 do
      local i, j = k % 3 + 1, (k + 1) % 3 + 1
      local I = m.inertia
      f.conditions[k] = ratio.tidy((I[k] - I[i]) * (I[k] - I[j]) / (I[i] * I[j]))
    end
  end
  design.extend(f)
  linearised.extend(f)
  return f
end

return facts
