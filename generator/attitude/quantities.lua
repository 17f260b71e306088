-- quantities.lua -- what can be said of a motion beyond its states: of a sample, in plain numbers.
--
-- One list, by which `polhode run` makes its columns and events of scenes know their words.  A sample is {t, q, w, r,
-- v, energy, L, base, contact, normal}: base(t) is the attitude of the frame that turns (effect.rotating_frame), a
-- quaternion; contact() gives N, the centre of mass, its velocity, the plane's force, the contact point and the slip,
-- vectors as three numbers; normal is the plane's.
-- SPDX-License-Identifier: GPL-3.0-or-later

local rotation = require "generator.attitude.rotation"

local quantities = {}

local xyz = { "x", "y", "z" }

local function part(kind) return function(s) return s[kind] end end

local function norm(v) return math.sqrt(v[1] * v[1] + v[2] * v[2] + v[3] * v[3]) end

-- {name, what it needs, unit, function -> a number or a list, endings of the columns' names (nil: one column), about =,
-- plain = no _ before the ending; length = what the name alone is in an expression: the length of the vector}.
quantities.list = {
  { "speed", { "w" }, "rad/s", function(s) return norm(s.w) end, about = "|w|" },
  { "omega_inertial", { "q", "w", "base" }, "rad/s", function(s)
    local w = rotation.apply(s.q, s.w)
    return s.base and rotation.apply(s.base(s.t), w) or w
  end, xyz, about = "w in inertial axes, also where a frame turns" },
  { "omega_frame", { "q", "w", "frame" }, "rad/s", function(s) return rotation.apply(s.q, s.w) end, xyz,
    about = "the same w in the axes of the frame that turns, of effect.rotating_frame" },
  { "L", { "L" }, "N m s", part "L", xyz, plain = true, about = "L in inertial axes" },
  { "L_body", { "q", "L" }, "N m s", function(s) return rotation.back(s.q, s.L) end, xyz, about = "L in body axes" },
  { "momentum", { "L" }, "N m s", function(s) return norm(s.L) end, about = "|L|" },
  { "tilt", { "q" }, "rad", function(s)
    local z = rotation.apply(s.q, { 0.0, 0.0, 1.0 })
    return math.atan(math.sqrt(z[1] * z[1] + z[2] * z[2]), z[3])
  end, about = "the angle between the body's z and inertial z" },
  { "N", { "contact" }, "N", function(s) return s.contact()[1] end, about = "the reaction of the plane" },
  { "height", { "contact" }, "m", function(s)
    local c, n = s.contact(), s.normal
    return c[2] * n[1] + c[3] * n[2] + c[4] * n[3]
  end, about = "that of the centre of mass above the plane" },
  { "com", { "contact" }, "m", function(s) return { table.unpack(s.contact(), 2, 4) } end, xyz,
    about = "the centre of mass on the plane, inertial axes" },
  { "com_velocity", { "contact" }, "m/s", function(s) return { table.unpack(s.contact(), 5, 7) } end, xyz,
    about = "its velocity" },
  { "contact_force", { "contact" }, "N", function(s) return { table.unpack(s.contact(), 8, 10) } end, xyz,
    about = "the force of the plane" },
  { "contact_point", { "contact" }, "m", function(s) return { table.unpack(s.contact(), 11, 13) } end, xyz,
    about = "where the body touches it" },
  { "slip", { "contact" }, "m/s", function(s) return { table.unpack(s.contact(), 14, 16) } end, xyz,
    length = "the speed of the contact point along the plane",
    about = "the velocity of the body there against the plane; in expressions its length" },
  { "axis", { "q" }, "1", function(s) return rotation.apply(s.q, { 0.0, 0.0, 1.0 }) end, xyz,
    about = "the body's z in inertial axes" },
  { "rotation_vector", { "q" }, "rad", function(s) return rotation.vector(s.q) end, xyz, about = "axis times angle" },
  { "matrix", { "q" }, "1", function(s)
    local R, list = rotation.matrix(s.q), {}
    for i = 1, 3 do
      for j = 1, 3 do list[#list + 1] = R[i][j] end
    end
    return list
  end, { "11", "12", "13", "21", "22", "23", "31", "32", "33" }, about = "rotation matrix, body to space" },
}

-- euler, which is euler_zxz, and the eleven others: three angles each.
local function euler(name, sequence)
  return { name, { "q" }, "rad", function(s) return (rotation.euler(s.q, sequence)) end, { "1", "2", "3" },
    about = "Euler angles " .. sequence }
end
quantities.list[#quantities.list + 1] = euler("euler", "zxz")
for _, sequence in ipairs(rotation.sequences) do
  quantities.list[#quantities.list + 1] = euler("euler_" .. sequence, sequence)
end

-- The words of the list, each with its unit and meaning: {name, unit, about, quantity, index of its component, or nil
-- for all of it: a number, or in an expression the length}.
function quantities.words()
  local list = {}
  for _, q in ipairs(quantities.list) do
    for k, ending in ipairs(q[5] or {}) do
      list[#list + 1] = { q[1] .. (q.plain and "" or "_") .. ending, q[3], q.about .. ", " .. ending, q, k }
    end
    if not q[5] or q.length then list[#list + 1] = { q[1], q[3], q.length or q.about, q } end
  end
  return list
end

-- The number of such a word for a sample.
function quantities.value(word, sample)
  local x = word[4][4](sample)
  if word[5] then return x[word[5]] end
  return type(x) == "table" and norm(x) or x
end

return quantities
