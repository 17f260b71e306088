-- walk.lua -- what is in an expression: its parts, itself with other parts, its symbols.
--
-- Functions of expr.lua, in a file of their own: expr.children, expr.map, expr.symbols, expr.constant.  ABOVE the line.
-- SPDX-License-Identifier: GPL-3.0-or-later

return function(expr)
  -- The nodes directly below e.
  function expr.children(e)
    if e.kind == "pow" then return { e.base } end
    local list = {}
    for i = 1, #e do list[i] = e[i] end
    return list
  end

  -- A node of e's kind with f applied to each child; e itself where nothing changed.
  function expr.map(e, f)
    if e.kind == "num" or e.kind == "sym" or #e == 0 and e.kind == "call" then return e end
    if e.kind == "pow" then
      local base = f(e.base)
      return base == e.base and e or expr.pow(base, e.exp)
    end
    local list, same = {}, true
    for i = 1, #e do
      list[i] = f(e[i])
      same = same and list[i] == e[i]
    end
    if same then return e end
    if e.kind == "add" then return expr.add(list) end
    if e.kind == "mul" then return expr.mul(list) end
    return expr.call(e.fn, table.unpack(list))
  end

  -- The symbols in e, in canonical order.
  function expr.symbols(e)
    local seen, list = {}, {}
    local function walk(x)
      if seen[x] then return end
      seen[x] = true
      if x.kind == "sym" then list[#list + 1] = x end
      if x.kind == "pow" then return walk(x.base) end
      for i = 1, #x do walk(x[i]) end
    end
    walk(e)
    table.sort(list, function(a, b) return expr.compare(a, b) < 0 end)
    return list
  end

  -- Does e depend on none of the symbols (set: name -> true)?  With no set: on no symbol at all.
  function expr.constant(e, names)
    local seen = {}
    local function free(x)
      if seen[x] then return true end
      seen[x] = true
      if x.kind == "sym" then return names ~= nil and not names[x.name] end
      if x.kind == "pow" then return free(x.base) end
      for i = 1, #x do
        if not free(x[i]) then return false end
      end
      return true
    end
    return free(e)
  end
end
