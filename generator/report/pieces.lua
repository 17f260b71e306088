-- pieces.lua -- the derivation of a body's mass properties: its pieces, where each was put, and the shifts.
--
-- Huygens and Steiner: every piece has its tensor about its own centroid, turned and stretched with it, and is carried
-- to the common point by  m (d^2 1 - d d^T).  For a body with parameters the steps are those that the emitted code
-- takes.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local ratio = require "generator.algebra.ratio"
local text = require "generator.formula.text"
local vec = require "generator.algebra.vec"
local maps = require "generator.mass.maps"

local pieces = {}

local comp = { "x", "y", "z" }
local most = 12 -- pieces that are spelled out

local function tuple(v)
  local list = {}
  for i, e in ipairs(v) do list[i] = text.of(e, "plain") end
  return "(" .. table.concat(list, ", ") .. ")"
end

-- "moved by (1, 0, 0), turned about (0, 0, 1) by α"
local function placement(p)
  local list = {}
  for i, step in ipairs(p.steps or {}) do
    local words = {}
    for k, w in ipairs(step) do
      words[k] = type(w) == "string" and w or expr.is(w) and text.of(w, "plain") or tuple(w)
    end
    list[i] = table.concat(words, " ")
  end
  return table.concat(list, ", ")
end

local function matter(p)
  if p.density then return ", of density " .. text.of(p.density, "plain") end
  return ""
end

-- "1. solid.box (line 4), moved by (a, 0, 0)"
function pieces.title(i, p)
  local placed = placement(p)
  return string.format("%d. %s%s (line %d)%s%s", i, p.hole and "minus " or "", p.name, p.line, matter(p),
    placed == "" and "" or ", " .. placed)
end

-- Lines of the section: titles, and per piece its mass, centroid c and own tensor.  formula(name, e, unit, number).
function pieces.lines(m, formula)
  local b, lines = m.body, {}
  local function put(name, e, unit) lines[#lines + 1] = formula("  " .. name, e, unit, m:double(e)) end
  local placed = false
  for _, p in ipairs(b.pieces) do placed = placed or #(p.steps or {}) > 0 end
  if #b.pieces == 1 and not placed then return lines end
  for i, p in ipairs(b.pieces) do
    if i > most then
      lines[#lines + 1] = "... and " .. #b.pieces - most .. " more"
      break
    end
    lines[#lines + 1] = pieces.title(i, p)
    put("mass", p.mass, "kg")
    for k = 1, 3 do
      if p.com[k] ~= expr.zero then put("c" .. comp[k], p.com[k], "m") end
    end
    for n, e in ipairs(p.sigma and maps.own(p) or {}) do
      e = p.given and p.given[n] or ratio.tidy(p.mass * e)
      if e ~= expr.zero then put("I" .. vec.entry[n], e, "kg m^2") end
    end
  end
  if #b.pieces > 1 then
    local first, second = table.unpack(m.parts and m.parts.shifts or {})
    local whole = second and second.whole and " + mass (d^2 1 - d d^T)" or ""
    lines[#lines + 1] = first and first.mu and "I = I_1 + I_2 + mu (D^2 1 - D D^T)" .. whole ..
      (whole == "" and ", D from centroid 1 to 2" or ", D = c_2 - c_1, d = com - origin") .. " (Huygens, Steiner)"
      or "I = sum of I_i + m_i (d_i^2 1 - d_i d_i^T), d_i from the common point to centroid i (Huygens, Steiner)"
  end
  for _, s in ipairs(m.parts and m.parts:needed(m.parts.entries) or {}) do
    lines[#lines + 1] = formula(s.name, s.e, s.unit, m:double(s.pure))
  end
  return lines
end

return pieces
