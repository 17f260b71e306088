#!/usr/bin/env lua5.4
-- zeros.t - structural zeros and equalities vanish from the emitted C: what a body does not have is not computed.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- The emitted text is searched, in both real types, with symbolic parameters and with --bake.  A body that does have
-- the term is searched too, so that a search that never finds anything fails.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local tap = require "tests.tap"
local tier = require "tests.tier"
local scene = require "tests.scene"

-- The body of function `name` in C text: from its head to the closing brace at the line's start.
local function body_of(code, name)
  local from = code:find("\n[%w_]+ " .. name .. "%(")
  if not from then return nil end
  return (code:sub(from, code:find("\n}\n", from, true)):gsub("/%*.-%*/", ""))
end

local variants = { { "double", false }, { "float", false }, { "double", true }, { "float", true } }

for _, variant in ipairs(tier.every(3, variants)) do
  local real, bake = variant[1], variant[2]
  local tag = ", " .. real .. (bake and ", baked" or "")
  local zero = real == "float" and "0.0F" or "0.0"
  local function code(path)
    local job = scene.plan(scene.file("bodies/" .. path .. ".lua", { bake = bake }), { real = real })
    local text = scene.files(job)[path .. ".c"]
    return text, path
  end

  -- an asymmetric body in principal axes: no product of inertia anywhere
  local text, name = code "brick_centroid"
  local products = text:find("%f[%w_]I[xyz][xyz]%f[^%w_]") and (text:find("Ixy", 1, true) or text:find("Ixz", 1, true)
    or text:find("Iyz", 1, true) or text:find("Jx", 1, true))
  tap.ok(not products, "brick about its centroid: no product of inertia in the code" .. tag)
  local inertia = body_of(text, name .. "_inertia")
  for i = 3, 5 do
    tap.like(inertia, "I[" .. i .. "] = " .. zero .. ";",
      "brick about its centroid: I[" .. i .. "] is the literal 0" .. tag)
  end
  for _, part in ipairs { "rhs", "step" } do
    tap.ok(not body_of(text, name .. "_" .. part):find("%f[%w_]L[xyz]%f[^%w_]"),
      "brick about its centroid: " .. part .. " needs no L = I w" .. tag)
  end
  text = code "brick"
  tap.ok(bake or text:find("Ixy", 1, true), "brick about its corner: has products of inertia" .. tag)
  tap.ok(body_of(text, "brick_rhs"):find("%f[%w_]L[xyz]%f[^%w_]"), "brick about its corner: needs L = I w" .. tag)

  -- a symmetric top: no third Euler equation
  for _, body in ipairs { "symmetric_top", "coin", "earth" } do
    text, name = code(body)
    local upper = body:upper()
    local rhs, step = body_of(text, name .. "_rhs"), body_of(text, name .. "_step")
    tap.like(rhs, "dx[" .. upper .. "_WZ] = " .. zero .. ";", body .. ": w3' is the literal 0" .. tag)
    tap.ok(not step:find("x%[" .. upper .. "_WZ%]%s*[-+*/]?=") and step:find("x%[" .. upper .. "_WX%]%s*="),
      body .. ": the step writes wx and never wz" .. tag)
    tap.ok(not step:find "%f[%w_]k%d?z%d?%f[^%w_]" and not step:find "%f[%w_]v[234]z%f[^%w_]"
      and not step:find "%f[%w_]vz[234]%f[^%w_]", body .. ": the step has no stage values of wz" .. tag)
  end

  -- a sphere: no Euler equation at all
  local job = scene.plan(assert(scene.body("solid.sphere { r = a, mass = M }", { "M", "a" }, "", { bake = bake })),
    { real = real })
  text = scene.files(job)["b.c"]
  local rhs, step = body_of(text, "b_rhs"), body_of(text, "b_step")
  for _, comp in ipairs { "WX", "WY", "WZ" } do
    tap.like(rhs, "dx[B_" .. comp .. "] = " .. zero .. ";",
      "sphere: the rate of " .. comp .. " is the literal 0" .. tag)
    tap.ok(not step:find("x%[B_" .. comp .. "%]%s*[-+*/]?="), "sphere: the step leaves " .. comp .. " alone" .. tag)
  end
  tap.ok(not rhs:find("m->", 1, true) and not step:find("m->", 1, true),
    "sphere: neither rates nor step read a constant of the body" .. tag)

  -- a rod along z keeps its own rate; about an oblique line the equations need no inverse of the tensor
  job = scene.plan(assert(scene.body("rod.straight { length = a, mass = M }", { "M", "a" }, "", { bake = bake })),
    { real = real })
  text = scene.files(job)["b.c"]
  tap.like(body_of(text, "b_rhs"), "dx[B_WZ] = " .. zero .. ";", "rod: the rate along it is kept" .. tag)
  text = code "dumbbell"
  tap.ok(not text:find("J[xyz][xyz]"), "oblique rod: no inverse of its singular tensor is formed" .. tag)
end

-- ---- equalities ----

do
  -- two equal edges: one constant serves both moments, and no difference of equal moments is formed
  local job = scene.plan(assert(scene.body("solid.box { x = a, y = a, z = c, mass = M }", { "M", "a", "c" })))
  local text = scene.files(job)["b.c"]
  local init = body_of(text, "b_init")
  local count = select(2, init:gsub("k%.I[xyz][xyz] = ", ""))
  tap.is(count, 2, "box with a square base: two moments are computed, not three")
  local inertia = body_of(text, "b_inertia")
  local first = inertia:match "I%[0%] = ([%w_]+);"
  tap.ok(first and inertia:find("I[1] = " .. first .. ";", 1, true),
    "box with a square base: I[0] and I[1] are one number")
  -- free motion reads no attitude
  local job2 = scene.plan(scene.file "bodies/brick.lua")
  local rates = scene.files(job2)["brick.c"]
  local euler = body_of(rates, "brick_rhs"):match "Lx = .*$"
  tap.ok(euler and not euler:find "%f[%w_]q[wxyz]%f[^%w_]", "free brick: Euler's equations read no attitude")
end

-- ---- nothing is loaded in vain ----

for _, path in ipairs { "brick", "brick_centroid", "symmetric_top", "gyroscope", "dumbbell" } do
  local job = scene.plan(scene.file("bodies/" .. path .. ".lua"))
  local text = scene.files(job)[path .. ".c"]
  local idle = {}
  for _, f in ipairs(job.functions) do
    local code = body_of(text, path .. "_" .. f.name)
    for declaration in code:gmatch "const [%w_]+_real .-;" do
      for name in declaration:gmatch "[ ,]([%w_]+) = " do
        local uses = select(2, code:gsub("%f[%w_]" .. name .. "%f[^%w_]", ""))
        -- a local that has its member's name is written name = m->name
        if uses - (declaration:find("m->" .. name .. "%f[^%w_]") and 1 or 0) < 2 then
          idle[#idle + 1] = f.name .. ": " .. name
        end
      end
    end
  end
  tap.ok(#idle == 0, path .. ": every named value of every function is used", table.concat(idle, ", "))
end

tap.done()
