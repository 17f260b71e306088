-- columns.lua -- no line of emitted C is longer than 100 columns, whatever the scene is called.
--
--     columns.fit(text) -> text
--     columns.part(text) -> text, single
-- A part of units.lua in its shape: the head of a function on one line if it fits, and all of a static one that only
-- returns something; no blank line before the one statement after declarations, nor in a body of a few lines.  single:
-- all of something static in one line, which wants no blank line beside its like.
-- Names of scenes make lines longer, so this can only be done at the end.  A comment goes on in its next line; one
-- behind code goes before it; code breaks behind a comma or before an operator.  Strings are not broken.  BELOW the
-- line.
-- SPDX-License-Identifier: GPL-3.0-or-later

local plain = require "generator.emit.plain"

local columns = { width = 100 }

local function indent_of(line) return string.match(line, "^ *") end

-- A word that joins those beside it in a formula.
local JOINS = { ["="] = true, ["+"] = true, ["-"] = true, ["x"] = true, ["/"] = true, ["<"] = true, [">"] = true }

-- The last place up to `width` at which the words of a comment may part, in no formula if there is such a place in the
-- last half; nil if there is none.
local function gap(line, from, width)
  local last
  for at = math.min(width, #line), from, -1 do
    if string.sub(line, at, at) == " " and string.find(line, "^%S", at + 1) and
      string.find(string.sub(line, from, at), "%S") then
      last = last or at
      local before, behind = string.match(string.sub(line, from, at - 1), "(%S+)$"), string.match(line, "^%S+", at + 1)
      if not JOINS[before] and not JOINS[behind] then return at end
    end
    if last and at < (from + width) // 2 then break end
  end
  return last
end

-- The place where a formula parts: behind a comma, or where words do.
local function formula_gap(line, from)
  for at = columns.width, from + 40, -1 do
    if string.find(line, "^, +%S", at - 1) then return at end
  end
  return gap(line, from, columns.width)
end

-- Lines of a comment: what does not fit goes to the front of the next line, or to a line of its own where that one is
-- a list, a formula or the end.  An indented line, a formula or a list, goes on by itself, further in.
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
    local inner = i > 1 and string.match(words, "^   *%f[%S]")
    while inner and #line > columns.width do
      local at = formula_gap(line, #margin + #inner + 1)
      if not at or #string.sub(line, at + 1) < 3 then break end
      out[#out + 1] = string.gsub(string.sub(line, 1, at), "%s+$", "")
      line = margin .. inner .. "    " .. string.match(line, "^ *(.*)$", at + 1)
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

local OPERATORS = { ["+"] = true, ["-"] = true, ["*"] = true, ["/"] = true, ["&&"] = true, ["||"] = true, ["?"] = true,
  [":"] = true, ["=="] = true, ["<="] = true, [">="] = true, ["<"] = true, [">"] = true, ["|"] = true, ["!="] = true }

-- Where a line of code is best broken, outside strings: behind a comma or before an operator, or behind the parenthesis
-- that a call opens; each level of parentheses is as bad as a line that is DEPTH columns shorter.  nil if nowhere.
local DEPTH = 16
local QUOTE, BACKSLASH, SPACE, COMMA, SEMICOLON, OPENED, CLOSED, BRACE = string.byte('"\\ ,;(){', 1, -1)
local OPENS = { [OPENED] = true, [BRACE] = true, [string.byte "["] = true }

local function joint(line)
  local quoted, best, least, depth = false, nil, math.huge, 0
  local first = #indent_of(line) + 8
  local function offer(at, cost)
    cost = cost - at
    if at > first and cost <= least then best, least = at, cost end
  end
  local at, last = 0, math.min(#line, columns.width - 2)
  while true do
    at = string.find(line, '[]"(%[{)} ]', at + 1)
    if not at or at > last then return best end
    local c = string.byte(line, at)
    if c == QUOTE then
      if string.byte(line, at - 1) ~= BACKSLASH then quoted = not quoted end
    elseif c == SPACE and not quoted then
      local before = string.byte(line, at - 1)
      local operator = string.match(line, "^[-+*/&|?:<>=!]+%f[ ]", at + 1)
      if before == COMMA or before == SEMICOLON or before == CLOSED and string.byte(line, at + 1) ~= BRACE then
        offer(at, DEPTH * depth)
      elseif operator and OPERATORS[operator] then
        offer(at, DEPTH * depth + 4)
      elseif before == QUOTE and string.byte(line, at + 1) == QUOTE then -- one string in two
        offer(at, DEPTH * depth)
      end
    elseif OPENS[c] and not quoted then
      depth = depth + 1
      if c == OPENED then offer(at, DEPTH * depth + 40) end
    elseif not quoted then
      depth = depth - 1
    end
  end
end

-- Appends the line, broken where it is too long; what goes on stands four columns further in.
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
    local at = joint(line)
    if not at then break end
    out[#out + 1] = string.gsub(string.sub(line, 1, at), " $", "") .. (directive and " \\" or "")
    line = margin .. string.sub(line, at + 1)
  end
  out[#out + 1] = line .. more
end

local ENDS = { [0] = true } -- of a statement, of a block, of a label, of a directive's line that goes on
for _, c in ipairs { string.byte(";}:\\", 1, -1) } do ENDS[c] = true end

-- Does the next line go on with the statement that ends in `line` so far?
local function goes_on(line, own, next_one)
  local last = string.byte(line, -1)
  if ENDS[last or 0] then return false end
  local tail = string.char(last)
  if string.find(own, "^[%a#]") or string.find(next_one, "^%s*[/#}]") then
    return false
  end
  if string.find(own, "^ *{") then return tail == "," and string.find(next_one, "^ *{.*},$") ~= nil end
  if string.find(next_one, "^%s*{") then return false end
  if #indent_of(next_one) <= #indent_of(own) or tail == "{" or string.find(line, "/*", 1, true) then return false end
  if tail == "," or tail == "=" or tail == "(" or string.find(next_one, "^%s*[+%-*/?:&|<>=]") then return true end
  local _, opened = string.gsub(line, "%(", "")
  local _, closed = string.gsub(line, "%)", "")
  return opened > closed
end

-- The head of a function: on one line, or broken between arguments.
local function broken_head(text)
  if plain.has(text, "\n") then text = string.gsub(text, "%s*\n%s*", " ") end
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

-- Is the line all of a static function or a constant?
local function whole(line)
  local open = string.find(line, "{", 1, true)
  return string.find(line, "^static ") ~= nil and string.find(line, ";", 1, true) ~= nil and
    (not open or string.find(line, "}[;]?$") ~= nil) and not string.find(line, "^[^={]*%b();")
end

-- A body of a few lines without blank ones, but for those before comments.
local FEW = 6
local function dense(body)
  local _, lines = string.gsub(body, "\n+", "")
  return lines - 2 > FEW and body or (string.gsub(body, "\n\n( *%f[^%s/])", "\n%1"))
end

function columns.part(text)
  local comment_end = string.find(text, "^/%*") and select(2, string.find(text, "*/\n", 1, true)) or 0
  local close = string.find(text, ")\n{\n", comment_end + 1, true) or string.find(text, "%)%s*;%s*$", comment_end + 1)
  local head = close and string.sub(text, comment_end + 1, close) or ""
  if string.find(head, "^%a") and not string.find(head, "[;={}#]") then
    local body = string.sub(text, close + 1)
    head = broken_head(head)
    local short = string.find(head, "^static ") and string.match(body, "^\n{\n  (return [^\n]*;)\n}$")
    if short and #head + #short + 5 <= columns.width then
      body = " { " .. short .. " }"
    else
      local blank = string.find(body, "\n\n", 1, true) -- the only one, or there are more declarations
      if blank and string.find(body, "^  return [^\n]*;\n}$", blank + 2) and
        string.find(string.sub(body, 1, blank), "^\n{\n[^{}]*;\n$") then
        body = string.sub(body, 1, blank) .. string.sub(body, blank + 2)
      end
    end
    text = string.sub(text, 1, comment_end) .. head .. dense(body)
  end
  return text, not string.find(text, "\n", 1, true) and whole(text)
end

-- Statements over several lines are joined first, so that the breaks do not depend on where the template had its own.
function columns.fit(text)
  local out, block, statement = {}, nil, nil
  local function finish()
    if not statement then return end
    if #statement > columns.width then code(statement, out) else out[#out + 1] = statement end
    statement = nil
  end
  for _, line in ipairs(plain.lines(text)) do
    if not block and string.find(line, "/*", 1, true) and string.find(line, "^ */%*") then
      finish()
      block = {}
    end
    if block then
      block[#block + 1] = line
      if string.find(line, "*/", 1, true) then
        local long = false
        for _, l in ipairs(block) do long = long or #l > columns.width end
        local alone = string.find(line, "%*/%s*$")
        for _, l in ipairs(long and alone and comment(block) or block) do out[#out + 1] = l end
        block = nil
      end
    elseif statement and goes_on(statement, statement, line) and not (string.find(statement, "^ *{") and
      #statement + #line > columns.width) then
      local space = string.sub(statement, -1) == "(" and "" or " "
      statement = statement .. space .. string.match(line, "^%s*(.*)$")
    else
      finish()
      statement = line
    end
  end
  finish()
  return table.concat(out, "\n") .. "\n"
end

return columns
