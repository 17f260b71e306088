-- printed_worker.lua - runs inside the program for printed.t: the general library's numbers of scenes.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- args: paths of scenes.  A line for each: a Lua table, a list of points {values = {parameter = number}, t, x, u,
-- rates, scale, mass, com, center, inertia, centroidal, moments} in the names of host.mass and host.rates, the
-- library's own from the shapes.  The first point has the parameters' defaults.

local R = require "generator.algebra.rational"
local driver = require "generator.driver"
local numeric = require "generator.dynamics.numeric"

local host, args = ...
local POINTS = 3

local seed = 1
local function random(n)
  seed = seed * 48271 % 2147483647
  return seed * n // 2147483647 + 1
end

-- A rate, a length, ... of either sign, in steps that doubles have.
local function some() return (random(2001) - 1001) / 512 end

-- A value as Lua text; infinite numbers are read back as such, what is none fails the comparison.
local function written(v)
  if type(v) ~= "table" then return v ~= v and "0/0" or string.format("%q", v) end
  local keys, out = {}, {}
  for k in pairs(v) do keys[#keys + 1] = k end -- sorted
  table.sort(keys)
  for i, k in ipairs(keys) do out[i] = string.format("[%q]=%s", k, written(v[k])) end
  return "{" .. table.concat(out, ",") .. "}"
end

-- Parameters beside their defaults, doubles.
local function values_of(job, spread)
  local exact, doubles = {}, {}
  for _, p in ipairs(job.record.params) do
    exact[p.name] = spread and R.fromdouble(R.todouble(p.default * R.new(48 + random(32), 64))) or p.default
    doubles[p.name] = R.todouble(exact[p.name])
  end
  return exact, doubles
end

local function point(job, spread)
  local exact, doubles = values_of(job, spread)
  local scene = numeric.scene(job, exact)
  local p, library = host.mass(scene), host.rates(scene)
  if not (p and library) then return nil end -- no body with these parameters
  local x, u, norm = {}, {}, 0.0
  for i, s in ipairs(job.states) do
    x[i] = some()
    if s.kind == "attitude" then norm = norm + x[i] ^ 2 end
  end
  for i, s in ipairs(job.states) do
    if s.kind == "attitude" then x[i] = x[i] / math.sqrt(norm) end
  end
  for i = 1, #job.model.inputs do u[i] = some() end
  p.values, p.t, p.x, p.u = doubles, random(1024) / 256, x, u
  local rates, scale = library:rates(p.t, numeric.whole(job, x), #u > 0 and u or nil)
  if not rates then return nil end -- no motion from there, as with a tensor that is not positive at this time
  p.rates, p.scale = numeric.part(job, rates), numeric.part(job, scale)
  return p
end

for _, path in ipairs(args) do
  local job = assert(driver.read(host, path, {}))
  local list = {}
  for n = 1, 40 do
    local now = #list == 0 and n < 20 and point(job, false) or #list > 0 and #list < POINTS and point(job, true)
    if now then list[#list + 1] = now end
  end
  host.out(written(list) .. "\n")
end
