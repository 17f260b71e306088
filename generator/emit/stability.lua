-- stability.lua -- the emitted NAME_spin_stable: the three signs of differences of moments, exactly, as C text.
--
-- The signs depend on parameters alone, so NAME_init computes them once (NAME_order) and the model keeps them.  An
-- atom (mass/critical.lua) that is a difference of two numbers is a comparison; any other polynomial is a sum of
-- products of parameters, whose sign NAME_sign_of_sum finds without rounding; what is no polynomial, or too large, is
-- computed as it stands and has the sign of the rounded value.  A number of the scene that is not one of the real type
-- stands as a sum of up to three.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local calculus = require "generator.algebra.calculus"
local evaluate = require "generator.algebra.evaluate"
local expr = require "generator.algebra.expr"
local poly = require "generator.algebra.poly"
local text = require "generator.algebra.text"
local number = require "generator.emit.number"
local source = require "generator.emit.source"

local stability = {}

local most_columns, most_terms = 7, 512
local bits = 240 -- of a coefficient that is no rational number
local parts = 3  -- numbers of the real type that a coefficient may take

-- The largest row of a sum is scaled to about 2^top, which leaves room for the split of Dekker's product; the last bit
-- of a subnormal number is 2^lowest.
local top, lowest, digits = { double = 900, float = 100 }, { double = -1074, float = -149 }, { double = 53, float = 24 }

local words = { p = true, order = true, value = true, D = true, S = true } -- what NAME_order itself calls something

local function parameter(ctx, name) return "p[" .. ctx.upper .. "_" .. string.upper(name) .. "]" end

-- c as up to three numbers of the real type that add up to it.
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

-- Does NAME_order itself call something so?
local function taken(name) return name == "p" or name == "order" or name == "value" or string.match(name, "^s%d+$") end

-- Statements that define `const int NAME` for the atom.
local function define(ctx, name, atom, lines, need)
  local function put(l) lines[#lines + 1] = l end
  local compared = comparison(ctx, atom)
  if compared then
    put("const int " .. name .. " = " .. compared .. ";")
    return
  end
  for _, l in ipairs(source.comment("the sign of " .. text.of(atom, "plain"))) do put(l) end
  local rows, columns = rows_of(ctx, atom)
  if rows then
    need.terms = math.max(need.terms, #rows << (columns - 1))
    need.columns = math.max(need.columns, columns)
    put("const " .. ctx.name .. "_real f_" .. name .. "[] = {")
    for i, row in ipairs(rows) do put("    " .. table.concat(row, ", ") .. (i < #rows and "," or "")) end
    put("};")
    put(string.format("const int %s = %s_sign_of_sum(%d, %d, f_%s);", name, ctx.name, #rows, columns, name))
    return
  end
  local params = {}
  for i, s in ipairs(expr.symbols(atom)) do params[i] = { name = s.name, sym = s } end
  local inputs, map = source.parameters(ctx, params, taken)
  local c = source.statements(ctx, { name = name, args = {}, inputs = inputs, groups = { { defs = {},
    outs = { { c = "const " .. ctx.name .. "_real value", expr = calculus.substitute(atom, map) } } } } })
  put("int " .. name .. ";")
  put("{")
  local inner = {}
  for _, l in ipairs(c.loads) do inner[#inner + 1] = l end
  for _, g in ipairs(c.groups) do
    for _, l in ipairs(g.lines) do inner[#inner + 1] = l end
  end
  for _, l in ipairs(inner) do put("  " .. l) end
  local zero = number.text(R.zero, ctx.real)
  put("  " .. name .. " = (value > " .. zero .. ") - (value < " .. zero .. ");")
  put("}")
  need.rounded = true
end

-- A product of signs as C: "-s1*s2", "1", "0".
local function product(s, names)
  if s.sign == 0 then return "0" end
  local list = {}
  for i, a in ipairs(s.atoms) do list[i] = names[a] end
  if #list == 0 then return s.sign > 0 and "1" or "-1" end
  return (s.sign < 0 and "-" or "") .. table.concat(list, "*")
end

-- The lines of NAME_order, and what they need of NAME_sign_of_sum.
local function order(ctx, s)
  local lines, names, need = {}, {}, { terms = 0, columns = 0 }
  for i, a in ipairs(s:atoms()) do
    names[a] = "s" .. i
    define(ctx, names[a], a, lines, need)
  end
  lines[#lines + 1] = ""
  if s.order then
    for i = 1, 3 do lines[#lines + 1] = "order[" .. i - 1 .. "] = " .. product(s.order[i], names) .. ";" end
    return lines, need
  end
  local b = s.block
  local function put(l) lines[#lines + 1] = l end
  for _, w in ipairs { "D", "S" } do
    table.insert(lines, #lines, "const int " .. w .. " = " .. product(b[w], names) .. ";")
  end
  -- the sign of I_p - I_q at the place of the third axis
  local function set(p, q, positive, negative)
    put("order[" .. 6 - p - q - 1 .. "] = " .. (p % 3 + 1 == q and positive or negative) .. ";")
  end
  put("/* D = (I_c - I_i)(I_c - I_j) - I_ij^2, S = 2 I_c - I_i - I_j: the product and the sum of the differences */")
  set(b.c, b.j, "D < 0 ? -1 : D > 0 ? S : S < 0 ? -1 : 0", "D < 0 ? 1 : D > 0 ? -S : S < 0 ? 1 : 0")
  set(b.c, b.i, "D < 0 ? 1 : D > 0 ? S : S > 0 ? 1 : 0", "D < 0 ? -1 : D > 0 ? -S : S > 0 ? -1 : 0")
  local gap = product(b.gap, names)
  set(b.j, b.i, gap, "-" .. gap)
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

-- Fills the values of templates/stability.h and .c and of the model's member.  s: mass/stability.of.
function stability.fill(ctx, s, v)
  v.has_order, v.order_sums, v.order_lines = false, false, {}
  v.order_terms, v.order_factors = "1", "1"
  v.order_range, v.order_top = "0", string.format("%d", top[ctx.real])
  v.stability_note, v.stability_order = {}, ""
  if not s.axes then
    v.stability_doc = { "0, 1, 2  the axes of " .. ctx.name .. "_principal, ascending moments" }
    v.stability_note = { "The moments have no simple closed form: those of " .. ctx.name .. "_principal are compared,",
      "and are equal only if they are so to the last bit." }
    v.stability_void, v.stability_numeric = false, true
    return
  end
  v.stability_numeric = false
  v.stability_doc = documentation(s)
  local atoms = s:atoms()
  if #atoms > 0 then
    local lines, need = order(ctx, s)
    v.has_order, v.order_lines, v.order_sums = true, lines, need.terms > 0
    v.order_terms, v.order_factors = string.format("%d", need.terms), string.format("%d", 1 << need.columns)
    v.order_range = string.format("%d", top[ctx.real] - lowest[ctx.real] - digits[ctx.real] * need.columns)
    v.stability_note = need.rounded and { "Near equality the sign is that of a rounded value." } or
      { "The signs are exact for the parameters that " .. ctx.name .. "_init was given." }
    v.stability_order = "const int *order = m->order; /* signs of I1 - I2, I2 - I0, I0 - I1 */"
    v.stability_void = false
  else
    local signs = s:signs(function() return 0 end)
    v.stability_order = string.format(
      "const int order[3] = {%d, %d, %d}; /* signs of I1 - I2, I2 - I0, " ..
      "I0 - I1 */", signs[1], signs[2], signs[3])
    v.stability_void = true
  end
end

return stability
