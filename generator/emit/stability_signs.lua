-- stability_signs.lua -- the emitted NAME_spin_stable: the three signs of differences of moments, exactly, as C text.
--
-- The signs depend on parameters alone, so NAME_init computes them once (NAME_sort_moments) and the model keeps them.
-- An atom (mass/critical.lua) that is a difference of two numbers is a comparison; any other polynomial is a sum of
-- products of parameters, whose sign NAME_sign_of_sum finds without rounding; what is no polynomial, or too large, is
-- computed as it stands (of a composite body in its named parts) and has the sign of the rounded value.  A number of
-- the scene that is not one of the real type stands as a sum of up to three.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local expr = require "generator.algebra.expr"
local poly = require "generator.algebra.poly"
local text = require "generator.formula.text"
local number = require "generator.emit.number"
local source = require "generator.emit.source"
local template = require "generator.emit.template"

local ORDER = template.group "numeric/order.c"
local SPINS = template.group("analysis/stability.h", "analysis/stability.c")

local stability = {}

local most_columns, most_terms = 7, 512
local bits = 240 -- of a coefficient that is no rational number
local parts = 3  -- numbers of the real type that a coefficient may take

-- The largest row of a sum is scaled to about 2^top, which leaves room for the split of Dekker's product; the last bit
-- of a subnormal number is 2^lowest.
local top, lowest, digits = { double = 900, float = 100 }, { double = -1074, float = -149 }, { double = 53, float = 24 }


local function parameter(ctx, name) return "p[" .. ctx.upper .. "_" .. string.upper(name) .. "]" end

-- c as up to three numbers of the real type that add up to it.
-- Each is the nearest to what is left; three of double have some 159 bits.
local function pieces(ctx, c)
  local list = {}
  for _ = 1, parts do
    local x = R.fromdouble(ctx.real == "float" and R.tofloat(c) or R.todouble(c))
    if R.sign(x) == 0 then break end
    list[#list + 1] = number.text(x, ctx.real)
    c = c - x
    if R.sign(c) == 0 then break end
  end
  return list
end

-- The rows of factors of the polynomial atom: {{coefficient, "p[..]", ...}, ...}, columns; nil where it is none.
local function rows_of(ctx, atom)
  local ring, p = poly.modest(atom)
  if not p then return nil end
  local rows, columns, largest = {}, 1, R.zero
  for n, t in ipairs(poly.sorted(p)) do
    local c, factors = t.c, {}
    for i, x in ipairs(t.e) do
      local g = ring.gens[i]
      if x ~= 0 and expr.constant(g) then
        c = c * evaluate.precise(expr.pow(g, x), {}, bits)
      elseif x ~= 0 then
        if g.kind ~= "sym" then return nil end
        for _ = 1, x do factors[#factors + 1] = parameter(ctx, g.name) end
      end
    end
    if R.abs(c) > largest then largest = R.abs(c) end
    columns = math.max(columns, #factors + 1)
    rows[n] = { c = c, factors = factors }
  end
  if columns > most_columns then return nil end
  -- coefficients of moderate size stay as they are written
  local scale = R.log2(largest) > 60 and R.new(2) ^ -R.log2(largest) or R.one
  local out = {}
  for _, r in ipairs(rows) do
    for _, c in ipairs(pieces(ctx, r.c * scale)) do
      local row = { c, table.unpack(r.factors) }
      while #row < columns do row[#row + 1] = number.text(R.one, ctx.real) end
      out[#out + 1] = row
    end
  end
  if #out << (columns - 1) > most_terms then return nil end
  return out, columns
end

-- x - y or x alone, as a comparison; nil otherwise.
local function comparison(ctx, atom)
  local sides = { "", "" }
  for _, t in ipairs(atom.kind == "add" and atom or { atom }) do
    local c, rest = expr.split(t)
    if R.abs(c) ~= R.one or rest.kind ~= "sym" then return nil end
    local side = R.sign(c) > 0 and 1 or 2
    if sides[side] ~= "" then return nil end
    sides[side] = parameter(ctx, rest.name)
  end
  for i = 1, 2 do
    if sides[i] == "" then sides[i] = number.text(R.zero, ctx.real) end
  end
  return "(" .. sides[1] .. " > " .. sides[2] .. ") - (" .. sides[1] .. " < " .. sides[2] .. ")"
end

-- The lines of statements in a block of their own: loads, then each group with its comment.
local function block(c, lines)
  lines[#lines + 1] = "{"
  for _, l in ipairs(c.loads) do lines[#lines + 1] = "  " .. l end
  for _, g in ipairs(c.groups) do
    for _, l in ipairs(g.why and source.comment(g.why) or {}) do lines[#lines + 1] = "  " .. l end
    for _, l in ipairs(g.lines) do lines[#lines + 1] = "  " .. l end
  end
end

-- Ends the block: the sign of each value.
local function signs_of_values(ctx, names, lines)
  local zero = number.text(R.zero, ctx.real)
  for _, name in ipairs(names) do
    local value = "value_" .. name
    lines[#lines + 1] = "  " .. name .. " = (" .. value .. " > " .. zero .. ") - (" .. value .. " < " .. zero .. ");"
  end
  lines[#lines + 1] = "}"
end

-- Statements that define `const int NAME` for the atom without rounding; false where they cannot.
local function exactly(ctx, name, atom, lines, need)
  local function put(l) lines[#lines + 1] = l end
  local compared = comparison(ctx, atom)
  if compared then
    put("const int " .. name .. " = " .. compared .. ";")
    return true
  end
  local rows, columns = rows_of(ctx, atom)
  if not rows then return false end
  for _, l in ipairs(source.comment("the sign of " .. text.of(atom, "plain"))) do put(l) end
  need.terms = math.max(need.terms, #rows << (columns - 1))
  need.columns = math.max(need.columns, columns)
  put("const " .. ctx.name .. "_real f_" .. name .. "[] = {")
  for i, row in ipairs(rows) do put("    " .. table.concat(row, ", ") .. (i < #rows and "," or "")) end
  put("};")
  put(string.format("const int %s = %s_sign_of_sum(%d, %d, f_%s);", name, ctx.name, #rows, columns, name))
  return true
end

local words = { p = true, order = true, D = true, S = true, gap = true }

-- Does NAME_sort_moments itself call something so?
local function taken(name)
  return words[name] or string.match(name, "^value") or string.match(name, "^[rs]%d+$")
end

-- The parameters in the expressions as inputs, and their new names.
local function inputs(ctx, list)
  local params, seen = {}, {}
  for _, e in ipairs(list) do
    for _, s in ipairs(expr.symbols(e)) do
      if not seen[s] then params[#params + 1] = { name = s.name, sym = s } end
      seen[s] = true
    end
  end
  return source.parameters(ctx, params, taken)
end

-- The same with rounding: int NAME and a block that computes the atom as it stands.
local function rounded(ctx, name, atom, lines)
  for _, l in ipairs(source.comment("the sign of " .. text.of(atom, "plain"))) do lines[#lines + 1] = l end
  local list, map = inputs(ctx, { atom })
  lines[#lines + 1] = "int " .. name .. ";"
  local out = { c = "const " .. ctx.name .. "_real value_" .. name, expr = calculus.substitute(atom, map) }
  block(source.statements(ctx, { name = name, args = {}, inputs = list, groups = { { defs = {}, outs = { out } } } }),
    lines)
  signs_of_values(ctx, { name }, lines)
end

-- Several from the named parts of the body (mass/parts.lua), which are computed once.  list: {name, why, expression}.
local function from_parts(ctx, body, list, lines)
  local forms, groups, names, pure = {}, {}, {}, {}
  for i, x in ipairs(list) do forms[i], names[i], pure[i] = x[3], x[1], body:resolve(x[3]) end
  local loads, map = inputs(ctx, pure)
  for _, step in ipairs(body:needed(forms)) do
    groups[#groups + 1] = { why = step.about, outs = {},
      defs = { { name = step.name, expr = calculus.substitute(step.e, map) } } }
  end
  for _, x in ipairs(list) do
    groups[#groups + 1] = { why = x[2], defs = {},
      outs = { { c = "const " .. ctx.name .. "_real value_" .. x[1], expr = calculus.substitute(x[3], map) } } }
  end
  lines[#lines + 1] = "int " .. table.concat(names, ", ") .. ";"
  block(source.statements(ctx, { name = "order", args = {}, inputs = loads, groups = groups }), lines)
  signs_of_values(ctx, names, lines)
end

-- A product of signs as C: "-s1*s2", "1", "0".
local function product(s, names)
  if s.sign == 0 then return "0" end
  local list = {}
  for i, a in ipairs(s.atoms) do list[i] = names[a] end
  if #list == 0 then return s.sign > 0 and "1" or "-1" end
  return (s.sign < 0 and "-" or "") .. table.concat(list, "*")
end

-- The difference that is minus difference k because the third is zero; nil if none is.
local function opposite(order, k)
  local i, j = k % 3 + 1, (k + 1) % 3 + 1
  return order[i].sign == 0 and j or order[j].sign == 0 and i or nil
end

local moment = { "I_x", "I_y", "I_z" }

-- The signs of the three differences, or of D, S and gap, as C; lines: what defines them.  A sign that cannot be had
-- exactly is computed from the body's parts if it has such.
local function signs(ctx, s, lines, need)
  local from, sign, names, count, later = s.block or s.order, {}, {}, 0, {}
  local function lossy(p)
    for _, a in ipairs(p.atoms) do
      if not comparison(ctx, a) and not rows_of(ctx, a) then return true end
    end
    return false
  end
  for _, k in ipairs(s.block and { "D", "S", "gap" } or { 1, 2, 3 }) do
    if s.named and lossy(from[k]) then
      local other = not s.block and opposite(s.order, k)
      if other and sign[other] then -- opposite signs stay so when rounded
        sign[k] = "-" .. sign[other]
      else
        sign[k] = s.block and k or "r" .. k
        local why = s.block and k or moment[k % 3 + 1] .. " - " .. moment[(k + 1) % 3 + 1]
        later[#later + 1] = { sign[k], why, s.named[k] }
      end
    else
      for _, a in ipairs(from[k].atoms) do
        if not names[a] then
          count = count + 1
          names[a] = "s" .. count
          if not exactly(ctx, names[a], a, lines, need) then
            rounded(ctx, names[a], a, lines)
            need.rounded = true
          end
        end
      end
      sign[k] = product(from[k], names)
    end
  end
  if #later > 0 then
    from_parts(ctx, s.parts, later, lines)
    need.rounded = true
  end
  return sign
end

-- The lines of NAME_sort_moments, and what they need of NAME_sign_of_sum.
local function order(ctx, s)
  local lines, need = {}, { terms = 0, columns = 0 }
  local sign = signs(ctx, s, lines, need)
  local function put(l) lines[#lines + 1] = l end
  local b = s.block
  for _, w in ipairs(b and { "D", "S" } or {}) do
    if sign[w] ~= w then put("const int " .. w .. " = " .. sign[w] .. ";") end
  end
  put("")
  if not b then
    for i = 1, 3 do put("order[" .. i - 1 .. "] = " .. sign[i] .. ";") end
    return lines, need
  end
  -- the sign of I_p - I_q at the place of the third axis
  local function set(p, q, positive, negative)
    put("order[" .. 6 - p - q - 1 .. "] = " .. (p % 3 + 1 == q and positive or negative) .. ";")
  end
  put("/* D = (I_c - I_i)(I_c - I_j) - I_ij^2, S = 2 I_c - I_i - I_j: the product and the sum of the differences */")
  set(b.c, b.j, "D < 0 ? -1 : D > 0 ? S : S < 0 ? -1 : 0", "D < 0 ? 1 : D > 0 ? -S : S < 0 ? 1 : 0")
  set(b.c, b.i, "D < 0 ? 1 : D > 0 ? S : S > 0 ? 1 : 0", "D < 0 ? -1 : D > 0 ? -S : S > 0 ? -1 : 0")
  set(b.j, b.i, sign.gap, "-" .. sign.gap)
  return lines, need
end

-- Text broken at blanks, continued by two.
local function wrapped(s, out)
  local width, line = 100, ""
  for word in string.gmatch(s, "%S+") do
    if line ~= "" and #line + #word > width then
      out[#out + 1] = line
      line = "     "
    end
    line = line == "" and word or line .. " " .. word
  end
  out[#out + 1] = line
end

local longest = 400 -- characters of a condition in a comment

-- A line for each axis: its conditions without and with dissipation.
local function documentation(s)
  local doc = {}
  for k = 1, 3 do
    local free, lossy = s:condition(k, false, "plain"), s:condition(k, true, "plain")
    if #free > longest or #lossy > longest then
      free, lossy = "by the differences of moments", "by the differences of moments"
    end
    wrapped(string.format("%d  %s: %s; with dissipation: %s", k - 1, s.axes[k], free, lossy), doc)
  end
  return doc
end

-- What order.c needs of NAME_sort_moments, nil where no sign depends on parameters; what stability.h and .c say.
local function decided(ctx, s)
  local atoms = s:atoms()
  local say = { numeric = false, doc = documentation(s), note = {}, order = "", void = #atoms == 0 }
  if #atoms == 0 then
    local fixed = s:signs(function() return 0 end)
    say.order = string.format("const int order[3] = {%d, %d, %d}; /* signs of I1 - I2, I2 - I0, I0 - I1 */", fixed[1],
      fixed[2], fixed[3])
    return nil, say
  end
  local lines, need = order(ctx, s)
  say.note[1] = need.rounded and "Near equality the sign is that of a rounded value." or
    "The signs are exact for the parameters that " .. ctx.name .. "_init was given."
  say.order = "const int *order = m->order; /* signs of I1 - I2, I2 - I0, I0 - I1 */"
  return { lines = lines, sums = need.terms > 0, terms = string.format("%d", need.terms),
    factors = string.format("%d", 1 << need.columns), top = string.format("%d", top[ctx.real]),
    range = string.format("%d", top[ctx.real] - lowest[ctx.real] - digits[ctx.real] * need.columns) }, say
end

-- Which spins persist, s: mass/stability.of, or nil.  {order, say: values of the templates, or nil}
function stability.of(ctx, s)
  if not s then return {} end
  if not s.axes then
    return { say = { numeric = true, void = false, order = "",
      doc = { "0, 1, 2  the axes of " .. ctx.name .. "_principal, ascending moments" },
      note = { "The moments have no simple closed form: those of " .. ctx.name .. "_principal are compared,",
        "and are equal only if they are so to the last bit." } } }
  end
  local signs_of, say = decided(ctx, s)
  return { order = signs_of, say = say }
end

-- The text of NAME_sort_moments; proof: with what Frama-C wants.
function stability.order(made, job, base)
  made.order.proof = job.proof or false
  return ORDER(job.templates, base, made.order) "numeric/order.c"
end

-- Header and source of NAME_spin_stable.
function stability.fragment(made, job, base)
  local render = SPINS(job.templates, base, made.say)
  return render "analysis/stability.h", render "analysis/stability.c"
end

return stability
