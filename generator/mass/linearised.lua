-- linearised.lua -- how wrong the linearised free top is: its error as a function of amplitude, in closed form.
--
-- A spin w about principal axis k with transverse rates x w and y w about i and j (i, j, k cyclic), z w about k:
--     x' = -a y z,  y' = b z x,  z' = c x y,   a = (Ik - Ij)/Ii,  b = (Ik - Ii)/Ij,  c = (Ii - Ij)/Ik
-- (time in 1/w); the linearised top keeps z = 1 (Landau and Lifshitz, Mechanics, section 37).  With a b > 0 put
-- x = r sqrt|a| cos f, y = +-r sqrt|b| sin f: then r is constant, f' = sqrt(a b) z without approximation, and z^2 is
-- linear in sin^2 f.  So z swings between p and q, and the mean of f' is sqrt(a b) agm(p, q), by Gauss's
--     integral from 0 to pi/2 of df/sqrt(p^2 cos^2 f + q^2 sin^2 f) = pi/(2 agm(p, q)).
-- Everything the linearised top misses follows: z itself, and a phase that runs away by agm(p, q) - 1 of a turn in
-- every period.  A transverse rate e w in the direction that is worst gives p = 1, q^2 = 1 - 2 C e^2, and
--     axial rate  -C e^2,    frequency  -C e^2/2,    third harmonic  C e^2/8 of the first    (leading terms)
-- with C = |c|/(2 min(|a|, |b|)); 2 C e^2 is the parameter m of the exact solution's elliptic functions, 1 on the
-- separatrix.  With a b < 0 the same steps give hyperbolic functions: see failure().
--
-- Plain numbers, relative ones only, so that no size of body or spin matters.  Errors are of the largest component
-- of the rates in principal axes, in parts of w.
-- SPDX-License-Identifier: GPL-3.0-or-later

local linearised = {}

-- Axis k of the three moments: {k, i, j, a, b, c, kind}.  kind: "exact" (Ii = Ij: the linearised rates are the
-- rates), "stable", "unstable", "neutral" (Ik is one of the two others).  Stable ones have also frequency (of the
-- polhode, in w), C, ratio (of the ellipse's axes), limit (the amplitude of the separatrix), weak (i or j: the
-- worst direction).  Unstable ones: growth, in w.  A rod's line has no moment and keeps its rate, as in the emitted
-- code.
function linearised.axis(I, k)
  local i, j = k % 3 + 1, (k + 1) % 3 + 1
  local A = { k = k, i = i, j = j, a = I[i] > 0 and (I[k] - I[j]) / I[i] or 0.0,
    b = I[j] > 0 and (I[k] - I[i]) / I[j] or 0.0, c = I[k] > 0 and (I[i] - I[j]) / I[k] or 0.0 }
  local a, b = math.abs(A.a), math.abs(A.b)
  if A.c == 0 then
    A.kind = "exact"
  elseif a == 0 or b == 0 then
    A.kind = "neutral"
  elseif (A.a > 0) ~= (A.b > 0) then
    A.kind, A.growth = "unstable", math.sqrt(a) * math.sqrt(b)
  else
    local least = math.min(a, b)
    A.kind, A.frequency, A.weak = "stable", math.sqrt(a) * math.sqrt(b), a <= b and i or j
    A.C, A.ratio = math.abs(A.c) / (2 * least), math.sqrt(math.max(a, b) / least)
    A.limit = 1 / math.sqrt(2 * A.C)
  end
  return A
end

-- agm(1 + p, 1 + q) - 1 for p >= q > -1, without cancelling: the means fall by c/2 = (a - g)/2, c -> c^2/(4 a).
local function agm_excess(p, q)
  local a, g, excess = 1 + p, 1 + q, (p + q) / 2
  local c = (p - q) / 2
  a, g = 1 + excess, math.sqrt(a * g)
  for _ = 1, 12 do -- quadratic: six suffice for q down to -1 + 1e-300
    c = c * c / (4 * (a + g) / 2)
    excess, a, g = excess - c, (a + g) / 2, math.sqrt(a * g)
  end
  return excess
end

-- The motion of a stable axis with transverse rates x, y (in parts of the spin) at t = 0:
-- {axial, shift, swing, third}: largest change of the axial rate; relative error of the frequency, exact minus
-- linearised; largest transverse rate; third harmonic in parts of the first, leading term.
-- nil beyond the separatrix: the polhode goes round another axis.
function linearised.motion(A, x, y)
  local a, b = math.abs(A.a), math.abs(A.b)
  local X, Y = x * (x / a), y * (y / b)
  local s = A.a > 0 and A.c or -A.c
  -- where sin f or cos f is 0
  local high, low = s * X, -s * Y -- of z^2 - 1
  if high < low then high, low = low, high end
  if low <= -1 then return nil end
  local p, q = high / (1 + math.sqrt(1 + high)), low / (1 + math.sqrt(1 + low))
  return { axial = math.max(p, -q), shift = agm_excess(p, q), swing = math.sqrt(X + Y) * math.sqrt(math.max(a, b)),
    third = math.abs(A.c) * (X + Y) / 16 }
end

-- The largest error within n periods: the axial rate's, or that of the phase, whose chord cannot exceed the diameter.
function linearised.error(motion, n)
  local turned = math.min(math.pi / 2, math.pi * n * math.abs(motion.shift))
  return math.max(motion.axial, 2 * motion.swing * math.sin(turned))
end

-- The direction (x, y), of length 1, in which a transverse rate does most harm: along the axis with the weaker
-- coupling where the spin is stable; where it is not, what grows is |x/sqrt|a| -+ y/sqrt|b|| (neutral: b x or a y).
function linearised.direction(A)
  if A.kind == "stable" then return A.weak == A.i and 1.0 or 0.0, A.weak == A.j and 1.0 or 0.0 end
  local a, b = math.sqrt(math.abs(A.a)), math.sqrt(math.abs(A.b))
  local n = math.sqrt(a * a + b * b)
  if n == 0 then return 1.0, 0.0 end
  return b / n, (A.a > 0 and -a or a) / n
end

-- The worst of the motions with the transverse rate e.
function linearised.worst(A, e)
  local x, y = linearised.direction(A)
  return linearised.motion(A, e * x, e * y)
end

-- The linearised rates x, y at the time t, in 1/w (templates/analysis/analysis.c has the same formula).
function linearised.rates(A, x, y, t)
  local c, s = 1.0, t
  if A.kind == "unstable" then
    local up, down = math.exp(A.growth * t), math.exp(-A.growth * t)
    c, s = (up + down) / 2, (up - down) / 2 / A.growth
  elseif A.kind ~= "neutral" then
    local frequency = A.frequency or math.abs(A.a) -- exact: a = b
    c, s = math.cos(frequency * t), frequency > 0 and math.sin(frequency * t) / frequency or t
  end
  return c * x - A.a * s * y, c * y + A.b * s * x
end

-- The amplitude below which n periods are right to eps, by bisection: the error grows with e.
function linearised.amplitude(A, eps, n)
  local low, high = -750.0, math.log(A.limit)
  -- in logarithms, from e^-750, which is below the smallest double, to the separatrix
  for _ = 1, 64 do
    local middle = (low + high) / 2
    local motion = linearised.worst(A, math.exp(middle))
    if motion and linearised.error(motion, n) <= eps then low = middle else high = middle end
  end
  return math.exp(low)
end

-- The time, in 1/w, until the linearised rates of an unstable or neutral axis are wrong by eps < 1; infinite if never.
-- Neutral: one transverse rate x stays, the spin turns with b x (or a y) towards the other, and 1 - cos = eps.
-- Unstable: with X = x/sqrt|a|, Y = y/sqrt|b| and the "time" s, s' = sqrt|a b| z, the motion is a sum of e^s and e^-s
-- without approximation, and z^2 = 1 - |c| (Y^2 - Y0^2).  When z has fallen by d, X^2 and Y^2 have grown by
-- d (2 - d)/|c|, and s lags the time by -log(1 - d/2) (for small e: the integral of dY/(Y sqrt(1 - |c| Y^2))), which
-- makes a transverse rate wrong by sqrt(m/|c|) d sqrt(d/(2 - d)), m = max(|a|, |b|).  So d = eps, or the smaller one
-- at which the transverse rate has failed already.  For small e the time is log(const/e)/sqrt|a b|.
function linearised.failure(A, x, y, eps)
  local a, b, c = math.abs(A.a), math.abs(A.b), math.abs(A.c)
  if A.kind == "neutral" then
    local turning = math.abs(b * x) + math.abs(a * y)
    return turning > 0 and math.acos(1 - eps) / turning or math.huge
  end
  local X, Y = x / math.sqrt(a), y / math.sqrt(b)
  local growing = math.abs(A.a > 0 and X - Y or X + Y) -- 2 u in u e^s
  if growing == 0 then return math.huge end
  local reach = math.sqrt(math.max(a, b) / c)
  local low, d = 0.0, eps
  if reach * d * math.sqrt(d / (2 - d)) > eps then
    for _ = 1, 60 do
      local middle = (low + d) / 2
      if reach * middle * math.sqrt(middle / (2 - middle)) > eps then d = middle else low = middle end
    end
  end
  local gain = d * (2 - d) / c
  return (math.log((math.sqrt(X * X + gain) + math.sqrt(Y * Y + gain)) / growing) - math.log(1 - d / 2)) / A.growth
end

-- The rates w (along the principal axes) as a spin: the axis k it is nearest to, the transverse rates x, y there in
-- parts of the spin, and e = |(x, y)|.  Of two equal moments any axis in their plane is principal: the one that the
-- spin's own part in that plane has.  A spin of zero gives k = 1, e = 0.  A negative spin is one about -k.
function linearised.spin(I, w)
  local size = math.max(math.abs(w[1]), math.abs(w[2]), math.abs(w[3]))
  if size == 0 then return { k = 1, x = 0.0, y = 0.0, e = 0.0, rate = 0.0 } end
  local v = { w[1] / size, w[2] / size, w[3] / size }
  local p = I[1] == I[2] and 1 or I[2] == I[3] and 2
  if I[1] == I[3] then -- a sphere: every axis is principal
    local n = math.sqrt(v[1] * v[1] + v[2] * v[2] + v[3] * v[3])
    return { k = 1, x = 0.0, y = 0.0, e = 0.0, rate = n * size }
  elseif p then
    v[p], v[p + 1] = math.sqrt(v[p] * v[p] + v[p + 1] * v[p + 1]), 0.0
    local own = p == 1 and 3 or 1
    if math.abs(v[own]) >= v[p] then -- about the symmetry axis; the direction in the plane does not matter
      return { k = own, x = v[p] / math.abs(v[own]), y = 0.0, e = v[p] / math.abs(v[own]),
        rate = math.abs(v[own]) * size }
    end
  end
  local k = 1
  for n = 2, 3 do
    if math.abs(v[n]) > math.abs(v[k]) then k = n end
  end
  local i, j, spin = k % 3 + 1, (k + 1) % 3 + 1, math.abs(v[k])
  local x, y = v[i] / spin, v[j] / spin
  if v[k] < 0 then y = -y end -- half a turn about i
  return { k = k, x = x, y = y, e = math.sqrt(x * x + y * y), rate = spin * size }
end

return linearised
