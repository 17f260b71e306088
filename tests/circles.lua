-- circles.lua - files of C that use each other in a circle, by a light reading of their text.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     circles.find(paths)      a list of texts, "a.c -> b.c (name) -> a.c (name)", one for each circle
--
-- A file defines a function or an object if that stands at the beginning of a line and is not static; it uses what it
-- names anywhere else.  Headers are no files here: what is in them is static, or defined elsewhere.  NAME##x uses all
-- objects that begin with NAME.

local circles = {}

-- The text without comments, strings and directives; macros' bodies stay.
local function code(path)
  local file = assert(io.open(path))
  local text = file:read "a"
  file:close()
  text = text:gsub("/%*.-%*/", " "):gsub("//[^\n]*", ""):gsub("\\\n", " "):gsub("\\.", ""):gsub('"[^"\n]*"', '""')
  return "\n" .. text:gsub("\n#%s*include[^\n]*", "\n"):gsub("\n#%s*if[^\n]*", "\n")
end

-- Calls call(name, is it an object) for each name that the text defines for others.
local function defined(text, call)
  local function global(head, name, object)
    if not head:find "^static%f[%W]" and not head:find "^typedef%f[%W]" then call(name, object) end
  end
  for head, name in text:gmatch "%f[^\n](%a[^\n;{}#=()]-)([%a_][%w_]*)%s*%b()%s*{" do global(head .. " ", name) end
  for head, name in text:gmatch "%f[^\n](%a[^\n;{}#=()]-[ *])([%a_][%w_]*)%s*=%f[^=]" do global(head, name, true) end
  for head, name in text:gmatch "%f[^\n](%a[^\n;{}#=()]-[ *])([%a_][%w_]*)%b[]%s*=%f[^=]" do
    global(head, name, true)
  end
  for head, name in text:gmatch "%f[^\n](%a[%w_ ]*[ *])%(%*([%a_][%w_]*)%)%b();" do -- a pointer to a function
    global(head, name, true)
  end
end

function circles.find(paths)
  local home, objects, texts = {}, {}, {}
  for _, path in ipairs(paths) do
    texts[path] = code(path)
    defined(texts[path], function(name, object)
      home[name] = path
      if object then objects[#objects + 1] = name end
    end)
  end
  local uses = {} -- path -> list of { path, name }
  for _, path in ipairs(paths) do
    local list, seen = {}, {}
    local function use(name)
      local to = home[name]
      if to and to ~= path and not seen[to] then
        seen[to] = true
        list[#list + 1] = { to, name }
      end
    end
    for name in texts[path]:gmatch "%f[%w_][%a_][%w_]*" do use(name) end
    for begins in texts[path]:gmatch "([%a_][%w_]*)##" do
      for _, name in ipairs(objects) do
        if name:sub(1, #begins) == begins then use(name) end
      end
    end
    uses[path] = list
  end

  local found, state, way = {}, {}, {}
  local function visit(path)
    state[path] = "open"
    for _, to in ipairs(uses[path]) do
      way[#way + 1] = { path, to[2] }
      if state[to[1]] == "open" then
        local text
        for _, step in ipairs(way) do
          if text then text = text .. step[1] end
          if step[1] == to[1] then text = step[1] end
          if text then text = text .. " (" .. step[2] .. ") -> " end
        end
        found[#found + 1] = text .. to[1]
      elseif not state[to[1]] then
        visit(to[1])
      end
      way[#way] = nil
    end
    state[path] = "done"
  end
  for _, path in ipairs(paths) do
    if not state[path] then visit(path) end
  end
  return found, home
end

return circles
