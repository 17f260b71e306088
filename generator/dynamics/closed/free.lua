-- free.lua -- what the closed forms of torque-free motion share.
-- SPDX-License-Identifier: GPL-3.0-or-later

local later = require "generator.later"

local free = {}

local forms = { later "generator.dynamics.closed.sphere", later "generator.dynamics.closed.symmetric",
  later "generator.dynamics.closed.asymmetric" }

-- The form of the same body without effects; nil and why not.
function free.top(m)
  local form, reason
  for _, f in ipairs(forms) do
    if not form then form, reason = f.detect(m, { free = true }) end
  end
  return form, reason
end

-- nil for a scene without effects, else why the motion is not free.
function free.acts(m, eq)
  if not m.has.attitude then return "it carries the attitude, which this scene has not" end
  if eq.free then return nil end
  local names, seen = {}, {}
  for _, e in ipairs(m.record.effects) do
    local name = string.gsub(e.kind, "effect%.", "")
    if not seen[name] then names[#names + 1] = name end
    seen[name] = true
  end
  local acts = #names == 1 and " acts" or " act"
  return "the motion is not free: " .. table.concat(names, ", ") .. acts .. " on the body"
end

return free
