-- motion.lua -- the hand-out's sections on the motion: equations, closed form and values, stability.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local read = require "generator.formula.read"
local tree = require "generator.formula.tree"
local effects = require "generator.report.handout.effects"
local closed = require "generator.report.handout.closed"
local formula = require "generator.report.handout.formula"
local order = require "generator.report.order"
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
      if u[i] ~= expr.zero then p:line(lines, p.symbols:own("F", name .. "," .. axes[i]), -f.mass * u[i]) end
    end
  end
  put("Coriolis", vec.map(vec.cross(rate, v), function(x) return two * x end))
  if e.a.centrifugal then put("centrifugal", vec.cross(rate, vec.cross(rate, r))) end
  put("Euler", vec.cross(e.a.rate_dot, r))
  p:display(formula.grouped(lines))
  if not e.a.centrifugal then p:words "The scene leaves the centrifugal force out." end
end

function motion.effect(p, f, e)
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
  local inverse, bare = false, false
  for _, e in ipairs(f.job.record.effects) do -- with what moves in the body, the code's L has its part
    for _, x in ipairs(e.kind == "effect.inertia_rate" and axes or {}) do
      p.symbols.of_name["L" .. x] = p.symbols:own("L", x .. ",t")
    end
  end
  for _, member in ipairs(f.job.model.members) do
    if used[member.name] and member.name ~= "M" then
      inverse = inverse or string.find(member.name, "^J[xyz][xyz]$") ~= nil
      local entry = string.match(member.name, "^I([xyz]+)$")
      local own = entry and not shown[member.e] -- the code's tensor, without what turns within the body
      bare = bare or own
      if own then
        p.symbols.of_name[member.name] = p.symbols:own("I", entry .. ",b")
      elseif not string.find(member.name, "^[IJRL][xyz]+$") and not p.symbols.of_name[member.name] then
        p.symbols.of_name[member.name] = p.symbols:fresh "k"
      end
      if not (shown[member.e] and string.find(member.name, "^[IR][xyz]+$")) then
        p:line(lines, p.symbols:of(member.name), member.e, f.job.model:double(member.e))
      end
    end
  end
  return lines, inverse, bare
end

-- Lines for the intermediate values and the derivatives of a group of equations.  A value that is called as a constant
-- hides it within its group, as in C.
local function rates(p, g, constant)
  local lines, hidden = {}, {}
  for _, d in ipairs(g.defs) do
    local node
    if constant[d.name] then
      hidden[d.name] = p.symbols.of_name[d.name]
      node = p.symbols:fresh "k"
    end
    p:line(lines, node or p.symbols:of(d.name), d.expr)
    if node then p.symbols.of_name[d.name] = node end
  end
  for _, o in ipairs(g.outs) do
    local node = p.symbols:of(o.state)
    p:line(lines, tree.sym(node[1], node.sub, { dot = 1 }), o.expr)
  end
  for name, node in pairs(hidden) do p.symbols.of_name[name] = node end -- a map to a map: order is lost anyway
  return lines
end

-- The equations of this body, component by component; attitude: with those of the attitude.
function motion.components(p, f, attitude)
  local lines, inverse, bare = constants(p, f) -- first: they give names
  local shown, constant = {}, {}
  for _, member in ipairs(f.job.model.members) do constant[member.name] = true end
  for _, g in ipairs(f.job.equations.groups) do
    local word = string.match(g.why, "^([^:,]+)")
    if #g.defs + #g.outs > 0 and (attitude or word ~= "attitude") then shown[#shown + 1] = { word = word, g = g } end
  end
  p:words("For this body, component by component" .. (#shown == 0 and "" or ":"))
  for _, s in ipairs(shown) do
    if #shown > 1 then p:words((string.gsub(s.word, "^%l", string.upper)) .. ":") end
    p:display(formula.grouped(rates(p, s.g, constant)))
  end
  if #lines > 0 then
    p:text("with the constants" .. (inverse and ", where $J$ is the inverse of the tensor" or "") .. (bare and
      ", $I_b$ the tensor without what turns in the body about its own axis" or "") .. ":")
    p:display(formula.grouped(lines))
  end
  p:where()
end

function motion.euler(p, f, asked)
  local m = f.job.model
  p:heading "Equations of motion"
  if m.has.rates then
    p:text("A vector $~e$ that is fixed in the body changes by $~e' = ~omega x ~e$. So the torque, which changes " ..
      "the angular momentum by $~L' = ~N$ in inertial axes, gives in the axes of the body")
    p:equations { "I ~omega' + ~omega x I ~omega = ~N" }
    p:words "In principal axes these are Euler's equations:"
    p:equations { "I_1 omega_1' = ( I_2 - I_3 ) omega_2 omega_3 + N_1",
      "I_2 omega_2' = ( I_3 - I_1 ) omega_3 omega_1 + N_2", "I_3 omega_3' = ( I_1 - I_2 ) omega_1 omega_2 + N_3" }
    p:text("A point $~r$ of the body has the velocity $~omega x ~r$ and, by the same rule once more, the " ..
      "acceleration $~omega' x ~r + ~omega x ( ~omega x ~r )$. The second term is the centripetal acceleration.")
  end
  for _, e in ipairs(f.job.record.effects) do motion.effect(p, f, e) end
  if #f.job.record.effects == 0 then p:text "No torque acts: $~N = 0$." end
  motion.components(p, f, asked.attitude or not m.has.rates)
end

local laws = { ["T+V"] = "the energy $T + V$", ["|L|"] = "the size of $~L$", L = "$~L$ in inertial axes",
  L_z = "$L_z$ in inertial axes", w3 = "$omega_3$ along the symmetry axis", ["T+V-n.L"] = "Jacobi's integral" }

local widest = 92 -- letters of a value's line with its words; a longer one gets them on the next line
local longest = 75 -- letters of such words

local function folded(words)
  local lines = {}
  while #words > longest do
    local head = string.match(string.sub(words, 1, longest), "^(.*) ")
    lines[#lines + 1] = head
    words = string.sub(words, #head + 2)
  end
  lines[#lines + 1] = words
  return lines
end

function motion.motion(p, f)
  p:heading "Motion"
  if f.closed.kind then
    p:words("This motion has a closed form: " .. f.closed.theorem .. ".")
    local formulas = closed.of(f)
    if formulas then
      p:equations(formulas, true)
    else
      p:text(table.concat(f.closed.text, " "))
    end
  else
    p:words("This motion has no closed form: " .. f.closed.refused .. ". It is integrated.")
  end
  local list = {}
  for i, law in ipairs(f.job.conserved) do list[i] = laws[law] or law end
  p:text(#list > 0 and "Conserved: " .. table.concat(list, ", ") .. "." or "Nothing is conserved.")
  local lines = {}
  for _, v in ipairs(values.of(f)) do
    local left, what = read.of(v.symbol, p.names), v.what
    local line = { left = left }
    if v.formula then
      line[1], line[2] = tree.op "=", read.of(v.formula, p.names)
    end
    line[#line + 1] = tree.op "approx"
    line[#line + 1] = tree.number(v.number, 6, v.unit)
    lines[#lines + 1] = line
    for _, words in ipairs(folded(what)) do
      if tree.width(tree.row(left, table.unpack(line))) + #words > widest then
        line = {}
        lines[#lines + 1] = line
      end
      line[#line + 1] = tree.op "quad"
      line[#line + 1] = tree.word(words)
    end
  end
  if #lines == 0 then return end
  p:words "Values of this scene's initial state:"
  p:display(lines)
end

-- The numbers of a spin about the axis n at the rate of the initial state; at 1 rad/s where nothing turns.
local function about(p, f, n, rate)
  local s, i, j = f.stability[order.of(f)[n]], n % 3 + 1, (n + 1) % 3 + 1
  local indices = { ["(k)"] = n, ["(i)"] = i, ["(j)"] = j }
  local function set(text) return read.of((string.gsub(text, "%(%a%)", indices)), p.names) end
  local lines = {}
  local function number(x) return tree.number(x * rate, 5, "rad/s") end
  if f.structure.rod then return p:words("About axis " .. n .. ": " .. s.verdict .. ".") end
  p:text(string.format("About axis %d, with $I_i = I_%d$ and $I_j = I_%d$, the spin is %s:", n, i, j, s.verdict))
  lines[1] = { left = p.symbols:own("Omega", "1"), tree.op "=", set "{I_(k) - I_(j)|I_(i)} omega_0", tree.op "approx",
    number(s.omega1) }
  lines[2] = { left = p.symbols:own("Omega", "2"), tree.op "=", set "{I_(k) - I_(i)|I_(j)} omega_0", tree.op "approx",
    number(s.omega2) }
  if s.period then
    lines[3] = { left = set "sqrt(Omega_1 Omega_2)", tree.op "approx", number(math.sqrt(s.square)) }
  elseif s.growth then
    lines[3] = { left = set "sigma", tree.op "approx", number(s.growth) }
  end
  p:display(formula.beside(lines, true))
end

function motion.stability(p, f)
  if not f.job.model.has.rates then return end
  p:heading "Stability of a spin about a principal axis"
  p:text("Let the body spin at the rate $omega_0$ about the principal axis $~e_k$, and let $~e_i$ and $~e_j$ be the " ..
    "other two, in cyclic order. Euler's equations without torque, to first order in the small rates $omega_i$ and " ..
    "$omega_j$, are")
  p:equations({ "I_i omega_i' = ( I_j - I_k ) omega_0 omega_j", "I_j omega_j' = ( I_k - I_i ) omega_0 omega_i" }, true)
  p:words "or"
  p:equations({ "omega_i' = - Omega_1 omega_j", "omega_j' = Omega_2 omega_i", "Omega_1 = {I_k - I_j|I_i} omega_0",
    "Omega_2 = {I_k - I_i|I_j} omega_0" }, true)
  p:text("About the axes of the least and of the largest moment both rates $Omega_1$ and $Omega_2$ have one sign. " ..
    "The small rates oscillate, and the spin is stable:")
  p:equations({ "omega_i = A cos( sqrt(Omega_1 Omega_2) t + psi_0 )",
    "|omega_j| = A sqrt({Omega_2|Omega_1}) |sin( sqrt(Omega_1 Omega_2) t + psi_0 )|" }, true)
  p:text("About the middle axis the signs differ. The small rates grow as an exponential, and the spin is unstable:")
  p:equations { "omega_i = C_1 exp( sigma t ) + C_2 exp( - sigma t ) , \"with\" sigma = sqrt(- Omega_1 Omega_2)" }
  local rate = f.rate > 0 and f.rate or 1.0
  p:text("With dissipation inside the body, only the axis of the largest moment stays stable. For this body" ..
    (#f.job.record.effects > 0 and ", without its effects," or "") .. " and")
  p:display { { left = p.symbols:own("omega", "0"), tree.op(f.rate > 0 and "approx" or "="),
    tree.number(rate, 5, "rad/s") } }
  for n = 1, 3 do about(p, f, n, rate) end
  local lines = {}
  for k, e in ipairs(f.conditions or {}) do
    local entries = { ["(k)"] = axes[k] .. axes[k], ["(i)"] = axes[k % 3 + 1] .. axes[k % 3 + 1],
      ["(j)"] = axes[(k + 1) % 3 + 1] .. axes[(k + 1) % 3 + 1] }
    local left = string.gsub("{( I_(k) - I_(i) ) ( I_(k) - I_(j) )|I_(i) I_(j)}", "%(%a%)", entries)
    p:line(lines, read.of(left, p.names), e)
  end
  if #lines > 0 then
    p:text "In the body's own quantities $Omega_1 Omega_2/omega_0^2$ is, about its axes $x$, $y$ and $z$:"
  end
  p:display(lines)
  p:where()
end

return motion
