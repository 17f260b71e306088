-- mesh.lua -- polhode mesh: mass properties of a mesh file, and what is wrong with it.
--
-- Counts and the box are in the file's unit, everything with a mass in SI.  Without --mass and --density the density
-- is 1 (kg per m^3, m^2 or m).  Exit status 1 when the file is malformed or no body can be made of it.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local evaluate = require "generator.algebra.evaluate"
local options = require "generator.commands.options"
local defects = require "generator.dsl.defects"
local units = require "generator.dsl.units"
local json = require "generator.report.json"

local mesh = {}

mesh.forms = { { "FILE", "mass properties of a mesh, and its defects",
  "FILE is STL, OBJ or PLY, by the end of its name." } }
mesh.operands = { 1, 1, "FILE" }
mesh.options = {
  { "--kind", { "volume", "surface", "wires" }, "what has mass: the inside, the faces, or the edges",
    default = "volume" },
  { "--units", "text", "the unit of the coordinates in the file, such as mm or in", value = "UNIT", default = "m" },
  { "--mass", "text", "of the whole: a number in kg, or with a unit", value = "\"2 kg\"", default = "by the density" },
  { "--density", "text", "of a volume, surface or length: in SI, or with a unit", value = "\"2.7 g/cm^3\"",
    default = "1 kg/m^3, kg/m^2 or kg/m" },
  { "--weld", "text", "vertices nearer than this part of the longest side are one, such as 1e-6", value = "W",
    default = "0: equal ones" },
  { "--format", { "text", "json" }, "how the result is written", default = "text" },
}
mesh.examples = {
  { "polhode mesh part.stl --units mm --density \"2.7 g/cm^3\"", "a part of aluminium" },
  { "polhode mesh part.stl --kind surface --mass \"250 g\"", "the same faces as a shell of known mass" },
}

local measures = {
  volume = { name = "volume", power = 3, density = units.density_volume },
  surface = { name = "area", power = 2, density = units.density_area },
  wires = { name = "length", power = 1, density = units.density_length },
}

-- A unit's exact factor to SI as a rational, or nil and a phrase.
local function factor(text, dimension)
  local e, d = units.parse(text)
  if not e then return nil, d end
  if not units.equal(d, dimension) then
    return nil, "must be in " .. units.si(dimension) .. " or a unit of its kind, got " .. string.format("%q", text)
  end
  return evaluate.precise(e, {}, 200)
end

-- "2.7 g/cm^3" or a number in SI, as the nearest double; nil and a phrase.
local function amount(text, dimension)
  local digits, unit = string.match(text, "^%s*(%S+)%s*(.-)%s*$")
  local n = digits and R.parse(digits)
  if not n then return nil, "must be a number, with or without a unit, got " .. string.format("%q", text) end
  if R.sign(n) <= 0 then return nil, "must be positive, got " .. text end
  if unit == "" then return R.todouble(n) end
  local f, why = factor(unit, dimension)
  if not f then return nil, why end
  return R.todouble(n * f)
end

-- {unit=, mass= or density=} for the host, or nil and what is wrong.
local function read(given, what)
  if given.mass and given.density then return nil, "--mass and --density exclude each other" end
  local unit, why = factor(given.units or "m", units.length)
  if not unit then return nil, "--units: " .. why end
  local out = { unit = R.todouble(unit) }
  if given.weld then
    local w = R.parse(given.weld)
    out.weld = w and R.todouble(w)
    if not w or out.weld < 0 or out.weld > 0.01 then
      return nil, "--weld must be a number from 0 to 0.01, a part of the longest side, got " .. given.weld
    end
  end
  if given.mass then
    out.mass, why = amount(given.mass, units.mass)
    if not out.mass then return nil, "--mass " .. why end
  else
    out.density, why = amount(given.density or "1", what.density)
    if not out.density then return nil, "--density " .. why end
  end
  return out
end

---- words ----

local count = defects.count

local function defects_of(m) return defects.phrases(m) end

local function verdict(m)
  local welded = m.merged > 0 and ", welded" or ""
  if m.triangles == 0 then return "lines only" end
  if m.defects.unbalanced > 0 then return "open: the faces do not enclose a volume" end
  if m.defects.inverted then return "closed, but inside out" .. welded end
  local clean = #defects_of(m) == (m.merged > 0 and 1 or 0)
  return (clean and "closed, no defects" or "closed, with defects") .. welded
end

-- The text is for reading: 12 digits.  JSON has all of them.
local function show(x) return string.format("%.12g", x + 0.0) end -- no -0

local function numbers(list)
  local out = {}
  for i, x in ipairs(list) do out[i] = show(x) end
  return table.concat(out, "  ")
end

local function text(file, m, what, unit)
  local b, out = m.body, {}
  local function row(name, value) out[#out + 1] = name .. string.rep(" ", 20 - #name) .. value end
  row("file", file)
  row("faces", count(m.faces, "face", "faces") .. ", " .. count(m.triangles, "triangle", "triangles") .. ", " ..
    count(m.vertices, "vertex", "vertices") .. ", " .. count(m.edges, "edge", "edges") ..
    (m.segments > 0 and ", " .. count(m.segments, "line segment", "line segments") or ""))
  row("verdict", verdict(m))
  for _, d in ipairs(defects_of(m)) do row("  defect", d) end
  row("box", "from " .. numbers(m.box.lo) .. " to " .. numbers(m.box.hi) .. " " .. unit)
  row(what.name, show(m.measure) .. " " .. unit .. (what.power > 1 and "^" .. what.power or ""))
  row("mass", show(b.mass) .. " kg")
  row("centre of mass", numbers(b.com) .. " m")
  row("tensor about it", "xx yy zz  " .. numbers { b.tensor[1], b.tensor[2], b.tensor[3] } .. " kg m^2")
  row("", "xy xz yz  " .. numbers { b.tensor[4], b.tensor[5], b.tensor[6] } .. " kg m^2")
  for k = 1, 3 do
    row(k == 1 and "principal moments" or "",
      show(b.moments[k]) .. " kg m^2 about " .. numbers(b.axes[k]))
  end
  return table.concat(out, "\n") .. "\n"
end

local function tojson(file, m, kind, how)
  local b, d = m.body, {}
  for i, p in ipairs(defects.list) do d[i] = { p[1], m.defects[p[1]] } end
  d[#d + 1] = { "unbalanced", m.defects.unbalanced }
  d[#d + 1] = { "inverted", m.defects.inverted }
  for _, key in ipairs { "bent", "bend", "unseen" } do d[#d + 1] = { key, m.defects[key] } end
  local faults = {}
  for i, f in ipairs(m.defects.faults) do
    faults[i] = json.object { { "kind", f.kind }, { "part", f.part }, { "other", f.other },
      { "triangles", f.triangles }, { "at", f.at }, { "share", f.share } }
  end
  d[#d + 1] = { "faults", faults }
  return json.text(json.object {
    { "file", file }, { "kind", kind }, { "unit", how.unit },
    { "faces", m.faces }, { "triangles", m.triangles }, { "vertices", m.vertices }, { "edges", m.edges },
    { "segments", m.segments }, { "parts", m.parts }, { "merged", m.merged },
    { "verdict", verdict(m) }, { "defects", json.object(d) },
    { "box", { m.box.lo, m.box.hi } }, { "measure", m.measure },
    { "mass", b.mass }, { "com", b.com }, { "com_tail", b.com_tail }, { "tensor", b.tensor },
    { "moments", b.moments }, { "axes", b.axes },
  })
end

function mesh.run(host, given)
  local kind, file = given.kind or "volume", given[1]
  local what = measures[kind]
  local how, wrong = read(given, what)
  if file == "-" then
    wrong = "the format of a mesh is told by the end of its file's name, so it cannot come from standard input"
  end
  if wrong then return options.wrong(host, "mesh", wrong) end
  local m, why, failed = host.mesh(file, kind, how)
  if not m then
    host.err((failed.reason == "file" and "polhode: cannot read " or "") .. why .. "\n")
    if failed.reason == "mesh" then
      for _, d in ipairs(defects_of(failed)) do host.err("    " .. d .. "\n") end
      local offer = defects.offer(failed, function(w) return "--weld " .. w end)
      if offer then host.err("    " .. offer .. "\n") end
      if kind == "volume" and failed.defects.unbalanced > 0 then
        host.err("    --kind surface takes the faces as a shell\n")
      end
    end
    return failed.reason == "file" and 2 or 1
  end
  host.out(given.format == "json" and tojson(file, m, kind, how) or text(file, m, what, given.units or "m"))
  return 0
end

return mesh
