-- python.lua -- a Python package: a C extension of the limited interface, so one wheel serves Python 3.11 and all later
-- ones, and a class that takes and gives NumPy arrays.
--
-- The extension copies nothing behind the caller's back and runs loops without the interpreter's lock; the class in
-- __init__.py allocates, checks shapes and says what is wrong.  Beside it: type stubs, a test, setuptools' files.
-- SPDX-License-Identifier: GPL-3.0-or-later

local number = require "generator.emit.number"
local readme = require "generator.emit.readme"
local template = require "generator.emit.template"

local GROUP = template.group("projects/python_native.c", "projects/python_init.py", "projects/python_native.pyi",
  "projects/python_project.toml", "projects/python_setup.txt", "projects/python_test.py")

local python = { whole = true, layout = "single" }

local reserved = {}
for word in string.gmatch([[and as assert async await class def del elif except finally from global import in is lambda
  nonlocal not or pass raise with yield None True False numpy setup tests test src self]], "%S+") do
  reserved[word] = true
end

function python.check(job)
  local d, name = job.diag, job.model.name
  if reserved[name] then
    d:error(job.record.line, "project python", "the scene must not be named like a word or a module of Python", name)
    return false
  end
  for _, p in ipairs(job.model.params) do
    if reserved[p.name] then
      d:error(p.line, "project python", "a parameter must not be named like a word of Python", p.name)
      return false
    end
  end
  return true
end

-- Text inside a string literal of C or Python: ? is marked because ??/ is a trigraph of C.
local function literal(s) return (string.gsub(string.gsub(s, '[\\"]', "\\%0"), "%c", " ")) end

-- Functions of a state that give numbers: {name, width, how C is called, ...}, of those that the scene has.
local function maps_of(made)
  local out, p = {}, made.base.name .. "_"
  local function put(name, width, call, about)
    if not made.offers[name] then return end
    local one = width == "1"
    out[#out + 1] = { name = name, width = width, call = call, about = about, tail = one and "" or width .. ",",
      flat = one and ".reshape(-1)" or "",
      shape = one and "() or (n,)" or "(" .. width .. ",) or (n, " .. width .. ")" }
  end
  put("energy", "1", "*y = " .. p .. "energy(m, x);", "The energy, J: kinetic, and potential where the scene has one.")
  put("momentum", "3", p .. "momentum(m, x, y);",
    "The angular momentum about the origin of rotation, inertial axes, kg m^2/s.")
  put("momentum_body", "3", p .. "momentum_body(m, x, y);",
    "The angular momentum about the origin of rotation, body axes, kg m^2/s.")
  return out
end

local function values_of(job, made)
  local m, float = job.model, job.real == "float"
  local offers = made.offers
  local v = { dtype = float and "float32" or "float64", format = float and "f" or "d",
    other_dtype = float and "float64" or "float32", checks = {}, states = {}, params = {}, inputs = {},
    maps = maps_of(made), has_step = offers.step ~= false, has_rhs = offers.rhs ~= false,
    has_orbit = offers.solve ~= false and offers.at ~= false, package_version = "0.1.0",
    title_literal = literal(job.title),
    all_sources = { "src/" .. m.name .. "_native.c" } }
  v.orbit_name = v.has_orbit and ', "Orbit"' or ""
  for i, c in ipairs(made.parts.init.checks) do v.checks[i] = literal(c.text) end
  for i, s in ipairs(job.states) do v.states[i] = { name = s.name, unit = s.unit or "1" } end
  for i, s in ipairs(m.inputs) do v.inputs[i] = { name = string.lower(s.index or s.name), unit = s.unit or "1" } end
  for i, p in ipairs(m.params) do
    v.params[i] = { name = p.name, unit = p.unit, default = number.decimal(p.default, "double") }
  end
  for _, s in ipairs(made.names.sources) do v.all_sources[#v.all_sources + 1] = "src/" .. s end
  return v
end

local about = {
  { name = "pyproject.toml, setup.py", about = "the package for pip and setuptools" },
  { name = "python", about = "the package: a class, its types, the stubs of the extension" },
  { name = "tests", about = "a test for unittest" },
}

local use = {
  "    python3 -m venv --system-site-packages env    # pip needs an environment of its own on Debian and others",
  "    env/bin/pip install --no-build-isolation .    # or: python3 -m build --no-isolation --wheel",
  "    env/bin/python -m unittest discover tests",
  "",
  "It needs NumPy and Python 3.11 or later. To build it you need a C compiler, setuptools and wheel; without",
  "`--no-build-isolation` pip downloads the last two. The wheel uses the stable interface (abi3).",
  "",
  "```python",
}

local function example(v, name, base)
  local out = { table.unpack(use) }
  local function put(line) out[#out + 1] = line end
  put("import " .. name)
  put("m = " .. name .. ".Model()          # parameters as keyword arguments, SI units")
  put("x = m.initial()                # shape (" .. base.upper .. "_NX,)")
  local u = base.has_inputs and ", u=[0.0]*" .. name .. ".NU" or ""
  if v.has_step then put("t, states = m.run(x, " .. base.step_text .. ", 1000, every=100" .. u .. ")") end
  if v.has_orbit then put("m.solve(x).at([0.0, 1.0, 2.0])  # the states at these times, in closed form") end
  put "```"
  return out
end

function python.files(job, made)
  local v, name = values_of(job, made), job.model.name
  local render = GROUP(job.templates, made.base, v)
  local files = {}
  for _, f in ipairs { { "native.c", "src/" .. name .. "_native.c" },
    { "init.py", "python/" .. name .. "/__init__.py" }, { "native.pyi", "python/" .. name .. "/_native.pyi" },
    { "project.toml", "pyproject.toml" }, { "setup.txt", "setup.py" },
    { "test.py", "tests/test_" .. name .. ".py" } } do
    files[#files + 1] = { name = f[2], text = render("projects/python_" .. f[1]) }
  end
  files[#files + 1] = { name = "python/" .. name .. "/py.typed", text = "# has types\n" }
  files[#files + 1] = { name = "README.md",
    text = readme.render(job, made, { files = about, use = example(v, name, made.base) }) }
  return files
end

-- What stands in no folder yet is the scene's C.
function python.arrange(files)
  for _, f in ipairs(files) do
    if string.find(f.name, "^[^/]+%.[ch]$") then
      f.name = (string.find(f.name, "_test%.c$") and "extras/" or "src/") .. f.name
    end
  end
  return files
end

return python
