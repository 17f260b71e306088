-- sources.lua - the project's own files, for the tests that read them: their names, their lines, the functions in them.
-- SPDX-License-Identifier: GPL-3.0-or-later

local sources = {}

-- The files that find(1) names, sorted: roots and conditions as it takes them.
function sources.files(...)
  local list = {}
  local pipe = assert(io.popen("find " .. table.concat({ ... }, " ") .. " -type f 2>/dev/null | LC_ALL=C sort"))
  for name in pipe:lines() do list[#list + 1] = name end
  pipe:close()
  return list
end

function sources.lines(path)
  local list = {}
  for line in io.lines(path) do list[#list + 1] = line end
  return list
end

-- ---- functions ------------------------------------------------------------------------------------------------------

-- How a function of Lua begins that ends with `end` at the same indent; a function that is an argument belongs to the
-- one around it.
local lua_heads = { "^(%s*)local function ([%w_]+)", "^(%s*)function ([%w_.:]+)", "^(%s*)return (function)%(",
  "^(%s*)([%w_.]+) = function%(", "^(%s*)local ([%w_]+) = function%(" }

local function lua_functions(lines)
  local list = {}
  for from, line in ipairs(lines) do
    local indent, name
    for _, head in ipairs(lua_heads) do
      if not indent then indent, name = line:match(head) end
    end
    local one_line = indent and line:find "%f[%w]end[%s,;)}%]]*$"
    for to = from + 1, indent and not one_line and #lines or 0 do
      if lines[to]:match("^" .. indent .. "end%f[^%w]") then
        list[#list + 1] = { name = name, from = from, lines = to - from + 1 }
        break
      end
    end
  end
  return list
end

-- In C, as clang-format leaves it, a function ends with a brace in the first column, as types and tables do; its head
-- begins in the first column, too, and has a parenthesis and no equals sign.
local function c_functions(lines)
  local list, from = {}, nil
  for at, line in ipairs(lines) do
    if line:find "^[%a]" and not line:find ";%s*$" then
      from = at
    elseif line == "}" and from then
      local head = table.concat(lines, " ", from, math.min(from + 3, at))
      local name = head:match "^[^={]-([%w_]+)%s*%("
      if name then list[#list + 1] = { name = name, from = from, lines = at - from + 1 } end
      from = nil
    end
  end
  return list
end

-- The functions of a file {name, from = line, lines = how many}, in the order of their heads.
function sources.functions(path)
  local lines = sources.lines(path)
  return path:find "%.[ch]$" and c_functions(lines) or lua_functions(lines)
end

return sources
