-- pair.lua -- two runs in one picture: their curves over time in one frame, the second dashed; figures side by side.
--
--     pair.of(first, second, names) -> the panels of one picture of both; first, second: the panels of each (panels.of)
-- Two panels over time are one frame if they have the same title: then they show the same quantities.
-- SPDX-License-Identifier: GPL-3.0-or-later

local pair = {}

local function noted(p, name)
  p.note = name .. (p.note and "; " .. p.note or "")
  return p
end

local function joined(a, b, names)
  for _, c in ipairs(b.curves) do
    local dashed = c.class .. " dashed"
    a.curves[#a.curves + 1] = { name = "", values = c.values, class = dashed, breaks = c.breaks, xs = c.xs }
  end
  a.shown, a.finish = math.min(a.shown, b.shown), math.max(a.finish, b.finish)
  a.whole = a.whole and b.whole
  a.mark, a.note = a.mark or b.mark, a.note == b.note and a.note or nil
  a.legend = { { "cn", names[1] }, { "cn dashed", names[2] } }
  return a
end

function pair.of(first, second, names)
  local out, by_title = {}, {}
  for _, p in ipairs(second) do by_title[p.title] = p end
  for _, p in ipairs(first) do
    local other = by_title[p.title]
    by_title[p.title] = nil
    if other and p.over and other.over then
      out[#out + 1] = joined(p, other, names)
    else
      out[#out + 1] = noted(p, names[1])
      if other then out[#out + 1] = noted(other, names[2]) end
    end
  end
  for _, p in ipairs(second) do
    if by_title[p.title] then out[#out + 1] = noted(p, names[2]) end
  end
  return out
end

return pair
