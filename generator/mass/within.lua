-- within.lua -- that every hole lies inside its body, as conditions on the parameters: for NAME_init.
--
-- holes.lua asks points of plain numbers.  Here the same question has an answer for all values of the parameters, where
-- body and hole are convex solids (convex.lua) at any exact place:
--     a hole in a solid          each set of the hole's hull is inside each bound of the solid
--     a hole beside a hole       they have no inner point in common
--     its density                not above the body's
-- The sum of several holes is several holes.  Of a hole in a sum of bodies, which may lie across both, in a mesh or in
-- what is not convex there is no such condition; it is `open`, and whoever can ask holes.lua for each set of values
-- does that.  A hole that no parameter changes has been decided.
-- Nor is there one for polygons to be simple (simple.lua).
--     within.conditions(m) -> list of {e, line, what, rule, opaque, allow_zero}; list of {what, rule, line} of the open
-- Slack, as in holes.lua: 1e-9 of the body's size, and 64 roundings; of a density 1e-6.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local cost = require "generator.algebra.cost"
local ratio = require "generator.algebra.ratio"
local body = require "generator.mass.body"
local catalogue = require "generator.mass.catalogue"
local convex = require "generator.mass.convex"
local critical = require "generator.mass.critical"
local simple = require "generator.mass.simple"

local within = { inside = "must lie inside the body it is cut from",
  denser = "must not be denser than the body it is cut from" }

-- What a margin may be below 0, in parts of a size: a symbol, and its value for a unit roundoff.
within.slack = expr.sym("slack of a hole", 1, true)
function within.slack_of(roundoff) return R.parse "1e-9" + R.new(64) * roundoff end

local weighed = expr.num(R.parse "1.000001")
local dearest = 200 -- operations of one condition: beyond, nobody reads it
local most = 120 -- conditions of a body: a plate with 16 holes that parameters move

-- The set of the names of the parameters in a tree.
function within.parameters(node, set)
  set = set or {}
  for _, x in pairs(node) do -- order does not matter: a set is filled
    if expr.is(x) then
      for _, s in ipairs(expr.symbols(x)) do set[s.name] = true end
    elseif type(x) == "table" then
      within.parameters(x, set)
    end
  end
  return set
end

-- ---- what is cut from what ----
--
-- A part is {node = a shape, maps = placements from it outwards}.

local function outside(node, maps) return { node, table.unpack(maps) } end

local function is_solid(node)
  if node.shape then return node.measure == "volume" end
  if node.of then return is_solid(node.of) end
  return is_solid(node[1]) or node.op == "sum" and is_solid(node[2])
end

-- Is something in it whose extent is not known?
local function vague(node)
  if node.shape then return node.shape == "tensor" end
  if node.of then return vague(node.of) end
  return vague(node[1]) or vague(node[2])
end

-- The parts of a sum, into list; nil if there is anything else than a solid or a hole in one.
local function parts(node, maps, list)
  if node.shape then
    list[#list + 1] = node.measure == "volume" and { node = node, maps = maps } or nil
    return node.measure == "volume" and list or nil
  end
  if node.of then return parts(node.of, outside(node, maps), list) end
  return node.op == "sum" and parts(node[1], maps, list) and parts(node[2], maps, list)
end

-- The one solid that a body is, and what was cut from it: part, list of parts; nil if it is not one.
local function opened(node, maps)
  if node.shape then
    local inner = convex.hollow(node)
    return { node = node, maps = maps }, inner and { { node = inner, maps = maps } } or {}
  elseif node.of then
    return opened(node.of, outside(node, maps))
  elseif node.op == "sum" then
    local first = is_solid(node[1])
    if first and is_solid(node[2]) then return nil end
    return opened(first and node[1] or node[2], maps)
  end
  local solid, cut = opened(node[1], maps)
  if not solid or not parts(node[2], maps, cut) then return nil end
  return solid, cut
end

-- The sets of a part in the frame of another one, scaled there; nil if they are none.
local function seen(part, from, k)
  local out = convex.hull(part.node)
  for i, s in ipairs(out or {}) do
    for _, map in ipairs(part.maps) do s = s and convex.placed(s, map) end
    for n = #from.maps, 1, -1 do s = s and convex.placed(s, from.maps[n], true) end
    s = s and k and convex.scaled(s, k) or s
    if not s then return nil end
    out[i] = s
  end
  return out
end

-- ---- the three questions; put(rule, margin, size) takes a condition; false: no answer ----

local function inside(part, solid, put)
  local bounds, k = convex.bounds(solid.node)
  local sets = bounds and seen(part, solid, k)
  for _, s in ipairs(sets or {}) do
    for _, b in ipairs(bounds) do
      local list = convex.inside(b, s)
      if not list then return false end
      for _, x in ipairs(list) do put(within.inside, x[1], x[2]) end
    end
  end
  return sets ~= nil
end

local function apart(part, other, rule, facts, put)
  if not next(within.parameters { part, other }) then return true end
  if not convex.full(part.node) or not convex.full(other.node) then return false end
  local s, t = seen(part, other), seen(other, other)
  if not s or not t or #s > 1 or #t > 1 then return false end
  local gap, size, along = convex.gap(s[1], t[1])
  if not gap then return false end
  if along then -- above each other is apart, too
    local sign, atoms = facts:signs(along)
    if not (sign < 0 and #atoms == 0) then gap = expr.call("max", gap, along) end
  end
  put(rule, gap, size)
  return true
end

-- What a part weighs per volume.
local function weight(part)
  if part.node.density then return part.node.density end
  local volume = catalogue.by_name[part.node.shape].build(part.node.a).measure
  for _, map in ipairs(part.maps) do
    if map.op == "scaled" then volume = volume * body.growth(map.k, "volume") end
    if map.op == "sheared" then volume = volume * body.determinant(map.A) end
  end
  return part.node.mass / volume
end

local function lighter(part, solid, put)
  if part.node.mass then return end -- a mass that was weighed: holes.lua warns
  local a, b = weight(solid), weight(part)
  if not expr.constant((ratio.tidy(a / b))) then put(within.denser, weighed * a - b) end
end

-- ---- one hole ----

-- The holes of a node `body - hole`, each by put; false: it is open.
local function asked(node, facts, put)
  if vague(node) then return true end
  local solid, cut = opened(node[1], {})
  local list = solid and parts(node[2], {}, {})
  if not list or #cut + #list > most then return false end
  for i, part in ipairs(list) do
    if not inside(part, solid, put) then return false end
    for _, other in ipairs(cut) do
      if not apart(part, other, within.inside, facts, put) then return false end
    end
    lighter(part, solid, put)
    for n = 1, part.node.density and i - 1 or 0 do -- what two of them take from one place is denser than the body
      if not apart(part, list[n], within.denser, facts, put) then return false end
    end
  end
  return true
end

-- The expression with the abs and roots of what is positive opened.
local function plain(e, facts)
  local back = {}
  for s, positive in pairs(facts.map) do back[positive] = s end -- into a table: order is lost anyway
  return calculus.substitute(calculus.substitute(e, facts.map), back)
end

-- Does a polygon, simple and anticlockwise for the defaults, turn left at each corner whatever the parameters?  Then it
-- goes round once for all of them, as it does for the defaults, and is simple.
-- That its area is positive is a check, so a turn that is in a fixed proportion to it is to the left.
local function convex_always(loop, facts)
  local area = expr.zero
  for i, a in ipairs(loop) do
    local b = loop[i % #loop + 1]
    area = area + a[1] * b[2] - a[2] * b[1]
  end
  for i, b in ipairs(loop) do
    local a, c = loop[(i - 2) % #loop + 1], loop[i % #loop + 1]
    local turn = (b[1] - a[1]) * (c[2] - b[2]) - (b[2] - a[2]) * (c[1] - b[1])
    local sign, atoms = facts:signs(turn)
    if sign <= 0 or #atoms > 0 then
      local part = ratio.tidy(turn / area)
      if part.kind ~= "num" or R.sign(part.value) <= 0 then return false end
    end
  end
  return true
end

function within.conditions(m)
  local list, open = {}, {}
  local facts = critical.of(m.record.checks)
  local function hole(node)
    local own, clear = {}, true
    local function put(rule, margin, size)
      clear = clear and #list + #own < most and cost { margin } <= dearest
      if not clear then return end
      local sign, atoms = facts:signs(plain(margin, facts))
      if sign >= 0 and #atoms == 0 then return end
      own[#own + 1] = { e = plain(size and margin + within.slack * size or margin, facts), line = node.line,
        what = "hole", rule = rule, opaque = true, allow_zero = true }
    end
    if asked(node, facts, put) and clear then
      table.move(own, 1, #own, #list + 1, list)
    else
      open[#open + 1] = { what = "hole", rule = within.inside, line = node.line }
    end
  end
  local function walk(node)
    if node.shape then
      local a = node.a
      if a and a.profile and next(within.parameters(a)) and not (#(a.holes or {}) == 0 and convex_always(a.profile,
        facts)) then
        open[#open + 1] = { what = string.gsub(node.shape, "^solid%.", ""), rule = simple.rule, line = node.line }
      end
      return
    end
    walk(node.of or node[1])
    if not node.of then walk(node[2]) end
    if node.op == "minus" and next(within.parameters(node)) then hole(node) end
  end
  walk(m.record.body)
  return list, open
end

-- Do the conditions of holes hold for the parameters' defaults?  holes.lua has asked, at points; this is the last word.
local exactly = { [within.slack] = expr.num(within.slack_of(R.zero)) }
function within.hold(d, m, list)
  for _, c in ipairs(list) do
    if c.what == "hole" and R.sign(m:number(calculus.substitute(c.e, exactly))) < 0 then
      d:error(c.line, c.what, c.rule, "one that does not, though all points of it that were asked do")
      return false
    end
  end
  return true
end

return within
