-- links.lua -- polhode links: every <inertial> of a robot file, and whether a body can have it.
--
-- One line a link on standard output: "ok", "warn", "static" or "no", its name, what it says; below it what is wrong.
-- Static is what never moves, so that its inertial does not matter: it is counted apart.  Exit status 1 when a link
-- cannot exist or cannot be read, 2 when the file cannot, or has no link.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local diag = require "generator.diag"
local document = require "generator.interchange.document"
local reader = require "generator.interchange.reader"
local read = require "generator.interchange.read"

local links = {}

links.forms = { { "FILE", "can each link's inertial exist?",
  "FILE is URDF, MJCF or SDF, or - for standard input. One line a link: ok, warn, static (it never moves) or no, " ..
    "and why." } }
links.operands = { 1, 1, "FILE" }
links.options = {}
links.examples = { { "polhode links robot.urdf", "every link of a robot" } }

local function numbers(list)
  local out = {}
  for i, q in ipairs(list) do out[i] = diag.show(R.todouble(q)) end
  return table.concat(out, " ")
end

-- A reader that collects its messages, as the lines below a link's.
local function collector(file)
  local said = { failed = false }
  local r = reader.new(file, function(rule, got)
    said[#said + 1], said.failed = "      " .. rule .. (got and ", got " .. got or ""), true
  end, function(text) said[#said + 1] = "      " .. text end)
  return r, said
end

-- Reads one link; returns its lines and the word for it.
local function judge(file, root, format, link)
  local r, said = collector(file)
  local p, static = read.link(r, root, format, link, true)
  static = link.static or static
  local word = static and "static" or said.failed and "no" or #said > 0 and "warn" or "ok"
  local name = link.name and diag.show(link.name) or "<" .. link.element.name .. "> in line " .. link.element.line
  local line = string.format("%-6s %s", word, name)
  if static then
    line = line .. ": " .. static
  elseif p then
    line = line .. ": mass " .. numbers { p.mass } .. ", com " .. numbers(p.com) .. ", xx yy zz xy xz yz " ..
      numbers(p.tensor) .. (#p.turns > 0 and " in a turned frame" or "")
  end
  table.insert(said, 1, line)
  return said, word
end

-- Links without <inertial>: nothing to judge, but for what should have been one.
local function bare(file, format, all)
  local out, n = {}, 0
  for _, link in ipairs(all) do
    if not link.inertial then
      n = n + 1
      local r, said = collector(file)
      r.owner = link.name and format.link .. " " .. diag.show(link.name) or nil
      r:misplaced(format, link.element, "inertial")
      for _, text in ipairs(said) do out[#out + 1] = string.sub(text, 7) end
    end
  end
  return out, n
end

local function plural(n) return n .. (n == 1 and " link" or " links") end

function links.run(host, given)
  local file = given[1]
  local function refuse(why)
    host.err("polhode: " .. why .. "\n")
    return 2
  end
  local text, why = host.read(file)
  if not text then return refuse(why) end
  if file == "-" then file = "stdin" end
  local root, message, line = document.tree(host.xml, text)
  if not root then return refuse(file .. (line and ":" .. line or "") .. ": " .. message) end
  local format = read.format(root)
  if not format then
    local rule, got = document.unknown(root)
    return refuse(file .. ":" .. root.line .. ": " .. rule .. ", got " .. got)
  end
  local list, _, all, includes = read.links(root, format)
  all = all or list
  local count = { ok = 0, warn = 0, no = 0, static = 0 }
  for _, link in ipairs(list) do
    local said, word = judge(file, root, format, link)
    count[word] = count[word] + 1
    host.out(table.concat(said, "\n") .. "\n")
  end
  local r, around = collector(file)
  read.around(r, root, format)
  local slips, without = bare(file, format, all)
  for i, said in ipairs(around) do around[i] = string.sub(said, 7) end
  for _, said in ipairs(slips) do around[#around + 1] = said end
  for _, said in ipairs(around) do host.out("warning: " .. said .. "\n") end
  local more = includes and "; included files are not read" or ""
  if #all == 0 or #list == 0 and not format.bare then
    return refuse(file .. ": nothing was checked: " .. format.name .. " without a <" .. format.link .. ">" ..
      (#all > 0 and " that has <inertial>: " .. format.without or "") .. more)
  end
  host.out(string.format("%s: %s, %d with <inertial>: %d wrong, %d with a warning; %d static%s%s\n", format.name,
    plural(#all), #list, count.no, count.warn, count.static + (format.bare and without or 0),
    without > 0 and not format.bare and "; " .. without .. " without <inertial>: " .. format.without or "", more))
  return count.no > 0 and 1 or 0
end

return links
