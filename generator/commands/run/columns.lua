-- columns.lua -- the columns of `polhode run`: those of the scene, or what --columns asks for.
--
--     columns.of(host, job, text, given) -> {names, row = function(t, x, energy, L) -> numbers}; nil and what is wrong
-- A row has its time as row.t, too.  A word is t, a state, energy, Lx .., a quantity or a group of `quantities`; what
-- is no word is an expression of them and of the parameters, with a name before it (rim = 0.1*wx) or its own text.
-- Quantities are those of attitude/quantities.lua.  Angles are in rad.  given.course: the scene's inputs over time,
-- known before the first row.
-- SPDX-License-Identifier: GPL-3.0-or-later

local evaluate = require "generator.algebra.evaluate"
local quantities = require "generator.attitude.quantities"
local contact = require "generator.dynamics.contact"
local vec = require "generator.algebra.vec"
local touch = require "generator.commands.run.touch"
local options = require "generator.commands.options"
local expression = require "generator.dsl.expression"
local diag = require "generator.diag"

local columns = {}

local function part(kind) return function(s) return s[kind] end end

local parts = { attitude = "q", rates = "w", position = "r", velocity = "v" }

-- The attitude of the frame that turns as a function of time; nil without one, and false where its axis moves too, so
-- that there is no formula.  About a fixed axis the angle is |rate| t + rate_dot t^2/2; at t = 0 it is 0.
local function base(m)
  if not m.frame then return nil end
  local rate, change, axis = {}, {}, nil
  for i = 1, 3 do rate[i], change[i] = m:double(m.frame.a.rate[i]), m:double(m.frame.a.rate_dot[i]) end
  for i = 1, 3 do
    local j = i % 3 + 1
    if rate[i] * change[j] ~= rate[j] * change[i] then return false end
    if rate[i] ~= 0 or change[i] ~= 0 then axis = axis or (rate[i] ~= 0 and rate or change) end
  end
  local size = math.sqrt(vec.dot(axis, axis))
  local unit = vec.map(axis, function(x) return x / size end)
  local first, second = vec.dot(rate, unit), vec.dot(change, unit)
  return function(t)
    local half = (first + second * t / 2) * t / 2
    return { math.cos(half), table.unpack(vec.map(unit, function(x) return math.sin(half) * x end)) }
  end
end

-- What the scene has, as a list of words in the order of the usual columns: {name, unit, function(sample)}; by name;
-- groups, {name -> names}; and the words of expressions, in which the name of a group may be a number, too.
local function words_of(job)
  local list, by_name, groups, wide, has = {}, {}, {}, {}, { energy = true, L = job.model.has.attitude or nil,
    contact = (contact.of(job.model) or job.record.landing) and true or nil,
    frame = job.model.frame and true or nil, base = base(job.model) ~= false }
  local function word(name, unit, f, about)
    by_name[name] = { name = name, unit = unit, f = f, about = about }
    list[#list + 1], wide[#wide + 1] = by_name[name], by_name[name]
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
  for _, w in ipairs(quantities.words()) do
    local name, unit, _, q, k = table.unpack(w)
    local fits = true
    for _, need in ipairs(q[2]) do fits = fits and has[need] end
    local function f(sample) return quantities.value(w, sample) end
    if fits and (k or not q[5]) then word(name, unit, f, not k and q.about or nil) elseif fits then
      wide[#wide + 1] = { name = name, unit = unit, f = f }
    end
    if fits and k then group(q[1], name) end
  end
  return list, by_name, groups, wide
end

-- The words that an expression of the scene may have, {name, unit, function(sample)}, in their order and by name.
function columns.words(job)
  local list, by_name = select(4, words_of(job)), {}
  for _, w in ipairs(list) do by_name[w.name] = w end
  return list, by_name
end

-- The same words in short, for a message: of a vector "com_x .. z"; of the Euler angles one sequence stands for all.
function columns.told(job)
  local list, out, ends = columns.words(job), {}, {}
  for _, w in ipairs(quantities.words()) do
    local q, k = w[4], w[5]
    if k then ends[w[1]] = k == 1 and not string.find(w[1], "^euler_%a") and " .. " .. q[5][#q[5]] or "" end
  end
  for _, w in ipairs(list) do
    local tail = ends[w.name]
    if tail ~= "" then out[#out + 1] = w.name .. (tail or "") end
  end
  return table.concat(out, ", ")
end

-- What a word that the scene lacks may have meant, as the end of a message.
local function missing(job, word, known)
  if string.find(word, "^omega_inertial") and base(job.model) == false then
    return ": the axis of its frame moves, so that there is no formula for the frame's attitude; there is omega_frame"
  end
  local axis = string.match(word, "^omega_?([xyz123]?)$")
  if axis and job.model.has.rates then
    axis = ({ ["1"] = "x", ["2"] = "y", ["3"] = "z" })[axis] or axis
    local body, space = "w" .. axis, "omega_inertial" .. (axis ~= "" and "_" .. axis or "")
    return "; the angular velocity is " .. body .. " in body axes and " .. space .. " in inertial axes"
  end
  return options.meant(word, known)
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
  return { name = name, unit = read.unit, f = function(sample)
    for _, w in ipairs(used) do env[w.name] = w.f(sample) end
    return evaluate.double(read.e, env)
  end }
end

-- A function that gives for one word, group or expression its columns, {{name =, unit =, f = of a sample}, ...; about =
-- in words}, or nil and what is wrong.  option: where the user wrote it; others: more words that the option knows.
function columns.reader(host, job, option, others)
  local list, by_name, groups, wide = words_of(job)
  local known = { table.unpack(others or {}) }
  for _, w in ipairs(list) do known[#known + 1] = w.name end
  local abouts = {}
  for _, q in ipairs(quantities.list) do
    known[#known + 1], abouts[q[1]] = q[5] and q[1] or nil, q.about
  end
  return function(entry)
    local name, body = string.match(entry, "^([%a_][%w_]*)%s*=%s*([^=].*)$")
    if by_name[entry] then return { by_name[entry], about = by_name[entry].about } end
    if groups[entry] then
      local out = { about = abouts[entry] }
      for i, member in ipairs(groups[entry]) do out[i] = by_name[member] end
      return out
    end
    if not name and string.find(entry, "^[%a_][%w_]*$") and not job.model.defaults[entry] then
      return nil, option .. ": the scene has no " .. entry .. missing(job, entry, known)
    end
    local c, why = expression_column(host, job, name or entry, body or entry, wide)
    if not c then return nil, option .. " " .. entry .. ": " .. why end
    return { c }
  end
end

-- The columns that are asked for: a list of {name, f}, or nil and what is wrong.
local function asked(host, job, text)
  local reader, out, taken = columns.reader(host, job, "--columns"), {}, {}
  for _, entry in ipairs(options.entries(text)) do
    if entry == "" then return nil, "--columns must be words or expressions with commas between, got " .. text end
    local list, why = reader(entry)
    if not list then return nil, why end
    for _, c in ipairs(list) do
      if taken[c.name] then return nil, "--columns: the column " .. c.name .. " is there twice" end
      taken[c.name] = true
      out[#out + 1] = c
    end
  end
  return out
end

local nowhere = {} -- of a disc that lies flat
for i = 1, 16 do nowhere[i] = 0 / 0 end

-- A sample from t, the scene's state, energy and L; on: the state of the scene given.ground, where a body that flies
-- and lands touches the plane.
function columns.sampler(host, job, given)
  local at, touching, plane = {}, touch.of(host, job, given and given.ground), touch.plane(job)
  local turned = base(job.model)
  for i, s in ipairs(job.states) do
    local kind = parts[s.kind]
    if kind then
      at[kind] = at[kind] or {}
      table.insert(at[kind], i)
    end
  end
  return function(t, x, energy, L, on)
    local s = { t = t, x = x, energy = energy, L = L, base = turned or nil, normal = plane and plane.normal }
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
  local sample, names = columns.sampler(host, job, given), {}
  for i, c in ipairs(list) do names[i] = c.name end
  return { names = names, row = function(t, x, energy, L, on)
    local s, row = sample(t, x, energy, L, on), { t = t }
    for i, c in ipairs(list) do row[i] = c.f(s) end
    return row
  end }
end

return columns
