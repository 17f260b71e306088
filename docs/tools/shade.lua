-- shade.lua -- faces as areas of few tones, joined to outlines, and edges joined to lines.
--
-- Brightness belongs to the corners and is linear between them; a face is cut where it passes from one tone to the
-- next, and what has the same tone is joined by cancelling common sides.
-- So a ball is some bands, not a thousand tiles.
-- SPDX-License-Identifier: GPL-3.0-or-later

local shade = { tones = 8 }

local light = { -0.42, 0.62, 0.66 } -- from the left, above, and the viewer

-- 0 dark .. tones light; half way round is not yet black (half Lambert)
local function brightness(n)
  local t = (n[1] * light[1] + n[2] * light[2] + n[3] * light[3] + 1) / 2
  return math.max(0, math.min(shade.tones - 1e-6, (t - 0.2) / 0.8 * shade.tones))
end

local function round(x) return math.floor(x * 10 + 0.5) / 10 end

-- Part of the polygon {{x, y, b}, ...} with side*b >= side*level.
local function clip(p, level, side)
  local out = {}
  for i, v in ipairs(p) do
    local w = p[i % #p + 1]
    local dv, dw = side * (v[3] - level), side * (w[3] - level)
    if dv >= 0 then out[#out + 1] = v end
    if dv * dw < 0 then
      local a, b = v, w
      if a[1] > b[1] or a[1] == b[1] and a[2] > b[2] then a, b = b, a end -- the same from both sides
      local t = (level - a[3]) / (b[3] - a[3])
      out[#out + 1] = { a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]), level }
    end
  end
  return out
end

-- Directed sides; one that comes back cancels.
local function add_sides(sides, p)
  local q = {}
  for i, v in ipairs(p) do q[i] = { round(v[1]), round(v[2]) } end
  for i, a in ipairs(q) do
    local b = q[i % #q + 1]
    if a[1] ~= b[1] or a[2] ~= b[2] then
      local ka, kb = a[1] .. "," .. a[2], b[1] .. "," .. b[2]
      local back = sides[kb .. "|" .. ka]
      if back and back.count > 0 then
        back.count = back.count - 1
      else
        local own = sides[ka .. "|" .. kb]
        if not own then
          own = { a, b, ka, kb, count = 0 }
          sides[ka .. "|" .. kb] = own
          sides[#sides + 1] = own
        end
        own.count = own.count + 1
      end
    end
  end
end

-- Is b on the way from a to c, but for a tenth of a pixel?
local function straight(a, b, c)
  local w = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])
  local l = math.sqrt((c[1] - a[1]) ^ 2 + (c[2] - a[2]) ^ 2)
  local on = (b[1] - a[1]) * (c[1] - b[1]) + (b[2] - a[2]) * (c[2] - b[2]) > 0
  return on and math.abs(w) <= 0.12 * l
end

local function simplified(p, closed)
  local out = {}
  for i, v in ipairs(p) do
    local last = #out > 0 and out[#out] or closed and p[#p]
    local after = p[i + 1] or closed and p[1]
    if not (last and after and straight(last, v, after)) then out[#out + 1] = v end
  end
  return out
end

local function loops(sides)
  local from = {}
  for _, s in ipairs(sides) do
    if s.count > 0 then
      from[s[3]] = from[s[3]] or {}
      table.insert(from[s[3]], s)
    end
  end
  local list = {}
  for _, s in ipairs(sides) do
    while s.count > 0 do
      local loop, at = {}, s
      while at do
        at.count = at.count - 1
        loop[#loop + 1] = at[1]
        local onward
        for _, t in ipairs(from[at[4]] or {}) do
          if t.count > 0 then onward = t break end
        end
        at = onward
      end
      loop = simplified(loop, true)
      if #loop > 2 then list[#list + 1] = loop end
    end
  end
  return list
end

-- The areas of the faces of one layer: {{class = "s3", loops = {points, ...}}, ...}, dark to light.
function shade.areas(faces)
  local by = {}
  for _, f in ipairs(faces) do
    local p, lo, hi = {}, math.huge, -math.huge
    for k, v in ipairs(f.seen) do
      p[k] = { v[1], v[2], brightness(f.corner[k]) }
      lo, hi = math.min(lo, p[k][3]), math.max(hi, p[k][3])
    end
    if hi - lo < 1e-3 then lo, hi = (lo + hi) / 2, (lo + hi) / 2 end
    for tone = math.floor(lo), math.floor(hi) do
      local part = p
      if lo < tone then part = clip(part, tone, 1) end
      if hi > tone + 1 then part = clip(part, tone + 1, -1) end
      if #part > 2 then
        local class = (f.cut and "c" or f.inside and "i" or "s") .. tone
        by[class] = by[class] or {}
        add_sides(by[class], part)
      end
    end
  end
  local list = {}
  for _, kind in ipairs { "i", "s", "c" } do
    for tone = 0, shade.tones - 1 do
      local class = kind .. tone
      if by[class] then list[#list + 1] = { class = class, loops = loops(by[class]) } end
    end
  end
  return list
end

-- Segments {p, q} joined to polylines.
function shade.lines(segments)
  local at, list = {}, {}
  local function name(p) return round(p[1]) .. "," .. round(p[2]) end
  for _, s in ipairs(segments) do
    s.ends = { name(s[1]), name(s[2]) }
    for i = 1, 2 do
      at[s.ends[i]] = at[s.ends[i]] or {}
      table.insert(at[s.ends[i]], s)
    end
  end
  local function follow(line, s, e) -- on from the end e of s
    while true do
      local onward
      for _, t in ipairs(#at[s.ends[e]] == 2 and at[s.ends[e]] or {}) do
        if not t.done then onward = t end
      end
      if not onward then return end
      local enter = onward.ends[1] == s.ends[e] and 1 or 2
      onward.done = true
      s, e = onward, 3 - enter
      line[#line + 1] = s[e]
    end
  end
  for _, s in ipairs(segments) do
    if not s.done then
      s.done = true
      local back, line = {}, {}
      follow(back, s, 1)
      for i = #back, 1, -1 do line[#line + 1] = back[i] end
      line[#line + 1], line[#line + 2] = s[1], s[2]
      follow(line, s, 2)
      local points = {}
      for i, p in ipairs(line) do points[i] = { round(p[1]), round(p[2]) } end
      list[#list + 1] = simplified(points, false)
    end
  end
  return list
end

-- Colours: {class, light, dark} for svg.new.
function shade.palette()
  local list = {}
  local function mix(a, b, t)
    local s = "#"
    for i = 1, 3 do s = s .. string.format("%02x", math.floor(a[i] + (b[i] - a[i]) * t + 0.5)) end
    return "fill:" .. s .. ";stroke:" .. s
  end
  local ends = { -- light page: dark and light end; dark page: the same
    s = { { 88, 122, 163 }, { 228, 238, 248 }, { 28, 50, 78 }, { 118, 157, 201 } },
    i = { { 158, 128, 98 }, { 250, 238, 220 }, { 60, 44, 30 }, { 168, 136, 102 } },
    c = { { 196, 112, 66 }, { 246, 190, 150 }, { 120, 62, 30 }, { 226, 150, 104 } },
  }
  for _, kind in ipairs { "i", "s", "c" } do
    local e = ends[kind]
    for tone = 0, shade.tones - 1 do
      local t = tone / (shade.tones - 1)
      list[#list + 1] = { kind .. tone, mix(e[1], e[2], t), mix(e[3], e[4], t) }
    end
  end
  return list
end

return shade
