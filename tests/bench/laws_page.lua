-- laws_page.lua -- the tables of docs/drift.md, between its marks, and its diagram.
-- SPDX-License-Identifier: GPL-3.0-or-later

local files = require "tests.cli.program"
local fit = require "tests.bench.laws_fit"
local workprecision = require "generator.draw.workprecision"

local page = {}

local power = { [0] = "1", [0.5] = "n^½", [1] = "n", [1.5] = "n^3/2", [2] = "n²" }

local function short(x)
  local s = string.gsub(string.format("%.0e", x), "e([+-])0*", function(sign) return "e" .. (sign == "-" and "-" or
    "") end)
  return (string.gsub(s, "e$", ""))
end

-- "0.52 ± 0.03, 2e-6": the exponent, its standard error, the error at the window's end; bold where it is not the law.
local function cell(r, name)
  local f = r.fits[name]
  if not f then return "–" end
  local text = string.format("%.2f ± %.2f, %s", f.p, f.error, short(f.last))
  return f.agrees and text or "**" .. text .. "**"
end

local function sections(list)
  local order, by = {}, {}
  for _, r in ipairs(list) do
    local key = r.regime == "truncation" and (r.laws.energy[1] == 1 and "creeping" or "geometric " .. r.scene) or
      r.regime
    if not by[key] then
      by[key] = {}
      order[#order + 1] = key
    end
    table.insert(by[key], r)
  end
  return order, by
end

local titles = {
  creeping = "Truncation leads, methods that know no invariant (double)",
  ["geometric free"] = "Geometric methods, free body (double)",
  ["geometric heavy"] = "Geometric methods, heavy top (double)",
  rounding = "Rounding leads", ["closed form"] = "No steps: the closed form",
}

local function tables(list)
  local out = {}
  local order, by = sections(list)
  local right, all = 0, 0
  for _, key in ipairs(order) do
    out[#out + 1] = "### " .. titles[key] .. "\n"
    local head = {}
    for i, name in ipairs(fit.quantities) do
      local law
      for _, r in ipairs(by[key]) do law = law or r.laws[name] end
      head[i] = name .. (law and ": " .. power[law[1]] or "")
    end
    out[#out + 1] = "| method | scene | h | steps | " .. table.concat(head, " | ") .. " |"
    out[#out + 1] = "|---|---|---|---|" .. string.rep("---|", #head)
    for _, r in ipairs(by[key]) do
      local cells = {}
      for i, name in ipairs(fit.quantities) do
        cells[i] = cell(r, name)
        if r.fits[name] then
          all = all + 1
          right = right + (r.fits[name].agrees and 1 or 0)
        end
      end
      out[#out + 1] = string.format("| %s | %s%s | %g | %s | %s |", r.method, r.scene, r.real == "float" and ", float"
        or "",
        r.h, short(r.steps), table.concat(cells, " | "))
    end
    out[#out + 1] = ""
  end
  table.insert(out, 1, string.format("%d exponents, of which %d are those of the law.\n", all, right))
  return table.concat(out, "\n")
end

local function gained(gains)
  local out = { "| method | scene | h | steps | operations | ns | energy | ⟶ | phase | ⟶ |",
    "|---|---|---|---|---|---|---|---|---|---|" }
  for i = 1, #gains, 2 do
    local a, b = gains[i], gains[i + 1]
    local function both(q)
      local x, y = fit.rms(a.points[#a.points].square[q]), fit.rms(b.points[#b.points].square[q])
      return string.format("%s | %s (%.3g×)", short(x), short(y), x / y)
    end
    out[#out + 1] = string.format("| %s | %s, %s | %g | %s | %d ⟶ %d (%+.0f %%) | %.0f ⟶ %.0f | %s | %s |", a.method,
      a.scene,
      a.real, a.h, short(a.steps), a.operations, b.operations, 100 * (b.operations / a.operations - 1), a.time, b.time,
      both(1), both(5))
  end
  return table.concat(out, "\n") .. "\n"
end

local function between(text, name, new)
  local open, close = "<!-- " .. name .. " -->\n", "<!-- end of " .. name .. " -->"
  local a, b = string.find(text, open, 1, true), string.find(text, close, 1, true)
  assert(a and b, "the page must have the marks of " .. name)
  return string.sub(text, 1, a - 1) .. open .. "\n" .. new .. "\n" .. string.sub(text, b)
end

-- One curve for each law.
local drawn = {
  { "rk4", "float", "free", "rounding", "phase", "rk4, float, h = 0.01: phase, n^3/2" },
  { "rk4", "float", "free", "rounding", "energy", "rk4, float: energy, n^1/2" },
  { "rk4, compensated", "float", "free", "rounding", "energy", "compensated, h = 0.001: energy" },
  { "rk4", "double", "free", "truncation", "energy", "rk4, h = 0.05: energy, n" },
  { "rk4", "double", "free", "truncation", "phase", "rk4, h = 0.05: phase, n^2" },
  { "split4", "double", "heavy", "truncation", "energy", "split4, heavy top: energy, bounded" },
  { "split4", "double", "heavy", "truncation", "phase", "split4, heavy top: phase, n" },
  { "rk4", "double", "free", "rounding", "energy", "rk4, double, h = 0.0001: energy, n^1/2" },
}

local function picture(list)
  local curves = {}
  for _, d in ipairs(drawn) do
    for _, r in ipairs(list) do
      if r.method == d[1] and r.real == d[2] and r.scene == d[3] and r.regime == d[4] and r.fits[d[5]] then
        curves[#curves + 1] = { label = d[6], kind = "own", points = r.fits[d[5]].points }
      end
    end
  end
  return workprecision.text { title = "How errors grow with the number of steps",
    about = "Errors of energy and phase over the number of steps, both logarithmic, for eight steppers.",
    note = "root mean square over 32 states; energy in units of T, phase in rad", xlabel = "steps", ylabel = "error",
    curves = curves }
end

function page.write(list, gains, path, svg_path)
  local laws, gain = tables(list), gained(gains)
  io.stdout:write(laws, "\n", gain)
  if not path then return end
  local text = between(files.read(path), "laws", laws)
  files.write(path, between(text, "gains", gain))
  files.write(svg_path, picture(list))
end

return page
