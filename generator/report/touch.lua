-- touch.lua -- of a body on a plane: integrals at the start, closed forms of balls, steady rolling, critical speeds.
--
-- G is the gravity.  Derived by linearising about the upright spin n, with
-- alpha the horizontal part of the axis, h the height of the centre of mass and rho the surface's radius of curvature
-- under it, i the quarter turn about the vertical, C = m G (h - rho):
--     smooth    I1 alpha'' - i I3 n alpha' - C alpha = 0                             stable for (I3 n)^2 > 4 I1 C
--     rolling   A alpha'' - i B n alpha' - C alpha = 0, A = I1 + m h^2, B = I3 + m h rho            (B n)^2 > 4 A C
--     sliding   friction F = -c N slip leaves a vibration mu alone only where it does not slip, h mu = rho n; it damps
--               both where this lies between the two of the smooth plane:     D n^2 > C, D = (I3 - I1 rho/h) rho/h
-- and of a disc of centre circle R and rounding rho, h = R + rho, with lean delta:
--     rolling straight at w3    (I1 + m h^2) delta'' = (m G R - (I3 + m h^2)(I3/I1) w3^2) delta
--     spinning at n on its edge (I1 + m h^2) delta'' = (m G R - (I1 + m h^2) n^2) delta
-- (Routh, Advanced Rigid Dynamics, 241-244; Moffatt, Shimomura, Branicki 2004 for the sliding one; O'Reilly 1996.)
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local vec = require "generator.algebra.vec"
local contact = require "generator.dynamics.contact"
local state = require "generator.dynamics.state"
local touch_laws = require "generator.dynamics.touch_laws"

local touch = {}

local function integrals(m, put)
  local start = { [state.t] = expr.zero }
  for _, s in ipairs(m.states) do start[s.sym] = s.initial end
  for _, law in ipairs(touch_laws.of(m)) do
    put(law.key, law.what, law.formula, law.latex, m:double(calculus.substitute(law.e, start)), law.unit)
  end
end

-- Heights of the centre of mass and radii of curvature when z is up and when it is down; nil where there is no contact.
local function ends(m, f)
  local s, c = f.surface, m:double(f.centre[3])
  if s.paraboloid then return { -c, m:double(s.half[1]) }, nil end
  local rho = m:double(s.rim)
  if f.sphere then return { rho - c, rho }, { rho + c, rho } end
  local a, b = m:double(s.half[1]), m:double(s.half[3])
  if b == 0 then return nil, nil end
  return { b - c, a * a / b }, { b + c, a * a / b }
end

-- What the rate of an upright spin must be: its least or greatest one, 0 where any will do.
local function upright(put, law, where, I1, I3, mass, G, h, rho)
  local key, C = "upright_z_" .. where, mass * G * (h - rho)
  local function row(name, what, formula, latex, number)
    put(key .. "_" .. name, "spinning upright with z " .. where .. ": " .. what, formula, latex, number, "rad/s")
  end
  local always = "stable at every rate"
  if law == "smooth" then
    row("above", C > 0 and "stable above this rate" or always, "2 sqrt(I1 m G (h - rho))/I3",
      "2\\sqrt{I_1mG(h - \\varrho)}/I_3", C > 0 and 2 * math.sqrt(I1 * C) / I3 or 0.0)
  elseif law == "rolling" then
    row("above", C > 0 and "stable above this rate" or always,
      "2 sqrt((I1 + m h^2) m G (h - rho))/(I3 + m h rho)",
      "2\\sqrt{(I_1 + mh^2)mG(h - \\varrho)}/(I_3 + mh\\varrho)",
      C > 0 and 2 * math.sqrt((I1 + mass * h * h) * C) / (I3 + mass * h * rho) or 0.0)
  else
    local D = (I3 - I1 * rho / h) * rho / h
    local formula, latex = "sqrt(m G (h - rho) h/(rho (I3 - I1 rho/h)))",
      "\\sqrt{mG(h - \\varrho)h/(\\varrho(I_3 - I_1\\varrho/h))}"
    if D > 0 then
      row("above", C > 0 and "friction damps it above this rate" or "friction damps it at every rate", formula, latex,
        C > 0 and math.sqrt(C / D) or 0.0)
    elseif C < 0 and D < 0 then
      row("below", "friction damps it below this rate, and turns it over above", formula, latex, math.sqrt(C / D))
    else
      row("below", "friction turns it over at every rate", formula, latex, 0.0)
    end
  end
end

local function disc(m, f, put, I1, I3, mass, G)
  local R, rho = m:double(f.surface.half[1]), m:double(f.surface.rim)
  local h = R + rho
  put("rolling_straight_above", "upright and rolling straight: stable above this w3",
    "sqrt(m G R I1/(I3 (I3 + m (R + rho)^2)))", "\\sqrt{mGRI_1/(I_3(I_3 + m(R + \\varrho)^2))}",
    math.sqrt(mass * G * R * I1 / (I3 * (I3 + mass * h * h))), "rad/s")
  put("spinning_on_edge_above", "upright and spinning about the normal: stable above this rate",
    "sqrt(m G R/(I1 + m (R + rho)^2))", "\\sqrt{mGR/(I_1 + m(R + \\varrho)^2)}",
    math.sqrt(mass * G * R / (I1 + mass * h * h)), "rad/s")
  if rho ~= 0 then return end
  -- steady: (I3 + m R^2) w3 p s - I1 p^2 s c + m G R c = 0 for the precession p, cosine c and sine s of the axis
  local q = vec.map(m.attitude, function(e) return m:double(e) end)
  local n = vec.map(contact.of(m).a.normal, function(e) return m:double(e) end)
  local c = vec.matvec(vec.transpose(vec.rotation(q)), n)[3] / math.sqrt(vec.dot(q, q)) ^ 2
  local s, w3 = math.sqrt(math.max(0.0, 1 - c * c)), m:double(m.omega[3])
  local A, B, D = I1 * s * c, (I3 + mass * R * R) * w3 * s, mass * G * R * c
  local roots = {}
  if A ~= 0 and B * B + 4 * A * D >= 0 then
    local far = (B + (B < 0 and -1 or 1) * math.sqrt(B * B + 4 * A * D)) / (2 * A)
    roots = { far, far ~= 0 and -D / A / far or nil }
  end
  for i, p in ipairs(roots) do
    put("steady_precession_" .. string.format("%d", i), "about the normal, for this tilt and w3",
      "I1 p^2 s c - (I3 + m R^2) w3 p s = m G R c", "I_1p^2sc - (I_3 + mR^2)\\omega_3ps = mGRc", p, "rad/s")
  end
end

local function ball(m, f, put, a, mass, G)
  local J, R, rate = m:double(f.I1), m:double(f.surface.rim), m:double(a.rate)
  local k = J / (J + mass * R * R)
  local n = vec.map(a.normal, function(e) return m:double(e) end)
  local along = vec.sub(G, vec.scale(vec.dot(G, n), n))
  local slope = math.sqrt(vec.dot(along, along))
  if rate ~= 0 then
    put("circle_rate", "V' = k Omega n x V + (1 - k) G_t: the centre's circles", "k Omega, k = I/(I + m R^2)",
      "k\\Omega,\\ k = I/(I + mR^2)", k * rate, "rad/s")
    if slope ~= 0 then
      put("drift", "across the slope", "(1 - k) G_t/(k Omega)", "(1 - k)G_t/(k\\Omega)", (1 - k) * slope / (k * rate),
        "m/s")
    end
  else
    put("acceleration", "of the centre down the slope: V' = (1 - k) G_t", "(1 - k) G_t, k = I/(I + m R^2)",
      "(1 - k)G_t,\\ k = I/(I + mR^2)", (1 - k) * slope, "m/s^2")
  end
end

-- The rows of values.lua for a scene with effect.plane.
function touch.rows(job, put)
  local m, e = job.model, contact.of(job.model)
  integrals(m, put)
  local a, f = e.a, touch_laws.facts(m, e)
  local G, mass = vec.map(a.gravity, function(x) return m:double(x) end), m:double(m.mass)
  local alone = #m.record.effects == 1 and not a.spinning and not a.rolling_resistance
  if not alone then return end
  if f.ball and a.law == "rolling" then ball(m, f, put, a, mass, G) end
  local size = math.sqrt(vec.dot(G, G))
  if m:double(a.rate) ~= 0 or not f.level or not f.revolved or size == 0 or f.ball then return end
  local I1, I3 = m:double(f.I1), m:double(f.I3)
  if f.surface.disc then
    if a.law == "rolling" and m:double(f.centre[3]) == 0 then disc(m, f, put, I1, I3, mass, size) end
    return
  end
  local up, down = ends(m, f)
  local function spin(x, where)
    if x and x[1] > 0 then upright(put, a.law, where, I1, I3, mass, size, x[1], x[2]) end
  end
  spin(up, "up")
  spin(down, "down")
end

return touch
