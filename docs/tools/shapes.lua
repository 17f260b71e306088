-- shapes.lua -- docs/shapes.md and its pictures: every shape of the catalogue with formulas, from the catalogue itself.
--
-- Arguments that are numbers stay symbols; lists of points take the values of the example (examples.lua here), and
-- arguments that choose are shown in every choice.  The same catalogue gives the same bytes.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local coordinate = require "generator.algebra.coordinate"
local cosine = require "generator.algebra.cosine"
local evaluate = require "generator.algebra.evaluate"
local expr = require "generator.algebra.expr"
local text = require "generator.formula.text"
local vec = require "generator.algebra.vec"
local body = require "generator.mass.body"
local surface = require "generator.geometry.surface"
local opened = require "docs.tools.opened"
local examples = require "docs.tools.examples"
local picture = require "docs.tools.picture"

local shapes = {}

-- ---- values of the example as expressions and as text ----

local function exact(x) return expr.lift(R.parse(tostring(x))) end

local function lifted(x)
  if type(x) == "number" then return exact(x) end
  local list = {}
  for i, v in ipairs(x) do list[i] = lifted(v) end
  return list
end

local function literal(x)
  if type(x) ~= "table" then return tostring(x) end
  local list = {}
  for i, v in ipairs(x) do list[i] = literal(v) end
  return "{" .. table.concat(list, ", ") .. "}"
end

local function show(e) return text.of(cosine(e), "unicode") end

local function names_of(spec)
  if spec.takes then return spec.takes end
  local list = {}
  for i, a in ipairs(spec.args or {}) do list[i] = a.name end
  return "{" .. table.concat(list, ", ") .. "}"
end

-- ---- mass properties ----

local function polynomial(terms)
  local p = {}
  for _, t in ipairs(terms) do
    p = coordinate.add(p, coordinate.scale(exact(t[1]), coordinate.monomial(t[2], t[3], t[4])))
  end
  return p
end

-- Every way to choose: a list of {words, {name = value}}.
local function choices(spec)
  local list = { { {}, {} } }
  for _, a in ipairs(spec.args or {}) do
    local values = a.choice or a.flag and { false, true }
    if values then
      local more = {}
      for _, c in ipairs(list) do
        for _, v in ipairs(values) do
          local words, chosen = { table.unpack(c[1]) }, {}
          for k, u in pairs(c[2]) do chosen[k] = u end -- order does not matter: a table is copied
          words[#words + 1], chosen[a.name] = a.name .. " = " .. tostring(v), v
          more[#more + 1] = { words, chosen }
        end
      end
      list = more
    end
  end
  return list
end

-- Has the shape formulas of its own?  (A mesh has the numbers of its file.)
local function described(spec) return spec.build and (spec.args or spec.name == "region") end

-- Arguments as build() takes them: symbols for single numbers, the example's values for lists.
function shapes.arguments(spec, example, chosen)
  if spec.name == "region" then
    local limits = {}
    for i, l in ipairs(example.args.limits) do limits[i] = { polynomial(l[1]), polynomial(l[2]) } end
    return { order = example.args.order, limits = limits, density = polynomial(example.density) }
  end
  local a = {}
  for _, s in ipairs(spec.args) do
    local given = example.args[s.name]
    if chosen[s.name] ~= nil then
      a[s.name] = chosen[s.name]
    elseif s.rows or s.lists or s.size then
      a[s.name] = lifted(given or s.default)
    else
      a[s.name] = expr.sym(s.name, 5, s.sign == "positive")
    end
  end
  return a
end

local entries = { "xx", "yy", "zz", "xy", "xz", "yz" }

-- "xx, yy" -> text: equal entries once, products that vanish not at all.
local function tensor_rows(I)
  local rows, of = {}, {}
  for n, e in ipairs(I) do
    if n <= 3 or e ~= expr.zero then
      if of[e] then
        of[e][1] = of[e][1] .. ", " .. entries[n]
      else
        of[e] = { entries[n], show(e) }
        rows[#rows + 1] = of[e]
      end
    end
  end
  return rows
end

local function point(r) return "(" .. show(r[1]) .. ", " .. show(r[2]) .. ", " .. show(r[3]) .. ")" end

-- Rows {what, formula} of one choice, the centroid.
local function facts(spec, a)
  local m = expr.sym("m", 1, true)
  local region = spec.name == "region"
  local shape = spec.build(a)
  local b = body.of { shape = spec.name, a = a, mass = m }
  local rows = { { region and "mass" or spec.measure, show(shape.measure) }, { "centroid", point(b.com) } }
  for _, r in ipairs(tensor_rows(body.tensor(b, b.com))) do rows[#rows + 1] = { "I " .. r[1], r[2] } end
  local names = {}
  for name in pairs(shape.points or {}) do names[#names + 1] = name end -- order does not matter: sorted
  table.sort(names)
  for _, name in ipairs(names) do rows[#rows + 1] = { "point " .. name, point(shape.points[name]) } end
  return rows, b.com
end

-- ---- pages and pictures ----

local function scene_line(spec, example)
  if example.line then return example.line end
  local list = {}
  for _, a in ipairs(spec.args or {}) do
    local v = example.args[a.name]
    if v ~= nil then list[#list + 1] = a.name .. " = " .. (example.scene and example.scene[a.name] or literal(v)) end
  end
  list[#list + 1] = "mass = 1"
  return spec.name .. "{" .. table.concat(list, ", ") .. "}"
end

-- What build() gives for the example: measure, com, sigma without symbols.
function shapes.example(spec)
  local example, chosen = examples[spec.name], {}
  for _, s in ipairs(spec.args or {}) do
    local v = example.args[s.name]
    chosen[s.name] = (s.choice or s.flag) and v or v and lifted(v)
  end
  return spec.build(shapes.arguments(spec, example, chosen))
end

-- The centroid of the example, as numbers.
local function centre(spec, example)
  local com
  if described(spec) then
    com = vec.map(shapes.example(spec).com or { expr.zero, expr.zero, expr.zero },
      function(e) return evaluate.double(e, {}) end)
  elseif example.args.list then
    local m = 0.0
    com = { 0, 0, 0 }
    for _, p in ipairs(example.args.list) do
      m = m + p[1]
      for d = 1, 3 do com[d] = com[d] + p[1] * p[d + 1] end
    end
    for d = 1, 3 do com[d] = com[d] / m end
  end
  return com or { 0, 0, 0 }
end

-- The picture of a shape of the catalogue, as SVG.
function shapes.picture(spec)
  local example = examples[spec.name]
  local node = example.node
  if not node then
    node = { shape = spec.name }
    for k, v in pairs(example.args) do node[k] = v end -- order does not matter: a table is copied
  end
  local s = surface.of(node, example.n, { turn = example.turn })
  if example.cut then s = opened.of(s) end
  return picture.of(s, { title = spec.name, about = spec.name .. names_of(spec) .. ": " .. spec.about .. "; "
    .. spec.frame, open = example.open, view = example.view, dims = example.dims(node),
    centroid = centre(spec, example) })
end

local head = [[
# Shapes

This page has every shape of the scene language. `make docs` makes it from the catalogue. Lengths are in metres,
angles in radians. Give either `mass` or `density` (per volume, area or length).

The tensor is about the centroid for the mass m, in the axes of the picture. Entries that are not listed are zero.
Off-diagonal entries are tensor entries, so they are minus the products of inertia. If an argument is a list, the
formulas are for the list of the example. In the pictures, the black and white disc is the centroid, and red lines are
the arguments. Some pictures have a quarter cut out, so that you can see more.

Some mean values have names, because their closed forms lose digits for a short curve. polhode computes them without
this loss. If sine and cosine of h are known numbers, the closed form is used instead.

| name | meaning |
|---|---|
| `arc_across(h)` | mean of sin² t over -h <= t <= h: `(1 - sin(2 h)/(2 h))/2` |
| `arc_along(h)` | variance of cos t over the same: `(1 + sin(2 h)/(2 h))/2 - (sin(h)/h)²` |
| `arc_lever(h)` | mean of t sin t over the same: `sin(h)/h - cos(h)` |
| `catenary_rise(u)` | catenary y = cosh x, -u <= x <= u, s = sinh u: mean of (y - 1)/s: `coth(u)/2 + u/(2 s²) - 1/s` |
| `catenary_width(u)` | variance of x/u on it: `1 - 2 coth(u)/u + 2/u²` |
| `catenary_height(u)` | variance of y/s on it: `1/12 + (3/4 - u coth(u)/2)/s² - u²/(4 s⁴)` |
| `ellipsoid_area(a, b, c)` | area of the ellipsoid's surface divided by 4 π |
| `ellipsoid_normal(a, b, c)` | mean over that surface of the square of the unit normal's component along a |

]]

local function link(name) return (string.gsub(name, "[^%w_]", "")) end

-- list: the catalogue's.  Returns files {{name =, text =}, ...}: shapes.md and a picture each.
function shapes.files(list)
  local out, files = { head }, {}
  for _, spec in ipairs(list) do
    out[#out + 1] = "[" .. spec.name .. "](#" .. link(spec.name) .. ")\n"
  end
  out[#out + 1] = "\n"
  for _, spec in ipairs(list) do
    local example = examples[spec.name] or error("no example of " .. spec.name .. " in docs/tools/examples.lua")
    out[#out + 1] = "## " .. spec.name .. "\n\n`" .. spec.name .. names_of(spec) .. "`: " .. spec.about .. ". Frame: "
      .. spec.frame .. ".\n\n![" .. spec.name .. "](shapes/" .. spec.name .. ".svg)\n\n"
    if example.note then out[#out + 1] = example.note .. "\n\n" end
    for _, choice in ipairs(described(spec) and choices(spec) or {}) do
      if #choice[1] > 0 then out[#out + 1] = "With " .. table.concat(choice[1], ", ") .. ":\n\n" end
      out[#out + 1] = "| | |\n|---|---|\n"
      for _, row in ipairs(facts(spec, shapes.arguments(spec, example, choice[2]))) do
        out[#out + 1] = "| " .. row[1] .. " | `" .. row[2] .. "` |\n"
      end
      out[#out + 1] = "\n"
    end
    out[#out + 1] = "```lua\n" .. scene_line(spec, example) .. "\n```\n\n"
    files[#files + 1] = { name = "shapes/" .. spec.name .. ".svg", text = shapes.picture(spec) }
  end
  table.insert(files, 1, { name = "shapes.md", text = (string.gsub(table.concat(out), "\n\n$", "\n")) })
  return files
end

return shapes
