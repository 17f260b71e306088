-- show.lua: an ir as text for people (`gen --show PASS`) and for tests.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- One instruction a line, grouped, each group under its comment; constants stand as exact rationals
-- where they are used (shortened if they are a long approximation).  v7 is value number 7; a named
-- intermediate is shown by its name; the type of every value is the real of the target.
--
--     ir brick_rhs: real, 42 values
--       real wy = input x[BRICK_WY]
--       -- Euler: I w' = -w x (I w)    [brick.lua:5]
--       real v7 = mul wy, wz
--       store dx[BRICK_WX] = v8

local R = require "polhode_rational"
local instr = require "generator.ir.core.instr"

local show = {}

local LONGEST = 24 -- characters of an exact constant before it is shown rounded

local function constant(q)
  local text = tostring(q)
  if #text <= LONGEST then return text end
  return string.format("~%.17g", R.todouble(q))
end

local function operands(i, label)
  local list = {}
  for _, field in ipairs(instr.srcs(i)) do list[#list + 1] = label(i[field]) end
  return list
end

-- real: "double" or "float" where it is settled, else "real".
function show.run(ir, real)
  real = real or "real"
  local define = instr.definitions(ir)

  local function label(v)
    local i = define[v]
    if not i then return "v" .. v .. "?" end
    if i.op == "const" then return constant(i.value) end
    return i.name or i.sym or "v" .. v
  end

  local lines = { string.format("ir %s: %s, %d values", ir.name or "?", real, ir.n) }
  local function line(...) lines[#lines + 1] = "  " .. string.format(...) end

  for _, i in ipairs(ir.inputs) do line("%s %s = input %s", real, i.sym, i.c) end
  for _, group in ipairs(ir.groups) do
    lines[#lines + 1] = ""
    if group.why then line("-- %s%s", group.why, group.where and "    [" .. group.where .. "]" or "") end
    for _, i in ipairs(group.code) do
      local args = operands(i, label)
      if i.op == "store" then
        line("store %s %s %s", i.c, i.assign, args[1])
      else
        for _, field in ipairs(instr.immediates(i)) do args[#args + 1] = tostring(i[field]) end
        line("%s %s = %s %s", real, label(i.dst), i.op, table.concat(args, ", "))
      end
    end
  end
  return table.concat(lines, "\n") .. "\n"
end

return show
