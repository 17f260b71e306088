-- links.lua -- polhode links: every <inertial> of a robot file, and whether a body can have it.
--
-- One line a link on standard output: "ok", "warn" or "no", its name, what it says; below it what is wrong.
-- Exit status 1 when a link cannot exist or cannot be read, 2 when the file cannot.
-- SPDX-License-Identifier: GPL-3.0-or-later

local R = require "generator.algebra.rational"
local diag = require "generator.diag"
local reader = require "generator.interchange.reader"
local read = require "generator.interchange.read"

local links = {}

links.forms = { { "FILE", "can each link's inertial exist?",
  "FILE is URDF, MJCF or SDF, or - for standard input. One line a link: ok, warn or no, and why." } }
links.operands = { 1, 1, "FILE" }
links.options = {}
links.examples = { { "polhode links robot.urdf", "every link of a robot" } }

local function numbers(list)
  local out = {}
  for i, q in ipairs(list) do out[i] = diag.show(R.todouble(q)) end
  return table.concat(out, " ")
end

-- Reads one link; returns its lines and whether it is wrong.
local function judge(file, root, format, link)
  local said, wrong = {}, false
  local r = reader.new(file, function(rule, got)
    said[#said + 1], wrong = "      " .. rule .. (got and ", got " .. got or ""), true
  end, function(text) said[#said + 1] = "      " .. text end)
  local p = read.link(r, root, format, link)
  local name = link.name and diag.show(link.name) or "<" .. link.element.name .. "> in line " .. link.element.line
  local line = string.format("%-4s  %s", wrong and "no" or #said > 0 and "warn" or "ok", name)
  if p then
    line = line .. ": mass " .. numbers { p.mass } .. ", com " .. numbers(p.com) .. ", xx yy zz xy xz yz " ..
      numbers(p.tensor) .. (#p.turns > 0 and " in a turned frame" or "")
  end
  table.insert(said, 1, line)
  return said, wrong
end

function links.run(host, given)
  local file = given[1]
  local function refuse(why)
    host.err("polhode: " .. why .. "\n")
    return 2
  end
  local text, why = host.read(file)
  if not text then return refuse(why) end
  if file == "-" then file = "stdin" end
  local root, message, line = host.xml(text)
  if not root then return refuse(file .. ":" .. line .. ": " .. message) end
  local format = read.format(root)
  if not format then
    return refuse(file .. ": no URDF, MJCF or SDF: the root is <" .. diag.cut(root.name, 40) .. ">")
  end
  local list, _, all, includes = read.links(root, format)
  local bad = 0
  for _, link in ipairs(list) do
    local said, wrong = judge(file, root, format, link)
    if wrong then bad = bad + 1 end
    host.out(table.concat(said, "\n") .. "\n")
  end
  host.out(string.format("%s: %d of %d with <inertial>, %d wrong%s\n", format.name, #list, all and #all or #list, bad,
    includes and "; included files are not read" or ""))
  return bad > 0 and 1 or 0
end

return links
