-- exact.lua - reads the numbers of the reference tables: sympy's texts as expressions, C literals as rationals.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"

local exact = {}

local names = { pi = expr.pi, sqrt = expr.sqrt, n = expr.lift, E = expr.call("exp", expr.one) }
for _, fn in ipairs { "exp", "sinh", "cosh", "tanh" } do
  names[fn] = function(x) return expr.call(fn, expr.lift(x)) end
end

-- The expression that a sympy text denotes; whole numbers must not become doubles on the way.
function exact.value(s)
  local lua = "return " .. s:gsub("%*%*", "^"):gsub("%d+", 'n"%0"')
  return expr.lift(assert(load(lua, lua, "t", names))())
end

-- Has the text functions that no normal form decides?
function exact.transcendental(s) return s:find "nh" ~= nil or s:find "osh" ~= nil or s:find "exp" ~= nil end

-- The second point of a row as a scene's table.
function exact.point(row)
  local function one(s)
    return (s:gsub("sqrt%((%d+)%)", "sqrt[%1]"):gsub("(%d+)/(%d+)", 'exact("%1/%2")'):gsub("sqrt%[(%d+)%]", "sqrt(%1)"))
  end
  local list = {}
  for i, s in ipairs(row.point) do list[i] = one(s) end
  return "{" .. table.concat(list, ", ") .. "}"
end

-- The rows of inertia.h by id: {mass, centroid, tensor, about} as rationals.
function exact.decimals(path)
  local file = assert(io.open(path))
  local text = file:read "a"
  file:close()
  local out = {}
  local function list(s)
    local v = {}
    for x in s:gmatch "[^,{}%s]+" do v[#v + 1] = R.parse((x:gsub("L$", ""))) end
    return v
  end
  for id, mass, centroid, tensor, about in
    text:gmatch '{"([^"]+)", ([^,]+), [^,]+, (%b{}),%s*(%b{}),%s*%b{}, (%b{})}' do
    out[id] = { mass = list(mass)[1], centroid = list(centroid), tensor = list(tensor), about = list(about) }
  end
  return out
end

return exact
