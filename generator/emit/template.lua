-- template.lua -- the template engine: text with ${name} and lines of logic that begin with %%.
--
-- One template line becomes exactly one line of a Lua chunk named after the template, so every load and run error
-- has the right file and line.  Three laws: an unknown name is an error; a value that is not a string is an error
-- (only emit/number.lua turns numbers into text); logic is `for` and `if` over prepared lists, nothing else, so
-- the environment holds the values and ipairs, no functions of the library.  A value may be a function without
-- arguments: its result is made when a template first reads it.  A line that is one value, indented, is an empty line
-- where the value is empty.
--
-- Templates that are filled with the same values are a group:
--     local GROUP = template.group("core/guard.h", "core/guard.c")       files of templates/
--     local render = GROUP(job.templates, base, { norm = true, rows = {} })
--     render "core/guard.h" -> text
-- The values are the group's own, under short names; what they do not have is looked up in emit/base.lua, and they may
-- not hide what is there.  The group says which templates read a value, so tests/emit/values.t finds those that none
-- reads.
-- SPDX-License-Identifier: GPL-3.0-or-later

local template = {}

local function quoted(s) return string.format("%q", s) end

-- One line of text as Lua: _put("..." .. _str(expr, "expr") .. ... .. "\n"), or _own("  ", expr) if it is one value.
-- What is between ${ and } is a Lua expression: w.name, n[2.5].
local function text_line(line)
  local indent, own = string.match(line, "^( +)%${([^}]*)}$")
  if own then return "_own(" .. quoted(indent) .. ", _str(" .. own .. ", " .. quoted(own) .. "))" end
  local parts, from = {}, 1
  while true do
    local a, b, name = string.find(line, "%${([^}]*)}", from)
    if not a then break end
    if a > from then parts[#parts + 1] = quoted(string.sub(line, from, a - 1)) end
    parts[#parts + 1] = "_str(" .. name .. ", " .. quoted(name) .. ")"
    from = b + 1
  end
  if string.find(line, "${", from, true) then parts[#parts + 1] = "_unclosed()" end
  local tail = string.sub(line, from)
  if tail ~= "" then parts[#parts + 1] = quoted(tail) end
  parts[#parts + 1] = "\"\\n\""
  return "_put(" .. table.concat(parts, " .. ") .. ")"
end

-- The template as Lua, one line for one of its lines.
function template.translate(name, source)
  local lines = {}
  if source ~= "" and string.sub(source, -1) ~= "\n" then
    local _, newlines = string.gsub(source, "\n", "")
    error(name .. ":" .. newlines + 1 .. ": the last line has no newline", 0)
  end
  for line in string.gmatch(source, "([^\n]*)\n") do
    local logic = string.match(line, "^%s*%%%%(.*)$")
    lines[#lines + 1] = logic or text_line(line)
  end
  return table.concat(lines, "\n")
end

-- The text of template `source` (its name is used in messages) with the values.  source: text, or what string.dump made
-- of its translation when the program was built.
function template.render(name, source, values)
  local out, n = {}, 0
  local function put(line)
    n = n + 1
    out[n] = line
  end
  local env
  env = setmetatable({
    ipairs = ipairs,
    _put = put,
    _own = function(indent, v) put((v == "" and "" or indent .. v) .. "\n") end,
    _unclosed = function() error("${ is not closed", 2) end,
    _str = function(v, what)
      if type(v) ~= "string" then error("${" .. what .. "} is " .. type(v) .. ", not a string", 2) end
      return v
    end,
  }, {
    __index = function(_, k)
      local v = values[k]
      if v == nil then error("unknown name '" .. tostring(k) .. "'", 2) end
      if type(v) == "function" then
        v = v()
        values[k] = v
      end
      rawset(env, k, v) -- found once, it is there
      return v
    end,
    __newindex = function(_, k) error("a template must not assign '" .. tostring(k) .. "'", 2) end,
  })
  local made = string.sub(source, 1, 4) == "\27Lua"
  local chunk, why = load(made and source or template.translate(name, source), "@" .. name, made and "b" or "t", env)
  if not chunk then error(why, 0) end
  chunk()
  return table.concat(out)
end

-- The same of a file, which ends with one newline.
function template.file(name, source, values)
  local text = template.render(name, source, values)
  local last = #text
  while string.sub(text, last - 1, last) == "\n\n" do last = last - 1 end
  return string.sub(text, 1, last)
end

-- All groups, each {names = list, has = set}; watch(group, values), if there is one, sees the values of each rendering.
template.groups, template.watch = {}, nil

local function unhidden(values, base)
  for k in pairs(values) do -- each alone: the order is lost
    if base[k] ~= nil then error("'" .. tostring(k) .. "' hides the value that all templates have", 3) end
  end
end

function template.group(...)
  local group = { names = { ... }, has = {} }
  for _, name in ipairs(group.names) do group.has[name] = true end
  table.insert(template.groups, group)
  return function(templates, base, values)
    local all = setmetatable({}, { __newindex = values, __index = function(_, k)
      local v = values[k]
      if v == nil then v = base[k] end
      return v
    end })
    return function(name)
      if not group.has[name] then error(name .. " is no template of this group", 2) end
      unhidden(values, base)
      if template.watch then template.watch(group, values) end
      local path = "templates/" .. name
      return template.file(path, templates[path], all)
    end
  end
end

return template
