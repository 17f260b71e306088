-- motion.lua -- the hand-out's sections on the motion: equations, closed form and values, stability.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local effects = require "generator.report.handout.effects"
local mass = require "generator.report.handout.mass"
local math_ = require "generator.report.handout.math"
local notation = require "generator.report.handout.values"
local values = require "generator.report.values"

local motion = {}

local axes = { "x", "y", "z" }

-- The three terms that a turning frame adds, each with its name and, for a body that moves, its components.
local function frame(p, f, e)
  p:text("In a frame that turns at the rate $~Omega$ the second derivative is, term by term, the relative " ..
    "acceleration, the Coriolis term, the Euler term and the centripetal acceleration $~Omega x ( ~Omega x ~r )$:")
  p:equations { "~a_inertial = ~r'' + 2 ~Omega x ~r' + ~Omega' x ~r + ~Omega x ( ~Omega x ~r )" }
  p:text("Taken to the side of the forces, each changes its sign. So the negative of the centripetal acceleration, " ..
    "times the mass, is the centrifugal force:")
  p:equations { '~F_Coriolis = - 2 M ~Omega x ~v', '~F_centrifugal = - M ~Omega x ( ~Omega x ~r )',
    "~F_Euler = - M ~Omega' x ~r" }
  if not f.job.model.has.position then
    p:words "The centre of mass does not move in this scene, so these forces do no work on it."
    return
  end
  local r = vec.map({ 1, 2, 3 }, function(i) return expr.sym("r" .. axes[i], 7) end)
  local v = vec.map({ 1, 2, 3 }, function(i) return expr.sym("v" .. axes[i], 7) end)
  local t = expr.sym("t", 7)
  local rate = vec.map(e.a.rate, function(x, i) return x + e.a.rate_dot[i] * t end)
  local two = expr.num(2)
  local lines = {}
  local function put(name, u)
    for i = 1, 3 do
      if u[i] ~= expr.zero then p:line(lines, math_.sym("F", name .. "," .. axes[i]), -f.mass * u[i]) end
    end
  end
  put("Coriolis", vec.map(vec.cross(rate, v), function(x) return two * x end))
  if e.a.centrifugal then put("centrifugal", vec.cross(rate, vec.cross(rate, r))) end
  put("Euler", vec.cross(e.a.rate_dot, r))
  p:display(lines)
  if not e.a.centrifugal then p:words "The scene leaves the centrifugal force out." end
end

local function effect(p, f, e)
  local name = string.gsub(e.kind, "^effect%.", "")
  p:words("Effect " .. string.gsub(name, "_", " ") .. ": " .. e.spec.about .. ".")
  if name == "rotating_frame" then return frame(p, f, e) end
  local list = effects[e.kind] or {}
  if #list > 0 then p:equations(list) end
end

-- Lines for the constants of the equations, with short names k_1, k_2, ...; entries of the tensor and of its inverse
-- keep theirs.  Second result: is there one of the inverse?
local function constants(p, f)
  local shown, used, lines = {}, {}, {}
  for _, list in ipairs { f.inertia, f.arm, { f.mass } } do
    for _, e in ipairs(list) do shown[e] = true end
  end
  for _, g in ipairs(f.job.equations.groups) do
    for _, list in ipairs { g.defs, g.outs } do
      for _, d in ipairs(list) do
        for _, s in ipairs(expr.symbols(d.expr)) do used[s.name] = true end
      end
    end
  end
  local n, inverse = 0, false
  for _, member in ipairs(f.job.model.members) do
    if used[member.name] and member.name ~= "M" then
      inverse = inverse or string.find(member.name, "^J[xyz][xyz]$") ~= nil
      if not string.find(member.name, "^[IJRL][xyz]+$") and not p.symbols.of_name[member.name] then
        n = n + 1
        p.symbols.of_name[member.name] = p.symbols:of("k_" .. n)
      end
      if not (shown[member.e] and string.find(member.name, "^[IR][xyz]+$")) then
        p:line(lines, p.symbols:of(member.name), member.e, f.job.model:double(member.e))
      end
    end
  end
  return lines, inverse
end

-- Lines for the intermediate values and the derivatives of a group of equations.
local function rates(p, g)
  local lines = {}
  for _, d in ipairs(g.defs) do p:line(lines, p.symbols:of(d.name), d.expr) end
  for _, o in ipairs(g.outs) do
    local node = p.symbols:of(o.state)
    p:line(lines, math_.sym(node[1], node.sub, { dot = 1 }), o.expr)
  end
  return lines
end

function motion.euler(p, f)
  local m = f.job.model
  p:heading "Equations of motion"
  if m.has.rates then
    p:text "The torque changes the angular momentum, $~L' = ~N$ in inertial axes. Seen from the body:"
    p:equations { "I ~omega' = ~N - ~omega x I ~omega" }
    p:words "In principal axes these are Euler's equations:"
    p:equations { "I_1 omega_1' = ( I_2 - I_3 ) omega_2 omega_3 + N_1",
      "I_2 omega_2' = ( I_3 - I_1 ) omega_3 omega_1 + N_2", "I_3 omega_3' = ( I_1 - I_2 ) omega_1 omega_2 + N_3" }
    p:text("A point $~r$ of the body has the acceleration $~omega' x ~r + ~omega x ( ~omega x ~r )$. The second " ..
      "term is the centripetal acceleration; its negative is the centrifugal force per mass in axes of the body.")
  end
  for _, e in ipairs(f.job.record.effects) do effect(p, f, e) end
  if #f.job.record.effects == 0 then p:text "No torque acts: $~N = 0$." end
  p:words "For this body, component by component:"
  local lines, inverse = constants(p, f) -- first: they give names
  for _, g in ipairs(f.job.equations.groups) do
    local word = string.match(g.why, "^([^:,]+)")
    if #g.defs + #g.outs > 0 then
      p:words((string.gsub(word, "^%l", string.upper)))
      p:display(rates(p, g))
    end
  end
  if #lines > 0 then
    p:text("with the constants, cancelled" .. (inverse and ", where $J$ is the inverse of $I$:" or ":"))
    p:display(lines)
  end
  p:where()
end

local laws = { ["T+V"] = "the energy $T + V$", ["|L|"] = "the size of $~L$", L = "$~L$ in inertial axes",
  L_z = "$L_z$ in inertial axes", w3 = "$omega_3$ along the symmetry axis", ["T+V-n.L"] = "Jacobi's integral" }

local widest = 90 -- letters of a value's line with its words; a longer one gets them on the next line

function motion.motion(p, f)
  p:heading "Motion"
  if f.closed.kind then
    p:words("This motion has a closed form: " .. f.closed.theorem .. ".")
    local formulas = notation.closed[f.closed.kind]
    if formulas then
      p:equations(formulas)
    else
      p:words(table.concat(f.closed.text, " "))
    end
  else
    p:words("This motion has no closed form: " .. f.closed.refused .. ". It is integrated.")
  end
  local list = {}
  for i, law in ipairs(f.job.conserved) do list[i] = laws[law] or law end
  p:text(#list > 0 and "Conserved: " .. table.concat(list, ", ") .. "." or "Nothing is conserved.")
  local lines = {}
  for _, v in ipairs(values.of(f)) do
    local symbol, formula, what = table.unpack(notation.row(v), 1, 3)
    local left = math_.read(symbol, p.names)
    local line = { left = left }
    if formula then
      line[1], line[2] = math_.op "=", math_.read(formula, p.names)
    end
    line[#line + 1] = math_.op "approx"
    line[#line + 1] = math_.number(v.number, 6, v.unit)
    lines[#lines + 1] = line
    if math_.width(math_.row(left, table.unpack(line))) + #what > widest then
      line = {}
      lines[#lines + 1] = line
    end
    line[#line + 1] = math_.op "quad"
    line[#line + 1] = math_.word(what)
  end
  if #lines == 0 then return end
  p:words "Values of this scene's initial state:"
  p:display(lines)
end

function motion.stability(p, f)
  if not f.job.model.has.rates then return end
  p:heading "Stability of a spin about a principal axis"
  p:text("Let the body spin at the rate $omega$ about the principal axis $k$, and let $i$ and $j$ be the other two. " ..
    "Euler's equations without torque, to first order in the small rates $omega_i$ and $omega_j$, are")
  p:equations { "I_i omega_i' = ( I_j - I_k ) omega omega_j", "I_j omega_j' = ( I_k - I_i ) omega omega_i",
    "Omega^2 = {( I_k - I_i ) ( I_k - I_j )|I_i I_j} omega^2" }
  p:text("If $Omega^2$ is positive, the small rates oscillate and the spin is stable: about the axes of the " ..
    "least and of the largest moment. About the middle axis $Omega^2$ is negative, and the small rates grow as an " ..
    "exponential. With dissipation inside the body, only the axis of the largest moment stays stable.")
  if #f.job.record.effects > 0 then p:words "For the body without its effects:" end
  local lines = {}
  local function relative(index) -- Omega_index^2/omega^2
    return math_.frac(math_.pow(math_.sym("Omega", index), math_.num "2"), math_.pow(p.symbols:own "rate",
      math_.num "2"))
  end
  for n, k in ipairs(mass.order(f)) do
    local s = f.stability[k]
    lines[n] = { left = relative(tostring(n)), math_.op "approx", math_.number(s.square, 5), math_.op "quad",
      math_.word("about axis " .. n .. ": " .. s.verdict) }
  end
  p:display(lines)
  lines = {}
  for k, e in ipairs(f.conditions or {}) do
    p:line(lines, relative(axes[k]), e)
  end
  if #lines > 0 then p:words "In the body's own quantities, about its axes:" end
  p:display(lines)
  p:where()
end

return motion
