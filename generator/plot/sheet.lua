-- sheet.lua -- panels side by side as one SVG.
--
--     sheet.text({title =, note =, about =}, { {title =, note =, draw = function(d, box)}, ... })
-- A colour never is the only sign: curves have their names at the end, or their marks differ.  Colours are told apart
-- by the colour-blind (Machado 2009, the three kinds: distances in OKLab of 0.10 and more).
-- SPDX-License-Identifier: GPL-3.0-or-later

local svg = require "generator.draw.svg"

local sheet = {}

local wide, high, margin = 430, 330, 16 -- of a panel; around all of them
local above, head = 46, 52 -- the panel's title and note; the sheet's

local styles = {
  { "line", "fill:none;stroke:#222;stroke-width:1.4;stroke-linejoin:round;stroke-linecap:round", "stroke:#f5f5f5" },
  { "cx", "stroke:#005a8e", "stroke:#56b4e9" },
  { "cy", "stroke:#d55e00", "stroke:#e69f00" },
  { "cz", "stroke:#009e73", "stroke:#009e73" },
  { "ce", "stroke:#882255", "stroke:#cc79a7" },
  { "cn", "stroke:#222", "stroke:#f5f5f5" },
  { "skin", "fill:#eef2f6;stroke:#8a94a0;stroke-width:1", "fill:#20262e;stroke:#77808c" },
  { "level", "fill:none;stroke:#8a98a8;stroke-width:.9", "stroke:#6c7887" },
  { "separatrix", "fill:none;stroke:#882255;stroke-width:1.3;stroke-dasharray:5 3", "stroke:#cc79a7" },
  { "trace", "fill:none;stroke:#005a8e;stroke-width:2;stroke-linejoin:round;stroke-linecap:round", "stroke:#56b4e9" },
  { "ring", "fill:none;stroke:#d55e00;stroke-width:1.1;stroke-dasharray:5 3", "stroke:#e69f00" },
  { "area", "stroke:none;fill-opacity:.16", },
  { "area.cx", "fill:#005a8e", "fill:#56b4e9" },
  { "area.cy", "fill:#d55e00", "fill:#e69f00" },
  { "start", "fill:#d55e00;stroke:#fff;stroke-width:.8", "fill:#e69f00;stroke:#15181d" },
  { "end", "font:italic 13px serif;fill:#222", "fill:#e6e9ee" },
  { "head", "font:bold 13px sans-serif;fill:#222", "fill:#e6e9ee" },
  { "far", "stroke-width:.6;opacity:.65" },
}

function sheet.text(o, panels)
  local columns = math.min(#panels, 2)
  local rows = (#panels + columns - 1) // columns
  local width = math.max(2 * margin + columns * wide, 460)
  local height = head + rows * high + margin
  local d = svg.new(width, height, { title = o.title, about = o.about, palette = styles })
  d:text(margin + 4, 24, o.title, "title")
  if o.note then d:math(margin + 4, 42, o.note, "small") end
  for i, p in ipairs(panels) do
    local x, y = margin + (i - 1) % columns * wide, head + (i - 1) // columns * high
    d:text(x + 4, y + 18, p.title, "head")
    if p.note then d:math(x + 4, y + 34, p.note, "small") end
    p.draw(d, { x0 = x, y0 = y + above, x1 = x + wide - 6, y1 = y + high - 4 })
  end
  d.used["area.cx"], d.used["area.cy"] = d.used.area, d.used.area
  return svg.text(d)
end

return sheet
