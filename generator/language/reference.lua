-- reference.lua -- the scene language, entry by entry, from the tables that editor and manual pages read.
--
--     reference.entries(tables) -> {{name, about, call | nil, rows = {{name, unit, default, about}, ...},
--                                   notes = {text}, example = text | nil}, ...}
-- tables: {shapes =, effects =, units =, functions =, watched =, conserved = f(effect) -> words}, as in
-- language/definitions.lua.
-- Arguments, units and defaults are those of the declarations; an example is a whole scene, which a test runs.
-- SPDX-License-Identifier: GPL-3.0-or-later

local fields = require "generator.language.fields"

local reference = {}

local function scene(inside) return 'return scene { name = "example", ' .. inside .. " }" end
local box = "body = solid.box { x = 0.3, y = 0.2, z = 0.1, mass = 2 }"

-- Scenes for the fields of a scene and for its functions; tests/report/reference.t runs each.
local examples = {
  ["scene.name"] = scene(box), ["scene.body"] = scene "body = solid.sphere { r = 0.1, mass = 1 }",
  ["scene.origin"] = scene(box .. ", origin = {0.15, 0.1, 0.05}"),
  ["scene.effects"] = scene(box .. ",\n  effects = { effect.damping { rate = 0.1 } }"),
  ["scene.initial"] = scene(box ..
    ",\n  initial = { omega = {0.1, 6, 0.2}, attitude = { axis = \"z\", angle = 0.5 } }"),
  ["scene.time"] = scene(box .. ", time = { horizon = 5, step = 0.01 }"),
  ["scene.accuracy"] = scene(box .. ", accuracy = 1e-6"),
  ["scene.budget"] = scene(box .. ", accuracy = 1e-6, budget = { ops = 500 }"),
  ["scene.ranges"] = scene(box .. ", ranges = { omega = 10 }"),
  ["scene.outputs"] = scene(box .. ',\n  effects = { effect.damping { rate = 0.1 } }, outputs = { "rates" }'),
  ["scene.events"] = scene(box .. ',\n  initial = { omega = {0, 6, 0.2} }, events = { { name = "flip", when = wy } }'),
  ["scene.measure"] = scene(box .. ", measure = { gyro = { wx, wy, wz } }"),
  param = 'local a = param("a", 0.3, "m")\n' .. scene "body = solid.box { x = a, y = a/2, z = 0.1, mass = 2 }",
  quantity = scene 'body = solid.sphere { r = quantity(10, "cm"), mass = 1 }',
  exact = scene 'body = solid.sphere { r = exact "1/3", mass = 1 }',
  input = 'local u = input("u", "N m", { min = -1, max = 1 })\n' ..
    scene(box .. ",\n  effects = { effect.torque { body = {0, 0, u} } }"),
  scene = scene(box),
}

local signs = { positive = "positive", nonnegative = "not negative" }

local function shown(x)
  if type(x) ~= "table" then return tostring(x) end
  local list = {}
  for i, v in ipairs(x) do list[i] = tostring(v) end
  return "{" .. table.concat(list, ", ") .. "}"
end

-- Rows of declared arguments.
local function arguments(units, args)
  local rows = {}
  for i, a in ipairs(args) do
    local about = {}
    for _, w in ipairs { a.about or "", a.size and a.size .. " components" or "", signs[a.sign] or "",
      a.choice and "one of " .. shown(a.choice) or "", a.motion and "may depend on the motion" or "" } do
      if w ~= "" then about[#about + 1] = w end
    end
    rows[i] = { a.name, a.flag and "true or false" or a.choice and "" or units.si(units.of(a.dim or "none")),
      a.default ~= nil and shown(a.default) or a.optional and "none" or "", table.concat(about, ", ") }
  end
  return rows
end

local function group_rows(g)
  local rows = {}
  for i, f in ipairs(g.fields) do rows[i] = { f[1], f[3] ~= "" and f[3] or f[2], f[4] or "", f[5] } end
  return rows
end

local function shape(units, s)
  local rows = s.args and arguments(units, s.args) or {}
  for _, a in ipairs(s.reader and fields.read_shapes[s.name] or {}) do rows[#rows + 1] = { a[1], a[2], "", a[3] } end
  return { name = s.name, about = s.about, call = s.name .. (s.takes or " { ... }"), rows = rows,
    notes = { "Frame: " .. s.frame .. ".", s.measure and "Also mass, or density per " .. s.measure .. "." or nil } }
end

local function effect(tables, e)
  local rows = {}
  for i, t in ipairs(e.takes or {}) do rows[i] = { t[1], t[2], t[3] or "", t[4] } end
  return { name = e.name, about = e.about, call = e.name .. " { ... }",
    rows = e.takes and rows or arguments(tables.units, e.args), notes = { "Formula: " .. e.formula .. ".",
      "Frame and signs: " .. e.signs .. ".", "Conserves: " .. tables.conserved(e) .. ".", "Source: " .. e.source .. ".",
      "Example: the installed scene " .. e.example .. "." } }
end

-- What functions of values take, by dsl/value.lua: by the number of arguments and by their dimensions.
local calls = { "(x)", "(x, y)", [false] = "(x, y, ...)" }
local kinds = { pure = "a pure number or an angle; gives a pure number", same = "any unit; gives a pure number",
  any = "any unit; gives the same", root = "any unit; gives its root" }

local function called(out, prefix, list)
  for _, f in ipairs(list) do
    local rows, names = {}, {}
    for i, a in ipairs(f[2]) do rows[i], names[i] = { a[1], a[2], "", a[3] }, a[1] end
    out[#out + 1] = { name = prefix .. f[1], about = f[4] or f[3], rows = rows, notes = {}, example = examples[f[1]],
      call = prefix .. f[1] .. "(" .. table.concat(names, ", ") .. ")" }
  end
end

function reference.entries(tables)
  local out, groups = {}, {}
  for _, g in ipairs(fields.groups) do groups[g.name] = g end
  called(out, "", fields.functions)
  for i, f in ipairs(out) do
    if f.name == "scene" then out[i].rows = group_rows(groups.Scene) end
  end
  for _, f in ipairs(groups.Scene.fields) do
    local own = groups[string.match(f[2], "^%u%a+")]
    local notes = { "Type: " .. f[2] .. ".", f[3] ~= "" and "Unit: " .. f[3] .. "." or nil }
    notes[#notes + 1] = f[4] and "Default: " .. f[4] .. "." or f.needed and "Required." or "Default: none."
    out[#out + 1] = { name = "scene." .. f[1], about = f[5], rows = own and group_rows(own) or {}, notes = notes,
      example = examples["scene." .. f[1]] or error("scene." .. f[1] .. " has no example") }
  end
  for _, name in ipairs { "Rotation", "Limits" } do
    out[#out + 1] = { name = string.lower(name), about = groups[name].about, rows = group_rows(groups[name]),
      notes = {} }
  end
  called(out, "shape:", fields.placing)
  for _, s in ipairs(tables.shapes) do out[#out + 1] = shape(tables.units, s) end
  for _, e in ipairs(tables.effects) do out[#out + 1] = effect(tables, e) end
  for _, w in ipairs(fields.words) do
    out[#out + 1] = { name = w[1], about = w[3], rows = {}, notes = { w[2] ~= "" and "Unit: " .. w[2] .. "." or nil } }
  end
  for _, m in ipairs(fields.motion) do
    out[#out + 1] = { name = "s." .. m[1], about = m[3], rows = {}, notes = { "Type: " .. m[2] .. ".",
      "In the functions of effect.custom." } }
  end
  local functions, known = {}, {}
  for i, f in ipairs(tables.functions) do functions[i] = { f[1], kinds[f[3]], "", f[4], call = calls[f[2]] } end
  local words = {}
  for i, w in ipairs(tables.watched) do words[i] = { w[1], w[2], "", w[3] } end
  out[#out + 1] = { name = "words of events", about = "what `when` of events and --columns of run know beside t " ..
    "and the states: of each scene what it has; where effect.rotating_frame turns the frame, its axes are meant, " ..
    "but for omega_inertial", rows = words, notes = {}, each = true }
  for i, u in ipairs(tables.units.list) do known[i] = u[1] end
  out[#out + 1] = { name = "functions", about = "functions of numbers and expressions: of parameters anywhere, and " ..
    "of t, states and inputs where an argument may depend on the motion", rows = functions, notes = {}, each = true }
  out[#out + 1] = { name = "units", rows = {}, about = "a unit is a product of these with powers, such as " ..
    '"kg m^2/s^2", "kg m2" or "kg·m²"; µ is u, ° is deg; zero is of any unit',
    notes = { table.concat(known, ", ") .. "." } }
  return out
end

local function sentence(s) return (string.gsub(s, "^%l", string.upper)) .. (string.find(s, "[%.:]$") and "" or ".") end

-- A row of an entry whose rows are entries, by the name that was asked for, for the terminal.
function reference.row(e, r, name)
  return reference.text { name = name, call = r.call and name .. r.call, about = r[4], rows = {},
    notes = { (r.call and "Takes " or "Unit: ") .. r[2] .. ".", "One of: " .. e.about .. "." } }
end

-- An entry for the terminal.
function reference.text(e)
  local out = { e.call or e.name, "", sentence(e.about) }
  if #e.rows > 0 then out[#out + 1] = "" end
  for _, r in ipairs(e.rows) do
    out[#out + 1] = "  " .. r[1] .. (r[2] ~= "" and " [" .. r[2] .. "]" or "") .. (r[4] ~= "" and ": " .. r[4] or "") ..
      (r[3] ~= "" and " (default " .. r[3] .. ")" or "")
  end
  if #e.notes > 0 then out[#out + 1] = "" end
  for _, n in ipairs(e.notes) do out[#out + 1] = n end
  if e.example then out[#out + 1] = "\nExample\n  " .. string.gsub(e.example, "\n", "\n  ") end
  return table.concat(out, "\n") .. "\n"
end

-- All entries as one page of Markdown.
function reference.page(list)
  local out = { "# Reference of the scene language\n\nMade by `make docs` from the declarations that check scenes. " ..
    "`polhode help NAME` prints one entry, such as `polhode help scene.initial`. Pictures and formulas of the " ..
    "shapes are in [shapes.md](shapes.md), those of the effects in [effects.md](effects.md).\n" }
  local function cell(s) return (string.gsub(s, "|", "\\|")) end
  for _, e in ipairs(list) do
    out[#out + 1] = "## " .. e.name .. "\n\n" .. (e.call and "`" .. e.call .. "`\n\n" or "") ..
      sentence(e.about) .. "\n"
    if #e.rows > 0 then out[#out + 1] = "| name | unit or type | default | |\n|---|---|---|---|" end
    for _, r in ipairs(e.rows) do
      local default = r[3] ~= "" and "`" .. cell(r[3]) .. "`" or ""
      out[#out + 1] = "| `" .. r[1] .. "` | " .. cell(r[2]) .. " | " .. default .. " | " .. cell(r[4]) .. " |"
    end
    if #e.rows > 0 then out[#out + 1] = "" end
    if #e.notes > 0 then out[#out + 1] = table.concat(e.notes, " ") .. "\n" end
    if e.example then out[#out + 1] = "```lua\n" .. e.example .. "\n```\n" end
  end
  return table.concat(out, "\n")
end

return reference
