-- shapes.lua -- shapes of the scene language: constructors, placement, sums and holes.
--
-- A shape is an opaque handle whose record is a tree of plain data (expressions inside):
--     {shape=, a={args}, mass= | density=, line=}    {op="at", of=, r=}    {op="turned", of=, q=unit quaternion, turns}
--     {op="scaled", of=, k={kx,ky,kz}}    {op="sheared", of=, A={rows}}    {op="sum" | "minus", a, b}
-- and in each of them broken (a message has told of it), formal (of a tensor that is asked to be no body's, and of what
-- is made of it), size (its parts, nil: one).
-- Nothing is integrated here; mass/body.lua turns the tree into mass, centre and tensor.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"
local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local vec = require "generator.algebra.vec"
local args = require "generator.dsl.args"
local digits = require "generator.mass.digits"
local law = later "generator.mass.law"
local polygon = later "generator.dsl.polygon"
local region = later "generator.dsl.region"
local rotation = later "generator.dsl.rotation"
local value = require "generator.dsl.value"
local diag = require "generator.diag"

local shapes = {}

local record = setmetatable({}, { __mode = "k" })
local handle = { __name = "shape" }
local method = {}

local most_parts = 1000 -- of one body: a loop of b = b + b would make 2^n

local ctx -- the scene that is being recorded: {diag =, checks =}

-- visible: the host's wrapper that keeps the caller's line known in `return shape:at{...}`.
function shapes.begin(c, visible)
  ctx = c
  local methods = {}
  for _, name in ipairs { "at", "turned", "scaled", "sheared", "mirrored" } do methods[name] = visible(method[name]) end
  handle.__index = function(_, name)
    if methods[name] then return methods[name] end
    ctx.diag:error(ctx.diag:here(), "shape", "has no operation " .. diag.show(name) ..
      " (it has at, turned, scaled, sheared, mirrored)")
    return function(self) return self end
  end
end
function shapes.record(h) return record[h] end

local function new(r)
  local h = setmetatable({}, handle)
  record[h] = r
  return h
end
shapes.new = new -- for constructors in files of their own

-- What an unknown constructor makes: nothing more is said about it.
function shapes.broken() return new { broken = true, line = ctx.diag:here() } end

local function here() return ctx.diag:here() end

-- The line of a call shape:name{...}: Lua knows only the line on which a chain of calls begins.
local function called(name) return ctx.diag:called(here(), name) end

-- Mass or density, exactly one; into node.  spec: {measure =}.
function shapes.amount(spec, what, line, given, node)
  local m, d = given.mass, given.density
  if m ~= nil and d ~= nil then
    ctx.diag:error(ctx.diag:locate(line, "density"), what, "give mass or density, not both")
  elseif m == nil and d == nil then
    ctx.diag:error(line, what, "mass is missing (give mass or density)")
  elseif m ~= nil then
    node.mass = args.scalar(ctx, ctx.diag:locate(line, "mass"), what, "mass", { dim = "mass", sign = "positive" }, m)
  else
    local at = ctx.diag:locate(line, "density")
    node.density = args.scalar(ctx, at, what, "density", { dim = "density_" .. spec.measure, sign = "positive" }, d)
  end
  return node.mass ~= nil or node.density ~= nil
end

-- What is written without a unit: {length = all lengths, mass = bool, density = bool}, for mass/plausible.lua.
local function bare(spec, given)
  local out = { length = true, mass = args.bare(given.mass), density = args.bare(given.density) }
  for _, s in ipairs(spec.args) do
    local x = given[s.name]
    if s.dim == "length" and x ~= nil then out.length = out.length and args.bare(x) end
  end
  return out
end

-- What the digits of the entries of a `tensor` say of their rounding.
local function written(given)
  local list = {}
  for i, name in ipairs(vec.entry) do list[i] = value.digits(given[name]) or false end
  return digits.written(list, 6)
end

-- Negative moments of a `tensor`; true when there are none.
local function signs(line, a, given)
  local entries = vec.map({ a.xx, a.yy, a.zz, a.xy, a.xz, a.yz }, value.number)
  local hint, ok = nil, true
  for i = 1, 3 do
    local name, got = vec.entry[i], nil
    if R.sign(entries[i]) < 0 then
      hint = hint and "" or law.hint { I = entries, mass = value.number(a.mass), com = vec.map(a.com, value.number),
        about = a.about }
      got = value.show(given[name]) .. hint
    end
    ok = args.condition(ctx, ctx.diag:locate(line, name), "tensor", law.not_negative(name), a[name], got, true) and ok
  end
  return ok
end

-- A `tensor` of numbers that is a rod but for the rounding of who computed it becomes one.
local function straight(node)
  local a, I = node.a, {}
  for i, name in ipairs(vec.entry) do
    if a[name].kind ~= "num" then return end
    I[i] = a[name].value
  end
  local rod = a.about == "com" and not node.formal and law.rod(node.written, I)
  if not rod then return end
  node.typed = vec.map(I, expr.num)
  for i, name in ipairs(vec.entry) do a[name] = expr.num(rod[i]) end
end

-- The constructor of one catalogue entry.
function shapes.constructor(spec)
  local what = string.gsub(spec.name, "^solid%.", "")
  return function(given)
    local line = here()
    local extra = spec.measure and { "mass", "density" }
    local a, ok = args.read(ctx, line, what, spec.args, given, extra)
    local node = { shape = spec.name, a = a, line = line, measure = spec.measure, curved = spec.curved }
    if args.plain(given) and spec.measure then
      ok = shapes.amount(spec, what, line, given, node) and ok
      node.bare = bare(spec, given)
    end
    if ok and spec.requires then
      for _, c in ipairs(spec.requires(a)) do
        ok = args.condition(ctx, line, what, c[2], c[1], args.named(spec.args, c[2], given), c[3]) and ok
      end
    end
    if ok and spec.polygons then
      ok = polygon.check(ctx, line, what, a.profile, a.holes or {}, spec.polygons == "x")
    end
    if spec.name == "tensor" then
      ok = ok and signs(line, a, given)
      node.mass, node.formal, node.written = a.mass, a.physical == false, written(args.plain(given) and given or {})
      if ok then straight(node) end
    end
    node.broken = not ok
    return new(node)
  end
end

-- points{{m, x, y, z}, ...}
function shapes.points(given)
  local line, node = here(), { shape = "points", rows = {} }
  node.line = line
  if not args.plain(given) or #given == 0 then
    ctx.diag:error(line, "points", "takes a list of rows {mass, x, y, z}", diag.show(given))
    node.broken = true
    return new(node)
  end
  node.size = #given
  if node.size > most_parts then
    ctx.diag:error(line, "points", "takes at most " .. most_parts .. " rows", diag.show(node.size))
    node.broken = true
    return new(node)
  end
  for _, k in ipairs(args.keys(given)) do
    if math.type(k) ~= "integer" then
      ctx.diag:error(line, "points", "unknown argument " .. diag.show(k) .. " (it has only rows)")
    end
  end
  for i = 1, #given do
    local row = given[i]
    if not args.list(row, 4) then
      ctx.diag:error(line, "points", "row " .. i .. " must be {mass, x, y, z}", diag.show(row))
      node.broken = true
    else
      local m = args.scalar(ctx, line, "points", "mass of row " .. i, { dim = "mass", sign = "positive" }, row[1])
      local r = args.vector(ctx, line, "points", "position of row " .. i, { dim = "length", size = 3 },
        { row[2], row[3], row[4] })
      if m and r then node.rows[#node.rows + 1] = { m, r[1], r[2], r[3] } else node.broken = true end
    end
  end
  return new(node)
end

-- region{{x, lo, hi}, {y, lo, hi}, {z, lo, hi}, density = ...}
function shapes.region(given) return new(region.read(ctx, here(), given)) end

---- placement -------------------------------------------------------------------------------------

-- The node above that of self.
local function derived(self, node)
  node.line = node.line or here()
  node.of = record[self]
  node.size, node.formal = node.of.size, node.of.formal
  node.broken = node.broken or node.of.broken
  return new(node)
end

local function receiver(self, name)
  if record[self] then return true end
  ctx.diag:error(here(), name, "is called on a shape with a colon: shape:" .. name .. "{...}", diag.show(self))
  return false
end

function method.at(self, r)
  if not receiver(self, "at") then return shapes.broken() end
  local line = called "at"
  local v = args.vector(ctx, line, "at", "position", { dim = "length", size = 3 }, r)
  return derived(self, { op = "at", r = v, broken = v == nil, line = line })
end

function method.turned(self, given)
  if not receiver(self, "turned") then return shapes.broken() end
  local line = called "turned"
  local q, turns = rotation.read(ctx, line, "turned", given)
  return derived(self, { op = "turned", q = q, turns = turns, euler = turns and given.euler, broken = q == nil,
    line = line })
end

-- Why the shapes below `node` cannot be scaled by different factors or sheared, or nil.  A volume stays uniform under
-- any affine map, a flat plate and a straight rod too, but how much a density per area or length is worth then depends
-- on how it lies; a curved wire or shell does not stay uniform.
local function stiff(node)
  if node.formal then return "a tensor with physical = false can only be scaled by one factor" end
  if node.shape then
    if node.curved then return "a curved wire or shell can only be scaled by one factor" end
    if node.density and node.measure ~= "volume" then
      return "a plate or rod given by its density can only be scaled by one factor"
    end
    return nil
  end
  if node.of then return stiff(node.of) end
  return stiff(node[1]) or stiff(node[2])
end

function method.scaled(self, k)
  if not receiver(self, "scaled") then return shapes.broken() end
  if not args.plain(k) then k = { k } end
  local specs = { size = #k == 1 and 1 or 3, sign = "positive" }
  local line = called "scaled"
  local v = args.vector(ctx, line, "scaled", "factor", specs, k)
  if v and #v == 1 then v = { v[1], v[1], v[1] } end
  local rule = v and not (v[1] == v[2] and v[2] == v[3]) and stiff(record[self])
  if rule then
    ctx.diag:error(line, "scaled", rule, diag.show(k))
    v = nil
  end
  return derived(self, { op = "scaled", k = v, broken = v == nil, line = line })
end

-- {xy = k, ...}: x grows by k y, and so on for any of the six pairs.
function method.sheared(self, given)
  if not receiver(self, "sheared") then return shapes.broken() end
  local line = called "sheared"
  local specs, A = {}, {}
  for i, to in ipairs { "x", "y", "z" } do
    A[i] = { expr.zero, expr.zero, expr.zero }
    A[i][i] = expr.one
    for j, by in ipairs { "x", "y", "z" } do
      if i ~= j then specs[#specs + 1] = { name = to .. by, default = 0, i = i, j = j } end
    end
  end
  local a, ok = args.read(ctx, line, "sheared", specs, given)
  for _, s in ipairs(specs) do A[s.i][s.j] = a[s.name] or expr.zero end
  local rule = ok and stiff(record[self])
  if rule then
    ctx.diag:error(line, "sheared", rule)
    ok = false
  end
  local volume = vec.dot(A[1], vec.cross(A[2], A[3]))
  local n = ok and value.number(volume)
  ok = ok and args.condition(ctx, line, "sheared", "the determinant must be positive", volume,
    n and diag.show(R.todouble(n)))
  return derived(self, { op = "sheared", A = A, broken = not ok, line = line })
end

function method.mirrored(self, axis)
  if not receiver(self, "mirrored") then return shapes.broken() end
  local k = { x = { -1, 1, 1 }, y = { 1, -1, 1 }, z = { 1, 1, -1 } }
  local v = k[axis]
  local line = called "mirrored"
  if not v then ctx.diag:error(line, "mirrored", "axis must be \"x\", \"y\" or \"z\"", diag.show(axis)) end
  return derived(self, { op = "scaled", k = v and vec.map(v, expr.lift), broken = v == nil, line = line })
end

-- + or -; after an error the side that is a shape stands for both.
local function joined(op, word)
  return function(a, b)
    local line = here()
    local x, y = record[a or false], record[b or false]
    if not x or not y then
      ctx.diag:error(line, word, "both sides must be shapes", value.show(not x and a or b))
      return (x and a) or (y and b) or shapes.broken()
    end
    if x.formal or y.formal then
      ctx.diag:error(line, word, "a tensor with physical = false stands alone (it can be moved, turned, mirrored " ..
        "and scaled by one factor)")
      return shapes.broken()
    end
    local node = { op = op, x, y, line = line, broken = x.broken or y.broken, size = (x.size or 1) + (y.size or 1) }
    if node.size > most_parts then
      ctx.diag:error(line, word, "a body must have at most " .. most_parts .. " parts", diag.show(node.size))
      node.broken = true
    end
    return new(node)
  end
end

handle.__add = joined("sum", "+")
handle.__sub = joined("minus", "-")
function handle.__newindex() ctx.diag:error(here(), "shape", "a shape cannot be changed") end
function handle.__tostring() return "a shape" end

return shapes
