-- rows.lua - what the tests know of each effect.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     rows.variants    all ways to write it: { effect, name, where, text(S) }, S a source of numbers, scenes.lua
--     rows.strengths   by its name: how it is written with its strength and with none, see below
--     rows.customs     { it, what says the same as effect.custom }
--     rows.known       { about =, scene =, t =, want = { column = number } }: motions known in closed form, of a ball
--                      of moment 2 kg m^2
--
-- where: "point": about a fixed point; "flight": the body moves; "centroid": about the centroid, moving or not;
-- "plane": the body touches a plane; nil: any of them.

local rows = {}

local V = {}
local function put(effect, name, where, text)
  V[#V + 1] = { effect = effect, name = name, where = where, text = text }
end

put("gravity", "gravity", "point", function(s) return "g = " .. s:num(0.5, 2, "m/s^2") end)
put("gravity", "gravity_direction", "point", function(s)
  return "g = " .. s:num(0.5, 2, "m/s^2") .. ", direction = " .. s:vec(1, nil, "polar")
end)
put("damping", "damping", nil, function(s) return "c = " .. s:num(0.05, 0.3, "N m s") end)
put("damping", "damping_principal", nil, function(s) return "c = " .. s:vec(0.2, "N m s") end)
put("damping", "damping_matrix", nil, function(s)
  return "c = {" .. s:vec(0.2, "N m s") .. ", " .. s:vec(0.2, "N m s") .. ", " .. s:vec(0.2, "N m s") .. "}"
end)
put("damping", "damping_rate", nil, function(s) return "rate = " .. s:num(0.05, 0.3, "1/s") end)
put("damping", "damping_of_motion", nil, function(s)
  return "c = " .. s:num(0.05, 0.3, "N m s") .. "*(2 + tanh(2*wz)*cos(t))"
end)
put("torque", "torque_body", nil, function(s) return "body = " .. s:vec(0.5, "N m", "axial") end)
put("torque", "torque_inertial", nil, function(s) return "inertial = " .. s:vec(0.5, "N m", "axial") end)
put("torque", "torque_moving", nil, function(s)
  return "body = {" .. s:num(0.1, 0.5, "N m") .. "*sin(2*t), " .. s:num(0.1, 0.3, "N m") .. "*qx, -0.1*wz}"
end)
put("torque", "torque_table", nil, function(s)
  return "inertial = {0, {{0, 0}, {2, " .. s:num(0.1, 0.5, "N m") .. "}, {6, 0}}, 0.1}"
end)
put("control", "control", nil, function() return "" end)
put("control", "control_limited", nil, function(s) return "max = " .. s:num(0.2, 0.5, "N m") end)
put("rotor", "rotor", nil, function(s)
  return "axis = " .. s:vec(1, nil, "axial") .. ", momentum = " .. s:num(0.2, 0.6, "N m s")
end)
put("rotor", "rotor_fast", nil, function(s) -- its momentum is all there is
  return "axis = " .. s:vec(1, nil, "axial") .. ", momentum = " .. s:num(200, 600, "N m s")
end)
put("translation", "flight", "flight", function(s) return "gravity = " .. s:vec(2, "m/s^2", "polar") end)
put("translation", "flight_drag", "flight", function(s)
  return "gravity = " .. s:num(0.5, 2, "m/s^2") .. ", drag = " .. s:num(0.05, 0.2, "kg/m") .. ", linear = " ..
    s:num(0.05, 0.2, "kg/s") .. ", stiffness = " .. s:num(0.5, 2, "N/m")
end)
put("translation", "flight_force", "flight", function(s)
  return "gravity = 0, force = " .. s:vec(0.5, "N", "polar") ..
    ", thrust = {" .. s:num(0.1, 0.5, "N") .. ", 0, 0.1*cos(t)}"
end)
put("translation", "flight_rates", "flight", function(s)
  return "gravity = 0, thrust = {" .. s:num(0.1, 0.5, "N") .. "*tanh(2*wz), 0, 0}"
end)
put("drag", "drag", nil, function(s) return "c = " .. s:num(0.05, 0.2, "kg m^2") end)
put("friction", "friction", nil, function(s)
  return "torque = " .. s:num(0.1, 0.4, "N m") .. ", smoothing = " .. s:num(0.1, 0.3, "rad/s")
end)
put("spring", "spring", nil, function(s) return "stiffness = " .. s:num(0.2, 1, "N m") end)
put("spring", "spring_rest", nil, function(s)
  return "stiffness = {" .. s:num(0.1, 0.5, "N m") .. ", " .. s:num(0.1, 0.5, "N m") .. ", 0.2}, rest = {1, 1, 0, " ..
    s:num(0.2, 0.8) .. "}"
end)
put("spring", "spring_axis", nil, function(s)
  return "stiffness = " .. s:num(0.2, 1, "N m") .. ", axis = " .. s:vec(1, nil, "axial") .. ", rest = " .. s:num(0.1, 1)
end)
put("magnetic", "magnetic", nil, function(s)
  return "moment = " .. s:vec(1, "A m^2", "axial") .. ", field = " .. s:vec(0.3, "T", "axial")
end)
put("magnetic", "magnetic_rotating", nil, function(s)
  return "moment = " .. s:vec(1, "A m^2") .. ", rotating = " .. s:vec(0.3, "T") .. ", rate = " .. s:num(0.5, 2, "rad/s")
end)
put("eddy_current", "eddy", nil, function(s)
  return "k = " .. s:num(0.5, 2, "N m s/T^2") .. ", field = " .. s:vec(0.5, "T", "axial")
end)
put("eddy_current", "eddy_upright", nil, function(s)
  return "k = " .. s:num(0.5, 2, "N m s/T^2") .. ", field = {0, 0, " .. s:num(0.2, 0.5, "T") .. "}"
end)
for _, included in ipairs { "true", "false" } do
  put("wheel", "wheel_" .. included, nil, function(s)
    return "axis = " .. s:vec(1, nil, "axial") .. ", inertia = " .. s:num(0.02, 0.08, "kg m^2") .. ", speed = " ..
      s:num(2, 6, "rad/s") .. ", torque = " .. s:num(0.05, 0.2, "N m") .. "*sin(t), included = " .. included
  end)
  put("wheel", "wheel_free_" .. included, nil, function(s)
    return "axis = {0, 0, 1}, inertia = " .. s:num(0.02, 0.08, "kg m^2") .. ", speed = " .. s:num(2, 6, "rad/s") ..
      ", included = " .. included
  end)
end
put("gravity_gradient", "circular", "centroid", function(s)
  return "mu = " .. s:num(0.2, 0.4, "m^3/s^2") .. ", orbit = { radius = " .. s:num(0.8, 1, "m") .. " }"
end)
put("gravity_gradient", "elliptic", "centroid", function(s)
  return "mu = " .. s:num(0.2, 0.4, "m^3/s^2") .. ", orbit = { a = " .. s:num(0.8, 1, "m") .. ", e = " ..
    s:num(0.1, 0.4) .. ", anomaly = 0.5 }"
end)
put("solar_pressure", "sunlight", nil, function(s)
  return "flux = " .. s:num(1e8, 3e8, "W/m^2") .. ", sun = " .. s:vec(1) .. ", plates = { { area = " ..
    s:num(0.5, 2, "m^2") .. ", normal = " .. s:vec(1) .. ", centre = " .. s:vec(1, "m") ..
    ", reflectivity = 0.4 }, { area = 1, normal = {0, 1, -1}, centre = {0.3, 0, 0} } }"
end)
put("pivot", "pivot", "point", function(s)
  return "acceleration = {" .. s:num(0.5, 2, "m/s^2") .. "*sin(3*t), t/8, -0.5}"
end)
put("pivot", "pivot_vibrates", "point", function(s)
  return "amplitude = " .. s:num(0.02, 0.1, "m") .. ", rate = " .. s:num(2, 5, "rad/s") ..
    ", axis = " .. s:vec(1, nil, "polar")
end)
put("inertia_rate", "parts_diagonal", nil, function(s)
  return "xx = " .. s:num(0.05, 0.3, "kg m^2") .. "*sin(t)^2, zz = " .. s:num(0.05, 0.2, "kg m^2") .. "*cos(t)"
end)
put("inertia_rate", "parts", nil, function(s)
  return "xx = " .. s:num(0.05, 0.3, "kg m^2") .. "*sin(t)^2, xy = " .. s:num(0.02, 0.1, "kg m^2") .. "*cos(2*t)"
end)
put("dissipation", "sink", nil, function(s) return "k = " .. s:num(0.005, 0.03, "s/kg/m^2") end)
put("custom", "custom_torque", nil, function(s)
  return "params = { slope = " .. s:num(0.1, 0.3, "N m s") ..
    " }, torque = function(s) return { -s.slope*s.w[2], s.slope*s.w[1], -0.05*s.L[3] } end"
end)
put("custom", "custom_potential", nil, function(s)
  return "params = { stiff = " .. s:num(0.1, 0.5, "N m") .. " }, potential = function(s) return s.stiff*(s.q[2]^2 + " ..
    "s.q[1]*s.q[4]) end"
end)
put("custom", "custom_state", nil, function(s)
  return "params = { stiff = " .. s:num(0.1, 0.5, "N m") .. " }, torque = function(s) return " ..
    "{ s.stiff*s.phi, 0, 0 } end, states = { phi = { initial = 1, unit = \"rad\", " ..
    "rate = function(s) return s.w[1] - quantity(1, \"1/s\")*s.phi end } }"
end)
put("rotating_frame", "frame", nil, function(s) return "rate = " .. s:vec(0.5, "rad/s", "axial") end)
put("rotating_frame", "frame_upright", nil, function(s)
  return "rate = {0, 0, " .. s:num(0.1, 0.5, "rad/s") .. "}"
end)
put("rotating_frame", "frame_changing", nil, function(s)
  return "rate = " .. s:vec(0.5, "rad/s", "axial") .. ", rate_dot = " .. s:vec(0.05, "rad/s^2", "axial") ..
    ", centrifugal = false"
end)

-- On a plane: every surface with every law, and so that each surface and each law has every kind of resistance, a
-- tilted normal and a turntable.  The bodies' rates of about 1 rad/s are slow beside sqrt(g/radius): contact is kept.
local surfaces = {
  { "sphere", function(s)
    return "sphere { r = " .. s:num(1.8, 2.2, "m") .. ", at = " .. s:vec(0.2, "m", "polar") .. " }"
  end },
  { "centred", function(s) return "sphere { r = " .. s:num(1.8, 2.2, "m") .. " }" end },
  { "ellipsoid", function(s)
    return "ellipsoid { a = " .. s:num(1.9, 2.1, "m") .. ", b = " .. s:num(2.2, 2.4, "m") .. ", c = 2.2, at = " ..
      s:vec(0.1, "m", "polar") .. ", turned = { quaternion = {1, " .. string.sub(s:vec(0.5, nil, "axial"), 2) .. " } }"
  end },
  { "disc", function(s)
    return "disc { r = " .. s:num(1.8, 2.2, "m") .. ", edge = " .. s:num(0.2, 0.3, "m") .. " }"
  end },
  { "paraboloid", function(s)
    return "paraboloid { a = " .. s:num(2.4, 3, "m") .. ", b = " .. s:num(2, 2.4, "m") ..
      ", at = {0, 0, -1.5}, turned = { axis = {0, 0, 1}, angle = 0.4 } }"
  end },
  { "support", function(s)
    return "support { h = function(n) return " .. s:num(1.8, 2.2, "m") .. "*(1 + 0.025*n[3]*(n[3]^2 - 3*n[1]^2)) end }"
  end },
}
local contacts = {
  { "rolling", function() return "law = \"rolling\"" end },
  { "smooth", function() return "law = \"smooth\"" end },
  { "viscous", function(s) return "law = \"sliding\", friction = { viscous = " .. s:num(0.1, 0.4, "s/m") .. " }" end },
  { "coulomb", function(s)
    return "law = \"sliding\", friction = { coulomb = " .. s:num(0.1, 0.4) .. ", smoothing = " ..
      s:num(0.1, 0.3, "m/s") .. " }"
  end },
}
local function resistance(s, k)
  if k == 1 then return "{ viscous = " .. s:num(0.01, 0.05, "m s") .. " }" end
  return "{ coulomb = " .. s:num(0.01, 0.05, "m") .. ", smoothing = " .. s:num(0.1, 0.3, "rad/s") .. " }"
end
for i, surface in ipairs(surfaces) do
  for k, contact in ipairs(contacts) do
    local spins, rolls, smooth = (i + k) % 3, (i + 2*k) % 3, contact[1] == "smooth"
    put("plane", "on_" .. surface[1] .. "_" .. contact[1], "plane", function(s)
      local text = "surface = contact." .. surface[2](s) .. ", " .. contact[2](s)
      if not smooth and spins > 0 then text = text .. ", spinning = " .. resistance(s, spins) end
      if not smooth and rolls > 0 then text = text .. ", rolling_resistance = " .. resistance(s, rolls) end
      if (i + k // 2) % 2 == 0 then text = text .. ", normal = " .. s:axes("0.1", "-0.2", "1", "polar") end
      if not smooth and (i + k // 3) % 2 == 0 then -- about the normal: in a mirror it turns the other way round
        text = text .. ", turntable = " .. (s.mirrored and "-" or "") .. s:num(0.2, 0.6, "rad/s")
      end
      return text
    end)
  end
end
rows.variants = V

-- full: with its strength; zero: with none, also: the other ways to say so; absent: what zero is the same as, if not
-- nothing; why: it has no zero.
-- alone: it stands beside few of the others.
-- place: "corner", the body must turn about its corner; "centroid", about its centroid; "moves": it flies.
rows.strengths = {
  gravity = { full = "effect.gravity { g = strength }", zero = "effect.gravity { g = 0 }", place = "corner" },
  damping = { full = "effect.damping { c = {{strength, 1, 0}, {1, 2, 0}, {0, 0, 3}} }",
    zero = "effect.damping { c = 0 }" },
  torque = { full = "effect.torque { inertial = {strength, 2, 3} }", zero = "effect.torque { inertial = {0, 0, 0} }",
    also = { "effect.torque { body = {0, 0*t, {{0, 0}, {1, 0}}} }" } },
  control = { full = "effect.control {}", why = "its input is the user's" },
  rotor = { full = "effect.rotor { axis = {0, 0, 1}, momentum = strength }",
    zero = "effect.rotor { axis = {0, 0, 1}, momentum = 0 }" },
  translation = { full = "effect.translation { gravity = {0, strength, -9}, drag = strength }", place = "moves",
    zero = "effect.translation { gravity = {0, 0, 0}, drag = 0, linear = 0, stiffness = 0 }",
    absent = "effect.translation { gravity = 0 }" },
  rotating_frame = { full = "effect.rotating_frame { rate = {0, strength, 1} }", place = "moves",
    zero = "effect.rotating_frame { rate = {0, 0, 0} }" },
  drag = { full = "effect.drag { c = strength }", zero = "effect.drag { c = 0 }" },
  friction = { full = "effect.friction { torque = strength, smoothing = 1 }",
    zero = "effect.friction { torque = 0, smoothing = 1 }" },
  spring = { full = "effect.spring { stiffness = strength, axis = {0, 3, 4}, rest = 1 }",
    zero = "effect.spring { stiffness = 0, axis = {0, 3, 4}, rest = 1 }",
    also = { "effect.spring { stiffness = {0, 0, 0} }" } },
  gravity_gradient = { full = "effect.gravity_gradient { mu = strength, orbit = { radius = 7 } }", place = "centroid",
    zero = "effect.gravity_gradient { mu = 0, orbit = { a = 7, e = 1/2 } }",
    also = { "effect.gravity_gradient { mu = 0, orbit = { radius = 7 } }" } },
  magnetic = { full = "effect.magnetic { moment = {strength, 0, 1}, rotating = {1, 0, 2}, rate = 3 }",
    zero = "effect.magnetic { moment = {0, 0, 0}, rotating = {1, 0, 2}, rate = 3 }",
    also = { "effect.magnetic { moment = {0, 1, 0}, rotating = {0, 0, 0}, rate = 3 }",
      "effect.magnetic { moment = {0, 0, 0}, field = {0, 0, 1} }" } },
  solar_pressure = { full = "effect.solar_pressure { sun = {1, 2, 3}, plates = { { area = strength, " ..
    "normal = {0, 3, 4}, centre = {0, 1, 0}, reflectivity = 1/2 } } }",
    zero = "effect.solar_pressure { sun = {1, 2, 3}, flux = 0, plates = { { area = 1, normal = {0, 3, 4}, " ..
      "centre = {0, 1, 0} } } }",
    also = { "effect.solar_pressure { sun = {1, 2, 3}, plates = { { area = 0, normal = {0, 3, 4}, " ..
      "centre = {0, 1, 0}, reflectivity = 1/2 } } }" } },
  plane = { full = "effect.plane { surface = contact.sphere { r = 9 }, law = \"rolling\", " ..
    "spinning = { viscous = strength } }", place = "centroid", alone = true,
    why = "the body touches it, whatever its strength" },
  wheel = { full = "effect.wheel { axis = {0, 3, 4}, inertia = strength, torque = 1, included = false }",
    why = "its speed is a state" },
  eddy_current = { full = "effect.eddy_current { k = strength, field = {0, 1, 2} }",
    zero = "effect.eddy_current { k = 0, field = {0, 1, 2} }",
    also = { "effect.eddy_current { k = 1, field = {0, 0, 0} }" } },
  dissipation = { full = "effect.dissipation { k = strength }", zero = "effect.dissipation { k = 0 }" },
  inertia_rate = { full = "effect.inertia_rate { xx = quantity(2, \"kg m^2\")*(2 + cos(quantity(2, \"rad/s\")*t)) }",
    zero = "effect.inertia_rate { xx = 0 }",
    also = { "effect.inertia_rate {}", "effect.inertia_rate { xx = 0, yz = 0*t }" } },
  pivot = { full = "effect.pivot { amplitude = strength, rate = 20 }", place = "corner",
    zero = "effect.pivot { amplitude = 0, rate = 20 }",
    also = { "effect.pivot { acceleration = { 0*t, 0, 0 } }" } },
  custom = { full = "effect.custom { params = { rub = strength }, torque = function(s) return " ..
    "{ -s.rub*s.w[1], 0, 0 } end }",
    zero = "effect.custom { torque = function(s) return { 0*s.w[1], 0, s.t - s.t } end }",
    also = { "effect.custom { params = {stiff = 0}, potential = function(s) return s.stiff*s.q[2]^2 end }" } },
}

rows.customs = {
  { "effect.damping { c = {0.1, 0.2, 0.3} }",
    "effect.custom { torque = function(s) return { quantity(-0.1, \"N m s\")*s.w[1], " ..
      "quantity(-0.2, \"N m s\")*s.w[2], quantity(-0.3, \"N m s\")*s.w[3] } end }" },
  { "effect.magnetic { moment = {0, 0, 0.5}, field = {0, 0, 0.4} }",
    "effect.custom { potential = function(s) return quantity(-0.2, \"N m\")*(s.q[1]^2 - s.q[2]^2 - s.q[3]^2 + " ..
      "s.q[4]^2) end }" },
  { "effect.eddy_current { k = 0.5, field = {0, 0, 0.6} }", -- k B^2 (w - (w.n) n), n = R^T e_z
    "effect.custom { torque = function(s) local q, c = s.q, quantity(-0.18, \"N m s\") " ..
      "local n = { 2*(q[2]*q[4] - q[1]*q[3]), 2*(q[3]*q[4] + q[1]*q[2]), q[1]^2 - q[2]^2 - q[3]^2 + q[4]^2 } " ..
      "local along = s.w[1]*n[1] + s.w[2]*n[2] + s.w[3]*n[3] return { c*(s.w[1] - along*n[1]), " ..
      "c*(s.w[2] - along*n[2]), c*(s.w[3] - along*n[3]) } end }" },
  { "effect.damping { rate = 0.2 }",
    "effect.custom { torque = function(s) return { quantity(-0.2, \"1/s\")*s.L[1], " ..
      "quantity(-0.2, \"1/s\")*s.L[2], quantity(-0.2, \"1/s\")*s.L[3] } end }" },
}

local function ball(effects, omega)
  return "return scene { name = \"ball\", body = solid.sphere { r = 1, mass = 5 }, origin = \"centroid\", " ..
    "effects = { " .. effects .. " }, initial = { omega = " .. omega .. " }, time = { step = 0.01 } }"
end

rows.known = {
  -- 2 w' = -w^2/2
  { about = "drag: w = w0/(1 + c w0 t/I)", scene = ball("effect.drag { c = 0.5 }", "{3, 0, 0}"), t = 2,
    want = { wx = 3/(1 + 0.5*3*2/2), wy = 0, Lx = 2*1.2 } },
  -- I w' = -k B^2 (w - (w.n) n), n = (0.6, 0, 0.8): along n w0 has (1.8, 0, 2.4), across it (-0.8, -2, 0.6)
  { about = "eddy currents: w across the field falls as exp(-k B^2 t/I)", t = 2,
    scene = ball("effect.eddy_current { k = 0.5, field = {0.6, 0, 0.8} }", "{1, -2, 3}"),
    want = { Lx = 2*(1.8 - 0.8*math.exp(-0.5)), Ly = 2*-2*math.exp(-0.5), Lz = 2*(2.4 + 0.6*math.exp(-0.5)),
      energy = 9 + 5*math.exp(-1) } },
}

return rows
