#!/usr/bin/env lua5.4
-- xml.t - host.xml: the tree, the lines, what is refused, and that nothing leaks or hangs.
-- SPDX-License-Identifier: GPL-3.0-or-later

local tap = require "tests.tap"
local tier = require "tests.tier"
local program = require "tests.cli.program"

-- A tree as one line: name@line[attributes in order]"text"(children).
local show = [[
  local function show(e)
    local out = { e.name, "@", tostring(e.line), "[" }
    for _, name in ipairs(e.at) do out[#out + 1] = name .. "=" .. e.at[name] .. ";" end
    out[#out + 1] = "]" .. e.text .. "("
    for _, c in ipairs(e) do out[#out + 1] = show(c) end
    return table.concat(out) .. ")"
  end
]]

local function prints(name, lua, want)
  local code, out, err = program.run(show .. lua)
  tap.ok(code == 0 and out == want, name, string.format("status %s\ngot  %s\nwant %s\n%s", code, out, want, err))
end

prints("an element with attributes in order and text", [=[say(show(host.xml [[<a z="1" b='2 &lt; 3'>x&amp;y</a>]]))]=],
  "a@1[z=1;b=2 < 3;]x&y()\n")
prints("children, their lines, own text joined", "say(show(host.xml '<a>1<b>\\n</b>2\\n<c:d/>3</a>'))",
  "a@1[]12\n3(b@1[]\n()c:d@3[]())\n")
prints("comments, instructions, sections, a declaration",
  "say(show(host.xml '<?xml version=\"1.0\"?><!-- <b/> --><a><?p q?><![CDATA[<x>]]>\\n<!-- y --></a>'))",
  "a@1[]<x>\n()\n")
prints("characters of other encodings become UTF-8",
  [[say(host.xml('<?xml version="1.0" encoding="ISO-8859-1"?><a>\xe4</a>').text == "\u{e4}")]], "true\n")

-- nil, message, line
prints("a wrong end", "say(host.xml '<a>\\n<b></a>')", "nil mismatched tag 2\n")
prints("nothing", "say(host.xml '')", "nil no element found 1\n")
prints("two roots", "say(host.xml '<a/>\\n<b/>')", "nil junk after document element 2\n")
prints("a byte that is no character", "say(host.xml '<a>\\1</a>')", "nil not well-formed (invalid token) 1\n")
prints("an attribute twice", "say(host.xml '<a b=\"1\" b=\"2\"/>')", "nil duplicate attribute 1\n")
prints("an unknown entity", "say(host.xml '<a>&b;</a>')", "nil undefined entity 1\n")
prints("an unknown encoding", "say(host.xml '<?xml version=\"1.0\" encoding=\"klingon\"?><a/>')",
  "nil unknown encoding 1\n")

-- Entities that multiply need a document type, which is refused before any of it is read.
prints("a document type", [[
  local t = { '<!DOCTYPE a [<!ENTITY e0 "xxxxxxxxxx">' }
  for i = 1, 30 do t[#t + 1] = '<!ENTITY e' .. i .. ' "' .. string.rep("&e" .. i - 1 .. ";", 10) .. '">' end
  say(host.xml(table.concat(t) .. "]><a>&e30;</a>"))
  say(host.xml '<!DOCTYPE a SYSTEM "file:///etc/passwd"><a/>')]],
  "nil a document type declaration is not allowed 1\nnil a document type declaration is not allowed 1\n")
prints("depth 200 is read, 201 refused", [[
  local function nested(n) return string.rep("<a>", n) .. string.rep("</a>", n) end
  say(host.xml(nested(200)).name, host.xml(nested(201)))]], "a nil elements are nested more than 200 deep 1\n")
prints("200000 elements are read, one more refused", [[
  local function many(n) return "<r>" .. string.rep("<a/>", n - 1) .. "</r>" end
  say(#host.xml(many(200000)), host.xml(many(200001)))]], "199999 nil there are more than 200000 elements 1\n")
prints("16 MiB are read, one byte more refused", [[
  local function long(n) return "<r>" .. string.rep("\n", n - 7) .. "</r>" end
  say(#host.xml(long(16 << 20)).text, host.xml(long((16 << 20) + 1)))]],
  ((16 << 20) - 7) .. " nil the text is larger than 16 MiB 1\n")
prints("text in many pieces is joined in linear time", [[
  say(#host.xml("<r>" .. string.rep("&amp;\n", 1000000) .. "</r>").text)]], "2000000\n")

if not tier.quick then
  -- the limit of memory is met inside the parser's handlers: an error of Lua, not a crash
  local code, _, err = program.run([[
    local kept = {}
    local text = "<r>" .. string.rep("<a b='1'>x</a>", 150000) .. "</r>"
    for i = 1, 100 do kept[i] = host.xml(text) end]])
  tap.ok(code == 70 and err:find("not enough memory", 1, true), "memory that runs out ends in an error", err)
end

program.finish()
tap.done()
