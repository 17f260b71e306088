-- oracle.lua - the loss of a log by another road: motion, residuals, derivatives and covariance, for tests of the fit.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- A model is {names (of the unknowns as the fit's JSON has them), residuals = function(p) -> list of z, moved =
-- function(p, d) -> p with the unknowns changed by d}.  An initial attitude is changed by a small turn in body axes.
-- Derivatives are central differences of order 4 about the estimate; the motion is RK4 with its own short step.

local oracle = {}

-- ---- losses ----

local CORNER = { huber = 1.345, cauchy = 2.385 }

-- psi = rho' and rho'' at z.
function oracle.psi(loss, z)
  local k = CORNER[loss]
  if loss == "huber" then return math.max(-k, math.min(k, z)), math.abs(z) <= k and 1 or 0 end
  if loss == "squares" then return z, 1 end
  local u = (z / k) ^ 2
  return z / (1 + u), (1 - u) / (1 + u) ^ 2
end

function oracle.rho(loss, z)
  local k, size = CORNER[loss], math.abs(z)
  if loss == "huber" and size > k then return k * size - k * k / 2 end
  if loss == "cauchy" then return k * k / 2 * math.log(1 + (z / k) ^ 2) end
  return z * z / 2
end

function oracle.loss(model, p, loss)
  local sum = 0
  for _, z in ipairs(model.residuals(p)) do sum = sum + oracle.rho(loss, z) end
  return sum
end

-- ---- small matrices ----

-- A^-1 b by elimination with pivots.
function oracle.solve(A, b)
  local n, M = #b, {}
  for i = 1, n do
    M[i] = { table.unpack(A[i]) }
    M[i][n + 1] = b[i]
  end
  for i = 1, n do
    local p = i
    for r = i + 1, n do p = math.abs(M[r][i]) > math.abs(M[p][i]) and r or p end
    M[i], M[p] = M[p], M[i]
    for r = i + 1, n do
      local f = M[r][i] / M[i][i]
      for c = i, n + 1 do M[r][c] = M[r][c] - f * M[i][c] end
    end
  end
  local x = {}
  for i = n, 1, -1 do
    x[i] = M[i][n + 1]
    for c = i + 1, n do x[i] = x[i] - M[i][c] * x[c] end
    x[i] = x[i] / M[i][i]
  end
  return x
end

function oracle.inverse(A)
  local n, out = #A, {}
  for i = 1, n do out[i] = {} end
  for k = 1, n do
    local unit = {}
    for i = 1, n do unit[i] = i == k and 1 or 0 end
    for i, x in ipairs(oracle.solve(A, unit)) do out[i][k] = x end
  end
  return out
end

local function product(A, B)
  local out = {}
  for i = 1, #A do
    out[i] = {}
    for k = 1, #B[1] do
      local sum = 0
      for j = 1, #B do sum = sum + A[i][j] * B[j][k] end
      out[i][k] = sum
    end
  end
  return out
end

-- ---- at an estimate ----

local H = 2e-5 -- of the differences: their error is of order H^4, and that of rounding 1e-16/H

local function column(model, p, k)
  local function at(x)
    local d = {}
    for i = 1, #model.names do d[i] = i == k and x or 0 end
    return model.residuals(model.moved(p, d))
  end
  local a, b, c, d, out = at(H), at(-H), at(2 * H), at(-2 * H), {}
  for i = 1, #a do out[i] = (8 * (a[i] - b[i]) - (c[i] - d[i])) / (12 * H) end
  return out
end

-- The gradient J' psi, H = J' diag(rho'') J and B = J' diag(psi^2) J at p.
function oracle.model(model, p, loss)
  local z, n, J = model.residuals(p), #model.names, {}
  for k = 1, n do J[k] = column(model, p, k) end
  local g, curve, outer = {}, {}, {}
  for a = 1, n do
    g[a], curve[a], outer[a] = 0, {}, {}
    for b = 1, n do curve[a][b], outer[a][b] = 0, 0 end
  end
  for i, x in ipairs(z) do
    local psi, d = oracle.psi(loss, x)
    for a = 1, n do
      g[a] = g[a] + J[a][i] * psi
      for b = 1, n do
        local jj = J[a][i] * J[b][i]
        curve[a][b], outer[a][b] = curve[a][b] + d * jj, outer[a][b] + psi * psi * jj
      end
    end
  end
  return g, curve, outer
end

-- Newton's step that is left at p, its length in standard errors, and the covariance H^-1 B H^-1 (least squares: H^-1).
function oracle.judge(model, p, loss)
  local g, curve, outer = oracle.model(model, p, loss)
  local C = oracle.inverse(curve)
  local step, length = oracle.solve(curve, g), 0
  for i = 1, #g do
    length = length + step[i] * g[i]
    step[i] = -step[i]
  end
  return step, length >= 0 and math.sqrt(length) or math.huge, loss == "squares" and C or product(product(C, outer), C)
end

-- The minimum by another search: Newton's steps from p, each halved until the loss falls; nil: it does not arrive.
function oracle.minimum(model, p, loss)
  local before = oracle.loss(model, p, loss)
  for _ = 1, 60 do
    local step, length = oracle.judge(model, p, loss)
    if length < 1e-7 then return p end
    for k = 0, 20 do
      local d = {}
      for i, x in ipairs(step) do d[i] = x / 2 ^ k end
      local to = model.moved(p, d)
      local now = oracle.loss(model, to, loss)
      if now < before or length < 1e-4 then
        p, before = to, now
        break
      elseif k == 20 then return nil end
    end
  end
  return nil
end

-- The largest difference of two covariances, as a part of the root of the product of the variances.
function oracle.apart(A, B)
  local worst = 0
  for i = 1, #A do
    for k = 1, #A do
      local size = math.sqrt(A[i][i] * A[k][k])
      worst = math.max(worst, A[i][k] == A[i][k] and math.abs(A[i][k] - B[i][k]) / size or math.huge)
    end
  end
  return worst
end

-- ---- attitudes ----

function oracle.product(a, b)
  return { a[1] * b[1] - a[2] * b[2] - a[3] * b[3] - a[4] * b[4], a[1] * b[2] + a[2] * b[1] + a[3] * b[4] - a[4] * b[3],
    a[1] * b[3] - a[2] * b[4] + a[3] * b[1] + a[4] * b[2], a[1] * b[4] + a[2] * b[3] - a[3] * b[2] + a[4] * b[1] }
end

function oracle.turned(q, x, y, z)
  local n = math.sqrt(x * x + y * y + z * z)
  local k = n > 0 and math.sin(n / 2) / n or 0.5
  return oracle.product(q, { math.cos(n / 2), k * x, k * y, k * z })
end

-- The rotation vector from a to b in body axes, the shorter way.
function oracle.between(a, b)
  local e = oracle.product({ a[1], -a[2], -a[3], -a[4] }, b)
  local n = math.sqrt(e[2] * e[2] + e[3] * e[3] + e[4] * e[4])
  local f = (e[1] < 0 and -1 or 1) * (n > 0 and 2 * math.atan(n, math.abs(e[1])) / n or 2)
  return { f * e[2], f * e[3], f * e[4] }
end

-- ---- motions ----

-- States at the times (from 0 on) by RK4 with steps no longer than h.
function oracle.states(rate, x, times, h)
  local list, t, n = {}, 0, #x
  local at = {} -- one table for all stages: there are many
  local function moved(k, f)
    for i = 1, n do at[i] = x[i] + f * k[i] end
    return at
  end
  for row, to in ipairs(times) do
    local count = math.ceil((to - t) / h)
    local d = count > 0 and (to - t) / count or 0
    for _ = 1, count do
      local a = rate(x)
      local b = rate(moved(a, d / 2))
      local c = rate(moved(b, d / 2))
      local e, out = rate(moved(c, d)), {}
      for i = 1, n do out[i] = x[i] + d / 6 * (a[i] + 2 * b[i] + 2 * c[i] + e[i]) end
      x = out
    end
    t, list[row] = to, x
  end
  return list
end

-- Rates of (q, w) for principal moments I and a torque(q, w) in body axes.
function oracle.body(I, torque)
  return function(x)
    local a, b, c, d, p, q, r = table.unpack(x)
    local N = torque and torque(x) or { 0, 0, 0 }
    return { (-b * p - c * q - d * r) / 2, (a * p + c * r - d * q) / 2, (a * q - b * r + d * p) / 2,
      (a * r + b * q - c * p) / 2, ((I[2] - I[3]) * q * r + N[1]) / I[1], ((I[3] - I[1]) * r * p + N[2]) / I[2],
      ((I[1] - I[2]) * p * q + N[3]) / I[3] }
  end
end

return oracle
