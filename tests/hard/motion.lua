-- motion.lua -- what the hard cases of motion share: a closed form against an oracle, steppers against their laws.
--
--     local m = kit.tool "motion"      nil while the catalogue only reads what a case says
--     m.closed(row, o)                 rows "at" (double, float) and "library" (long double)
--     m.step(row, o)                   a row for each stepper, in double and in float
--     m.state(x, y, pace)              the worse of the attitudes' angle, rad, and the rates' error over the pace
--
-- BAR, units u of the type's rounding, for every closed form: 36.  Attitude is a sum of products of two phases' sines and
-- cosines and of series' constants; each phase is reduced in pairs and rounded once (pi u), its sine and cosine once
-- more, some dozen operations on numbers below 2 follow; the angle is twice the quaternion's error.
-- SPDX-License-Identifier: GPL-3.0-or-later

local reference = require "generator.plan.reference"
local R = require "generator.algebra.rational"

return function(kit)
  local m = { BAR = 36 }

  -- The larger of two lists' entries, of either sign; 0 for none.
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

  -- ---- the closed form ----

  -- o.text; o.p parameters in the scene's order; o.x0; o.times; o.truth(p, x0, times) -> states; o.bar(p, x0, t, u), the
  -- bound in units u (36); o.pace(p, x0); o.library = false where it cannot; o.options of kit.emitted; o.reals.
  function m.closed(row, o)
    kit.each({ text = o.text, reals = o.reals }, function(b, real)
      local p, x0, times = kit.rounded(real, o.p), kit.rounded(real, o.x0), kit.rounded(real, o.times)
      local truth = o.truth(p, x0, times)
      local pace = o.pace and o.pace(p, x0)
      local function judge(who, name, states)
        local at, bound, worst = 0.0, 1.0, -1.0
        for i, t in ipairs(times) do
          local u = who == "library" and kit.u.double or b.u
          local bar = (o.bar and o.bar(p, x0, t, u) or m.BAR) * u
          local e = states and m.state(states[i], truth[i], pace) or math.huge
          if e / bar > worst then worst, at, bound = e / bar, e, bar end
        end
        row(o.who and who == "at" and o.who or who, name, at, bound)
      end
      local states
      if b.plugin:init(p) == 0 and b.plugin:solve(x0) == 0 then
        states = {}
        for i, t in ipairs(times) do states[i] = b.plugin:at(t) end
      end
      judge("at", real, states)
      if real == "double" and o.library ~= false then judge("library", "long double", m.library(b.job, p, x0, times)) end
    end)
  end

  -- States by the general library, or nil; one run.
  function m.library(job, p, x0, times)
    local values
    if #p > 0 then
      values = {}
      for i, q in ipairs(job.model.params) do values[q.name] = R.fromdouble(p[i]) end
    end
    local sorted = {}
    for i, t in ipairs(times) do sorted[i] = { t, i } end
    table.sort(sorted, function(a, b) return a[1] < b[1] end)
    -- the library's times go one way from 0
    local out = {}
    for _, way in ipairs { 1, -1 } do
      local list, index = {}, {}
      for k = 1, #sorted do
        local s = sorted[way == 1 and k or #sorted + 1 - k]
        if s[1] * way > 0 or way == 1 and s[1] == 0 then list[#list + 1], index[#index + 1] = s[1], s[2] end
      end
      local rows, why = nil, nil
      if #list > 0 then
        rows, why = reference.of(kit.host, job, x0, list, values, true)
        if not rows then error("library: " .. tostring(why), 0) end
        for k, i in ipairs(index) do out[i] = rows[k] end
      end
    end
    return out
  end

  return m
end
