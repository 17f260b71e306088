-- motion.lua -- what the hard cases of motion share: a closed form against an oracle, steppers against their laws.
--
--     local m = kit.tool "motion"      nil while the catalogue only reads what a case says
--     m.closed(row, o)                 rows "at" (double, float) and "library" (long double)
--     m.free(row, o)                   the same of the free asymmetric top m.text against MPFR
--     m.ask(o)                         what else the emitted code of a free body knows (tests/hard/free.c)
--     m.step(row, o)                   a row for each stepper, in double and in float
--     m.state(x, y, pace)              the worse of the attitudes' angle, rad, and the rates' error over the pace
--
-- BAR, units u of the type's rounding, for every closed form: 36.  Attitude is a sum of products of two phases'
-- sines and
-- cosines and of series' constants; each phase is reduced in pairs and rounded once (pi u), its sine and cosine once
-- more, some dozen operations on numbers below 2 follow; the angle is twice the quaternion's error.
-- SPDX-License-Identifier: GPL-3.0-or-later

local reference = require "generator.plan.reference"
local R = require "generator.algebra.rational"

return function(kit)
  local m = { BAR = 36 }

  m.steppers = { "rk4", "adaptive", "taylor", "split2", "split4", "split6", "midpoint", "semi" }

  m.text = [[
local A, B, C = param("A", 1, "kg m^2"), param("B", 2, "kg m^2"), param("C", 3, "kg m^2")
return scene { name = "free", body = tensor { mass = 1, xx = A, yy = B, zz = C },
  initial = { omega = {0.1, 1, 0.1} } }
]]

  -- The largest entry of a list, of either sign; 0 for none.
  function m.size(list, from, to)
    local most = 0.0
    for i = from or 1, to or #list do most = math.max(most, math.abs(list[i])) end
    return most
  end

  -- pace nil: the largest of the oracle's rates.
  function m.state(x, want, pace)
    if not kit.finite(x) then return math.huge end
    local most = 0.0
    for i = 5, 7 do most = math.max(most, math.abs(x[i] - want[i])) end
    local scale = pace or m.size(want, 5, 7)
    return kit.worst(kit.angle(x, want), scale > 0 and most / scale or most)
  end

  -- The bar of a closed form over long times, units u: a phase's rate is known to 2^-100 of a turn for each turn, in
  -- float to 2^-42 (what the emitted header promises), and the fastest turns with `rate`, rad/s.
  function m.long(rate)
    return function(_, _, t, u) return m.BAR + math.abs(t) * rate * 2.0 ^ (u > 1e-10 and -42 or -100) / u end
  end

  local function of(value, real)
    if type(value) == "function" then return value(real) end
    return value
  end

  -- ---- the closed form ----

  -- o.text; o.p parameters in the scene's order, o.x0, o.times: lists or functions of the real type; o.truth(p, x0,
  -- times) -> states; o.bar(p, x0, t, u), the bound in units u (36); o.pace(p, x0); o.library = false where it cannot;
  -- o.library_bar, its own bound; o.reals; o.who, added to "at"; o.measure, instead of m.state.
  function m.closed(row, o)
    kit.each({ text = o.text, reals = o.reals }, function(b, real)
      local p, x0, times = kit.rounded(real, of(o.p, real)), kit.rounded(real, of(o.x0, real)),
        kit.rounded(real, of(o.times, real))
      local truth = o.truth(p, x0, times)
      local pace = o.pace and o.pace(p, x0)
      local function judge(who, name, u, states)
        local at, bound, worst = 0.0, 1.0, -1.0
        for i, t in ipairs(times) do
          local law = who == "library" and o.library_bar or o.bar
          local bar = (law and law(p, x0, t, u) or m.BAR) * u
          local e = states and (o.measure or m.state)(states[i], truth[i], pace, real) or math.huge
          if e / bar > worst then worst, at, bound = e / bar, e, bar end
        end
        row(o.who and who .. ", " .. o.who or who, name, at, bound)
      end
      local states
      if b.plugin:init(p) == 0 and b.plugin:solve(x0) == 0 then
        states = {}
        for i, t in ipairs(times) do states[i] = b.plugin:at(t) end
      end
      judge("at", real, b.u, states)
      if real == "double" and o.library ~= false then
        judge("library", "long double", kit.u.double, m.library(b.job, p, x0, times))
      end
    end)
  end

  -- States by the general library, one run for each sign of the times; raises where it cannot.
  function m.library(job, p, x0, times)
    local values, out = {}, {}
    for i, q in ipairs(job.model.params) do values[q.name] = R.fromdouble(p[i]) end
    for _, way in ipairs { 1, -1 } do
      local order, list = {}, {}
      for i, t in ipairs(times) do
        if t * way > 0 or way == 1 and t == 0 then order[#order + 1] = i end
      end
      table.sort(order, function(a, b) return math.abs(times[a]) < math.abs(times[b]) end)
      for k, i in ipairs(order) do list[k] = times[i] end
      if #list > 0 then
        local rows, why = reference.new(kit.host, job):motion(x0, list, values, true)
        if not rows then error("library: " .. tostring(why), 0) end
        for k, i in ipairs(order) do out[i] = rows[k] end
      end
    end
    return out
  end

  -- ---- the free asymmetric top ----

  function m.truth(p, x0, times) return kit.free_top({ p[1], p[2], p[3], 0, 0, 0 }, x0, times) end

  function m.free(row, o)
    o.text, o.truth = m.text, o.truth or m.truth
    m.closed(row, o)
  end

  -- Period of the rates, s (inf, or 0), and the mean rate of precession: many digits.
  function m.periods(p, x0)
    local line = { p[1], p[2], p[3], 0, 0, 0, x0[5], x0[6], x0[7], x0[1], x0[2], x0[3], x0[4], 0 }
    return table.unpack(kit.oracle("free_top", "-p", { line })[1])
  end

  -- o.text (a scene named free), o.real, o.p, o.x0, o.t, o.h, o.n (an integer): {period, precession, rotation, flip},
  -- state after n ticks; or nil.
  function m.ask(o)
    local words = {}
    for _, list in ipairs { o.p, o.x0, { o.t or 0.0, o.h or 1.0 } } do
      for _, x in ipairs(list) do words[#words + 1] = string.format("%a", x) end
    end
    words[#words + 1] = string.format("%d", o.n or 0)
    local lines, out = kit.program { text = o.text or m.text, real = o.real, source = "tests/hard/free.c",
      arguments = words }, {}
    if #lines < 2 then return nil end
    for i, line in ipairs(lines) do
      out[i] = {}
      for word in string.gmatch(line, "%S+") do out[i][#out[i] + 1] = tonumber(word) or string.find(word, "inf") and
        math.huge or 0 / 0 end
    end
    return out[1], out[2]
  end

  -- ---- steppers ----

  -- What a step of angle a = h |w| leaves, rad and relative rates, for each rad: {order, factor, double's a, float's
  -- a}.
  -- Runge and Kutta: Lotkin's bound (1951, Math. Tables 5, 128), 73/720 M L^4 h^4 with L = 2 |w|, for the free body's
  -- equations have the derivative |w| times a factor below 2; adaptive's 5th order with L^5 likewise.  taylor: a
  -- majorant
  -- of w' = K w w, K <= 1, has the coefficients |w|^(n+1), so that a^order/(1 - a) is left.  split: b^10 of a series in
  -- b = a/2 whose next pole is at b = pi or farther, and 4 for its coefficient.  midpoint, semi: a^2/12 for the
  -- angle by
  -- Cayley's map and for the rates, a^2/24 and a^2/12 of third derivatives below 4 |w|^3; 1 is above their sum.
  local law = { rk4 = { 4, 2, 2.0 ^ -10, 2.0 ^ -5 }, adaptive = { 5, 4, 2.0 ^ -8, 2.0 ^ -4 },
    taylor = { 20, 1.5, 2.0 ^ -2, 2.0 ^ -4, 10 }, midpoint = { 2, 1, 2.0 ^ -10, 2.0 ^ -8 },
    semi = { 2, 1, 2.0 ^ -10, 2.0 ^ -8 } }
  for _, name in ipairs { "split2", "split4", "split6" } do law[name] = { 10, 4 / 2.0 ^ 10, 2.0 ^ -3, 2.0 ^ -2 } end

  -- What keeps T and |L| to rounding whatever the step is.
  m.keeps = { split2 = true, split4 = true, split6 = true, midpoint = true }

  -- Taylor's coefficients are those of seconds: |w|^order and its inverse must be numbers of the type
  -- (docs/methods.md).
  function m.fits(name, real, pace)
    local turns = math.abs(math.log(pace, 2))
    return name ~= "taylor" or (real == "float" and 10 * turns < 120 or real ~= "float" and 20 * turns < 1000)
  end

  -- fn(b, real, p, x0, name) for each stepper and type; o.text (m.text), o.p, o.x0, o.steppers.
  function m.each(row, o, fn)
    kit.each({ text = o.text or m.text, methods = m.steppers }, function(b, real)
      local p, x0 = kit.rounded(real, of(o.p, real)), kit.rounded(real, of(o.x0, real))
      if b.plugin:init(p) ~= 0 then
        row("init", real, math.huge, 1)
        return
      end
      for _, name in ipairs(o.steppers or m.steppers) do fn(b, real, p, x0, name) end
    end)
  end

  -- The step by the law, a power of two, for the fastest rate; how many make about so many radians; truncation for
  -- them.
  function m.plan(name, real, pace, radians)
    local l = law[name]
    local h = 2.0 ^ math.floor(math.log(l[real == "float" and 4 or 3] / pace, 2))
    return h, math.max(1, math.floor(radians / (pace * h))),
      l[2] * (h * pace) ^ (real == "float" and l[5] or l[1]) * radians
  end

  -- Three standard deviations of n independent steps of 16 roundings each, of q and w; those of w turn the attitude.
  function m.walk(n, radians, u) return 3 * math.sqrt(n) * u * (16 + 2 * radians) end

  -- How far energy and |L| have gone, relatively: the worse, and that of |L| alone.
  function m.drift(b, x0, x)
    local function length(v) return math.sqrt(v[1] ^ 2 + v[2] ^ 2 + v[3] ^ 2) end
    local function off(a, c) return c ~= 0 and kit.number(math.abs(a / c - 1)) or kit.number(math.abs(a)) end
    local L = off(length(b.plugin:momentum(x)), length(b.plugin:momentum(x0)))
    return kit.worst(off(b.plugin:energy(x), b.plugin:energy(x0)), L), L
  end

  -- Each stepper from x0 over about o.radians.  o.pace(real), the fastest rate, rad/s; o.growth(t): how an error at the
  -- start has grown (1); o.condition: what a rounding is multiplied by (1); o.truth; o.laws: rows of energy and |L|,
  -- too.  The bound is growth times truncation and rounding;
  -- what keeps T and |L| has no truncation in them, and no growth: they are integrals.
  function m.step(row, o)
    m.each(row, o, function(b, real, p, x0, name)
      local pace = of(o.pace, real)
      if not m.fits(name, real, pace) then return end
      local h, n, cut = m.plan(name, real, pace, o.radians)
      local x = b.plugin:march(0, x0, nil, h, n, name)
      local want = (o.truth or m.truth)(p, x0, { h * n })[1]
      local more = (o.growth and o.growth(h * n) or 1) * (o.condition or 1)
      row(name, real, m.state(x, want), more * (cut + m.walk(n, o.radians, b.u)))
      if o.laws then
        row(name .. ", laws", real, m.drift(b, x0, x), 2 * ((m.keeps[name] and 0 or cut) + m.walk(n, 0, b.u)))
      end
    end)
  end

  return m
end
