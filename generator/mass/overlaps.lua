-- overlaps.lua -- do bodies that are joined by + share space?
--
-- a + b adds masses and moments, so what both hold counts twice.  That may be meant (a core that is denser than what
-- is around it), so it is a warning.  The question is asked of plain numbers, at the parameters' defaults: solids are
-- asked about points of Halton's sequence in what their boxes share, and about points of their surfaces; thin things
-- about points inside of their flat faces and straight pieces, which lie on another by an overlap only.  Parts may
-- touch.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local diag = require "generator.diag"
local inside = later "generator.geometry.inside"
local surface = later "generator.geometry.surface"
local kinds = require "generator.mass.kinds"

local overlaps = {}

local lattice, samples, most_pairs = 1000, 60, 2000
local unit = { volume = " m^3", area = " m^2", length = " m" }

-- Does the tree have a sum?
function overlaps.any(node)
  if node.shape then return false end
  if node.op == "sum" then return true end
  return overlaps.any(node.of or node[1]) or not node.of and overlaps.any(node[2])
end

local function first_line(node)
  while not node.shape do node = node.of or node[1] end
  return node.line, (string.gsub(node.shape, "^solid%.", ""))
end

-- The bodies of one kind that a tree is a sum of, where they stand: {tree, line, name, box}.
local function terms(node, num, kind, placed, list)
  if num.extra then
    return terms(node, num.of, kind, function(inner)
      return placed(setmetatable({ of = inner }, { __index = num }))
    end, list)
  elseif num.op == "sum" then
    terms(node[1], num[1], kind, placed, list)
    terms(node[2], num[2], kind, placed, list)
  elseif num.of then
    terms(node.of, num.of, kind, function(inner)
      return placed(setmetatable({ of = inner }, { __index = num }))
    end, list)
  else
    local own = kinds.part(num, kind)
    if own and not kinds.of(own).unknown then
      local line, name = first_line(node)
      local tree = placed(own)
      local lo, hi = surface.box(tree, 16)
      list[#list + 1] = { tree = tree, line = line, name = name, lo = lo, hi = hi }
    end
  end
  return list
end

local function identity(tree) return tree end

-- ---- two bodies ----

-- What the boxes share: lowest and highest corner, and the volume; nil if they do not meet.
local function shared(a, b)
  local lo, hi, volume = {}, {}, 1
  for i = 1, 3 do
    lo[i], hi[i] = math.max(a.lo[i], b.lo[i]), math.min(a.hi[i], b.hi[i])
    if lo[i] > hi[i] then return nil end
    volume = volume * (hi[i] - lo[i])
  end
  return lo, hi, volume
end

-- Digits of n in the base, mirrored at the point.
local function halton(n, base)
  local at, digit = 0, 1
  while n > 0 do
    digit = digit / base
    at = at + digit * (n % base)
    n = n // base
  end
  return at
end

local function slack_of(a, b)
  local size, reach = math.huge, 0
  for _, t in ipairs { a, b } do
    local longest = 0
    for i = 1, 3 do
      longest = math.max(longest, t.hi[i] - t.lo[i])
      reach = math.max(reach, math.abs(t.lo[i]), math.abs(t.hi[i]))
    end
    size = math.min(size, longest)
  end
  return kinds.slack(size, reach, a.tree, b.tree)
end

-- Is a point beside the surface of a in the midst of both?
-- The eight corners of a small cube about each sample: one of them is in a, if a is no needle there.
local function reaches(a, b, slack)
  local list = surface.samples(a.tree, 6)
  for n = 1, #list, #list // samples + 1 do
    local p = list[n]
    for k = 0, inside.contains(b.tree, p, -slack) and 7 or -1 do
      local q = {}
      for i = 1, 3 do q[i] = p[i] + 8 * slack * ((k >> (i - 1)) % 2 * 2 - 1) end
      if inside.contains(a.tree, q, -slack) and inside.contains(b.tree, q, -slack) then return true end
    end
  end
  return false
end

-- Volume that two solids share; 0: less than can be told; nil: none.
local function solid(a, b)
  local lo, hi, volume = shared(a, b)
  local slack, hits = lo and slack_of(a, b), 0
  if not lo then return nil end
  for n = 1, volume > 0 and lattice or 0 do
    local p = {}
    for i, base in ipairs { 2, 3, 5 } do p[i] = lo[i] + (hi[i] - lo[i]) * halton(n, base) end
    if inside.contains(a.tree, p, -slack) and inside.contains(b.tree, p, -slack) then hits = hits + 1 end
  end
  if hits > 0 then return volume * hits / lattice end
  return (reaches(a, b, slack) or reaches(b, a, slack)) and 0 or nil
end

-- Do flat faces or straight pieces of a lie on b?
local function lies_on(a, b, slack)
  local s, points = surface.tree(a.tree, 16), {}
  for _, f in ipairs(s.faces) do
    for k = 2, f.flat and #f - 1 or 0 do
      local p = {}
      for i = 1, 3 do p[i] = 0.50719 * f[1][i] + 0.31337 * f[k][i] + 0.17944 * f[k + 1][i] end
      points[#points + 1] = p
    end
  end
  for _, l in ipairs(s.lines) do
    for k = 1, #l - 1 do
      local p = {}
      for i = 1, 3 do p[i] = l[k][i] + 0.46291 * (l[k + 1][i] - l[k][i]) end
      points[#points + 1] = p
    end
  end
  for n = 1, #points, #points // (4 * samples) + 1 do
    if inside.contains(a.tree, points[n], slack) and inside.contains(b.tree, points[n], slack) then return true end
  end
  return false
end

local function thin(a, b)
  if not shared(a, b) then return nil end
  local slack = slack_of(a, b)
  return (lies_on(a, b, slack) or lies_on(b, a, slack)) and 0 or nil
end

-- ---- the whole ----

local function warn(d, node, kind, list)
  local worst = list[1]
  for _, o in ipairs(list) do
    if o.shared > worst.shared then worst = o end
  end
  local size = worst.shared > 0 and ", some " .. diag.rough(worst.shared) .. unit[kind] or ""
  d:warn(node.line, "+", "the " .. worst.a.name .. " of line " .. worst.a.line .. " and the " .. worst.b.name ..
    " of line " .. worst.b.line .. " overlap: what both hold" .. size .. ", counts twice (cut it out of one of them)" ..
    (#list > 1 and "; so do " .. (#list - 1) .. " more pairs" or ""))
end

-- Warns of the sums in a tree whose parts overlap, once for each sum.  m: the model; tree: its body as numbers.
function overlaps.check(d, m, tree)
  local pairs_left = most_pairs
  local function walk(node, num)
    if num.extra then return walk(node, num.of) end
    if num.shape then return end
    if num.of then return walk(node.of, num.of) end
    walk(node[1], num[1])
    walk(node[2], num[2])
    if num.op ~= "sum" then return end
    for _, kind in ipairs { "volume", "area", "length" } do
      local list = {}
      local left, right = terms(node[1], num[1], kind, identity, {}), terms(node[2], num[2], kind, identity, {})
      for _, a in ipairs(left) do
        for _, b in ipairs(right) do
          local met = pairs_left > 0 and shared(a, b)
          pairs_left = met and pairs_left - 1 or pairs_left
          local s = met and (kind == "volume" and solid or thin)(a, b)
          if s then list[#list + 1] = { a = a, b = b, shared = s } end
        end
      end
      if #list > 0 then warn(d, node, kind, list) end
    end
  end
  walk(m.record.body, tree)
end

return overlaps
