-- q31.lua -- the fixed-point step as C: constants, statements, the header's table, the self-test's bits.
--
-- Every node of the program (methods/fixed.lua) is one statement.  What is prepared here are lists of lines for
-- templates/steppers/q31*; the program is not changed.  Numbers in comments are for people: three digits.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local number = require "generator.emit.number"
local template = require "generator.emit.template"

local GROUP = template.group("steppers/q31.h", "steppers/q31.c", "steppers/q31_real.c", "test/q31_test.c")

local q31 = {}

local function whole(n) return string.format("%d", n) end
local function word(n) return "INT32_C(" .. whole(n) .. ")" end
local function few(x) return string.format("%.3g", x) end
local function power(e) return e == 0 and "1" or "2^" .. whole(-e) end

-- Text of nodes; keeps which constants and which products it met.
local printer = {}
printer.__index = printer

-- Constants of equal value and exponent are one, K1, K2 ..
function printer:of(node)
  if node.kind ~= "constant" then return node.name end
  if not self.names[node] then
    local key = whole(node.value) .. " " .. whole(node.e)
    local known = self.known[key]
    if not known then
      known = "K" .. whole(#self.constants + 1)
      self.known[key] = known
      self.constants[#self.constants + 1] = { name = known, value = word(node.value),
        about = string.format("%s: %s = %s %s, off by %s", node.about, number.text(node.q, "double"), whole(node.value),
          power(node.e), node.err * 2.0 ^ node.e < 2.0 ^ -60 and "nothing" or few(node.err)) }
    end
    self.names[node] = known
  end
  return self.names[node]
end

local text = {}
local WIDTH = 92 -- of an expression

-- An operand: a node that is used once and whose text is short stands where it is used.
local function operand(p, node, inside)
  if not (p.once[node] and inside[node.kind]) then return p:of(node) end
  p.inline[node] = true
  local s = text[node.kind](p, node)
  return (node.kind == "right" or node.kind == "mul" and node.n > 32) and "(" .. s .. ")" or s
end

-- mul32(a, b), down31(a, b), (down32(a, b) + 2) >> 2
function text.mul(p, o)
  local n = math.min(o.n, 32)
  local name = ((o.down or o.n > 32) and "down" or "mul") .. whole(n)
  p.products[name] = true
  local call = name .. "(" .. p:of(o.a) .. ", " .. p:of(o.b) .. ")"
  if o.n == n then return call end
  return (o.down and call or "(" .. call .. " + " .. whole(1 << o.n - 33) .. ")") .. " >> " .. whole(o.n - 32)
end

function text.product(p, o) return p:of(o.a) .. "*" .. p:of(o.b) end

local once = { right = true, mul = true, product = true, left = true }
local multiplied = { right = true, mul = true }

function text.sum(p, o)
  local out = {}
  for i, t in ipairs(o.terms) do
    local m = math.abs(t[1])
    local sign = t[1] < 0 and (i == 1 and "-" or " - ") or i > 1 and " + " or ""
    out[i] = sign .. (m ~= 1 and whole(m) .. "*" or "") .. operand(p, t[2], m == 1 and once or multiplied)
  end
  if o.more ~= 0 then out[#out + 1] = (o.more < 0 and " - " or " + ") .. whole(math.abs(o.more)) end
  return table.concat(out)
end

local within_right = { sum = true, product = true }

function text.right(p, o)
  return string.format("(%s + %s) >> %s", operand(p, o.a, within_right), whole(1 << o.n - 1), whole(o.n))
end

function text.left(p, o) return p:of(o.a) .. "*" .. whole(1 << o.n) end

-- How often each node is used by those that the results need.
local function uses(program, results)
  local used = {}
  local function use(node) used[node] = (used[node] or 0) + 1 end
  for _, node in ipairs(results) do
    use(node)
    use(node) -- by its name
  end
  for i = #program.ops, 1, -1 do
    local o = program.ops[i]
    if used[o] then
      if o.a then use(o.a) end
      if o.b then use(o.b) end
      for _, t in ipairs(o.terms or {}) do use(t[2]) end
    end
  end
  return used
end

-- The statements of a program as lines.
local function statements(p, program, results)
  local used = uses(program, results)
  p.once, p.inline = {}, {}
  local made = {}
  for i, o in ipairs(program.ops) do -- what stands inside another is known when all have been made
    if used[o] and o.kind ~= "block" then
      made[i] = o.kind == "clip" and string.format("clipped(%s, %s, %s, %s, &bits)", p:of(o.a), word(-o.limit),
        word(o.limit), whole(o.flag) .. "u") or text[o.kind](p, o)
      p.once[o] = used[o] == 1 and #made[i] < WIDTH // 2
    end
  end
  local lines, title = {}, nil
  for i, o in ipairs(program.ops) do
    if o.kind == "block" then
      title = o.text
    elseif made[i] and not p.inline[o] then
      for k, line in ipairs(title or {}) do
        if k == 1 then lines[#lines + 1] = "" end
        lines[#lines + 1] = (k == 1 and "/* " or " * ") .. line .. (k == #title and " */" or "")
      end
      title = nil
      lines[#lines + 1] = "const int32_t " .. o.name .. " = " .. made[i] .. ";"
    end
  end
  return lines
end

local function indent(lines)
  local out = {}
  for i, line in ipairs(lines) do out[i] = line == "" and "" or "  " .. line end
  return out
end

-- x += d with what is below the last place kept in the remainder, from -2^(k-1) to 2^(k-1) - 1.  Of one that was
-- disturbed only the low k bits count, so nothing overflows; t is the sum plus half a unit.
local function updates(layout, upper)
  local lines = {}
  for i, s in ipairs(layout) do
    local place = upper .. "_Q31_" .. string.upper(s.name)
    if s.node and s.k > 0 then
      local rest = upper .. "_Q31_R" .. string.upper(s.name)
      local half, unit = whole(1 << s.k - 1), whole(1 << s.k)
      lines[#lines + 1] = string.format("t = (int32_t)(((uint32_t)x[%s] + %su) & %su) + %s;", rest, half,
        whole((1 << s.k) - 1), s.node.name)
      lines[#lines + 1] = string.format("d = t >> %s;", whole(s.k))
      lines[#lines + 1] = string.format("x[%s] = t - d*%s - %s;", rest, unit, half)
      lines[#lines + 1] = string.format("x[%s] = %s + d;", place, s.name)
    elseif s.node then
      lines[#lines + 1] = string.format("x[%s] = %s + %s;", place, s.name, s.node.name)
    end
    if i == 4 then lines[#lines + 1] = "" end
  end
  return lines
end

-- Rows of the header's table.
local function rows(step, layout, source)
  local out = {}
  for i, s in ipairs(layout) do
    local unit = i > 4 and " rad/s" or ""
    local err = s.node and few(s.node.err) or "0"
    out[i] = string.format("%-5s %-14s %-10s %-15s %s", s.name, power(s.e) .. unit,
      s.k > 0 and power(s.k) or "-", "+-" .. few(s.limit * 2.0 ^ -s.e) .. unit, err .. unit)
  end
  local why = step.rates.why
  return out, (string.gsub(why, "line (%d+) of the scene", source .. ":%1"))
end

local function array(x, from)
  local list = {}
  for i = from or 1, #x do list[#list + 1] = word(x[i]) end
  return list
end

local function wrapped(list, per)
  local lines = {}
  for i = 1, #list, per do lines[#lines + 1] = table.concat(list, ", ", i, math.min(i + per - 1, #list)) .. "," end
  return lines
end

-- The products that the text uses, as mul32 and so on: rounded to nearest or down, n bits dropped.  On a machine of 32
-- bits they are made of halves of 16 (steppers/q31.c), where n bits are the lower half and n - 16 of the middle one.
local function products_used(p)
  local out = {}
  for _, down in ipairs { false, true } do
    for n = 30, 32 do
      local name = (down and "down" or "mul") .. whole(n)
      if p.products[name] then
        out[#out + 1] = { name = name, n = whole(n), times = n < 32 and "*" .. whole(1 << 32 - n) or "",
          rest = whole(n - 16), round = down and "0" or string.format("0x%x", 1 << n - 17),
          long_round = down and "" or string.format(" + INT64_C(0x%x)", 1 << n - 1) }
      end
    end
  end
  return out
end

-- The words of the state: limits, units, and what conversion from and to real numbers multiplies by.
local function state_words(layout)
  local out = {}
  for i, l in ipairs(layout) do
    out[i] = { name = l.name, upper = string.upper(l.name), limit = word(l.limit), rate = i > 4,
      tail = i < 7 and " &&" or ";", scale = number.text(R.new(2) ^ l.e, "double"),
      unit = number.text(R.new(2) ^ -l.e, "double"),
      norm = i <= 4 and "*n" or "", one = whole(1 << l.k), place = whole(i - 1), bit = whole(1 << i - 1) }
  end
  return out
end

-- The words of the inputs, and the bits that tell of those beyond their limits.
local function input_words(step)
  local out, bits = {}, 0
  for i, u in ipairs(step.u) do
    local unit = u.unit == "1" and "" or " " .. u.unit
    out[i] = { name = u.node.name, upper = u.index, bit = whole(1 << u.bit), shift = whole(u.bit),
      low = word(u.low), high = word(u.high), scale = number.text(R.new(2) ^ u.exponent, "double"),
      row = string.format("%-10s unit %s%s, limited to %s .. %s%s", u.label, power(u.exponent), unit,
        few(u.low * 2.0 ^ -u.exponent), few(u.high * 2.0 ^ -u.exponent), unit) }
    bits = bits | 1 << u.bit
  end
  return out, whole(bits)
end

-- The self-test's runs; a run goes on from where the one before it ended (`more` steps).
local function test_cases(cases)
  local out = {}
  for i, c in ipairs(cases) do
    local case = { n = whole(i), start = wrapped(array(c.start), 5), runs = {}, what = c.what,
      u = table.concat(array(c.u or { 0 }), ", ") }
    local last = 0
    for k, r in ipairs(c.runs) do
      case.runs[k] = { steps = whole(r.steps), more = whole(r.steps - last), want = wrapped(array(r.x), 5),
        bits = whole(r.bits) .. "u" }
      last = r.steps
    end
    out[i] = case
  end
  return out
end

-- job.q31: {step, layout, start, energy = {program, node}, cases = {{start =, u =, runs = {{steps, x, bits}}}}}
function q31.files(job, base)
  local s = job.q31
  local step, layout, upper = s.step, s.layout, base.upper
  local p = setmetatable({ names = {}, known = {}, constants = {}, products = {} }, printer)
  local w = {}
  local results = {}
  for i = 1, 7 do results[#results + 1] = layout[i].node or nil end
  w.body = indent(statements(p, step.program, results))
  w.energy_body = indent(statements(p, s.energy.program, { s.energy.node }))
  w.energy_start = word(s.energy.start)
  w.energy_node, w.energy_unit = p:of(s.energy.node), power(s.energy.node.e)
  w.constants, w.products = p.constants, products_used(p)
  w.updates = indent(updates(layout, upper))
  w.rows, w.why = rows(step, layout, job.source)
  w.words = state_words(layout)
  w.has_input = #step.u > 0
  w.inputs, w.input_bits = input_words(step)
  w.norm_limit = few(step.norm_limit * 2.0 ^ -28)
  w.step_seconds = number.text(step.h, "double")
  w.start_lines = wrapped(array(s.start), 5)
  w.cases = test_cases(s.cases)
  local n, render = job.model.name, GROUP(job.templates, base, w)
  return { { name = n .. "_q31.h", text = render "steppers/q31.h" },
    { name = n .. "_q31.c", text = render "steppers/q31.c" },
    { name = n .. "_q31_real.c", text = render "steppers/q31_real.c" },
    { name = n .. "_q31_test.c", text = render "test/q31_test.c" } }
end

return q31
