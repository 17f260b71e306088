-- covariance.lua -- --covariance FILE.csv: means and covariance of normal values, and the factor that makes them.
--
--     name,mean,wx,wy            a row a name, in the order of the columns
--     wx,6,0.01,0.002
--     wy,0,0.002,0.04
--     covariance.read(host, file) -> {{name, mean, factor = row of L}, ...}, L L^T the covariance | nil, what is wrong
-- Cholesky's factor in exact arithmetic but for the roots; a matrix that is no covariance is refused by its pivot.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local csv = require "generator.commands.csv"
local diag = require "generator.diag"

local covariance = {}

-- L with L L^T = C, row by row; nil and the row at which C is none.  A pivot of 0 is allowed where its column is 0.
local function factored(C)
  local n, D, U = #C, {}, {} -- C = U D U^T, U with ones on its diagonal, in rationals
  for i = 1, n do
    U[i] = {}
    for j = 1, i do
      local s = C[i][j]
      for k = 1, j - 1 do s = s - U[i][k] * D[k] * U[j][k] end
      if i == j then
        if R.sign(s) < 0 then return nil, i end
        D[i], U[i][i] = s, R.one
      elseif R.sign(D[j]) == 0 then
        if R.sign(s) ~= 0 then return nil, i end
        U[i][j] = R.zero
      else
        U[i][j] = s / D[j]
      end
    end
  end
  local L = {}
  for i = 1, n do
    L[i] = {}
    for j = 1, i do L[i][j] = R.todouble(U[i][j] * R.apply("sqrt", 128, D[j])) end
  end
  return L
end

function covariance.read(host, file)
  local f, why = csv.open(host, file)
  if not f then return nil, why end
  local rows, wrong = f.object:texts()
  if not rows then return nil, wrong end
  local head, n, C, out = f.names, #rows, {}, {}
  if head[1] ~= "name" or head[2] ~= "mean" or #head ~= n + 2 or n < 1 then
    return f:wrong "must be name,mean and the names, and each name must have a row"
  elseif next(f.units) then
    return f:wrong "a name must have no unit here: parameters are in the scene's, states in SI's"
  end
  for i, row in ipairs(rows) do
    local function say(rule, got)
      return nil, f.path .. ":" .. diag.show(row.line) .. ": " .. rule .. ", got " .. diag.show(got)
    end
    if row[1] ~= head[i + 2] then return say("must be the row of " .. head[i + 2], row[1]) end
    C[i] = {}
    for j = 0, n do
      local q = R.parse(row[j + 2])
      local x = q and R.todouble(q)
      if not x or x - x ~= 0 then return say("column " .. head[j + 2] .. " must be a number", row[j + 2]) end
      if j == 0 then out[i] = { name = row[1], mean = x } else C[i][j] = q end
    end
  end
  for i = 1, n do
    for j = 1, i - 1 do
      if C[i][j] ~= C[j][i] then
        return nil, file .. ": must be symmetric, and " .. out[i].name .. " with " .. out[j].name .. " is not"
      end
    end
  end
  local L, at = factored(C)
  if not L then
    return nil, file .. ": is no covariance: its row " .. out[at].name .. " asks for a negative variance"
  end
  for i, row in ipairs(out) do row.factor = L[i] end
  return out
end

return covariance
