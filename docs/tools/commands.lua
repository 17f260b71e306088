-- commands.lua -- docs/commands.md: what `polhode help` and `polhode help COMMAND` print, on one page.
-- SPDX-License-Identifier: GPL-3.0-or-later

local help = require "generator.commands.help"

local commands = {}

-- The page.  Code in Markdown is what is indented by four, so every line that is not empty is.
function commands.page()
  local out = { "# Commands", "",
    "What `polhode help` and `polhode help COMMAND` print; `make docs` writes this page.", "" }
  local function code(text) out[#out + 1] = (string.gsub(text, "%f[^\n\0]([^\n])", "    %1")) end
  code(help.overview())
  for _, name in ipairs(help.names) do
    out[#out + 1] = "## polhode " .. name .. "\n"
    code(help.page(name))
  end
  return table.concat(out, "\n")
end

return commands
