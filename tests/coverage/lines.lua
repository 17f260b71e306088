-- lines.lua - which lines can run, and which did: of Lua from luac and hook.c's files, of C from gcov.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local seen = lines.lua(paths, folder)     -- { [path] = { [line] = ran } }
--     local seen = lines.c(notes)               -- the same, of the sources of gcc's .gcno files
--
-- A line of Lua can run if luac shows an instruction on it, in whatever function, called or not.  Two instructions that
-- no one wrote do not count: the return that ends every function, on the line of its `end` (after a `return` of the
-- function's own it never runs), and the first one of a main chunk.  For C gcov says it.

local lines = {}

local function run(command)
  local pipe = assert(io.popen(command))
  local text = pipe:read("a")
  assert(pipe:close(), command)
  return text
end

-- The instructions' lines in one listing of luac.
local function executable(listing)
  local seen, of, last = {}, "", nil
  for line in listing:gmatch "[^\n]+" do
    local path = line:match "^%a+ <([^:>]+):%d+,%d+>"
    local number, name = line:match "^\t%d+\t%[(%-?%d+)%]\t([%u%d_]+)"
    if path then
      seen[path] = seen[path] or {}
      of, last = path, nil -- the last one of the function before goes
    elseif number then
      if last then
        seen[of][last] = false
      end
      last = name ~= "VARARGPREP" and tonumber(number) or nil
    end
  end
  return seen
end

function lines.lua(paths, folder)
  -- one file at a time: given many, luac 5.4.4 frees something twice
  local seen = executable(run("printf '%s\\n' " .. table.concat(paths, " ") .. " | xargs -n 1 luac5.4 -l -p"))
  for _, path in ipairs(paths) do
    local file = io.open(folder .. "/" .. path:gsub("/", "%%"), "rb")
    if file then
      local bytes = file:read("a")
      file:close()
      for line in pairs(seen[path]) do -- any order
        seen[path][line] = bytes:byte(line + 1) == 1
      end
    end
  end
  return seen
end

-- "      12:  34:text", "   #####:  35:text" (did not run), "       -:  36:text" (cannot run).
function lines.c(notes)
  local seen, of = {}, nil
  for line in run("gcov -t " .. table.concat(notes, " ") .. " 2>/dev/null"):gmatch "[^\n]+" do
    local source = line:match "^%s*%-:%s+0:Source:(.*)$"
    local count, number = line:match "^%s*([%d#=*-]+):%s*(%d+):"
    if source then
      of = nil
      if source:find "^src/" then
        seen[source] = seen[source] or {}
        of = seen[source]
      end
    elseif of and count and count ~= "-" then
      number = tonumber(number)
      of[number] = of[number] or count:find "%d" ~= nil
    end
  end
  return seen
end

return lines
