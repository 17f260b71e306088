-- covariance.lua -- --covariance FILE.csv: means and covariance of normal values, and the factor that makes them.
--
--     name,mean,wx,wy            a row a name, in the order of the columns
--     wx,6,0.01,0.002
--     wy,0,0.002,0.04
--     covariance.read(host, file) -> {{name, mean, factor = row of L}, ...}, L L^T the covariance | nil, what is wrong
-- Cholesky's factor in exact arithmetic but for the roots; a matrix that is no covariance is refused by its pivot.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"

local covariance = {}

local function cells(line)
  local list = {}
  for cell in string.gmatch(line .. ",", "([^,]*),") do list[#list + 1] = string.match(cell, "^%s*(.-)%s*$") end
  return list
end

local function rows_of(text)
  local rows = {}
  for line in string.gmatch(string.gsub(text, "\r", ""), "[^\n]+") do
    if string.find(line, "%S") then rows[#rows + 1] = cells(line) end
  end
  return rows
end

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
  local text, why = host.read(file)
  if not text then return nil, why end
  local rows = rows_of(text)
  local head, n = rows[1] or {}, #rows - 1
  if head[1] ~= "name" or head[2] ~= "mean" or #head ~= n + 2 or n < 1 then
    return nil, file .. ": the first line must be name,mean and the names, and each name must have a row"
  end
  local C, out = {}, {}
  for i = 1, n do
    local row = rows[i + 1]
    if row[1] ~= head[i + 2] or #row ~= n + 2 then
      return nil, file .. ": row " .. i .. " must be of " .. head[i + 2] .. ", with its mean and " .. n .. " numbers"
    end
    C[i] = {}
    for j = 0, n do
      local q = R.parse(row[j + 2])
      if not q then return nil, file .. ": row " .. row[1] .. " must be of numbers, got " .. row[j + 2] end
      if j == 0 then out[i] = { name = row[1], mean = R.todouble(q) } else C[i][j] = q end
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
