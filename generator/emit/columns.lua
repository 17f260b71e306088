-- columns.lua -- no line of emitted C is longer than 100 columns, whatever the scene is called.
--
--     columns.fit(text) -> text
--     columns.heads(text) -> text      heads of functions, on one line if they fit
-- Names of scenes make lines longer, so this can only be done at the end.  A comment goes on in its next line; one
-- behind code goes before it; code breaks behind a comma or before an operator.  Strings are not broken.  BELOW the
-- line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local columns = { width = 100 }

local function indent_of(line) return string.match(line, "^ *") end

-- The last place up to `width` at which the words of a comment may part; nil if there is none.
local function gap(line, from, width)
  for at = math.min(width, #line), from, -1 do
    if string.sub(line, at, at) == " " and string.find(line, "^%S", at + 1) and
      string.find(string.sub(line, from, at), "%S") then
      return at
    end
  end
end

-- Lines of a comment: what does not fit goes to the front of the next line, or to a line of its own where that one is
-- a list, a formula or the end.
local function comment(lines)
  local out, rest = {}, nil
  local margin = indent_of(lines[1]) .. (string.find(lines[2] or " *", "^ *%*") and " * " or "   ")
  for i, line in ipairs(lines) do
    local words = string.match(line, "^ *%*? ?(.*)$")
    local prose = i > 1 and string.find(words, "^%S") and not string.find(line, "^ *%*/")
    if rest and prose then
      line, rest = margin .. rest .. " " .. words, nil
    elseif rest then
      out[#out + 1], rest = margin .. rest, nil
    end
    while #line > columns.width do
      local at = gap(line, #margin + 1, columns.width)
      if at and string.sub(line, at + 1) == "*/" then at = gap(line, #margin + 1, at - 1) end -- not alone on a line
      if not at then break end
      out[#out + 1] = string.gsub(string.sub(line, 1, at - 1), "%s+$", "")
      rest = string.sub(line, at + 1)
      line = nil
      if #margin + #rest <= columns.width then break end
      line, rest = margin .. rest, nil
    end
    out[#out + 1] = line
  end
  if rest then out[#out + 1] = margin .. rest end
  return out
end

local OPERATORS = { ["+"] = true, ["-"] = true, ["*"] = true, ["&&"] = true, ["||"] = true, ["?"] = true, [":"] = true,
  ["=="] = true, ["<="] = true, [">="] = true, ["<"] = true, [">"] = true, ["|"] = true }

-- The last place up to the width where a line of code may be broken, outside strings; nil if there is none.
local function joint(line)
  local quoted, best, open = false, nil, nil
  local first = #indent_of(line) + 8
  for at = 1, math.min(#line, columns.width - 2) do
    local c = string.sub(line, at, at)
    if c == '"' and string.sub(line, at - 1, at - 1) ~= "\\" then quoted = not quoted end
    if c == "(" and not quoted and at > first then open = at end
    if c == " " and not quoted and at > first then
      local before, after = string.sub(line, at - 1, at - 1), string.match(line, "^(%S+)", at + 1)
      local new = before == "," or before == ";" or before == ")" and after ~= "{" or OPERATORS[after or ""]
      if new then best = at end
    end
  end
  return best, not best and open or nil
end

local function code(line, out)
  local directive = string.find(line, "^#")
  local own, note = string.match(line, "^(.-%S)%s+(/%*.*%*/)$")
  if own and not string.find(own, "/*", 1, true) then
    for _, l in ipairs(comment { indent_of(line) .. note }) do out[#out + 1] = l end
    line = own
  end
  local margin = indent_of(line) .. "    "
  local more = string.match(line, " *\\$") or "" -- of a directive that goes on
  line = string.sub(line, 1, #line - #more)
  while #line > columns.width do
    local at, open = joint(line)
    if not (at or open) then break end
    out[#out + 1] = string.sub(line, 1, at and at - 1 or open) .. (directive and " \\" or "")
    line = margin .. string.sub(line, (at or open) + 1)
  end
  out[#out + 1] = line .. more
end

-- The head of a function: on one line, or broken between arguments.
local function broken_head(text)
  text = string.gsub(text, "%s*\n%s*", " ")
  if #text <= columns.width then return text end
  local open = string.find(text, "(", 1, true)
  local lines, line = {}, string.sub(text, 1, open)
  local wide = false
  for argument in string.gmatch(string.sub(text, open + 1), "[^,]+") do
    wide = wide or #line + #argument > columns.width
  end
  local pad = string.rep(" ", wide and 4 or #line)
  for argument, comma in string.gmatch(string.sub(text, open + 1), "%s*([^,]+)(,?)") do
    if #line + #argument + #comma + 1 > columns.width and string.find(line, "%S") then
      lines[#lines + 1] = string.gsub(line, "%s+$", "")
      line = pad
    end
    line = line .. argument .. comma .. (comma ~= "" and " " or "")
  end
  lines[#lines + 1] = line
  return table.concat(lines, "\n")
end

-- The text of a file with all heads of functions, defined or declared, so.
function columns.heads(text)
  text = string.gsub("\n" .. text, "(\n)([%a][^\n;={}#]*%([^;={}#]-%))(;?\n)", function(before, own, after)
    return before .. broken_head(own .. string.sub(after, 1, -2)) .. "\n"
  end)
  return string.sub(text, 2)
end

function columns.fit(text)
  local out, block = {}, nil
  for line in string.gmatch(text, "([^\n]*)\n") do
    if not block and string.find(line, "^ */%*") then block = {} end
    if block then
      block[#block + 1] = line
      if string.find(line, "*/", 1, true) then
        local long = false
        for _, l in ipairs(block) do long = long or #l > columns.width end
        local alone = string.find(line, "%*/%s*$")
        for _, l in ipairs(long and alone and comment(block) or block) do out[#out + 1] = l end
        block = nil
      end
    elseif #line > columns.width then
      code(line, out)
    else
      out[#out + 1] = line
    end
  end
  return table.concat(out, "\n") .. "\n"
end

return columns
