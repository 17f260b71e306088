-- headers.lua -- what the headers of the library say, as blocks of text and of declarations, for polhode(3).
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     headers.names              the public headers, in the order of the page
--     headers.blocks(text)       a list of {head = a section's name} , {text = a comment}, {code = declarations}

local headers = { names = { "polhode.h", "polhode_move.h", "polhode_acts.h", "polhode_attitude.h", "polhode_mesh.h",
  "polhode_plane.h", "polhode_exact.h" } }

-- A comment without its stars and indents; blank lines part paragraphs, which are joined: man fills lines by itself.
local function comment_text(comment)
  local text = string.gsub(string.gsub(comment, "^/%*+%s*", ""), "%s*%*+/$", "")
  text = string.gsub(text, "\n[ \t]*%*? ?", "\n")
  return (string.gsub(text, "SPDX%-License%-Identifier:[^\n]*\n?", ""))
end

local function skipped(code)
  return not string.find(code, "[%w}]") or string.find(code, "^#ifndef") or string.find(code, "^#endif") or
    string.find(code, "^#ifdef") or string.find(code, '^extern "C"') or string.find(code, "^#include") or
    string.find(code, "^#define [%u_]+_H$") or string.find(code, "^}")
end

-- Parts of the text: comments that begin a line, and what is between them.
function headers.blocks(text)
  local blocks, at = {}, 1
  local function code(piece)
    local lines = {}
    for line in string.gmatch(piece, "[^\n]+") do
      if not skipped(line) or string.find(line, "^} %w") or string.find(line, "^};") then lines[#lines + 1] = line end
    end
    if #lines > 0 then blocks[#blocks + 1] = { code = table.concat(lines, "\n") } end
  end
  text = "\n" .. text
  while true do
    local from = string.find(text, "\n/%*", at)
    code(string.sub(text, at, (from or #text + 1) - 1))
    if not from then return blocks end
    local to = string.find(text, "*/", from, true)
    local comment = string.sub(text, from + 1, to + 1)
    local head = string.match(comment, "^/%* %-%-%-%- (.-) %-%-%-%- %*/$")
    if head then
      blocks[#blocks + 1] = { head = head }
    else
      for paragraph in string.gmatch(comment_text(comment) .. "\n\n", "(.-)\n\n+") do
        if string.find(paragraph, "%S") then blocks[#blocks + 1] = { text = paragraph } end
      end
    end
    at = to + 2
  end
end

return headers
