-- projects.lua -- the emitted projects that the promises are checked on: every scene of bodies/, every stepper.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     for _, p in ipairs(projects.list(dir)) do ... end
--         {name = of the scene, real =, where = its directory, title =, own = with its own mathematical functions,
--          header =, source = texts}
-- Each scene once with its parameters, its closed form and every stepper that it admits, in double and in float by
-- turns; each tenth also baked, with jacobians and all steppers that have them, in the other real type.  The default
-- functions of every scene in every real type, with parameters and baked, are what tests/emit/compile.t compiles.

local program = require "tests.cli.program"

local projects = {}

local binary = os.getenv "POLHODE" or "build/polhode"

local ALL = { "exact", "rk4", "adaptive", "taylor", "midpoint", "semi", "split2", "split4", "split6" }
-- those with a transition matrix; a splitting method has none (docs/emitted.md)
local DERIVED = { "exact", "rk4", "adaptive", "taylor", "midpoint", "semi" }

-- p with its texts, or nil and the refusal.
local function emit(p, path, options)
  local all = string.gsub(options, "%-%-with ", "--with analysis,")
  if not string.find(all, "--with", 1, true) then all = all .. " --with analysis" end
  local code = program.shell(string.format("%s gen %s --layout single --real %s %s -o %s >/dev/null 2>%s.err", binary,
    path, p.real, all, p.where, p.where))
  if code ~= 0 then return nil, program.read(p.where .. ".err") end
  p.header = program.read(p.where .. "/" .. p.name .. ".h")
  p.source = program.read(p.where .. "/" .. p.name .. ".c")
  return p
end

-- Methods that are refused are left out, one after the other, as the message names them; what float cannot hold is in
-- double.
local function widest(p, path, methods, options)
  local words = { table.unpack(methods) }
  while true do
    local done, why = emit(p, path, "--method " .. table.concat(words, ",") .. " " .. options)
    if done then break end
    local refused, at = string.match(why, "method (%w+):"), nil
    for i, w in ipairs(words) do at = w == refused and i or at end
    if at then
      table.remove(words, at)
    elseif p.real == "float" and string.find(why, "constant", 1, true) then
      p.real = "double"
    else
      error(path .. ": " .. why)
    end
  end
  p.own = p.real == "float"
  p.title = string.format("%s, %s, %s%s", p.name, p.real, options ~= "" and options .. ", " or "",
    table.concat(words, " "))
  return p
end

function projects.list(dir)
  local pipe = assert(io.popen "LC_ALL=C ls bodies/*.lua")
  local list, n = {}, 0
  for path in pipe:lines() do
    local name = string.match(path, "([%w_]+)%.lua$")
    local real, other = "double", "float"
    if n % 2 == 1 then real, other = other, real end
    list[#list + 1] = widest({ name = name, real = real, where = dir .. "/" .. name .. "-all" }, path, ALL, "")
    if n % 10 == 2 then
      list[#list + 1] = widest({ name = name, real = other, where = dir .. "/" .. name .. "-baked" }, path, DERIVED,
        "--bake --with jacobians")
    end
    n = n + 1
  end
  pipe:close()
  return list
end

-- One project with options of its own.
function projects.one(dir, path, real, options)
  local name = string.match(path, "([%w_]+)%.lua$")
  options = options or ""
  program.shell("mkdir -p " .. dir)
  local p = { name = name, real = real, title = name .. ", " .. real .. " " .. options,
    where = string.format("%s/%s-%s", dir, name, real), own = string.find(options, "libm own", 1, true) ~= nil }
  p.own = p.own or real == "float" and not string.find(options, "libm system", 1, true)
  local done, why = emit(p, path, options)
  if not done then error(path .. ": " .. why) end
  return p
end

return projects
