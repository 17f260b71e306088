-- handout.lua -- a scene explained as a lecture prints it: LaTeX, Markdown, HTML or Typst.
--
--     handout.text(facts, format, sections, costs, head) -> text
-- facts: report/facts.lua; sections: a list of `handout.sections` in any order, nil for `handout.usual`; costs: below;
-- head: {title =, author =, date =}, each words or nil, or nil.
-- SPDX-License-Identifier: GPL-3.0-or-later

local mass = require "generator.report.handout.mass"
local motion = require "generator.report.handout.motion"
local page = require "generator.report.handout.page"

local handout = {}

handout.usual = { "tensor", "principal", "euler", "motion", "stability" }
handout.sections = { "tensor", "principal", "euler", "attitude", "motion", "stability", "costs" }
handout.formats = { markdown = true, latex = true, html = true, typst = true }

local writers = { tensor = mass.tensor, principal = mass.principal, euler = motion.euler, motion = motion.motion,
  stability = motion.stability }

-- Lines of at most `widest` letters, broken at blanks.
local widest = 92
local function folded(lines)
  local out = {}
  for _, l in ipairs(lines) do
    while #l > widest do
      local at = widest
      while at > 8 and string.sub(l, at, at) ~= " " do at = at - 1 end
      at = at > 8 and at or widest
      out[#out + 1] = string.sub(l, 1, at)
      l = "      " .. string.sub(l, at + 1)
    end
    out[#out + 1] = l
  end
  return out
end

-- costs: {{title =, lines = {text}}, ...}, printed where the section is asked for.
function handout.text(f, format, sections, costs, head)
  local asked = {}
  head = head or {}
  for _, name in ipairs(sections or handout.usual) do asked[name] = true end
  local document = require("generator.report.handout." .. format)
  local p = page.of(document, f)
  local under = {}
  for _, words in ipairs { head.author or false, head.date or false } do under[#under + 1] = words or nil end
  p:put(document.title(head.title or (string.gsub(f.name, "_", " ")), under))
  mass.given(p, f)
  for _, name in ipairs(handout.usual) do
    if asked[name] then writers[name](p, f, asked) end
  end
  for _, c in ipairs(asked.costs and costs or {}) do
    p:heading(c.title)
    p:put(p.format.listing(folded(c.lines)))
  end
  for i, w in ipairs(f.warnings) do
    if i == 1 then p:heading "Warnings" end
    p:words(w.text)
  end
  return p:done() .. document.tail
end

return handout
