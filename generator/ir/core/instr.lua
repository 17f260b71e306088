-- instr.lua: the instruction table of the IR, declared once, and what follows from it.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Below the line: every value is an IEEE number of the target's `real` (double or float), every
-- operation rounds once, and only value-preserving rewrites are legal.  Only constants are still
-- exact rationals; they round when they are printed or evaluated.
--
-- An ir is { name, n, inputs, consts, groups }: n is the highest value number given out; inputs and
-- consts are lists of `input` and `const` instructions; a group is { why, where, code } and code is a
-- list of the other instructions.  A value number (field dst) is defined once and before its uses.
-- An instruction that bears `name` is a named intermediate of the source and keeps that name in C.
--
-- Naming convention: a field src* is a value number that is read, dst one that is defined, all other
-- fields are immediates.  Passes use srcs(), immediates(), renamed() and never enumerate opcodes to
-- find operands.  An opcode that is not in the table is a loud error everywhere.
--
-- Not here: evaluation order of a program (lower, order), rewriting (fold, cse, power).

local R = require "polhode_rational"
local special = require "generator.ir.special.special"

local instr = {}

local HUGE = math.huge

-- ---- evaluation of the functions that Lua's math library lacks -------------------------------------

-- Correctly rounded by MPFR; `ends` gives the values at -inf and +inf.  The odd functions keep the
-- sign of zero, which a rational cannot carry.
local function by_mpfr(fn, ends, at_zero)
  return function(x)
    if x ~= x then return x end
    if x == 0 then return at_zero or x end
    if x == math.huge then return ends[2] elseif x == -math.huge then return ends[1] end
    local value = R.apply(fn, 53, R.fromdouble(x))
    if value then return R.todouble(value) end
    return x > 0 and ends[2] or ends[1] -- out of range: these functions are finite on finite x
  end
end

-- The value of x^n is by definition that of this chain, each step rounded; the power pass unrolls
-- exactly it.
local function powi(x, n, rounded)
  if n == 1 then return x end
  if n % 2 == 1 then return rounded(powi(x, n - 1, rounded) * x) end
  local half = powi(x, n // 2, rounded)
  return rounded(half * half)
end

-- ---- the table --------------------------------------------------------------------------------------

-- fields   operands and immediates, in order
-- c        how it is written in C: "infix" with symbol and level, "prefix", "call" with the libm stem
--          (the suffix f follows `real`), "helper" with the stem of a function that the file defines,
--          "literal", "name", "store", or nil if it never reaches C
-- level    binding strength: 1 for + and -, 2 for * and /, 3 for the unary minus, 4 for operands
-- cost     class of count.lua: add, mul, div, sqrt, call, or free
-- apply    the IEEE result from two operands, instruction and the rounding to `real`, helpers from the
--          rounding and all operands; its last rounding is left to the caller
local op = {}

-- Enters an opcode; operands and immediates follow from the names of its fields.
local function declare(name, entry)
  entry.srcs, entry.immediates = {}, {}
  for _, field in ipairs(entry.fields) do
    if string.match(field, "^src") then
      table.insert(entry.srcs, field)
    elseif field ~= "dst" then
      table.insert(entry.immediates, field)
    end
  end
  op[name] = entry
end

declare("const", { fields = { "dst", "value" }, c = "literal", cost = "free" })
declare("input", { fields = { "dst", "sym", "c" }, c = "name", cost = "free" })
declare("store", { fields = { "src1", "c", "assign" }, c = "store", cost = "free" })
declare("neg", { fields = { "dst", "src1" }, c = "prefix", symbol = "-", level = 3, cost = "free",
  apply = function(x) return -x end })
declare("add", { fields = { "dst", "src1", "src2" }, c = "infix", symbol = " + ", level = 1, cost = "add",
  commutes = true, apply = function(x, y) return x + y end })
declare("sub", { fields = { "dst", "src1", "src2" }, c = "infix", symbol = " - ", level = 1, cost = "add",
  apply = function(x, y) return x - y end })
declare("mul", { fields = { "dst", "src1", "src2" }, c = "infix", symbol = "*", level = 2, cost = "mul",
  commutes = true, apply = function(x, y) return x * y end })
declare("div", { fields = { "dst", "src1", "src2" }, c = "infix", symbol = "/", level = 2, cost = "div",
  apply = function(x, y) return x / y end })
declare("powi", { fields = { "dst", "src1", "n" }, cost = "mul",
  apply = function(x, _, i, rounded) return powi(x, i.n, rounded) end })

-- libm functions: name, number of operands, cost class, evaluation.  Each is an opcode of its own.
for _, row in ipairs {
  { "sqrt", 1, "sqrt", math.sqrt },
  { "fabs", 1, "free", math.abs },
  { "copysign", 2, "free", function(x, y) return y < 0 and -math.abs(x) or math.abs(x) end },
  { "sin", 1, "call", math.sin },
  { "cos", 1, "call", math.cos },
  { "tan", 1, "call", math.tan },
  { "asin", 1, "call", math.asin },
  { "acos", 1, "call", math.acos },
  { "atan", 1, "call", function(x) return math.atan(x) end },
  { "atan2", 2, "call", function(y, x) return math.atan(y, x) end },
  { "exp", 1, "call", math.exp },
  { "log", 1, "call", function(x) return math.log(x) end },
  { "sinh", 1, "call", by_mpfr("sinh", { -HUGE, HUGE }) },
  { "cosh", 1, "call", by_mpfr("cosh", { HUGE, HUGE }, 1.0) },
  { "tanh", 1, "call", by_mpfr("tanh", { -1.0, 1.0 }) },
  { "cbrt", 1, "call", by_mpfr("cbrt", { -HUGE, HUGE }) },
  { "pow", 2, "call", function(x, y) return x ^ y end },
} do
  local name, arity, cost, apply = table.unpack(row)
  declare(name, { fields = { "dst", "src1", arity == 2 and "src2" or nil },
    c = "call", stem = name, level = 4, cost = cost, apply = apply })
end

-- Functions that libm lacks.
for _, row in ipairs(special.list) do
  local name, arity, value = table.unpack(row)
  local fields = { "dst" }
  for k = 1, arity do fields[k + 1] = "src" .. k end
  declare(name, { fields = fields, c = "helper", stem = name, level = 4, cost = "call",
    apply = function(x, y, _, rounded, ...) return value(rounded, x, y, ...) end })
end

-- ---- reading instructions -------------------------------------------------------------------------------

-- The table's entry of an opcode; unknown opcodes are bugs of the caller.
function instr.of(opcode)
  return op[opcode] or error("ir: unknown opcode '" .. tostring(opcode) .. "'", 2)
end

-- Names of the operand fields of instruction i, in order.
function instr.srcs(i)
  return instr.of(i.op).srcs
end

function instr.immediates(i)
  return instr.of(i.op).immediates
end

-- i with operands map[v] for v where that is set: i itself if none is, else a copy.
function instr.renamed(i, map)
  local same = true
  for _, field in ipairs(instr.srcs(i)) do same = same and not map[i[field]] end
  if same then return i end
  local copy = { op = i.op, dst = i.dst, name = i.name }
  for _, field in ipairs(instr.immediates(i)) do copy[field] = i[field] end
  for _, field in ipairs(instr.srcs(i)) do copy[field] = map[i[field]] or i[field] end
  return copy
end

-- A copy of i that bears `name`.
function instr.named(i, name)
  local copy = {}
  for _, field in ipairs(instr.of(i.op).fields) do copy[field] = i[field] end
  copy.op, copy.name = i.op, name
  return copy
end

-- Calls visit(i, group) for every instruction in program order; group is nil for inputs and consts.
function instr.each(ir, visit)
  for _, i in ipairs(ir.inputs) do visit(i) end
  for _, i in ipairs(ir.consts) do visit(i) end
  for _, group in ipairs(ir.groups) do
    for _, i in ipairs(group.code) do visit(i, group) end
  end
end

-- Value number -> the instruction that defines it.
function instr.definitions(ir)
  local by_value = {}
  instr.each(ir, function(i) if i.dst then by_value[i.dst] = i end end)
  return by_value
end

-- Value number -> how often it is read.
function instr.uses(ir)
  local count = {}
  instr.each(ir, function(i)
    for _, field in ipairs(instr.srcs(i)) do count[i[field]] = (count[i[field]] or 0) + 1 end
  end)
  return count
end

-- An ir like `ir` with rewrite(i, emit) called for each instruction of the groups in order; rewrite
-- emits what takes its place.  Inputs and constants are shared with the old ir, in new lists.
function instr.rebuilt(ir, rewrite)
  local new = { name = ir.name, n = ir.n, groups = {},
    inputs = table.move(ir.inputs, 1, #ir.inputs, 1, {}),
    consts = table.move(ir.consts, 1, #ir.consts, 1, {}) }
  for g, group in ipairs(ir.groups) do
    local code = {}
    local function emit(i) code[#code + 1] = i end
    for _, i in ipairs(group.code) do
      instr.of(i.op) -- loud here, whatever the pass looks at
      rewrite(i, emit, new)
    end
    new.groups[g] = { why = group.why, where = group.where, code = code }
  end
  return new
end

-- A fresh value number of ir.
function instr.fresh(ir)
  ir.n = ir.n + 1
  return ir.n
end

return instr
