-- candidates.lua -- every way in which the emitted code of a scene can follow its motion.
--
-- A candidate is {name, method, order (of taylor), real, vector, setting, refused}: setting tells what chooses the
-- accuracy, "step" (a fixed step), "tolerance" (NAME_METHOD_run) or "none" (the closed form); refused: why the scene
-- does not admit it.  The name is the method's, then the order, then "tol" where a tolerance chooses the steps.
-- NAME_taylor_run lowers its order to what the tolerance asks for, so that one candidate "taylor 30 tol" would do for
-- all; a lower top makes the array of coefficients smaller.
-- SPDX-License-Identifier: GPL-3.0-or-later

local equations = require "generator.dynamics.equations"
local methods = require "generator.methods.methods"

local candidates = {}

candidates.orders = { 6, 8, 10, 12, 16, 20, 24, 30 } -- of Taylor series

local function set(names)
  local s = {}
  for _, n in ipairs(names) do s[n] = true end
  return s
end

-- Why the method cannot be had for the scene, or nil; orders of one method stand or fall together.
local function refusal(scene, name)
  if name == "exact" then
    local form = scene.closed
    return not form.kind and "no closed form: " .. form.refused or
      form.part and "the closed form " .. form.part or nil
  end
  local m = methods.by_name[name]
  local unfit = methods.refused(scene.equations, m)
  if unfit or not m.program then return unfit end
  local program, why = m.program(equations.fork(scene.equations), {})
  return not program and why or nil
end

-- The candidates of a scene that was read, not planned.  options: {methods = names (nil: all), orders = Taylor's (nil:
-- those above), real = "double" or "float" (nil: both), vector = also the variants for this host, mild = without
-- methods for stiff equations but those that `methods` names}.
function candidates.of(scene, options)
  options = options or {}
  local wanted, list = options.methods and set(options.methods), {}
  local function put(c, refused)
    c.refused, c.vector = refused, c.vector or false
    list[#list + 1] = c
  end
  local names = { "exact" }
  for _, m in ipairs(methods) do
    if not m.stiff or not options.mild or wanted then names[#names + 1] = m.name end
  end
  for _, name in ipairs(names) do
    local m = methods.by_name[name]
    local refused
    if not wanted or wanted[name] then refused = refusal(scene, name) end
    for _, real in ipairs(wanted and not wanted[name] and {} or options.real and { options.real } or
      { "double", "float" }) do
      local function both(label, order, vector) -- by a fixed step, and by a tolerance where there is a choice
        if vector then label = label .. " vector" end
        put({ name = label, method = name, order = order, real = real, setting = "step", vector = vector }, refused)
        if m.adaptive then
          put({ name = label .. " tol", method = name, order = order, real = real, setting = "tolerance",
            vector = vector }, refused)
        end
      end
      if name == "exact" then
        put({ name = name, method = name, real = real, setting = "none" }, refused)
      elseif m.orders then
        for _, order in ipairs(options.orders or candidates.orders) do
          both(name .. " " .. order, order)
          if options.vector then both(name .. " " .. order, order, true) end
        end
      else
        both(name)
      end
    end
  end
  return list
end

return candidates
