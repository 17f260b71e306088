-- jacobi.lua -- principal moments and axes of a tensor of doubles, for reports.
--
-- Cyclic Jacobi (Golub, Van Loan, Matrix Computations, 8.5), moments ascending, axes right-handed, the largest
-- component of the first two positive.  The emitted code has its own (templates/analysis.c), the library another.
-- BELOW the line: IEEE doubles.
-- SPDX-License-Identifier: GPL-3.0-or-later

local jacobi = {}

local epsilon = 2.0 ^ -52

-- I: {xx, yy, zz, xy, xz, yz}.  Returns {m1, m2, m3} and {axis1, axis2, axis3}.
function jacobi.run(I)
  local a = { { I[1], I[4], I[5] }, { I[4], I[2], I[6] }, { I[5], I[6], I[3] } }
  local v = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } }
  for _ = 1, 12 do
    local busy = false
    for i = 1, 2 do
      for j = i + 1, 3 do
        local limit = epsilon * (math.sqrt(math.abs(a[i][i])) * math.sqrt(math.abs(a[j][j])))
        if math.abs(a[i][j]) > limit then
          busy = true
          local theta = 0.5 * (a[j][j] - a[i][i]) / a[i][j]
          local t = 1 / (math.abs(theta) + math.sqrt(1 + theta * theta))
          if theta < 0 then t = -t end
          local c = 1 / math.sqrt(1 + t * t)
          local s, k = t * c, 6 - i - j
          a[i][i], a[j][j] = a[i][i] - t * a[i][j], a[j][j] + t * a[i][j]
          a[i][j], a[j][i] = 0.0, 0.0
          local p, q = a[k][i], a[k][j]
          a[k][i], a[k][j] = c * p - s * q, s * p + c * q
          a[i][k], a[j][k] = a[k][i], a[k][j]
          for r = 1, 3 do
            p, q = v[r][i], v[r][j]
            v[r][i], v[r][j] = c * p - s * q, s * p + c * q
          end
        else
          a[i][j], a[j][i] = 0.0, 0.0
        end
      end
    end
    if not busy then break end
  end
  local order = { 1, 2, 3 }
  for i = 2, 3 do
    for j = i, 2, -1 do
      if a[order[j]][order[j]] < a[order[j - 1]][order[j - 1]] then order[j], order[j - 1] = order[j - 1], order[j] end
    end
  end
  local moments, axes = {}, {}
  for n, i in ipairs(order) do
    moments[n] = a[i][i]
    local largest = 1
    for r = 2, 3 do
      if math.abs(v[r][i]) > math.abs(v[largest][i]) then largest = r end
    end
    local sign = v[largest][i] < 0 and -1.0 or 1.0
    axes[n] = { sign * v[1][i], sign * v[2][i], sign * v[3][i] }
    for r = 1, 3 do axes[n][r] = axes[n][r] + 0.0 end -- no negative zero
  end
  local x, y = axes[1], axes[2]
  axes[3] = { x[2] * y[3] - x[3] * y[2], x[3] * y[1] - x[1] * y[3], x[1] * y[2] - x[2] * y[1] }
  return moments, axes
end

return jacobi
