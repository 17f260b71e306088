-- messages_slips.lua: what word processors, other languages and other countries put into a scene, for errors.t.
-- SPDX-License-Identifier: GPL-3.0-or-later

local forms = require "tests.dsl.forms"
local after, number, identifier = forms.after, forms.number, forms.identifier

local function scene(body, initial)
  return 'return scene {\n  name = "s",\n  body = ' .. body .. ",\n  initial = { omega = " ..
    (initial or "{1, 2, 3}") .. " } }\n"
end

local letters = "names are of the letters a to z, digits and _"

return { {
  about = "slips",
  { scene "solid.box { x = 1, y = 2 z = 3, mass = 1 }", 3, "syntax: a comma is missing between 2 and z" },
  { 'return scene {\n  name = "s"\n  body = solid.sphere { r = 1, mass = 1 } }\n', 2,
    'syntax: a comma is missing between "s" and body' },
  { 'return scene {\n  name = "s",\n  body = solid.sphere { r = 1, mass = 1 }\n  -- ω\n  initial = {} }\n', 3,
    "syntax: a comma is missing between } and initial" },
  { 'local a = param("a" 0.1, "m")\nreturn 1\n', 1, 'syntax: a comma is missing between "a" and 0.1' },
  { "return scene {\n  name = “s”,\n}\n", 2, 'syntax: Lua has no “ (U+201C): write "' },
  { 'return scene {\n  name = "s”,\n}\n', 2, 'syntax: Lua has no ” (U+201D): write "' },
  { "return scene {\n  name = ‘s’,\n}\n", 2, "syntax: Lua has no ‘ (U+2018): write '" },
  { scene("solid.sphere { r = 1, mass = 1 }", "{1, −2, 3}"), 4, "syntax: Lua has no − (U+2212): write -" },
  { scene("solid.sphere { r = 1, mass = 1 }", "{1, 2 × 3, 3}"), 4, "syntax: Lua has no × (U+00D7): write *" },
  { "local ω = 3\nreturn ω\n", 1, "syntax: Lua has no ω (U+03C9): " .. letters .. ": write omega" },
  { "local Ω = 3\nreturn Ω\n", 1, "syntax: Lua has no Ω (U+03A9): " .. letters .. ": write Omega" },
  { "local é = 3\nreturn é\n", 1, "syntax: Lua has no é (U+00E9): " .. letters },
  { "return\u{A0}scene {}\n", 1, "syntax: Lua has no such blank (U+00A0): write a blank" },
  { "local x = 1 \xFF\nreturn x\n", 1, "syntax: the text must be UTF-8" },
  { after 'param("ω", 1, "rad/s")', 1, "param: name " .. identifier .. ' (write omega), got "ω"' },
  { after 'param("a", "0,5", "m")', 1, "param: default of a " .. number .. ' (decimals have a point: 0.5), got "0,5"' },
  { after 'param("a", 0,5, "m")', 1,
    'param: unit must be a string such as "kg m^2" (decimals have a point: 0.5, not 0,5), got 5' },
  { scene "solid.box { x = 0,5, y = 2, z = 3, mass = 1 }", 3, "box: decimals have a point: 0.5, not 0,5" },
  { scene "solid.box {\n    x = 1,\n    y = 2,25,\n    z = 3, mass = 1 }", 5,
    "box: decimals have a point: 2.25, not 2,25" },
  { scene 'solid.box { x = "-0,5", y = 2, z = 3, mass = 1 }', 3,
    "box: x " .. number .. ' (decimals have a point: -0.5), got "-0,5"' },
  { scene("solid.sphere { r = 1, mass = 1 }", "{0,5, 1, 2}"), 4,
    "initial: omega must be a list of 3 numbers (decimals have a point: 0.5, not 0,5), got {0, 5, 1, 2}" },
  { scene("solid.sphere { r = 1, mass = 1 }", '{0, 1, "3000 rpm"}'), 4, "initial: omega[3] " .. number ..
    ' (a number with a unit is quantity(3000, "rpm")), got "3000 rpm"' },
  { after 'param("w", "3000 rpm")', 1, "param: default of w " .. number ..
    ' (the unit is a text of its own: 3000, "rpm"), got "3000 rpm"' },
  { after 'quantity("1e3 kg m²")', 1, "quantity: the number " .. number ..
    ' (the unit is a text of its own: 1e3, "kg m²"), got "1e3 kg m²"' },
  { scene "solid.cube { x = 1, mass = 1 }", 3,
    'solid: has no "cube" (it is solid.box{x = a, y = a, z = a, mass = M})' },
} }
