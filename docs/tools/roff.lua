-- roff.lua -- a page of the manual in the macros of man(7), which man-db and mandoc both read.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     local page = roff.page(name, section, version, date, about)
--     page:section(NAME)   page:subsection(NAME)   page:text(words)   page:literal(lines)
--     page:synopsis(bold, rest)                  one line of how to call
--     page:entry(term, operand | nil, words)     a term and what it means
--     page:inner(function)                       entries within an entry
--     page:example(command, words)   page:see({{name, section}, ...})   page:done() -> text
-- Words are plain text: what roff reads as its own is escaped here.

local roff = {}

local page = {}
page.__index = page

-- A line cannot begin with a dot or an apostrophe, a backslash is \e, and a minus that a user copies is \-.
function roff.escape(text)
  text = string.gsub(text, "\\", "\\e")
  text = string.gsub(text, "%-", "\\-")
  text = string.gsub(text, "[`^~]", { ["`"] = "\\(ga", ["^"] = "\\(ha", ["~"] = "\\(ti" })
  return (string.gsub(text, "^([%.'])", "\\&%1"))
end

local escape = roff.escape

function page:put(line) self[#self + 1] = line end

-- Text in lines of its own, a sentence a line, as roff wants it.
function page:words(text)
  text = string.gsub(text, "%s+", " ")
  text = string.gsub(text, "([%.%?!]%)?) (%f[%u])", "%1\n%2")
  for line in string.gmatch(text, "[^\n]+") do
    while #line > 76 do -- lines of sources that people can read
      local at = 76
      while at > 20 and string.sub(line, at, at) ~= " " do at = at - 1 end
      if at == 20 then at = string.find(line, " ", 76, true) or #line + 1 end
      self:put(escape(string.sub(line, 1, at - 1)))
      line = string.sub(line, at + 1)
    end
    if line ~= "" then self:put(escape(line)) end
  end
end

function page:section(name)
  self:put(".SH " .. (string.find(name, " ") and '"' .. escape(name) .. '"' or escape(name)))
  self.fresh = true
end

function page:subsection(name)
  self:put(".SS " .. escape(name))
  self.fresh = true
end

function page:text(words)
  if not self.fresh then self:put ".PP" end
  self.fresh = false
  self:words(words)
end

function page:literal(lines)
  if not self.fresh then self:put ".PP" end
  self.fresh = false
  self:put ".nf"
  for line in string.gmatch(lines .. "\n", "([^\n]*)\n") do self:put(line == "" and ".sp" or escape(line)) end
  self:put ".fi"
end

function page:synopsis(bold, rest)
  if not self.fresh then self:put ".br" end
  self.fresh = false
  self:put(".B " .. escape(bold))
  self:put(escape(rest))
end

function page:entry(term, operand, words)
  self:put ".TP"
  self.fresh = false
  self:put("\\fB" .. escape(term) .. "\\fR" .. (operand and " \\fI" .. escape(operand) .. "\\fR" or ""))
  self:words(words)
end

function page:inner(entries)
  self:put ".RS"
  entries()
  self:put ".RE"
end

function page:example(command, words)
  self:put ".TP"
  self.fresh = false
  self:put("\\fB" .. escape(command) .. "\\fR")
  self:words(string.gsub(words, "^%l", string.upper) .. ".")
end

function page:see(list)
  self:section "SEE ALSO"
  for i, p in ipairs(list) do
    self:put(".BR " .. escape(p[1]) .. " (" .. p[2] .. ")" .. (i < #list and "," or ""))
  end
end

function page:done() return table.concat(self, "\n") .. "\n" end

function roff.page(name, section, version, date, about)
  local p = setmetatable({}, page)
  p:put '.\\" Made by `make man`.  SPDX-License-Identifier: GPL-3.0-or-later'
  p:put(string.format('.TH %s %d %s "polhode %s"', string.upper(escape(name)), section, date, version))
  p:put ".SH NAME"
  p:put(escape(name) .. " \\- " .. escape(about))
  return p
end

return roff
