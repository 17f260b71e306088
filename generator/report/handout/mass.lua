-- mass.lua -- the hand-out's sections on the body: what is given, the tensor, principal moments.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local vec = require "generator.algebra.vec"
local expression = require "generator.formula.expression"
local tree = require "generator.formula.tree"
local formula = require "generator.report.handout.formula"
local integrals = require "generator.report.handout.integrals"
local order = require "generator.report.order"

local mass = {}

local axes = { "x", "y", "z" }
local MASS = expr.sym("the mass", 1) -- of a body whose mass is no parameter
mass.entry = { { 1, 4, 5 }, { 4, 2, 6 }, { 5, 6, 3 } } -- of {xx, yy, zz, xy, xz, yz}

function mass.given(p, f)
  local lines = {}
  for _, q in ipairs(f.params) do
    lines[#lines + 1] = { left = p.symbols:of(q.name), tree.op "=",
      tree.number(f.job.model:double(q.sym), 12, q.unit) }
  end
  p:heading "Given"
  p:words(#lines > 0 and "The scene is given by" or
    "The scene has no parameters: every number is an exact constant.")
  p:display(formula.beside(lines))
  if not f.job.model.has.rates then
    p:text("Vectors are in the axes $x$, $y$, $z$ of the base frame, a dot is the derivative by time, and $~r$ and " ..
      "$~v$ are position and velocity of the centre of mass.")
  else
    p:text("The axes $x$, $y$, $z$ are those of the body, the axes 1, 2, 3 its principal axes. $~omega$ is the " ..
      "angular velocity, and its components are in axes of the body. A dot is the derivative by time, and $S$ turns " ..
      "body axes into inertial axes.")
  end
  p:reserve(mass.said) -- at the end all symbols are known
end

-- What is not written with its usual letter, and why.
function mass.said(p)
  local out = {}
  for i, c in ipairs(p.symbols:said()) do
    local function words(s) return p.format.words(s) end
    out[i] = p.format.paragraph(c.name and { words "The scene calls a quantity ", p:node(p.symbols:of(c.name)),
      words("; " .. c.meaning .. " is therefore written "), p:node(c.node), words "." } or
      { words((string.gsub(c.meaning, "^%l", string.upper)) .. " is written "), p:node(c.node), words "." })
  end
  return table.concat(out, "\n")
end

-- The powers of symbols in a product, and its coefficient; nil for a sum.
local function powers(e)
  local c, rest = expr.split(e)
  local list = {}
  for _, u in ipairs(rest == expr.one and {} or rest.kind == "mul" and rest or { rest }) do
    local base, n = u, R.one
    if u.kind == "pow" then base, n = u.base, u.exp end
    if base.kind == "sym" then list[base] = n end
  end
  return list, c
end

-- c and six entries with e = c times entry: the mass, the powers that all entries have, and a denominator of all.
local function common(f, I)
  local m = f.mass
  if m.kind == "num" then return nil end
  local out, shared, list, bottom, before, after = {}, nil, {}, nil, 0, 0
  for n, e in ipairs(I) do
    out[n] = e == expr.zero and e or ratio.tidy(e / m)
    before, after = before + expression.size(e, 500), after + expression.size(out[n], 500)
    for _, s in ipairs(expr.symbols(out[n])) do
      if s == m then return nil end
    end
    if e ~= expr.zero then
      local own, c = powers(out[n])
      if not shared then
        shared, bottom = own, R.den(c)
        for _, s in ipairs(expr.symbols(out[n])) do
          if own[s] then list[#list + 1] = s end
        end
      end
      if R.den(c) ~= bottom then bottom = R.one end
      for _, s in ipairs(list) do -- the least power that all have
        if shared[s] and not own[s] then shared[s] = nil end
        if shared[s] and own[s] < shared[s] then shared[s] = own[s] end
      end
    end
  end
  if not shared or after >= before then return nil end
  local c = expr.one / expr.num(bottom)
  for _, s in ipairs(list) do
    if shared[s] then c = c * expr.pow(s, shared[s]) end
  end
  for n, e in ipairs(out) do out[n] = ratio.tidy(e / c) end
  return c * (m.kind == "sym" and m or MASS), out
end

-- The lines of a tensor I: the matrix if it fits into a line, else entry by entry; none where only numbers stand in it.
-- about: ",c" for that about the centre of mass.
function mass.matrix(p, f, about, I)
  local w, rows = p.writer, {}
  local left = p.symbols:own("I", about and "c")
  local c, inner = common(f, I)
  local shown, fits, symbolic = inner or I, true, false
  for _, e in ipairs(I) do symbolic = symbolic or #expr.symbols(e) > 0 end
  for _, e in ipairs(shown) do fits = fits and formula.fits(e) end
  if fits then
    for i = 1, 3 do
      rows[i] = {}
      for k = 1, 3 do rows[i][k] = w:of(shown[mass.entry[i][k]]) end
    end
  end
  local matrix = fits and tree.matrix(rows)
  local lines = {}
  if symbolic and fits and tree.width(matrix) + (c and 6 or 0) + 4 <= formula.widest then
    lines[1] = { left = left, tree.op "=", matrix }
    if c then table.insert(lines[1], 2, w:of(c)) end
  elseif symbolic then -- without parameters the numbers, below, say all
    for n, e in ipairs(I) do
      if e ~= expr.zero then p:line(lines, p.symbols:own("I", vec.entry[n] .. (about or "")), e) end
    end
  end
  return lines
end

local digit = 0.8 -- of a letter's width

-- law: an equation after it, or nil.
local function tensor(p, f, about, I, numbers, law)
  local lines, values = mass.matrix(p, f, about, I), {}
  for i = 1, 3 do
    values[i] = {}
    for k = 1, 3 do values[i][k] = tree.number(numbers[mass.entry[i][k]], 5) end
  end
  local matrix = { kind = "quantity", tree.matrix(values), { kind = "unit", "kg m^2" } }
  local one = lines[1]
  if #lines == 1 and formula.width(one) + digit * tree.width(matrix) <= formula.widest then
    one[#one + 1] = tree.op "approx"
    one[#one + 1] = matrix
  else
    lines[#lines + 1] = { left = p.symbols:own("I", about and "c"), tree.op "approx", matrix }
  end
  if law then lines[#lines + 1] = p:lines { law }[1] end
  p:display(lines)
end

local function vector(p, name, v, numbers)
  local lines = {}
  for i = 1, 3 do p:line(lines, p.symbols:own(name, axes[i]), v[i], v[i].kind ~= "num" and numbers[i] or nil, "m") end
  p:display(formula.beside(lines))
end

-- Where the formula of a shape comes from.
local function origin(p, f)
  p:text("Each entry of the tensor is an integral over the mass, here with $~x$ from the origin of the axes:")
  p:equations { "I_jk = int ( ( ~x . ~x ) delta_jk - x_j x_k ) dM" }
  local seen = {}
  for _, piece in ipairs(f.job.model.body.pieces) do
    local known = integrals[piece.name]
    if known and not seen[piece.name] then
      p:text(known[4] .. " (" .. known[1] .. "), about its own axis $z$:")
      p:equations { "I_zz = " .. known[2] .. " = " .. known[3] }
    end
    seen[piece.name] = true
  end
end

-- Do the equations of motion begin with the components of this angular momentum?
local function defined(f)
  for _, e in ipairs(f.job.record.effects) do
    if e.kind == "effect.inertia_rate" or e.kind == "effect.rotor" then return false end
  end
  for _, g in ipairs(f.job.equations.groups) do
    for _, d in ipairs(g.defs) do
      if d.name == "Lx" then return true end
    end
  end
  return false
end

function mass.tensor(p, f, asked)
  local s, lines = p.symbols, {}
  p:heading "Mass and tensor of inertia"
  if f.mass.kind ~= "sym" then
    p:words "The mass is"
    p:line(lines, s:own "M", f.mass, f.mass_number, "kg")
    p:display(lines)
  end
  if f.is_central then
    p:words "The origin of rotation is the centre of mass."
  else
    p:words "The centre of mass, seen from the origin of rotation:"
    vector(p, "R", f.arm, f.arm_number)
  end
  if not f.job.model.has.rates then
    p:words "The body does not turn in this scene, so its tensor does not enter."
    return p:where()
  end
  origin(p, f)
  p:words(f.is_central and "The tensor about the centre of mass is" or "The tensor about the origin of rotation is")
  tensor(p, f, nil, f.inertia, f.inertia_number)
  if not f.is_central then
    p:text("and about the centre of mass, from which it is moved by Huygens and Steiner,")
    tensor(p, f, ",c", f.centroidal, f.centroidal_number, "I = I_c + M ( ( ~R . ~R ) 1 - ~R ~R^T )")
  end
  p:where()
  p:text "Kinetic energy of the rotation and angular momentum:"
  lines = p:lines({ "T = {1|2} ( ~omega . I ~omega )", "~L = I ~omega" }, true)
  local w = vec.map({ 1, 2, 3 }, function(i) return expr.sym("w" .. axes[i], 7) end)
  local named = vec.map(f.inertia, function(e, n) return e == expr.zero and e or expr.sym("I" .. vec.entry[n], 3) end)
  local L = vec.apply(named, w)
  local T = expr.zero
  for i = 1, 3 do T = T + named[i] * w[i] ^ 2 / 2 end
  T = T + named[4] * w[1] * w[2] + named[5] * w[1] * w[3] + named[6] * w[2] * w[3]
  p:line(lines, s:own "T", T)
  for i = 1, asked.euler and defined(f) and 0 or 3 do p:line(lines, s:own("L", axes[i]), L[i]) end
  p:display(formula.grouped(lines))
end

local function sentence(s) return (string.gsub(s, "^%l", string.upper)) .. "." end

-- The name of a moment in closed form: that of the nearest numbers, "A_1 = A_2" for one that is there twice.
local function moments(s, f, n)
  local list, own = {}, {}
  for i, k in ipairs(order.of(f)) do list[i] = { index = i, number = f.moments[k] } end
  for j = 1, n do -- each takes its own, so that two never share one
    local q = f.closed_moments[j]
    local x = f.job.model:double(q.moment)
    table.sort(list, function(a, b)
      local da, db = math.abs(a.number - x), math.abs(b.number - x)
      return da < db or da == db and a.index < b.index
    end)
    own = {}
    for _ = 1, math.min(q.multiplicity, #list) do own[#own + 1] = table.remove(list, 1).index end
  end
  table.sort(own)
  local node = { kind = "row" }
  for i, index in ipairs(own) do
    if i > 1 then node[#node + 1] = tree.op "=" end
    node[#node + 1] = s:own("I", tostring(index))
  end
  return node
end

function mass.principal(p, f)
  if not f.job.model.has.rates then return end
  local s, lines = p.symbols
  p:heading "Principal moments and axes"
  p:words(sentence(f.symmetry) .. (f.structure.kind == "symmetric" and " Axis 3 is the axis of symmetry." or
    f.structure.kind ~= "sphere" and " Axis 1 has the least moment, axis 3 the largest." or ""))
  if not f.physical then p:words "No body has these moments: the largest is more than the sum of the others." end
  local exact = f.closed_moments or {}
  for n, q in ipairs(exact) do
    local name = moments(s, f, n)
    lines = {}
    p:line(lines, name, f.closed_named[n].moment, f.job.model:double(q.moment), "kg m^2")
    if q.axis then
      local nodes, fits = {}, true
      for i = 1, 3 do
        local e = f.closed_named[n].axis[i]
        fits = fits and formula.fits(e)
        nodes[i] = fits and { p.writer:of(e) }
      end
      local column = fits and tree.matrix(nodes)
      if fits and tree.width(column) < formula.widest - 10 then
        local about = tree.row(tree.op "quad", tree.word "about the axis ", column)
        local last = lines[#lines]
        if #lines == 1 and not last.sum and formula.width(last) + tree.width(about) <= formula.widest then
          last[#last + 1] = about
        else
          lines[#lines + 1] = { about }
        end
      end
    end
    p:display(lines)
  end
  p:where()
  p:words(#exact > 0 and "In numbers, with unit vectors along the axes:" or
    "There is no simple closed form; in numbers, with unit vectors along the axes:")
  lines = {}
  for n, k in ipairs(order.of(f)) do
    local c = {}
    for i = 1, 3 do c[i] = tree.number(f.axes[k][i], 5) end
    lines[n] = { left = s:own("I", tostring(n)), tree.op "approx", tree.number(f.moments[k], 5, "kg m^2"),
      tree.op ",", tree.op "quad", s:own("e", tostring(n), { vector = true }), tree.op "approx",
      { kind = "tuple", c[1], c[2], c[3] } }
  end
  p:display(lines)
  p:words "In these axes the tensor is diagonal, and"
  p:equations({ "T = {1|2} ( I_1 omega_1^2 + I_2 omega_2^2 + I_3 omega_3^2 )",
    "~L = I_1 omega_1 ~e_1 + I_2 omega_2 ~e_2 + I_3 omega_3 ~e_3" }, true)
end

return mass
