-- fold.lua -- torques divided by moments of inertia, without a division: constants of an effect and moments make one.
--
--     C w/I  =>  (C/I) w,    2 m g r (..)/I  =>  (2 m g r/I) (..)
-- An effect's constants are provisional until the equations stand (fold.constants): those that were folded into a
-- quotient never become constants of the model, the others do then (fold.settle).  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"
local ratio = require "generator.algebra.ratio"

local fold = {}

-- Provisional constants: {[symbol] = {name, e, about, positive}} and the function that effects call for them;
-- positive: it must not round to 0 either.
-- Their symbols begin with an apostrophe, so no name of a scene is among them; by_sym is filled as effects call.
function fold.constants()
  local by_sym, by_expr = {}, {}
  return by_sym, function(name, e, about, positive)
    e = ratio.tidy(e)
    if e.kind == "num" then return e end
    local sym = by_expr[e]
    if not sym then
      local unique, n = "'" .. name, 1
      while by_sym[expr.sym(unique, 3)] do
        n = n + 1
        unique = "'" .. name .. n
      end
      sym = expr.sym(unique, 3)
      by_expr[e], by_sym[sym] = sym, { name = name, e = e, about = about, positive = positive }
    end
    return sym
  end
end

-- Is the name that of a constant, of the model or a provisional one?
function fold.taken(m, provisional, name)
  local found = m.by_name[name] ~= nil
  for _, p in pairs(provisional) do found = found or p.name == name end -- in any order: it is or it is not
  return found
end

-- Is every symbol of e a constant, of the model or a provisional one?
local function constant(m, provisional, e)
  for _, s in ipairs(expr.symbols(e)) do
    local member = m.by_name[s.name]
    if not provisional[s] and not (member and member.sym == s and member.e) then return false end
  end
  return true
end

-- The terms of e; a number times a sum is multiplied out.
local function terms(e)
  if e.kind == "add" then return e end
  if e.kind == "mul" and #e == 2 and e[1].kind == "num" and e[2].kind == "add" then
    local list = {}
    for i = 1, #e[2] do list[i] = e[1] * e[2][i] end
    return list
  end
  return { e }
end

-- e/I with every term's constants and I in one constant; nil where a term has none.  I: a constant of the model.
-- A sign stays outside: c and -c would be two constants.  What the constant is called tells where it comes from: by its
-- first provisional one, with the moment behind it unless that has cancelled.
local function quotient(m, provisional, e, I)
  local parts = {}
  for i, t in ipairs(terms(e)) do
    local c, rest, any = {}, {}, I.kind == "num"
    for _, f in ipairs(t.kind == "mul" and t or { t }) do
      if constant(m, provisional, f) then
        c[#c + 1] = f
        any = any or f.kind ~= "num"
      else
        rest[#rest + 1] = f
      end
    end
    if not any then return nil end
    parts[i] = { c = expr.mul(c), rest = expr.mul(rest) }
  end
  local map, sum = {}, expr.zero
  for _, member in ipairs(m.members) do map[member.sym] = member.e end
  for sym, p in pairs(provisional) do map[sym] = p.e end -- into a table: order is lost anyway
  for _, p in ipairs(parts) do
    local sign, c = 1, p.c
    local number, pure = expr.split(c)
    if R.sign(number) < 0 then sign, c = -1, -c end
    local over = ratio.tidy(calculus.substitute(c / I, map))
    local name, about = "torque", "of a torque"
    for _, x in ipairs(expr.symbols(pure)) do
      local own = provisional[x]
      if own then
        name, about = own.name, own.about
        if own.e ~= over then -- else the moments have cancelled
          local factor = R.abs(number) ~= R.one and tostring(R.abs(number)) .. " times " or ""
          local moment = I.kind == "sym" and I.name or "I"
          local member = m.by_name[moment] -- in words: a parameter may have the name that the moment would have
          local words = member and member.about and string.gsub(member.about, ", kg m%^2$", "") or "moment of inertia"
          name = name .. "_" .. moment
          about = factor .. string.gsub(about, ",.*", "") .. ", over the " .. words
        end
        break
      end
    end
    local k = m:constant(name, over, about)
    sum = sum + sign * k * p.rest
  end
  return sum
end

-- n/I, n a sum of names of torques that groups define: a name whose torque folds becomes an acceleration in its
-- group.  inline: puts definitions in.
function fold.over(m, provisional, groups, n, I, axis, inline)
  local sum = expr.zero
  for _, t in ipairs(n.kind == "add" and n or { n }) do
    local folded
    for _, g in ipairs(groups) do
      for _, d in ipairs(g.defs) do
        if expr.sym(d.name, 7) == t and not folded then
          folded = quotient(m, provisional, inline(groups, d.expr), I)
          if folded then
            g.why = string.gsub(g.why, "; over the moments$", "") .. "; over the moments"
            d.name, d.expr = string.gsub(d.name, "^N" .. axis, "a" .. axis), folded
            while fold.taken(m, provisional, d.name) do d.name = d.name .. "_" end
            folded = expr.sym(d.name, 7)
          end
        end
      end
    end
    sum = sum + (folded or quotient(m, provisional, t, I) or t / I)
  end
  return sum
end

-- Provisional constants that are left in the groups become the model's.
function fold.settle(m, provisional, groups)
  local map = {}
  local function settled(e)
    for _, s in ipairs(expr.symbols(e)) do
      local p = provisional[s]
      if p and not map[s] then
        map[s] = m:constant(p.name, p.e, p.about)
        if p.positive then m:positive(map[s]) end
      end
    end
    return calculus.substitute(e, map)
  end
  for _, g in ipairs(groups) do
    for _, d in ipairs(g.defs) do d.expr = settled(d.expr) end
    for i, o in ipairs(g.outs) do
      if expr.is(o) then g.outs[i] = settled(o) else o.expr = settled(o.expr) end
    end
  end
end

-- Does any group after the first use one of the definitions?
function fold.uses(groups, defs)
  local names = {}
  for _, d in ipairs(defs) do names[d.name] = true end
  for i = 2, #groups do
    for _, list in ipairs { groups[i].defs, groups[i].outs } do
      for _, x in ipairs(list) do
        if not expr.constant(x.expr, names) then return true end
      end
    end
  end
  return false
end

return fold
