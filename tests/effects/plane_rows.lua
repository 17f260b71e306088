-- plane_rows.lua -- the motions of tests/reference/plane.h as scenes that a user would write, and how far a run is off.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     plane_rows.cases            lists of rows, one list for each motion; row[1] its name, row[10] the time
--     plane_rows.scene(row)       the scene
--     plane_rows.run(command, dir, case, options)
--                                 `command run` with these options: a list, for each row how far it is off: {q =, w =,
--                                 com =, v =, N =}, w and N relative; or nil and what it said
--     plane_rows.moved(row)       by the same names, what half a unit of a double in each input moves

local program = require "tests.cli.program"

local plane_rows = {}

-- The rows of the header, as tables: C's braces are Lua's.
local LAWS = { PH_ROLLING = "rolling", PH_SMOOTH = "smooth", PH_VISCOUS = "sliding", PH_COULOMB = "sliding" }
local text = program.read "tests/reference/plane.h":match "plane_rows%[%] = {\n(.*)\n};"
text = text:gsub("%.(%a[%w_]* =)", "%1"):gsub("(%d)L%f[%W]", "%1"):gsub("PH_%u+", function(law)
  return '"' .. law .. '"'
end)
local rows = assert(load("return {" .. text .. "}"))()

local function list(v)
  local out = {}
  for i, x in ipairs(v) do out[i] = string.format("%.17g", x) end
  return "{ " .. table.concat(out, ", ") .. " }"
end

local function surface(p)
  local at = ", at = " .. list(p.centre)
  if p.half_axes[1] == 0 then return string.format("contact.sphere { r = %.17g%s }", p.rim, at) end
  if p.half_axes[3] == 0 then
    return string.format("contact.disc { r = %.17g, edge = %.17g%s }", p.half_axes[1], p.rim, at)
  end
  return string.format("contact.ellipsoid { a = %.17g, b = %.17g, c = %.17g%s, turned = { quaternion = %s } }",
    p.half_axes[1], p.half_axes[2], p.half_axes[3], at, list(p.axes))
end

-- What v has along the plane: the rest follows from attitude and rates, and a scene may not say otherwise.
local function along(p, v)
  local n, above, square = p.normal, 0, 0
  for i = 1, 3 do above, square = above + n[i] * v[i], square + n[i] * n[i] end
  local out = {}
  for i = 1, 3 do out[i] = v[i] - above / square * n[i] end
  return out
end

function plane_rows.scene(row)
  local I, p = row[3], row[4]
  local law = LAWS[p.law]
  local friction = p.law == "PH_VISCOUS" and string.format(", friction = { viscous = %.17g }", p.friction) or
    p.law == "PH_COULOMB" and string.format(", friction = { coulomb = %.17g, smoothing = %.17g }", p.friction,
      p.smoothing) or ""
  local turns = p.rate ~= 0 and string.format(", turntable = %.17g", p.rate) or ""
  local damped = row[9] ~= 0 and string.format(", effect.damping { c = %.17g }", row[9]) or ""
  return string.format([[
return scene { name = "body",
  body = tensor { mass = %.17g, xx = %.17g, yy = %.17g, zz = %.17g, xy = %.17g, xz = %.17g, yz = %.17g },
  effects = { effect.plane { surface = %s, law = "%s"%s, normal = %s%s, gravity = %s }%s },
  initial = { omega = %s, attitude = %s, position = %s%s }, time = { step = 0.0005 } }
]], row[2], I[1], I[2], I[3], I[4], I[5], I[6], surface(p), law, friction, list(p.normal), turns, list(p.gravity),
    damped, list(row[6]), list(row[5]), list(along(p, row[7])),
    law ~= "rolling" and ", velocity = " .. list(along(p, row[8])) or "")
end

local function largest(a, b, sign)
  local d = 0
  for i = 1, #b do d = math.max(d, math.abs((sign or 1) * a[i] - b[i])) end
  return d
end

local cases = {}
for _, row in ipairs(rows) do
  local last = cases[#cases]
  if not last or last[1][1] ~= row[1] then
    last = {}
    cases[#cases + 1] = last
  end
  last[#last + 1] = row
end

plane_rows.rows, plane_rows.cases = rows, cases

function plane_rows.moved(row) return { q = row[16], w = row[17], com = row[18], v = row[19], N = row[20] } end

-- How far the numbers of a run are from the row's.
local function off(row, x)
  local q, w, com, v = row[11], row[12], row[13], row[14]
  local sign = x[1] * q[1] + x[2] * q[2] + x[3] * q[3] + x[4] * q[4] < 0 and -1 or 1
  local rate = math.sqrt(w[1] ^ 2 + w[2] ^ 2 + w[3] ^ 2)
  return { q = largest(x, q, sign), w = largest({ x[5], x[6], x[7] }, w) / rate,
    com = largest({ x[8], x[9], x[10] }, com), v = largest({ x[11], x[12], x[13] }, v),
    N = math.abs(x[14] / row[15] - 1) }
end

function plane_rows.run(command, dir, case, options)
  local times, found = {}, {}
  for i, row in ipairs(case) do times[i] = string.format("%.17g", row[10]) end
  program.write(dir .. "/body.lua", plane_rows.scene(case[1]))
  local code = program.shell(string.format("%s run %s/body.lua %s --columns q,w,com,com_velocity,N --at %s " ..
    "-o %s/out.csv 2>%s/said", command, dir, options, table.concat(times, ","), dir, dir))
  if code ~= 0 then return nil, program.read(dir .. "/said") end
  for line in program.read(dir .. "/out.csv"):gmatch "[^\n]+" do
    local x = {}
    for word in line:gmatch "[^,]+" do x[#x + 1] = tonumber(word) end
    if #x == 14 and case[#found + 1] then found[#found + 1] = off(case[#found + 1], x) end
  end
  if #found < #case then return nil, #found .. " rows of " .. #case end
  return found
end

-- The largest off/bar of what `run` gave, infinite for a NaN; bar(moved): what is allowed where the inputs move it so
-- far.
function plane_rows.worst(case, found, bar)
  local worst = 0.0
  for i, row in ipairs(case) do
    local moved = plane_rows.moved(row)
    for _, key in ipairs { "q", "w", "com", "v", "N" } do
      local ratio = found[i][key] / bar(moved[key], row)
      worst = ratio <= worst and worst or ratio == ratio and ratio or math.huge
    end
  end
  return worst
end

return plane_rows
