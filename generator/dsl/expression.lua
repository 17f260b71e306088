-- expression.lua -- one expression of the motion that is not written in the scene, as on the command line.
--
--     expression.read(host, d, text, words, params) -> {e = expression, unit = text} | nil after errors in d
-- words: {{name, unit}, ...}, states and t; params: of the record.  The words and functions are those of a scene, and
-- so are the rules of dimensions; d are diagnostics of the text alone.
-- SPDX-License-Identifier: GPL-3.0-or-later

local motion = require "generator.algebra.motion"
local expr = require "generator.algebra.expr"
local args = require "generator.dsl.args"
local slips = require "generator.dsl.slips"
local units = require "generator.dsl.units"
local value = require "generator.dsl.value"
local nearest = require "generator.nearest"

local expression = {}

local function dimension(unit)
  local _, dim = units.parse(unit)
  return dim
end

function expression.read(host, d, text, words, params)
  local e, names = {}, {}
  value.begin(d)
  for _, k in ipairs(args.keys(host.safe)) do e[k] = k == "exact" and nil or host.safe[k] end
  e.pi = value.new(expr.pi, nil)
  for _, f in ipairs(value.functions) do e[f[1]] = value.func(table.unpack(f)) end
  for _, w in ipairs(words) do
    e[w[1]] = value.new(motion.sym(w[1]), dimension(w[2]), w[1] == "t" or "bare")
    names[#names + 1] = w[1]
  end
  for _, p in ipairs(params) do
    e[p.name] = value.new(p.sym, dimension(p.unit))
    value.default(p.sym, p.default)
    names[#names + 1] = p.name
  end
  local unknown
  setmetatable(e, { __index = function(_, k)
    unknown = unknown or k
    return nil
  end })
  local ok, first = host.sandbox("return " .. text, "@" .. d.file, e)
  if unknown then
    local best = nearest.one(unknown, names)
    d:error(0, "expression", "no word " .. unknown .. " (it has " .. table.concat(names, ", ") .. ")" ..
      (best and "; did you mean " .. best .. "?" or ""))
  elseif not ok then
    local message = string.gsub(string.gsub(first.message or "", "^.-:%d+: ", ""), "%c", " ")
    d:error(0, "expression", select(2, slips.syntax(d, 1, message)))
  end
  if d:failed() then return nil end
  local r, why = value.of(first)
  if not r then
    d:error(0, "expression", why or "is no number")
    return nil
  end
  return { e = r.e, unit = r.dim and units.si(r.dim) or "1" }
end

return expression
