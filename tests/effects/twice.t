#!/usr/bin/env lua5.4
-- twice.t - the same physics written in two ways moves the same, by the library and by the emitted code.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Random scenes of one to three effects (scenes.lua), each run from its text and from another text of the same motion:
-- effects in another order, parameters for numbers, the wheel in the body's tensor or not, axes renamed, the scene in a
-- mirror, the body elsewhere with its origin, in two pieces, other units, all quantities scaled by their dimensions,
-- custom effects for built-in ones, and time reversed.  Both roads integrate to 1e-12; over 2 s, some two radians,
-- neighbouring motions of these scenes part by less than 1e3.
-- POLHODE_SCENES=50: so many of each kind.  The quick tier takes one of each.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"
local rows = require "tests.effects.rows"
local scenes = require "tests.effects.scenes"

local dir = program.directory()
local quick = program.quick_compiler()
local binary = os.getenv "POLHODE" or "build/polhode"
local count = tonumber(os.getenv "POLHODE_SCENES") or tier.quick and 1 or 4
local TOLERANCE = 1e3 * 1e-11

-- The state at the end, by column: { qw = .., .. }, or nil and the messages.
local function run(engine, text, finish)
  program.write(dir .. "/s.lua", text)
  local status = program.shell(string.format("%s timeout 100 %s run %s/s.lua --engine %s --method adaptive " ..
    "--tolerance 1e-12 --until %g >%s/out 2>%s/err", quick, binary, dir, engine, finish or 2, dir, dir))
  local out = program.read(dir .. "/out")
  local head, last = out:match "^([^\n]*)\n.-([^\n]*)\n$"
  if status ~= 0 or not last then return nil, status .. "\n" .. program.read(dir .. "/err") end
  local names, state = {}, {}
  for name in head:gmatch "[^,]+" do names[#names + 1] = name end
  for number in last:gmatch "[^,]+" do state[table.remove(names, 1)] = tonumber(number) end
  return state
end

-- The largest difference, q and -q being one attitude; names: what is called so in b is called names[..] in a.
local function apart(a, b, names)
  local dot, worst, where = 0.0, 0.0, ""
  local function of(name) return names and names[name] or name end
  for _, q in ipairs { "qw", "qx", "qy", "qz" } do dot = dot + (a[of(q)] or 0)*(b[q] or 0) end
  local sign = dot < 0 and -1 or 1
  for name, y in pairs(b) do
    local x = a[of(name)]
    local s = name:find "^q[wxyz]$" and sign or 1
    local d = x and math.abs(x - s*y)/(1 + math.abs(y)) or math.huge
    if name ~= "t" and not name:find "energy" and (d > worst or d ~= d) then worst, where = d, name end
  end
  return worst, where
end

-- how: names, see `apart`; back, which turns the second state into the first one's; finish, the second one's end.
local function same(what, first, second, how)
  how = how or {}
  for _, engine in ipairs { "general", "generated" } do
    local a, why = run(engine, first)
    local b, why_b
    if a then b, why_b = run(engine, second, how.finish) end
    if b and how.back then how.back(b) end
    local d, where = 0, why or why_b
    if a and b then d, where = apart(a, b, how.names) end
    tap.ok(a and b and d <= TOLERANCE, what .. ", " .. engine, string.format("%s: %.3g\n%s%s", where, d, first, second))
  end
end

-- The same with all quantities scaled: the second motion is compared in the units of the first.
local UNIT = { w = "1/s", L = "N m s" } -- of columns; W of a wheel is a rate
local function grown(what, first, second, scale)
  same(what, first, second, { finish = 2*scale[3], back = function(b)
    for name, x in pairs(b) do
      local unit = UNIT[name:sub(1, 1)]
      if unit then b[name] = x/scenes.scaled(scale, 1, unit) end
    end
  end })
end

-- The second is the first in a mirror across x: what is odd there has the other sign.
local ODD = { "qy", "qz", "wy", "wz", "Ly", "Lz", "rx", "vx", "p1", "v1" }
local function mirrored(what, first, second)
  same(what, first, second, { back = function(b)
    for _, name in ipairs(ODD) do b[name] = b[name] and -b[name] end
  end })
end

local V = {}
for _, v in ipairs(scenes.variants) do V[v.name] = v end

local random = scenes.new(4711, 0)
local BODY = { "diagonal", "symmetric", "full" }

-- One to three variants that fit each other, `must` among them; from: names to choose from, nil: all.
local function choose(must, from)
  while true do
    local list = { must }
    for _ = 1, random:random(must and 2 or 3) do
      list[#list + 1] = from and V[from[random:random(#from)]] or scenes.draw(random)
    end
    if select(2, scenes.fits(list)) then return list end
  end
end

-- An origin that suits all of them, said once, so that both texts have the same.
local function placed(list) return (scenes.fits(list)) or "centroid" end

for n = 1, count do
  -- another order
  local list = choose()
  local p = scenes.parts(scenes.new(n, 0), BODY[n % 3 + 1], list, placed(list))
  local first, turned = scenes.joined("a", p), {}
  for i, e in ipairs(p.effects) do turned[#p.effects + 1 - i] = e end
  p.effects = turned
  -- several wheels change their columns' names with their order
  if not first:find "wheel" and not first:find "custom" then
    same("effects in another order " .. n, first, scenes.joined("a", p))
  end

  -- parameters for numbers
  list = choose()
  local seed = random:random(100000)
  same("parameters for numbers " .. n, scenes.text(scenes.new(seed, -1), "b", "full", list, placed(list)),
    scenes.text(scenes.new(seed, 2), "b", "full", list, placed(list)))

  -- axes renamed: x, y, z of the one are y, z, x of the other
  local vectors = { "gravity_direction", "damping", "damping_principal", "damping_rate", "torque_body",
    "torque_inertial", "rotor", "flight", "drag", "friction", "spring", "spring_axis", "magnetic", "wheel_true",
    "wheel_false", "pivot_vibrates", "sink", "frame", "frame_changing" }
  list = choose(nil, vectors)
  local a, b = scenes.new(seed, 0), scenes.new(seed, 0)
  b.renamed = true
  local to = {}
  for _, k in ipairs { "q", "w", "r", "v", "L" } do
    to[k .. "x"], to[k .. "y"], to[k .. "z"] = k .. "z", k .. "x", k .. "y"
  end
  same("axes renamed " .. n, scenes.text(a, "c", "full", list, placed(list)), scenes.text(b, "c", "full", list,
    placed(list)), { names = to })

  -- in a mirror across x
  list = choose(nil, vectors)
  a, b = scenes.new(seed, 0), scenes.new(seed, 0)
  b.mirrored = true
  mirrored("in a mirror " .. n, scenes.text(a, "m", "full", list, placed(list)), scenes.text(b, "m", "full", list,
    placed(list)))
  local plane = V["on_" .. ({ "sphere", "ellipsoid" })[n % 2 + 1] .. "_" ..
    ({ "viscous", "rolling", "smooth", "coulomb" })[(n + n // 4) % 4 + 1]]
  list = choose(plane, { "damping", "torque_body", "spring", "drag" })
  a, b = scenes.new(seed, 0), scenes.new(seed, 0)
  b.mirrored = true
  mirrored(plane.name .. " in a mirror " .. n, scenes.text(a, "m", "diagonal", list, "centroid"), scenes.text(b, "m",
    "diagonal", list, "centroid"))

  -- other units
  list = choose()
  a, b = scenes.new(seed, 0), scenes.new(seed, 0)
  b.others = true
  same("other units " .. n, scenes.text(a, "u", "diagonal", list, placed(list)), scenes.text(b, "u", "diagonal", list,
    placed(list)))

  -- all lengths twice, all masses three times, all times four times as long
  list = choose(nil, { "gravity_direction", "damping", "damping_principal", "damping_rate", "torque_body",
    "torque_inertial", "rotor", "friction", "spring", "spring_axis", "magnetic", "magnetic_rotating", "wheel_free_true",
    "wheel_free_false", "frame" })
  a, b = scenes.new(seed, 0), scenes.new(seed, 0)
  b.scale = { 2, 3, 4 }
  local small, large = scenes.parts(a, "diagonal", list, placed(list)), scenes.parts(b, "diagonal", list, placed(list))
  large.origin = large.origin:gsub("%d[%d.]*", function(x) return x*b.scale[1] end)
  large.initial = large.initial:gsub("omega = %b{}", function(t)
    return (t:gsub("%d[%d.]*", function(x) return string.format("%.17g", x/b.scale[3]) end))
  end)
  grown("larger, heavier, slower " .. n, scenes.joined("z", small), scenes.joined("z", large), b.scale)

  -- the body elsewhere, its origin with it; and in two pieces
  list = choose(nil, { "gravity", "gravity_direction", "damping_rate", "torque_table", "rotor", "pivot", "drag",
    "sink" })
  p = scenes.parts(scenes.new(seed, 0), "diagonal", list, "point")
  first = scenes.joined("d", p)
  local body = p.body
  p.body, p.origin = body .. ":at {1, 2, 3}", "{1.1, 2.2, 2.7}"
  same("the body elsewhere " .. n, first, scenes.joined("d", p))
  local x, y, z, m = body:match "x = ([%d.]+), y = ([%d.]+), z = ([%d.]+), mass = ([%d.]+)"
  local half = string.format("solid.box { x = %.17g, y = %s, z = %s, mass = %.17g }", x/2, y, z, m/2)
  p.body = string.format("(%s:at {%.17g, 0, 0} + %s:at {%.17g, 0, 0})", half, x/4, half, -x/4)
  p.origin = "{0.1, 0.2, -0.3}"
  same("the body in two pieces " .. n, first, scenes.joined("d", p))

  -- J a a^T of the wheel in the body's tensor, or not
  list = choose(nil, { "damping_rate", "circular", "elliptic", "sink", "frame", "rotor", "custom_torque",
    "damping_matrix", "flight_force", "parts" })
  p = scenes.parts(scenes.new(seed, 0), "diagonal", list, "centroid")
  table.insert(p.effects, "effect.wheel { axis = {0, 0, 1}, inertia = 0.25, speed = 3, torque = 0.1*sin(t), " ..
    "included = true }")
  p.body = "tensor { mass = 3, com = {0, 0, 0}, xx = 2, yy = 2.5, zz = 1.25 }"
  first = scenes.joined("e", p)
  p.effects[#p.effects] = p.effects[#p.effects]:gsub("true", "false")
  p.body = "tensor { mass = 3, com = {0, 0, 0}, xx = 2, yy = 2.5, zz = 1 }"
  same("the wheel in the tensor or not " .. n, first, scenes.joined("e", p))

  -- the scene's own effects for those of the language
  p = scenes.parts(scenes.new(seed, 0), "full", choose(nil, { "rotor", "drag", "spring", "damping_rate" }), "centroid")
  local own = #p.effects + 1
  for i, pair in ipairs(rows.customs) do
    p.effects[own] = pair[1]
    first = scenes.joined("f", p)
    p.effects[own] = pair[2]
    same("a custom effect " .. i .. " for a built-in one " .. n, first, scenes.joined("f", p))
  end
end

-- What differs is seen: a thousandth of one damping, by both roads.
do
  local p = scenes.parts(scenes.new(1, 0), "full", { V.rotor }, "centroid")
  for _, engine in ipairs { "general", "generated" } do
    p.effects[2] = "effect.damping { c = 0.1 }"
    local a = run(engine, scenes.joined("h", p))
    p.effects[2] = "effect.damping { c = 0.1001 }"
    tap.ok(apart(a, run(engine, scenes.joined("h", p))) > 100*TOLERANCE, "another motion is told apart, " .. engine)
  end
end

-- Time reversed: what has an energy and no memory comes back.
local function state_text(s, flies)
  local function list(names, sign)
    local out = {}
    for i, name in ipairs(names) do out[i] = string.format("%.17g", sign*s[name]) end
    return "{" .. table.concat(out, ", ") .. "}"
  end
  return "omega = " .. list({ "wx", "wy", "wz" }, -1) .. ", attitude = " .. list({ "qw", "qx", "qy", "qz" }, 1) ..
    (flies and ", position = " .. list({ "rx", "ry", "rz" }, 1) .. ", velocity = " ..
      list({ "vx", "vy", "vz" }, -1) or "")
end
for n, names in ipairs { { "gravity_direction", "spring" }, { "magnetic", "spring_axis" },
  { "flight", "custom_potential" } } do
  local p = scenes.parts(scenes.new(n, 0), "full", { V[names[1]], V[names[2]] })
  local begin = p.initial
  for _, engine in ipairs { "general", "generated" } do
    p.initial = begin
    local there, why = run(engine, scenes.joined("g", p))
    local back, d, where
    if there then
      p.initial = state_text(there, there.rx ~= nil)
      back, why = run(engine, scenes.joined("g", p))
    end
    if back then
      p.initial = state_text(back, back.rx ~= nil)
      local again = run(engine, scenes.joined("g", p)) -- and there once more, which is where it was
      d, where = apart(there, again)
    end
    tap.ok(d and d <= TOLERANCE, "time reversed: " .. table.concat(names, " and ") .. ", " .. engine,
      d and string.format("%s: %.3g", where, d) or why)
  end
end

tap.done(program.finish())
