-- scene.lua - reads scenes inside a test, without the program: a host of a few lines.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local s = scene.read [[ local a = param("a", 2, "m") return scene { ... } ]]        -- or nil, the messages
--     local s = scene.body("solid.sphere { r = r, mass = M }", { "M", "r" }, "origin = {0, 0, 0}")
--     local plan = scene.plan(s, { real = "float" }); scene.files(plan)["b.c"]
--
-- The sandbox here bounds nothing and hides nothing: scenes of tests are our own.  What the real one does is tested
-- in tests/cli.  `visible` is the identity, so the line of a shape in tail position is not known.
-- Also here: exact numbers at random, the same in every run, and values of expressions at them.

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local evaluate = require "generator.algebra.evaluate"
local calculus = require "generator.algebra.calculus"
local driver = require "generator.driver"
local random = require "tests.ir.random"

local scene = {}

local function slurp(path)
  local file = io.open(path, "rb")
  if not file then return nil end
  local text = file:read "a"
  file:close()
  return text
end
scene.slurp = slurp

local function sandbox(text, name, env)
  local chunk, why = load(text, name, "t", env)
  if not chunk then return false, { message = why, line = tonumber(why:match(":(%d+):")), kind = "syntax" } end
  local result = table.pack(pcall(chunk))
  if result[1] then return table.unpack(result, 1, result.n) end
  local raised = tostring(result[2])
  return false, { message = raised, line = tonumber(raised:match(":(%d+):")), kind = "runtime" }
end

local templates
local function all_templates()
  if not templates then
    templates = {}
    local pipe = assert(io.popen "find templates -type f")
    for name in pipe:lines() do templates[name] = slurp(name) end
    pipe:close()
  end
  return templates
end

-- A host whose only file is the text.
local function host(text)
  return {
    read = function() return text end, sandbox = sandbox, visible = function(f) return f end,
    safe = { ipairs = ipairs, pairs = pairs, tostring = tostring, math = math, string = string, table = table },
    templates = all_templates(),
  }
end

-- The scene of a text; nil and all its messages if it is refused.
function scene.read(text, options)
  local job, d, why = driver.read(host(text), (options or {}).file or "test.lua", options or {})
  if job then return job end
  return nil, d and d:report() or why
end

function scene.file(path, options)
  local text = assert(slurp(path), path)
  local given = { file = path }
  for k, v in pairs(options or {}) do given[k] = v end
  return assert(scene.read(text, given))
end

-- A scene of one body named b.  params: names; M... is a mass, phi and k... are pure numbers, rho is of any kind, other
-- names are lengths; defaults 2, 3, 5, 7 ... in their order unless "name = value" says otherwise.  more: further lines
-- of the scene.
function scene.body(shape, params, more, options)
  local lines = {}
  local prime = { 2, 3, 5, 7, 11, 13, 17, 19, 23, 29 }
  for i, p in ipairs(params or {}) do
    local name, value = p:match "^(%w+)%s*=%s*(.+)$"
    name, value = name or p, value or tostring(prime[i])
    local unit = name:find "^M" and '"kg"' or name:find "^rho" and "nil"
      or (name:find "^phi" or name:find "^k") and '"rad"' or '"m"'
    lines[i] = string.format('local %s = param("%s", %s, %s)', name, name, value, unit)
  end
  return scene.read(table.concat(lines, "\n") .. "\nlocal body = " .. shape ..
    "\nreturn scene { name = \"b\", body = body, " .. (more or "") .. " }\n", options)
end

-- A plan of a scene; nil and its diagnostics.
function scene.plan(s, options)
  local o = options or {}
  return driver.plan(s, { only = o.only, analysis = o.analysis, orbit = o.orbit, layout = o.layout, real = o.real,
    command = "polhode gen test.lua", methods = o.methods, jacobians = o.jacobians, order = o.order, libm = o.libm,
    proof = o.proof, compensated = o.compensated, q31 = o.q31, batch = o.batch, package = o.package,
    planned = o.planned, sweep = o.sweep, fit = o.fit, attitude = o.attitude, estimator = o.estimator })
end

-- The files of a plan by name.
function scene.files(plan, plugin)
  local by_name = {}
  for i, f in ipairs(assert(driver.files(plan, { plugin = plugin })).files) do
    by_name[f.name], by_name[i] = f.text, f.name
  end
  return by_name
end

-- The emitted function `name` of a plan as a description (dynamics/quantities.lua).
function scene.description(plan, name)
  for _, f in ipairs(plan.functions) do
    if f.name == name then return f end
  end
  return nil
end

-- Results of a description as expressions of parameters and state: [index] or [state name], "result".
function scene.results(plan, f)
  local map, out = {}, {}
  for _, member in ipairs(plan.model.members) do map[member.sym] = member.e end
  for _, g in ipairs(f.groups) do
    for _, d in ipairs(g.defs) do
      local e = calculus.substitute(d.expr, map)
      for rank = 6, 9 do map[expr.sym(d.name, rank)] = e end
    end
    for _, o in ipairs(g.outs) do
      local array = o.array or "result"
      out[array] = out[array] or {}
      out[array][o.index and o.index + 1 or o.state or 1] = calculus.substitute(o.expr, map)
    end
  end
  return out
end

-- The rates of change of a plan as expressions of parameters and state, by name.
function scene.rates(plan) return scene.results(plan, scene.description(plan, "rhs")).dx end

---- exact numbers at random --------------------------------------------------------------------------

scene.seed = random.seed

-- A rational in [1/9, 40); with `signed` half of them negative.
function scene.rational(signed)
  local q = R.new(random.int(40), random.int(9))
  if signed and random.int(2) == 1 then return -q end
  return q
end

-- A value for every symbol of the expressions that env lacks: positive ones for positive symbols, any sign else.
function scene.point(list, env, positive)
  env = env or {}
  for _, e in ipairs(list) do
    for _, s in ipairs(expr.symbols(e)) do
      env[s.name] = env[s.name] or scene.rational(not (s.positive or positive))
    end
  end
  return env
end

function scene.exact(e, env) return evaluate.exact(e, env) end

-- Are two nodes without symbols the same number?  Rational ones exactly; what has pi, roots, sines and the like at 600
-- bits, of which 500 must agree: 100 are for what cancels, and no two short formulas come that close by chance.
function scene.same(a, b)
  if a.kind == "num" and b.kind == "num" then return a == b end
  local x, y = evaluate.precise(a, {}, 600), evaluate.precise(b, {}, 600)
  local d = R.abs(x - y)
  return R.sign(d) == 0 or R.sign(y) ~= 0 and R.log2(d) < R.log2(y) - 500
end

-- Is e = want (a node or number) at `count` random points with positive values?  Exact for rational functions.
-- Second result: where not.
function scene.agree(e, want, count)
  for _ = 1, count or 5 do
    local env = scene.point({ e, expr.lift(want) }, nil, true)
    local a, b = evaluate.exact(e, env), evaluate.exact(expr.lift(want), env)
    if a ~= b then return false, tostring(a) .. " instead of " .. tostring(b) end
  end
  return true
end

return scene
