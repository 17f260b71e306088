-- libm.lua -- the mathematical functions that stand in the emitted code itself (--libm own), or the C library's names.
--
--     libm.names(ctx, own)        the values ${sin}, ${huge} ... that templates call functions by
--     libm.source(base, ctx, templates, text)   C text of the functions that `text` calls, and of what these call
--     libm.linked(ctx, text)      must the text be linked with -lm?
-- Everything is plain arithmetic on the real type and integers, each step rounded once, so the same bits come out on
-- every machine.  Series are economised in exact rationals (economy.lua), their coefficients rounded once.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local economy = require "generator.emit.economy"
local number = require "generator.emit.number"
local plain = require "generator.emit.plain"
local template = require "generator.emit.template"

local libm = {}

-- What each function calls itself.
local FUNCTIONS = {
  huge = { "real" }, fabs = { "number" }, copysign = { "bits", "real" }, sqrt = { "number" }, cbrt = { "bits", "real" },
  floor = { "bits", "real" }, frexp = { "bits", "real" }, ldexp = { "bits", "real" }, sin = { "circular" },
  cos = { "circular" }, tan = { "near", "product" }, exp = { "parts", "ldexp" }, sinh = { "halves", "fabs" },
  cosh = { "halves", "fabs" }, tanh = { "parts", "ldexp", "fabs" }, log = { "mantissa" },
  pow = { "mantissa", "product", "parts", "ldexp", "floor", "fabs" },
  atan = { "angle", "fabs" }, atan2 = { "angle", "supplement", "fabs", "frexp", "ldexp" },
  asin = { "angle", "beside", "fabs" }, acos = { "angle", "beside", "supplement", "fabs" },
}
-- The same of what only they call.
local HELPERS = {
  bits = { "number" }, real = { "number" }, circular = { "near" }, near = { "reduce" }, reduce = { "bits", "real" },
  halves = { "parts", "ldexp" }, mantissa = { "bits", "real" }, angle = { "product" }, beside = { "product", "sqrt" },
}
local ALSO = { double = { reduce = { "product", "fabs" } }, float = {} }
local TEXTS = { "numeric/libm_bits.c", "numeric/libm_root.c", "numeric/libm_product.c", "numeric/libm_circular.c",
  "numeric/libm_exp.c", "numeric/libm_log.c", "numeric/libm_arc.c" }
local GROUP = template.group(table.unpack(TEXTS))

local SYSTEM = { "fabs", "copysign", "sqrt", "sin", "cos", "sinh", "cosh", "frexp", "ldexp", "exp", "log", "floor",
  "fma", "atan2" }

-- All of <math.h> that the code calls.
local INCLUDED = { "tan", "tanh", "asin", "acos", "atan", "pow", "cbrt", "hypot", "fmod", "ceil",
  table.unpack(SYSTEM) }

-- ctx: {name, real}
function libm.names(ctx, own)
  local f, v = ctx.real == "float" and "f" or "", {}
  for _, fn in ipairs(SYSTEM) do v[fn] = own and ctx.name .. "_" .. fn or fn .. f end
  v.huge = own and ctx.name .. "_huge()" or f == "f" and "HUGE_VALF" or "HUGE_VAL"
  if own then v.fma = "__builtin_fma" .. f end -- only where the processor has it
  v.fast_fma = f == "f" and "FP_FAST_FMAF" or "FP_FAST_FMA"
  v.arm_fma = f == "f" and "4" or "8" -- the bit of __ARM_FP: a Cortex-M4F computes in float only
  return v
end

-- Does the text call the function?
local function calls(text, fn) return plain.word(text, fn .. "(") end

-- Must a program with this text be linked with the C library's mathematics, -lm?  What compilers always turn into
-- instructions needs no library.
function libm.linked(ctx, text)
  local f = ctx.real == "float" and "f" or ""
  for _, fn in ipairs(ctx.own and {} or SYSTEM) do
    local inline = fn == "fabs" or fn == "copysign"
    if not inline and calls(text, fn .. f) then return true end
  end
  return false
end

-- Does the text need <math.h>: a function of it, or one of its macros?
function libm.included(ctx, text)
  if ctx.own then return false end
  if string.find(text, "FP_FAST_FMA", 1, true) or string.find(text, "HUGE_VAL", 1, true) then return true end
  local f = ctx.real == "float" and "f" or ""
  for _, fn in ipairs(INCLUDED) do
    if calls(text, fn .. f) then return true end
  end
  return false
end

-- ---- constants ----

local PRECISION = 220 -- bits of pi, log 2

local function apply(fn, x) return R.apply(fn, PRECISION, x and R.lift(x)) end

local formats = {
  float = { format = "binary32", f = "f", digits = 24, exponent = 8, width = 32 },
  double = { format = "binary64", f = "", digits = 53, exponent = 11, width = 64 },
}

local function rounded(q, real) return R.fromdouble(real == "float" and R.tofloat(q) or R.todouble(q)) end

-- q cut after so many bits
local function cut(q, bits)
  local unit = R.new(2) ^ (R.log2(q) - bits + 1)
  return R.new(R.toint(R.floor(q/unit)))*unit
end

-- The bits of a number in [1/4, 2), as C.
local function pattern(q, F, real)
  local x = rounded(q, real)
  local e = R.log2(x)
  local bias = (1 << F.exponent - 1) - 1
  local fraction = R.toint(x*R.new(2) ^ (F.digits - 1 - e)) - (1 << F.digits - 1)
  return string.format("0x%0" .. F.width // 4 .. "XU", (e + bias << F.digits - 1) + fraction)
end

-- Statements for sum c[k] z^k in `name`: even and odd powers side by side.
local function polynomial(name, c, z, real, type_name)
  local lines = {}
  local function text(k) return number.text(c[k], real) end
  local function signed(k) return (R.sign(c[k]) < 0 and " - " or " + ") .. number.text(R.abs(c[k]), real) end
  local function horner(last, first, step, power)
    local s = text(last)
    for k = last - step, first, -step do
      s = (k == last - step and s .. "*" .. power or "(" .. s .. ")*" .. power) .. signed(k)
    end
    return s
  end
  local function put(what, s)
    local line = "const " .. type_name .. " " .. what .. " = " .. s .. ";"
    while #line > 96 do
      local at = 96
      while string.sub(line, at, at) ~= " " do at = at - 1 end
      lines[#lines + 1] = string.sub(line, 1, at - 1)
      line = "  " .. string.sub(line, at + 1)
    end
    lines[#lines + 1] = line
  end
  local n = #c
  if n < 3 then
    put(name, horner(n, 0, 1, z))
  else
    local square, even = name .. "2", n - n%2
    put(square, z .. "*" .. z)
    put(name .. "_odd", horner(n - (n + 1)%2, 1, 2, square))
    put(name, "(" .. horner(even, 0, 2, square) .. ") + " .. z .. "*" .. name .. "_odd")
  end
  return lines
end

local function factorial(n) return n < 2 and R.one or R.new(n)*factorial(n - 1) end

-- Coefficients of f(0), f(1) ... as many as `bits` want on 0 <= z <= h.
local function series(f, h, bits, terms)
  local c = {}
  for k = 0, terms or 24 do c[k] = f(k) end
  return economy.shorten(c, R.lift(h), R.new(2) ^ -bits)
end

-- tanh x = sum of 2^2n (2^2n - 1) B_2n x^(2n-1)/(2n)! (DLMF 4.33.3), by tanh' = 1 - tanh^2
local function tanh_series(terms)
  local t = { [0] = R.one } -- tanh x = sum t[k] x^(2k+1)
  for k = 1, terms + 1 do
    local sum = R.zero
    for i = 0, k - 1 do sum = sum + t[i]*t[k - 1 - i] end
    t[k] = -sum/R.new(2*k + 1)
  end
  return function(k) return t[k + 1] end
end

local function fill_series(L, real, type_name)
  local bits = formats[real].digits
  local function put(name, variable, c)
    for k = 0, #c do c[k] = rounded(c[k], real) end
    L[name .. "_lines"] = polynomial(variable, c, "z", real, type_name)
  end
  local quarter_pi2 = "0.61685028" -- (pi/4)^2, rounded up
  put("sine", "s", series(function(k) return R.new(-1) ^ (k + 1)/factorial(2*k + 3) end, quarter_pi2, bits + 1))
  put("cosine", "c", series(function(k) return R.new(-1) ^ k/factorial(2*k + 4) end, quarter_pi2, bits + 3))
  local half_log2 = "0.1202" -- (log(2)/2)^2 and a little
  put("even", "e", series(function(k) return R.one/factorial(2*k + 2) end, half_log2, bits + 1))
  put("odd", "o", series(function(k) return R.one/factorial(2*k + 3) end, half_log2, bits - 1))
  put("sinh", "p", series(function(k) return R.one/factorial(2*k + 3) end, 1, bits + 3))
  put("tanh", "p", series(tanh_series(60), "25/64", bits + 2, 60))
  put("arc", "p", series(function(k) return R.new(-1) ^ (k + 1)/R.new(2*k + 3) end, "1/16", bits - 1))
  put("pow", "p", series(function(k) return R.new(1, 2*k + 5) end, "0.02944", bits + 1, 40))
  put("log", "p", series(function(k) return R.new(2, 2*k + 3) end, "0.02944", bits - 3, 40))
end

-- 2/pi as words of 32 bits after some zeros, six words a line: what a large argument is multiplied by (Payne and Hanek,
-- templates/numeric/libm_circular.c).
local function inverse_lines(zeros, words)
  local x, list, lines = R.lift(2)/R.apply("pi", 32*words + 64), {}, {}
  for _ = 1, zeros do list[#list + 1] = "0x00000000U" end
  for _ = zeros + 1, words do
    x = x*R.new(1 << 32)
    local whole = R.toint(R.floor(x))
    list[#list + 1] = string.format("0x%08XU", whole)
    x = x - R.new(whole)
  end
  for i = 1, #list, 6 do
    lines[#lines + 1] = table.concat(list, ", ", i, math.min(i + 5, #list)) .. (i + 5 < #list and "," or "")
  end
  return lines
end

local function fill_constants(L, real)
  local F = formats[real]
  local d, bias = F.digits, (1 << F.exponent - 1) - 1
  local function n(q) return number.text(R.lift(q), real) end
  local function two(k) return R.new(2) ^ k end
  local function hex(i) return string.format("0x%0" .. F.width // 4 .. "XU", i) end
  local function int(i) return string.format("%d", i) end
  local fraction = (1 << d - 1) - 1
  L.round_off = n(R.new(3)*two(d - 2))
  L.format, L.f, L.digits, L.width = F.format, F.f, int(d), int(F.width)
  L.uint, L.exponent_bits, L.fraction_bits, L.bias = "uint" .. L.width .. "_t", int(F.exponent), int(d - 1), int(bias)
  L.exponent_field, L.exponent_last = int((1 << F.exponent) - 1) .. "U", int((1 << F.exponent) - 1)
  L.sign, L.magnitude = hex(1 << F.width - 1), hex((1 << F.width - 1) - 1)
  L.fraction, L.hidden = hex(fraction), hex(fraction + 1)
  L.infinity = hex((1 << F.exponent) - 1 << d - 1)
  L.one_bits, L.half_bits = pattern(R.one, F, real), pattern(R.half, F, real)
  L.root_half_bits = pattern(apply("sqrt", "1/2"), F, real)
  L.two_bits, L.two64, L.farthest = n(two(d)), n(two(-64)), real == "float" and "400" or "4000"
  L.sse_math = real == "float" and "__SSE_MATH__" or "__SSE2_MATH__"
  -- sine and cosine
  local pi = apply "pi"
  L.nearest_multiple, L.product_bits = real == "float" and "30" or "61", real == "float" and "64" or "128"
  L.leading_zeros = real == "float" and "32" or "64"
  L.inverse_lines = real == "float" and inverse_lines(1, 8) or inverse_lines(2, 39)
  L.quarter_pi_bits, L.tiny_bits = pattern(pi/R.new(4), F, real), hex(bias - (d + 1)//2 << d - 1)
  L.half_pi_fixed = string.format("0x%XU", R.toint(R.floor(pi*two(30) + R.half)))
  L.high_unit, L.low_unit = n(two(-23)), n(two(-55))
  L.two53_inverse, L.two106_inverse, L.two126_inverse = n(two(-53)), n(two(-106)), n(two(-126))
  L.inverse_half_pi = n(R.new(2)/pi)
  local first, high = cut(pi/R.new(2), d - 20), rounded(pi/R.new(2), real)
  L.half_pi_first, L.half_pi_second = n(first), n(pi/R.new(2) - first)
  L.half_pi_high, L.half_pi_low = n(high), n(pi/R.new(2) - high)
  L.nearby, L.too_near = n(R.new(1600000)), n(two(-8))
  -- exponentials
  local log2 = apply("log", 2)
  first = cut(log2, d - (real == "float" and 9 or 12)) -- times k, which has no more bits
  L.log2_first, L.log2_second, L.inverse_log2 = n(first), n(log2 - first), n(R.one/log2)
  L.exp_most, L.exp_least = n(log2*R.new(bias + 1)), n(-log2*R.new(bias + d + 1))
  L.sinh_most, L.tanh_near = n(log2*R.new(bias + 2)), n(R.new(5, 8))
  L.pow_most = n(two(d + 20)) -- |log x| >= 2^-d: with a larger power all overflows
  L.pow_bits = int(d == 24 and 35 or 65)
  local third = R.new(1, 3)
  L.third_high, L.third_low = n(rounded(third, real)), n(third - rounded(third, real))
  -- angles and roots
  local function pair(name, x) L[name .. "_high"], L[name .. "_low"] = n(rounded(x, real)), n(x - rounded(x, real)) end
  pair("quarter_pi", pi/R.new(4))
  pair("arc_half", apply("atan", "1/2"))
  L.tiny, L.arc_second = n(two(-((d + 1)//2))), n "0.72"
  local third_of = (R.new(2*bias, 3) - R.lift "0.0331")*two(d - 1) -- t^3 is within 5 % of x
  L.cbrt_start, L.cbrt_steps = hex(R.toint(R.floor(third_of))), d == 24 and "1" or "2"
  L.high_half = hex((1 << F.width - 1) - (1 << (d + 1)//2))
  L.cube, L.cube_root = n(two(3*(d//3 + 1))), n(two(-(d//3 + 1)))
  L.tanh_far = n(log2*R.new(d + 2)/R.new(2))
end

-- C text of what `text` calls, "" if that is nothing
function libm.source(base, ctx, templates, text)
  local need, called = {}, false
  local function want(name)
    if need[name] then return end
    need[name], called = true, true
    for _, other in ipairs(FUNCTIONS[name] or HELPERS[name] or {}) do want(other) end
    for _, other in ipairs(ALSO[ctx.real][name] or {}) do want(other) end
  end
  for name in string.gmatch(text, "%f[%w_]" .. ctx.name .. "_(%l[%l%d]*)%(") do
    if FUNCTIONS[name] then want(name) end
  end
  if not called then return "" end
  local L = { need = setmetatable(need, { __index = function() return false end }), single = ctx.real == "float" }
  fill_constants(L, ctx.real)
  fill_series(L, ctx.real, ctx.name .. "_real")
  local render, parts = GROUP(templates, base, L), {}
  for _, name in ipairs(TEXTS) do
    local part = render(name)
    if part ~= "" then parts[#parts + 1] = part end
  end
  return table.concat(parts, "\n")
end

return libm
