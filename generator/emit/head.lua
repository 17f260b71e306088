-- head.lua -- what header and source say of the scene before its functions: where it comes from, its states, inputs,
-- parameters, and the struct of its derived constants.
--
--     head.of(job, ctx, about) -> values for templates/core/scene.h and scene.c
--     about: {banner = lines, kept = the derived constants in the model, order, split_setup = bool: what else is in it}
-- SPDX-License-Identifier: GPL-3.0-or-later

local listing = require "generator.emit.listing"
local number = require "generator.emit.number"

local head = {}

-- The files that the scene came from with their hashes; a name must neither end nor begin a comment.
local function sources(job)
  local list = {}
  for i, f in ipairs(job.hashes or {}) do
    list[i] = { name = string.gsub(string.gsub(f.name, "%*/", "_/"), "/%*", "/_"), hash = f.hash }
  end
  return list
end

-- The parameters with their defaults; the number is that of p[], in SI units, with the unit once; what the scene
-- gives in a unit of another size stands behind it.
local function parameters(m)
  local list = {}
  for i, p in ipairs(m.params) do
    local tail = " " .. p.unit
    local given = string.sub(p.given, -#tail) == tail and string.sub(p.given, 1, -#tail - 1) or p.given
    local first = string.match(given, "^%S+")
    local scale = tonumber(first) and tonumber(first) ~= m:double(p.sym) -- of the unit that the scene gives it in
    list[i] = { name = p.name, unit = p.unit,
      about = "default " .. (scale and number.text(p.default, "double") or given),
      given = scale and ", " .. given .. " in the scene" or nil }
  end
  return list
end

-- The parameters' defaults as C.
function head.defaults(m, real)
  local list = {}
  for i, p in ipairs(m.params) do
    list[i] = { name = p.name, upper = string.upper(p.name), value = number.text(p.default, real) }
  end
  return list
end

function head.of(job, ctx, about)
  local m, upper = job.model, ctx.upper
  return { hashes = sources(job), hash = job.hash or "", has_hash = job.hash ~= nil, banner = about.banner,
    state_enum = listing.enumeration(upper, listing.told_apart(m, job.states), "NX"),
    input_enum = job.equations.inputs and listing.enumeration(upper, listing.described(m), "NU") or {},
    has_limits = listing.limited(m), param_enum = listing.enumeration(upper, parameters(m), "NP"),
    members = listing.members(about.kept, m.name .. "_real"), order = about.order, split_setup = about.split_setup,
    no_members = about.no_members, has_compensated = job.compensated or false }
end

return head
