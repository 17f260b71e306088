-- curve.lua -- curves on paper: as few points as the eye needs, and their path data.
-- SPDX-License-Identifier: GPL-3.0-or-later

local curve = {}

local tolerance = 0.12 -- pixels

-- The points of a polyline that keep it within the tolerance: Douglas and Peucker 1973, with a stack of its own.
function curve.simplified(points, within)
  local n = #points
  if n < 3 then return points end
  local keep, stack, limit = { [1] = true, [n] = true }, { { 1, n } }, (within or tolerance) ^ 2
  while #stack > 0 do
    local part = table.remove(stack)
    local a, b = points[part[1]], points[part[2]]
    local ux, uy = b[1] - a[1], b[2] - a[2]
    local length, worst, at = ux * ux + uy * uy, limit, nil
    for i = part[1] + 1, part[2] - 1 do
      local vx, vy = points[i][1] - a[1], points[i][2] - a[2]
      local s = length > 0 and math.max(0, math.min(1, (vx * ux + vy * uy) / length)) or 0
      local dx, dy = vx - s * ux, vy - s * uy
      local d = dx * dx + dy * dy
      if d > worst then worst, at = d, i end
    end
    if at then
      keep[at] = true
      stack[#stack + 1], stack[#stack + 2] = { part[1], at }, { at, part[2] }
    end
  end
  local out = {}
  for i = 1, n do
    if keep[i] then out[#out + 1] = points[i] end
  end
  return out
end

-- The pieces of a polyline inside the rectangle x0, y0, x1, y1: Liang and Barsky 1984, for each of its lines.
function curve.clipped(points, x0, y0, x1, y1)
  local pieces, here = {}, nil
  for i = 2, #points do
    local a, b = points[i - 1], points[i]
    local dx, dy, from, to = b[1] - a[1], b[2] - a[2], 0.0, 1.0
    for _, edge in ipairs { { -dx, a[1] - x0 }, { dx, x1 - a[1] }, { -dy, a[2] - y0 }, { dy, y1 - a[2] } } do
      local p, q = edge[1], edge[2]
      if p == 0 then
        if q < 0 then to = -1 end
      elseif p < 0 then from = math.max(from, q / p) else to = math.min(to, q / p) end
    end
    if from > to then here = nil else
      local function at(s) return { a[1] + s * dx, a[2] + s * dy } end
      if not here or from > 0 then
        here = { at(from) }
        pieces[#pieces + 1] = here
      end
      here[#here + 1] = to < 1 and at(to) or b
      if to < 1 then here = nil end
    end
  end
  return pieces
end

-- Tenths of a pixel as text: "-.4".
local function tenths(n)
  local s = string.format("%s%d.%d", n < 0 and "-" or "", math.abs(n) // 10, math.abs(n) % 10)
  return (string.gsub(string.gsub(s, "%.0$", ""), "^(%-?)0%.", "%1."))
end

-- Path data through the points: steps from one to the next in tenths of a pixel, so that errors do not add up.
function curve.path(points, closed)
  local out, x, y = {}, nil, nil
  for _, p in ipairs(curve.simplified(points)) do
    local px, py = math.floor(p[1] * 10 + 0.5), math.floor(p[2] * 10 + 0.5)
    if px ~= x or py ~= y then
      local dx, dy = tenths(px - (x or 0)), tenths(py - (y or 0))
      local sign = string.sub(dx, 1, 1) == "-"
      out[#out + 1] = (#out == 0 and "M" or #out == 1 and "l" or sign and "" or " ") .. dx ..
        (string.sub(dy, 1, 1) == "-" and "" or " ") .. dy
      x, y = px, py
    end
  end
  if #out == 1 then out[2] = "l0 0" end -- a dot
  return table.concat(out) .. (closed and "z" or "")
end

-- Angles that run on instead of jumping by a turn.
function curve.unwrapped(list, turn)
  local out, last, shift = {}, nil, 0
  for i, a in ipairs(list) do
    if last then
      while a + shift - last > turn / 2 do shift = shift - turn end
      while a + shift - last < -turn / 2 do shift = shift + turn end
    end
    last = a + shift
    out[i] = last
  end
  return out
end

return curve
