-- special.lua -- the table of special paths in docs/methods.md, from what each method declares.
-- SPDX-License-Identifier: GPL-3.0-or-later

local bounded = require "generator.dynamics.bounded"
local wide = require "generator.emit.wide"
local methods = require "generator.methods.methods"

local special = {}

local BEGIN, END = "<!-- special paths -->\n", "<!-- end of special paths -->"

-- The page with the table in its place.
function special.page(text)
  local lines = { "| method | special path | what it needs of the scene |", "|---|---|---|" }
  local function put(name, needs)
    for _, p in ipairs(needs or {}) do
      lines[#lines + 1] = string.format("| %s | %s | %s |", name, p.path, p.needs)
    end
  end
  for _, m in ipairs(methods) do put("`" .. m.name .. "`", m.needs) end
  put("`--with q31`", bounded.needs)
  put("`--with batch`", wide.needs)
  local first, last = assert(text:find(BEGIN, 1, true)), assert(text:find(END, 1, true))
  return text:sub(1, first + #BEGIN - 1) .. table.concat(lines, "\n") .. "\n" .. text:sub(last)
end

return special
