-- numeric.lua -- a scene as plain numbers, for the general library.
--
-- The library gets the SHAPES and the effects, not our tensor: it computes mass properties and motion by its own
-- formulas, which is what makes it a second road.  Parameters take given values (their defaults, or random ones).
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local vec = require "generator.algebra.vec"
local body = require "generator.mass.body"
local slips = require "generator.mass.slips"
local validity = require "generator.mass.validity"
local context = require "generator.dynamics.context"
local postfix = require "generator.dynamics.postfix"
local state = require "generator.dynamics.state"

local numeric = {}

local none = { expr.zero, expr.zero, expr.zero }

-- job: a scene; values: {name -> rational} for all parameters (nil: defaults); lines: inputs run along straight lines.
-- Returns {name, body, origin, effects, q, w, r, v} as the host's engine takes it.
function numeric.scene(job, values, lines)
  local m, record = job.model, job.record
  local env = {}
  for _, p in ipairs(record.params) do env[p.name] = values and values[p.name] or p.default end
  local function exact(e) return evaluate.precise(e, env, 240) end
  local function num(e) return R.todouble(exact(e)) end
  local function nums(v) return vec.map(v, num) end

  -- an argument of a shape: an expression, a word or flag, or a list of such
  local function plain(v)
    if expr.is(v) then return num(v) end
    return type(v) == "table" and vec.map(v, plain) or v
  end

  -- t moved by r, which need not be a double: what is left of it is a second, small shift.  own: the scene moves it;
  -- other shifts are marked `extra`, as the scene's tree has no such node.
  local function shifted(t, r, own)
    local high, low, whole = nums(r), {}, true
    for i, e in ipairs(r) do
      low[i] = R.todouble(exact(e) - R.fromdouble(high[i]))
      whole = whole and low[i] == 0
    end
    local moved = { op = "at", of = t, r = high, extra = not own }
    return whole and moved or { op = "at", of = moved, r = low, extra = true }
  end

  -- Coordinates are rounded relative to the first point, so that a far body keeps its small distances.  Returns the
  -- arguments and that point, or nil for shapes that are not given by points.
  local function relative(a)
    local key = a.vertices and "vertices" or a.points and "points" or a.profile and a.h and "profile"
    if a.from then
      return { from = vec.sub(a.from, a.from), to = vec.sub(a.to, a.from) }, a.from
    elseif not key then
      return a, nil
    end
    local base, out = a[key][1], {}
    local function local_rows(rows) return vec.map(rows, function(r) return vec.sub(r, base) end) end
    for k, v in pairs(a) do out[k] = v end -- order does not matter: a table of named arguments
    out[key] = local_rows(a[key])
    if a.holes then out.holes = vec.map(a.holes, local_rows) end
    return out, { base[1], base[2], base[3] or expr.zero }
  end

  -- the terms of a polynomial in the coordinates: {coefficient, i, j, k}
  local function terms(p, factor)
    return vec.map(p, function(t) return { num(factor * t.c), t[1], t[2], t[3] } end)
  end

  local function region(node, growth)
    local limits = {}
    for n, l in ipairs(node.a.limits) do limits[n] = { terms(l[1], expr.one), terms(l[2], expr.one) } end
    return { shape = "region", order = node.a.order, limits = limits, mass = node.mass and num(node.mass),
      density = not node.mass and terms(node.a.density, growth.volume) or nil }
  end

  -- A tensor that no body has was taken as it is: the library is told so, about the centre of mass.
  local function formal(a)
    local I = vec.map({ a.xx, a.yy, a.zz, a.xy, a.xz, a.yz }, exact)
    if a.about == "origin" then I = vec.sub(I, slips.steiner(exact(a.mass), vec.map(a.com, exact))) end
    if validity.lawful(I) then return nil end
    local out = { shape = "tensor", formal = true, mass = num(a.mass), com = nums(a.com) }
    for i, name in ipairs(vec.entry) do out[name] = R.todouble(I[i]) end
    return out
  end

  -- density is multiplied by the growth of its shape under the scalings around it: the library's scaling keeps mass
  local function tree(node, growth)
    if node.shape == "points" then
      local rows = {}
      local first = node.rows[1]
      local base = { first[2], first[3], first[4] }
      for i, row in ipairs(node.rows) do
        rows[i] = { num(row[1]), table.unpack(nums(vec.sub({ row[2], row[3], row[4] }, base))) }
      end
      return shifted({ shape = "points", list = rows }, base)
    elseif node.shape == "mesh" then
      local a = node.a
      return shifted({ shape = "mesh", mass = num(node.mass or node.density * growth[node.measure] * a.measure),
        com = { 0.0, 0.0, 0.0 }, sigma = nums(a.sigma) }, a.com)
    elseif node.shape == "region" then
      return region(node, growth)
    elseif node.shape == "tensor" and node.name ~= "inertial" and formal(node.a) then
      return formal(node.a)
    elseif node.shape then
      local out = { shape = node.shape, mass = node.mass and num(node.mass),
        density = node.density and num(node.density * growth[node.measure]) }
      local a, base = relative(node.a)
      for k, v in pairs(a) do -- order does not matter: a table of named numbers
        out[k] = plain(v)
      end
      return base and shifted(out, base) or out
    elseif node.op == "at" then
      return shifted(tree(node.of, growth), node.r, true)
    elseif node.op == "turned" then
      return { op = "turned", of = tree(node.of, growth), q = nums(node.q) }
    elseif node.op == "scaled" then
      local inner = {}
      for _, measure in ipairs { "volume", "area", "length" } do
        inner[measure] = growth[measure] * body.growth(node.k, measure)
      end
      return { op = "scaled", of = tree(node.of, inner), k = nums(node.k) }
    elseif node.op == "sheared" then
      local A = node.A
      local inner = { volume = growth.volume * body.determinant(A), area = growth.area, length = growth.length }
      return { op = "affine", of = tree(node.of, inner),
        A = { num(A[1][1]), num(A[1][2]), num(A[1][3]), num(A[2][1]), num(A[2][2]), num(A[2][3]), num(A[3][1]),
          num(A[3][2]), num(A[3][3]) } }
    elseif node.op == "sum" then
      return { op = "sum", tree(node[1], growth), tree(node[2], growth) }
    elseif node.op == "minus" then
      return { op = "minus", tree(node[1], growth), tree(node[2], growth), line = node.line }
    end
    error("unknown node in a shape tree: " .. tostring(node.op))
  end

  local body_tree = tree(record.body, { volume = expr.one, area = expr.one, length = expr.one })
  -- the origin of rotation becomes that of the coordinates
  body_tree = shifted(body_tree, vec.map(m.origin, function(e) return -e end))
  if not job.states then return { body = body_tree } end -- asked for while the model is made
  local effects, dry = {}, context.dry(m)
  dry.lines = lines
  local place = {}
  for k, s in ipairs(state.known) do place[s.name] = k - 1 end
  for i, k in ipairs((numeric.positions(job))) do place[job.states[i].name] = k - 1 end
  for i, s in ipairs(m.inputs) do place[s.name] = -i end
  local function code(e) return postfix.of(e, exact, place) end
  for _, e in ipairs(m.record.effects) do -- those that act
    local more
    effects[#effects + 1], more = e.spec.numeric(e.a, num, record.given, code, context.with(dry, e))
    effects[#effects + 1] = more
  end
  local own = {}
  for _, s in ipairs(job.states) do
    if s.effect then own[#own + 1] = s.initial end
  end
  return { name = m.name, body = body_tree, origin = { 0.0, 0.0, 0.0 }, effects = effects, inputs = #m.inputs,
    own = nums(own), q = nums(record.attitude), w = nums(record.omega), r = nums(record.given.position or none),
    v = nums(record.given.velocity or none) }
end

-- The library's state is q and w, with r and v where the body moves, and what effects add.  Where each state of the
-- scene is in it, and how long it is.
function numeric.positions(job)
  local list, n = {}, job.model.has.position and 13 or 7
  for i, s in ipairs(job.states) do
    for k, known in ipairs(state.known) do
      if known.name == s.name then list[i] = k end
    end
    if s.effect then
      n = n + 1
      list[i] = n
    end
  end
  return list, n
end

-- The library's state for the scene's state x: no turning where the scene has none.
function numeric.whole(job, x)
  local at, n = numeric.positions(job)
  local full = { 1.0, 0.0, 0.0, 0.0 }
  for i = 5, n do full[i] = 0.0 end
  for i, k in ipairs(at) do full[k] = x[i] end
  return full
end

-- The scene's part of a list in the library's order, which begins after `offset` entries.
function numeric.part(job, full, offset)
  return vec.map((numeric.positions(job)), function(k) return full[(offset or 0) + k] end)
end

-- The scene's initial state as doubles, parameters at their defaults.
function numeric.initial(job)
  return vec.map(job.states, function(s) return job.model:double(s.initial) end)
end

return numeric
