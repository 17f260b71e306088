-- undefined.lua -- a name that the scene reads and nobody made: an error on its line, with what was probably meant.
--
-- In plain Lua such a name is nil, an argument that is nil is one that was left out, and `drag = Cd` would vanish
-- without a word.  A scene's own globals are as in Lua: it may make them, and what it made may be nil.
-- SPDX-License-Identifier: GPL-3.0-or-later

local broken = require "generator.diag.broken"
local nearest = require "generator.nearest"
local args = require "generator.dsl.args"
local units = require "generator.dsl.units"
local diag = require "generator.diag"

local undefined = {}

local most = 100 -- names for which the nearest are looked for

-- What Lua has and a scene has not: docs/sandbox.md.
local of_lua = {}
for word in string.gmatch([[_G _VERSION collectgarbage coroutine debug dofile getmetatable io load loadfile loadstring
  next os package pcall print rawequal rawget rawlen rawset require setmetatable utf8 warn xpcall]], "%S+") do
  of_lua[word] = true
end

-- Rotations are tables: what is taken for a function of that name.
local rotations = { euler = 'euler = "zxz", angles = {a, b, c}', quaternion = "quaternion = {w, x, y, z}",
  matrix = "matrix = {{..}, {..}, {..}}" }

-- Why there is no such name, or what is near it: " (...)" or "".
local function hint(ctx, e, name, params)
  if of_lua[name] then return " (Lua has it, a scene has not: it sees only a part of Lua's library)" end
  if rotations[name] then
    return " (a rotation is a table: { " .. rotations[name] .. " }; degrees are quantity(30, \"deg\"))"
  end
  for _, p in ipairs(params) do
    if p.name == name then
      return " (to use the parameter, write local " .. name .. " = param(\"" .. name .. "\", ...))"
    end
  end
  local words, members = ctx.diag:locals(), {}
  for _, k in ipairs(args.keys(e)) do
    words[#words + 1] = type(k) == "string" and k or nil
    for _, member in ipairs(ctx.families[k] or {}) do
      if member == name then members[#members + 1] = k .. "." .. member end
    end
  end
  if #members > 0 then return " (there is " .. table.concat(members, ", ") .. ")" end
  local near = nearest.of(name, words)
  local list = " (nearest: " .. table.concat(near, ", ") .. ")"
  if #near > 0 and nearest.slips(name, near[1]) < 1 then return list end -- it differs by capitals only
  local line = ctx.diag:declared(name)
  if line then return " (the local of line " .. line .. " is not visible here)" end
  if string.find(name, "^%a+$") and units.parse(name) then return " (a unit is written as text: \"" .. name .. "\")" end
  if #near > 0 then return list end
  for _, k in ipairs(args.keys(ctx.families)) do
    for _, member in ipairs(nearest.of(name, ctx.families[k])) do near[#near + 1] = k .. "." .. member end
  end
  return #near > 0 and " (nearest: " .. table.concat(near, ", ", 1, math.min(#near, 3)) .. ")" or ""
end

-- Lua's own tables: what they do not have is no member of theirs in a scene.
local function library(ctx, name, from)
  local list, t = {}, {}
  for _, k in ipairs(args.keys(from)) do list[#list + 1], t[k] = k, from[k] end
  return setmetatable(t, { __index = function(_, k)
    undefined.member(ctx, name, k, list)
    return broken.object
  end })
end

-- Shapes that are asked for and are made of others.
local made_of = { solid = {
  cube = "it is solid.box{x = a, y = a, z = a, mass = M}" }, shell = {
  frustum = "it is shell.cone{r = R, h = H} - shell.cone{r = r, h = H r/R}:at{0, 0, H (1 - r/R)}, H whole" } }

-- What to write in place of family.k, or "".
local function instead(ctx, family, k, list)
  if type(k) ~= "string" then return "" end
  local made, near, others = made_of[family] and made_of[family][k], nearest.of(k, list), {}
  if made then return " (" .. made .. ")" end
  if #near > 0 then return " (nearest: " .. table.concat(near, ", ") .. ")" end
  for _, name in ipairs(args.keys(ctx.families or {})) do
    for _, member in ipairs(ctx.families[name]) do
      if member == k then others[#others + 1] = name .. "." .. k end
    end
  end
  return #others > 0 and " (there is " .. table.concat(others, ", ") .. ")" or ""
end

-- An unknown member of a family or library is reported with what may be meant.
function undefined.member(ctx, family, k, list)
  ctx.diag:error(ctx.diag:here(), family, "has no " .. diag.show(k) .. instead(ctx, family, k, list))
end

-- Guards the environment e, whose words are all there but for those of watched(name, line), which stand back behind
-- what the scene itself calls so.  ctx.families: names of members by the name of the family.
function undefined.guard(ctx, e, params, watched)
  for _, k in ipairs { "math", "string", "table" } do
    if e[k] then e[k] = library(ctx, k, e[k]) end
  end
  -- words of the environment, and globals that the script has set: these may be nil
  local made, count = {}, 0
  for k in pairs(e) do made[k] = true end
  setmetatable(e, {
    __index = function(_, k)
      if made[k] then return nil end
      local named = type(k) == "string" and ctx.named[string.upper(k)]
      local own = type(k) ~= "string" or named and named[1] == k or ctx.diag:declared(k)
      local word = not own and watched(k, ctx.diag:here())
      if word then return word end
      count = count + 1
      local why = type(k) == "string" and count <= most and hint(ctx, e, k, params) or ""
      ctx.diag:error(ctx.diag:here(), "script", "unknown name " .. diag.show(k) .. why)
      return broken.object
    end,
    __newindex = function(t, k, v)
      made[k] = true
      rawset(t, k, v)
    end,
  })
end

return undefined
