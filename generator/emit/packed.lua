-- packed.lua -- the Taylor recurrences of one level as rows of eight: the vectors of templates/steppers/taylor_rows.c.
--
-- Next terms are sums of products and of multiples, place by place: after*(C0 p0 + C1 p1 + ... + D y).  Product k of
-- every place makes plane k, its factors are the newest terms in another order; so a whole order needs shuffles of one
-- row and no gathering.  BELOW the line where it makes C.
-- SPDX-License-Identifier: GPL-3.0-or-later

local expr = require "generator.algebra.expr"
local calculus = require "generator.algebra.calculus"

local packed = {}

local WIDTH, PLANES = 8, 4

local function text(n) return string.format("%d", n) end

-- The next term of each place as an expression in lanes and places, and what its term 1 has beside; or nil.
-- Where a term is divided by a term 0 (x.first) it is no multiple of the others: nil.
local function forms(program)
  local whole, at_start, at_zero = {}, {}, {}
  for _, x in ipairs(program.variables) do
    if x.first then return nil end
    if x.level > 0 or not x.place and x.term then
      whole[x.sym] = calculus.substitute(x.term, whole)
      at_start[x.sym] = calculus.substitute(x.start, at_start)
    end
  end
  for _, x in ipairs(program.read) do at_zero[x.sym] = expr.zero end
  local following, list = {}, {}
  local function put(x, term, rest)
    following[x.sym] = term
    list[x.place + 1] = { term = term, rest = rest }
  end
  for _, x in ipairs(program.read) do
    if x.state then
      local slope = program.slopes[x.name]
      put(x, calculus.substitute(slope.term, whole),
        calculus.substitute(calculus.substitute(slope.start, at_start), at_zero))
    elseif x.level > 0 then
      return nil
    end
  end
  for _, x in ipairs(program.variables) do -- sums of states, and of sums made before
    if not x.state and x.place then
      local rest = expr.zero
      for _, y in ipairs(program.read) do
        local part = calculus.diff(x.term, y.sym)
        if part ~= expr.zero then rest = rest + part * list[y.place + 1].rest end
      end
      put(x, calculus.substitute(x.term, following), rest)
    end
  end
  return list
end

-- {planes = {{a, b (places), factor}}, linear = {{{place, factor}}}} of the places, 1 to WIDTH, or nil.
local function layout(program)
  if #program.read > WIDTH or #program.levels ~= 1 or #program.lanes == 0 then return nil end
  for _, l in ipairs(program.lanes) do
    if l.weighted then return nil end
  end
  local list = forms(program)
  if not list then return nil end
  local variable = {}
  for _, l in ipairs(program.lanes) do variable["p[" .. l.index .. "]"] = true end
  for _, x in ipairs(program.read) do variable[x.name] = true end
  local out = { planes = {}, linear = {}, rest = {}, has_rest = false }
  for i, f in ipairs(list) do
    local products, multiples = 0, 0
    for _, l in ipairs(program.lanes) do
      local c = calculus.diff(f.term, expr.sym("p[" .. l.index .. "]", 8))
      if c ~= expr.zero then
        products = products + 1
        if not expr.constant(c, variable) or products > PLANES then return nil end
        out.planes[products] = out.planes[products] or {}
        out.planes[products][i] = { a = l.a.place, b = l.b.place, factor = c }
      end
    end
    for _, x in ipairs(program.read) do
      local c = calculus.diff(f.term, x.sym)
      if c ~= expr.zero then
        multiples = multiples + 1
        if not expr.constant(c, variable) or multiples > PLANES then return nil end
        out.linear[multiples] = out.linear[multiples] or {}
        out.linear[multiples][i] = { a = x.place, factor = c }
      end
    end
    out.rest[i] = f.rest
    out.has_rest = out.has_rest or f.rest ~= expr.zero
  end
  return out
end

packed.width = text(WIDTH)

-- Values of the template, or nil where the recurrences are no such rows.  zero: its literal; render(groups): the lines
-- of groups by their number.
function packed.of(ctx, program, zero, render)
  local made = layout(program)
  if not made then return nil end
  local v = { planes = {}, linear = {}, rest = {} }
  local g = { where = 1, defs = {}, outs = {} }
  local function row(name, of)
    local factors, a, b = {}, {}, {}
    for i = 1, WIDTH do
      local e = of[i]
      factors[i] = e and name .. "_" .. i - 1 or zero
      a[i], b[i] = text(e and e.a or i - 1), text(e and e.b or i - 1)
      if e then
        g.outs[#g.outs + 1] = { c = "const " .. ctx.name .. "_real " .. factors[i], expr = e.factor }
      end
    end
    return { factors = table.concat(factors, ", "), a = table.concat(a, ", "), b = table.concat(b, ", ") }
  end
  for k, plane in ipairs(made.planes) do
    local r = row("c" .. k - 1, plane)
    r.index = text(k - 1)
    v.planes[k] = r
  end
  for k, l in ipairs(made.linear) do
    local r = row("d" .. k - 1, l)
    r.index = text(k - 1)
    v.linear[k] = r
  end
  if made.has_rest then
    local of = {}
    for i, e in ipairs(made.rest) do
      if e ~= expr.zero then of[i] = { factor = e } end
    end
    v.rest[1] = row("e", of)
  end
  v.factors = render { g }
  local first, sums, newest, others = {}, {}, {}, {}
  for _, p in ipairs(v.planes) do
    local k = p.index
    first[#first + 1] = "A" .. k .. "*b" .. k .. "[0]"
    sums[#sums + 1] = "C" .. k .. "*(p" .. k .. " + r" .. k .. ")"
    newest[#newest + 1] = string.format("((after*A%s)*b%s[n] + (after*B%s)*a%s[n])", k, k, k, k)
  end
  for _, p in ipairs(v.linear) do
    local turned = "__builtin_shufflevector(Y, Y, " .. p.a .. ")"
    first[#first + 1] = "D" .. p.index .. "*" .. turned
    others[#others + 1] = "(after*D" .. p.index .. ")*" .. turned
  end
  if made.has_rest then first[#first + 1] = "E" end
  v.first_row = table.concat(first, " + ")
  local all = { "after*(" .. table.concat(sums, " + ") .. ")", table.unpack(newest) }
  for _, e in ipairs(others) do all[#all + 1] = e end
  v.next_row = table.concat(all, "\n      + ")
  return v
end

return packed
