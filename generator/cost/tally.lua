-- tally.lua -- how many operations a function of the emitted C does, counted on its text.
--
-- The text is read by generator/cost/reading.lua, only the functions that are asked for and what they call.  Integers
-- that do not depend on the numbers (loops, orders, indices) are followed exactly.  Where the numbers decide, the
-- costlier branch is counted; so a count is exact where no branch depends on the numbers, else the largest.  Two
-- comments in templates say what no bound would tell: after the brace of a loop `some 8 times` or `mostly once`, for
-- loops that converge, and after that of a branch `rare`, which is not counted.
-- SPDX-License-Identifier: GPL-3.0-or-later

local reading = require "generator.cost.reading"
local tokens = require "generator.cost.tokens"

local tally = {}

-- The C library's functions that emitted code may call (emit/project.lua).
local LIBRARY = { "fabs", "copysign", "sqrt", "sin", "cos", "sinh", "cosh", "frexp", "ldexp", "exp", "log", "floor",
  "fma", "tan", "asin", "acos", "atan", "atan2", "tanh", "pow", "fmod", "hypot", "cbrt", "ceil" }

-- Their names in a scene's code: the C library's, or its own, which count as the same calls (--libm own)
local function library(scene)
  local known = { __builtin_fma = "fma", __builtin_fmaf = "fma" }
  for _, name in ipairs(LIBRARY) do
    known[name], known[name .. "f"], known[scene .. "_" .. name] = name, name, name
  end
  return known
end

-- Which of two costs is the larger, roughly.
local WEIGHT = { add = 1, mul = 1, div = 4, sqrt = 6, fma = 1, cmp = 0.5, conv = 0.5, conv64 = 0.5, mem = 0,
  long = 0.5 }
local function weight(c)
  local sum = 0
  for name, n in pairs(c) do sum = sum + n * (WEIGHT[name] or 30) end -- a sum of few exact terms: in any order
  return sum
end

local function add(to, c, times)
  for name, n in pairs(c) do to[name] = (to[name] or 0) + n * (times or 1) end -- sums by name: in any order
end

-- ---- the text ----

-- The lines that a compiler would keep whose macros are those in the set `defined`, to which the text adds its own.
local function preprocessed(text, defined)
  local out, depth, skipping, pos = {}, 0, nil, 1
  while true do
    local first, last, line, _ = string.find(text, "\n[ \t]*(#[^\n]*)", pos)
    if not first then break end
    if not skipping then out[#out + 1] = string.sub(text, pos, first) end
    local word, rest = string.match(line, "^#%s*(%a+)%s*(.*)$")
    while string.sub(line, -1) == "\\" do
      _, last, line = string.find(text, "^\n([^\n]*)", last + 1)
    end
    if word == "if" or word == "ifdef" or word == "ifndef" then
      depth = depth + 1
      if not skipping then
        local holds = false -- one of the names is enough: what is asked for here is a processor's or a host's
        for name in string.gmatch(rest, "[%a_][%w_]*") do holds = holds or defined[name] or false end
        if word == "ifndef" then holds = not holds end
        if not holds then skipping = depth end
      end
    elseif word == "else" then
      if skipping == depth then skipping = nil elseif not skipping then skipping = depth end
    elseif word == "define" and not skipping then
      defined[string.match(rest, "^[%w_]+")] = true
    elseif word == "endif" then
      if skipping == depth then skipping = nil end
      depth = depth - 1
    end
    pos = last + 1
  end
  if not skipping then out[#out + 1] = string.sub(text, pos) end
  return table.concat(out)
end

-- Name -> kind of a structure's fields.  One that is a structure itself gets a type of its own, struct_NAME.
local fields_of
function fields_of(unit, body)
  local fields = {}
  body = string.gsub(body, "struct%s*(%b{})%s*([%w_]+)", function(inner, name) -- a structure without a name
    local own = "struct_" .. name
    unit.types[own], unit.fields[own] = own, fields_of(unit, string.sub(inner, 2, -2))
    return own .. " " .. name
  end)
  for line in string.gmatch(string.gsub(body, "%b[]", "*"), "[^;]+") do
    local kind
    for word in string.gmatch(line, "[%a_][%w_*]*") do
      local known = unit.types[word] or unit.integer[word] and "int"
      if known then
        kind = known
      elseif word ~= "const" and word ~= "struct" then
        fields[string.match(word, "^[^*]*")] = kind .. string.gsub(word, "[^*]", "")
      end
    end
  end
  return fields
end

-- Without its comments.
local function uncommented(text)
  local out, pos = {}, 1
  while true do
    local first = string.find(text, "/*", pos, true)
    if not first then break end
    out[#out + 1] = string.sub(text, pos, first - 1)
    local _, last = string.find(text, "*/", first + 2, true)
    pos = last + 1
  end
  out[#out + 1] = string.sub(text, pos)
  return table.concat(out)
end

-- What stands between functions, without comments: types, enumerators, tables.
local function outside(unit, text)
  if not string.find(text, ";", 1, true) then return end
  for list in string.gmatch(text, "enum [%w_]*%s*{(.-)}") do
    local n = 0
    for entry in string.gmatch(list, "[^,]+") do
      local name, value = string.match(entry, "([%a_][%w_]*)%s*=?%s*(%d*)")
      if name then
        n = value ~= "" and math.tointeger(tonumber(value)) or n
        unit.constants[name], n = unit.fixed[name] or n, n + 1
      end
    end
  end
  for kind, name in string.gmatch(text, "typedef ([%w_]+) ([%w_]+)") do -- another name; numbers of several bodies
    unit.types[name] = unit.types[kind]
  end
  for body, name in string.gmatch(text, "typedef %a+ [%w_]*%s*(%b{}) ([%w_]+);") do
    unit.types[name] = name
    unit.fields[name] = fields_of(unit, string.sub(body, 2, -2))
  end
  for kind, name in string.gmatch(text, "static const ([%w_]+) ([%w_]+) = [^{;]*;") do unit.globals[name] = kind end
  for kind, name in string.gmatch(text, "static const ([%w_]+) ([%w_]+) = {") do
    unit.globals[name] = unit.types[kind]
  end
  for kind, name, size in string.gmatch(text, "static const ([%w_]+) ([%w_]+)(%[[%w%[%]_ +]*%])") do
    unit.globals[name] = (unit.types[kind] or "int") .. string.gsub(string.gsub(size, "%b[]", "*"), "[^*]", "")
  end
end

-- The functions of the emitted header and source.  name: the scene's; options: {fma = the processor has fused
-- multiplication and addition in the real type, least = the cheaper branch instead, constants = enumerators of other
-- values than the text's, values = of functions whose result is known though the numbers decide it}
function tally.read(name, header, source, options)
  local defined = { FP_FAST_FMA = options.fma, FP_FAST_FMAF = options.fma }
  local unit = { real = name .. "_real", fields = {}, functions = {}, constants = {}, library = library(name),
    types = { [name .. "_real"] = "real", real = "real", double = "real", float = "real", void = "void" },
    globals = { HUGE_VAL = "lit", HUGE_VALF = "lit" }, integer = reading.integer, memo = {},
    least = options.least, fixed = options.constants or {}, values = options.values or {} }
  local text = preprocessed("\n" .. header .. "\n" .. source, defined)
  local pos = 1
  while true do
    local open = string.find(text, "\n{\n", pos, true)
    local between = uncommented(string.sub(text, pos, open or #text))
    outside(unit, between)
    if not open then break end
    local close = string.find(text, "\n}\n", open, true)
    local head = string.match(between, "^.*[;}](.*)$") or between
    local kind, f, parameters = string.match(head, "%f[%w_]([%w_]+)%s+%*?([%a_][%w_]*)%s*(%b())%s*$")
    unit.functions[f] = not unit.library[f] and { result = unit.types[kind] or "int", parameters = parameters,
      text = string.sub(text, open + 1, close + 1) } or nil
    pos = close + 2
  end
  return unit
end

-- ---- the machine ----

local run, items

local BOUND = 300 -- no loop of emitted code is as long

local function copy(t)
  local c = {}
  for k, v in pairs(t) do c[k] = v end -- a copy: order is lost anyway
  return c
end

-- Where the numbers decide between ways that cost a and b: is it the second that is counted?
local function second(unit, a, b)
  local wa, wb = weight(a), weight(b)
  if unit.least then return wb < wa end
  return wb > wa
end

-- Integers after ways that part and meet: what they do not agree on is the larger one, as more turns cost more.
local function meet(unit, env, other)
  for name, value in pairs(other) do -- each by itself: in any order
    local own = env[name]
    if own ~= value then
      env[name] = own and value and (unit.least and math.min or math.max)(own, value) or nil
    end
  end
  for name in pairs(env) do -- each by itself: in any order
    if other[name] == nil then env[name] = nil end
  end
end

-- Is a loop's condition known to fail?  One that the numbers decide holds as long as something else bounds the loop;
-- where it comes last it fails, so that the body is counted once.
local function ends(unit, item, env, total)
  items(unit, item.before, 1, env, total)
  local cond = tokens.number_of(item.cond, env)
  return cond == 0 or cond == nil and (unit.least or item.after)
end

-- A loop whose condition is looked at, turn by turn; returns as items does.
local function loop(unit, item, env, total)
  for turn = 1, BOUND do
    if turn == BOUND then error("a loop without a bound in " .. unit.running, 0) end
    if not item.after and ends(unit, item, env, total) then break end
    local status, value = items(unit, item.body, 1, env, total)
    if status == "return" then return status, value end
    if status == "break" then break end
    items(unit, item.step, 1, env, total)
    if item.after and ends(unit, item, env, total) then break end
  end
end

-- Item i, a branch that the numbers do not decide: both ways are counted, and the dearer one (or with unit.least the
-- cheaper) is taken.  Where one way ends the function or the loop and the other does not, what follows it belongs to
-- the other.  Returns as items does, and whether the rest is counted already.
local function either(unit, code, i, env, total)
  local item, other, a, b = code[i], copy(env), {}, {}
  local sa, va = items(unit, item.yes, 1, env, a)
  local sb, vb = items(unit, item.no, 1, other, b)
  if sa and sb then
    if second(unit, a, b) then a, sa, va = b, sb, vb end
    add(total, a)
    return true, sa, va
  elseif sa or sb then -- one way ends here, the other, a from now on, goes on
    if sa then
      a, b, sb, vb = b, a, sa, va
      for name in pairs(env) do env[name] = nil end -- all of them: in any order
      for name, v in pairs(other) do env[name] = v end -- a copy: order is lost anyway
    end
    local status, value = items(unit, code, i + 1, env, a)
    local last = not unit.least and sb == "return" and second(unit, a, b)
    add(total, last and b or a)
    if value and vb then value = math.max(value, vb) end
    return true, status, value
  end
  add(total, second(unit, a, b) and b or a)
  meet(unit, env, other)
  return false
end

-- Adds what the items cost from number `first` on; returns "return", "break", "continue" or nil, and the value.
function items(unit, code, first, env, total)
  for i = first, #code do
    local item = code[i]
    local kind = item.kind
    local status, value
    if not kind then
      add(total, item)
    elseif kind == "set" then
      env[item.name] = tokens.number_of(item.value, env)
    elseif kind == "call" then
      local args = {}
      for k = 1, 16 do args[k] = tokens.number_of(item.args[k], env) or false end
      local cost, result = run(unit, item.name, args)
      add(total, cost)
      env[item.slot] = result
    elseif kind == "loop" and item.turns then
      for _ = 1, item.turns do
        items(unit, item.before, 1, env, total)
        if items(unit, item.body, 1, env, total) then break end
        items(unit, item.step, 1, env, total)
      end
    elseif kind == "loop" then
      status, value = loop(unit, item, env, total)
    elseif kind == "if" then
      local cond = tokens.number_of(item.cond, env)
      if cond == nil and item.rare then cond = 0 end
      if cond ~= nil then
        status, value = items(unit, cond ~= 0 and item.yes or item.no, 1, env, total)
      else
        local counted
        counted, status, value = either(unit, code, i, env, total)
        if counted then return status, value end
      end
    else
      return kind, tokens.number_of(item.value, env)
    end
    if status then return status, value end
  end
  return nil
end

-- The text with two kinds of comments as words of their own: how often a loop runs where the numbers decide, and a
-- branch that is not counted.
local function hinted(text)
  text = string.gsub(string.gsub(text, "/%* some (%d+) times %*/", "@ %1"), "/%* mostly once[^*]*%*/", "@ 1")
  text = string.gsub(text, "/%* rare[^*]*%*/", "@ rare")
  return (string.gsub(text, "/%*.-%*/", " "))
end

-- A call's operations and, if it is an integer that is known, its result: once for each choice of known integer
-- arguments.  args: false for what is not known.
function run(unit, name, args)
  local f = unit.functions[name]
  if not f.code then
    local read = reading.body(unit, name, f.parameters, hinted(f.text))
    f.code, f.order, f.kinds = read.code, read.parameters, read.kinds
  end
  local key, env = name, {}
  for i, p in ipairs(f.order) do
    if f.kinds[p] == "int" and args[i] then
      env[p] = args[i]
      key = key .. "," .. i .. "=" .. args[i]
    end
  end
  local known = unit.memo[key]
  if known then return known.total, known.value end
  local total, before = {}, unit.running
  unit.running = name
  local _, value = items(unit, f.code, 1, env, total)
  if unit.values[name] then value = unit.values[name] end
  unit.memo[key], unit.running = { total = total, value = value }, before
  return total, value
end

-- The operations of one call, {add =, mul =, ..., sin =, ...}; args: values of integer parameters by position.
function tally.run(unit, name, args)
  local total = run(unit, name, args or {})
  return total
end

function tally.has(unit, name) return unit.functions[name] ~= nil end

return tally
