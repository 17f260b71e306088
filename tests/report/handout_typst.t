#!/usr/bin/env lua5.4
-- handout_typst.t - Typst's compiler takes the hand-out of every body without a word, and no formula is too wide.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Needs node and the compiler in build/typst: `.ci/setup typst`, `make check-typst`; POLHODE_TYPST names another folder
-- that has it in its node_modules.  Without it, it is skipped.

local tap = require "tests.tap"

local program = os.getenv "POLHODE" or "build/polhode"
local compiler = os.getenv "POLHODE_TYPST" or "build/typst"
if not os.execute("command -v node >/dev/null 2>&1 && test -d '" .. compiler ..
  "/node_modules/@myriaddreamin/typst-ts-node-compiler'") then
  tap.skip("the hand-outs are compiled", "Typst's compiler is not there (.ci/setup typst)")
  tap.done()
  return
end

local function output(command)
  local pipe = assert(io.popen(command))
  local text = pipe:read "a"
  pipe:close()
  return text
end

local folder = string.gsub(output "mktemp -d", "\n", "")
local documents = {} -- {name, what is expected of it}

local function put(name, text, expected)
  local file = assert(io.open(string.format("%s/%03d.typ", folder, #documents + 1), "w"))
  file:write(text)
  file:close()
  documents[#documents + 1] = { name = name, expected = expected or "^nothing$" }
end
local function explained(name, scene, options)
  local text = output(string.format("%s explain '%s' --format typst %s 2>&1", program, scene, options or ""))
  tap.ok(string.find(text, "\n== Given\n", 1, true), name .. ": it is written", text)
  put(name, text)
end

local head = "#set page(paper: \"a4\", margin: 22mm)\n\n= Wrong\n\n"
put("control: a name that Typst does not know", head .. "$ phi_(p1) = 0 $\n", "^unknown variable: p1")
put("control: a formula too wide", head .. "$ " .. string.rep("omega + ", 60) .. "1 $\n", "a formula of")
put("control: a warning", head .. "#set text(font: \"no such font\")\nwords\n", "unknown font family")

for path in string.gmatch(output "ls bodies/*.lua", "[^\n]+") do
  explained(path, path, "--sections all --author 'A. #Bee' --date '1. 2.' " ..
    "--title '#1 [$x_1$] \"it\" <a>@b // c'")
end

-- Names of the theory, of Typst's own functions, and with digits and words as their indices.
local scene = os.tmpname()
for _, names in ipairs { { "omega", "I1", "M", "e1" }, { "dif", "dot", "angle", "frac" },
  { "sin", "arcsin", "op", "mat" }, { "thin", "quad", "lr", "x_12" }, { "p_start2", "L", "pi_1", "alpha_beta" },
  { "in", "R2", "sum", "bold" },
  { "yes", "none", "T_xx", "k_ij" } } do
  local file = assert(io.open(scene, "w"))
  file:write(string.format([[local a, b = param(%q, 3, "cm"), param(%q, 5, "cm")
    local c, m = param(%q, 8, "cm"), param(%q, 2, "kg")
    return scene { name = "a_name", body = solid.box { x = a, y = b, z = c, mass = m },
    origin = {a/3, b/5, 0}, effects = { effect.gravity {}, effect.damping { c = 1e-4 } },
    initial = { omega = {1, 2, 3} } }]], table.unpack(names)))
  file:close()
  explained("names " .. table.concat(names, ", "), scene, "--sections all")
end

local said = {}
for line in string.gmatch(output(string.format("node tests/report/typst.mjs '%s' '%s'/*.typ 2>&1", compiler, folder)),
  "[^\n]+") do
  said[#said + 1] = line
end
for i, d in ipairs(documents) do
  local pages, text = string.match(said[i] or "", "^(%d+) (.*)$")
  tap.ok(text and string.find(text, d.expected), d.name .. ": what Typst says", said[i])
  if d.expected == "^nothing$" then tap.ok(tonumber(pages or 0) > 0, d.name .. ": it has pages") end
end
os.remove(scene)
os.execute("rm -r '" .. folder .. "'")
tap.done()
