-- factored.lua -- n 1 - J = L U by the structure of a matrix, as definitions: no pivots, no entry that is zero.
--
-- Pivots are diagonal entries, first those that fill least (Markowitz 1957, Management Science 3, 255).  Row p of U has
-- its pivot as 1/U_pp.  L has ones on its diagonal.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"

local factored = {}

local RANK = 8

-- The order of the pivots and where L + U has entries: order = {rows}, full[i][k].
local function ordered(n, full)
  local left, order = {}, {}
  for i = 1, n do left[i] = true end
  for _ = 1, n do
    local best, least
    for p = 1, n do
      if left[p] then
        local row, column = 0, 0
        for i = 1, n do
          if left[i] and i ~= p then
            row, column = row + (full[p][i] and 1 or 0), column + (full[i][p] and 1 or 0)
          end
        end
        if not least or row * column < least then best, least = p, row * column end
      end
    end
    order[#order + 1], left[best] = best, nil
    for i = 1, n do
      for k = 1, n do
        if left[i] and left[k] and full[i][best] and full[best][k] then full[i][k] = true end
      end
    end
  end
  return order
end

-- sum over what was eliminated before of L_ik U_kj
local function eliminated(cell, order, upto, i, j)
  local terms = {}
  for s = 1, upto do
    local k = order[s]
    if cell[i][k] and cell[k][j] then terms[#terms + 1] = cell[i][k] * cell[k][j] end
  end
  return expr.add(terms)
end

-- Forward and back substitution: F[..] and b[..] give k[..].
local function solved(states, order, cell)
  local forward = { why = "L y = b", defs = {}, outs = {} }
  local back = { why = "U k = y", defs = {}, outs = {} }
  local y, k = {}, {}
  for s, p in ipairs(order) do
    local terms = { expr.sym("b" .. states[p].name, RANK) }
    for r = 1, s - 1 do
      local q = order[r]
      if cell[p][q] then terms[#terms + 1] = -cell[p][q] * y[q] end
    end
    local name = "y_" .. states[p].name
    forward.defs[s] = { name = name, expr = expr.add(terms) }
    y[p] = expr.sym(name, RANK)
  end
  for s = #order, 1, -1 do
    local p = order[s]
    local terms = { y[p] }
    for r = s + 1, #order do
      local q = order[r]
      if cell[p][q] then terms[#terms + 1] = -cell[p][q] * k[q] end
    end
    local name = "k_" .. states[p].name
    back.defs[#back.defs + 1] = { name = name, expr = cell[p][p] * expr.add(terms) }
    k[p] = expr.sym(name, RANK)
  end
  for i, s in ipairs(states) do back.outs[i] = { array = "k", index = i - 1, expr = expr.sym("k_" .. s.name, RANK) } end
  return { forward, back }
end

-- states: {name}; J: its matrix of expressions; n: the symbol.  Returns {groups = the factors into F[..], entries = the
-- expressions of J that they use, names = of F's entries, solve = the groups of what uses them}.
function factored.of(states, J, n)
  local size, full, cell, names, entries = #states, {}, {}, {}, {}
  for i = 1, size do
    full[i], cell[i] = {}, {}
    for k = 1, size do
      full[i][k] = i == k or J[i][k] ~= expr.zero
      entries[#entries + 1] = J[i][k]
    end
  end
  local order = ordered(size, full)
  local g = { why = "n 1 - J = L U; the diagonal of U as its inverse", defs = {}, outs = {} }
  local function put(i, k, e)
    local name = states[i].name .. "_" .. states[k].name
    g.defs[#g.defs + 1] = { name = "f_" .. name, expr = e }
    cell[i][k] = expr.sym("f_" .. name, RANK)
    names[#names + 1] = name
    g.outs[#g.outs + 1] = { array = "F", index = #names - 1, expr = cell[i][k] }
  end
  for s, p in ipairs(order) do
    put(p, p, 1 / (n - J[p][p] - eliminated(cell, order, s - 1, p, p)))
    for r = s + 1, size do
      local q = order[r]
      if full[p][q] then put(p, q, -J[p][q] - eliminated(cell, order, s - 1, p, q)) end
    end
    for r = s + 1, size do
      local q = order[r]
      if full[q][p] then put(q, p, cell[p][p] * (-J[q][p] - eliminated(cell, order, s - 1, q, p))) end
    end
  end
  local read = {}
  for i = 1, size do
    read[i] = {}
    for k = 1, size do
      if cell[i][k] then read[i][k] = expr.sym("F" .. states[i].name .. "_" .. states[k].name, RANK) end
    end
  end
  return { groups = { g }, entries = entries, names = names, solve = solved(states, order, read) }
end

return factored
