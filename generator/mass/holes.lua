-- holes.lua -- does every hole lie inside the body it is cut from, and is it made of the same stuff?
--
-- `a - hole` subtracts the hole's mass; that is the body with the hole in it only where the body was.  The question is
-- asked of plain numbers, at the parameters' defaults (geometry/), by samples: points of the hole's surface, and points
-- between them, must be in a within a slack.  A hole of a kind (volume, area, length, particles) is compared with the
-- parts of that kind; a thin plate cut from a solid takes nothing away and is refused.  Of a tensor nothing is known,
-- and nothing is said.
-- Slack: 1e-9 of the hole's size, for holes flush with their body whose numbers were typed to a dozen digits, and 64
-- roundings of the largest coordinate that occurs on the way (a placement makes some ten).  Where a mesh is met, 1e-6
-- and 4 roundings of float: what a file's coordinates have.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local diag = require "generator.diag"
local inside = later "generator.geometry.inside"
local surface = later "generator.geometry.surface"
local catalogue = require "generator.mass.catalogue"
local kinds = require "generator.mass.kinds"
local within = require "generator.mass.within"

local holes = {}

local most_samples = 400
local noun = { volume = "a volume", area = "an area", length = "a length", particles = "particles" }
local per = { volume = " kg/m^3", area = " kg/m^2", length = " kg/m" }

-- Does the tree have a hole?
function holes.any(node)
  if node.shape then return false end
  if node.op == "minus" then return true end
  if node.of then return holes.any(node.of) end
  return holes.any(node[1]) or holes.any(node[2])
end

-- ---- density ----

-- How many times larger things of a kind are after the map of a node.
local function growth(node, kind)
  if node.op == "affine" then
    local A = node.A
    return kind == "volume" and math.abs(A[1] * (A[5] * A[9] - A[6] * A[8]) - A[2] * (A[4] * A[9] - A[6] * A[7]) +
      A[3] * (A[4] * A[8] - A[5] * A[7])) or 1
  end
  local k = node.op == "scaled" and node.k
  if not k then return 1 end
  if kind == "volume" then return math.abs(k[1] * k[2] * k[3]) end
  return kind == "area" and k[1] ^ 2 or math.abs(k[1]) -- one factor, see the scene language
end

-- Writes into the leaves of the numeric tree what they weigh per volume, area or length where they stand (`weight`;
-- nil: not known).  node: the same tree as expressions.
-- size: how many times larger things of each kind are than where the shape is written; a density stays, a mass spreads.
local function weigh(m, node, num, size)
  if num.extra then return weigh(m, node, num.of, size) end
  if num.shape then
    local spec = catalogue.by_name[node.shape]
    local kind = inside.kind(num)
    num.by_mass = node.mass ~= nil
    if num.shape == "region" or not spec or not kind or kind == "particles" then return end -- not one number
    if node.density then
      num.weight = R.todouble(m:number(node.density))
    elseif node.mass then
      local measure = expr.zero
      for _, part in ipairs(spec.pieces and spec.pieces(node.a) or { spec.build(node.a) }) do
        measure = measure + part.measure
      end
      num.weight = R.todouble(m:number(node.mass / measure)) / (size[kind] or 1)
    end
  elseif num.of then
    local larger = {}
    for _, kind in ipairs(kinds.list) do larger[kind] = (size[kind] or 1) * growth(num, kind) end
    weigh(m, node.of, num.of, larger)
  else
    weigh(m, node[1], num[1], size)
    weigh(m, node[2], num[2], size)
  end
end

-- What the tree weighs per volume (area, length) at p; nil if not known.
local function weight(node, p, slack)
  if node.shape then
    local there = inside.contains(node, p, slack)
    if there == false then return 0 end
    return there and node.weight or nil
  elseif node.of then
    local q, k = inside.back(node, p)
    return weight(node.of, q, slack / k)
  end
  local a, b = weight(node[1], p, slack), weight(node[2], p, slack)
  return a and b and (node.op == "sum" and a + b or a - b)
end

-- ---- samples ----

local function place(p)
  return "(" .. diag.rough(p[1]) .. ", " .. diag.rough(p[2]) .. ", " .. diag.rough(p[3]) .. ")"
end

-- Lengths of the shifts in a tree, added: what coordinates may reach on the way to a leaf.
-- (a bound: they may point in different directions)
local function shifts(node)
  if node.shape then return 0 end
  if node.of then
    local r = node.r or { 0, 0, 0 }
    return math.abs(r[1]) + math.abs(r[2]) + math.abs(r[3]) + shifts(node.of)
  end
  return shifts(node[1]) + shifts(node[2])
end

-- At most `most_samples` points of the hole's surface, their size, and the slack.  Samples that are not in the hole are
-- dropped: points on the chords of its inner rims, and on what a part of it cuts from another.
local function sampled(a, hole)
  local all, list = surface.samples(hole, 12), {}
  local step = math.max(1, math.ceil(#all / most_samples))
  local lo, hi, reach = { 1 / 0, 1 / 0, 1 / 0 }, { -1 / 0, -1 / 0, -1 / 0 }, shifts(a) + shifts(hole)
  for _, p in ipairs(all) do
    for i = 1, 3 do
      lo[i], hi[i] = math.min(lo[i], p[i]), math.max(hi[i], p[i])
      reach = math.max(reach, math.abs(p[i]))
    end
  end
  local size = math.max(hi[1] - lo[1], hi[2] - lo[2], hi[3] - lo[3])
  local slack = kinds.slack(size, reach, a, hole)
  for n = 1, #all, step do
    if inside.contains(hole, all[n], slack) then list[#list + 1] = all[n] end
  end
  return list, size, slack
end

-- Points between the samples that are in the hole.
-- Pairs and places have no pattern; of a solid only what is clearly inside counts.
local function between(hole, list, slack, kind)
  local out = {}
  for i = 1, #list, 2 do
    local a, b, p = list[i], list[(i * 7919) % #list + 1], {}
    for k = 1, 3 do p[k] = a[k] + 0.46291 * (b[k] - a[k]) end
    if inside.contains(hole, p, kind == "volume" and -slack or slack) then out[#out + 1] = p end
  end
  return out
end

-- One hole of one kind in the parts of a of that kind.
local function contained(d, node, a, hole, kind)
  local list, size, slack = sampled(a, hole)
  local inner = between(hole, list, slack, kind)
  local worst, where
  for _, points in ipairs { list, inner } do
    for _, p in ipairs(points) do
      local e = inside.excess(a, p)
      if e and e > slack and (not worst or e > worst) then worst, where = e, p end
    end
  end
  if worst then
    local far = inside.distance(a, where, math.max(1e-6 * size, 16 * slack))
    d:error(node.line, "hole", within.inside, "the point " .. place(where) ..
      " of the hole" .. (node[2].line and " (line " .. node[2].line .. ")" or "") .. ", " .. diag.rough(far) ..
      " m outside")
    return false
  end
  return true, kind == "volume" and inner or list, slack
end

-- Is a part's mass given, and its density so a derived number?
local function by_mass(node)
  if node.shape then return node.by_mass end
  if node.of then return by_mass(node.of) end
  return by_mass(node[1]) or by_mass(node[2])
end

-- Is the hole as dense as the body around it?  A denser one leaves negative mass, a lighter one leaves some in it.
-- 1e-6: digits of a mass that was computed elsewhere; 1e-2: of one that was weighed.
local function same_stuff(d, node, a, hole, kind, points, slack)
  local heavy, light, got
  for _, p in ipairs(points) do
    local h, w = weight(hole, p, slack), weight(a, p, slack)
    local border = kind == "volume" and w ~= weight(a, p, -slack) -- two parts meet here
    if h and w and w > 0 and h > 0 and not border then
      local r = h / w
      if r > (heavy or 1 + 1e-6) then heavy, got = r, { h, w, p } end
      if r < (light or 0.99) then light, got = r, heavy and got or { h, w, p } end
    end
  end
  if not got then return true end
  local text = diag.rough(got[1]) .. (heavy and " > " or " < ") .. diag.rough(got[2]) .. per[kind] .. " at " ..
    place(got[3])
  if not heavy then
    d:warn(node.line, "hole", "is less dense than the body it is cut from, " .. text .. ": the rest stays in the hole")
  elseif by_mass(hole) then
    d:warn(node.line, "hole", "is denser than the body it is cut from, " .. text ..
      ": negative mass remains (give both the same density)")
  else
    d:error(node.line, "hole", within.denser, text)
    return false
  end
  return true
end

-- Kind by kind; true: nothing is wrong, or nothing is known of the hole.
local function cut(d, node, a, hole)
  local in_a, in_hole = kinds.of(a), kinds.of(hole)
  if in_hole.unknown then return true end
  local good = true
  for _, kind in ipairs(kinds.list) do
    if in_hole[kind] and not in_a[kind] then
      if not in_a.unknown then
        local list = {}
        for _, k in ipairs(kinds.list) do if in_a[k] then list[#list + 1] = noun[k] end end
        d:error(node.line, "hole", "must be of the same kind (volume, area, length or particles) as the body it is " ..
          "cut from", noun[kind] .. " from " .. table.concat(list, " and "))
        good = false
      end
    elseif in_hole[kind] then
      local x, y = kinds.part(a, kind), kinds.part(hole, kind)
      local ok, points, slack = contained(d, node, x, y, kind)
      good = ok and (kind == "particles" or same_stuff(d, node, x, y, kind, points, slack)) and good
    end
  end
  return good
end

-- Reports the holes that are not in their bodies.  m: the model; tree: its body as numbers (dynamics/numeric.lua), made
-- for this call: what the leaves weigh is written into it.
function holes.check(d, m, tree)
  weigh(m, m.record.body, tree, {})
  local function walk(node, num)
    if num.extra then return walk(node, num.of) end
    if num.shape then return true end
    if num.of then return walk(node.of, num.of) end
    local good = walk(node[1], num[1])
    good = walk(node[2], num[2]) and good
    if num.op == "minus" and good then good = cut(d, node, num[1], num[2]) end
    return good
  end
  return walk(m.record.body, tree)
end

return holes
