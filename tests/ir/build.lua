-- build.lua: writes irs by hand for the tests of single passes.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- build.ir { { store, nest }, ... }: a nest is a string (an input), a rational (a constant) or
-- { op, nest, nest } ; tables that are used twice are computed once.  name = in a nest names its value;
-- an element { why =, stores... } of the list opens a group.

local R = require "polhode_rational"
local instr = require "generator.ir.core.instr"

local build = {}

function build.ir(groups)
  local ir = { name = "f", n = 0, inputs = {}, consts = {}, groups = {} }
  local known, code = {}, nil

  local function value(x)
    local key = R.is(x) and tostring(x) .. " const" or x
    if known[key] then return known[key] end
    local i = { dst = 0 }
    if type(x) == "string" then
      i.op, i.sym, i.c = "input", x, x
      table.insert(ir.inputs, i)
    elseif R.is(x) then
      i.op, i.value = "const", x
      table.insert(ir.consts, i)
    else
      i.op, i.name, i.n = x[1], x.name, x.n
      for k, field in ipairs(instr.of(x[1]).srcs) do i[field] = value(x[k + 1]) end
      code[#code + 1] = i
    end
    i.dst = instr.fresh(ir)
    known[key] = i.dst
    return i.dst
  end

  for g, group in ipairs(groups) do
    code = {}
    ir.groups[g] = { why = group.why or "group " .. g, where = group.where, code = code }
    for _, s in ipairs(group) do
      local v = value(s[2])
      if s[1] then code[#code + 1] = { op = "store", src1 = v, c = s[1], assign = s.assign or "=" } end
    end
  end
  return ir
end

-- One nest, stored in y.
function build.one(nest) return build.ir { { { "y", nest } } } end

-- Are a and b the same IEEE datum, all NaNs being one?
function build.same(a, b)
  if a ~= a then return b ~= b end
  return a == b and 1 / a == 1 / b
end

return build
