-- columns.lua -- the columns of `polhode run`: those of the scene, or what --columns asks for.
--
--     columns.of(host, job, text, given) -> {names, row = function(t, x, energy, L) -> numbers}; nil and what is wrong
-- A row has its time as row.t, too.  A word is t, a state, energy, Lx .., a quantity or a group of `quantities`; what
-- is no word is an expression of them and of the parameters, with a name before it (rim = 0.1*wx) or its own text.
-- Angles are in rad.  given.course: the scene's inputs over time, known before the first row.
-- SPDX-License-Identifier: GPL-3.0-or-later

local evaluate = require "generator.algebra.evaluate"
local rotation = require "generator.attitude.rotation"
local contact = require "generator.dynamics.contact"
local touch = require "generator.commands.run.touch"
local options = require "generator.commands.options"
local expression = require "generator.dsl.expression"
local diag = require "generator.diag"

local columns = {}

local xyz = { "x", "y", "z" }

local function part(kind) return function(s) return s[kind] end end

local function norm(v) return math.sqrt(v[1] * v[1] + v[2] * v[2] + v[3] * v[3]) end

-- Quantities of a sample {t, q, w, r, v, energy, L}: {name, what it needs, unit, function -> a number or a list,
-- endings of the columns' names (nil: one column)}.
columns.quantities = {
  { "speed", { "w" }, "rad/s", function(s) return norm(s.w) end, about = "|w|" },
  { "omega_inertial", { "q", "w" }, "rad/s", function(s) return rotation.apply(s.q, s.w) end, xyz,
    about = "w in inertial axes" },
  { "L", { "L" }, "N m s", part "L", xyz, plain = true, about = "L in inertial axes" },
  { "L_body", { "q", "L" }, "N m s", function(s) return rotation.back(s.q, s.L) end, xyz, about = "L in body axes" },
  { "momentum", { "L" }, "N m s", function(s) return norm(s.L) end, about = "|L|" },
  { "tilt", { "q" }, "rad", function(s)
    local z = rotation.apply(s.q, { 0.0, 0.0, 1.0 })
    return math.atan(math.sqrt(z[1] * z[1] + z[2] * z[2]), z[3])
  end, about = "the angle between the body's z and inertial z" },
  { "N", { "contact" }, "N", function(s) return s.contact()[1] end, about = "the reaction of the plane" },
  { "com", { "contact" }, "m", function(s) return { table.unpack(s.contact(), 2, 4) } end, xyz,
    about = "the centre of mass on the plane, inertial axes" },
  { "com_velocity", { "contact" }, "m/s", function(s) return { table.unpack(s.contact(), 5, 7) } end, xyz,
    about = "its velocity" },
  { "contact_force", { "contact" }, "N", function(s) return { table.unpack(s.contact(), 8, 10) } end, xyz,
    about = "the force of the plane" },
  { "contact_point", { "contact" }, "m", function(s) return { table.unpack(s.contact(), 11, 13) } end, xyz,
    about = "where the body touches it" },
  { "slip", { "contact" }, "m/s", function(s) return { table.unpack(s.contact(), 14, 16) } end, xyz,
    about = "the velocity of the body there against the plane" },
  { "axis", { "q" }, "1", function(s) return rotation.apply(s.q, { 0.0, 0.0, 1.0 }) end, xyz,
    about = "the body's z in inertial axes" },
  { "rotation_vector", { "q" }, "rad", function(s) return rotation.vector(s.q) end, xyz, about = "axis times angle" },
  { "matrix", { "q" }, "1", function(s)
    local R, list = rotation.matrix(s.q), {}
    for i = 1, 3 do
      for j = 1, 3 do list[#list + 1] = R[i][j] end
    end
    return list
  end, { "11", "12", "13", "21", "22", "23", "31", "32", "33" }, about = "rotation matrix, body to space" },
}

-- euler, which is euler_zxz, and the eleven others: three angles each.
local function euler(name, sequence)
  return { name, { "q" }, "rad", function(s) return (rotation.euler(s.q, sequence)) end, { "1", "2", "3" },
    about = "Euler angles " .. sequence }
end
columns.quantities[#columns.quantities + 1] = euler("euler", "zxz")
for _, sequence in ipairs(rotation.sequences) do
  columns.quantities[#columns.quantities + 1] = euler("euler_" .. sequence, sequence)
end

local parts = { attitude = "q", rates = "w", position = "r", velocity = "v" }

-- What the scene has, as a list of words in the order of the usual columns: {name, unit, function(sample)}; then
-- groups, {name -> names}.
local function words_of(job)
  local list, by_name, groups, has = {}, {}, {}, { energy = true, L = job.model.has.attitude or nil,
    contact = (contact.of(job.model) or job.record.landing) and true or nil }
  local function word(name, unit, f)
    by_name[name] = { name = name, unit = unit, f = f }
    list[#list + 1] = by_name[name]
  end
  local function group(name, member)
    groups[name] = groups[name] or {}
    table.insert(groups[name], member)
  end
  word("t", "s", part "t")
  for i, s in ipairs(job.states) do
    word(s.name, s.unit, function(sample) return sample.x[i] end)
    local kind = parts[s.kind]
    if kind then
      has[kind] = true
      group(kind, s.name)
    end
    group("states", s.name)
  end
  word("energy", "J", part "energy")
  for _, q in ipairs(columns.quantities) do
    local fits = true
    for _, need in ipairs(q[2]) do fits = fits and has[need] end
    for k, ending in ipairs(fits and q[5] or {}) do
      local name = q[1] .. (q.plain and "" or "_") .. ending
      word(name, q[3], function(sample) return q[4](sample)[k] end)
      group(q[1], name)
    end
    if fits and not q[5] then word(q[1], q[3], q[4]) end
  end
  return list, by_name, groups
end

-- The text cut at commas outside of brackets.
local function entries(text)
  local list, depth, from = {}, 0, 1
  for i = 1, #text do
    local c = string.sub(text, i, i)
    if c == "(" then depth = depth + 1 elseif c == ")" then depth = depth - 1 end
    if c == "," and depth <= 0 then
      list[#list + 1] = string.sub(text, from, i - 1)
      from = i + 1
    end
  end
  list[#list + 1] = string.sub(text, from)
  for i, s in ipairs(list) do list[i] = string.match(s, "^%s*(.-)%s*$") end
  return list
end

-- An expression as a column, or nil and what is wrong.
local function expression_column(host, job, name, text, list)
  local words = {}
  for i, w in ipairs(list) do words[i] = { w.name, w.unit } end
  local d = diag.new("--columns", text)
  local read = expression.read(host, d, text, words, job.model.params)
  if not read then return nil, (string.gsub(d.errors[1].message, "^expression: ", "")) end
  local used, env = {}, {}
  for k, q in pairs(job.model.defaults) do env[k] = q end -- into a table: order is lost anyway
  for _, w in ipairs(list) do
    if string.find(text, w.name, 1, true) then used[#used + 1] = w end
  end
  return { name = name, f = function(sample)
    for _, w in ipairs(used) do env[w.name] = w.f(sample) end
    return evaluate.double(read.e, env)
  end }
end

-- The columns that are asked for: a list of {name, f}, or nil and what is wrong.
local function asked(host, job, text)
  local list, by_name, groups = words_of(job)
  local out, taken, known = {}, {}, {}
  for _, w in ipairs(list) do known[#known + 1] = w.name end
  for _, q in ipairs(columns.quantities) do known[#known + 1] = q[5] and q[1] or nil end
  local wrong
  local function put(c)
    if taken[c.name] then wrong = wrong or "the column " .. c.name .. " is there twice" end
    taken[c.name] = true
    out[#out + 1] = c
  end
  for _, entry in ipairs(entries(text)) do
    local name, body = string.match(entry, "^([%a_][%w_]*)%s*=%s*([^=].*)$")
    if entry == "" then return nil, "--columns must be words or expressions with commas between, got " .. text end
    if by_name[entry] then
      put(by_name[entry])
    elseif groups[entry] then
      for _, member in ipairs(groups[entry]) do put(by_name[member]) end
    elseif not name and string.find(entry, "^[%a_][%w_]*$") and not job.model.defaults[entry] then
      return nil, "--columns: the scene has no " .. entry .. options.meant(entry, known)
    else
      local c, why = expression_column(host, job, name or entry, body or entry, list)
      if not c then return nil, "--columns " .. entry .. ": " .. why end
      put(c)
    end
  end
  if wrong then return nil, "--columns: " .. wrong end
  return out
end

local nowhere = {} -- of a disc that lies flat
for i = 1, 16 do nowhere[i] = 0 / 0 end

-- A sample from t, the scene's state, energy and L; on: the state of the scene given.ground, where a body that flies
-- and lands touches the plane.
local function sampler(host, job, given)
  local at, touching = {}, touch.of(host, job, given and given.ground)
  for i, s in ipairs(job.states) do
    local kind = parts[s.kind]
    if kind then
      at[kind] = at[kind] or {}
      table.insert(at[kind], i)
    end
  end
  return function(t, x, energy, L, on)
    local s = { t = t, x = x, energy = energy, L = L }
    for _, kind in ipairs { "q", "w", "r", "v" } do
      if at[kind] then
        s[kind] = {}
        for n, i in ipairs(at[kind]) do s[kind][n] = x[i] end
      end
    end
    if touching then
      local known
      function s.contact()
        known = known or touching(t, x, given and given.course, on) or nowhere
        return known
      end
    end
    return s
  end
end

function columns.of(host, job, text, given)
  local list, why
  if text then
    list, why = asked(host, job, text)
    if not list then return nil, why end
  else
    list = {}
    local _, by_name, groups = words_of(job)
    local first = {}
    for _, kind in ipairs { "q", "w" } do
      for _, name in ipairs(groups[kind] or {}) do first[#first + 1] = name end
    end
    local rest = {}
    for _, name in ipairs(groups.states or {}) do rest[#rest + 1] = name end
    local order = { "t", table.unpack(first) }
    order[#order + 1] = "energy"
    for _, name in ipairs(groups.L or {}) do order[#order + 1] = name end
    for i = #first + 1, #rest do order[#order + 1] = rest[i] end
    for i, name in ipairs(order) do list[i] = by_name[name] end
  end
  local sample, names = sampler(host, job, given), {}
  for i, c in ipairs(list) do names[i] = c.name end
  return { names = names, row = function(t, x, energy, L, on)
    local s, row = sample(t, x, energy, L, on), { t = t }
    for i, c in ipairs(list) do row[i] = c.f(s) end
    return row
  end }
end

return columns
