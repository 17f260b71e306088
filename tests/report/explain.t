#!/usr/bin/env lua5.4
-- explain.t - polhode explain: keys, shapes and values of the JSON, the closed forms in every format.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The program is run as a user runs it.  Numbers are compared with formulas written out here; the JSON is read by a
-- strict reader (tests/json.lua).  The quick tier takes every eighth body.

package.path = "./?.lua;" .. package.path

local tap = require "tests.tap"
local tier = require "tests.tier"
local json = require "tests.json"

local EPSILON = 2.0 ^ -52

local binary = os.getenv "POLHODE" or "build/polhode"

local function explain(path, format, more)
  local command = string.format("%s explain %s --format %s %s 2>/dev/null", binary, path, format, more or "")
  local pipe = assert(io.popen(command))
  local text = pipe:read "a"
  local fine = pipe:close()
  return text, fine
end

local bodies = {}
do
  local pipe = assert(io.popen "ls bodies/*.lua")
  for path in pipe:lines() do bodies[#bodies + 1] = path end
  pipe:close()
end
bodies = tier.every(8, bodies)

-- the reader refuses what is no JSON, so that what it reads is some
for _, text in ipairs { "{", "[1,]", "{\"a\":1,}", "nan", "01", "1.", "\"a\nb\"", "{\"a\":1,\"a\":2}", "[1] x",
  "'a'" } do
  tap.ok(not pcall(json.read, text), "no JSON: " .. text:gsub("\n", "\\n"))
end

-- ---- JSON: shape, for every body ----

local KEYS = { "name", "mass", "com", "inertia", "centroidal", "principal", "symmetry", "closed_form", "stability",
  "effects", "methods", "cost", "warnings" }

local function numbers(list, n)
  if type(list) ~= "table" or #list ~= n then return false end
  for _, x in ipairs(list) do
    if type(x) ~= "number" then return false end
  end
  return true
end

local function tensor(t)
  if type(t) ~= "table" or type(t.symbolic) ~= "table" or not numbers(t.numeric, 6) then return false end
  return table.concat(json.keys[t.symbolic], " ") == "xx yy zz xy xz yz"
end

for _, path in ipairs(bodies) do
  local name = path:match "([%w_]+)%.lua"
  local text, fine = explain(path, "json")
  local read, j = pcall(json.read, text)
  if tap.ok(fine and read, name .. ": the JSON is JSON", tostring(j)) then
    local missing = {}
    for _, key in ipairs(KEYS) do
      if j[key] == nil then missing[#missing + 1] = key end
    end
    tap.is(table.concat(missing, " "), "", name .. ": no key of the contract is missing")
    tap.ok(j.name == name and type(j.mass) == "number" and numbers(j.com, 3) and tensor(j.inertia)
      and tensor(j.centroidal), name .. ": name, mass, com[3], inertia and centroidal have their shape")
    local p = j.principal
    local axes = numbers(p.moments, 3) and #p.axes == 3
    for k = 1, 3 do axes = axes and numbers(p.axes[k], 3) end
    tap.ok(axes and p.moments[1] <= p.moments[2] and p.moments[2] <= p.moments[3],
      name .. ": three ascending moments and three axes")
    local worst = 0.0
    for k = 1, 3 do
      local a, I, m = p.axes[k], j.inertia.numeric, p.moments[k]
      worst = math.max(worst, math.abs(I[1] * a[1] + I[4] * a[2] + I[5] * a[3] - m * a[1]),
        math.abs(I[4] * a[1] + I[2] * a[2] + I[6] * a[3] - m * a[2]),
        math.abs(I[5] * a[1] + I[6] * a[2] + I[3] * a[3] - m * a[3]))
    end
    -- Jacobi's rotations: a dozen roundings of the largest moment
    tap.ok(worst <= 32 * EPSILON * p.moments[3], name .. ": I axis = moment axis", string.format("%g", worst))
    tap.ok(#j.stability == 3 and #j.methods >= 2 and #j.cost > 5 and type(j.warnings) == "table"
      and type(j.symmetry) == "string", name .. ": stability[3], methods, cost, warnings, symmetry")
    local closed = j.closed_form
    tap.ok(closed.kind == json.null and type(closed.refused) == "string"
      or type(closed.kind) == "string" and type(closed.theorem) == "string",
      name .. ": a closed form with its theorem, or why there is none")
    local exact = false
    for _, m in ipairs(j.methods) do exact = exact or m == "exact" end
    tap.is(exact, closed.kind ~= json.null, name .. ": the method exact is listed where there is a closed form")
    for k, s in ipairs(j.stability) do
      local sign = s.Omega_squared_per_rate_squared
      local own, i, o = p.moments[k], p.moments[k % 3 + 1], p.moments[(k + 1) % 3 + 1]
      if i > 0 and o > 0 then
        -- the differences cancel: their error is some roundings of the largest moment
        tap.near(sign, (own - i) * (own - o) / (i * o), 8 * EPSILON, 16 * EPSILON * p.moments[3] ^ 2 / (i * o),
          name .. ": Omega^2 about axis " .. k .. " is (Ik - Ii)(Ik - Ij)/(Ii Ij)",
          "16 roundings of the largest moment")
      end
      tap.ok(s.verdict == (sign > 0 and "stable" or sign < 0 and "unstable" or "neutral"),
        name .. ": the verdict about axis " .. tostring(s.axis) .. " is the sign of Omega^2")
    end
    local rhs
    for _, c in ipairs(j.cost) do
      if c["function"] == "rhs" then rhs = c end
    end
    tap.ok(rhs and math.type(rhs.add) == "integer" and rhs.mul > 0, name .. ": the cost of the rates is counted")
  end
end

-- ---- JSON: values ----

do
  local j = json.read((explain("bodies/brick.lua", "json")))
  local a, b, c, M = 0.2, 0.1, 0.05, 2.4
  tap.is(j.mass, M, "brick: the mass")
  tap.is(j.mass_symbolic, "M", "brick: the mass, symbolic")
  local s = j.inertia.symbolic
  tap.is(table.concat({ s.xx, s.yy, s.zz, s.xy, s.xz, s.yz }, ", "),
    "M*(b^2 + c^2)/3, M*(a^2 + c^2)/3, M*(a^2 + b^2)/3, -M*a*b/4, -M*a*c/4, -M*b*c/4", "brick: the tensor, symbolic")
  local want = { M * (b * b + c * c) / 3, M * (a * a + c * c) / 3, M * (a * a + b * b) / 3, -M * a * b / 4,
    -M * a * c / 4, -M * b * c / 4 }
  for n = 1, 6 do
    -- the report's numbers are rounded once from exact ones, the formula here a few times
    tap.near(j.inertia.numeric[n], want[n], 4 * EPSILON, 0.0, "brick: entry " .. n, "four operations")
  end
  tap.is(j.inertia.numeric[1], 0.01, "brick: I_xx is the double nearest to 1/100")
  for i, x in ipairs { 0.1, 0.05, 0.025 } do
    tap.is(j.com[i], 0.0, "brick: com[" .. i .. "], in the coordinates of the shape")
    tap.is(j.com_from_origin[i], x, "brick: com_from_origin[" .. i .. "]")
  end
  tap.is(j.centroidal.symbolic.xy, "0", "brick: a vanishing entry is written 0")
  tap.is(#j.effects, 0, "brick: no effects")
  tap.is(#j.parameters, 4, "brick: four parameters")
  tap.ok(j.parameters[1].name == "a" and j.parameters[1].default == 0.2 and j.parameters[1].unit == "m",
    "brick: the first is a = 0.2 m")
  j = json.read((explain("bodies/brick.lua", "json", "--set a=0.4")))
  tap.is(j.parameters[1].default, 0.4, "--set changes a default")
  tap.near(j.inertia.numeric[4], -M * 0.4 * b / 4, 4 * EPSILON, 0.0, "--set: and the numbers", "four operations")
  j = json.read((explain("bodies/gyroscope.lua", "json")))
  tap.ok(#j.effects == 1 and j.effects[1].name == "effect.control" and j.effects[1].line == 12,
    "gyroscope: one effect, with its line")
  j = json.read((explain("bodies/cube_corner.lua", "json")))
  local m = j.principal.moments
  local unit = 1 * 0.1 ^ 2
  for k, want_k in ipairs { 1 / 6, 11 / 12, 11 / 12 } do
    tap.near(m[k] / unit, want_k, 8 * EPSILON, 0.0, "cube about its corner: moment " .. k, "Jacobi and two operations")
  end
end

-- ---- the other formats ----

local function contains(text, parts, name)
  for _, part in ipairs(parts) do
    tap.ok(text:find(part, 1, true) ~= nil, name .. ": says " .. part)
  end
end

contains(explain("bodies/brick.lua", "text"), { "Ixx = M (b² + c²)/3 = 0.01 kg m^2", "Ixy = -M a b/4",
  "Ixx = M (b² + c²)/12", "a = 0.2 m", "closed form: ", "unstable", "stable" }, "brick, text")
contains(explain("bodies/cube_corner.lua", "text"), { "11 M a²/12", "M a²/6", "(1, 1, 1)",
  "closed form: free symmetric top" }, "cube about its corner, text")
contains(explain("bodies/gyroscope.lua", "text"), { "effect control (line 12)", "conserves nothing" },
  "gyroscope, text")
contains(explain("bodies/dumbbell.lua", "text"), { "rod", "m1 m2 d²" }, "dumbbell, text")

for _, path in ipairs(bodies) do
  local name = path:match "([%w_]+)%.lua"
  for _, format in ipairs { "text", "markdown", "latex", "html", "typst" } do
    local text, fine = explain(path, format)
    tap.ok(fine and #text > 500 and utf8.len(text) and text:find "\n$" and not text:find("nil", 1, true)
      and not text:find "%f[%w]nan%f[%W]" and not text:find "%f[%w]inf%f[%W]",
      name .. ", " .. format .. ": a text in UTF-8 without nil, nan or inf")
  end
end

do -- the brick about its corner; roots of its characteristic cubic, by bisection with 60 digits
  local pipe = assert(io.popen((os.getenv "POLHODE" or "build/polhode") .. " explain bodies/brick.lua"))
  local text = pipe:read "a"
  pipe:close()
  for _, digits in ipairs { "Omega1 = -0.9654980288189445 w, Omega2 = -0.8489238103818718 w",
    "Omega2 = -0.6463213136732373 w, growth rate 0.7407277180816859 w" } do
    tap.ok(string.find(text, digits, 1, true), "differences of moments to the last digit: " .. digits)
  end
end

tap.done()
