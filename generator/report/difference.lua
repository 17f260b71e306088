-- difference.lua -- explain --diff A B: by what two scenes differ, term by term.
--
-- Each scene is flattened into sections of entries {key, value}; an entry is added, removed or changed.  The equations
-- are compared twice: group by group as they are emitted, and by the terms of each rate with every named quantity put
-- in, so that a renamed quantity is no difference there.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local text = require "generator.formula.text"
local equations = require "generator.dynamics.equations"
local attribution = require "generator.report.attribution"
local json = require "generator.report.json"

local difference = {}

local most_terms = 64 -- of a rate; what is longer is one term

-- How many terms e has when its products of sums are multiplied out, at most.
local function count(e)
  local n = e.kind == "add" and 0 or 1
  for i = 1, (e.kind == "add" or e.kind == "mul") and #e or 0 do
    n = e.kind == "add" and n + count(e[i]) or n * count(e[i])
    if n > most_terms then break end
  end
  return n
end

-- The terms of e as a sum, products with a sum multiplied out while that is short.
local function terms(e)
  if e.kind == "add" then
    local list = {}
    for i = 1, #e do
      for _, t in ipairs(terms(e[i])) do list[#list + 1] = t end
    end
    return #list <= most_terms and list or { e }
  end
  for i = 1, e.kind == "mul" and count(e) <= most_terms and #e or 0 do
    if e[i].kind == "add" then
      local rest, list = {}, {}
      for k = 1, #e do
        if k ~= i then rest[#rest + 1] = e[k] end
      end
      for k = 1, #e[i] do
        for _, t in ipairs(terms(expr.mul { expr.mul(rest), e[i][k] })) do list[#list + 1] = t end
        if #list > most_terms then return { e } end
      end
      return list
    end
  end
  return e == expr.zero and {} or { e }
end

local function lines_of_group(g)
  local list = {}
  for _, d in ipairs(g.defs) do list[#list + 1] = d.name .. " = " .. text.of(d.expr, "plain") end
  for _, o in ipairs(g.outs) do list[#list + 1] = "d" .. o.state .. "/dt = " .. text.of(o.expr, "plain") end
  return table.concat(list, "\n")
end

local function counts(job)
  local c = {}
  for _, f in ipairs(job.functions) do
    if f.name == "rhs" or f.name == "step" then c[#c + 1] = { f.name, attribution.words(attribution.cost(job, f)) } end
  end
  return c
end

-- The sections of a planned job: a list of {title, key, entries}; an entry is {key, value}.
local function flatten(job)
  local m, sections = job.model, {}
  local function section(title, key)
    local s = { title = title, key = key, entries = {} }
    sections[#sections + 1] = s
    return function(name, value) s.entries[#s.entries + 1] = { name, value } end
  end
  local put = section("Parameters", "parameters")
  for _, p in ipairs(m.params) do put(p.name, p.given) end
  put = section("States", "states")
  for _, s in ipairs(job.states) do put(s.name, s.about ~= "" and s.about or s.unit) end
  put = section("Derived constants", "constants")
  for _, c in ipairs(m.members) do
    local e = c.form == c.sym and c.e or c.form -- a step of the body stands nowhere else
    if not c.multiple then put(c.name, text.of(e, "plain") .. " = " .. json.number(m:double(c.e))) end
  end
  put = section("Equations", "equations")
  for _, g in ipairs(job.equations.groups) do put(string.match(g.why, "^[^:]*"), lines_of_group(g)) end
  put = section("Terms of the equations", "terms")
  for _, g in ipairs(job.equations.groups) do
    for _, o in ipairs(g.outs) do
      for _, t in ipairs(terms(equations.inline(job.equations.groups, o.expr))) do
        put("d" .. o.state .. "/dt: " .. text.of(t, "plain"), "")
      end
    end
  end
  put = section("Conserved", "conserved")
  for _, law in ipairs(job.conserved) do put(law, "") end
  put = section("Closed form", "closed_form")
  put("closed form", job.closed.kind and job.closed.theorem or "none: " .. job.closed.refused)
  put = section("Operations", "operations")
  for _, c in ipairs(counts(job)) do put(c[1], c[2]) end
  return sections
end

-- Entries by key; one key many times over gets numbers.
local function keyed(entries)
  local list, by, times = {}, {}, {}
  for _, e in ipairs(entries) do
    times[e[1]] = (times[e[1]] or 0) + 1
    local key = times[e[1]] == 1 and e[1] or e[1] .. " (" .. times[e[1]] .. ")"
    list[#list + 1] = key
    by[key] = e[2]
  end
  return list, by
end

-- A list of {title, key, changes}; a change is {how = "removed", "added" or "changed", key, a, b}.
local function compare(a, b)
  local left, right, out = flatten(a), flatten(b), {}
  for i, s in ipairs(left) do
    local changes = {}
    local keys_a, of_a = keyed(s.entries)
    local keys_b, of_b = keyed(right[i].entries)
    for _, key in ipairs(keys_a) do
      if of_b[key] == nil then
        changes[#changes + 1] = { how = "removed", key = key, a = of_a[key] }
      elseif of_b[key] ~= of_a[key] then
        changes[#changes + 1] = { how = "changed", key = key, a = of_a[key], b = of_b[key] }
      end
    end
    for _, key in ipairs(keys_b) do
      if of_a[key] == nil then changes[#changes + 1] = { how = "added", key = key, b = of_b[key] } end
    end
    out[#out + 1] = { title = s.title, key = s.key, changes = changes }
  end
  return out
end

local writers = {}

-- Lines of value that other lacks.
local function own_lines(value, other)
  local known, list = {}, {}
  for line in string.gmatch(other or "", "[^\n]+") do known[line] = true end
  for line in string.gmatch(value or "", "[^\n]+") do
    if not known[line] then list[#list + 1] = line end
  end
  return list
end

function writers.text(a, b, sections)
  local out = { "- " .. a.model.name .. " (" .. a.file .. ")", "+ " .. b.model.name .. " (" .. b.file .. ")" }
  local nothing = true
  for _, s in ipairs(sections) do
    if #s.changes > 0 then
      nothing = false
      out[#out + 1] = "\n" .. s.title
    end
    for _, c in ipairs(s.changes) do
      local mark = c.how == "removed" and "- " or c.how == "added" and "+ " or "  "
      local one = c.how ~= "changed" and not string.find(c.a or c.b, "\n", 1, true)
      if one then
        local value = c.a or c.b
        out[#out + 1] = "  " .. mark .. c.key .. (value ~= "" and ": " .. value or "")
      else
        out[#out + 1] = "  " .. mark .. c.key
        for _, line in ipairs(own_lines(c.a, c.b)) do out[#out + 1] = "    - " .. line end
        for _, line in ipairs(own_lines(c.b, c.a)) do out[#out + 1] = "    + " .. line end
      end
    end
  end
  if nothing then out[#out + 1] = "\nno difference" end
  return table.concat(out, "\n") .. "\n"
end

function writers.json(a, b, sections)
  local fields = { { "a", a.model.name }, { "b", b.model.name } }
  for _, s in ipairs(sections) do
    local list = {}
    for i, c in ipairs(s.changes) do
      list[i] = json.object { { "change", c.how }, { "what", c.key }, { "a", c.a or json.null },
        { "b", c.b or json.null } }
    end
    fields[#fields + 1] = { s.key, list }
  end
  return json.text(json.object(fields))
end

-- How the planned job b differs from a, in the format text or json.
function difference.text(a, b, format) return writers[format](a, b, compare(a, b)) end

return difference
