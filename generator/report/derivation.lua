-- derivation.lua -- the scene in words and formulas, for the emitted banner and README.
-- SPDX-License-Identifier: GPL-3.0-or-later

local context = require "generator.dynamics.context"
local expr = require "generator.algebra.expr"
local text = require "generator.formula.text"
local vec = require "generator.algebra.vec"

local derivation = {}

local words = {
  sphere = "spherical top", symmetric = "symmetric top", diagonal = "asymmetric top, principal axes",
  full = "asymmetric top, oblique axes",
}

function derivation.kind(m)
  return not m.has.rates and "point" or m.structure.rod and "rod" or words[m.structure.kind]
end

function derivation.title(job)
  local m = job.model
  local n = #m.record.effects
  return "rigid body \"" .. m.name .. "\": " .. derivation.kind(m) .. ", " ..
    (n == 0 and "torque-free" or n == 1 and "1 effect" or n .. " effects") .. ", " .. job.real
end

-- The entries of a tensor as lines "Ixx = ...", zeros gathered in one line.
local function tensor(I, style, prefix, suffix)
  local lines, zeros = {}, {}
  for n, e in ipairs(I) do
    local name = "I" .. vec.entry[n]
    if e == expr.zero then
      zeros[#zeros + 1] = name
    else
      lines[#lines + 1] = prefix .. name .. " = " .. text.of(e, style) .. suffix
    end
  end
  if #zeros > 0 then lines[#lines + 1] = prefix .. table.concat(zeros, " = ") .. " = 0" .. suffix end
  return lines
end

local most = 60 -- steps that are spelled out

-- The tensor about the origin of rotation as lines; of a composite body in its named parts, which come first.
local function named_tensor(m, style)
  local lines = {}
  if not m.has.rates then return lines end
  local steps = m.parts and m.parts:needed(m.parts.entries) or {}
  for i, s in ipairs(steps) do
    if i > most then
      lines[i] = "    ... and " .. #steps - most .. " more, see " .. m.name .. "_init"
      break
    end
    lines[i] = "    " .. s.name .. " = " .. text.of(s.e, style) .. (s.about ~= s.name and "  (" .. s.about .. ")" or "")
  end
  for _, l in ipairs(tensor(m.parts and m.parts.entries or m.inertia, style, "    ", "")) do lines[#lines + 1] = l end
  return lines
end

local BANNER_WIDTH = 97 -- of emitted lines, less what stands before a line of a comment

-- The lines of effects, those of one line of a helper as one: "4, 3 times".
local function cited(lines)
  local list, count = {}, {}
  for _, l in ipairs(lines) do
    if not count[l] then list[#list + 1] = l end
    count[l] = (count[l] or 0) + 1
  end
  for i, l in ipairs(list) do list[i] = count[l] > 1 and string.format("%s, %d times", l, count[l]) or l end
  return table.concat(list, ", ")
end

-- Lines for the header's banner: what the body is, its tensor, what was chosen.
function derivation.banner(job)
  local m = job.model
  local lines = {}
  if m.has.rates then
    lines[1] = "Tensor of inertia about the origin of rotation, kg m^2 (off-diagonals are tensor entries):"
  end
  -- A long line goes on behind a comma or semicolon of its second half, else at a blank.
  local function put(l)
    while #l > BANNER_WIDTH do
      local cut = BANNER_WIDTH + 1
      while cut > BANNER_WIDTH // 2 and not string.find(l, "^[,;] ", cut - 1) do cut = cut - 1 end
      if cut == BANNER_WIDTH // 2 then
        cut = BANNER_WIDTH + 1
        while cut > 20 and string.sub(l, cut, cut) ~= " " do cut = cut - 1 end
      end
      if string.sub(l, cut, cut) ~= " " then break end -- one word is longer
      lines[#lines + 1] = string.sub(l, 1, cut - 1)
      l = "        " .. string.sub(l, cut + 1)
    end
    lines[#lines + 1] = l
  end
  for _, l in ipairs(named_tensor(m, "plain")) do put(l) end
  local file = string.match(m.file, "[^/]*$")
  local kinds, lines_of, formulas = {}, {}, {}
  for _, e in ipairs(m.record.effects) do
    if not lines_of[e.spec] then kinds[#kinds + 1], lines_of[e.spec] = e.spec, {} end
    if not formulas[e.spec] then formulas[e.spec] = {} end
    local formula, known = context.formula(e), false
    for _, f in ipairs(formulas[e.spec]) do known = known or f == formula end
    if not known then table.insert(formulas[e.spec], formula) end -- of several effects of one kind each that differs
    table.insert(lines_of[e.spec], string.format("%d", e.line))
  end
  for _, spec in ipairs(kinds) do
    put(string.format("Effect %s (%s:%s): %s.", string.gsub(spec.name, "^effect%.", ""), file,
      cited(lines_of[spec]), table.concat(formulas[spec], "; or ")))
  end
  if #m.record.effects == 0 then lines[#lines + 1] = "No effects: torque-free motion about the origin." end
  local names = {}
  for i, s in ipairs(job.steppers) do names[i] = s.method.name end
  lines[#lines + 1] = "Method: " .. table.concat(names, ", ") .. (job.closed.kind and "; closed form: " ..
    job.closed.theorem or "") .. "."
  if m.baked then lines[#lines + 1] = "Parameters are folded into the constants (--bake)." end
  return lines
end

function derivation.markdown(job)
  local m = job.model
  local lines = {}
  if m.has.rates then
    lines = { "Tensor of inertia about the origin of rotation (entries; kg m²):", "" }
    for _, l in ipairs(named_tensor(m, "unicode")) do lines[#lines + 1] = l end
    lines[#lines + 1] = ""
  end
  lines[#lines + 1] = "Structure: " .. derivation.kind(m) .. ".  Equations of motion:"
  lines[#lines + 1] = ""
  for _, g in ipairs(job.equations.groups) do
    lines[#lines + 1] = "    " .. g.why .. (g.where and "   [" .. g.where .. "]" or "")
  end
  lines[#lines + 1] = ""
  if job.closed.kind then
    lines[#lines + 1] = "Closed form: " .. job.closed.theorem .. "."
    for _, l in ipairs(job.closed.text) do lines[#lines + 1] = l end
  else
    lines[#lines + 1] = "No closed form: " .. job.closed.refused .. "."
  end
  return lines
end

return derivation
