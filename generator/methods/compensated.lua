-- compensated.lua -- steps whose states carry the low-order words of their sums: gen --with compensated.
--
-- A state is the unevaluated sum x + low of two numbers of the type.  A step computes what it adds, d, from x, and then
--     s = d + low,   x' = x + s,   low' = s - (x' - x)
-- Dekker's Fast2Sum: for |s| <= |x| low' is exactly what rounding x' lost, and it enters the next sum.  Where a
-- component of the state is smaller than its increment the difference x' - x is itself rounded; that is at most an
-- ulp of s, no more than s has from its own arithmetic, so no branch and no 2Sum of six operations is needed.  What
-- remains are the roundings of d: h |w| times those of the plain step.  It pays where steps are short.
-- A method takes part by increments(eq, constant, lost), its step as equation groups whose outs are d (rk4, adaptive,
-- semi; lost(name) is the low of a state, for a step that needs x'), or by a template (taylor, whose series is one).
-- The others multiply rotations: there is no increment.
-- Source: Kahan 1965, Comm. ACM 8, 40; Moller 1965, BIT 5, 37 and 251; Dekker 1971, Numer. Math. 18, 224; Knuth,
-- TAOCP 2, section 4.2.2; Hairer, Lubich, Wanner, Geometric Numerical Integration (2nd ed.), VIII.5.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"

local compensated = {}

-- A prefix with which no state's name becomes that of a constant.
local function prefix(m, word)
  local clash
  repeat
    clash = false
    for _, s in ipairs(m.states) do clash = clash or m.by_name[word .. s.name] ~= nil end
    if clash then word = word .. "_" end
  until not clash
  return word
end

-- NAME_STEP_compensated of a method with increments, as a function description.
-- Three words a state: add = d + low, new = x + add, gain = new - x; then low = add - gain.
local function of(eq, method, name)
  local m, groups = eq.model, {}
  local low, names = prefix(m, "low"), {}
  local function lost(state) return expr.sym(low .. state, 3) end
  local steps, divides = method.increments(eq, function(e, words) return m:derived(e, words) end, lost)
  local last = { why = "Fast2Sum: low is what the sum loses, and comes back with the next step", defs = {}, outs = {} }
  local before, sum, gained = prefix(m, "add"), prefix(m, "new"), prefix(m, "gain")
  for i, s in ipairs(m.states) do names[i] = low .. s.name end
  for i, g in ipairs(steps) do
    groups[i] = { why = g.why, where = g.where, defs = g.defs, outs = {} }
    for _, o in ipairs(g.outs) do
      local sym, words = m.states.by_name[o.state].sym, {}
      for k, w in ipairs { before, sum, gained } do words[k] = expr.sym(w .. o.state, 9) end
      last.defs[#last.defs + 1] = { name = before .. o.state, expr = lost(o.state) + o.expr }
      last.defs[#last.defs + 1] = { name = sum .. o.state, expr = sym + words[1] }
      last.defs[#last.defs + 1] = { name = gained .. o.state, expr = words[2] - sym }
      last.outs[#last.outs + 1] = { array = "x", state = o.state, expr = words[2] }
      last.outs[#last.outs + 1] = { array = "low", state = o.state, expr = words[1] - words[3] }
    end
  end
  groups[#groups + 1] = last
  return { name = name .. "_compensated",
    args = { "m", "t", "x!", "u", "h", { name = "low", count = #m.states, names = names, out = true, held = true } },
    doc = { "The same step with compensated sums: the state is x + low, low[NX] 0 at the start and then what x[i]",
      "lost, so that rounding grows with h |w| times what it is in " .. m.name .. "_" .. name .. "." },
    groups = groups, guard = divides and "h" or nil }
end

-- The functions of a job {equations, record, steppers, diag}; nil after an error.
function compensated.list(job)
  local list = {}
  for i, s in ipairs(job.steppers) do
    if s.method.increments then
      list[#list + 1] = of(job.equations, s.method, i == 1 and "step" or s.method.name .. "_step")
    elseif not s.method.compensated then
      job.diag:error(job.record.line, "method " .. s.method.name,
        "it has no compensated step (--with compensated): rk4, adaptive, taylor and semi have one")
      return nil
    elseif s.program.switches then
      job.diag:error(job.record.line, "method " .. s.method.name,
        "its step goes from corner to corner of these equations: without --with compensated")
      return nil
    end
  end
  return list
end

return compensated
