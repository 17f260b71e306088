-- laws_fit.lua -- exponents of growth: least squares of log(error) over log(n), with the ensemble's standard error.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The error at n is the root of the mean square over the ensemble.  The members are independent, the points of one
-- member's walk are not, so the standard error is not that of the line: it is the jackknife's over the groups of
-- members (Efron 1982): the fit without each group in turn, sqrt((G - 1)/G sum (p_g - mean)^2).

local fit = {}

fit.quantities = { "energy", "momentum", "direction", "norm", "phase" }

local function rms(squares, without)
  local sum, n = 0, 0
  for g, x in ipairs(squares) do
    if g ~= without then sum, n = sum + x, n + 1 end
  end
  return math.sqrt(sum / n)
end
fit.rms = rms

-- Slope of y over x, both lists.
local function slope(x, y)
  local n, mx, my, sxx, sxy = #x, 0, 0, 0, 0
  for i = 1, n do mx, my = mx + x[i] / n, my + y[i] / n end
  for i = 1, n do sxx, sxy = sxx + (x[i] - mx) ^ 2, sxy + (x[i] - mx) * (y[i] - my) end
  return sxy / sxx
end

-- The fit of quantity q over the points that lie in window = {least n, largest n}, below 0.1, above 0: {p, error,
-- last = the error at the last of them, points = {{n, error}}, bias = |mean|/(its standard error) at the last}; nil
-- if fewer than four.
function fit.one(points, q, window, members)
  local x, kept = {}, {}
  for _, point in ipairs(points) do
    local e = rms(point.square[q])
    if point.n >= window[1] and point.n <= window[2] and e < 0.1 and e > 0 then
      kept[#kept + 1] = point
      x[#x + 1] = math.log(point.n)
    end
  end
  if #kept < 4 then return nil end
  local groups = #kept[1].square[q]
  local function fitted(without)
    local y = {}
    for i, point in ipairs(kept) do y[i] = math.log(math.max(rms(point.square[q], without), 1e-300)) end
    return slope(x, y)
  end
  local p, mean, sum = fitted(), 0, 0
  local each = {}
  for g = 1, groups do
    each[g] = fitted(g)
    mean = mean + each[g] / groups
  end
  for g = 1, groups do sum = sum + (each[g] - mean) ^ 2 end
  local out = { p = p, error = math.sqrt((groups - 1) / groups * sum), points = {} }
  for i, point in ipairs(kept) do out.points[i] = { point.n, rms(point.square[q]) } end
  local last = kept[#kept]
  out.last = rms(last.square[q])
  out.bias = math.abs(last.mean[q]) / (out.last / math.sqrt(members))
  return out
end

-- Fits every quantity of a run that has a law: r.fits[quantity].
function fit.run(r, points)
  r.fits, r.time = {}, points.time
  for q, name in ipairs(fit.quantities) do
    local law = r.laws[name]
    if law then
      local f = fit.one(points, q, { law.from or 100, law.to or math.huge }, r.members)
      if f then
        f.law, f.why = law[1], law.why
        f.agrees = fit.agrees(f)
        r.fits[name] = f
      end
    end
  end
end

-- Within three standard errors, and 0.1 more: the windows end where the next law takes over.
function fit.agrees(f) return math.abs(f.p - f.law) <= 3 * f.error + 0.1 end

return fit
