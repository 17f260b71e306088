-- closed.lua -- which templates say a closed form: the order of the C, what stands first is used by what follows.
--
--     closed.texts(form) -> headers, sources      names of templates; form: see dynamics/closed/closed.lua
-- SPDX-License-Identifier: GPL-3.0-or-later

local closed = {}

local function names(room, text)
  local list = {}
  for name in string.gmatch(text, "%S+") do
    list[#list + 1] = "templates/" .. (string.find(name, "/", 1, true) and name or room .. "/" .. name)
  end
  return list
end

local function of(header, sources)
  return { header = "templates/orbit/" .. header, sources = names("orbit", sources) }
end

-- By the form's kind.
local TEXTS = {
  sphere = of("closed.h", "circle.c count.c quaternion.c closed.c"),
  symmetric = of("closed.h", "circle.c count.c numeric/quotient.c quaternion.c closed.c"),
  asymmetric = of("top.h", "circle.c numeric/double.c theta_at.c top.c polynomial.c circular.c hyperbolic.c " ..
    "quaternion.c setup.c many.c count.c tick.c query.c"),
  gyrostat = of("closed.h", "circle.c count.c numeric/quotient.c quaternion.c closed.c"),
  axial = of("axial.h", "circle.c numeric/quotient.c clock.c axial.c"),
  lagrange = of("lagrange.h", "circle.c numeric/double.c numeric/integral.c numeric/wide.c quaternion.c " ..
    "polynomial.c phase.c frame.c phases.c lagrange.c lagrange_theta.c lagrange_at.c states.c lagrange_solve.c " ..
    "count.c lagrange_tick.c"),
  ["asymmetric gyrostat"] = of("gyrostat.h", "circle.c numeric/double.c numeric/integral.c numeric/wide.c " ..
    "quaternion.c polynomial.c phase.c frame.c phases.c gyrostat.c gyrostat_at.c gyrostat_theta.c states.c " ..
    "gyrostat_solve.c count.c lagrange_tick.c"),
  point = of("point.h", "point.c"),
}

-- What counts time in ticks, or answers for the free motion alone.
local ONLY_FREE = {}
for _, name in ipairs(names("orbit", "count.c tick.c many.c query.c")) do ONLY_FREE[name] = true end

-- A free motion in another time: the clock stands before what asks for the time.
local function damped(free)
  local asks = { ["templates/orbit/theta_at.c"] = true, ["templates/orbit/closed.c"] = true }
  local list = {}
  for _, name in ipairs(TEXTS[free.kind].sources) do
    if asks[name] then
      if free.kind == "sphere" then list[#list + 1] = "templates/numeric/quotient.c" end
      list[#list + 1] = "templates/orbit/clock.c"
    end
    if not ONLY_FREE[name] then list[#list + 1] = name end
  end
  list[#list + 1] = "templates/orbit/damped.c"
  return { TEXTS[free.kind].header, "templates/orbit/damped.h" }, list
end

function closed.texts(form)
  if form.free then return damped(form.free) end
  local t = TEXTS[form.kind]
  return { t.header }, t.sources
end

return closed
